// The checks of card K109; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/reliability/k109_face_mill_replacement.h"

using namespace verstat::models;
using namespace verstat::models::k109;

namespace {

MillSharing sharing(double r_tooth, std::int64_t teeth, std::int64_t allowed, double alpha) {
  return {{r_tooth, teeth, alpha}, allowed};
}
double equal(double r_tooth, std::int64_t teeth, std::int64_t allowed, double alpha) {
  return mill_reliability_load_sharing(sharing(r_tooth, teeth, allowed, alpha)).r_mill;
}
double local(double r_tooth, std::int64_t teeth, std::int64_t allowed, double alpha) {
  return mill_reliability_local_sharing(sharing(r_tooth, teeth, allowed, alpha)).r_mill;
}
double from_state(double r_tooth, std::int64_t teeth, std::int64_t now, std::int64_t allowed, double alpha) {
  return mission_reliability_from_state({sharing(r_tooth, teeth, allowed, alpha), now}).r_mill;
}
double erlang(double mean, std::int64_t allowed) {
  double sum = 0;
  double term = std::exp(-mean);
  for (std::int64_t i = 0; i <= allowed; ++i) {
    sum += term;
    term *= mean / static_cast<double>(i + 1);
  }
  return sum;
}

}  // namespace

TEST_CASE("K109: the table of the card for z = 10, R_z = 0.9", "[K109]") {
  struct Row {
    double paper, binomial, alpha1, alpha2, alpha2_local, from_alpha0, from_alpha2, working;
  };
  const Row rows[] = {{0.348678, 0.348678, 0.348678, 0.348678, 0.348678, 0.900000, 0.000027, 1.000000},
                      {0.575780, 0.736099, 0.716048, 0.695360, 0.679923, 0.990000, 0.010281, 1.000000},
                      {0.723697, 0.929809, 0.909579, 0.885056, 0.863750, 0.999000, 0.113663, 1.000000},
                      {0.820038, 0.987205, 0.977547, 0.961946, 0.944687, 0.999900, 0.383574, 1.000000},
                      {0.882787, 0.998365, 0.995450, 0.988215, 0.977102, 0.999990, 0.693478, 0.999991},
                      {0.923656, 0.999853, 0.999223, 0.996393, 0.989911, 0.999999, 0.891543, 0.999853},
                      {0.950276, 0.999991, 0.999885, 0.998849, 0.995168, 1.000000, 0.971965, 0.998365},
                      {0.967614, 1.000000, 0.999985, 0.999593, 0.997475, 1.000000, 0.994533, 0.987205},
                      {0.978906, 1.000000, 0.999998, 0.999827, 0.998570, 1.000000, 0.999171, 0.929809},
                      {0.986261, 1.000000, 1.000000, 0.999900, 0.999132, 1.000000, 0.999900, 0.736099}};
  for (std::int64_t m = 0; m < 10; ++m) {
    INFO(m);
    const Row& row = rows[m];
    CHECK(mill_reliability_paper({0.9, 10, m}).r_mill == Approx(row.paper).margin(5.1e-7));
    CHECK(equal(0.9, 10, m, 0) == Approx(row.binomial).margin(5.1e-7));
    CHECK(equal(0.9, 10, m, 1) == Approx(row.alpha1).margin(5.1e-7));
    CHECK(equal(0.9, 10, m, 2) == Approx(row.alpha2).margin(5.1e-7));
    CHECK(local(0.9, 10, m, 2) == Approx(row.alpha2_local).margin(5.1e-7));
    CHECK(from_state(0.9, 10, 9 - m, 9, 0) == Approx(row.from_alpha0).margin(5.1e-7));
    CHECK(from_state(0.9, 10, 9 - m, 9, 2) == Approx(row.from_alpha2).margin(5.1e-7));
    CHECK(mill_reliability_binomial({0.9, 10, std::min<std::int64_t>(10 - m, 9)}).r_mill ==
          Approx(row.working).margin(5.1e-7));
  }
}

TEST_CASE("K109: replacement numbers for the target 0.95", "[K109]") {
  const RequiredM paper = required_m_paper({0.95, 0.9, 10});
  CHECK(paper.m_real == Approx(5.9871).margin(5e-5));
  CHECK(paper.m == 6);
  CHECK(paper.replace_at_failed == 4);
  for (const auto& [alpha, failed] : {std::pair{0.0, 9}, {1.0, 7}, {1.5, 5}, {2.0, 4}, {2.5, 3}, {3.0, 2}}) {
    INFO(alpha);
    CHECK(control_limit({{{0.9, 10, alpha}, 0.95}, 9}).replace_at_failed == failed);
  }
  for (const double alpha : {0.0, 1.0, 2.0}) {
    CHECK(required_failed_allowed({{0.9, 10, alpha}, 0.95}).failed_allowed == 3);
    CHECK(required_failed_allowed({{0.9, 10, alpha}, 0.95}).replace_at_failed == 4);
  }
  CHECK(local(0.9, 10, 3, 2) < 0.95);
  CHECK(local(0.9, 10, 4, 2) > 0.95);
}

TEST_CASE("K109: eq. (0) rises with m and R_z, falls with z, and inverts", "[K109]") {
  CHECK(rc::check([] {
    const auto z = *rc::gen::inRange<std::int64_t>(1, 30);
    const auto m = *rc::gen::inRange<std::int64_t>(0, z);
    const double r = *rc::gen::inRange(30, 99) * 0.01;
    const double at = mill_reliability_paper({r, z, m}).r_mill;
    RC_ASSERT(mill_reliability_paper({r, z, m + 1}).r_mill >= at);
    RC_ASSERT(mill_reliability_paper({r + 0.005, z, m}).r_mill > at);
    RC_ASSERT(mill_reliability_paper({r, z + 1, m}).r_mill < at);
    if (at < 0.999999) {
      RC_ASSERT(std::abs(required_tooth_reliability_paper({at, z, m}).r_tooth - r) < 1e-9);
      RC_ASSERT(required_m_paper({at, r, z}).m == m);
    }
  }));
  CHECK_THROWS_WITH(required_m_paper({0.95, 1e-10, 40}), Catch::Contains("r_tooth = 1e-10, is too small"));
  CHECK(required_m_paper({0.95, 0.01, 10}).m == 1'000'000'000);
}

TEST_CASE("K109: load sharing meets its special cases and bounds", "[K109]") {
  CHECK(rc::check([] {
    const auto z = *rc::gen::inRange<std::int64_t>(1, 11);
    const auto c = *rc::gen::inRange<std::int64_t>(0, z);
    const double r = *rc::gen::inRange(5, 100) * 0.01;
    const double exposure = -std::log(r);
    RC_ASSERT(std::abs(equal(r, z, c, 0) - mill_reliability_binomial({r, z, c}).r_mill) < 1e-12);
    RC_ASSERT(std::abs(equal(r, z, c, 1) - erlang(static_cast<double>(z) * exposure, c)) < 1e-12);
    RC_ASSERT(std::abs(local(r, z, c, 0) - equal(r, z, c, 0)) < 1e-12);
    RC_ASSERT(std::abs(local(r, z, c, 1) - equal(r, z, c, 1)) < 1e-12);
    const double alpha = *rc::gen::inRange(0, 40) * 0.1;
    if (c == 0)
      RC_ASSERT(std::abs(equal(r, z, c, alpha) - std::pow(r, static_cast<double>(z))) < 1e-12);
    else
      RC_ASSERT(equal(r, z, c, alpha + 0.1) <= equal(r, z, c, alpha) + 1e-13);
    if (alpha > 1) RC_ASSERT(local(r, z, c, alpha) <= equal(r, z, c, alpha) + 1e-12);
    if (alpha <= 2 && r < 1) {
      const double paper = mill_reliability_paper({r, z, c}).r_mill;
      RC_ASSERT(paper <= equal(r, z, c, alpha) + 1e-12);
      RC_ASSERT(paper <= local(r, z, c, alpha) + 1e-12);
    }
    const std::vector<double> pmf = failed_teeth_pmf({r, z, alpha}).pmf;
    RC_ASSERT(std::abs(std::accumulate(pmf.begin(), pmf.end(), 0.0) - 1) < 1e-12);
    const double head = std::accumulate(pmf.begin(), pmf.begin() + c + 1, 0.0);
    RC_ASSERT(std::abs(head - equal(r, z, c, alpha)) < 1e-12);
    // Readings I and II coincide for alpha = 1.
    RC_ASSERT(std::abs(from_state(r, z, z - c - 1, z - 1, 1) - equal(r, z, c, 1)) < 1e-12);
  }));
  CHECK(mill_reliability_paper({0.7, 3, 2}).r_mill - equal(0.7, 3, 2, 3) == Approx(0.118).margin(5e-4));
  CHECK(from_state(0.9, 10, 5, 4, 2) == 0);
  CHECK(equal(1, 10, 3, 2) == 1);
}

TEST_CASE("K109: stiff chains and long missions agree with the closed form", "[K109]") {
  // q L up to 1e6: the transition matrix of a short step is squared.
  for (const double r : {0.5, 1e-3, 1e-10})
    for (const std::int64_t c : {0, 5, 39}) {
      INFO(r << " " << c);
      CHECK(equal(r, 40, c, 1) == Approx(erlang(-40 * std::log(r), c)).epsilon(1e-10).margin(1e-300));
    }
  // alpha = 2, z = 2: rates 2 and 4, P_1 = 2 (e^-2L - e^-4L)/2, for which 0 failures or 1 remain.
  const double exposure = 30;
  const double two = std::exp(-2 * exposure) + (std::exp(-2 * exposure) - std::exp(-4 * exposure));
  CHECK(equal(std::exp(-exposure), 2, 1, 2) == Approx(two).epsilon(1e-10));
  const std::vector<double> pmf = failed_teeth_pmf({0.5, 40, 4}).pmf;
  CHECK(std::accumulate(pmf.begin(), pmf.end(), 0.0) == Approx(1).epsilon(1e-12));
  CHECK(pmf[0] == Approx(std::pow(0.5, 40)).epsilon(1e-9));
}

TEST_CASE("K109: stiff local sharing", "[K109]") {
  // Above 400 expected jumps the chain is stepped implicitly; alpha = 1 has a closed form there, too.
  for (const double r : {1e-11, 1e-13})
    CHECK(local(r, 16, 15, 1) == Approx(erlang(-16 * std::log(r), 15)).epsilon(1e-8));
  // Three teeth: patterns 3, 2, 1 teeth with total rates 3, 2^a + 1, 3^a; alpha 4 makes the last two fast.
  const double rates[] = {3, 17, 81};
  for (const double exposure : {0.5, 3.0, 6.0, 20.0}) {
    double alive = 0;
    for (int i = 0; i < 3; ++i) {
      double factor = 1;  // survival of a sum of three exponential stages
      for (int j = 0; j < 3; ++j)
        if (j != i) factor *= rates[j] / (rates[j] - rates[i]);
      alive += factor * std::exp(-rates[i] * exposure);
    }
    CHECK(local(std::exp(-exposure), 3, 2, 4) == Approx(alive).epsilon(1e-9));
  }
}

TEST_CASE("K109: required tooth reliability inverts", "[K109]") {
  CHECK(rc::check([] {
    const auto z = *rc::gen::inRange<std::int64_t>(1, 20);
    const auto c = *rc::gen::inRange<std::int64_t>(0, z);
    const double alpha = *rc::gen::inRange(0, 41) * 0.1;
    const double r_mill = *rc::gen::inRange(1, 1000) * 1e-3;
    const double r = required_tooth_reliability({r_mill, z, c, alpha}).r_tooth;
    RC_ASSERT(std::abs(equal(r, z, c, alpha) - r_mill) < 1e-9);
  }));
}

TEST_CASE("K109: failure times", "[K109]") {
  CHECK(rc::check([] {
    ToothLives in;
    const auto z = *rc::gen::inRange<std::size_t>(1, 12);
    for (std::size_t i = 0; i < z; ++i) in.lives_min.push_back(*rc::gen::inRange(1, 100));
    const double mean =
        std::accumulate(in.lives_min.begin(), in.lives_min.end(), 0.0) / static_cast<double>(z);
    in.alpha = *rc::gen::inRange(0, 41) * 0.1;
    in.rule = *rc::gen::element(SharingRule::equal, SharingRule::local);
    const FailureTimes out = failure_times(in);
    RC_ASSERT(std::is_sorted(out.times_min.begin(), out.times_min.end()));
    auto order = out.order;
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < z; ++i) RC_ASSERT(order[i] == static_cast<std::int64_t>(i));
    auto sorted = in.lives_min;
    std::sort(sorted.begin(), sorted.end());
    RC_ASSERT(out.times_min[0] == sorted[0]);
    for (std::size_t i = 0; i < z; ++i) RC_ASSERT(out.times_min[i] <= sorted[i] + 1e-9);
    in.alpha = 0;
    const FailureTimes alone = failure_times(in);
    for (std::size_t i = 0; i < z; ++i) RC_ASSERT(std::abs(alone.times_min[i] - sorted[i]) < 1e-9);
    in.alpha = 1;
    RC_ASSERT(std::abs(failure_times(in).times_min.back() - mean) < 1e-9);
  }));
  // Ties go to the lowest index.
  CHECK(failure_times({{30, 30, 30}, 2, SharingRule::local}).order == std::vector<std::int64_t>{0, 1, 2});
}

TEST_CASE("K109: mean time to the n-th failure", "[K109]") {
  const double expected[] = {13.91, 20.01, 23.96, 26.74, 28.76, 30.20, 31.21, 31.87, 32.25, 32.40};
  for (std::int64_t n = 1; n <= 10; ++n)
    CHECK(mean_time_to_nth_failure({{44, 2}, n, 10, 2}).t_mean_min == Approx(expected[n - 1]).margin(5e-3));
  CHECK(rc::check([] {
    const double beta = *rc::gen::inRange(5, 51) * 0.1;
    const auto z = *rc::gen::inRange<std::int64_t>(1, 41);
    const auto n = *rc::gen::inRange<std::int64_t>(1, z + 1);
    const auto teeth = static_cast<double>(z);
    const double alpha = *rc::gen::inRange(0, 41) * 0.1;
    RC_ASSERT(std::abs(mean_time_to_nth_failure({{44, beta}, 1, z, alpha}).t_mean_min /
                           (44 * std::pow(teeth, -1 / beta)) -
                       1) < 1e-10);
    RC_ASSERT(std::abs(mean_time_to_nth_failure({{44, beta}, z, z, 1}).t_mean_min / 44 - 1) < 1e-10);
    RC_ASSERT(std::abs(mean_time_to_nth_failure({{44, 1}, n, z, 1}).t_mean_min /
                           (44 * static_cast<double>(n) / teeth) -
                       1) < 1e-10);
  }));
  // (C7) as printed on the card, where its alternating sum is still good.
  const double beta = 1.7;
  const int z = 7;
  const auto choose = [](int n, int k) {
    double c = 1;
    for (int i = 0; i < k; ++i) c = c * (n - i) / (i + 1);
    return c;
  };
  double before = 0;
  double mean = 0;
  for (int k = 1; k <= z; ++k) {
    double sum = 0;
    for (int i = 0; i < k; ++i)
      sum += (i % 2 == 0 ? 1 : -1) * choose(k - 1, i) / std::pow(z - k + 1 + i, 1 + 1 / beta);
    const double order_mean = 44 * k * choose(z, k) * sum;
    mean += (order_mean - before) / std::pow(static_cast<double>(z) / (z - k + 1), 1.5);
    before = order_mean;
    CHECK(mean_time_to_nth_failure({{44, beta}, k, z, 1.5}).t_mean_min == Approx(mean).epsilon(1e-9));
  }
}

TEST_CASE("K109: reliability under the exposure model", "[K109]") {
  const auto reliability = [](double t, std::int64_t z, std::int64_t c, double mean, double beta,
                              double alpha) {
    return mill_reliability_exposure({{mean, beta}, t, z, c, alpha}).r_mill;
  };
  CHECK(reliability(30, 5, 2, 69, 1, 1.5) == Approx(0.557069).margin(5e-7));
  CHECK(reliability(16, 10, 2, 44, 2, 2) == Approx(0.8694).margin(5e-5));
  CHECK(reliability(16, 10, 3, 44, 2, 2) == Approx(0.9485).margin(1e-3));
  CHECK(reliability(16, 10, 5, 44, 2, 2) == Approx(0.991).margin(1e-3));
  // beta = 1: the exposure model is the chain.
  CHECK(rc::check([] {
    const auto z = *rc::gen::inRange<std::int64_t>(3, 15);
    const auto c = *rc::gen::inRange<std::int64_t>(0, 3);
    const double t = *rc::gen::inRange(1, 60);
    const double alpha = *rc::gen::inRange(0, 41) * 0.1;
    RC_ASSERT(std::abs(mill_reliability_exposure({{44, 1}, t, z, c, alpha}).r_mill -
                       equal(std::exp(-t / 44), z, c, alpha)) < 1e-8);
  }));
  // alpha = 0: independent teeth, whatever the shape; draws included.
  for (const double beta : {0.5, 0.8, 2.0, 5.0})
    for (const std::int64_t c : {0, 1, 2, 4}) {
      const double r = tooth_reliability({{44, beta}, 20}).r_tooth;
      INFO(beta << " " << c);
      CHECK(reliability(20, 6, c, 44, beta, 0) ==
            Approx(mill_reliability_binomial({r, 6, c}).r_mill).margin(c < 3 ? 1e-8 : 2e-3));
    }
}

TEST_CASE("K109: policy cost", "[K109]") {
  const Policy defaults{{44, 2}, 10, 3, 16, 2, 2, 5, 40, 0.8, 6, 15};
  Policy in = defaults;
  in.t_planned_min = 1e300;
  CHECK(policy_cost(in).p_unplanned == 1);
  CHECK(policy_cost(in).mean_cycle_cutting_min == Approx(28.0493).margin(5e-5));
  in = {{44, 0.5}, 3, 1, 1e12, 2, 2, 5, 40, 0.8, 6, 15};
  CHECK(policy_cost(in).mean_cycle_cutting_min == Approx(10.3210).margin(5e-5));
  in = {{44, 1}, 8, 4, 1e9, 1, 2, 5, 40, 0.8, 6, 15};
  CHECK(policy_cost(in).mean_cycle_cutting_min == Approx(5 * 44.0 / 8).epsilon(1e-9));
  in = defaults;
  in.t_planned_min = 1e-3;
  CHECK(policy_cost(in).p_unplanned < 1e-15);
  in.change_planned_min = 0;
  in.machine_rate_per_min = 0;
  CHECK(policy_cost(in).cost_per_cutting_min == Approx(25 / 1e-3).epsilon(1e-9));  // z c_edge + c_planned
}

TEST_CASE("K109: bad input names itself", "[K109]") {
  CHECK_THROWS_WITH(equal(0.9, 4, 4, 2),
                    "K109.mill_reliability_load_sharing: failed_allowed = 4, must be below z");
  CHECK_THROWS_WITH(quality_level({{1, 2}, {1}}), Catch::Contains("must be as many as scores"));
  CHECK_THROWS_WITH(quality_level({{1, 2}, {0, 0}}), Catch::Contains("must be above 0"));
  CHECK_THROWS_WITH(mill_reliability_paper({1.2, 10, 3}),
                    "K109.mill_reliability_paper: r_tooth = 1.2, allowed 0 < r_tooth < 1 (reliability of one "
                    "tooth over the mission)");
}
