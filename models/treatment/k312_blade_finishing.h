#pragma once
// Finishing routes of milled titanium compressor blades (K312): measured surface state and endurance limit
// of five routes, and what follows for the failure probability in service.
//
// Sakhniuk, Ivchenko 2011. Stresses and microhardness in MPa. Routes follow high-speed milling: P polishing,
// P+UH1..3 polishing and soft, medium, hard ultrasonic hardening with balls, VP vibropolishing.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k312 {

enum class Finish { polishing, soft, medium, hard, vibropolishing };

struct FinishChoice {
  Finish variant = Finish::polishing;
};
struct FinishState {
  double ra_um;
  double microhardness_mpa;
  double microhardness_sd_mpa;
  double hardening_pct;
  std::optional<double> sigma_1_mpa;     // endurance limit; VP was not tested
  std::optional<double> sigma_1_sd_mpa;  // its scatter
};
/// Measured state of the surface after a route. K312 Table 2.
[[nodiscard]] FinishState finish_state(const FinishChoice& in);

enum class HardenedFinish { soft, medium, hard };
struct HardenedChoice {
  HardenedFinish variant = HardenedFinish::soft;
};
struct HardeningRegime {
  double mass_kg;
  double ball_min_mm, ball_max_mm;
  double intensity_min, intensity_max;  // printed in mA
  double time_min;
};
/// Regime of the ultrasonic hardening. K312 Table 1.
[[nodiscard]] HardeningRegime hardening_regime(const HardenedChoice& in);

struct Microhardness {
  double hardness_mpa = 0;
  double reference_mpa = 3304;  // of the metal below the surface
};
struct WorkHardening {
  double degree_pct;
};
/// Degree of work hardening u = 100 (H - H_ref)/H_ref. Not printed; reproduces Table 2.
[[nodiscard]] WorkHardening hardening_degree(const Microhardness& in);

struct TestedStresses {
  double sigma_min_mpa = 0;  // least stress tested
  double sigma_max_mpa = 0;  // stress of the first failure
};
struct EnduranceLimit {
  double sigma_1_mpa;
};
/// Endurance limit as the middle of the two stresses, 0 <= min <= max. K312, formula of the text.
[[nodiscard]] EnduranceLimit endurance_limit_midpoint(const TestedStresses& in);

struct TipSwing {
  double double_amplitude_mm = 0;
};
struct Stress {
  double sigma_mpa;
};
/// Stress in the blade root from the swing 2A of its tip: 30.9 MPa per 0.2 mm. K312, step of the test.
[[nodiscard]] Stress stress_from_swing(const TipSwing& in);

enum class ProfiledFinish { polishing, vibropolishing, medium, hard };
struct DepthBelowSurface {
  ProfiledFinish variant = ProfiledFinish::polishing;
  double depth_um = 0;  // P+UH2 up to 20, P+UH3 up to 70
};
/// Residual stress below the back of the blade, compression negative: printed points, linear between
/// (COMPLETION). P and VP constant beyond 30 um.
[[nodiscard]] Stress residual_stress(const DepthBelowSurface& in);

enum class FormingRoute { cold_rolling, high_speed_milling };
struct RouteChoice {
  FormingRoute route = FormingRoute::high_speed_milling;
};
struct ScrapShare {
  double p_scrap;
};
/// Scrap of the forming route, the printed upper values. K312 text.
[[nodiscard]] ScrapShare route_scrap(const RouteChoice& in);

struct RoughnessCheck {
  Finish variant = Finish::polishing;
  double ra_limit_um = 0.4;
};
struct RoughnessVerdict {
  bool ok;
};
/// Whether the roughness of a route meets the limit (equality does).
[[nodiscard]] RoughnessVerdict roughness_ok(const RoughnessCheck& in);

struct HardeningDose {
  double intensity = 0;  // printed mA
  double time_min = 0;
};
struct EnduranceAfterDose {
  double dose;
  double sigma_1_mpa;
  double sigma_1_sd_mpa;
};
/// Endurance limit over the hardening dose, intensity times time: linear between the four tested doses,
/// constant above the largest. COMPLETION, an engineering guess.
[[nodiscard]] EnduranceAfterDose endurance_after_dose(const HardeningDose& in);

struct StressAndStrength {
  double sigma_a_mpa = 0, sigma_a_sd_mpa = 0;  // working stress
  double sigma_1_mpa = 0, sigma_1_sd_mpa = 0;  // endurance limit
};
struct FailureProbability {
  double p;
};
/// P(working stress > endurance limit), both normal and independent. Not both deviations zero. COMPLETION.
[[nodiscard]] FailureProbability fatigue_failure_probability(const StressAndStrength& in);

struct ScatteredEndurance {
  double sigma_1_mpa = 0;
  double sigma_1_sd_mpa = 0;
  double reliability = 0;  // 0.5..0.99999
};
/// Endurance limit that a share `reliability` of the blades exceeds, sigma_-1 - z_R s. COMPLETION.
[[nodiscard]] Stress guaranteed_endurance(const ScatteredEndurance& in);

struct StaircaseTest {
  std::vector<double> levels_mpa;  // in test order
  std::vector<bool> failed;
  double step_mpa = 0;
};
struct StaircaseEstimate {
  double mean_mpa;
  double sd_mpa;
};
/// Mean and deviation of the endurance limit from an up-and-down test, Dixon and Mood on the rarer outcome.
/// COMPLETION. Both outcomes must occur; the levels must lie on one grid of the step.
[[nodiscard]] StaircaseEstimate staircase(const StaircaseTest& in);

struct EnduranceTest {
  double cycles = 2e7;
  double frequency_hz = 0;
};
struct TestTime {
  double time_min;
};
/// Time of one specimen in the fatigue test.
[[nodiscard]] TestTime endurance_test_time(const EnduranceTest& in);

}  // namespace verstat::models::k312

template <>
struct verstat::models::EnumNames<verstat::models::k312::Finish> {
  using Finish = k312::Finish;
  static constexpr std::array names{std::pair{Finish::polishing, "P"}, std::pair{Finish::soft, "P+UH1"},
                                    std::pair{Finish::medium, "P+UH2"}, std::pair{Finish::hard, "P+UH3"},
                                    std::pair{Finish::vibropolishing, "VP"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k312::HardenedFinish> {
  using Finish = k312::HardenedFinish;
  static constexpr std::array names{std::pair{Finish::soft, "P+UH1"}, std::pair{Finish::medium, "P+UH2"},
                                    std::pair{Finish::hard, "P+UH3"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k312::ProfiledFinish> {
  using Finish = k312::ProfiledFinish;
  static constexpr std::array names{std::pair{Finish::polishing, "P"},
                                    std::pair{Finish::vibropolishing, "VP"},
                                    std::pair{Finish::medium, "P+UH2"}, std::pair{Finish::hard, "P+UH3"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k312::FormingRoute> {
  static constexpr std::array names{std::pair{k312::FormingRoute::cold_rolling, "cold_rolling"},
                                    std::pair{k312::FormingRoute::high_speed_milling, "high_speed_milling"}};
};
