// The checks of card K408; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/dynamics/k408_stepped_axial_tool.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k408;

namespace {

constexpr double pi = std::numbers::pi;

AxialTool tool(std::int64_t scheme, std::vector<double> lengths, std::vector<double> diameters) {
  AxialTool in;
  in.scheme = scheme;
  in.length_mm = std::move(lengths);
  in.outer_mm = std::move(diameters);
  return in;
}
AxialTool reamer(std::int64_t scheme) {
  return tool(scheme, {28, 152, 78, 75}, {22.3, 18.9, 21.1, 22.1});
}
std::vector<double> omegas(const AxialTool& in, std::int64_t count) {
  return axial_tool_frequencies({in, count}).omega_rad_s;
}

// Natural frequencies by Hermite beam elements, an independent discretization.
std::vector<double> by_elements(const AxialTool& in, int per_segment, int count) {
  const auto elements = static_cast<Eigen::Index>(in.length_mm.size()) * per_segment;
  const Eigen::Index size = 2 * (elements + 1);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size), mass = stiffness;
  for (Eigen::Index e = 0; e < elements; ++e) {
    const auto s = static_cast<std::size_t>(e / per_segment);
    const double h = in.length_mm[s] * 1e-3 / per_segment, d = in.outer_mm[s] * 1e-3;
    const double ej = in.modulus_gpa * 1e9 * pi / 64 * d * d * d * d, m = in.density_kg_m3 * pi / 4 * d * d;
    Eigen::Matrix4d k, w;
    k << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h, 6 * h,
        2 * h * h, -6 * h, 4 * h * h;
    w << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h * h, 13 * h, -3 * h * h, 54, 13 * h, 156, -22 * h, -13 * h,
        -3 * h * h, -22 * h, 4 * h * h;
    stiffness.block<4, 4>(2 * e, 2 * e) += ej / (h * h * h) * k;
    mass.block<4, 4>(2 * e, 2 * e) += m * h / 420 * w;
  }
  std::vector<bool> held(static_cast<std::size_t>(size), false);
  if (in.scheme <= 4) held[0] = true;
  if (in.scheme <= 2 || in.scheme >= 5) held[1] = true;
  held[static_cast<std::size_t>(size - 2)] = true;
  if (in.scheme % 2 == 0) held[static_cast<std::size_t>(size - 1)] = true;
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < size; ++i)
    if (!held[static_cast<std::size_t>(i)]) free.push_back(i);
  const Eigen::MatrixXd k = stiffness(free, free), w = mass(free, free);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, w, Eigen::EigenvaluesOnly);
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(std::sqrt(solver.eigenvalues()(i)));
  return out;
}

AxialTool random_tool() {
  const int n = *rc::gen::inRange(1, 6);
  AxialTool in;
  for (int i = 0; i < n; ++i) {
    in.length_mm.push_back(*rc::gen::inRange(20, 150));
    in.outer_mm.push_back(*rc::gen::inRange(5, 41));
  }
  return in;
}

}  // namespace

TEST_CASE("K408: Krylov functions keep their identity and small arguments", "[K408]") {
  for (double x : {0.0, 1e-3, 0.3, 0.999999, 1.0, 1.000001, 3.0, 8.0}) {
    const auto k = krylov_abcd({x});
    CHECK(k.a * k.c - k.b * k.d == Approx(std::sin(x) * std::sin(x) / 2).epsilon(1e-9).margin(1e-12));
    CHECK(k.a + k.c == Approx(std::cosh(x)).epsilon(1e-14));
    CHECK(k.b + k.d == Approx(std::sinh(x)).epsilon(1e-14).margin(1e-300));
  }
  CHECK(krylov_abcd({1e-5}).d == Approx(1e-15 / 6).epsilon(1e-14));
  CHECK(krylov_abcd({1e-5}).c == Approx(0.5e-10).epsilon(1e-14));
}

TEST_CASE("K408: a uniform beam has its textbook frequencies", "[K408]") {
  const double lambda[6][3] = {
      {3.92660, 7.06858, 10.21018}, {4.73004, 7.85320, 10.99561},     {pi, 2 * pi, 3 * pi},
      {3.92660, 7.06858, 10.21018}, {pi / 2, 3 * pi / 2, 5 * pi / 2}, {2.36502, 5.49780, 8.63938}};
  const double wave = std::sqrt(210e9 / 7850) * 0.02 / 4 / (0.3 * 0.3);
  for (int scheme = 1; scheme <= 6; ++scheme) {
    const auto got = omegas(tool(scheme, {300}, {20}), 3);
    for (int k = 0; k < 3; ++k)
      CHECK(got[static_cast<std::size_t>(k)] ==
            Approx(lambda[scheme - 1][k] * lambda[scheme - 1][k] * wave).epsilon(4e-6));
    // The segments a uniform beam is split into do not matter.
    const auto split = omegas(tool(scheme, {40, 110, 25, 125}, {20, 20, 20, 20}), 6);
    const auto whole = omegas(tool(scheme, {300}, {20}), 6);
    for (std::size_t k = 0; k < 6; ++k) CHECK(split[k] == Approx(whole[k]).epsilon(1e-11));
  }
}

TEST_CASE("K408: six frequencies of random tools are those of beam elements", "[K408]") {
  verstat::test::property([] {
    auto in = random_tool();
    in.scheme = *rc::gen::inRange(1, 7);
    const auto got = omegas(in, 6);
    const auto elements = by_elements(in, in.length_mm.size() > 1 ? 16 : 36, 6);
    for (std::size_t k = 0; k < 6; ++k) RC_ASSERT(std::abs(got[k] / elements[k] - 1) < 2e-3);
  });
  const auto fine = by_elements(reamer(2), 15, 3);
  const auto got = omegas(reamer(2), 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(got[k] == Approx(fine[k]).epsilon(2e-5));
}

TEST_CASE("K408: constraints raise frequencies and the tips interlace", "[K408]") {
  verstat::test::property([] {
    auto in = random_tool();
    std::vector<std::vector<double>> w(7);
    for (int scheme = 1; scheme <= 6; ++scheme) {
      in.scheme = scheme;
      w[static_cast<std::size_t>(scheme)] = omegas(in, 5);
    }
    const double up = 1 + 1e-10;
    for (std::size_t k = 0; k < 5; ++k) {
      RC_ASSERT((w[2][k] * up >= w[1][k] && w[4][k] * up >= w[3][k] && w[6][k] * up >= w[5][k]));
      RC_ASSERT((w[1][k] * up >= w[3][k] && w[2][k] * up >= w[4][k]));
      if (k < 4)
        for (std::size_t pinned : {1U, 3U, 5U}) RC_ASSERT(w[pinned + 1][k] <= w[pinned][k + 1] * up);
    }
  });
}

TEST_CASE("K408: frequencies scale with size and sound speed", "[K408]") {
  const auto base = omegas(reamer(1), 3);
  auto scaled = reamer(1);
  for (double& x : scaled.length_mm) x *= 3;
  for (double& x : scaled.outer_mm) x *= 3;
  auto stiff = reamer(1);
  stiff.modulus_gpa *= 4;
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(omegas(scaled, 3)[k] == Approx(base[k] / 3).epsilon(1e-12));
    CHECK(omegas(stiff, 3)[k] == Approx(base[k] * 2).epsilon(1e-12));
  }
}

TEST_CASE("K408: a thin neck slows the tool without losing a frequency", "[K408]") {
  const auto neck = tool(5, {60, 80, 60}, {40, 2, 40});
  const auto got = omegas(neck, 3);
  // Few elements: the smaller they are, the more digits the stiff ends take from the neck.
  const auto elements = by_elements(neck, 6, 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(got[k] == Approx(elements[k]).epsilon(2e-3));
}

TEST_CASE("K408: mode shapes", "[K408]") {
  // A pinned beam in quarters: sin(2 pi x/L), largest first at the quarter nearest the holder.
  const auto second = axial_tool_mode({tool(3, {75, 75, 75, 75}, {20, 20, 20, 20}), 2}).displacement;
  const double sine[] = {0, 1, 0, -1, 0};
  for (std::size_t k = 0; k < 5; ++k) CHECK(second[k] == Approx(sine[k]).margin(1e-9));
  CHECK(second[0] == 0);
  CHECK(second[4] == 0);
  // The sixth mode too: nothing is lost on the way.
  const auto sixth = axial_tool_mode({tool(3, {35, 60, 205}, {20, 20, 20}), 6}).displacement;
  CHECK(sixth[1] == 1);
  CHECK(sixth[2] == Approx(std::sin(6 * pi * 95 / 300) / std::sin(6 * pi * 35 / 300)).epsilon(1e-9));
}

TEST_CASE("K408: modes that no segment end shows are refused", "[K408]") {
  CHECK_THROWS_WITH(
      axial_tool_mode({tool(1, {300}, {20}), 1}),
      "K408.axial_tool_mode: length_mm = 1, segment: none of its ends moves under this scheme; split it");
  CHECK_THROWS_WITH(
      axial_tool_mode({tool(3, {150, 150}, {20, 20}), 2}),
      "K408.axial_tool_mode: mode = 2, has its nodal points at all segment ends; split a segment");
}

TEST_CASE("K408: receptance is symmetric, damped and flexible as the beam", "[K408]") {
  verstat::test::property([] {
    auto in = random_tool();
    in.scheme = *rc::gen::inRange(1, 7);
    const auto n = static_cast<std::int64_t>(in.length_mm.size());
    const std::int64_t i = *rc::gen::inRange<std::int64_t>(0, n + 1),
                       j = *rc::gen::inRange<std::int64_t>(0, n + 1);
    const double frequency = std::exp(*rc::gen::inRange(0, 100) * 0.1);
    const auto there = axial_tool_receptance({in, i, j, frequency, 0.03});
    const auto back = axial_tool_receptance({in, j, i, frequency, 0.03});
    const double slack = 1e-9 * there.magnitude_um_n + 1e-18;
    RC_ASSERT(std::abs(there.real_um_n - back.real_um_n) <= slack);
    RC_ASSERT(std::abs(there.imaginary_um_n - back.imaginary_um_n) <= slack);
    if (i == j) RC_ASSERT(there.imaginary_um_n <= 0);
  });
  // Static: clamped-pinned beam loaded in the middle, 7 L^3 / (768 EJ).
  const double ej = 210e9 * pi / 64 * std::pow(0.02, 4);
  const auto fixed = axial_tool_receptance({tool(1, {150, 150}, {20, 20}), 1, 1, 1e-3, 0});
  CHECK(fixed.real_um_n == Approx(1e6 * 7 * std::pow(0.3, 3) / (768 * ej)).epsilon(1e-9));
  // Static: sliding-pinned beam loaded at the sliding end, L^3 / (3 EJ).
  const auto floating = axial_tool_receptance({tool(5, {100, 200}, {20, 20}), 0, 0, 1e-3, 0});
  CHECK(floating.real_um_n == Approx(1e6 * std::pow(0.3, 3) / (3 * ej)).epsilon(1e-6));
  // Supported nodes do not move.
  CHECK(axial_tool_receptance({reamer(1), 0, 2, 300, 0.02}).magnitude_um_n == 0);
}

TEST_CASE("K408: receptance peaks at the natural frequencies with a height of 1/loss factor", "[K408]") {
  const auto frequency = axial_tool_frequencies({reamer(1), 2}).frequency_hz;
  for (double f : frequency) {
    const auto at = [&](double x, double loss) {
      return axial_tool_receptance({reamer(1), 2, 2, x, loss}).magnitude_um_n;
    };
    CHECK(at(f, 0.001) > at(f * 1.002, 0.001));
    CHECK(at(f, 0.001) > at(f / 1.002, 0.001));
    CHECK(at(f, 0.001) == Approx(2 * at(f, 0.002)).epsilon(0.01));
  }
}

TEST_CASE("K408: speed limits of the published tool", "[K408]") {
  CHECK(reaming_speed_limit({3956 / (2 * pi), 8, 20, 0.2}).spindle_rpm == Approx(3778).margin(0.6));
  CHECK(reaming_speed_limit({2367 / (2 * pi), 8, 20, 0.2}).speed_m_min == Approx(142).margin(0.5));
  CHECK(reaming_speed_limit({587.4 / (2 * pi), 8, 20, 0.2}).spindle_rpm == Approx(561).margin(0.5));
}

TEST_CASE("K408: bad input names itself", "[K408]") {
  auto short_list = reamer(1);
  short_list.outer_mm.pop_back();
  CHECK_THROWS_WITH(axial_tool_frequencies({short_list, 3}),
                    "K408.axial_tool_frequencies: outer_mm = 3, entries: must have as many as length_mm (4)");
  auto hollow = reamer(1);
  hollow.inner_mm = {0, 19, 0, 0};
  CHECK_THROWS_WITH(axial_tool_frequencies({hollow, 3}),
                    "K408.axial_tool_frequencies: inner_mm = 19, must be below outer_mm of its segment");
}
