// The checks of card S3; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/s3_rk_profile_cutter.h"

using namespace verstat::models;
using namespace verstat::models::s3;

namespace {

constexpr double rad = std::numbers::pi / 180;

RkCutter cutter(double rf_mm, double e_mm = 3.4, std::int64_t lobes = 3) {
  RkCutter c;
  c.eccentricity_mm = e_mm;
  c.lobes = lobes;
  c.cutter_radius_mm = rf_mm;
  return c;
}
RkUniformCutter uniform(const RkCutter& c, std::int64_t teeth, double first_deg = 180) {
  return {c, teeth, first_deg};
}
double worst(const RkCutter& c, std::int64_t teeth, double first_deg = 180) {
  return rk_form_error_uniform(uniform(c, teeth, first_deg)).max_deviation_mm.value();
}
RkToothPair pair(const RkCutter& c, double first_deg, double second_deg) {
  return {c, first_deg, second_deg};
}
RkTolerance tolerance(const RkCutter& c, double t_mm, double first_deg = 180) {
  return {c, t_mm, first_deg};
}

// A cutter between its limits, N = 2..5.
RkCutter any_cutter() {
  const std::int64_t lobes = *rc::gen::inRange<std::int64_t>(2, 6);
  const double n = static_cast<double>(lobes);
  const double e_mm = 40 / (n * n - 1) * *rc::gen::inRange(0, 60) * 0.01;
  RkHole hole;
  hole.eccentricity_mm = e_mm;
  hole.lobes = lobes;
  const RkRadiusLimits limits = rk_cutter_radius_limits(hole);
  RC_PRE(limits.max_cutter_radius_mm > limits.min_cutter_radius_mm + 0.5);
  const double share = *rc::gen::inRange(30, 98) * 0.01;
  return cutter(
      limits.min_cutter_radius_mm + share * (limits.max_cutter_radius_mm - limits.min_cutter_radius_mm), e_mm,
      lobes);
}

}  // namespace

TEST_CASE("S3: Table 1 within 8 %, Table 2 at 18, 24 and 25 within 6 %", "[S3]") {
  const std::vector<std::pair<std::int64_t, double>> table1 = {
      {10, 0.82}, {15, 0.77}, {20, 0.218}, {30, 0.11}, {40, 0.075}};
  for (const auto& [teeth, printed_mm] : table1)
    CHECK(worst(cutter(24), teeth) == Approx(printed_mm).epsilon(0.08));
  CHECK(worst(cutter(18), 20) == Approx(3.3).epsilon(0.06));
  CHECK(worst(cutter(24), 20) == Approx(0.22).epsilon(0.06));
  CHECK(worst(cutter(25), 20) == Approx(0.16).epsilon(0.06));
  // The two columns that do not come out.
  CHECK(worst(cutter(20), 20) == Approx(0.836).margin(1e-3));
  CHECK(worst(cutter(22), 20) == Approx(0.385).margin(1e-3));
}

TEST_CASE("S3: phase of uniform teeth", "[S3]") {
  for (const auto& [teeth, tip_mm, flat_mm] :
       {std::tuple{20, 0.223, 0.223}, std::tuple{21, 0.206, 0.459}, std::tuple{22, 0.192, 0.192}}) {
    CHECK(worst(cutter(24), teeth, 0) == Approx(tip_mm).margin(6e-4));
    CHECK(worst(cutter(24), teeth, 180) == Approx(flat_mm).margin(6e-4));
  }
}

TEST_CASE("S3: the algorithm lists 21 positions for 0.2 mm, with the printed pitches", "[S3]") {
  const RkToothPositions p = rk_tooth_positions(tolerance(cutter(24), 0.2));
  CHECK(p.positions_listed == 21);
  CHECK(p.teeth == 20);
  const std::vector<double> pitches = {8.7,  8.9,  9.3,  10.0, 11.0, 12.6, 15.2, 19.9, 32.5, 91.2,
                                       39.8, 21.6, 16.0, 13.1, 11.3, 10.2, 9.4,  9.0,  8.7,  8.7};
  REQUIRE(p.parameter_pitches_deg.size() == pitches.size());
  for (std::size_t k = 0; k < pitches.size(); ++k)
    CHECK(p.parameter_pitches_deg[k] == Approx(pitches[k]).margin(0.051));
  CHECK(p.parameter_angles_deg.back() == Approx(366.8).margin(0.051));
  CHECK(p.closing_cusp_mm.value() == Approx(0.010).margin(5e-4));
  CHECK(rk_tooth_positions(tolerance(cutter(24), 0.2, 0)).teeth == 19);
  CHECK(rk_equalised_cutter(uniform(cutter(24), 19, 0)).equal_deviation_mm == Approx(0.1998).margin(5e-5));
}

TEST_CASE("S3: equalising gain and minimum teeth of the card", "[S3]") {
  CHECK(rk_equalised_cutter(uniform(cutter(24), 20)).equal_deviation_mm == Approx(0.1805).margin(5e-5));
  CHECK(rk_equalised_cutter(uniform(cutter(24), 24)).equal_deviation_mm == Approx(0.1258).margin(5e-5));
  CHECK(worst(cutter(24), 24) == Approx(0.167).margin(5e-4));
  for (const auto& [rf_mm, even, equal] : {std::tuple{18.0, 75, 53}, std::tuple{20.0, 41, 34},
                                           std::tuple{22.0, 28, 25}, std::tuple{24.0, 22, 20}}) {
    CHECK(rk_min_teeth({tolerance(cutter(rf_mm), 0.2), Spacing::uniform}).teeth == even);
    CHECK(rk_min_teeth({tolerance(cutter(rf_mm), 0.2), Spacing::equalised}).teeth == equal);
  }
}

TEST_CASE("S3: radius limits", "[S3]") {
  const RkRadiusLimits limits = rk_cutter_radius_limits({});
  CHECK(limits.min_cutter_radius_mm == Approx(15.6));
  CHECK(limits.max_cutter_radius_mm == Approx(24.5137).margin(5e-5));
  RkHole round;
  round.eccentricity_mm = 0;
  CHECK(rk_cutter_radius_limits(round).max_cutter_radius_mm == Approx(40));
  // The tooth angle grows with t below the limit and turns back at the lobe tip above it.
  CHECK(rc::check([] {
    RkCutterAtNormal in;
    static_cast<RkCutter&>(in) = any_cutter();
    const auto angle = [&](double t_deg) {
      in.normal_angle_deg = t_deg;
      return rk_cutter_point(in).tooth_angle_deg;
    };
    for (double t_deg = 0; t_deg < 180.0 / static_cast<double>(in.lobes); t_deg += 0.5)
      RC_ASSERT(angle(t_deg + 0.5) > angle(t_deg));
    const double n = static_cast<double>(in.lobes);
    in.cutter_radius_mm = rk_cutter_radius_limits(in).max_cutter_radius_mm * 1.001;
    if (in.cutter_radius_mm >= in.mean_radius_mm - (n - 1) * in.eccentricity_mm) return;
    RC_ASSERT(angle(1e-3) < angle(0));
  }));
}

TEST_CASE("S3: the largest cusp is the largest distance from the profile to all tracks (brute force)",
          "[S3]") {
  CHECK(rc::check([] {
    const RkCutter c = any_cutter();
    const double n = static_cast<double>(c.lobes);
    const std::int64_t teeth = *rc::gen::inRange<std::int64_t>(14, 40);
    const double first_deg = *rc::gen::inRange(0, 360);
    const auto answer = rk_form_error_uniform(uniform(c, teeth, first_deg)).max_deviation_mm;
    RC_PRE(answer.has_value());
    // Union of all tooth tracks over one lobe, as the farthest reach per polar angle cell.
    constexpr int cells = 2000;
    const double lobe = 2 * std::numbers::pi / n;
    std::vector<double> reach(cells, 0.0);
    const double a_mm = c.mean_radius_mm - c.cutter_radius_mm;
    for (std::int64_t k = 0; k < teeth; ++k) {
      const double theta = (first_deg + 360.0 * static_cast<double>(k) / static_cast<double>(teeth)) * rad;
      // The tooth radius from the conjugate cutter: bisect t on the tooth angle.
      RkCutterAtNormal at;
      static_cast<RkCutter&>(at) = c;
      double low = theta / n - lobe / 2, high = theta / n + lobe / 2;
      for (int i = 0; i < 60; ++i) {
        at.normal_angle_deg = 0.5 * (low + high) / rad;
        (rk_cutter_point(at).tooth_angle_deg < theta / rad ? low : high) = 0.5 * (low + high);
      }
      const double rho_mm = rk_cutter_point(at).tooth_radius_mm;
      // Every crossing of the track with the ray of a cell, between neighbouring samples.
      constexpr int samples = 8'000;
      double polar_before = 0, r_before = 0;
      for (int i = 0; i <= samples; ++i) {
        const double g = 2 * std::numbers::pi * i / samples;
        const double psi = theta - n * g;
        const double x = a_mm * std::cos(g) + rho_mm * std::cos(g + psi);
        const double y = a_mm * std::sin(g) + rho_mm * std::sin(g + psi);
        const double r = std::hypot(x, y);
        const double polar = std::atan2(y, x);
        if (i > 0 && std::abs(polar - polar_before) < 1) {
          const double from = std::min(polar, polar_before) / lobe * cells;
          const double to = std::max(polar, polar_before) / lobe * cells;
          for (double cell = std::ceil(from); cell <= to; ++cell) {
            const double share = (cell * lobe / cells - polar_before) / (polar - polar_before);
            double& best = reach[static_cast<std::size_t>(static_cast<int>(cell) + 10 * cells) % cells];
            best = std::max(best, r_before + share * (r - r_before));
          }
        }
        polar_before = polar;
        r_before = r;
      }
    }
    double worst_mm = 0;
    for (int i = 0; i < cells; ++i) {
      const double polar = lobe * i / cells;
      // Profile radius at the polar angle by bisection on the normal angle.
      RkHoleAtNormal hole;
      static_cast<RkHole&>(hole) = c;
      double low = polar - 1.2, high = polar + 1.2;
      RkProfilePoint p{};
      for (int j = 0; j < 32; ++j) {
        hole.normal_angle_deg = 0.5 * (low + high) / rad;
        p = rk_profile_point(hole);
        const double off = std::remainder(std::atan2(p.y_mm, p.x_mm) - polar, 2 * std::numbers::pi);
        (off < 0 ? low : high) = 0.5 * (low + high);
      }
      RC_ASSERT(reach[static_cast<std::size_t>(i)] < p.r_mm + 1e-4);  // no track passes outside
      worst_mm = std::max(worst_mm, p.r_mm - reach[static_cast<std::size_t>(i)]);
    }
    // The peak of a cusp falls between two cells.
    RC_ASSERT(worst_mm < *answer + 1e-4);
    RC_ASSERT(worst_mm > 0.96 * *answer - 1e-4);
  }));
}

TEST_CASE("S3: the tolerance is reached at the smallest pitch, against the plain scan", "[S3]") {
  CHECK(rc::check([] {
    const RkCutter c = any_cutter();
    const double first_deg = *rc::gen::inRange(0, 360);
    const double t_mm = *rc::gen::inRange(1, 40) * 0.02;
    const RkToothPositions p = rk_tooth_positions(tolerance(c, t_mm, first_deg));
    double theta = first_deg;
    for (std::size_t k = 1; k < p.tooth_angles_deg.size(); ++k) {
      const double next = first_deg + p.tooth_angles_deg[k];
      for (double d = 0.25; theta + d < next - 1e-6; d += 0.25) {
        const auto height = rk_cusp(pair(c, theta, theta + d)).cusp_height_mm;
        RC_ASSERT(height.has_value() && *height < t_mm);
      }
      const auto before = rk_cusp(pair(c, theta, next - 1e-7)).cusp_height_mm;
      const auto after = rk_cusp(pair(c, theta, next + 1e-7)).cusp_height_mm;
      RC_ASSERT(before.has_value() && *before < t_mm);
      RC_ASSERT(!after.has_value() || *after >= t_mm);
      theta = next;
    }
  }));
}

TEST_CASE("S3: equalised cusps are equal all the way round", "[S3]") {
  const RkEqualisedCutter e = rk_equalised_cutter(uniform(cutter(23), 24, 30));
  for (std::size_t k = 0; k < e.tooth_angles_deg.size(); ++k) {
    const double from = 30 + e.tooth_angles_deg[k];
    const double to = k + 1 < e.tooth_angles_deg.size() ? 30 + e.tooth_angles_deg[k + 1] : 390;
    CHECK(rk_cusp(pair(cutter(23), from, to)).cusp_height_mm.value() ==
          Approx(e.equal_deviation_mm).epsilon(1e-8));
  }
}

TEST_CASE("S3: without eccentricity cusps are equal and follow s^2/8 (1/R_track - 1/R)", "[S3]") {
  const RkCutter round = cutter(24, 0);
  const auto [most, least] = rk_form_error_uniform(uniform(round, 200));
  CHECK(most.value() == Approx(least.value()).epsilon(1e-7));
  const double pitch_radius_mm = 1.5 * 16;
  const double c_mm = 40 - pitch_radius_mm;
  const double track_mm = c_mm - 1 / (1 / c_mm + 2 / pitch_radius_mm);
  CHECK(track_mm == Approx(9.14).margin(5e-3));
  const RkCusp small = rk_cusp(pair(round, 0, 1.8));
  const double s_mm = small.contact_pitch_mm;
  CHECK(small.cusp_height_mm.value() == Approx(s_mm * s_mm / 8 * (1 / track_mm - 1.0 / 40)).epsilon(2e-3));
}

TEST_CASE("S3: cusps are symmetric about lobe tip and flat and fall as 1/Z^2", "[S3]") {
  CHECK(rc::check([] {
    const RkCutter c = any_cutter();
    const double from = *rc::gen::inRange(-180, 340);
    const double pitch = *rc::gen::inRange(2, 14);
    const auto here = rk_cusp(pair(c, from, from + pitch)).cusp_height_mm;
    const auto there = rk_cusp(pair(c, -from - pitch, -from)).cusp_height_mm;
    RC_ASSERT(here.has_value() == there.has_value());
    if (here) RC_ASSERT(std::abs(*here - *there) < 1e-9);
  }));
  CHECK(worst(cutter(20), 400) == Approx(worst(cutter(20), 200) / 4).epsilon(0.02));
}

TEST_CASE("S3: grades of Tables 1 and 2 by the 60 % rule", "[S3]") {
  const std::vector<std::pair<double, int>> rows = {{0.82, 16}, {0.77, 16}, {0.11, 11}, {3.3, 17},
                                                    {0.38, 14}, {0.31, 14}, {0.16, 12}, {0.218, 13},
                                                    {0.22, 13}, {0.075, 11}};
  for (const auto& [deviation_mm, grade] : rows)
    CHECK(it_grade_for_deviation({deviation_mm, 80}).it_grade == grade);
  CHECK(it_grade_for_deviation({0.0066, 18}).it_grade == 6);
  CHECK(it_grade_for_deviation({0.0066, 18.001}).it_grade == 6);
  CHECK(it_grade_for_deviation({0.0067, 18}).it_grade == 7);
}

TEST_CASE("S3: the cutting speed is the speed of the tooth against the profile", "[S3]") {
  // Finite difference of the track in the frame of the hole, at the contact.
  CHECK(rc::check([] {
    RkCutterAtNormal at;
    static_cast<RkCutter&>(at) = any_cutter();
    at.normal_angle_deg = *rc::gen::inRange(0, 360) + 0.3;
    const RkCutterPoint p = rk_cutter_point(at);
    const double n = static_cast<double>(at.lobes);
    const double a_mm = at.mean_radius_mm - at.cutter_radius_mm;
    const auto place = [&](double g) {
      const double angle = p.tooth_angle_deg * rad - (n - 1) * g;
      return std::pair{a_mm * std::cos(g) + p.tooth_radius_mm * std::cos(angle),
                       a_mm * std::sin(g) + p.tooth_radius_mm * std::sin(angle)};
    };
    const double g = p.centre_line_angle_deg * rad, h = 1e-6;
    const auto [x1, y1] = place(g - h);
    const auto [x2, y2] = place(g + h);
    const double per_turn_m = 2 * std::numbers::pi * std::hypot(x2 - x1, y2 - y1) / (2 * h) / 1000;
    RkCutting cutting;
    static_cast<RkCutterAtNormal&>(cutting) = at;
    cutting.work_speed_rpm = 100;
    RC_ASSERT(std::abs(rk_cutting_kinematics(cutting).cutting_speed_m_min - 100 * per_turn_m) < 1e-5);
  }));
}

TEST_CASE("S3: bad input names itself", "[S3]") {
  CHECK_THROWS_WITH(rk_cusp(pair(cutter(24), 20, 10)),
                    "S3.rk_cusp: tooth1_angle_deg = 20, must be below tooth2_angle_deg");
  CHECK_THROWS_WITH(rk_cusp(pair(cutter(24, 6), 10, 20)),
                    Catch::Contains("eccentricity_mm = 6, must be below"));
  CHECK_THROWS_WITH(rk_cusp(pair(cutter(34), 10, 20)), Catch::Contains("the normals miss the pitch circle"));
  CHECK_THROWS_WITH(rk_equalised_cutter(uniform(cutter(18), 2)), Catch::Contains("too few"));
  // Below the smallest radius the teeth near the flat cut nothing.
  CHECK_THROWS_WITH(rk_tooth_positions(tolerance(cutter(13), 0.2)),
                    Catch::Contains("below its smallest value"));
  CHECK_THROWS_WITH(rk_min_teeth({tolerance(cutter(24), 1e-9), Spacing::uniform}),
                    Catch::Contains("more than 2000 teeth"));
}
