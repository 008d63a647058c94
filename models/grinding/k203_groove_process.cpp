// Functions 9-15 of K203: removal, wear, dressing and time.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/grinding/k203_crossed_axis_groove_grinding.h"

namespace verstat::models::k203 {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Section and angle of contact at one point of the wheel profile.
struct ProfileRate {
  double rate_mm2_s;
  double arc;
};
ProfileRate profile_rate(const RemovalRegime& in, double phi) {
  const double speed_mm_s = in.traverse_speed_m_min * 1000 / 60 * std::cos(phi);  // v cos(phi)
  const double radius_mm =
      in.wheel_center_radius_mm + (in.wheel_profile_radius_mm - in.wear_mm) * std::cos(phi);
  const double depth_mm = in.scheme == Stock::shifted ? in.infeed_mm : in.infeed_mm / std::cos(phi);
  require(depth_mm <= radius_mm, "infeed_mm", in.infeed_mm,
          "must be below the wheel radius everywhere on the profile");
  if (in.retreat_speed_mm_s >= speed_mm_s) return {0, 0};
  const double from = std::asin(in.retreat_speed_mm_s / speed_mm_s);
  const double to = 2 * std::asin(std::sqrt(depth_mm / (2 * radius_mm)));  // acos(1 - t/r)
  if (from >= to) return {0, 0};
  // r (cos from - cos to), without the difference of two ones.
  const double half = std::sin(from / 2);
  const double cut_mm = depth_mm - 2 * radius_mm * half * half;
  return {
      -std::expm1(-in.grain_ratio) * (speed_mm_s * cut_mm - in.retreat_speed_mm_s * radius_mm * (to - from)),
      to - from};
}

}  // namespace

RemovalRate grinding_removal_rate(const RemovalRegime& in) {
  return guarded<&grinding_removal_rate>(in, [&] {
    require(in.wear_mm < in.wheel_profile_radius_mm, "wear_mm", in.wear_mm,
            "must be below the profile radius of the wheel");
    constexpr int intervals = 400;  // Simpson over the whole profile
    const double high = in.phi_max_deg * degree;
    double sum = 0;
    for (int k = 0; k <= intervals; ++k) {
      const double weight = k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2;
      sum += weight * profile_rate(in, high * (2.0 * k / intervals - 1)).rate_mm2_s;
    }
    const double rate_mm3_s = sum * (2 * high / intervals) / 3 * (in.wheel_profile_radius_mm - in.wear_mm);
    const ProfileRate crown = profile_rate(in, 0);
    return RemovalRate{60 * rate_mm3_s, 60 * crown.rate_mm2_s, crown.arc / degree};
  });
}

RemovedVolume removed_volume(const StockOnGroove& in) {
  return guarded<&removed_volume>(in, [&] {
    require(in.profile_radius_mm != 0, "profile_radius_mm", in.profile_radius_mm,
            "must not be 0: > 0 for a nut, < 0 for a screw");
    require(in.center_radius_mm + in.profile_radius_mm > 0, "center_radius_mm", in.center_radius_mm,
            "must exceed the profile radius of a screw");
    const double rho = std::abs(in.profile_radius_mm);
    require(in.stock_mm < rho, "stock_mm", in.stock_mm, "must be below the profile radius");
    const double side = in.profile_radius_mm > 0 ? 1 : -1;
    const double f = in.phi_max_deg * degree;
    const double stock = in.stock_mm;
    const double r = in.center_radius_mm;
    double section = 0;
    double moment = 0;  // of the section about the part axis
    if (in.scheme == Stock::concentric) {
      section = 2 * f * stock * (rho - stock / 2);
      // rho^3 - (rho - stock)^3
      const double cubes = stock * (3 * rho * rho - 3 * rho * stock + stock * stock);
      moment = r * section + side * 2 / 3 * std::sin(f) * cubes;
    } else {
      section = 2 * rho * stock * std::sin(f);
      moment = rho * stock * (2 * r * std::sin(f) + side * rho * (f + std::sin(f) * std::cos(f))) -
               side * stock * stock * rho * std::sin(f);
    }
    const double turns = in.thread_length_mm / in.lead_mm;
    return RemovedVolume{section, turns * std::hypot(2 * std::numbers::pi * r, in.lead_mm),
                         2 * std::numbers::pi * turns * moment};
  });
}

PlungeLength plunge_length(const Plunge& in) {
  return guarded<&plunge_length>(
      in, [&] { return PlungeLength{in.stock_mm / std::cos(in.theta_max_deg * degree)}; });
}

DressingDepth dressing_depth(const WornProfile& in) {
  return guarded<&dressing_depth>(in, [&] {
    const double rho = in.wheel_profile_radius_mm;
    const double wear = in.wear_mm;
    require(wear < rho, "wear_mm", wear, "must be below the profile radius of the wheel");
    const double inward = (rho - wear) * std::sin(in.alpha_deg * degree);
    const double gap = wear * (2 * rho - wear);
    if (gap == 0) return DressingDepth{0};
    return DressingDepth{gap / (inward + std::sqrt(inward * inward + gap))};
  });
}

DressingVolume dressing_volume(const Dressing& in) {
  return guarded<&dressing_volume>(in, [&] {
    const double rho = in.wheel_profile_radius_mm;
    require(in.wheel_width_mm <= 2 * rho, "wheel_width_mm", in.wheel_width_mm,
            "must not exceed twice the profile radius");
    require(in.depth_mm < in.wheel_center_radius_mm, "depth_mm", in.depth_mm,
            "must be below the radius of the profile centre");
    const double half = in.wheel_width_mm / 2;
    const double section = in.depth_mm * in.wheel_width_mm;
    const double radius_integral = 2 * in.wheel_center_radius_mm * half +
                                   half * std::sqrt((rho - half) * (rho + half)) +
                                   rho * rho * std::asin(half / rho);
    return DressingVolume{section, std::numbers::pi * in.depth_mm * (2 * radius_integral - section)};
  });
}

WheelWear wheel_wear_per_part(const WearInputs& in) {
  return guarded<&wheel_wear_per_part>(in, [&] {
    const double path = in.method == Method::copying ? 1 / std::cos(in.phi_max_deg * degree) : 1;
    const double wear_mm = path * in.stock_mm * in.groove_length_mm /
                           (2 * std::numbers::pi * in.wheel_outer_radius_mm * in.grinding_ratio);
    return WheelWear{wear_mm, wear_mm / in.wear_limit_mm};
  });
}

GrindingTime groove_grinding_time(const GrindingPlan& in) {
  return guarded<&groove_grinding_time>(in, [&] {
    const double passes =
        std::max(0.0, std::ceil(in.stock_mm / in.infeed_mm - 1e-9)) + static_cast<double>(in.sparkout_passes);
    require(passes < 1e15, "infeed_mm", in.infeed_mm, "asks for more than 1e15 passes");
    const double stroke_min = (in.thread_length_mm + in.overrun_mm) / (in.lead_mm * in.part_speed_rpm);
    return GrindingTime{static_cast<std::int64_t>(passes), stroke_min,
                        passes * (stroke_min * (1 + 1 / in.return_speed_ratio) + in.setting_time_min) +
                            in.dressing_time_min * in.dressings_per_part};
  });
}

}  // namespace verstat::models::k203
