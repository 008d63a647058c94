#include "operations/kinds/cam_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::CamMilling> {
  static std::vector<Field> fields() {
    using S = operations::CamMilling;
    return {
        need<S>(&S::cam, "cam", "-", no_range(), "three-arc cam"),
        may<S>(&S::cams, "cams", "1", closed(1, 1000), "equal cams on the shaft, milled in one setting"),
        need<S>(&S::width_mm, "width_mm", "mm", open_low(0, 1000), "width of a cam"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "overrun along the axis"),
        need<S>(&S::allowance_mm, "allowance_mm", "mm", open_low(0, 100), "allowance"),
        need<S>(&S::axial_feed_mm_rev, "axial_feed_mm_rev", "mm/rev", open_low(0, 100),
                "axial feed per turn of the part s"),
        need<S>(&S::contour_feed_mm_min, "contour_feed_mm_min", "mm/min", open_low(0, 1e5),
                "largest contour feed on the cam"),
        need<S>(&S::tool_diameter_mm, "tool_diameter_mm", "mm", open_low(0, 1000), "cutter diameter"),
        need<S>(&S::teeth, "teeth", "1", closed(1, 200), "number of teeth"),
        need<S>(&S::tool_speed_rpm, "tool_speed_rpm", "rpm", open_low(0, 1e5), "cutter speed"),
        may<S>(&S::orientation_deg, "orientation_deg", "deg", open(-90, 90), "crossing of the axes alpha"),
        may<S>(&S::edge_length_mm, "edge_length_mm", "mm", open_low(0, 1000),
               "periphery of the cutter from the pivot to its end face"),
        may<S>(&S::scheme, "scheme", "-", no_range(), "how the part turns"),
        may<S>(&S::radius_loss_mm, "radius_loss_mm", "mm", closed(0, 10),
               "wear of the cutter radius that a constant offset corrects"),
        may<S>(&S::kc11_mpa, "kc11_mpa", "MPa", open_low(0, 1e5),
               "specific cutting force at 1 mm chip thickness"),
        may<S>(&S::mc, "mc", "1", closed(0, 0.9), "exponent of the specific cutting force"),
        may<S>(&S::ra_max_um, "ra_max_um", "um", above(0), "allowed roughness along the axis Ra"),
        may<S>(&S::roundness_max_um, "roundness_max_um", "um", above(0), "allowed height of tooth facets"),
        may<S>(&S::form_error_max_mm, "form_error_max_mm", "mm", above(0), "allowed form error by wear"),
        may<S>(&S::part_speed_max_rpm, "part_speed_max_rpm", "rpm", above(0), "largest speed of the part"),
        may<S>(&S::axis_feed_max_mm_min, "axis_feed_max_mm_min", "mm/min", above(0),
               "largest feed of the cutter's horizontal and vertical axes")};
  }
};

namespace verstat::operations {

namespace s1 = models::s1;

namespace {

struct AxisDemand {
  double part_speed_rpm = 0;
  double feed_mm_min = 0;  // horizontal or vertical, the larger
};

// Largest part speed and axis feeds of the stabilised law. On an arc h' and h - rho are a sine and a cosine
// of the normal angle, so the extremes lie at the ends of the arcs and, on the flank, where the sine is one.
AxisDemand stabilised_demand(const CamMilling& spec, const s1::CamGeometry& geometry) {
  constexpr double beside_deg = 1e-9;  // on the other arc of a joint
  const double nose = geometry.nose_joint_deg;
  const double base = geometry.base_joint_deg;
  AxisDemand most;
  for (const double angle_deg : {0.0, nose, nose + beside_deg, std::max(nose, base - 90), base, 180.0}) {
    s1::CamFeed at;
    at.cam = spec.cam;
    at.normal_angle_deg = angle_deg;
    at.contour_feed_mm_min = spec.contour_feed_mm_min;
    const s1::RotationLaw law = s1::cam_rotation_law(at);
    most.part_speed_rpm = std::max(most.part_speed_rpm, law.part_speed_rpm);
    most.feed_mm_min = std::max({most.feed_mm_min, std::abs(law.feed_y_mm_min), std::abs(law.feed_x_mm_min)});
  }
  return most;
}

// The usual scheme turns at the speed whose peak contour feed is the specified one: its turn takes
// time_factor times L/v.
double uniform_speed_rpm(const CamMilling& spec, double perimeter_mm, double time_factor) {
  return spec.contour_feed_mm_min / (perimeter_mm * time_factor);
}

}  // namespace

CutPlan plan(const CamMilling& spec, const PlanContext& context) {
  const bool uniform = spec.scheme == CamScheme::uniform;
  models::require(!uniform || spec.orientation_deg == 0, "orientation_deg", spec.orientation_deg,
                  "must be 0 in the uniform scheme, whose axes are parallel");
  const double radius_mm = spec.tool_diameter_mm / 2;
  const s1::CamGeometry geometry = s1::cam_geometry({spec.cam});

  s1::CamPass pass;
  pass.cam = spec.cam;
  pass.width_mm = spec.width_mm;
  pass.overrun_mm = spec.overrun_mm;
  pass.axial_feed_mm_rev = spec.axial_feed_mm_rev;
  pass.contour_feed_mm_min = spec.contour_feed_mm_min;
  const s1::CamTime time = s1::cam_milling_time(pass);

  s1::CamAndTool tool;
  tool.cam = spec.cam;
  tool.tool_radius_mm = radius_mm;
  const s1::FeedNonuniformity swing = s1::conventional_feed_nonuniformity(tool);
  const double factor = uniform ? swing.time_factor : 1;

  // Surfaces show worst where the cam is most curved.
  const double sharpest_mm = std::min(spec.cam.r_base_mm, spec.cam.r_nose_mm);
  s1::AxialCut axial;
  axial.tool_radius_mm = radius_mm;
  axial.part_radius_mm = sharpest_mm;
  axial.orientation_deg = spec.orientation_deg;
  axial.axial_feed_mm_rev = spec.axial_feed_mm_rev;
  const s1::AxialRoughness roughness = s1::axial_roughness(axial);

  s1::ToothFacets facets;
  facets.contour_feed_mm_min = spec.contour_feed_mm_min;
  facets.tool_speed_rpm = spec.tool_speed_rpm;
  facets.teeth = spec.teeth;
  facets.tool_diameter_mm = spec.tool_diameter_mm;
  facets.part_radius_mm = sharpest_mm;
  facets.orientation_deg = spec.orientation_deg;
  const s1::Roundness roundness = s1::roundness_deviation(facets);

  s1::WornTool worn;
  static_cast<s1::CamAndTool&>(worn) = tool;
  worn.radius_loss_mm = spec.radius_loss_mm;
  worn.scheme = uniform ? s1::WearScheme::centre_plane : s1::WearScheme::normal_contact;
  const double form_error_mm = s1::tool_wear_form_error(worn).form_error_mm;

  s1::RoughingCut roughing;
  roughing.tool_radius_mm = radius_mm;
  roughing.part_radius_mm = sharpest_mm;
  roughing.allowance_mm = spec.allowance_mm;
  roughing.edge_length_mm = spec.edge_length_mm;
  roughing.orientation_deg = spec.orientation_deg;
  const s1::AllowanceSplit split = s1::allowance_split(roughing);
  const double removal_mm3_min =
      s1::material_removal_rate({spec.allowance_mm, spec.axial_feed_mm_rev, spec.contour_feed_mm_min})
          .removal_rate_mm3_min;
  AxisDemand demand = stabilised_demand(spec, geometry);
  if (uniform) demand.part_speed_rpm = uniform_speed_rpm(spec, geometry.perimeter_mm, swing.time_factor);
  const double speed_m_min = std::numbers::pi * spec.tool_diameter_mm * spec.tool_speed_rpm / 1000;

  CutPlan p;
  p.quantities.reserve(20);
  p.set_main_time(static_cast<double>(spec.cams) * time.time_min * factor,
                  uniform ? "S1.conventional_feed_nonuniformity" : "S1.cam_milling_time");
  p.quantities.push_back({"revolutions", time.revolutions, "1", "S1.cam_milling_time", "turns for one cam"});
  p.quantities.push_back(
      {"perimeter_mm", geometry.perimeter_mm, "mm", "S1.cam_geometry", "length of the contour"});
  p.quantities.push_back({"feed_swing", uniform ? swing.max_to_min_feed : 1, "1",
                          "S1.conventional_feed_nonuniformity", "largest over smallest contour feed"});
  p.quantities.push_back({"uniform_time_factor", swing.time_factor, "1", "S1.conventional_feed_nonuniformity",
                          "time of the uniform scheme over the stabilised one at equal peak feed"});
  p.quantities.push_back({"part_speed_max_rpm", demand.part_speed_rpm, "rpm", "S1.cam_rotation_law",
                          "largest speed of the part"});
  if (!uniform)
    p.quantities.push_back({"axis_feed_max_mm_min", demand.feed_mm_min, "mm/min", "S1.cam_rotation_law",
                            "largest feed of the cutter's axes"});
  p.quantities.push_back(
      {"ra_um", roughness.ra_um, "um", "S1.axial_roughness", "roughness along the axis at the nose"});
  p.leave("ra_um");
  p.quantities.push_back({"feed_per_tooth_mm", roundness.feed_per_tooth_mm, "mm", "S1.roundness_deviation",
                          "feed per tooth at the peak of the contour feed"});
  p.quantities.push_back({"roundness_um", roundness.roundness_deviation_um, "um", "S1.roundness_deviation",
                          "height of the tooth facets at the nose"});
  p.quantities.push_back({"wear_form_error_mm", form_error_mm, "mm", "S1.tool_wear_form_error",
                          "form error that wear of the radius leaves after the offset"});
  p.quantities.push_back({"periphery_share", split.periphery_mm / spec.allowance_mm, "1",
                          "S1.allowance_split", "part of the allowance that the periphery takes"});
  p.quantities.push_back({"removal_rate_mm3_min", removal_mm3_min, "mm3/min", "S1.material_removal_rate",
                          "removal rate at the peak of the contour feed"});
  p.quantities.push_back(
      {"cutting_speed_m_min", speed_m_min, "m/min", "definition", "cutting speed of the cutter"});

  p.spindle.teeth = spec.teeth;
  MachineLoad load;
  load.spindle_speed_rpm = spec.tool_speed_rpm;
  if (spec.kc11_mpa) {
    const double mean_chip_mm =
        roundness.feed_per_tooth_mm * std::sqrt(std::min(1.0, spec.allowance_mm / spec.tool_diameter_mm));
    const double kc = kienzle_n_mm2(*spec.kc11_mpa, spec.mc, mean_chip_mm);
    load.power_kw = kc * removal_mm3_min / 60e6;
    load.torque_nm = *load.power_kw * 30'000 / (std::numbers::pi * spec.tool_speed_rpm);
    p.quantities.push_back({"cutting_power_kw", *load.power_kw, "kW",
                            "COMPLETION: Kienzle at the mean chip thickness", "cutting power at peak feed"});
  }
  if (spec.ra_max_um) {
    p.limits.push_back({"ra_um", roughness.ra_um, *spec.ra_max_um, true, "um", "S1.axial_roughness"});
    s1::RoughnessLimit wanted;
    wanted.tool_radius_mm = radius_mm;
    wanted.part_radius_mm = sharpest_mm;
    wanted.axial_feed_mm_rev = spec.axial_feed_mm_rev;
    wanted.ra_limit_um = *spec.ra_max_um;
    p.quantities.push_back({"orientation_max_deg", s1::max_orientation_for_roughness(wanted).orientation_deg,
                            "deg", "S1.max_orientation_for_roughness",
                            "largest crossing of the axes that keeps the roughness"});
  }
  if (spec.roundness_max_um)
    p.limits.push_back({"roundness_um", roundness.roundness_deviation_um, *spec.roundness_max_um, true, "um",
                        "S1.roundness_deviation"});
  if (spec.form_error_max_mm)
    p.limits.push_back({"wear_form_error_mm", form_error_mm, *spec.form_error_max_mm, true, "mm",
                        "S1.tool_wear_form_error"});
  if (spec.part_speed_max_rpm)
    p.limits.push_back({"part_speed_rpm", demand.part_speed_rpm, *spec.part_speed_max_rpm, true, "rpm",
                        "S1.cam_rotation_law"});
  if (spec.axis_feed_max_mm_min && !uniform)
    p.limits.push_back({"axis_feed_mm_min", demand.feed_mm_min, *spec.axis_feed_max_mm_min, true, "mm/min",
                        "S1.cam_rotation_law"});
  add_machine_limits(p, context, load);
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, speed_m_min, roundness.feed_per_tooth_mm, spec.allowance_mm);
  return p;
}

namespace cam_milling {
void add_to(Kinds& kinds) {
  kinds.add<CamMilling>("The cams of a shaft milled with a cutter of turned axis.", {"S1"});
}
}  // namespace cam_milling

}  // namespace verstat::operations
