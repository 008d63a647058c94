// The checks of card K110; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/thermal/k110_contact_hot_spots.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k110;

namespace {

double real(int low, int high, double scale) {
  return *rc::gen::inRange(low, high) * scale;
}

}  // namespace

TEST_CASE("K110: hot-spot factors of the text", "[K110]") {
  CHECK(thermal_severity({2000, 900, 1650}).hot_spot_factor == Approx(2.25));
  CHECK(thermal_severity({2000, 1129, 1650}).hot_spot_factor == Approx(1.79).margin(0.005));
  CHECK(thermal_severity({800, 300, 640}).hot_spot_factor == Approx(2.79).margin(0.005));
  CHECK(thermal_severity({400, 200, 640}).hot_spot_factor == Approx(2.11).margin(0.005));
  CHECK(thermal_severity({20, 200, 640}).hot_spot_factor == 0);
  CHECK(thermal_severity({640, 200, 640}).homologous_contact == 1);
  CHECK(thermal_severity({2000, 900, 1650}).melting_margin_degc == -350);
  CHECK(thermal_severity({2300, 900, 1650}).melting_margin_degc == -650);
}

TEST_CASE("K110: records of the table", "[K110]") {
  CHECK(published_contact_temperature({Record::ti_ir_s03}).low_degc == 2300);
  CHECK(published_contact_temperature({Record::ti_fem_a}).high_degc == 700);
  CHECK(published_contact_temperature({Record::al_diamond_mean}).low_degc == 200);
  CHECK(published_contact_temperature({Record::al_diamond_mean}).high_degc == 300);
  CHECK(melting_temperature({Material::al_zn_mg_cu1_5}).temperature_degc == 640);
}

TEST_CASE("K110: the mean rise follows the cube root of speed and thickness", "[K110]") {
  const auto rise = [](double v, double h) {
    return mean_interface_temperature({700, 2.7, 48, v, h}).mean_degc - 20;
  };
  CHECK(rise(800, 0.1) == Approx(2 * rise(100, 0.1)));
  CHECK(rise(100, 0.8) == Approx(2 * rise(100, 0.1)));
  CHECK(mean_interface_temperature({700, 2.7, 48, 600, 0.1}).mean_degc == Approx(305).margin(0.5));
  CHECK(mean_interface_temperature({700, 2.7, 48, 1300, 0.4}).mean_degc == Approx(606).margin(0.5));
  // Titanium with u = 1400 h^-0.23: far above the quoted 900 degC unless the coefficient is calibrated.
  for (const double h : {0.1, 0.2}) {
    const double u = 1400 * std::pow(h, -0.23);
    const double t = mean_interface_temperature({u, 2.33, 2.9, 75, h}).mean_degc;
    CHECK(t > 1445);
    CHECK(t < 1565);
    const double calibrated = 0.4 * (900 - 20) / (t - 20);
    CHECK(calibrated > 0.225);
    CHECK(calibrated < 0.255);
  }
}

TEST_CASE("K110: the speed limit inverts the mean temperature, and falls with the cube of the factor",
          "[K110]") {
  verstat::test::property([] {
    const double u = real(300, 5000, 1);
    const double rho_c = real(15, 40, 0.1);
    const double a = real(2, 100, 1);
    const double h = real(2, 100, 0.01);
    const double v = real(5, 2000, 1);
    const double ambient = real(-50, 100, 1);
    const double c = real(10, 60, 0.01);
    const double mean = mean_interface_temperature({u, rho_c, a, v, h, ambient, c}).mean_degc;
    const double limit = speed_limit_by_temperature({u, rho_c, a, h, mean, ambient, 1, c}).speed_m_min;
    RC_ASSERT(std::abs(limit / v - 1) < 1e-9);
    const double hot = speed_limit_by_temperature({u, rho_c, a, h, mean, ambient, 2, c}).speed_m_min;
    RC_ASSERT(std::abs(8 * hot / limit - 1) < 1e-12);
  });
}

TEST_CASE("K110: flash temperature has the limits of a resting and a fast source", "[K110]") {
  // At rest the uniform circular source rises q r/k at its centre: 2/sqrt(1.273 pi) = 1.000.
  const Flash slow = asperity_flash_temperature({1, 0.3, 1e4, 1e-6, 5, 50, 10, 1});
  CHECK(slow.rise_k == Approx(slow.heat_flux_w_mm2 * 5 / 50).epsilon(1e-3));
  const Flash fast = asperity_flash_temperature({1, 0.3, 1e4, 1e7, 5, 50, 10, 1});
  CHECK(
      fast.rise_k ==
      Approx(2 * fast.heat_flux_w_mm2 * 5 / (50 * std::sqrt(std::numbers::pi * fast.peclet))).epsilon(1e-4));
  // Linear in the friction stress until the shear cap.
  const auto rise = [](double f) {
    return asperity_flash_temperature({2, f, 500, 100, 5, 6.7, 2.9, 0.5}).rise_k;
  };
  CHECK(rise(0.2) == Approx(2 * rise(0.1)));
  CHECK(rise(0.25) == Approx(rise(0.9)));
}

TEST_CASE("K110: flashes explain a part in titanium and little in aluminium", "[K110]") {
  struct Row {
    double radius, titanium, aluminium;
  };
  for (const Row row : {Row{1, 56, 7}, Row{5, 213, 32}, Row{20, 530, 95}}) {
    CHECK(asperity_flash_temperature({10, 1, 500, 100, row.radius, 6.7, 2.9, 0.5}).rise_k ==
          Approx(row.titanium).margin(0.6));
    CHECK(asperity_flash_temperature({10, 1, 200, 600, row.radius, 130, 48, 0.5}).rise_k ==
          Approx(row.aluminium).margin(0.6));
  }
}

TEST_CASE("K110: the wear multiplier has its limits and grows with energy, temperature and area", "[K110]") {
  CHECK(hot_zone_wear_multiplier({900, 900, 0.3, 80}).mean_rate_multiplier == 1);
  CHECK(hot_zone_wear_multiplier({900, 1300, 0, 80}).mean_rate_multiplier == 1);
  const HotZone whole = hot_zone_wear_multiplier({900, 1300, 1, 80});
  CHECK(whole.mean_rate_multiplier == Approx(whole.local_rate_ratio));
  verstat::test::property([] {
    const double mean = real(20, 2000, 1);
    const HotZoneInputs in{mean, mean + real(1, 900, 1), real(1, 90, 0.01), real(1, 900, 1)};
    const double base = hot_zone_wear_multiplier(in).mean_rate_multiplier;
    HotZoneInputs more = in;
    more.activation_energy_kj_mol += 10;
    RC_ASSERT(hot_zone_wear_multiplier(more).mean_rate_multiplier > base);
    more = in;
    more.hot_degc += 10;
    RC_ASSERT(hot_zone_wear_multiplier(more).mean_rate_multiplier > base);
    more = in;
    more.hot_area_fraction += 0.05;
    RC_ASSERT(hot_zone_wear_multiplier(more).mean_rate_multiplier > base);
  });
}

TEST_CASE("K110: bad input names itself", "[K110]") {
  CHECK_THROWS_WITH(thermal_severity({10, 900, 1650}),
                    "K110.thermal_severity: contact_temperature_degc = 10, must not be below ambient_degc");
  CHECK_THROWS_WITH(thermal_severity({900, 20, 1650}), Catch::Contains("mean_temperature_degc = 20"));
  CHECK_THROWS_WITH(speed_limit_by_temperature({700, 2.7, 48, 0.1, 20}),
                    Catch::Contains("temperature_limit_degc = 20"));
  CHECK_THROWS_WITH(hot_zone_wear_multiplier({900, 800, 0.1, 80}),
                    Catch::Contains("hot_temperature_degc = 800"));
}
