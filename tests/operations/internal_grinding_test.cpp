// Internal grinding: the published table of heights as a limit on protrusion, dressing and time.

#include "operations/kinds/internal_grinding.h"

#include <numbers>

#include "models/grinding/k303_cutting_surface_height.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

namespace verstat::operations {
namespace {

using test::limit_of;

InternalGrinding example() {
  return test::Gallery("internal_grinding").spec<InternalGrinding>();
}

TEST_CASE("internal grinding: the example is feasible and survives JSON") {
  const MachineLimits machine = test::Gallery("internal_grinding").file.machine_limits;
  PlanContext context;
  context.machine = &machine;
  const CutPlan p = plan(example(), context);
  CHECK(p.feasible());
  // 15 + 5 revolutions at 38.2 rpm.
  CHECK(p.main_time_min == Approx(20 * std::numbers::pi * 50 / 6000));
  CHECK(*p.value_of("power_kw") == Approx(60 * 1000 * 6 * 0.010 * 14 / 60'000));
}

TEST_CASE("internal grinding: heights of the published table") {
  InternalGrinding s = example();
  struct Row {
    double speed_m_min, depth_um, rmax_um;
  };
  for (const Row& row : {Row{3, 5, 4.80}, Row{6, 5, 5.00}, Row{3, 10, 6.60}, Row{6, 10, 7.9}, Row{9, 10, 8.8},
                         Row{3, 15, 7.4}, Row{6, 15, 9.1}, Row{9, 15, 10.3}}) {
    s.work_speed_m_min = row.speed_m_min;
    s.depth_um = row.depth_um;
    CHECK(*plan(s, {}).value_of("cutting_surface_rmax_um") == Approx(row.rmax_um).epsilon(0.02));
  }
}

TEST_CASE("internal grinding: faster work saves time and asks for earlier dressing") {
  InternalGrinding s = example();
  double time_min = 1e9;
  double between_min = 1e9;
  for (const double speed : {3.0, 6.0, 9.0}) {
    s.work_speed_m_min = speed;
    const CutPlan p = plan(s, {});
    CHECK(p.main_time_min < time_min);
    REQUIRE(p.more_elements.size() == 1);
    CHECK(p.more_elements[0].mean_min < between_min);
    CHECK(p.more_elements[0].mean_min == Approx((12 - *p.value_of("cutting_surface_rmax_um")) / 0.02));
    time_min = p.main_time_min;
    between_min = p.more_elements[0].mean_min;
  }
}

TEST_CASE("internal grinding: the limit changes sign at K303's largest speed") {
  InternalGrinding s = example();
  s.grain_protrusion_um = 7.5;
  models::k303::SpeedSearch search;
  search.wheel_radius_mm = 20;
  search.work_radius_mm = 25;
  search.wheel_speed_m_s = 25;
  search.grain_spacing_mm = s.grain_spacing_mm;
  search.tip_radius_um = s.tip_radius_um;
  search.tip_angle_deg = s.tip_angle_deg;
  search.weibull_x0_um_m = s.weibull_x0_um_m;
  search.weibull_m = s.weibull_m;
  search.protrusion_um = 7.5;
  search.depth_mm = 0.010;
  search.speed_low_m_min = 1;
  search.speed_high_m_min = 20;
  const double most = models::k303::max_work_speed_for_protrusion(search).work_speed_m_min;
  REQUIRE(most > 1);
  REQUIRE(most < 20);
  s.work_speed_m_min = most * 0.9999;
  CHECK(limit_of(plan(s, {}), "grain_protrusion_um").met());
  s.work_speed_m_min = most * 1.0001;
  CHECK_FALSE(limit_of(plan(s, {}), "grain_protrusion_um").met());
}

TEST_CASE("internal grinding: bad specifications name the place") {
  InternalGrinding s = example();
  s.length_mm = 17;
  CHECK(test::refusal(s) == "wheel_width_mm = 16, must cover length_mm in plunge grinding");
  s = example();
  s.wheel_diameter_mm = 50;
  CHECK(test::refusal(s).find("work_radius_mm") != std::string::npos);
  nlohmann::json json = test::Gallery("internal_grinding").json.at("process");
  json.erase("grain_protrusion_um");
  CHECK(test::refusal(json).find("grain_protrusion_um") != std::string::npos);
}

TEST_CASE("internal grinding: the wheel never sinks deeper than the cut") {
  test::property("rmax", [] {
    InternalGrinding s = example();
    s.work_speed_m_min = *rc::gen::inRange(1, 30);
    s.depth_um = *rc::gen::inRange(1, 20);
    const CutPlan p = plan(s, {});
    const double rmax_um = *p.value_of("cutting_surface_rmax_um");
    RC_ASSERT(rmax_um > 0);
    RC_ASSERT(rmax_um <= s.depth_um + 1e-9);
    RC_ASSERT(*p.value_of("residual_height_um") <= rmax_um + 1e-9);
  });
}

}  // namespace
}  // namespace verstat::operations
