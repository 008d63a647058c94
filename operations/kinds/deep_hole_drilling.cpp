#include "operations/kinds/deep_hole_drilling.h"

#include "models/life/k120_deep_hole_guide_pads.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::DeepHoleDrilling> {
  static std::vector<Field> fields() {
    using S = operations::DeepHoleDrilling;
    return {
        need<S>(&S::hole_diameter_mm, "hole_diameter_mm", "mm", closed(1, 1000), "diameter of the hole"),
        need<S>(&S::hole_length_mm, "hole_length_mm", "mm", closed(1, 1e5), "length of the hole"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1000),
                "cutting speed at the diameter"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 5), "feed"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "approach and overrun"),
        need<S>(&S::pad_wear_a_mm_m_b, "pad_wear_a_mm_m_b", "mm/m^b", open_low(0, 10),
                "a of the pad wear a L^b + c"),
        need<S>(&S::pad_wear_b, "pad_wear_b", "1", closed(0.1, 4), "b of the pad wear"),
        may<S>(&S::pad_wear_c_mm, "pad_wear_c_mm", "mm", closed(-1, 1), "c of the pad wear"),
        need<S>(&S::pad_shift_m, "pad_shift_m", "m", closed(0, 1e4),
                "drilled length by which each pad point follows its predecessor"),
        may<S>(&S::pad_critical_wear_mm, "pad_critical_wear_mm", "mm", open_low(0, 1),
               "radial wear at which the contact jumps back along the pad"),
        may<S>(&S::pad_trace_wear_mm, "pad_trace_wear_mm", "mm", open_low(0, 1),
               "radial wear that marks a pad point"),
        may<S>(&S::pad_life_cv, "pad_life_cv", "1", closed(0.05, 2), "coefficient of variation of pad life"),
        may<S>(&S::pad_criterion, "pad_criterion", "-", no_range(), "when the pads are replaced"),
        may<S>(&S::specific_cutting_force_mpa, "specific_cutting_force_mpa", "MPa", open_low(0, 1e5),
               "specific cutting force"),
        may<S>(&S::diameter_loss_max_mm, "diameter_loss_max_mm", "mm", open_low(0, 10),
               "largest loss of diameter over the pads until they are replaced")};
  }
};

namespace verstat::operations {

CutPlan plan(const DeepHoleDrilling& spec, const PlanContext& context) {
  namespace k120 = models::k120;
  const double hole_m = spec.hole_length_mm / 1000;
  const double travel_m = hole_m + spec.approach_mm / 1000;
  const auto time = k120::deep_drilling_time({.hole_diameter_mm = spec.hole_diameter_mm,
                                              .drilled_length_m = travel_m,
                                              .cutting_speed_m_min = spec.cutting_speed_m_min,
                                              .feed_mm_rev = spec.feed_mm_rev});
  CutPlan p;
  p.set_main_time(time.time_min, "K120.deep_drilling_time");
  p.quantities.push_back(
      {"spindle_speed_rpm", time.spindle_rpm, "rpm", "K120.deep_drilling_time", "spindle speed"});
  p.quantities.push_back(
      {"feed_rate_mm_min", time.feed_rate_mm_min, "mm/min", "K120.deep_drilling_time", "feed rate"});
  p.quantities.push_back({"pad_sliding_path_m",
                          k120::pad_sliding_path({.hole_diameter_mm = spec.hole_diameter_mm,
                                                  .drilled_length_m = hole_m,
                                                  .feed_mm_rev = spec.feed_mm_rev})
                              .path_m,
                          "m", "K120.pad_sliding_path", "path of a pad along the wall of one hole"});

  const auto life = k120::pad_life({.a_mm_m_b = spec.pad_wear_a_mm_m_b,
                                    .b = spec.pad_wear_b,
                                    .c_mm = spec.pad_wear_c_mm,
                                    .shift_per_point_m = spec.pad_shift_m,
                                    .critical_wear_mm = spec.pad_critical_wear_mm,
                                    .trace_wear_mm = spec.pad_trace_wear_mm,
                                    .hole_length_m = hole_m});
  const bool lead_in = spec.pad_criterion == PadCriterion::lead_in_lost;
  const double pads_m = lead_in ? life.lead_in_shift_starts_m : life.replace_at_m;
  models::require(pads_m > 0, "pad_wear_c_mm", spec.pad_wear_c_mm,
                  "wears the pads out before they drill: must be below the wear of the criterion");
  constexpr const char* origin = "K120.pad_life";
  p.quantities.push_back({"lead_in_shift_starts_m", life.lead_in_shift_starts_m, "m", origin,
                          "drilled length at which the contact begins to move along the pad"});
  p.quantities.push_back({"pad_life_m", pads_m, "m", origin, "drilled length of one set of pads"});
  p.quantities.push_back(
      {"holes_per_pad_set", pads_m / hole_m, "1", origin, "holes of one set of pads, not rounded"});
  p.limits.push_back({"holes_per_pad_set", pads_m / hole_m, 1, false, "1", origin});

  const auto effect =
      k120::pad_wear_effect({.wear_mm = k120::pad_radial_wear({.drilled_length_m = pads_m,
                                                               .a_mm_m_b = spec.pad_wear_a_mm_m_b,
                                                               .b = spec.pad_wear_b,
                                                               .c_mm = spec.pad_wear_c_mm,
                                                               .shift_m = 0})
                                            .wear_mm});
  p.quantities.push_back({"diameter_loss_mm", effect.diameter_loss_mm, "mm", "K120.pad_wear_effect",
                          "loss of diameter over the lead-in when the pads are replaced"});
  p.quantities.push_back({"insert_overhang_increase_mm", effect.insert_overhang_increase_mm, "mm",
                          "K120.pad_wear_effect", "growth of the insert overhang until then"});
  if (spec.diameter_loss_max_mm)
    p.limits.push_back({"diameter_loss_mm", effect.diameter_loss_mm, *spec.diameter_loss_max_mm, true, "mm",
                        "K120.pad_wear_effect"});
  // Pads slide as long as the head drills: metres become minutes of main time.
  p.more_elements.push_back({.element = "guide pads",
                             .law = models::LifeLawKind::weibull,
                             .mean_min = pads_m / hole_m * p.main_time_min,
                             .cv = spec.pad_life_cv,
                             .origin = "K120.pad_life; COMPLETION: Weibull in drilled metres"});
  p.consumables.push_back({"guide_pad_sets", hole_m / pads_m, "1", origin, "sets of guide pads per hole"});

  if (spec.specific_cutting_force_mpa) {
    constexpr const char* force = "COMPLETION: specific cutting force on the full section";
    // k_c A v with A = f D/2 and the mean speed v/2, in W for N/mm2, mm2 and m/min over 60.
    const double power_kw = *spec.specific_cutting_force_mpa * spec.feed_mm_rev * spec.hole_diameter_mm *
                            spec.cutting_speed_m_min / 240'000;
    const double torque_nm = power_kw * 9549.3 / time.spindle_rpm;
    p.quantities.push_back({"power_kw", power_kw, "kW", force, "cutting power"});
    p.quantities.push_back({"torque_nm", torque_nm, "N m", force, "torque of the head"});
    limit_power(p, context, power_kw, force);
    limit_torque(p, context, torque_nm, force);
  }
  limit_spindle_speed(p, context, time.spindle_rpm, "K120.deep_drilling_time");
  limit_feed_rate(p, context, time.feed_rate_mm_min, "K120.deep_drilling_time");
  if (context.edge != nullptr)
    p.edge =
        taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.hole_diameter_mm / 2);
  return p;
}

namespace deep_hole_drilling {
void add_to(Kinds& kinds) {
  kinds.add<DeepHoleDrilling>("A deep hole from the solid: inserts live in minutes, guide pads in metres.",
                              {"K120"});
}
}  // namespace deep_hole_drilling

}  // namespace verstat::operations
