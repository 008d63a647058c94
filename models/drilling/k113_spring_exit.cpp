// K113, second half: the spring feed holder, breakthrough, and the main times of the exit strategies.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/drilling/k113_through_hole_feed_change.h"
#include "models/math/gauss_legendre.h"
#include "models/math/trig_degrees.h"

namespace verstat::models::k113 {
namespace {

// A compression usually comes from a division P / C: equality in (C4) must survive its rounding.
constexpr double completion_slack = 1e-9;

bool spring_completes(double compression_mm, double zone_mm, double point_mm) {
  return compression_mm >= (zone_mm + point_mm) * (1 - completion_slack);
}

// First line of the exit phase: the drill advances through the zone with the whole edge engaged.
// xi: share of the compression left at its end.
double zone_time_min(const SpringExitInputs& in, double compression_mm, double xi) {
  const double scale_min = compression_mm / (in.rpm * in.feed_mm_rev);
  const double log_xi = std::log(xi);
  const double u = 1 - 1 / in.exp_feed;
  return u == 0 ? -scale_min * log_xi : scale_min * std::expm1(u * log_xi) / -u;
}

// Integral (C3) over the height of the point. The feed ratio is (force/engaged)^(1/e) up to its cap; both are
// linear in the share 1 - s = w^3 of the point that is still in, so they meet the cap at most once, and w
// makes the root at the tip smooth. Panels shrink towards the tip, where a spring that just suffices changes
// fast.
double exit_time_min(const SpringExitInputs& in, double compression_mm) {
  const double left_mm = compression_mm - in.zone_mm - in.point_height_mm;  // of the compression at the end
  const double engaged_at_1 = (1 - in.chisel_share) * compression_mm;
  // engaged / force at the share u that is still in; grows with u.
  const auto slowness = [&](double u) { return engaged_at_1 * u / (left_mm + u * in.point_height_mm); };
  const double capped_slowness = std::pow(in.feed_cap_ratio, -in.exp_feed);
  // slowness(u) = capped_slowness
  const double slope = engaged_at_1 - capped_slowness * in.point_height_mm;
  double cap_share = 1;  // below it the cap rules
  if (slowness(1) > capped_slowness)
    cap_share = slope > 0 ? std::clamp(capped_slowness * left_mm / slope, 0.0, 1.0) : 1;
  double sum = cap_share / in.feed_cap_ratio;
  const double from = std::cbrt(cap_share);
  double low = from;
  for (const double mark : {0.01, 0.03, 0.1, 0.25, 0.5, 1.0}) {
    if (mark <= low) continue;
    sum +=
        integrate_gauss([&](double w) { return 3 * w * w * std::pow(slowness(w * w * w), 1 / in.exp_feed); },
                        low, mark, gauss_legendre_24());
    low = mark;
  }
  return in.point_height_mm * sum / (in.rpm * in.feed_mm_rev);
}

double given(const std::optional<double>& value, const char* name) {
  require(value.has_value(), name, Value(), "is needed by this strategy");
  return *value;
}

}  // namespace

SpringHolder spring_holder_setup(const SpringHolderInputs& in) {
  return guarded<&spring_holder_setup>(in, [&] {
    const double compression_mm = in.thrust_n / in.spring_rate_n_mm;
    const double point_mm =
        in.diameter_mm / 2 * cos_deg(in.half_point_angle_deg) / sin_deg(in.half_point_angle_deg);
    const double zone_mm = in.zone_fraction * in.diameter_mm;
    require(in.part_thickness_mm >= point_mm + zone_mm, "part_thickness_mm", in.part_thickness_mm,
            "must be at least point height + exit zone, or the switch trips before full engagement");
    return SpringHolder{.spring_compression_mm = compression_mm,
                        .point_height_mm = point_mm,
                        .zone_mm = zone_mm,
                        .switch_distance_mm = in.part_thickness_mm - (point_mm + zone_mm),
                        .spring_rate_limit_n_mm = in.thrust_n / (zone_mm + point_mm),
                        .spring_completes = spring_completes(compression_mm, zone_mm, point_mm) ? 1 : 0};
  });
}

FeedClutch feed_clutch_torque(const FeedClutchInputs& in) {
  return guarded<&feed_clutch_torque>(in, [&] {
    return FeedClutch{in.safety_factor * in.rack_module_mm * static_cast<double>(in.rack_pinion_teeth) *
                      in.feed_force_limit_n / (2000 * in.efficiency)};
  });
}

LoadFactor feed_jump_load_factor(const LoadFactorInputs& in) {
  return guarded<&feed_jump_load_factor>(in, [&] { return LoadFactor{std::pow(in.feed_jump, in.exp_feed)}; });
}

FeedJump breakthrough_feed_jump(const FeedJumpInputs& in) {
  return guarded<&breakthrough_feed_jump>(in, [&] {
    const double springback_mm = in.relieved_share * in.thrust_n / in.axial_stiffness_n_mm;
    const double travel_mm = in.relief_travel_mm;
    if (springback_mm >= travel_mm) return FeedJump{springback_mm, 0, std::nullopt};
    return FeedJump{springback_mm, 1, travel_mm / (travel_mm - springback_mm)};
  });
}

SpringExit spring_exit_phase(const SpringExitInputs& in) {
  return guarded<&spring_exit_phase>(in, [&] {
    const double stroke_mm = in.zone_mm + in.point_height_mm;
    const bool completed = spring_completes(in.spring_compression_mm, in.zone_mm, in.point_height_mm);
    const double compression_mm =
        completed ? std::max(in.spring_compression_mm, stroke_mm) : in.spring_compression_mm;
    SpringExit out{};
    out.completed = completed ? 1 : 0;
    if (compression_mm > in.zone_mm) {
      const double xi = (compression_mm - in.zone_mm) / compression_mm;
      out.zone_time_min = zone_time_min(in, compression_mm, xi);
      out.feed_ratio_before = std::pow(xi, 1 / in.exp_feed);
      out.feed_ratio_after =
          std::min(std::pow(xi / (1 - in.chisel_share), 1 / in.exp_feed), in.feed_cap_ratio);
    }
    if (!completed) {
      out.stall_advance_mm = compression_mm;
      return out;
    }
    out.exit_time_min = exit_time_min(in, compression_mm);
    out.total_time_min = out.zone_time_min.value_or(0) + *out.exit_time_min;
    out.residual_compression_mm = compression_mm - stroke_mm;
    return out;
  });
}

CriticalSpring spring_critical_design(const CriticalSpringInputs& in) {
  return guarded<&spring_critical_design>(in, [&] {
    const double compression_mm = in.zone_mm + in.point_height_mm;
    const double xi = in.point_height_mm / compression_mm;
    return CriticalSpring{
        .spring_rate_n_mm = in.thrust_n / compression_mm,
        .feed_ratio_before = std::pow(xi, 1 / in.exp_feed),
        .feed_ratio_after = std::pow(xi / (1 - in.chisel_share), 1 / in.exp_feed),
        .zone_for_unit_feed_mm = in.point_height_mm * in.chisel_share / (1 - in.chisel_share)};
  });
}

HoleTime through_hole_time(const HoleTimeInputs& in) {
  return guarded<&through_hole_time>(in, [&] {
    const double feed_rate_mm_min = in.rpm * in.feed_mm_rev;
    const double constant_mm = in.approach_mm + in.part_thickness_mm + in.point_height_mm + in.overrun_mm;
    switch (in.strategy) {
      case ExitStrategy::constant:
        return HoleTime{constant_mm / feed_rate_mm_min};
      case ExitStrategy::reduced_full_depth:
        return HoleTime{given(in.feed_divisor, "feed_divisor") * constant_mm / feed_rate_mm_min};
      case ExitStrategy::reduced_exit: {
        const double zone_mm = given(in.zone_mm, "zone_mm");
        const double divisor = given(in.feed_divisor, "feed_divisor");
        require(in.part_thickness_mm >= zone_mm, "part_thickness_mm", in.part_thickness_mm,
                "must be at least zone_mm for reduced_exit");
        return HoleTime{(in.approach_mm + in.part_thickness_mm - zone_mm +
                         divisor * (zone_mm + in.point_height_mm + in.overrun_mm)) /
                        feed_rate_mm_min};
      }
      case ExitStrategy::spring_exit: {
        const double zone_mm = given(in.zone_mm, "zone_mm");
        const double compression_mm = given(in.spring_compression_mm, "spring_compression_mm");
        const double spring_min = given(in.spring_time_min, "spring_time_min");
        require(in.part_thickness_mm >= zone_mm + in.point_height_mm, "part_thickness_mm",
                in.part_thickness_mm, "must be at least zone_mm + point_height_mm for spring_exit");
        return HoleTime{(in.approach_mm + in.part_thickness_mm - zone_mm + compression_mm) /
                            feed_rate_mm_min +
                        spring_min};
      }
    }
    reject("unknown strategy");
  });
}

BreakEven spring_break_even_thickness(const BreakEvenInputs& in) {
  return guarded<&spring_break_even_thickness>(in, [&] {
    const double spring_mm = in.rpm * in.feed_mm_rev * in.spring_time_min;
    const double k = in.feed_divisor;
    const double thickness_mm = (in.spring_compression_mm - in.zone_mm + spring_mm -
                                 in.approach_mm * (k - 1) - k * (in.point_height_mm + in.overrun_mm)) /
                                (k - 1);
    return BreakEven{std::max(0.0, thickness_mm)};
  });
}

BreakRisk drill_break_probability(const BreakInputs& in) {
  return guarded<&drill_break_probability>(in, [&] {
    require(in.torque_sd_nm > 0 || in.strength_sd_nm > 0, "strength_sd_nm", in.strength_sd_nm,
            "must be above 0 when torque_sd_nm is 0");
    const double spread_nm = std::hypot(in.strength_sd_nm, in.load_factor * in.torque_sd_nm);
    const double beta = (in.strength_mean_nm - in.load_factor * in.torque_mean_nm) / spread_nm;
    return BreakRisk{beta, std::erfc(beta / std::numbers::sqrt2) / 2};
  });
}

}  // namespace verstat::models::k113
