#include "operations/kinds/cylindrical_grinding.h"

#include <algorithm>
#include <numbers>

#include "models/grinding/k118_elastic_grinding_clamp_force.h"
#include "models/grinding/k207_longitudinal_feed_controller.h"
#include "models/grinding/k302_combined_grinding_roughness.h"
#include "models/grinding/k303_cutting_surface_height.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

namespace verstat::models {

template <>
struct StructFields<operations::ElectrochemicalAid> {
  static std::vector<Field> fields() {
    using S = operations::ElectrochemicalAid;
    return {need<S>(&S::voltage_v, "voltage_v", "V", closed(0, 1000), "voltage net of over-potential"),
            need<S>(&S::gap_um, "gap_um", "um", open_low(0, 1e4), "gap at the peaks"),
            need<S>(&S::exposure_s, "exposure_s", "s", closed(0, 1e4), "time of dissolution"),
            need<S>(&S::conductivity_s_m, "conductivity_s_m", "S/m", open_low(0, 1000),
                    "conductivity of the electrolyte"),
            may<S>(&S::efficiency, "efficiency", "1", open_low(0, 1), "share of the current that dissolves"),
            may<S>(&S::volume_equivalent_mm3_a_min, "volume_equivalent_mm3_a_min", "mm3/(A min)",
                   open_low(0, 100), "dissolved volume per charge; iron 2.21")};
  }
};

template <>
struct StructFields<operations::FeedController> {
  static std::vector<Field> fields() {
    using S = operations::FeedController;
    return {need<S>(&S::feed_from_m_min, "feed_from_m_min", "m/min", open_low(0, 1e3),
                    "feed of the passes before this operation"),
            may<S>(&S::plant_gain, "plant_gain", "1", open_low(0, 100), "gain of the drive"),
            may<S>(&S::plant_pole, "plant_pole", "1", open(0, 1), "pole of the drive, per pass"),
            may<S>(&S::delay, "delay", "1", closed(1, 20), "dead time in passes")};
  }
};

template <>
struct StructFields<operations::CylindricalGrinding> {
  static std::vector<Field> fields() {
    using S = operations::CylindricalGrinding;
    std::vector<Field> all{
        need<S>(&S::diameter_mm, "diameter_mm", "mm", closed(0.1, 1e4), "diameter of the ground cylinder"),
        need<S>(&S::length_mm, "length_mm", "mm", closed(0.1, 1e5), "its length"),
        need<S>(&S::allowance_um, "allowance_um", "um", open_low(0, 1e4), "stock on the radius"),
        may<S>(&S::initial_defect_um, "initial_defect_um", "um", closed(0, 1e4),
               "heat-affected layer the part comes with"),
        need<S>(&S::transform_c, "transform_c", "degC", closed(100, 2000),
                "temperature of phase transformation of the part"),
        may<S>(&S::ambient_c, "ambient_c", "degC", closed(-50, 99), "temperature of the part before"),
        need<S>(&S::conductivity_w_mk, "conductivity_w_mk", "W/(m K)", closed(0.1, 1000),
                "thermal conductivity of the part"),
        need<S>(&S::diffusivity_m2_s, "diffusivity_m2_s", "m2/s", closed(1e-8, 1e-3),
                "thermal diffusivity of the part"),
        need<S>(&S::work_speed_m_min, "work_speed_m_min", "m/min", closed(0.01, 1000),
                "surface speed of the part"),
        need<S>(&S::rough_infeed_um, "rough_infeed_um", "um", closed(0.01, 1000), "depth of a roughing pass"),
        need<S>(&S::finish_infeed_um, "finish_infeed_um", "um", closed(0.01, 1000),
                "depth of a finishing pass"),
        need<S>(&S::finish_allowance_um, "finish_allowance_um", "um", open_low(0, 1e4),
                "part of the allowance left for finishing"),
        may<S>(&S::sparkout_passes, "sparkout_passes", "1", closed(0, 10'000), "passes without infeed"),
        may<S>(&S::traverse_feed_mm_rev, "traverse_feed_mm_rev", "mm/rev", closed(1e-3, 1e3),
               "feed along the part; without it the wheel plunges and a pass is one revolution"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1e3), "travel beyond the length, traverse only"),
        may<S>(&S::feed_controller, "feed_controller", "-", no_range(),
               "controller of the traverse feed; absent: the feed is there at once"),
        may<S>(&S::up_grinding, "up_grinding", "-", no_range(),
               "wheel and part run against each other in the contact"),
        need<S>(&S::specific_energy_j_mm3, "specific_energy_j_mm3", "J/mm3", closed(0.1, 1000),
                "energy per removed volume"),
        may<S>(&S::heat_fraction, "heat_fraction", "1", open_low(0, 1), "share of the heat into the part"),
        may<S>(&S::electrochemical, "electrochemical", "-", no_range(),
               "electrochemical dissolution in the zone; absent: none"),
        need<S>(&S::wheel_diameter_mm, "wheel_diameter_mm", "mm", closed(1, 5000), "wheel diameter"),
        need<S>(&S::wheel_width_mm, "wheel_width_mm", "mm", closed(0.1, 1000), "wheel width"),
        need<S>(&S::wheel_speed_m_s, "wheel_speed_m_s", "m/s", closed(1, 500), "wheel speed"),
        may<S>(&S::profile_exponent, "profile_exponent", "1", closed(0, 3),
               "exponent of the groove width: 0.5 rounded tip, 1 cone"),
        may<S>(&S::tip_exponent, "tip_exponent", "1", closed(0.1, 5), "exponent of the tip-depth law"),
        may<S>(&S::chip_coefficient, "chip_coefficient", "1", open_low(0, 1),
               "share of a groove that leaves as chip"),
        may<S>(&S::width_coefficient, "width_coefficient", "mm^(1-m)", closed(1e-4, 100),
               "coefficient of the groove width"),
        may<S>(&S::grains_per_mm2, "grains_per_mm2", "1/mm2", closed(0.01, 1e4),
               "grains per area within the wheel layer"),
        may<S>(&S::wheel_layer_mm, "wheel_layer_mm", "mm", closed(1e-4, 1),
               "depth of the wheel layer that holds the tips"),
        may<S>(&S::grinding_ratio, "grinding_ratio", "1", open_low(0, 1e6),
               "removed volume per worn wheel volume"),
        may<S>(&S::roughness_ra_max_um, "roughness_ra_max_um", "um", open_low(0, 100), "largest Ra"),
        may<S>(&S::defect_depth_max_um, "defect_depth_max_um", "um", closed(0, 1e4),
               "deepest heat-affected layer left on the part"),
        may<S>(&S::temperature_max_c, "temperature_max_c", "degC", closed(100, 3000),
               "highest surface temperature in any pass"),
        may<S>(&S::base_length_mm, "base_length_mm", "mm", closed(0.01, 25),
               "length over which Rz and Rmax are taken")};
    operations::append_grain_protrusion<S>(all);
    return all;
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

/// Heat of one stage: power, surface temperature, and the layer it reaches above the transformation.
struct StageHeat {
  double power_kw = 0;
  double temperature_c = 0;
  double defect_um = 0;
};

StageHeat stage_heat(const CylindricalGrinding& s, double infeed_um, double width_of_cut_mm) {
  models::k303::ArcOfCut arc;
  arc.wheel_radius_mm = s.wheel_diameter_mm / 2;
  arc.work_radius_mm = s.diameter_mm / 2;
  arc.kind = models::k303::GrindingKind::external;
  arc.depth_mm = infeed_um / 1000;
  const double contact_mm = models::k303::contact_arc(arc).arc_length_mm;
  const double work_mm_s = s.work_speed_m_min * 1000 / 60;
  const double power_per_width_w_mm = s.specific_energy_j_mm3 * work_mm_s * infeed_um / 1000;

  models::k118::RiseInputs heat;
  heat.conductivity_w_mk = s.conductivity_w_mk;
  heat.diffusivity_m2_s = s.diffusivity_m2_s;
  heat.heat_fraction = s.heat_fraction;
  heat.wheel_speed_m_s = s.wheel_speed_m_s;
  heat.work_speed_m_min = s.work_speed_m_min;
  heat.contact_length_mm = contact_mm;
  heat.width_mm = 1;
  heat.tangential_force_n = power_per_width_w_mm / s.wheel_speed_m_s;

  StageHeat stage;
  stage.power_kw = power_per_width_w_mm * width_of_cut_mm / 1000;
  stage.temperature_c = s.ambient_c + models::k118::grinding_temperature_rise(heat).temperature_rise_k;
  models::k302::SurfaceHeating surface;
  surface.surface_c = stage.temperature_c;
  surface.transform_c = s.transform_c;
  surface.ambient_c = s.ambient_c;
  surface.diffusivity_mm2_s = s.diffusivity_m2_s * 1e6;
  surface.source_time_s = contact_mm / work_mm_s;
  stage.defect_um = models::k302::defect_depth_temperature(surface).depth_um;
  return stage;
}

/// Marks of the grains left by `passes` passes of equal infeed. Every pass meets each point `overlap` times
/// at one depth, which multiplies the marks.
models::k302::SteadyLayer marks(const models::k302::MarkIntensity& intensity, double overlap,
                                double infeed_um, double passes, std::int64_t sparkout_passes) {
  models::k302::SteadyLayer field;
  field.g_per_mm_nu = overlap * intensity.g_per_mm_nu;
  field.nu = intensity.nu;
  field.shift_um = infeed_um;
  field.contacts = std::max<std::int64_t>(1, static_cast<std::int64_t>(passes));
  field.sparkout_contacts = sparkout_passes;
  return field;
}

void check(const CylindricalGrinding& s) {
  models::require(s.finish_allowance_um <= s.allowance_um, "finish_allowance_um", s.finish_allowance_um,
                  "must not be above allowance_um");
  models::require(s.traverse_feed_mm_rev || s.length_mm <= s.wheel_width_mm, "wheel_width_mm",
                  s.wheel_width_mm, "must cover length_mm in plunge grinding (no traverse_feed_mm_rev)");
  models::require(!s.traverse_feed_mm_rev || *s.traverse_feed_mm_rev <= s.wheel_width_mm,
                  "traverse_feed_mm_rev", s.traverse_feed_mm_rev.value_or(0),
                  "must not be above wheel_width_mm");
  models::require(!s.feed_controller || s.traverse_feed_mm_rev, "feed_controller/feed_from_m_min",
                  s.feed_controller ? s.feed_controller->feed_from_m_min : 0,
                  "needs traverse_feed_mm_rev: a plunging wheel does not traverse");
  models::require(s.allowance_um < 500 * s.diameter_mm, "allowance_um", s.allowance_um,
                  "must be below the radius of the part");
}

/// Time of the passes while the traverse feed follows its controller (K207), with what the change of feed
/// does on the way.
double controlled_time_min(const CylindricalGrinding& s, double part_speed_rpm, double passes, CutPlan& p) {
  const FeedController& controller = *s.feed_controller;
  models::k207::FeedChange change;
  change.plant_gain = controller.plant_gain;
  change.plant_pole = controller.plant_pole;
  change.delay = controller.delay;
  change.length_mm = s.length_mm + s.overrun_mm;
  change.feed_from_m_min = controller.feed_from_m_min;
  change.feed_to_m_min = *s.traverse_feed_mm_rev * part_speed_rpm / 1000;
  change.n_passes = static_cast<std::int64_t>(passes);
  models::k207::StepInputs step;
  static_cast<models::k207::FeedLoop&>(step) = change;
  step.n_samples = change.n_passes;
  const auto response = models::k207::feed_channel_step_response(step);
  const double radius = models::k207::feed_loop_spectral_radius(change).rho;
  const double rise_m_min = change.feed_to_m_min - change.feed_from_m_min;
  const double peak_m_min = rise_m_min > 0 ? change.feed_to_m_min + rise_m_min * response.overshoot_pct / 100
                                           : std::max(change.feed_from_m_min, change.feed_to_m_min);
  const double peak_mm_rev = 1000 * peak_m_min / part_speed_rpm;
  constexpr const char* origin = "K207.feed_channel_step_response";
  p.quantities.push_back({"feed_loop_radius", radius, "1", "K207.feed_loop_spectral_radius",
                          "below 1 the controller is stable"});
  p.quantities.push_back({"feed_settle_passes", static_cast<double>(response.settle_samples), "1", origin,
                          "passes until the feed stays within 2 % of the change"});
  p.quantities.push_back(
      {"peak_traverse_feed_mm_rev", peak_mm_rev, "mm/rev", origin, "largest feed on the way"});
  p.limits.push_back({"feed_loop_radius", radius, 1, true, "1", "K207.feed_loop_spectral_radius"});
  p.limits.push_back({"peak_traverse_feed_mm_rev", peak_mm_rev, s.wheel_width_mm, true, "mm/rev",
                      "K207: every turn must stay under the wheel"});
  return models::k207::feed_change_time(change).time_min;
}

}  // namespace

CutPlan plan(const CylindricalGrinding& s, const PlanContext& context) {
  check(s);
  const double pi = std::numbers::pi;
  const double rough_stock_um = s.allowance_um - s.finish_allowance_um;
  const double rough_passes = rough_stock_um > 0 ? steps_in(rough_stock_um, s.rough_infeed_um) : 0;
  const double finish_passes = steps_in(s.finish_allowance_um, s.finish_infeed_um);
  const double passes = rough_passes + finish_passes + static_cast<double>(s.sparkout_passes);
  const double part_speed_rpm = 1000 * s.work_speed_m_min / (pi * s.diameter_mm);
  const double revolutions_per_pass =
      s.traverse_feed_mm_rev ? (s.length_mm + s.overrun_mm) / *s.traverse_feed_mm_rev : 1;
  const double overlap = s.traverse_feed_mm_rev ? s.wheel_width_mm / *s.traverse_feed_mm_rev : 1;
  const double width_of_cut_mm = s.traverse_feed_mm_rev.value_or(s.length_mm);

  CutPlan p;
  p.quantities.reserve(24);
  if (s.feed_controller)
    p.set_main_time(controlled_time_min(s, part_speed_rpm, passes, p), "K207.feed_change_time");
  else
    p.set_main_time(passes * revolutions_per_pass / part_speed_rpm,
                    "COMPLETION: passes times revolutions over part speed");

  // Heat-affected layer: roughing brings one, finishing removes it and brings its own (K302 eq. 17).
  const StageHeat rough = rough_passes > 0 ? stage_heat(s, s.rough_infeed_um, width_of_cut_mm) : StageHeat{};
  const StageHeat finish = stage_heat(s, s.finish_infeed_um, width_of_cut_mm);
  const double defect_before_um =
      rough_passes > 0
          ? models::k302::defect_depth_after_pass({s.initial_defect_um, rough_stock_um, rough.defect_um})
                .depth_um
          : s.initial_defect_um;
  // Passes that bring the same layer amount to one of their whole stock.
  const double defect_um =
      models::k302::defect_depth_after_pass({defect_before_um, s.finish_allowance_um, finish.defect_um})
          .depth_um;
  const auto burn_passes = models::k302::passes_to_reach_defect(
      {defect_before_um, s.finish_infeed_um, finish.defect_um, s.defect_depth_max_um.value_or(0)});

  // Roughness.
  models::k302::MarkGeometry wheel;
  wheel.profile_exponent = s.profile_exponent;
  wheel.tip_exponent = s.tip_exponent;
  wheel.chip_coefficient = s.chip_coefficient;
  wheel.width_coefficient = s.width_coefficient;
  wheel.grains_per_mm2 = s.grains_per_mm2;
  wheel.wheel_speed_m_s = s.wheel_speed_m_s;
  wheel.work_speed_m_min = s.work_speed_m_min;
  wheel.up_grinding = s.up_grinding;
  wheel.wheel_diameter_mm = s.wheel_diameter_mm * s.diameter_mm / (s.wheel_diameter_mm + s.diameter_mm);
  wheel.wheel_layer_mm = s.wheel_layer_mm;
  const models::k302::MarkIntensity intensity = models::k302::abrasive_mark_intensity(wheel);
  const auto field = marks(intensity, overlap, s.finish_infeed_um, finish_passes, s.sparkout_passes);
  models::k302::MarkFieldAtDepth at_depth;
  static_cast<models::k302::MarkField&>(at_depth) = field;
  at_depth.median_depth_um = models::k302::median_depth(field).median_depth_um;
  double ra_um = models::k302::roughness_ra(at_depth).ra_um;
  const auto layer = models::k302::layer_height_steady(field);
  double sunk_um = layer.actual_depth_um;
  if (rough_passes > 0)
    sunk_um = std::max(sunk_um, models::k302::layer_height_steady(
                                    marks(intensity, overlap, s.rough_infeed_um, rough_passes, 0))
                                    .actual_depth_um);
  double layer_um = layer.mechanical_height_um;
  const char* ra_origin = "K302.roughness_ra";
  if (s.electrochemical) {
    const ElectrochemicalAid& ec = *s.electrochemical;
    const auto dissolved = models::k302::electrochemical_removal(
        {ec.volume_equivalent_mm3_a_min, ec.efficiency, ec.conductivity_s_m, ec.voltage_v, ec.gap_um,
         layer_um, ec.exposure_s});
    ra_um = models::k302::combined_ra({ra_um, layer_um, dissolved.peak_um, dissolved.valley_um}).ra_um;
    layer_um = models::k302::roughness_layer(
                   {layer.actual_depth_um, s.finish_infeed_um, dissolved.peak_um, dissolved.valley_um})
                   .layer_height_um;
    ra_origin = "K302.combined_ra";
    p.quantities.push_back({"dissolved_at_peaks_um", dissolved.peak_um, "um", "K302.electrochemical_removal",
                            "depth dissolved at the peaks"});
  }
  const auto extremes =
      models::k302::roughness_extremes({layer_um, intensity.theta, s.tip_exponent, s.base_length_mm});

  const double power_kw = std::max(rough.power_kw, finish.power_kw);
  const double temperature_c = std::max(rough.temperature_c, finish.temperature_c);
  const double wheel_rpm = 60'000 * s.wheel_speed_m_s / (pi * s.wheel_diameter_mm);
  const double feed_mm_min =
      s.traverse_feed_mm_rev
          ? *s.traverse_feed_mm_rev * part_speed_rpm
          : std::max(rough_passes > 0 ? s.rough_infeed_um : 0, s.finish_infeed_um) / 1000 * part_speed_rpm;

  auto& q = p.quantities;
  q.push_back({"rough_passes", rough_passes, "1", "definition", "roughing passes"});
  q.push_back({"finish_passes", finish_passes, "1", "definition", "finishing passes"});
  q.push_back({"part_speed_rpm", part_speed_rpm, "rpm", "definition", "speed of the part"});
  q.push_back({"wheel_speed_rpm", wheel_rpm, "rpm", "definition", "speed of the wheel"});
  q.push_back({"power_kw", power_kw, "kW", "COMPLETION: specific energy times removal rate",
               "grinding power, hardest stage"});
  q.push_back({"tangential_force_n", 1000 * power_kw / s.wheel_speed_m_s, "N",
               "COMPLETION: power over wheel speed", "tangential force, hardest stage"});
  if (rough_passes > 0) {
    q.push_back({"rough_temperature_c", rough.temperature_c, "degC", "K118.grinding_temperature_rise",
                 "surface temperature in roughing"});
    q.push_back({"rough_defect_um", rough.defect_um, "um", "K302.defect_depth_temperature",
                 "heat-affected layer that roughing brings"});
  }
  q.push_back({"finish_temperature_c", finish.temperature_c, "degC", "K118.grinding_temperature_rise",
               "surface temperature in finishing"});
  q.push_back({"finish_defect_um", finish.defect_um, "um", "K302.defect_depth_temperature",
               "heat-affected layer that finishing brings"});
  q.push_back({"defect_depth_um", defect_um, "um", "K302.defect_depth_after_pass",
               "heat-affected layer left on the part"});
  q.push_back({"burn_passes", static_cast<double>(burn_passes.passes), "1", "K302.passes_to_reach_defect",
               "finishing passes that remove the burn of roughing; -1: none suffices"});
  q.push_back({"roughness_ra_um", ra_um, "um", ra_origin, "Ra of the part"});
  if (extremes.rz_um > 0) {  // else the layer is too thin for the order statistics
    q.push_back({"roughness_rz_um", extremes.rz_um, "um", "K302.roughness_extremes", "Rz of the part"});
    q.push_back({"roughness_rmax_um", extremes.rmax_um, "um", "K302.roughness_extremes", "Rmax of the part"});
  }
  p.leave("defect_depth_um");
  p.leave("roughness_ra_um");
  if (extremes.rz_um > 0) {
    p.leave("roughness_rz_um");
    p.leave("roughness_rmax_um");
  }
  q.push_back({"sunk_depth_um", sunk_um, "um", "K302.layer_height_steady",
               "depth to which the wheel sinks into the surface, deepest stage"});

  p.limits.reserve(10);
  p.limits.push_back({"wheel_layer_um", sunk_um, 1000 * s.wheel_layer_mm, true, "um",
                      "K302.layer_height_steady: the law of the tips holds within the layer"});
  p.limits.push_back({"grain_protrusion_um", sunk_um, s.grain_protrusion_um, true, "um",
                      "K302.layer_height_steady: the bond must not rub"});
  if (s.roughness_ra_max_um)
    p.limits.push_back({"roughness_ra_um", ra_um, *s.roughness_ra_max_um, true, "um", ra_origin});
  if (s.defect_depth_max_um)
    p.limits.push_back(
        {"defect_depth_um", defect_um, *s.defect_depth_max_um, true, "um", "K302.defect_depth_after_pass"});
  if (s.temperature_max_c)
    p.limits.push_back({"temperature_c", temperature_c, *s.temperature_max_c, true, "degC",
                        "K118.grinding_temperature_rise"});
  add_machine_limits(
      p, context,
      WheelLoad{.wheel_rpm = wheel_rpm,
                .diameter_mm = s.wheel_diameter_mm * s.diameter_mm / (s.wheel_diameter_mm + s.diameter_mm),
                .work_speed_m_min = s.work_speed_m_min,
                .infeed_mm = s.finish_infeed_um / 1000,
                .feed_rate_mm_min = feed_mm_min,
                .power_kw = power_kw});

  p.more_elements.push_back(dressing_life(s, sunk_um, p.main_time_min));
  if (s.grinding_ratio) {
    const double stock_mm = s.allowance_um / 1000;
    const double removed_mm3 = pi * (s.diameter_mm - stock_mm) * stock_mm * s.length_mm;
    p.consumables.push_back({"wheel_volume_mm3", removed_mm3 / *s.grinding_ratio, "mm3",
                             "COMPLETION: removed volume over grinding ratio", "wheel worn off per part"});
  }
  return p;
}

namespace cylindrical_grinding {
void add_to(Kinds& kinds) {
  kinds.add<CylindricalGrinding>("A shaft ground outside in roughing and finishing passes and spark-out.",
                                 {"K302", "K303", "K118", "K207"});
}
}  // namespace cylindrical_grinding

}  // namespace verstat::operations
