// The checks of card K305; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k305_thermo_friction_surface.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k305;

TEST_CASE("K305: the text's numbers come back", "[K305]") {
  CHECK(disc_speed({500, 1600}).speed_m_s == Approx(41.9).margin(0.05));
  CHECK(disc_speed({500, 2500}).speed_m_s == Approx(65.4).margin(0.06));
  CHECK(published_ranges({Quantity::residual_45_subsurface}).low == -600);
  CHECK(published_ranges({Quantity::residual_45_subsurface}).high == -200);
  CHECK(surface_temperature({Steel::steel_12kh18n12t}).high_c == 650);
  CHECK(surface_temperature({Steel::steel_09kh15n8yu}).low_c == 600);
  // Every name has a range in order.
  for (const auto& [quantity, name] : EnumNames<Quantity>::names) {
    INFO(name);
    CHECK(published_ranges({quantity}).low <= published_ranges({quantity}).high);
  }
}

TEST_CASE("K305: the envelope includes its ends and judges the feed by the width band", "[K305]") {
  const auto inside = [](double width, double depth, double feed, double rpm) {
    return regime_in_envelope({width, depth, feed, rpm}).in_envelope == 1;
  };
  CHECK(inside(60, 1, 160, 1600));
  CHECK(inside(100, 2.5, 100, 2500));
  CHECK(inside(65, 2, 300, 2000));
  CHECK_FALSE(inside(90, 2, 300, 2000));  // the feed of the narrow band
  CHECK_FALSE(inside(65, 2, 120, 2000));  // the feed of the wide band
  CHECK_FALSE(inside(79.99, 2, 200, 2000));
  CHECK_FALSE(inside(65, 2.51, 200, 2000));
  CHECK(compressive_stress_trend({50.001}).trend == 1);
}

TEST_CASE("K305: hardness falls from the factor to the base", "[K305]") {
  CHECK(hardness_ratio({500, 1.5}).ratio == Approx(1.125));
  verstat::test::property([] {
    const double factor = 1 + *rc::gen::inRange(1, 100) * 0.01;
    const double depth = *rc::gen::inRange(0, 590);
    const double here = hardness_ratio({depth, factor}).ratio;
    RC_ASSERT(here <= factor);
    RC_ASSERT(here >= hardness_ratio({depth + 10, factor}).ratio);
    RC_ASSERT(hardness_ratio({600.0 + depth, factor}).ratio == 1);
  });
}

TEST_CASE("K305: residual stress passes through the printed ends", "[K305]") {
  const auto plain = [](double depth, double level) {
    return residual_stress({Steel::steel_45, depth, level}).stress_mpa;
  };
  const auto alloy = [](double depth, double level) {
    return residual_stress({Steel::steel_09kh15n8yu, depth, level}).stress_mpa;
  };
  CHECK(plain(0, 1) == Approx(1170));
  CHECK(plain(7, 0) == Approx(0).margin(1e-12));
  CHECK(plain(14, 1) == Approx(0).margin(1e-12));
  CHECK(plain(30, 1) == Approx(-600));
  CHECK(alloy(0, 1) == Approx(-1100));
  CHECK(alloy(140, 1) == Approx(0).margin(1e-12));
  verstat::test::property([&] {
    const double depth = *rc::gen::inRange(0, 400), level = *rc::gen::inRange(0, 101) * 0.01;
    RC_ASSERT(alloy(depth, level) <= 0);
    RC_ASSERT(plain(depth, level) >= -(200 + 400 * level) - 1e-9);
    if (depth > 100 + 200 * level) RC_ASSERT(plain(depth, level) == 0);
    if (depth > 100 + 40 * level) RC_ASSERT(alloy(depth, level) == 0);
  });
}

TEST_CASE("K305: feed limit meets its corners and falls with width and depth", "[K305]") {
  CHECK(feed_limit({90, 2.5}).feed_mm_min == Approx(100).epsilon(1e-12));
  CHECK(feed_limit({60, 1}).feed_mm_min == Approx(333).margin(0.5));
  CHECK(feed_limit({100, 2.5}).feed_mm_min == Approx(86).margin(0.5));
  verstat::test::property([] {
    const double width = *rc::gen::inRange(600, 990) * 0.1, depth = *rc::gen::inRange(100, 245) * 0.01;
    const double here = feed_limit({width, depth}).feed_mm_min;
    RC_ASSERT(feed_limit({width + 1, depth}).feed_mm_min < here);
    RC_ASSERT(feed_limit({width, depth + 0.05}).feed_mm_min < here);
  });
}

TEST_CASE("K305: the energy limit loads the drive fully", "[K305]") {
  const auto first = removal_and_power({65, 2.5, 160, 20, 14, 0.8});
  CHECK(removal_and_power({65, 2.5, 160, first.energy_limit_j_mm3, 14, 0.8}).power_kw == Approx(14 * 0.8));
}

TEST_CASE("K305: whole quotients of passes count exactly", "[K305]") {
  const auto passes = [](double part, double stock, double depth) {
    return pass_time({600, part, 70, 5, 40, stock, depth, 200}).passes;
  };
  CHECK(passes(70, 4.2, 1.4) == 3);
  CHECK(passes(135, 4.2, 1.4) == 6);
  CHECK(passes(135.01, 4.2, 1.4) == 9);
  CHECK(passes(200, 4.21, 1.4) == 12);
  CHECK(passes(200, 0, 1.4) == 0);
}

TEST_CASE("K305: removing the hardened layer costs at least 0.54 mm", "[K305]") {
  CHECK(following_allowance({40, 500, false, 0}).allowance_um == 540);
  CHECK(following_allowance({40, 500, true, 30}).allowance_um == 70);
}

TEST_CASE("K305: bad input names itself", "[K305]") {
  CHECK_THROWS_WITH(
      residual_stress({Steel::steel_38khgn, 10, 0.5}),
      "K305.residual_stress: steel = \"38KhGN\", has no published residual stress; allowed: \"45\", "
      "\"09Kh15N8Yu\"");
  CHECK_THROWS_WITH(pass_time({600, 135, 70, 70, 40, 4, 1, 200}),
                    "K305.pass_time: overlap_mm = 70, must be below disc_width_band_mm");
}
