// The checks of card K203; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k203_crossed_axis_groove_grinding.h"
#include "models/math/solve.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k203;

namespace {

constexpr double degree = std::numbers::pi / 180;
const Groove screw{20, -3.1, 10};

double part(double low, double high) {  // one of 1000 steps between
  return low + (high - low) * *rc::gen::inRange(0, 1000) * 1e-3;
}

GrooveToWheel at(const Groove& groove, double distance, double tilt, double phi) {
  return {groove, distance, tilt, phi};
}

RemovalRegime regime(double phi_max_deg, Stock scheme) {
  return {147, 3.1, 0, phi_max_deg, 2, 0.02, 0, 50, scheme};
}

}  // namespace

TEST_CASE("K203: the normal is perpendicular to the groove and points away from the axis", "[K203]") {
  verstat::test::property([] {
    const double sign = *rc::gen::element(-1.0, 1.0);
    const Groove g{part(10, 40), sign * part(1, 6), part(4, 30)};
    const double theta = part(-180, 180);
    const double phi = part(-80, 80);
    const auto point = [&](double t, double f) { return helical_groove_point({g, t, f}); };
    const GroovePoint p = point(theta, phi);
    RC_ASSERT(std::abs(std::hypot(p.nx, p.ny, p.nz) - 1) < 1e-14);
    for (const auto& [dt, df] : {std::pair{1e-4, 0.0}, std::pair{0.0, 1e-4}}) {
      const GroovePoint a = point(theta - dt, phi - df);
      const GroovePoint b = point(theta + dt, phi + df);
      const double dx = b.x_mm - a.x_mm;
      const double dy = b.y_mm - a.y_mm;
      const double dz = b.z_mm - a.z_mm;
      RC_ASSERT(std::abs(dx * p.nx + dy * p.ny + dz * p.nz) < 1e-7 * std::hypot(dx, dy, dz));
    }
    RC_ASSERT(point(0, phi).ny > 0);
  });
}

TEST_CASE("K203: at phi = 0 the wheel has the radius of the line of centres", "[K203]") {
  const WheelPoint crown = wheel_profile_point(at(screw, 166.9, -4.55, 0));
  CHECK(crown.wheel_radius_mm == Approx(166.9 - 16.9).epsilon(1e-14));
  CHECK(crown.wheel_axial_mm == Approx(0).margin(1e-12));
  const WheelPoint nut = wheel_profile_point(at({20, 3.1, 10}, 11.1, -4, 0));
  CHECK(nut.wheel_radius_mm == Approx(23.1 - 11.1).epsilon(1e-14));
}

TEST_CASE("K203: the wheel profile is the groove surface seen from the wheel axis", "[K203]") {
  // Brute force: of all groove points at the same place Z along the wheel axis, the contact is the nearest.
  for (const double tilt : {-4.55, 0.0, 2.0})
    for (const double phi : {10.0, 25.0, 35.0}) {
      const WheelPoint contact = wheel_profile_point(at(screw, 166.9, tilt, phi));
      const double c = std::cos(tilt * degree);
      const double s = std::sin(tilt * degree);
      double nearest = std::numeric_limits<double>::infinity();
      for (double f = -phi; f <= phi; f += 0.02) {
        const auto axial = [&](double theta) {
          const GroovePoint p = helical_groove_point({screw, theta, f});
          return -p.x_mm * s + p.z_mm * c - contact.wheel_axial_mm;
        };
        if (axial(-60) * axial(60) > 0) continue;
        const GroovePoint p = helical_groove_point({screw, find_root(axial, -60, 60), f});
        nearest = std::min(nearest, std::hypot(p.x_mm * c + p.z_mm * s, p.y_mm - 166.9));
      }
      INFO("tilt " << tilt << ", phi " << phi);
      CHECK(contact.wheel_radius_mm == Approx(nearest).margin(1e-5));
    }
}

TEST_CASE("K203: the ground groove is the envelope of the wheel", "[K203]") {
  // Brute force: the part's material ends at the smallest radius the sweeping wheel reaches in the section.
  for (const double tilt : {-5.34, 0.0, 3.0})
    for (const double phi : {0.0, 12.0, 30.0}) {
      const WheelToGroove in{{147, 2.5, 10, 166.5, tilt, 0}, phi};
      const GrooveSectionPoint made = ground_groove_point(in);
      const double c = std::cos(tilt * degree);
      const double s = std::sin(tilt * degree);
      double smallest = std::numeric_limits<double>::infinity();
      for (double f = -60; f <= 60; f += 0.05) {
        const double r = 147 + 2.5 * std::cos(f * degree);
        const double z_wheel = 2.5 * std::sin(f * degree);
        const auto section = [&](double delta) {
          const double x_wheel = r * std::sin(delta);
          const double x = x_wheel * c - z_wheel * s;
          const double y = 166.5 - r * std::cos(delta);
          const double z = x_wheel * s + z_wheel * c;
          return std::pair{std::hypot(x, y),
                           z - 10 / (2 * std::numbers::pi) * std::atan2(-x, y) - made.groove_axial_mm};
        };
        const auto offset = [&](double delta) { return section(delta).second; };
        // Aligned with the groove a wheel circle meets the section more than once.
        for (int k = -40; k < 40; ++k) {
          const double from = 0.101 * k * degree;
          const double to = 0.101 * (k + 1) * degree;
          if (offset(from) * offset(to) <= 0)
            smallest = std::min(smallest, section(find_root(offset, from, to)).first);
        }
      }
      INFO("tilt " << tilt << ", phi " << phi);
      CHECK(made.groove_radius_mm == Approx(smallest).margin(1e-5));
    }
}

TEST_CASE("K203: a wheel dressed for the final settings makes the groove exactly there", "[K203]") {
  verstat::test::property([] {
    const Groove g{part(15, 30), -part(2, 4), part(5, 15)};
    const double bottom = g.center_radius_mm + g.profile_radius_mm;
    const double distance = bottom + part(100, 200);
    const double aligned = -std::atan(g.lead_mm / (2 * std::numbers::pi * bottom)) / degree;
    const double tilt = aligned + part(-1, 6);
    const PassFormError pass = pass_form_error({g, distance, tilt, distance, tilt, 30, 41});
    RC_ASSERT(std::abs(pass.fit_radius_mm + g.profile_radius_mm) < 1e-6);
    RC_ASSERT(pass.form_error_mm < 1e-6);
  });
  const auto error_um = [](double tilt) {
    return 1000 * pass_form_error({screw, 166.9, 3.8, 166.9, tilt, 40, 41}).form_error_mm;
  };
  CHECK(error_um(3.0) == Approx(0.8).margin(0.05));
  CHECK(error_um(1.0) == Approx(2.4).margin(0.05));
  CHECK(error_um(3.8) < 1e-3);
}

TEST_CASE("K203: the wheel undercuts where the card says", "[K203]") {
  CHECK_NOTHROW(wheel_profile_point(at(screw, 166.9, 5, 56)));
  CHECK_THROWS_WITH(wheel_profile_point(at(screw, 166.9, 5, 59)), Catch::Contains("undercut"));
  CHECK_NOTHROW(wheel_profile_point(at(screw, 166.9, 10, 43)));
  CHECK_THROWS_WITH(wheel_profile_point(at(screw, 166.9, 10, -47)), Catch::Contains("undercut"));
}

TEST_CASE("K203: the effective radius is that of a short arc", "[K203]") {
  for (const double tilt : {-5.34, -2.0, 1.0, 3.0}) {
    const double effective = effective_groove_radius({{2.5, 149.5, 17, 10, 0}, tilt}).groove_radius_mm;
    const auto fitted = [&](double phi_max) {
      return groove_profile_fit({{147, 2.5, 10, 166.5, tilt, 0}, phi_max, 41}).fit_radius_mm;
    };
    CHECK(fitted(4) == Approx(effective).epsilon(4e-4));
    CHECK(fitted(1) == Approx(effective).epsilon(3e-5));
  }
}

TEST_CASE("K203: the tilt for a radius inverts the effective radius", "[K203]") {
  verstat::test::property([] {
    const bool internal = *rc::gen::arbitrary<bool>();
    const double bottom = part(20, 40);
    const CrossedWheel wheel{part(2, 4), internal ? part(0.4, 0.7) * bottom : part(80, 200), bottom,
                             part(5, 20), internal ? 1 : 0};
    const double aligned = -std::atan(wheel.lead_mm / (2 * std::numbers::pi * bottom)) / degree;
    // Beyond the shallow dip behind the aligned position the radius grows.
    const double tilt = aligned + part(4, 39);
    const double radius = effective_groove_radius({wheel, tilt}).groove_radius_mm;
    RC_ASSERT(std::abs(tilt_for_radius({wheel, radius}).tilt_deg - tilt) < 1e-6);
  });
}

TEST_CASE("K203: the schedule ends at the final groove and steps evenly", "[K203]") {
  const PassSchedule s = pass_schedule({20, 3.1, 0.2, 0.06, 10, 150, 2.7, 0});
  REQUIRE(s.tilt_deg.size() == 4);
  CHECK(s.profile_radius_mm.front() == Approx(2.96));
  CHECK(s.profile_radius_mm.back() == Approx(3.1).epsilon(1e-14));
  CHECK(s.center_distance_mm.back() == Approx(166.9));
  CHECK(std::is_sorted(s.tilt_deg.begin(), s.tilt_deg.end()));
  CHECK(pass_schedule({20, 3.1, 0.28, 0.07, 10, 150, 2.7, 0}).tilt_deg.size() == 4);
}

TEST_CASE("K203: the volume lies between the section swept at its smallest and largest radius", "[K203]") {
  verstat::test::property([] {
    const double sign = *rc::gen::element(-1.0, 1.0);
    const double rho = part(2, 5);
    const double stock = part(0.01, 0.5);
    const double f = part(5, 90);
    const Stock scheme = *rc::gen::element(Stock::shifted, Stock::concentric);
    const RemovedVolume v = removed_volume({{20, sign * rho, 10}, 300, stock, f, scheme});
    const double turns = 30 * 2 * std::numbers::pi;
    const double least = 20 + std::min(sign * rho, sign * (rho - stock) * std::cos(f * degree) - stock);
    const double largest = 20 + std::max(sign * rho, sign * (rho - stock) * std::cos(f * degree));
    RC_ASSERT(v.volume_mm3 >= v.section_mm2 * turns * least);
    RC_ASSERT(v.volume_mm3 <= v.section_mm2 * turns * largest);
  });
  // Brute force of both sections, in cells of angle and depth.
  for (const double sign : {1.0, -1.0}) {
    double concentric = 0;
    double shifted = 0;
    const double rho = 3.1;
    const double stock = 0.2;
    for (int i = 0; i < 2000; ++i) {
      const double phi = 45 * degree * ((i + 0.5) / 1000 - 1);
      const double dphi = 45 * degree / 1000;
      for (int j = 0; j < 20; ++j) {
        const double t = stock * (j + 0.5) / 20;  // below the final arc
        const double dt = stock / 20;
        concentric += (20 + sign * (rho - t) * std::cos(phi)) * (rho - t) * dphi * dt;
        shifted += (20 + sign * (rho * std::cos(phi) - t)) * rho * std::cos(phi) * dphi * dt;
      }
    }
    const double turns = 30 * 2 * std::numbers::pi;
    CHECK(removed_volume({{20, sign * rho, 10}, 300, stock, 45, Stock::concentric}).volume_mm3 ==
          Approx(turns * concentric).epsilon(1e-5));
    CHECK(removed_volume({{20, sign * rho, 10}, 300, stock, 45, Stock::shifted}).volume_mm3 ==
          Approx(turns * shifted).epsilon(1e-5));
  }
}

TEST_CASE("K203: removal rate of a dense, sharp wheel has closed forms", "[K203]") {
  const double v = 2000;  // mm/min
  CHECK(grinding_removal_rate(regime(45, Stock::shifted)).q_mm3_min ==
        Approx(v * 0.02 * 2 * 3.1 * std::sin(45 * degree)).epsilon(1e-9));
  CHECK(grinding_removal_rate(regime(45, Stock::concentric)).q_mm3_min ==
        Approx(v * 0.02 * 2 * 45 * degree * 3.1).epsilon(1e-9));
  // Uniform along a concentric profile, falling as cos(phi) along a shifted one.
  const auto slope = [](double phi, Stock scheme) {
    return (grinding_removal_rate(regime(phi + 0.01, scheme)).q_mm3_min -
            grinding_removal_rate(regime(phi - 0.01, scheme)).q_mm3_min) /
           (2 * 0.02 * degree * 3.1);
  };
  CHECK(slope(40, Stock::concentric) == Approx(v * 0.02).epsilon(1e-6));
  CHECK(slope(40, Stock::shifted) == Approx(v * 0.02 * std::cos(40 * degree)).epsilon(1e-6));
}

TEST_CASE("K203: removal rate falls with retreat and wear, rises with speed, infeed and coverage", "[K203]") {
  verstat::test::property([] {
    const RemovalRegime r{part(50, 200), part(2, 5),   part(0, 0.1),
                          part(10, 80),  part(0.5, 5), part(0.005, 0.05),
                          part(0, 0.3),  part(0.1, 5), *rc::gen::element(Stock::shifted, Stock::concentric)};
    const double q = grinding_removal_rate(r).q_mm3_min;
    const auto with = [&](double RemovalRegime::*member, double factor) {
      RemovalRegime changed = r;
      changed.*member *= factor;
      return grinding_removal_rate(changed).q_mm3_min;
    };
    // Simpson's sum over the kink where the wheel stops cutting is that rough.
    const double slack = 1e-4 * r.traverse_speed_m_min * 1000 * r.infeed_mm * r.wheel_profile_radius_mm;
    RC_ASSERT(with(&RemovalRegime::retreat_speed_mm_s, 1.2) <= q + slack);
    RC_ASSERT(with(&RemovalRegime::wear_mm, 1.2) <= q + slack);
    RC_ASSERT(with(&RemovalRegime::traverse_speed_m_min, 1.2) >= q - slack);
    RC_ASSERT(with(&RemovalRegime::infeed_mm, 1.2) >= q - slack);
    RC_ASSERT(with(&RemovalRegime::grain_ratio, 1.2) >= q - slack);
  });
}

TEST_CASE("K203: dressing depth", "[K203]") {
  CHECK(dressing_depth({100, 0.05, 0}).depth_mm == Approx(3.162).margin(5e-4));
  verstat::test::property([] {
    const double rho = part(1, 100);
    const double wear = part(0.001, 0.9) * rho;
    RC_ASSERT(std::abs(dressing_depth({rho, wear, 90}).depth_mm / wear - 1) < 1e-12);
    const double alpha = part(0, 89);
    const double depth = dressing_depth({rho, wear, alpha}).depth_mm;
    RC_ASSERT(dressing_depth({rho, wear, alpha + 1}).depth_mm < depth);
    // The worn point lies on the arc of the same radius whose centre is moved by the depth.
    const double y = (rho - wear) * std::sin(alpha * degree) + depth;
    const double x = (rho - wear) * std::cos(alpha * degree);
    RC_ASSERT(std::abs(std::hypot(x, y) / rho - 1) < 1e-12);
  });
}

TEST_CASE("K203: dressing volume is the wheel before less the wheel after", "[K203]") {
  const Dressing d{147, 3.1, 4.4, 0.05};
  double volume = 0;
  for (int k = 0; k < 20000; ++k) {
    const double z = 4.4 * ((k + 0.5) / 20000 - 0.5);
    const double before = 147 + std::sqrt(3.1 * 3.1 - z * z);
    const double after = before - 0.05;
    volume += std::numbers::pi * (before * before - after * after) * 4.4 / 20000;
  }
  CHECK(dressing_volume(d).volume_mm3 == Approx(volume).epsilon(1e-8));
}

TEST_CASE("K203: wear and time", "[K203]") {
  const WheelWear narrow = wheel_wear_per_part({0.2, 3780, 150, 60, 0.02, 60, Method::narrow});
  const WheelWear copying = wheel_wear_per_part({0.2, 3780, 150, 60, 0.02, 60, Method::copying});
  CHECK(copying.wear_per_part_mm == Approx(2 * narrow.wear_per_part_mm));
  CHECK(copying.wear_per_part_mm ==
        Approx(narrow.wear_per_part_mm / 0.2 * plunge_length({0.2, 60}).length_mm));
  const GrindingTime t = groove_grinding_time({300, 10, 20, 0.28, 0.02, 0, 6, 2, 0, 5, 0});
  CHECK(t.passes == 14);  // 0.28 / 0.02 is a hair above 14 in binary
  CHECK(t.time_min == Approx(14 * 1.5 * t.pass_time_min));
}

TEST_CASE("K203: bad input names itself", "[K203]") {
  CHECK_THROWS_WITH(ground_groove_point({{147, 2.5, 10, 100, 3, 0}, 0}),
                    Catch::Contains("K203.ground_groove_point: center_distance_mm = 100, must exceed"));
  CHECK_THROWS_WITH(tilt_for_radius({{2.7, 150, 16.9, 10, 0}, 2}),
                    Catch::Contains("groove_radius_mm = 2, must not be below the radius"));
  CHECK_THROWS_WITH(dressing_depth({3.1, 3.1, 45}),
                    "K203.dressing_depth: wear_mm = 3.1, must be below the profile radius of the wheel");
  CHECK_THROWS_WITH(removed_volume({{20, 0, 10}, 300, 0.2, 45, Stock::shifted}),
                    Catch::Contains("profile_radius_mm = 0, must not be 0"));
}
