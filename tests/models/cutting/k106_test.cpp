// The checks of card K106; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/cutting/k106_cylindrical_rake_hard_turning.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k106;

TEST_CASE("K106: levels of the text", "[K106]") {
  const auto at = [](double s, double t, double h, Rake rake) {
    return hard_turning_forces({60, s, t, h, rake, ToolMaterial::cbn});
  };
  CHECK(at(0.14, 0.1, 0, Rake::flat).p_y_n == Approx(100));
  CHECK(at(0.14, 0.1, 0, Rake::flat).p_z_n == Approx(100));
  CHECK(at(0.14, 0.1, 0.1, Rake::flat).p_y_n == Approx(250));
  CHECK(at(0.14, 0.1, 0.1, Rake::flat).p_z_n == Approx(120));
  CHECK(at(0.67, 0.1, 0, Rake::flat).p_z_n == Approx(300));
  CHECK(at(0.67, 0.1, 0, Rake::flat).p_x_n / at(0.14, 0.1, 0, Rake::flat).p_x_n == Approx(1.35));
  CHECK(at(0.1, 0.05, 0, Rake::flat).p_x_n == Approx(20));
  CHECK(at(0.7, 0.25, 0, Rake::flat).p_x_n == Approx(40));
  CHECK(at(0.14, 0.1, 0.1, Rake::cylindrical).p_y_n == Approx(300));
  CHECK(at(0.14, 0.1, 0.1, Rake::cylindrical).p_z_n == Approx(113).margin(0.5));
  CHECK(at(0.38, 0.2, 0, Rake::flat).p_y_n / at(0.38, 0.1, 0, Rake::flat).p_y_n == Approx(2));
}

TEST_CASE("K106: the ratio of radial and tangential force runs from 1 to 4 with wear", "[K106]") {
  const auto ratio = [](double h) {
    const HardTurningForces f = hard_turning_forces({60, 0.3, 0.1, h, Rake::cylindrical, ToolMaterial::cbn});
    return f.p_y_n / f.p_z_n;
  };
  CHECK(ratio(0) == Approx(1));
  CHECK(ratio(0.058) == Approx(2).margin(0.01));
  CHECK(ratio(0.205) == Approx(4).margin(0.01));
}

TEST_CASE("K106: forces rise with feed, depth and wear; sharp tools are equal; speed has no effect",
          "[K106]") {
  verstat::test::property([] {
    const double s = *rc::gen::inRange(10, 70) * 0.01;
    const double t = *rc::gen::inRange(5, 25) * 0.01;
    const double h = *rc::gen::inRange(0, 20) * 0.01;
    const Rake rake = *rc::gen::element(Rake::flat, Rake::cylindrical);
    const HardTurningForces base = hard_turning_forces({60, s, t, h, rake, ToolMaterial::cbn});
    for (const HardTurningForces& more :
         {hard_turning_forces({60, s + 0.01, t, h, rake, ToolMaterial::cbn}),
          hard_turning_forces({60, s, t + 0.01, h, rake, ToolMaterial::cbn}),
          hard_turning_forces({60, s, t, h + 0.01, rake, ToolMaterial::cbn})}) {
      RC_ASSERT(more.p_y_n > base.p_y_n);
      RC_ASSERT(more.p_z_n > base.p_z_n);
      RC_ASSERT(more.p_x_n >= base.p_x_n);
    }
    RC_ASSERT(hard_turning_forces({140, s, t, h, rake, ToolMaterial::cbn}).p_y_n == base.p_y_n);
    RC_ASSERT(hard_turning_forces({60, s, t, 0, Rake::flat, ToolMaterial::cbn}).p_y_n ==
              hard_turning_forces({60, s, t, 0, Rake::cylindrical, ToolMaterial::cbn}).p_y_n);
    const HardTurningForces ceramic = hard_turning_forces({60, s, t, h, rake, ToolMaterial::ceramic});
    RC_ASSERT(ceramic.p_y_n == 2 * base.p_y_n);
    RC_ASSERT(ceramic.p_z_n == base.p_z_n);
  });
}

TEST_CASE("K106: the envelope ends where the paper's ranges end, ends included", "[K106]") {
  const auto flag = [](double v, double s, double t, double h) {
    return hard_turning_forces({v, s, t, h, Rake::flat, ToolMaterial::cbn}).in_published_envelope;
  };
  CHECK(flag(30, 0.29, 0.1, 0));
  CHECK(flag(150, 0.29, 0.1, 0));
  CHECK_FALSE(flag(29.99, 0.29, 0.1, 0));
  CHECK_FALSE(flag(150.01, 0.29, 0.1, 0));
  CHECK(flag(60, 0.14, 0.1, 0));          // P_y, P_z exactly 100 N
  CHECK_FALSE(flag(60, 0.139, 0.1, 0));   // below 100 N
  CHECK_FALSE(flag(60, 0.71, 0.05, 0));   // feed
  CHECK_FALSE(flag(60, 0.3, 0.26, 0));    // depth
  CHECK_FALSE(flag(60, 0.29, 0.1, 0.3));  // P_y above 500 N: wear itself is not tested
  CHECK(flag(60, 0.14, 0.1, 0.25));
}

TEST_CASE("K106: growth with time passes the printed points and starts at 1", "[K106]") {
  CHECK(force_growth_with_time({0}).factor_y == 1);
  CHECK(force_growth_with_time({10}).factor_y == Approx(2.25));
  CHECK(force_growth_with_time({40}).factor_y == Approx(4));
  CHECK(force_growth_with_time({40}).factor_z == Approx(1.2));
}

TEST_CASE("K106: edge length and flank pressure are consistent with the wear data", "[K106]") {
  const double b = active_edge_length({3.5, 0.1, 0.14}).length_mm;
  CHECK(b == Approx(0.909).margin(0.0005));
  CHECK(flank_contact_pressure({150, 0.1, b}).pressure_mpa == Approx(1651).margin(0.5));
  // Whole quarter at full depth, half circle with the widest feed.
  CHECK(active_edge_length({2, 2, 0}).length_mm == Approx(3.14159265).epsilon(1e-8));
  CHECK(active_edge_length({2, 2, 4}).length_mm == Approx(2 * 3.14159265).epsilon(1e-8));
}

TEST_CASE("K106: chatter of ceramic, ends included", "[K106]") {
  CHECK(ceramic_chatter_risk({60, 0.1}).risk);
  CHECK(ceramic_chatter_risk({100, 0.3}).risk);
  CHECK_FALSE(ceramic_chatter_risk({59.9, 0.1}).risk);
  CHECK_FALSE(ceramic_chatter_risk({100.1, 0.1}).risk);
  CHECK_FALSE(ceramic_chatter_risk({80, 0.099}).risk);
}

TEST_CASE("K106: power is never critical and the tested bar hardly bends", "[K106]") {
  CHECK(cutting_power({400, 150}).power_kw == Approx(1));
  CHECK(part_deflection({500, 600, 150, 210000}).deflection_um < 0.5);
  CHECK(part_deflection({100, 200, 10, 210000}).deflection_um /
            part_deflection({100, 100, 20, 210000}).deflection_um ==
        Approx(8 * 16));
}

TEST_CASE("K106: bad input names itself", "[K106]") {
  CHECK_THROWS_WITH(active_edge_length({3.5, 4, 0.1}), "K106.active_edge_length: t = 4, must not be above r");
  CHECK_THROWS_WITH(force_growth_with_time({61}), Catch::Contains("tau = 61, allowed 0 <= tau <= 60"));
  CHECK_THROWS_WITH(
      catalogue()
          .at("K106.hard_turning_forces")
          .evaluate(Value::Map{
              {"v", 60.0}, {"s", 0.3}, {"t", 0.1}, {"h", 0.0}, {"rake", "round"}, {"tool_material", "cbn"}}),
      Catch::Contains("rake = \"round\", must be one of \"flat\", \"cylindrical\""));
}
