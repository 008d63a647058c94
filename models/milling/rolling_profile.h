#pragma once
// One side of a profile, y = f(z): polynomial, arc or natural cubic spline, with what rolling generation asks
// of it: slope, arc length, points of a given slope and crossings with a line (S2).

#include <optional>
#include <string_view>
#include <vector>

namespace verstat::models::s2 {

struct Profile;

class ProfileSide {
 public:
  /// Throws DomainError naming `name`/member when the profile is not complete or its range does not fit.
  ProfileSide(const Profile& profile, std::string_view name);

  [[nodiscard]] double z_min() const { return z_min_; }
  [[nodiscard]] double z_max() const { return z_max_; }
  [[nodiscard]] bool covers(double z_mm) const { return z_mm >= z_min_ && z_mm <= z_max_; }
  [[nodiscard]] double y(double z_mm) const;
  [[nodiscard]] double slope(double z_mm) const;
  /// Along the curve, negative when to < from. Exact for arcs, else to 1e-12.
  [[nodiscard]] double arc_length(double from_mm, double to_mm) const;
  /// Point with f'(z) = slope nearest to z; none when there is none in the range.
  [[nodiscard]] std::optional<double> nearest_with_slope(double slope, double z_mm) const;
  /// Largest z <= `upper_mm` where the curve meets the line through (z0, y0) with a slope.
  [[nodiscard]] std::optional<double> last_on_line(double z0_mm, double y0_mm, double slope,
                                                   double upper_mm) const;

 private:
  // f(z) = c0 + c1 (z - origin) + ... for z in [from, to].
  struct Piece {
    double origin, from, to;
    std::vector<double> coefficients;
    std::vector<double> slope_coefficients;
  };
  void add_piece(double origin, double from, double to, std::vector<double> coefficients);
  void add_spline(const std::vector<double>& z, const std::vector<double>& y);
  [[nodiscard]] const Piece& piece_at(double z_mm) const;

  double z_min_;
  double z_max_;
  bool arc_ = false;
  double zc_ = 0, yc_ = 0, r_ = 0;
  std::vector<Piece> pieces_;  // empty for an arc
};

}  // namespace verstat::models::s2
