#include "operations/kinds/thread_rolling.h"

#include <cmath>

#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::BlankFactors> {
  static std::vector<Field> fields() {
    using S = operations::BlankFactors;
    return {
        may<S>(&S::form, "form", "1", closed(0.1, 10), "K1: error of form"),
        may<S>(&S::hardness, "hardness", "1", closed(0.1, 10), "K2: hardness"),
        may<S>(&S::diameter, "diameter", "1", closed(0.1, 10), "K3: diameter above that of a full profile"),
        may<S>(&S::location, "location", "1", closed(0.1, 10), "K4: location between the rollers")};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::ThreadRolling> {
  static std::vector<Field> fields() {
    using S = operations::ThreadRolling;
    return {
        need<S>(&S::pitch_mm, "pitch_mm", "mm", open_low(0, 100), "pitch of the thread"),
        may<S>(&S::half_angle_deg, "half_angle_deg", "deg", open(0, 89), "half angle of the profile"),
        may<S>(&S::tip_flat_mm, "tip_flat_mm", "mm", closed(0, 100), "flat tip of the roller's ridges"),
        may<S>(&S::tip_radius_mm, "tip_radius_mm", "mm", closed(0, 50), "tip radius; above 0: no flat"),
        need<S>(&S::profile_height_mm, "profile_height_mm", "mm", open_low(0, 100), "height of the profile"),
        may<S>(&S::half_tolerance_mm, "half_tolerance_mm", "mm", closed(0, 10), "half its tolerance"),
        need<S>(&S::minor_diameter_mm, "minor_diameter_mm", "mm", open_low(0, 2000), "minor diameter"),
        need<S>(&S::roller_diameter_mm, "roller_diameter_mm", "mm", open_low(0, 2000), "roller diameter"),
        may<S>(&S::rollers, "rollers", "1", closed(1, 4), "number of rollers"),
        entries(need<S>(&S::lead_in_drop_mm, "lead_in_drop_mm", "mm", closed(0, 100),
                        "how far each lead-in ridge stands below the sizing ridges, falling"),
                1, 1000),
        may<S>(&S::sizing_turns, "sizing_turns", "1", closed(1, 1000), "sizing ridges in contact"),
        need<S>(&S::rolling_speed_m_min, "rolling_speed_m_min", "m/min", open_low(0, 1000), "rolling speed"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", open_low(0, 10),
                "radial feed per revolution of the blank"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "approach of the roller"),
        may<S>(&S::sizing_revolutions, "sizing_revolutions", "1", closed(0, 1000),
               "revolutions of the blank at full depth"),
        may<S>(&S::handling_min, "handling_min", "min", closed(0, 1000), "loading and unloading"),
        may<S>(&S::blanks, "blanks", "-", no_range(), "quality of the blanks over that of good ones"),
        may<S>(&S::force_base, "force_base", "kN/mm^n", open_low(0, 1000),
               "force coefficient of good blanks"),
        may<S>(&S::blank_diameter_mm, "blank_diameter_mm", "mm", open_low(0, 2000),
               "diameter of the blanks; not given: that of a full profile"),
        may<S>(&S::blank_tolerance_mm, "blank_tolerance_mm", "mm", open_low(0, 10),
               "allowed difference from the diameter of a full profile"),
        may<S>(&S::radial_force_max_kn, "radial_force_max_kn", "kN", open_low(0, 1e5),
               "largest radial force of the machine"),
        may<S>(&S::strength, "strength", "-", no_range(), "strength that is compared with a cut thread"),
        may<S>(&S::strength_factor_min, "strength_factor_min", "1", closed(1, 10),
               "strength the part needs over that of a cut thread")};
  }
};

namespace verstat::operations {

namespace k407 = models::k407;

CutPlan plan(const ThreadRolling& spec, const PlanContext& context) {
  const k407::RidgeShape ridge{spec.pitch_mm, spec.half_angle_deg, spec.tip_flat_mm, spec.tip_radius_mm};
  k407::ThreadProfile profile;
  static_cast<k407::RidgeShape&>(profile) = ridge;
  profile.profile_height_mm = spec.profile_height_mm;
  profile.half_tolerance_mm = spec.half_tolerance_mm;
  profile.minor_diameter_mm = spec.minor_diameter_mm;
  const auto sizing = k407::calibrating_penetration(profile);
  const double blank_mm = spec.blank_diameter_mm.value_or(sizing.blank_exact_mm);

  k407::RidgeSequence sequence;
  static_cast<k407::RidgeShape&>(sequence) = ridge;
  sequence.drops_mm = spec.lead_in_drop_mm;
  sequence.sizing_depth_mm = sizing.penetration_mm;
  sequence.blank_radius_mm = blank_mm / 2;
  sequence.roller_radius_mm = spec.roller_diameter_mm / 2;
  sequence.sizing_turns = spec.sizing_turns;
  const auto turns = k407::turn_sequence(sequence);
  const double coefficient =
      k407::force_coefficient({spec.blanks.form, spec.blanks.hardness, spec.blanks.diameter,
                               spec.blanks.location, spec.force_base})
          .coefficient;
  k407::RollingZone zone;
  zone.layer_mm = turns.layer_mm;
  zone.perimeter_mean_mm = turns.perimeter_mean_mm;
  zone.arc_mean_mm = turns.arc_mean_mm;
  zone.sizing_perimeter_mm = turns.sizing_perimeter_mm;
  zone.coefficient = coefficient;
  const auto force = k407::rolling_radial_force(zone);
  const auto drive = k407::rolling_drive({.radial_kn = force.radial_kn,
                                          .roller_diameter_mm = spec.roller_diameter_mm,
                                          .speed_m_min = spec.rolling_speed_m_min,
                                          .rollers = spec.rollers});
  const auto cycle = k407::plunge_cycle_time({.sizing_depth_mm = sizing.penetration_mm,
                                              .approach_mm = spec.approach_mm,
                                              .feed_mm_rev = spec.feed_mm_rev,
                                              .sizing_revolutions = spec.sizing_revolutions,
                                              .speed_m_min = spec.rolling_speed_m_min,
                                              .blank_diameter_mm = blank_mm,
                                              .roller_diameter_mm = spec.roller_diameter_mm,
                                              .handling_min = spec.handling_min});
  const auto strength = k407::rolled_thread_strength({spec.strength});

  CutPlan p;
  p.quantities.reserve(20);
  p.set_main_time(cycle.rolling_min, "K407.plunge_cycle_time");
  auto& q = p.quantities;
  q.push_back({"cycle_min", cycle.cycle_min, "min", "K407.plunge_cycle_time", "rolling with handling"});
  q.push_back({"full_profile_blank_mm", sizing.blank_exact_mm, "mm", "K407.calibrating_penetration",
               "blank that fills the profile, equal ring volumes"});
  q.push_back({"penetration_mm", sizing.penetration_mm, "mm", "K407.calibrating_penetration",
               "of the sizing ridges"});
  q.push_back({"layer_mm", turns.layer_mm, "mm", "K407.turn_sequence", "displaced layer of a lead-in ridge"});
  q.push_back({"contact_area_mm2", turns.contact_area_mm2, "mm2", "K407.turn_sequence", "contact area"});
  q.push_back({"force_coefficient", coefficient, "kN/mm^n", "K407.force_coefficient", "of these blanks"});
  q.push_back({"radial_force_kn", force.radial_kn, "kN", "K407.rolling_radial_force", "on one roller"});
  q.push_back(
      {"tangential_force_kn", force.tangential_kn, "kN", "K407.rolling_radial_force", "on one roller"});
  q.push_back({"pressure_mpa", force.pressure_mpa, "MPa", "K407.rolling_radial_force", "nominal pressure"});
  q.push_back({"force_fit_applies", force.in_range ? 1.0 : 0.0, "1", "K407.rolling_radial_force",
               "1 inside the range of the fit, else a lower estimate"});
  q.push_back({"roller_torque_nm", drive.torque_nm, "N m", "K407.rolling_drive", "of one roller"});
  q.push_back({"power_kw", drive.power_kw, "kW", "K407.rolling_drive", "of all rollers"});
  q.push_back({"blank_rpm", cycle.blank_rpm, "rpm", "K407.plunge_cycle_time", "speed of the blank"});
  q.push_back({"roller_rpm", cycle.roller_rpm, "rpm", "K407.plunge_cycle_time", "speed of the rollers"});
  q.push_back({"strength_factor_low", strength.low, "1", "K407.rolled_thread_strength",
               "strength over that of a cut thread, least"});
  q.push_back({"strength_factor_high", strength.high, "1", "K407.rolled_thread_strength", "the same, most"});
  p.limits.push_back(
      {"blank_difference_mm", std::abs(blank_mm - sizing.blank_exact_mm), spec.blank_tolerance_mm, true, "mm",
       "K407.calibrating_penetration: a thicker blank overloads, a thinner one does not fill"});
  if (spec.radial_force_max_kn)
    p.limits.push_back({"radial_force_kn", force.radial_kn, *spec.radial_force_max_kn, true, "kN",
                        "K407.rolling_radial_force"});
  if (spec.strength_factor_min)
    p.limits.push_back({"strength_factor", strength.low, *spec.strength_factor_min, false, "1",
                        "K407.rolled_thread_strength"});
  limit_power(p, context, drive.power_kw, "K407.rolling_drive");
  limit_spindle_speed(p, context, cycle.roller_rpm, "K407.plunge_cycle_time");
  limit_torque(p, context, drive.torque_nm * static_cast<double>(spec.rollers), "K407.rolling_drive");
  limit_feed_force(p, context, 1000 * force.radial_kn, "K407.rolling_radial_force");
  return p;
}

namespace thread_rolling {
void add_to(Kinds& kinds) {
  kinds.add<ThreadRolling>("An external thread rolled between rollers that plunge into the blank.", {"K407"});
}
}  // namespace thread_rolling

}  // namespace verstat::operations
