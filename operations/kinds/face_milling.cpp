#include "operations/kinds/face_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

#include "models/math/policy.h"
#include "models/reliability/k109_face_mill_replacement.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::FaceMilling> {
  static std::vector<Field> fields() {
    using S = operations::FaceMilling;
    return {
        need<S>(&S::mill_diameter_mm, "mill_diameter_mm", "mm", closed(1, 2000), "diameter over the teeth D"),
        need<S>(&S::teeth, "teeth", "1", closed(1, 40), "number of teeth z"),
        need<S>(&S::width_mm, "width_mm", "mm", open_low(0, 2000), "width of cut, at most the diameter"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e6), "length of the plane along the feed"),
        need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(1e-4, 100), "depth of one pass a_p"),
        may<S>(&S::passes, "passes", "1", closed(1, 10'000), "number of passes"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e5),
                "cutting speed v_c"),
        need<S>(&S::feed_per_tooth_mm, "feed_per_tooth_mm", "mm", closed(1e-4, 10),
                "feed per tooth of the fresh mill f_z"),
        need<S>(&S::replace_at_failed_teeth, "replace_at_failed_teeth", "1", closed(1, 40),
                "failed teeth at which the mill is pulled, 1 to z"),
        may<S>(&S::sharing, "sharing", "-", no_range(), "who takes the chip of a failed tooth"),
        may<S>(&S::feed_after_failure, "feed_after_failure", "-", no_range(),
               "table feed once teeth have failed: kept, or reduced in proportion to the working teeth"),
        may<S>(&S::load_exponent, "load_exponent", "1", closed(0, 4),
               "exponent of the load in the wear rate, feed exponent of the tool life law"),
        may<S>(&S::parts_per_mission, "parts_per_mission", "1", closed(1, 1'000'000),
               "parts between two occasions to change the mill"),
        may<S>(&S::reliability_min, "reliability_min", "1", open(0, 1),
               "wanted probability that a fresh mill gets through the mission; economic range 0.82 to 0.95"),
        may<S>(&S::chip_per_tooth_max_mm, "chip_per_tooth_max_mm", "mm", closed(1e-4, 100),
               "thickest feed per tooth that an insert stands"),
        may<S>(&S::kc11_mpa, "kc11_mpa", "MPa", open_low(0, 1e5),
               "specific cutting force at 1 mm chip thickness"),
        may<S>(&S::mc, "mc", "1", closed(0, 0.9), "exponent of the specific cutting force")};
  }
};

namespace verstat::operations {

namespace k109 = models::k109;

namespace {

// Cv of the time to the m-th failure: the hazard clock of a stage is exponential, so for a load exponent of
// 1 the time is eta Gamma(m, 1/z)^(1/beta) exactly; other exponents shift the mean far more than the scatter.
double cv_of_mth_failure(std::int64_t m, double shape) {
  const double stages = static_cast<double>(m);
  const double to_first = boost::math::tgamma_delta_ratio(stages, 1 / shape, models::MathPolicy());
  const double to_second = boost::math::tgamma_delta_ratio(stages, 2 / shape, models::MathPolicy());
  return std::sqrt(std::max(to_first * to_first / to_second - 1, 1e-8));
}

struct Mill {
  double alpha;
  std::int64_t allowed;  // failures tolerated
  double thickest_chip_mm;
};

Mill mill_of(const FaceMilling& spec) {
  const bool kept = spec.feed_after_failure == FeedAfterFailure::keep;
  const std::int64_t allowed = spec.replace_at_failed_teeth - 1;
  const double z = static_cast<double>(spec.teeth);
  const double lost = static_cast<double>(allowed);
  const double growth = spec.sharing == LoadSharing::local ? 1 + lost : z / (z - lost);
  return {kept ? spec.load_exponent : 0, allowed, spec.feed_per_tooth_mm * (kept ? growth : 1)};
}

void add_cutting_load(CutPlan& p, const FaceMilling& spec, const PlanContext& context, double speed_rpm,
                      double feed_mm_min, double removal_cm3_min) {
  p.spindle.teeth = spec.teeth;
  MachineLoad load;
  load.spindle_speed_rpm = speed_rpm;
  load.feed_rate_mm_min = feed_mm_min;
  if (spec.kc11_mpa) {
    const double half_width = spec.width_mm / spec.mill_diameter_mm;
    const double mean_chip_mm = spec.feed_per_tooth_mm * half_width / std::asin(half_width);
    const double kc = kienzle_n_mm2(*spec.kc11_mpa, spec.mc, mean_chip_mm);
    p.spindle.specific_force_n_mm2 = kc;
    p.spindle.width_of_cut_mm = spec.depth_of_cut_mm;
    load.power_kw = kc * removal_cm3_min / 60'000;
    load.torque_nm = *load.power_kw * 30'000 / (std::numbers::pi * speed_rpm);
    p.quantities.push_back({"cutting_power_kw", *load.power_kw, "kW",
                            "COMPLETION: Kienzle at the mean chip thickness",
                            "mean cutting power, mill central to the plane"});
    p.quantities.push_back({"cutting_torque_nm", *load.torque_nm, "N m",
                            "COMPLETION: Kienzle at the mean chip thickness", "mean torque at the mill"});
  }
  add_machine_limits(p, context, load);
}

// Life of one tooth at the load of the fresh mill; other laws are taken as the Weibull law of the same cv.
struct ToothLaw {
  ElementLife life;
  double shape = 1;
};

ToothLaw tooth_law(const FaceMilling& spec, const EdgeLife& edge) {
  const ElementLife life =
      taylor_life(edge, spec.cutting_speed_m_min, spec.feed_per_tooth_mm, spec.depth_of_cut_mm);
  return {life, life.law == models::LifeLawKind::exponential ? 1 : models::weibull_shape(life.cv)};
}

double mean_time_to_failure_min(const FaceMilling& spec, const Mill& mill, const ToothLaw& tooth,
                                std::int64_t n) {
  k109::NthFailure failure;
  failure.t_mean_min = tooth.life.mean_min;
  failure.beta = tooth.shape;
  failure.n = n;
  failure.teeth = spec.teeth;
  failure.alpha = mill.alpha;
  return k109::mean_time_to_nth_failure(failure).t_mean_min;
}

// With a table feed in proportion to the working teeth a part takes longer the more teeth have failed: the
// mean over the life of the mill, weighted by the work done in each state.
double slowdown_by_reduced_feed(const FaceMilling& spec, const Mill& mill, const ToothLaw& tooth) {
  const double z = static_cast<double>(spec.teeth);
  double before = 0;
  double work = 0;
  for (std::int64_t failed = 0; failed < spec.replace_at_failed_teeth; ++failed) {
    const double after = mean_time_to_failure_min(spec, mill, tooth, failed + 1);
    work += (after - before) * (z - static_cast<double>(failed)) / z;
    before = after;
  }
  return before / work;
}

void add_mill_life(CutPlan& p, const FaceMilling& spec, const Mill& mill, const ToothLaw& law) {
  const ElementLife& tooth = law.life;
  const double shape = law.shape;
  p.edge = ElementLife{.element = "edge",
                       .law = models::LifeLawKind::weibull,
                       .mean_min = mean_time_to_failure_min(spec, mill, law, spec.replace_at_failed_teeth),
                       .cv = cv_of_mth_failure(spec.replace_at_failed_teeth, shape),
                       .origin = "K109.mean_time_to_nth_failure"};
  p.quantities.push_back({"tooth_life_min", tooth.mean_min, "min", tooth.origin,
                          "mean life of one tooth at the load of the fresh mill"});
  p.quantities.push_back({"mill_life_min", p.edge->mean_min, "min", p.edge->origin,
                          "mean cutting time to the change; equal sharing, an upper bound for local"});

  k109::ToothAtTime mission;
  mission.t_mean_min = tooth.mean_min;
  mission.beta = shape;
  mission.t_min = p.main_time_min * static_cast<double>(spec.parts_per_mission);
  // A mission far beyond the life: no tooth survives, and the models still want a positive probability.
  const double r_tooth = std::max(k109::tooth_reliability(mission).r_tooth, 1e-300);

  k109::MillSharing sharing;
  sharing.r_tooth = r_tooth;
  sharing.teeth = spec.teeth;
  sharing.alpha = mill.alpha;
  sharing.failed_allowed = mill.allowed;
  const bool local = spec.sharing == LoadSharing::local;
  const double r_mill = local ? k109::mill_reliability_local_sharing(sharing).r_mill
                              : k109::mill_reliability_load_sharing(sharing).r_mill;
  const char* origin = local ? "K109.mill_reliability_local_sharing" : "K109.mill_reliability_load_sharing";
  p.quantities.push_back({"mission_min", mission.t_min, "min", "definition", "cutting time of the mission"});
  p.quantities.push_back({"tooth_reliability", r_tooth, "1", "K109.tooth_reliability",
                          "probability that a tooth survives the mission at the load of the fresh mill"});
  p.quantities.push_back({"mill_reliability", r_mill, "1", origin,
                          "probability that a fresh mill gets through the mission without a change"});
  k109::Load worst;
  worst.teeth = spec.teeth;
  worst.failed = mill.allowed;
  worst.alpha = mill.alpha;
  p.quantities.push_back({"load_factor", k109::load_factor(worst).factor, "1", "K109.load_factor",
                          "wear rate of a survivor just before the change, equal sharing"});

  if (!spec.reliability_min) return;
  p.limits.push_back({"mill_reliability", r_mill, *spec.reliability_min, false, "1", origin});
  if (r_tooth >= 1) return;
  k109::MissionTarget target;
  target.r_tooth = r_tooth;
  target.teeth = spec.teeth;
  target.alpha = mill.alpha;
  target.r_mill_target = *spec.reliability_min;
  p.quantities.push_back(
      {"required_replace_at", static_cast<double>(k109::required_failed_allowed(target).replace_at_failed),
       "1", "K109.required_failed_allowed",
       "failed teeth at which the mill may be pulled at the earliest to meet the wanted reliability"});
}

}  // namespace

CutPlan plan(const FaceMilling& spec, const PlanContext& context) {
  models::require(spec.replace_at_failed_teeth <= spec.teeth, "replace_at_failed_teeth",
                  spec.replace_at_failed_teeth, "must not exceed the number of teeth");
  models::require(spec.width_mm <= spec.mill_diameter_mm, "width_mm", spec.width_mm,
                  "must not exceed the diameter of the mill");
  models::require(spec.sharing == LoadSharing::global || spec.teeth <= 16, "teeth", spec.teeth,
                  "at most 16 with local sharing");
  const Mill mill = mill_of(spec);

  const double speed_rpm = k109::spindle_speed({spec.cutting_speed_m_min, spec.mill_diameter_mm}).speed_rpm;
  const double feed_mm_min = k109::table_feed({spec.feed_per_tooth_mm, spec.teeth, speed_rpm}).feed_mm_min;
  const double removal_cm3_min =
      k109::material_removal_rate({spec.width_mm, spec.depth_of_cut_mm, feed_mm_min}).rate_cm3_min;
  // The mill travels until its full width has come in, half a diameter less half a chord beyond the edge.
  const double run_in_mm = (spec.mill_diameter_mm - std::sqrt(spec.mill_diameter_mm * spec.mill_diameter_mm -
                                                              spec.width_mm * spec.width_mm)) /
                           2;

  const bool wears = context.edge != nullptr;
  const ToothLaw tooth = wears ? tooth_law(spec, *context.edge) : ToothLaw{};
  const double slowdown = wears && spec.feed_after_failure == FeedAfterFailure::reduce
                              ? slowdown_by_reduced_feed(spec, mill, tooth)
                              : 1;

  CutPlan p;
  p.quantities.reserve(16);
  p.set_main_time(slowdown * static_cast<double>(spec.passes) * (spec.length_mm + run_in_mm) / feed_mm_min,
                  "K109.table_feed");
  p.quantities.push_back({"slowdown", slowdown, "1", "COMPLETION: mean over the states of the mill",
                          "mean main time over that of a fresh mill"});
  p.quantities.push_back({"spindle_speed_rpm", speed_rpm, "rpm", "K109.spindle_speed", "spindle speed"});
  p.quantities.push_back({"table_feed_mm_min", feed_mm_min, "mm/min", "K109.table_feed", "table feed"});
  p.quantities.push_back({"removal_rate_cm3_min", removal_cm3_min, "cm3/min", "K109.material_removal_rate",
                          "metal removal rate"});
  p.quantities.push_back({"thickest_chip_per_tooth_mm", mill.thickest_chip_mm, "mm",
                          "COMPLETION: chip of the failed teeth shared out",
                          "feed per tooth of the hardest loaded survivor just before the change"});
  if (spec.chip_per_tooth_max_mm)
    p.limits.push_back({"chip_per_tooth_mm", mill.thickest_chip_mm, *spec.chip_per_tooth_max_mm, true, "mm",
                        "COMPLETION: chip of the failed teeth shared out"});
  add_cutting_load(p, spec, context, speed_rpm, feed_mm_min, removal_cm3_min);
  if (wears) add_mill_life(p, spec, mill, tooth);
  return p;
}

namespace face_milling {
void add_to(Kinds& kinds) {
  kinds.add<FaceMilling>("A plane milled with indexable teeth; the mill is pulled at m failed teeth.",
                         {"K109"});
}
}  // namespace face_milling

}  // namespace verstat::operations
