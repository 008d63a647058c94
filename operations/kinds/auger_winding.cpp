#include "operations/kinds/auger_winding.h"

#include <cmath>
#include <numbers>

#include "models/treatment/k306_auger_winding.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::AugerWinding> {
  static std::vector<Field> fields() {
    using S = operations::AugerWinding;
    return {
        need<S>(&S::outer_diameter_mm, "outer_diameter_mm", "mm", open_low(0, 5000), "of the screw"),
        need<S>(&S::inner_diameter_mm, "inner_diameter_mm", "mm", open_low(0, 5000), "of the screw"),
        need<S>(&S::pitch_mm, "pitch_mm", "mm", open_low(0, 5000), "of the screw"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "of the screw"),
        need<S>(&S::inner_thickness_mm, "inner_thickness_mm", "mm", open_low(0, 100),
                "thickness that the inner edge must keep"),
        may<S>(&S::force_radius_factor, "force_radius_factor", "1", open_low(1, 100),
               "radius at which the longitudinal force acts over the outer radius of the coil"),
        may<S>(&S::trim_widths, "trim_widths", "1", closed(0, 20), "ends cut off, in strip widths"),
        need<S>(&S::spindle_speed_rpm, "spindle_speed_rpm", "rpm", open_low(0, 1000), "speed of the mandrel"),
        may<S>(&S::turns_per_winding, "turns_per_winding", "1", closed(1, 1000),
               "turns that one load of the mandrel takes"),
        may<S>(&S::setup_min, "setup_min", "min", closed(0, 1e4), "set-up of every winding"),
        need<S>(&S::flow_stress_mpa, "flow_stress_mpa", "MPa", open_low(0, 5000), "flow stress of the strip"),
        may<S>(&S::friction, "friction", "1", open_low(0, 1), "friction of strip and clamp"),
        may<S>(&S::clamp_turns, "clamp_turns", "1", closed(0, 100), "turns held by the spring clamp"),
        may<S>(&S::clamp_factor, "clamp_factor", "1", open_low(0, 10), "k1 of the clamp, usually 0.5 to 0.7"),
        may<S>(&S::strip_thickness_mm, "strip_thickness_mm", "mm", open_low(0, 100),
               "strip at hand; not given: the one that is needed"),
        may<S>(&S::mandrel_length_mm, "mandrel_length_mm", "mm", open_low(0, 1e5),
               "length of the mandrel for the tight coil"),
        may<S>(&S::winding_force_max_n, "winding_force_max_n", "N", open_low(0, 1e8),
               "largest longitudinal force")};
  }
};

namespace verstat::operations {

namespace k306 = models::k306;

CutPlan plan(const AugerWinding& spec, const PlanContext& context) {
  const auto blank = k306::auger_blank_plan({.outer_diameter_mm = spec.outer_diameter_mm,
                                             .inner_diameter_mm = spec.inner_diameter_mm,
                                             .pitch_mm = spec.pitch_mm,
                                             .length_mm = spec.length_mm,
                                             .inner_thickness_mm = spec.inner_thickness_mm,
                                             .force_radius_factor = spec.force_radius_factor,
                                             .trim = spec.trim_widths});
  const double thickness_mm = spec.strip_thickness_mm.value_or(blank.thickness_mm);
  const double inner_mm = blank.mandrel_diameter_mm / 2;
  const double outer_mm = inner_mm + blank.strip_width_mm;
  // What the tight coil makes of the strip at hand: thickness goes inversely with the root of the radius.
  const double left_mm = thickness_mm * std::sqrt(blank.neutral_radius_mm / inner_mm);
  const double outer_left_mm = thickness_mm * std::sqrt(blank.neutral_radius_mm / outer_mm);
  const double force_n = std::abs(k306::longitudinal_force({.flow_stress_mpa = spec.flow_stress_mpa,
                                                            .thickness_mm = thickness_mm,
                                                            .outer_radius_mm = outer_mm,
                                                            .inner_radius_mm = inner_mm,
                                                            .neutral_radius_mm = blank.neutral_radius_mm})
                                      .force_n);
  const auto winding = k306::winding_time({.strip_length_mm = blank.net_mm,
                                           .neutral_radius_mm = blank.neutral_radius_mm,
                                           .spindle_rpm = spec.spindle_speed_rpm,
                                           .turns_per_winding = spec.turns_per_winding,
                                           .setup_min = spec.setup_min});
  k306::SpringClamp clamp;
  clamp.k1 = spec.clamp_factor;
  clamp.friction = spec.friction;
  clamp.turns = spec.clamp_turns;
  clamp.deformation_radius_mm = blank.neutral_radius_mm;
  clamp.mandrel_radius_mm = inner_mm;
  clamp.force_n = force_n;
  const double clamp_n = k306::spring_clamp_force(clamp).force_n;
  const auto step = k306::mandrel_step_range({spec.outer_diameter_mm});
  const auto groove = k306::groove_dimensions({thickness_mm});
  const double torque_nm = force_n * blank.neutral_radius_mm / 1000;
  const double power_kw = torque_nm * spec.spindle_speed_rpm * std::numbers::pi / 30'000;

  CutPlan p;
  p.quantities.reserve(20);
  p.set_main_time(winding.time_min, "K306.winding_time");
  auto& q = p.quantities;
  constexpr const char* chain = "K306.auger_blank_plan";
  constexpr const char* bending = "K306.longitudinal_force";
  q.push_back({"turns", winding.turns, "1", "K306.winding_time", "turns of the tight coil"});
  q.push_back(
      {"windings", static_cast<double>(winding.windings), "1", "K306.winding_time", "loads of the mandrel"});
  q.push_back({"mandrel_diameter_mm", blank.mandrel_diameter_mm, "mm", chain,
               "gives the screw its inner diameter after stretching"});
  q.push_back({"mandrel_step_low_mm", step.min_mm, "mm", "K306.mandrel_step_range", "step of the mandrel"});
  q.push_back({"mandrel_step_high_mm", step.max_mm, "mm", "K306.mandrel_step_range", "the same, most"});
  q.push_back({"groove_width_mm", groove.width_max_mm, "mm", "K306.groove_dimensions",
               "slot that holds the strip, widest"});
  q.push_back({"strip_width_mm", blank.strip_width_mm, "mm", chain, "width of the strip"});
  q.push_back({"neutral_radius_mm", blank.neutral_radius_mm, "mm", chain, "neutral radius of the bending"});
  q.push_back({"strip_thickness_mm", blank.thickness_mm, "mm", chain,
               "strip that keeps the inner edge its thickness"});
  q.push_back({"inner_edge_mm", left_mm, "mm", "K306.blank_thickness", "inner edge of this strip"});
  q.push_back({"outer_edge_mm", outer_left_mm, "mm", "K306.blank_thickness", "outer edge of this strip"});
  q.push_back({"coil_length_mm", blank.stack_mm, "mm", "K306.coil_stack_length", "of the tight coil"});
  q.push_back({"winding_force_n", force_n, "N", bending, "longitudinal force, magnitude"});
  q.push_back({"clamp_force_n", clamp_n, "N", "K306.spring_clamp_force", "force of the spring clamp"});
  q.push_back({"torque_nm", torque_nm, "N m", "COMPLETION: force at the neutral radius", "at the mandrel"});
  q.push_back({"power_kw", power_kw, "kW", "COMPLETION: torque times speed", "winding power"});
  p.limits.push_back(
      {"inner_edge_mm", left_mm, spec.inner_thickness_mm * (1 - 1e-9), false, "mm", "K306.blank_thickness"});
  if (spec.mandrel_length_mm)
    p.limits.push_back(
        {"coil_length_mm", blank.stack_mm, *spec.mandrel_length_mm, true, "mm", "K306.coil_stack_length"});
  if (spec.winding_force_max_n)
    p.limits.push_back({"winding_force_n", force_n, *spec.winding_force_max_n, true, "N", bending});
  limit_power(p, context, power_kw, bending);
  limit_torque(p, context, torque_nm, bending);
  limit_spindle_speed(p, context, spec.spindle_speed_rpm, "given");
  p.consumables.push_back(
      {"strip_mm", blank.trimmed_mm, "mm", "K306.strip_length", "strip with the ends that are cut off"});
  p.consumables.push_back({"strip_waste_mm", blank.trimmed_mm - blank.net_mm, "mm", "K306.strip_length",
                           "strip that is cut off"});
  return p;
}

namespace auger_winding {
void add_to(Kinds& kinds) {
  kinds.add<AugerWinding>("A strip wound on edge into the flight of a screw.", {"K306"});
}
}  // namespace auger_winding

}  // namespace verstat::operations
