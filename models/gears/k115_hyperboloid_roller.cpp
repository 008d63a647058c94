#include "models/gears/k115_hyperboloid_roller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace verstat::models::k115 {
namespace detail {

Turn::Turn(double angle_rad) : sine(std::sin(angle_rad)), cosine(std::cos(angle_rad)) {}

Point to_roller(const Point& tool, const Turn& tool_turn, const Turn& roller_turn, const Turn& shaft_angle,
                double centre_distance_mm, double tangential_shift_mm) {
  const auto [s1, c1] = tool_turn;
  const auto [s2, c2] = roller_turn;
  const auto [sg, cg] = shaft_angle;
  const auto [x, y, z] = tool;
  return {.x = x * (c2 * c1 + s1 * s2 * cg) + y * (s2 * c1 * cg - s1 * c2) - z * s2 * sg +
               centre_distance_mm * c2,
          .y = x * (s1 * c2 * cg - s2 * c1) + y * (s1 * s2 + c1 * c2 * cg) - z * c2 * sg -
               centre_distance_mm * s2,
          .z = x * s1 * sg + y * c1 * sg + z * cg + tangential_shift_mm};
}

}  // namespace detail

namespace {

using detail::Point;
using detail::Turn;

constexpr double radians_per_degree = std::numbers::pi / 180;

struct Contact {
  double tool_turn_deg;
  double roller_turn_deg;
  Point point;
};

// The flank of the tool gear at one roll angle, in mesh with the roller: everything but the axial position.
class Mesh {
 public:
  template <class In>
  explicit Mesh(const In& in)
      : u21_(-static_cast<double>(in.tool_teeth) / static_cast<double>(in.roller_starts)),
        shaft_angle_(in.shaft_angle_deg * radians_per_degree),
        centre_distance_mm_(
            in.centre_distance_mm.value_or(0.5 * in.module_mm *
                                           (static_cast<double>(in.tool_teeth) +
                                            static_cast<double>(in.roller_starts) / shaft_angle_.cosine))),
        tangential_shift_mm_(in.tangential_shift_mm),
        base_radius_mm_(0.5 * in.module_mm * static_cast<double>(in.tool_teeth) *
                        std::cos(in.pressure_angle_deg * radians_per_degree)),
        roll_angle_(in.roll_angle_deg * radians_per_degree),
        branch_(static_cast<double>(in.branch)),
        flank_(static_cast<double>(in.flank)) {
    const double sine = std::sin(roll_angle_);
    const double cosine = std::cos(roll_angle_);
    x_mm_ = base_radius_mm_ * (cosine + roll_angle_ * sine);
    y_mm_ = flank_ * base_radius_mm_ * (sine - roll_angle_ * cosine);
  }

  // Where the flank at the axial position Z touches the roller: eq. (4), then eq. (1).
  [[nodiscard]] std::optional<Contact> contact(double axial_position_mm) const {
    const double a = centre_distance_mm_ * u21_ * shaft_angle_.cosine;
    double b = -flank_ * axial_position_mm * u21_ * shaft_angle_.sine;
    if (b == 0) b = 0;  // no negative zero: atan2 would turn by 360 deg
    const double c = (1 - u21_ * shaft_angle_.cosine) * base_radius_mm_;
    const double reach = std::hypot(a, b);
    if (std::abs(c) > reach) return std::nullopt;
    const double theta = std::atan2(b, a) + branch_ * std::acos(c / reach);
    double tool_turn_deg = std::fmod(flank_ * (theta - roll_angle_) / radians_per_degree, 360.0);
    if (tool_turn_deg < 0) tool_turn_deg += 360;
    if (tool_turn_deg >= 360) tool_turn_deg = 0;  // a tiny negative angle rounds to 360
    const double roller_turn_deg = u21_ * tool_turn_deg;
    return Contact{
        tool_turn_deg, roller_turn_deg,
        detail::to_roller({x_mm_, y_mm_, axial_position_mm}, Turn(tool_turn_deg * radians_per_degree),
                          Turn(roller_turn_deg * radians_per_degree), shaft_angle_, centre_distance_mm_,
                          tangential_shift_mm_)};
  }

  // Axial position whose contact lies in the plane z2 = section, by the secant method.
  [[nodiscard]] std::optional<double> position_of_section(double section_mm) const {
    constexpr double tolerance_mm = 1e-12;
    constexpr int most_steps = 100;
    double before = 0;
    double now = 1;
    std::optional<double> off_before = off_section(before, section_mm);
    if (!off_before) return std::nullopt;
    if (std::abs(*off_before) < tolerance_mm) return before;
    for (int step = 0; step < most_steps; ++step) {
      const std::optional<double> off_now = off_section(now, section_mm);
      if (!off_now) return std::nullopt;
      // A large roller cannot come nearer than the rounding of its coordinates.
      const double rounding_mm = 4 * std::numeric_limits<double>::epsilon() *
                                 (std::abs(x_mm_) + std::abs(y_mm_) + std::abs(now) + std::abs(section_mm));
      if (std::abs(*off_now) < std::max(tolerance_mm, rounding_mm)) return now;
      if (*off_now == *off_before) return std::nullopt;
      const double change = -*off_now * (now - before) / (*off_now - *off_before);
      before = now;
      off_before = off_now;
      now += change;
      if (std::abs(change) < tolerance_mm) return now;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<double> off_section(double axial_position_mm, double section_mm) const {
    const auto touched = contact(axial_position_mm);
    if (!touched) return std::nullopt;
    return touched->point.z - section_mm;
  }

  double u21_;
  Turn shaft_angle_;
  double centre_distance_mm_;
  double tangential_shift_mm_;
  double base_radius_mm_;
  double roll_angle_;
  double branch_;
  double flank_;
  double x_mm_ = 0;
  double y_mm_ = 0;
};

template <class In>
void require_signs(const In& in) {
  require(in.branch != 0, "branch", in.branch, "must be 1 or -1");
  require(in.flank != 0, "flank", in.flank, "must be 1 or -1");
}

}  // namespace

PitchGeometry roller_pitch_geometry(const CrossedPair& in) {
  return guarded<&roller_pitch_geometry>(in, [&] {
    const auto tool_teeth = static_cast<double>(in.tool_teeth);
    const auto starts = static_cast<double>(in.roller_starts);
    const double diameter_mm = in.module_mm * starts / std::cos(in.shaft_angle_deg * radians_per_degree);
    return PitchGeometry{diameter_mm, (in.module_mm * tool_teeth + diameter_mm) / 2, -tool_teeth / starts};
  });
}

RollerPoint hyperboloid_roller_point(const RollerFlank& in) {
  return guarded<&hyperboloid_roller_point>(in, [&] {
    require_signs(in);
    const auto touched = Mesh(in).contact(in.axial_position_mm);
    if (!touched) return RollerPoint{};
    const Point& p = touched->point;
    return RollerPoint{touched->tool_turn_deg, touched->roller_turn_deg, p.x, p.y, p.z, std::hypot(p.x, p.y)};
  });
}

SectionPoint hyperboloid_roller_section_point(const RollerSection& in) {
  return guarded<&hyperboloid_roller_section_point>(in, [&] {
    require_signs(in);
    const Mesh mesh(in);
    const auto position_mm = mesh.position_of_section(in.section_mm);
    if (!position_mm) return SectionPoint{};
    const auto touched = mesh.contact(*position_mm);
    if (!touched) return SectionPoint{};
    const Point& p = touched->point;
    return SectionPoint{p.x, p.y, std::hypot(p.x, p.y), touched->tool_turn_deg, *position_mm};
  });
}

BlankRadius ruled_hyperboloid_radius(const Blank& in) {
  return guarded<&ruled_hyperboloid_radius>(in, [&] {
    return BlankRadius{
        std::hypot(in.throat_radius_mm, in.z_mm * std::tan(in.shaft_angle_deg * radians_per_degree))};
  });
}

RollingQuality gear_rolling_quality(const RollerChoice& in) {
  return guarded<&gear_rolling_quality>(in, [&] {
    return in.roller == Roller::hyperboloid ? RollingQuality{0.25, 7} : RollingQuality{1, std::nullopt};
  });
}

DesignRange roller_design_range(const NoInputs& in) {
  return guarded<&roller_design_range>(in, [] {
    return DesignRange{.starts_min = 13,
                       .starts_max = 33,
                       .pitch_diameter_min_mm = 31,
                       .pitch_diameter_max_mm = 82,
                       .helix_min_deg = 14,
                       .helix_max_deg = 44};
  });
}

namespace {

void teeth(auto& f, auto pointer) {
  f.input(pointer, "z1", "z1", "1", at_least(5), "teeth of the tool gear", 34);
}
void starts(auto& f, auto pointer) {
  f.input(pointer, "z2", "z2", "1", at_least(5), "starts of the roller", 17);
}
void module_mm(auto& f, auto pointer) {
  f.input(pointer, "module_mm", "m", "mm", closed(0.2, 50), "module", 2.0);
}
void shaft_angle(auto& f, auto pointer) {
  f.input(pointer, "gamma_deg", "gamma", "deg", closed(0, 60), "shaft angle, the helix angle of the roller",
          30.0);
}

template <class In>
void flank_fields(auto& f, auto place) {
  teeth(f, &In::tool_teeth);
  module_mm(f, &In::module_mm);
  f.input(&In::pressure_angle_deg, "alpha_deg", "alpha", "deg", closed(5, 40),
          "transverse pressure angle of the tool gear", 20.0);
  starts(f, &In::roller_starts);
  shaft_angle(f, &In::shaft_angle_deg);
  f.input(&In::roll_angle_deg, "psi_deg", "psi", "deg", closed(0, 60), "roll angle of the involute", 20.0);
  place(f);
  f.input(&In::branch, "branch", "-", "1", closed(-1, 1), "1 working branch, -1 the other root", 1)
      .input(&In::flank, "flank", "f", "1", closed(-1, 1), "side of the tooth, 1 or -1", 1)
      .optional(&In::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
                "shortest centre distance; null for that of roller_pitch_geometry")
      .optional(&In::tangential_shift_mm, "tangential_shift_mm", "S_T", "mm", any(),
                "shift along the roller axis");
}

void describe_surface(Source& source) {
  source
      .function<&roller_pitch_geometry>("roller_pitch_geometry",
                                        "Pitch diameter, centre distance and ratio of tool gear and roller.",
                                        "completion (crossed helical pair)", Provenance::completion)
      .with([](auto& f) { starts(f, &CrossedPair::roller_starts); })
      .with([](auto& f) { module_mm(f, &CrossedPair::module_mm); })
      .with([](auto& f) { shaft_angle(f, &CrossedPair::shaft_angle_deg); })
      .with([](auto& f) { teeth(f, &CrossedPair::tool_teeth); })
      .output(&PitchGeometry::pitch_diameter_mm, "pitch_diameter_mm", "d2", "mm", positive(),
              "pitch diameter of the roller")
      .output(&PitchGeometry::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
              "shortest centre distance")
      .output(&PitchGeometry::ratio_u21, "ratio_u21", "u21", "1", below(0),
              "angular speed of the roller over that of the tool gear");
  const std::string no_check =
      "No check of tip limits, undercut or interference: the tool gear cuts only up to its tip, and past the "
      "smallest radius the points are no part of a tooth.";
  source
      .function<&hyperboloid_roller_point>("hyperboloid_roller_point", "A point of the roller tooth surface.",
                                           "eqs. (1), (2), (4)", Provenance::repaired)
      .with([](auto& f) {
        flank_fields<RollerFlank>(f, [](auto& g) {
          g.input(&RollerFlank::axial_position_mm, "Z_mm", "Z", "mm", any(),
                  "axial position on the tool gear, z1 + S0", 4.0);
        });
      })
      .output(&RollerPoint::tool_turn_deg, "phi1_deg", "phi1", "deg", open_high(0, 360),
              "turn of the tool gear; null when the flank does not touch")
      .output(&RollerPoint::roller_turn_deg, "phi2_deg", "phi2", "deg", any(), "turn of the roller")
      .output(&RollerPoint::x_mm, "x2_mm", "x2", "mm", any(), "coordinate on the roller")
      .output(&RollerPoint::y_mm, "y2_mm", "y2", "mm", any(), "coordinate on the roller")
      .output(&RollerPoint::z_mm, "z2_mm", "z2", "mm", any(), "coordinate along the roller axis")
      .output(&RollerPoint::radius_mm, "radius_mm", "-", "mm", non_negative(),
              "distance from the roller axis")
      .note(
          "x2 and y2 depend on the reduction of phi1 to 0..360 deg (a full turn moves the point by z1 roller "
          "teeth); radius and z2 do not.")
      .note("Involute flank, pressure angle and default centre distance are completions.")
      .note(no_check);
  source
      .function<&hyperboloid_roller_section_point>("hyperboloid_roller_section_point",
                                                   "A point of the roller profile in a cross section.",
                                                   "eqs. (1), (4) solved for z2", Provenance::completion)
      .with([](auto& f) {
        flank_fields<RollerSection>(f, [](auto& g) {
          g.input(&RollerSection::section_mm, "z_section_mm", "z2", "mm", any(),
                  "plane of the section along the roller axis", 5.0);
        });
      })
      .output(&SectionPoint::x_mm, "x2_mm", "x2", "mm", any(), "coordinate; null when there is no such point")
      .output(&SectionPoint::y_mm, "y2_mm", "y2", "mm", any(), "coordinate on the roller")
      .output(&SectionPoint::radius_mm, "radius_mm", "-", "mm", non_negative(),
              "distance from the roller axis")
      .output(&SectionPoint::tool_turn_deg, "phi1_deg", "phi1", "deg", open_high(0, 360),
              "turn of the tool gear")
      .output(&SectionPoint::axial_position_mm, "Z_mm", "Z", "mm", any(), "axial position on the tool gear")
      .note(no_check);
  source
      .function<&ruled_hyperboloid_radius>("ruled_hyperboloid_radius",
                                           "Radius of the hyperboloid blank along its axis.", "(5)",
                                           Provenance::completion)
      .input(&Blank::throat_radius_mm, "throat_radius_mm", "R0", "mm", positive(), "radius of the throat",
             20.0)
      .with([](auto& f) { shaft_angle(f, &Blank::shaft_angle_deg); })
      .input(&Blank::z_mm, "z_mm", "z", "mm", any(), "distance from the throat along the axis", 10.0)
      .output(&BlankRadius::radius_mm, "radius_mm", "R", "mm", positive(), "radius");
}

void describe_results(Source& source) {
  source
      .function<&gear_rolling_quality>("gear_rolling_quality", "Quality of gears rolled with a roller.",
                                       "measured", Provenance::paper)
      .input(&RollerChoice::roller, "roller", "-", "-", no_range(), "kind of roller", "hyperboloid")
      .output(&RollingQuality::profile_error_factor, "profile_error_factor", "-", "1", positive(),
              "profile error over that of conventional rolling")
      .output(&RollingQuality::accuracy_grade, "accuracy_grade", "-", "1", at_least(1),
              "accuracy grade of the gear; null when not given");
  source
      .function<&roller_design_range>("roller_design_range", "Range of the rollers actually made.", "text",
                                      Provenance::paper)
      .output(&DesignRange::starts_min, "z2_min", "z2", "1", at_least(1), "fewest starts")
      .output(&DesignRange::starts_max, "z2_max", "z2", "1", at_least(1), "most starts")
      .output(&DesignRange::pitch_diameter_min_mm, "pitch_diameter_min_mm", "d2", "mm", positive(),
              "smallest pitch diameter")
      .output(&DesignRange::pitch_diameter_max_mm, "pitch_diameter_max_mm", "d2", "mm", positive(),
              "largest pitch diameter")
      .output(&DesignRange::helix_min_deg, "helix_min_deg", "beta", "deg", positive(), "smallest helix angle")
      .output(&DesignRange::helix_max_deg, "helix_max_deg", "beta", "deg", positive(), "largest helix angle");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K115",
       .title = "Increase of teeth knurling strengthening precision",
       .authors = "Vitrenko O. S., Bielozorova V. V., Kyrychenko I. O., Kuzmenko N. M.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Gear teeth are finished by rolling with a multi-start roller on crossed axes, whose tooth "
           "surface is the envelope of a spur tool gear travelling along the generatrix of a one-sheet "
           "hyperboloid. The profile error fell four times against conventional rollers, without a wave "
           "of displaced metal; grade 7 was reached.",
       .role = "gears",
       .errata = {
           "Eq. (1): the first cosine of x1 and the last of y1 in row 1 and the sign of y1 in row 3 are "
           "misprinted; only the repaired matrix is a rotation.",
           "Eq. (2): the first bracket is printed with x1 - r for x1, the second term with z1 alone for "
           "z1 + S0; repaired by n . (v1 - v2) = 0 with the axes of (1).",
           "Gears rolled: a later \"10\" teeth is a misprint of 100."}});
  describe_surface(source);
  describe_results(source);
}

}  // namespace verstat::models::k115
