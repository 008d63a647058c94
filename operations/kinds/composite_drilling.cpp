#include "operations/kinds/composite_drilling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/drilling/k404_step_drill_delamination.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::CompositeDrilling> {
  static std::vector<Field> fields() {
    using S = operations::CompositeDrilling;
    return {
        may<S>(&S::drill, "drill", "-", no_range(), "step drill or plain drill"),
        need<S>(&S::diameter_mm, "diameter_mm", "mm", closed(0.5, 200), "diameter of the hole"),
        may<S>(&S::step_ratio, "step_ratio", "1", closed(0.1, 0.9),
               "diameter of the first stage over the hole"),
        may<S>(&S::step_length_mm, "step_length_mm", "mm", closed(0, 1000),
               "cylindrical length of the first stage"),
        need<S>(&S::thickness_mm, "thickness_mm", "mm", closed(0.05, 1000), "thickness of the laminate"),
        may<S>(&S::holes, "holes", "1", closed(1, 10'000), "holes of one part"),
        may<S>(&S::index_min, "index_min", "min", closed(0, 1000), "positioning between two holes"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "approach"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "overrun"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 2000),
                "cutting speed at the diameter"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-4, 5), "feed before the exit"),
        may<S>(&S::exit_feed_mm_rev, "exit_feed_mm_rev", "mm/rev", closed(1e-4, 5),
               "feed while a stage breaks through; without it the feed"),
        may<S>(&S::exit_zone_mm, "exit_zone_mm", "mm", closed(0, 1000),
               "travel at the exit feed, for each stage"),
        may<S>(&S::elastic_modulus_mpa, "elastic_modulus_mpa", "MPa", closed(100, 1e6),
               "elastic modulus of the ply"),
        may<S>(&S::ply_thickness_mm, "ply_thickness_mm", "mm", closed(0.01, 20), "thickness of the last ply"),
        may<S>(&S::poisson, "poisson", "1", closed(0, 0.45), "Poisson's ratio"),
        may<S>(&S::stress_intensity_mpa_m05, "stress_intensity_mpa_m05", "MPa m^0.5", closed(0.01, 100),
               "critical stress intensity between the plies"),
        may<S>(&S::criterion, "criterion", "-", no_range(), "model of the critical thrust"),
        may<S>(&S::thrust_first_n_mm, "thrust_first_n_mm", "N/mm", open_low(0, 1e5),
               "thrust of the first stage (or the plain drill) per mm of diameter at a feed of 1 mm/rev"),
        may<S>(&S::thrust_next_n_mm, "thrust_next_n_mm", "N/mm", open_low(0, 1e5),
               "thrust of the second stage per mm of the diameter it adds"),
        may<S>(&S::thrust_exp_feed, "thrust_exp_feed", "1", closed(0.5, 1), "exponent of the feed"),
        may<S>(&S::flank_wear_mm, "flank_wear_mm", "mm", closed(0, 2), "flank wear of the drill"),
        may<S>(&S::thrust_growth_per_mm, "thrust_growth_per_mm", "1/mm", closed(0, 100),
               "relative growth of the thrust per mm of flank wear"),
        may<S>(&S::safety, "safety", "1", closed(1, 100), "critical thrust over the thrust allowed"),
        may<S>(&S::thrust_cv, "thrust_cv", "1", closed(0, 1), "coefficient of variation of the thrust"),
        may<S>(&S::critical_cv, "critical_cv", "1", closed(0, 1),
               "coefficient of variation of the critical thrust"),
        may<S>(&S::scrap_probability_max, "scrap_probability_max", "1", closed(0, 1),
               "largest probability of a part with a delaminated hole"),
        may<S>(&S::working_relief_min_deg, "working_relief_min_deg", "deg", closed(0, 45),
               "least relief in work at the web of the first stage")};
  }
};

namespace verstat::operations {

namespace {

namespace k404 = models::k404;

/// A stage breaking through.
struct Stage {
  double thrust_n = 0;
  double critical_n = 0;
  double feed_limit_mm_rev = 0;
  double delamination = 0;
};

double first_critical_n(const CompositeDrilling& spec, double gd_n2) {
  return spec.criterion == DelaminationCriterion::clamped
             ? k404::critical_thrust_clamped({.gd_n2 = gd_n2, .poisson = spec.poisson, .ratio = 0}).thrust_n
             : k404::critical_thrust_first_stage({.gd_n2 = gd_n2, .poisson = spec.poisson}).thrust_n;
}

double next_critical_n(const CompositeDrilling& spec, double gd_n2) {
  const k404::NextStagePlate plate{.gd_n2 = gd_n2, .poisson = spec.poisson, .ratio = spec.step_ratio};
  if (spec.criterion == DelaminationCriterion::clamped) return k404::critical_thrust_clamped(plate).thrust_n;
  const auto next = k404::critical_thrust_next_stage(plate);
  models::require(next.valid, "step_ratio", spec.step_ratio,
                  "is beyond the pole of the printed formula; use criterion \"clamped\"");
  return next.thrust_n;
}

Stage stage(const CompositeDrilling& spec, double coefficient_n_mm, double width_mm, double critical_n,
            double feed_mm_rev) {
  Stage s;
  s.critical_n = critical_n;
  s.thrust_n = coefficient_n_mm * width_mm * std::pow(feed_mm_rev, spec.thrust_exp_feed);
  s.feed_limit_mm_rev =
      std::pow(critical_n / (spec.safety * coefficient_n_mm * width_mm), 1 / spec.thrust_exp_feed);
  s.delamination = k404::delamination_probability({.thrust_mean_n = s.thrust_n,
                                                   .cv_thrust = spec.thrust_cv,
                                                   .critical_n = critical_n,
                                                   .cv_critical = spec.critical_cv})
                       .probability;
  return s;
}

}  // namespace

CutPlan plan(const CompositeDrilling& spec, const PlanContext& context) {
  const bool step = spec.drill == LaminateDrill::step;
  const double rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  const double exit_feed_mm_rev = spec.exit_feed_mm_rev.value_or(spec.feed_mm_rev);
  const auto drill = k404::step_drill_geometry({.diameter_mm = spec.diameter_mm, .ratio = spec.step_ratio});

  double travel_mm = 0;
  if (step) {
    travel_mm = k404::step_drilling_time({.thickness_mm = spec.thickness_mm,
                                          .diameter_mm = spec.diameter_mm,
                                          .ratio = spec.step_ratio,
                                          .first_point_deg = drill.first_point_deg,
                                          .next_point_deg = drill.next_point_deg,
                                          .step_length_mm = spec.step_length_mm,
                                          .approach_mm = spec.approach_mm,
                                          .overrun_mm = spec.overrun_mm,
                                          .feed_mm_rev = spec.feed_mm_rev,
                                          .speed_rpm = rpm})
                    .travel_mm;
  } else {
    const double cone_mm =
        spec.diameter_mm / 2 / std::tan(drill.first_point_deg / 2 * std::numbers::pi / 180);
    travel_mm = spec.approach_mm + spec.thickness_mm + cone_mm + spec.overrun_mm;
  }
  const double slow_mm = spec.exit_feed_mm_rev ? (step ? 2 : 1) * spec.exit_zone_mm : 0;
  models::require(slow_mm <= travel_mm, "exit_zone_mm", spec.exit_zone_mm,
                  "is longer than the travel of the drill");
  const double hole_min =
      (travel_mm - slow_mm) / (spec.feed_mm_rev * rpm) + slow_mm / (exit_feed_mm_rev * rpm);
  const double holes = static_cast<double>(spec.holes);
  const double cutting_min = holes * hole_min;

  CutPlan p;
  p.set_main_time(cutting_min + (holes - 1) * spec.index_min,
                  step ? "K404.step_drilling_time" : "COMPLETION: travel over feed rate");
  p.quantities.push_back({"spindle_speed_rpm", rpm, "rpm", "definition", "spindle speed"});
  p.quantities.push_back({"travel_mm", travel_mm, "mm",
                          step ? "K404.step_drilling_time" : "COMPLETION: approach, thickness, cone, overrun",
                          "travel of the drill through one hole"});

  const double stiffness_n_mm = k404::bending_stiffness({.e_modulus_mpa = spec.elastic_modulus_mpa,
                                                         .thickness_mm = spec.ply_thickness_mm,
                                                         .poisson = spec.poisson})
                                    .stiffness_n_mm;
  const double release_n_mm = k404::energy_release_rate({.k_i_mpa_m05 = spec.stress_intensity_mpa_m05,
                                                         .e_modulus_mpa = spec.elastic_modulus_mpa,
                                                         .poisson = spec.poisson})
                                  .g_ic_n_mm;
  const double gd_n2 = stiffness_n_mm * release_n_mm;
  const double wear = 1 + spec.thrust_growth_per_mm * spec.flank_wear_mm;
  const bool clamped = spec.criterion == DelaminationCriterion::clamped;
  const char* first_origin = clamped ? "K404.critical_thrust_clamped" : "K404.critical_thrust_first_stage";
  const char* next_origin = clamped ? "K404.critical_thrust_clamped" : "K404.critical_thrust_next_stage";
  constexpr const char* thrust_origin = "COMPLETION: thrust c w f^y";

  const double first_mm = step ? spec.step_ratio * spec.diameter_mm : spec.diameter_mm;
  const Stage first =
      stage(spec, wear * spec.thrust_first_n_mm, first_mm, first_critical_n(spec, gd_n2), exit_feed_mm_rev);
  p.quantities.push_back(
      {"thrust_first_n", first.thrust_n, "N", thrust_origin, "thrust of the first stage at the exit"});
  p.quantities.push_back({"critical_thrust_first_n", first.critical_n, "N", first_origin,
                          "thrust that delaminates under the first stage"});
  p.limits.push_back(
      {"thrust_first_n", first.thrust_n, first.critical_n / spec.safety, true, "N", first_origin});
  double feed_max_mm_rev = first.feed_limit_mm_rev;
  double sound = 1 - first.delamination;
  double thrust_max_n = first.thrust_n;
  if (step) {
    const Stage next = stage(spec, wear * spec.thrust_next_n_mm, (1 - spec.step_ratio) * spec.diameter_mm,
                             next_critical_n(spec, gd_n2), exit_feed_mm_rev);
    p.quantities.push_back(
        {"thrust_next_n", next.thrust_n, "N", thrust_origin, "thrust of the second stage at the exit"});
    p.quantities.push_back({"critical_thrust_next_n", next.critical_n, "N", next_origin,
                            "thrust that delaminates under the second stage"});
    p.limits.push_back(
        {"thrust_next_n", next.thrust_n, next.critical_n / spec.safety, true, "N", next_origin});
    const auto limit = k404::step_drill_feed_limit({.diameter_mm = spec.diameter_mm,
                                                    .ratio = spec.step_ratio,
                                                    .critical_first_n = first.critical_n,
                                                    .critical_next_n = next.critical_n,
                                                    .c_first_n_mm = wear * spec.thrust_first_n_mm,
                                                    .c_next_n_mm = wear * spec.thrust_next_n_mm,
                                                    .exponent = spec.thrust_exp_feed,
                                                    .safety = spec.safety});
    feed_max_mm_rev = limit.feed_max_mm_rev;
    p.quantities.push_back({"binding_stage", static_cast<double>(limit.binding_stage), "1",
                            "K404.step_drill_feed_limit", "stage that limits the exit feed"});
    sound *= 1 - next.delamination;
    thrust_max_n = std::max(thrust_max_n, next.thrust_n);
  }
  const char* feed_origin = step ? "K404.step_drill_feed_limit" : "COMPLETION: thrust c w f^y inverted";
  p.quantities.push_back({"exit_feed_limit_mm_rev", feed_max_mm_rev, "mm/rev", feed_origin,
                          "largest exit feed without delamination"});
  p.limits.push_back({"exit_feed_mm_rev", exit_feed_mm_rev, feed_max_mm_rev, true, "mm/rev", feed_origin});

  // The scrap of a part with several holes: holes and stages are independent.
  p.scrap_probability = sound <= 0 ? 1 : -std::expm1(holes * std::log(sound));
  constexpr const char* scrap_origin = "K404.delamination_probability; COMPLETION: holes independent";
  p.quantities.push_back({"scrap_probability", p.scrap_probability, "1", scrap_origin,
                          "probability of a part with a delaminated hole"});
  if (spec.scrap_probability_max)
    p.limits.push_back(
        {"scrap_probability", p.scrap_probability, *spec.scrap_probability_max, true, "1", scrap_origin});

  p.quantities.push_back(
      {"first_diameter_mm", first_mm, "mm", "K404.step_drill_geometry", "diameter of the first stage"});
  p.quantities.push_back(
      {"helix_deg", drill.helix_deg, "deg", "K404.step_drill_geometry", "helix angle of the drill"});
  p.quantities.push_back({"first_point_deg", drill.first_point_deg, "deg", "K404.step_drill_geometry",
                          "point angle of the first stage"});
  p.quantities.push_back({"next_point_deg", drill.next_point_deg, "deg", "K404.step_drill_geometry",
                          "point angle of the second stage"});
  const double relief_deg = k404::working_relief({.relief_deg = drill.first_relief_deg,
                                                  .feed_mm_rev = std::max(spec.feed_mm_rev, exit_feed_mm_rev),
                                                  .radius_mm = drill.web_radius_mm,
                                                  .half_point_deg = drill.first_point_deg / 2})
                                .relief_deg;
  p.quantities.push_back({"working_relief_deg", relief_deg, "deg", "K404.working_relief",
                          "relief left by the feed at the web radius"});
  if (spec.working_relief_min_deg)
    p.limits.push_back({"working_relief_deg", relief_deg, *spec.working_relief_min_deg, false, "deg",
                        "K404.working_relief"});

  limit_spindle_speed(p, context, rpm, "definition");
  limit_feed_rate(p, context, rpm * std::max(spec.feed_mm_rev, exit_feed_mm_rev), "definition");
  limit_feed_force(p, context, thrust_max_n, thrust_origin);
  if (context.edge != nullptr) {
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.diameter_mm / 2);
    // A life counts cutting; the main time also holds the positioning between holes.
    p.edge->mean_min *= p.main_time_min / cutting_min;
  }
  return p;
}

namespace composite_drilling {
void add_to(Kinds& kinds) {
  kinds.add<CompositeDrilling>("Holes through a laminate with a step drill: thrust against delamination.",
                               {"K404"});
}
}  // namespace composite_drilling

}  // namespace verstat::operations
