// The checks of card K108; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k108_magnetic_abrasive_inserts.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k108;

TEST_CASE("K108: the printed stages take 3.47 and 8 min, and the ring has 95.5 mm", "[K108]") {
  CHECK(treatment_time({8, 26}).total_min == Approx(3.47).margin(0.005));
  CHECK(treatment_time({4, 120}).total_min == 8);
  CHECK(ring_radius({2, 200}).radius_mm == Approx(95.5).margin(0.05));
}

TEST_CASE("K108: roughness runs from its start to the final level of the mixture", "[K108]") {
  for (const Mixture mixture : {Mixture::fine, Mixture::coarse}) {
    const double final_um = final_roughness({mixture}).ra_um;
    CHECK(roughness_after({0, 0.4, mixture}).ra_um == Approx(0.4).epsilon(1e-15));
    CHECK(std::abs(roughness_after({480, 0.4, mixture}).ra_um - final_um) < 1e-3 * (0.4 - final_um));
    // 95 % of the change at the settling time, from either side.
    CHECK((0.4 - roughness_after({200, 0.4, mixture}).ra_um) / (0.4 - final_um) ==
          Approx(0.95).margin(0.001));
    CHECK(roughness_after({100, final_um / 2, mixture}).ra_um > final_um / 2);
  }
  CHECK(final_roughness({Mixture::fine}).ra_um < final_roughness({Mixture::coarse}).ra_um);
}

TEST_CASE("K108: hardness grows from 1 to 1.135", "[K108]") {
  CHECK(hardness_factor({0}).factor == 1);
  CHECK(hardness_factor({480}).factor == Approx(1.135).margin(1e-5));
  verstat::test::property([] {
    const double t = *rc::gen::inRange(0, 479);
    RC_ASSERT(hardness_factor({t + 1}).factor > hardness_factor({t}).factor);
  });
}

TEST_CASE("K108: edge radius and treatment time are inverse", "[K108]") {
  verstat::test::property([] {
    const double start = *rc::gen::inRange(0, 200) * 0.1;
    const double rate = *rc::gen::inRange(1, 200) * 1e-3;
    const double t_break = *rc::gen::inRange(0, 500);
    const double slow = *rc::gen::inRange(1, 101) * 1e-2;
    const double t = *rc::gen::inRange(0, 1000);
    const double rho = edge_radius_after({t, start, rate, t_break, slow}).radius_um;
    RC_ASSERT(rho >= start);
    RC_ASSERT(time_for_edge_radius({rho, start, rate, t_break, slow}).time_s == Approx(t).margin(1e-8));
  });
  CHECK(edge_radius_after({480, 10, 20.0 / 480, 480, 1}).radius_um == Approx(30));  // the printed 30 um
  CHECK(time_for_edge_radius({5, 10, 0.05, 100, 0.3}).time_s == 0);
  // Without growth after the break the radius there is the last that can be reached.
  const double last = edge_radius_after({1e6, 10, 0.055, 330, 0}).radius_um;
  CHECK(time_for_edge_radius({last, 10, 0.055, 330, 0}).time_s == Approx(330));
}

TEST_CASE("K108: the ends of the recommended angles count", "[K108]") {
  CHECK(recommended_setting({20, 30, Mixture::fine}).angles_ok);
  CHECK_FALSE(recommended_setting({std::nextafter(20.0, 0.0), 25, Mixture::fine}).angles_ok);
  CHECK_FALSE(recommended_setting({25, std::nextafter(30.0, 90.0), Mixture::fine}).angles_ok);
  CHECK_FALSE(recommended_setting({25, 25, Mixture::coarse}).mixture_ok);
}

TEST_CASE("K108: bad input names itself", "[K108]") {
  CHECK_THROWS_WITH(
      time_for_edge_radius({30, 10, 0.05, 330, 0}),
      "K108.time_for_edge_radius: rho_target = 30, must not be above the radius at t_break when "
      "slow_factor = 0");
  CHECK_THROWS_WITH(
      catalogue().at("K108.final_roughness").evaluate(Value::Map{{"mixture", "medium"}}),
      Catch::Contains("K108.final_roughness: mixture = \"medium\", must be one of \"fine\", \"coarse\""));
}
