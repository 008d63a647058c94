// The checks of card K303; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k303_cutting_surface_height.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k303;

namespace {

// Wheel 1A1 40x16x10x5 AC6 100/80 4 M2-01 in a bore of 50 mm.
CuttingRegime regime(double work_speed_m_min, double depth_mm) {
  CuttingRegime r;
  r.wheel_speed_m_s = 25;
  r.wheel_radius_mm = 20;
  r.work_radius_mm = 25;
  r.grain_spacing_mm = 0.32;
  r.tip_radius_um = 6.69;
  r.tip_angle_deg = 91;
  r.weibull_x0_um_m = 81.2;
  r.weibull_m = 1.45;
  r.work_speed_m_min = work_speed_m_min;
  r.depth_mm = depth_mm;
  return r;
}

double rmax_um(const CuttingRegime& r) {
  return cutting_surface_roughness(r).rmax_um;
}

}  // namespace

TEST_CASE("K303: table 1", "[K303]") {
  struct Row {
    double speed, depth, paper, here;
  };
  constexpr std::array rows{Row{3, 0.005, 4.8, 4.80}, Row{3, 0.010, 6.6, 6.60}, Row{3, 0.015, 7.4, 7.44},
                            Row{6, 0.005, 5.0, 5.00}, Row{6, 0.010, 7.9, 8.04}, Row{6, 0.015, 9.1, 9.24},
                            Row{9, 0.005, 5.0, 5.00}, Row{9, 0.010, 8.8, 8.88}, Row{9, 0.015, 10.3, 10.44}};
  for (const Row& row : rows) {
    INFO(row.speed << " m/min, " << row.depth << " mm");
    const double rmax = rmax_um(regime(row.speed, row.depth));
    CHECK(rmax == Approx(row.here).margin(1e-9));
    CHECK(rmax == Approx(row.paper).epsilon(0.02));
  }
  CHECK(cutting_surface_roughness(regime(6, 0.005)).saturated == 1);
  CHECK(cutting_surface_roughness(regime(3, 0.005)).saturated == 0);
}

TEST_CASE("K303: Rmax rises by one interval per point to its maximum, then falls", "[K303]") {
  struct Row {
    double speed, peak_mm;
  };
  for (const Row row : {Row{3, 0.592}, Row{6, 0.792}, Row{9, 0.947}}) {
    const SurfaceAlongArc arc = cutting_surface_profile(regime(row.speed, 0.01));
    const auto peak = static_cast<std::size_t>(std::max_element(arc.rmax_um.begin(), arc.rmax_um.end()) -
                                               arc.rmax_um.begin());
    for (std::size_t p = 0; p < peak; ++p) CHECK(arc.rmax_um[p] == Approx(0.12 * static_cast<double>(p + 1)));
    for (std::size_t p = peak + 1; p < arc.rmax_um.size(); ++p) CHECK(arc.rmax_um[p] <= arc.rmax_um[p - 1]);
    CHECK(arc.position_mm[peak] == Approx(row.peak_mm).margin(6e-4));
    CHECK(arc.position_mm.back() == Approx(1.411).margin(6e-4));
  }
}

TEST_CASE(
    "K303: Rmax grows with work speed, depth and spacing, falls with wheel speed, never exceeds the depth",
    "[K303]") {
  verstat::test::property([] {
    const double speed = *rc::gen::inRange(5, 300) * 0.1;
    const double depth = *rc::gen::inRange(1, 400) * 1e-4;
    const CuttingRegime r = regime(speed, depth);
    const double rmax = rmax_um(r);
    RC_ASSERT(rmax <= depth * 1000 + 1e-9);
    RC_ASSERT(rmax_um(regime(speed * 1.3, depth)) >= rmax);
    // In steps of whole intervals: a deeper cut starts on a finer part of the arc.
    RC_ASSERT(rmax_um(regime(speed, depth + 0.0012)) >= rmax - 1e-9);
    CuttingRegime wider = r;
    wider.grain_spacing_mm *= 1.2;
    RC_ASSERT(rmax_um(wider) >= rmax);
    CuttingRegime faster = r;
    faster.wheel_speed_m_s *= 1.2;
    RC_ASSERT(rmax_um(faster) <= rmax);
    faster.work_speed_m_min *= 1.2;  // only the ratio of the speeds matters
    RC_ASSERT(rmax_um(faster) == rmax);
  });
}

TEST_CASE("K303: the height left at the end does not depend on the depth", "[K303]") {
  struct Row {
    double speed, final_um;
  };
  for (const Row row : {Row{3, 4.08}, Row{6, 5.52}, Row{9, 6.60}})
    for (const double depth : {0.010, 0.015, 0.02}) {
      const ResidualHeight left = residual_height(regime(row.speed, depth));
      CHECK(left.final_height_um == Approx(row.final_um).margin(1e-9));
      CHECK(left.rmax_um == rmax_um(regime(row.speed, depth)));
    }
}

TEST_CASE("K303: the groove is continuous in value and slope where the round tip ends", "[K303]") {
  verstat::test::property([] {
    const double radius = *rc::gen::inRange(1, 300) * 0.1;
    const double angle = *rc::gen::inRange(20, 170);
    const double seam = radius * (1 - std::sin(angle * std::numbers::pi / 360));
    const double step = 1e-6 * seam;
    const auto width = [&](double t) { return scratch_width({t, radius, angle}).width_um; };
    RC_ASSERT(std::abs(width(seam + step) - width(seam - step)) < 1e-4 * width(seam));
    const double before = (width(seam) - width(seam - step)) / step;
    const double after = (width(seam + step) - width(seam)) / step;
    RC_ASSERT(std::abs(before / after - 1) < 1e-3);
  });
}

TEST_CASE("K303: the layers of tips add up to the Weibull law", "[K303]") {
  double sum = 0;
  for (int layer = 1; layer <= 80; ++layer)
    sum += tip_layer_probability({layer, 0.12, 1.45, 81.2}).probability;
  CHECK(sum == Approx(1 - std::exp(-std::pow(80 * 0.12, 1.45) / 81.2)).epsilon(1e-12));
}

TEST_CASE("K303: the finest interval that lets one grain pass", "[K303]") {
  const auto search = [](double width_mm, double speed_m_min) {
    IntervalSearch s;
    s.wheel_radius_mm = 20;
    s.work_radius_mm = 25;
    s.work_speed_m_min = speed_m_min;
    s.wheel_width_mm = width_mm;
    s.step_um = 0.01;
    s.wheel_speed_m_s = 25;
    s.grain_spacing_mm = 0.32;
    s.weibull_x0_um_m = 81.2;
    s.weibull_m = 1.45;
    return minimum_interval(s);
  };
  CHECK(search(10, 3).interval_um == Approx(0.04));
  CHECK(search(10, 9).interval_um == Approx(0.07));
  CHECK(search(16, 3).interval_um == Approx(0.04));
  CHECK(search(16, 9).interval_um == Approx(0.06));
  CHECK(search(1, 3).interval_um == Approx(0.13));
  CHECK(search(1, 9).interval_um == Approx(0.23));
}

TEST_CASE("K303: a finer interval raises Rmax by 1 to 3 per cent", "[K303]") {
  for (const double speed : {3.0, 6.0, 9.0}) {
    CuttingRegime fine = regime(speed, 0.015);
    fine.interval_um = 0.01;
    const double growth = rmax_um(fine) / rmax_um(regime(speed, 0.015)) - 1;
    CHECK(growth > 0.005);
    CHECK(growth < 0.035);
  }
}

TEST_CASE("K303: the largest speed and depth are safe, the next ones are not", "[K303]") {
  verstat::test::property([] {
    const double protrusion = *rc::gen::inRange(20, 150) * 0.1;
    const CuttingRegime base = regime(6, 0.012);
    const double speed =
        max_work_speed_for_protrusion({base, protrusion, base.depth_mm, 0.5, 60}).work_speed_m_min;
    if (speed > 0) {
      RC_ASSERT(rmax_um(regime(speed, base.depth_mm)) < protrusion);
    } else {
      RC_ASSERT(rmax_um(regime(0.5, base.depth_mm)) >= protrusion - 1e-9);
    }
    if (speed > 0 && speed < 60)
      RC_ASSERT(rmax_um(regime(speed * (1 + 2e-6), base.depth_mm)) >= protrusion - 1e-9);
    const double depth = max_depth_for_protrusion({base, protrusion, 6}).depth_mm;
    const int count = static_cast<int>(std::round(depth * 1000 / 0.12));
    for (int k = std::max(1, count - 2); k <= std::min(833, count + 2); ++k)
      RC_ASSERT((rmax_um(regime(6, k * 0.12 / 1000)) < protrusion - 1e-9) == (k <= count));
  });
}

TEST_CASE("K303: bad input names itself", "[K303]") {
  CHECK_THROWS_WITH(
      contact_arc({{20, 20, GrindingKind::internal}, 0.01}),
      "K303.contact_arc: work_radius_mm = 20, must be larger than wheel_radius_mm in internal grinding");
  CHECK(contact_arc({{20, 0, GrindingKind::surface}, 0.01}).equivalent_diameter_mm == 40);
  CuttingRegime fine = regime(6, 0.02);
  fine.interval_um = 1e-3;
  CHECK_THROWS_WITH(rmax_um(fine), Catch::Contains("interval_um = 0.001, must cut the depth into at most"));
}
