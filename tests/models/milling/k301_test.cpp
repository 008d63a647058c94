// The checks of card K301; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/solve.h"
#include "models/milling/helical_tooth_load.h"
#include "models/milling/k301_polygon_milling.h"

using namespace verstat::models;
using namespace verstat::models::k301;

namespace {

using std::numbers::pi;
constexpr double rad = pi / 180;

const std::vector<double> printed_x{133.373, 129.803, 127.035, 125.12, 124.099, 123.99};
const std::vector<double> printed_c{-98.302, -102.689, -107.293, -112.068, -116.955, -121.885};

Polygon polygon(std::int64_t faces, double apothem_mm, double radius_mm) {
  return {faces, apothem_mm, radius_mm};
}
ContourPoint point(const Polygon& p, double c_deg) {
  return polygon_contour_point({p, c_deg});
}
EngagedArc arc(const Polygon& p, double blank_mm, double c_deg) {
  return polygon_engagement({{p, blank_mm}, c_deg});
}

// The example of the card.
PolygonPass example(FeedStrategy strategy) {
  PolygonPass in;
  static_cast<Polygon&>(in) = polygon(6, 21.65, 8);
  in.blank_radius_mm = 25;
  in.axial_depth_mm = 10;
  in.teeth = 4;
  in.helix_deg = 30;
  in.rpm = 1200;
  in.kc11_mpa = 1700;
  in.mc = 0.25;
  in.force_limit_n = 900;
  in.feed_min_mm_min = 20;
  in.feed_max_mm_min = 600;
  in.x_rate_max_mm_min = 10000;
  in.c_rate_max_deg_min = 7200;
  in.strategy = strategy;
  return in;
}

// Integral of f(c) ds along one sector of the path, with midpoints of flat and corner.
template <class F>
double along_sector(const Polygon& p, F&& f) {
  const double half = p.apothem_mm * std::tan(pi / static_cast<double>(p.faces));
  const double d = p.apothem_mm + p.cutter_radius_mm;
  const double rho = p.apothem_mm / std::cos(pi / static_cast<double>(p.faces));
  constexpr int n = 40'000;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double share = (2 * k + 1.0) / n - 1;
    sum += f(std::atan2(share * half, d) / rad) * 2 * half / n;
    const double beta = share * pi / static_cast<double>(p.faces);
    const double delta =
        std::atan2(p.cutter_radius_mm * std::sin(beta), rho + p.cutter_radius_mm * std::cos(beta));
    sum += f((delta + pi / static_cast<double>(p.faces)) / rad) * p.cutter_radius_mm * 2 * pi /
           static_cast<double>(p.faces) / n;
  }
  return sum;
}

MillingForce force(double start, double exit, double fz, double depth, double radius, std::int64_t z,
                   double helix, double mc = 0.25) {
  return peak_milling_force({start, exit, fz, depth, radius, z, helix, 1700, mc});
}

}  // namespace

TEST_CASE("K301: the printed program lies on one face at a constant contour feed of 300", "[K301]") {
  for (std::size_t i = 0; i < printed_x.size(); ++i)
    CHECK(std::abs(printed_x[i] - 123.9235 / std::cos((printed_c[i] + 120) * rad)) < 0.002);
  const FlatFit fit = gcode_flat_fit({printed_x, printed_c});
  CHECK(fit.x0_mm == Approx(123.9235).margin(1e-3));
  CHECK(fit.c0_deg == Approx(-120).margin(1e-2));
  CHECK(fit.max_residual_mm < 0.6e-3);
  const std::vector<double> f{232.1, 246.3, 258.6, 258.6, 274.6, 274.6};
  const std::vector<double> expected{0, 299.97, 299.96, 289, 299.89, 297};
  for (const std::size_t i : {1, 2, 3, 4, 5}) {
    const NcBlock block{
        {printed_x[i - 1], printed_c[i - 1], printed_x[i], printed_c[i], FeedMode::c_rate, true}, f[i]};
    CHECK(block_path_feed(block).path_feed_mm_min ==
          Approx(expected[i]).margin(i == 3 || i == 5 ? 0.5 : 0.006));
  }
}

TEST_CASE("K301: feed_word_for_block inverts block_path_feed", "[K301]") {
  CHECK(rc::check([] {
    NcBlock block;
    block.x1_mm = *rc::gen::inRange(20, 90);
    block.x2_mm = block.x1_mm + *rc::gen::inRange(1, 40) * 0.1;
    block.c1_deg = *rc::gen::inRange(-180, 180);
    block.c2_deg = block.c1_deg + *rc::gen::inRange(1, 80) * 0.1;
    block.f_word = *rc::gen::inRange(10, 900);
    block.mode = *rc::gen::element(FeedMode::radial, FeedMode::c_rate, FeedMode::inverse_time);
    block.x_is_diameter = *rc::gen::arbitrary<bool>();
    const FeedForBlock back{block, block_path_feed(block).path_feed_mm_min};
    RC_ASSERT(std::abs(feed_word_for_block(back).f_word - block.f_word) < 1e-9 * block.f_word);
  }));
}

TEST_CASE("K301: contour is continuous, closes and dx/dc is its derivative", "[K301]") {
  CHECK(rc::check([] {
    const std::int64_t faces = *rc::gen::inRange<std::int64_t>(3, 9);
    const Polygon p = polygon(faces, *rc::gen::inRange(10, 60), *rc::gen::inRange(2, 40));
    const ContourSummary s = polygon_contour_summary(p);
    for (const double side : {-1.0, 1.0}) {
      const ContourPoint in = point(p, side * (s.flat_half_angle_deg - 1e-9));
      const ContourPoint out = point(p, side * (s.flat_half_angle_deg + 1e-9));
      RC_ASSERT(in.on_corner == 0 && out.on_corner == 1);
      RC_ASSERT(std::abs(in.x_mm - out.x_mm) < 1e-7 && std::abs(in.chi_deg - out.chi_deg) < 1e-5);
    }
    const double middle = 180.0 / static_cast<double>(faces);
    RC_ASSERT(point(p, 1e-6).dx_dc_mm_rad > 0 && point(p, -1e-6).dx_dc_mm_rad < 0);
    RC_ASSERT(point(p, middle - 1e-6).dx_dc_mm_rad > 0 && point(p, middle + 1e-6).dx_dc_mm_rad < 0);
    RC_ASSERT(std::abs(point(p, middle).x_mm - s.x_max_mm) < 1e-9);
    const double c_deg = *rc::gen::inRange(-3600, 3600) * 0.1 + 0.017;
    const double slope = (point(p, c_deg + 1e-4).x_mm - point(p, c_deg - 1e-4).x_mm) / (2e-4 * rad);
    RC_ASSERT(std::abs(slope - point(p, c_deg).dx_dc_mm_rad) < 1e-3 * p.apothem_mm);
  }));
  const Polygon p = polygon(6, 43, 18);
  double length = 0;
  constexpr int n = 60'000;
  ContourPoint before = point(p, 0);
  for (int k = 1; k <= n; ++k) {
    const ContourPoint here = point(p, 360.0 * k / n);
    length += std::sqrt(std::pow(here.x_mm - before.x_mm, 2) +
                        4 * here.x_mm * before.x_mm * std::pow(std::sin(pi / n), 2));
    before = here;
  }
  CHECK(length == Approx(polygon_contour_summary(p).path_length_mm).epsilon(1e-7));
}

TEST_CASE("K301: axis feeds compose to the contour feed", "[K301]") {
  CHECK(rc::check([] {
    const double x = *rc::gen::inRange(10, 100), slope = *rc::gen::inRange(-300, 300) * 0.1;
    const AxisFeeds f = radial_feed_for_path_feed({250, x, slope});
    RC_ASSERT(std::abs(std::hypot(f.radial_feed_mm_min, x * f.c_rate_deg_min * rad) - 250) < 1e-9);
  }));
  CHECK(radial_feed_for_path_feed({300, 61, 0}).radial_feed_mm_min == 0);
  const CutAtAngle middle{example(FeedStrategy::stabilized), 0};
  CHECK(stabilized_path_feed(middle).radial_feed_mm_min == 0);
  // Reading F as a radial feed recovers the contour feed it was made from.
  NcProgram program;
  const Polygon p = polygon(6, 43, 18);
  for (double c = 4; c <= 16; c += 0.25) {
    const ContourPoint here = point(p, c);
    program.x_mm.push_back(2 * here.x_mm);
    program.c_deg.push_back(c);
    program.f_word.push_back(
        radial_feed_for_path_feed({300, here.x_mm, here.dx_dc_mm_rad}).radial_feed_mm_min);
  }
  program.x_is_diameter = true;
  const NcFeeds feeds = verify_gcode_feed(program);
  for (std::size_t i = 1; i + 1 < feeds.path_feed_mm_min.size(); ++i)
    CHECK(feeds.path_feed_mm_min[i] == Approx(300).epsilon(1e-3));
}

TEST_CASE("K301: the swept area balances the stock", "[K301]") {
  for (const std::int64_t faces : {3, 4, 6, 8}) {
    const auto n = static_cast<double>(faces);
    const Polygon p = polygon(faces, 20, 15);
    const double rho = 20 / std::cos(pi / n);
    const double area = n * 20 * 20 * std::tan(pi / n);
    for (const double blank : {rho, rho + 2}) {
      if (faces == 3 && blank > rho) continue;  // exit reaches 180 deg
      const double swept = n * along_sector(p, [&](double c) { return arc(p, blank, c).radial_width_mm; });
      CHECK(swept == Approx(pi * blank * blank - area).epsilon(2e-6));
    }
    // Below the vertex radius: N circular segments.
    const double blank = 0.5 * (20 + rho);
    const double half = std::acos(20 / blank);
    const double segments = n * blank * blank * (half - std::sin(half) * std::cos(half));
    const double swept = n * along_sector(p, [&](double c) { return arc(p, blank, c).radial_width_mm; });
    CHECK(swept == Approx(segments).epsilon(1e-4));
  }
}

TEST_CASE("K301: engagement of a blank with the radius of the vertices", "[K301]") {
  const Polygon p = polygon(6, 43, 18);
  const ContourSummary s = polygon_contour_summary(p);
  const double blank = s.vertex_radius_mm;
  CHECK(arc(p, blank, -s.flat_half_angle_deg).exit_angle_deg == Approx(2 * s.flat_half_angle_deg));
  CHECK(arc(p, blank, s.flat_half_angle_deg).radial_width_mm == Approx(0).margin(1e-9));
  double before = 0;
  for (double c = s.flat_half_angle_deg + 0.1; c < 30; c += 0.1)
    CHECK(arc(p, blank, c).radial_width_mm == Approx(0).margin(1e-9));
  for (double c = 30.2; c < 60 - s.flat_half_angle_deg; c += 0.1) {
    CHECK(arc(p, blank, c).exit_angle_deg > before);
    before = arc(p, blank, c).exit_angle_deg;
  }
  CHECK(before == Approx(2 * s.flat_half_angle_deg).epsilon(0.02));
}

TEST_CASE("K301: the engaged arc is what a brute force of earlier positions leaves", "[K301]") {
  CHECK(rc::check([] {
    const Polygon p = polygon(*rc::gen::inRange<std::int64_t>(3, 8), 20, *rc::gen::inRange(6, 20));
    const double blank = 20 + *rc::gen::inRange(1, 9) * 0.2 * p.cutter_radius_mm;
    const double c0 = *rc::gen::inRange(-60, 60) + 0.37;
    const ContourPoint here = point(p, c0);
    const EngagedArc engaged = arc(p, blank, c0);
    std::vector<std::pair<double, double>> earlier;
    for (double back = 0.02; back < 180; back += 0.02) {
      const double x = point(p, c0 - back).x_mm;
      earlier.emplace_back(x * std::cos((c0 - back) * rad), x * std::sin((c0 - back) * rad));
    }
    const double radius = p.cutter_radius_mm;
    for (int k = 1; k < 60; ++k) {
      const double phi = 3.0 * k;
      const double turn = here.chi_deg * rad + phi * rad;
      const double px = here.x_mm * std::cos(c0 * rad) +
                        radius * (-std::cos(turn) * std::cos(c0 * rad) - std::sin(turn) * std::sin(c0 * rad));
      const double py = here.x_mm * std::sin(c0 * rad) +
                        radius * (-std::cos(turn) * std::sin(c0 * rad) + std::sin(turn) * std::cos(c0 * rad));
      if (std::abs(std::hypot(px, py) - blank) < 0.05 * radius) continue;  // too near the skin to tell
      bool stock = std::hypot(px, py) < blank;
      for (const auto& [ex, ey] : earlier) stock = stock && std::hypot(px - ex, py - ey) >= radius - 1e-9;
      const bool inside =
          engaged.in_cut == 1 && phi > engaged.start_angle_deg && phi < engaged.exit_angle_deg;
      RC_ASSERT(stock == inside);
    }
  }));
}

TEST_CASE("K301: the heaviest position lies before the middle of the face", "[K301]") {
  CutAtAngle in{example(FeedStrategy::stabilized), 0};
  double least = 1e9, at = 0;
  for (double c = -30; c <= 30; c += 0.1) {
    in.c_deg = c;
    const double feed = stabilized_path_feed(in).path_feed_mm_min;
    if (feed < least) {
      least = feed;
      at = c;
    }
  }
  CHECK(at == Approx(-12).margin(1.0));
}

TEST_CASE("K301: the integral of a power of the sine", "[K301]") {
  for (const double p : {0.05, 0.3, 0.75, 1.0}) {
    const SinePowerIntegral integral(p);
    for (double phi = 0.05; phi < 3.14; phi += 0.17) {
      // phi = u^4 takes the root singularity at zero away.
      const double by_quadrature =
          integrate([&](double u) { return std::pow(std::sin(u * u * u * u), p) * 4 * u * u * u; }, 0,
                    std::pow(phi, 0.25), 1e-12);
      CHECK(integral(phi) == Approx(by_quadrature).epsilon(2e-11));
    }
  }
  CHECK(SinePowerIntegral(1)(2.5) == Approx(1 - std::cos(2.5)).epsilon(1e-14));
}

TEST_CASE("K301: the peak is that of a dense search over slices", "[K301]") {
  CHECK(rc::check([] {
    const double start = *rc::gen::inRange(0, 100), exit = start + *rc::gen::inRange(30, 80);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(1, 7);
    const double helix = *rc::gen::inRange(0, 60);
    const double depth = *rc::gen::inRange(1, 30), radius = 8, mc = 0.25, fz = 0.05;
    const double lag = depth * std::tan(helix * rad) / radius;
    double peak = 0;
    const int positions = 2000 / static_cast<int>(z);
    const int slices = 60 + static_cast<int>(60 * lag);
    for (int i = 0; i < positions; ++i) {
      double sum = 0;
      for (int s = 0; s < slices; ++s)
        for (std::int64_t j = 0; j < z; ++j) {
          const double lead =
              2 * pi * (i / static_cast<double>(positions) + static_cast<double>(j)) / static_cast<double>(z);
          double angle = std::fmod(lead - lag * (s + 0.5) / slices, 2 * pi);
          if (angle < 0) angle += 2 * pi;
          if (angle >= start * rad && angle <= exit * rad) sum += std::pow(fz * std::sin(angle), 1 - mc);
        }
      peak = std::max(peak, 1700 * sum * depth / slices);
    }
    const double found = force(start, exit, fz, depth, radius, z, helix).peak_force_n;
    RC_ASSERT(found > 0.95 * peak);
    // A slice is in or out as a whole: the search jumps by a slice of the arc.
    RC_ASSERT(found < 1.06 * peak);
  }));
}

TEST_CASE("K301: force laws", "[K301]") {
  CHECK(rc::check([] {
    const double start = *rc::gen::inRange(0, 90), exit = start + *rc::gen::inRange(1, 90);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(1, 8);
    const double depth = *rc::gen::inRange(1, 40);
    const double helix = *rc::gen::inRange(0, 60);
    const MillingForce f = force(start, exit, 0.05, depth, 10, z, helix);
    const MillingForce doubled = force(start, exit, 0.1, depth, 10, z, helix);
    RC_ASSERT(std::abs(doubled.peak_force_n / f.peak_force_n - std::pow(2, 0.75)) < 1e-9);
    const MillingForce straight = force(start, exit, 0.05, depth, 10, z, 0);
    RC_ASSERT(std::abs(straight.mean_force_n - f.mean_force_n) < 1e-9 * f.mean_force_n);
    RC_ASSERT(straight.peak_force_n >= f.peak_force_n * (1 - 1e-9));
    RC_ASSERT(f.peak_force_n >= f.mean_force_n * (1 - 1e-9));
  }));
  CHECK(force(50, 50, 0.05, 10, 10, 4, 30).peak_force_n == 0);
  CHECK(force(60, 30, 0.05, 10, 10, 4, 30).mean_force_n == 0);
  // A lag of whole pitches makes the force constant: peak = mean.
  const double lag_turn = std::atan(2 * pi / 4 * 10 / 10) / rad;
  CHECK(lag_turn < 60);
  const MillingForce even = force(10, 100, 0.05, 10, 10, 4, lag_turn);
  CHECK(even.peak_force_n == Approx(even.mean_force_n).epsilon(1e-9));
}

TEST_CASE("K301: stabilised and constant feed, the card's example", "[K301]") {
  const PolygonTime slow = polygon_milling_time(example(FeedStrategy::constant));
  const PolygonTime fast = polygon_milling_time(example(FeedStrategy::stabilized));
  CHECK(slow.loop_time_min == Approx(1.127).margin(1e-3));
  CHECK(fast.loop_time_min == Approx(0.672).margin(1e-3));
  CHECK(fast.feed_low_mm_min == Approx(178).margin(0.5));
  CHECK(fast.feed_high_mm_min == 600);
  CHECK(rc::check([] {
    PolygonPass in = example(FeedStrategy::constant);
    in.faces = *rc::gen::inRange<std::int64_t>(3, 8);
    in.blank_radius_mm = 21.65 + *rc::gen::inRange(0, 120) * 0.1;
    in.force_limit_n = *rc::gen::inRange(100, 3000);
    in.x_rate_max_mm_min = *rc::gen::inRange(100, 2000);
    in.c_rate_max_deg_min = *rc::gen::inRange(200, 3000);
    const PolygonTime constant = polygon_milling_time(in);
    in.strategy = FeedStrategy::stabilized;
    const PolygonTime stabilized = polygon_milling_time(in);
    RC_ASSERT(stabilized.loop_time_min <= constant.loop_time_min * (1 + 1e-12));
    if (stabilized.feed_low_mm_min > in.feed_min_mm_min)
      RC_ASSERT(stabilized.peak_force_high_n <= in.force_limit_n * (1 + 1e-9));
  }));
}

TEST_CASE("K301: bad input names itself", "[K301]") {
  CHECK_THROWS_WITH(verify_gcode_feed({{60, 61, 61}, {0, 1, 2}, {100, 100, 100}, false}),
                    "K301.verify_gcode_feed: x_mm/2 = 61, must differ from block 1: dx/dc is undefined");
  CHECK_THROWS_WITH(verify_gcode_feed({{60, 61}, {0, 1, 2}, {100, 100}, false}),
                    Catch::Contains("c_deg has 3 entries, must have as many as x_mm, 2"));
  CHECK_THROWS_WITH(gcode_flat_fit({{60, 61}, {5, 5}}), Catch::Contains("must differ between the points"));
  CHECK_THROWS_WITH(block_path_feed({{60, 1, 60, 2, FeedMode::radial, false}, 100}),
                    Catch::Contains("x2_mm = 60, must differ from x1_mm"));
  CHECK_THROWS_WITH(feed_word_for_block({{60, 1, 60, 1, FeedMode::c_rate, false}, 100}),
                    Catch::Contains("must have a length"));
  CHECK_THROWS_WITH(arc(polygon(6, 30, 8), 29, 0),
                    "K301.polygon_engagement: blank_radius_mm = 29, must not be below apothem_mm");
  CHECK_THROWS_WITH(tooth_pass_maxima({{1, 2}, {1, 2}, {0}, {2}}), Catch::Contains("end_index/0 = 2"));
}
