// The checks of card K306; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k306_auger_winding.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k306;
using verstat::test::property;

namespace {

struct Radii {
  double outer, inner, force;
};
Radii random_radii() {
  const double inner = *rc::gen::inRange(10, 100);
  const double outer = inner * (1 + *rc::gen::inRange(1, 300) * 0.01);
  return {outer, inner, outer * (1 + *rc::gen::inRange(1, 300) * 0.01)};
}

}  // namespace

TEST_CASE("K306: a flat screw is wound on its own diameter, stretching reduces it", "[K306]") {
  property([] {
    const double inner = *rc::gen::inRange(20, 100);
    const double outer = inner + *rc::gen::inRange(10, 200);
    const double width = (outer - inner) / 2;
    RC_ASSERT(std::abs(mandrel_diameter({width, 1e-9, outer, inner}).diameter_mm - inner) < 1e-9);
    // Without the correction of the paper the diameter rises with the pitch.
    double last = inner;
    for (double pitch = 5; pitch < inner / 0.021; pitch += 5) {
      const double geometric =
          mandrel_diameter({width, pitch, outer, inner}).diameter_mm / (1 - 0.021 * pitch / inner);
      RC_ASSERT(geometric > last);
      last = geometric;
    }
  });
  CHECK(mandrel_diameter({50, 100, 150, 50}).diameter_mm == Approx(60.36).margin(0.005));
}

TEST_CASE("K306: the neutral line lies between the inner edge and the middle of bending", "[K306]") {
  property([] {
    const Radii c = random_radii();
    const double middle = std::sqrt(c.outer * c.inner);
    const double neutral = neutral_radius({c.outer, c.inner, c.force}).radius_mm;
    RC_ASSERT(neutral > c.inner);
    RC_ASSERT(neutral < middle);
    RC_ASSERT(neutral_radius({c.outer, c.inner, 1.2 * c.force}).radius_mm > neutral);
    RC_ASSERT(std::abs(neutral_radius({c.outer, c.inner, 1e12}).radius_mm - middle) < 1e-6);
    RC_ASSERT(neutral_radius({c.outer, c.outer, c.force}).radius_mm == c.outer);
    // Eq. (3) as it stands, without the rearrangement that saves its digits.
    const double arm = c.force - middle;
    const double root = std::sqrt(
        1 + (c.outer * c.outer + 2 * std::sqrt(c.outer * std::pow(c.inner, 3)) - 3 * c.outer * c.inner) /
                (3 * arm * arm));
    RC_ASSERT(std::abs(neutral - (c.force - arm * root)) < 1e-9 * c.force);
  });
}

TEST_CASE("K306: the neutral radius meets the exact moment balance to a percent", "[K306]") {
  const auto exact = [](double outer, double inner, double force) {
    const auto balance = [&](double rho) {
      return force * std::log(outer * inner / (rho * rho)) - (outer + inner - 2 * rho);
    };
    double low = inner, high = outer;  // the balance falls with rho in here
    for (int k = 0; k < 200; ++k) {
      const double middle = (low + high) / 2;
      (balance(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  for (const double ratio : {1.1, 1.5, 2.0})
    CHECK(neutral_radius({ratio, 1, 1.5 * ratio}).radius_mm ==
          Approx(exact(ratio, 1, 1.5 * ratio)).epsilon(0.009));
  CHECK(neutral_radius({3, 1, 4.5}).radius_mm == Approx(exact(3, 1, 4.5)).epsilon(0.03));
}

TEST_CASE("K306: the inner edge is thicker than the blank, the outer thinner", "[K306]") {
  property([] {
    const Radii c = random_radii();
    const double neutral = neutral_radius({c.outer, c.inner, c.force}).radius_mm;
    const double inner = blank_thickness({Edge::inner, 3, c.outer, c.inner, neutral}).thickness_mm;
    const double outer = blank_thickness({Edge::outer, 3, c.outer, c.inner, neutral}).thickness_mm;
    RC_ASSERT(inner < 3);
    RC_ASSERT(outer > 3);
    RC_ASSERT(std::abs(outer / inner - std::sqrt(c.outer / c.inner)) < 1e-12 * outer / inner);
  });
}

TEST_CASE("K306: strip length against the screw", "[K306]") {
  const ScrewStrip strip{1000, 45, 60, 50, 100, 50};
  const double net = strip_length(strip).net_mm;
  CHECK(net > 1000);
  CHECK(strip_length(strip).trimmed_mm == Approx(net + 4 * 50));
  ScrewStrip twice = strip;
  twice.screw_length_mm *= 2;
  CHECK(strip_length(twice).net_mm == Approx(2 * net).epsilon(1e-14));
  ScrewStrip stretched = strip;
  stretched.pitch_mm = 1e9;
  CHECK(strip_length(stretched).net_mm == Approx(1000).epsilon(1e-12));
  ScrewStrip corrugated = strip;
  corrugated.developed_length_factor = 1.1;
  CHECK(strip_length(corrugated).net_mm == Approx(1.1 * net));
}

TEST_CASE("K306: the coil is its turns times the thickness of the inner edge", "[K306]") {
  property([] {
    const Radii c = random_radii();
    const double neutral = std::sqrt(c.outer * c.inner);
    const double turns = winding_time({3000, neutral, 12, 15, 0}).turns;
    const double edge = 2.5 / std::sqrt(c.inner / neutral);
    const double stack = coil_stack_length({2.5, c.outer - c.inner, c.outer / c.inner, 3000}).length_mm;
    RC_ASSERT(std::abs(stack - turns * edge) < 1e-10 * stack);
    RC_ASSERT(std::abs(longitudinal_force({400, 2.5, c.outer, c.inner, neutral}).force_n) < 1e-9);
    const double inward = neutral_radius({c.outer, c.inner, c.force}).radius_mm;
    RC_ASSERT(longitudinal_force({400, 2.5, c.outer, c.inner, inward}).force_n > 0);
  });
}

TEST_CASE("K306: whole windings are not rounded up", "[K306]") {
  const double circumference = 2 * std::numbers::pi * 45;
  CHECK(winding_time({45 * circumference, 45, 12, 15, 4}).windings == 3);
  CHECK(winding_time({45.1 * circumference, 45, 12, 15, 4}).windings == 4);
}

TEST_CASE("K306: the plan of the card, and what the force radius does to it", "[K306]") {
  const auto plan = [](double factor) { return auger_blank_plan({150, 50, 100, 1000, 3, factor}); };
  const AugerBlank p = plan(1.5);
  CHECK(p.mandrel_diameter_mm == Approx(60.36).margin(0.005));
  CHECK(p.neutral_radius_mm == Approx(44.34).margin(0.005));
  CHECK(p.thickness_mm == Approx(2.475).margin(5e-4));
  CHECK(p.net_mm == Approx(2656).margin(0.5));
  CHECK(p.trimmed_mm == Approx(2856).margin(0.5));
  CHECK(p.stack_mm == Approx(27.2).margin(0.05));
  CHECK(plan(1.01).net_mm == Approx(2375).margin(0.5));
  CHECK(plan(3).net_mm == Approx(2831).margin(0.5));
  CHECK(plan(1000).net_mm == Approx(2940).margin(0.5));
}

TEST_CASE("K306: bad input names itself", "[K306]") {
  CHECK_THROWS_WITH(mandrel_diameter({50, 2400, 150, 50}),
                    "K306.mandrel_diameter: T = 2400, must be below d/0.021");
  CHECK_THROWS_WITH(neutral_radius({75, 25, 75}), "K306.neutral_radius: rho_np = 75, must be above R");
  CHECK_THROWS_WITH(neutral_radius({100, 1, 100.1}), Catch::Contains("inside the inner edge of the coil"));
  CHECK_THROWS_WITH(blank_thickness({Edge::inner, 3, 80, 30, 25}),
                    "K306.blank_thickness: rho0 = 25, must not be below r");
}
