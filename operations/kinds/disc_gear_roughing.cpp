#include "operations/kinds/disc_gear_roughing.h"

#include <cmath>

#include "models/gears/k304_disc_cutter_roughing.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::DiscGearRoughing> {
  static std::vector<Field> fields() {
    using S = operations::DiscGearRoughing;
    return {
        need<S>(&S::module_mm, "module_mm", "mm", closed(1, 100), "module (published 8 to 20)"),
        may<S>(&S::depth_mm, "depth_mm", "mm", open_low(0, 500), "depth of the gap; without it 2.25 modules"),
        need<S>(&S::face_width_mm, "face_width_mm", "mm", open_low(0, 1e4), "face width"),
        need<S>(&S::gaps, "gaps", "1", closed(1, 10'000), "gaps of the part"),
        need<S>(&S::hardness_hb, "hardness_hb", "HB", open_low(0, 600), "Brinell hardness of the part"),
        may<S>(&S::cutters, "cutters", "1", closed(1, 2), "cutters at work at once"),
        may<S>(&S::diameter_mm, "diameter_mm", "mm", closed(10, 2000), "cutter diameter"),
        may<S>(&S::inserts_per_cutter, "inserts_per_cutter", "1", closed(1, 1000), "inserts of one cutter"),
        may<S>(&S::groups, "groups", "1", closed(1, 300), "groups of insert positions"),
        may<S>(&S::edges_per_insert, "edges_per_insert", "1", closed(1, 16), "usable edges of an insert"),
        may<S>(&S::rpm, "rpm", "rpm", open_low(0, 1e5), "cutter speed; without it the published one"),
        may<S>(&S::feed_mm_min, "feed_mm_min", "mm/min", open_low(0, 1e5),
               "feed; without it the published one"),
        need<S>(&S::return_feed_mm_min, "return_feed_mm_min", "mm/min", open_low(0, 1e6),
                "feed of the return"),
        may<S>(&S::indexing_min, "indexing_min", "min", closed(0, 1000), "indexing from gap to gap"),
        may<S>(&S::clearance_mm, "clearance_mm", "mm", closed(0, 1000), "clearance on each side"),
        may<S>(&S::full_exit, "full_exit", "-", no_range(), "whether the cutter leaves the part completely"),
        may<S>(&S::coolant, "coolant", "-", no_range(), "cutting fluid"),
        may<S>(&S::coated, "coated", "-", no_range(), "coated inserts"),
        may<S>(&S::taylor_exponent, "taylor_exponent", "1", closed(0.05, 1), "m of V T^m = const"),
        may<S>(&S::life_speed_ref_m_min, "life_speed_ref_m_min", "m/min", open_low(0, 1e4),
               "speed of the published life; without it that of the published regime"),
        may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2), "coefficient of variation of insert life"),
        may<S>(&S::allowance_mm, "allowance_mm", "mm", closed(0, 50), "left on the tooth thickness"),
        may<S>(&S::pressure_angle_deg, "pressure_angle_deg", "deg", open(0, 45), "pressure angle"),
        may<S>(&S::kc11_mpa, "kc11_mpa", "MPa", open_low(0, 1e5), "specific cutting force k_c1.1"),
        may<S>(&S::mc, "mc", "1", open_high(0, 1), "exponent m_c"),
        may<S>(&S::second_cutter_offset_deg, "second_cutter_offset_deg", "deg", closed(0, 360),
               "angle by which the second cutter leads"),
        may<S>(&S::peak_force_max_n, "peak_force_max_n", "N", open_low(0, 1e7),
               "largest peak of the tangential force")};
  }
};

namespace verstat::operations {

namespace k304 = models::k304;

CutPlan plan(const DiscGearRoughing& spec, const PlanContext& context) {
  const bool paired = spec.cutters > 1;
  const double depth_mm = spec.depth_mm.value_or(2.25 * spec.module_mm);
  std::optional<k304::Regime> published;
  if (!spec.rpm || !spec.feed_mm_min || !spec.life_speed_ref_m_min)
    published = k304::recommended_regime(
        {.module_mm = spec.module_mm, .hardness_hb = spec.hardness_hb, .paired = paired});
  const double rpm = spec.rpm ? *spec.rpm : published->rpm;
  const double feed_mm_min = spec.feed_mm_min ? *spec.feed_mm_min : published->feed_mm_min;
  const double speed_m_min =
      k304::disc_cutter_speed({.diameter_mm = spec.diameter_mm, .rpm = rpm}).cutting_speed_m_min;

  const auto travel = k304::disc_cutter_travel({.face_width_mm = spec.face_width_mm,
                                                .depth_mm = depth_mm,
                                                .diameter_mm = spec.diameter_mm,
                                                .clearance_mm = spec.clearance_mm,
                                                .full_exit = spec.full_exit});
  const auto gap = k304::gap_time({.travel_mm = travel.travel_mm,
                                   .feed_mm_min = feed_mm_min,
                                   .return_feed_mm_min = spec.return_feed_mm_min,
                                   .indexing_min = spec.indexing_min});
  const auto time =
      k304::gear_roughing_time({.per_gap_min = gap.per_gap_min, .gaps = spec.gaps, .cutters = spec.cutters});

  CutPlan p;
  p.set_main_time(time.main_time_whole_strokes_min, "K304.gear_roughing_time");
  p.quantities.push_back({"gap_time_min", gap.per_gap_min, "min", "K304.gap_time",
                          "working stroke, return and indexing of one stroke"});
  p.quantities.push_back({"gap_working_min", gap.working_min, "min", "K304.gap_time", "working stroke"});
  p.quantities.push_back(
      {"strokes", static_cast<double>(time.strokes), "1", "K304.gear_roughing_time", "strokes of one part"});
  p.quantities.push_back(
      {"rpm", rpm, "rpm", spec.rpm ? "specification" : "K304.recommended_regime", "cutter speed"});
  p.quantities.push_back({"feed_mm_min", feed_mm_min, "mm/min",
                          spec.feed_mm_min ? "specification" : "K304.recommended_regime", "feed"});
  p.quantities.push_back(
      {"cutting_speed_m_min", speed_m_min, "m/min", "K304.disc_cutter_speed", "cutting speed"});
  p.quantities.push_back(
      {"feed_mm_tooth",
       k304::disc_cutter_feeds({.feed_mm_min = feed_mm_min, .rpm = rpm, .teeth_in_line = spec.groups})
           .feed_mm_tooth,
       "mm", "K304.disc_cutter_feeds", "feed per insert of one position"});
  p.quantities.push_back(
      {"travel_mm", travel.travel_mm, "mm", "K304.disc_cutter_travel", "travel of one stroke"});
  const auto section = k304::rack_gap_section({.module_mm = spec.module_mm,
                                               .depth_mm = depth_mm,
                                               .allowance_mm = spec.allowance_mm,
                                               .pressure_angle_deg = spec.pressure_angle_deg});
  p.quantities.push_back(
      {"gap_area_mm2", section.area_mm2, "mm2", "K304.rack_gap_section", "section of the roughed gap"});

  const auto life = k304::disc_cutter_life({.coolant = spec.coolant, .coated = spec.coated});
  const double speed_ref_m_min =
      spec.life_speed_ref_m_min ? *spec.life_speed_ref_m_min : published->speed_actual_m_min;
  const double life_min = k304::life_at_speed({.life_ref_min = life.life_mid_min,
                                               .speed_ref_m_min = speed_ref_m_min,
                                               .speed_m_min = speed_m_min,
                                               .taylor_exponent = spec.taylor_exponent})
                              .life_min;
  const auto use = k304::insert_consumption({.life_min = life_min,
                                             .working_min = gap.working_min,
                                             .gaps = spec.gaps,
                                             .cutters = spec.cutters,
                                             .inserts_per_cutter = spec.inserts_per_cutter,
                                             .edges_per_insert = spec.edges_per_insert});
  p.quantities.push_back({"insert_life_min", life_min, "min", "K304.disc_cutter_life, K304.life_at_speed",
                          "life of the inserts in minutes of working strokes"});
  p.quantities.push_back({"gaps_per_life", use.gaps_per_life, "1", "K304.insert_consumption",
                          "gaps roughed in one insert life"});
  p.quantities.push_back({"changes_per_part", use.changes_per_part, "1", "K304.insert_consumption",
                          "changes of all edges per part"});
  p.consumables.push_back(
      {"inserts", use.inserts_per_part, "1", "K304.insert_consumption", "inserts used by one part"});
  // Inserts wear in working strokes only; the element lives in minutes of main time.
  p.edge = ElementLife{
      .element = "edge",
      .law = models::LifeLawKind::weibull,
      .mean_min = life_min * p.main_time_min / (static_cast<double>(time.strokes) * gap.working_min),
      .cv = spec.life_cv,
      .origin = "K304.life_at_speed; COMPLETION: Weibull"};

  models::require(spec.kc11_mpa.has_value() == spec.mc.has_value(), "mc",
                  spec.mc ? models::Value(*spec.mc) : models::Value(), "and kc11_mpa must be given together");
  if (spec.kc11_mpa) {
    k304::SplitCut cut;
    static_cast<k304::InsertLayout&>(cut) =
        k304::split_profile_inserts({.module_mm = spec.module_mm,
                                     .depth_mm = depth_mm,
                                     .allowance_mm = spec.allowance_mm,
                                     .pressure_angle_deg = spec.pressure_angle_deg});
    cut.groups = spec.groups;
    cut.diameter_mm = spec.diameter_mm;
    cut.depth_mm = depth_mm;
    cut.feed_mm_min = feed_mm_min;
    cut.rpm = rpm;
    cut.kc11_mpa = *spec.kc11_mpa;
    cut.mc = *spec.mc;
    cut.second_cutter_offset_deg = paired ? spec.second_cutter_offset_deg : -1;
    const auto force = k304::split_scheme_force(cut);
    constexpr const char* origin = "K304.split_scheme_force";
    p.quantities.push_back({"mean_force_n", force.mean_force_n, "N", origin, "mean tangential force"});
    p.quantities.push_back({"peak_force_n", force.peak_force_n, "N", origin, "peak tangential force"});
    p.quantities.push_back({"power_kw", force.mean_power_kw, "kW", origin, "mean cutting power"});
    if (spec.peak_force_max_n)
      p.limits.push_back({"peak_force_n", force.peak_force_n, *spec.peak_force_max_n, true, "N", origin});
    limit_power(p, context, force.mean_power_kw, origin);
    limit_torque(p, context, force.peak_force_n * spec.diameter_mm / 2000, origin);
  } else {
    models::require(!spec.peak_force_max_n, "peak_force_max_n", spec.peak_force_max_n.value_or(0),
                    "needs kc11_mpa and mc");
  }
  limit_spindle_speed(p, context, rpm, "definition");
  limit_feed_rate(p, context, feed_mm_min, "definition");
  return p;
}

namespace disc_gear_roughing {
void add_to(Kinds& kinds) {
  kinds.add<DiscGearRoughing>("Tooth gaps of large module roughed by disc cutters with indexable inserts.",
                              {"K304"});
}
}  // namespace disc_gear_roughing

}  // namespace verstat::operations
