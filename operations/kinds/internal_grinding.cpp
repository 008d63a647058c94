#include "operations/kinds/internal_grinding.h"

#include <numbers>

#include "models/grinding/k303_cutting_surface_height.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::InternalGrinding> {
  static std::vector<Field> fields() {
    using S = operations::InternalGrinding;
    std::vector<Field> all{
        need<S>(&S::bore_diameter_mm, "bore_diameter_mm", "mm", closed(0.5, 5000), "diameter of the bore"),
        need<S>(&S::length_mm, "length_mm", "mm", closed(0.1, 1000), "length of the bore"),
        need<S>(&S::allowance_um, "allowance_um", "um", open_low(0, 1e4), "stock on the radius"),
        need<S>(&S::work_speed_m_min, "work_speed_m_min", "m/min", closed(0.01, 1000),
                "surface speed of the bore"),
        need<S>(&S::depth_um, "depth_um", "um", closed(0.01, 100), "depth of cut per revolution"),
        may<S>(&S::sparkout_revolutions, "sparkout_revolutions", "1", closed(0, 10'000),
               "revolutions without infeed"),
        need<S>(&S::wheel_diameter_mm, "wheel_diameter_mm", "mm", closed(0.1, 5000),
                "wheel diameter, below that of the bore"),
        need<S>(&S::wheel_width_mm, "wheel_width_mm", "mm", closed(0.1, 1000), "wheel width"),
        need<S>(&S::wheel_speed_m_s, "wheel_speed_m_s", "m/s", closed(1, 500), "wheel speed"),
        may<S>(&S::grain_spacing_mm, "grain_spacing_mm", "mm", closed(0.001, 10),
               "mean distance of grains on the wheel face (default: diamond 100/80)"),
        may<S>(&S::tip_radius_um, "tip_radius_um", "um", closed(0.1, 1000), "tip radius of the grains"),
        may<S>(&S::tip_angle_deg, "tip_angle_deg", "deg", open(0, 180), "tip angle of the grains"),
        may<S>(&S::weibull_x0_um_m, "weibull_x0_um_m", "um^m", open_low(0, 1e9),
               "parameter X_0 of the grain heights"),
        may<S>(&S::weibull_m, "weibull_m", "1", closed(0.1, 10), "exponent m of the grain heights"),
        may<S>(&S::interval_um, "interval_um", "um", closed(0.01, 10), "interval of the count along the arc"),
        may<S>(&S::coverage, "coverage", "1", open(0, 1), "coverage that counts as a closed surface"),
        may<S>(&S::specific_energy_j_mm3, "specific_energy_j_mm3", "J/mm3", closed(0.1, 1000),
               "energy per removed volume; needed for the power"),
        may<S>(&S::grinding_ratio, "grinding_ratio", "1", open_low(0, 1e6),
               "removed volume per worn wheel volume"),
        may<S>(&S::residual_height_max_um, "residual_height_max_um", "um", open_low(0, 1000),
               "largest height left behind the arc")};
    operations::append_grain_protrusion<S>(all);
    return all;
  }
};

namespace verstat::operations {

CutPlan plan(const InternalGrinding& s, const PlanContext& context) {
  models::require(s.length_mm <= s.wheel_width_mm, "wheel_width_mm", s.wheel_width_mm,
                  "must cover length_mm in plunge grinding");
  const double pi = std::numbers::pi;
  const double cutting_revolutions = steps_in(s.allowance_um, s.depth_um);
  const double part_rpm = 1000 * s.work_speed_m_min / (pi * s.bore_diameter_mm);

  CutPlan p;
  p.quantities.reserve(16);
  p.set_main_time((cutting_revolutions + static_cast<double>(s.sparkout_revolutions)) / part_rpm,
                  "COMPLETION: revolutions over part speed");

  models::k303::CuttingRegime regime;
  regime.wheel_radius_mm = s.wheel_diameter_mm / 2;
  regime.work_radius_mm = s.bore_diameter_mm / 2;
  regime.kind = models::k303::GrindingKind::internal;
  regime.wheel_speed_m_s = s.wheel_speed_m_s;
  regime.grain_spacing_mm = s.grain_spacing_mm;
  regime.tip_radius_um = s.tip_radius_um;
  regime.tip_angle_deg = s.tip_angle_deg;
  regime.weibull_x0_um_m = s.weibull_x0_um_m;
  regime.weibull_m = s.weibull_m;
  regime.interval_um = s.interval_um;
  regime.coverage = s.coverage;
  regime.work_speed_m_min = s.work_speed_m_min;
  regime.depth_mm = s.depth_um / 1000;
  const auto height = models::k303::residual_height(regime);
  const double removal_mm3_mm_min =
      models::k303::specific_removal_rate({s.work_speed_m_min, s.depth_um / 1000}).q_mm3_mm_min;
  const double wheel_rpm = 60'000 * s.wheel_speed_m_s / (pi * s.wheel_diameter_mm);

  auto& q = p.quantities;
  q.push_back({"revolutions", cutting_revolutions, "1", "definition", "revolutions that remove stock"});
  q.push_back({"part_speed_rpm", part_rpm, "rpm", "definition", "speed of the part"});
  q.push_back({"wheel_speed_rpm", wheel_rpm, "rpm", "definition", "speed of the wheel"});
  q.push_back({"cutting_surface_rmax_um", height.rmax_um, "um", "K303.cutting_surface_roughness",
               "largest height of irregularities inside the arc: the wheel sinks in as deep"});
  q.push_back({"residual_height_um", height.final_height_um, "um", "K303.residual_height",
               "height left at the end of the arc"});
  q.push_back({"arc_length_mm", height.arc_length_mm, "mm", "K303.residual_height", "contact arc"});
  q.push_back({"specific_removal_mm3_mm_min", removal_mm3_mm_min, "mm3/(mm min)",
               "K303.specific_removal_rate", "removal rate per mm of width"});
  std::optional<double> power_kw;
  if (s.specific_energy_j_mm3) {
    power_kw = *s.specific_energy_j_mm3 * removal_mm3_mm_min * s.length_mm / 60'000;
    q.push_back(
        {"power_kw", *power_kw, "kW", "COMPLETION: specific energy times removal rate", "grinding power"});
  }

  p.limits.reserve(6);
  p.limits.push_back({"grain_protrusion_um", height.rmax_um, s.grain_protrusion_um, true, "um",
                      "K303.cutting_surface_roughness: the bond must not rub"});
  if (s.residual_height_max_um)
    p.limits.push_back({"residual_height_um", height.final_height_um, *s.residual_height_max_um, true, "um",
                        "K303.residual_height"});
  add_machine_limits(p, context,
                     WheelLoad{.wheel_rpm = wheel_rpm,
                               .diameter_mm = s.wheel_diameter_mm * s.bore_diameter_mm /
                                              (s.bore_diameter_mm - s.wheel_diameter_mm),
                               .work_speed_m_min = s.work_speed_m_min,
                               .infeed_mm = s.depth_um / 1000,
                               .feed_rate_mm_min = s.depth_um / 1000 * part_rpm,
                               .power_kw = power_kw});

  p.more_elements.push_back(dressing_life(s, height.rmax_um, p.main_time_min));
  if (s.grinding_ratio) {
    const double stock_mm = s.allowance_um / 1000;
    const double removed_mm3 = pi * (s.bore_diameter_mm + stock_mm) * stock_mm * s.length_mm;
    p.consumables.push_back({"wheel_volume_mm3", removed_mm3 / *s.grinding_ratio, "mm3",
                             "COMPLETION: removed volume over grinding ratio", "wheel worn off per part"});
  }
  return p;
}

namespace internal_grinding {
void add_to(Kinds& kinds) {
  kinds.add<InternalGrinding>("A bore ground by plunging, the grains standing above the bond.", {"K303"});
}
}  // namespace internal_grinding

}  // namespace verstat::operations
