#include "operations/kinds/reaming.h"

#include "models/dynamics/k408_stepped_axial_tool.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/spindle.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::Reaming> {
  static std::vector<Field> fields() {
    using S = operations::Reaming;
    return {
        need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 1000), "diameter of the hole"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "length of the hole"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1e4), "approach"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1e4), "overrun"),
        may<S>(&S::allowance_mm, "allowance_mm", "mm", open_low(0, 10), "allowance on the diameter"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", open_low(0, 1000), "cutting speed"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", open_low(0, 100), "feed"),
        may<S>(&S::teeth, "teeth", "1", closed(1, 100), "teeth of the tool"),
        entries(need<S>(&S::segment_length_mm, "segment_length_mm", "mm", open_low(0, 1e4),
                        "segments of the tool, holder end first"),
                1, 20),
        entries(need<S>(&S::segment_outer_mm, "segment_outer_mm", "mm", open_low(0, 1e3),
                        "their outer diameters"),
                1, 20),
        entries(may<S>(&S::segment_inner_mm, "segment_inner_mm", "mm", closed(0, 1e3), "their bores"), 0, 20),
        entries(may<S>(&S::inertia_factor, "inertia_factor", "1", open_low(0, 1),
                       "inertia of fluted segments over that of the ring"),
                0, 20),
        entries(may<S>(&S::area_factor, "area_factor", "1", open_low(0, 1), "area likewise"), 0, 20),
        may<S>(&S::tip, "tip", "-", no_range(), "how the hole holds the tip"),
        may<S>(&S::modulus_gpa, "modulus_gpa", "GPa", open_low(0, 1000), "modulus of elasticity"),
        may<S>(&S::density_kg_m3, "density_kg_m3", "kg/m3", open_low(0, 25'000), "density"),
        may<S>(&S::margin, "margin", "1", open_high(0, 1),
               "how far the tooth frequency stays below the first natural one"),
        may<S>(&S::torque_nm, "torque_nm", "N m", open_low(0, 1e6), "cutting torque")};
  }
};

namespace verstat::operations {

namespace k408 = models::k408;

namespace {

/// Scheme of K408: holder rigid 1, 2, rocking 3, 4, floating 5, 6; tip pinned odd, clamped even.
std::int64_t scheme_of(ToolHolder holder, ToolTip tip) {
  const std::int64_t pinned = holder == ToolHolder::rigid ? 1 : holder == ToolHolder::rocking ? 3 : 5;
  return tip == ToolTip::pinned ? pinned : pinned + 1;
}

}  // namespace

CutPlan plan(const Reaming& spec, const PlanContext& context) {
  const ToolHolder holder = context.spindle != nullptr ? context.spindle->holder : ToolHolder::rigid;
  k408::ToolSpectrum tool;
  tool.scheme = scheme_of(holder, spec.tip);
  tool.length_mm = spec.segment_length_mm;
  tool.outer_mm = spec.segment_outer_mm;
  tool.inner_mm = spec.segment_inner_mm;
  tool.j_factor = spec.inertia_factor;
  tool.a_factor = spec.area_factor;
  tool.modulus_gpa = spec.modulus_gpa;
  tool.density_kg_m3 = spec.density_kg_m3;
  tool.count = 1;
  const double first_hz = k408::axial_tool_frequencies(tool).frequency_hz.at(0);
  const auto speed_limit = k408::reaming_speed_limit({.frequency_hz = first_hz,
                                                      .teeth = spec.teeth,
                                                      .diameter_mm = spec.diameter_mm,
                                                      .margin = spec.margin});
  const auto time = k408::reaming_main_time({.length_mm = spec.length_mm,
                                             .approach_mm = spec.approach_mm,
                                             .overrun_mm = spec.overrun_mm,
                                             .speed_m_min = spec.cutting_speed_m_min,
                                             .diameter_mm = spec.diameter_mm,
                                             .feed_mm_rev = spec.feed_mm_rev});
  CutPlan p;
  p.set_main_time(time.main_time_min, "K408.reaming_main_time");
  auto& q = p.quantities;
  q.push_back({"spindle_speed_rpm", time.spindle_rpm, "rpm", "K408.reaming_main_time", "spindle speed"});
  q.push_back({"natural_frequency_hz", first_hz, "Hz", "K408.axial_tool_frequencies",
               "first natural frequency of the tool in this holder"});
  q.push_back({"tooth_frequency_hz", time.spindle_rpm * static_cast<double>(spec.teeth) / 60, "Hz",
               "definition", "teeth that pass in a second"});
  q.push_back({"speed_limit_m_min", speed_limit.speed_m_min, "m/min", "K408.reaming_speed_limit",
               "cutting speed that stays below resonance"});
  p.limits.push_back({"cutting_speed_m_min", spec.cutting_speed_m_min, speed_limit.speed_m_min, true, "m/min",
                      "K408.reaming_speed_limit"});
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.allowance_mm / 2);
  p.spindle.teeth = spec.teeth;
  limit_spindle_speed(p, context, time.spindle_rpm, "K408.reaming_main_time");
  limit_feed_rate(p, context, time.spindle_rpm * spec.feed_mm_rev, "definition");
  if (spec.torque_nm) limit_torque(p, context, *spec.torque_nm, "given");
  return p;
}

namespace reaming {
void add_to(Kinds& kinds) {
  kinds.add<Reaming>("A hole reamed with an elastic tool that must not resonate.", {"K408"});
}
}  // namespace reaming

}  // namespace verstat::operations
