#include "operations/kinds/slot_milling.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/k105_tslot_chip_reinteraction.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::margin_of;
using verstat::test::value_of;

TEST_CASE("slot milling: a chip device keeps the tolerance at a feed that chips would spoil",
          "[slot_milling]") {
  const auto gallery = test::Gallery("slot_milling");
  SlotMilling spec = gallery.spec<SlotMilling>();
  const CutPlan device = plan(spec, gallery.context());
  CHECK(device.feasible());
  CHECK(value_of(device, "added_share") == Approx(0.125));
  spec.evacuation = ChipEvacuation::none;
  const CutPlan none = plan(spec, gallery.context());
  CHECK(value_of(none, "added_share") == Approx(0.25));
  CHECK(margin_of(none, "side_error_um") < 0);
  CHECK(value_of(none, "side_error_um") / value_of(device, "side_error_um") == Approx(1.25 / 1.125));
  CHECK(none.main_time_min == device.main_time_min);

  // The force grows with f^(1-mc): without the device the feed must fall by this much.
  const double fall = std::pow(37 / value_of(none, "side_error_um"), 1 / 0.75);
  spec.table_feed_mm_min *= fall;
  const CutPlan slower = plan(spec, gallery.context());
  CHECK(margin_of(slower, "side_error_um") == Approx(0).margin(1e-12));
  CHECK(slower.main_time_min == Approx(device.main_time_min / fall));
  CHECK(slower.main_time_min > 1.05 * device.main_time_min);
}

TEST_CASE("slot milling: plan numbers are those of K105", "[slot_milling]") {
  const auto gallery = test::Gallery("slot_milling");
  SlotMilling spec = gallery.spec<SlotMilling>();
  spec.evacuation = ChipEvacuation::none;
  spec.lateral_force_n = 400;
  const CutPlan p = plan(spec, gallery.context());
  CHECK(p.main_time_min == Approx(3 * (0.75 + 15.0 / 160)));
  CHECK(value_of(p, "cutting_speed_m_min") == Approx(20.8).margin(0.05));
  CHECK(value_of(p, "cutting_fraction") == Approx(0.306).margin(5e-4));
  CHECK(value_of(p, "total_lateral_force_n") == Approx(500));
  CHECK(value_of(p, "mean_recuts") == Approx(0.63 / 0.37));
  models::k105::FormErrorInputs bending;
  bending.lateral_force_n = 400;
  bending.added_share = 0.25;
  bending.overhang_mm = 20;
  bending.stem_diameter_mm = 11;
  bending.cutter_diameter_mm = 21;
  bending.elastic_modulus_mpa = 210'000;
  CHECK(value_of(p, "side_error_um") == models::k105::t_slot_form_error(bending).side_um);
  CHECK(value_of(p, "face_error_um") == models::k105::t_slot_form_error(bending).face_um);
}

TEST_CASE("slot milling: better evacuation never bends the stem more", "[slot_milling]") {
  const auto gallery = test::Gallery("slot_milling");
  test::property([&] {
    SlotMilling spec = gallery.spec<SlotMilling>();
    spec.reinteraction_share = *rc::gen::inRange(0, 101) * 0.01;
    spec.evacuation_efficiency = *rc::gen::inRange(0, 100) * 0.01;
    const double before = *plan(spec, {}).value_of("side_error_um");
    spec.evacuation_efficiency += 0.01;
    const CutPlan better = plan(spec, {});
    RC_ASSERT(*better.value_of("side_error_um") <= before);
    RC_ASSERT(*better.value_of("added_share") <= 0.25);
  });
}

TEST_CASE("slot milling: errors name what is wrong", "[slot_milling]") {
  SlotMilling spec = test::Gallery("slot_milling").spec<SlotMilling>();
  spec.stem_diameter_mm = 12;
  CHECK(test::refusal(spec) ==
        "stem_diameter_mm = 12, must be below the throat width: the stem runs in the throat");
  spec.throat_width_mm = 21;
  CHECK(test::refusal(spec) == "throat_width_mm = 21, must be below the cutter diameter");
}
