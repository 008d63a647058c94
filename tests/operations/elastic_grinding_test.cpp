// Elastic grinding: the clamp force sets the depth, the phase transformation limits the force.

#include "operations/kinds/elastic_grinding.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

namespace verstat::operations {
namespace {

using test::limit_of;

ElasticGrinding example() {
  return test::Gallery("elastic_grinding").spec<ElasticGrinding>();
}

TEST_CASE("elastic grinding: the example is feasible and survives JSON") {
  const MachineLimits machine = test::Gallery("elastic_grinding").file.machine_limits;
  PlanContext context;
  context.machine = &machine;
  const CutPlan p = plan(example(), context);
  CHECK(p.feasible());
  REQUIRE(p.more_elements.size() == 1);
  CHECK(p.more_elements[0].mean_min == 30);
}

TEST_CASE("elastic grinding: the published pair of force and depth comes back") {
  // The state at 15 um, one minute after dressing, gives a force; that force gives 15 um.
  models::k118::ElasticInputs state;
  state.depth_um = 15;
  const auto truth = models::k118::elastic_grinding_state(state);
  ElasticGrinding s;
  s.clamp_force_n = truth.clamp_force_n;
  s.allowance_um = 30;
  s.stroke_length_mm = 60;
  const CutPlan p = plan(s, {});
  CHECK(*p.value_of("depth_um") == Approx(15).epsilon(1e-9));
  CHECK(*p.value_of("temperature_c") == Approx(truth.temperature_c).epsilon(1e-9));
  CHECK(*p.value_of("power_kw") == Approx(truth.power_kw).epsilon(1e-9));
  CHECK(*p.value_of("removal_rate_mm3_min") == Approx(truth.removal_rate_mm3_min).epsilon(1e-9));
  // Two passes (a hair above 15 um or below may make them three) of 0.01 min.
  CHECK(p.main_time_min == Approx(0.01 * *p.value_of("passes")));
}

TEST_CASE("elastic grinding: more force, fewer passes, until the steel transforms") {
  ElasticGrinding s = example();
  const double limit_n = *plan(s, {}).value_of("limit_clamp_force_n");
  // The card: about 36 um and 10.4 N/mm where 0.9 of the heat enters the part (a fresh wheel).
  s.time_after_dress_min = 1;
  const CutPlan fresh = plan(s, {});
  CHECK(*fresh.value_of("limit_depth_um") == Approx(36).epsilon(0.03));
  CHECK(*fresh.value_of("limit_clamp_force_n") / s.width_mm == Approx(10.4).epsilon(0.01));
  s = example();

  double time_min = 1e9;
  for (const double share : {0.4, 0.6, 0.8, 0.999}) {
    s.clamp_force_n = share * limit_n;
    const CutPlan p = plan(s, {});
    CHECK(limit_of(p, "temperature_c").met());
    CHECK(limit_of(p, "clamp_force_n").met());
    CHECK(p.main_time_min < time_min);
    time_min = p.main_time_min;
  }
  s.clamp_force_n = 1.001 * limit_n;
  const CutPlan burnt = plan(s, {});
  CHECK_FALSE(limit_of(burnt, "temperature_c").met());
  CHECK_FALSE(limit_of(burnt, "clamp_force_n").met());
}

TEST_CASE("elastic grinding: without burn in 1..60 um no force limit is claimed") {
  ElasticGrinding s = example();
  s.heat_fraction = 0.3;
  const CutPlan p = plan(s, {});
  CHECK(*p.value_of("limit_depth_um") == 60);
  for (const Limit& limit : p.limits) CHECK(std::string(limit.name) != "clamp_force_n");
  CHECK(p.feasible());
}

TEST_CASE("elastic grinding: a longer dressing interval cuts less at the same force") {
  ElasticGrinding s = example();
  s.time_after_dress_min = 5;
  const CutPlan sharp = plan(s, {});
  s.time_after_dress_min = 120;
  const CutPlan dull = plan(s, {});
  CHECK(*dull.value_of("depth_um") < *sharp.value_of("depth_um"));
  CHECK(dull.main_time_min >= sharp.main_time_min);
}

TEST_CASE("elastic grinding: bad specifications name the place") {
  ElasticGrinding s = example();
  s.clamp_force_n = 1e5;
  CHECK(test::refusal(s).find("clamp_force_n") != std::string::npos);
  s = example();
  s.critical_c = 100;
  s.ambient_c = 100;
  CHECK(test::refusal(s) == "critical_c = 100, must be above ambient_c");
  nlohmann::json json = test::Gallery("elastic_grinding").json.at("process");
  json["heat_fraction"] = 1.5;
  CHECK(test::refusal(json).find("heat_fraction = 1.5") != std::string::npos);
}

TEST_CASE("elastic grinding: force and width grow together") {
  test::property("width", [] {
    ElasticGrinding s = example();
    const double factor = *rc::gen::inRange(2, 6);
    const CutPlan one = plan(s, {});
    s.width_mm *= factor;
    s.clamp_force_n *= factor;
    const CutPlan wide = plan(s, {});
    RC_ASSERT(std::abs(*wide.value_of("depth_um") - *one.value_of("depth_um")) < 1e-6);
    RC_ASSERT(std::abs(*wide.value_of("power_kw") - factor * *one.value_of("power_kw")) <
              1e-6 * *wide.value_of("power_kw"));
  });
}

}  // namespace
}  // namespace verstat::operations
