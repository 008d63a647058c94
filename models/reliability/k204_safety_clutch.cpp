#include "models/reliability/k204_safety_clutch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "models/math/solve.h"

namespace verstat::models::k204 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double speed_max_rpm = 600;

struct Point {
  double speed_rpm, k_d;
};
// Published dynamic factors; (0, 1) is a completion. Of the two values printed for the round slot at 400 rpm,
// 1.25 and 1.15, the second is the outlier.
constexpr Point cone_points[] = {{0, 1}, {230, 1.16}, {400, 1.27}};
constexpr Point round_points[] = {{0, 1}, {230, 1.13}, {400, 1.25}};
constexpr Point polygon_points[] = {{0, 1}, {170, 1.12}};

std::span<const Point> dynamic_points(Clutch clutch) {
  switch (clutch) {
    case Clutch::cone:
      return cone_points;
    case Clutch::ball_round:
      return round_points;
    case Clutch::ball_triangle:
    case Clutch::ball_pentagon:
      break;
  }
  return polygon_points;
}

// Line through the segment of the points that `x` of member `from` falls into; the last one goes on.
double along(std::span<const Point> points, double Point::*from, double Point::*to, double x) {
  std::size_t k = 1;
  while (k + 1 < points.size() && x > points[k].*from) ++k;
  const Point& a = points[k - 1];
  const Point& b = points[k];
  return a.*to + (b.*to - a.*to) * (x - a.*from) / (b.*from - a.*from);
}

double reengage_limit_rpm(Clutch clutch) {
  return clutch == Clutch::ball_triangle || clutch == Clutch::ball_pentagon ? 170 : 0;
}

TripBand trip_band(double set_torque, double accuracy) {
  const double low = 2 * set_torque / (1 + accuracy);
  const double high = accuracy * low;
  return {low, high, set_torque, (high - low) / 6};
}

double upper_tail(double z) {
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

SpikeOutcome outcome(const SpikeInputs& in) {
  const double tc = in.cutting_torque_nm;
  const double tb = in.break_torque_nm;
  const TripBand band = trip_band(in.set_torque_nm, in.accuracy);
  const double mu = band.t_mean_nm;
  const double sigma = band.sigma_nm;
  const double beta = 1 / (in.spike_mean_ratio * tc);
  const double tau = tb / in.dynamic_factor;
  const auto demand_above = [&](double x) { return x > tc ? std::exp(-beta * (x - tc)) : 1; };
  const auto threshold_above = [&](double x) { return upper_tail((x - mu) / sigma); };
  // Mass of demand and threshold that meet above y, both beyond T_c. Below 1e-40 for very light cuts, where
  // the product overflows.
  const auto tail = [&](double y) {
    if (beta * sigma > 30) return 0.0;
    return std::exp(beta * (tc - mu) + beta * beta * sigma * sigma / 2) *
           upper_tail((y - mu) / sigma + beta * sigma);
  };
  SpikeOutcome out{};
  out.p_trip = std::min(1.0, upper_tail((mu - tc) / sigma) + tail(tc));
  out.p_break = demand_above(tb) * threshold_above(tau);
  out.p_break_no_clutch = demand_above(tb);
  if (tb > tc) {
    const double broken_tripped =
        demand_above(tb) * std::max(0.0, threshold_above(tau) - threshold_above(tb)) + tail(tb);
    out.p_trip_safe = std::max(0.0, out.p_trip - broken_tripped);
  } else {
    // P_trip less Phi((T_c - mu)/sigma) - Phi((tau - mu)/sigma) + tail(T_c), taken out by hand.
    out.p_trip_safe = upper_tail((mu - tau) / sigma);
  }
  return out;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

ClutchCoefficients clutch_coefficients(const ClutchType& in) {
  return guarded<&clutch_coefficients>(in, [&] {
    const double limit = reengage_limit_rpm(in.clutch);
    switch (in.clutch) {
      case Clutch::cone:
        return ClutchCoefficients{1.13, 1.17, 0.98, 0.99, 0.96, 0.99, 1, 1, limit};
      case Clutch::ball_round:
        return ClutchCoefficients{1.11, 1.16, 0.98, 0.99, 0.94, 0.99, 1, 1, limit};
      case Clutch::ball_triangle:
        return ClutchCoefficients{1.10, 1.18, 0.98, 0.99, 0.94, 0.99, 1.17, 1.83, limit};
      case Clutch::ball_pentagon:
        break;
    }
    return ClutchCoefficients{1.10, 1.18, 0.98, 0.99, 0.94, 0.99, 2.33, 6.5, limit};
  });
}

DynamicFactor clutch_dynamic_factor(const ClutchSpeed& in) {
  return guarded<&clutch_dynamic_factor>(in, [&] {
    return DynamicFactor{along(dynamic_points(in.clutch), &Point::speed_rpm, &Point::k_d, in.speed_rpm)};
  });
}

DynamicFactor clutch_dynamic_factor_inertial(const InertialDrive& in) {
  return guarded<&clutch_dynamic_factor_inertial>(in, [&] {
    const double omega = pi * in.speed_rpm / 30;
    return DynamicFactor{1 + omega * std::sqrt(in.inertia_kg_m2 * in.torsional_stiffness_nm_rad) /
                                 in.trip_torque_nm};
  });
}

TripBand clutch_trip_band(const Setting& in) {
  return guarded<&clutch_trip_band>(in, [&] { return trip_band(in.set_torque_nm, in.accuracy); });
}

SetTorque clutch_set_torque_drift(const DriftInputs& in) {
  return guarded<&clutch_set_torque_drift>(in, [&] {
    return SetTorque{in.set_torque_nm * std::pow(in.stability, in.trips / in.reference_trips)};
  });
}

ReengageTorque clutch_reengage_torque(const SensitivityInputs& in) {
  return guarded<&clutch_reengage_torque>(in,
                                          [&] { return ReengageTorque{in.sensitivity * in.set_torque_nm}; });
}

SettingWindow clutch_setting_window(const WindowInputs& in) {
  return guarded<&clutch_setting_window>(in, [&] {
    const double low = in.work_peak_torque_nm * (1 + in.accuracy) / (2 * in.drift_factor);
    const double high = in.allowable_torque_nm * (1 + in.accuracy) / (2 * in.accuracy * in.dynamic_factor);
    return SettingWindow{low, high, low <= high ? 1 : 0, in.accuracy * in.dynamic_factor / in.drift_factor};
  });
}

MaxSpeed clutch_max_speed(const MaxSpeedInputs& in) {
  return guarded<&clutch_max_speed>(in, [&] {
    const double k_d = in.allowable_torque_nm * in.drift_factor / (in.work_peak_torque_nm * in.accuracy);
    if (k_d < 1) return MaxSpeed{0};
    return MaxSpeed{
        std::min(speed_max_rpm, along(dynamic_points(in.clutch), &Point::k_d, &Point::speed_rpm, k_d))};
  });
}

SpikeOutcome overload_spike_outcome(const SpikeInputs& in) {
  return guarded<&overload_spike_outcome>(in, [&] { return outcome(in); });
}

CostRate clutch_cost_rate(const CostRateInputs& in) {
  return guarded<&clutch_cost_rate>(in, [&] {
    const double trips = in.spike_rate_per_min * in.p_trip_safe;
    const double breaks = in.spike_rate_per_min * in.p_break;
    return CostRate{trips, breaks, trips * in.trip_cost + breaks * in.break_cost,
                    1 / (1 + trips * in.trip_downtime_min + breaks * in.break_downtime_min)};
  });
}

OptimalSetting optimal_clutch_setting(const OptimumInputs& in) {
  return guarded<&optimal_clutch_setting>(in, [&] {
    const double low = in.cutting_torque_nm * (1 + in.accuracy) / 2;
    const double high = in.break_torque_nm;
    require(high > low, "break_torque_nm", high, "must be above cutting_torque_nm (1 + k_accuracy) / 2");
    const auto cost = [&](double set_torque) {
      const SpikeOutcome p = outcome({in.cutting_torque_nm, in.spike_mean_ratio, set_torque, in.accuracy,
                                      in.dynamic_factor, in.break_torque_nm});
      return p.p_trip_safe * in.trip_cost + p.p_break * in.break_cost;
    };
    constexpr int cells = 600;
    const auto node = [&](int k) { return k == cells ? high : low + (high - low) * k / cells; };
    int best = 0;
    double least = cost(low);
    for (int k = 1; k <= cells; ++k)
      if (const double here = cost(node(k)); here < least) {
        best = k;
        least = here;
      }
    const Minimum refined =
        minimize_unimodal(cost, node(std::max(best - 1, 0)), node(std::min(best + 1, cells)));
    if (refined.value < least) return OptimalSetting{refined.x, refined.value};
    return OptimalSetting{node(best), least};
  });
}

GrowthTripTime torque_growth_trip_time(const GrowthInputs& in) {
  return guarded<&torque_growth_trip_time>(in, [&] {
    const TripBand band = trip_band(in.set_torque_nm, in.accuracy);
    const auto reached = [&](double torque) {
      return std::max(0.0, (torque / in.initial_torque_nm - 1) / in.torque_growth_per_min);
    };
    return GrowthTripTime{reached(band.t_min_nm), reached(band.t_mean_nm), reached(band.t_max_nm)};
  });
}

StopEvent clutch_stop_event(const StopInputs& in) {
  return guarded<&clutch_stop_event>(in, [&] {
    const double limit = reengage_limit_rpm(in.clutch);
    if (limit > 0 && in.speed_rpm > limit)  // the ball jams in the slot: the clutch stays open
      return StopEvent{0, in.detect_min + in.manual_reset_min + in.restart_min, 0};
    // 1e-9 keeps a whole number of attempts from being rounded down.
    const double impacts = std::floor(in.speed_rpm * in.overload_clear_min / in.frequency + 1e-9);
    require(impacts < 1e15, "overload_clear_min", in.overload_clear_min, "gives more than 1e15 impacts");
    return StopEvent{1, in.overload_clear_min + in.frequency / in.speed_rpm + in.restart_min,
                     static_cast<std::int64_t>(impacts)};
  });
}

TestMetrics clutch_test_metrics(const TestSeries& in) {
  return guarded<&clutch_test_metrics>(in, [&] {
    const double trip = mean(in.static_trip_nm);
    const auto [least, most] = std::minmax_element(in.static_trip_nm.begin(), in.static_trip_nm.end());
    return TestMetrics{mean(in.dynamic_peak_nm) / trip, *most / *least, mean(in.reengage_nm) / trip,
                       mean(in.static_trip_after_nm) / trip, mean(in.idle_revolutions)};
  });
}

Torque motor_torque(const Motor& in) {
  return guarded<&motor_torque>(in, [&] { return Torque{1000 * in.power_kw * 30 / (pi * in.speed_rpm)}; });
}

StaticTrip clutch_static_trip_torque(const Pocket& in) {
  return guarded<&clutch_static_trip_torque>(in, [&] {
    const double angle = in.pocket_angle_deg * pi / 180 + std::atan(in.friction_coefficient);
    if (angle >= pi / 2) return StaticTrip{std::nullopt, 1};
    return StaticTrip{in.spring_force_n * in.element_radius_mm * 1e-3 * std::tan(angle), 0};
  });
}

}  // namespace verstat::models::k204
