#include "operations/kinds/hard_turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/reliability/k117_rational_reliability.h"
#include "models/toolpath/k107_round_insert_notch_clashes.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

namespace verstat::models {

using operations::HardTurning;
using operations::ProfileSegment;

std::vector<Field> StructFields<ProfileSegment>::fields() {
  using S = ProfileSegment;
  return {need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "length along the generatrix"),
          need<S>(&S::slope_deg, "slope_deg", "deg", open(-90, 90),
                  "slope against the axis, positive when it rises in the direction of feed")};
}

template <>
struct StructFields<HardTurning> {
  static std::vector<Field> fields() {
    using S = HardTurning;
    return {
        need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 1e4), "mean diameter of the cut"),
        entries(need<S>(&S::segments, "segments", "-", no_range(), "straight segments in machining order"), 1,
                50),
        may<S>(&S::passes, "passes", "1", closed(1, 1000), "number of passes"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(1, 2000),
                "cutting speed v_c (published 30 to 150)"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 5),
                "feed along the generatrix (published 0.1 to 0.7)"),
        need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(1e-3, 5),
                "depth normal to the generatrix (published 0.05 to 0.25)"),
        may<S>(&S::insert_radius_mm, "insert_radius_mm", "mm", closed(2, 16), "radius of the round insert"),
        may<S>(&S::rake, "rake", "-", no_range(), "rake face of the tool"),
        may<S>(&S::tool_material, "tool_material", "-", no_range(), "material of the insert"),
        may<S>(&S::flank_wear_mm, "flank_wear_mm", "mm", closed(0, 1),
               "flank wear at which the edge is taken out"),
        may<S>(&S::cutting_time_min, "cutting_time_min", "min", closed(0, 60),
               "cutting time of the edge at which the forces are asked"),
        may<S>(&S::notch_half_width_mm, "notch_half_width_mm", "mm", closed(0, 1.9),
               "half-width of a notch along the edge"),
        may<S>(&S::persistent_edge, "persistent_edge", "-", no_range(),
               "whether the edge has already cut whole parts"),
        may<S>(&S::clash_scrap_probability, "clash_scrap_probability", "1", probability(),
               "probability of scrap when feed or depth is forbidden"),
        may<S>(&S::least_concave_radius_mm, "least_concave_radius_mm", "mm", open_low(0, 1e5),
               "smallest concave radius of the profile"),
        may<S>(&S::length_between_centres_mm, "length_between_centres_mm", "mm", open_low(0, 1e5),
               "length of the part between centres"),
        may<S>(&S::elastic_modulus_mpa, "elastic_modulus_mpa", "MPa", closed(1000, 1e6),
               "elastic modulus of the part"),
        may<S>(&S::radial_force_max_n, "radial_force_max_n", "N", open_low(0, 1e6),
               "largest radial force of the worn edge"),
        may<S>(&S::deflection_max_um, "deflection_max_um", "um", open_low(0, 1e5),
               "largest deflection of the part under the worn edge"),
        may<S>(&S::scallop_max_um, "scallop_max_um", "um", open_low(0, 1000),
               "largest theoretical height of the ridges")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k106 = models::k106;
namespace k107 = models::k107;

struct Forces {
  double radial_n;
  double main_n;
};

/// Forces of the worn edge: by its wear, or by its cutting time when that is given and says more.
Forces forces(const HardTurning& spec, const PlanContext& context, CutPlan& p) {
  k106::HardTurning regime{.speed_m_min = spec.cutting_speed_m_min,
                           .feed_mm_rev = spec.feed_mm_rev,
                           .depth_mm = spec.depth_of_cut_mm,
                           .flank_wear_mm = 0,
                           .rake = spec.rake,
                           .tool_material = spec.tool_material};
  constexpr const char* origin = "K106.hard_turning_forces";
  const auto sharp = k106::hard_turning_forces(regime);
  regime.flank_wear_mm = spec.flank_wear_mm;
  const auto worn = k106::hard_turning_forces(regime);
  p.quantities.push_back({"feed_force_n", sharp.p_x_n, "N", origin, "axial force"});
  p.quantities.push_back({"radial_force_sharp_n", sharp.p_y_n, "N", origin, "radial force of a sharp edge"});
  p.quantities.push_back({"main_force_sharp_n", sharp.p_z_n, "N", origin, "main force of a sharp edge"});
  p.quantities.push_back({"radial_force_worn_n", worn.p_y_n, "N", origin, "radial force at the wear given"});
  p.quantities.push_back({"main_force_worn_n", worn.p_z_n, "N", origin, "main force at the wear given"});
  p.quantities.push_back({"in_published_envelope", worn.in_published_envelope ? 1.0 : 0.0, "1", origin,
                          "1: regime and forces within the published ranges, 0: extrapolated"});
  if (spec.flank_wear_mm > 0) {
    const double edge_mm = k106::active_edge_length({.radius_mm = spec.insert_radius_mm,
                                                     .depth_mm = spec.depth_of_cut_mm,
                                                     .feed_mm_rev = spec.feed_mm_rev})
                               .length_mm;
    p.quantities.push_back({"flank_pressure_mpa",
                            k106::flank_contact_pressure({.force_growth_n = worn.p_y_n - sharp.p_y_n,
                                                          .flank_wear_mm = spec.flank_wear_mm,
                                                          .edge_length_mm = edge_mm})
                                .pressure_mpa,
                            "MPa", "K106.flank_contact_pressure", "contact pressure on the worn flank"});
  }
  if (spec.radial_force_max_n) {
    // (C1) is linear in wear: one worn point gives the wear at which the limit is met.
    regime.flank_wear_mm = 0.1;
    const double growth_n_mm = (k106::hard_turning_forces(regime).p_y_n - sharp.p_y_n) / 0.1;
    p.quantities.push_back({"wear_at_force_limit_mm",
                            std::max(0.0, (*spec.radial_force_max_n - sharp.p_y_n) / growth_n_mm), "mm",
                            origin, "flank wear at which the radial force meets its limit"});
  }
  Forces worst{worn.p_y_n, worn.p_z_n};
  if (spec.cutting_time_min) {
    const auto growth = k106::force_growth_with_time({.cutting_time_min = *spec.cutting_time_min});
    constexpr const char* by_time = "K106.force_growth_with_time";
    const Forces then{sharp.p_y_n * growth.factor_y, sharp.p_z_n * growth.factor_z};
    p.quantities.push_back(
        {"radial_force_at_time_n", then.radial_n, "N", by_time, "radial force at the cutting time given"});
    p.quantities.push_back(
        {"main_force_at_time_n", then.main_n, "N", by_time, "main force at the cutting time given"});
    worst = {std::max(worst.radial_n, then.radial_n), std::max(worst.main_n, then.main_n)};
  }
  limit_feed_force(p, context, sharp.p_x_n, origin);
  return worst;
}

/// Every pair of different slopes that can meet on the edge forbids an interval: going down by an angle the
/// tip moves towards the trailing notch (feed), going up towards the leading one (depth). Pairs of equal
/// slope are left out: there the guard only says that the feed is below the width of the notch.
void forbidden_bands(const HardTurning& spec, CutPlan& p) {
  std::vector<double> down_deg;
  std::vector<double> up_deg;
  for (std::size_t i = 0; i < spec.segments.size(); ++i)
    for (std::size_t k = spec.persistent_edge ? 0 : i + 1; k < spec.segments.size(); ++k) {
      const double turn_deg = spec.segments[k].slope_deg - spec.segments[i].slope_deg;
      if (turn_deg < 0 && turn_deg >= -90) down_deg.push_back(-turn_deg);
      if (turn_deg > 0 && turn_deg <= 90) up_deg.push_back(turn_deg);
    }
  for (auto* angles : {&down_deg, &up_deg}) {
    std::sort(angles->begin(), angles->end());
    angles->erase(std::unique(angles->begin(), angles->end()), angles->end());
  }
  for (const double omega_deg : down_deg) {
    k107::EntryBand in;
    in.radius_mm = spec.insert_radius_mm;
    in.slope_deg = omega_deg;
    in.half_width_mm = spec.notch_half_width_mm;
    const auto band = k107::forbidden_feed_interval(in);
    p.bands.push_back({"feed_mm_rev", spec.feed_mm_rev, band.low_mm_rev, band.high_mm_rev, "mm/rev",
                       "K107.forbidden_feed_interval"});
  }
  for (const double omega_deg : up_deg) {
    k107::ExitBand in;
    in.radius_mm = spec.insert_radius_mm;
    in.slope_deg = omega_deg;
    in.half_width_mm = spec.notch_half_width_mm;
    const auto band = k107::forbidden_depth_interval(in);
    p.bands.push_back({"depth_of_cut_mm", spec.depth_of_cut_mm, band.low_mm, band.high_mm, "mm",
                       "K107.forbidden_depth_interval"});
  }
}

void notches(const HardTurning& spec, CutPlan& p) {
  forbidden_bands(spec, p);
  if (std::any_of(p.bands.begin(), p.bands.end(), [](const ForbiddenBand& b) { return b.inside(); }))
    p.scrap_probability = spec.clash_scrap_probability;
  const auto angles = k107::notch_angles({.radius_mm = spec.insert_radius_mm,
                                          .feed_mm_rev = spec.feed_mm_rev,
                                          .depth_mm = spec.depth_of_cut_mm});
  p.quantities.push_back(
      {"trailing_notch_deg", angles.trail_deg, "deg", "K107.notch_angles", "from the tip of the edge"});
  p.quantities.push_back(
      {"leading_notch_deg", angles.lead_deg, "deg", "K107.notch_angles", "from the tip of the edge"});
  if (spec.segments.size() < 2) return;
  k107::Profile profile;
  profile.slopes_deg.reserve(spec.segments.size());
  for (const ProfileSegment& s : spec.segments) profile.slopes_deg.push_back(s.slope_deg);
  profile.radius_mm = spec.insert_radius_mm;
  profile.feed_mm_rev = spec.feed_mm_rev;
  profile.depth_mm = spec.depth_of_cut_mm;
  profile.half_width_mm = spec.notch_half_width_mm;
  profile.persistent = spec.persistent_edge;
  const auto clashes = k107::profile_clashes(profile);
  p.quantities.push_back({"notch_margin_deg", clashes.margin_deg, "deg", "K107.profile_clashes",
                          "smallest distance of a tip from a notch less the guard; negative: a clash"});
  p.quantities.push_back({"notch_clashes", static_cast<double>(clashes.clashes.size()), "1",
                          "K107.profile_clashes", "pairs of segments whose tip and notch meet"});
}

void surface(const HardTurning& spec, CutPlan& p) {
  const double scallop_um =
      k107::scallop_height({.radius_mm = spec.insert_radius_mm, .feed_mm_rev = spec.feed_mm_rev}).height_um;
  p.quantities.push_back(
      {"scallop_um", scallop_um, "um", "K107.scallop_height", "theoretical height of the ridges"});
  if (spec.scallop_max_um)
    p.limits.push_back({"scallop_um", scallop_um, *spec.scallop_max_um, true, "um", "K107.scallop_height"});
  if (spec.least_concave_radius_mm)
    p.limits.push_back({"least_concave_radius_mm", *spec.least_concave_radius_mm, spec.insert_radius_mm,
                        false, "mm", "K107.concave_radius_ok"});
}

void deflection(const HardTurning& spec, double radial_n, CutPlan& p) {
  if (!spec.length_between_centres_mm) return;
  constexpr const char* origin = "K106.part_deflection";
  const double deflection_um = k106::part_deflection({.p_y_n = radial_n,
                                                      .length_mm = *spec.length_between_centres_mm,
                                                      .diameter_mm = spec.diameter_mm,
                                                      .elastic_modulus_mpa = spec.elastic_modulus_mpa})
                                   .deflection_um;
  p.quantities.push_back({"deflection_um", deflection_um, "um", origin, "of the part at mid-span"});
  if (spec.deflection_max_um)
    p.limits.push_back({"deflection_um", deflection_um, *spec.deflection_max_um, true, "um", origin});
}

}  // namespace

CutPlan plan(const HardTurning& spec, const PlanContext& context) {
  using models::require;
  require(!spec.segments.empty(), "segments", models::Value::List{}, "must have at least one segment");
  require(!spec.deflection_max_um || spec.length_between_centres_mm, "deflection_max_um",
          spec.deflection_max_um.value_or(0), "needs the member \"length_between_centres_mm\"");

  models::k117::TurningPass pass;
  pass.diameter_mm = spec.diameter_mm;
  pass.length_mm = 0;
  for (const ProfileSegment& s : spec.segments) pass.length_mm += s.length_mm;
  pass.passes = static_cast<double>(spec.passes);
  pass.speed_m_min = spec.cutting_speed_m_min;
  pass.feed_mm_rev = spec.feed_mm_rev;

  CutPlan p;
  p.set_main_time(models::k117::machining_time_turning(pass).time_min, "K117.machining_time_turning");
  const double spindle_speed_rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  p.quantities.push_back({"spindle_speed_rpm", spindle_speed_rpm, "rpm", "definition", "spindle speed"});
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.depth_of_cut_mm);

  const Forces worst = forces(spec, context, p);
  const double power_kw =
      k106::cutting_power({.p_z_n = worst.main_n, .speed_m_min = spec.cutting_speed_m_min}).power_kw;
  p.quantities.push_back({"power_kw", power_kw, "kW", "K106.cutting_power", "cutting power, worn edge"});
  if (spec.radial_force_max_n)
    p.limits.push_back(
        {"radial_force_n", worst.radial_n, *spec.radial_force_max_n, true, "N", "K106.hard_turning_forces"});
  deflection(spec, worst.radial_n, p);
  surface(spec, p);
  notches(spec, p);
  // After the notches: a chattering ceramic insert is no matter of the profile. The ends chatter too.
  if (spec.tool_material == k106::ToolMaterial::ceramic &&
      k106::ceramic_chatter_risk({.speed_m_min = 80, .depth_mm = spec.depth_of_cut_mm}).risk)
    p.bands.push_back({"cutting_speed_m_min", spec.cutting_speed_m_min, std::nextafter(60.0, 0.0),
                       std::nextafter(100.0, 200.0), "m/min", "K106.ceramic_chatter_risk"});
  limit_power(p, context, power_kw, "K106.cutting_power");
  limit_torque(p, context, worst.main_n * spec.diameter_mm / 2000, "K106.hard_turning_forces");
  p.spindle.normal_force_n = worst.radial_n;
  limit_spindle_speed(p, context, spindle_speed_rpm, "definition");
  limit_feed_rate(p, context, spindle_speed_rpm * spec.feed_mm_rev, "definition");
  return p;
}

namespace hard_turning {
void add_to(Kinds& kinds) {
  kinds.add<HardTurning>("A shaped part of hardened steel turned with a round CBN or ceramic insert.",
                         {"K106", "K107", "K117"});
}
}  // namespace hard_turning

}  // namespace verstat::operations
