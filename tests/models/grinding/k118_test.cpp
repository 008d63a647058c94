// The checks of card K118; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k118_elastic_grinding_clamp_force.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k118;

namespace {

ForceInputs r6m5() {
  ForceInputs in;
  in.temperature_c = 880;
  return in;
}

ForceInputs steel_60s2() {
  ForceInputs in;
  in.flow_c_mpa = 1015;
  in.flow_alpha_mpa_k = 0.432;
  in.temperature_c = 820;
  return in;
}

double part(int low, int high) {  // one of 1000 steps between
  return *rc::gen::inRange(low * 1000, high * 1000) * 1e-3;
}

// Wheels, grains and regimes over wide ranges.
ElasticWithoutDepth any_regime() {
  ElasticWithoutDepth in;
  in.wheel_radius_mm = part(40, 250);
  in.wheel_speed_m_s = part(15, 60);
  in.work_speed_m_min = part(1, 30);
  in.width_mm = part(1, 50);
  in.concentration_pct = part(25, 200);
  in.grains_per_carat = part(5, 200) * 1000;
  in.roughness_rz_um = part(0, 10);
  in.time_after_dress_min = part(1, 60);
  in.tip_radius_um = part(2, 30);
  in.cone_angle_deg = part(60, 140);
  in.heat_fraction = part(0, 1);
  return in;
}

ElasticInputs at_depth(const ElasticWithoutDepth& in, double depth_um) {
  return {in, {depth_um}};
}

}  // namespace

TEST_CASE("K118: table 2 with the calibration, and its ratio without", "[K118]") {
  CHECK(clamp_force_at_temperature(r6m5()).clamp_force_n == Approx(4.23).epsilon(0.005));
  CHECK(clamp_force_at_temperature(steel_60s2()).clamp_force_n == Approx(5.35).epsilon(0.005));
  ForceInputs first = r6m5();
  ForceInputs second = steel_60s2();
  first.k_cal = second.k_cal = 1;
  CHECK(clamp_force_at_temperature(second).clamp_force_n / clamp_force_at_temperature(first).clamp_force_n ==
        Approx(5.35 / 4.23).epsilon(0.001));
}

TEST_CASE("K118: intermediate values of the printed chain", "[K118]") {
  const ContactGeometry g = grinding_contact_geometry({});
  CHECK(g.grain_diameter_um == Approx(131.2).margin(0.05));
  CHECK(g.grain_spacing_body_mm == Approx(0.13148).margin(5e-6));
  CHECK(g.grain_spacing_surface_mm == Approx(0.32343).margin(5e-6));
  CHECK(g.active_share == Approx(0.30991).margin(5e-6));
  CHECK(g.k_height == Approx(1.7963).margin(5e-5));
  CHECK(g.k_kinematic == Approx(53.52).margin(5e-3));
  CHECK(g.grain_pitch_mm == Approx(31.09).margin(5e-3));
  CHECK(g.chip_thickness_max_um == Approx(1.345).margin(5e-4));
  CHECK(g.contact_length_mm == Approx(1.936).margin(6e-4));
  CHECK(g.active_grains == Approx(2.524).margin(5e-4));
  const GrainCut c = grinding_grain_cut({});
  CHECK(c.cut_width_mm == Approx(0.02467).margin(5e-6));
  CHECK(c.wear_flat_um == Approx(28.87).margin(0.006));
  CHECK(c.chip_thickness_um == Approx(3.345).margin(5e-4));
  CHECK(c.rake_deg == Approx(-71.6).margin(0.05));
  CHECK(c.shear_angle_deg == Approx(7.81).margin(5e-3));
  CHECK(c.stress_ratio == Approx(2.298).margin(5e-4));
  CHECK(c.action_angle_deg == Approx(58.7).margin(0.05));
  CHECK(c.normal_factor_mm2 * 1000 / (c.cut_width_mm * g.active_grains) == Approx(52.7 + 66.3).margin(0.1));
}

TEST_CASE("K118: force and grains are linear in the width, pitch and chip do not know it", "[K118]") {
  verstat::test::property([] {
    const ElasticWithoutDepth one = any_regime();
    ElasticWithoutDepth two = one;
    two.width_mm *= 2;
    const ContactInputs first{one, {15}};
    const ContactInputs second{two, {15}};
    const ContactGeometry a = grinding_contact_geometry(first);
    const ContactGeometry b = grinding_contact_geometry(second);
    RC_ASSERT(std::abs(b.active_grains / a.active_grains - 2) < 1e-12);
    RC_ASSERT(a.grain_pitch_mm == b.grain_pitch_mm);
    RC_ASSERT(a.chip_thickness_max_um == b.chip_thickness_max_um);
    const double ratio = elastic_grinding_state(at_depth(two, 15)).clamp_force_n /
                         elastic_grinding_state(at_depth(one, 15)).clamp_force_n;
    RC_ASSERT(std::abs(ratio - 2) < 1e-9);
  });
}

TEST_CASE("K118: pitch, width and count are tied unless the tip caps the cut; the chip stays in the depth",
          "[K118]") {
  verstat::test::property([] {
    const ElasticWithoutDepth in = any_regime();
    const double depth_um = part(1, 60);
    const ContactGeometry g = grinding_contact_geometry({in, {depth_um}});
    const GrainCut c = grinding_grain_cut({in, {depth_um}, in});
    if (c.cut_width_mm < c.tip_width_mm)
      RC_ASSERT(
          std::abs(c.cut_width_mm * g.active_grains / (g.contact_length_mm * in.width_mm / g.grain_pitch_mm) -
                   1) < 1e-12);
    const double r = in.wheel_radius_mm;
    const double most_um = 1000 * (r - std::sqrt(r * r - g.contact_length_mm * g.contact_length_mm));
    RC_ASSERT(g.chip_thickness_max_um > 0);
    RC_ASSERT(g.chip_thickness_max_um <= most_um * (1 + 1e-6));
    const double advance_mm = in.work_speed_m_min * g.grain_pitch_mm / (60 * in.wheel_speed_m_s);
    RC_ASSERT((std::abs(g.chip_thickness_max_um / most_um - 1) < 1e-6) ==
                  (advance_mm >= g.contact_length_mm * (1 - 1e-3)) ||
              std::abs(advance_mm / g.contact_length_mm - 1) < 1e-2);
    RC_ASSERT(g.k_height >= 1);
    RC_ASSERT(c.chip_thickness_um >= g.grain_diameter_um / 2 || c.rake_deg < 0);
  });
}

TEST_CASE("K118: the tip width is continuous where the round tip ends", "[K118]") {
  GrainCutInputs in;
  in.tip_radius_um = 60;
  const double seam_um = 60 * (1 - std::sin(50 * 3.14159265358979 / 180));
  in.depth_um = seam_um * (1 - 1e-9);
  const double below_mm = grinding_grain_cut(in).tip_width_mm;
  in.depth_um = seam_um * (1 + 1e-9);
  CHECK(grinding_grain_cut(in).tip_width_mm == Approx(below_mm).epsilon(1e-8));
}

TEST_CASE("K118: clamp force falls with temperature to zero and grows with depth and time", "[K118]") {
  verstat::test::property([] {
    ForceInputs in = r6m5();
    in.depth_um = part(1, 50);
    in.temperature_c = part(0, 2000);
    const double force_n = clamp_force_at_temperature(in).clamp_force_n;
    ForceInputs hotter = in;
    hotter.temperature_c += 50;
    RC_ASSERT(clamp_force_at_temperature(hotter).clamp_force_n < force_n);
    ForceInputs deeper = in;
    deeper.depth_um += 1;
    RC_ASSERT(clamp_force_at_temperature(deeper).clamp_force_n > force_n);
    ForceInputs later = in;
    later.time_after_dress_min = 60;
    const double growth = clamp_force_at_temperature(later).clamp_force_n / force_n;
    RC_ASSERT(growth > 1 && growth < std::pow(60, 0.047));
  });
  ForceInputs limit = r6m5();
  limit.temperature_c = 723 / 0.255 - 273 - 1e-6;
  CHECK(clamp_force_at_temperature(limit).clamp_force_n == Approx(0).margin(1e-7));
  limit.temperature_c += 1;
  CHECK_THROWS_AS(clamp_force_at_temperature(limit), ModelError);
}

TEST_CASE("K118: the force limit inverts the temperature rise", "[K118]") {
  verstat::test::property([] {
    RiseInputs in;
    in.contact_length_mm = part(1, 5);
    in.work_speed_m_min = part(1, 30);
    in.tangential_force_n = part(1, 50);
    ForceLimitInputs back;
    static_cast<HeatInputs&>(back) = in;
    back.allowed_rise_k = grinding_temperature_rise(in).temperature_rise_k;
    RC_ASSERT(std::abs(tangential_force_limit(back).tangential_force_n / in.tangential_force_n - 1) < 1e-12);
  });
}

TEST_CASE("K118: temperature and force of the state grow with depth and obey both equations", "[K118]") {
  verstat::test::property([] {
    const ElasticWithoutDepth in = any_regime();
    const double depth_um = part(1, 59);
    const ElasticState s = elastic_grinding_state(at_depth(in, depth_um));
    const ElasticState deeper = elastic_grinding_state(at_depth(in, depth_um + 1));
    RC_ASSERT(deeper.temperature_c >= s.temperature_c);
    RC_ASSERT(deeper.clamp_force_n > s.clamp_force_n);
    RC_ASSERT(s.temperature_c >= in.ambient_c);
    RC_ASSERT(s.temperature_c < in.flow_c_mpa / in.flow_alpha_mpa_k - 273);
    // The forces are those at the temperature, and the temperature is that of the forces.
    ForceInputs at{in, {depth_um}, in, in, s.temperature_c};
    RC_ASSERT(std::abs(clamp_force_at_temperature(at).clamp_force_n / s.clamp_force_n - 1) < 1e-9);
    RiseInputs heat;
    static_cast<HeatPath&>(heat) = in;
    heat.wheel_speed_m_s = in.wheel_speed_m_s;
    heat.work_speed_m_min = in.work_speed_m_min;
    heat.width_mm = in.width_mm;
    heat.contact_length_mm = grinding_contact_geometry({in, {depth_um}}).contact_length_mm;
    heat.tangential_force_n = s.tangential_force_n;
    RC_ASSERT(std::abs(grinding_temperature_rise(heat).temperature_rise_k -
                       (s.temperature_c - in.ambient_c)) < 1e-7);
    // Without heat: ambient and the largest force.
    ElasticWithoutDepth cold = in;
    cold.heat_fraction = 0;
    const ElasticState unheated = elastic_grinding_state(at_depth(cold, depth_um));
    RC_ASSERT(unheated.temperature_c == in.ambient_c);
    RC_ASSERT(unheated.clamp_force_n >= s.clamp_force_n);
  });
}

TEST_CASE("K118: depth from clamp force inverts the state", "[K118]") {
  verstat::test::property([] {
    const ElasticWithoutDepth in = any_regime();
    const double depth_um = part(1, 60);
    const ElasticState s = elastic_grinding_state(at_depth(in, depth_um));
    RC_ASSERT(std::abs(elastic_depth_from_clamp({in, s.clamp_force_n}).depth_um / depth_um - 1) < 1e-9);
  });
}

TEST_CASE("K118: the thermal limit lies where the temperature is critical, and moves with heat and speed",
          "[K118]") {
  ElasticWithoutDepth in;
  in.heat_fraction = 0.9;
  const ThermalLimit limit = thermal_limit_state({in, 880});
  CHECK(limit.limited);
  CHECK(limit.depth_um == Approx(36).margin(0.5));
  CHECK(limit.clamp_force_n == Approx(10.4).margin(0.05));
  CHECK(elastic_grinding_state(at_depth(in, limit.depth_um)).temperature_c == Approx(880).epsilon(1e-10));
  ElasticWithoutDepth less_heat = in;
  less_heat.heat_fraction = 0.85;
  CHECK(thermal_limit_state({less_heat, 880}).depth_um > limit.depth_um);
  ElasticWithoutDepth slower = in;
  slower.wheel_speed_m_s = 33;
  CHECK(thermal_limit_state({slower, 880}).depth_um > limit.depth_um);
  ElasticWithoutDepth default_heat;
  CHECK_FALSE(thermal_limit_state({default_heat, 880}).limited);
  CHECK(thermal_limit_state({default_heat, 880}).depth_um == 60);
  CHECK(thermal_limit_state({default_heat, 20.5}).depth_um == 1);
}

TEST_CASE("K118: bad input names itself", "[K118]") {
  ElasticWithoutDepth in;
  CHECK_THROWS_WITH(
      elastic_depth_from_clamp({in, 1000}),
      "K118.elastic_depth_from_clamp: clamp_force_n = 1000, is above the force of a depth of 60 um");
  GrainCutInputs fine;
  fine.grains_per_carat = 1e12;
  CHECK_THROWS_WITH(grinding_grain_cut(fine),
                    Catch::Contains("makes the grains finer than the chip is thick"));
}
