#include "operations/kinds/thermo_friction.h"

#include <algorithm>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::ThermoFriction> {
  static std::vector<Field> fields() {
    using S = operations::ThermoFriction;
    return {
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "length of the surface"),
        need<S>(&S::part_width_mm, "part_width_mm", "mm", open_low(0, 1e4), "width of the surface"),
        need<S>(&S::stock_mm, "stock_mm", "mm", open_low(0, 1000), "stock"),
        may<S>(&S::steel, "steel", "-", no_range(), "steel"),
        need<S>(&S::disc_width_mm, "disc_width_mm", "mm", open_low(0, 1000),
                "width of a pass (published 60 to 70 and 80 to 100)"),
        may<S>(&S::overlap_mm, "overlap_mm", "mm", closed(0, 1000), "overlap of neighbouring passes"),
        may<S>(&S::run_in_out_mm, "run_in_out_mm", "mm", closed(0, 1e4), "run-in and run-out"),
        need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", open_low(0, 100),
                "depth of a pass (published 1 to 2.5)"),
        need<S>(&S::feed_mm_min, "feed_mm_min", "mm/min", open_low(0, 1e5), "feed (published 100 to 315)"),
        need<S>(&S::spindle_speed_rpm, "spindle_speed_rpm", "rpm", open_low(0, 1e5),
                "speed of the disc (published 1600 to 2500)"),
        may<S>(&S::disc_diameter_mm, "disc_diameter_mm", "mm", open_low(0, 5000), "diameter of the disc"),
        may<S>(&S::specific_energy_j_mm3, "specific_energy_j_mm3", "J/mm3", open_low(0, 1000),
               "energy per volume removed: adds the power"),
        may<S>(&S::drive_power_kw, "drive_power_kw", "kW", open_low(0, 1e4), "power of the drive"),
        may<S>(&S::efficiency, "efficiency", "1", open_low(0, 1), "efficiency of the drive"),
        may<S>(&S::roughness_rz_um, "roughness_rz_um", "um", closed(0, 1000),
               "Rz left behind (published 40 to 80)"),
        may<S>(&S::hardening_factor, "hardening_factor", "1", closed(1, 5),
               "hardness of the surface over that of the core (published 1.3 to 1.5)"),
        may<S>(&S::hardened_depth_um, "hardened_depth_um", "um", closed(0, 5000),
               "depth of the hardened layer (published 500)"),
        may<S>(&S::stress_level, "stress_level", "1", closed(0, 1),
               "place within the published residual stresses: 0 mild, 1 severe"),
        may<S>(&S::hardened_layer, "hardened_layer", "-", no_range(),
               "whether the next operation removes or keeps the hardened layer"),
        may<S>(&S::positioning_error_um, "positioning_error_um", "um", closed(0, 1e4),
               "positioning error of the next operation"),
        may<S>(&S::next_allowance_mm, "next_allowance_mm", "mm", closed(0, 100),
               "allowance that the next operation takes"),
        may<S>(&S::surface_stress_max_mpa, "surface_stress_max_mpa", "MPa", closed(-5000, 5000),
               "largest residual stress at the surface, tension positive")};
  }
};

namespace verstat::operations {

namespace {

namespace k305 = models::k305;

constexpr const char* ranges = "K305.published_ranges";

void within(CutPlan& p, const char* low_name, const char* high_name, double value, k305::Quantity quantity,
            const char* unit) {
  const auto range = k305::published_ranges({quantity});
  p.limits.push_back({low_name, value, range.low, false, unit, ranges});
  p.limits.push_back({high_name, value, range.high, true, unit, ranges});
}

/// The regimes that were tried; between the two bands of width nothing is known.
void envelope(const ThermoFriction& spec, double width_mm, CutPlan& p) {
  const bool narrow = width_mm <= k305::published_ranges({k305::Quantity::width_low_band}).high;
  within(p, "published_depth_min_mm", "published_depth_max_mm", spec.depth_of_cut_mm, k305::Quantity::depth,
         "mm");
  within(p, "published_spindle_speed_min_rpm", "published_spindle_speed_max_rpm", spec.spindle_speed_rpm,
         k305::Quantity::spindle, "rpm");
  within(p, "published_width_min_mm", "published_width_max_mm", width_mm,
         narrow ? k305::Quantity::width_low_band : k305::Quantity::width_high_band, "mm");
  within(p, "published_feed_min_mm_min", "published_feed_max_mm_min", spec.feed_mm_min,
         narrow ? k305::Quantity::feed_low_band : k305::Quantity::feed_high_band, "mm/min");
  const int inside = k305::regime_in_envelope({.width_mm = width_mm,
                                               .depth_mm = spec.depth_of_cut_mm,
                                               .feed_mm_min = spec.feed_mm_min,
                                               .spindle_rpm = spec.spindle_speed_rpm})
                         .in_envelope;
  p.quantities.push_back({"in_envelope", static_cast<double>(inside), "1", "K305.regime_in_envelope",
                          "1: the regime lies within the published ranges"});
  const auto widths_low = k305::published_ranges({k305::Quantity::width_low_band}).low;
  const auto widths_high = k305::published_ranges({k305::Quantity::width_high_band}).high;
  const auto depths = k305::published_ranges({k305::Quantity::depth});
  if (width_mm >= widths_low && width_mm <= widths_high && spec.depth_of_cut_mm >= depths.low &&
      spec.depth_of_cut_mm <= depths.high) {
    const double feed_mm_min =
        k305::feed_limit({.width_mm = width_mm, .depth_mm = spec.depth_of_cut_mm}).feed_mm_min;
    p.quantities.push_back({"feed_limit_mm_min", feed_mm_min, "mm/min", "K305.feed_limit",
                            "for this width and depth; the printed feeds look like the drive's limit"});
    // The corners that the limit runs through are published regimes: they pass in spite of rounding.
    p.limits.push_back(
        {"feed_mm_min", spec.feed_mm_min, feed_mm_min * (1 + 1e-12), true, "mm/min", "K305.feed_limit"});
  }
}

void power(const ThermoFriction& spec, const PlanContext& context, double width_mm, CutPlan& p) {
  k305::RemovalInputs in;
  in.width_mm = width_mm;
  in.depth_mm = spec.depth_of_cut_mm;
  in.feed_mm_min = spec.feed_mm_min;
  in.specific_energy_j_mm3 = spec.specific_energy_j_mm3.value_or(1);  // its place when no power is asked
  in.drive_power_kw = spec.drive_power_kw;
  in.efficiency = spec.efficiency;
  const auto removal = k305::removal_and_power(in);
  constexpr const char* origin = "K305.removal_and_power";
  p.quantities.push_back(
      {"removal_rate_mm3_min", removal.removal_mm3_min, "mm3/min", origin, "volume removed"});
  p.quantities.push_back({"energy_limit_j_mm3", removal.energy_limit_j_mm3, "J/mm3", origin,
                          "specific energy that loads the drive fully"});
  if (!spec.specific_energy_j_mm3) return;
  p.quantities.push_back({"power_kw", removal.power_kw, "kW", origin, "cutting power"});
  p.limits.push_back(
      {"drive_power_kw", removal.power_kw, spec.drive_power_kw * spec.efficiency, true, "kW", origin});
  limit_power(p, context, removal.power_kw / spec.efficiency, origin);
}

/// The surface that the next operation receives.
void state_handed_on(const ThermoFriction& spec, CutPlan& p) {
  const auto add = [&](const char* name, double value, const char* unit, const char* origin,
                       const char* meaning) {
    p.quantities.push_back({name, value, unit, origin, meaning});
  };
  const auto surface = k305::surface_temperature({spec.steel});
  add("surface_temperature_low_c", surface.low_c, "degC", "K305.surface_temperature", "least of the range");
  add("surface_temperature_high_c", surface.high_c, "degC", "K305.surface_temperature", "most of the range");
  add("roughness_rz_um", spec.roughness_rz_um, "um", "given", "Rz left behind");
  add("hardened_depth_um", spec.hardened_depth_um, "um", "given", "depth of the hardened layer");
  add("surface_hardness_ratio", k305::hardness_ratio({.depth_um = 0, .factor = spec.hardening_factor}).ratio,
      "1", "K305.hardness_ratio", "hardness of the surface over that of the core");
  const bool keep = spec.hardened_layer == HardenedLayer::kept;
  const double allowance_um = k305::following_allowance({.rz_um = spec.roughness_rz_um,
                                                         .hardened_depth_um = spec.hardened_depth_um,
                                                         .keep_hardened = keep,
                                                         .positioning_error_um = spec.positioning_error_um})
                                  .allowance_um;
  add("following_allowance_mm", allowance_um / 1000, "mm", "K305.following_allowance",
      "smallest allowance of the next operation");
  for (const char* left : {"roughness_rz_um", "hardened_depth_um", "surface_hardness_ratio",
                           "following_allowance_mm", "next_hardness_ratio"})
    p.leave(left);
  // What the next operation leaves under its own surface.
  add("next_hardness_ratio",
      k305::hardness_ratio({.depth_um = allowance_um, .factor = spec.hardening_factor}).ratio, "1",
      "K305.hardness_ratio", "at the surface of the next operation, over that of the core");
  if (spec.next_allowance_mm)
    p.limits.push_back({"next_allowance_mm", *spec.next_allowance_mm, allowance_um / 1000, false, "mm",
                        "K305.following_allowance"});
  const bool stress_known =
      spec.steel == k305::Steel::steel_45 || spec.steel == k305::Steel::steel_09kh15n8yu;
  if (!stress_known) return;
  const auto stress_mpa = [&](double depth_um) {
    return k305::residual_stress({.steel = spec.steel, .depth_um = depth_um, .level = spec.stress_level})
        .stress_mpa;
  };
  constexpr const char* origin = "K305.residual_stress";
  add("surface_stress_mpa", stress_mpa(0), "MPa", origin, "residual, tension positive");
  add("stress_at_25_um_mpa", stress_mpa(25), "MPa", origin, "residual, in the active layer");
  add("next_surface_stress_mpa", stress_mpa(allowance_um), "MPa", origin,
      "residual, at the surface of the next operation");
  p.leave("surface_stress_mpa");
  p.leave("next_surface_stress_mpa");
  if (spec.surface_stress_max_mpa)
    p.limits.push_back(
        {"surface_stress_mpa", stress_mpa(0), *spec.surface_stress_max_mpa, true, "MPa", origin});
}

}  // namespace

CutPlan plan(const ThermoFriction& spec, const PlanContext& context) {
  models::require(!spec.surface_stress_max_mpa || spec.steel == k305::Steel::steel_45 ||
                      spec.steel == k305::Steel::steel_09kh15n8yu,
                  "surface_stress_max_mpa", spec.surface_stress_max_mpa.value_or(0),
                  "is known for the steels 45 and 09Kh15N8Yu only");
  CutPlan p;
  const auto time = k305::pass_time({.length_mm = spec.length_mm,
                                     .part_width_mm = spec.part_width_mm,
                                     .disc_width_band_mm = spec.disc_width_mm,
                                     .overlap_mm = spec.overlap_mm,
                                     .run_in_out_mm = spec.run_in_out_mm,
                                     .stock_mm = spec.stock_mm,
                                     .depth_mm = spec.depth_of_cut_mm,
                                     .feed_mm_min = spec.feed_mm_min});
  p.set_main_time(time.main_time_min, "K305.pass_time");
  p.quantities.push_back({"passes", static_cast<double>(time.passes), "1", "K305.pass_time",
                          "rows over the width times layers over the stock"});
  const double rim_m_s =
      k305::disc_speed({.diameter_mm = spec.disc_diameter_mm, .spindle_rpm = spec.spindle_speed_rpm})
          .speed_m_s;
  p.quantities.push_back({"disc_speed_m_s", rim_m_s, "m/s", "K305.disc_speed", "of the rim"});
  p.quantities.push_back(
      {"compression_trend", static_cast<double>(k305::compressive_stress_trend({rim_m_s}).trend), "1",
       "K305.compressive_stress_trend", "of compressive stress with disc speed: -1 falls, 1 rises"});
  const double width_mm = std::min(spec.part_width_mm, spec.disc_width_mm);
  envelope(spec, width_mm, p);
  power(spec, context, width_mm, p);
  state_handed_on(spec, p);
  // The card gives no life of the disc: it is the tool's own, at the rim speed and the feed per revolution.
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, 60 * rim_m_s, spec.feed_mm_min / spec.spindle_speed_rpm,
                         spec.depth_of_cut_mm);
  limit_spindle_speed(p, context, spec.spindle_speed_rpm, "given");
  limit_feed_rate(p, context, spec.feed_mm_min, "given");
  return p;
}

namespace thermo_friction {
void add_to(Kinds& kinds) {
  kinds.add<ThermoFriction>("A flat steel surface machined with a smooth rotating disc.", {"K305"});
}
}  // namespace thermo_friction

}  // namespace verstat::operations
