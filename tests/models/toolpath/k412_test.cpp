// The checks of card K412; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/toolpath/k412_straightening_roll.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k412;

namespace {

constexpr double degree = std::numbers::pi / 180;

double part(double low, double high) {  // one of 1000 steps between
  return low + (high - low) * *rc::gen::inRange(0, 1000) * 1e-3;
}

// The worked example: throat 200, pipe 60, 30 deg, half length 120.
ProfileSampling sampling(std::int64_t points) {
  ProfileSampling s;
  s.throat_diameter_mm = 200;
  s.pipe_diameter_mm = 60;
  s.crossing_angle_deg = 30;
  s.half_length_mm = 120;
  s.n_points = points;
  return s;
}

RollContour example_contour() {
  return roll_contour({sampling(121), 12, 12});
}

RoughTurning example_roughing() {
  const RollContour contour = example_contour();
  return {contour, 265, 0.8, 0.3, 3, 0.4, 90, 800, 3, 3, 4000};
}

Contour arc(double radius_mm, double half_angle, int half_points) {
  Contour c;
  for (int k = -half_points; k <= half_points; ++k) {
    const double t = half_angle * k / half_points;
    c.y_mm.push_back(radius_mm * std::sin(t));
    c.x_radius_mm.push_back(100 + radius_mm * (1 - std::cos(t)));
  }
  return c;
}

}  // namespace

TEST_CASE("K412: the table of the profile", "[K412]") {
  struct Row {
    double phi, x, y;
  };
  for (const Row row : {Row{90, 200, 0}, Row{85, 200.802, 18.368}, Row{80, 203.241, 36.988},
                        Row{70, 213.494, 76.104}, Row{65, 221.755, 97.269}, Row{55, 246.589, 145.144}}) {
    const ProfilePoint p = roll_profile_point({{200, 60, 30}, row.phi});
    CHECK(p.diameter_mm == Approx(row.x).margin(6e-4));
    CHECK(p.y_mm == Approx(row.y).margin(6e-4));
  }
}

TEST_CASE("K412: the roll touches its pipe in every section", "[K412]") {
  verstat::test::property([] {
    ProfileSampling s;
    s.throat_diameter_mm = part(80, 400);
    s.pipe_diameter_mm = part(10, 200);
    s.crossing_angle_deg = part(20, 60);
    s.half_length_mm = part(20, 200);
    s.n_points = 21;
    const RollGap gap = roll_pipe_gap({roll_profile(s), s.pipe_diameter_mm, s.crossing_angle_deg,
                                       (s.throat_diameter_mm + s.pipe_diameter_mm) / 2});
    RC_ASSERT(std::abs(gap.gap_min_mm) < 1e-6);
    RC_ASSERT(std::abs(gap.gap_max_mm) < 1e-6);
  });
}

TEST_CASE("K412: the profile grows from the throat, is symmetric, and phi is its inverse", "[K412]") {
  verstat::test::property([] {
    const RollAndPipe roll{part(80, 400), part(10, 200), part(5, 89)};
    const double phi = part(10, 89);
    const ProfilePoint here = roll_profile_point({roll, phi});
    const ProfilePoint further = roll_profile_point({roll, phi - 1});
    RC_ASSERT(further.diameter_mm > here.diameter_mm);
    RC_ASSERT(further.y_mm > here.y_mm);
    RC_ASSERT(std::abs(roll_phi_at_y({roll, here.y_mm}).phi_deg - phi) < 1e-9);
    RC_ASSERT(roll_phi_at_y({roll, -here.y_mm}).phi_deg == roll_phi_at_y({roll, here.y_mm}).phi_deg);
  });
  const RollProfile p = roll_profile(sampling(7));
  for (std::size_t k = 0; k < 7; ++k) {
    CHECK(p.y_mm[k] == -p.y_mm[6 - k]);
    CHECK(p.x_radius_mm[k] == p.x_radius_mm[6 - k]);
  }
  CHECK(roll_phi_at_y({{200, 60, 90}, 15}).phi_deg == Approx(60));
}

TEST_CASE("K412: limits of a thin pipe and of a right angle, and the curvature at the throat", "[K412]") {
  const ProfilePoint hyperboloid = roll_profile_point({{200, 1e-9, 30}, 50});
  CHECK(hyperboloid.diameter_mm / 2 ==
        Approx(std::hypot(100, hyperboloid.y_mm * std::tan(30 * degree))).epsilon(1e-9));
  const ProfilePoint groove = roll_profile_point({{200, 60, 90}, 50});  // circle about (y 0, x 130)
  CHECK(std::hypot(groove.y_mm, 130 - groove.diameter_mm / 2) == Approx(30).epsilon(1e-12));
  ProfileSampling fine = sampling(3);
  fine.half_length_mm = 0.5;
  const RollProfile throat = roll_profile(fine);
  CHECK(0.5 * 0.5 / (2 * (throat.x_radius_mm[2] - 100)) ==
        Approx(throat.throat_curvature_radius_mm).epsilon(1e-4));
}

TEST_CASE("K412: the gap is the distance of the pipe surface, by brute force", "[K412]") {
  verstat::test::property([] {
    const double y = part(-150, 150);
    const double radius = part(50, 200);
    const double alpha = part(5, 90);
    const double distance = radius + part(0, 80);
    const RollGap gap = roll_pipe_gap({{{y, y + 1}, {radius, radius}}, 40, alpha, distance});
    double nearest = 1e300;
    for (int k = -9000; k <= 9000; ++k) {
      const double t = k * 0.01 * degree;
      nearest = std::min(nearest, std::hypot(radius * std::cos(t) - distance,
                                             radius * std::cos(alpha * degree) * std::sin(t) -
                                                 y * std::sin(alpha * degree)));
    }
    RC_ASSERT(std::abs(gap.gap_mm[0] - (nearest - 20)) < 2e-2);
    RC_ASSERT(gap.gap_mm[0] <= nearest - 20 + 1e-9);
  });
}

TEST_CASE("K412: the existing roll on other pipes", "[K412]") {
  const RollProfile roll = roll_profile(sampling(121));
  const RollFit thin = roll_pipe_fit({roll, 50, 25, 35});
  CHECK(thin.alpha_deg == Approx(29.41).margin(0.01));
  CHECK(thin.gap_max_mm == Approx(0.013).margin(6e-4));
  const RollFit thick = roll_pipe_fit({roll, 68, 25, 35});
  CHECK(thick.alpha_deg == Approx(30.47).margin(0.01));
  CHECK(thick.gap_max_mm == Approx(0.010).margin(6e-4));
  const RollFit own = roll_pipe_fit({roll, 60, 25, 35});
  CHECK(own.alpha_deg == Approx(30).margin(1e-3));
  CHECK(own.centre_distance_mm == Approx(130).margin(1e-6));
  // No other angle on a fine grid is better.
  const RollProfile coarse = roll_profile(sampling(13));
  const RollFit best = roll_pipe_fit({coarse, 50, 25, 35});
  for (double alpha = 25; alpha <= 35; alpha += 0.05)
    CHECK(roll_pipe_fit({coarse, 50, alpha, alpha}).gap_max_mm >= best.gap_max_mm - 1e-9);
}

TEST_CASE("K412: the fillet is tangent to the last chord and to the face", "[K412]") {
  verstat::test::property([] {
    const ProfileEnd end{part(50, 200), part(100, 150), part(30, 49), part(50, 100), part(1, 20)};
    const EndFillet f = roll_end_fillet(end);
    const double along = (f.y_c_mm - end.y_k_mm) * (end.y_k_mm - end.y_k1_mm) +
                         (f.x_c_mm - end.x_k_mm) * (end.x_k_mm - end.x_k1_mm);
    RC_ASSERT(std::abs(along) < 1e-9);
    RC_ASSERT(std::abs(std::hypot(f.y_c_mm - end.y_k_mm, f.x_c_mm - end.x_k_mm) / end.fillet_radius_mm - 1) <
              1e-12);
    RC_ASSERT(f.max_diameter_mm >= 2 * end.x_k_mm);
  });
  const RollContour c = example_contour();
  CHECK(c.length_mm == Approx(286.53).margin(6e-3));
  CHECK(c.max_diameter_mm == Approx(233.30).margin(6e-3));
  CHECK(c.length_mm == path_length(c).length_mm);
}

TEST_CASE("K412: the offset of a concave arc has the radius less the offset", "[K412]") {
  const Contour concave = arc(50, 0.6, 30);
  const Contour moved = offset_contour({concave, 5});
  for (std::size_t k = 1; k + 1 < moved.y_mm.size(); ++k)
    CHECK(std::hypot(moved.y_mm[k], 150 - moved.x_radius_mm[k]) ==
          Approx(50 - 5 / std::cos(0.6 / 60)).epsilon(1e-12));
}

TEST_CASE("K412: surface speed without cap, with a low cap, and across it", "[K412]") {
  const RollProfile roll = roll_profile(sampling(61));
  const auto minutes = [&](double max_rpm) {
    return contour_pass_time({roll, 0.2, 140, max_rpm}).main_time_min;
  };
  double integral = 0;  // of D ds
  for (std::size_t k = 1; k < roll.y_mm.size(); ++k)
    integral += (roll.x_radius_mm[k] + roll.x_radius_mm[k - 1]) *
                std::hypot(roll.y_mm[k] - roll.y_mm[k - 1], roll.x_radius_mm[k] - roll.x_radius_mm[k - 1]);
  CHECK(minutes(1e9) == Approx(std::numbers::pi * integral / (1000 * 140 * 0.2)).epsilon(1e-12));
  CHECK(minutes(1e-3) == Approx(path_length(roll).length_mm / (0.2 * 1e-3)).epsilon(1e-12));
  verstat::test::property([] {
    // A cone across the cap: sum of many short pieces.
    const double max_rpm = part(100, 1000);
    const Contour cone{{0, 60}, {part(0, 40), part(41, 90)}};
    double sum = 0;
    constexpr int pieces = 20000;
    for (int k = 0; k < pieces; ++k) {
      const double radius =
          cone.x_radius_mm[0] + (cone.x_radius_mm[1] - cone.x_radius_mm[0]) * (k + 0.5) / pieces;
      sum += 1 / std::min(max_rpm, 1000 * 120 / (2 * std::numbers::pi * radius));
    }
    const double length = std::hypot(60, cone.x_radius_mm[1] - cone.x_radius_mm[0]);
    const double minutes_here = contour_pass_time({cone, 0.2, 120, max_rpm}).main_time_min;
    RC_ASSERT(std::abs(minutes_here / (sum * length / pieces / 0.2) - 1) < 1e-7);
    RC_ASSERT(contour_pass_time({cone, 0.25, 120, max_rpm}).main_time_min < minutes_here);
    RC_ASSERT(contour_pass_time({cone, 0.2, 130, max_rpm}).main_time_min <= minutes_here);
    RC_ASSERT(contour_pass_time({cone, 0.2, 120, max_rpm * 1.1}).main_time_min <= minutes_here);
  });
}

TEST_CASE("K412: the worked example of roughing, finishing, facing and grinding", "[K412]") {
  const RoughPlan plan = rough_turning_plan(example_roughing());
  CHECK(plan.cylinder_passes == 5);
  CHECK(plan.cylinder_depth_mm == Approx(2.953).margin(6e-4));
  CHECK(plan.contour_passes == 6);
  CHECK(plan.contour_depth_mm == Approx(2.773).margin(6e-4));
  constexpr std::array lengths{120.5, 162.2, 195.5, 224.7, 252.3, 289.8};
  REQUIRE(plan.contour_lengths_mm.size() == lengths.size());
  for (std::size_t k = 0; k < lengths.size(); ++k)
    CHECK(plan.contour_lengths_mm[k] == Approx(lengths[k]).margin(0.06));
  CHECK(plan.cut_length_mm == Approx(2635.8).margin(0.06));
  CHECK(plan.main_time_min == Approx(54.79).margin(6e-3));
  CHECK(plan.cylinder_time_min == Approx(30.73).margin(6e-3));
  CHECK(plan.rapid_time_min == Approx(0.63).margin(6e-3));
  CHECK(plan.removed_cm3 == Approx(5070).margin(0.6));
  const Contour finish = offset_contour({example_contour(), 0.3});
  CHECK(contour_pass_time({finish, 0.2, 140, 1200}).main_time_min == Approx(6.90).margin(6e-3));
  CHECK(facing_time({265, 0, 4, 2, 0.3, 90, 800, 3}).main_time_min == Approx(4.35).margin(6e-3));
  CHECK(dressing_radius_for_wheel({40, 0.3, 1.2, 420}).radius_mm == Approx(239.2).margin(0.06));
}

TEST_CASE("K412: bookkeeping of the roughing plan", "[K412]") {
  verstat::test::property([] {
    RoughTurning in = example_roughing();
    in.blank_diameter_mm = part(240, 400);
    in.max_depth_mm = part(0.5, 6);
    const RoughPlan plan = rough_turning_plan(in);
    const Contour base = offset_contour({in, 1.1});
    const double extent = base.y_mm.back() - base.y_mm.front();
    const double blank_cm3 =
        std::numbers::pi / 4 * in.blank_diameter_mm * in.blank_diameter_mm * extent / 1000;
    RC_ASSERT(std::abs(plan.removed_cm3 + revolve_volume(base).volume_cm3 - blank_cm3) < 1e-9 * blank_cm3);
    RoughTurning deeper = in;
    deeper.max_depth_mm *= 1.3;
    RC_ASSERT(rough_turning_plan(deeper).cylinder_passes <= plan.cylinder_passes);
    RC_ASSERT(rough_turning_plan(deeper).contour_passes <= plan.contour_passes);
    // Without cap phase 1 is proportional to the mean diameter before the cuts.
    in.max_rpm = 1e9;
    const auto passes = static_cast<double>(plan.cylinder_passes);
    const double mean = in.blank_diameter_mm - plan.cylinder_depth_mm * (passes - 1);
    RC_ASSERT(std::abs(rough_turning_plan(in).cylinder_time_min /
                           (passes * (extent + 6) * std::numbers::pi * mean / (1000 * 90 * 0.4)) -
                       1) < 1e-9);
  });
}

TEST_CASE("K412: dressing radius depends on the spacing, the wheel criterion does not", "[K412]") {
  const auto at_spacing = [](double spacing, DressingVariant variant) {
    const RollProfile roll =
        roll_profile(sampling(static_cast<std::int64_t>(std::lround(240 / spacing)) + 1));
    return dressing_radius({roll, 0.3, 1.2, variant, true});
  };
  struct Row {
    double spacing, radius;
  };
  for (const Row row : {Row{20, 355}, Row{10, 239}, Row{5, 104}, Row{2.5, 32}})
    CHECK(at_spacing(row.spacing, DressingVariant::tangent).radius_mm == Approx(row.radius).margin(0.6));
  CHECK(at_spacing(0.02, DressingVariant::tangent).radius_mm == Approx(0.18).margin(0.01));
  CHECK(at_spacing(10, DressingVariant::printed).radius_mm == Approx(39e3).epsilon(0.02));
  CHECK(at_spacing(20, DressingVariant::printed).radius_mm == 1e9);
  verstat::test::property([] {
    const double spacing = part(1, 20);
    const double stock = part(0.05, 1);
    Contour straight;
    for (int k = 0; k < 7; ++k) {
      straight.y_mm.push_back(k * spacing);
      straight.x_radius_mm.push_back(100);
    }
    const double expected = (4 * spacing * spacing + 1.44 * stock * stock) / (2 * 1.2 * stock);
    const DressingRadius r = dressing_radius({straight, stock, 1.2});
    RC_ASSERT(std::abs(r.radius_mm / expected - 1) < 1e-9);
    RC_ASSERT(r.index == 1);
  });
}

TEST_CASE("K412: the wheel of the dressing criterion touches over its width", "[K412]") {
  verstat::test::property([] {
    const double width = part(10, 100);
    const double allowance = part(0.05, 0.5);
    const double profile = part(100, 1000);
    const double radius = dressing_radius_for_wheel({width, allowance, 1.2, profile}).radius_mm;
    RC_ASSERT(radius < profile);
    RC_ASSERT(
        std::abs(2 * wheel_contact_half_width({radius, profile, 1.2 * allowance}).half_width_mm / width - 1) <
        1e-9);
    const double feed = grinding_feed_for_scallop({radius, profile, 0.5}).feed_mm_rev;
    RC_ASSERT(grinding_feed_for_scallop({radius * 1.01, profile, 0.5}).feed_mm_rev > feed);
    RC_ASSERT(std::abs(feed * feed / 8 * (1 / radius - 1 / profile) - 0.5e-3) < 1e-12);
  });
  CHECK(wheel_contact_half_width({500, 420, 0.3}).half_width_mm == 1e9);
}

TEST_CASE("K412: NC text rounds, numbers and leaves no minus zero", "[K412]") {
  const Program p = gcode_contour({{{-0.0004, 5}, {10, 10.12345}}, 0.15, 99.5, 2000.4, 7, 1.5, 42});
  const std::vector<std::string> expected{"%",
                                          "O0042",
                                          "N10 G21 G18 G40 G95",
                                          "N20 T0707",
                                          "N30 G50 S2000",
                                          "N40 G96 S100 M03",
                                          "N50 G00 X23.000 Z-1.500",
                                          "N60 G01 X20.000 Z0.000 F0.150",
                                          "N70 G01 X20.247 Z5.000",
                                          "N80 G00 X23.247",
                                          "N90 M05",
                                          "N100 M30",
                                          "%"};
  CHECK(p.lines == expected);
}

TEST_CASE("K412: bad input names itself", "[K412]") {
  CHECK_THROWS_WITH(path_length({{0, 2, 1}, {5, 5, 5}}),
                    "K412.path_length: y_mm/2 = 1, must not be below the point before it");
  CHECK_THROWS_WITH(path_length({{0, 2, 2}, {5, 6, 6}}), Catch::Contains("neighbouring points must differ"));
  CHECK_THROWS_WITH(path_length({{0, 2, 2}, {5, 6}}), Catch::Contains("must have as many as y_mm, 3"));
  CHECK_THROWS_WITH(roll_phi_at_y({{200, 60, 90}, 30}),
                    Catch::Contains("y_mm = 30, must stay within half the pipe diameter"));
  RoughTurning small = example_roughing();
  small.blank_diameter_mm = 230;
  CHECK_THROWS_WITH(rough_turning_plan(small), Catch::Contains("D_blank_mm = 230, must not be below"));
  CHECK_THROWS_WITH(contour_pass_time({{{0, 1}, {5, 5}}, 0.2, 0, 100, SpindleMode::css}),
                    Catch::Contains("v_m_min = 0, must be positive in mode \"css\""));
}
