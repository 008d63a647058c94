#include "models/drilling/k404_step_drill_delamination.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/normal.h"
#include "models/math/solve.h"

namespace verstat::models::k404 {
namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180;

double square(double x) {
  return x * x;
}

// The bracket in the denominator of eq. (2).
double next_stage_bracket(double nu, double xi) {
  return 2 * (1 - nu) * (1 + 2 * nu * nu) - (12 - 4 * nu + 3 * nu * nu + 3 * nu * nu * nu) * xi * xi -
         8 * (1 + 3 * nu) * xi * xi * std::log(xi);
}

// (C1) over the critical thrust without a hole, which is 4 pi sqrt(2 gd).
double clamped_factor(double nu, double xi) {
  const double xi2 = xi * xi;
  const double xi2_ln_xi = xi > 0 ? xi2 * std::log(xi) : 0;
  return ((1 - nu) + (1 + nu) * xi2) / ((1 - nu) * (1 - xi) * (1 + xi) - 2 * (1 + nu) * xi2_ln_xi);
}

double clamped_disc_n(double gd_n2) {
  return 4 * pi * std::sqrt(2 * gd_n2);
}

// Eq. (3) in units of P a^2 / (16 pi D), over the radius in units of a.
double relative_deflection(double nu, double r) {
  const double log_term = r > 0 ? 2 * r * r * std::log(r) : 0;
  return (3 + nu) / (1 + nu) * (1 - r) * (1 + r) + log_term;
}

double feed_limit(double critical_n, double safety, double c_n_mm, double width_mm, double exponent) {
  return std::pow(critical_n / (safety * c_n_mm * width_mm), 1 / exponent);
}

struct StageFeeds {
  double first, next;
};
StageFeeds feeds_at(const StepDrillChoice& in, double xi) {
  const double disc_n = clamped_disc_n(in.gd_n2);
  return {feed_limit(disc_n, in.safety, in.c_first_n_mm, xi * in.diameter_mm, in.exponent),
          feed_limit(disc_n * clamped_factor(in.poisson, xi), in.safety, in.c_next_n_mm,
                     (1 - xi) * in.diameter_mm, in.exponent)};
}

}  // namespace

BendingStiffness bending_stiffness(const Ply& in) {
  return guarded<&bending_stiffness>(in, [&] {
    return BendingStiffness{in.e_modulus_mpa * in.thickness_mm * in.thickness_mm * in.thickness_mm /
                            (12 * (1 - square(in.poisson)))};
  });
}

EnergyReleaseRate energy_release_rate(const StressIntensity& in) {
  return guarded<&energy_release_rate>(in, [&] {
    constexpr double mm_per_m = 1000;
    return EnergyReleaseRate{(1 - square(in.poisson)) * square(in.k_i_mpa_m05) * mm_per_m / in.e_modulus_mpa};
  });
}

CriticalThrust critical_thrust_first_stage(const FirstStagePlate& in) {
  return guarded<&critical_thrust_first_stage>(in, [&] {
    return CriticalThrust{4 * pi * std::sqrt(2 * in.gd_n2 * (1 + in.poisson) / (3 + in.poisson))};
  });
}

NextStageThrust critical_thrust_next_stage(const NextStagePlate& in) {
  return guarded<&critical_thrust_next_stage>(in, [&] {
    const double nu = in.poisson;
    const double bracket = next_stage_bracket(nu, in.ratio);
    require(std::abs(bracket) > 1e-12, "xi", in.ratio, "must not be at the pole of eq. (2)");
    const double numerator = (1 - nu) + 2 * (1 + nu) * square(in.ratio);
    return NextStageThrust{std::numbers::sqrt2 * pi / (1 - nu) * numerator *
                               std::sqrt(32 * in.gd_n2 / ((1 + nu) * std::abs(bracket))),
                           bracket > 0};
  });
}

Pole next_stage_pole(const PoissonRatio& in) {
  return guarded<&next_stage_pole>(in, [&] {
    return Pole{find_root([&](double xi) { return next_stage_bracket(in.poisson, xi); }, 0.3, 1)};
  });
}

CriticalThrust critical_thrust_clamped(const NextStagePlate& in) {
  return guarded<&critical_thrust_clamped>(
      in, [&] { return CriticalThrust{clamped_disc_n(in.gd_n2) * clamped_factor(in.poisson, in.ratio)}; });
}

Deflection plate_deflection(const LoadedPlate& in) {
  return guarded<&plate_deflection>(in, [&] {
    const double a_mm = in.support_radius_mm;
    require(in.radius_mm <= a_mm, "r", in.radius_mm, "must not be above a");
    return Deflection{in.thrust_n * a_mm * a_mm / (16 * pi * in.stiffness_n_mm) *
                      relative_deflection(in.poisson, in.radius_mm / a_mm)};
  });
}

StageRadius stage_radius_for_deflection(const DeflectionLimit& in) {
  return guarded<&stage_radius_for_deflection>(in, [&] {
    const double a_mm = in.support_radius_mm;
    const double limit = in.deflection_limit_mm * 16 * pi * in.stiffness_n_mm / (in.thrust_n * a_mm * a_mm);
    if (limit >= relative_deflection(in.poisson, 0)) return StageRadius{0};
    if (limit <= 0) return StageRadius{a_mm};
    return StageRadius{a_mm *
                       find_root([&](double r) { return relative_deflection(in.poisson, r) - limit; }, 0, 1)};
  });
}

FeedLimit step_drill_feed_limit(const StepDrillLoad& in) {
  return guarded<&step_drill_feed_limit>(in, [&] {
    const double first =
        feed_limit(in.critical_first_n, in.safety, in.c_first_n_mm, in.ratio * in.diameter_mm, in.exponent);
    const double next = feed_limit(in.critical_next_n, in.safety, in.c_next_n_mm,
                                   (1 - in.ratio) * in.diameter_mm, in.exponent);
    return FeedLimit{first, next, std::min(first, next), first <= next ? 1 : 2};
  });
}

BestRatio best_step_ratio(const StepDrillChoice& in) {
  return guarded<&best_step_ratio>(in, [&] {
    constexpr double least = 0.1;
    constexpr double most = 0.9;
    // Below the crossing the second stage limits, above it the first; both thrusts share gd, d, y and S.
    const auto excess = [&](double xi) {
      return in.c_first_n_mm * xi * clamped_factor(in.poisson, xi) - in.c_next_n_mm * (1 - xi);
    };
    double xi = 0;
    if (excess(least) >= 0)
      xi = least;
    else if (excess(most) <= 0)
      xi = most;
    else
      xi = find_root(excess, least, most);
    const StageFeeds feeds = feeds_at(in, xi);
    return BestRatio{xi, std::min(feeds.first, feeds.next)};
  });
}

Delamination delamination_probability(const ThrustScatter& in) {
  return guarded<&delamination_probability>(in, [&] {
    const double margin_n = in.thrust_mean_n - in.critical_n;
    const double deviation_n = std::hypot(in.cv_thrust * in.thrust_mean_n, in.cv_critical * in.critical_n);
    if (deviation_n == 0) return Delamination{margin_n < 0 ? 0.0 : margin_n > 0 ? 1.0 : 0.5};
    return Delamination{normal_cdf(margin_n / deviation_n)};
  });
}

DrillGeometry step_drill_geometry(const DrillSize& in) {
  return guarded<&step_drill_geometry>(in, [&] {
    return DrillGeometry{.first_diameter_mm = in.ratio * in.diameter_mm,
                         .next_diameter_mm = in.diameter_mm,
                         .helix_deg = 28,
                         .first_point_deg = 120,
                         .next_point_deg = 140,
                         .first_relief_deg = 10,
                         .next_relief_deg = 10,
                         .chisel_angle_deg = 55,
                         .web_radius_mm = 0.6};
  });
}

WorkingRelief working_relief(const StaticRelief& in) {
  return guarded<&working_relief>(in, [&] {
    return WorkingRelief{in.relief_deg -
                         std::atan(in.feed_mm_rev / (2 * pi * in.radius_mm)) / radians_per_degree};
  });
}

DrillingTime step_drilling_time(const StepDrilling& in) {
  return guarded<&step_drilling_time>(in, [&] {
    const auto cone_mm = [](double width_mm, double point_deg) {
      return width_mm / 2 / std::tan(point_deg / 2 * radians_per_degree);
    };
    const double travel_mm = in.approach_mm + in.thickness_mm + in.overrun_mm +
                             cone_mm(in.ratio * in.diameter_mm, in.first_point_deg) + in.step_length_mm +
                             cone_mm((1 - in.ratio) * in.diameter_mm, in.next_point_deg);
    return DrillingTime{travel_mm, travel_mm / (in.feed_mm_rev * in.speed_rpm)};
  });
}

namespace {

constexpr Range poisson_range = closed(0, 0.45);
constexpr Range point_range = open_low(0, 180);

void poisson(auto& f, auto pointer) {
  f.input(pointer, "nu", "nu", "1", poisson_range, "Poisson's ratio of the ply", 0.32);
}
void gd(auto& f, auto pointer) {
  f.input(pointer, "gd", "G_IC D", "N^2", positive(), "critical energy release rate times bending stiffness",
          29.48);
}
void thrust_model(auto& f, auto c_first, auto c_next, auto exponent, auto safety) {
  f.input(c_first, "c_1", "c_1", "N/mm", positive(), "thrust constant of stage 1, chisel edge included", 90.0)
      .input(c_next, "c_2", "c_2", "N/mm", positive(), "thrust constant of stage 2", 45.0)
      .input(exponent, "y", "y", "1", closed(0.5, 1), "exponent of the feed in the thrust", 0.8)
      .input(safety, "safety", "S", "1", at_least(1), "safety factor on the thrust", 1.5);
}

void describe_thrusts(Source& source) {
  source
      .function<&bending_stiffness>("bending_stiffness", "Bending stiffness of the uncut ply.",
                                    "under eq. (1)", Provenance::paper)
      .input(&Ply::e_modulus_mpa, "e_modulus", "E", "MPa", positive(), "modulus of elasticity", 14000.0)
      .input(&Ply::thickness_mm, "h", "h", "mm", positive(), "thickness of the uncut ply", 0.5)
      .with([](auto& f) { poisson(f, &Ply::poisson); })
      .output(&BendingStiffness::stiffness_n_mm, "d", "D", "N*mm", positive(), "bending stiffness");
  source
      .function<&energy_release_rate>("energy_release_rate", "Critical energy release rate from K_I.",
                                      "under eq. (1)", Provenance::paper)
      .input(&StressIntensity::k_i_mpa_m05, "k_i", "K_I", "MPa*m^0.5", non_negative(),
             "critical stress intensity", 1.6)
      .input(&StressIntensity::e_modulus_mpa, "e_modulus", "E", "MPa", positive(), "modulus of elasticity",
             14000.0)
      .with([](auto& f) { poisson(f, &StressIntensity::poisson); })
      .output(&EnergyReleaseRate::g_ic_n_mm, "g_ic", "G_IC", "N/mm", non_negative(),
              "critical energy release rate");
  source
      .function<&critical_thrust_first_stage>("critical_thrust_first_stage",
                                              "Critical thrust of the first stage of a step drill.",
                                              "eq. (1)", Provenance::paper)
      .with([](auto& f) { gd(f, &FirstStagePlate::gd_n2); })
      .with([](auto& f) { poisson(f, &FirstStagePlate::poisson); })
      .output(&CriticalThrust::thrust_n, "p", "P", "N", positive(), "critical thrust")
      .note("A simply supported disc; the clamped disc of Hocheng and Dharan carries 1.59 times more.");
  source
      .function<&critical_thrust_next_stage>("critical_thrust_next_stage",
                                             "Critical thrust of the next stage of a step drill.", "eq. (2)",
                                             Provenance::reconstructed)
      .with([](auto& f) { gd(f, &NextStagePlate::gd_n2); })
      .with([](auto& f) { poisson(f, &NextStagePlate::poisson); })
      .input(&NextStagePlate::ratio, "xi", "xi", "1", open_low(0, 1), "ratio of the stage diameters", 0.4)
      .output(&NextStageThrust::thrust_n, "f_t", "F_T", "N", positive(), "critical thrust")
      .output(&NextStageThrust::valid, "valid", "-", "-", no_range(),
              "the bracket of eq. (2) is positive; otherwise f_t must not be used")
      .note(
          "Beyond the pole the printed table took the absolute value of a negative bracket: its maximum at "
          "0.6 and its fall to 1 are artefacts.")
      .note("Prefer critical_thrust_clamped.");
  source
      .function<&next_stage_pole>("next_stage_pole", "Ratio at which eq. (2) has its false pole.",
                                  "bracket of eq. (2)", Provenance::completion)
      .with([](auto& f) { poisson(f, &PoissonRatio::poisson); })
      .output(&Pole::ratio, "xi_pole", "xi_pole", "1", open(0.3, 1), "zero of the bracket");
  source
      .function<&critical_thrust_clamped>("critical_thrust_clamped",
                                          "Critical thrust of either stage, clamped plate.", "(C1)",
                                          Provenance::completion)
      .with([](auto& f) { gd(f, &NextStagePlate::gd_n2); })
      .with([](auto& f) { poisson(f, &NextStagePlate::poisson); })
      .input(&NextStagePlate::ratio, "xi", "xi", "1", open_high(0, 1),
             "ratio of the stage diameters, 0 for the first stage", 0.4)
      .output(&CriticalThrust::thrust_n, "f", "F", "N", positive(), "critical thrust")
      .note("gd is a fitted value: measure it; a tough thermoplastic ply may need far more than estimated.");
  const auto plate = [](auto& f, auto thrust, auto stiffness, auto nu, auto support) {
    f.input(thrust, "p", "P", "N", positive(), "thrust", 60.0)
        .input(stiffness, "d", "D", "N*mm", positive(), "bending stiffness", 160.0);
    poisson(f, nu);
    f.input(support, "a", "a", "mm", positive(), "distance to the support", 10.0);
  };
  source
      .function<&plate_deflection>("plate_deflection", "Deflection of the ply at the radius of the stage.",
                                   "eq. (3)", Provenance::paper)
      .with([&](auto& f) {
        plate(f, &LoadedPlate::thrust_n, &LoadedPlate::stiffness_n_mm, &LoadedPlate::poisson,
              &LoadedPlate::support_radius_mm);
      })
      .input(&LoadedPlate::radius_mm, "r", "r", "mm", non_negative(), "radius of the stage, at most a", 2.0)
      .output(&Deflection::deflection_mm, "w", "w", "mm", non_negative(), "deflection");
  source
      .function<&stage_radius_for_deflection>("stage_radius_for_deflection",
                                              "Smallest stage radius that keeps a limit on deflection.",
                                              "eq. (3), inverse", Provenance::paper)
      .with([&](auto& f) {
        plate(f, &DeflectionLimit::thrust_n, &DeflectionLimit::stiffness_n_mm, &DeflectionLimit::poisson,
              &DeflectionLimit::support_radius_mm);
      })
      .input(&DeflectionLimit::deflection_limit_mm, "w_max", "w", "mm", non_negative(), "limit on deflection",
             1.0)
      .output(&StageRadius::radius_mm, "r", "r", "mm", non_negative(), "radius of the stage")
      .note(
          "The deflection falls with the radius, so a limit bounds the radius from below, though the paper "
          "speaks of the largest radius.");
}

void describe_drill(Source& source) {
  source
      .function<&step_drill_feed_limit>("step_drill_feed_limit",
                                        "Largest exit feed without delamination, per stage.", "(C2)",
                                        Provenance::completion)
      .input(&StepDrillLoad::diameter_mm, "d", "d_2", "mm", positive(), "finished diameter", 10.0)
      .input(&StepDrillLoad::ratio, "xi", "xi", "1", open(0, 1), "ratio of the stage diameters", 0.4)
      .input(&StepDrillLoad::critical_first_n, "f_crit_1", "F_c1", "N", positive(),
             "critical thrust of stage 1", 61.5)
      .input(&StepDrillLoad::critical_next_n, "f_crit_2", "F_c2", "N", positive(),
             "critical thrust of stage 2", 131.1)
      .with([](auto& f) {
        thrust_model(f, &StepDrillLoad::c_first_n_mm, &StepDrillLoad::c_next_n_mm, &StepDrillLoad::exponent,
                     &StepDrillLoad::safety);
      })
      .output(&FeedLimit::feed_first_mm_rev, "f_1", "f_1", "mm/rev", non_negative(), "feed limit of stage 1")
      .output(&FeedLimit::feed_next_mm_rev, "f_2", "f_2", "mm/rev", non_negative(), "feed limit of stage 2")
      .output(&FeedLimit::feed_max_mm_rev, "f_max", "f_max", "mm/rev", non_negative(), "largest exit feed")
      .output(&FeedLimit::binding_stage, "binding_stage", "-", "1", closed(1, 2), "stage that limits")
      .note("The constants of the thrust are the user's; a worn drill needs larger ones.");
  source
      .function<&best_step_ratio>("best_step_ratio", "Ratio of the stages for the largest exit feed.",
                                  "(C1), (C2)", Provenance::completion)
      .with([](auto& f) { gd(f, &StepDrillChoice::gd_n2); })
      .with([](auto& f) { poisson(f, &StepDrillChoice::poisson); })
      .input(&StepDrillChoice::diameter_mm, "d", "d_2", "mm", positive(), "finished diameter", 10.0)
      .with([](auto& f) {
        thrust_model(f, &StepDrillChoice::c_first_n_mm, &StepDrillChoice::c_next_n_mm,
                     &StepDrillChoice::exponent, &StepDrillChoice::safety);
      })
      .output(&BestRatio::ratio, "xi", "xi", "1", closed(0.1, 0.9), "ratio of the stage diameters")
      .output(&BestRatio::feed_max_mm_rev, "f_max", "f_max", "mm/rev", non_negative(), "largest exit feed");
  source
      .function<&delamination_probability>("delamination_probability",
                                           "Probability that the thrust delaminates the hole.", "(C3)",
                                           Provenance::completion)
      .input(&ThrustScatter::thrust_mean_n, "f_mean", "F", "N", positive(), "mean thrust", 50.0)
      .input(&ThrustScatter::cv_thrust, "cv_force", "v_F", "1", non_negative(),
             "coefficient of variation of the thrust", 0.15)
      .input(&ThrustScatter::critical_n, "f_crit", "F_c", "N", positive(), "mean critical thrust", 61.5)
      .input(&ThrustScatter::cv_critical, "cv_crit", "v_c", "1", non_negative(),
             "coefficient of variation of the critical thrust", 0.1)
      .output(&Delamination::probability, "probability", "P_d", "1", probability(),
              "probability of delamination");
  source
      .function<&step_drill_geometry>("step_drill_geometry", "The published geometry of the step drill.",
                                      "table of the geometry", Provenance::paper)
      .input(&DrillSize::diameter_mm, "d", "d_2", "mm", positive(), "finished diameter", 10.0)
      .optional(&DrillSize::ratio, "xi", "xi", "1", open(0, 1), "ratio of the stage diameters")
      .output(&DrillGeometry::first_diameter_mm, "d_1", "d_1", "mm", positive(), "diameter of stage 1")
      .output(&DrillGeometry::next_diameter_mm, "d_2", "d_2", "mm", positive(), "diameter of stage 2")
      .output(&DrillGeometry::helix_deg, "helix_deg", "-", "deg", positive(), "helix angle of both stages")
      .output(&DrillGeometry::first_point_deg, "point_1_deg", "-", "deg", positive(),
              "point angle of stage 1")
      .output(&DrillGeometry::next_point_deg, "point_2_deg", "-", "deg", positive(), "point angle of stage 2")
      .output(&DrillGeometry::first_relief_deg, "relief_1_deg", "-", "deg", positive(),
              "relief of stage 1 at the periphery")
      .output(&DrillGeometry::next_relief_deg, "relief_2_deg", "-", "deg", positive(),
              "relief of stage 2 at the periphery")
      .output(&DrillGeometry::chisel_angle_deg, "chisel_angle_deg", "-", "deg", positive(),
              "angle of the chisel edge")
      .output(&DrillGeometry::web_radius_mm, "web_radius", "-", "mm", positive(), "radius of the web")
      .note("The unit of the web radius is not printed; the helix of stage 2 is implied.");
  source
      .function<&working_relief>("working_relief", "Relief angle left at a radius by the feed.", "(C4)",
                                 Provenance::completion)
      .input(&StaticRelief::relief_deg, "alpha_static", "alpha", "deg", open(-90, 90), "static relief", 10.0)
      .input(&StaticRelief::feed_mm_rev, "feed", "f", "mm/rev", positive(), "feed", 0.1)
      .input(&StaticRelief::radius_mm, "r", "r", "mm", positive(), "radius of the point of the edge", 0.6)
      .input(&StaticRelief::half_point_deg, "half_point", "-", "deg", open_low(0, 90),
             "half of the point angle; not used by this approximation", 60.0)
      .output(&WorkingRelief::relief_deg, "alpha_work", "alpha_w", "deg", any(), "working relief");
  source
      .function<&step_drilling_time>("step_drilling_time", "Travel and time of drilling with a step drill.",
                                     "(C5)", Provenance::completion)
      .input(&StepDrilling::thickness_mm, "thickness", "-", "mm", positive(), "thickness of the part", 6.0)
      .input(&StepDrilling::diameter_mm, "d", "d_2", "mm", positive(), "finished diameter", 10.0)
      .input(&StepDrilling::ratio, "xi", "xi", "1", open(0, 1), "ratio of the stage diameters", 0.4)
      .input(&StepDrilling::first_point_deg, "point_1", "2 phi_1", "deg", point_range,
             "full point angle of stage 1", 120.0)
      .input(&StepDrilling::next_point_deg, "point_2", "2 phi_2", "deg", point_range,
             "full point angle of stage 2", 140.0)
      .input(&StepDrilling::step_length_mm, "step_length", "-", "mm", non_negative(),
             "cylindrical length of stage 1", 8.0)
      .input(&StepDrilling::approach_mm, "approach", "-", "mm", non_negative(), "approach", 1.0)
      .input(&StepDrilling::overrun_mm, "overrun", "-", "mm", non_negative(), "overrun", 1.0)
      .input(&StepDrilling::feed_mm_rev, "feed", "f", "mm/rev", positive(), "feed", 0.1)
      .input(&StepDrilling::speed_rpm, "n", "n", "rpm", positive(), "spindle speed", 2000.0)
      .output(&DrillingTime::travel_mm, "travel", "-", "mm", positive(), "travel under feed")
      .output(&DrillingTime::time_min, "time", "-", "min", positive(), "drilling time");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K404",
       .title = "Analytical calculation of loads in machining TWINTEX with a step drill and determination of "
                "its optimal geometric parameters",
       .authors = "Globa O. V., Kukhanovskyi O. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "When a drill breaks through a laminate, its thrust pushes the last uncut ply off. Fracture "
                 "mechanics of a thin plate gives the critical thrust of both stages of a step drill, hence "
                 "the feed allowed at the exit, the best ratio of the stages and the probability of scrap.",
       .role = "drilling",
       .errata = {
           "The bracket in the denominator of eq. (2) changes sign at a ratio of about 0.6: the printed "
           "force "
           "table takes its absolute value, so the rows 0.7 to 1.0 mean nothing. A clamped annulus (C1) is "
           "given beside it.",
           "Eqs. (1) and (2) rest on different supports (simply supported, clamped): the printed doubling of "
           "the critical load from stage 1 to stage 2 is an effect of that.",
           "None of E, K_I, h and nu is printed: nu = 0.32 and G_IC D = 29.48 N^2 are recovered from the "
           "table."}});
  describe_thrusts(source);
  describe_drill(source);
}

}  // namespace verstat::models::k404
