// The checks of card K101; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/gears/hobbing_process.h"
#include "models/gears/k101_hobbing_chip_thickness.h"
#include "models/math/trig_degrees.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k101;

namespace {

constexpr double pi = std::numbers::pi;

Hobbing example(FeedMode mode = FeedMode::climb) {
  Hobbing in;
  in.feed_mode = mode;
  return in;
}

ToothLoad load(const Hobbing& process, std::int64_t tooth, double angle_deg) {
  ToothLoadInputs in;
  static_cast<Hobbing&>(in) = process;
  in.tooth_index = tooth;
  in.tooth_angle_deg = angle_deg;
  return hobbing_tooth_load(in);
}

LoadSummary summary(const Hobbing& process, double step_deg) {
  LoadSummaryInputs in;
  static_cast<Hobbing&>(in) = process;
  in.angle_step_deg = step_deg;
  return hobbing_load_summary(in);
}

// The card's algorithm step by step: every pass at every scan step, then bisection. No bounds, no ordering.
double plain_chip(const HobbingProcess& process, std::int64_t tooth, double theta, const OutlinePoint& point,
                  std::int64_t previous_revs) {
  const double t = process.tooth_angle(tooth);
  const double phi = theta - t;
  const Eigen::Vector3d p = process.to_blank(process.place(point, theta, t), phi);
  const double radius = process.gear_outer_radius;
  if (std::hypot(p.y(), p.z()) >= radius) return 0;
  const Eigen::Vector3d n = process.direction_to_blank(process.swept(point, theta, t).normal0, phi);
  std::vector<Pass> passes;
  for (std::int64_t i = -process.last_tooth; i <= process.last_tooth; ++i)
    for (std::int64_t rev = 0; rev <= previous_revs; ++rev) {
      if (rev == 0 && i >= tooth) continue;
      const double offset = -2 * pi * static_cast<double>(rev * process.gear_teeth);
      passes.push_back({process.tooth_angle(i), offset - process.tooth_angle(i)});
    }
  const auto cut = [&](double g) {
    const Eigen::Vector3d q = p + g * n;
    for (const Pass& pass : passes)
      if (process.clearance(q, pass, 3 * pi / 2) <= 0) return true;
    return false;
  };
  if (cut(0)) return 0;
  // Distance to the outer cylinder by bisection on the radius along the normal, at most 6 mm.
  double best = 6;
  const auto outside = [&](double g) { return std::hypot(p.y() + g * n.y(), p.z() + g * n.z()) >= radius; };
  if (outside(best)) {
    double low = 0;
    while (best - low > 1e-12) (outside((low + best) / 2) ? best : low) = (low + best) / 2;
  }
  double last = 0;
  for (int k = 1; last < best; ++k) {
    const double g = std::min(best, k * 0.05);
    if (cut(g)) {
      double low = last;
      double high = g;
      while (high - low > 1e-9) (cut((low + high) / 2) ? high : low) = (low + high) / 2;
      return std::min(best, high);
    }
    last = g;
  }
  return best;
}

// Gap that all passes together leave on the pitch circle in the transverse plane through the hob centre.
double pitch_circle_gap(const Hobbing& in) {
  const HobbingProcess process(in);
  const double radius =
      in.module_mm * static_cast<double>(in.gear_teeth) / (2 * std::cos(to_radians(in.gear_helix_deg)));
  const auto swept = [&](double chi) {
    const Eigen::Vector3d q(0, radius * std::cos(chi), radius * std::sin(chi));
    for (std::int64_t rev = -3; rev <= 3; ++rev)
      for (std::int64_t i = -process.last_tooth; i <= process.last_tooth; ++i) {
        // The blank has turned by about rev turns: take the pass of that turn.
        const double offset = 2 * pi * static_cast<double>(rev * in.gear_teeth);
        if (process.clearance(q, {process.tooth_angle(i), offset - process.tooth_angle(i)}, 3 * pi / 2) <= 0)
          return true;
      }
    return false;
  };
  // A point in the middle of a gap, then its two sides by bisection.
  const double pitch = 2 * pi / static_cast<double>(in.gear_teeth);
  constexpr int grid = 60;
  int start = -1;
  for (int k = 0; k < grid && start < 0; ++k)
    if (!swept(pitch * k / grid) && swept(pitch * (k + 1) / grid)) start = k;
  REQUIRE(start >= 0);
  const auto border = [&](double solid, double gap) {
    for (int k = 0; k < 40; ++k) (swept((solid + gap) / 2) ? gap : solid) = (solid + gap) / 2;
    return (solid + gap) / 2;
  };
  const double low = border(pitch * start / grid, pitch * (start + 1) / grid);
  int end = start + 1;
  while (swept(pitch * (end + 1) / grid)) ++end;
  const double high = border(pitch * (end + 1) / grid, pitch * end / grid);
  return radius * (high - low);
}

}  // namespace

TEST_CASE("K101: without swivel the approach is sqrt(h (d - h)), first contact at 90 deg", "[K101]") {
  verstat::test::property([] {
    const double d = *rc::gen::inRange(50, 200);
    const double h = *rc::gen::inRange(10, 200) * 0.1;
    const double gear = *rc::gen::inRange(30, 400);
    const Approach a = hob_approach_length({gear + d / 2 - h, d, gear, 0});
    RC_ASSERT(std::abs(a.approach_length_mm - std::sqrt(h * (d - h))) < 1e-9);
    RC_ASSERT(std::abs(a.contact_angle_deg - 90) < 1e-9);
    // Even in the setting angle, and longer with it.
    const Approach left = hob_approach_length({gear + d / 2 - h, d, gear, -17});
    RC_ASSERT(left.approach_length_mm ==
              hob_approach_length({gear + d / 2 - h, d, gear, 17}).approach_length_mm);
    RC_ASSERT(left.approach_length_mm > a.approach_length_mm);
  });
  CHECK(hob_approach_length({200, 100, 100, 5}).approach_length_mm == 0);
  CHECK(hob_approach_length({200, 100, 100, 5}).contact_angle_deg == 90);
}

TEST_CASE("K101: the approach is the maximum over the intersection line, near the handbook value", "[K101]") {
  for (const double beta_deg : {3.0, 10.0, 25.0, 44.0}) {
    const double beta = to_radians(beta_deg);
    double best = 0;
    for (int k = 0; k <= 200000; ++k) {
      const double tau = std::asin((95.75 - 50) / 57) + (pi / 2 - std::asin((95.75 - 50) / 57)) * k / 200000;
      const double q = std::sqrt(std::max(0.0, 2500 - std::pow(95.75 - 57 * std::sin(tau), 2)));
      best = std::max(best, (q + 57 * std::cos(tau) * std::sin(beta)) / std::cos(beta));
    }
    CHECK(hob_approach_length({95.75, 100, 57, beta_deg}).approach_length_mm == Approx(best).epsilon(1e-9));
  }
  CHECK(hob_approach_length({95.75, 100, 57, 10}).approach_length_mm == Approx(32.78).margin(0.005));
  CHECK(hob_approach_length({95.75, 100, 57, 25}).approach_length_mm == Approx(38.97).margin(0.005));
}

TEST_CASE("K101: the depth is 2.25 m for every shift and helix", "[K101]") {
  for (const double x : {-0.5, 0.0, 0.4, 1.0})
    for (const double helix : {-30.0, 0.0, 20.0}) {
      const HobbingSetup s = hobbing_setup({4, 33, helix, x, 90, 1.25});
      CHECK(s.cutting_depth_mm == Approx(9));
      CHECK(s.gear_outer_radius_mm + 45 - s.centre_distance_mm == Approx(9));
    }
}

TEST_CASE("K101: differential rotation of the blank", "[K101]") {
  KinematicsInputs in;
  in.hob_angle_deg = 7200;
  CHECK(hobbing_kinematics(in).blank_angle_deg == Approx(360));
  in.gear_helix_deg = 20;
  in.feed_mode = FeedMode::conventional;
  CHECK(hobbing_kinematics(in).blank_angle_deg == Approx(360.784).margin(0.0005));
  // Travel times 2 sin(beta)/(m Z) on top of the pure ratio.
  const HobbingKinematics k = hobbing_kinematics(in);
  CHECK(to_radians(k.blank_angle_deg - 360) ==
        Approx(k.axial_travel_mm * 2 * std::sin(to_radians(20)) / (5 * 20)));
}

TEST_CASE("K101: the outline is continuous and stays on the tooth", "[K101]") {
  const HobbingProcess process{example()};
  const std::vector<OutlinePoint> edge = process.edge_samples(16, 5, 7);
  REQUIRE(edge.size() == 49);
  for (const OutlinePoint& point : edge) {
    CHECK(std::abs(process.outline_distance(point.r, point.w)) < 1e-12);
    CHECK(process.outline_distance(point.r + 0.01 * point.normal_r, point.w + 0.01 * point.normal_w) ==
          Approx(0.01).margin(1e-9));
    CHECK(std::abs(point.tangent_r * point.normal_r + point.tangent_w * point.normal_w) < 1e-15);
  }
  for (std::size_t k = 0; k < 49; ++k) {  // symmetric but for the sampling of the second flank
    CHECK(edge[k].r <= process.hob.tip_radius + 1e-12);
    CHECK(edge[k].r >= process.hob.tip_radius - process.cutting_depth - 1e-12);
  }
}

TEST_CASE("K101: the relative velocity is the derivative of the motion", "[K101]") {
  verstat::test::property([] {
    VelocityInputs in;
    in.gear_helix_deg = *rc::gen::inRange(-40, 40);
    in.feed_mode = *rc::gen::element(FeedMode::climb, FeedMode::conventional);
    in.axial_feed_mm_rev = *rc::gen::inRange(1, 80) * 0.1;
    in.segment = Segment::corner_45;
    in.parameter = *rc::gen::inRange(90, 160);
    in.tooth_index = *rc::gen::inRange(-20, 20);
    in.tooth_angle_deg = *rc::gen::inRange(200, 340);
    const HobbingProcess process(in);
    const double t = process.tooth_angle(in.tooth_index);
    const double theta = to_radians(in.tooth_angle_deg);
    const OutlinePoint point = process.outline_point(in.segment, in.parameter);
    const double step = 1e-5;
    const Eigen::Vector3d numeric =
        (process.to_blank(process.place(point, theta + step, t), theta + step - t) -
         process.to_blank(process.place(point, theta - step, t), theta - step - t)) /
        (2 * step);
    const RelativeVelocity v = hob_relative_velocity(in);
    const Eigen::Vector3d exact =
        process.direction_to_blank({v.vx_mm_rad, v.vy_mm_rad, v.vz_mm_rad}, theta - t);
    RC_ASSERT((exact - numeric).norm() < 1e-6);
  });
}

TEST_CASE("K101: the normal is square to edge and motion and points into the tooth", "[K101]") {
  ToothPointInputs in;
  in.segment = Segment::flank_12;
  in.parameter = 47;
  in.tooth_index = 3;
  in.tooth_angle_deg = 262;
  const SurfaceNormal n = cutting_surface_normal(in);
  const HobbingProcess process(in);
  const double t = process.tooth_angle(3);
  const double theta = to_radians(262);
  const Eigen::Vector3d normal(n.nx, n.ny, n.nz);
  const OutlinePoint point = process.outline_point(in.segment, in.parameter);
  CHECK(normal.norm() == Approx(1));
  CHECK(normal.dot(process.direction_to_blank(process.tangent(point, theta), theta - t)) ==
        Approx(0).margin(1e-12));
  const Eigen::Vector3d p0 = process.place(point, theta, t);
  CHECK(normal.dot(process.direction_to_blank(process.velocity(p0), theta - t)) == Approx(0).margin(1e-9));
  // A step along it lies inside the volume that this very pass sweeps, a step back outside.
  const Eigen::Vector3d p = process.to_blank(p0, theta - t);
  CHECK(process.clearance(p + 0.01 * normal, {t, -t}, theta) < 0);
  CHECK(process.clearance(p - 0.01 * normal, {t, -t}, theta) > 0);
}

TEST_CASE("K101: chips agree with the plain algorithm that looks at every pass and step", "[K101]") {
  Hobbing helical = example(FeedMode::conventional);
  helical.gear_helix_deg = -25;
  helical.gear_teeth = 31;
  helical.axial_feed_mm_rev = 3.3;
  helical.hob_profile = HobProfile::archimedean;
  Hobbing coarse = example();
  coarse.hob_gashes = 6;
  coarse.hob_diameter_mm = 70;
  coarse.hob_tip_radius_mm = 0.4;
  coarse.axial_feed_mm_rev = 6;
  // Feed beyond the approach length: most points look back at earlier revolutions from far round the hob.
  Hobbing tiny = example();
  tiny.module_mm = 1.3;
  tiny.hob_diameter_mm = 20;
  tiny.hob_tip_radius_mm = 0;
  tiny.gear_teeth = 43;
  tiny.gear_helix_deg = -29;
  tiny.axial_feed_mm_rev = 8;
  for (const Hobbing& in : {example(), example(FeedMode::conventional), helical, coarse, tiny}) {
    const HobbingProcess process(in);
    const std::vector<OutlinePoint> edge = process.edge_samples(16, 5, 7);
    double largest = 0;
    for (const std::int64_t tooth : {-17, -9, -4, -2, 0, 1, 5})
      for (const double theta_deg : {238.0, 255.0, 263.0, 277.0, 292.0}) {
        const double theta = to_radians(theta_deg);
        const ToothPosition position(process, tooth, theta, 2);
        for (std::size_t k = (static_cast<std::size_t>(tooth + 17)) % 5; k < edge.size(); k += 5) {
          const double chip = position.chip_thickness(edge[k], 0.05);
          INFO(tooth << " " << theta_deg << " " << k);
          CHECK(chip == Approx(plain_chip(process, tooth, theta, edge[k], 2)).margin(5e-9));
          largest = std::max(largest, chip);
        }
      }
    CHECK(largest > 0.1);
  }
}

TEST_CASE("K101: loads of the worked example at 260 deg", "[K101]") {
  struct Row {
    std::int64_t tooth;
    double chip, contact, section;
  };
  for (const Row row :
       {Row{-6, .066, 2.2, .095}, Row{-5, .049, 3.8, .117}, Row{-4, .081, 4.9, .172},
        Row{-3, .124, 7.5, .373}, Row{-2, .168, 9.3, .698}, Row{-1, .122, 8.6, .559}, Row{0, .074, 8.9, .381},
        Row{1, .055, 6.8, .187}, Row{2, .049, 4.1, .111}, Row{3, .044, 3.3, .086}, Row{4, .050, 3.3, .083},
        Row{5, .056, 2.7, .089}, Row{6, .062, 2.7, .096}}) {
    const ToothLoad got = load(example(), row.tooth, 260);
    INFO(row.tooth);
    CHECK(got.max_chip_thickness_mm == Approx(row.chip).margin(0.0011));
    CHECK(got.contact_length_mm == Approx(row.contact).margin(0.06));
    CHECK(got.chip_section_mm2 == Approx(row.section).margin(0.0011));
  }
}

TEST_CASE("K101: each feed mode leaves its half of the arc uncut", "[K101]") {
  for (std::int64_t tooth = -23; tooth <= 23; ++tooth) {
    for (const double angle : {240.0, 255.0, 267.0})
      CHECK(load(example(FeedMode::conventional), tooth, angle).max_chip_thickness_mm == 0);
    for (const double angle : {273.0, 285.0, 300.0})
      CHECK(load(example(FeedMode::climb), tooth, angle).max_chip_thickness_mm == 0);
  }
}

TEST_CASE("K101: one earlier blank revolution is enough at a feed of 2 mm", "[K101]") {
  ChipInputs in;
  in.segment = Segment::tip_34;
  in.parameter = 0.6;
  for (const std::int64_t tooth : {-8, -2, 0, 4})
    for (const double angle : {240.0, 260.0, 268.0}) {
      in.tooth_index = tooth;
      in.tooth_angle_deg = angle;
      in.previous_blank_revs = 1;
      const double one = hobbing_chip_thickness(in).chip_thickness_mm;
      in.previous_blank_revs = 4;
      CHECK(hobbing_chip_thickness(in).chip_thickness_mm == Approx(one).margin(2e-9));
      // The angle is a position in the turn.
      in.tooth_angle_deg = angle - 720;
      CHECK(hobbing_chip_thickness(in).chip_thickness_mm == Approx(one).margin(1e-8));
    }
}

TEST_CASE("K101: a blank of finite width is cut between its end faces only", "[K101]") {
  ChipInputs in;
  in.segment = Segment::tip_34;
  in.parameter = 1.1;
  in.tooth_index = -2;
  in.tooth_angle_deg = 260;
  const double steady = hobbing_chip_thickness(in).chip_thickness_mm;
  in.blank_limited = true;
  in.face_width_mm = 30;
  in.hob_turns = 400;
  CHECK(hobbing_chip_thickness(in).chip_thickness_mm == Approx(steady).margin(1e-8));
  for (const std::int64_t turns : {-10, 100, 650, 2000}) {
    in.hob_turns = turns;
    CHECK(hobbing_chip_thickness(in).chip_thickness_mm == 0);
  }
}

TEST_CASE("K101: fine feed and many gashes generate the tooth gap of the gear", "[K101]") {
  Hobbing in = example(FeedMode::conventional);
  in.axial_feed_mm_rev = 0.1;
  in.hob_gashes = 30;
  CHECK(pitch_circle_gap(in) == Approx(6.398).margin(0.002));
  in.gear_helix_deg = 20;
  CHECK(pitch_circle_gap(in) == Approx(6.809).margin(0.002));
  in.gear_helix_deg = -20;
  CHECK(pitch_circle_gap(in) == Approx(6.809).margin(0.002));
}

TEST_CASE("K101: chip volume balances the gap, and both hands agree", "[K101]") {
  const LoadSummary climb = summary(example(), 1.5);
  CHECK(climb.chip_volume_per_gap_mm3 == Approx(191.5).margin(0.1));
  CHECK(climb.chip_volume_per_gap_mm3 == Approx(93.05 * 2).epsilon(0.04));
  CHECK(climb.max_chip_thickness_mm == Approx(0.359).margin(0.0005));
  const LoadSummary conventional = summary(example(FeedMode::conventional), 1.5);
  CHECK(conventional.chip_volume_per_gap_mm3 == Approx(190.9).margin(0.1));
  double total = 0;
  for (const double share : climb.tooth_shares) total += share;
  CHECK(total == Approx(1));
  CHECK(climb.tooth_shares.size() == static_cast<std::size_t>(1 - 2 * climb.first_tooth_index));
  CHECK(climb.most_loaded_tooth == -2);
  Hobbing helical = example(FeedMode::conventional);
  helical.profile_shift = 0;
  helical.gear_helix_deg = 30;
  const double right = summary(helical, 2).chip_volume_per_gap_mm3;
  helical.gear_helix_deg = -30;
  CHECK(summary(helical, 2).chip_volume_per_gap_mm3 == Approx(right).epsilon(0.005));
  CHECK(right == Approx(206.4).epsilon(0.005));
}

TEST_CASE("K101: the peak grows with the feed and falls with the gashes", "[K101]") {
  Hobbing in = example();
  in.axial_feed_mm_rev = 1;
  CHECK(summary(in, 1.5).max_chip_thickness_mm == Approx(0.245).margin(0.0006));
  in.axial_feed_mm_rev = 4;
  CHECK(summary(in, 1.5).max_chip_thickness_mm == Approx(0.522).margin(0.0006));
  in.axial_feed_mm_rev = 2;
  in.hob_gashes = 8;
  CHECK(summary(in, 1.5).max_chip_thickness_mm == Approx(0.422).margin(0.0006));
}

TEST_CASE("K101: arc, engagement and main time", "[K101]") {
  const ContactArc arc = hob_contact_arc({95.75, 100, 57});
  CHECK(arc.entry_angle_deg == Approx(230.81).margin(0.005));
  CHECK(arc.exit_angle_deg == Approx(309.19).margin(0.005));
  const auto engaged = [&arc](double angle) {
    return hob_tooth_engaged({angle, arc.entry_angle_deg, arc.exit_angle_deg}).engaged;
  };
  CHECK(engaged(arc.entry_angle_deg));
  CHECK(engaged(arc.exit_angle_deg));
  CHECK(engaged(arc.exit_angle_deg - 720));
  CHECK(engaged(270 + 3600));
  CHECK_FALSE(engaged(arc.entry_angle_deg - 0.001));
  CHECK_FALSE(engaged(arc.exit_angle_deg + 0.001));
  CHECK_FALSE(engaged(90));
  const MainTime one = hobbing_main_time({31.7256, 30, 2, 20, 120, 1});
  CHECK(one.hob_revolutions == Approx(934.5).margin(0.05));
  CHECK(hobbing_main_time({31.7256, 30, 2, 20, 120, 2}).main_time_min == Approx(one.main_time_min / 2));
}

TEST_CASE("K101: Hoffmeister's estimates that the card lists", "[K101]") {
  const auto chip = [](std::int64_t teeth, double helix) {
    return hoffmeister_chip_thickness({5, teeth, helix, 0, 100, 10, 1, 2, 11.25}).max_chip_thickness_mm;
  };
  CHECK(chip(20, 0) == Approx(0.310).margin(0.0005));
  CHECK(chip(20, 15) == Approx(0.282).margin(0.0005));
  CHECK(chip(20, -30) == Approx(0.257).margin(0.0005));
  CHECK(chip(40, 30) == Approx(0.214).margin(0.0005));
}

TEST_CASE("K101: bad input names itself", "[K101]") {
  HobInputs sharp;
  sharp.hob_tip_radius_mm = 3;
  CHECK_THROWS_WITH(hob_geometry(sharp),
                    "K101.hob_geometry: hob_tip_radius_mm = 3, is too large: no tip land is left");
  HobInputs small;
  small.hob_diameter_mm = 20;
  small.module_mm = 6;
  CHECK_THROWS_WITH(hob_geometry(small), Catch::Contains("hob_diameter_mm = 20, is too small"));
  EdgePointInputs off;
  off.segment = Segment::corner_23;
  off.parameter = 10;
  CHECK_THROWS_WITH(hob_edge_point(off), Catch::Contains("parameter = 10, is outside segment 23"));
  ChipInputs limited;
  limited.segment = Segment::tip_34;
  limited.blank_limited = true;
  CHECK_THROWS_WITH(
      hobbing_chip_thickness(limited),
      "K101.hobbing_chip_thickness: face_width_mm = null, is needed when blank_limited is true");
  CHECK_THROWS_WITH(hob_contact_arc({200, 100, 100}), Catch::Contains("do not meet"));
}
