// The checks of card K116; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <array>
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/surface/k116_tool_steel_surface.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k116;

namespace {

constexpr std::array finishes{FatigueFinish::grinding_abrasive, FatigueFinish::turning_geksanit_r_50,
                              FatigueFinish::turning_geksanit_r_100, FatigueFinish::turning_geksanit_r_200};

double life(FatigueFinish finish, double stress_mpa) {
  return fatigue_life_cycles({finish, stress_mpa}).cycles;
}

}  // namespace

TEST_CASE("K116: the fatigue limits at 1e7 cycles are the printed ones", "[K116]") {
  constexpr std::array limits{560.0, 827.0, 770.0, 735.0};
  for (std::size_t k = 0; k < finishes.size(); ++k)
    CHECK(fatigue_limit({finishes[k]}).limit_mpa == Approx(limits[k]).margin(2));
  CHECK(fatigue_limit({FatigueFinish::turning_geksanit_r_50}).limit_mpa == Approx(827.18).margin(0.005));
  // 1e5 cycles: just outside the stress range of the life.
  CHECK(fatigue_limit({finishes[1], 1e5}).limit_mpa == Approx(1001).margin(0.5));
  CHECK(fatigue_limit({finishes[2], 1e5}).limit_mpa == Approx(1031).margin(0.5));
}

TEST_CASE("K116: life falls with stress and is the inverse of the limit", "[K116]") {
  verstat::test::property([] {
    const auto finish = finishes[*rc::gen::inRange<std::size_t>(0, finishes.size())];
    const double stress = *rc::gen::inRange(5000, 9990) * 0.1;
    RC_ASSERT(life(finish, stress + 1) < life(finish, stress));
    const double cycles = std::pow(10, *rc::gen::inRange(5200, 7001) * 1e-3);
    const double limit = fatigue_limit({finish, cycles}).limit_mpa;
    if (limit >= 500 && limit <= 1000) RC_ASSERT(life(finish, limit) == Approx(cycles).epsilon(1e-11));
  });
}

TEST_CASE("K116: grinding lives shortest everywhere, and the turning curves cross once in the range",
          "[K116]") {
  int crossings = 0;
  for (int stress = 500; stress <= 1000; ++stress) {
    for (std::size_t k = 1; k < finishes.size(); ++k)
      CHECK(life(finishes[0], stress) < life(finishes[k], stress));
    if (stress == 1000) break;
    for (std::size_t i = 1; i < finishes.size(); ++i)
      for (std::size_t k = i + 1; k < finishes.size(); ++k) {
        const bool above = life(finishes[i], stress) > life(finishes[k], stress);
        const bool above_next = life(finishes[i], stress + 1) > life(finishes[k], stress + 1);
        if (above != above_next) {
          ++crossings;
          CHECK(stress == 945);  // at 945.8 MPa
          CHECK(i == 1);
          CHECK(k == 2);
        }
      }
  }
  CHECK(crossings == 1);
}

TEST_CASE("K116: the limit over speed meets the printed values and clamps", "[K116]") {
  CHECK(turned_fatigue_limit_vs_speed({100}).limit_mpa == 770);
  CHECK(turned_fatigue_limit_vs_speed({150}).limit_mpa == Approx(752.5));
  CHECK(turned_fatigue_limit_vs_speed({1}).limit_mpa == 827);
  CHECK(turned_fatigue_limit_vs_speed({1000}).limit_mpa == 735);
}

TEST_CASE("K116: austenite between and outside the rows of the tables", "[K116]") {
  CHECK(austenite_after_grinding({Wheel::abrasive, 60}).percent == Approx(26));
  CHECK(austenite_after_grinding({Wheel::abrasive, 0}).percent == 24);
  CHECK(austenite_after_grinding({Wheel::geksanit_a, 1000}).percent == 30);
  CHECK(austenite_after_grinding({Wheel::geksanit_a, 20}).percent == 27);
  CHECK(austenite_after_turning({60}).percent == Approx(25.5));
  CHECK(austenite_after_turning({5}).percent == 23);
  CHECK(austenite_after_turning({40}).percent == 21);
}

TEST_CASE("K116: the austenite share depends on the ratio of the lines only", "[K116]") {
  CHECK(retained_austenite_percent({100, 0}).percent == 0);
  CHECK(retained_austenite_percent({0, 3}).percent == 100);
  verstat::test::property([] {
    const double alpha = *rc::gen::inRange(1, 1000) * 0.1;
    const double gamma = *rc::gen::inRange(1, 1000) * 0.1;
    const double scale = *rc::gen::inRange(1, 1000) * 0.01;
    const double share = retained_austenite_percent({alpha, gamma}).percent;
    RC_ASSERT(retained_austenite_percent({alpha * scale, gamma * scale}).percent == Approx(share));
    RC_ASSERT(retained_austenite_percent({alpha, gamma * 1.1}).percent > share);
  });
}

TEST_CASE("K116: the stress sum is odd in the shift, tension for a smaller spacing", "[K116]") {
  CHECK(xray_principal_stress_sum({210000, 0.28, 57, 0}).sum_mpa == 0);
  const double tension = xray_principal_stress_sum({210000, 0.28, 57, 0.05}).sum_mpa;
  CHECK(tension > 0);
  CHECK(xray_principal_stress_sum({210000, 0.28, 57, -0.05}).sum_mpa == -tension);
  // cot 45 deg = 1: E/mu times the shift in radians.
  CHECK(xray_principal_stress_sum({200000, 0.25, 45, 180 / std::acos(-1.0)}).sum_mpa == Approx(800000));
}

TEST_CASE("K116: hard turning leaves the thinnest tempered zone", "[K116]") {
  CHECK(tempered_zone_depth({LayerFinish::abrasive_wheel}).to_um == 650);
  CHECK(tempered_zone_depth({LayerFinish::geksanit_a_wheel}).to_um == 300);
  CHECK(tempered_zone_depth({LayerFinish::geksanit_a_wheel}).from_um == 30);
  CHECK(tempered_zone_depth({LayerFinish::geksanit_r_turning}).to_um <
        tempered_zone_depth({LayerFinish::geksanit_a_wheel}).from_um);
}

TEST_CASE("K116: bad input names itself", "[K116]") {
  CHECK_THROWS_WITH(retained_austenite_percent({0, 0}),
                    "K116.retained_austenite_percent: S_alpha = 0, must not be 0 together with S_gamma");
  CHECK_THROWS_WITH(life(finishes[0], 499),
                    "K116.fatigue_life_cycles: stress_MPa = 499, allowed 500 <= stress_MPa <= 1000 (stress "
                    "amplitude)");
}
