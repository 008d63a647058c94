// The checks of card K304; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>
#include <numeric>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/gears/k304_disc_cutter_roughing.h"

using namespace verstat::models;
using namespace verstat::models::k304;

namespace {

// The split scheme of the card, module 10.
SplitCut split(double feed_mm_min, double second_deg) {
  SplitCut in;
  static_cast<InsertLayout&>(in) = split_profile_inserts({10, 22.5});
  in.depth_mm = 22.5;
  in.feed_mm_min = feed_mm_min;
  in.rpm = 110;
  in.kc11_mpa = 1900;
  in.mc = 0.25;
  in.second_cutter_offset_deg = second_deg;
  return in;
}

// All six positions on each of `teeth` full-profile teeth.
SplitForce full_profile(std::int64_t teeth) {
  // Full-profile teeth: the six parts of the edge stand at one angle; summed from single-insert cutters.
  const SplitCut all = split(120, -1);
  SplitForce sum{};
  for (std::size_t k = 0; k < all.widths_mm.size(); ++k) {
    SplitCut one = all;
    one.groups = teeth;
    one.widths_mm = {all.widths_mm[k]};
    one.lead_angles_deg = {all.lead_angles_deg[k]};
    one.radial_offsets_mm = {all.radial_offsets_mm[k]};
    sum.mean_force_n += split_scheme_force(one).mean_force_n;
  }
  return sum;
}

}  // namespace

TEST_CASE("K304: Table 2 and the tool lives are reproduced", "[K304]") {
  const double rows[3][5] = {{8, 110, 120, 100, 110}, {10, 110, 120, 90, 100}, {12, 90, 100, 80, 90}};
  for (const auto& [module_mm, rpm1, feed1, rpm2, feed2] : rows) {
    const Regime soft = recommended_regime({module_mm, 217});
    CHECK(soft.rpm == rpm1);
    CHECK(soft.feed_mm_min == feed1);
    CHECK(soft.speed_printed_m_min == 120);
    const Regime hard = recommended_regime({module_mm, 217.5});
    CHECK(hard.rpm == rpm2);
    CHECK(hard.feed_mm_min == feed2);
    CHECK(hard.speed_printed_m_min == 100);
    CHECK(recommended_regime({module_mm, 150, true}).feed_mm_min == Approx(0.8 * feed1));
  }
  CHECK(recommended_regime({12, 240}).speed_actual_m_min == Approx(71.6).margin(0.05));
  CHECK(disc_cutter_life({}).life_mid_min == 180);
  CHECK(disc_cutter_life({true, true}).life_low_min == Approx(390));
  CHECK(disc_cutter_life({true, true}).life_high_min == Approx(540));
  CHECK(disc_cutter_life({true, true}).life_mid_min == Approx(465));
}

TEST_CASE("K304: rpm inverts speed, feeds compose", "[K304]") {
  CHECK(rc::check([] {
    const double d = *rc::gen::inRange(50, 500), n = *rc::gen::inRange(10, 900);
    RC_ASSERT(std::abs(disc_cutter_rpm({d, disc_cutter_speed({d, n}).cutting_speed_m_min}).rpm - n) < 1e-9);
    const std::int64_t teeth = *rc::gen::inRange<std::int64_t>(1, 40);
    const CutterFeeds f = disc_cutter_feeds({120, n, teeth});
    RC_ASSERT(std::abs(f.feed_mm_tooth * static_cast<double>(teeth) * n - 120) < 1e-9);
  }));
}

TEST_CASE("K304: a pair of cutters halves strokes: cutting x 1.6, return and indexing x 2", "[K304]") {
  const GapTime one = gap_time({360, 120, 1200, 0.5});
  const GapTime two = gap_time({360, 96, 1200, 0.5});
  const auto strokes = [](std::int64_t k) { return gear_roughing_time({1, 60, k}).strokes; };
  CHECK(strokes(2) * 2 == strokes(1));
  CHECK(one.working_min * 60 / (two.working_min * 30) == Approx(1.6));
  CHECK(one.return_min * 60 / (two.return_min * 30) == Approx(2));
}

TEST_CASE("K304: whole strokes never take less than the printed time", "[K304]") {
  CHECK(rc::check([] {
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(1, 300), k = *rc::gen::inRange<std::int64_t>(1, 5);
    const RoughingTime t = gear_roughing_time({2.5, z, k});
    RC_ASSERT(t.main_time_whole_strokes_min >= t.main_time_min * (1 - 1e-12));
    if (z % k == 0) RC_ASSERT(std::abs(t.main_time_whole_strokes_min - t.main_time_min) < 1e-9);
    RC_ASSERT(std::abs(gear_roughing_time({2.5, 2 * z, k}).main_time_min - 2 * t.main_time_min) < 1e-9);
  }));
}

TEST_CASE("K304: the split profile covers the gap", "[K304]") {
  CHECK(rc::check([] {
    const double m = *rc::gen::inRange(8, 21), alpha = *rc::gen::inRange(10, 25);
    const GapShape shape{m, 2 * m, *rc::gen::inRange(0, 15) * 0.1, alpha};
    RC_PRE(std::numbers::pi * m / 2 - shape.allowance_mm > 2 * m * std::tan(alpha * std::numbers::pi / 180));
    const GapSection gap = rack_gap_section(shape);
    const InsertLayout inserts = split_profile_inserts(shape);
    double width = 0, area = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      width += inserts.widths_mm[k];
      area += inserts.widths_mm[k] * (shape.depth_mm - inserts.radial_offsets_mm[k]);
    }
    RC_ASSERT(std::abs(width - gap.top_width_mm) < 1e-11);
    RC_ASSERT(std::abs(area - gap.area_mm2) < 1e-9);
  }));
  CHECK(rack_gap_section({10, 22.5}).area_mm2 == Approx(314.956).margin(5e-4));
}

TEST_CASE("K304: forces of the card's example", "[K304]") {
  const SplitForce one = split_scheme_force(split(120, -1));
  CHECK(one.mean_force_n == Approx(1816).margin(0.5));
  CHECK(one.peak_force_n == Approx(3654).margin(2));
  CHECK(one.mean_power_kw == Approx(2.85).margin(5e-3));
  CHECK(full_profile(5).mean_force_n == Approx(one.mean_force_n).epsilon(1e-4));
  CHECK(full_profile(30).mean_force_n == Approx(2842).margin(1));
  CHECK(1 - one.mean_force_n / full_profile(30).mean_force_n == Approx(0.36).margin(5e-3));
}

TEST_CASE("K304: two cutters", "[K304]") {
  const auto peak = [](double offset_deg) { return split_scheme_force(split(96, offset_deg)).peak_force_n; };
  CHECK(peak(0) == Approx(6181).margin(2));
  CHECK(peak(12) == Approx(6181).margin(2));
  CHECK(peak(6) == Approx(5614).margin(2));
  CHECK(peak(28.5) == Approx(4777).margin(15));
  double least = 1e9;
  for (double offset = 0; offset <= 72; offset += 0.5) {
    const SplitForce f = split_scheme_force(split(96, offset));
    CHECK(f.mean_force_n == Approx(3072).margin(1));
    least = std::min(least, f.peak_force_n);
    if (offset == 5 || offset == 20) {
      CHECK(f.peak_force_n == Approx(peak(offset + 72)).epsilon(1e-3));
      CHECK(f.peak_force_n == Approx(peak(72 - offset)).epsilon(1e-3));
    }
  }
  CHECK(least == Approx(4777).margin(15));
}

TEST_CASE("K304: the sum is that of single inserts over the whole turn", "[K304]") {
  // Straight from the definition: inserts j, lag j * 360/(N groups), a whole turn in fine steps.
  const SplitCut in = split(120, -1);
  const double radius = 142.5, f_g = 120.0 / 110 / 5, rad = std::numbers::pi / 180;
  double mean = 0, peak = 0;
  constexpr int steps = 36'000;
  for (int i = 0; i < steps; ++i) {
    double sum = 0;
    for (int j = 0; j < 30; ++j) {
      const auto k = static_cast<std::size_t>(j % 6);
      const double phi = std::fmod((i + 0.5) * 0.01 - j * 12.0 + 720, 360) * rad;
      const double kappa = in.lead_angles_deg[k] * rad;
      if (phi > 0 && phi <= std::acos((radius - 22.5) / (radius - in.radial_offsets_mm[k])))
        sum +=
            1900 * in.widths_mm[k] / std::sin(kappa) * std::pow(f_g * std::sin(phi) * std::sin(kappa), 0.75);
    }
    mean += sum / steps;
    peak = std::max(peak, sum);
  }
  const SplitForce force = split_scheme_force(in);
  CHECK(force.mean_force_n == Approx(mean).epsilon(1e-9));
  CHECK(force.peak_force_n == Approx(peak).epsilon(1e-9));
}

TEST_CASE("K304: life and consumption", "[K304]") {
  CHECK(life_at_speed({360, 100, 100, 0.25}).life_min == 360);
  CHECK(life_at_speed({360, 100, 200, 0.25}).life_min == Approx(360.0 / 16));
  const InsertConsumption use = insert_consumption({360, 3, 60, 2, 30, 4});
  CHECK(use.gaps_per_life == Approx(240));
  CHECK(use.changes_per_part == Approx(0.25));
  CHECK(use.inserts_per_part == Approx(0.25 * 30 * 2 / 4));
}

TEST_CASE("K304: bad input names itself", "[K304]") {
  CHECK_THROWS_WITH(recommended_regime({9, 200}),
                    "K304.recommended_regime: module_mm = 9, must be 8, 10 or 12: the table has no other");
  CHECK_THROWS_WITH(recommended_regime({8, 241}), Catch::Contains("hardness_hb = 241, allowed"));
  CHECK_THROWS_WITH(rack_gap_section({10, 60}), Catch::Contains("depth_mm = 60, leaves no width"));
  SplitCut in = split(120, -1);
  in.radial_offsets_mm[3] = 30;
  CHECK_THROWS_WITH(split_scheme_force(in),
                    Catch::Contains("radial_offsets_mm/3 = 30, must be below depth_mm"));
  in.lead_angles_deg.pop_back();
  CHECK_THROWS_WITH(split_scheme_force(in), Catch::Contains("lead_angles_deg has 5 entries"));
}
