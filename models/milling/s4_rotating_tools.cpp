#include "models/milling/s4_rotating_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::s4 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;
constexpr double count_slack = 1e-9;  // a count that is whole by design is not rounded up

struct Vector {
  double x;
  double y;
  [[nodiscard]] double length() const { return std::hypot(x, y); }
};
Vector operator+(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y};
}

// Contact from the part axis: across and along the line of centres.
Vector contact_from_axis(const Contact& in) {
  const double rho = in.contact_angle_deg * rad_per_deg;
  return {in.tool_radius_mm * std::sin(rho), in.centre_distance_mm - in.tool_radius_mm * std::cos(rho)};
}

double speed_m_min(double rpm, double radius_mm) {
  return 2 * pi * rpm * radius_mm / 1000;
}

double reach_of_flat_mm(const Flat& in) {
  const double reach_mm = in.flat_distance_mm + in.tool_radius_mm;
  require(reach_mm > 0, "flat_distance_mm", in.flat_distance_mm,
          "plus tool_radius_mm must be positive: the tool centre must stay off the axis");
  return reach_mm;
}

std::int64_t count_up(double ratio, std::string_view name, double value) {
  require(ratio < 1e6, name, value, "is too small: more than a million passes");
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(ratio - count_slack)));
}

void require_inside(const double depth_mm, const double blank_radius_mm) {
  require(depth_mm <= blank_radius_mm, "depth_mm", depth_mm, "must not be above blank_radius_mm");
}

double half_width_mm(double radius_mm, double depth_mm) {
  return std::sqrt(depth_mm * (2 * radius_mm - depth_mm));
}

}  // namespace

ContactRadius contact_radius(const Contact& in) {
  return guarded<&contact_radius>(in, [&] {
    const Vector p = contact_from_axis(in);
    return ContactRadius{p.length(), std::atan2(p.x, p.y) / rad_per_deg};
  });
}

EngagementLimit engagement_limit(const ToolAndWork& in) {
  return guarded<&engagement_limit>(in, [&] {
    const double a = in.centre_distance_mm, r1 = in.tool_radius_mm, r2 = in.work_radius_mm;
    const double cosine = (a * a + (r1 - r2) * (r1 + r2)) / (2 * a * r1);
    if (cosine >= 1) return EngagementLimit{false, 0, 0};
    if (cosine <= -1) return EngagementLimit{true, 180, 0};
    const double rho = std::acos(cosine);
    return EngagementLimit{true, rho / rad_per_deg,
                           std::atan2(r1 * std::sin(rho), a - r1 * cosine) / rad_per_deg};
  });
}

ResultantSpeed resultant_speed(const CuttingMotion& in) {
  return guarded<&resultant_speed>(in, [&] {
    const double rho = in.contact_angle_deg * rad_per_deg;
    const Vector contact = contact_from_axis(in);
    const double sigma = std::atan2(contact.x, contact.y);
    const double edge = speed_m_min(in.tool_speed_rpm, in.tool_radius_mm);
    const double work = speed_m_min(in.work_speed_rpm, contact.length());
    const double sense = in.mode == MillingMode::down ? 1 : -1;
    const Vector v_r{edge * std::cos(rho), edge * std::sin(rho)};
    const Vector v_s = Vector{0, -in.approach_feed_mm_min / 1000} +
                       Vector{-sense * work * std::cos(sigma), sense * work * std::sin(sigma)};
    const Vector v = v_r + v_s;
    const double deviation =
        edge == 0 ? 0 : std::atan2(std::abs(v_r.x * v.y - v_r.y * v.x), v_r.x * v.x + v_r.y * v.y);
    return ResultantSpeed{edge, work, v_s.length(), v.length(), deviation / rad_per_deg};
  });
}

EdgeSpeeds edge_speed_components(const EdgeInclination& in) {
  return guarded<&edge_speed_components>(in, [&] {
    const double lambda = in.inclination_deg * rad_per_deg;
    return EdgeSpeeds{in.resultant_speed_m_min * std::sin(lambda),
                      in.resultant_speed_m_min * std::cos(lambda)};
  });
}

KinematicInclination kinematic_inclination(const SecondMotion& in) {
  return guarded<&kinematic_inclination>(in, [&] {
    const double crossing = in.crossing_angle_deg * rad_per_deg;
    const Vector sum{1 + in.speed_ratio * std::cos(crossing), in.speed_ratio * std::sin(crossing)};
    require(sum.length() > 1e-12, "speed_ratio", in.speed_ratio,
            "the two motions cancel at this crossing angle: there is no resultant");
    const double turn_deg = std::atan2(sum.y, sum.x) / rad_per_deg;
    return KinematicInclination{turn_deg, in.static_inclination_deg - turn_deg};
  });
}

FeedLimit block_feed_limit(const Block& in) {
  return guarded<&block_feed_limit>(
      in, [&] { return FeedLimit{in.block_length_mm / (in.block_time_ms / 1000) * 60}; });
}

BlockLength block_length_for_tolerance(const ChordTolerance& in) {
  return guarded<&block_length_for_tolerance>(in, [&] {
    require(in.chord_tolerance_mm <= in.path_radius_mm, "chord_tolerance_mm", in.chord_tolerance_mm,
            "must not be above path_radius_mm");
    return BlockLength{2 * half_width_mm(in.path_radius_mm, in.chord_tolerance_mm)};
  });
}

ChipThickness uncut_chip_thickness(const LeadCut& in) {
  return guarded<&uncut_chip_thickness>(
      in, [&] { return ChipThickness{in.feed_mm * std::sin(in.lead_angle_deg * rad_per_deg)}; });
}

FlatLayer flat_layer(const Layer& in) {
  return guarded<&flat_layer>(in, [&] {
    require_inside(in.depth_mm, in.blank_radius_mm);
    // acos(1 - t/R) without cancellation.
    const double edge_rad = 2 * std::asin(std::sqrt(in.depth_mm / (2 * in.blank_radius_mm)));
    return FlatLayer{edge_rad / rad_per_deg, in.depth_mm, 2 * half_width_mm(in.blank_radius_mm, in.depth_mm)};
  });
}

Projection flat_projection(const TiltedFlat& in) {
  return guarded<&flat_projection>(
      in, [&] { return Projection{in.flat_length_mm * std::sin(in.tilt_deg * rad_per_deg)}; });
}

FlatAxes flat_axis_law(const FlatTurn& in) {
  return guarded<&flat_axis_law>(in, [&] {
    const double reach_mm = reach_of_flat_mm(in);
    const double theta = in.rotation_deg * rad_per_deg;
    const double cosine = std::cos(theta);
    return FlatAxes{reach_mm / cosine, reach_mm * std::tan(theta),
                    in.surface_feed_mm_min * cosine * cosine / (2 * pi * reach_mm),
                    in.surface_feed_mm_min * std::sin(theta)};
  });
}

XIncrements flat_x_increments(const FlatSteps& in) {
  return guarded<&flat_x_increments>(in, [&] {
    const double reach_mm = reach_of_flat_mm(in);
    const auto x_mm = [&](std::int64_t i) {
      const double share = static_cast<double>(2 * i - in.steps) / static_cast<double>(in.steps);
      return reach_mm / std::cos(in.half_angle_deg * rad_per_deg * share);
    };
    XIncrements out;
    out.increments_mm.reserve(static_cast<std::size_t>(in.steps));
    double before_mm = x_mm(0);
    for (std::int64_t i = 1; i <= in.steps; ++i) {
      const double here_mm = x_mm(i);
      out.increments_mm.push_back(here_mm - before_mm);
      before_mm = here_mm;
    }
    return out;
  });
}

StepErrors flat_step_error(const FlatStep& in) {
  return guarded<&flat_step_error>(in, [&] {
    const double reach_mm = reach_of_flat_mm(in);
    require(std::abs(in.rotation_deg) + in.step_deg / 2 < 90, "step_deg", in.step_deg,
            "abs(rotation_deg) plus half of it must stay below 90");
    const double h = in.step_deg / 2 * rad_per_deg;
    const double cos2 = std::pow(std::cos(in.rotation_deg * rad_per_deg), 2);
    // cos(theta + h) cos(theta - h); the differences of the card's formulas expanded, so that small steps
    // keep their digits.
    const double product = cos2 - std::pow(std::sin(h), 2);
    const double half2 = std::pow(std::sin(h / 2), 2);
    const double along_mm = reach_mm * std::sin(2 * h) / product;
    StepErrors out{reach_mm * 2 * half2 * (2 * (1 - half2) - cos2) / product, along_mm, std::nullopt};
    const double r_mm = in.tool_radius_mm, quarter_mm2 = along_mm * along_mm / 4;
    if (along_mm < 2 * r_mm)
      out.imprint_scallop_mm = quarter_mm2 / (r_mm + std::sqrt(std::max(0.0, r_mm * r_mm - quarter_mm2)));
    return out;
  });
}

FlatTime flat_milling_time(const FlatPass& in) {
  return guarded<&flat_milling_time>(in, [&] {
    require_inside(in.depth_mm, in.blank_radius_mm);
    const std::int64_t layers =
        count_up(in.depth_mm / in.width_of_cut_mm, "width_of_cut_mm", in.width_of_cut_mm);
    const std::int64_t passes =
        count_up(in.flat_axial_length_mm / in.axial_depth_mm, "axial_depth_mm", in.axial_depth_mm);
    double path_mm = 0;
    for (std::int64_t i = 1; i <= layers; ++i) {
      const double removed_mm = std::min(static_cast<double>(i) * in.width_of_cut_mm, in.depth_mm);
      path_mm += 2 * half_width_mm(in.blank_radius_mm + in.tool_radius_mm, removed_mm);
    }
    path_mm *= static_cast<double>(passes);
    return FlatTime{layers, passes, path_mm, path_mm / in.surface_feed_mm_min};
  });
}

FlatSpeeds flat_milling_speeds(const FlatCut& in) {
  return guarded<&flat_milling_speeds>(in, [&] {
    require_inside(in.depth_mm, in.blank_radius_mm);
    const double reach_mm = in.blank_radius_mm - in.depth_mm + in.tool_radius_mm;
    require(reach_mm > 0, "tool_radius_mm", in.tool_radius_mm,
            "must be positive when the flat goes through the axis");
    const double tangent = half_width_mm(in.blank_radius_mm, in.depth_mm) / reach_mm;
    const double sense = in.mode == MillingMode::down ? -1 : 1;
    // Rolling of the part on the tool circle, 2 pi n2 R1 with n2 = v_f cos^2 theta / (2 pi (d + R1)).
    const auto speed_m = [&](double cos2) {
      const double rolling_mm_min = in.surface_feed_mm_min * cos2 * in.tool_radius_mm / reach_mm;
      return std::abs(speed_m_min(in.tool_speed_rpm, in.tool_radius_mm) +
                      sense * (in.surface_feed_mm_min - rolling_mm_min) / 1000);
    };
    const double edge_m = speed_m(1 / (1 + tangent * tangent));
    return FlatSpeeds{edge_m, speed_m(1), edge_m};
  });
}

FinishingRule finishing_rule(const FinishingRegime& in) {
  return guarded<&finishing_rule>(in, [&] {
    if (in.cutting_speed_m_min >= 600 && in.depth_to_feed_ratio <= in.ratio_limit)
      return FinishingRule{true, 1.6, 3.2};
    return FinishingRule{false, std::nullopt, std::nullopt};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "S4",
       .title = "Kinematic and geometric features of high-speed machining of complex surfaces of parts with "
                "rotating tools on CNC machines",
       .authors = "Popok N. N., Anisimov V. S.",
       .published = "Science and Technique (Minsk), vol. 23, no. 6, 2024, pp. 461-472",
       .models =
           "Turn-milling of parts that combine cylinders, cones, spheres and flats: the true cutting speed "
           "at "
           "entry, middle and exit in down and up milling, the inclination of the edge in motion, the feed a "
           "control sustains with short blocks, and flats on a rotating bar by synchronised X and C axes.",
       .role = "milling",
       .errata = {
           "Eqs. (4), (5) are printed as products of two speeds and a cosine (unit m^2/min^2, zero for "
           "perpendicular vectors); the text announces the cosine theorem, so vector sums are meant.",
           "Eq. (3) with the arcsine is wrong beyond 90 deg; atan2 is used.",
           "The formula l sin(alpha) for the X travel of a flat does not give the printed 0.2 and 1.0 mm; R "
           "(1 "
           "- cos alpha) = t does.",
           "A flat 1 mm deep on a 32 mm bar is 11.14 mm wide, not 7."}});

  const auto centres = [](auto& f) {
    f.input(&Centres::centre_distance_mm, "centre_distance_mm", "a_w", "mm", positive(),
            "distance of the axes", 25.0)
        .input(&Centres::tool_radius_mm, "tool_radius_mm", "R_1", "mm", positive(), "radius of the tool",
               10.0);
  };
  const auto contact = [&](auto& f) {
    f.with(centres).input(&Contact::contact_angle_deg, "contact_angle_deg", "rho", "deg", any(),
                          "angle of the contact at the tool centre, from the line of centres", 12.0);
  };
  const auto layer = [](auto& f) {
    f.input(&Layer::blank_radius_mm, "blank_radius_mm", "R", "mm", positive(), "radius of the bar", 16.0)
        .input(&Layer::depth_mm, "depth_mm", "t", "mm", non_negative(), "depth, up to the radius", 1.0);
  };
  const auto flat = [](auto& f) {
    f.input(&Flat::tool_radius_mm, "tool_radius_mm", "R_1", "mm", non_negative(),
            "radius of the tool; 0: a point tool", 10.0)
        .input(&Flat::flat_distance_mm, "flat_distance_mm", "d", "mm", any(),
               "distance of the flat from the axis; with the tool radius positive", 15.0);
  };

  source
      .function<&contact_radius>("contact_radius", "Radius and angle of the contact on the part.",
                                 "eqs. (1)-(3)", Provenance::repaired)
      .with(contact)
      .output(&ContactRadius::contact_radius_mm, "contact_radius_mm", "R_2'", "mm", non_negative(),
              "distance of the contact from the part axis")
      .output(&ContactRadius::work_angle_deg, "work_angle_deg", "sigma", "deg", closed(-180, 180),
              "its angle at the part axis");
  source
      .function<&engagement_limit>("engagement_limit", "Angles of entry and exit of the cut.",
                                   "derived from eq. (1)", Provenance::completion)
      .with(centres)
      .input(&ToolAndWork::work_radius_mm, "work_radius_mm", "R_2", "mm", positive(), "radius of the part",
             16.0)
      .output(&EngagementLimit::engaged, "engaged", "-", "-", no_range(), "tool and part overlap")
      .output(&EngagementLimit::tool_angle_deg, "tool_angle_deg", "rho_max", "deg", closed(0, 180),
              "at the tool centre, plus and minus")
      .output(&EngagementLimit::work_angle_deg, "work_angle_deg", "sigma", "deg", closed(0, 180),
              "at the part axis, plus and minus");
  source
      .function<&resultant_speed>("resultant_speed", "Cutting speed relative to the part.", "eqs. (4), (5)",
                                  Provenance::repaired)
      .with(contact)
      .input(&CuttingMotion::tool_speed_rpm, "tool_speed_rpm", "n_1", "rpm", non_negative(),
             "speed of the tool", 3000.0)
      .input(&CuttingMotion::work_speed_rpm, "work_speed_rpm", "n_2", "rpm", non_negative(),
             "speed of the part", 100.0)
      .input(&CuttingMotion::approach_feed_mm_min, "approach_feed_mm_min", "f", "mm/min", any(),
             "feed along the line of centres, positive towards the part", 900.0)
      .input(&CuttingMotion::mode, "mode", "-", "-", no_range(), "down or up milling", "down")
      .output(&ResultantSpeed::tool_speed_m_min, "tool_speed_m_min", "v_r", "m/min", non_negative(),
              "speed of the edge by the rotation of the tool")
      .output(&ResultantSpeed::work_speed_m_min, "work_speed_m_min", "w", "m/min", non_negative(),
              "speed of the part at the contact")
      .output(&ResultantSpeed::feed_speed_m_min, "feed_speed_m_min", "v_s", "m/min", non_negative(),
              "both feed motions together")
      .output(&ResultantSpeed::resultant_speed_m_min, "resultant_speed_m_min", "v", "m/min", non_negative(),
              "edge relative to the part")
      .output(&ResultantSpeed::deviation_deg, "deviation_deg", "-", "deg", closed(0, 180),
              "angle between it and the speed of the edge");
  source
      .function<&edge_speed_components>("edge_speed_components", "Speed along and normal to the edge.",
                                        "behind the example", Provenance::completion)
      .input(&EdgeInclination::resultant_speed_m_min, "resultant_speed_m_min", "v", "m/min", non_negative(),
             "cutting speed", 100.0)
      .input(&EdgeInclination::inclination_deg, "inclination_deg", "lambda", "deg", any(),
             "inclination of the edge", 45.0)
      .output(&EdgeSpeeds::tangential_speed_m_min, "tangential_speed_m_min", "-", "m/min", any(),
              "along the edge")
      .output(&EdgeSpeeds::normal_speed_m_min, "normal_speed_m_min", "-", "m/min", any(),
              "normal to the edge");
  source
      .function<&kinematic_inclination>("kinematic_inclination",
                                        "Inclination of the edge turned by a second motion.", "completion",
                                        Provenance::completion)
      .input(&SecondMotion::static_inclination_deg, "static_inclination_deg", "lambda_C", "deg", any(),
             "against the plane normal to the main velocity", 45.0)
      .input(&SecondMotion::speed_ratio, "speed_ratio", "i", "1", any(),
             "other motion over main; negative for the opposite sense", 0.5)
      .input(&SecondMotion::crossing_angle_deg, "crossing_angle_deg", "epsilon", "deg", any(),
             "between the two velocities", 90.0)
      .output(&KinematicInclination::turn_deg, "turn_deg", "eta", "deg", closed(-180, 180),
              "turn of the main plane")
      .output(&KinematicInclination::kinematic_inclination_deg, "kinematic_inclination_deg", "lambda_K",
              "deg", any(), "against the plane normal to the resultant velocity");
  source
      .function<&block_feed_limit>("block_feed_limit", "Largest feed the control sustains with short blocks.",
                                   "eq. (6)", Provenance::paper)
      .input(&Block::block_length_mm, "block_length_mm", "L_block", "mm", positive(), "length of a block",
             0.01)
      .input(&Block::block_time_ms, "block_time_ms", "t_block", "ms", positive(), "time for a block", 2.0)
      .output(&FeedLimit::max_feed_mm_min, "max_feed_mm_min", "F_max", "mm/min", positive(), "largest feed");
  source
      .function<&block_length_for_tolerance>("block_length_for_tolerance",
                                             "Longest block within a chord tolerance.", "completion",
                                             Provenance::completion)
      .input(&ChordTolerance::path_radius_mm, "path_radius_mm", "R", "mm", positive(), "radius of the path",
             16.0)
      .input(&ChordTolerance::chord_tolerance_mm, "chord_tolerance_mm", "tol", "mm", positive(),
             "chord tolerance, up to the radius", 0.001)
      .output(&BlockLength::block_length_mm, "block_length_mm", "L", "mm", positive(), "longest block");
  source
      .function<&uncut_chip_thickness>("uncut_chip_thickness", "Uncut chip thickness.", "behind the example",
                                       Provenance::completion)
      .input(&LeadCut::feed_mm, "feed_mm", "f", "mm", non_negative(), "feed", 0.1)
      .input(&LeadCut::lead_angle_deg, "lead_angle_deg", "kappa", "deg", closed(0, 180), "lead angle", 90.0)
      .output(&ChipThickness::thickness_mm, "thickness_mm", "a", "mm", non_negative(), "chip thickness");
  source
      .function<&flat_layer>("flat_layer", "Layer of a flat on a bar.", "behind the printed angles",
                             Provenance::repaired)
      .with(layer)
      .output(&FlatLayer::edge_angle_deg, "edge_angle_deg", "alpha", "deg", closed(0, 90),
              "half of the angle the layer takes on the bar")
      .output(&FlatLayer::x_travel_mm, "x_travel_mm", "Delta X", "mm", non_negative(), "travel of X")
      .output(&FlatLayer::width_mm, "width_mm", "-", "mm", non_negative(), "width of the flat");
  source
      .function<&flat_projection>("flat_projection", "Projection of a flat on X, as printed.",
                                  "formula in the text", Provenance::paper)
      .input(&TiltedFlat::flat_length_mm, "flat_length_mm", "l", "mm", non_negative(), "length of the flat",
             7.0)
      .input(&TiltedFlat::tilt_deg, "tilt_deg", "alpha", "deg", any(), "tilt", 9.0)
      .output(&Projection::projection_mm, "projection_mm", "Delta X", "mm", any(), "projection")
      .note("This is not the X travel of the example: see flat_layer.");
  source
      .function<&flat_axis_law>("flat_axis_law", "Synchronised X and C axes that generate a flat.", "derived",
                                Provenance::completion)
      .with(flat)
      .input(&FlatTurn::rotation_deg, "rotation_deg", "theta", "deg", open(-90, 90),
             "tilt of the flat's normal from the line of centres", 12.6)
      .input(&FlatTurn::surface_feed_mm_min, "surface_feed_mm_min", "v_f", "mm/min", positive(),
             "feed along the flat", 400.0)
      .output(&FlatAxes::x_mm, "x_mm", "x", "mm", positive(), "distance of the axes")
      .output(&FlatAxes::flat_position_mm, "flat_position_mm", "s", "mm", any(),
              "position of the tool along the flat")
      .output(&FlatAxes::work_speed_rpm, "work_speed_rpm", "n_2", "rpm", non_negative(), "speed of the part")
      .output(&FlatAxes::x_feed_mm_min, "x_feed_mm_min", "x'", "mm/min", any(), "feed of X");
  source
      .function<&flat_x_increments>("flat_x_increments", "X moves of a flat for equal angular steps.",
                                    "derived", Provenance::completion)
      .with(flat)
      .input(&FlatSteps::half_angle_deg, "half_angle_deg", "-", "deg", open(0, 90),
             "rotation from the middle to either end", 12.6)
      .input(&FlatSteps::steps, "steps", "N", "1", closed(1, 100'000), "number of steps", 6)
      .output(&XIncrements::increments_mm, "increments_mm", "-", "mm", any(), "signed moves of X");
  source
      .function<&flat_step_error>("flat_step_error", "Errors of a flat made in angular steps.", "completion",
                                  Provenance::completion)
      .with(flat)
      .input(&FlatStep::rotation_deg, "rotation_deg", "theta", "deg", open(-90, 90), "middle of the step",
             12.0)
      .input(&FlatStep::step_deg, "step_deg", "2 h", "deg", positive(), "angular step", 1.0)
      .output(&StepErrors::interpolation_error_mm, "interpolation_error_mm", "-", "mm", any(),
              "error normal to the flat of a block linear in x and theta")
      .output(&StepErrors::step_along_flat_mm, "step_along_flat_mm", "ds", "mm", positive(),
              "step along the flat")
      .output(&StepErrors::imprint_scallop_mm, "imprint_scallop_mm", "-", "mm", non_negative(),
              "scallop between imprints; null when they do not meet");
  source
      .function<&flat_milling_time>("flat_milling_time", "Main time of a flat on a bar.", "completion",
                                    Provenance::completion)
      .input(&FlatPass::blank_radius_mm, "blank_radius_mm", "R", "mm", positive(), "radius of the bar", 16.0)
      .input(&FlatPass::depth_mm, "depth_mm", "t", "mm", positive(), "depth, up to the radius", 1.0)
      .input(&FlatPass::width_of_cut_mm, "width_of_cut_mm", "a_e", "mm", positive(), "depth of one layer",
             0.5)
      .input(&FlatPass::flat_axial_length_mm, "flat_axial_length_mm", "-", "mm", positive(),
             "length of the flat along the bar", 20.0)
      .input(&FlatPass::axial_depth_mm, "axial_depth_mm", "a_p", "mm", positive(), "axial depth of one pass",
             8.0)
      .input(&FlatPass::tool_radius_mm, "tool_radius_mm", "R_1", "mm", non_negative(), "radius of the tool",
             10.0)
      .input(&FlatPass::surface_feed_mm_min, "surface_feed_mm_min", "v_f", "mm/min", positive(),
             "feed along the flat", 400.0)
      .output(&FlatTime::layers, "layers", "-", "1", at_least(1), "number of layers")
      .output(&FlatTime::axial_passes, "axial_passes", "-", "1", at_least(1), "number of axial passes")
      .output(&FlatTime::path_length_mm, "path_length_mm", "-", "mm", positive(), "path of the tool centre")
      .output(&FlatTime::time_min, "time_min", "-", "min", positive(), "main time")
      .note("Each layer counts from first to last touch of the full blank: slightly long for later layers.");
  source
      .function<&flat_milling_speeds>("flat_milling_speeds", "Cutting speed along a flat.", "derived",
                                      Provenance::completion)
      .with(layer)
      .input(&FlatCut::tool_radius_mm, "tool_radius_mm", "R_1", "mm", non_negative(), "radius of the tool",
             10.0)
      .input(&FlatCut::tool_speed_rpm, "tool_speed_rpm", "n_1", "rpm", non_negative(), "speed of the tool",
             3000.0)
      .input(&FlatCut::surface_feed_mm_min, "surface_feed_mm_min", "v_f", "mm/min", positive(),
             "feed along the flat", 400.0)
      .input(&FlatCut::mode, "mode", "-", "-", no_range(), "down or up milling", "down")
      .output(&FlatSpeeds::entry_speed_m_min, "entry_speed_m_min", "v", "m/min", non_negative(), "at entry")
      .output(&FlatSpeeds::middle_speed_m_min, "middle_speed_m_min", "v", "m/min", non_negative(),
              "in the middle")
      .output(&FlatSpeeds::exit_speed_m_min, "exit_speed_m_min", "v", "m/min", non_negative(), "at exit");
  source
      .function<&finishing_rule>("finishing_rule", "Whether high-speed finishing may replace grinding.",
                                 "text", Provenance::paper)
      .input(&FinishingRegime::cutting_speed_m_min, "cutting_speed_m_min", "v", "m/min", non_negative(),
             "cutting speed", 600.0)
      .input(&FinishingRegime::depth_to_feed_ratio, "depth_to_feed_ratio", "-", "1", non_negative(),
             "depth of cut over feed", 0.2)
      .optional(&FinishingRegime::ratio_limit, "ratio_limit", "-", "1", positive(), "largest ratio")
      .output(&FinishingRule::applies, "applies", "-", "-", no_range(), "the rule applies")
      .output(&FinishingRule::ra_min_um, "ra_min_um", "Ra", "um", positive(),
              "lower Ra; null when the rule does not apply")
      .output(&FinishingRule::ra_max_um, "ra_max_um", "Ra", "um", positive(),
              "upper Ra; null when the rule does not apply")
      .note("An experience value. The printed ratio reads like a swap of depth and feed.");
}

}  // namespace verstat::models::s4
