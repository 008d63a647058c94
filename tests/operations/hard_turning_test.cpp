#include "operations/kinds/hard_turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/toolpath/k107_round_insert_notch_clashes.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::limit_of;
using verstat::test::refusal;
using verstat::test::value_of;

namespace {

HardTurning example() {
  return test::Gallery("hard_turning").spec<HardTurning>();
}

bool in_a_band(const CutPlan& p, const std::string& knob) {
  return std::any_of(p.bands.begin(), p.bands.end(),
                     [&](const ForbiddenBand& b) { return knob == b.name && b.inside(); });
}

double part(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) * 1e-3;
}

}  // namespace

TEST_CASE("hard turning: a feed of 0.30 mm/rev is forbidden on the shaped part, 0.42 is not") {
  const test::Gallery gallery("hard_turning");
  HardTurning t = example();
  const CutPlan forbidden = gallery.file.process.plan(gallery.context());
  CHECK(in_a_band(forbidden, "feed_mm_rev"));
  CHECK_FALSE(in_a_band(forbidden, "depth_of_cut_mm"));
  CHECK_FALSE(forbidden.feasible());
  CHECK(forbidden.scrap_probability == 0.2);
  // Card K107: 0.3053 mm/rev is the forbidden feed of a slope of 2.5 degrees, r 3.5 mm.
  const auto band = std::find_if(forbidden.bands.begin(), forbidden.bands.end(),
                                 [](const ForbiddenBand& b) { return b.inside(); });
  CHECK(band->low < 0.3053);
  CHECK(band->high > 0.3053);

  t.feed_mm_rev = 0.42;
  const CutPlan free = plan(t, gallery.context());
  CHECK(free.bands.size() == forbidden.bands.size());
  CHECK(free.feasible());
  CHECK(free.scrap_probability == 0);
  CHECK(value_of(free, "notch_margin_deg") > 0);
  CHECK(free.main_time_min == Approx(std::numbers::pi * 40 * 280 / (1000 * 120 * 0.42)));
}

TEST_CASE("hard turning: the depth that a rise of 20 degrees forbids") {
  HardTurning t = example();
  t.feed_mm_rev = 0.5;
  t.depth_of_cut_mm = 0.2111;  // card K107
  CHECK(in_a_band(plan(t, {}), "depth_of_cut_mm"));
  t.depth_of_cut_mm = 0.15;
  CHECK_FALSE(in_a_band(plan(t, {}), "depth_of_cut_mm"));
}

TEST_CASE("hard turning: the bands forbid exactly what the pair rule of K107 finds") {
  test::property([] {
    HardTurning t = example();
    const int count = *rc::gen::inRange(2, 6);
    t.segments.clear();
    for (int k = 0; k < count; ++k) t.segments.push_back({50, part(-40, 40)});
    t.feed_mm_rev = part(0.1, 0.9);
    t.depth_of_cut_mm = part(0.02, 0.5);
    t.notch_half_width_mm = part(0.01, 0.2);
    t.persistent_edge = *rc::gen::arbitrary<bool>();
    const CutPlan p = plan(t, {});

    models::k107::Profile profile;
    for (const auto& s : t.segments) profile.slopes_deg.push_back(s.slope_deg);
    profile.radius_mm = t.insert_radius_mm;
    profile.feed_mm_rev = t.feed_mm_rev;
    profile.depth_mm = t.depth_of_cut_mm;
    profile.half_width_mm = t.notch_half_width_mm;
    profile.persistent = t.persistent_edge;
    const auto found = models::k107::profile_clashes(profile);
    RC_PRE(std::abs(found.margin_deg) > 1e-6);
    // A clash across zero turn (trailing notch within the guard of the tip's own place) belongs to no band.
    const double guard_deg = t.notch_half_width_mm / t.insert_radius_mm * 180 / std::numbers::pi;
    bool opposite = false;
    for (const auto& c : found.clashes) {
      const double turn = profile.slopes_deg[static_cast<std::size_t>(c.clashing)] -
                          profile.slopes_deg[static_cast<std::size_t>(c.marking)];
      opposite = opposite || std::abs(turn) <= 2 * guard_deg;
    }
    RC_PRE(!opposite);
    RC_ASSERT(found.clashes.empty() == (!in_a_band(p, "feed_mm_rev") && !in_a_band(p, "depth_of_cut_mm")));
  });
}

TEST_CASE("hard turning: the radial force grows far faster with wear than the main force") {
  HardTurning t = example();
  const CutPlan p = plan(t, {});
  // Card K106: after 40 min of cutting the radial force is four times, the main force 1.2 times the sharp
  // one.
  CHECK(value_of(p, "radial_force_at_time_n") / value_of(p, "radial_force_sharp_n") == Approx(4));
  CHECK(value_of(p, "main_force_at_time_n") / value_of(p, "main_force_sharp_n") == Approx(1.2));
  // k_y 20 and k_z 4/3 per mm: the same growth at a wear of 0.15 mm.
  CHECK(value_of(p, "radial_force_worn_n") / value_of(p, "radial_force_sharp_n") == Approx(4));
  CHECK(value_of(p, "main_force_worn_n") / value_of(p, "main_force_sharp_n") == Approx(1.2));
}

TEST_CASE("hard turning: published forces of the flat rake") {
  HardTurning t = example();
  t.rake = models::k106::Rake::flat;
  t.cutting_speed_m_min = 60;
  t.feed_mm_rev = 0.14;
  t.depth_of_cut_mm = 0.1;
  t.flank_wear_mm = 0.1;
  t.cutting_time_min.reset();
  const CutPlan p = plan(t, {});
  CHECK(value_of(p, "radial_force_sharp_n") == Approx(100));
  CHECK(value_of(p, "radial_force_worn_n") == Approx(250));
  CHECK(value_of(p, "main_force_worn_n") == Approx(120));
  CHECK(value_of(p, "flank_pressure_mpa") == Approx(1651).margin(1));
}

TEST_CASE("hard turning: the radial-force limit is met up to the wear that the plan names") {
  HardTurning t = example();
  t.cutting_time_min.reset();
  const double wear_mm = value_of(plan(t, {}), "wear_at_force_limit_mm");
  REQUIRE(wear_mm > 0.05);
  t.flank_wear_mm = wear_mm * 0.999;
  CHECK(limit_of(plan(t, {}), "radial_force_n").met());
  t.flank_wear_mm = wear_mm * 1.001;
  CHECK_FALSE(limit_of(plan(t, {}), "radial_force_n").met());
}

TEST_CASE("hard turning: the deflection of a slender part is the limit, not the power") {
  HardTurning t = example();
  t.feed_mm_rev = 0.42;
  t.radial_force_max_n.reset();
  const CutPlan stout = plan(t, {});
  CHECK(stout.feasible());
  CHECK(value_of(stout, "power_kw") < 1);
  t.diameter_mm = 20;
  const CutPlan slender = plan(t, {});
  CHECK_FALSE(limit_of(slender, "deflection_um").met());
  CHECK(value_of(slender, "deflection_um") == Approx(16 * value_of(stout, "deflection_um")));
}

TEST_CASE("hard turning: ceramic chatters between 60 and 100 m/min, ends included, from 0.1 mm depth") {
  HardTurning t = example();
  t.feed_mm_rev = 0.42;
  t.tool_material = models::k106::ToolMaterial::ceramic;
  for (const auto& [speed, chatters] :
       {std::pair{59.9, false}, {60.0, true}, {100.0, true}, {100.1, false}}) {
    t.cutting_speed_m_min = speed;
    t.depth_of_cut_mm = 0.1;
    CHECK(in_a_band(plan(t, {}), "cutting_speed_m_min") == chatters);
    t.depth_of_cut_mm = 0.09;
    CHECK_FALSE(in_a_band(plan(t, {}), "cutting_speed_m_min"));
  }
}

TEST_CASE("hard turning: bad specifications are named") {
  HardTurning t = example();
  t.length_between_centres_mm.reset();
  CHECK(refusal(t) == "deflection_max_um = 60, needs the member \"length_between_centres_mm\"");
  t = example();
  t.insert_radius_mm = 1;
  CHECK(refusal(t).find("r = 1, allowed 2 <= r <= 16") != std::string::npos);
  t = example();
  t.least_concave_radius_mm = 3;
  CHECK_FALSE(limit_of(plan(t, {}), "least_concave_radius_mm").met());
}
