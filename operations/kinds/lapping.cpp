#include "operations/kinds/lapping.h"

#include <algorithm>

#include "models/surface/k311_lapping_cycle.h"
#include "operations/fields.h"

namespace verstat::models {

template <>
struct StructFields<operations::LapGrains> {
  static std::vector<Field> fields() {
    using S = operations::LapGrains;
    return {
        need<S>(&S::grain_um, "grain_um", "um", open_low(0, 1000), "grain diameter"),
        need<S>(&S::depth_mean_um, "depth_mean_um", "um", closed(-1000, 1000), "mean depth of penetration"),
        need<S>(&S::depth_sd_um, "depth_sd_um", "um", open_low(0, 1000), "its standard deviation"),
        need<S>(&S::depth_greatest_um, "depth_greatest_um", "um", open_low(0, 1000),
                "greatest depth, up to grain_um"),
        need<S>(&S::spacing_um, "spacing_um", "um", open_low(0, 1e5), "mean distance of grains"),
        may<S>(&S::shape_factor, "shape_factor", "1", open_low(0, 100), "shape of the scratch; 2: chord"),
        need<S>(&S::share_under_lap, "share_under_lap", "1", open_low(0, 1),
                "share of the finishing time that a point is under the lap")};
  }
};

template <>
struct StructFields<operations::Lapping> {
  static std::vector<Field> fields() {
    using S = operations::Lapping;
    return {
        need<S>(&S::allowance_um, "allowance_um", "um", open_low(0, 1e4), "stock per lapped side"),
        need<S>(&S::width_mm, "width_mm", "mm", open_low(0, 1e4), "width of the lapped groove"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e4), "length of the lapped groove"),
        may<S>(&S::sides, "sides", "1", closed(1, 2), "lapped sides of the web"),
        need<S>(&S::web_um, "web_um", "um", open_low(0, 1e5), "thickness of the web before lapping"),
        need<S>(&S::web_min_um, "web_min_um", "um", closed(0, 1e5), "least thickness after"),
        need<S>(&S::web_max_um, "web_max_um", "um", closed(0, 1e5), "largest thickness after"),
        need<S>(&S::roughness_initial_um, "roughness_initial_um", "um", closed(0, 1000),
                "roughness height R_max of the blank"),
        need<S>(&S::defect_initial_um, "defect_initial_um", "um", closed(0, 1000),
                "defect layer of the blank below its valleys"),
        need<S>(&S::roughness_final_um, "roughness_final_um", "um", closed(0, 1000),
                "largest R_max of the finished part"),
        need<S>(&S::defect_final_um, "defect_final_um", "um", closed(0, 1000),
                "deepest defect layer of the finished part"),
        need<S>(&S::forced_force_n, "forced_force_n", "N", open_low(0, 1e5), "pressing force, forced stage"),
        need<S>(&S::finish_force_n, "finish_force_n", "N", open_low(0, 1e5), "pressing force, gentle stage"),
        need<S>(&S::lap_speed_m_min, "lap_speed_m_min", "m/min", closed(1e-3, 1e4), "lap speed"),
        need<S>(&S::contact_area_mm2, "contact_area_mm2", "mm2", open_low(0, 1e6), "area under the lap"),
        need<S>(&S::preston_um_mpa_m, "preston_um_mpa_m", "um/(MPa m)", closed(1e-9, 1e3),
                "Preston's coefficient"),
        need<S>(&S::roughness_forced_um, "roughness_forced_um", "um", closed(0, 1000),
                "R_max that the forced stage keeps up"),
        need<S>(&S::defect_forced_um, "defect_forced_um", "um", closed(0, 1000),
                "defect layer that the forced stage keeps up"),
        may<S>(&S::grains, "grains", "-", no_range(), "grains under the lap; needed for Ra"),
        may<S>(&S::parts_per_lap_life, "parts_per_lap_life", "1", closed(2, 100'000),
               "parts of one lap life; the source has at least 30"),
        may<S>(&S::end_of_life_ratio, "end_of_life_ratio", "1", closed(1, 100),
               "lapping time of the last part of the life over that of the first"),
        may<S>(&S::reset_interval_parts, "reset_interval_parts", "1", closed(1, 100'000),
               "parts between lap resets; absent: the best number within the life"),
        may<S>(&S::preparation_min, "preparation_min", "min", closed(0, 1e5),
               "preparation per part, for the piece time"),
        may<S>(&S::reset_min, "reset_min", "min", closed(0, 1e5), "time of a lap reset, for the piece time"),
        may<S>(&S::paste_g_mm3, "paste_g_mm3", "g/mm3", closed(0, 1e6), "paste per removed volume"),
        may<S>(&S::force_max_n, "force_max_n", "N", open_low(0, 1e5), "force that the web allows"),
        may<S>(&S::lap_speed_max_m_min, "lap_speed_max_m_min", "m/min", open_low(0, 1e4), "fastest lap"),
        may<S>(&S::roughness_ra_max_um, "roughness_ra_max_um", "um", open_low(0, 100),
               "largest Ra; needs grains")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace k311 = models::k311;

CutPlan plan(const Lapping& s, const PlanContext&) {
  models::require(s.finish_force_n <= s.forced_force_n, "finish_force_n", s.finish_force_n,
                  "must not be above forced_force_n");
  models::require(s.web_min_um <= s.web_max_um, "web_min_um", s.web_min_um, "must not be above web_max_um");
  models::require(static_cast<double>(s.sides) * s.allowance_um < s.web_um, "allowance_um", s.allowance_um,
                  "must leave some of web_um on all lapped sides");
  models::require(!s.reset_interval_parts || *s.reset_interval_parts <= s.parts_per_lap_life,
                  "reset_interval_parts", s.reset_interval_parts.value_or(0),
                  "must not be above parts_per_lap_life");
  models::require(!s.roughness_ra_max_um || s.grains, "roughness_ra_max_um",
                  s.roughness_ra_max_um.value_or(0), "needs grains, from which Ra follows");

  const double rate_forced_um_min =
      k311::preston_rate({s.preston_um_mpa_m, s.forced_force_n, s.contact_area_mm2, s.lap_speed_m_min})
          .rate_um_min;
  const double rate_finish_um_min =
      k311::preston_rate({s.preston_um_mpa_m, s.finish_force_n, s.contact_area_mm2, s.lap_speed_m_min})
          .rate_um_min;
  const double switch_um = k311::switch_allowance({s.roughness_forced_um, s.defect_forced_um,
                                                   s.roughness_final_um, s.defect_final_um})
                               .allowance_um;
  const auto stages =
      k311::two_stage_time({s.allowance_um, rate_forced_um_min, rate_finish_um_min, switch_um});
  // The same rule for the state of the blank: this much must go before its traces are gone.
  const double needed_um = k311::switch_allowance({s.roughness_initial_um, s.defect_initial_um,
                                                   s.roughness_final_um, s.defect_final_um})
                               .allowance_um;

  // Linear growth to the stated ratio at the last part of the life.
  const double first_min = stages.total_min * static_cast<double>(s.sides);
  const double growth = (s.end_of_life_ratio - 1) / static_cast<double>(s.parts_per_lap_life - 1);
  k311::LapReset reset;
  reset.first_min = first_min;
  reset.growth = growth;
  reset.preparation_min = s.preparation_min;
  reset.change_min = s.reset_min;
  reset.parts_max = s.parts_per_lap_life;
  const auto best = k311::best_lap_reset(reset);
  const std::int64_t interval = s.reset_interval_parts.value_or(best.parts);
  const double last_min =
      k311::cycle_time_with_lap_wear({interval, first_min, s.parts_per_lap_life, s.end_of_life_ratio})
          .time_min;
  const double mean_min = (first_min + last_min) / 2;
  const double parts = static_cast<double>(interval);

  const double piece_min = k311::piece_time({s.allowance_um, s.allowance_um / mean_min, 1, s.preparation_min,
                                             s.reset_min, 1, parts})
                               .time_min;

  CutPlan p;
  p.quantities.reserve(18);
  p.set_main_time(mean_min, "K311.cycle_time_with_lap_wear");
  // A part meets the lap at any of its ages: times of a run lie evenly between the first and the last.
  if (last_min > first_min) p.time_law = UniformDuration{first_min, last_min};

  auto& q = p.quantities;
  q.push_back({"first_part_min", first_min, "min", "K311.two_stage_time", "lapping time with a fresh lap"});
  q.push_back({"last_part_min", last_min, "min", "K311.cycle_time_with_lap_wear",
               "lapping time of the last part before the reset"});
  q.push_back({"forced_stage_min", stages.forced_min, "min", "K311.two_stage_time",
               "forced stage per side, fresh lap"});
  q.push_back({"finish_stage_min", stages.finish_min, "min", "K311.two_stage_time",
               "gentle stage per side, fresh lap"});
  q.push_back({"switch_allowance_um", switch_um, "um", "K311.switch_allowance",
               "allowance at which the forced stage must end"});
  q.push_back({"forced_rate_um_min", rate_forced_um_min, "um/min", "K311.preston_rate",
               "removal rate of the forced stage"});
  q.push_back({"finish_rate_um_min", rate_finish_um_min, "um/min", "K311.preston_rate",
               "removal rate of the gentle stage"});
  q.push_back({"reset_interval_parts", parts, "1", s.reset_interval_parts ? "given" : "K311.best_lap_reset",
               "parts between lap resets"});
  q.push_back({"best_reset_interval_parts", static_cast<double>(best.parts), "1", "K311.best_lap_reset",
               "parts between resets with the least mean piece time"});
  q.push_back({"piece_time_min", piece_min, "min", "K311.piece_time",
               "mean piece time with preparation and the share of the reset"});
  const double web_um = s.web_um - static_cast<double>(s.sides) * s.allowance_um;
  q.push_back({"web_um", web_um, "um", "K311.lapping_cycle", "thickness of the web after lapping"});

  p.limits.reserve(7);
  p.limits.push_back({"allowance_um", s.allowance_um, needed_um, false, "um", "K311.switch_allowance"});
  p.limits.push_back({"web_um", web_um, s.web_min_um, false, "um", "K311.lapping_cycle"});
  p.limits.push_back({"web_um", web_um, s.web_max_um, true, "um", "K311.lapping_cycle"});
  if (s.force_max_n)
    p.limits.push_back({"force_n", s.forced_force_n, *s.force_max_n, true, "N", "K311.cycle_constraints"});
  if (s.lap_speed_max_m_min)
    p.limits.push_back({"lap_speed_m_min", s.lap_speed_m_min, *s.lap_speed_max_m_min, true, "m/min",
                        "K311.cycle_constraints"});
  if (s.grains) {
    const LapGrains& g = *s.grains;
    k311::GrainContact contact;
    contact.mean_um = g.depth_mean_um;
    contact.sd_um = g.depth_sd_um;
    contact.greatest_um = g.depth_greatest_um;
    contact.grain_um = g.grain_um;
    contact.spacing_um = g.spacing_um;
    contact.shape_factor = g.shape_factor;
    contact.speed_m_min = s.lap_speed_m_min;
    contact.time_s = stages.finish_min * 60 * g.share_under_lap;
    const auto rough = k311::lapped_roughness(contact);
    q.push_back({"roughness_ra_um", rough.ra_um, "um", "K311.lapped_roughness", "Ra after the gentle stage"});
    q.push_back(
        {"roughness_max_um", rough.r_max_um, "um", "K311.lapped_roughness", "R_max after the gentle stage"});
    p.leave("roughness_ra_um");
    p.leave("roughness_max_um");
    p.limits.push_back(
        {"roughness_max_um", rough.r_max_um, s.roughness_final_um, true, "um", "K311.lapped_roughness"});
    if (s.roughness_ra_max_um)
      p.limits.push_back(
          {"roughness_ra_um", rough.ra_um, *s.roughness_ra_max_um, true, "um", "K311.lapped_roughness"});
  }

  // The reset is planned by parts: hardly any scatter.
  p.more_elements.push_back({.element = "lap",
                             .law = models::LifeLawKind::normal,
                             .mean_min = parts * mean_min,
                             .cv = 0.05,
                             .origin = "K311.best_lap_reset; COMPLETION: normal law, cv 0.05"});
  if (s.paste_g_mm3)
    p.consumables.push_back(
        {"paste_g",
         *s.paste_g_mm3 * static_cast<double>(s.sides) * s.allowance_um / 1000 * s.width_mm * s.length_mm,
         "g", "K311.piece_cost: paste of eq. (14)", "paste per part"});
  p.consumables.push_back(
      {"lap_resets", 1 / parts, "1", "K311.best_lap_reset", "share of a lap reset per part"});
  return p;
}

namespace lapping {
void add_to(Kinds& kinds) {
  kinds.add<Lapping>("A groove lapped in two stages while the lap wears and is reset.", {"K311"});
}
}  // namespace lapping

}  // namespace verstat::operations
