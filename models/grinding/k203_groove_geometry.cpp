// Functions 1-8 of K203: contact of wheel and groove, and the tilt of the narrow wheel.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "models/grinding/k203_crossed_axis_groove_grinding.h"
#include "models/math/circle_fit.h"
#include "models/math/solve.h"

namespace verstat::models::k203 {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double slope_step_deg = 0.02;

struct Vector {
  double x, y, z;
};

// Point and (unscaled) normal of the groove, eqs. (1)-(3); p = lead / 2 pi.
struct SurfacePoint {
  Vector at, normal;
};
// The section at one phi, to be asked at many theta.
class GrooveSection {
 public:
  GrooveSection(const Groove& g, double phi)
      : p_(g.lead_mm / (2 * std::numbers::pi)),
        rho_(g.profile_radius_mm),
        sin_phi_(std::sin(phi)),
        cos_phi_(std::cos(phi)),
        y_(g.center_radius_mm + g.profile_radius_mm * cos_phi_) {}
  [[nodiscard]] SurfacePoint at(double theta) const {
    const double s = std::sin(theta);
    const double c = std::cos(theta);
    return {{-y_ * s, y_ * c, rho_ * sin_phi_ + p_ * theta},
            {p_ * sin_phi_ * c - y_ * cos_phi_ * s, y_ * cos_phi_ * c + p_ * sin_phi_ * s, y_ * sin_phi_}};
  }

 private:
  double p_, rho_, sin_phi_, cos_phi_, y_;
};
SurfacePoint groove_surface(const Groove& g, double theta, double phi) {
  return GrooveSection(g, phi).at(theta);
}

void check_section(const Groove& g, double phi) {
  require(g.profile_radius_mm != 0, "profile_radius_mm", g.profile_radius_mm,
          "must not be 0: > 0 for a nut, < 0 for a screw");
  require(g.center_radius_mm + g.profile_radius_mm * std::cos(phi) > 0, "center_radius_mm",
          g.center_radius_mm, "must leave the groove outside the part axis (R + rho cos phi > 0)");
}

// The root of f nearest to 0 within +-limit (rad): a walk outwards in steps of a quarter of a degree.
template <class F>
std::optional<double> nearest_root(const F& f, double limit) {
  constexpr double step = 0.25 * degree;
  const int steps = static_cast<int>(std::lround(limit / step));
  double right = f(0);
  if (right == 0) return 0.0;
  double left = right;
  for (int k = 1; k <= steps; ++k) {
    const double next_right = f(k * step);
    const double next_left = f(-k * step);
    std::optional<double> root;
    if (std::signbit(next_right) != std::signbit(right) || next_right == 0)
      root = find_root(f, (k - 1) * step, k * step);
    if (std::signbit(next_left) != std::signbit(left) || next_left == 0) {
      const double negative = find_root(f, -k * step, -(k - 1) * step);
      if (!root || -negative < *root) root = negative;
    }
    if (root) return root;
    right = next_right;
    left = next_left;
  }
  return std::nullopt;
}

struct WheelContactPoint {
  double theta, radius_mm, axial_mm;
};
// Eqs. (4)-(11): the groove normal at phi meets the wheel axis.
WheelContactPoint wheel_contact(const Groove& g, double center_distance_mm, double tilt_deg, double phi,
                                std::string_view input) {
  const double c = std::cos(tilt_deg * degree);
  const double s = std::sin(tilt_deg * degree);
  const GrooveSection section(g, phi);
  const auto miss = [&](double theta) {
    const auto [at, n] = section.at(theta);
    return (n.x * c + n.z * s) * (at.y - center_distance_mm) - n.y * (at.x * c + at.z * s);
  };
  const std::optional<double> theta = nearest_root(miss, 40 * degree);
  require(theta.has_value(), input, phi / degree,
          "must have a contact of wheel and groove within 40 deg of the line of centres");
  const Vector at = section.at(*theta).at;
  return {*theta, std::hypot(at.x * c + at.z * s, at.y - center_distance_mm), -at.x * s + at.z * c};
}

struct WheelProfile {
  WheelContactPoint at;
  double radius_slope, axial_slope;  // per step of phi
};
WheelProfile wheel_profile(const Groove& g, double center_distance_mm, double tilt_deg, double phi,
                           std::string_view input) {
  const double step = slope_step_deg * degree;
  const auto before = wheel_contact(g, center_distance_mm, tilt_deg, phi - step, input);
  const auto after = wheel_contact(g, center_distance_mm, tilt_deg, phi + step, input);
  return {wheel_contact(g, center_distance_mm, tilt_deg, phi, input), after.radius_mm - before.radius_mm,
          after.axial_mm - before.axial_mm};
}

// A wheel whose width no longer grows with |phi| would cut away what is to stay.
void check_no_undercut(const WheelProfile& here, const WheelProfile& crown, double phi,
                       std::string_view input) {
  require(here.axial_slope * crown.axial_slope > 0, input, phi / degree,
          "must stay where the wheel grows wider with |phi|: this wheel would undercut the groove");
}

struct SectionPoint {
  double wheel_angle, radius_mm, axial_mm;
};
// Eqs. (14), (15): where the wheel circle through (radius, axial) with the normal (n_radius, n_axial) touches
// the groove it makes by a helical motion. Angles from the line of centres.
SectionPoint groove_contact(double radius_mm, double axial_mm, double n_radius, double n_axial,
                            double lead_mm, double center_distance_mm, double tilt_deg, bool internal) {
  const double p = lead_mm / (2 * std::numbers::pi);
  const double c = std::cos(tilt_deg * degree);
  const double s = std::sin(tilt_deg * degree);
  const double side = internal ? 1 : -1;  // a screw touches the wheel at 180 deg
  const auto turned = [&](const Vector& v) { return Vector{v.x * c - v.z * s, v.y, v.x * s + v.z * c}; };
  const auto on_wheel = [&](double delta) {
    Vector at = turned({-side * radius_mm * std::sin(delta), side * radius_mm * std::cos(delta), axial_mm});
    at.y += center_distance_mm;
    return at;
  };
  const auto miss = [&](double delta) {
    const Vector at = on_wheel(delta);
    const Vector n = turned({-side * n_radius * std::sin(delta), side * n_radius * std::cos(delta), n_axial});
    return -at.y * n.x + at.x * n.y + p * n.z;
  };
  const std::optional<double> delta = nearest_root(miss, 25 * degree);
  if (!delta) reject("no contact of wheel and groove within 25 deg of the line of centres");
  const Vector at = on_wheel(*delta);
  const double turn = std::atan2(-at.x, at.y);
  return {(internal ? 0 : std::numbers::pi) + *delta, std::hypot(at.x, at.y), at.z - p * turn};
}

void check_distance(const WheelSetting& in) {
  const double outer_mm = in.wheel_center_radius_mm + in.wheel_profile_radius_mm;
  require(in.internal == 1 || in.center_distance_mm > outer_mm, "center_distance_mm", in.center_distance_mm,
          "must exceed the outer radius of the wheel, or a screw would be cut through");
}

SectionPoint toroid_contact(const WheelSetting& in, double phi) {
  return groove_contact(in.wheel_center_radius_mm + in.wheel_profile_radius_mm * std::cos(phi),
                        in.wheel_profile_radius_mm * std::sin(phi), std::cos(phi), std::sin(phi), in.lead_mm,
                        in.center_distance_mm, in.tilt_deg, in.internal == 1);
}

template <class F>
std::vector<PlanePoint> sample(double phi_max_deg, std::int64_t points, const F& section) {
  std::vector<PlanePoint> sampled;
  sampled.reserve(static_cast<std::size_t>(points));
  for (std::int64_t k = 0; k < points; ++k) {
    const double share = 2 * static_cast<double>(k) / static_cast<double>(points - 1) - 1;
    const SectionPoint at = section(share * phi_max_deg * degree);
    sampled.push_back({at.axial_mm, at.radius_mm});
  }
  return sampled;
}

// Second-order envelope at the crown.
double envelope_radius_mm(const CrossedWheel& in, double tilt) {
  const double p = in.lead_mm / (2 * std::numbers::pi);
  const double g = in.internal == 1 ? -1 : 1;
  const double c = std::cos(tilt);
  const double s = std::sin(tilt);
  const double across = 1 / in.wheel_outer_radius_mm;
  const double along = 1 / in.wheel_profile_radius_mm;
  const double a11 = g * (c * c * across + s * s * along);
  const double a12 = g * s * c * (across - along);
  const double a22 = g * (s * s * across + c * c * along);
  const double y = in.groove_bottom_radius_mm;
  const double q = -(y * a12 - p * a22) / (1 + y * a11 - p * a12);
  return std::abs((1 + p * q / y) / (a12 * q + a22));
}

void check_wheel(const CrossedWheel& in) {
  require(in.internal == 0 || in.wheel_outer_radius_mm < in.groove_bottom_radius_mm, "wheel_outer_radius_mm",
          in.wheel_outer_radius_mm, "must be below the groove bottom radius in a nut");
}

double tilt_of_radius(const CrossedWheel& in, double radius_mm, std::string_view input) {
  check_wheel(in);
  const double aligned = -std::atan(in.lead_mm / (2 * std::numbers::pi * in.groove_bottom_radius_mm));
  double low = aligned;
  double high = aligned + 40 * degree;
  const double least_mm = envelope_radius_mm(in, low);
  const double largest_mm = envelope_radius_mm(in, high);
  require(radius_mm >= least_mm, input, radius_mm,
          "must not be below the radius this wheel makes when aligned with the groove");
  require(radius_mm <= largest_mm, input, radius_mm,
          "must not be above the radius this wheel makes at 40 deg from the groove");
  // The radius dips slightly after the aligned position and rises from there: one root past the dip.
  return find_root([&](double tilt) { return envelope_radius_mm(in, tilt) - radius_mm; }, low, high, 1e-15);
}

}  // namespace

GroovePoint helical_groove_point(const GroovePosition& in) {
  return guarded<&helical_groove_point>(in, [&] {
    const double phi = in.phi_deg * degree;
    check_section(in, phi);
    const auto [at, n] = groove_surface(in, in.theta_deg * degree, phi);
    const double length = std::hypot(n.x, n.y, n.z);
    return GroovePoint{at.x, at.y, at.z, n.x / length, n.y / length, n.z / length};
  });
}

WheelPoint wheel_profile_point(const GrooveToWheel& in) {
  return guarded<&wheel_profile_point>(in, [&] {
    const double phi = in.phi_deg * degree;
    check_section(in, phi);
    check_section(in, 0);
    const WheelProfile here = wheel_profile(in, in.center_distance_mm, in.tilt_deg, phi, "phi_deg");
    if (phi != 0)
      check_no_undercut(here, wheel_profile(in, in.center_distance_mm, in.tilt_deg, 0, "phi_deg"), phi,
                        "phi_deg");
    return WheelPoint{here.at.theta / degree, here.at.radius_mm, here.at.axial_mm};
  });
}

GrooveSectionPoint ground_groove_point(const WheelToGroove& in) {
  return guarded<&ground_groove_point>(in, [&] {
    check_distance(in);
    const SectionPoint at = toroid_contact(in, in.phi_deg * degree);
    return GrooveSectionPoint{at.wheel_angle / degree, at.radius_mm, at.axial_mm};
  });
}

GrooveFit groove_profile_fit(const SectionSampling& in) {
  return guarded<&groove_profile_fit>(in, [&] {
    check_distance(in);
    const auto section =
        sample(in.phi_max_deg, in.points, [&](double phi) { return toroid_contact(in, phi); });
    const auto [least, largest] = std::minmax_element(
        section.begin(), section.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.x < b.x; });
    const CircleFit fit = fit_circle(section);
    return GrooveFit{fit.radius, fit.center_y, fit.form_error, fit.rms_error, (largest->x - least->x) / 2};
  });
}

PassFormError pass_form_error(const IntermediatePass& in) {
  return guarded<&pass_form_error>(in, [&] {
    check_section(in, 0);
    check_section(in, in.phi_max_deg * degree);
    const WheelProfile crown =
        wheel_profile(in, in.final_center_distance_mm, in.final_tilt_deg, 0, "phi_max_deg");
    require(in.profile_radius_mm > 0 || in.pass_center_distance_mm > crown.at.radius_mm,
            "pass_center_distance_mm", in.pass_center_distance_mm,
            "must exceed the outer radius of the wheel, or a screw would be cut through");
    const auto section = sample(in.phi_max_deg, in.points, [&](double phi) {
      const WheelProfile w =
          wheel_profile(in, in.final_center_distance_mm, in.final_tilt_deg, phi, "phi_max_deg");
      check_no_undercut(w, crown, phi, "phi_max_deg");
      // Normal of the dressed profile in its (radius, axial) plane, pointing away from the wheel axis.
      const double outwards = w.axial_slope > 0 ? 1 : -1;
      return groove_contact(w.at.radius_mm, w.at.axial_mm, outwards * w.axial_slope,
                            -outwards * w.radius_slope, in.lead_mm, in.pass_center_distance_mm,
                            in.pass_tilt_deg, in.profile_radius_mm > 0);
    });
    const CircleFit fit = fit_circle(section);
    return PassFormError{fit.radius, fit.center_y, fit.form_error, fit.rms_error};
  });
}

GrooveRadius effective_groove_radius(const TiltedWheel& in) {
  return guarded<&effective_groove_radius>(in, [&] {
    check_wheel(in);
    return GrooveRadius{envelope_radius_mm(in, in.tilt_deg * degree)};
  });
}

Tilt tilt_for_radius(const WantedRadius& in) {
  return guarded<&tilt_for_radius>(
      in, [&] { return Tilt{tilt_of_radius(in, in.groove_radius_mm, "groove_radius_mm") / degree}; });
}

PassSchedule pass_schedule(const PassPlan& in) {
  return guarded<&pass_schedule>(in, [&] {
    require(in.stock_mm < in.final_profile_radius_mm, "stock_mm", in.stock_mm,
            "must be below the final profile radius");
    const double passes = std::ceil(in.stock_mm / in.infeed_mm - 1e-9);
    require(passes <= 10'000, "infeed_mm", in.infeed_mm, "must divide the stock into at most 10000 passes");
    const double side = in.internal == 1 ? 1 : -1;
    PassSchedule schedule;
    for (double k = 1; k <= passes; ++k) {
      const double radius_mm =
          in.final_profile_radius_mm - in.stock_mm + std::min(k * in.infeed_mm, in.stock_mm);
      const double bottom_mm = in.groove_center_radius_mm + side * radius_mm;
      require(bottom_mm > 0, "groove_center_radius_mm", in.groove_center_radius_mm,
              "must exceed the profile radius of a screw");
      schedule.profile_radius_mm.push_back(radius_mm);
      schedule.center_distance_mm.push_back(bottom_mm - side * in.wheel_outer_radius_mm);
      schedule.tilt_deg.push_back(tilt_of_radius({in.wheel_profile_radius_mm, in.wheel_outer_radius_mm,
                                                  bottom_mm, in.lead_mm, in.internal},
                                                 radius_mm, "final_profile_radius_mm") /
                                  degree);
    }
    return schedule;
  });
}

}  // namespace verstat::models::k203
