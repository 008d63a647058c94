#include "models/gears/hobbing_process.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "models/math/solve.h"
#include "models/math/trig_degrees.h"

namespace verstat::models::k101 {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

CylinderContact cylinder_contact(double centre_mm, double hob_radius_mm, double gear_radius_mm, double beta) {
  if (centre_mm - gear_radius_mm >= hob_radius_mm) return {0, pi / 2};
  if (centre_mm <= std::abs(hob_radius_mm - gear_radius_mm))
    reject(
        "one tip cylinder lies inside the other: centre_distance_mm must exceed the difference of the radii");
  const double b = std::abs(beta);  // L is even in beta
  const auto reach = [=](double tau) {
    const double y = centre_mm - gear_radius_mm * std::sin(tau);
    return std::sqrt(std::max(0.0, (hob_radius_mm - y) * (hob_radius_mm + y)));
  };
  // dL/dtau times q / R_a, without the pole at q = 0.
  const auto slope = [=](double tau) {
    return std::cos(tau) * (centre_mm - gear_radius_mm * std::sin(tau)) -
           reach(tau) * std::sin(tau) * std::sin(b);
  };
  double tau = 0;
  if (b == 0) {
    tau = std::asin(std::min(1.0, centre_mm / gear_radius_mm));
  } else {
    tau = find_root(slope, std::asin((centre_mm - hob_radius_mm) / gear_radius_mm), pi / 2);
  }
  return {(reach(tau) + gear_radius_mm * std::cos(tau) * std::sin(b)) / std::cos(b), tau};
}

Hob::Hob(const HobInputs& in)
    : tip_radius(in.hob_diameter_mm / 2),
      pitch_radius(tip_radius - in.hob_addendum_factor * in.module_mm),
      lead_angle(0),
      helix(0),
      a1(0),
      corner_radius(in.hob_tip_radius_mm),
      corner_radial(tip_radius - corner_radius),
      corner_axial(0),
      section_angle(0),
      sin_pressure(sin_deg(in.pressure_angle_deg)),
      cos_pressure(cos_deg(in.pressure_angle_deg)),
      tan_pressure(sin_pressure / cos_pressure) {
  require(in.module_mm < 2 * pitch_radius, "hob_diameter_mm", in.hob_diameter_mm,
          "is too small: the pitch diameter hob_diameter_mm - 2 hob_addendum_factor module_mm must be above "
          "module_mm");
  lead_angle = std::asin(in.module_mm / (2 * pitch_radius));
  helix = in.module_mm / (2 * std::cos(lead_angle));
  a1 = pi * in.module_mm / 4 + pitch_radius * tan_pressure;
  corner_axial = a1 - corner_radial * tan_pressure - corner_radius / cos_pressure;
  require(corner_axial > 0, "hob_tip_radius_mm", in.hob_tip_radius_mm, "is too large: no tip land is left");
  // The outline lies in the section normal to the thread, or in the axial section.
  section_angle = in.hob_profile == HobProfile::convolute ? -lead_angle : 0;
}

HobbingProcess::HobbingProcess(const Hobbing& in)
    : hob(in),
      centre_distance(0),
      gear_outer_radius(0),
      setting_angle(0),
      cutting_depth(0),
      travel_rate(0),
      blank_rate(0),
      approach(0),
      zone_half_length(0),
      gear_teeth(in.gear_teeth),
      gashes(in.hob_gashes),
      last_tooth(0),
      climb(in.feed_mode == FeedMode::climb),
      cos_section(std::cos(hob.section_angle)),
      sin_section(std::sin(hob.section_angle)),
      cos_setting(0),
      sin_setting(0) {
  const double m = in.module_mm;
  const double z = static_cast<double>(in.gear_teeth);
  const double helix = to_radians(in.gear_helix_deg);
  const double pitch_radius = m * z / (2 * std::cos(helix));
  gear_outer_radius = pitch_radius + m * (1 + in.profile_shift);
  centre_distance = pitch_radius + in.profile_shift * m + hob.pitch_radius;
  cutting_depth = gear_outer_radius + hob.tip_radius - centre_distance;
  setting_angle = hob.lead_angle - helix;
  require(std::abs(setting_angle) < pi / 2, "gear_helix_deg", in.gear_helix_deg,
          "with the lead angle of this hob it sets the hob along the gear axis");
  cos_setting = std::cos(setting_angle);
  sin_setting = std::sin(setting_angle);
  const double sigma = climb ? -1 : 1;
  travel_rate = sigma * in.axial_feed_mm_rev / z / (2 * pi);
  blank_rate = (1 + sigma * in.axial_feed_mm_rev / z * std::sin(helix) / (m * pi)) / z;
  approach = cylinder_contact(centre_distance, hob.tip_radius, gear_outer_radius, setting_angle).length_mm;
  zone_half_length =
      cylinder_contact(centre_distance, gear_outer_radius, hob.tip_radius, setting_angle).length_mm;
  const double tooth_pitch = 2 * pi * hob.helix / static_cast<double>(gashes);
  last_tooth = static_cast<std::int64_t>(std::ceil(zone_half_length / tooth_pitch));
}

double HobbingProcess::tooth_angle(std::int64_t tooth) const {
  return -2 * pi * static_cast<double>(tooth) / static_cast<double>(gashes);
}

OutlinePoint HobbingProcess::outline_point(Segment segment, double parameter) const {
  const double s = hob.sin_pressure;
  const double c = hob.cos_pressure;
  const double root_u = (hob.tip_radius - cutting_depth) / c;
  const double corner_u = (hob.corner_radial + hob.corner_radius * s) / c;
  const double pressure_deg = to_degrees(std::atan2(s, c));
  const auto check = [&](double low, double high, std::string_view range) {
    constexpr double slack = 1e-9;  // ends are computed numbers
    require(parameter >= low - slack && parameter <= high + slack, "parameter", parameter, range);
  };
  switch (segment) {
    case Segment::flank_12:
      check(root_u, corner_u, "is outside segment 12 (u in mm, from the root to the corner of the tooth)");
      return {parameter * c, hob.a1 - parameter * s, c, -s, s, c};
    case Segment::flank_56:
      check(root_u, corner_u, "is outside segment 56 (u in mm, from the root to the corner of the tooth)");
      return {parameter * c, -hob.a1 + parameter * s, c, s, s, -c};
    case Segment::tip_34:
      check(0, 2 * hob.corner_axial,
            "is outside segment 34 (u_1 in mm, from 0 to the width of the tip land)");
      return {hob.tip_radius, parameter - hob.corner_axial, 0, 1, 1, 0};
    case Segment::corner_23:
      check(pressure_deg, 90, "is outside segment 23 (mu in degrees, from the pressure angle to 90)");
      break;
    case Segment::corner_45:
      check(90, 180 - pressure_deg, "is outside segment 45 (mu in degrees, from 90 to 180 - pressure angle)");
      break;
  }
  const double sin_mu = sin_deg(parameter);
  const double cos_mu = cos_deg(parameter);
  const double centre = segment == Segment::corner_23 ? hob.corner_axial : -hob.corner_axial;
  // The tangent of a sharp corner (radius 0) is that of the limit.
  return {hob.corner_radial + hob.corner_radius * sin_mu,
          centre + hob.corner_radius * cos_mu,
          cos_mu,
          -sin_mu,
          sin_mu,
          cos_mu};
}

std::vector<OutlinePoint> HobbingProcess::edge_samples(std::int64_t n_flank, std::int64_t n_round,
                                                       std::int64_t n_tip) const {
  const double root_u = (hob.tip_radius - cutting_depth) / hob.cos_pressure;
  const double corner_u = (hob.corner_radial + hob.corner_radius * hob.sin_pressure) / hob.cos_pressure;
  const double pressure_deg = to_degrees(std::atan2(hob.sin_pressure, hob.cos_pressure));
  std::vector<OutlinePoint> points;
  const auto add = [&](Segment segment, double from, double to, std::int64_t count, std::int64_t parts) {
    for (std::int64_t k = 0; k < count; ++k)
      points.push_back(
          outline_point(segment, from + (to - from) * static_cast<double>(k) / static_cast<double>(parts)));
  };
  add(Segment::flank_12, root_u, corner_u, n_flank, n_flank);
  add(Segment::corner_23, pressure_deg, 90, n_round, n_round);
  add(Segment::tip_34, 2 * hob.corner_axial, 0, n_tip, n_tip);
  add(Segment::corner_45, 90, 180 - pressure_deg, n_round, n_round);
  add(Segment::flank_56, corner_u, root_u, n_flank, n_flank - 1);
  return points;
}

Eigen::Vector3d HobbingProcess::place(const OutlinePoint& point, double angle, double tooth_t) const {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double across = point.w * sin_section;
  return {point.r * c - across * s, point.r * s + across * c, hob.helix * tooth_t + point.w * cos_section};
}

Eigen::Vector3d HobbingProcess::velocity(const Eigen::Vector3d& point0) const {
  const double sw = blank_rate * sin_setting;
  const double cw = blank_rate * cos_setting;
  return {-point0.y() * (1 + sw) - centre_distance * sw + travel_rate * cos_setting,
          point0.x() * (1 + sw) - point0.z() * cw,
          (point0.y() + centre_distance) * cw + travel_rate * sin_setting};
}

Eigen::Vector3d HobbingProcess::tangent(const OutlinePoint& point, double theta) const {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  const double across = point.tangent_w * sin_section;
  return {point.tangent_r * c - across * s, point.tangent_r * s + across * c, point.tangent_w * cos_section};
}

HobbingProcess::Swept HobbingProcess::swept(const OutlinePoint& point, double theta, double tooth_t) const {
  const Eigen::Vector3d product = velocity(place(point, theta, tooth_t)).cross(tangent(point, theta));
  const double width = product.norm();
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  const double across = point.normal_w * sin_section;
  const Eigen::Vector3d outward(point.normal_r * c - across * s, point.normal_r * s + across * c,
                                point.normal_w * cos_section);
  const double sign = product.dot(outward) > 0 ? -1 : 1;
  const Eigen::Vector3d normal = sign / width * product;
  return {normal, width};
}

Eigen::Vector3d HobbingProcess::direction_to_blank(const Eigen::Vector3d& v0, double hob_rotation) const {
  const double c = std::cos(blank_rate * hob_rotation);
  const double s = std::sin(blank_rate * hob_rotation);
  const double z = -sin_setting * v0.x() + cos_setting * v0.z();
  return {cos_setting * v0.x() + sin_setting * v0.z(), c * v0.y() - s * z, s * v0.y() + c * z};
}

Eigen::Vector3d HobbingProcess::to_blank(const Eigen::Vector3d& point0, double hob_rotation) const {
  const Eigen::Vector3d from_blank_axis(point0.x(), point0.y() + centre_distance, point0.z());
  Eigen::Vector3d out = direction_to_blank(from_blank_axis, hob_rotation);
  out.x() += travel_rate * hob_rotation;
  return out;
}

double HobbingProcess::outline_distance(double r, double w) const {
  w = std::abs(w);
  const double dr = r - hob.corner_radial;
  const double dw = w - hob.corner_axial;
  if (dw >= 0 && dr * hob.cos_pressure - dw * hob.sin_pressure >= 0)
    return std::sqrt(dr * dr + dw * dw) - hob.corner_radius;
  return std::max(r - hob.tip_radius, r * hob.sin_pressure + (w - hob.a1) * hob.cos_pressure);
}

double HobbingProcess::clearance(const Eigen::Vector3d& q, const Pass& pass, double start) const {
  constexpr double nearest = 3 * pi / 2;
  const double z_of_tooth = hob.helix * pass.tooth_angle;
  double th = start;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double hob_rotation = th + pass.shift;
    const double cb = std::cos(blank_rate * hob_rotation);
    const double sb = std::sin(blank_rate * hob_rotation);
    // Undo blank rotation, travel, centre distance and swivel.
    const double xs = q.x() - travel_rate * hob_rotation;
    const double ys = cb * q.y() + sb * q.z();
    const double zs = -sb * q.y() + cb * q.z();
    const double x0 = cos_setting * xs - sin_setting * zs;
    const double y0 = ys - centre_distance;
    const double z0 = sin_setting * xs + cos_setting * zs;
    const double c = std::cos(th);
    const double s = std::sin(th);
    const double r = c * x0 + s * y0;
    const double tau = -s * x0 + c * y0;
    const double zeta = z0 - z_of_tooth;
    const double f = tau * cos_section - zeta * sin_section;
    // From a start more than a quarter turn off Newton would find the far side of the hob. The point of the
    // hob nearest to the blank never is.
    if (iteration == 0 && th != nearest && (r <= 0 || std::abs(f) > 0.5 * r * cos_section)) {
      th = nearest;
      continue;
    }
    // The blank moves on while the tooth turns.
    const double dx0 = -cos_setting * travel_rate + sin_setting * blank_rate * ys;
    const double dy0 = blank_rate * zs;
    const double dz0 = -sin_setting * travel_rate - cos_setting * blank_rate * ys;
    const double df = (-r - s * dx0 + c * dy0) * cos_section - dz0 * sin_section;
    const double step = std::clamp(-f / df, -0.5, 0.5);
    th += step;
    if (std::abs(step) < 1e-10) return outline_distance(r, tau * sin_section + zeta * cos_section);
  }
  reject("the tooth angle at which an earlier pass meets a point was not found");
}

ToothPosition::ToothPosition(const HobbingProcess& process, std::int64_t tooth, double theta,
                             std::int64_t previous_blank_revs, std::int64_t hob_turns,
                             std::optional<EndFaces> faces)
    : process_(&process),
      theta_(theta),
      tooth_t_(process.tooth_angle(tooth)),
      hob_rotation_(theta - tooth_t_ + 2 * pi * static_cast<double>(hob_turns)),
      cos_theta_(std::cos(theta)),
      sin_theta_(std::sin(theta)),
      faces_(faces),
      lipschitz_(1) {
  const HobbingProcess& p = process;
  const double blank_speed = std::abs(p.blank_rate) * p.gear_outer_radius + std::abs(p.travel_rate);
  const double root_radius = std::max(p.hob.tip_radius - p.cutting_depth, 0.1 * p.hob.tip_radius);
  // Clearance changes by no more than this per millimetre of travel of the point: 1 for a fixed tooth angle,
  // and the tooth angle follows the point at 1/r.
  lipschitz_ = 1 + 2 * blank_speed / root_radius;
  const auto add = [&](std::int64_t i, std::int64_t revs_ago) {
    if (i < -p.last_tooth || i > p.last_tooth || (revs_ago == 0 && i >= tooth)) return;
    EarlierPass pass{};
    pass.tooth_angle = p.tooth_angle(i);
    pass.shift = 2 * pi * static_cast<double>(hob_turns - revs_ago * p.gear_teeth) - pass.tooth_angle;
    const double hob_rotation = theta_ + pass.shift;
    pass.cos_blank = std::cos(p.blank_rate * hob_rotation);
    pass.sin_blank = std::sin(p.blank_rate * hob_rotation);
    pass.travel = p.travel_rate * hob_rotation;
    passes_.push_back(pass);
  };
  passes_.reserve(static_cast<std::size_t>((2 * p.last_tooth + 1) * (previous_blank_revs + 1)));
  // Nearest passes first: most points are found cut away by one of them.
  const std::int64_t farthest = p.last_tooth + std::abs(tooth);
  const auto outwards = [&](std::int64_t first_rev, std::int64_t last_rev) {
    for (std::int64_t d = 0; d <= farthest; ++d)
      for (std::int64_t n = first_rev; n <= last_rev; ++n) {
        add(tooth - d, n);
        if (d > 0) add(tooth + d, n);
      }
  };
  outwards(0, std::min<std::int64_t>(1, previous_blank_revs));
  outwards(2, previous_blank_revs);
}

// No more than the clearance of a pass, from one look at the tooth angle of the current tooth: while the pass
// turns on by d radians to meet the point, the point moves by at most d times the speed of the blank.
double ToothPosition::lower_bound(const Eigen::Vector3d& q, const EarlierPass& pass) const {
  const HobbingProcess& p = *process_;
  const double xs = q.x() - pass.travel;
  const double ys = pass.cos_blank * q.y() + pass.sin_blank * q.z();
  const double zs = -pass.sin_blank * q.y() + pass.cos_blank * q.z();
  const double x0 = p.cos_setting * xs - p.sin_setting * zs;
  const double y0 = ys - p.centre_distance;
  const double zeta = p.sin_setting * xs + p.cos_setting * zs - p.hob.helix * pass.tooth_angle;
  const double r = cos_theta_ * x0 + sin_theta_ * y0;
  const double tau = -sin_theta_ * x0 + cos_theta_ * y0;
  const double f = tau * p.cos_section - zeta * p.sin_section;
  constexpr double none = -std::numeric_limits<double>::infinity();
  if (!(r > 0) || std::abs(f) > 0.5 * r * p.cos_section) return none;
  const double turn = 1.5 * std::abs(f) / (r * p.cos_section);
  const double speed =
      std::abs(p.blank_rate) * std::sqrt(q.y() * q.y() + q.z() * q.z()) + std::abs(p.travel_rate);
  const double moved = turn * speed;
  const double w = std::abs(zeta) / p.cos_section;  // when the tooth meets the point, tau = zeta tan(beta_1)
  const double across = w * p.sin_section;
  const double r_met = std::sqrt(std::max(0.0, x0 * x0 + y0 * y0 - across * across));
  return std::max(r_met - p.hob.tip_radius,
                  r_met * p.hob.sin_pressure + (w - p.hob.a1) * p.hob.cos_pressure) -
         2 * moved;
}

double ToothPosition::distance_to_boundary(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const {
  constexpr double cap_mm = 6;
  double best = cap_mm;
  const double a = n.y() * n.y() + n.z() * n.z();
  if (a > 0) {
    const double b = p.y() * n.y() + p.z() * n.z();
    const double radius = process_->gear_outer_radius;
    const double c = p.y() * p.y() + p.z() * p.z() - radius * radius;
    best = std::min(best, (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a);
  }
  if (faces_ && n.x() > 0) best = std::min(best, (faces_->high_mm - p.x()) / n.x());
  if (faces_ && n.x() < 0) best = std::min(best, (faces_->low_mm - p.x()) / n.x());
  return best;
}

double ToothPosition::chip_thickness(const OutlinePoint& point, double step_mm) const {
  return sample(point, step_mm).thickness_mm;
}

ToothPosition::Sample ToothPosition::sample(const OutlinePoint& point, double step_mm) const {
  const HobbingProcess& process = *process_;
  const Eigen::Vector3d p = process.to_blank(process.place(point, theta_, tooth_t_), hob_rotation_);
  const double radius = process.gear_outer_radius;
  if (p.y() * p.y() + p.z() * p.z() >= radius * radius) return {0, 0};
  if (faces_ && (p.x() < faces_->low_mm || p.x() > faces_->high_mm)) return {0, 0};

  std::vector<Candidate> candidates;
  candidates.reserve(passes_.size());
  for (std::size_t k = 0; k < passes_.size(); ++k) {
    double bound = lower_bound(p, passes_[k]);
    if (bound <= 0) bound = process.clearance(p, passes_[k], theta_);
    if (bound <= 0) return {0, 0};  // an earlier pass has been here
    candidates.push_back({bound, k});
  }
  const HobbingProcess::Swept swept = process.swept(point, theta_, tooth_t_);
  const Eigen::Vector3d n = process.direction_to_blank(swept.normal0, hob_rotation_);
  const double boundary = distance_to_boundary(p, n);
  const auto last_step = static_cast<std::int64_t>(std::ceil(boundary / step_mm));
  const auto at = [&](std::int64_t k) { return std::min(boundary, static_cast<double>(k) * step_mm); };

  // A heap with the nearest pass on top: few are ever taken off.
  const auto farther = [](const Candidate& a, const Candidate& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.pass > b.pass;
  };
  std::make_heap(candidates.begin(), candidates.end(), farther);
  double best = boundary;
  std::int64_t hit_step = last_step;  // first step at which some pass holds the point
  while (!candidates.empty()) {
    std::pop_heap(candidates.begin(), candidates.end(), farther);
    const Candidate candidate = candidates.back();
    candidates.pop_back();
    if (candidate.bound > lipschitz_ * at(hit_step)) break;
    const EarlierPass& pass = passes_[candidate.pass];
    const auto clearance = [&](double g) {
      const Eigen::Vector3d q = p + g * n;
      return process.clearance(q, pass, theta_);
    };
    const auto steps_free = [&](double c) {
      return static_cast<std::int64_t>(std::floor(c / (lipschitz_ * step_mm)));
    };
    std::int64_t k = std::max<std::int64_t>(1, steps_free(candidate.bound));
    double here = 1;
    while (k <= hit_step && (here = clearance(at(k))) > 0) k += std::max<std::int64_t>(1, steps_free(here));
    if (k > hit_step) continue;
    // The surface lies between the last free step and this one: false position with halving (Illinois).
    double low = at(k - 1);
    double high = at(k);
    double f_low = k == 1 ? process.clearance(p, pass, theta_) : clearance(low);
    double f_high = here;
    if (f_low <= 0) {
      high = low;  // a free step was jumped over: the surface is no farther than the one before
    }
    int side = 0;
    while (high - low > 1e-9) {
      double g = (f_low * high - f_high * low) / (f_low - f_high);
      // Stay inside, and close in from both ends.
      g = std::clamp(g, low + 0.02 * (high - low), high - 0.02 * (high - low));
      const double f = clearance(g);
      if (f <= 0) {
        high = g;
        f_high = f;
        if (side == -1) f_low /= 2;
        side = -1;
      } else {
        low = g;
        f_low = f;
        if (side == 1) f_high /= 2;
        side = 1;
      }
    }
    if (k < hit_step || high < best) {
      best = std::min(best, high);
      hit_step = k;
    }
  }
  return {best, swept.width_mm_rad};
}

}  // namespace verstat::models::k101
