// The checks of card K407; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/solve.h"
#include "models/treatment/k407_thread_rolling.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k407;

namespace {

constexpr RidgeShape m12{1.75, 30, 0, 0.1443 * 1.75};
constexpr RidgeShape tr80{8, 15, 2.93, 0};
constexpr RidgeShape tr40{5, 15, 1.83, 0};

RidgeProfile sunk(const RidgeShape& shape, double depth) {
  return ridge_profile({shape, depth});
}
double raised(const RidgeProfile& p, double depth) {
  return extrusion_height({p.gap_mm, p.closing, depth, p.area_mm2}).height_mm;
}

}  // namespace

TEST_CASE("K407: area is the integral of the width, perimeter the length of the profile", "[K407]") {
  for (const RidgeShape& shape : {m12, tr80}) {
    const double tangent =
        shape.tip_radius_mm * (1 - std::sin(shape.half_angle_deg * std::numbers::pi / 180));
    for (double depth : {0.01, 0.08, 0.3, 0.9}) {
      const auto width = [&](double e) { return sunk(shape, e).width_mm; };
      // sqrt at the tip: substitute e = x^2; split at the end of the arc.
      const auto substituted = [&](double x) { return 2 * x * width(x * x); };
      const double kink = std::sqrt(std::min(tangent, depth));
      const double area =
          integrate(substituted, 0, kink, 1e-11) + integrate(substituted, kink, std::sqrt(depth), 1e-11);
      CHECK(sunk(shape, depth).area_mm2 == Approx(area).epsilon(1e-9));
      const double step = 1e-6;
      const double slope = (width(depth + step) - width(depth - step)) / (4 * step);  // of one flank
      const double rate =
          (sunk(shape, depth + step).perimeter_mm - sunk(shape, depth - step).perimeter_mm) / (2 * step);
      CHECK(rate == Approx(2 * std::hypot(1, slope)).epsilon(1e-6));
    }
    CHECK(sunk(shape, 0).perimeter_mm == 0);
  }
}

TEST_CASE("K407: eq. (6) conserves area: flat tip always, rounded tip below the arc", "[K407]") {
  verstat::test::property([] {
    const RidgeShape shape{static_cast<double>(*rc::gen::inRange(2, 13)),
                           static_cast<double>(*rc::gen::inRange(0, 31)), *rc::gen::inRange(0, 50) * 0.01, 0};
    const double depth = *rc::gen::inRange(1, 100) * 0.002 * shape.pitch_mm;
    const auto p = sunk(shape, depth);
    const double height = raised(p, depth);
    RC_ASSERT(std::abs((p.gap_mm - p.closing * depth) * height - p.closing / 2 * height * height -
                       p.area_mm2) < 1e-12 * (1 + p.area_mm2));
  });
  // Too high by 11, 3, 0.8 % where the tangents replace the arc, exact from its end on.
  const double tangent = m12.tip_radius_mm / 2;
  for (const auto& [depth, percent] : {std::pair{0.01, 11.0}, {0.05, 3.0}, {0.08, 0.8}, {tangent, 0.0}}) {
    const auto p = sunk(m12, depth);
    // Height that gives the true area between the arcs: P h - (area(depth + h) - area(depth)) = area(depth).
    const double exact =
        find_root([&](double h) { return m12.pitch_mm * h - sunk(m12, depth + h).area_mm2; }, 1e-9, 1.0);
    CHECK(100 * (raised(p, depth) / exact - 1) == Approx(percent).margin(0.5));
  }
}

TEST_CASE("K407: the sizing ridge fills the profile", "[K407]") {
  for (const auto& [shape, height, tolerance, minor] :
       {std::tuple{m12, 1.0735, 0.0, 9.853}, std::tuple{tr80, 4.5, 0.1, 71.0},
        std::tuple{tr40, 2.75, 0.05, 34.5}}) {
    const auto s = calibrating_penetration({shape, height, tolerance, minor});
    const auto p = sunk(shape, s.penetration_mm);
    CHECK(s.penetration_mm + raised(p, s.penetration_mm) == Approx(s.full_mm).epsilon(1e-9));
    // A larger tolerance gives a smaller blank.
    CHECK(calibrating_penetration({shape, height, tolerance + 0.02, minor}).blank_mm < s.blank_mm);
    // Exact blank: the ring volume between root and crest, by quadrature.
    const double root = minor - 2 * tolerance;
    const double tangent =
        shape.tip_radius_mm * (1 - std::sin(shape.half_angle_deg * std::numbers::pi / 180));
    const auto ring = [&](double x) {
      return 2 * x * (root / 2 + x * x) * (shape.pitch_mm - sunk(shape, x * x).width_mm);
    };
    const double kink = std::sqrt(tangent);
    const double volume =
        integrate(ring, 0, kink, 1e-11) + integrate(ring, kink, std::sqrt(s.full_mm), 1e-11);
    CHECK(s.blank_exact_mm == Approx(std::sqrt(root * root + 8 / shape.pitch_mm * volume)).epsilon(1e-10));
    // Areas for volumes: raised height at most 3 % too large.
    const double exact_raised = minor / 2 + height - s.blank_exact_mm / 2;
    CHECK(s.extruded_mm / exact_raised - 1 == Approx(0.027).margin(0.004));
  }
  const auto bolt = calibrating_penetration({m12, 1.0735, 0, 9.853});
  CHECK(bolt.blank_mm == Approx(10.890).margin(6e-4));
  CHECK(bolt.blank_exact_mm == Approx(10.917).margin(6e-4));
}

TEST_CASE("K407: the contact arc is the intersection of two circles", "[K407]") {
  verstat::test::property([] {
    const double blank = *rc::gen::inRange(50, 600) * 0.1, roller = *rc::gen::inRange(400, 700) * 0.1;
    const double depth = *rc::gen::inRange(1, 100) * 0.01;
    const auto a = contact_arc({blank, roller, depth});
    const double half_chord = std::sqrt(blank * blank - a.chord_mm * a.chord_mm);
    const double along = blank + roller - depth - a.chord_mm;
    RC_ASSERT(std::abs(std::hypot(half_chord, along) - roller) < 1e-9);
    RC_ASSERT(contact_arc({blank + 1, roller, depth}).arc_mm > a.arc_mm);
    RC_ASSERT(contact_arc({blank, roller + 1, depth}).arc_mm > a.arc_mm);
    const double small = contact_arc({blank, roller, 1e-8}).arc_mm;
    RC_ASSERT(std::abs(small / std::sqrt(2e-8 * roller * blank / (roller + blank)) - 1) < 1e-6);
  });
  CHECK(contact_arc({35, 50, 0}).arc_mm == 0);
}

TEST_CASE("K407: a sequence of ridges displaces what the ridges before left", "[K407]") {
  RidgeSequence in{tr80, {1.4346, 0.8695, 0.4347, 0.1739}, 2.17363, 37.6736, 52.5, 2};
  const auto out = turn_sequence(in);
  CHECK(out.layer_mm == Approx(0.25).margin(5e-3));
  CHECK(out.contact_area_mm2 == Approx(119).margin(0.5));
  CHECK(out.displaced_mm2[0] == Approx(sunk(tr80, out.depth_mm[0]).area_mm2).epsilon(1e-12));
  for (double f : out.displaced_mm2) CHECK(f > 0);
  CHECK(rolling_radial_force({out.layer_mm, out.perimeter_mean_mm, out.arc_mean_mm, out.sizing_perimeter_mm})
            .radial_kn == Approx(69.6).margin(0.1));
}

TEST_CASE("K407: force at middle and corners, growing with every argument", "[K407]") {
  CHECK(rolling_radial_force({0.15, 13, 7.5, 33}).radial_kn == Approx(110.67).margin(0.005));
  CHECK(rolling_radial_force({0.05, 6, 5, 10}).radial_kn == Approx(32.92).margin(0.005));
  const auto high = rolling_radial_force({0.25, 20, 10, 56});
  CHECK(high.radial_kn == Approx(213.94).margin(0.005));
  CHECK(high.in_range);
  CHECK_FALSE(rolling_radial_force({0.25, 20, 10, 56.01}).in_range);
  const double base = rolling_radial_force({0.15, 13, 7.5, 33}).radial_kn;
  CHECK(rolling_radial_force({0.16, 13, 7.5, 33}).radial_kn > base);
  CHECK(rolling_radial_force({0.15, 14, 7.5, 33}).radial_kn > base);
  CHECK(rolling_radial_force({0.15, 13, 8, 33}).radial_kn > base);
  CHECK(rolling_radial_force({0.15, 13, 7.5, 34}).radial_kn > base);
  CHECK(rolling_radial_force({0.15, 13, 7.5, 33, 18.8}).radial_kn == Approx(2 * base).epsilon(1e-14));
}

TEST_CASE("K407: strength of rolled threads covers the measured ratio", "[K407]") {
  const auto bending = rolled_thread_strength({StrengthProperty::bending_fatigue});
  CHECK((127.0 / 45 > bending.low && 127.0 / 45 < bending.high));
}

TEST_CASE("K407: bad input names itself", "[K407]") {
  CHECK_THROWS_WITH(turn_sequence({tr80, {0.5, 0.8}, 2.0, 37, 52, 2}),
                    "K407.turn_sequence: drop_mm = 0.8, must be below the drop of the ridge before");
  CHECK_THROWS_WITH(
      calibrating_penetration({m12, 2.0, 0, 9.853}),
      "K407.calibrating_penetration: profile_height_mm = 2, makes neighbouring ridges overlap: the width "
      "at the full depth must not be above the pitch");
  CHECK_THROWS_WITH(contact_arc({20, 5, 6}),
                    "K407.contact_arc: H_mm = 6, makes the contact angle of the roller exceed 90 deg");
  CHECK_THROWS_WITH(
      extrusion_height({1, 1, 0.5, 0.2}),
      "K407.extrusion_height: F_mm2 = 0.2, overfills the profile: must not be above (A - B H)^2 / (2 B)");
}
