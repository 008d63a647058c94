#include "operations/kinds/cutting_off.h"

#include <numbers>

#include "models/grinding/k104_cutoff_wheel_sides.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::CuttingOff> {
  static std::vector<Field> fields() {
    using S = operations::CuttingOff;
    return {
        need<S>(&S::workpiece_diameter_mm, "workpiece_diameter_mm", "mm", closed(20, 120),
                "diameter of the bar or pipe"),
        may<S>(&S::wheel_diameter_mm, "wheel_diameter_mm", "mm", closed(300, 600), "diameter of the wheel"),
        may<S>(&S::wheel_thickness_mm, "wheel_thickness_mm", "mm", open_low(0, 50), "its thickness"),
        need<S>(&S::wheel_speed_m_s, "wheel_speed_m_s", "m/s", open_low(0, 200), "speed of the wheel"),
        need<S>(&S::radial_feed_mm_s, "radial_feed_mm_s", "mm/s", open_low(0, 100), "radial feed"),
        need<S>(&S::side_grains_per_mm2, "side_grains_per_mm2", "1/mm2", open_low(0, 100),
                "grains on the sides of the wheel"),
        may<S>(&S::grain_tip_radius_mm, "grain_tip_radius_mm", "mm", open_low(0, 1), "their tip radius"),
        may<S>(&S::chip_coefficient, "chip_coefficient", "1", open_low(0, 1),
               "share of the groove that becomes chip"),
        may<S>(&S::relative_depth_min, "relative_depth_min", "1", closed(0.01, 0.5),
               "depth over tip radius that the side grains must reach"),
        need<S>(&S::part_length_mm, "part_length_mm", "mm", open_low(0, 1e5), "length of the piece"),
        may<S>(&S::specific_energy_j_mm3, "specific_energy_j_mm3", "J/mm3", open_low(0, 1000),
               "specific energy of abrasive cutting: gives the power")};
  }
};

namespace verstat::operations {

namespace k104 = models::k104;

CutPlan plan(const CuttingOff& spec, const PlanContext& context) {
  const double layer_mm =
      k104::side_layer_thickness({spec.workpiece_diameter_mm, spec.wheel_diameter_mm}).layer_mm;
  const auto cut = k104::cutoff_time_and_kerf(
      {spec.workpiece_diameter_mm, spec.radial_feed_mm_s, spec.wheel_thickness_mm, layer_mm});
  const double depth = k104::relative_cut_depth({.grain_density_mm2 = spec.side_grains_per_mm2,
                                                 .layer_mm = layer_mm,
                                                 .radial_feed_mm_s = spec.radial_feed_mm_s,
                                                 .workpiece_diameter_mm = spec.workpiece_diameter_mm,
                                                 .grain_tip_radius_mm = spec.grain_tip_radius_mm,
                                                 .wheel_speed_m_s = spec.wheel_speed_m_s,
                                                 .chip_coefficient = spec.chip_coefficient})
                           .relative_depth;
  const double least_feed = k104::min_radial_feed({.grain_density_mm2 = spec.side_grains_per_mm2,
                                                   .layer_mm = layer_mm,
                                                   .workpiece_diameter_mm = spec.workpiece_diameter_mm,
                                                   .grain_tip_radius_mm = spec.grain_tip_radius_mm,
                                                   .relative_depth = spec.relative_depth_min,
                                                   .wheel_speed_m_s = spec.wheel_speed_m_s,
                                                   .chip_coefficient = spec.chip_coefficient})
                                .feed_mm_s;
  k104::SideGrains grains;
  grains.layer_mm = layer_mm;
  grains.radial_feed_mm_s = spec.radial_feed_mm_s;
  grains.workpiece_diameter_mm = spec.workpiece_diameter_mm;
  grains.grain_tip_radius_mm = spec.grain_tip_radius_mm;
  grains.relative_depth = spec.relative_depth_min;
  grains.wheel_speed_m_s = spec.wheel_speed_m_s;
  grains.chip_coefficient = spec.chip_coefficient;

  CutPlan p;
  p.quantities.reserve(10);
  p.set_main_time(cut.main_time_min, "K104.cutoff_time_and_kerf");
  auto& q = p.quantities;
  q.push_back({"side_layer_mm", layer_mm, "mm", "K104.side_layer_thickness",
               "layer that the wheel's sides take off the walls"});
  q.push_back({"kerf_mm", cut.kerf_width_mm, "mm", "K104.cutoff_time_and_kerf", "width of the kerf"});
  q.push_back({"relative_depth", depth, "1", "K104.relative_cut_depth",
               "depth of the side grains over their tip radius"});
  q.push_back({"side_grain_regime", static_cast<double>(k104::grain_cut_regime({depth}).regime), "1",
               "K104.grain_cut_regime", "0 plastic: burn, 1 transition, 2 cutting, 3 intensive"});
  q.push_back({"radial_feed_min_mm_s", least_feed, "mm/s", "K104.min_radial_feed",
               "feed below which the side grains rub"});
  q.push_back({"side_grains_max_per_mm2", k104::max_side_grain_density(grains).density_mm2, "1/mm2",
               "K104.max_side_grain_density", "most side grains that still cut at this feed"});
  p.limits.push_back({"radial_feed_mm_s", spec.radial_feed_mm_s, least_feed, false, "mm/s",
                      "K104.min_radial_feed: the kerf walls must not burn"});
  const double wheel_rpm = 60'000 * spec.wheel_speed_m_s / (std::numbers::pi * spec.wheel_diameter_mm);
  limit_spindle_speed(p, context, wheel_rpm, "definition");
  limit_feed_rate(p, context, 60 * spec.radial_feed_mm_s, "given");
  if (spec.specific_energy_j_mm3) {
    // The chord is longest in the middle of the cut: all of the diameter.
    const double power_kw = *spec.specific_energy_j_mm3 * spec.workpiece_diameter_mm * cut.kerf_width_mm *
                            spec.radial_feed_mm_s / 1000;
    constexpr const char* origin = "COMPLETION: specific energy times removal rate at full width";
    q.push_back({"power_kw", power_kw, "kW", origin, "power in the middle of a solid bar"});
    limit_power(p, context, power_kw, origin);
    limit_torque(p, context, power_kw * 30'000 / (std::numbers::pi * wheel_rpm), origin);
  }
  p.consumables.push_back({"bar_mm", spec.part_length_mm + cut.kerf_width_mm, "mm",
                           "K104.cutoff_time_and_kerf", "bar with the kerf"});
  return p;
}

namespace cutting_off {
void add_to(Kinds& kinds) {
  kinds.add<CuttingOff>("A bar parted with an abrasive wheel whose sides must not rub.", {"K104"});
}
}  // namespace cutting_off

}  // namespace verstat::operations
