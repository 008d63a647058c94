#pragma once
// Digital controller of the longitudinal feed of a grinding wheel (K207).
//
// A feedback channel holds the traverse feed at its set value: the feed is measured once per pass, a digital
// controller drives the feed servo through a zero-order hold, with two samples of dead time. Taken literally
// one sample is one pass, so a change of feed stretches over the first passes of an operation.
//
// Yenikeiev, Subotin 2011. The paper gives no plant: the default one (first-order lag whose pole is the
// stable zero of the controller) is a completion.

#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k207 {

struct PassMeasured {
  double length_mm = 0;
  double pass_time_s = 0;
};
struct LongitudinalFeed {
  double feed_m_min;
};
/// Measured feed of one pass, S = l / t.
[[nodiscard]] LongitudinalFeed longitudinal_feed(const PassMeasured& in);

struct PassAtFeed {
  double length_mm = 0;
  double feed_m_min = 0;
};
struct PassDuration {
  double pass_time_s;
};
/// Time of one pass; inverse of longitudinal_feed.
[[nodiscard]] PassDuration longitudinal_pass_time(const PassAtFeed& in);

enum class ErrorLaw { uniform, triangular, normal, laplace, laplace_scale };

struct CodeError {
  double sigma = 0;  // standard deviation; for laplace_scale the scale of the printed density
  ErrorLaw law = ErrorLaw::triangular;
};
struct EntropyInterval {
  double delta_e;
};
/// Entropy interval of uncertainty exp(H)/2, H the differential entropy of the law; K207 second eq. (2)
/// corrected.
[[nodiscard]] EntropyInterval entropy_interval(const CodeError& in);

struct DriveLags {
  double tau_mc_s = 0;
  double t_mc_s = 0;
  double t_e_s = 0;
  double t_em_s = 0;
  double t_m_s = 0;
};
struct DrivePolynomial {
  double a0;
  double a1;
  double a2;
  double a3;
  double a4;
};
/// Denominator of the drive, K207 eq. (5): (T_M p + 1)[(product of four lags) - 1] / p.
[[nodiscard]] DrivePolynomial drive_polynomial(const DriveLags& in);

enum class Block { input, hold, regulator, drive };

struct BlockAtFrequency {
  Block block = Block::input;
  double freq_hz = 0;
  std::optional<double> k;        // input, drive
  std::optional<double> tau_s;    // input, hold, regulator
  double delta_e = 1;             // input
  std::optional<double> tau_t_s;  // drive, as all below
  std::optional<double> tau_p2_s;
  std::optional<double> tau_mc_s;
  std::optional<double> t_mc_s;
  std::optional<double> t_e_s;
  std::optional<double> t_em_s;
  std::optional<double> t_m_s;
};
struct FrequencyResponse {
  double magnitude;
  double phase_deg;
};
/// Frequency response of blocks (1)-(5) at p = j 2 pi f; phase in (-180, 180].
[[nodiscard]] FrequencyResponse feed_channel_block(const BlockAtFrequency& in);

struct ReferenceModel {
  double delta_e = 0;
  double k_m = 0;
  double t_m = 0;  // in sample periods
  double l4 = 0;
  double eps = 0;
};
struct ReferenceNumerator {
  double r1;
  double r2;
};
/// Coefficients of z^-1 and z^-2 of the reference model, K207 eq. (9).
[[nodiscard]] ReferenceNumerator reference_model_numerator(const ReferenceModel& in);

enum class Variant { repaired, printed };

struct PlantModel {
  std::vector<double> a;  // a1..a3
  std::vector<double> b;  // b0..b3
  double r1 = 0;
  double r2 = 0;
  Variant variant = Variant::repaired;
};
struct RegulatorPolynomials {
  std::vector<double> h;
  std::vector<double> f;
  std::vector<double> g;
};
/// Polynomials of the controller, K207 eqs. (10)-(12). All a nonzero.
[[nodiscard]] RegulatorPolynomials regulator_polynomials(const PlantModel& in);

struct ClosedLoop {
  std::vector<double> a;  // a1..., the leading 1 left out
  std::vector<double> b;
  std::vector<double> d;  // d0 not 0
  std::vector<double> f;
  std::int64_t delay = 1;
};
struct SpectralRadius {
  double rho;
};
/// Largest modulus of the roots of A D + z^-delay B F; stable below 1, 0 without roots. From eqs. (6), (7).
[[nodiscard]] SpectralRadius closed_loop_spectral_radius(const ClosedLoop& in);

/// Coefficients of the controller, K207 eq. (14).
struct Regulator {
  double n0 = 0.04752;
  double n1 = 0.862;
  double n2 = -0.823;
  double d0 = 0.374;
};

struct RegulatorInputs : Regulator {
  double u_prev = 0;
  double e0 = 0;
  double e1 = 0;
  double e2 = 0;
};
struct RegulatorOutput {
  double u;
};
/// One step of the controller: u = u_prev + (n0 e0 + n1 e1 + n2 e2) / d0. K207 eq. (14).
[[nodiscard]] RegulatorOutput regulator_step(const RegulatorInputs& in);

struct RegulatorGains {
  double k_p;
  double k_i;
  double k_d;
  double zero_1;
  double zero_2;
};
/// Controller (14) regrouped into P, I and D with its real zeros, zero_1 <= zero_2.
[[nodiscard]] RegulatorGains regulator_gains(const Regulator& in);

/// Controller and the first-order plant behind it (completion).
struct FeedLoop : Regulator {
  double plant_gain = 1;
  double plant_pole = 0.9091867638508087;
  std::int64_t delay = 2;
};
struct StepInputs : FeedLoop {
  std::int64_t n_samples = 1;
  double dead_band = 0;
  double band = 0.02;
};
struct StepResponse {
  std::vector<double> y;
  std::vector<double> y_first;
  double overshoot_pct;
  std::int64_t settle_samples;
  double steady_error;
};
/// Response of the closed loop to a unit step. COMPLETION (plant).
[[nodiscard]] StepResponse feed_channel_step_response(const StepInputs& in);

/// Stability of the same loop without dead band.
[[nodiscard]] SpectralRadius feed_loop_spectral_radius(const FeedLoop& in);

struct FeedChange : FeedLoop {
  double length_mm = 0;
  double feed_from_m_min = 0;
  double feed_to_m_min = 0;
  std::int64_t n_passes = 1;
  double dead_band = 0;
};
struct ChangeTime {
  double time_min;
};
/// Time of n passes while the feed follows a change; the first pass still runs at the old feed. COMPLETION.
[[nodiscard]] ChangeTime feed_change_time(const FeedChange& in);

}  // namespace verstat::models::k207

template <>
struct verstat::models::EnumNames<verstat::models::k207::ErrorLaw> {
  static constexpr std::array names{
      std::pair{k207::ErrorLaw::uniform, "uniform"}, std::pair{k207::ErrorLaw::triangular, "triangular"},
      std::pair{k207::ErrorLaw::normal, "normal"}, std::pair{k207::ErrorLaw::laplace, "laplace"},
      std::pair{k207::ErrorLaw::laplace_scale, "laplace_scale"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k207::Block> {
  static constexpr std::array names{
      std::pair{k207::Block::input, "input"}, std::pair{k207::Block::hold, "hold"},
      std::pair{k207::Block::regulator, "regulator"}, std::pair{k207::Block::drive, "drive"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k207::Variant> {
  static constexpr std::array names{std::pair{k207::Variant::repaired, "repaired"},
                                    std::pair{k207::Variant::printed, "printed"}};
};
