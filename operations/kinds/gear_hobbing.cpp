#include "operations/kinds/gear_hobbing.h"

#include <cmath>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::GearHobbing> {
  static std::vector<Field> fields() {
    using S = operations::GearHobbing;
    return {
        need<S>(&S::module_mm, "module_mm", "mm", closed(1, 20), "normal module"),
        need<S>(&S::gear_teeth, "gear_teeth", "1", closed(8, 300), "teeth of the gear"),
        may<S>(&S::gear_helix_deg, "gear_helix_deg", "deg", closed(-45, 45),
               "helix angle, right hand positive"),
        may<S>(&S::profile_shift, "profile_shift", "1", closed(-1, 1.5), "profile shift coefficient"),
        need<S>(&S::face_width_mm, "face_width_mm", "mm", closed(0.1, 1e4), "face width of one gear"),
        may<S>(&S::gears_per_stack, "gears_per_stack", "1", closed(1, 1000), "gears cut in one clamping"),
        need<S>(&S::hob_diameter_mm, "hob_diameter_mm", "mm", closed(20, 400), "tip diameter of the hob"),
        may<S>(&S::hob_gashes, "hob_gashes", "1", closed(6, 30), "gashes of the hob"),
        may<S>(&S::hob_starts, "hob_starts", "1", closed(1, 6), "starts of the hob"),
        may<S>(&S::hob_tip_radius_mm, "hob_tip_radius_mm", "mm", closed(0, 20),
               "tip radius of the hob tooth; without it 0.3 modules"),
        may<S>(&S::pressure_angle_deg, "pressure_angle_deg", "deg", closed(10, 35), "pressure angle"),
        may<S>(&S::hob_addendum_factor, "hob_addendum_factor", "1", closed(0.8, 2), "addendum over module"),
        may<S>(&S::hob_profile, "hob_profile", "-", no_range(), "profile of the hob worm"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1000),
                "cutting speed at the hob tip"),
        need<S>(&S::axial_feed_mm_rev, "axial_feed_mm_rev", "mm/rev", closed(0.1, 8),
                "axial feed per blank revolution"),
        may<S>(&S::feed_mode, "feed_mode", "-", no_range(), "climb or conventional feed"),
        may<S>(&S::allowance_mm, "allowance_mm", "mm", closed(0, 1000),
               "allowance before and behind the stack, each"),
        may<S>(&S::chip_model, "chip_model", "-", no_range(), "how the chip thickness is found"),
        may<S>(&S::angle_step_deg, "angle_step_deg", "deg", closed(0.5, 5), "step of the spatial model"),
        may<S>(&S::chip_thickness_max_mm, "chip_thickness_max_mm", "mm", open_low(0, 5),
               "largest chip thickness that the hob stands"),
        may<S>(&S::specific_cutting_force_mpa, "specific_cutting_force_mpa", "MPa", open_low(0, 1e5),
               "specific cutting force")};
  }
};

namespace verstat::operations {

namespace {

namespace k101 = models::k101;

struct Chips {
  double thickness_mm;
  double volume_per_gap_mm3;  // and blank revolution
  const char* origin;
  const char* volume_origin;
};

Chips spatial_chips(const GearHobbing& spec, CutPlan& p) {
  models::require(spec.hob_starts == 1, "hob_starts", spec.hob_starts,
                  "must be 1: the spatial chip model is for single-start hobs");
  k101::LoadSummaryInputs in;
  in.module_mm = spec.module_mm;
  in.hob_diameter_mm = spec.hob_diameter_mm;
  in.hob_tip_radius_mm = spec.hob_tip_radius_mm.value_or(0.3 * spec.module_mm);
  in.pressure_angle_deg = spec.pressure_angle_deg;
  in.hob_addendum_factor = spec.hob_addendum_factor;
  in.hob_profile = spec.hob_profile;
  in.gear_teeth = spec.gear_teeth;
  in.gear_helix_deg = spec.gear_helix_deg;
  in.profile_shift = spec.profile_shift;
  in.hob_gashes = spec.hob_gashes;
  in.axial_feed_mm_rev = spec.axial_feed_mm_rev;
  in.feed_mode = spec.feed_mode;
  in.angle_step_deg = spec.angle_step_deg;
  constexpr const char* origin = "K101.hobbing_load_summary";
  const auto load = k101::hobbing_load_summary(in);
  p.quantities.push_back({"most_loaded_tooth", static_cast<double>(load.most_loaded_tooth), "1", origin,
                          "hob tooth that removes most, 0 at the centre"});
  p.quantities.push_back(
      {"most_loaded_share", load.most_loaded_share, "1", origin, "share of the volume that it removes"});
  return {load.max_chip_thickness_mm, load.chip_volume_per_gap_mm3, origin, origin};
}

Chips estimated_chips(const GearHobbing& spec, const k101::HobbingSetup& setup) {
  const double thickness_mm = k101::hoffmeister_chip_thickness({.module_mm = spec.module_mm,
                                                                .gear_teeth = spec.gear_teeth,
                                                                .gear_helix_deg = spec.gear_helix_deg,
                                                                .profile_shift = spec.profile_shift,
                                                                .hob_diameter_mm = spec.hob_diameter_mm,
                                                                .hob_gashes = spec.hob_gashes,
                                                                .hob_starts = spec.hob_starts,
                                                                .axial_feed_mm_rev = spec.axial_feed_mm_rev,
                                                                .cutting_depth_mm = setup.cutting_depth_mm})
                                  .max_chip_thickness_mm;
  // Teeth and gaps share the ring between tip and root circle about evenly.
  const double tip_mm = setup.gear_outer_radius_mm;
  const double root_mm = tip_mm - setup.cutting_depth_mm;
  const double gap_mm2 =
      std::numbers::pi * (tip_mm * tip_mm - root_mm * root_mm) / (2 * static_cast<double>(spec.gear_teeth));
  return {thickness_mm, gap_mm2 * spec.axial_feed_mm_rev, "K101.hoffmeister_chip_thickness",
          "COMPLETION: half the ring between tip and root circle"};
}

}  // namespace

CutPlan plan(const GearHobbing& spec, const PlanContext& context) {
  const double rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.hob_diameter_mm);
  const auto setup = k101::hobbing_setup({.module_mm = spec.module_mm,
                                          .gear_teeth = spec.gear_teeth,
                                          .gear_helix_deg = spec.gear_helix_deg,
                                          .profile_shift = spec.profile_shift,
                                          .hob_diameter_mm = spec.hob_diameter_mm,
                                          .hob_addendum_factor = spec.hob_addendum_factor});
  const k101::ApproachInputs meeting{.centre_distance_mm = setup.centre_distance_mm,
                                     .hob_diameter_mm = spec.hob_diameter_mm,
                                     .gear_outer_radius_mm = setup.gear_outer_radius_mm,
                                     .setting_angle_deg = setup.setting_angle_deg};
  const auto approach = k101::hob_approach_length(meeting);
  const double gears = static_cast<double>(spec.gears_per_stack);
  const auto stack =
      k101::hobbing_main_time({.approach_length_mm = approach.approach_length_mm + spec.allowance_mm,
                               .face_width_mm = spec.face_width_mm * gears,
                               .axial_feed_mm_rev = spec.axial_feed_mm_rev,
                               .gear_teeth = spec.gear_teeth,
                               .hob_speed_rpm = rpm,
                               .hob_starts = spec.hob_starts});

  CutPlan p;
  p.set_main_time(stack.main_time_min / gears, "K101.hobbing_main_time");
  p.quantities.push_back({"hob_speed_rpm", rpm, "rpm", "definition", "hob speed"});
  p.quantities.push_back({"hob_revolutions", stack.hob_revolutions, "1", "K101.hobbing_main_time",
                          "hob revolutions of one stack"});
  p.quantities.push_back({"approach_length_mm", approach.approach_length_mm, "mm", "K101.hob_approach_length",
                          "axial approach of the hob"});
  p.quantities.push_back(
      {"cutting_depth_mm", setup.cutting_depth_mm, "mm", "K101.hobbing_setup", "depth of the tooth gap"});
  p.quantities.push_back({"setting_angle_deg", setup.setting_angle_deg, "deg", "K101.hobbing_setup",
                          "setting angle of the hob"});

  const Chips chips =
      spec.chip_model == ChipModel::spatial ? spatial_chips(spec, p) : estimated_chips(spec, setup);
  p.quantities.push_back(
      {"chip_thickness_mm", chips.thickness_mm, "mm", chips.origin, "largest chip thickness"});
  p.quantities.push_back({"chip_volume_per_gap_mm3", chips.volume_per_gap_mm3, "mm3", chips.volume_origin,
                          "volume of one gap per blank revolution"});
  if (spec.chip_thickness_max_mm)
    p.limits.push_back(
        {"chip_thickness_mm", chips.thickness_mm, *spec.chip_thickness_max_mm, true, "mm", chips.origin});

  const double blank_rpm = rpm * static_cast<double>(spec.hob_starts) / static_cast<double>(spec.gear_teeth);
  if (spec.specific_cutting_force_mpa) {
    constexpr const char* origin = "COMPLETION: Kienzle, mean of K101 (C4)";
    const double volume_mm3_min = chips.volume_per_gap_mm3 * static_cast<double>(spec.gear_teeth) * blank_rpm;
    const double power_kw = *spec.specific_cutting_force_mpa * volume_mm3_min / 6e7;
    p.quantities.push_back({"power_kw", power_kw, "kW", origin, "mean cutting power"});
    limit_power(p, context, power_kw, origin);
    limit_torque(p, context, power_kw * 9549.3 / rpm, origin);
  }
  limit_spindle_speed(p, context, rpm, "definition");
  limit_feed_rate(p, context, spec.axial_feed_mm_rev * blank_rpm, "definition");
  if (context.edge != nullptr)
    p.edge =
        taylor_life(*context.edge, spec.cutting_speed_m_min, spec.axial_feed_mm_rev, setup.cutting_depth_mm);
  return p;
}

namespace gear_hobbing {
void add_to(Kinds& kinds) {
  kinds.add<GearHobbing>("Cylindrical gears by a hob with axial feed: the chip thickness limits the feed.",
                         {"K101"});
}
}  // namespace gear_hobbing

}  // namespace verstat::operations
