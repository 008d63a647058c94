// The checks of card K119; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/inspection/k119_cutter_certification.h"

using namespace verstat::models;
using namespace verstat::models::k119;

namespace {

constexpr double shape = 2.1013490946885454;  // cv 0.5

InspectionIn plan() {
  return {{9, 6, 0, 0.5, 2, 3, 40, shape, 56.26, 0.31, 0.7, 0.69}, 0.2};
}

}  // namespace

TEST_CASE("K119: Table 1 sums, Tables 2-4, and the fits within their stated errors", "[K119]") {
  CHECK(strength_test_score({1.13, 0.80, 0.47}).score == Approx(2.40));
  CHECK(strength_test_score({1.17, 0.60, 0.37}).score == Approx(2.14));
  CHECK(strength_test_score({0.45, 0.56, 0.40}).score == Approx(1.41));
  CHECK(insert_strength_by_thickness({7.94}).breaking_force_n == 31700);
  CHECK(insert_strength_by_thickness({4.76}).power_kw == Approx(6.3));
  struct Fit {
    Treatment variant;
    double feed_percent, life_percent, breakage_percent;
  };
  for (const Fit& fit : {Fit{Treatment::standard, 7.9, -11.5, -20}, Fit{Treatment::tin, 0.2, -13.6, 1},
                         Fit{Treatment::bo, 3.8, -9.1, 6}, Fit{Treatment::bo_tin, -14.6, -43, 22}}) {
    const TreatmentVariant seen = treatment_variant({fit.variant});
    const ChippingPrediction told = chipping_test_predict({seen.chip_resistance_s});
    CHECK(100 * (told.breaking_feed_mm_rev / seen.breaking_feed_mm_rev - 1) ==
          Approx(fit.feed_percent).margin(0.06));
    CHECK(100 * (told.mean_life_min / seen.mean_life_min - 1) == Approx(fit.life_percent).margin(0.3));
    CHECK(100 * (told.breakage_fraction / seen.breakage_fraction - 1) ==
          Approx(fit.breakage_percent).margin(0.8));
  }
  CHECK(treatment_variant({Treatment::bo}).life_ratio == Approx(2.67).margin(0.005));
}

TEST_CASE("K119: predictions are monotonic and their inverses meet the targets", "[K119]") {
  CHECK(rc::check([] {
    const double t_c = *rc::gen::inRange(1, 3000) * 0.1;
    const ChippingPrediction a = chipping_test_predict({t_c});
    const ChippingPrediction b = chipping_test_predict({t_c * 1.01});
    RC_ASSERT(a.breakage_fraction >= 0);
    RC_ASSERT(a.breakage_fraction <= 1);
    RC_ASSERT(b.breakage_fraction <= a.breakage_fraction);
    RC_ASSERT(b.breaking_feed_mm_rev > a.breaking_feed_mm_rev);
    RC_ASSERT(b.mean_life_s > a.mean_life_s);
    RC_ASSERT(std::abs(breaking_feed_predict({a.breaking_feed_mm_rev}).chip_resistance_s / t_c - 1) < 1e-12);
    const LotTargets targets{*rc::gen::inRange(1, 100) * 1.0, *rc::gen::inRange(1, 101) * 0.01};
    const ChippingPrediction met =
        chipping_test_predict({required_chip_resistance(targets).chip_resistance_s});
    RC_ASSERT(met.mean_life_min >= targets.min_mean_life_min * (1 - 1e-12));
    RC_ASSERT(met.breakage_fraction <= targets.max_breakage_fraction * (1 + 1e-12));
  }));
}

TEST_CASE("K119: the stepped-feed test", "[K119]") {
  SteppedFeed in;
  in.breaking_feed_mm_rev = 0.7;
  CHECK(stepped_feed_test(in).steps == 1);
  in.breaking_feed_mm_rev = 0.76 + 4 * 0.1;  // met exactly by the fifth step
  CHECK(stepped_feed_test(in).steps == 5);
  in.breaking_feed_mm_rev += 1e-6;
  CHECK(stepped_feed_test(in).steps == 6);
  CHECK_FALSE(stepped_feed_applicable({33, 4.76, 100, 100}).applicable);
  CHECK_FALSE(stepped_feed_applicable({32, 6.36, 100, 100}).size_ok);
  CHECK(stepped_feed_applicable({32, 6.35, 9.5, 3.0}).applicable);
}

TEST_CASE("K119: screening balances, and grows with rho", "[K119]") {
  CHECK(rc::check([] {
    const double d = *rc::gen::inRange(1, 1000) * 0.001;
    const double p = *rc::gen::inRange(1, 1000) * 0.001;
    const double rho = *rc::gen::inRange(0, 980) * 0.001;
    const Screening s = screen_by_correlated_test({rho, d, p});
    RC_ASSERT(std::abs(p * s.bad_fraction_rejected + (1 - p) * s.bad_fraction_accepted - d) < 1e-14);
    const Screening more = screen_by_correlated_test({rho + 0.01, d, p});
    RC_ASSERT(more.sensitivity >= s.sensitivity - 1e-12);
    RC_ASSERT(more.specificity >= s.specificity - 1e-12);
    const Screening blind = screen_by_correlated_test({0, d, p});
    RC_ASSERT(std::abs(blind.sensitivity - p) < 1e-12);
    RC_ASSERT(std::abs(blind.bad_fraction_accepted - d) < 1e-12);
    const double target = d * *rc::gen::inRange(1, 100) * 0.01;
    const RejectFraction found = reject_fraction_for_target({rho, d, target});
    if (found.feasible && found.reject_fraction >= 0.001)
      RC_ASSERT(std::abs(screen_by_correlated_test({rho, d, found.reject_fraction}).bad_fraction_accepted -
                         target) < 1e-9);
  }));
  CHECK(screen_by_correlated_test({0.995, 0.1, 0.1}).bad_fraction_accepted < 0.01);
  CHECK(reject_fraction_for_target({0.5, 0.2, 0.2}).reject_fraction == 0);
  CHECK_FALSE(reject_fraction_for_target({0, 0.2, 0.1}).feasible);
  // "With rho = 0.96 and 10 % weak assemblies, rejecting 15 % leaves 0.7 % weak."
  CHECK(screen_by_correlated_test({0.96, 0.1, 0.15}).bad_fraction_accepted == Approx(0.007).margin(5e-4));
}

TEST_CASE("K119: the card's table of screening", "[K119]") {
  struct Row {
    Treatment variant;
    double p, q, sensitivity, mean_min, cv, b10_min;
  };
  using enum Treatment;
  for (const Row& row :
       {Row{standard, 0.1, 0.844, 0.116, 19.8, 0.458, 8.8},
        Row{standard, 0.3, 0.801, 0.348, 21.6, 0.408, 10.8},
        Row{standard, 0.5, 0.729, 0.576, 23.6, 0.371, 12.8}, Row{bo, 0.1, 0.253, 0.265, 52.9, 0.455, 23.6},
        Row{bo, 0.3, 0.168, 0.622, 58.1, 0.402, 29.5}, Row{bo, 0.5, 0.102, 0.835, 63.7, 0.362, 35.3},
        Row{bo_tin, 0.1, 0.383, 0.217, 43.3, 0.444, 20.2}, Row{bo_tin, 0.3, 0.271, 0.568, 48.3, 0.378, 26.4},
        Row{bo_tin, 0.5, 0.169, 0.807, 53.6, 0.328, 32.2}}) {
    const TreatmentVariant batch = treatment_variant({row.variant});
    const Screening s = screen_by_correlated_test({-batch.r_breakage_chip, batch.breakage_fraction, row.p});
    CHECK(s.bad_fraction_accepted == Approx(row.q).margin(5.1e-4));
    CHECK(s.sensitivity == Approx(row.sensitivity).margin(5.1e-4));
    const WeibullLife law = weibull_from_mean_cv({batch.mean_life_min, 0.5});
    const ScreenedLife life = screened_life({law.shape, law.scale_min, batch.r_life_chip, row.p});
    CHECK(life.mean_accepted_min == Approx(row.mean_min).margin(0.051));
    CHECK(life.cv_accepted == Approx(row.cv).margin(5.1e-4));
    // The table starts from means rounded to 0.1 min: 18.7 for 18.667.
    CHECK(life.b10_accepted_min == Approx(row.b10_min).margin(0.06));
  }
}

TEST_CASE("K119: screened life balances and improves", "[K119]") {
  CHECK(rc::check([] {
    const double k = *rc::gen::inRange(8, 60) * 0.1;
    const double rho = *rc::gen::inRange(1, 95) * 0.01;
    const double p = *rc::gen::inRange(5, 90) * 0.01;
    const ScreenedLife s = screened_life({k, 50, rho, p});
    RC_ASSERT(std::abs((p * s.mean_rejected_min + (1 - p) * s.mean_accepted_min) / s.mean_all_min - 1) <
              1e-7);
    const double t = *rc::gen::inRange(1, 150);
    const ScreenedSurvival r = screened_survival({{k, 50, rho, p}, t});
    RC_ASSERT(r.accepted >= r.all - 1e-14);
    const ScreenedSurvival at_b10 = screened_survival({{k, 50, rho, p}, s.b10_accepted_min});
    RC_ASSERT(std::abs(at_b10.accepted - 0.9) < 1e-10);
    const ScreenedLife more = screened_life({k, 50, rho, p + 0.05});
    const ScreenedLife sharper = screened_life({k, 50, rho + 0.04, p});
    RC_ASSERT(more.mean_accepted_min > s.mean_accepted_min);
    RC_ASSERT(sharper.mean_accepted_min > s.mean_accepted_min);
    RC_ASSERT(more.b10_accepted_min > s.b10_accepted_min);
    RC_ASSERT(sharper.b10_accepted_min > s.b10_accepted_min);
  }));
  const ScreenedLife blind = screened_life({shape, 50, 0, 0.3});
  CHECK(blind.mean_accepted_min == Approx(blind.mean_all_min).epsilon(1e-7));
  CHECK(blind.equivalent_shape == Approx(shape).epsilon(1e-6));
  CHECK(screened_life({shape, 50, 0.7, 0.3}).cv_accepted < 0.5);
  // Narrow laws: the equivalent shape lies far above 60.
  CHECK(screened_life({30, 50, 0.995, 0.999}).equivalent_shape > 60);
  // Drawing pairs of scores gives the same mean.
  std::mt19937_64 bits(119);
  const auto normal_score = [&] {
    double sum = -6;  // twelve uniforms: close enough to normal for a check to 1 %
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(bits() >> 11) * 0x1p-53;
    return sum;
  };
  double total = 0;
  int accepted = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double y = normal_score();
    const double x = 0.7 * y + std::sqrt(0.51) * normal_score();
    if (x < -0.5244005127080407) continue;  // Phi^-1(0.3)
    total += 50 * std::pow(-std::log(0.5 * std::erfc(y / std::sqrt(2.0))), 1 / shape);
    ++accepted;
  }
  CHECK(screened_life({shape, 50, 0.7, 0.3}).mean_accepted_min == Approx(total / accepted).epsilon(0.01));
}

TEST_CASE("K119: lots", "[K119]") {
  CHECK(lot_acceptance({100, 0.35, 7, 100}).p_accept == 0.5);
  CHECK(lot_acceptance({120, 0.35, 9, 100}).p_accept > lot_acceptance({120, 0.35, 4, 100}).p_accept);
  CHECK(lot_acceptance({80, 0.35, 9, 100}).p_accept < lot_acceptance({80, 0.35, 4, 100}).p_accept);
  CHECK(lot_mean_correlation({0.3, 0.35, 1'000'000'000}).rho_lot == Approx(1).epsilon(1e-8));
}

TEST_CASE("K119: inspection decision", "[K119]") {
  InspectionIn in = plan();
  in.rho_life = in.rho_break = 0;
  CHECK_FALSE(inspection_decision(in).inspect);
  CHECK(optimal_reject_fraction(in).reject_fraction == 0);
  in = plan();
  const double saved = inspection_decision(in).saving_fraction;
  in.breakage_cost *= 2;
  CHECK(inspection_decision(in).saving_fraction > saved);
  in.breakage_fraction = 1;
  CHECK(inspection_decision(in).breakage_fraction_accepted == 1);
  CHECK_NOTHROW(optimal_reject_fraction(in));
  // The grid optimum beats every other grid point.
  in = plan();
  const OptimalReject best = optimal_reject_fraction(in);
  for (int k = 1; k <= 90; ++k) {
    in.reject_fraction = k / 100.0;
    CHECK(inspection_decision(in).cost_rate_with >= best.cost_rate);
  }
}

TEST_CASE("K119: bad input names itself", "[K119]") {
  CHECK_THROWS_WITH(ultrasonic_failure_cycles({UltrasonicIndicator::shift, 0.56}),
                    Catch::Contains("cycles = 0.56, must not be above 0.91^(1/0.16)"));
  InspectionIn in = plan();
  in.edges_used_by_test = 6;
  CHECK_THROWS_WITH(inspection_decision(in),
                    "K119.inspection_decision: edges_used_by_test = 6, must be below edges_per_insert");
  in = plan();
  in.salvage_value = 10;
  CHECK_THROWS_WITH(inspection_decision(in), Catch::Contains("must not be above insert_cost"));
  in = plan();
  in.insert_cost = in.salvage_value = in.change_cost = in.breakage_cost = 0;
  CHECK_THROWS_WITH(inspection_decision(in), Catch::Contains("no costs at all"));
}
