// The checks of card K311; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/solve.h"
#include "models/surface/k311_lapping_cycle.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k311;

namespace {

LappingPasses web(std::vector<std::vector<double>> removals) {
  return {.radii_um = {1000, 1000.8, 1000.2, 1001},
          .removals_um = std::move(removals),
          .sign = -1,
          .roughness_max_um = 3,
          .defect_depth_um = 4,
          .allowance_um = 6,
          .web_um = 60,
          .roughness_floor_um = 0.2,
          .defect_floor_um = 0,
          .sides = 1};
}

// d 3, m 0.5, sigma 0.2, t_f 1.1, l0 40, chi 2, V 10 m/min.
GrainContact lap(double time_s) {
  GrainContact c;
  c.mean_um = 0.5;
  c.sd_um = 0.2;
  c.greatest_um = 1.1;
  c.grain_um = 3;
  c.spacing_um = 40;
  c.speed_m_min = 10;
  c.time_s = time_s;
  return c;
}

double untouched(double level_um, double time_s) {
  GrainContactLevel in{lap(time_s)};
  in.level_um = level_um;
  return non_removal_probability(in).probability;
}

}  // namespace

TEST_CASE("K311: peaks go first, the defect layer after them", "[K311]") {
  const LappedState s =
      lapping_cycle(web({{0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}}));
  CHECK(s.roughness_max_um == Approx(1.5));
  CHECK(s.defect_depth_um == Approx(4.0));
  const LappedState none = lapping_cycle(web({}));
  CHECK(none.roughness_max_um == 3);
  CHECK(none.form_deviation_um == Approx(1.0));
}

TEST_CASE("K311: damaged depth and allowance keep their sum with the removal", "[K311]") {
  verstat::test::property([] {
    const auto tenths = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3));
    std::vector<std::vector<double>> passes;
    double removed = 0;
    for (const int t : tenths) {
      passes.push_back({0.1 * t, 0.2 * t, 0.1 * t, 0.0});
      removed += 0.1 * t;
    }
    RC_PRE(removed < 6.5);  // no floor of the defect depth yet
    const LappedState s = lapping_cycle(web(passes));
    RC_ASSERT(std::abs(s.defect_depth_um + s.roughness_max_um + removed - 7) < 1e-9);
    RC_ASSERT(std::abs(s.allowance_um + removed - 6) < 1e-9);
    RC_ASSERT(std::abs(s.web_um + removed - 60) < 1e-9);
  });
}

TEST_CASE("K311: a web lapped from both sides thins twice as fast", "[K311]") {
  LappingPasses in = web({{0.5, 0.5, 0.5, 0.5}});
  in.sides = 2;
  CHECK(lapping_cycle(in).web_um == Approx(59));
}

TEST_CASE("K311: the switching allowance is the least one that the limits allow", "[K311]") {
  verstat::test::property([] {
    const double rough = *rc::gen::inRange(0, 300) * 0.01;
    const double deep = *rc::gen::inRange(0, 300) * 0.01;
    const double at = switch_allowance({rough, deep, 0.3, 0.5}).allowance_um;
    const auto ok = [&](double allowance) {
      return cycle_constraints({rough, deep, allowance, 0.3, 0.5, 1, 2, 1, 2}).ok;
    };
    RC_ASSERT(ok(at));
    if (at > 0) RC_ASSERT(!ok(at - 1e-9));
  });
}

TEST_CASE("K311: piece time and two stages", "[K311]") {
  CHECK(piece_time({20, 2, 1.2, 3, 15, 0, 100}).time_min == Approx(20 / 2.0 * 1.2 + 3));
  CHECK(two_stage_time({20, 2, 2, 7}).total_min == Approx(10));
}

TEST_CASE("K311: the density of the depth integrates to 1, also where the mean lies outside", "[K311]") {
  for (const double mean_um : {-1.0, 0.0, 0.5, 1.3, 2.5}) {
    const auto f = [&](double a) { return grain_depth_pdf({{mean_um, 0.2, 1.1}, a}).density_per_um; };
    CHECK(integrate(f, 0, 1.1) == Approx(1).epsilon(1e-9));
    CHECK(f(-0.01) == 0);
    CHECK(f(1.11) == 0);
  }
}

TEST_CASE("K311: material survives where no grain reaches, and less of it with time and speed", "[K311]") {
  CHECK(untouched(1.1, 0.01) == 1);
  CHECK(untouched(5, 0.01) == 1);
  CHECK(untouched(0.3, 0) == 1);
  verstat::test::property([] {
    const double y = *rc::gen::inRange(0, 105) * 0.01;
    const double t = *rc::gen::inRange(1, 100) * 1e-4;
    RC_ASSERT(untouched(y, t) <= untouched(y + 0.05, t));
    RC_ASSERT(untouched(y, t) >= untouched(y, 1.1 * t));
    GrainContactLevel denser{lap(t)};
    denser.level_um = y;
    denser.spacing_um = 39;
    RC_ASSERT(non_removal_probability(denser).probability <= untouched(y, t));
  });
}

TEST_CASE("K311: the mean number of scratches equals the printed integral", "[K311]") {
  // exponent at level y by the plain integral of the card, no substitution
  const double y = 0.2;
  const double integral = integrate(
      [&](double a) {
        return std::sqrt((a - y) * (3 - a + y)) * grain_depth_pdf({{0.5, 0.2, 1.1}, a}).density_per_um;
      },
      y, 1.1, 1e-8);
  const double expected = std::exp(-2 * (10e6 / 60) * 0.002 / (40.0 * 40.0) * integral);
  CHECK(untouched(y, 0.002) == Approx(expected).epsilon(1e-7));
}

TEST_CASE("K311: a long lap reaches t_f and smooths; roughness passes a maximum", "[K311]") {
  CHECK(lapped_roughness(lap(0.005)).ra_um == Approx(0.238).margin(5e-4));
  CHECK(lapped_roughness(lap(0.05)).ra_um == Approx(0.102).margin(5e-4));
  CHECK(lapped_roughness(lap(0.5)).ra_um == Approx(0.060).margin(5e-4));
  CHECK(lapped_roughness(lap(0)).ra_um == 0);
  CHECK(lapped_roughness(lap(0)).mean_removal_um == 0);
  CHECK(lapped_roughness(lap(1e-5)).ra_um < 0.01);
  const LappedRoughness long_run = lapped_roughness(lap(1e6));
  CHECK(long_run.mean_removal_um == Approx(1.1).epsilon(1e-3));
  CHECK(long_run.ra_um < 1e-3);
  CHECK(long_run.r_max_um == Approx(6 * long_run.ra_um));
}

TEST_CASE("K311: Ra is the mean absolute deviation of the surface with this level curve", "[K311]") {
  // The depth Y below the outermost line has P(Y > y) = 1 - P: sampled by inversion on a fine grid.
  const double t = 0.005;
  const int n = 1000;
  double mean = 0;
  std::vector<double> level(n);
  for (int k = 0; k < n; ++k) {
    const double share = (k + 0.5) / n;  // of the profile at or above the level
    double low = 0, high = 1.1;
    while (high - low > 1e-7) {
      const double middle = 0.5 * (low + high);
      (untouched(middle, t) < share ? low : high) = middle;
    }
    level[static_cast<std::size_t>(k)] = low;
    mean += low / n;
  }
  double ra = 0;
  for (const double y : level) ra += std::abs(y - mean) / n;
  const LappedRoughness r = lapped_roughness(lap(t));
  CHECK(r.mean_removal_um == Approx(mean).epsilon(1e-3));
  CHECK(r.ra_um == Approx(ra).epsilon(1e-3));
}

TEST_CASE("K311: the best lap reset beats every other number of parts", "[K311]") {
  const BestReset card = best_lap_reset({10, 0.38 / 39, 2, 15, 200});
  CHECK(card.parts == 18);
  CHECK(card.time_min == Approx(13.66).margin(5e-3));
  CHECK(best_lap_reset({10, 0, 2, 15, 50}).parts == 50);
  CHECK(best_lap_reset({10, 0, 2, 0, 50}).parts == 1);
  verstat::test::property([] {
    const LapReset in{*rc::gen::inRange(1, 30) * 1.0, *rc::gen::inRange(0, 50) * 1e-3, 2,
                      *rc::gen::inRange(0, 60) * 1.0, *rc::gen::inRange(1, 120)};
    std::int64_t best = 1;
    const auto run = [&](std::int64_t n) {
      const double parts = static_cast<double>(n);
      return in.first_min * (1 + in.growth * (parts - 1) / 2) + in.preparation_min + in.change_min / parts;
    };
    for (std::int64_t n = 2; n <= in.parts_max; ++n)
      if (run(n) < run(best) - 1e-12) best = n;
    RC_ASSERT(best_lap_reset(in).parts == best);
  });
}

TEST_CASE("K311: force of the lap against a sum over a fine grid of depths", "[K311]") {
  LapContact in;
  in.mean_um = 0.05;
  in.sd_um = 0.03;
  in.greatest_um = 0.14;
  in.width_mm = 2;
  in.length_mm = 3;
  in.spacing_um = 40;
  in.grain_um = 3;
  in.hardness_mpa = 9000;
  double force_n = 0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double a = 0.14 * (k + 0.5) / n;
    force_n += 3750 * 0.5 * 3.14159265358979 * a * (3 - a) * 9000e-6 *
               grain_depth_pdf({{0.05, 0.03, 0.14}, a}).density_per_um * 0.14 / n;
  }
  CHECK(lapping_force(in).force_n == Approx(force_n).epsilon(1e-7));
}

TEST_CASE("K311: bad input names itself", "[K311]") {
  CHECK_THROWS_WITH(lapping_cycle(web({{0.5, 0.5}})),
                    "K311.lapping_cycle: removals/0 has 2 entries, must have one per radius of r, that is 4");
  GrainContactLevel in{lap(0.1)};
  in.greatest_um = 3.5;
  CHECK_THROWS_WITH(non_removal_probability(in),
                    "K311.non_removal_probability: t_f = 3.5, must not be above the grain diameter d");
  CHECK_THROWS_WITH(cycle_time_with_lap_wear({41, 10, 40, 1.38}),
                    "K311.cycle_time_with_lap_wear: j = 41, must not be above n_life");
}
