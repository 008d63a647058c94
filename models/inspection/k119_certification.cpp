// Formulas of K119: published relations, tests, screening by a correlated test.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "models/inspection/k119_cutter_certification.h"
#include "models/math/bivariate_normal.h"
#include "models/math/life_law.h"
#include "models/math/normal.h"
#include "models/math/solve.h"

namespace verstat::models::k119 {
namespace {

// Eqs. (1)-(3).
double breaking_feed(double chip_resistance_s) {
  return 0.26 * std::pow(chip_resistance_s, 0.46);
}
double mean_life_s(double chip_resistance_s) {
  return 2.28 * std::pow(chip_resistance_s, 1.35);
}
double raw_breakage(double chip_resistance_s) {
  return 56.3 * std::pow(chip_resistance_s, -0.98);
}
double breakage(double chip_resistance_s) {
  return std::clamp(raw_breakage(chip_resistance_s), 0.0, 1.0);
}

// Table 2.
struct StrengthRow {
  double thickness_mm, feed_mm_rev, force_n, power_kw;
};
constexpr std::array strength_rows{StrengthRow{3.18, 1.30, 5400, 2.7}, StrengthRow{4.76, 2.20, 12700, 6.3},
                                   StrengthRow{6.35, 3.00, 18750, 9.5}, StrengthRow{7.94, 4.00, 31700, 16.5}};

InsertStrength strength(double thickness_mm) {
  std::size_t k = 1;
  while (k + 1 < strength_rows.size() && thickness_mm > strength_rows[k].thickness_mm) ++k;
  const StrengthRow& a = strength_rows[k - 1];
  const StrengthRow& b = strength_rows[k];
  const double share = (thickness_mm - a.thickness_mm) / (b.thickness_mm - a.thickness_mm);
  return {std::lerp(a.feed_mm_rev, b.feed_mm_rev, share), std::lerp(a.force_n, b.force_n, share),
          std::lerp(a.power_kw, b.power_kw, share)};
}

// Tables 3 and 4, in the order of Treatment.
struct BatchRow {
  double chip_s, feed_mm_rev, life_s, breakage, r_feed, r_life, r_breakage;
};
constexpr std::array batches{
    BatchRow{90, 1.91, 1120, 0.86, 0.78, 0.67, -0.79}, BatchRow{55, 1.64, 590, 0.99, 0.69, 0.74, -0.83},
    BatchRow{190, 2.80, 2990, 0.31, 0.81, 0.70, -0.69}, BatchRow{115, 2.70, 2430, 0.44, 0.91, 0.81, -0.76}};

// Share that is bad and rejected, J.
double bad_and_rejected(double rho, double bad, double reject) {
  return std::clamp(bivariate_normal_cdf(normal_quantile(bad), normal_quantile(reject), rho),
                    std::max(0.0, bad + reject - 1), std::min(bad, reject));
}

double bad_among_accepted(double rho, double bad, double reject) {
  return (bad - bad_and_rejected(rho, bad, reject)) / (1 - reject);
}

// Survival of the accepted at the cumulative hazard y = (t/s)^k.
double accepted_survival(double y, double rho, double reject) {
  if (y == 0) return 1;
  const double survives = std::exp(-y);
  if (survives == 0) return 0;
  // Normal score of the life; from the tail that keeps its digits.
  const double fails = -std::expm1(-y);
  const double z = fails > 0.5 ? -normal_quantile(survives) : normal_quantile(fails);
  return std::min(1.0, bivariate_normal_cdf(-z, -normal_quantile(reject), rho) / (1 - reject));
}

// Moments of the life of accepted and rejected inserts as integrals over the normal score z of life. The
// lives at the nodes are computed once for all reject fractions.
// The trapezoidal rule converges faster than any power for such integrands: the transform of the selection
// falls like exp(-(spread w)^2 / 2), which at w = 2 pi / step is below 1e-12 for a step of 0.85 spreads.
class LifeBySelection {
 public:
  LifeBySelection(double shape, double scale_min, double rho)
      : panels_(static_cast<int>(std::ceil(2 * last / std::min(0.25, 0.85 * spread_of(rho))))),
        step_(2 * last / panels_),
        life_min_(static_cast<std::size_t>(panels_) + 1),
        weight_(static_cast<std::size_t>(panels_) + 1) {
    for (int i = 0; i <= panels_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double z = node(i);
      const double hazard = z < 0 ? -std::log1p(-normal_cdf(z)) : -std::log(normal_cdf(-z));
      life_min_[k] = scale_min * std::pow(hazard, 1 / shape);
      weight_[k] = step_ * normal_density(z);
    }
  }
  struct Moments {
    double first;
    double second;
  };
  [[nodiscard]] Moments accepted(double rho, double reject) const {
    return moments(rho, normal_quantile(reject), 1, 1 - reject);
  }
  [[nodiscard]] Moments rejected(double rho, double reject) const {
    return moments(rho, normal_quantile(reject), -1, reject);
  }

 private:
  static constexpr double last = 8.5;
  static double spread_of(double rho) { return std::sqrt((1 - rho) * (1 + rho)); }
  [[nodiscard]] double node(int i) const { return -last + i * step_; }

  // `side` 1: scores above the limit, -1: below; `share` of the inserts on that side.
  [[nodiscard]] Moments moments(double rho, double limit, double side, double share) const {
    const double spread = spread_of(rho);
    Moments out{0, 0};
    for (int i = 0; i <= panels_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double chosen = weight_[k] * normal_cdf(side * (rho * node(i) - limit) / spread);
      out.first += chosen * life_min_[k];
      out.second += chosen * life_min_[k] * life_min_[k];
    }
    return {out.first / share, out.second / share};
  }

  int panels_;
  double step_;
  std::vector<double> life_min_;
  std::vector<double> weight_;
};

double mean_life_min(double shape, double scale_min) {
  return scale_min * LifeLaw::weibull(1, shape).mean();
}

// Cost rate without and with sorting, for one or many reject fractions.
class Inspection {
 public:
  explicit Inspection(const InspectionPlan& in)
      : in_(in),
        life_(in.shape, in.scale_min, in.rho_life),
        mean_min_(mean_life_min(in.shape, in.scale_min)) {
    require(in.edges_used_by_test < in.edges_per_insert, "edges_used_by_test", in.edges_used_by_test,
            "must be below edges_per_insert");
    require(in.salvage_value <= in.insert_cost, "salvage_value", in.salvage_value,
            "must not be above insert_cost");
    if (!(cost_rate_without() > 0))
      reject("without inspection there are no costs at all: insert, change or breakage must cost something");
  }
  [[nodiscard]] double cost_rate_without() const {
    return (in_.insert_cost / static_cast<double>(in_.edges_per_insert) + in_.change_cost +
            in_.breakage_fraction * in_.breakage_cost) /
           mean_min_;
  }
  [[nodiscard]] InspectionDecision at(double reject) const {
    const double q = in_.breakage_fraction;
    InspectionDecision out{};
    out.breakage_fraction_accepted = q > 0 && q < 1 ? bad_among_accepted(in_.rho_break, q, reject) : q;
    out.mean_life_accepted_min = life_.accepted(in_.rho_life, reject).first;
    const auto edges = static_cast<double>(in_.edges_per_insert - in_.edges_used_by_test);
    out.cost_rate_without = cost_rate_without();
    out.cost_rate_with =
        ((in_.insert_cost + in_.test_cost - reject * in_.salvage_value) / ((1 - reject) * edges) +
         in_.change_cost + out.breakage_fraction_accepted * in_.breakage_cost) /
        out.mean_life_accepted_min;
    out.saving_fraction = 1 - out.cost_rate_with / out.cost_rate_without;
    out.inspect = out.cost_rate_with < out.cost_rate_without;
    out.breakages_per_hour_without = 60 * q / mean_min_;
    out.breakages_per_hour_with = 60 * out.breakage_fraction_accepted / out.mean_life_accepted_min;
    return out;
  }

 private:
  const InspectionPlan& in_;
  LifeBySelection life_;
  double mean_min_;
};

}  // namespace

ChippingPrediction chipping_test_predict(const ChippingTest& in) {
  return guarded<&chipping_test_predict>(in, [&] {
    const double life_s = mean_life_s(in.chip_resistance_s);
    return ChippingPrediction{breaking_feed(in.chip_resistance_s), life_s, life_s / 60,
                              raw_breakage(in.chip_resistance_s), breakage(in.chip_resistance_s)};
  });
}

BreakingFeedPrediction breaking_feed_predict(const BreakingFeed& in) {
  return guarded<&breaking_feed_predict>(in, [&] {
    const double chip_s = std::pow(in.breaking_feed_mm_rev / 0.26, 1 / 0.46);
    return BreakingFeedPrediction{chip_s, mean_life_s(chip_s) / 60, breakage(chip_s)};
  });
}

RequiredChipResistance required_chip_resistance(const LotTargets& in) {
  return guarded<&required_chip_resistance>(in, [&] {
    const double by_life_s = std::pow(60 * in.min_mean_life_min / 2.28, 1 / 1.35);
    const double by_breakage_s = std::pow(56.3 / in.max_breakage_fraction, 1 / 0.98);
    return RequiredChipResistance{by_life_s, by_breakage_s, std::max(by_life_s, by_breakage_s)};
  });
}

FailureCycles ultrasonic_failure_cycles(const UltrasonicTest& in) {
  return guarded<&ultrasonic_failure_cycles>(in, [&] {
    const bool shift = in.indicator == UltrasonicIndicator::shift;
    const double factor = shift ? 0.91 : 2.65;
    const double exponent = shift ? 0.84 : 0.55;
    require(in.cycles_millions <= std::pow(factor, 1 / (1 - exponent)), "cycles", in.cycles_millions,
            shift ? "must not be above 0.91^(1/0.16) = 0.5546: the shift would come after the destruction"
                  : "must not be above 2.65^(1/0.45) = 8.7206: the damage would come after the destruction");
    return FailureCycles{factor * std::pow(in.cycles_millions, exponent)};
  });
}

InsertStrength insert_strength_by_thickness(const InsertThickness& in) {
  return guarded<&insert_strength_by_thickness>(in, [&] { return strength(in.thickness_mm); });
}

SteppedFeedApplicability stepped_feed_applicable(const SteppedFeedSetup& in) {
  return guarded<&stepped_feed_applicable>(in, [&] {
    const InsertStrength breaks = strength(in.thickness_mm);
    SteppedFeedApplicability out{};
    out.size_ok = in.holder_height_mm <= 32 && in.thickness_mm <= 6.35;
    out.feed_ok = in.machine_max_feed_mm_rev >= breaks.breaking_feed_mm_rev;
    out.power_ok = in.machine_power_kw >= breaks.power_kw;
    out.applicable = out.size_ok && out.feed_ok && out.power_ok;
    return out;
  });
}

TestScore strength_test_score(const TestScores& in) {
  return guarded<&strength_test_score>(
      in, [&] { return TestScore{in.universality + in.tool_cost + in.result_quality}; });
}

TreatmentVariant treatment_variant(const TreatmentIn& in) {
  return guarded<&treatment_variant>(in, [&] {
    const BatchRow& row = batches[static_cast<std::size_t>(in.variant)];
    const BatchRow& standard = batches[0];
    return TreatmentVariant{row.chip_s,
                            row.feed_mm_rev,
                            row.life_s / 60,
                            row.breakage,
                            row.r_feed,
                            row.r_life,
                            row.r_breakage,
                            row.life_s / standard.life_s,
                            row.breakage / standard.breakage};
  });
}

SteppedFeedTest stepped_feed_test(const SteppedFeed& in) {
  return guarded<&stepped_feed_test>(in, [&] {
    // 1e-9 keeps a feed that is met exactly from costing one step more.
    const double more = std::max(
        0.0, std::ceil((in.breaking_feed_mm_rev - in.start_feed_mm_rev) / in.feed_step_mm_rev - 1e-9));
    require(more < 1e15, "feed_step_mm_rev", in.feed_step_mm_rev, "asks for more than 1e15 steps");
    const double duration_s = (1 + more) * in.step_time_s;
    return SteppedFeedTest{1 + static_cast<std::int64_t>(more), duration_s,
                           in.cutting_speed_m_min * duration_s / 60};
  });
}

WeibullLife weibull_from_mean_cv(const LifeMoments& in) {
  return guarded<&weibull_from_mean_cv>(in, [&] {
    const LifeLaw law(LifeLawKind::weibull, in.mean_life_min, in.life_cv);
    return WeibullLife{law.shape(), law.scale()};
  });
}

LifeModel life_model_from_chipping_test(const ChippingLife& in) {
  return guarded<&life_model_from_chipping_test>(in, [&] {
    const LifeLaw law(LifeLawKind::weibull, mean_life_s(in.chip_resistance_s) / 60, in.life_cv);
    return LifeModel{law.mean(), breakage(in.chip_resistance_s), law.shape(), law.scale()};
  });
}

Screening screen_by_correlated_test(const Screen& in) {
  return guarded<&screen_by_correlated_test>(in, [&] {
    const double d = in.bad_fraction;
    const double p = in.reject_fraction;
    const double both = bad_and_rejected(in.rho, d, p);
    return Screening{both / d, 1 - (p - both) / (1 - d), (d - both) / (1 - p), both / p, p - both};
  });
}

RejectFraction reject_fraction_for_target(const ScreenTarget& in) {
  return guarded<&reject_fraction_for_target>(in, [&] {
    constexpr double most = 0.999;
    if (in.target_bad_fraction >= in.bad_fraction) return RejectFraction{0, true};
    if (in.rho == 0) return RejectFraction{1, false};
    const auto excess = [&](double p) {
      return p == 0 ? in.bad_fraction - in.target_bad_fraction
                    : bad_among_accepted(in.rho, in.bad_fraction, p) - in.target_bad_fraction;
    };
    if (excess(most) > 0) return RejectFraction{1, false};
    return RejectFraction{find_root(excess, 0, most), true};
  });
}

ScreenedSurvival screened_survival(const ScreenedAtTime& in) {
  return guarded<&screened_survival>(in, [&] {
    const double y = std::pow(in.time_min / in.scale_min, in.shape);
    return ScreenedSurvival{std::exp(-y), accepted_survival(y, in.rho, in.reject_fraction)};
  });
}

ScreenedLife screened_life(const ScreenedLifeIn& in) {
  return guarded<&screened_life>(in, [&] {
    const LifeBySelection life(in.shape, in.scale_min, in.rho);
    const auto accepted = life.accepted(in.rho, in.reject_fraction);
    ScreenedLife out{};
    out.mean_all_min = mean_life_min(in.shape, in.scale_min);
    out.mean_accepted_min = accepted.first;
    out.mean_rejected_min = life.rejected(in.rho, in.reject_fraction).first;
    out.cv_accepted = std::sqrt(std::max(0.0, accepted.second / (accepted.first * accepted.first) - 1));
    const LifeLaw equivalent(LifeLawKind::weibull, accepted.first, out.cv_accepted);
    out.equivalent_shape = equivalent.shape();
    out.equivalent_scale_min = equivalent.scale();
    const double y =
        find_root([&](double hazard) { return accepted_survival(hazard, in.rho, in.reject_fraction) - 0.9; },
                  0, 60, 1e-13);
    out.b10_accepted_min = in.scale_min * std::pow(y, 1 / in.shape);
    return out;
  });
}

LotAcceptance lot_acceptance(const LotPlan& in) {
  return guarded<&lot_acceptance>(in, [&] {
    return LotAcceptance{normal_cdf((std::log(in.tc_lot_s) - std::log(in.tc_critical_s)) *
                                    std::sqrt(static_cast<double>(in.sample_size)) / in.ln_sd_within)};
  });
}

LotCorrelation lot_mean_correlation(const LotScatter& in) {
  return guarded<&lot_mean_correlation>(in, [&] {
    return LotCorrelation{
        in.ln_sd_between /
        std::hypot(in.ln_sd_between, in.ln_sd_within / std::sqrt(static_cast<double>(in.sample_size)))};
  });
}

InspectionDecision inspection_decision(const InspectionIn& in) {
  return guarded<&inspection_decision>(in, [&] { return Inspection(in).at(in.reject_fraction); });
}

OptimalReject optimal_reject_fraction(const InspectionPlan& in) {
  return guarded<&optimal_reject_fraction>(in, [&] {
    const Inspection inspection(in);
    OptimalReject best{0, inspection.cost_rate_without()};
    for (int k = 1; k <= 90; ++k) {
      const double cost_rate = inspection.at(k / 100.0).cost_rate_with;
      if (cost_rate < best.cost_rate) best = {k / 100.0, cost_rate};
    }
    return best;
  });
}

}  // namespace verstat::models::k119
