#include "operations/kinds/through_hole_drilling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/drilling/k111_reverse_tilt_chisel_edge.h"
#include "models/drilling/k114_sharpened_chisel_edge.h"
#include "models/drilling/k308_hole_pair_tooling.h"
#include "models/drilling/k410_drilling_fem.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

namespace verstat::models {

std::vector<Field> StructFields<operations::MultiSpindleHead>::fields() {
  using S = operations::MultiSpindleHead;
  return {need<S>(&S::drills, "drills", "1", closed(2, 100), "drills in the head"),
          may<S>(&S::pinion_teeth, "pinion_teeth", "1", closed(5, 500), "teeth of the central pinion"),
          may<S>(&S::gear_teeth, "gear_teeth", "1", closed(5, 500), "teeth of a spindle gear"),
          may<S>(&S::gear_module_mm, "gear_module_mm", "mm", closed(0.1, 50), "module of the gears"),
          may<S>(&S::centre_distance_mm, "centre_distance_mm", "mm", open_low(0, 1e4),
                 "distance of the two spindles")};
}

std::vector<Field> StructFields<operations::DrillRun>::fields() {
  using S = operations::DrillRun;
  return {need<S>(&S::diameter_mm, "diameter_mm", "mm", closed(0.1, 200), "drill diameter"),
          need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 10), "feed"),
          need<S>(&S::thrust_n, "thrust_n", "N", open_low(0, 1e7), "thrust"),
          need<S>(&S::torque_nm, "torque_nm", "N m", open_low(0, 1e6), "torque")};
}

template <>
struct StructFields<operations::ThroughHoleDrilling> {
  static std::vector<Field> fields() {
    using S = operations::ThroughHoleDrilling;
    return {
        need<S>(&S::diameter_mm, "diameter_mm", "mm", closed(0.1, 200), "drill diameter"),
        need<S>(&S::thickness_mm, "thickness_mm", "mm", closed(0.01, 1e4), "thickness of the part"),
        may<S>(&S::holes, "holes", "1", closed(1, 10'000), "holes of one part"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1000),
                "cutting speed at the diameter"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 10), "nominal feed"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "approach"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "overrun"),
        may<S>(&S::index_min, "index_min", "min", closed(0, 1000), "positioning between two strokes"),
        may<S>(&S::head, "head", "-", no_range(), "multi-spindle head"),
        may<S>(&S::exit_strategy, "exit_strategy", "-", no_range(), "what is done at breakthrough"),
        may<S>(&S::feed_divisor, "feed_divisor", "1", closed(1, 100), "feed over the reduced feed"),
        may<S>(&S::exit_zone_fraction, "exit_zone_fraction", "1", closed(0.2, 0.5),
               "exit zone over the diameter"),
        may<S>(&S::spring_rate_n_mm, "spring_rate_n_mm", "N/mm", open_low(0, 1e6),
               "rate of the spring of the drill holder"),
        may<S>(&S::spring_feed_cap_ratio, "spring_feed_cap_ratio", "1", closed(1, 100),
               "largest feed of the spring holder over the nominal feed"),
        may<S>(&S::thrust_coefficient_n, "thrust_coefficient_n", "N", open_low(0, 1e6),
               "C of the thrust C D^x S^y"),
        may<S>(&S::thrust_exp_diameter, "thrust_exp_diameter", "1", closed(0, 5), "x of the thrust"),
        may<S>(&S::thrust_exp_feed, "thrust_exp_feed", "1", closed(0.1, 2), "y of the thrust"),
        may<S>(&S::torque_coefficient_nm, "torque_coefficient_nm", "N m", open_low(0, 1e4),
               "C of the torque C D^x S^y"),
        may<S>(&S::torque_exp_diameter, "torque_exp_diameter", "1", closed(0, 5), "x of the torque"),
        may<S>(&S::torque_exp_feed, "torque_exp_feed", "1", closed(0.1, 2), "y of the torque"),
        may<S>(&S::load_cv, "load_cv", "1", closed(0, 1), "coefficient of variation of the loads"),
        entries(may<S>(&S::runs, "runs", "-", no_range(),
                       "simulated or measured runs to which the laws of thrust and torque are fitted"),
                0, 10'000),
        may<S>(&S::strength_mpa, "strength_mpa", "MPa", closed(300, 1200),
               "strength of the steel, for the comparison of the runs with the handbook"),
        may<S>(&S::point, "point", "-", no_range(), "grinding of the drill point"),
        may<S>(&S::half_point_angle_deg, "half_point_angle_deg", "deg", closed(45, 75), "half point angle"),
        may<S>(&S::chisel_share, "chisel_share", "1", closed(0, 0.95),
               "share of the thrust on a standard chisel edge"),
        may<S>(&S::chisel_force_ratio, "chisel_force_ratio", "1", closed(0, 1),
               "force of the improved chisel edge over that of the standard one"),
        may<S>(&S::clearance_periphery_deg, "clearance_periphery_deg", "deg", closed(5, 30),
               "clearance of the lips at the periphery"),
        may<S>(&S::core_ratio, "core_ratio", "1", closed(0.01, 0.9), "core over drill diameter"),
        may<S>(&S::slot_tilt_deg, "slot_tilt_deg", "deg", open(-90, 90), "reverse tilt of the slot"),
        may<S>(&S::slot_width_mm, "slot_width_mm", "mm", open_low(0, 50), "width of the slot"),
        may<S>(&S::kinematic_clearance_min_deg, "kinematic_clearance_min_deg", "deg", open_high(0, 90),
               "least clearance in work of the slotted chisel at the core radius"),
        may<S>(&S::chisel_slope_deg, "chisel_slope_deg", "deg", open(0, 90),
               "slope of the sharpened chisel edge in plan"),
        may<S>(&S::chisel_half_angle_deg, "chisel_half_angle_deg", "deg", open_low(0, 90),
               "half angle of the roof of the sharpened chisel edge"),
        may<S>(&S::chisel_clearance_deg, "chisel_clearance_deg", "deg", closed(0, 90),
               "wanted clearance of the sharpened chisel edge"),
        may<S>(&S::chisel_rake_deg, "chisel_rake_deg", "deg", closed(0, 90),
               "wanted rake of the sharpened chisel edge"),
        may<S>(&S::chisel_wedge_min_deg, "chisel_wedge_min_deg", "deg", closed(0, 90),
               "least wedge angle of the sharpened chisel edge"),
        may<S>(&S::feed_jump, "feed_jump", "1", closed(1, 10),
               "measured feed jump at breakthrough (published 1.4 to 1.85)"),
        may<S>(&S::axial_stiffness_n_mm, "axial_stiffness_n_mm", "N/mm", open_low(0, 1e7),
               "axial stiffness of the machine"),
        may<S>(&S::relieved_share, "relieved_share", "1", closed(0, 1),
               "share of the thrust lost at breakthrough"),
        may<S>(&S::relief_travel_mm, "relief_travel_mm", "mm", open_low(0, 1000),
               "travel over which it is lost"),
        may<S>(&S::break_torque_nm, "break_torque_nm", "N m", open_low(0, 1e6),
               "mean torque that breaks the drill"),
        may<S>(&S::break_torque_cv, "break_torque_cv", "1", closed(0.001, 1),
               "coefficient of variation of that torque"),
        may<S>(&S::torsion_allow_mpa, "torsion_allow_mpa", "MPa", open_low(0, 1e4),
               "allowed torsional stress of the drill"),
        may<S>(&S::overhang_mm, "overhang_mm", "mm", open_low(0, 1e4), "overhang of the drill"),
        may<S>(&S::breakage_probability_max, "breakage_probability_max", "1", closed(0, 1),
               "largest probability of a broken drill in one part"),
        may<S>(&S::bushing, "bushing", "-", no_range(), "drill bushing of the jig"),
        may<S>(&S::bushing_holes_fixed, "bushing_holes_fixed", "1", closed(1, 1e9),
               "holes until a fixed bushing is worn out"),
        may<S>(&S::bushing_slip, "bushing_slip", "1", closed(0, 1), "circumferential slip of the bushing"),
        may<S>(&S::bushing_return_factor, "bushing_return_factor", "1", closed(0, 1),
               "normal force of the return stroke over that of cutting"),
        may<S>(&S::return_feed_mm_rev, "return_feed_mm_rev", "mm/rev", open_low(0, 1000),
               "feed of the return stroke")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k111 = models::k111;
namespace k113 = models::k113;
namespace k114 = models::k114;
namespace k308 = models::k308;
using k113::ExitStrategy;

constexpr double drill_elastic_modulus_mpa = 2.1e5;  // high-speed steel, textbook
/// Section of a twist drill and end condition of its buckling, as in the check of K113.
constexpr double section_modulus_factor = 0.02;
constexpr double inertia_factor = 0.0054;
constexpr double buckling_length_factor = 0.7;

/// Thrust over that of a standard point, and the share of it that the chisel edge still carries.
struct PointEffect {
  double thrust_ratio = 1;
  double chisel_share = 0;
};

PointEffect point_effect(const ThroughHoleDrilling& spec, CutPlan& p) {
  if (spec.point == DrillPoint::standard) {
    const auto chisel =
        k111::standard_chisel_geometry({.half_point_angle_deg = spec.half_point_angle_deg,
                                        .clearance_periphery_deg = spec.clearance_periphery_deg,
                                        .core_radius_mm = spec.core_ratio * spec.diameter_mm / 2,
                                        .drill_radius_mm = spec.diameter_mm / 2});
    p.quantities.push_back({"chisel_rake_deg", chisel.chisel_rake_deg, "deg", "K111.standard_chisel_geometry",
                            "rake of the chisel edge"});
    return {1, spec.chisel_share};
  }
  if (spec.point == DrillPoint::slotted_chisel) {
    k111::SlottedPoint slotted;
    slotted.half_point_angle_deg = spec.half_point_angle_deg;
    slotted.clearance_periphery_deg = spec.clearance_periphery_deg;
    slotted.core_radius_mm = spec.core_ratio * spec.diameter_mm / 2;
    slotted.drill_radius_mm = spec.diameter_mm / 2;
    slotted.reverse_tilt_deg = spec.slot_tilt_deg;
    const double core_mm = slotted.core_radius_mm;
    models::require(spec.slot_width_mm / 2 < core_mm, "slot_width_mm", spec.slot_width_mm,
                    "must be below the core diameter");
    const auto geometry = k111::slotted_chisel_geometry(slotted);
    p.quantities.push_back({"chisel_rake_deg", geometry.rake_deg, "deg", "K111.slotted_chisel_geometry",
                            "rake of the chisel edge"});
    const auto working =
        k111::slotted_chisel_kinematics({slotted, spec.slot_width_mm, spec.feed_mm_rev, core_mm});
    p.quantities.push_back({"chisel_kinematic_clearance_deg", working.kinematic_clearance_deg, "deg",
                            "K111.slotted_chisel_kinematics",
                            "clearance in work of the chisel edge at the core radius"});
    const double feed_max_mm_rev = k111::slotted_chisel_max_feed({slotted, spec.slot_width_mm, core_mm,
                                                                  spec.kinematic_clearance_min_deg})
                                       .max_feed_mm_rev;
    p.limits.push_back({"chisel_clearance_feed_mm_rev", spec.feed_mm_rev, feed_max_mm_rev, true, "mm/rev",
                        "K111.slotted_chisel_max_feed"});
  } else {
    k114::Targets targets;
    targets.psi_deg = spec.chisel_slope_deg;
    targets.phi_c_deg = spec.chisel_half_angle_deg;
    targets.alpha_target_deg = spec.chisel_clearance_deg;
    targets.gamma_target_deg = spec.chisel_rake_deg;
    const auto settings = k114::chisel_edge_setting_angles(targets);
    const auto reach = k114::chisel_edge_limits(targets);
    constexpr const char* origin = "K114.chisel_edge_setting_angles";
    p.quantities.push_back(
        {"chisel_rake_deg", spec.chisel_rake_deg, "deg", "specification", "rake of the chisel edge"});
    p.quantities.push_back(
        {"flank_setting_deg", settings.eps1_deg, "deg", origin, "setting angle of the chisel's flank"});
    p.quantities.push_back(
        {"face_setting_deg", settings.eps2_deg, "deg", origin, "setting angle of the chisel's face"});
    p.limits.push_back({"chisel_clearance_deg", spec.chisel_clearance_deg, reach.alpha_min_deg, false, "deg",
                        "K114.chisel_edge_limits"});
    p.limits.push_back({"chisel_rake_deg", spec.chisel_rake_deg, reach.gamma_max_deg, true, "deg",
                        "K114.chisel_edge_limits"});
    p.limits.push_back({"chisel_wedge_deg", 90 - spec.chisel_clearance_deg - spec.chisel_rake_deg,
                        spec.chisel_wedge_min_deg, false, "deg", "COMPLETION: strength of the wedge"});
  }
  const double ratio = k111::drill_thrust_ratio(
                           {.chisel_share = spec.chisel_share, .chisel_force_ratio = spec.chisel_force_ratio})
                           .thrust_ratio;
  return {ratio, spec.chisel_share * spec.chisel_force_ratio / ratio};
}

struct Loads {
  double thrust_n;  // of one drill
  double torque_nm;
};

Loads loads(const ThroughHoleDrilling& spec, double feed_mm_rev, double thrust_ratio) {
  // A plain power law: (1) of K113 with the hardness inside the coefficient.
  return {.thrust_n = thrust_ratio * k113::drill_thrust({.coefficient = spec.thrust_coefficient_n,
                                                         .diameter_mm = spec.diameter_mm,
                                                         .feed_mm_rev = feed_mm_rev,
                                                         .hardness_hb = 1,
                                                         .exp_diameter = spec.thrust_exp_diameter,
                                                         .exp_feed = spec.thrust_exp_feed,
                                                         .exp_hardness = 0})
                                         .thrust_n,
          .torque_nm = spec.torque_coefficient_nm * std::pow(spec.diameter_mm, spec.torque_exp_diameter) *
                       std::pow(feed_mm_rev, spec.torque_exp_feed)};
}

/// The specification with the power laws fitted to its runs (K410). Runs of one diameter tell the feed only:
/// the exponent of the diameter stays as given.
ThroughHoleDrilling fitted(const ThroughHoleDrilling& given, CutPlan& p) {
  ThroughHoleDrilling spec = given;
  if (given.runs.empty()) return spec;
  const bool one_diameter = std::all_of(given.runs.begin(), given.runs.end(), [&](const DrillRun& run) {
    return run.diameter_mm == given.runs.front().diameter_mm;
  });
  models::k410::Runs thrust;
  models::k410::Runs torque;
  models::k410::Comparison compared;
  for (const DrillRun& run : given.runs) {
    std::vector<double> factors{run.feed_mm_rev};
    if (!one_diameter) factors.push_back(run.diameter_mm);
    thrust.factors.push_back(factors);
    torque.factors.push_back(std::move(factors));
    thrust.response.push_back(run.thrust_n);
    torque.response.push_back(run.torque_nm);
    models::k410::Drilling handbook;
    handbook.diameter_mm = run.diameter_mm;
    handbook.feed_mm_rev = run.feed_mm_rev;
    handbook.spindle_rpm = 1000 * given.cutting_speed_m_min / (std::numbers::pi * run.diameter_mm);
    handbook.strength_mpa = given.strength_mpa;
    compared.model.push_back(run.thrust_n);
    compared.reference.push_back(models::k410::drilling_loads(handbook).thrust_n);
  }
  const auto thrust_law = models::k410::fit_power_law(thrust);
  const auto torque_law = models::k410::fit_power_law(torque);
  const auto take = [&](const models::k410::PowerLawFit& law, double& coefficient, double& exp_feed,
                        double& exp_diameter, const char* what) {
    models::require(law.exponents[0] >= 0.1 && law.exponents[0] <= 2, "runs", law.exponents[0],
                    std::string("gives this exponent of the feed for the ") + what + ", allowed 0.1 to 2");
    exp_feed = law.exponents[0];
    coefficient = law.coefficient;
    if (one_diameter)
      coefficient /= std::pow(given.runs.front().diameter_mm, exp_diameter);
    else
      exp_diameter = law.exponents[1];
  };
  take(thrust_law, spec.thrust_coefficient_n, spec.thrust_exp_feed, spec.thrust_exp_diameter, "thrust");
  take(torque_law, spec.torque_coefficient_nm, spec.torque_exp_feed, spec.torque_exp_diameter, "torque");
  const auto agreement = models::k410::model_agreement(compared);
  p.quantities.push_back({"thrust_fit_error", thrust_law.max_relative_error, "1", "K410.fit_power_law",
                          "largest relative error of the fitted thrust over the runs"});
  p.quantities.push_back({"torque_fit_error", torque_law.max_relative_error, "1", "K410.fit_power_law",
                          "the same of the torque"});
  p.quantities.push_back({"thrust_against_handbook", agreement.mean_relative_error, "1",
                          "K410.model_agreement", "mean of thrust of the runs over the handbook's, less 1"});
  return spec;
}

/// Feed jump of a machine that drives the feed rigidly; none when the drill is pulled through.
std::optional<double> feed_jump(const ThroughHoleDrilling& spec, double thrust_n, double point_height_mm,
                                CutPlan& p) {
  if (spec.feed_jump) return spec.feed_jump;
  if (!spec.axial_stiffness_n_mm) return 1;
  const double travel_mm = spec.relief_travel_mm.value_or(point_height_mm);
  const auto jump = k113::breakthrough_feed_jump({.thrust_n = thrust_n,
                                                  .axial_stiffness_n_mm = *spec.axial_stiffness_n_mm,
                                                  .relieved_share = spec.relieved_share,
                                                  .relief_travel_mm = travel_mm});
  p.quantities.push_back({"springback_mm", jump.springback_mm, "mm", "K113.breakthrough_feed_jump",
                          "elastic travel that the machine gives back at breakthrough"});
  p.limits.push_back(
      {"springback_mm", jump.springback_mm, travel_mm, true, "mm", "K113.breakthrough_feed_jump"});
  return jump.feed_jump;
}

/// Torque peak at breakthrough over the torque at the nominal feed; none when the drill is pulled through.
struct Exit {
  double hole_time_min = 0;
  std::optional<double> load_factor;
};

Exit exit_of(const ThroughHoleDrilling& spec, double rpm, double thrust_all_n, double chisel_share,
             double point_height_mm, CutPlan& p) {
  const double zone_mm = spec.exit_zone_fraction * spec.diameter_mm;
  k113::HoleTimeInputs hole{.strategy = spec.exit_strategy,
                            .part_thickness_mm = spec.thickness_mm,
                            .point_height_mm = point_height_mm,
                            .approach_mm = spec.approach_mm,
                            .overrun_mm = spec.overrun_mm,
                            .feed_mm_rev = spec.feed_mm_rev,
                            .rpm = rpm,
                            .zone_mm = zone_mm,
                            .feed_divisor = spec.feed_divisor};
  Exit out;
  if (spec.exit_strategy != ExitStrategy::spring_exit) {
    out.hole_time_min = k113::through_hole_time(hole).main_time_min;
    const bool reduced = spec.exit_strategy != ExitStrategy::constant;
    const double feed_ratio = reduced ? 1 / spec.feed_divisor : 1;
    // The machine gives back what the thrust at the feed of the exit has stored in it.
    const auto jump =
        feed_jump(spec, thrust_all_n * std::pow(feed_ratio, spec.thrust_exp_feed), point_height_mm, p);
    if (!jump) return out;
    p.quantities.push_back({"feed_jump", *jump, "1",
                            spec.feed_jump ? "specification" : "K113.breakthrough_feed_jump",
                            "feed at breakthrough over the feed before it"});
    const double peak =
        k113::feed_jump_load_factor({.feed_jump = *jump, .exp_feed = spec.torque_exp_feed}).load_factor *
        std::pow(feed_ratio, spec.torque_exp_feed);
    // A feed reduced at the exit only has run at the nominal feed before.
    out.load_factor = spec.exit_strategy == ExitStrategy::reduced_exit ? std::max(1.0, peak) : peak;
    return out;
  }
  models::require(spec.spring_rate_n_mm.has_value(), "spring_rate_n_mm", models::Value(),
                  "is needed by exit_strategy \"spring_exit\"");
  const auto holder = k113::spring_holder_setup({.thrust_n = thrust_all_n,
                                                 .spring_rate_n_mm = *spec.spring_rate_n_mm,
                                                 .diameter_mm = spec.diameter_mm,
                                                 .half_point_angle_deg = spec.half_point_angle_deg,
                                                 .zone_fraction = spec.exit_zone_fraction,
                                                 .part_thickness_mm = spec.thickness_mm});
  p.quantities.push_back({"spring_compression_mm", holder.spring_compression_mm, "mm",
                          "K113.spring_holder_setup", "compression of the spring under the thrust"});
  p.quantities.push_back({"switch_distance_mm", holder.switch_distance_mm, "mm", "K113.spring_holder_setup",
                          "travel of the quill from full engagement to the limit switch"});
  p.limits.push_back({"spring_rate_n_mm", *spec.spring_rate_n_mm, holder.spring_rate_limit_n_mm, true, "N/mm",
                      "K113.spring_holder_setup"});
  models::require(
      holder.spring_completes != 0, "spring_rate_n_mm", *spec.spring_rate_n_mm,
      "is too stiff: the drill stalls before it is through; must be at most thrust over exit zone "
      "and point height");
  const auto exit = k113::spring_exit_phase({.feed_mm_rev = spec.feed_mm_rev,
                                             .rpm = rpm,
                                             .spring_compression_mm = holder.spring_compression_mm,
                                             .zone_mm = zone_mm,
                                             .point_height_mm = point_height_mm,
                                             .exp_feed = spec.thrust_exp_feed,
                                             .chisel_share = chisel_share,
                                             .feed_cap_ratio = spec.spring_feed_cap_ratio});
  if (!exit.total_time_min) models::reject("the spring does not finish the hole");
  hole.spring_compression_mm = holder.spring_compression_mm;
  hole.spring_time_min = *exit.total_time_min;
  out.hole_time_min = k113::through_hole_time(hole).main_time_min;
  const double after = exit.feed_ratio_after.value_or(0);
  p.quantities.push_back({"feed_jump", after, "1", "K113.spring_exit_phase",
                          "feed over the nominal feed when the chisel edge has left the metal"});
  out.load_factor = std::max(1.0, std::pow(after, spec.torque_exp_feed));
  return out;
}

double breakage(const ThroughHoleDrilling& spec, double torque_nm, const std::optional<double>& load_factor,
                double holes) {
  if (!load_factor) return 1;
  if (!spec.break_torque_nm) return 0;
  const double one =
      k113::drill_break_probability({.torque_mean_nm = torque_nm,
                                     .torque_sd_nm = spec.load_cv * torque_nm,
                                     .load_factor = *load_factor,
                                     .strength_mean_nm = *spec.break_torque_nm,
                                     .strength_sd_nm = spec.break_torque_cv * *spec.break_torque_nm})
          .break_probability;
  // 1 - (1 - p)^holes without cancellation; p = 1 ends at 1.
  return one >= 1 ? 1 : -std::expm1(holes * std::log1p(-one));
}

void strength_limits(const ThroughHoleDrilling& spec, double thrust_ratio, CutPlan& p) {
  models::require(spec.torsion_allow_mpa.has_value() == spec.overhang_mm.has_value(), "torsion_allow_mpa",
                  spec.torsion_allow_mpa ? models::Value(*spec.torsion_allow_mpa) : models::Value(),
                  "and overhang_mm must be given together");
  if (!spec.torsion_allow_mpa) return;
  const double d = spec.diameter_mm;
  const auto limits =
      k113::drill_strength_feed_limits({.diameter_mm = d,
                                        .torsion_allow_mpa = *spec.torsion_allow_mpa,
                                        .section_modulus_mm3 = section_modulus_factor * d * d * d,
                                        .torque_coefficient_nm = spec.torque_coefficient_nm,
                                        .torque_exp_diameter = spec.torque_exp_diameter,
                                        .torque_exp_feed = spec.torque_exp_feed,
                                        .elastic_modulus_mpa = drill_elastic_modulus_mpa,
                                        .inertia_mm4 = inertia_factor * d * d * d * d,
                                        .overhang_mm = *spec.overhang_mm,
                                        .length_factor = buckling_length_factor,
                                        .thrust_coefficient_n = thrust_ratio * spec.thrust_coefficient_n,
                                        .thrust_exp_diameter = spec.thrust_exp_diameter,
                                        .thrust_exp_feed = spec.thrust_exp_feed});
  constexpr const char* origin = "K113.drill_strength_feed_limits";
  const double feed_mm_rev = spec.exit_strategy == ExitStrategy::reduced_full_depth
                                 ? spec.feed_mm_rev / spec.feed_divisor
                                 : spec.feed_mm_rev;
  p.limits.push_back(
      {"feed_torsion_mm_rev", feed_mm_rev, limits.feed_torsion_mm_rev, true, "mm/rev", origin});
  p.limits.push_back(
      {"feed_buckling_mm_rev", feed_mm_rev, limits.feed_buckling_mm_rev, true, "mm/rev", origin});
}

void bushings(const ThroughHoleDrilling& spec, double drills, double strokes, CutPlan& p) {
  if (spec.bushing == DrillBushing::none) return;
  double holes = spec.bushing_holes_fixed;
  const char* origin = "COMPLETION: wear by sliding path, Weibull with cv 0.7";
  if (spec.bushing == DrillBushing::rotating) {
    const auto wear = k308::bushing_wear_ratio_slip({.slip = spec.bushing_slip,
                                                     .return_factor = spec.bushing_return_factor,
                                                     .radius_mm = spec.diameter_mm / 2,
                                                     .feed_mm_rev = spec.feed_mm_rev,
                                                     .return_feed_mm_rev = spec.return_feed_mm_rev});
    p.quantities.push_back({"bushing_wear_ratio", wear.ratio, "1", "K308.bushing_wear_ratio_slip",
                            "wear of the rotating bushing over that of a fixed one"});
    holes = k308::bushing_life({.holes_fixed = holes, .wear_ratio = wear.ratio}).holes;
    origin = "K308.bushing_life; COMPLETION: Weibull with cv 0.7";
  }
  p.quantities.push_back(
      {"bushing_life_holes", holes, "1", origin, "holes until a drill bushing is worn out"});
  // Every stroke of the head wears every bushing once.
  p.more_elements.push_back({.element = "drill bushings",
                             .law = models::LifeLawKind::weibull,
                             .mean_min = holes * p.main_time_min / strokes,
                             .cv = 0.7,
                             .origin = origin});
  p.consumables.push_back(
      {"drill_bushings", drills * strokes / holes, "1", origin, "bushings worn out by one part"});
}

}  // namespace

CutPlan plan(const ThroughHoleDrilling& given, const PlanContext& context) {
  CutPlan p;
  const ThroughHoleDrilling spec = fitted(given, p);
  const double rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  const double point_height_mm =
      spec.diameter_mm / 2 / std::tan(spec.half_point_angle_deg * std::numbers::pi / 180);
  const double drills = spec.head ? static_cast<double>(spec.head->drills) : 1;

  const PointEffect point = point_effect(spec, p);
  const Loads nominal = loads(spec, spec.feed_mm_rev, point.thrust_ratio);
  const double thrust_all_n = drills * nominal.thrust_n;
  const Exit exit = exit_of(spec, rpm, thrust_all_n, point.chisel_share, point_height_mm, p);

  double strokes = static_cast<double>(spec.holes);
  double machine_rpm = rpm;
  if (spec.head) {
    const auto& head = *spec.head;
    machine_rpm = rpm * static_cast<double>(head.gear_teeth) / static_cast<double>(head.pinion_teeth);
    const auto job = k308::multi_spindle_drilling({.depth_mm = spec.thickness_mm + point_height_mm,
                                                   .approach_mm = spec.approach_mm,
                                                   .overrun_mm = spec.overrun_mm,
                                                   .feed_mm_rev = spec.feed_mm_rev,
                                                   .machine_rpm = machine_rpm,
                                                   .pinion_teeth = head.pinion_teeth,
                                                   .gear_teeth = head.gear_teeth,
                                                   .holes = spec.holes,
                                                   .drills = head.drills,
                                                   .index_min = spec.index_min});
    strokes = static_cast<double>(job.strokes);
    if (head.centre_distance_mm) {
      const double pinion_mm = head.gear_module_mm * static_cast<double>(head.pinion_teeth);
      const double gear_mm = head.gear_module_mm * static_cast<double>(head.gear_teeth);
      const auto arms = k308::head_angle({.pinion_diameter_mm = pinion_mm,
                                          .gear_diameter_mm = gear_mm,
                                          .distance_mm = *head.centre_distance_mm});
      constexpr const char* origin = "K308.head_angle";
      p.quantities.push_back(
          {"head_angle_deg", arms.angle_deg, "deg", origin, "angle between the arms of the spindles"});
      // Both gears turn the same way: their tips must clear.
      p.limits.push_back({"centre_distance_min_mm", *head.centre_distance_mm,
                          gear_mm + 2 * head.gear_module_mm, false, "mm", origin});
      p.limits.push_back(
          {"centre_distance_max_mm", *head.centre_distance_mm, pinion_mm + gear_mm, true, "mm", origin});
    }
  }
  const double cutting_min = strokes * exit.hole_time_min;
  p.set_main_time(
      cutting_min + (strokes - 1) * spec.index_min,
      spec.head ? "K113.through_hole_time, K308.multi_spindle_drilling" : "K113.through_hole_time");

  const bool reduced_throughout = spec.exit_strategy == ExitStrategy::reduced_full_depth;
  const Loads steady =
      reduced_throughout ? loads(spec, spec.feed_mm_rev / spec.feed_divisor, point.thrust_ratio) : nominal;
  constexpr const char* torque_origin = "COMPLETION: power law of the torque, as K113.drill_thrust";
  const double power_kw = drills * steady.torque_nm * rpm / 9549.3;
  p.quantities.push_back(
      {"hole_time_min", exit.hole_time_min, "min", "K113.through_hole_time", "main time of one stroke"});
  p.quantities.push_back({"strokes", strokes, "1", spec.head ? "K308.multi_spindle_drilling" : "definition",
                          "strokes of one part"});
  p.quantities.push_back({"spindle_speed_rpm", rpm, "rpm", "definition", "speed of a drill"});
  p.quantities.push_back(
      {"point_height_mm", point_height_mm, "mm", "K113.spring_holder_setup", "height of the drill point"});
  p.quantities.push_back({"thrust_ratio", point.thrust_ratio, "1", "K111.drill_thrust_ratio",
                          "thrust over that of a standard point"});
  p.quantities.push_back({"thrust_n", steady.thrust_n, "N", "K113.drill_thrust", "thrust of one drill"});
  p.quantities.push_back({"torque_nm", steady.torque_nm, "N m", torque_origin, "torque of one drill"});
  p.quantities.push_back({"power_kw", power_kw, "kW", torque_origin, "power of all drills"});

  const double holes = static_cast<double>(spec.holes);
  p.breakage_probability = breakage(spec, nominal.torque_nm, exit.load_factor, holes);
  if (exit.load_factor)
    p.quantities.push_back({"load_factor", *exit.load_factor, "1", "K113.feed_jump_load_factor",
                            "largest torque over the torque at the nominal feed"});
  p.quantities.push_back({"breakage_probability", p.breakage_probability, "1",
                          "K113.drill_break_probability; COMPLETION: holes independent",
                          "probability of a broken drill in one part"});
  if (spec.breakage_probability_max)
    p.limits.push_back({"breakage_probability", p.breakage_probability, *spec.breakage_probability_max, true,
                        "1", "K113.drill_break_probability"});
  strength_limits(spec, point.thrust_ratio, p);

  limit_power(p, context, power_kw, torque_origin);
  limit_torque(p, context, drills * steady.torque_nm * rpm / machine_rpm, torque_origin);
  // Three standard deviations above the mean, as the paper sizes the drive.
  limit_feed_force(p, context, drills * steady.thrust_n * (1 + 3 * spec.load_cv), "K113.drill_thrust");
  limit_spindle_speed(p, context, machine_rpm, "definition");
  limit_feed_rate(p, context, rpm * spec.feed_mm_rev, "definition");

  if (context.edge != nullptr) {
    const double feed_mm_rev = reduced_throughout ? spec.feed_mm_rev / spec.feed_divisor : spec.feed_mm_rev;
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, feed_mm_rev, spec.diameter_mm / 2);
    // A life counts cutting; the main time also holds the positioning between strokes.
    p.edge->mean_min *= p.main_time_min / cutting_min;
  }
  bushings(spec, drills, strokes, p);
  return p;
}

namespace through_hole_drilling {
void add_to(Kinds& kinds) {
  kinds.add<ThroughHoleDrilling>(
      "Through holes under four exit strategies, one by one or by a multi-spindle head.",
      {"K113", "K111", "K114", "K308", "K410"});
}
}  // namespace through_hole_drilling

}  // namespace verstat::operations
