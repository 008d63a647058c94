// The checks of card K308; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k308_hole_pair_tooling.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k308;

TEST_CASE("K308: the wear ratio of the example and its small-feed limit", "[K308]") {
  CHECK(bushing_wear_ratio({1.2, 0.3, 5, 0.2, 0.8}).ratio == Approx(0.00924).margin(5e-6));
  CHECK(bushing_wear_ratio({1.4, 0.3, 5, 0.2, 0.8}).ratio == Approx(0.01078).margin(5e-6));
  CHECK(bushing_wear_ratio({1.2, 0.3, 5, 0.2, 0.8}).life_gain == Approx(108).margin(0.5));
  CHECK(bushing_wear_ratio({1.4, 0.3, 5, 0.2, 0.8}).life_gain == Approx(93).margin(0.5));
  // Equal feeds far below the radius: k1 S / (2 pi r), whatever k2.
  CHECK(bushing_wear_ratio({1.3, 0.7, 50, 0.01, 0.01}).ratio ==
        Approx(1.3 * 0.01 / (2 * std::numbers::pi * 50)).epsilon(1e-8));
}

TEST_CASE("K308: a turning bushing wears less at every practical feed", "[K308]") {
  verstat::test::property([] {
    const double k1 = *rc::gen::inRange(120, 141) * 1e-2;
    const double k2 = *rc::gen::inRange(0, 101) * 1e-2;
    const double r = *rc::gen::inRange(5, 300) * 0.1;
    const double s1 = r * *rc::gen::inRange(1, 100) * 1e-2;
    const double s2 = r * *rc::gen::inRange(1, 100) * 1e-2;
    RC_ASSERT(bushing_wear_ratio({k1, k2, r, s1, s2}).ratio < 1);
    // Complete entrainment is eq. (1) with k1 = 1; a fixed bushing is 1.
    RC_ASSERT(bushing_wear_ratio_slip({0, k2, r, s1, s2}).ratio ==
              Approx(bushing_wear_ratio({1, k2, r, s1, s2}).ratio).epsilon(1e-13));
    RC_ASSERT(bushing_wear_ratio_slip({1, k2, r, s1, s2}).ratio == 1);
  });
}

TEST_CASE("K308: the printed slip factors mean half a percent of slip", "[K308]") {
  CHECK(bushing_wear_ratio_slip({0.0048, 0.3, 5, 0.2, 0.8}).ratio ==
        Approx(bushing_wear_ratio({1.2, 0.3, 5, 0.2, 0.8}).ratio).epsilon(0.005));
  CHECK(bushing_wear_ratio_slip({0.0072, 0.3, 5, 0.2, 0.8}).ratio ==
        Approx(bushing_wear_ratio({1.4, 0.3, 5, 0.2, 0.8}).ratio).epsilon(0.005));
  CHECK(bushing_wear_ratio_slip({0.02, 0.3, 5, 0.2, 0.8}).ratio == Approx(0.0218).margin(5e-5));
  CHECK(bushing_wear_ratio_slip({0.02, 0.3, 5, 0.2, 0.8}).life_gain == Approx(46).margin(0.5));
}

TEST_CASE("K308: the wear ratio is the ratio of the sliding paths", "[K308]") {
  const double moving =
      sliding_path({4, 0.1, 1, 0.03}).path_mm + 0.4 * sliding_path({4, 0.5, 1, 0.03}).path_mm;
  const double fixed = sliding_path({4, 0.1, 1, 1}).path_mm + 0.4 * sliding_path({4, 0.5, 1, 1}).path_mm;
  CHECK(bushing_wear_ratio_slip({0.03, 0.4, 4, 0.1, 0.5}).ratio == Approx(moving / fixed));
  CHECK(bushing_life({10000, 0.02}).holes == Approx(500000));
}

TEST_CASE("K308: error sums follow the 3-4-5 rule and never fall below a component", "[K308]") {
  CHECK(setup_error({0.03, 0, 0.04}).error_mm == Approx(0.05));
  CHECK(setup_error({0, 0.07, 0}).error_mm == 0.07);
  CHECK(gauge_error({0, 0.3, 0, 0.4, 0}).error_mm == Approx(0.5));
  CHECK(gauge_error({0, 0, 0, 0, 0.011}).error_mm == 0.011);
  CHECK(gauge_error({1, 1, 1, 1, 1}).error_mm == Approx(std::sqrt(5.0)));
  verstat::test::property([] {
    const double one = *rc::gen::inRange(0, 1000) * 1e-3;
    const double two = *rc::gen::inRange(0, 1000) * 1e-3;
    RC_ASSERT(setup_error({one, two, 0.1}).error_mm >= std::max({one, two, 0.1}));
    RC_ASSERT(gauge_error({one, two, 0.1, 0, two}).error_mm >= std::max({one, two, 0.1}));
  });
}

TEST_CASE("K308: angle and centre distance of the head are inverse", "[K308]") {
  CHECK(head_center_distance({40, 24, 180}).distance_mm == 64);
  CHECK(head_angle({40, 24, 40}).angle_deg == Approx(77.4).margin(0.05));
  verstat::test::property([] {
    const double phi = *rc::gen::inRange(1, 1790) * 0.1;
    const double a = head_center_distance({40, 24, phi}).distance_mm;
    RC_ASSERT(head_angle({40, 24, a}).angle_deg == Approx(phi).epsilon(1e-9));
  });
  CHECK(head_angle({40, 24, 24}).ok);
  CHECK(head_angle({40, 24, 64}).ok);
  CHECK_FALSE(head_angle({40, 24, 23.999}).ok);
  CHECK_FALSE(head_angle({40, 24, 64.001}).ok);
  CHECK(head_angle({40, 24, 65}).angle_deg == 180);
}

TEST_CASE("K308: strokes are whole and indexing falls between them", "[K308]") {
  verstat::test::property([] {
    const std::int64_t holes = *rc::gen::inRange(1, 50);
    const std::int64_t drills = *rc::gen::inRange(1, 9);
    const auto job = multi_spindle_drilling({12, 3, 2, 0.15, 600, 40, 24, holes, drills, 0.1});
    RC_ASSERT(job.strokes * drills >= holes);
    RC_ASSERT((job.strokes - 1) * drills < holes);
    RC_ASSERT(job.time_min == Approx(static_cast<double>(job.strokes) * 17 / 150 +
                                     0.1 * static_cast<double>(job.strokes - 1)));
  });
  const auto most = std::numeric_limits<std::int64_t>::max();
  CHECK(multi_spindle_drilling({12, 3, 2, 0.15, 600, 40, 24, most, most - 1, 0.1}).strokes == 2);
}

TEST_CASE("K308: acceptance is one half at a limit when the other is far, and symmetric", "[K308]") {
  CHECK(inspection_accept_probability({10, 10, 1000, 0.1, 3}).probability == Approx(0.5).epsilon(1e-12));
  CHECK(inspection_accept_probability({10, -1000, 10, 0.1, 3}).probability == Approx(0.5).epsilon(1e-12));
  CHECK(inspection_accept_probability({10, 10, 11, 0, 3}).probability == 1);
  CHECK(inspection_accept_probability({11, 10, 11, 0, 3}).probability == 1);
  CHECK(inspection_accept_probability({11.001, 10, 11, 0, 3}).probability == 0);
  // One sigma inside each limit: erf(1/sqrt 2).
  CHECK(inspection_accept_probability({0, -1, 1, 2, 2}).probability == Approx(std::erf(1 / std::sqrt(2.0))));
  // Far outside the probability is small, not zero.
  CHECK(inspection_accept_probability({2, -1, 1, 0.3, 3}).probability == Approx(7.62e-24).epsilon(1e-3));
}

TEST_CASE("K308: bad input names itself", "[K308]") {
  CHECK_THROWS_WITH(inspection_accept_probability({0, 1, 1, 0.1, 3}),
                    "K308.inspection_accept_probability: lower = 1, must be below upper");
  CHECK_THROWS_WITH(
      sliding_path({5, 0.2, 20, 1.5}),
      "K308.sliding_path: slip = 1.5, allowed 0 <= slip <= 1 (share of circumferential sliding, 1 "
      "for a fixed bushing)");
}
