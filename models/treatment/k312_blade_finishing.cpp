#include "models/treatment/k312_blade_finishing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "models/math/normal.h"
#include "models/math/polyline.h"

namespace verstat::models::k312 {
namespace {

// Table 2: Ra, H, S_H, u, sigma_-1, S.
FinishState table_2(Finish variant) {
  switch (variant) {
    case Finish::polishing:
      return {0.224, 4184, 153.11, 26.6, 540.5, 36.0};
    case Finish::soft:
      return {0.248, 4164, 118.67, 26.0, 540.5, 11.0};
    case Finish::medium:
      return {0.299, 4612, 224.36, 39.6, 571.5, 13.0};
    case Finish::hard:
      return {0.309, 4086, 105.31, 23.7, 504.0, 8.0};
    case Finish::vibropolishing:
      break;
  }
  return {0.711, 4477, 197.43, 35.5, std::nullopt, std::nullopt};
}

// Residual stress of the back, printed points: depth um, MPa. At 30 um of P and VP the mean of -3..-18.
constexpr std::array<Node, 2> polished_profile{{{0, -388}, {30, -10.5}}};
constexpr std::array<Node, 2> medium_profile{{{0, -210}, {20, -292}}};
constexpr std::array<Node, 3> hard_profile{{{0, -323}, {10, -469}, {70, -72}}};

// Middle intensity of Table 1 times minutes; dose 0 is polishing alone.
constexpr std::array<Node, 4> endurance_over_dose{{{0, 540.5}, {162.5, 540.5}, {312.5, 571.5}, {625, 504}}};
constexpr std::array<Node, 4> scatter_over_dose{{{0, 36}, {162.5, 11}, {312.5, 13}, {625, 8}}};

constexpr double test_step_mpa = 30.9;
constexpr double test_step_swing_mm = 0.2;

// Levels may miss the grid of the step by this share of a step.
constexpr double grid_slack = 1e-6;

StaircaseEstimate dixon_mood(const StaircaseTest& in) {
  const auto failures = std::count(in.failed.begin(), in.failed.end(), true);
  const auto survivors = static_cast<std::ptrdiff_t>(in.failed.size()) - failures;
  const bool from_failures = failures <= survivors;
  const double lowest = *std::ranges::min_element(in.levels_mpa);
  const auto grid_index = [&](double level) { return std::round((level - lowest) / in.step_mpa); };

  double least = 0;
  double count = 0;
  for (std::size_t k = 0; k < in.levels_mpa.size(); ++k)
    if (in.failed[k] == from_failures) {
      least = count == 0 ? in.levels_mpa[k] : std::min(least, in.levels_mpa[k]);
      ++count;
    }
  double first = 0;   // A, sum of the grid indices above the lowest level of the rarer outcome
  double second = 0;  // B, sum of their squares
  for (std::size_t k = 0; k < in.levels_mpa.size(); ++k)
    if (in.failed[k] == from_failures) {
      const double index = grid_index(in.levels_mpa[k]) - grid_index(least);
      first += index;
      second += index * index;
    }
  const double mean = least + in.step_mpa * (first / count + (from_failures ? -0.5 : 0.5));
  const double v = (count * second - first * first) / (count * count);
  return {mean, v >= 0.3 ? 1.62 * in.step_mpa * (v + 0.029) : 0.53 * in.step_mpa};
}

}  // namespace

FinishState finish_state(const FinishChoice& in) {
  return guarded<&finish_state>(in, [&] { return table_2(in.variant); });
}

HardeningRegime hardening_regime(const HardenedChoice& in) {
  return guarded<&hardening_regime>(in, [&] {
    const bool soft = in.variant == HardenedFinish::soft;
    const bool hard = in.variant == HardenedFinish::hard;
    return HardeningRegime{.mass_kg = 0.4,
                           .ball_min_mm = 1.0,
                           .ball_max_mm = 1.3,
                           .intensity_min = soft ? 30.0 : 60.0,
                           .intensity_max = soft ? 35.0 : 65.0,
                           .time_min = hard ? 10.0 : 5.0};
  });
}

WorkHardening hardening_degree(const Microhardness& in) {
  return guarded<&hardening_degree>(
      in, [&] { return WorkHardening{100 * (in.hardness_mpa - in.reference_mpa) / in.reference_mpa}; });
}

EnduranceLimit endurance_limit_midpoint(const TestedStresses& in) {
  return guarded<&endurance_limit_midpoint>(in, [&] {
    require(in.sigma_min_mpa <= in.sigma_max_mpa, "sigma_min", in.sigma_min_mpa,
            "must not be above sigma_max");
    return EnduranceLimit{(in.sigma_min_mpa + in.sigma_max_mpa) / 2};
  });
}

Stress stress_from_swing(const TipSwing& in) {
  return guarded<&stress_from_swing>(
      in, [&] { return Stress{test_step_mpa * (in.double_amplitude_mm / test_step_swing_mm)}; });
}

Stress residual_stress(const DepthBelowSurface& in) {
  return guarded<&residual_stress>(in, [&] {
    switch (in.variant) {
      case ProfiledFinish::medium:
        require(in.depth_um <= medium_profile.back().x, "depth", in.depth_um,
                "must be at most 20 um for P+UH2");
        return Stress{polyline(medium_profile, in.depth_um)};
      case ProfiledFinish::hard:
        require(in.depth_um <= hard_profile.back().x, "depth", in.depth_um,
                "must be at most 70 um for P+UH3");
        return Stress{polyline(hard_profile, in.depth_um)};
      case ProfiledFinish::polishing:
      case ProfiledFinish::vibropolishing:
        break;
    }
    return Stress{polyline(polished_profile, in.depth_um)};
  });
}

ScrapShare route_scrap(const RouteChoice& in) {
  return guarded<&route_scrap>(
      in, [&] { return ScrapShare{in.route == FormingRoute::cold_rolling ? 0.38 : 0.02}; });
}

RoughnessVerdict roughness_ok(const RoughnessCheck& in) {
  return guarded<&roughness_ok>(
      in, [&] { return RoughnessVerdict{table_2(in.variant).ra_um <= in.ra_limit_um}; });
}

EnduranceAfterDose endurance_after_dose(const HardeningDose& in) {
  return guarded<&endurance_after_dose>(in, [&] {
    const double dose = in.intensity * in.time_min;
    return EnduranceAfterDose{dose, polyline(endurance_over_dose, dose), polyline(scatter_over_dose, dose)};
  });
}

FailureProbability fatigue_failure_probability(const StressAndStrength& in) {
  return guarded<&fatigue_failure_probability>(in, [&] {
    const double scatter = std::hypot(in.sigma_a_sd_mpa, in.sigma_1_sd_mpa);
    require(scatter > 0, "sigma_1_sd", in.sigma_1_sd_mpa, "must not be zero when sigma_a_sd is zero");
    return FailureProbability{normal_cdf((in.sigma_a_mpa - in.sigma_1_mpa) / scatter)};
  });
}

Stress guaranteed_endurance(const ScatteredEndurance& in) {
  return guarded<&guaranteed_endurance>(
      in, [&] { return Stress{in.sigma_1_mpa - normal_quantile(in.reliability) * in.sigma_1_sd_mpa}; });
}

StaircaseEstimate staircase(const StaircaseTest& in) {
  return guarded<&staircase>(in, [&] {
    require(in.failed.size() == in.levels_mpa.size(), "failed", static_cast<std::int64_t>(in.failed.size()),
            "entries: must be as many as of levels");
    if (std::ranges::all_of(in.failed, [](bool failed) { return failed; }) ||
        std::ranges::none_of(in.failed, [](bool failed) { return failed; }))
      reject("failed must hold both failures and survivors");
    const double lowest = *std::ranges::min_element(in.levels_mpa);
    for (const double level : in.levels_mpa) {
      const double index = (level - lowest) / in.step_mpa;
      require(std::abs(index - std::round(index)) <= grid_slack, "levels", level,
              "must lie a whole number of steps above the lowest level");
    }
    return dixon_mood(in);
  });
}

TestTime endurance_test_time(const EnduranceTest& in) {
  return guarded<&endurance_test_time>(in, [&] { return TestTime{in.cycles / in.frequency_hz / 60}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K312",
       .title = "Quality control surface blades GTE engineering methods",
       .authors = "Sakhniuk N. V., Ivchenko L. I.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Titanium (VT8) compressor blades milled at high speed and finished by hand polishing, polishing "
           "with ultrasonic shot hardening at three regimes, or vibropolishing: roughness, microhardness, "
           "residual stress, endurance limit and its scatter. There is a best hardening dose; too much harms "
           "the thin edges.",
       .role = "treatment",
       .errata = {
           "The gain in endurance of P+UH2 is printed as 5.4 %, which is relative to the new value; relative "
           "to polishing it is 5.7 %.",
           "Ra of vibropolishing is printed as almost twice the others; the table gives 2.3 to 3.2 times.",
           "The unit mA of the hardening intensity is doubtful; it is used as an index.",
           "The paper says P+UH2 improves the micro-relief; its Ra rises from 0.224 to 0.299 um."}});

  source
      .function<&finish_state>("finish_state", "Measured surface state and endurance limit after a route.",
                               "Table 2", Provenance::paper)
      .input(&FinishChoice::variant, "variant", "-", "-", no_range(), "finishing route", "P+UH2")
      .output(&FinishState::ra_um, "ra", "R_a", "um", positive(), "roughness")
      .output(&FinishState::microhardness_mpa, "microhardness", "H", "MPa", positive(), "microhardness, 50 g")
      .output(&FinishState::microhardness_sd_mpa, "microhardness_sd", "S_H", "MPa", positive(), "its scatter")
      .output(&FinishState::hardening_pct, "hardening", "u", "%", any(), "degree of work hardening")
      .output(&FinishState::sigma_1_mpa, "sigma_1", "sigma_-1", "MPa", positive(),
              "endurance limit; none for VP, which was not tested")
      .output(&FinishState::sigma_1_sd_mpa, "sigma_1_sd", "S", "MPa", positive(), "its scatter")
      .note(
          "The number of blades is not given; S is taken as the standard deviation of the endurance limit.");
  source
      .function<&hardening_regime>("hardening_regime", "Regime of the ultrasonic hardening.", "Table 1",
                                   Provenance::paper)
      .input(&HardenedChoice::variant, "variant", "-", "-", no_range(), "route with hardening", "P+UH2")
      .output(&HardeningRegime::mass_kg, "mass", "-", "kg", positive(), "mass of the balls")
      .output(&HardeningRegime::ball_min_mm, "ball_min", "-", "mm", positive(), "least diameter of the balls")
      .output(&HardeningRegime::ball_max_mm, "ball_max", "-", "mm", positive(),
              "largest diameter of the balls")
      .output(&HardeningRegime::intensity_min, "intensity_min", "-", "mA", positive(), "least intensity")
      .output(&HardeningRegime::intensity_max, "intensity_max", "-", "mA", positive(), "largest intensity")
      .output(&HardeningRegime::time_min, "t", "t", "min", positive(), "time of treatment");
  source
      .function<&hardening_degree>("hardening_degree", "Degree of work hardening from microhardness.",
                                   "reproduces Table 2", Provenance::reconstructed)
      .input(&Microhardness::hardness_mpa, "H", "H", "MPa", positive(), "microhardness of the surface",
             4184.0)
      .optional(&Microhardness::reference_mpa, "H_ref", "H_ref", "MPa", positive(),
                "microhardness of the base")
      .output(&WorkHardening::degree_pct, "u", "u", "%", any(), "degree of work hardening");
  source
      .function<&endurance_limit_midpoint>("endurance_limit_midpoint",
                                           "Endurance limit between the tested stresses.", "text",
                                           Provenance::paper)
      .input(&TestedStresses::sigma_min_mpa, "sigma_min", "sigma_min", "MPa", non_negative(),
             "least stress tested", 525.3)
      .input(&TestedStresses::sigma_max_mpa, "sigma_max", "sigma_max", "MPa", non_negative(),
             "stress of the first failure", 556.2)
      .output(&EnduranceLimit::sigma_1_mpa, "sigma_1", "sigma_-1", "MPa", non_negative(), "endurance limit");
  source
      .function<&stress_from_swing>("stress_from_swing", "Stress from the swing of the blade tip.", "text",
                                    Provenance::paper)
      .input(&TipSwing::double_amplitude_mm, "double_amplitude", "2A", "mm", non_negative(),
             "swing of the tip", 0.2)
      .output(&Stress::sigma_mpa, "sigma", "sigma", "MPa", non_negative(), "stress amplitude")
      .note("Proportional to the printed step of the test, 30.9 MPa for 0.2 mm.");
  source
      .function<&residual_stress>("residual_stress", "Residual stress below the back of the blade.", "text",
                                  Provenance::completion)
      .input(&DepthBelowSurface::variant, "variant", "-", "-", no_range(),
             "finishing route with known stresses", "P+UH3")
      .input(&DepthBelowSurface::depth_um, "depth", "-", "um", non_negative(),
             "depth; P+UH2 up to 20, P+UH3 up to 70", 10.0)
      .output(&Stress::sigma_mpa, "sigma", "sigma", "MPa", any(), "residual stress, compression negative")
      .note("Printed points, linear between. P+UH1 has no data.");
  source.function<&route_scrap>("route_scrap", "Scrap of the forming route.", "text", Provenance::paper)
      .input(&RouteChoice::route, "route", "-", "-", no_range(), "forming route", "high_speed_milling")
      .output(&ScrapShare::p_scrap, "p_scrap", "-", "1", probability(), "share of scrap")
      .note("Printed as upper values.");
  source
      .function<&roughness_ok>("roughness_ok", "Whether a route meets the roughness limit.", "Table 2",
                               Provenance::paper)
      .input(&RoughnessCheck::variant, "variant", "-", "-", no_range(), "finishing route", "P+UH3")
      .optional(&RoughnessCheck::ra_limit_um, "ra_limit", "R_a", "um", positive(), "roughness limit")
      .output(&RoughnessVerdict::ok, "ok", "-", "-", no_range(), "roughness within the limit");
  source
      .function<&endurance_after_dose>("endurance_after_dose", "Endurance limit over the hardening dose.",
                                       "completion", Provenance::completion)
      .input(&HardeningDose::intensity, "intensity", "-", "mA", non_negative(), "intensity, printed unit",
             62.5)
      .input(&HardeningDose::time_min, "t", "t", "min", non_negative(), "time of treatment", 5.0)
      .output(&EnduranceAfterDose::dose, "dose", "q", "mA*min", non_negative(), "intensity times time")
      .output(&EnduranceAfterDose::sigma_1_mpa, "sigma_1", "sigma_-1", "MPa", positive(), "endurance limit")
      .output(&EnduranceAfterDose::sigma_1_sd_mpa, "sigma_1_sd", "S", "MPa", positive(), "its scatter")
      .note(
          "Linear between four tested doses: an engineering guess. Constant above 625, which is optimistic.");
  source
      .function<&fatigue_failure_probability>(
          "fatigue_failure_probability", "Probability that the working stress exceeds the endurance limit.",
          "completion", Provenance::completion)
      .input(&StressAndStrength::sigma_a_mpa, "sigma_a", "sigma_a", "MPa", non_negative(),
             "working stress amplitude", 480.0)
      .input(&StressAndStrength::sigma_a_sd_mpa, "sigma_a_sd", "s_a", "MPa", non_negative(), "its scatter",
             20.0)
      .input(&StressAndStrength::sigma_1_mpa, "sigma_1", "sigma_-1", "MPa", non_negative(), "endurance limit",
             571.5)
      .input(&StressAndStrength::sigma_1_sd_mpa, "sigma_1_sd", "s_-1", "MPa", non_negative(), "its scatter",
             13.0)
      .output(&FailureProbability::p, "p", "p", "1", probability(), "failure probability")
      .note("If the printed scatter is a standard error of the mean, the result is too low.");
  source
      .function<&guaranteed_endurance>("guaranteed_endurance", "Endurance limit at a required reliability.",
                                       "completion", Provenance::completion)
      .input(&ScatteredEndurance::sigma_1_mpa, "sigma_1", "sigma_-1", "MPa", non_negative(),
             "endurance limit", 540.5)
      .input(&ScatteredEndurance::sigma_1_sd_mpa, "sigma_1_sd", "s_-1", "MPa", non_negative(), "its scatter",
             36.0)
      .input(&ScatteredEndurance::reliability, "reliability", "R", "1", closed(0.5, 0.99999),
             "share of blades above the result", 0.99)
      .output(&Stress::sigma_mpa, "sigma", "-", "MPa", any(), "guaranteed endurance limit");
  source
      .function<&staircase>("staircase", "Endurance limit and scatter from an up-and-down test.",
                            "completion (Dixon, Mood)", Provenance::completion)
      .input(&StaircaseTest::levels_mpa, "levels", "-", "MPa", non_negative(), "stress levels in test order",
             Value::List{500.0, 530.0, 500.0, 530.0, 560.0})
      .length(2, 100'000)
      .input(&StaircaseTest::failed, "failed", "-", "-", no_range(), "whether the specimen failed",
             Value::List{false, true, false, false, true})
      .length(2, 100'000)
      .input(&StaircaseTest::step_mpa, "step", "-", "MPa", positive(), "step between levels", 30.0)
      .output(&StaircaseEstimate::mean_mpa, "mean", "-", "MPa", any(), "mean endurance limit")
      .output(&StaircaseEstimate::sd_mpa, "sd", "-", "MPa", positive(), "its standard deviation")
      .note("Cannot return less than 0.53 steps of deviation: 16.4 MPa for the step of the paper.");
  source
      .function<&endurance_test_time>("endurance_test_time", "Time of one specimen in the fatigue test.",
                                      "text", Provenance::paper)
      .optional(&EnduranceTest::cycles, "cycles", "-", "1", non_negative(), "cycles without failure")
      .input(&EnduranceTest::frequency_hz, "frequency", "f", "Hz", positive(), "frequency of the first mode",
             1050.0)
      .output(&TestTime::time_min, "t", "t", "min", non_negative(), "time per specimen");
}

}  // namespace verstat::models::k312
