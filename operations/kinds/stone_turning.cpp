#include "operations/kinds/stone_turning.h"

#include <algorithm>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"

namespace verstat::models {

using operations::StoneTurning;
using operations::StoneWheel;

std::vector<Field> StructFields<StoneWheel>::fields() {
  using S = StoneWheel;
  return {may<S>(&S::rim_width_mm, "rim_width_mm", "mm", open_low(0, 500), "width of the rim"),
          may<S>(&S::layer_depth_mm, "layer_depth_mm", "mm", open_low(0, 100), "depth of the diamond layer"),
          may<S>(&S::concentration_percent, "concentration_percent", "%", open_low(0, 200),
                 "concentration of diamond (paper 50 to 100)"),
          may<S>(&S::usable_fraction, "usable_fraction", "1", open_low(0, 1), "usable share of the layer"),
          need<S>(&S::grinding_ratio, "grinding_ratio", "mm3/mm3", open_low(0, 1e6),
                  "volume of stone removed by a volume of layer"),
          may<S>(&S::life_law, "life_law", "-", no_range(), "life law of the wheel"),
          may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2), "coefficient of variation of wheel life")};
}

template <>
struct StructFields<StoneTurning> {
  static std::vector<Field> fields() {
    using S = StoneTurning;
    return {
        need<S>(&S::group, "group", "1", closed(1, 5), "machinability group of the stone"),
        may<S>(&S::operation, "operation", "-", no_range(), "rough or finish"),
        need<S>(&S::lathe, "lathe", "-", no_range(), "the lathe"),
        may<S>(&S::feed_path, "feed_path", "-", no_range(), "along the part, or a plunge into it"),
        need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 2000), "diameter before the operation"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e4),
                "length of the surface; width of the form in a plunge"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "run-in and run-out"),
        need<S>(&S::allowance_per_side_mm, "allowance_per_side_mm", "mm", open_low(0, 500),
                "allowance per side"),
        may<S>(&S::depth_per_pass_mm, "depth_per_pass_mm", "mm", open_low(0, 100),
               "depth of a pass (paper: up to 5)"),
        need<S>(&S::spindle_speed_rpm, "spindle_speed_rpm", "rpm", open_low(0, 10'000), "work speed"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", open_low(0, 10),
                "longitudinal feed, or cross feed in a plunge"),
        may<S>(&S::sparkout_revs, "sparkout_revs", "1", closed(0, 1000), "revolutions of spark-out, plunge"),
        may<S>(&S::wheel_diameter_mm, "wheel_diameter_mm", "mm", open_low(0, 1000), "wheel diameter"),
        may<S>(&S::relative_speed_m_s, "relative_speed_m_s", "m/s", open_low(0, 100),
               "speed between wheel and stone (paper 5 to 15)"),
        may<S>(&S::motion, "motion", "-", no_range(), "how wheel and stone move at the contact"),
        may<S>(&S::wheel, "wheel", "-", no_range(), "diamond layer: adds consumption and wheel life")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k112 = models::k112;

constexpr const char* table_1 = "K112.machine_characteristics";
constexpr const char* table_3 = "K112.stone_turning_regime";

void window(CutPlan& p, const char* low_name, const char* high_name, double value, double low, double high,
            const char* unit, const char* origin) {
  p.limits.push_back({low_name, value, low, false, unit, origin});
  p.limits.push_back({high_name, value, high, true, unit, origin});
}

/// What the group asks for and what the lathe can do, each with its margin, and whether the two meet at all.
void eligibility(const StoneTurning& spec, CutPlan& p) {
  const auto regime = k112::stone_turning_regime({spec.group, spec.operation});
  const auto lathe = k112::machine_characteristics({spec.lathe});
  const auto fit = k112::stone_machine_fit({spec.lathe, spec.group, spec.operation, spec.diameter_mm});
  const bool plunge = spec.feed_path == StoneFeed::plunge;
  const double feasible = static_cast<double>(fit.feasible);
  constexpr const char* origin = "K112.stone_machine_fit";
  p.quantities.push_back({"lathe_eligible", feasible, "1", origin, "1: the lathe can run the group"});
  if (fit.rpm_low && fit.rpm_high) {
    p.quantities.push_back(
        {"spindle_speed_low_rpm", *fit.rpm_low, "rpm", origin, "lowest speed that group and lathe share"});
    p.quantities.push_back(
        {"spindle_speed_high_rpm", *fit.rpm_high, "rpm", origin, "highest speed that group and lathe share"});
  }
  if (fit.long_feed_low_mm_rev && fit.long_feed_high_mm_rev) {
    p.quantities.push_back({"long_feed_low_mm_rev", *fit.long_feed_low_mm_rev, "mm/rev", origin,
                            "smallest feed that group and lathe share"});
    p.quantities.push_back({"long_feed_high_mm_rev", *fit.long_feed_high_mm_rev, "mm/rev", origin,
                            "largest feed that group and lathe share"});
  }
  p.limits.push_back({"lathe_eligible", feasible, 1, false, "1", origin});
  p.limits.push_back({"lathe_swing_mm", spec.diameter_mm, lathe.swing_carriage_mm, true, "mm", table_1});
  window(p, "lathe_speed_min_rpm", "lathe_speed_max_rpm", spec.spindle_speed_rpm, lathe.rpm_min,
         lathe.rpm_max, "rpm", table_1);
  window(p, "group_speed_min_rpm", "group_speed_max_rpm", spec.spindle_speed_rpm, regime.rpm_min,
         regime.rpm_max, "rpm", table_3);
  window(p, "lathe_feed_min_mm_rev", "lathe_feed_max_mm_rev", spec.feed_mm_rev,
         plunge ? lathe.cross_feed_min_mm_rev : lathe.long_feed_min_mm_rev,
         plunge ? lathe.cross_feed_max_mm_rev : lathe.long_feed_max_mm_rev, "mm/rev", table_1);
  window(p, "group_feed_min_mm_rev", "group_feed_max_mm_rev", spec.feed_mm_rev,
         plunge ? regime.cross_feed_min_mm_rev : regime.long_feed_min_mm_rev,
         plunge ? regime.cross_feed_max_mm_rev : regime.long_feed_max_mm_rev, "mm/rev", table_3);
  window(p, "relative_speed_min_m_s", "relative_speed_max_m_s", spec.relative_speed_m_s, 5, 15, "m/s",
         "K112.stone_turning_kinematics");
}

/// Main time; also how deep a pass goes.
void passes(const StoneTurning& spec, CutPlan& p) {
  if (spec.feed_path == StoneFeed::plunge) {
    p.set_main_time(k112::stone_plunge_time({.allowance_per_side_mm = spec.allowance_per_side_mm,
                                             .cross_feed_mm_rev = spec.feed_mm_rev,
                                             .rpm = spec.spindle_speed_rpm,
                                             .sparkout_revs = spec.sparkout_revs})
                        .main_time_min,
                    "K112.stone_plunge_time");
    return;
  }
  const auto time = k112::stone_turning_time({.length_mm = spec.length_mm,
                                              .approach_mm = spec.approach_mm,
                                              .allowance_per_side_mm = spec.allowance_per_side_mm,
                                              .depth_per_pass_mm = spec.depth_per_pass_mm,
                                              .long_feed_mm_rev = spec.feed_mm_rev,
                                              .rpm = spec.spindle_speed_rpm});
  p.set_main_time(time.main_time_min, "K112.stone_turning_time");
  p.quantities.push_back(
      {"passes", static_cast<double>(time.passes), "1", "K112.stone_turning_time", "passes along the part"});
  const double depth_mm = std::min(spec.depth_per_pass_mm, spec.allowance_per_side_mm);
  p.quantities.push_back({"removal_rate_mm3_min",
                          k112::stone_removal_rate({.work_diameter_mm = spec.diameter_mm,
                                                    .depth_mm = depth_mm,
                                                    .long_feed_mm_rev = spec.feed_mm_rev,
                                                    .rpm = spec.spindle_speed_rpm})
                              .removal_rate_mm3_min,
                          "mm3/min", "K112.stone_removal_rate", "of the first pass"});
  p.limits.push_back({"depth_per_pass_mm", depth_mm, 5, true, "mm", "K112.stone_turning_time"});
}

void consumption(const StoneTurning& spec, CutPlan& p) {
  const StoneWheel& wheel = *spec.wheel;
  const double stone_mm3 = std::numbers::pi * (spec.diameter_mm - spec.allowance_per_side_mm) *
                           spec.allowance_per_side_mm * spec.length_mm;
  const auto life = k112::diamond_wheel_life({.wheel_diameter_mm = spec.wheel_diameter_mm,
                                              .rim_width_mm = wheel.rim_width_mm,
                                              .layer_depth_mm = wheel.layer_depth_mm,
                                              .concentration_percent = wheel.concentration_percent,
                                              .usable_fraction = wheel.usable_fraction,
                                              .grinding_ratio = wheel.grinding_ratio,
                                              .stone_volume_per_part_mm3 = stone_mm3});
  models::require(life.parts_per_wheel > 0, "wheel/grinding_ratio", wheel.grinding_ratio,
                  "must leave something to wear: ratio, concentration and usable share above 0");
  constexpr const char* origin = "K112.diamond_wheel_life";
  p.quantities.push_back({"stone_volume_mm3", stone_mm3, "mm3", "definition", "stone removed from a part"});
  p.quantities.push_back({"parts_per_wheel", life.parts_per_wheel, "1", origin, "parts that a wheel lasts"});
  p.edge = ElementLife{.element = "wheel",
                       .law = wheel.life_law,
                       .mean_min = life.parts_per_wheel * p.main_time_min,
                       .cv = wheel.life_cv,
                       .origin = "K112.diamond_wheel_life; law and cv COMPLETION"};
  p.consumables.push_back({"wheels", 1 / life.parts_per_wheel, "1", origin, "diamond wheels per part"});
  p.consumables.push_back({"diamond_carat", life.diamond_carat / life.parts_per_wheel, "carat", origin,
                           "diamond per part, with what stays in a spent wheel"});
}

}  // namespace

CutPlan plan(const StoneTurning& spec, const PlanContext& context) {
  models::require(spec.allowance_per_side_mm < spec.diameter_mm / 2, "allowance_per_side_mm",
                  spec.allowance_per_side_mm, "must be below half the diameter");
  CutPlan p;
  passes(spec, p);
  const auto speeds = k112::stone_turning_kinematics({.work_diameter_mm = spec.diameter_mm,
                                                      .rpm = spec.spindle_speed_rpm,
                                                      .wheel_diameter_mm = spec.wheel_diameter_mm,
                                                      .relative_speed_m_s = spec.relative_speed_m_s,
                                                      .conventional = spec.motion == StoneMotion::opposed});
  constexpr const char* origin = "K112.stone_turning_kinematics";
  p.quantities.push_back(
      {"work_speed_m_min", speeds.work_speed_m_min, "m/min", origin, "peripheral speed of the stone"});
  p.quantities.push_back({"wheel_speed_m_s", speeds.wheel_speed_m_s, "m/s", origin, "of the wheel"});
  p.quantities.push_back({"wheel_speed_rpm", speeds.wheel_rpm, "rpm", origin, "of the wheel"});
  eligibility(spec, p);
  if (spec.wheel) consumption(spec, p);
  limit_spindle_speed(p, context, spec.spindle_speed_rpm, "given");
  limit_feed_rate(p, context, spec.spindle_speed_rpm * spec.feed_mm_rev, "definition");
  return p;
}

namespace stone_turning {
void add_to(Kinds& kinds) {
  kinds.add<StoneTurning>("A body of revolution of natural stone turned with a driven diamond wheel.",
                          {"K112"});
}
}  // namespace stone_turning

}  // namespace verstat::operations
