#pragma once
// Milling of polygons on turning centres (K301): the path of the cutter centre around the part, the contour
// feed that an NC program really commands, and the feed law that keeps the largest tooth force constant.
//
// Petrakov, Klavak 2011. The cutter axis is parallel to the spindle, the turret moves along X, the spindle
// turns about C. Angles c are measured from the middle of a face, positive in the direction in which the
// cutter moves around the part; x is a radius unless x_is_diameter.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k301 {

struct Polygon {
  std::int64_t faces = 3;
  double apothem_mm = 0;  // half of across flats for even numbers of faces
  double cutter_radius_mm = 0;
};
struct ContourSummary {
  double vertex_radius_mm;
  double flat_half_angle_deg;  // c at the end of the straight part
  double x_min_mm;
  double x_max_mm;
  double path_length_mm;  // of the cutter centre
  double polygon_area_mm2;
};
/// Extremes, length and area of the contour: d = a + R, rho = a/cos(pi/N), theta_1 = atan(a tan(pi/N)/d),
/// L = 2 N a tan(pi/N) + 2 pi R. Derived, implied by K301 Fig. 1.
[[nodiscard]] ContourSummary polygon_contour_summary(const Polygon& in);

struct PolygonAtAngle : Polygon {
  double c_deg = 0;
};
struct ContourPoint {
  double x_mm;
  double dx_dc_mm_rad;
  double chi_deg;          // at the cutter centre, from the part axis to the contact, positive forward
  std::int64_t on_corner;  // 1 where the centre pivots about a vertex
};
/// Cutter centre at part angle c; dx/dc = x tan chi. Derived, implied by K301 Fig. 1.
[[nodiscard]] ContourPoint polygon_contour_point(const PolygonAtAngle& in);

struct NcProgram {
  std::vector<double> x_mm;  // as programmed
  std::vector<double> c_deg;
  std::vector<double> f_word;  // radial feed, mm/min; the modal value carried on
  bool x_is_diameter = false;
};
struct NcFeeds {
  std::vector<double> dx_dc_mm_rad;
  std::vector<double> c_rate_deg_min;
  std::vector<double> path_feed_mm_min;
};
/// Contour feed of an NC program whose F word is a radial feed: F_e = sqrt(F_x^2 + (x omega)^2), omega =
/// F_x/(dx/dc), dx/dc by central differences (one-sided at the ends). K301 eqs. (1)-(3), (2) repaired.
/// Error where dx or dc is zero.
[[nodiscard]] NcFeeds verify_gcode_feed(const NcProgram& in);

struct PathFeed {
  double path_feed_mm_min = 0;
  double x_mm = 0;
  double dx_dc_mm_rad = 0;
};
struct AxisFeeds {
  double radial_feed_mm_min;
  double c_rate_deg_min;
};
/// Radial feed and C rate for a contour feed: F_x = F_e |dx/dc|/sqrt((dx/dc)^2 + x^2), omega = F_x/|dx/dc|
/// (its limit F_e/x where dx/dc = 0). K301 eqs. (6), (2).
[[nodiscard]] AxisFeeds radial_feed_for_path_feed(const PathFeed& in);

struct ForceRecord {
  std::vector<double> c_deg;
  std::vector<double> force_n;
  std::vector<std::int64_t> start_index;  // 0-based, inclusive, one pair per tooth pass
  std::vector<std::int64_t> end_index;
};
struct PassMaxima {
  std::vector<double> c_at_max_deg;
  std::vector<double> max_force_n;
};
/// Largest force of every tooth pass; the first of equal values. K301 eq. (4).
[[nodiscard]] PassMaxima tooth_pass_maxima(const ForceRecord& in);

enum class FeedMode : std::uint8_t { radial, c_rate, inverse_time };
struct BlockMove {
  double x1_mm = 0;
  double c1_deg = 0;
  double x2_mm = 0;
  double c2_deg = 0;
  FeedMode mode = FeedMode::c_rate;
  bool x_is_diameter = false;
};
struct NcBlock : BlockMove {
  double f_word = 0;  // mm/min of radial travel, deg/min of C, or 1/min
};
struct BlockFeed {
  double chord_mm;  // length of the block in the frame of the part
  double path_feed_mm_min;
};
/// Contour feed of one block. Error when the axis that carries the feed does not move. COMPLETION.
[[nodiscard]] BlockFeed block_path_feed(const NcBlock& in);

struct FeedForBlock : BlockMove {
  double path_feed_mm_min = 0;
};
struct FeedWord {
  double f_word;
};
/// F word that gives a contour feed: inverse of block_path_feed. Error for a block of no length. COMPLETION.
[[nodiscard]] FeedWord feed_word_for_block(const FeedForBlock& in);

struct FlatPoints {
  std::vector<double> x_mm;
  std::vector<double> c_deg;
};
struct FlatFit {
  double x0_mm;   // a + R, or twice that in diameter programming
  double c0_deg;  // direction of the normal of the face
  double max_residual_mm;
};
/// Least-squares line X cos(C - c0) = X0 through points of one face. COMPLETION.
[[nodiscard]] FlatFit gcode_flat_fit(const FlatPoints& in);

struct RoundBlank : Polygon {
  double blank_radius_mm = 0;  // >= apothem
};
struct BlankAtAngle : RoundBlank {
  double c_deg = 0;
};
struct EngagedArc {
  double start_angle_deg;  // on the cutter, from the contact with the finished contour
  double exit_angle_deg;
  double radial_width_mm;
  std::int64_t in_cut;  // 1 or 0; all zeros when 0
};
/// Engaged arc of the cutter in a round blank: omega = acos[(x^2 + R^2 - R_b^2)/(2 R x)], exit = min(pi,
/// omega - chi), start = max(0, -omega - chi). COMPLETION C1.
[[nodiscard]] EngagedArc polygon_engagement(const BlankAtAngle& in);

struct ToothLoadCut {
  double start_angle_deg = 0;
  double exit_angle_deg = 0;
  double feed_per_tooth_mm = 0;
  double axial_depth_mm = 0;
  double cutter_radius_mm = 0;
  std::int64_t teeth = 1;
  double helix_deg = 0;
  double kc11_mpa = 0;
  double mc = 0;
};
struct MillingForce {
  double peak_force_n;
  double mean_force_n;
  double max_chip_mm;
};
/// Peak over one tooth pitch, and mean, of the total tangential force of a helical cutter (Kienzle). No arc
/// (exit <= start) gives zeros. COMPLETION C2.
[[nodiscard]] MillingForce peak_milling_force(const ToothLoadCut& in);

struct ForceLimitedCut : RoundBlank {
  double axial_depth_mm = 0;
  std::int64_t teeth = 1;
  double helix_deg = 0;
  double rpm = 0;
  double kc11_mpa = 0;
  double mc = 0;
  double force_limit_n = 0;
  double feed_min_mm_min = 0;
  double feed_max_mm_min = 0;
  double x_rate_max_mm_min = 0;
  double c_rate_max_deg_min = 0;
};
struct CutAtAngle : ForceLimitedCut {
  double c_deg = 0;
};
enum class FeedLimit : std::uint8_t { force, feed_max, feed_min, x_axis, c_axis };
struct StabilizedFeed {
  double path_feed_mm_min;
  double peak_force_n;
  double radial_feed_mm_min;
  double c_rate_deg_min;
  FeedLimit limited_by;
};
/// Contour feed that holds the peak force at its limit, F_e = n z (P/G)^(1/(1-mc)), then the bounds feed_max,
/// feed_min, X rate, C rate in this order; `limited_by` is the last that changed the feed. COMPLETION C3.
[[nodiscard]] StabilizedFeed stabilized_path_feed(const CutAtAngle& in);

enum class FeedStrategy : std::uint8_t { constant, stabilized };
struct PolygonPass : ForceLimitedCut {
  FeedStrategy strategy = FeedStrategy::stabilized;
  std::int64_t axial_passes = 1;
  double approach_mm = 0;
};
struct PolygonTime {
  double loop_time_min;  // one turn around the part
  double main_time_min;
  double feed_low_mm_min;
  double feed_high_mm_min;
  double peak_force_high_n;
  double peak_force_low_n;
};
/// Main time with the stabilised feed, or with one constant feed that the worst position allows: 100
/// midpoints on a flat, 100 on a corner. COMPLETION C4.
[[nodiscard]] PolygonTime polygon_milling_time(const PolygonPass& in);

}  // namespace verstat::models::k301

template <>
struct verstat::models::EnumNames<verstat::models::k301::FeedMode> {
  static constexpr std::array names{std::pair{k301::FeedMode::radial, "radial"},
                                    std::pair{k301::FeedMode::c_rate, "c_rate"},
                                    std::pair{k301::FeedMode::inverse_time, "inverse_time"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k301::FeedLimit> {
  static constexpr std::array names{
      std::pair{k301::FeedLimit::force, "force"}, std::pair{k301::FeedLimit::feed_max, "feed_max"},
      std::pair{k301::FeedLimit::feed_min, "feed_min"}, std::pair{k301::FeedLimit::x_axis, "x_axis"},
      std::pair{k301::FeedLimit::c_axis, "c_axis"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k301::FeedStrategy> {
  static constexpr std::array names{std::pair{k301::FeedStrategy::constant, "constant"},
                                    std::pair{k301::FeedStrategy::stabilized, "stabilized"}};
};
