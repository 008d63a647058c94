// The checks of card K210; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/dynamics/k210_hydrostatic_bearing.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k210;

namespace {

constexpr double pi = std::numbers::pi;

Load load(double x_n, double y_n, double rpm, double gain) {
  Load in;
  in.load_x_n = x_n;
  in.load_y_n = y_n;
  in.spindle_rpm = rpm;
  in.feedback_gain = gain;
  return in;
}

Bearing bearing(double rpm, double gain) {
  Bearing b;
  b.spindle_rpm = rpm;
  b.feedback_gain = gain;
  return b;
}

}  // namespace

TEST_CASE("K210: centred without rotation every pocket holds beta p_s", "[K210]") {
  for (const std::int64_t pockets : {3, 4, 5}) {
    Displacement in;
    in.spindle_rpm = 0;
    in.pockets = pockets;
    const PocketState s = pocket_state(in);
    for (const double p : s.p_mpa) CHECK(p == Approx(2.0));
    CHECK(std::hypot(s.fx_n, s.fy_n) < 1e-9);
    // N beta p_s k_a(c)
    const double ka =
        2 * (pi * 0.175 / static_cast<double>(pockets)) * std::pow(60e-6, 3) / (12 * 0.28 * 0.0325);
    CHECK(s.flow_l_min == Approx(static_cast<double>(pockets) * 2e6 * ka * 6e4));
  }
  CHECK(pocket_state({}).flow_l_min == Approx(0.261).margin(5e-4));
}

TEST_CASE("K210: pressures solve the pocket balance", "[K210]") {
  verstat::test::property([] {
    Displacement in;
    in.ex_um = *rc::gen::inRange(-35, 36);
    in.ey_um = *rc::gen::inRange(-35, 36);
    in.spindle_rpm = *rc::gen::inRange(0, 400);
    in.feedback_gain = 0.5 * *rc::gen::inRange(0, 20);
    in.pockets = *rc::gen::inRange(3, 6);
    const PocketState s = pocket_state(in);
    // Dense solution of the card's equations.
    const auto n = static_cast<int>(in.pockets);
    const double c = 60e-6, mu = 0.28, pitch = pi * 0.175 / n, a = 0.0325, b = pitch - 0.09, lp = 0.18;
    const double u = pi * 0.175 * in.spindle_rpm / 60;
    const auto film = [&](double i) {
      const double angle = 2 * pi * i / n;
      return c - 1e-6 * (in.ex_um * std::cos(angle) + in.ey_um * std::sin(angle));
    };
    const auto cube = [](double h) { return h * h * h; };
    const double g0 = 2 * pitch * cube(c) / (12 * mu * a);
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd rhs(n);
    for (int i = 0; i < n; ++i) {
      const double opening = std::clamp(1 + in.feedback_gain * (c - film(i)) / c, 0.0, 10.0);
      const double after = lp * cube(film(i + 0.5)) / (12 * mu * b);
      const double before = lp * cube(film(i - 0.5)) / (12 * mu * b);
      m(i, i) += g0 * opening + 2 * pitch * cube(film(i)) / (12 * mu * a) + after + before;
      m(i, (i + 1) % n) -= after;
      m(i, (i + n - 1) % n) -= before;
      rhs(i) = g0 * opening * 4e6 - 0.5 * lp * u * (film(i + 0.5) - film(i - 0.5));
    }
    const Eigen::VectorXd p = m.partialPivLu().solve(rhs);
    for (int i = 0; i < n; ++i)
      RC_ASSERT(std::abs(s.p_mpa[static_cast<std::size_t>(i)] - p(i) * 1e-6) < 1e-9);
  });
}

TEST_CASE("K210: direct stiffness is proportional to 1 + K/3 and to the supply pressure", "[K210]") {
  const double plain = static_stiffness(bearing(0, 0)).k_direct_n_um;
  CHECK(plain == Approx(1422).margin(0.5));
  for (const double gain : {1.0, 5.0, 20.0})
    CHECK(static_stiffness(bearing(0, gain)).k_direct_n_um == Approx(plain * (1 + gain / 3)).epsilon(1e-5));
  Bearing strong = bearing(0, 0);
  strong.supply_pressure_mpa = 12;
  CHECK(static_stiffness(strong).k_direct_n_um == Approx(3 * plain));
}

TEST_CASE("K210: small loads displace by load over stiffness", "[K210]") {
  const double k = static_stiffness(bearing(0, 2)).k_direct_n_um;
  CHECK(shaft_equilibrium(load(10, 0, 0, 2)).ex_um == Approx(10 / k).epsilon(1e-4));
}

TEST_CASE("K210: a load turned by a pocket pitch turns the answer", "[K210]") {
  const Equilibrium a = shaft_equilibrium(load(20000, 0, 0, 0));
  const double angle = 2 * pi / 5;
  const Equilibrium b = shaft_equilibrium(load(20000 * std::cos(angle), 20000 * std::sin(angle), 0, 0));
  CHECK(b.ex_um == Approx(a.ex_um * std::cos(angle) - a.ey_um * std::sin(angle)));
  CHECK(b.ey_um == Approx(a.ex_um * std::sin(angle) + a.ey_um * std::cos(angle)));
}

TEST_CASE("K210: equilibrium balances the load, with the attitude of the rotation", "[K210]") {
  const Equilibrium e = shaft_equilibrium(load(5000, 0, 100, 0));
  CHECK(e.ex_um == Approx(0.589).margin(5e-4));
  CHECK(e.ey_um == Approx(1.313).margin(5e-4));
  Displacement at;
  at.ex_um = e.ex_um;
  at.ey_um = e.ey_um;
  CHECK(pocket_state(at).fx_n == Approx(-5000).margin(1e-3));
  CHECK(pocket_state(at).fy_n == Approx(0).margin(1e-3));
  CHECK(e.h_min_um == Approx(60 - e.eccentricity_um));
  CHECK(shaft_equilibrium(load(5000, 0, -100, 0)).ey_um == Approx(-e.ey_um));
}

TEST_CASE("K210: feedback brings the shaft back", "[K210]") {
  for (const double w : {5000.0, 20000.0, 60000.0}) {
    double before = 1e9;
    for (const double gain : {0.0, 1.0, 3.0, 10.0, 20.0}) {
      const double now = shaft_equilibrium(load(w, 0, 0, gain)).eccentricity_um;
      CHECK(now < before);
      before = now;
    }
  }
}

TEST_CASE("K210: an overload is an error, never a result", "[K210]") {
  CHECK_THROWS_WITH(shaft_equilibrium(load(80000, 0, 0, 0)),
                    Catch::StartsWith("K210.shaft_equilibrium: no equilibrium below 0.98 of the clearance"));
}

TEST_CASE("K210: centring load against every choice of open pockets", "[K210]") {
  Bearing b;
  CHECK(centring_load_capacity(b).load_n == Approx(60400).margin(50));
  double before = 0;
  for (const double limit : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    b.conductance_max = limit;
    const double now = centring_load_capacity(b).load_n;
    CHECK(now >= before);
    before = now;
  }
  CHECK(before == Approx(73300).margin(50));
  // Brute force over conductances 0, 1/2 and full of all five pockets.
  b.conductance_max = 10;
  const double c = 60e-6, mu = 0.28, pitch = pi * 0.175 / 5;
  const double ka = 2 * pitch * c * c * c / (12 * mu * 0.0325);
  const double kc = 0.18 * c * c * c / (12 * mu * (pitch - 0.09));
  const double area = (0.18 + 0.0325) * 0.175 * std::sin(pi / 5);
  double best = 0;
  for (int code = 0; code < 243; ++code) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(5, 5);
    Eigen::VectorXd rhs(5);
    int rest = code;
    for (int i = 0; i < 5; ++i, rest /= 3) {
      const double g = ka * 10 * (rest % 3) / 2;
      m(i, i) += g + ka + 2 * kc;
      m(i, (i + 1) % 5) -= kc;
      m(i, (i + 4) % 5) -= kc;
      rhs(i) = g * 4e6;
    }
    const Eigen::VectorXd p = m.partialPivLu().solve(rhs);
    double force = 0;
    for (int i = 0; i < 5; ++i) force += p(i) * area * std::cos(2 * pi * i / 5);
    best = std::max(best, force);
  }
  CHECK(centring_load_capacity(b).load_n == Approx(best).epsilon(1e-9));
}

TEST_CASE("K210: heat of the default bearing", "[K210]") {
  LossInputs in;
  in.flow_l_min = 0.261;
  const Losses l = bearing_losses(in);
  CHECK(l.friction_kw == Approx(0.210).margin(5e-4));
  CHECK(l.pump_kw == Approx(0.017).margin(5e-4));
  CHECK(l.temp_rise_c == Approx(31.7).margin(0.1));
  CHECK(l.outlet_c == Approx(22 + l.temp_rise_c));
  CHECK(oil_viscosity({22}).mu_pa_s == Approx(0.28));
}

TEST_CASE("K210: the pocket count follows from the published dimensions", "[K210]") {
  CHECK(pi * 175 / (90 + 20) == Approx(5).epsilon(1e-3));
}

TEST_CASE("K210: bad input names itself", "[K210]") {
  Displacement far;
  far.ex_um = 60;
  CHECK_THROWS_WITH(pocket_state(far), Catch::StartsWith("K210.pocket_state: ex_um = 60"));
  Bearing wide;
  wide.pockets = 6;
  wide.pocket_width_mm = 92;
  CHECK_THROWS_WITH(static_stiffness(wide),
                    Catch::StartsWith("K210.static_stiffness: pocket_width_mm = 92, must be below the pocket "
                                      "pitch"));
}
