// The checks of card K307; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/inspection/k307_location_gauges.h"
#include "models/math/bivariate_normal.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k307;
using verstat::test::property;

namespace {

const GaugeDesign example{100, 20, 20, 0.2, 0.020, 0.020, 0.008, 0.008};

GaugeDesign random_design() {
  const auto um = [](int low, int high) { return *rc::gen::inRange(low, high) * 1e-3; };
  GaugeDesign in{um(50000, 300000), um(5000, 40000), um(5000, 40000), um(20, 500), 0, 0,
                 um(0, 10),         um(0, 10)};
  in.deviation_1_mm = in.wear_value_1_mm + um(0, 20);
  in.deviation_2_mm = in.wear_value_2_mm + um(0, 20);
  return in;
}

// P(X >= B, Y <= B') of X = C + s, Y = C - s, by the bivariate normal law.
double by_bivariate(const GaugedProcess& in) {
  const double m = (in.d1_mean_mm + in.d2_mean_mm) / 2;
  const double radius2 = (in.d1_sigma_mm * in.d1_sigma_mm + in.d2_sigma_mm * in.d2_sigma_mm) / 4;
  const double distance2 = in.distance_sigma_mm * in.distance_sigma_mm;
  const double sigma = std::sqrt(distance2 + radius2);
  return bivariate_normal_cdf((in.distance_mean_mm + m - in.b_outer_mm) / sigma,
                              (in.b_inner_mm - in.distance_mean_mm + m) / sigma,
                              (radius2 - distance2) / (radius2 + distance2));
}

}  // namespace

TEST_CASE("K307: the example of the card", "[K307]") {
  const GaugeSizes outer = gauge_outer_span(example);
  CHECK(outer.b_max_mm == Approx(119.820).epsilon(1e-12));
  CHECK(outer.b_min_mm == Approx(119.808).epsilon(1e-12));
  CHECK(outer.b_wear_mm == Approx(119.800).epsilon(1e-12));
  const GaugeSizes inner = gauge_inner_span(example);
  CHECK(inner.b_min_mm == Approx(80.180).epsilon(1e-12));
  CHECK(inner.b_max_mm == Approx(80.192).epsilon(1e-12));
  CHECK(inner.b_wear_mm == Approx(80.200).epsilon(1e-12));
}

TEST_CASE("K307: gauges are ordered and the pair is symmetric about the distance", "[K307]") {
  property([] {
    const GaugeDesign in = random_design();
    const GaugeSizes outer = gauge_outer_span(in);
    const GaugeSizes inner = gauge_inner_span(in);
    RC_ASSERT(outer.b_max_mm >= outer.b_min_mm && outer.b_min_mm >= outer.b_wear_mm);
    RC_ASSERT(inner.b_wear_mm >= inner.b_max_mm && inner.b_max_mm >= inner.b_min_mm);
    RC_ASSERT(std::abs((outer.b_wear_mm + inner.b_wear_mm) / 2 - in.distance_mm) < 1e-9);
    const double virtual_sum = in.d1_min_mm + in.d2_min_mm - 2 * in.tolerance_mm;
    RC_ASSERT(std::abs(outer.b_wear_mm - inner.b_wear_mm - virtual_sum) < 1e-9);
    RC_ASSERT(std::abs(outer.b_max_mm - outer.b_min_mm - outer.tolerance_mm) < 1e-9);
    RC_ASSERT(std::abs(inner.b_wear_mm - inner.b_max_mm - inner.wear_allowance_mm) < 1e-9);
  });
  GaugeDesign exact = example;
  exact.deviation_1_mm = exact.wear_value_1_mm;
  exact.deviation_2_mm = exact.wear_value_2_mm;
  CHECK(gauge_outer_span(exact).tolerance_mm == 0);
}

TEST_CASE("K307: worn gauges accept exactly the permitted deviation", "[K307]") {
  property([] {
    const GaugeDesign in = random_design();
    const double d1 = in.d1_min_mm + *rc::gen::inRange(0, 100) * 1e-3;
    const double d2 = in.d2_min_mm + *rc::gen::inRange(0, 100) * 1e-3;
    const double deviation =
        allowed_center_deviation({d1, d2, in.d1_min_mm, in.d2_min_mm, in.tolerance_mm}).deviation_mm;
    RC_ASSERT(std::abs(deviation - in.tolerance_mm - (d1 + d2 - in.d1_min_mm - in.d2_min_mm) / 2) < 1e-9);
    const double outer = gauge_outer_span(in).b_wear_mm;
    const double inner = gauge_inner_span(in).b_wear_mm;
    const auto accepts = [&](double c) { return gauge_accepts({c, d1, d2, outer, inner}).accept; };
    for (const double side : {-1.0, 1.0}) {
      RC_ASSERT(accepts(in.distance_mm + side * deviation));
      RC_ASSERT(!accepts(in.distance_mm + side * (deviation + 1e-6)));
    }
  });
}

TEST_CASE("K307: the pass probability is the bivariate normal one, whichever scatters more", "[K307]") {
  property([] {
    const double distance_sigma = std::pow(10.0, *rc::gen::inRange(-300, 0) * 0.01);
    const double hole_sigma = std::pow(10.0, *rc::gen::inRange(-300, 0) * 0.01);
    const GaugedProcess in{100 + *rc::gen::inRange(-300, 300) * 1e-3,
                           distance_sigma,
                           20 + *rc::gen::inRange(-50, 200) * 1e-3,
                           hole_sigma,
                           20 + *rc::gen::inRange(-50, 200) * 1e-3,
                           hole_sigma / 2,
                           119.82,
                           80.18};
    RC_ASSERT(std::abs(gauge_pass_probability(in).p - by_bivariate(in)) < 1e-10);
  });
}

TEST_CASE("K307: worn gauges and larger holes pass more, offset and scatter less", "[K307]") {
  const GaugedProcess in{100, 0.1, 20.026, 0.008, 20.026, 0.008, 119.82, 80.18};
  const double p = gauge_pass_probability(in).p;
  CHECK(p == Approx(0.9603).margin(5e-5));
  GaugedProcess worn = in;
  worn.b_outer_mm = 119.8;
  worn.b_inner_mm = 80.2;
  CHECK(gauge_pass_probability(worn).p == Approx(0.9760).margin(5e-5));
  GaugedProcess larger = in;
  larger.d1_mean_mm += 0.01;
  CHECK(gauge_pass_probability(larger).p > p);
  GaugedProcess offset = in;
  offset.distance_mean_mm += 0.05;
  CHECK(gauge_pass_probability(offset).p < p);
  GaugedProcess wider = in;
  wider.distance_sigma_mm = 0.12;
  CHECK(gauge_pass_probability(wider).p < p);
  // With the mean outside the band more scatter helps.
  GaugedProcess outside = in;
  outside.distance_mean_mm = 100.5;
  GaugedProcess outside_wider = outside;
  outside_wider.distance_sigma_mm = 0.2;
  CHECK(gauge_pass_probability(outside_wider).p > gauge_pass_probability(outside).p);
  // No scatter of the holes is the limit of little scatter.
  GaugedProcess little = in, none = in;
  little.d1_sigma_mm = little.d2_sigma_mm = 1e-9;
  none.d1_sigma_mm = none.d2_sigma_mm = 0;
  CHECK(gauge_pass_probability(little).p == Approx(gauge_pass_probability(none).p).epsilon(1e-8));
}

TEST_CASE("K307: gauge life and thermal assembly", "[K307]") {
  CHECK(gauge_life_checks({119.82, 119.8, 0.002}).checks == 10000);
  CHECK(gauge_life_checks({80.18, 80.2, 0.003}).checks == 6666);
  CHECK(heating_temperature({100, 0.12, 0.05, 11.5e-6, 20}).temperature_c == Approx(167.8).margin(0.05));
  CHECK(axial_gap({80, 11.5e-6, 150, 20}).gap_mm == Approx(0.12).margin(0.001));
  CHECK(reduced_deviation({20.00, 20.00, 20.05}).deviation == Approx(-1));
  CHECK(reduced_deviation({20.05, 20.00, 20.05}).deviation == Approx(1));
}

TEST_CASE("K307: bad input names itself", "[K307]") {
  GaugeDesign bad = example;
  bad.deviation_2_mm = 0.005;
  CHECK_THROWS_WITH(gauge_outer_span(bad), "K307.gauge_outer_span: F2 = 0.005, must not be below W2");
  CHECK_THROWS_WITH(reduced_deviation({1, 2, 2}), "K307.reduced_deviation: lower = 2, must be below upper");
}
