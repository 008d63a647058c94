#include "operations/kinds/cam_milling.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::margin_of;
using verstat::test::value_of;

namespace s1 = models::s1;

TEST_CASE("cam milling: the stabilised feed halves the time of uniform rotation", "[cam_milling]") {
  const auto gallery = test::Gallery("cam_milling");
  CamMilling spec = gallery.spec<CamMilling>();
  const CutPlan stabilised = plan(spec, gallery.context());
  CHECK(stabilised.feasible());
  CHECK(stabilised.main_time_min == Approx(8 * 22 * 123.524 / 500).epsilon(1e-5));
  CHECK(value_of(stabilised, "wear_form_error_mm") == 0);

  spec.scheme = CamScheme::uniform;
  spec.orientation_deg = 0;
  const CutPlan uniform = plan(spec, gallery.context());
  CHECK(uniform.main_time_min / stabilised.main_time_min == Approx(2.09).margin(0.005));
  CHECK(value_of(uniform, "feed_swing") == Approx(4.25).margin(0.005));
  CHECK(margin_of(uniform, "wear_form_error_mm") < 0);  // the worn cutter spoils the form
  // Equal peak feed: the uniform speed makes the specified feed where the contour runs fastest.
  double peak = 0;
  for (int k = 0; k < 7200; ++k) {
    s1::UniformRotation at;
    at.cam = spec.cam;
    at.tool_radius_mm = spec.tool_diameter_mm / 2;
    at.part_speed_rpm = value_of(uniform, "part_speed_max_rpm");
    at.normal_angle_deg = -180 + 0.05 * k;
    peak = std::max(peak, s1::conventional_state(at).contour_feed_mm_min);
  }
  CHECK(peak == Approx(spec.contour_feed_mm_min).epsilon(2e-3));
}

TEST_CASE("cam milling: demands on the axes are the largest over the whole cam", "[cam_milling]") {
  const auto gallery = test::Gallery("cam_milling");
  for (const s1::Cam& cam : {s1::Cam{18, 8, 18, 60}, s1::Cam{30, 20, 22, 120}}) {
    CamMilling spec = gallery.spec<CamMilling>();
    spec.cam = cam;
    const CutPlan p = plan(spec, gallery.context());
    double feed = 0, speed = 0;
    for (int k = 0; k <= 36'000; ++k) {
      s1::CamFeed at;
      at.cam = cam;
      at.normal_angle_deg = 0.01 * k;
      at.contour_feed_mm_min = spec.contour_feed_mm_min;
      const s1::RotationLaw law = s1::cam_rotation_law(at);
      feed = std::max({feed, std::abs(law.feed_x_mm_min), std::abs(law.feed_y_mm_min)});
      speed = std::max(speed, law.part_speed_rpm);
    }
    CHECK(value_of(p, "part_speed_max_rpm") == Approx(speed));
    CHECK(value_of(p, "axis_feed_max_mm_min") == Approx(feed).epsilon(1e-3));
    CHECK(value_of(p, "axis_feed_max_mm_min") >= feed * (1 - 1e-12));
  }
}

TEST_CASE("cam milling: roughness decides how far the axis may turn", "[cam_milling]") {
  const auto gallery = test::Gallery("cam_milling");
  test::property([&] {
    CamMilling spec = gallery.spec<CamMilling>();
    spec.axial_feed_mm_rev = *rc::gen::inRange(1, 8);
    spec.ra_max_um = *rc::gen::inRange(1, 40) * 0.1;
    const double largest = *plan(spec, {}).value_of("orientation_max_deg");
    spec.orientation_deg = largest * 0.999;
    RC_ASSERT(margin_of(plan(spec, {}), "ra_um") >= 0);
    if (largest < 89) {
      spec.orientation_deg = largest * 1.001;
      RC_ASSERT(margin_of(plan(spec, {}), "ra_um") < 0);
    }
  });
}

TEST_CASE("cam milling: errors name what is wrong", "[cam_milling]") {
  CamMilling spec = test::Gallery("cam_milling").spec<CamMilling>();
  spec.scheme = CamScheme::uniform;
  CHECK(test::refusal(spec) ==
        "orientation_deg = 20, must be 0 in the uniform scheme, whose axes are parallel");
  spec.orientation_deg = 0;
  spec.cam.r_flank_mm = 15;
  CHECK(test::refusal(spec).find("S1.cam_geometry: ") == 0);
}
