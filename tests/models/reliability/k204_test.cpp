// The checks of card K204; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <cstdint>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/reliability/k204_safety_clutch.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k204;

namespace {

double factor(Clutch clutch, double rpm) {
  return clutch_dynamic_factor({{clutch}, rpm}).k_d;
}

// Uniform numbers in (0, 1) for the sampling check (splitmix64).
class Uniform {
 public:
  double operator()() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    z ^= z >> 31;
    return (static_cast<double>(z >> 11) + 0.5) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

SpikeOutcome sampled(const SpikeInputs& in, int samples) {
  Uniform uniform;
  const TripBand band = clutch_trip_band({in.set_torque_nm, in.accuracy});
  SpikeOutcome sum{};
  for (int k = 0; k < samples; ++k) {
    const double demand = in.cutting_torque_nm * (1 - in.spike_mean_ratio * std::log(uniform()));
    const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
    const double threshold = band.t_mean_nm + band.sigma_nm * normal;
    const bool tripped = demand >= threshold;
    const double peak = tripped ? std::min(demand, in.dynamic_factor * threshold) : demand;
    const bool broken = peak > in.break_torque_nm;
    sum.p_trip += tripped;
    sum.p_trip_safe += tripped && !broken;
    sum.p_break += broken;
    sum.p_break_no_clutch += demand > in.break_torque_nm;
  }
  for (double* p : {&sum.p_trip, &sum.p_trip_safe, &sum.p_break, &sum.p_break_no_clutch}) *p /= samples;
  return sum;
}

}  // namespace

TEST_CASE("K204: the dynamic factor starts at 1 and grows nearly in proportion to the speed", "[K204]") {
  for (const Clutch c : {Clutch::cone, Clutch::ball_round, Clutch::ball_triangle, Clutch::ball_pentagon}) {
    CHECK(factor(c, 0) == 1);
    double before = 1;
    for (double n = 10; n <= 600; n += 10) {
      CHECK(factor(c, n) > before);
      before = factor(c, n);
    }
  }
  CHECK((factor(Clutch::cone, 230) - 1) / 230 == Approx(6.96e-4).margin(5e-7));
  CHECK((factor(Clutch::cone, 400) - 1) / 400 == Approx(6.75e-4).margin(5e-7));
  CHECK((factor(Clutch::ball_round, 230) - 1) / 230 == Approx(5.65e-4).margin(5e-7));
  CHECK((factor(Clutch::ball_round, 400) - 1) / 400 == Approx(6.25e-4).margin(5e-7));
  CHECK((factor(Clutch::ball_triangle, 170) - 1) / 170 == Approx(7.06e-4).margin(5e-7));
  CHECK(factor(Clutch::ball_round, 170) == Approx(1.096).margin(5e-4));
}

TEST_CASE("K204: closed forms agree with simulation", "[K204]") {
  const SpikeInputs cases[] = {{25, 0.4, 42, 1.15, 1.27, 50},
                               {25, 0.4, 42, 1.15, 1.27, 60},
                               {40, 0.2, 42, 1.17, 1.16, 50},
                               {40, 0.2, 42, 1.2, 1.2, 39}};
  for (const SpikeInputs& in : cases) {
    const SpikeOutcome closed = overload_spike_outcome(in);
    const SpikeOutcome drawn = sampled(in, 400'000);
    CHECK(closed.p_trip == Approx(drawn.p_trip).margin(3e-3));
    CHECK(closed.p_trip_safe == Approx(drawn.p_trip_safe).margin(3e-3));
    CHECK(closed.p_break == Approx(drawn.p_break).margin(3e-3));
    CHECK(closed.p_break_no_clutch == Approx(drawn.p_break_no_clutch).margin(3e-3));
  }
}

TEST_CASE("K204: a clutch set too high protects nothing", "[K204]") {
  const SpikeOutcome high = overload_spike_outcome({25, 0.4, 42, 1.15, 1.27, 50});
  CHECK(high.p_break == Approx(0.0818).margin(5e-5));
  CHECK(high.p_break_no_clutch == Approx(0.0821).margin(5e-5));
}

TEST_CASE("K204: trips fall and breaks rise with the setting, probabilities stay probabilities", "[K204]") {
  verstat::test::property([] {
    SpikeInputs in{*rc::gen::inRange(5, 60) * 1.0,      0.05 * *rc::gen::inRange(1, 41),
                   *rc::gen::inRange(5, 90) * 1.0,      1 + 0.01 * *rc::gen::inRange(1, 51),
                   1 + 0.01 * *rc::gen::inRange(0, 40), *rc::gen::inRange(5, 120) * 1.0};
    const SpikeOutcome low = overload_spike_outcome(in);
    in.set_torque_nm *= 1.02;
    const SpikeOutcome high = overload_spike_outcome(in);
    RC_ASSERT(high.p_trip <= low.p_trip + 1e-12);
    RC_ASSERT(high.p_break >= low.p_break - 1e-12);
    for (const SpikeOutcome& p : {low, high}) {
      RC_ASSERT(p.p_trip >= 0 && p.p_trip <= 1);
      RC_ASSERT(p.p_trip_safe >= 0);
      RC_ASSERT(p.p_trip_safe + p.p_break <= 1 + 1e-12);
      RC_ASSERT(p.p_break <= p.p_break_no_clutch);
    }
  });
}

TEST_CASE("K204: the window opens exactly at the required overload ratio, and the speed with it", "[K204]") {
  verstat::test::property([] {
    const double k_t = 1 + 0.01 * *rc::gen::inRange(0, 30);
    const double k_d = 1 + 0.01 * *rc::gen::inRange(0, 30);
    const double drift = 1 - 0.01 * *rc::gen::inRange(0, 20);
    const double ratio = clutch_setting_window({30, 30, k_t, k_d, drift}).required_overload_ratio;
    RC_ASSERT(clutch_setting_window({30, 30 * ratio * 1.0001, k_t, k_d, drift}).feasible == 1);
    RC_ASSERT(clutch_setting_window({30, 30 * ratio * 0.9999, k_t, k_d, drift}).feasible == 0);
    for (const Clutch c : {Clutch::cone, Clutch::ball_round, Clutch::ball_triangle}) {
      const double speed = clutch_max_speed({{c}, 30, 30 * ratio, k_t, drift}).speed_rpm;
      if (speed > 0 && speed < 600) RC_ASSERT(std::abs(factor(c, speed) - k_d) < 1e-9);
    }
  });
  CHECK(clutch_setting_window({1, 1, 1.17, 1.27, 0.96}).required_overload_ratio ==
        Approx(1.55).margin(0.005));
}

TEST_CASE("K204: the setting drifts down with the trips", "[K204]") {
  double before = 42.1;
  for (double n = 0; n < 500; n += 25) {
    const double now = clutch_set_torque_drift({42, 0.96, n, 100}).set_torque_nm;
    CHECK(now < before);
    before = now;
  }
  CHECK(clutch_set_torque_drift({42, 0.96, 100}).set_torque_nm == Approx(42 * 0.96));
}

TEST_CASE("K204: no setting is cheaper than the optimal one", "[K204]") {
  const auto cost = [](const OptimumInputs& in, double set) {
    const SpikeOutcome p = overload_spike_outcome(
        {in.cutting_torque_nm, in.spike_mean_ratio, set, in.accuracy, in.dynamic_factor, in.break_torque_nm});
    return p.p_trip_safe * in.trip_cost + p.p_break * in.break_cost;
  };
  verstat::test::property([&] {
    const OptimumInputs in{25,
                           0.05 * *rc::gen::inRange(2, 20),
                           1.15,
                           1.27,
                           40.0 + *rc::gen::inRange(0, 40),
                           *rc::gen::inRange(0, 10) * 1.0,
                           *rc::gen::inRange(0, 200) * 1.0};
    const OptimalSetting best = optimal_clutch_setting(in);
    RC_ASSERT(std::abs(cost(in, best.set_torque_nm) - best.cost_per_spike) < 1e-12);
    const double low = 25 * 2.15 / 2;
    for (int k = 0; k <= 2000; ++k)
      RC_ASSERT(cost(in, low + (in.break_torque_nm - low) * k / 2000) >= best.cost_per_spike - 1e-7);
  });
  // The interior optimum grows with the break torque and falls with the cost of a break.
  CHECK(optimal_clutch_setting({25, 0.4, 1.15, 1.27, 65, 4, 90}).set_torque_nm >
        optimal_clutch_setting({25, 0.4, 1.15, 1.27, 60, 4, 90}).set_torque_nm);
  CHECK(optimal_clutch_setting({25, 0.4, 1.15, 1.27, 60, 4, 150}).set_torque_nm <
        optimal_clutch_setting({25, 0.4, 1.15, 1.27, 60, 4, 90}).set_torque_nm);
}

TEST_CASE("K204: polygon clutches re-engage up to 170 rpm", "[K204]") {
  const auto stop = [](Clutch c, double rpm) {
    return clutch_stop_event({{{c}, rpm}, 0.05, 0.5, 4, 0.3, 1.5});
  };
  CHECK(stop(Clutch::ball_triangle, 170).auto_reengage == 1);
  CHECK(stop(Clutch::ball_triangle, 170.01).auto_reengage == 0);
  CHECK(stop(Clutch::ball_triangle, 170.01).downtime_min == Approx(4.8));
  CHECK(stop(Clutch::cone, 600).auto_reengage == 1);
}

TEST_CASE("K204: static trip torque locks where tan has its pole", "[K204]") {
  CHECK(clutch_static_trip_torque({500, 50, 50, 0}).torque_nm.value() ==
        Approx(25 * std::tan(50 * std::numbers::pi / 180)));
  const StaticTrip locked = clutch_static_trip_torque({500, 50, 85, 0.1});
  CHECK(locked.self_locking == 1);
  CHECK_FALSE(locked.torque_nm);
}

TEST_CASE("K204: bad input names itself", "[K204]") {
  CHECK_THROWS_WITH(factor(Clutch::cone, 601),
                    "K204.clutch_dynamic_factor: speed_rpm = 601, allowed 0 <= speed_rpm <= 600 (speed)");
  CHECK_THROWS_WITH(optimal_clutch_setting({25, 0.4, 1.2, 1.27, 27, 4, 90}),
                    "K204.optimal_clutch_setting: break_torque_nm = 27, must be above cutting_torque_nm (1 + "
                    "k_accuracy) / 2");
}
