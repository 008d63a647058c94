#include "operations/kinds/ball_end_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/milling/k401_ball_end_hardened_steel_forces.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

std::vector<verstat::models::Field>
verstat::models::StructFields<verstat::operations::SurfacePatch>::fields() {
  using S = operations::SurfacePatch;
  return {need<S>(&S::area_cm2, "area_cm2", "cm2", open_low(0, 1e6), "area of the patch"),
          may<S>(&S::inclination_deg, "inclination_deg", "deg", closed(0, 90),
                 "slope against the plane across the tool axis"),
          need<S>(&S::depth_mm, "depth_mm", "mm", open_low(0, 50),
                  "depth of cut along the normal of the surface a_p")};
}

template <>
struct verstat::models::StructFields<verstat::operations::BallEndMilling> {
  static std::vector<Field> fields() {
    using S = operations::BallEndMilling;
    return {
        entries(need<S>(&S::patches, "patches", "-", no_range(), "parts of the surface, in any order"), 1,
                1000),
        need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 100), "diameter of the ball"),
        may<S>(&S::teeth, "teeth", "1", closed(1, 20), "number of teeth"),
        need<S>(&S::overhang_mm, "overhang_mm", "mm", open_low(0, 1000), "overhang of the mill"),
        may<S>(&S::modulus_mpa, "modulus_mpa", "MPa", closed(1e5, 1e6),
               "elastic modulus of the mill; carbide 580000 to 620000"),
        need<S>(&S::spindle_speed_rpm, "spindle_speed_rpm", "rpm", open_low(0, 2e5), "spindle speed"),
        need<S>(&S::feed_per_tooth_mm, "feed_per_tooth_mm", "mm", open_low(0, 2), "feed per tooth f_z"),
        need<S>(&S::step_over_mm, "step_over_mm", "mm", open_low(0, 50), "distance of the rows a_e"),
        may<S>(&S::feed, "feed", "-", no_range(), "how the feed follows the force limits"),
        may<S>(&S::force_model, "force_model", "-", no_range(), "where the forces come from"),
        may<S>(&S::relief_deg, "relief_deg", "deg", closed(6, 18), "regression: relief angle"),
        may<S>(&S::hardness_hrc, "hardness_hrc", "HRC", closed(40, 55), "regression: hardness of the part"),
        may<S>(&S::helix_deg, "helix_deg", "deg", open(-80, 80), "energy: helix angle"),
        may<S>(&S::normal_rake_deg, "normal_rake_deg", "deg", closed(-45, 45), "energy: normal rake"),
        may<S>(&S::mode, "mode", "-", no_range(), "energy: climb (down), conventional (up) or slot"),
        may<S>(&S::stress_scale, "stress_scale", "1", open_low(0, 100),
               "energy: measured over computed force, of the material"),
        may<S>(&S::feed_force_max_n, "feed_force_max_n", "N", above(0), "allowed force along the feed"),
        may<S>(&S::axial_force_max_n, "axial_force_max_n", "N", above(0),
               "allowed push-off force along the tool axis"),
        may<S>(&S::normal_force_max_n, "normal_force_max_n", "N", above(0),
               "allowed force across the feed in the plane of rotation"),
        may<S>(&S::form_error_max_um, "form_error_max_um", "um", above(0),
               "allowed error normal to the surface from bending of the mill"),
        may<S>(&S::scallop_max_um, "scallop_max_um", "um", above(0), "allowed height between rows")};
  }
};

namespace verstat::operations {

namespace k401 = models::k401;
namespace k406 = models::k406;

namespace {

constexpr double smallest_feed_mm = 0.04;  // of the explored box
// The largest feed meets its force limit to rounding: a hair above the limit is met.
constexpr double rounding = 1 + 1e-9;

struct ToolForce {
  double feed_n = 0, normal_n = 0, axial_n = 0;
  double in_plane_n = 0;
  double power_kw = 0;  // energy model only
};

// Largest values met on any patch.
struct Extremes {
  ToolForce force;
  double deflection_um = 0;
  double form_error_um = 0;
  double speed_m_min = 0;
  double power_kw = 0;
  double feed_low_mm = 0, feed_high_mm = 0;
};

void within_box(const char* name, double value, double low, double high) {
  if (value < low || value > high)
    models::require(false, name, value,
                    "outside the regime that the regressions explored: n 8936 to 31100 rpm, f_z 0.04 to 0.12 "
                    "mm, a_p 0.06 to 0.36 mm, a_e 0.3 to 0.6 mm; force_model \"energy\" has no such box");
}

void check(const BallEndMilling& spec) {
  if (spec.force_model == BallForceModel::energy) {
    models::require(spec.feed == BallFeed::given, "feed", models::detail::Binding<BallFeed>::write(spec.feed),
                    "the energy model takes the feed as given; only force_model \"regression\" can limit it");
    return;
  }
  within_box("spindle_speed_rpm", spec.spindle_speed_rpm, 8936, 31'100);
  within_box("feed_per_tooth_mm", spec.feed_per_tooth_mm, smallest_feed_mm, 0.12);
  within_box("step_over_mm", spec.step_over_mm, 0.3, 0.6);
  for (const SurfacePatch& patch : spec.patches) within_box("depth_mm", patch.depth_mm, 0.06, 0.36);
  if (spec.feed == BallFeed::given) return;
  if (!spec.feed_force_max_n || !spec.axial_force_max_n || !spec.normal_force_max_n)
    models::reject(
        "a feed limited by force needs feed_force_max_n, axial_force_max_n and normal_force_max_n");
}

k401::CutWidth cut_of(const BallEndMilling& spec, double depth_mm) {
  return {spec.spindle_speed_rpm, depth_mm, spec.step_over_mm, spec.relief_deg, spec.hardness_hrc};
}

// Where no feed of the box keeps the limits, the smallest one: the limits of the plan then say so.
double limited_feed_mm(const BallEndMilling& spec, double depth_mm) {
  k401::LimitedCut cut;
  static_cast<k401::CutWidth&>(cut) = cut_of(spec, depth_mm);
  cut.px_max_n = *spec.feed_force_max_n;
  cut.py_max_n = *spec.axial_force_max_n;
  cut.pz_max_n = *spec.normal_force_max_n;
  const k401::LargestFeed largest = k401::max_feed_for_force_limits(cut);
  return largest.feasible ? std::min(spec.feed_per_tooth_mm, largest.feed_mm_tooth) : smallest_feed_mm;
}

ToolForce force_on(const BallEndMilling& spec, double depth_mm, double feed_mm) {
  if (spec.force_model == BallForceModel::regression) {
    k401::BallEndCut cut;
    static_cast<k401::CutWidth&>(cut) = cut_of(spec, depth_mm);
    cut.feed_mm_tooth = feed_mm;
    const k401::BallEndForces f = k401::ball_end_forces(cut);
    return {f.feed_n, f.normal_n, f.push_off_n, f.in_plane_n, 0};
  }
  k406::BallEndMillTurn turn;
  turn.diameter_mm = spec.diameter_mm;
  turn.helix_deg = spec.helix_deg;
  turn.teeth = spec.teeth;
  turn.normal_rake_deg = spec.normal_rake_deg;
  turn.spindle_rpm = spec.spindle_speed_rpm;
  turn.feed_mm_tooth = feed_mm;
  turn.depth_mm = depth_mm;
  turn.step_over_mm = spec.step_over_mm;
  turn.mode = spec.mode;
  turn.stress_scale = spec.stress_scale;
  const k406::ForceSummary f = k406::ball_end_force_summary(turn);
  const double x = std::abs(f.x_peak_n);
  const double y = std::abs(f.y_peak_n);
  return {x, y, std::abs(f.z_peak_n), std::hypot(x, y), f.power_mean_kw};
}

// Largest force along the slope and across the tool axis once the patch is inclined; the maxima have no
// sign, so both senses of the axial force are tried.
struct AcrossAxis {
  double along_slope_n;
  double resultant_n;
};

AcrossAxis across_axis(const ToolForce& force, double inclination_deg) {
  AcrossAxis worst{0, 0};
  for (const double sense : {1.0, -1.0}) {
    const k406::MachineForces f =
        k406::rotate_forces({force.feed_n, force.normal_n, sense * force.axial_n, inclination_deg, 0});
    worst.along_slope_n = std::max(worst.along_slope_n, std::abs(f.x_n));
    worst.resultant_n = std::max(worst.resultant_n, std::hypot(f.x_n, f.y_n));
  }
  return worst;
}

void raise(double& largest, double value) {
  largest = std::max(largest, value);
}

}  // namespace

CutPlan plan(const BallEndMilling& spec, const PlanContext& context) {
  check(spec);
  double common_feed_mm = spec.feed_per_tooth_mm;
  if (spec.feed == BallFeed::constant)
    for (const SurfacePatch& patch : spec.patches)
      common_feed_mm = std::min(common_feed_mm, limited_feed_mm(spec, patch.depth_mm));

  Extremes most;
  most.feed_low_mm = spec.feed_per_tooth_mm;
  double time_min = 0;
  double wear = 0;  // edge lives spent on one part
  ElementLife life;
  double scallop_um = 0;
  for (const SurfacePatch& patch : spec.patches) {
    const double feed_mm =
        spec.feed == BallFeed::patchwise ? limited_feed_mm(spec, patch.depth_mm) : common_feed_mm;
    k401::BallFinishing finishing;
    finishing.spindle_rpm = spec.spindle_speed_rpm;
    finishing.feed_mm_tooth = feed_mm;
    finishing.teeth = spec.teeth;
    finishing.depth_mm = patch.depth_mm;
    finishing.step_over_mm = spec.step_over_mm;
    finishing.diameter_mm = spec.diameter_mm;
    const k401::FinishingRates rates = k401::ball_finishing_rates(finishing);
    const double patch_min = patch.area_cm2 / rates.area_cm2_min;
    time_min += patch_min;
    scallop_um = rates.scallop_um;

    k406::InclinedBall ball;
    ball.diameter_mm = spec.diameter_mm;
    ball.spindle_rpm = spec.spindle_speed_rpm;
    ball.depth_mm = patch.depth_mm;
    ball.surface_deg = patch.inclination_deg;
    const double speed_m_min = k406::inclined_ball_speed(ball).speed_m_min;

    const ToolForce force = force_on(spec, patch.depth_mm, feed_mm);
    const AcrossAxis across = across_axis(force, patch.inclination_deg);
    k401::Overhang bending;
    bending.force_n = across.resultant_n;
    bending.diameter_mm = spec.diameter_mm;
    bending.overhang_mm = spec.overhang_mm;
    bending.modulus_mpa = spec.modulus_mpa;
    const double deflection_um = k401::tool_deflection(bending).deflection_um;
    const double sine = std::sin(patch.inclination_deg * std::numbers::pi / 180);

    raise(most.force.feed_n, force.feed_n);
    raise(most.force.normal_n, force.normal_n);
    raise(most.force.axial_n, force.axial_n);
    raise(most.force.in_plane_n, force.in_plane_n);
    raise(most.deflection_um, deflection_um);
    if (across.resultant_n > 0)
      raise(most.form_error_um, deflection_um * across.along_slope_n / across.resultant_n * sine);
    raise(most.speed_m_min, speed_m_min);
    raise(most.power_kw, spec.force_model == BallForceModel::regression
                             ? k401::power_bound({force.in_plane_n, speed_m_min}).power_kw
                             : force.power_kw);
    most.feed_low_mm = std::min(most.feed_low_mm, feed_mm);
    raise(most.feed_high_mm, feed_mm);
    if (context.edge != nullptr) {
      life = taylor_life(*context.edge, speed_m_min, feed_mm, patch.depth_mm);
      wear += patch_min / life.mean_min;
    }
  }

  const bool regression = spec.force_model == BallForceModel::regression;
  const char* force_origin = regression ? "K401.ball_end_forces" : "K406.ball_end_force_summary";
  const double feed_mm_min = spec.spindle_speed_rpm * static_cast<double>(spec.teeth) * most.feed_high_mm;
  CutPlan p;
  p.quantities.reserve(16);
  p.set_main_time(time_min, "K401.ball_finishing_rates");
  p.quantities.push_back({"feed_low_mm", most.feed_low_mm, "mm",
                          spec.feed == BallFeed::given ? "given" : "K401.max_feed_for_force_limits",
                          "smallest feed per tooth on the surface"});
  p.quantities.push_back({"feed_high_mm", most.feed_high_mm, "mm",
                          spec.feed == BallFeed::given ? "given" : "K401.max_feed_for_force_limits",
                          "largest feed per tooth on the surface"});
  p.quantities.push_back(
      {"feed_force_n", most.force.feed_n, "N", force_origin, "largest force along the feed"});
  p.quantities.push_back({"normal_force_n", most.force.normal_n, "N", force_origin,
                          "largest force across the feed in the plane of rotation"});
  p.quantities.push_back(
      {"axial_force_n", most.force.axial_n, "N", force_origin, "largest push-off force along the axis"});
  p.quantities.push_back({"in_plane_force_n", most.force.in_plane_n, "N", force_origin,
                          "largest force in the plane of rotation, upper bound"});
  p.quantities.push_back({"deflection_um", most.deflection_um, "um", "K401.tool_deflection",
                          "largest bending of the mill on the inclined patches, K406.rotate_forces"});
  p.quantities.push_back({"form_error_um", most.form_error_um, "um", "COMPLETION: bending along the normal",
                          "largest error normal to the surface"});
  p.quantities.push_back(
      {"scallop_um", scallop_um, "um", "K401.ball_finishing_rates", "height between rows"});
  p.quantities.push_back({"cutting_speed_m_min", most.speed_m_min, "m/min", "K406.inclined_ball_speed",
                          "largest effective cutting speed"});
  p.quantities.push_back({"cutting_power_kw", most.power_kw, "kW",
                          regression ? "K401.power_bound" : "K406.ball_end_force_summary",
                          "largest cutting power"});

  const auto limit = [&](const char* name, double value, const std::optional<double>& allowed,
                         const char* unit, const char* origin) {
    if (allowed) p.limits.push_back({name, value, *allowed, true, unit, origin});
  };
  const auto force_limit = [&](const char* name, double value_n, const std::optional<double>& allowed_n) {
    if (allowed_n) p.limits.push_back({name, value_n, *allowed_n * rounding, true, "N", force_origin});
  };
  force_limit("feed_force_n", most.force.feed_n, spec.feed_force_max_n);
  force_limit("axial_force_n", most.force.axial_n, spec.axial_force_max_n);
  force_limit("normal_force_n", most.force.normal_n, spec.normal_force_max_n);
  limit("form_error_um", most.form_error_um, spec.form_error_max_um, "um",
        "COMPLETION: bending along the normal");
  limit("scallop_um", scallop_um, spec.scallop_max_um, "um", "K401.ball_finishing_rates");
  p.spindle.teeth = spec.teeth;
  p.spindle.normal_force_n = most.force.normal_n;
  MachineLoad load;
  load.power_kw = most.power_kw;
  load.spindle_speed_rpm = spec.spindle_speed_rpm;
  load.feed_rate_mm_min = feed_mm_min;
  add_machine_limits(p, context, load);

  if (context.edge != nullptr) {
    // Patches of different speed and feed wear the edge one after the other: shares of life add up.
    life.mean_min = time_min / wear;
    p.edge = life;
  }
  return p;
}

namespace ball_end_milling {
void add_to(Kinds& kinds) {
  kinds.add<BallEndMilling>("A surface finished with a ball-end mill, patch by patch.", {"K401", "K406"});
}
}  // namespace ball_end_milling

}  // namespace verstat::operations
