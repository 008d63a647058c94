// Promises that seeded faults (tools/mutate.mjs) broke without any other test noticing.
#include <cmath>

#include "models/catalogue/error.h"
#include "models/dynamics/k206_spindle_base_frequencies.h"
#include "operations/duration.h"
#include "operations/kinds/face_milling.h"
#include "operations/kinds/hard_turning.h"
#include "operations/machine_load.h"
#include "operations/spindle.h"
#include "operations/taylor.h"
#include "tests/operations/gallery.h"

using namespace verstat;
using namespace verstat::operations;
using Catch::Matchers::Contains;
using test::GalleryExample;
using test::value_of;

TEST_CASE("the mean of every law of durations", "[duration]") {
  CHECK(mean_min(ConstantDuration{3}) == 3);
  CHECK(mean_min(ExponentialDuration{0.25}) == 4);
  CHECK(mean_min(UniformDuration{2, 8}) == 5);
  CHECK(mean_min(TriangularDuration{1, 2, 9}) == 4);
  CHECK(mean_min(LognormalDuration{7, 0.3}) == 7);
  CHECK(mean_min(GammaDuration{7, 0.3}) == 7);
  CHECK(mean_min(WeibullDuration{7, 0.3}) == 7);
  // Step: only the observed values. Linear: evenly between neighbours, (1 + 4) / 2 and (4 + 10) / 2 alike.
  EmpiricalDuration observed{.values_min = {4, 1, 10}, .between = BetweenValues::step};
  CHECK(mean_min(observed) == Approx(5));
  observed.between = BetweenValues::linear;
  CHECK(mean_min(observed) == Approx(4.75));
  // Weights 1, 2, 1 of 1, 4, 10: between two neighbours lies half the weight of each, 1.5 here and 1.5 there.
  observed.weights = {2, 1, 1};
  CHECK(mean_min(observed) == Approx(4.75));
  observed.weights = {1, 3, 1};  // of 4, 1, 10: two parts from 1 to 4, one part from 4 to 10
  CHECK(mean_min(observed) == Approx((2 * 2.5 + 1 * 7) / 3));
  observed.between = BetweenValues::step;
  CHECK(mean_min(observed) == Approx((4 + 3 * 1 + 10) / 5.0));
  observed.weights = {0, 3, 1};  // what has no weight is not there
  CHECK(mean_min(observed) == Approx((3 * 1 + 10) / 4.0));
}

TEST_CASE("observed durations have one weight per value or none at all", "[duration]") {
  EmpiricalDuration observed{.values_min = {1, 2, 3}};
  CHECK_NOTHROW(check_duration(observed, "setup"));
  observed.weights = {1, 1};
  CHECK_THROWS_WITH(check_duration(observed, "setup"),
                    Contains("setup/weights") && Contains("one weight for each of the 3 values"));
  observed.weights = {0, 0, 2};
  CHECK_THROWS_WITH(check_duration(observed, "setup"), Contains("above 0 for at least two values"));
  CHECK_THROWS_WITH(check_duration(UniformDuration{3, 2}, "setup"), Contains("setup/low_min"));
  CHECK_THROWS_WITH(check_duration(TriangularDuration{3, 2, 4}, "setup"), Contains("setup/low_min"));
  CHECK_THROWS_WITH(check_duration(TriangularDuration{1, 5, 4}, "setup"), Contains("setup/mode_min"));
}

TEST_CASE("Taylor's law: every exponent is that of its own quantity", "[life]") {
  EdgeLife edge;
  edge.mean_ref_min = 60;
  edge.cutting_speed_ref_m_min = 100;
  edge.feed_ref_mm_rev = 0.2;
  edge.depth_of_cut_ref_mm = 2;
  edge.speed_exponent = 3.5;
  edge.feed_exponent = 0.7;
  edge.depth_exponent = 0.3;
  // v T^(1/mu) f^y a^x is the same for all regimes.
  CHECK(taylor_life(edge, 100, 0.2, 2).mean_min == Approx(60));
  CHECK(taylor_life(edge, 200, 0.2, 2).mean_min == Approx(60 * std::pow(2, -3.5)));
  CHECK(taylor_life(edge, 100, 0.4, 2).mean_min == Approx(60 * std::pow(2, -0.7 * 3.5)));
  CHECK(taylor_life(edge, 100, 0.2, 4).mean_min == Approx(60 * std::pow(2, -0.3 * 3.5)));
}

TEST_CASE("a plan knows the units of its quantities and the speeds of its spindle", "[plan]") {
  CutPlan plan;
  plan.quantities.push_back({"main_time_min", 3, "min", "definition", "time"});
  plan.quantities.push_back({"power_kw", 5, "kW", "definition", "power"});
  CHECK(std::string(plan.unit_of("power_kw")) == "kW");
  CHECK(std::string(plan.unit_of("main_time_min")) == "min");
  CHECK(std::string(plan.unit_of("no such quantity")) == "1");
  limit_spindle_speed(plan, {}, 120, 340, "definition");
  CHECK(plan.spindle.speed_low_rpm == 120);
  CHECK(plan.spindle.speed_high_rpm == 340);
  CHECK(plan.limits.empty());  // no machine, no limit
}

TEST_CASE("the spindle itself, turning once, must not meet a natural frequency either", "[K206]") {
  GalleryExample<FaceMilling> example("face_milling_machine");
  example.file.machine_limits.safety_clutch.reset();
  Spindle spindle = *example.file.spindle;
  const double natural_rpm = 60 * spindle.dynamics().natural_hz[0];
  spindle.speed_max_rpm = std::max(spindle.speed_max_rpm, 1.5 * natural_rpm);
  auto context = example.context();
  context.spindle = &spindle;
  bool found = false;
  for (const ForbiddenBand& band : operations::detail::plan_of(example.spec, context).bands)
    found = found || (band.low <= natural_rpm && natural_rpm <= band.high);
  CHECK(found);
}

TEST_CASE("a stiffer material of the spindle raises every natural frequency", "[K206]") {
  const GalleryExample<FaceMilling> example("face_milling_machine");
  Spindle spindle = *example.file.spindle;
  const auto before = spindle.dynamics();
  spindle.elastic_base->modulus_gpa *= 1.5;
  const auto after = spindle.dynamics();
  REQUIRE(after.natural_hz.size() == before.natural_hz.size());
  for (std::size_t k = 0; k < before.natural_hz.size(); ++k)
    CHECK(after.natural_hz[k] > before.natural_hz[k]);
}

TEST_CASE("errors of nose and bearing add up", "[K206][K210]") {
  const GalleryExample<FaceMilling> milling("face_milling_machine");
  const GalleryExample<HardTurning> turning("hard_turning_machine");
  Spindle spindle = *turning.file.spindle;
  spindle.bearings.reset();
  spindle.elastic_base = milling.file.spindle->elastic_base;
  spindle.hydrostatic.emplace();
  auto context = turning.context();
  context.spindle = &spindle;
  const CutPlan plan = operations::detail::plan_of(turning.spec, context);
  const double nose_um = value_of(plan, "spindle_deflection_um");
  const double bearing_um = value_of(plan, "spindle_displacement_um");
  CHECK(nose_um > 0);
  CHECK(bearing_um > 0);
  CHECK(value_of(plan, "spindle_form_error_um") == Approx(nose_um + bearing_um).epsilon(1e-14));
}
