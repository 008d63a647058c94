#include "models/grinding/k207_longitudinal_feed_controller.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace verstat::models::k207 {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t largest_degree = 200;  // of a characteristic polynomial
constexpr std::size_t first_values = 12;     // of a response, for a quick look

DrivePolynomial drive(double a, double b, double c, double d, double m) {
  const double sum = a + b + c + d;
  const double pairs = c * d + a * b + (a + b) * (c + d);
  const double triples = (a + b) * c * d + a * b * (c + d);
  const double all = a * b * c * d;
  return {sum, m * sum + pairs, m * pairs + triples, m * triples + all, m * all};
}

// A real amplitude and a phase as magnitude and phase in (-180, 180].
FrequencyResponse response(double amplitude, double phase_rad) {
  double phase_deg = std::remainder(phase_rad / degree + (amplitude < 0 ? 180 : 0), 360);
  if (phase_deg <= -180) phase_deg += 360;
  return {std::abs(amplitude), phase_deg};
}

double given(const std::optional<double>& value, std::string_view input, bool positive = true) {
  require(value.has_value(), input, Value(), "must be given for this block");
  require(!positive || *value > 0, input, *value, "must be positive");
  return *value;
}

// Product of two polynomials in z^-1; an empty one is 0.
std::vector<double> product(const std::vector<double>& p, const std::vector<double>& q) {
  if (p.empty() || q.empty()) return {};
  std::vector<double> out(p.size() + q.size() - 1, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
  return out;
}

// Largest modulus of the roots z of c0 + c1 z^-1 + ...; c0 is not 0. Roots at 0 are dropped first.
double spectral_radius(std::vector<double> c) {
  while (c.size() > 1 && c.back() == 0) c.pop_back();
  const std::size_t n = c.size() - 1;
  if (n == 0) return 0;
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) companion(0, k) = -c[static_cast<std::size_t>(k) + 1] / c[0];
  for (Eigen::Index k = 1; k < size; ++k) companion(k, k - 1) = 1;
  if (!companion.allFinite()) reject("the coefficients overflow: d0 is too small");
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, false);
  if (solver.info() != Eigen::Success) reject("the roots of the characteristic polynomial do not converge");
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

double loop_radius(const std::vector<double>& a_d, const std::vector<double>& b_f, std::int64_t delay) {
  const std::size_t terms =
      std::max(a_d.size(), b_f.empty() ? std::size_t{0} : b_f.size() + static_cast<std::size_t>(delay));
  require(terms <= largest_degree + 1, "delay", delay,
          "makes the characteristic polynomial longer than degree 200");
  std::vector<double> c(terms, 0.0);
  for (std::size_t k = 0; k < a_d.size(); ++k) c[k] = a_d[k];
  for (std::size_t k = 0; k < b_f.size(); ++k) c[k + static_cast<std::size_t>(delay)] += b_f[k];
  return spectral_radius(std::move(c));
}

double next_control(const Regulator& r, double u_prev, double e0, double e1, double e2) {
  return u_prev + (r.n0 * e0 + r.n1 * e1 + r.n2 * e2) / r.d0;
}

void check_regulator(const Regulator& in) {
  require(in.d0 != 0, "d0", in.d0, "must not be 0");
}

// y of the unit step: every sample measures, compares and corrects.
std::vector<double> step_response(const FeedLoop& in, std::size_t samples, double dead_band) {
  check_regulator(in);
  std::vector<double> y(samples, 0.0);
  std::vector<double> u(samples, 0.0);
  double e1 = 0;
  double e2 = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const auto delay = static_cast<std::size_t>(in.delay);
    const double drive_in = k >= delay ? u[k - delay] : 0;
    if (k > 0) y[k] = in.plant_pole * y[k - 1] + in.plant_gain * (1 - in.plant_pole) * drive_in;
    double e0 = 1 - y[k];
    if (std::abs(e0) <= dead_band) e0 = 0;
    u[k] = next_control(in, k > 0 ? u[k - 1] : 0, e0, e1, e2);
    e2 = e1;
    e1 = e0;
  }
  return y;
}

}  // namespace

LongitudinalFeed longitudinal_feed(const PassMeasured& in) {
  return guarded<&longitudinal_feed>(
      in, [&] { return LongitudinalFeed{in.length_mm / 1000 / (in.pass_time_s / 60)}; });
}

PassDuration longitudinal_pass_time(const PassAtFeed& in) {
  return guarded<&longitudinal_pass_time>(
      in, [&] { return PassDuration{60 * in.length_mm / (1000 * in.feed_m_min)}; });
}

EntropyInterval entropy_interval(const CodeError& in) {
  return guarded<&entropy_interval>(in, [&] {
    using std::numbers::e;
    switch (in.law) {
      case ErrorLaw::uniform:
        return EntropyInterval{in.sigma * std::numbers::sqrt3};
      case ErrorLaw::triangular:
        return EntropyInterval{in.sigma * std::sqrt(1.5 * e)};
      case ErrorLaw::normal:
        return EntropyInterval{in.sigma * std::sqrt(std::numbers::pi * e / 2)};
      case ErrorLaw::laplace:
        return EntropyInterval{in.sigma * e / std::numbers::sqrt2};
      case ErrorLaw::laplace_scale:
        break;
    }
    return EntropyInterval{in.sigma * e};
  });
}

DrivePolynomial drive_polynomial(const DriveLags& in) {
  return guarded<&drive_polynomial>(
      in, [&] { return drive(in.tau_mc_s, in.t_mc_s, in.t_e_s, in.t_em_s, in.t_m_s); });
}

FrequencyResponse feed_channel_block(const BlockAtFrequency& in) {
  return guarded<&feed_channel_block>(in, [&] {
    const double omega = 2 * std::numbers::pi * in.freq_hz;
    if (in.block == Block::drive) {
      const double k = given(in.k, "k", false);
      const double tau_t = given(in.tau_t_s, "tau_t_s");
      const double tau_p2 = given(in.tau_p2_s, "tau_p2_s");
      const DrivePolynomial a =
          drive(given(in.tau_mc_s, "tau_mc_s"), given(in.t_mc_s, "t_mc_s"), given(in.t_e_s, "t_e_s"),
                given(in.t_em_s, "t_em_s"), given(in.t_m_s, "t_m_s"));
      const std::complex<double> p(0, omega);
      const std::complex<double> h =
          k * tau_t * p / ((tau_p2 * p + 1.0) * ((((a.a4 * p + a.a3) * p + a.a2) * p + a.a1) * p + a.a0));
      return response(std::abs(h), std::arg(h));
    }
    const double tau = given(in.tau_s, "tau_s");
    if (in.block == Block::input) return response(given(in.k, "k", false) * in.delta_e, -omega * tau);
    // 1 - e^-jx = 2 sin(x/2) e^j(90 deg - x/2)
    const double chord = 2 * std::sin(omega * tau / 2);
    if (in.block == Block::hold) return response(chord / omega, -omega * tau / 2);
    return response(chord / tau, std::numbers::pi / 2 - omega * tau / 2);
  });
}

ReferenceNumerator reference_model_numerator(const ReferenceModel& in) {
  return guarded<&reference_model_numerator>(in, [&] {
    const double gain = in.delta_e * in.k_m / in.eps;
    return ReferenceNumerator{gain * (1 - in.t_m), gain * (in.t_m - in.l4)};
  });
}

RegulatorPolynomials regulator_polynomials(const PlantModel& in) {
  return guarded<&regulator_polynomials>(in, [&] {
    const auto& a = in.a;
    const auto& b = in.b;
    for (std::size_t k = 0; k < 3; ++k)
      require(a[k] != 0, "a/" + std::to_string(k), a[k], "must not be 0: eqs. (10)-(12) divide by it");
    const double f1 = 1 + 1 / a[0];
    const double f2 = f1 + 1 / a[1];
    const double g1 = b[1] - b[0] * a[0] + b[0] * f1;
    const double third = in.variant == Variant::repaired ? b[0] : b[2];
    const double g2 = b[2] + b[1] * f1 + third * f2 - b[0] * a[1] - a[0] * g1;
    return RegulatorPolynomials{{in.r1 * b[0], (in.r1 * b[1] + in.r2 * b[0]) / a[0],
                                 (in.r1 * b[2] + in.r2 * b[1]) / a[1], (in.r1 * b[3] + in.r2 * b[2]) / a[2]},
                                {1, f1, f2},
                                {b[0], g1, g2}};
  });
}

SpectralRadius closed_loop_spectral_radius(const ClosedLoop& in) {
  return guarded<&closed_loop_spectral_radius>(in, [&] {
    require(in.d[0] != 0, "d/0", in.d[0], "must not be 0");
    std::vector<double> a{1};
    a.insert(a.end(), in.a.begin(), in.a.end());
    return SpectralRadius{loop_radius(product(a, in.d), product(in.b, in.f), in.delay)};
  });
}

RegulatorOutput regulator_step(const RegulatorInputs& in) {
  return guarded<&regulator_step>(in, [&] {
    check_regulator(in);
    return RegulatorOutput{next_control(in, in.u_prev, in.e0, in.e1, in.e2)};
  });
}

RegulatorGains regulator_gains(const Regulator& in) {
  return guarded<&regulator_gains>(in, [&] {
    check_regulator(in);
    require(in.n0 != 0, "n0", in.n0, "must not be 0: the controller has one zero only");
    const double discriminant = in.n1 * in.n1 - 4 * in.n0 * in.n2;
    require(discriminant >= 0, "n1", in.n1, "must leave the zeros of n0 z^2 + n1 z + n2 real");
    // The root without cancellation, and the other one from the product of both.
    const double sum = -(in.n1 + std::copysign(std::sqrt(discriminant), in.n1)) / 2;
    const double first = sum / in.n0;
    const double second = sum == 0 ? 0 : in.n2 / sum;
    const double q1 = in.n1 / in.d0;
    const double q2 = in.n2 / in.d0;
    return RegulatorGains{-q1 - 2 * q2, (in.n0 + in.n1 + in.n2) / in.d0, q2, std::min(first, second),
                          std::max(first, second)};
  });
}

StepResponse feed_channel_step_response(const StepInputs& in) {
  return guarded<&feed_channel_step_response>(in, [&] {
    StepResponse out{};
    out.y = step_response(in, static_cast<std::size_t>(in.n_samples), in.dead_band);
    out.y_first.assign(out.y.begin(),
                       out.y.begin() + static_cast<std::ptrdiff_t>(std::min(out.y.size(), first_values)));
    out.overshoot_pct = std::max(0.0, 100 * (*std::max_element(out.y.begin(), out.y.end()) - 1));
    for (std::size_t k = 0; k < out.y.size(); ++k)
      if (std::abs(out.y[k] - 1) > in.band) out.settle_samples = static_cast<std::int64_t>(k) + 1;
    out.steady_error = 1 - out.y.back();
    return out;
  });
}

SpectralRadius feed_loop_spectral_radius(const FeedLoop& in) {
  return guarded<&feed_loop_spectral_radius>(in, [&] {
    check_regulator(in);
    const double gain = in.plant_gain * (1 - in.plant_pole) / in.d0;
    return SpectralRadius{loop_radius(product({1, -1}, {1, -in.plant_pole}),
                                      {gain * in.n0, gain * in.n1, gain * in.n2}, in.delay)};
  });
}

ChangeTime feed_change_time(const FeedChange& in) {
  return guarded<&feed_change_time>(in, [&] {
    double time_min = 0;
    for (const double y : step_response(in, static_cast<std::size_t>(in.n_passes), in.dead_band)) {
      const double feed_m_min = in.feed_from_m_min + (in.feed_to_m_min - in.feed_from_m_min) * y;
      require(feed_m_min > 0, "feed_to_m_min", in.feed_to_m_min,
              "makes the feed overshoot to zero or below: reduce it in smaller steps");
      time_min += in.length_mm / 1000 / feed_m_min;
    }
    return ChangeTime{time_min};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K207",
       .title = "Synthesis of an optimal digital controller of the longitudinal feed of a grinding wheel",
       .authors = "Yenikeiev A. F., Subotin O. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011, "
                    "pp. 175-179",
       .models =
           "A feedback channel that holds the longitudinal feed of a grinding wheel: measurement once per "
           "pass, digital controller of reference-model form, feed servo behind a zero-order hold, two "
           "samples "
           "of dead time. Gives the blocks, the polynomials of the controller and one numeric controller; "
           "what "
           "a change of feed costs in passes.",
       .role = "grinding",
       .errata = {"The density of the code error is called triangular and printed as a Laplace density; the "
                  "measured "
                  "kurtosis fits the name.",
                  "The entropy interval sigma exp(sigma) = 0.036142 is just sigma; exp(H)/2 stands instead.",
                  "Eq. (8) prints a minus before the control effort and the limit of the sum as infinity.",
                  "Eq. (12) prints b_2 f_2 in g_2; the long division B F / A gives b_0 f_2.",
                  "Eq. (13) is not the closed loop of eqs. (6), (7), which is z^-2 B H / (A D + z^-2 B F).",
                  "Eq. (10) divides coefficient by coefficient, which is no division of polynomials: kept as "
                  "printed."}});

  const auto lag = [](auto& f, auto member, const char* name, const char* symbol, const char* meaning,
                      double example) { f.input(member, name, symbol, "s", positive(), meaning, example); };
  const auto block_lag = [](auto& f, auto member, const char* name, const char* symbol, const char* meaning,
                            double example) {
    f.optional(member, name, symbol, "s", any(), meaning).example(example);
  };
  const auto regulator = [](auto& f) {
    f.optional(&Regulator::n0, "n0", "n_0", "1", any(), "coefficient of the error now")
        .optional(&Regulator::n1, "n1", "n_1", "1", any(), "coefficient of the error one sample ago")
        .optional(&Regulator::n2, "n2", "n_2", "1", any(), "coefficient of the error two samples ago")
        .optional(&Regulator::d0, "d0", "d_0", "1", any(), "divisor, not 0");
  };
  const auto loop = [&](auto& f) {
    f.optional(&FeedLoop::plant_gain, "plant_gain", "K", "1", any(), "gain of the plant")
        .optional(&FeedLoop::plant_pole, "plant_pole", "lambda", "1", any(), "pole of the plant")
        .optional(&FeedLoop::delay, "delay", "-", "1", closed(1, 1'000'000), "dead time, samples")
        .with(regulator);
  };
  const std::string completed =
      "The plant is a completion: the paper gives no plant data. One sample is read as one pass.";

  source
      .function<&longitudinal_feed>("longitudinal_feed", "Measured feed of one pass.", "S_np = l / t_1",
                                    Provenance::paper)
      .input(&PassMeasured::length_mm, "length_mm", "l", "mm", positive(),
             "length between the limit switches", 200.0)
      .input(&PassMeasured::pass_time_s, "pass_time_s", "t_1", "s", positive(), "time between them", 2.0)
      .output(&LongitudinalFeed::feed_m_min, "feed_m_min", "S_np", "m/min", positive(), "feed");
  source
      .function<&longitudinal_pass_time>("longitudinal_pass_time", "Time of one pass.", "S_np = l / t_1",
                                         Provenance::paper)
      .input(&PassAtFeed::length_mm, "length_mm", "l", "mm", positive(), "length of the pass", 200.0)
      .input(&PassAtFeed::feed_m_min, "feed_m_min", "S_np", "m/min", positive(), "feed", 6.0)
      .output(&PassDuration::pass_time_s, "pass_time_s", "t_1", "s", positive(), "time");
  source
      .function<&entropy_interval>("entropy_interval", "Entropy interval of uncertainty of the input module.",
                                   "second eq. (2)", Provenance::repaired)
      .input(&CodeError::sigma, "sigma", "sigma", "any", non_negative(),
             "standard deviation; for laplace_scale the scale of the density", 0.036142)
      .input(&CodeError::law, "law", "-", "-", no_range(), "law of the code error", "triangular")
      .output(&EntropyInterval::delta_e, "delta_e", "Delta_e", "any", non_negative(),
              "interval, unit of sigma")
      .note("Use triangular: the measured kurtosis fits it.");
  source
      .function<&drive_polynomial>("drive_polynomial", "Denominator of the drive.", "eq. (5)",
                                   Provenance::paper)
      .with([&](auto& f) {
        lag(f, &DriveLags::tau_mc_s, "tau_mc_s", "tau_mc", "time constant", 0.02);
        lag(f, &DriveLags::t_mc_s, "t_mc_s", "T_mc", "time constant", 0.05);
        lag(f, &DriveLags::t_e_s, "t_e_s", "T_e", "electrical time constant", 0.004);
        lag(f, &DriveLags::t_em_s, "t_em_s", "T_em", "electromechanical time constant", 0.008);
        lag(f, &DriveLags::t_m_s, "t_m_s", "T_M", "time constant of the motor", 0.12);
      })
      .output(&DrivePolynomial::a0, "a0", "a_0", "s", positive(), "coefficient of p^0")
      .output(&DrivePolynomial::a1, "a1", "a_1", "s^2", positive(), "coefficient of p")
      .output(&DrivePolynomial::a2, "a2", "a_2", "s^3", positive(), "coefficient of p^2")
      .output(&DrivePolynomial::a3, "a3", "a_3", "s^4", positive(), "coefficient of p^3")
      .output(&DrivePolynomial::a4, "a4", "a_4", "s^5", positive(), "coefficient of p^4");
  source
      .function<&feed_channel_block>("feed_channel_block", "Frequency response of a block of the channel.",
                                     "eqs. (1)-(5)", Provenance::paper)
      .input(&BlockAtFrequency::block, "block", "-", "-", no_range(), "which block", "drive")
      .input(&BlockAtFrequency::freq_hz, "freq_hz", "f", "Hz", positive(), "frequency", 1.0)
      .optional(&BlockAtFrequency::k, "k", "k", "any", any(),
                "gain of input; of drive the product k_M T_k1 k_P2")
      .example(1.5)
      .with([&](auto& f) {
        block_lag(f, &BlockAtFrequency::tau_s, "tau_s", "tau", "input, hold, regulator", 0.05);
      })
      .optional(&BlockAtFrequency::delta_e, "delta_e", "Delta_e", "1", any(), "input: entropy interval")
      .with([&](auto& f) {
        block_lag(f, &BlockAtFrequency::tau_t_s, "tau_t_s", "tau_T", "drive: sampling period", 0.1);
        block_lag(f, &BlockAtFrequency::tau_p2_s, "tau_p2_s", "tau_P2", "drive: lag of the input module",
                  0.02);
        block_lag(f, &BlockAtFrequency::tau_mc_s, "tau_mc_s", "tau_mc", "drive: time constant", 0.02);
        block_lag(f, &BlockAtFrequency::t_mc_s, "t_mc_s", "T_mc", "drive: time constant", 0.05);
        block_lag(f, &BlockAtFrequency::t_e_s, "t_e_s", "T_e", "drive: electrical time constant", 0.004);
        block_lag(f, &BlockAtFrequency::t_em_s, "t_em_s", "T_em", "drive: electromechanical time constant",
                  0.008);
        block_lag(f, &BlockAtFrequency::t_m_s, "t_m_s", "T_M", "drive: time constant of the motor", 0.12);
      })
      .output(&FrequencyResponse::magnitude, "magnitude", "|H|", "any", non_negative(), "magnitude")
      .output(&FrequencyResponse::phase_deg, "phase_deg", "arg H", "deg", closed(-180, 180), "phase")
      .note("The drive block differentiates: H4(0) = 0.");
  source
      .function<&reference_model_numerator>("reference_model_numerator", "Numerator of the reference model.",
                                            "eq. (9)", Provenance::reconstructed)
      .input(&ReferenceModel::delta_e, "delta_e", "Delta_e", "any", any(), "entropy interval", 0.036142)
      .input(&ReferenceModel::k_m, "k_m", "k_M", "1", any(), "gain", 1.2)
      .input(&ReferenceModel::t_m, "t_m", "T_M", "samples", positive(), "time constant in sample periods",
             0.6)
      .input(&ReferenceModel::l4, "l4", "l_4", "1", any(), "exp(-1/T_M) by interpretation", 0.1)
      .input(&ReferenceModel::eps, "eps", "eps_adm", "any", positive(), "admissible error", 0.05)
      .output(&ReferenceNumerator::r1, "r1", "r_1", "1", any(), "coefficient of z^-1")
      .output(&ReferenceNumerator::r2, "r2", "r_2", "1", any(), "coefficient of z^-2")
      .note("l_4 is undefined in the paper.");
  source
      .function<&regulator_polynomials>("regulator_polynomials", "Polynomials of the controller.",
                                        "eqs. (10)-(12)", Provenance::repaired)
      .input(&PlantModel::a, "a", "a_i", "1", any(), "a1..a3 of the plant, not 0",
             Value::List{-1.2, 0.5, -0.08})
      .length(3, 3)
      .input(&PlantModel::b, "b", "b_i", "1", any(), "b0..b3 of the plant",
             Value::List{0.1, 0.08, 0.03, 0.01})
      .length(4, 4)
      .input(&PlantModel::r1, "r1", "r_1", "1", any(), "from the reference model", 0.3)
      .input(&PlantModel::r2, "r2", "r_2", "1", any(), "from the reference model", 0.4)
      .optional(&PlantModel::variant, "variant", "-", "-", no_range(), "g_2 repaired or as printed")
      .output(&RegulatorPolynomials::h, "h", "h_i", "1", any(), "eq. (10)")
      .output(&RegulatorPolynomials::f, "f", "f_i", "1", any(), "eq. (11)")
      .output(&RegulatorPolynomials::g, "g", "g_i", "1", any(), "eq. (12)")
      .note("Eq. (10) has no basis in control theory; kept for parity with the paper.");
  source
      .function<&closed_loop_spectral_radius>("closed_loop_spectral_radius", "Stability of a closed loop.",
                                              "eqs. (6), (7)", Provenance::repaired)
      .input(&ClosedLoop::a, "a", "A", "1", any(), "a1..., the leading 1 left out", Value::List{-0.9})
      .length(0, 100)
      .input(&ClosedLoop::b, "b", "B", "1", any(), "b0...", Value::List{0.1})
      .length(0, 100)
      .input(&ClosedLoop::d, "d", "D", "1", any(), "d0..., d0 not 0", Value::List{1.0, -1.0})
      .length(1, 100)
      .input(&ClosedLoop::f, "f", "F", "1", any(), "f0...", Value::List{0.127, 2.305, -2.2})
      .length(0, 100)
      .input(&ClosedLoop::delay, "delay", "-", "1", closed(1, 1'000'000), "dead time, samples", 2)
      .output(&SpectralRadius::rho, "rho", "rho", "1", non_negative(), "largest modulus; stable below 1")
      .note("Degree up to 200.");
  source
      .function<&regulator_step>("regulator_step", "One step of the controller.", "eq. (14)",
                                 Provenance::paper)
      .input(&RegulatorInputs::u_prev, "u_prev", "u_{t-1}", "1", any(), "last control", 0.5)
      .input(&RegulatorInputs::e0, "e0", "e_t", "1", any(), "error now", 0.2)
      .input(&RegulatorInputs::e1, "e1", "e_{t-1}", "1", any(), "error one sample ago", 0.6)
      .input(&RegulatorInputs::e2, "e2", "e_{t-2}", "1", any(), "error two samples ago", 1.0)
      .with(regulator)
      .output(&RegulatorOutput::u, "u", "u_t", "1", any(), "control");
  source
      .function<&regulator_gains>("regulator_gains", "The controller as P, I and D.", "eq. (14) regrouped",
                                  Provenance::completion)
      .with(regulator)
      .output(&RegulatorGains::k_p, "k_p", "K_P", "1", any(), "proportional gain")
      .output(&RegulatorGains::k_i, "k_i", "K_I", "1", any(), "integral gain")
      .output(&RegulatorGains::k_d, "k_d", "K_D", "1", any(), "derivative gain")
      .output(&RegulatorGains::zero_1, "zero_1", "z_1", "1", any(), "smaller zero")
      .output(&RegulatorGains::zero_2, "zero_2", "z_2", "1", any(), "larger zero");
  source
      .function<&feed_channel_step_response>("feed_channel_step_response",
                                             "Response of the feed to a change of its set value.",
                                             "eq. (14) with a completed plant", Provenance::completion)
      .input(&StepInputs::n_samples, "n_samples", "-", "1", closed(1, 1'000'000), "samples", 60)
      .with(loop)
      .optional(&StepInputs::dead_band, "dead_band", "-", "1", non_negative(),
                "error taken as zero, in units of the step")
      .optional(&StepInputs::band, "band", "-", "1", non_negative(), "band of settling, in units of the step")
      .output(&StepResponse::y, "y", "y", "1", any(), "feed in units of the step, from sample 0")
      .output(&StepResponse::y_first, "y_first", "y", "1", any(), "its first 12 values")
      .output(&StepResponse::overshoot_pct, "overshoot_pct", "-", "%", non_negative(), "overshoot")
      .output(&StepResponse::settle_samples, "settle_samples", "-", "1", non_negative(),
              "index after the last sample outside the band; n_samples: not settled")
      .output(&StepResponse::steady_error, "steady_error", "-", "1", any(), "1 less the last value")
      .note(completed);
  source
      .function<&feed_loop_spectral_radius>("feed_loop_spectral_radius", "Stability of the feed loop.",
                                            "characteristic polynomial", Provenance::completion)
      .with(loop)
      .output(&SpectralRadius::rho, "rho", "rho", "1", non_negative(), "largest modulus; stable below 1")
      .note(completed);
  source
      .function<&feed_change_time>("feed_change_time", "Time of passes during a change of feed.",
                                   "completion", Provenance::completion)
      .input(&FeedChange::length_mm, "length_mm", "l", "mm", positive(), "length of a pass", 200.0)
      .input(&FeedChange::feed_from_m_min, "feed_from_m_min", "-", "m/min", positive(), "old feed", 4.0)
      .input(&FeedChange::feed_to_m_min, "feed_to_m_min", "-", "m/min", positive(), "new feed", 6.0)
      .input(&FeedChange::n_passes, "n_passes", "-", "1", closed(1, 1'000'000), "passes", 30)
      .with(loop)
      .optional(&FeedChange::dead_band, "dead_band", "-", "1", non_negative(),
                "error taken as zero, in units of the step")
      .output(&ChangeTime::time_min, "time_min", "-", "min", positive(), "time of all passes")
      .note(completed);
}

}  // namespace verstat::models::k207
