// The checks of card K121; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/inspection/k121_thermo_emf.h"

using namespace verstat::models;
using namespace verstat::models::k121;

TEST_CASE("K121: the card's table of coefficient and speed", "[K121]") {
  const double c_v[] = {290.4, 241.6, 201.2, 165.9, 134.1, 105.0, 77.9, 52.4};
  const double v[] = {195.1, 162.4, 135.2, 111.5, 90.2, 70.6, 52.4, 35.2};
  for (int i = 0; i < 8; ++i) {
    const double emf_mv = 3 + i;
    CHECK(emf_speed_coefficient({emf_mv}).c_v == Approx(c_v[i]).margin(0.051));
    CHECK(emf_cutting_speed({{emf_mv}, {1, 0.3, 1}, 60}).speed_m_min == Approx(v[i]).margin(0.051));
  }
}

TEST_CASE("K121: speed and life are inverse, fall with E and scale as printed", "[K121]") {
  CHECK(rc::check([] {
    const double emf_mv = *rc::gen::inRange(1, 1200) * 0.01;
    const double life_min = *rc::gen::inRange(1, 300);
    const Cut cut{*rc::gen::inRange(1, 50) * 0.1, *rc::gen::inRange(1, 20) * 0.05,
                  *rc::gen::inRange(1, 30) * 0.1};
    const double v = emf_cutting_speed({{emf_mv}, cut, life_min}).speed_m_min;
    RC_ASSERT(std::abs(emf_tool_life({{emf_mv}, cut, v}).tool_life_min / life_min - 1) < 1e-12);
    RC_ASSERT(emf_cutting_speed({{emf_mv + 0.1}, cut, life_min}).speed_m_min < v);
    RC_ASSERT(std::abs(emf_cutting_speed({{emf_mv}, cut, 32 * life_min}).speed_m_min * 2 / v - 1) < 1e-12);
    Cut other = cut;
    other.k_v *= 2;
    RC_ASSERT(std::abs(emf_cutting_speed({{emf_mv}, other, life_min}).speed_m_min / v - 2) < 1e-12);
    RC_ASSERT(std::abs(emf_tool_life({{emf_mv}, other, v}).tool_life_min / life_min - 32) < 1e-10);
    other = cut;
    other.depth_mm *= 2;
    other.feed_mm_rev *= 3;
    RC_ASSERT(std::abs(emf_cutting_speed({{emf_mv}, other, life_min}).speed_m_min * std::pow(2, 0.15) *
                           std::pow(3, 0.35) / v -
                       1) < 1e-12);
    // The handbook form with the same exponents.
    RC_ASSERT(
        std::abs(handbook_cutting_speed({cut, emf_speed_coefficient({emf_mv}).c_v, life_min, 0.2, 0.15, 0.35})
                         .speed_m_min /
                     v -
                 1) < 1e-12);
    const EmfLimit limit = emf_limit_for_regime({cut, v, life_min});
    if (emf_mv > 0.06) {
      RC_ASSERT(limit.feasible);
      RC_ASSERT(std::abs(limit.emf_limit_mv - emf_mv) < 1e-10);
    }
    // Sensitivity against a finite difference.
    const double h = 1e-5 * emf_mv;
    const double slope = (std::log(emf_speed_coefficient({emf_mv + h}).c_v) -
                          std::log(emf_speed_coefficient({emf_mv - h}).c_v)) /
                         (2 * h);
    RC_ASSERT(std::abs(emf_sensitivity({emf_mv}).dln_speed_per_mv / slope - 1) < 1e-6);
  }));
  CHECK(emf_speed_coefficient({std::nextafter(emf_end_mv, 0.0)}).c_v == Approx(0).margin(1e-12));
  CHECK(emf_room_correction({{5}, 20, 20}).emf_ref_mv == 5);
}

TEST_CASE("K121: groups share out the delivery", "[K121]") {
  CHECK(rc::check([] {
    Sorting in;
    in.emf_mean_mv = *rc::gen::inRange(20, 100) * 0.1;
    in.emf_sd_mv = *rc::gen::inRange(1, 100) * 0.01;
    in.groups = *rc::gen::inRange(1, 12);
    in.mode = *rc::gen::element(GroupMode::quantile, GroupMode::width);
    const Groups out = emf_sort_groups(in);
    RC_ASSERT(out.inner_bounds_mv.size() + 1 == out.share.size());
    RC_ASSERT(std::abs(std::accumulate(out.share.begin(), out.share.end(), 0.0) - 1) < 1e-14);
    RC_ASSERT(std::abs(std::inner_product(out.share.begin(), out.share.end(), out.mean_emf_mv.begin(), 0.0) -
                       in.emf_mean_mv) < 1e-12);
    double between = 0;
    for (std::size_t i = 0; i < out.share.size(); ++i)
      between += out.share[i] * std::pow((out.mean_emf_mv[i] - in.emf_mean_mv) / in.emf_sd_mv, 2);
    RC_ASSERT(std::abs(between + out.within_variance_share - 1) < 1e-12);
    ScatterIn scatter{in, *rc::gen::inRange(5, 150) * 0.01};
    const LifeScatter life = emf_life_scatter(scatter);
    RC_ASSERT(life.rho <= 1);
    RC_ASSERT(life.ln_sd_within <= life.ln_sd_total);
    scatter.groups = 1;
    const LifeScatter unsorted = emf_life_scatter(scatter);
    RC_ASSERT(std::abs(unsorted.ln_sd_within - unsorted.ln_sd_total) < 1e-14);
    RC_ASSERT(std::abs(unsorted.life_cv_within / scatter.life_cv_total - 1) < 1e-12);
  }));
  CHECK(emf_sort_groups({{5, 0.4}, 5, GroupMode::quantile}).within_variance_share ==
        Approx(0.103).margin(5e-4));
  CHECK(emf_sort_groups({{5, 0.4}, 1, GroupMode::quantile}).inner_bounds_mv.empty());
}

TEST_CASE("K121: screened life", "[K121]") {
  ScreenIn in{{5, 0.4}, {1, 0.3, 1}, 1e6, 130};
  const ScreenedLife all = emf_screened_life(in);
  CHECK(all.reject_fraction == 0);
  CHECK(all.mean_life_accepted_min == all.mean_life_all_min);
  double before = all.mean_life_all_min;
  for (const double limit : {6.0, 5.5, 5.0, 4.5, 4.0}) {
    in.emf_limit_mv = limit;
    const ScreenedLife out = emf_screened_life(in);
    CHECK(out.mean_life_accepted_min > before);
    CHECK(out.mean_life_all_min == Approx(all.mean_life_all_min).epsilon(1e-10));
    before = out.mean_life_accepted_min;
  }
  // A narrow delivery: the life at the mean, plus half the curvature times the variance.
  const double at_mean = emf_tool_life({{5}, {1, 0.3, 1}, 130}).tool_life_min;
  CHECK(emf_screened_life({{5, 1e-3}, {1, 0.3, 1}, 100, 130}).mean_life_all_min ==
        Approx(at_mean).epsilon(1e-5));
  CHECK_THROWS_WITH(emf_screened_life({{5, 0.4}, {1, 0.3, 1}, 2.5, 130}),
                    Catch::Contains("emf_limit_mv = 2.5, accepts nothing"));
}

TEST_CASE("K121: life of a set of inserts", "[K121]") {
  const SetLife one = multi_insert_set_life({60, 0.3, 0.35, 1});
  CHECK(one.median_random_min == 60);
  CHECK(one.median_sorted_min == 60);
  CHECK(rc::check([] {
    const double between = *rc::gen::inRange(0, 100) * 0.01;
    const double within = *rc::gen::inRange(0, 100) * 0.01;
    const auto n = *rc::gen::inRange<std::int64_t>(1, 50);
    const SetLife out = multi_insert_set_life({60, between, within, n});
    RC_ASSERT(out.gain >= 1);
    RC_ASSERT(std::abs(out.gain * out.median_random_min / out.median_sorted_min - 1) < 1e-13);
    if (between == 0) RC_ASSERT(out.gain == 1);
    // The median of the minimum: each insert survives it with probability 2^(-1/n).
    if (within > 0) {
      const double z = std::log(out.median_sorted_min / 60) / within;
      RC_ASSERT(std::abs(std::pow(0.5 * std::erfc(z / std::sqrt(2.0)), n) - 0.5) < 1e-10);
    }
  }));
}

TEST_CASE("K121: bad input names itself", "[K121]") {
  CHECK_THROWS_WITH(emf_speed_coefficient({12.3}),
                    Catch::Contains("emf_mv = 12.3, allowed 0 < emf_mv < 12.2"));
  CHECK_THROWS_WITH(emf_group_plan({{{5, 5}, 5, GroupMode::quantile}, {1, 0.3, 1}, 60, 130}),
                    Catch::Contains("emf_sd_mv = 5, is too large"));
  CHECK_FALSE(emf_limit_for_regime({{1, 0.3, 1}, 1000, 60}).feasible);
}
