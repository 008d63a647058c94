// Thread rolling, winding of screw flights, reaming: the effects that their papers show.
#include <cmath>

#include "operations/kinds/auger_winding.h"
#include "operations/kinds/cutting_off.h"
#include "operations/kinds/gear_generating.h"
#include "operations/kinds/reaming.h"
#include "operations/kinds/thread_rolling.h"
#include "operations/spindle.h"
#include "tests/operations/gallery.h"

using namespace verstat;
using namespace verstat::operations;
using Catch::Matchers::Contains;
using namespace verstat::test;

TEST_CASE("thread rolling: the quality of the blanks drives the force", "[K407]") {
  GalleryExample<ThreadRolling> example;
  const auto poor = example.plan();
  CHECK(poor.feasible());
  auto good = example.spec;
  good.blanks = {};
  const auto force_kn = [&](const ThreadRolling& spec) {
    return value_of(example.Gallery::plan(spec), "radial_force_kn");
  };
  CHECK(force_kn(example.spec) / force_kn(good) == Approx(1.15 * 1.25));
  // Twice the lead-in ridges: thinner layers, less force.
  auto gentle = good;
  gentle.lead_in_drop_mm.clear();
  for (std::size_t k = 0; k < example.spec.lead_in_drop_mm.size(); ++k) {
    const double drop_mm = example.spec.lead_in_drop_mm[k];
    const double before_mm = k == 0 ? 2.17 : example.spec.lead_in_drop_mm[k - 1];
    gentle.lead_in_drop_mm.push_back((drop_mm + before_mm) / 2);
    gentle.lead_in_drop_mm.push_back(drop_mm);
  }
  CHECK(value_of(example.Gallery::plan(gentle), "layer_mm") < value_of(poor, "layer_mm"));
  CHECK(force_kn(gentle) < force_kn(good));
  // Depth and approach at the feed, then the sizing revolutions, at the speed of the blank.
  CHECK(poor.main_time_min * value_of(poor, "blank_rpm") ==
        Approx((value_of(poor, "penetration_mm") + example.spec.approach_mm) / example.spec.feed_mm_rev +
               example.spec.sizing_revolutions));
  auto thick = example.spec;
  thick.blank_diameter_mm = value_of(poor, "full_profile_blank_mm") + 0.1;
  CHECK_FALSE(limit_of(example.Gallery::plan(thick), "blank_difference_mm").met());
  auto rising = example.spec;
  rising.lead_in_drop_mm = {0.2, 0.4};
  CHECK_THAT(refusal(rising), Contains("drop_mm"));
}

TEST_CASE("auger winding: the inner edge thickens, and a thin strip does not suffice", "[K306]") {
  GalleryExample<AugerWinding> example;
  const auto p = example.plan();
  CHECK(p.feasible());
  CHECK(value_of(p, "inner_edge_mm") == Approx(3));
  CHECK(value_of(p, "strip_thickness_mm") < 3);
  CHECK(value_of(p, "outer_edge_mm") < value_of(p, "strip_thickness_mm"));
  CHECK(value_of(p, "turns") < 10);  // 1000 mm at a pitch of 100 mm: the coil has fewer turns than the screw
  CHECK(p.main_time_min == Approx(4 + value_of(p, "turns") / 12));
  auto thin = example.spec;
  thin.strip_thickness_mm = 2;
  CHECK_FALSE(limit_of(example.Gallery::plan(thin), "inner_edge_mm").met());
  auto two = example.spec;
  two.turns_per_winding = 6;
  CHECK(example.Gallery::plan(two).main_time_min == Approx(p.main_time_min + 4));
  auto strong = example.spec;
  strong.flow_stress_mpa = 800;
  CHECK(value_of(example.Gallery::plan(strong), "winding_force_n") ==
        Approx(2 * value_of(p, "winding_force_n")));
  auto inside_out = example.spec;
  inside_out.inner_diameter_mm = 200;
  CHECK_FALSE(refusal(inside_out).empty());
}

TEST_CASE("reaming: the holder of the machine decides the speed that a long tool allows", "[K408]") {
  GalleryExample<Reaming> example;
  const auto in_holder = [&](ToolHolder holder) {
    Spindle spindle = *example.file.spindle;
    spindle.holder = holder;
    auto context = example.context();
    context.spindle = &spindle;
    return operations::detail::plan_of(example.spec, context);
  };
  const auto rigid = in_holder(ToolHolder::rigid);
  const auto rocking = in_holder(ToolHolder::rocking);
  const auto floating = in_holder(ToolHolder::floating);
  // K408: the rigid scheme has the highest first frequency, a floating tip the lowest.
  CHECK(value_of(rigid, "natural_frequency_hz") > value_of(rocking, "natural_frequency_hz"));
  CHECK(value_of(rocking, "natural_frequency_hz") > value_of(floating, "natural_frequency_hz"));
  for (const auto& p : {rigid, rocking, floating}) {
    // Eight teeth at the allowed speed meet four fifths of the frequency.
    const double rpm = value_of(p, "speed_limit_m_min") * 1000 / (3.14159265358979 * 20);
    CHECK(rpm * 8 / 60 == Approx(0.8 * value_of(p, "natural_frequency_hz")));
    CHECK(p.main_time_min == rigid.main_time_min);
  }
  auto fast = example.spec;
  fast.cutting_speed_m_min = 60;
  CHECK_FALSE(limit_of(example.Gallery::plan(fast), "cutting_speed_m_min").met());
  auto ragged = example.spec;
  ragged.segment_outer_mm.pop_back();
  CHECK_FALSE(refusal(ragged).empty());
}

TEST_CASE("cutting off: below the least feed the side grains rub", "[K104]") {
  GalleryExample<CuttingOff> example;
  const auto p = example.plan();
  CHECK(p.feasible());
  CHECK(p.main_time_min == Approx(75.5 / 10 / 60));
  CHECK(value_of(p, "side_grain_regime") == 2);
  // At the least feed the grains reach just the depth that is wanted.
  auto least = example.spec;
  least.radial_feed_mm_s = value_of(p, "radial_feed_min_mm_s");
  CHECK(value_of(example.Gallery::plan(least), "relative_depth") == Approx(0.08));
  auto slow = example.spec;
  slow.radial_feed_mm_s = 2;
  const auto rubbing = example.Gallery::plan(slow);
  CHECK_FALSE(limit_of(rubbing, "radial_feed_mm_s").met());
  CHECK(value_of(rubbing, "side_grain_regime") < 2);
  // A thinner wheel saves bar: kerf and side layer.
  auto thin = example.spec;
  thin.wheel_thickness_mm = 3;
  CHECK(p.consumables.at(0).value - example.Gallery::plan(thin).consumables.at(0).value == Approx(1));
  auto thick = example.spec;
  thick.workpiece_diameter_mm = 150;
  CHECK_THAT(refusal(thick), Contains("workpiece_diameter_mm"));
}

TEST_CASE("gear generating: the crossing of the axes makes the cutting speed", "[K202][K405]") {
  GalleryExample<GearGenerating> example;
  const auto p = example.plan();
  CHECK(p.feasible());
  constexpr double pi = 3.14159265358979;
  CHECK(value_of(p, "cutting_speed_m_min") == Approx(pi * 60 * 500 / 1000 * std::tan(25 * pi / 180)));
  CHECK(p.main_time_min ==
        Approx(3 * (25 + 8) / std::cos(25 * pi / 180) / (0.3 * value_of(p, "gear_speed_rpm"))));
  auto wide = example.spec;
  wide.shaft_angle_deg = 40;
  CHECK_FALSE(example.Gallery::plan(wide).feasible());  // above 60 m/min
  auto narrow = example.spec;
  narrow.shaft_angle_deg = 10;
  CHECK_FALSE(example.Gallery::plan(narrow).feasible());  // too slow to cut
  // Hertz: the pressure goes with the root of the load.
  auto loaded = example.spec;
  loaded.contact->load_n_mm *= 4;
  CHECK(value_of(example.Gallery::plan(loaded), "contact_pressure_mpa") ==
        Approx(2 * value_of(p, "contact_pressure_mpa")));
}
