#include "operations/kinds/elastic_grinding.h"

#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::ElasticGrinding> {
  static std::vector<Field> fields() {
    using S = operations::ElasticGrinding;
    std::vector<Field> all{
        need<S>(&S::clamp_force_n, "clamp_force_n", "N", open_low(0, 1e6),
                "force that presses the part to the wheel, on the whole width"),
        may<S>(&S::critical_c, "critical_c", "degC", closed(100, 2000),
               "temperature of phase transformation: 880 R6M5, 820 60S2"),
        need<S>(&S::allowance_um, "allowance_um", "um", open_low(0, 1e5), "stock on the flat"),
        need<S>(&S::stroke_length_mm, "stroke_length_mm", "mm", closed(0.1, 1e5), "length of a pass"),
        may<S>(&S::sparkout_passes, "sparkout_passes", "1", closed(0, 10'000),
               "passes after the allowance is gone"),
        need<S>(&S::width_mm, "width_mm", "mm", closed(0.01, 1000), "width of the ground flat"),
        may<S>(&S::wheel_radius_mm, "wheel_radius_mm", "mm", closed(1, 5000), "wheel radius"),
        may<S>(&S::wheel_speed_m_s, "wheel_speed_m_s", "m/s", closed(1, 500), "wheel speed"),
        may<S>(&S::work_speed_m_min, "work_speed_m_min", "m/min", closed(0.01, 1000), "work speed"),
        may<S>(&S::concentration_pct, "concentration_pct", "%", closed(25, 200), "diamond concentration"),
        may<S>(&S::grains_per_carat, "grains_per_carat", "1/carat", open_low(0, 1e12), "grains per carat"),
        may<S>(&S::weibull_m, "weibull_m", "1", closed(0.1, 10), "exponent of the grain heights"),
        may<S>(&S::weibull_x0_um_m, "weibull_x0_um_m", "um^m", open_low(0, 1e9),
               "parameter of the grain heights"),
        may<S>(&S::kd_intercept, "kd_intercept", "1", closed(-1e4, 1e4), "regression of the grain pitch"),
        may<S>(&S::kd_slope, "kd_slope", "1", closed(-1e3, 1e3), "regression of the grain pitch"),
        may<S>(&S::k_l, "k_l", "1", closed(1, 1000), "spacing on the surface over spacing in the body"),
        may<S>(&S::k_contact, "k_contact", "1", open_low(0, 1), "share of grains in contact"),
        may<S>(&S::roughness_rz_um, "roughness_rz_um", "um", closed(0, 20), "roughness of the cut surface"),
        may<S>(&S::shrinkage, "shrinkage", "1", open_low(1, 20), "chip shrinkage"),
        may<S>(&S::time_after_dress_min, "dressing_interval_min", "min", open_low(0, 1e5),
               "grinding time between dressings; sets the wear flat"),
        may<S>(&S::k_flank, "k_flank", "1", open_low(0, 100), "coefficient of the wear flat"),
        may<S>(&S::friction, "friction", "1", closed(0, 1), "friction on the wear flat"),
        may<S>(&S::tip_radius_um, "tip_radius_um", "um", open_low(0, 1000), "tip radius of the grains"),
        may<S>(&S::cone_angle_deg, "cone_angle_deg", "deg", open(0, 180), "apex angle of the grains"),
        may<S>(&S::flow_c_mpa, "flow_c_mpa", "MPa", open_low(0, 1e5),
               "flow stress C - alpha T, T in kelvin: C (723 R6M5, 1015 60S2)"),
        may<S>(&S::flow_alpha_mpa_k, "flow_alpha_mpa_k", "MPa/K", open_low(0, 100),
               "its alpha (0.255 R6M5, 0.432 60S2)"),
        may<S>(&S::k_cal, "k_cal", "1", open_low(0, 100), "calibration of the forces"),
        may<S>(&S::conductivity_w_mk, "conductivity_w_mk", "W/(m K)", closed(0.1, 1000),
               "thermal conductivity"),
        may<S>(&S::diffusivity_m2_s, "diffusivity_m2_s", "m2/s", closed(1e-8, 1e-3), "thermal diffusivity"),
        may<S>(&S::heat_fraction, "heat_fraction", "1", closed(0, 1), "share of the heat into the part"),
        may<S>(&S::ambient_c, "ambient_c", "degC", closed(-50, 100), "temperature of the part before"),
        may<S>(&S::grinding_ratio, "grinding_ratio", "1", open_low(0, 1e6),
               "removed volume per worn wheel volume")};
    operations::append_dressing_law<S>(all);
    return all;
  }
};

namespace verstat::operations {

namespace k118 = models::k118;

CutPlan plan(const ElasticGrinding& s, const PlanContext& context) {
  models::require(s.critical_c > s.ambient_c, "critical_c", s.critical_c, "must be above ambient_c");
  k118::ClampInputs clamp;
  static_cast<k118::ElasticWithoutDepth&>(clamp) = s;
  clamp.clamp_force_n = s.clamp_force_n;
  const auto cut = k118::elastic_depth_from_clamp(clamp);
  k118::ThermalLimitInputs thermal;
  static_cast<k118::ElasticWithoutDepth&>(thermal) = s;
  thermal.critical_c = s.critical_c;
  const auto limit = k118::thermal_limit_state(thermal);
  const auto time =
      k118::elastic_grinding_time({s.allowance_um, cut.depth_um, s.stroke_length_mm, s.work_speed_m_min});

  CutPlan p;
  p.quantities.reserve(12);
  p.set_main_time(time.time_min + static_cast<double>(s.sparkout_passes) * s.stroke_length_mm /
                                      (1000 * s.work_speed_m_min),
                  "K118.elastic_grinding_time");
  const double power_kw = cut.tangential_force_n * s.wheel_speed_m_s / 1000;
  const double wheel_rpm = 30'000 * s.wheel_speed_m_s / (std::numbers::pi * s.wheel_radius_mm);

  auto& q = p.quantities;
  q.push_back({"passes", static_cast<double>(time.passes + s.sparkout_passes), "1",
               "K118.elastic_grinding_time", "passes with spark-out"});
  q.push_back({"depth_um", cut.depth_um, "um", "K118.elastic_depth_from_clamp",
               "depth of cut that the clamp force produces"});
  q.push_back({"temperature_c", cut.temperature_c, "degC", "K118.elastic_depth_from_clamp",
               "temperature of the ground surface"});
  q.push_back({"tangential_force_n", cut.tangential_force_n, "N", "K118.elastic_depth_from_clamp",
               "tangential force"});
  q.push_back({"power_kw", power_kw, "kW", "definition: force times wheel speed", "grinding power"});
  q.push_back({"removal_rate_mm3_min", cut.depth_um * s.width_mm * s.work_speed_m_min, "mm3/min",
               "definition: depth, width and work speed", "removal rate"});
  q.push_back({"wheel_speed_rpm", wheel_rpm, "rpm", "definition", "speed of the wheel"});
  q.push_back({"limit_depth_um", limit.depth_um, "um", "K118.thermal_limit_state",
               "largest depth below the critical temperature, 1..60 um"});
  q.push_back(
      {"limit_clamp_force_n", limit.clamp_force_n, "N", "K118.thermal_limit_state", "its clamp force"});

  p.limits.reserve(6);
  p.limits.push_back(
      {"temperature_c", cut.temperature_c, s.critical_c, true, "degC", "K118.elastic_depth_from_clamp"});
  if (limit.limited)
    p.limits.push_back(
        {"clamp_force_n", s.clamp_force_n, limit.clamp_force_n, true, "N", "K118.thermal_limit_state"});
  add_machine_limits(p, context,
                     WheelLoad{.wheel_rpm = wheel_rpm,
                               .diameter_mm = 2 * s.wheel_radius_mm,
                               .work_speed_m_min = s.work_speed_m_min,
                               .infeed_mm = cut.depth_um / 1000,
                               .feed_rate_mm_min = 1000 * s.work_speed_m_min,
                               .power_kw = power_kw,
                               .normal_force_n = s.clamp_force_n});
  limit_feed_force(p, context, s.clamp_force_n, "machine");

  p.more_elements.push_back(dressing_life(s, s.time_after_dress_min, "given: dressing interval"));
  if (s.grinding_ratio)
    p.consumables.push_back(
        {"wheel_volume_mm3", s.allowance_um / 1000 * s.width_mm * s.stroke_length_mm / *s.grinding_ratio,
         "mm3", "COMPLETION: removed volume over grinding ratio", "wheel worn off per part"});
  return p;
}

namespace elastic_grinding {
void add_to(Kinds& kinds) {
  kinds.add<ElasticGrinding>("A flat pressed to the wheel with a force that the burn temperature limits.",
                             {"K118"});
}
}  // namespace elastic_grinding

}  // namespace verstat::operations
