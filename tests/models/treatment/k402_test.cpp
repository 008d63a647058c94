// The checks of card K402; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/solve.h"
#include "models/treatment/k402_discrete_coating.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k402;

namespace {

HeatedIsland island(double side, double h, double delta_alpha = 3e-6, double delta_t = 780) {
  return {{h, 440000, 0.25, delta_alpha, delta_t}, side};
}

}  // namespace

TEST_CASE("K402: a few micrometres of TiN do not insulate", "[K402]") {
  CHECK(coating_temperature_drop({1e5, 3, 12.5}).delta_k == Approx(0.024).epsilon(1e-12));
  const auto face = insert_face_temperatures({800, 1e5, 3, 12.5, 4.76, 23});
  CHECK(800 - face.interface_c == Approx(0.024).margin(1e-9));
}

TEST_CASE("K402: thermal shear rises with the island, saturates and follows the sign of the mismatch",
          "[K402]") {
  const double saturated = 440000 / 0.75 * 3e-6 * 780 * 4 * 0.104 / 2;
  double previous = 0;
  for (double side : {10.0, 20.0, 40.0, 80.0, 200.0}) {
    const double tau = interface_thermal_shear(island(side, 4)).tau_max_mpa;
    CHECK(tau > previous);
    CHECK(tau < saturated);
    previous = tau;
  }
  CHECK(previous == Approx(saturated).epsilon(1e-4));
  verstat::test::property([] {
    const double side = *rc::gen::inRange(10, 201), h = *rc::gen::inRange(10, 80) * 0.1;
    const auto hot = interface_thermal_shear(island(side, h));
    RC_ASSERT(hot.tau_max_mpa > 0);
    RC_ASSERT(interface_thermal_shear(island(side, h, -3e-6)).tau_max_mpa == -hot.tau_max_mpa);
    RC_ASSERT(interface_thermal_shear(island(side, h, -3e-6, -780)).sigma_centre_mpa == hot.sigma_centre_mpa);
    RC_ASSERT(hot.sigma_centre_mpa < 440000 / 0.75 * 3e-6 * 780);
    if (side >= 40) RC_ASSERT(interface_thermal_shear(island(side, h + 0.1)).tau_max_mpa > hot.tau_max_mpa);
  });
}

TEST_CASE("K402: an island is in equilibrium", "[K402]") {
  // tau(x) = sigma_0 h k sinh(k x) / cosh(k D/2): its integral over half the island is the force in the
  // middle.
  for (double side : {10.0, 40.0, 120.0, 200.0}) {
    const double h = 3, k = 0.104 / std::sqrt(h);
    const auto out = interface_thermal_shear(island(side, h));
    const double shear = integrate(
        [&](double x) { return out.tau_max_mpa * std::sinh(k * x) / std::sinh(k * side / 2); }, 0, side / 2);
    CHECK(shear == Approx(out.sigma_centre_mpa * h).epsilon(1e-10));
  }
  CHECK(interface_thermal_shear(island(200, 1)).sigma_centre_mpa ==
        Approx(440000 / 0.75 * 3e-6 * 780).epsilon(1e-4));
}

TEST_CASE("K402: the printed reductions by discreteness are met", "[K402]") {
  verstat::test::property([] {
    const double ratio = discrete_shear_ratio({static_cast<double>(*rc::gen::inRange(40, 121)),
                                               *rc::gen::inRange(20, 61) * 0.1})
                             .ratio;
    RC_ASSERT((ratio >= 0.4 && ratio <= 0.67));
  });
  CHECK(size_effect({120, 40, 6}).ratio == Approx(1.43).margin(0.005));
  CHECK(size_effect({120, 40, 4}).ratio == Approx(1.28).margin(0.005));
  CHECK(size_effect({120, 40, 2}).ratio == Approx(1.11).margin(0.005));
}

TEST_CASE("K402: the largest safe island is where the margin ends", "[K402]") {
  verstat::test::property([] {
    const double h = *rc::gen::inRange(10, 81) * 0.1, mismatch = *rc::gen::inRange(-40, 41) * 1e-7;
    const double pressure = *rc::gen::inRange(100, 900), adhesion = *rc::gen::inRange(100, 500);
    const HeatedCoating coating{h, 440000, 0.25, mismatch, 780};
    const auto safe = largest_safe_island({coating, 0.35, pressure, adhesion});
    const auto total = [&](double side) {
      return std::abs(interface_thermal_shear({coating, side}).tau_max_mpa) + 0.35 * pressure;
    };
    if (!safe.feasible) {
      RC_ASSERT(total(10) > adhesion);
    } else if (safe.side_um == 200) {
      RC_ASSERT(total(200) <= adhesion);
    } else {
      RC_ASSERT(std::abs(total(safe.side_um) - adhesion) < 1e-6 * adhesion);
    }
    HeatedCoating mirrored = coating;
    mirrored.delta_alpha_1_k = -mismatch;
    const auto same = largest_safe_island({mirrored, 0.35, pressure, adhesion});
    RC_ASSERT((same.feasible == safe.feasible && same.side_um == safe.side_um));
  });
}

TEST_CASE("K402: margin and coverage", "[K402]") {
  const auto even = delamination_margin({{0.5, 400}, 100, 300});
  CHECK(even.holds);
  CHECK(even.margin == Approx(1));
  CHECK(island_coverage({0.2, 0.33}).share == Approx(0.367).margin(5e-4));
}

TEST_CASE("K402: bad input names itself", "[K402]") {
  CHECK_THROWS_WITH(delamination_margin({{0, 300}, 0, 300}),
                    "K402.delamination_margin: tau_thermal = 0, and mu q must not both be 0");
  CHECK_THROWS_WITH(island_coverage({0.4, 0.33}),
                    "K402.island_coverage: side = 0.4, must not be above pitch");
}
