// The long run of small shops against what can be written down by hand: renewal reward, flows through routes,
// shares of the clock on the wall.
#include <cmath>

#include <catch2/catch.hpp>

#include "models/math/life_law.h"
#include "optimize/renewal_reward.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;

namespace {

// One mill at 2 UAH/min that takes 20 min for a plate worth 100 UAH; blanks always at hand.
json mill() {
  return json::parse(R"({"name": "mill", "simulation": {"horizon_min": 10000, "replications": 2, "seed": "1"},
    "stores": [{"name": "done"}], "machines": [{"name": "mill", "rate_per_min": 2}],
    "crews": [{"name": "fitter", "rate_per_min": 0.9, "walking_min": 5}],
    "spares": [{"name": "belt", "price": 55, "lead_time": {"kind": "constant", "value_min": 0}}],
    "operations": [{"name": "milling", "machine": "mill",
      "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}}],
    "parts": [{"name": "plate", "route": ["milling"], "value": 100, "store": "done"}]})");
}

struct Shop {
  scenarios::Scenario scenario;
  LongRunModel model;
  LongRun run;
  explicit Shop(const json& text) : scenario(scenarios::load(text)), model(scenario), run(model.evaluate()) {}
  [[nodiscard]] double value(const std::string& kpi) const {
    return model.value(run, model.kpi(kpi).value());
  }
};

}  // namespace

TEST_CASE("by hand: handling by operators who tend two machines each") {
  json s = mill();
  s["crews"][0] = {
      {"name", "operator"}, {"rate_per_min", 0.4}, {"walking_min", 0.25}, {"machines_per_member", 2}};
  s["machines"][0]["loading"] = {{"kind", "constant"}, {"value_min", 1.5}};
  s["machines"][0]["unloading"] = {{"kind", "exponential"}, {"rate_per_min", 0.5}};
  s["machines"][0]["count"] = 3;
  // Nobody is needed: nobody walks either.
  const Shop alone(s);
  CHECK(alone.run.throughput_per_h == Approx(3 * 60 / 23.5));
  CHECK(alone.run.cost_per_part == Approx(2 * 23.5));
  CHECK(alone.run.operations[0].crew_per_part_min == 0);
  s["machines"][0]["attendance"] = {{"crew", "operator"}};
  const Shop tended(s);
  CHECK(tended.run.throughput_per_h == Approx(3 * 60 / 24.0));
  CHECK(tended.run.operations[0].crew_per_part_min == Approx(4.0 / 2));
  CHECK(tended.run.cost_per_part == Approx(2 * 24 + 0.4 * 2));
  // Paid by the shift: 0.4 a minute, which makes 3/24 of a part.
  s["crews"][0]["pay"] = "shift";
  CHECK(Shop(s).run.cost_per_part == Approx(2 * 24 + 0.4 * 24 / 3));
  // An attended machine without handling needs nobody.
  s["machines"][0].erase("loading");
  s["machines"][0].erase("unloading");
  CHECK(Shop(s).run.operations[0].crew_per_part_min == 0);
}

TEST_CASE("by hand: stops that come with work on parts") {
  const auto with = [](const char* failures) {
    json s = mill();
    s["machines"][0]["failures"] = json::parse(failures);
    return Shop(s);
  };
  // One failure per mean life, whatever the law; crew, spare, damage, and half of them spoil the part.
  for (const char* life :
       {R"({"kind": "constant", "value_min": 500})", R"({"kind": "exponential", "rate_per_min": 0.002})",
        R"({"kind": "uniform", "low_min": 0, "high_min": 1000})",
        R"({"kind": "triangular", "low_min": 100, "mode_min": 300, "high_min": 1100})",
        R"({"kind": "lognormal", "mean_min": 500, "cv": 2})",
        R"({"kind": "gamma", "mean_min": 500, "cv": 0.2})",
        R"({"kind": "weibull", "mean_min": 500, "cv": 1.5})",
        R"({"kind": "empirical", "values_min": [100, 200, 900], "weights": [2, 1, 3], "between": "step"})"}) {
    INFO(life);
    json s = mill();
    s["machines"][0]["failures"] =
        json::parse(R"([{"name": "a", "repair": {"kind": "constant", "value_min": 50},
      "crew": "fitter", "spare": "belt", "damage": 12, "scrap_probability": 0.5}])");
    s["machines"][0]["failures"][0]["time_to_failure"] = json::parse(life);
    const double mean = operations::mean_min(scenarios::load(s).machines[0].failures[0].time_to_failure);
    const double stops = 20 / mean;
    const Shop shop(s);
    CHECK(mean == Approx(500).epsilon(0.11));
    CHECK(shop.run.throughput_per_h == Approx(60 / (20 + stops * 55) * std::exp(-0.5 * stops)));
    CHECK(shop.run.quality_ratio == Approx(std::exp(-0.5 * stops)));
    CHECK(shop.run.operations[0].crew_per_part_min == Approx(stops * 55));
    CHECK(shop.run.cost_per_part ==
          Approx(2 * 20 + stops * ((2 + 0.9) * 55 + 12 + 55) + 100 * (1 - std::exp(-0.5 * stops))));
    CHECK(shop.run.cost_per_good_part == Approx(shop.run.cost_per_part / std::exp(-0.5 * stops)));
  }
  // By parts: one stop in 60 of them (a life of 59.5 ends with the 60th), between parts, so none is spoilt.
  for (const char* parts : {"60", "59.5"}) {
    const Shop by_parts = with(
        (R"([{"name": "a", "clock": "parts", "scrap_probability": 0.5, "repair": {"kind": "constant", "value_min": 30},
               "time_to_failure": {"kind": "constant", "value_min": )" +
         std::string(parts) + "}}]")
            .c_str());
    CHECK(by_parts.run.throughput_per_h == Approx(60 / 20.5));
    CHECK(by_parts.run.quality_ratio == 1);
  }
  // After the part: half a part later on the average, and none is spoilt.
  const Shop later = with(R"([{"name": "a", "effect": "after_part", "scrap_probability": 0.5,
    "repair": {"kind": "constant", "value_min": 51}, "time_to_failure": {"kind": "constant", "value_min": 500}}])");
  CHECK(later.run.throughput_per_h == Approx(60 / (20 + 20.0 / 510 * 51)));
  CHECK(later.run.quality_ratio == 1);
  // A clock of the cut stands still where nothing cuts.
  const Shop never =
      with(R"([{"name": "a", "clock": "cutting", "repair": {"kind": "constant", "value_min": 51},
    "time_to_failure": {"kind": "constant", "value_min": 500}}])");
  CHECK(never.run.throughput_per_h == Approx(3));
  // Maintenance, by the minute and by the part.
  json s = mill();
  s["machines"][0]["maintenance"] = json::parse(R"([
    {"name": "a", "clock": "operating", "interval": 500, "duration": {"kind": "constant", "value_min": 40}, "crew": "fitter", "spare": "belt"},
    {"name": "b", "clock": "parts", "interval": 100, "duration": {"kind": "constant", "value_min": 60}}])");
  const Shop kept(s);
  CHECK(kept.run.throughput_per_h == Approx(60 / (20 + 20.0 / 510 * 45 + 0.6)));
  CHECK(kept.run.cost_per_part == Approx(2 * 20 + 20.0 / 510 * (2.9 * 45 + 55) + 2 * 0.6));
}

TEST_CASE("by hand: stops by the clock on the wall take their share of the time") {
  json s = mill();
  s["machines"][0]["count"] = 2;
  s["machines"][0]["failures"] =
      json::parse(R"([{"name": "a", "clock": "calendar", "damage": 70, "spare": "belt", "crew": "fitter",
    "time_to_failure": {"kind": "exponential", "rate_per_min": 0.0005}, "repair": {"kind": "constant", "value_min": 95},
    "scrap_probability": 0.4}])");
  s["machines"][0]["maintenance"] = json::parse(R"([{"name": "b", "clock": "calendar", "interval": 960,
    "duration": {"kind": "constant", "value_min": 40}}])");
  const Shop shop(s);
  const double share = 100.0 / 2100 + 40.0 / 1000;
  const double survival = std::exp(-0.4 * 20 / 2000);
  const double parts_per_min = 2 * (1 - share) / 20;
  CHECK(shop.run.throughput_per_h == Approx(60 * parts_per_min * survival));
  CHECK(shop.value("load/mill") == Approx(1));
  const double per_min = 2 * (2 + (0.9 * 100 + 70 + 55) / 2100);  // of two mills
  CHECK(shop.run.cost_per_part == Approx(per_min / parts_per_min + 100 * (1 - survival)));
}

TEST_CASE("by hand: change-overs between families of batches") {
  json s = mill();
  s["crews"][0]["walking_min"] = 3;
  s["operations"] = json::parse(R"([
    {"name": "long", "machine": "mill", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 10}}},
    {"name": "short", "machine": "mill", "family": "b", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 12}}},
    {"name": "short too", "machine": "mill", "family": "b", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 1}}}])");
  s["parts"] = json::parse(R"([
    {"name": "A", "route": ["long"], "batch_size": 5, "store": "done", "supply": {"kind": "interarrival", "time": {"kind": "exponential", "rate_per_min": 0.004}}},
    {"name": "B", "route": ["short"], "batch_size": 8, "store": "done", "supply": {"kind": "weekly_profile", "rates": [{"from_h": 0, "to_h": 84, "per_h": 0.36}]}}])");
  s["machines"][0]["setup"] =
      json::parse(R"({"time": {"kind": "constant", "value_min": 40}, "cost": 25, "crew": "fitter"})");
  const double a = 0.004;
  const double b = 0.003;
  const double both = a * b / (a + b);  // change-overs per minute, each way
  const double parts = 5 * a + 8 * b;
  const auto expect = [&](double to_long_min, double to_short_min) {
    const Shop shop(s);
    const double minutes = to_long_min + to_short_min + 2 * 3;
    CHECK(shop.value("load/mill") == Approx(5 * a * 10 + 8 * b * 12 + both * minutes));
    CHECK(shop.run.throughput_per_h == Approx(60 * parts));
    CHECK(shop.run.cost_per_part == Approx((2 + both * (2 * 25 + 0.9 * minutes)) / parts));
  };
  expect(40, 40);
  // The first rule that fits: between two families by name, from any, to any.
  s["machines"][0]["setup"]["times"] =
      json::parse(R"([{"from": "b", "to": "long", "time": {"kind": "exponential", "rate_per_min": 0.01}},
    {"from": "*", "to": "long", "time": {"kind": "constant", "value_min": 7}}])");
  expect(100, 40);
  s["machines"][0]["setup"]["times"].erase(0);
  expect(7, 40);
  s["machines"][0]["setup"]["times"].push_back(
      json::parse(R"({"from": "*", "to": "*", "time": {"kind": "constant", "value_min": 9}})"));
  expect(7, 9);
  // One family needs none.
  s["operations"][0]["family"] = "b";
  CHECK(Shop(s).value("load/mill") == Approx(5 * a * 10 + 8 * b * 12));
}

TEST_CASE("by hand: shifts, and what happens at their ends") {
  json s = mill();
  s["calendars"] = json::parse(
      R"([{"name": "day", "shifts": [{"days": ["monday", "tuesday", "wednesday", "thursday", "friday"], "from_h": 6, "to_h": 22}]},
    {"name": "always", "shifts": [{"days": ["monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"], "from_h": 0, "to_h": 24}]}])");
  s["machines"][0]["calendar"] = "day";
  s["machines"][0]["part_at_shift_end"] = "pause";
  const double open = 80.0 / 168;
  CHECK(Shop(s).run.throughput_per_h == Approx(3 * open));
  CHECK(Shop(s).run.cost_per_part == Approx(40));
  // Crews paid by the shift, within their calendar only.
  s["crews"][0] = {
      {"name", "fitter"}, {"rate_per_min", 0.5}, {"pay", "shift"}, {"members", 3}, {"calendar", "day"}};
  CHECK(Shop(s).run.cost_per_part == Approx(40 + 3 * 0.5 * 20));
  s["crews"][0].erase("calendar");
  CHECK(Shop(s).run.cost_per_part == Approx(40 + 3 * 0.5 * 20 / open));
  s["crews"] = json::array();
  // Finished: five times a week half a part more.
  s["machines"][0]["part_at_shift_end"] = "finish";
  CHECK(Shop(s).run.throughput_per_h == Approx(3 * (open + 5.0 / 10080 * 10)));
  s["machines"][0]["calendar"] = "always";
  CHECK(Shop(s).run.throughput_per_h == Approx(3));
}

TEST_CASE(
    "by hand: after the shift a part goes on until its edge must be changed by somebody who has gone home") {
  json s = test::gallery("heavy-lathe.json");
  s["calendars"] = json::parse(
      R"([{"name": "day", "shifts": [{"days": ["monday", "tuesday"], "from_h": 6, "to_h": 14}]}])");
  s["machines"][0]["calendar"] = "day";
  const auto expect = [&](double overrun_min) {
    const Shop shop(s);
    const double on_shift = 16.0 / 168 + 2.0 / 10080 * overrun_min;
    const OperationCost& o = shop.run.operations[0];
    CHECK(shop.run.throughput_per_h == Approx(2 * 60 * on_shift / o.time_per_part_min * o.survival));
  };
  const OperationCost lathe = Shop(s).run.operations[0];
  REQUIRE(lathe.changes_per_part > 0.1);
  expect(lathe.time_per_part_min / 2);  // the setter is always there
  s["crews"][0]["calendar"] = "day";
  // The part is met at a random place, the change comes at random: the mean of the shorter one, by the
  // midpoint rule.
  double mean = 0;
  constexpr int steps = 100'000;
  for (int k = 0; k < steps; ++k) {
    const double u = (k + 0.5) / steps;
    mean += (1 - u) * std::exp(-lathe.changes_per_part * u) * lathe.time_per_part_min / steps;
  }
  expect(mean);
}

TEST_CASE("by hand: more work than the mill can do, and none left for blanks at hand") {
  json s = mill();
  s["simulation"]["allow_overload"] = true;
  s["operations"].push_back(json::parse(
      R"({"name": "slotting", "machine": "mill", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 5}}})"));
  s["parts"] = json::parse(R"([
    {"name": "A", "route": ["milling"], "store": "done", "supply": {"kind": "interarrival", "time": {"kind": "constant", "value_min": 12.5}}},
    {"name": "B", "route": ["slotting"], "store": "done", "supply": {"kind": "interarrival", "time": {"kind": "constant", "value_min": 12.5}}}])");
  // Twice what it can do: each customer gets half of what he sends.
  const Shop crowded(s);
  CHECK(crowded.value("load/mill") == Approx(2));
  CHECK(crowded.run.throughput_per_h == Approx(60.0 / 12.5));
  CHECK(crowded.run.cost_per_part == Approx(2 * 12.5));
  CHECK(crowded.run.operation_rate_per_min[0] == Approx(0.04));
  // Blanks at hand fill what the others leave: a quarter here, nothing there.
  s["parts"][0]["supply"]["time"]["value_min"] = 80.0 / 3;
  s["parts"][1]["supply"] = {{"kind", "always_available"}};
  const Shop filled(s);
  CHECK(filled.run.operation_rate_per_min[0] == Approx(3.0 / 80));
  CHECK(filled.run.operation_rate_per_min[1] == Approx(0.25 / 5));
  CHECK(filled.value("load/mill") == Approx(1));
  s["parts"][0]["supply"]["time"]["value_min"] = 10;
  const Shop nothing_left(s);
  CHECK(nothing_left.run.operation_rate_per_min[1] == 0);
  CHECK(nothing_left.run.throughput_per_h == Approx(3));
  CHECK(nothing_left.value("load/mill") == Approx(2));
  // Two kinds of blanks at hand come in equal numbers of batches.
  s["parts"][0]["supply"] = {{"kind", "always_available"}};
  s["parts"][0]["batch_size"] = 3;
  const Shop equal(s);
  CHECK(equal.run.operation_rate_per_min[0] == Approx(3.0 / 65));
  CHECK(equal.run.operation_rate_per_min[1] == Approx(1.0 / 65));
}

TEST_CASE("by hand: parts that go round, leave on the way, or are all spoilt") {
  json s = mill();
  s["operations"][0]["quality"] = {{"scrap_probability", 0.1}};
  s["operations"].push_back(json::parse(
      R"({"name": "check", "machine": "table", "cost": 3, "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 5}}})"));
  s["machines"].push_back({{"name", "table"}, {"rate_per_min", 0.5}});
  s["parts"][0].erase("route");
  // A fifth of the good ones goes back to the mill, a quarter of them leaves at once.
  s["parts"][0]["steps"] = json::parse(R"([
    {"name": "m", "operation": "milling", "next": [{"to": "c", "probability": 0.75}, {"probability": 0.25}]},
    {"name": "c", "operation": "check", "next": [{"to": "m", "probability": 0.2}, {"probability": 0.8}]}])");
  const Shop shop(s);
  // Visits of the mill per blank: n = 1 + 0.9 0.75 0.2 n; the mill is always busy.
  const double visits = 1 / (1 - 0.9 * 0.75 * 0.2);
  const double blanks_per_min = 1 / (20 * visits);
  const double good = visits * 0.9 * (0.25 + 0.75 * 0.8);
  CHECK(good + 0.1 * visits == Approx(1));  // every blank ends somewhere
  CHECK(shop.run.throughput_per_h == Approx(60 * blanks_per_min * good));
  CHECK(shop.run.quality_ratio == Approx(good));
  CHECK(shop.value("load/table") == Approx(blanks_per_min * visits * 0.9 * 0.75 * 5));
  const double checks = visits * 0.9 * 0.75;
  CHECK(shop.run.cost_per_part ==
        Approx(2 * 20 * visits + 0.5 / blanks_per_min + 3 * checks + 100 * 0.1 * visits));
  s["operations"][0]["quality"]["scrap_probability"] = 1.0;
  const Shop spoilt(s);
  CHECK(spoilt.run.throughput_per_h == 0);
  CHECK(spoilt.run.quality_ratio == 0);
  CHECK(std::isinf(spoilt.run.cost_per_good_part));
  CHECK(spoilt.run.cost_per_part == Approx(2 * 20 + 100 + 0.5 * 20));
  // A rate of chance to go round that is next to one settles, too.
  s["operations"][0]["quality"]["scrap_probability"] = 0.0;
  s["parts"][0]["steps"][0]["next"] =
      json::parse(R"([{"to": "m", "probability": 0.9}, {"to": "c", "probability": 0.1}])");
  CHECK(Shop(s).run.throughput_per_h == Approx(60 / (20 * 12.5)).epsilon(1e-6));
}

TEST_CASE("by hand: a crew by its wages is paid for the whole shift") {
  json s = mill();
  s["crews"][0] = json::parse(
      R"({"name": "fitter", "members": 2, "wages": {"monthly_wage": 15120, "hours_per_month": 168}})");
  // 15 120 a month of 168 h is 1.5 UAH/min.
  CHECK(Shop(s).run.cost_per_part == Approx(40 + 2 * 1.5 * 20));
}

TEST_CASE("by hand: drills that break by chance besides wearing out") {
  json s = test::gallery("drilling-line.json");
  s["parts"][0]["route"] = {"drill 8 x 20"};
  s["parts"][0].erase("release");
  for (const char* list : {"machines", "operations", "tools", "inserts"}) s[list].erase(1);
  s["tools"][0]["strategy"] = {{"kind", "run_to_failure"}};
  {
    const Shop shop(s);
    const auto& plan = shop.run.plans[0];
    REQUIRE(plan.breakage_probability > 1e-3);
    // The sooner of wear and chance: mean time in use by the midpoint rule.
    const models::LifeLaw life(plan.edge->law, plan.edge->mean_min, plan.edge->cv);
    const double rate = -std::log1p(-plan.breakage_probability) / plan.main_time_min;
    double used = 0;
    constexpr int steps = 200'000;
    const double end = 10 * plan.edge->mean_min;
    for (int k = 0; k < steps; ++k) {
      const double t = (k + 0.5) * end / steps;
      used += life.reliability(t) * std::exp(-rate * t) * end / steps;
    }
    CHECK(shop.run.operations[0].failures_per_part == Approx(plan.main_time_min / used).epsilon(1e-6));
    CHECK(shop.value("tool/20 mm drill/failure_share") == Approx(1));
  }
  // A drill that cannot bear the cut breaks again and again.
  s["operations"][0]["process"]["break_torque_nm"] = 5.0;
  const Shop hopeless(s);
  CHECK(hopeless.run.plans[0].breakage_probability == Approx(1));
  CHECK(hopeless.run.operations[0].failures_per_part > 20);
  CHECK(std::isfinite(hopeless.run.cost_per_part));
  s["tools"][0]["strategy"] = {{"kind", "block"}, {"gamma", 0.8}};
  CHECK_THROWS_WITH(Shop(s),
                    "block replacement of a tool that also breaks by chance is left to the simulation");
}

TEST_CASE("by hand: clutches that trip, and reset themselves or not") {
  json s = test::gallery("heavy-lathe.json");
  s["operations"][0]["process"]["material"] = {{"kc11_n_mm2", 2000}, {"mc", 0.25}};
  // On a shaft that turns too fast for it to close again by itself.
  s["machines"][0]["limits"] =
      json::parse(R"({"safety_clutch": {"clutch": "ball_triangle", "shaft_speed_rpm": 500,
    "set_torque_nm": 690, "accuracy": 1.15, "break_torque_nm": 1070, "spike_rate_per_min": 0.2, "spike_mean_ratio": 0.4,
    "overload_clear_min": 0.05, "detect_min": 0.5, "manual_reset_min": 4, "restart_min": 0.3}})");
  const double undisturbed = LongRunModel(scenarios::load(test::gallery("heavy-lathe.json")))
                                 .evaluate()
                                 .operations[0]
                                 .time_per_part_min;
  const Shop nobody(s);
  const auto overload = nobody.run.plans[0].overload.value();
  REQUIRE(overload.trips_per_part > 0.01);
  CHECK_FALSE(overload.self_reset);
  // Without somebody who is called it takes what the clutch says.
  CHECK(nobody.run.operations[0].time_per_part_min ==
        Approx(undisturbed + overload.trips_per_part * overload.reset_min));
  s["crews"].push_back({{"name", "fitter"}, {"rate_per_min", 0.9}, {"walking_min", 6}});
  s["machines"][0]["overload"] = json::parse(
      R"({"crew": "fitter", "repair": {"kind": "constant", "value_min": 90}, "damage": 300, "scrap_probability": 0.5})");
  const Shop called(s);
  const double minutes = overload.trips_per_part * (overload.reset_min + 6) + overload.breaks_per_part * 96;
  CHECK(called.run.operations[0].time_per_part_min == Approx(undisturbed + minutes));
  CHECK(called.run.operations[0].cost_per_part - nobody.run.operations[0].cost_per_part ==
        Approx(minutes * 3.9 - 3 * overload.trips_per_part * overload.reset_min +
               300 * overload.breaks_per_part));
  // A cone closes by itself: the fitter comes for what breaks alone.
  s["machines"][0]["limits"]["safety_clutch"]["clutch"] = "cone";
  const Shop by_itself(s);
  const auto cone = by_itself.run.plans[0].overload.value();
  CHECK(cone.self_reset);
  CHECK(by_itself.run.operations[0].time_per_part_min ==
        Approx(undisturbed + cone.trips_per_part * cone.reset_min + cone.breaks_per_part * 96));
  CHECK(called.run.quality_ratio ==
        Approx(nobody.run.quality_ratio * std::exp(-0.5 * overload.breaks_per_part)));
}

TEST_CASE("by hand: a shop whose orders all come after the end makes nothing") {
  json s = mill();
  s["parts"][0]["supply"] =
      json::parse(R"({"kind": "orders", "orders": [{"arrives_min": 20000, "quantity": 5}]})");
  const Shop shop(s);
  CHECK(shop.run.throughput_per_h == 0);
  CHECK(std::isinf(shop.run.cost_per_part));
  CHECK(std::isinf(shop.run.cost_per_good_part));
  CHECK(shop.run.quality_ratio == 0);
  s["parts"][0]["supply"]["orders"].insert(s["parts"][0]["supply"]["orders"].begin(),
                                           json::parse(R"({"arrives_min": 9000, "quantity": 100})"));
  CHECK(Shop(s).run.throughput_per_h == Approx(60 * 100 / 10'000.0));
}

TEST_CASE("by hand: KPIs by name, and tools that are idle") {
  json s = test::gallery("heavy-lathe.json");
  s["tools"].push_back({{"name", "spare tool"},
                        {"insert", "T5K10"},
                        {"crew", "setter"},
                        {"strategy", {{"kind", "run_to_failure"}}}});
  const Shop shop(s);
  CHECK(shop.model.kpis() ==
        std::vector<std::string>{"cost_per_part", "cost_per_good_part", "throughput_per_h", "quality_ratio",
                                 "load/lathe", "tool/roughing tool/failure_share",
                                 "tool/roughing tool/inserts_per_100_parts", "tool/spare tool/failure_share",
                                 "tool/spare tool/inserts_per_100_parts"});
  CHECK_FALSE(shop.model.kpi("load/mill"));
  CHECK(shop.value("tool/spare tool/failure_share") == 0);
  CHECK(shop.value("tool/spare tool/inserts_per_100_parts") == 0);
  // Age replacement at gamma: of the changes 1 - gamma come after a failure.
  CHECK(shop.value("tool/roughing tool/failure_share") == Approx(0.36));
  const models::LifeLaw life(models::LifeLawKind::weibull, 60, 0.7);
  const double used = life.restricted_mean(life.gamma_percent_life(0.64));
  const double main_min = shop.run.plans[0].main_time_min;
  // Two edges per insert, all usable.
  CHECK(shop.value("tool/roughing tool/inserts_per_100_parts") == Approx(100 * main_min / used / 2));
  CHECK(shop.model.operation_cost(shop.scenario.operations[0]).changes_per_part == Approx(main_min / used));
  CHECK(shop.model.cost_per_part() == shop.run.cost_per_part);
}

TEST_CASE("edges used per insert: a geometric series, with doubtful reserve and single edges") {
  for (const std::int64_t edges : {1, 2, 8})
    for (const double s : {0.0, 0.3, 1.0})
      for (const double single : {0.0, 0.4, 1.0}) {
        double several = 0;
        for (std::int64_t k = 0; k < edges; ++k) several += std::pow(s, static_cast<double>(k));
        CHECK(edges_used_per_insert(edges, s, single) == Approx(single + (1 - single) * several));
      }
}
