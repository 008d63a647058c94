// The checks of card K310; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k310_pulse_current_contact.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k310;

TEST_CASE("K310: heat and energy grow with the square of the current", "[K310]") {
  const double one = contact_heat_power({.current_a = 100, .resistance_mohm = 0.7}).power_kw;
  const double two = contact_heat_power({.current_a = 200, .resistance_mohm = 0.7}).power_kw;
  CHECK(two == Approx(4 * one).epsilon(1e-14));
}

TEST_CASE("K310: constriction temperature and voltage are inverse, and 0 V leaves the body cold", "[K310]") {
  verstat::test::property([] {
    const double body_c = *rc::gen::inRange(-200, 400);
    const double voltage_v = *rc::gen::inRange(1, 2000) * 1e-3;
    const double hot_c = constriction_temperature({voltage_v, body_c}).temperature_c;
    RC_ASSERT(hot_c > body_c);
    RC_ASSERT(std::abs(constriction_voltage({hot_c, body_c}).voltage_v - voltage_v) < 1e-9);
  });
  CHECK(constriction_temperature({0, 20}).temperature_c == Approx(20).margin(1e-10));
}

TEST_CASE("K310: copper contacts soften at 0.12 V and melt at 0.43 V", "[K310]") {
  // Known contact data (Holm): 190 degC and 1083 degC; the relation meets them to 15 %.
  CHECK(constriction_temperature({0.12, 20}).temperature_c == Approx(190).epsilon(0.15));
  CHECK(constriction_temperature({0.43, 20}).temperature_c == Approx(1083).epsilon(0.15));
}

TEST_CASE("K310: U = I R links resistance, power, temperature and densities", "[K310]") {
  const double resistance_mohm = constriction_resistance({0.2, 10, 20}).resistance_mohm;
  CHECK(resistance_mohm == Approx(0.5));
  const double voltage_v = 200 * resistance_mohm * 1e-3;
  CHECK(constriction_temperature({voltage_v, 20}).temperature_c == Approx(163).margin(0.5));
  CHECK(specific_power({{200, resistance_mohm}, 10, 20}).specific_power_kw_mm2 == Approx(3.2).epsilon(0.01));
}

TEST_CASE("K310: bad input names itself", "[K310]") {
  CHECK_THROWS_WITH(constriction_voltage({10, 20}),
                    "K310.constriction_voltage: T = 10, must not be below T_body");
  CHECK_THROWS_WITH(
      treatment_time({1000, 4, 1, 2, 5}),
      "K310.treatment_time: overlap = 1, allowed 0 <= overlap < 1 (share of a spot covered again)");
}
