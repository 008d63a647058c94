#include "operations/kinds/gear_generating.h"

#include "models/gears/k202_hyperboloid_forming.h"
#include "models/gears/k405_hyperboloid_contact.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::FlankContact> {
  static std::vector<Field> fields() {
    using S = operations::FlankContact;
    return {need<S>(&S::load_n_mm, "load_n_mm", "N/mm", open_low(0, 1e5), "load along the line of contact"),
            need<S>(&S::reduced_radius_mm, "reduced_radius_mm", "mm", open_low(0, 1e5),
                    "reduced radius of the flanks"),
            may<S>(&S::tool_modulus_mpa, "tool_modulus_mpa", "MPa", open_low(0, 2e6), "modulus of the tool"),
            may<S>(&S::tool_poisson, "tool_poisson", "1", closed(0, 0.49), "its Poisson ratio"),
            may<S>(&S::gear_modulus_mpa, "gear_modulus_mpa", "MPa", open_low(0, 2e6), "modulus of the gear"),
            may<S>(&S::gear_poisson, "gear_poisson", "1", closed(0, 0.49), "its Poisson ratio"),
            may<S>(&S::pressure_max_mpa, "pressure_max_mpa", "MPa", open_low(0, 1e5),
                   "highest contact pressure")};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::GearGenerating> {
  static std::vector<Field> fields() {
    using S = operations::GearGenerating;
    return {need<S>(&S::module_mm, "module_mm", "mm", open_low(0, 50), "module"),
            need<S>(&S::gear_teeth, "gear_teeth", "1", closed(5, 1000), "teeth of the gear"),
            need<S>(&S::tool_teeth, "tool_teeth", "1", closed(5, 1000), "teeth of the tool"),
            may<S>(&S::shaft_angle_deg, "shaft_angle_deg", "deg", closed(1, 60), "crossing of the axes"),
            need<S>(&S::face_width_mm, "face_width_mm", "mm", open_low(0, 5000), "width of the gear"),
            may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "overrun"),
            need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", open_low(0, 100),
                    "feed per revolution of the gear"),
            need<S>(&S::tool_speed_rpm, "tool_speed_rpm", "rpm", open_low(0, 1e5), "speed of the tool"),
            may<S>(&S::passes, "passes", "1", closed(1, 1000), "passes"),
            may<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", open_low(0, 10), "depth of a pass"),
            may<S>(&S::cutting_speed_min_m_min, "cutting_speed_min_m_min", "m/min", open_low(0, 1000),
                   "lowest speed at which the flanks cut"),
            may<S>(&S::cutting_speed_max_m_min, "cutting_speed_max_m_min", "m/min", open_low(0, 1000),
                   "highest speed that the tool stands"),
            may<S>(&S::contact, "contact", "-", no_range(), "contact of the flanks")};
  }
};

namespace verstat::operations {

namespace k202 = models::k202;
namespace k405 = models::k405;

CutPlan plan(const GearGenerating& spec, const PlanContext& context) {
  const auto setup =
      k202::generating_setup({spec.module_mm, spec.tool_teeth, spec.gear_teeth, spec.shaft_angle_deg});
  const double speed_m_min =
      k202::sliding_cutting_speed({setup.tool_pitch_radius_mm, spec.tool_speed_rpm, spec.shaft_angle_deg})
          .vc_m_min;
  const auto time = k202::gear_generation_time({.face_width_mm = spec.face_width_mm,
                                                .overrun_mm = spec.overrun_mm,
                                                .shaft_angle_deg = spec.shaft_angle_deg,
                                                .feed_mm_rev = spec.feed_mm_rev,
                                                .tool_speed_rpm = spec.tool_speed_rpm,
                                                .tool_teeth = spec.tool_teeth,
                                                .gear_teeth = spec.gear_teeth,
                                                .passes = spec.passes});
  CutPlan p;
  p.quantities.reserve(10);
  p.set_main_time(time.time_min, "K202.gear_generation_time");
  auto& q = p.quantities;
  q.push_back(
      {"gear_speed_rpm", time.gear_speed_rpm, "rpm", "K202.gear_generation_time", "speed of the gear"});
  q.push_back({"cutting_speed_m_min", speed_m_min, "m/min", "K202.sliding_cutting_speed",
               "sliding of the flanks at the pitch point"});
  q.push_back({"centre_distance_mm", setup.center_distance_mm, "mm", "K202.generating_setup",
               "shortest distance of the axes"});
  q.push_back({"throat_radius_mm", setup.gear_throat_radius_mm, "mm", "K202.generating_setup",
               "throat of the gear's hyperboloid"});
  q.push_back({"edge_radius_mm",
               k202::hyperboloid_blank_radius({spec.face_width_mm / 2, setup.center_distance_mm,
                                               setup.tool_pitch_radius_mm, spec.shaft_angle_deg})
                   .radius_mm,
               "mm", "K202.hyperboloid_blank_radius", "of the hyperboloid at the ends of the face"});
  const auto limit = [&](const char* name, double value, const std::optional<double>& allowed, bool most,
                         const char* unit, const char* origin) {
    if (allowed) p.limits.push_back({name, value, *allowed, most, unit, origin});
  };
  limit("cutting_speed_m_min", speed_m_min, spec.cutting_speed_min_m_min, false, "m/min",
        "K202.sliding_cutting_speed");
  limit("cutting_speed_m_min", speed_m_min, spec.cutting_speed_max_m_min, true, "m/min",
        "K202.sliding_cutting_speed");
  if (spec.contact) {
    const FlankContact& c = *spec.contact;
    const auto pressed = k405::line_contact_pressure({.load_n_mm = c.load_n_mm,
                                                      .reduced_radius_mm = c.reduced_radius_mm,
                                                      .e1_mpa = c.tool_modulus_mpa,
                                                      .nu1 = c.tool_poisson,
                                                      .e2_mpa = c.gear_modulus_mpa,
                                                      .nu2 = c.gear_poisson});
    q.push_back({"contact_pressure_mpa", pressed.p_max_mpa, "MPa", "K405.line_contact_pressure",
                 "highest pressure of the flanks"});
    limit("contact_pressure_mpa", pressed.p_max_mpa, c.pressure_max_mpa, true, "MPa",
          "K405.line_contact_pressure");
  }
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, speed_m_min, spec.feed_mm_rev, spec.depth_of_cut_mm);
  p.spindle.teeth = spec.tool_teeth;
  limit_spindle_speed(p, context, spec.tool_speed_rpm, "given");
  limit_feed_rate(p, context, time.gear_speed_rpm * spec.feed_mm_rev, "definition");
  return p;
}

namespace gear_generating {
void add_to(Kinds& kinds) {
  kinds.add<GearGenerating>("A gear finished by a tool on crossed axes: sliding of the flanks cuts.",
                            {"K202", "K405"});
}
}  // namespace gear_generating

}  // namespace verstat::operations
