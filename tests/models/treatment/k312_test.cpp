// The checks of card K312; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k312_blade_finishing.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k312;
using verstat::test::property;

namespace {
constexpr Finish all[] = {Finish::polishing, Finish::soft, Finish::medium, Finish::hard,
                          Finish::vibropolishing};
constexpr Finish tested[] = {Finish::polishing, Finish::soft, Finish::medium, Finish::hard};
}  // namespace

TEST_CASE("K312: work hardening follows from microhardness", "[K312]") {
  for (const Finish finish : all) {
    const FinishState state = finish_state({finish});
    CHECK(hardening_degree({state.microhardness_mpa}).degree_pct == Approx(state.hardening_pct).margin(0.05));
    CHECK(state.sigma_1_mpa.has_value() == (finish != Finish::vibropolishing));
    CHECK(state.sigma_1_sd_mpa.has_value() == state.sigma_1_mpa.has_value());
  }
}

TEST_CASE("K312: endurance limits are midpoints of the levels of the test", "[K312]") {
  const auto steps = [](Finish finish) { return *finish_state({finish}).sigma_1_mpa / 30.9; };
  CHECK(steps(Finish::polishing) == Approx(17.5).margin(0.01));
  CHECK(steps(Finish::medium) == Approx(18.5).margin(0.01));
  CHECK(steps(Finish::hard) == Approx(16.31).margin(0.005));
  CHECK(endurance_limit_midpoint({17 * 30.9, 18 * 30.9}).sigma_1_mpa == Approx(540.75));
  CHECK(stress_from_swing({1}).sigma_mpa == Approx(154.5));
  CHECK(571.5 / 540.5 - 1 == Approx(0.057).margin(0.0005));
}

TEST_CASE("K312: a test of 2e7 cycles takes 303 to 333 minutes", "[K312]") {
  EnduranceTest test;
  test.frequency_hz = 1100;
  CHECK(endurance_test_time(test).time_min == Approx(303).margin(0.5));
  test.frequency_hz = 1000;
  CHECK(endurance_test_time(test).time_min == Approx(333).margin(0.5));
}

TEST_CASE("K312: less scatter is safer than it looks by the mean", "[K312]") {
  const double failure[] = {0.071, 0.0040, 6.3e-5, 0.133};
  const double guaranteed[] = {456.8, 514.9, 541.3, 485.4};
  for (int k = 0; k < 4; ++k) {
    const FinishState state = finish_state({tested[k]});
    CHECK(fatigue_failure_probability({480, 20, *state.sigma_1_mpa, *state.sigma_1_sd_mpa}).p ==
          Approx(failure[k]).epsilon(0.01));
    CHECK(guaranteed_endurance({*state.sigma_1_mpa, *state.sigma_1_sd_mpa, 0.99}).sigma_mpa ==
          Approx(guaranteed[k]).margin(0.05));
  }
}

TEST_CASE("K312: the guaranteed limit has the failure probability it guarantees", "[K312]") {
  property([] {
    const double mean = *rc::gen::inRange(300, 700);
    const double sd = *rc::gen::inRange(1, 50);
    const double reliability = *rc::gen::inRange(500, 1000) * 1e-3;
    const double limit = guaranteed_endurance({mean, sd, reliability}).sigma_mpa;
    RC_ASSERT(std::abs(fatigue_failure_probability({limit, 0, mean, sd}).p - (1 - reliability)) < 1e-12);
  });
}

TEST_CASE("K312: doubling the time at medium intensity costs 67.5 MPa", "[K312]") {
  CHECK(endurance_after_dose({62.5, 5}).sigma_1_mpa - endurance_after_dose({62.5, 10}).sigma_1_mpa ==
        Approx(67.5));
  CHECK(endurance_after_dose({62.5, 20}).sigma_1_mpa == 504);
  // The tested doses are those of the regimes.
  for (const auto& [choice, finish] : {std::pair{HardenedFinish::soft, Finish::soft},
                                       {HardenedFinish::medium, Finish::medium},
                                       {HardenedFinish::hard, Finish::hard}}) {
    const HardeningRegime regime = hardening_regime({choice});
    const EnduranceAfterDose after =
        endurance_after_dose({(regime.intensity_min + regime.intensity_max) / 2, regime.time_min});
    CHECK(after.sigma_1_mpa == Approx(*finish_state({finish}).sigma_1_mpa));
    CHECK(after.sigma_1_sd_mpa == Approx(*finish_state({finish}).sigma_1_sd_mpa));
  }
}

TEST_CASE("K312: residual stress between and beyond its printed points", "[K312]") {
  CHECK(residual_stress({ProfiledFinish::vibropolishing, 15}).sigma_mpa == Approx((-388 - 10.5) / 2));
  CHECK(residual_stress({ProfiledFinish::medium, 10}).sigma_mpa == Approx(-251));
  CHECK_THROWS_WITH(residual_stress({ProfiledFinish::medium, 20.5}),
                    "K312.residual_stress: depth = 20.5, must be at most 20 um for P+UH2");
  CHECK_THROWS_WITH(residual_stress({ProfiledFinish::hard, 71}),
                    "K312.residual_stress: depth = 71, must be at most 70 um for P+UH3");
}

TEST_CASE("K312: the staircase does not depend on where its grid lies or how fine it is", "[K312]") {
  property([] {
    StaircaseTest test{{}, {}, 10};
    const auto n = *rc::gen::inRange(3, 30);
    for (int k = 0; k < n; ++k) {
      test.levels_mpa.push_back(10.0 * *rc::gen::inRange(0, 6));
      test.failed.push_back(*rc::gen::arbitrary<bool>());
    }
    test.failed[0] = true;
    test.failed[1] = false;
    const StaircaseEstimate base = staircase(test);
    StaircaseTest moved = test;
    for (double& level : moved.levels_mpa) level = 3 * level + 100;
    moved.step_mpa = 30;
    const StaircaseEstimate other = staircase(moved);
    RC_ASSERT(std::abs(other.mean_mpa - (3 * base.mean_mpa + 100)) < 1e-9);
    RC_ASSERT(std::abs(other.sd_mpa - 3 * base.sd_mpa) < 1e-9);
    RC_ASSERT(base.sd_mpa >= 0.53 * 10 - 1e-12);
  });
  // Equal numbers of both outcomes: the failures count.
  CHECK(staircase({{500, 530}, {false, true}, 30}).mean_mpa == Approx(515));
}

TEST_CASE("K312: bad input names itself", "[K312]") {
  CHECK_THROWS_WITH(staircase({{500, 530}, {true, true}, 30}),
                    "K312.staircase: failed must hold both failures and survivors");
  CHECK_THROWS_WITH(staircase({{500, 531}, {false, true}, 30}),
                    "K312.staircase: levels = 531, must lie a whole number of steps above the lowest level");
  CHECK_THROWS_WITH(
      fatigue_failure_probability({480, 0, 540, 0}),
      "K312.fatigue_failure_probability: sigma_1_sd = 0, must not be zero when sigma_a_sd is zero");
}
