// K113, first half: thrust and torque of the drill over a group of steels, and the printed data.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/drilling/k113_through_hole_feed_change.h"

namespace verstat::models::k113 {
namespace {

constexpr double feed_rule_exponent = 0.6;  // eq. (2)

struct MeanSd {
  double mean;
  double sd;
};

MeanSd mean_and_sd(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  // Equal values have no spread; their computed mean may be off by a rounding.
  if (std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); }))
    return {values.front(), 0};
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

}  // namespace

DrillThrust drill_thrust(const DrillThrustInputs& in) {
  return guarded<&drill_thrust>(in, [&] {
    return DrillThrust{in.coefficient * std::pow(in.diameter_mm, in.exp_diameter) *
                       std::pow(in.feed_mm_rev, in.exp_feed) * std::pow(in.hardness_hb, in.exp_hardness)};
  });
}

FeedRule drill_feed_rule(const FeedRuleInputs& in) {
  return guarded<&drill_feed_rule>(
      in, [&] { return FeedRule{in.feed_coefficient * std::pow(in.diameter_mm, feed_rule_exponent)}; });
}

ThrustLaw thrust_diameter_law(const ThrustLawInputs& in) {
  return guarded<&thrust_diameter_law>(in, [&] {
    return ThrustLaw{in.coefficient * std::pow(in.hardness_hb, in.exp_hardness) *
                         std::pow(in.feed_coefficient, in.exp_feed),
                     in.exp_diameter + feed_rule_exponent * in.exp_feed};
  });
}

LoadFit fit_load_diameter_law(const LoadFitInputs& in) {
  return guarded<&fit_load_diameter_law>(in, [&] {
    const std::size_t n = in.diameters_mm.size();
    require(in.loads.size() == n, "loads", static_cast<std::int64_t>(in.loads.size()),
            "entries: must be as many as diameters_mm");
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t k = 0; k < n; ++k) {
      mean_x += std::log(in.diameters_mm[k]) / static_cast<double>(n);
      mean_y += std::log(in.loads[k]) / static_cast<double>(n);
    }
    double sxx = 0;
    double sxy = 0;
    double syy = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double dx = std::log(in.diameters_mm[k]) - mean_x;
      const double dy = std::log(in.loads[k]) - mean_y;
      sxx += dx * dx;
      sxy += dx * dy;
      syy += dy * dy;
    }
    const bool one_diameter = std::all_of(in.diameters_mm.begin(), in.diameters_mm.end(), [&](double d) {
      return std::log(d) == std::log(in.diameters_mm.front());
    });
    require(!one_diameter, "diameters_mm", in.diameters_mm.front(), "at least two must be distinct");
    const bool one_load =
        std::all_of(in.loads.begin(), in.loads.end(), [&](double p) { return p == in.loads.front(); });
    if (one_load) return LoadFit{in.loads.front(), 0, 1};
    const double slope = sxy / sxx;
    return LoadFit{std::exp(mean_y - slope * mean_x), slope, std::min(1.0, sxy * sxy / (sxx * syy))};
  });
}

GroupLoad group_load_bounds(const GroupLoadInputs& in) {
  return guarded<&group_load_bounds>(in, [&] {
    require(in.exponents.size() == in.coefficients.size(), "exponents",
            static_cast<std::int64_t>(in.exponents.size()), "entries: must be as many as coefficients");
    const MeanSd c = mean_and_sd(in.coefficients);
    const MeanSd x = mean_and_sd(in.exponents);
    std::vector<double> log_loads;
    log_loads.reserve(in.coefficients.size());
    for (std::size_t k = 0; k < in.coefficients.size(); ++k)
      log_loads.push_back(std::log(in.coefficients[k]) + in.exponents[k] * std::log(in.diameter_mm));
    const MeanSd joint = mean_and_sd(log_loads);
    const double k = in.sigma_multiplier;
    return GroupLoad{.coefficient_mean = c.mean,
                     .coefficient_sd = c.sd,
                     .exponent_mean = x.mean,
                     .exponent_sd = x.sd,
                     .load_likely = c.mean * std::pow(in.diameter_mm, x.mean),
                     .load_max = (c.mean + k * c.sd) * std::pow(in.diameter_mm, x.mean + k * x.sd),
                     .load_median_joint = std::exp(joint.mean),
                     .load_max_joint = std::exp(joint.mean + k * joint.sd)};
  });
}

FeedLimits drill_strength_feed_limits(const FeedLimitInputs& in) {
  return guarded<&drill_strength_feed_limits>(in, [&] {
    constexpr double n_mm_per_n_m = 1000;
    const double torque_at_unit_feed_nm =
        in.torque_coefficient_nm * std::pow(in.diameter_mm, in.torque_exp_diameter);
    const double torsion =
        std::pow(in.torsion_allow_mpa * in.section_modulus_mm3 / (n_mm_per_n_m * torque_at_unit_feed_nm),
                 1 / in.torque_exp_feed);
    const double effective_mm = in.length_factor * in.overhang_mm;
    const double critical_n = std::numbers::pi * std::numbers::pi * in.elastic_modulus_mpa * in.inertia_mm4 /
                              (effective_mm * effective_mm);
    const double buckling =
        std::pow(critical_n / (in.thrust_coefficient_n * std::pow(in.diameter_mm, in.thrust_exp_diameter)),
                 1 / in.thrust_exp_feed);
    return FeedLimits{torsion, critical_n, buckling, std::min(torsion, buckling), buckling < torsion ? 1 : 0};
  });
}

SteelHardness steel_hardness(const SteelInputs& in) {
  return guarded<&steel_hardness>(in, [&] {
    switch (in.grade) {
      case SteelGrade::s15kh:
        return SteelHardness{179};
      case SteelGrade::s38kha:
        return SteelHardness{207};
      case SteelGrade::s30khm:
        return SteelHardness{229};
      case SteelGrade::s20kh2n4a:
        return SteelHardness{269};
      case SteelGrade::s40khf:
        return SteelHardness{241};
      case SteelGrade::s40khs:
        return SteelHardness{255};
    }
    reject("unknown grade");
  });
}

PublishedRange published_ranges(const PublishedRangeInputs& in) {
  return guarded<&published_ranges>(in, [&] {
    switch (in.quantity) {
      case PublishedQuantity::breakthrough_feed_jump:
        return PublishedRange{1.4, 1.85};
      case PublishedQuantity::feed_reduction_percent:
        return PublishedRange{10, 25};
      case PublishedQuantity::feed_divisor_special:
        return PublishedRange{1.35, 1.6};
      case PublishedQuantity::zone_fraction:
        return PublishedRange{0.2, 0.5};
      case PublishedQuantity::clutch_safety_factor:
        return PublishedRange{1.15, 1.25};
      case PublishedQuantity::small_diameter_limit_mm:
        return PublishedRange{1, 2.5};
      case PublishedQuantity::drilling_labour_share_single_percent:
        return PublishedRange{6, 7};
      case PublishedQuantity::drilling_labour_share_medium_percent:
        return PublishedRange{10, 12};
    }
    reject("unknown quantity");
  });
}

}  // namespace verstat::models::k113
