// The checks of card K113; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k113_through_hole_feed_change.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k113;

namespace {

double real(int low, int high, double scale) {
  return *rc::gen::inRange(low, high) * scale;
}

// Explicit time stepping of the quasi-static exit (C2), independent of the closed form and the midpoint rule.
double stepped_exit_min(const SpringExitInputs& in, int steps) {
  const double stroke = in.zone_mm + in.point_height_mm;
  const double db = stroke / steps;
  double t = 0;
  for (int k = 0; k < steps; ++k) {
    const double b = (k + 0.5) * db;
    double w = 1;
    if (b >= in.zone_mm) w = (1 - in.chisel_share) * (1 - (b - in.zone_mm) / in.point_height_mm);
    const double ratio =
        std::min(std::pow((1 - b / in.spring_compression_mm) / w, 1 / in.exp_feed), in.feed_cap_ratio);
    t += db / (in.rpm * in.feed_mm_rev * ratio);
  }
  return t;
}

constexpr SpringExitInputs example{.feed_mm_rev = 0.3,
                                   .rpm = 400,
                                   .spring_compression_mm = 16.5,
                                   .zone_mm = 6,
                                   .point_height_mm = 6,
                                   .exp_feed = 0.7,
                                   .chisel_share = 0.5,
                                   .feed_cap_ratio = 1.85};

}  // namespace

TEST_CASE("K113: handbook exponents give the printed diameter exponents", "[K113]") {
  CHECK(thrust_diameter_law({1, 200, 0.05, 1, 0.7, 0.75}).exponent == Approx(1.42));
  CHECK(thrust_diameter_law({1, 200, 0.05, 2, 0.8, 0.75}).exponent == Approx(2.48));
}

TEST_CASE("K113: thrust at the ruled feed is the diameter law", "[K113]") {
  verstat::test::property([] {
    const double d = real(10, 400, 0.1);
    const double feed = drill_feed_rule({0.05, d}).feed_mm_rev;
    const double thrust = drill_thrust({11.6, d, feed, 217, 1, 0.7, 0.75}).thrust_n;
    const ThrustLaw law = thrust_diameter_law({11.6, 217, 0.05, 1, 0.7, 0.75});
    RC_ASSERT(std::abs(law.coefficient * std::pow(d, law.exponent) / thrust - 1) < 1e-12);
  });
}

TEST_CASE("K113: the fit recovers a power law exactly", "[K113]") {
  verstat::test::property([] {
    const double c = real(1, 10000, 0.01);
    const double x = real(-300, 300, 0.01);
    LoadFitInputs in{{3, 5, 8, 12, 20, 30}, {}};
    for (const double d : in.diameters_mm) in.loads.push_back(c * std::pow(d, x));
    const LoadFit fit = fit_load_diameter_law(in);
    RC_ASSERT(std::abs(fit.coefficient / c - 1) < 1e-10);
    RC_ASSERT(std::abs(fit.exponent - x) < 1e-11);
    RC_ASSERT(fit.r_squared > 1 - 1e-9);
    RC_ASSERT(fit.r_squared <= 1);
  });
  const LoadFit flat = fit_load_diameter_law({{5, 10, 20}, {0.1, 0.1, 0.1}});
  CHECK(flat.r_squared == 1);
  CHECK(flat.exponent == 0);
  CHECK(flat.coefficient == 0.1);
}

TEST_CASE("K113: the largest load is not below the likely one, equal without spread", "[K113]") {
  verstat::test::property([] {
    GroupLoadInputs in;
    for (int k = 0; k < 6; ++k) {
      in.coefficients.push_back(real(50, 150, 1));
      in.exponents.push_back(real(100, 200, 0.01));
    }
    in.diameter_mm = real(10, 500, 0.1);
    const GroupLoad load = group_load_bounds(in);
    RC_ASSERT(load.load_max >= load.load_likely);
    RC_ASSERT(load.load_max_joint >= load.load_median_joint);
    in.sigma_multiplier = 0;
    const GroupLoad none = group_load_bounds(in);
    RC_ASSERT(none.load_max == none.load_likely);
    RC_ASSERT(none.load_max_joint == none.load_median_joint);
  });
  const GroupLoad same = group_load_bounds({{82, 82, 82}, {1.43, 1.43, 1.43}, 17, 3});
  CHECK(same.load_max == same.load_likely);
  CHECK(same.load_max_joint == Approx(same.load_likely).epsilon(1e-14));
}

TEST_CASE("K113: buckling governs up to 2 mm and torsion from 2.5 mm", "[K113]") {
  // Whole length of a jobber drill (GOST 10902 medium series) as overhang, handbook loads.
  const auto limits = [](double d, double length_mm) {
    return drill_strength_feed_limits({d, 800, 0.02 * d * d * d, 0.345, 2, 0.8, 210000,
                                       0.0054 * std::pow(d, 4), length_mm, 0.7, 680, 1, 0.7});
  };
  CHECK(limits(1.0, 34).buckling_governs == 1);
  CHECK(limits(1.5, 40).buckling_governs == 1);
  CHECK(limits(2.0, 49).buckling_governs == 1);
  CHECK(limits(2.5, 57).buckling_governs == 0);
  CHECK(limits(3.0, 61).buckling_governs == 0);
  const FeedLimits l = limits(2.0, 49);
  CHECK(l.feed_limit_mm_rev == l.feed_buckling_mm_rev);
}

TEST_CASE("K113: at the feed limits torque and thrust reach what the drill stands", "[K113]") {
  const FeedLimits l =
      drill_strength_feed_limits({8, 800, 10.24, 0.345, 2, 0.8, 210000, 22.1184, 100, 0.7, 680, 1, 0.7});
  CHECK(1000 * 0.345 * 64 * std::pow(l.feed_torsion_mm_rev, 0.8) == Approx(800 * 10.24));
  CHECK(680 * 8 * std::pow(l.feed_buckling_mm_rev, 0.7) == Approx(l.critical_thrust_n));
}

TEST_CASE("K113: a feed jump of 1.4-1.85 raises the torque 1.31-1.64 times", "[K113]") {
  CHECK(feed_jump_load_factor({1.4, 0.8}).load_factor == Approx(1.31).margin(0.005));
  CHECK(feed_jump_load_factor({1.85, 0.8}).load_factor == Approx(1.64).margin(0.005));
}

TEST_CASE("K113: usual chisel shares reproduce the recommended zone of 0.2-0.5 D", "[K113]") {
  const double point = spring_holder_setup({6600, 400, 1, 59, 0.3, 40}).point_height_mm;
  CHECK(point == Approx(0.30).margin(0.005));
  const auto zone = [point](double share) {
    return spring_critical_design({6600, point, share, 0.7, 0.3}).zone_for_unit_feed_mm;
  };
  CHECK(zone(0.4) == Approx(0.20).margin(0.005));
  CHECK(zone(0.5) == Approx(0.30).margin(0.005));
  CHECK(zone(0.6) == Approx(0.45).margin(0.005));
}

TEST_CASE("K113: the critical spring exits at a constant feed, the nominal one after its zone", "[K113]") {
  const CriticalSpring design = spring_critical_design({6600, 6, 0.4, 0.7, 4});
  const CriticalSpring unit = spring_critical_design({6600, 6, 0.4, 0.7, design.zone_for_unit_feed_mm});
  CHECK(unit.feed_ratio_after == Approx(1));
  // A constant exit feed means exit time = point height over that feed.
  SpringExitInputs in = example;
  in.chisel_share = 0.4;
  in.spring_compression_mm = 6600 / unit.spring_rate_n_mm;
  in.zone_mm = design.zone_for_unit_feed_mm;
  const SpringExit exit = spring_exit_phase(in);
  CHECK(exit.completed == 1);
  CHECK(*exit.exit_time_min == Approx(6.0 / (400 * 0.3)).epsilon(1e-9));
  CHECK(*exit.residual_compression_mm == Approx(0).margin(1e-12));
}

TEST_CASE("K113: the feed falls before breakthrough and jumps when the chisel leaves", "[K113]") {
  double last = 1;
  for (const double zone : {1.0, 3.0, 6.0, 9.0, 10.0}) {
    SpringExitInputs in = example;
    in.zone_mm = zone;
    in.feed_cap_ratio = 100;
    const SpringExit exit = spring_exit_phase(in);
    CHECK(*exit.feed_ratio_before < last);
    last = *exit.feed_ratio_before;
    CHECK(*exit.feed_ratio_after / *exit.feed_ratio_before == Approx(std::pow(0.5, -1 / 0.7)));
  }
}

TEST_CASE("K113: the exit phase agrees with explicit stepping", "[K113]") {
  for (const double y : {0.5, 0.7, 1.0, 1.3})
    for (const double compression : {12.5, 16.5, 30.0}) {
      SpringExitInputs in = example;
      in.exp_feed = y;
      in.spring_compression_mm = compression;
      CHECK(*spring_exit_phase(in).total_time_min == Approx(stepped_exit_min(in, 400000)).epsilon(1e-5));
    }
  // Continuous across y = 1, where the closed form changes.
  SpringExitInputs in = example;
  in.exp_feed = 1;
  const double at_one = *spring_exit_phase(in).zone_time_min;
  in.exp_feed = 1 + 1e-9;
  CHECK(*spring_exit_phase(in).zone_time_min == Approx(at_one).epsilon(1e-8));
}

TEST_CASE("K113: a stiff spring stalls, inside the zone without a breakthrough at all", "[K113]") {
  SpringExitInputs in = example;
  in.spring_compression_mm = 5;
  const SpringExit exit = spring_exit_phase(in);
  CHECK(exit.completed == 0);
  CHECK(*exit.stall_advance_mm == 5);
  CHECK_FALSE(exit.zone_time_min.has_value());
  CHECK_FALSE(exit.exit_time_min.has_value());
  // Equality completes, also after the rounding of a division.
  in.spring_compression_mm = 12 * (1 - 1e-12);
  CHECK(spring_exit_phase(in).completed == 1);
  in.spring_compression_mm = 12 * (1 - 1e-8);
  CHECK(spring_exit_phase(in).completed == 0);
}

TEST_CASE("K113: the worked example of 20 mm", "[K113]") {
  CHECK(spring_holder_setup({6600, 400, 20, 59, 0.3, 40}).spring_rate_limit_n_mm ==
        Approx(550).epsilon(0.001));
  const double t = *spring_exit_phase(example).total_time_min;
  CHECK(t == Approx(0.097).margin(0.0005));
  HoleTimeInputs in{.strategy = ExitStrategy::constant,
                    .part_thickness_mm = 40,
                    .point_height_mm = 6,
                    .approach_mm = 2,
                    .overrun_mm = 1,
                    .feed_mm_rev = 0.3,
                    .rpm = 400,
                    .zone_mm = 6,
                    .feed_divisor = 1.25,
                    .spring_compression_mm = 16.5,
                    .spring_time_min = t};
  const auto time = [&in](ExitStrategy strategy) {
    in.strategy = strategy;
    return through_hole_time(in).main_time_min;
  };
  CHECK(time(ExitStrategy::constant) == Approx(0.408).margin(0.0005));
  CHECK(time(ExitStrategy::reduced_full_depth) == Approx(0.510).margin(0.0005));
  CHECK(time(ExitStrategy::reduced_exit) == Approx(0.435).margin(0.0005));
  CHECK(time(ExitStrategy::spring_exit) == Approx(0.535).margin(0.0005));
  const auto even = [t](double divisor) {
    return spring_break_even_thickness({6, 2, 1, 6, 0.3, 400, divisor, 16.5, t}).break_even_thickness_mm;
  };
  CHECK(even(1.11) == Approx(129).margin(0.5));
  CHECK(even(1.25) == Approx(52).margin(0.5));
  CHECK(even(1.6) == Approx(16).margin(0.5));
  CHECK(even(2) == Approx(6).margin(0.5));
  // At the break-even thickness the two strategies take the same time.
  in.part_thickness_mm = even(1.25);
  CHECK(time(ExitStrategy::reduced_full_depth) == Approx(time(ExitStrategy::spring_exit)));
}

TEST_CASE("K113: the feed jump starts at 1 and grows as the machine softens", "[K113]") {
  double last = 1;
  for (const double stiffness : {1e9, 1e5, 2e4, 1e4, 5e3, 3e3}) {
    const FeedJump jump = breakthrough_feed_jump({6600, stiffness, 0.5, 1.5});
    REQUIRE(jump.stable == 1);
    CHECK(*jump.feed_jump >= last);
    last = *jump.feed_jump;
  }
  CHECK(*breakthrough_feed_jump({6600, 1e12, 0.5, 1.5}).feed_jump == Approx(1));
  CHECK(breakthrough_feed_jump({6600, 2200, 0.5, 1.5}).stable == 0);  // springback = travel
}

TEST_CASE("K113: breakage grows with the load factor and is 1/2 at equal means", "[K113]") {
  double last = 0;
  for (const double factor : {1.0, 1.3, 1.6, 2.0, 2.4}) {
    const double p = drill_break_probability({50, 5, factor, 120, 15}).break_probability;
    CHECK(p > last);
    last = p;
  }
  CHECK(drill_break_probability({50, 5, 2.4, 120, 0}).break_probability == Approx(0.5));
  // Phi(-1.96) = 0.025 (normal table).
  CHECK(drill_break_probability({0, 1, 1, 1.959964, 0}).break_probability == Approx(0.025).epsilon(1e-5));
}

TEST_CASE("K113: bad input names itself", "[K113]") {
  CHECK_THROWS_WITH(fit_load_diameter_law({{5, 5}, {1, 2}}),
                    "K113.fit_load_diameter_law: diameters_mm = 5, at least two must be distinct");
  CHECK_THROWS_WITH(spring_holder_setup({6600, 400, 20, 59, 0.3, 12}),
                    Catch::Contains("part_thickness_mm = 12"));
  CHECK_THROWS_WITH(through_hole_time({.strategy = ExitStrategy::reduced_full_depth,
                                       .part_thickness_mm = 40,
                                       .feed_mm_rev = 0.3,
                                       .rpm = 400}),
                    "K113.through_hole_time: feed_divisor = null, is needed by this strategy");
  CHECK_THROWS_WITH(drill_break_probability({50, 0, 1, 120, 0}), Catch::Contains("strength_sd_nm = 0"));
}
