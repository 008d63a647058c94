// The checks of card K403; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/gauss_legendre.h"
#include "models/thermal/k403_unsteady_cutting_temperature.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k403;

namespace {

ContinuousCut cut(double v, double s, double t, double h, Model model = Model::exact, double time = -1) {
  ContinuousCut in;
  in.cutting_speed_m_min = v;
  in.feed_mm_rev = s;
  in.depth_mm = t;
  in.flank_wear_mm = h;
  in.time_s = time;
  in.m_model = model;
  in.wedge = model;
  return in;
}

double steady_rise(double v, double s, double t, double h) {
  return cutting_temperature(cut(v, s, t, h)).mean_c - 20;
}

}  // namespace

TEST_CASE("K403: Gauss rule of 24 points integrates polynomials of degree 47", "[K403]") {
  for (int degree : {0, 1, 5, 20, 47}) {
    const double integral =
        integrate_gauss([&](double x) { return std::pow(x, degree); }, 0, 1, gauss_legendre_24());
    CHECK(integral == Approx(1.0 / (degree + 1)).epsilon(1e-13));
  }
}

TEST_CASE("K403: both sides of each contact have the same temperature", "[K403]") {
  verstat::test::property([] {
    const auto any = [](int low, int high, double unit) { return *rc::gen::inRange(low, high) * unit; };
    const double l = any(20, 200, 0.01), h = any(1, 50, 0.01), m = any(1, 101, 0.01);
    ChipSide chip{.cutting_speed_m_min = any(20, 250, 1),
                  .chip_compression = any(12, 50, 0.1),
                  .rake_length_mm = l,
                  .flank_length_mm = h,
                  .m = m,
                  .m1 = any(50, 200, 0.01),
                  .shear_flux_w_mm2 = any(100, 3000, 1),
                  .rake_flux_w_mm2 = any(50, 500, 1),
                  .flank_flux_w_mm2 = any(50, 900, 1),
                  .chip_share = any(50, 100, 0.01),
                  .flank_temperature_share = any(10, 100, 0.01)};
    const double m2 = any(200, 400, 0.01), n = any(50, 100, 0.01);
    const auto k = chip_side_coefficients(chip);
    const auto q =
        heat_fluxes({k.k1_k, k.k2_k, k.k3_m2k_w, k.k4_m2k_w, l, h, m, m2, n, n, chip.tool_conductivity_w_mk});
    const auto rise = contact_temperatures(
        {q.rake_w_mm2, q.flank_w_mm2, l, h, m, chip.m1, m2, n, n, chip.tool_conductivity_w_mk});
    // Drain of the chip side alone: K4 without its tool part.
    chip.m = 0;
    const double drain = chip_side_coefficients(chip).k4_m2k_w;
    RC_ASSERT(std::abs(k.k1_k - drain * q.rake_w_mm2 * 1e6 - rise.rake) < 1e-9 * k.k1_k);
    RC_ASSERT(std::abs(k.k2_k - k.k3_m2k_w * q.flank_w_mm2 * 1e6 - rise.flank) < 1e-9 * (k.k1_k + k.k2_k));
  });
}

TEST_CASE("K403: at the start nothing is warm and the rake flux is finite and largest", "[K403]") {
  const auto start = cutting_temperature(cut(80, 0.4, 1, 0.1, Model::exact, 0));
  CHECK(start.mean_c == Approx(20));
  CHECK(start.m == 0);
  double previous = start.rake_flux_w_mm2;
  for (double time : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const double flux = cutting_temperature(cut(80, 0.4, 1, 0.1, Model::exact, time)).rake_flux_w_mm2;
    CHECK(flux < previous);
    previous = flux;
  }
}

TEST_CASE("K403: fluxes of the paper's Fig. 1", "[K403]") {
  struct Row {
    double time_s, rake, flank;
  };
  for (const Row& row :
       {Row{0.2, 333, 285}, Row{0.5, 297, 111}, Row{2, 204, -197}, Row{4, 149, -257}, Row{15, 64, -171}}) {
    const auto at = cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper, row.time_s));
    CHECK(at.rake_flux_w_mm2 == Approx(row.rake).margin(0.6));
    CHECK(at.flank_flux_w_mm2 == Approx(row.flank).margin(0.6));
  }
  CHECK(cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper, 0.7)).flank_flux_w_mm2 > 0);
  CHECK(cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper, 0.9)).flank_flux_w_mm2 < 0);
}

TEST_CASE("K403: steady temperatures of the tested regime", "[K403]") {
  const auto worn = cutting_temperature(cut(80, 0.4, 1, 0.1));
  CHECK(worn.rake_c == Approx(876).margin(0.5));
  CHECK(worn.flank_c == Approx(400).margin(0.5));
  CHECK(worn.mean_c == Approx(834).margin(0.5));
  const auto sharp = cutting_temperature(cut(80, 0.4, 1, 0));
  CHECK(sharp.mean_c == Approx(917).margin(0.5));
  CHECK(sharp.flank_c == 20);
  CHECK(sharp.mean_c == sharp.rake_c);
}

TEST_CASE("K403: local exponents of the steady mean rise", "[K403]") {
  const double base = steady_rise(80, 0.4, 1, 0.1);
  const auto exponent = [&](double rise) { return std::log(rise / base) / std::log(1.01); };
  const double in_v = exponent(steady_rise(80.8, 0.4, 1, 0.1));
  const double in_s = exponent(steady_rise(80, 0.404, 1, 0.1));
  const double in_t = exponent(steady_rise(80, 0.4, 1.01, 0.1));
  CHECK((in_v > 0.35 && in_v < 0.39));
  CHECK((in_s > 0.12 && in_s < 0.19));
  CHECK((in_t > 0.03 && in_t < 0.07));
}

TEST_CASE("K403: wedge functions meet the tables", "[K403]") {
  const double eta[] = {1, 2, 3, 5, 10, 20};
  const double exact_90[] = {0.650, 0.946, 1.148, 1.424, 1.826, 2.247};
  const double exact_60[] = {0.858, 1.286, 1.582, 1.991, 2.591, 3.221};
  const double paper_90[] = {0.754, 0.928, 1.091, 1.391, 2.044, 3.127};
  const double paper_60[] = {1.064, 1.309, 1.540, 1.964, 2.885, 4.414};
  // The tables of the exact solution are up to 3e-4 of the value above the converged integrals.
  for (int k = 0; k < 6; ++k) {
    CHECK(wedge_functions({eta[k], 1, 0, 90, Model::exact}).m1 == Approx(exact_90[k]).margin(1e-3));
    CHECK(wedge_functions({eta[k], 1, 0, 60, Model::exact}).m1 == Approx(exact_60[k]).margin(1e-3));
    CHECK(wedge_functions({eta[k], 1, 0, 90, Model::paper}).m1 == Approx(paper_90[k]).margin(6e-4));
    CHECK(wedge_functions({eta[k], 1, 0, 60, Model::paper}).m1 == Approx(paper_60[k]).margin(6e-4));
  }
}

TEST_CASE("K403: wedge functions are reciprocal, fall with the angle and rise with the width", "[K403]") {
  const auto at = [](double b, double l, double h, double beta) {
    return wedge_functions({b, l, h, beta, Model::exact});
  };
  const auto one = at(2, 1, 0.3, 80);
  CHECK(one.n1 == one.n2);
  CHECK(at(2, 0.3, 1, 80).n1 == Approx(one.n1).epsilon(1e-12));  // heat from h to l as from l to h
  const auto blunt = at(2, 1, 0.3, 90);
  const auto wide = at(3, 1, 0.3, 80);
  CHECK((blunt.m1 < one.m1 && blunt.m2 < one.m2 && blunt.n1 < one.n1));
  CHECK((wide.m1 > one.m1 && wide.m2 > one.m2 && wide.n1 > one.n1));
  // h -> 0: the flank contact becomes the edge, whose temperature is finite.
  CHECK(at(2, 1, 1e-4, 80).n1 == Approx(at(2, 1, 1e-5, 80).n1).epsilon(2e-3));
}

TEST_CASE("K403: exact warm-up starts as the square root of time and ends at the wedge function", "[K403]") {
  const double fo[] = {0.01, 0.1, 1, 10, 100, 400};
  const double share[] = {0.094, 0.267, 0.596, 0.854, 0.953, 0.977};
  for (int k = 0; k < 6; ++k) CHECK(m_fo_exact({fo[k], 3}).m == Approx(share[k]).margin(6e-4));
  // Two independent solutions: constant flux on a half space, and images for the steady state.
  const double steady = wedge_functions({3, 1, 0, 90, Model::exact}).m1;
  CHECK(m_fo_exact({1e-6, 3}).m * steady == Approx(1.1284e-3).epsilon(2e-3));
  CHECK(m_fo_exact({1e12, 3}).m == Approx(1).epsilon(1e-5));
  verstat::test::property([] {
    const double eta = *rc::gen::inRange(2, 500) * 0.1;
    const double low = std::exp(*rc::gen::inRange(-100, 150) * 0.1);
    RC_ASSERT(m_fo_exact({low, eta}).m < m_fo_exact({low * 1.1, eta}).m);
  });
}

TEST_CASE("K403: periodic warm-up lies between one contact and the steady state", "[K403]") {
  for (double eta : {0.5, 2.0, 10.0})
    for (double period : {0.01, 1.0, 30.0}) {
      CHECK(m_periodic({period, period, eta}).m == Approx(1).epsilon(1e-12));
      double previous = 0;
      for (double share : {0.05, 0.3, 0.7, 0.95}) {
        const double m = m_periodic({share * period, period, eta}).m;
        CHECK(m >= m_fo_exact({share * period, eta}).m);
        CHECK(m > previous);
        CHECK(m < 1);
        previous = m;
      }
      CHECK(m_periodic({(1 - 1e-6) * period, period, eta}).m == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("K403: settling times", "[K403]") {
  Settling in;
  static_cast<CuttingZone&>(in) = cut(80, 0.4, 1, 0.1);
  CHECK(settling_time(in).time_s == Approx(0.07).margin(0.002));
  in.m_model = in.wedge = Model::paper;
  CHECK(settling_time(in).time_s == Approx(13.4).margin(0.05));
  in.fo_scale = 3.36;
  CHECK(settling_time(in).time_s == Approx(4.0).margin(0.01));
  // It is the first time: the temperature there is the fraction, before it lower.
  in.fo_scale = 1;
  const double time = settling_time(in).time_s;
  const double steady = cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper)).mean_c - 20;
  CHECK(cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper, time)).mean_c - 20 == Approx(0.95 * steady));
  CHECK(cutting_temperature(cut(80, 0.4, 1, 0.1, Model::paper, 0.99 * time)).mean_c - 20 < 0.95 * steady);
}

TEST_CASE("K403: the speed for a temperature inverts the temperature", "[K403]") {
  TemperatureLimit in;
  static_cast<CuttingZone&>(in) = cut(0, 0.4, 1, 0.1);
  in.limit_c = 850;
  const double speed = speed_for_temperature(in).speed_m_min;
  CHECK(cutting_temperature(cut(speed, 0.4, 1, 0.1)).mean_c == Approx(850).epsilon(1e-10));
  in.limit_c = 100;
  CHECK_FALSE(speed_for_temperature(in).feasible);
  in.limit_c = 5000;
  CHECK(speed_for_temperature(in).speed_m_min == 600);
}

TEST_CASE("K403: special cases join their neighbours", "[K403]") {
  // h -> 0 and m -> 0 of the flank balance; the temperature under the flank across its two formulas.
  const auto nearly = heat_fluxes({1000, 280, 6e-10, 1.2e-5, 1, 1e-7, 0.5, 2.1, 0.8, 0.8, 37.7});
  CHECK(nearly.rake_w_mm2 ==
        Approx(heat_fluxes({1000, 280, 6e-10, 1.2e-5, 1, 0, 0.5, 2.1, 0.8, 0.8, 37.7}).rake_w_mm2)
            .epsilon(2e-2));
  const auto cold = heat_fluxes({1000, 280, 6e-7, 1.2e-5, 1, 0.1, 1e-12, 2.1, 0.8, 0.8, 37.7});
  CHECK(cold.flank_w_mm2 ==
        Approx(heat_fluxes({1000, 280, 6e-7, 1.2e-5, 1, 0.1, 0, 2.1, 0.8, 0.8, 37.7}).flank_w_mm2)
            .epsilon(1e-6));
  double previous = 1;
  for (double h = 1e-6; h < 1e4; h *= 1.05) {
    const double share = heat_sources({80, 0.4, 1, h}).flank_temperature_share;
    CHECK(share < previous);
    CHECK(share > 0.9 * previous);  // no jump where the series, erfc and the asymptote meet
    previous = share;
  }
}

TEST_CASE("K403: bad input names itself", "[K403]") {
  CHECK_THROWS_WITH(m_periodic({2, 1, 2}), "K403.m_periodic: fo_cut = 2, must not be above fo_period");
  auto steep = cut(80, 0.4, 1, 0.1);
  steep.relief_deg = 65;
  CHECK_THROWS_WITH(cutting_temperature(steep),
                    "K403.cutting_temperature: alpha = 65, must leave a wedge angle 90 - gamma - alpha of 30 "
                    "to 120 deg");
}
