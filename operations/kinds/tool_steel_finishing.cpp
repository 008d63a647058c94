#include "operations/kinds/tool_steel_finishing.h"

#include <cmath>
#include <numbers>

#include "models/reliability/k117_rational_reliability.h"
#include "models/surface/k116_tool_steel_surface.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::ToolSteelFinishing> {
  static std::vector<Field> fields() {
    using S = operations::ToolSteelFinishing;
    return {need<S>(&S::finish, "finish", "-", no_range(), "how the surface is finished"),
            need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 5000), "diameter of the part"),
            need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "length of the surface"),
            need<S>(&S::surface_speed_m_min, "surface_speed_m_min", "m/min", open_low(0, 1000),
                    "speed of the part: cutting speed in turning, work speed in grinding"),
            need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", open_low(0, 100),
                    "longitudinal feed per revolution"),
            may<S>(&S::passes, "passes", "1", closed(1, 10'000), "passes over the surface"),
            may<S>(&S::working_stress_mpa, "working_stress_mpa", "MPa", closed(500, 1000),
                   "stress amplitude in service, rotating bending"),
            may<S>(&S::fatigue_limit_min_mpa, "fatigue_limit_min_mpa", "MPa", open_low(0, 5000),
                   "fatigue limit that the part needs at 1e7 cycles"),
            may<S>(&S::tempered_depth_max_um, "tempered_depth_max_um", "um", closed(0, 1000),
                   "deepest tempered zone allowed"),
            may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2),
                   "scatter of the lives of a lot of tools finished so"),
            may<S>(&S::breakage_fraction, "breakage_fraction", "1", probability(),
                   "share of those lives that end by breakage"),
            may<S>(&S::cost_per_tool, "cost_per_tool", "money", closed(0, 1e9),
                   "of finishing a tool of the lot")};
  }
};

namespace verstat::operations {

namespace {

namespace k116 = models::k116;
using Curve = k116::FatigueFinish;

/// Fatigue curve of the finish; curves of turning exist at 50, 100 and 200 m/min: the nearest in ratio.
std::optional<Curve> curve_of(const ToolSteelFinishing& spec) {
  switch (spec.finish) {
    case SteelFinish::grinding_abrasive:
      return Curve::grinding_abrasive;
    case SteelFinish::grinding_boron_nitride:
      return std::nullopt;
    case SteelFinish::turning_boron_nitride:
      if (spec.surface_speed_m_min < 50 * std::numbers::sqrt2) return Curve::turning_geksanit_r_50;
      if (spec.surface_speed_m_min < 100 * std::numbers::sqrt2) return Curve::turning_geksanit_r_100;
      return Curve::turning_geksanit_r_200;
  }
  return std::nullopt;
}

void fatigue(const ToolSteelFinishing& spec, CutPlan& p) {
  const auto curve = curve_of(spec);
  models::require(curve || !spec.fatigue_limit_min_mpa, "fatigue_limit_min_mpa",
                  spec.fatigue_limit_min_mpa.value_or(0), "is not known of grinding with boron nitride");
  if (!curve) return;
  const bool turned = spec.finish == SteelFinish::turning_boron_nitride;
  const double ground_mpa = k116::fatigue_limit({Curve::grinding_abrasive, 1e7}).limit_mpa;
  const double limit_mpa =
      turned ? k116::turned_fatigue_limit_vs_speed({spec.surface_speed_m_min}).limit_mpa : ground_mpa;
  const char* origin = turned ? "K116.turned_fatigue_limit_vs_speed" : "K116.fatigue_limit";
  p.quantities.push_back({"fatigue_limit_mpa", limit_mpa, "MPa", origin, "fatigue limit at 1e7 cycles"});
  p.leave("fatigue_limit_mpa");
  p.quantities.push_back({"fatigue_limit_factor", limit_mpa / ground_mpa, "1", origin,
                          "fatigue limit over that of abrasive grinding"});
  if (spec.fatigue_limit_min_mpa)
    p.limits.push_back({"fatigue_limit_mpa", limit_mpa, *spec.fatigue_limit_min_mpa, false, "MPa", origin});
  if (!spec.working_stress_mpa) return;
  const double cycles = k116::fatigue_life_cycles({*curve, *spec.working_stress_mpa}).cycles;
  const double ground =
      k116::fatigue_life_cycles({Curve::grinding_abrasive, *spec.working_stress_mpa}).cycles;
  p.quantities.push_back({"service_life_cycles", cycles, "1", "K116.fatigue_life_cycles",
                          "mean life at the working stress, curve of the nearest speed"});
  p.quantities.push_back({"service_life_factor", cycles / ground, "1", "K116.fatigue_life_cycles",
                          "this life over that of an abrasively ground part"});
  p.leave("service_life_cycles");
  // Dies and cutters of tool steel that fail by fatigue: delivered, they are ground with an abrasive wheel.
  p.lot = PreparedLot{.law = models::LifeLawKind::weibull,
                      .life_factor = cycles / ground,
                      .cv = spec.life_cv,
                      .breakage_fraction = spec.breakage_fraction,
                      .added_cost_per_insert = spec.cost_per_tool,
                      .origin = "K116.fatigue_life_cycles; COMPLETION: the scatter is given"};
}

void layer(const ToolSteelFinishing& spec, CutPlan& p) {
  const bool turned = spec.finish == SteelFinish::turning_boron_nitride;
  const bool abrasive = spec.finish == SteelFinish::grinding_abrasive;
  const double austenite =
      turned
          ? k116::austenite_after_turning({spec.surface_speed_m_min}).percent
          : k116::austenite_after_grinding({abrasive ? k116::Wheel::abrasive : k116::Wheel::geksanit_a, 10})
                .percent;
  p.quantities.push_back({"retained_austenite_percent", austenite, "%",
                          turned ? "K116.austenite_after_turning" : "K116.austenite_after_grinding",
                          "retained austenite near the surface"});
  const auto zone = k116::tempered_zone_depth({turned     ? k116::LayerFinish::geksanit_r_turning
                                               : abrasive ? k116::LayerFinish::abrasive_wheel
                                                          : k116::LayerFinish::geksanit_a_wheel});
  p.quantities.push_back({"tempered_depth_um", zone.to_um, "um", "K116.tempered_zone_depth",
                          "deepest reach of the tempered zone"});
  p.leave("retained_austenite_percent");
  p.leave("tempered_depth_um");
  if (spec.tempered_depth_max_um)
    p.limits.push_back({"tempered_depth_um", zone.to_um, *spec.tempered_depth_max_um, true, "um",
                        "K116.tempered_zone_depth"});
}

}  // namespace

CutPlan plan(const ToolSteelFinishing& spec, const PlanContext& context) {
  models::k117::TurningPass pass;
  pass.diameter_mm = spec.diameter_mm;
  pass.length_mm = spec.length_mm;
  pass.passes = static_cast<double>(spec.passes);
  pass.speed_m_min = spec.surface_speed_m_min;
  pass.feed_mm_rev = spec.feed_mm_rev;
  CutPlan p;
  p.set_main_time(models::k117::machining_time_turning(pass).time_min, "K117.machining_time_turning");
  fatigue(spec, p);
  layer(spec, p);
  const double rpm = 1000 * spec.surface_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  if (spec.finish == SteelFinish::turning_boron_nitride) {
    limit_spindle_speed(p, context, rpm, "definition");
    // The paper turned at a depth of 0.25 mm throughout.
    if (context.edge != nullptr)
      p.edge = taylor_life(*context.edge, spec.surface_speed_m_min, spec.feed_mm_rev, 0.25);
  }
  limit_feed_rate(p, context, rpm * spec.feed_mm_rev, "definition");
  return p;
}

namespace tool_steel_finishing {
void add_to(Kinds& kinds) {
  kinds.add<ToolSteelFinishing>("Hardened tool steel ground or hard-turned: what the surface is worth.",
                                {"K116", "K117"});
}
}  // namespace tool_steel_finishing

}  // namespace verstat::operations
