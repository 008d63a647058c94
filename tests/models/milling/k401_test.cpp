// The checks of card K401; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/k401_ball_end_hardened_steel_forces.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k401;

namespace {

BallEndCut cut(double n, double f_z, double a_p, double a_e, double alpha, double hrc) {
  return {{n, a_p, a_e, alpha, hrc}, f_z};
}
// Somewhere in the explored box.
BallEndCut anywhere() {
  const auto in = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000;
  };
  return cut(in(8936, 31100), in(0.04, 0.12), in(0.06, 0.36), in(0.3, 0.6), in(6, 18), in(40, 55));
}

}  // namespace

TEST_CASE("K401: forces around the centre of the plan", "[K401]") {
  struct Row {
    std::function<BallEndCut(double)> at;
    std::array<double, 5> x, y, z;
  };
  const std::array<Row, 6> rows{{
      {[](double q) { return cut(8936 + q * (31100 - 8936), 0.08, 0.21, 0.45, 12, 47.5); },
       {18.97, 16.72, 14.74, 12.99, 11.45},
       {34.67, 31.56, 28.74, 26.16, 23.82},
       {33.93, 33.93, 33.93, 33.93, 33.93}},
      {[](double q) { return cut(20018, 0.04 + q * 0.08, 0.21, 0.45, 12, 47.5); },
       {14.90, 14.58, 14.74, 15.38, 16.66},
       {23.50, 26.19, 28.74, 32.09, 37.84},
       {27.90, 31.05, 33.93, 36.58, 39.02}},
      {[](double q) { return cut(20018, 0.08, 0.06 + q * 0.3, 0.45, 12, 47.5); },
       {14.74, 14.74, 14.74, 14.74, 14.74},
       {28.74, 28.74, 28.74, 28.74, 28.74},
       {23.08, 27.99, 33.93, 41.13, 49.87}},
      {[](double q) { return cut(20018, 0.08, 0.21, 0.3 + q * 0.3, 12, 47.5); },
       {13.21, 13.83, 14.74, 15.97, 17.59},
       {24.50, 26.35, 28.74, 31.78, 35.61},
       {37.65, 35.74, 33.93, 32.21, 30.58}},
      {[](double q) { return cut(20018, 0.08, 0.21, 0.45, 6 + q * 12, 47.5); },
       {18.51, 16.52, 14.74, 13.15, 11.73},
       {34.36, 30.95, 28.74, 27.13, 25.88},
       {46.03, 38.51, 33.93, 30.76, 28.38}},
      {[](double q) { return cut(20018, 0.08, 0.21, 0.45, 12, 40 + q * 15); },
       {6.84, 10.01, 14.74, 21.84, 32.56},
       {25.28, 26.86, 28.74, 30.95, 33.57},
       {43.63, 38.48, 33.93, 29.90, 26.34}},
  }};
  for (const Row& row : rows)
    for (std::size_t k = 0; k < 5; ++k) {
      const auto force = ball_end_forces(row.at(0.25 * static_cast<double>(k)));
      CHECK(force.feed_n == Approx(row.x[k]).margin(0.006));
      CHECK(force.push_off_n == Approx(row.y[k]).margin(0.006));
      CHECK(force.normal_n == Approx(row.z[k]).margin(0.006));
    }
}

TEST_CASE("K401: extremes over the box", "[K401]") {
  // Every force is monotone along most axes, so a grid with the corners finds the extremes.
  std::array<double, 4> least{1e9, 1e9, 1e9, 1e9}, most{};
  constexpr int steps = 8;
  const auto at = [](double low, double high, int k) { return low + (high - low) * k / steps; };
  for (int i = 0; i <= steps; i += steps)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; k += steps)
        for (int m = 0; m <= steps; ++m)
          for (int a = 0; a <= steps; a += steps)
            for (int h = 0; h <= steps; ++h) {
              const auto f = ball_end_forces(cut(at(8936, 31100, i), at(0.04, 0.12, j), at(0.06, 0.36, k),
                                                 at(0.3, 0.6, m), at(6, 18, a), at(40, 55, h)));
              const std::array<double, 4> values{f.feed_n, f.push_off_n, f.normal_n, f.resultant_n};
              for (std::size_t q = 0; q < 4; ++q) {
                least[q] = std::min(least[q], values[q]);
                most[q] = std::max(most[q], values[q]);
              }
            }
  const std::array<double, 4> low{3.2, 11.9, 10.5, 25.1}, high{64.7, 79.0, 117.1, 128.5};
  for (std::size_t q = 0; q < 4; ++q) {
    CHECK(least[q] == Approx(low[q]).margin(0.06));
    CHECK(most[q] == Approx(high[q]).margin(0.06));
  }
}

TEST_CASE("K401: signs of the influences", "[K401]") {
  verstat::test::property([] {
    const auto d = ball_end_force_gradient(anywhere());
    RC_ASSERT((d.x_n < 0 && d.y_n < 0 && d.z_n == 0));
    RC_ASSERT((d.x_alpha < 0 && d.y_alpha < 0 && d.z_alpha < 0));
    RC_ASSERT((d.y_fz > 0 && d.z_fz > 0 && d.x_ap == 0 && d.y_ap == 0 && d.z_ap > 0));
    RC_ASSERT((d.x_hrc > 0 && d.z_hrc < 0));
  });
}

TEST_CASE("K401: gradient equals central differences", "[K401]") {
  verstat::test::property([] {
    const auto in = anywhere();
    const auto d = ball_end_force_gradient(in);
    const auto difference = [&](auto change, double step) {
      auto low = in, high = in;
      change(low, -step);
      change(high, step);
      const auto a = ball_end_forces(low), b = ball_end_forces(high);
      return std::array<double, 3>{std::log(b.feed_n / a.feed_n) / (2 * step),
                                   std::log(b.push_off_n / a.push_off_n) / (2 * step),
                                   std::log(b.normal_n / a.normal_n) / (2 * step)};
    };
    const auto agree = [](const std::array<double, 3>& got, double x, double y, double z) {
      const auto close = [](double a, double b) {
        return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(b));
      };
      return close(got[0], x) && close(got[1], y) && close(got[2], z);
    };
    RC_ASSERT(agree(difference([](auto& c, double e) { c.spindle_rpm += e; }, 1.0), d.x_n, d.y_n, d.z_n));
    RC_ASSERT(
        agree(difference([](auto& c, double e) { c.feed_mm_tooth += e; }, 2e-6), d.x_fz, d.y_fz, d.z_fz));
    RC_ASSERT(agree(difference([](auto& c, double e) { c.depth_mm += e; }, 1e-5), d.x_ap, d.y_ap, d.z_ap));
    RC_ASSERT(
        agree(difference([](auto& c, double e) { c.step_over_mm += e; }, 1e-5), d.x_ae, d.y_ae, d.z_ae));
    RC_ASSERT(agree(difference([](auto& c, double e) { c.relief_deg += e; }, 1e-4), d.x_alpha, d.y_alpha,
                    d.z_alpha));
    RC_ASSERT(
        agree(difference([](auto& c, double e) { c.hardness_hrc += e; }, 1e-4), d.x_hrc, d.y_hrc, d.z_hrc));
  });
}

TEST_CASE("K401: hardness turns the in-plane force rather than raising it", "[K401]") {
  const auto at = [](double hrc) { return ball_end_forces(cut(20018, 0.08, 0.21, 0.45, 12, hrc)); };
  CHECK(at(40).resultant_n == Approx(50.9).margin(0.06));
  CHECK(at(47.5).resultant_n == Approx(46.8).margin(0.06));
  CHECK(at(55).resultant_n == Approx(53.7).margin(0.06));
  CHECK(at(55).feed_n / at(40).feed_n == Approx(4.8).margin(0.05));
  CHECK(at(55).normal_n / at(40).normal_n == Approx(0.6).margin(0.01));
}

TEST_CASE("K401: the largest feed is that of a fine scan", "[K401]") {
  verstat::test::property([] {
    const auto place = anywhere();
    LimitedCut in;
    static_cast<CutWidth&>(in) = place;
    in.px_max_n = *rc::gen::inRange(4, 60);
    in.py_max_n = *rc::gen::inRange(12, 70);
    in.pz_max_n = *rc::gen::inRange(12, 100);
    double scanned = 0;
    constexpr int steps = 800;
    for (int k = 0; k <= steps; ++k) {
      auto at = place;
      at.feed_mm_tooth = 0.04 + 0.08 * k / steps;
      const auto f = ball_end_forces(at);
      if (f.feed_n <= in.px_max_n && f.push_off_n <= in.py_max_n && f.normal_n <= in.pz_max_n)
        scanned = at.feed_mm_tooth;
    }
    const auto got = max_feed_for_force_limits(in);
    if (scanned > 0) {
      RC_ASSERT(got.feasible);
      RC_ASSERT(got.feed_mm_tooth >= scanned - 1e-12);
      RC_ASSERT(got.feed_mm_tooth <= scanned + 0.08 / steps + 1e-12);
    } else if (got.feasible) {
      // A feasible interval narrower than the scan: its end must keep the limits.
      auto at = place;
      at.feed_mm_tooth = got.feed_mm_tooth;
      const auto f = ball_end_forces(at);
      RC_ASSERT(f.feed_n <= in.px_max_n * (1 + 1e-9));
      RC_ASSERT(f.push_off_n <= in.py_max_n * (1 + 1e-9));
      RC_ASSERT(f.normal_n <= in.pz_max_n * (1 + 1e-9));
    }
  });
}

TEST_CASE("K401: the best regime beats every point of a grid and keeps the limits", "[K401]") {
  for (const auto& [hrc, px, py, pz] :
       {std::array{47.5, 20.0, 30.0, 40.0}, std::array{55.0, 40.0, 40.0, 40.0},
        std::array{47.5, 12.0, 35.0, 45.0}, std::array{42.0, 8.0, 40.0, 60.0}}) {
    const RegimeProblem problem{hrc, 12, 2, px, py, pz};
    const auto best = best_regime(problem);
    REQUIRE(best.feasible);
    const auto at =
        ball_end_forces(cut(best.spindle_rpm, best.feed_mm_tooth, best.depth_mm, best.step_over_mm, 12, hrc));
    CHECK(at.feed_n <= px * (1 + 1e-9));
    CHECK(at.push_off_n <= py * (1 + 1e-9));
    CHECK(at.normal_n <= pz * (1 + 1e-9));
    CHECK(at.in_range);
    double grid_best = 0;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60; ++j)
        for (int k = 0; k <= 60; ++k) {
          const double f = 0.04 + 0.08 * i / 60, p = 0.06 + 0.3 * j / 60, e = 0.3 + 0.3 * k / 60;
          if (f * p * e <= grid_best) continue;
          const auto force = ball_end_forces(cut(31100, f, p, e, 12, hrc));
          if (force.feed_n <= px && force.push_off_n <= py && force.normal_n <= pz) grid_best = f * p * e;
        }
    const double grid_rate = grid_best * 31100 * 2 / 1000;
    CHECK(best.removal_cm3_min >= grid_rate);
    CHECK(best.removal_cm3_min <= grid_rate * 1.08);
  }
}

TEST_CASE("K401: benchmark optimum", "[K401]") {
  const auto best = best_regime({47.5, 12, 2, 20, 30, 40});
  CHECK(best.spindle_rpm == 31100);
  CHECK(best.feed_mm_tooth == Approx(0.0827).margin(5e-5));
  CHECK(best.depth_mm == Approx(0.2828).margin(5e-5));
  CHECK(best.step_over_mm == Approx(0.6).margin(1e-6));
  CHECK(best.removal_cm3_min == Approx(0.8727).margin(5e-5));
  const auto at = ball_end_forces(cut(31100, best.feed_mm_tooth, best.depth_mm, best.step_over_mm, 12, 47.5));
  CHECK(at.push_off_n == Approx(30).epsilon(1e-9));
  CHECK(at.normal_n == Approx(40).epsilon(1e-9));
}

TEST_CASE("K401: bad input names itself", "[K401]") {
  CHECK_THROWS_WITH(ball_finishing_rates({20000, 0.08, 2, 6, 0.4, 10}),
                    "K401.ball_finishing_rates: a_p = 6, must not be above d/2");
  CHECK_THROWS_AS(ball_end_forces(cut(20018, 0.08, 0.21, 0.45, 12, 1)), ModelError);
}
