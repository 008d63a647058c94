#pragma once
// Multi-start roller for the strengthening rolling of gear teeth (K115): its tooth surface is the envelope of
// a spur tool gear (index 1) that travels along the straight generatrix of a one-sheet hyperboloid, in
// crossed-axis mesh with the roller (index 2).
//
// Vitrenko, Bielozorova, Kyrychenko, Kuzmenko 2011. The paper keeps the flank general; the involute flank,
// the pitch geometry and the closed form of the contact angle are completions.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k115 {

struct CrossedPair {
  std::int64_t roller_starts = 5;
  double module_mm = 0;
  double shaft_angle_deg = 0;
  std::int64_t tool_teeth = 5;
};
struct PitchGeometry {
  double pitch_diameter_mm;
  double centre_distance_mm;
  double ratio_u21;
};
/// Pitch diameter m z2/cos(gamma), centre distance (m z1 + d2)/2 and signed ratio -z1/z2 of a spur tool gear
/// and a roller of helix angle gamma (0..60 deg). COMPLETION.
[[nodiscard]] PitchGeometry roller_pitch_geometry(const CrossedPair& in);

struct RollerFlank {
  std::int64_t tool_teeth = 5;
  double module_mm = 0;
  double pressure_angle_deg = 0;
  std::int64_t roller_starts = 5;
  double shaft_angle_deg = 0;
  double roll_angle_deg = 0;
  double axial_position_mm = 0;
  std::int64_t branch = 1;
  std::int64_t flank = 1;
  std::optional<double> centre_distance_mm;
  double tangential_shift_mm = 0;
};
struct RollerPoint {
  std::optional<double> tool_turn_deg;  // all null when the flank does not touch
  std::optional<double> roller_turn_deg;
  std::optional<double> x_mm;
  std::optional<double> y_mm;
  std::optional<double> z_mm;
  std::optional<double> radius_mm;
};
/// Point of the roller tooth surface touched at the involute roll angle psi 0..60 deg and the axial position
/// Z = z1 + S0 of the tool gear. K115 eqs. (1), (2), repaired, with the closed form (4) of the contact angle.
/// branch +1 is the working flank, -1 the root on the other line of action; flank +-1 the side of the tooth.
/// Null outputs when the meshing equation has no root, which needs a centre distance other than the default.
[[nodiscard]] RollerPoint hyperboloid_roller_point(const RollerFlank& in);

struct RollerSection {
  std::int64_t tool_teeth = 5;
  double module_mm = 0;
  double pressure_angle_deg = 0;
  std::int64_t roller_starts = 5;
  double shaft_angle_deg = 0;
  double roll_angle_deg = 0;
  double section_mm = 0;
  std::int64_t branch = 1;
  std::int64_t flank = 1;
  std::optional<double> centre_distance_mm;
  double tangential_shift_mm = 0;
};
struct SectionPoint {
  std::optional<double> x_mm;  // all null when there is no such point
  std::optional<double> y_mm;
  std::optional<double> radius_mm;
  std::optional<double> tool_turn_deg;
  std::optional<double> axial_position_mm;
};
/// Point of the roller profile in the plane z2 = const: the axial position is found by the secant method from
/// Z = 0 and 1 mm to 1e-12 mm within 100 steps. Null outputs when it does not converge or a trial position
/// has no contact. K115, section profile.
[[nodiscard]] SectionPoint hyperboloid_roller_section_point(const RollerSection& in);

struct Blank {
  double throat_radius_mm = 0;
  double shaft_angle_deg = 0;
  double z_mm = 0;
};
struct BlankRadius {
  double radius_mm;
};
/// Radius of the blank, a one-sheet hyperboloid of revolution, sqrt(R0^2 + z^2 tan^2 gamma). K115 (5).
[[nodiscard]] BlankRadius ruled_hyperboloid_radius(const Blank& in);

enum class Roller { hyperboloid, conventional };
struct RollerChoice {
  Roller roller = Roller::hyperboloid;
};
struct RollingQuality {
  double profile_error_factor;
  std::optional<std::int64_t> accuracy_grade;  // null for the conventional roller: not given
};
/// Profile error over that of conventional rolling and accuracy grade of the rolled gear. K115, measured.
[[nodiscard]] RollingQuality gear_rolling_quality(const RollerChoice& in);

struct NoInputs {};
struct DesignRange {
  std::int64_t starts_min;
  std::int64_t starts_max;
  double pitch_diameter_min_mm;
  double pitch_diameter_max_mm;
  double helix_min_deg;
  double helix_max_deg;
};
/// Range of the rollers actually made. K115, text.
[[nodiscard]] DesignRange roller_design_range(const NoInputs& in);

namespace detail {

struct Point {
  double x, y, z;
};
struct Turn {
  double sine, cosine;
  explicit Turn(double angle_rad);
};
/// K115 eq. (1), repaired: a point of the tool gear, z = z1 + S0 included, in the coordinates of the roller.
[[nodiscard]] Point to_roller(const Point& tool, const Turn& tool_turn, const Turn& roller_turn,
                              const Turn& shaft_angle, double centre_distance_mm, double tangential_shift_mm);

}  // namespace detail
}  // namespace verstat::models::k115

template <>
struct verstat::models::EnumNames<verstat::models::k115::Roller> {
  static constexpr std::array names{std::pair{k115::Roller::hyperboloid, "hyperboloid"},
                                    std::pair{k115::Roller::conventional, "conventional"}};
};
