// Geometry of K412: profile of the roll, contact with the pipe, fillets to the faces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "models/math/ellipse_distance.h"
#include "models/math/solve.h"
#include "models/toolpath/straightening_roll_contour.h"

namespace verstat::models::k412 {

TurnedContour checked(const Contour& contour) {
  const auto& y = contour.y_mm;
  const auto& x = contour.x_radius_mm;
  require(x.size() == y.size(), "x_radius_mm", static_cast<std::int64_t>(x.size()),
          fmt::format("entries: must have as many as y_mm, {}", y.size()));
  TurnedContour points;
  points.reserve(y.size());
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (k > 0) {
      require(y[k] >= y[k - 1], fmt::format("y_mm/{}", k), y[k], "must not be below the point before it");
      require(y[k] != y[k - 1] || x[k] != x[k - 1], fmt::format("y_mm/{}", k), y[k],
              "repeats the point before it: neighbouring points must differ");
    }
    points.push_back({y[k], x[k]});
  }
  return points;
}

Contour to_lists(const TurnedContour& contour) {
  Contour lists;
  lists.y_mm.reserve(contour.size());
  lists.x_radius_mm.reserve(contour.size());
  for (const auto& [axial, radius] : contour) {
    lists.y_mm.push_back(axial);
    lists.x_radius_mm.push_back(radius);
  }
  return lists;
}

namespace {

constexpr double degree = std::numbers::pi / 180;

// Profile by the complement epsilon = 90 deg - phi, which is exactly 0 at the throat.
struct Profile {
  explicit Profile(const RollAndPipe& roll)
      : throat_mm(roll.throat_diameter_mm),
        pipe_mm(roll.pipe_diameter_mm),
        right_angle(roll.crossing_angle_deg == 90),
        sin_alpha(right_angle ? 1 : std::sin(roll.crossing_angle_deg * degree)),
        cos_alpha(right_angle ? 0 : std::cos(roll.crossing_angle_deg * degree)),
        half_cot_mm((throat_mm + pipe_mm) / 2 * cos_alpha * cos_alpha / sin_alpha) {}

  [[nodiscard]] double y_mm(double epsilon) const {
    return half_cot_mm * std::tan(epsilon) + pipe_mm / 2 * sin_alpha * std::sin(epsilon);
  }
  [[nodiscard]] double diameter_mm(double epsilon) const {
    const double c = std::cos(epsilon);
    // sqrt(1 - cos^2 phi sin^2 alpha)
    return (throat_mm + pipe_mm * (1 - c)) / c * std::hypot(c, std::sin(epsilon) * cos_alpha);
  }
  [[nodiscard]] double epsilon_at(double y) const {
    const double place = std::abs(y);
    if (right_angle) {
      require(place < pipe_mm / 2, "y_mm", y, "must stay within half the pipe diameter at alpha = 90 deg");
      return std::asin(2 * place / pipe_mm);
    }
    // The first term alone reaches the place at this angle, both together sooner.
    const double high = std::atan2(place, half_cot_mm);
    return find_root([&](double epsilon) { return y_mm(epsilon) - place; }, 0,
                     std::min(high * (1 + 1e-9), std::numbers::pi / 2));
  }

  double throat_mm, pipe_mm;
  bool right_angle;
  double sin_alpha, cos_alpha, half_cot_mm;
};

double phi_deg(double epsilon) {
  return 90 - epsilon / degree;
}

TurnedContour sampled(const ProfileSampling& in) {
  require(in.n_points % 2 == 1, "n_points", in.n_points, "must be odd: one point is the throat");
  const Profile profile(in);
  require(!profile.right_angle || in.half_length_mm < in.pipe_diameter_mm / 2, "half_length_mm",
          in.half_length_mm, "must be below half the pipe diameter at alpha = 90 deg");
  const auto middle = static_cast<std::size_t>(in.n_points / 2);
  TurnedContour points(2 * middle + 1);
  for (std::size_t k = 0; k <= middle; ++k) {
    const double y = in.half_length_mm * static_cast<double>(k) / static_cast<double>(middle);
    const double radius = profile.diameter_mm(profile.epsilon_at(y)) / 2;
    points[middle + k] = {y, radius};
    points[middle - k] = {-y, radius};
  }
  points[middle].axial_mm = 0;
  return points;
}

EndFillet fillet(const ContourPoint& end, const ContourPoint& before, double radius_mm) {
  const double beta = std::atan2(end.radius_mm - before.radius_mm, end.axial_mm - before.axial_mm);
  const double x_c = end.radius_mm - radius_mm * std::cos(beta);
  require(x_c >= 0, "R_c_mm", radius_mm, "must leave the centre of the fillet outside the roll axis");
  const double y_c = end.axial_mm + radius_mm * std::sin(beta);
  return {beta / degree,
          y_c,
          x_c,
          2 * (x_c + radius_mm),
          y_c + radius_mm,
          radius_mm * (std::numbers::pi / 2 + beta)};
}

// Distance of roll and pipe at one section: the circle of the section, seen along the pipe axis, is an
// ellipse.
double section_gap_mm(const ContourPoint& section, double pipe_diameter_mm, double alpha_deg,
                      double centre_distance_mm) {
  const double cos_alpha = alpha_deg == 90 ? 0 : std::cos(alpha_deg * degree);
  return ellipse_distance(section.radius_mm, section.radius_mm * cos_alpha, centre_distance_mm,
                          section.axial_mm * std::sin(alpha_deg * degree)) -
         pipe_diameter_mm / 2;
}

struct GapRange {
  double least, largest;
};
GapRange gap_range(const TurnedContour& roll, double pipe_diameter_mm, double alpha_deg,
                   double centre_distance_mm) {
  GapRange range{1e300, -1e300};
  for (const ContourPoint& section : roll) {
    const double gap = section_gap_mm(section, pipe_diameter_mm, alpha_deg, centre_distance_mm);
    range.least = std::min(range.least, gap);
    range.largest = std::max(range.largest, gap);
  }
  return range;
}

}  // namespace

ProfilePoint roll_profile_point(const ProfileAngle& in) {
  return guarded<&roll_profile_point>(in, [&] {
    const Profile profile(in);
    const double epsilon = (90 - in.phi_deg) * degree;
    return ProfilePoint{profile.diameter_mm(epsilon), profile.y_mm(epsilon)};
  });
}

Phi roll_phi_at_y(const ProfilePlace& in) {
  return guarded<&roll_phi_at_y>(in, [&] { return Phi{phi_deg(Profile(in).epsilon_at(in.y_mm))}; });
}

RollProfile roll_profile(const ProfileSampling& in) {
  return guarded<&roll_profile>(in, [&] {
    const TurnedContour points = sampled(in);
    const Profile profile(in);
    const double cot = profile.cos_alpha / profile.sin_alpha;
    return RollProfile{to_lists(points), phi_deg(profile.epsilon_at(in.half_length_mm)),
                       2 * points.back().radius_mm,
                       (profile.throat_mm + profile.pipe_mm) / 2 * cot * cot + profile.pipe_mm / 2};
  });
}

RollGap roll_pipe_gap(const RollSetup& in) {
  return guarded<&roll_pipe_gap>(in, [&] {
    RollGap out{};
    for (const ContourPoint& section : checked(in))
      out.gap_mm.push_back(
          section_gap_mm(section, in.pipe_diameter_mm, in.crossing_angle_deg, in.centre_distance_mm));
    const auto [least, largest] = std::minmax_element(out.gap_mm.begin(), out.gap_mm.end());
    out.gap_min_mm = *least;
    out.gap_max_mm = *largest;
    return out;
  });
}

RollFit roll_pipe_fit(const FitSearch& in) {
  return guarded<&roll_pipe_fit>(in, [&] {
    require(in.alpha_min_deg <= in.alpha_max_deg, "alpha_min_deg", in.alpha_min_deg,
            "must not be above alpha_max_deg");
    const TurnedContour roll = checked(in);
    const auto [least, largest] = std::minmax_element(
        roll.begin(), roll.end(),
        [](const ContourPoint& a, const ContourPoint& b) { return a.radius_mm < b.radius_mm; });
    const double low = least->radius_mm;
    const double high = largest->radius_mm + in.pipe_diameter_mm;
    const auto touching_mm = [&](double alpha_deg) {
      const auto gap = [&](double distance) {
        return gap_range(roll, in.pipe_diameter_mm, alpha_deg, distance).least;
      };
      if (gap(low) > 0) reject("the pipe does not reach the roll at any centre distance from its throat");
      return find_root(gap, low, high, 1e-13);
    };
    const auto worst_mm = [&](double alpha_deg) {
      return gap_range(roll, in.pipe_diameter_mm, alpha_deg, touching_mm(alpha_deg)).largest;
    };
    constexpr int cells = 40;
    const auto node = [&](int k) {
      return in.alpha_min_deg + (in.alpha_max_deg - in.alpha_min_deg) * k / cells;
    };
    int best = 0;
    double best_mm = worst_mm(node(0));
    for (int k = 1; k <= cells; ++k)
      if (const double here = worst_mm(node(k)); here < best_mm) {
        best = k;
        best_mm = here;
      }
    const Minimum minimum =
        minimize_unimodal(worst_mm, node(std::max(best - 1, 0)), node(std::min(best + 1, cells)), 1e-8);
    const double alpha_deg = minimum.value < best_mm ? minimum.x : node(best);
    return RollFit{alpha_deg, touching_mm(alpha_deg), worst_mm(alpha_deg)};
  });
}

EndFillet roll_end_fillet(const ProfileEnd& in) {
  return guarded<&roll_end_fillet>(in, [&] {
    require(in.y_k_mm > in.y_k1_mm, "y_k", in.y_k_mm, "must be above y_k1: the right end of the profile");
    require(in.x_k_mm >= in.x_k1_mm, "x_k", in.x_k_mm, "must not be below x_k1: the profile rises");
    return fillet({in.y_k_mm, in.x_k_mm}, {in.y_k1_mm, in.x_k1_mm}, in.fillet_radius_mm);
  });
}

RollContour roll_contour(const ContourSampling& in) {
  return guarded<&roll_contour>(in, [&] {
    const TurnedContour profile = sampled(in);
    const EndFillet end = fillet(profile.back(), profile[profile.size() - 2], in.fillet_radius_mm);
    const double from = -end.beta_deg * degree;
    TurnedContour right;
    for (std::int64_t k = 1; k <= in.arc_points; ++k) {
      const double t =
          from + (std::numbers::pi / 2 - from) * static_cast<double>(k) / static_cast<double>(in.arc_points);
      right.push_back(
          {end.y_c_mm + in.fillet_radius_mm * std::sin(t), end.x_c_mm + in.fillet_radius_mm * std::cos(t)});
    }
    TurnedContour points;
    for (auto p = right.rbegin(); p != right.rend(); ++p) points.push_back({-p->axial_mm, p->radius_mm});
    points.insert(points.end(), profile.begin(), profile.end());
    points.insert(points.end(), right.begin(), right.end());
    double largest = end.max_diameter_mm;
    for (const ContourPoint& p : points) largest = std::max(largest, 2 * p.radius_mm);
    return RollContour{to_lists(points), largest, contour_length_mm(points)};
  });
}

}  // namespace verstat::models::k412
