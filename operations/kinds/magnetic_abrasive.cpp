#include "operations/kinds/magnetic_abrasive.h"

#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::MagneticAbrasive> {
  static std::vector<Field> fields() {
    using S = operations::MagneticAbrasive;
    return {may<S>(&S::material, "material", "-", no_range(), "material of the bearing"),
            need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 5000), "diameter of the surface"),
            need<S>(&S::width_mm, "width_mm", "mm", open_low(0, 5000), "width of the surface"),
            need<S>(&S::surface_speed_m_min, "surface_speed_m_min", "m/min", open_low(0, 5000),
                    "circumferential speed"),
            need<S>(&S::feed_mm_min, "feed_mm_min", "mm/min", open_low(0, 1e5), "axial feed"),
            may<S>(&S::grain_size_um, "grain_size_um", "um", open_low(0, 5000), "size of the grains"),
            may<S>(&S::gap_mm, "gap_mm", "mm", open_low(0, 100), "working gap"),
            may<S>(&S::amplitude_mm, "amplitude_mm", "mm", open_low(0, 100), "of the axial oscillation"),
            may<S>(&S::grains, "grains", "1", closed(1, 1000), "grains in a row along the axis"),
            may<S>(&S::grain_spacing_mm, "grain_spacing_mm", "mm", open_low(0, 100), "their distance"),
            may<S>(&S::groove_width_mm, "groove_width_mm", "mm", open_low(0, 100),
                   "width of a scratch along the axis"),
            may<S>(&S::passes, "passes", "1", closed(1, 10'000), "passes over the width"),
            may<S>(&S::time_constant_min, "time_constant_min", "min", open_low(0, 1e4),
                   "time constant of the fall of roughness, to be measured"),
            may<S>(&S::ra_before_um, "ra_before_um", "um", open_low(0, 100),
                   "roughness before; not given: that of the paper's ground bearings"),
            may<S>(&S::part_life_factor, "part_life_factor", "1", closed(0.01, 100),
                   "life in service over that of a ground bearing, to be measured"),
            may<S>(&S::ra_max_um, "ra_max_um", "um", open_low(0, 100), "roughest surface allowed")};
  }
};

namespace verstat::operations {

namespace k309 = models::k309;

CutPlan plan(const MagneticAbrasive& spec, const PlanContext& context) {
  const auto scratch =
      k309::scratch_pattern({spec.diameter_mm / 2, spec.surface_speed_m_min, spec.feed_mm_min});
  const auto gap =
      k309::track_max_gap({spec.grains, spec.grain_spacing_mm, scratch.pitch_mm, spec.groove_width_mm});
  const double time_min = k309::mao_pass_time({.width_mm = spec.width_mm,
                                               .grains = spec.grains,
                                               .spacing_mm = spec.grain_spacing_mm,
                                               .feed_mm_min = spec.feed_mm_min,
                                               .passes = spec.passes})
                              .time_min;
  const auto window =
      k309::mao_result({spec.grain_size_um, spec.gap_mm, spec.amplitude_mm, scratch.speed_rpm});
  const auto ground = k309::ground_state({spec.material});
  const double before_um = spec.ra_before_um.value_or(ground.ra_um);
  const double final_um = (window.ra_min_um + window.ra_max_um) / 2;
  const double ra_um =
      before_um <= final_um
          ? before_um
          : k309::roughness_after_mao({time_min, before_um, final_um, spec.time_constant_min}).ra_um;

  CutPlan p;
  p.quantities.reserve(12);
  p.set_main_time(time_min, "K309.mao_pass_time");
  auto& q = p.quantities;
  q.push_back({"part_speed_rpm", scratch.speed_rpm, "rpm", "K309.scratch_pattern", "speed of the part"});
  q.push_back(
      {"scratch_pitch_mm", scratch.pitch_mm, "mm", "K309.scratch_pattern", "pitch of one grain's helix"});
  q.push_back({"crossing_angle_deg", scratch.crossing_angle_deg, "deg", "K309.scratch_pattern",
               "between scratches of opposite rotation"});
  q.push_back({"scratch_length_mm",
               k309::scratch_length({60 * time_min, spec.surface_speed_m_min, spec.feed_mm_min}).length_mm,
               "mm", "K309.scratch_length", "path of one grain"});
  q.push_back(
      {"oscillation_hz",
       k309::oscillation_frequency({.feed_mm_min = spec.feed_mm_min, .amplitude_mm = spec.amplitude_mm})
           .frequency_hz,
       "Hz", "K309.oscillation_frequency", "of the axial oscillation"});
  q.push_back(
      {"track_gap_mm", gap.gap_mm, "mm", "K309.track_max_gap", "largest distance of neighbouring tracks"});
  q.push_back({"in_window", window.in_window ? 1.0 : 0.0, "1", "K309.mao_result",
               "1 inside the recommended settings"});
  q.push_back({"ra_before_um", before_um, "um", spec.ra_before_um ? "given" : "K309.ground_state",
               "roughness Ra before"});
  q.push_back({"ra_um", ra_um, "um", "K309.roughness_after_mao", "roughness Ra after"});
  q.push_back({"part_life_factor", spec.part_life_factor, "1", "given; K309 only asserts it",
               "life of the bearing in service over that of a ground one"});
  p.leave("ra_um");
  p.leave("part_life_factor");
  p.limits.push_back({"track_gap_mm", gap.gap_mm, spec.groove_width_mm, true, "mm",
                      "K309.track_max_gap: scratches must cover the surface"});
  p.limits.push_back({"in_window", window.in_window ? 1.0 : 0.0, 1, false, "1",
                      "K309.mao_result: the roughness is known inside the window"});
  if (spec.ra_max_um)
    p.limits.push_back({"ra_um", ra_um, *spec.ra_max_um, true, "um", "K309.roughness_after_mao"});
  limit_spindle_speed(p, context, scratch.speed_rpm, "K309.scratch_pattern");
  limit_feed_rate(p, context, spec.feed_mm_min, "given");
  return p;
}

namespace magnetic_abrasive {
void add_to(Kinds& kinds) {
  kinds.add<MagneticAbrasive>("A bearing surface finished with ferro-abrasive grains.", {"K309"});
}
}  // namespace magnetic_abrasive

}  // namespace verstat::operations
