#include "operations/kinds/rk_milling.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using models::s3::Spacing;
using verstat::test::margin_of;
using verstat::test::value_of;

TEST_CASE("RK milling: the tolerance decides cutter radius and teeth", "[rk_milling]") {
  const auto gallery = test::Gallery("rk_milling");
  const RkMilling spec = gallery.spec<RkMilling>();
  const CutPlan chosen = plan(spec, gallery.context());
  CHECK(chosen.feasible());
  CHECK(value_of(chosen, "cutter_radius_mm") == Approx(24.5137 - 0.1).margin(1e-4));
  CHECK(value_of(chosen, "teeth") <= 22);
  CHECK(chosen.main_time_min == Approx(3.4 / 20 + 2 / 100.0));

  // S3's fewest teeth for 0.2 mm.
  const struct {
    double radius_mm;
    int uniform, equalised;
  } card[] = {{18, 75, 53}, {20, 41, 34}, {22, 28, 25}, {24, 22, 20}};
  for (const auto& row : card) {
    RkMilling given = spec;
    given.cutter_radius_mm = row.radius_mm;
    const CutPlan uniform = plan(given, gallery.context());
    CHECK(value_of(uniform, "teeth") == row.uniform);
    CHECK(uniform.feasible());
    given.spacing = Spacing::equalised;
    const CutPlan equalised = plan(given, gallery.context());
    CHECK(value_of(equalised, "teeth") == row.equalised);
    CHECK(margin_of(equalised, "form_deviation_mm") >= 0);
    given.spacing = Spacing::uniform;
    given.teeth = row.uniform - 2;  // one tooth on the flat and one at the lobe tip need an even step
    CHECK(margin_of(plan(given, gallery.context()), "form_deviation_mm") < 0);
  }
}

TEST_CASE("RK milling: numbers of S3's Table 1, cutters outside their limits", "[rk_milling]") {
  const auto gallery = test::Gallery("rk_milling");
  RkMilling spec = gallery.spec<RkMilling>();
  spec.cutter_radius_mm = 24;
  spec.teeth = 20;
  const CutPlan p = plan(spec, gallery.context());
  CHECK(value_of(p, "cusp_mm") == Approx(0.223).margin(5e-4));
  CHECK(value_of(p, "it_grade") == 13);
  CHECK(margin_of(p, "form_deviation_mm") < 0);
  CHECK(value_of(p, "cutting_speed_lobe_m_min") == Approx(24.4).margin(0.05));
  CHECK(value_of(p, "cutting_speed_flat_m_min") == Approx(15.8).margin(0.05));
  CHECK(value_of(p, "cutter_speed_rpm") == Approx(300));
  spec.cutter_radius_mm = 25;  // undercuts the lobe tip
  CHECK_FALSE(plan(spec, gallery.context()).feasible());
  spec.cutter_radius_mm = 15;  // tracks that loop
  CHECK_FALSE(plan(spec, gallery.context()).feasible());
}

TEST_CASE("RK milling: run-out uses up tolerance and asks for more teeth", "[rk_milling]") {
  const auto gallery = test::Gallery("rk_milling");
  test::property([&] {
    RkMilling spec = gallery.spec<RkMilling>();
    spec.form_tolerance_mm = *rc::gen::inRange(10, 40) * 0.01;
    const CutPlan still = plan(spec, {});
    RC_ASSERT(still.feasible() || *still.value_of("it_grade") > 13);
    spec.run_out_mm = 0.05;
    const CutPlan running = plan(spec, {});
    RC_ASSERT(*running.value_of("teeth") >= *still.value_of("teeth"));
    RC_ASSERT(margin_of(running, "form_deviation_mm") >= 0);
  });
}

TEST_CASE("RK milling: errors name what is wrong", "[rk_milling]") {
  RkMilling spec = test::Gallery("rk_milling").spec<RkMilling>();
  spec.run_out_mm = 0.2;
  CHECK(test::refusal(spec) == "run_out_mm = 0.2, must be below the form tolerance, which it uses up");
  spec.run_out_mm = 0;
  spec.eccentricity_mm = 4.9;
  CHECK(test::refusal(spec).find("eccentricity_mm = 4.9, no cutter both clears") == 0);
}
