// The safety clutch of a drive in the shop (K204): trips, breaks, their time and cost per part are those of
// the plan, and the setting that costs least is the card's.
#include "operations/safety_clutch.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

constexpr double rate_per_min = 3;
constexpr double damage = 180;
constexpr double repair_min = 20;

json milling_with_clutch(double set_torque_nm) {
  const json shown =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/face_milling_machine.json");
  json shop = small_shop(always(), constant(1));
  shop["operations"][0]["process"] = shown.at("process");
  json& machine = shop["machines"][0];
  machine["rate_per_min"] = rate_per_min;
  machine["limits"]["safety_clutch"] = shown.at("machine_limits").at("safety_clutch");
  machine["limits"]["safety_clutch"]["set_torque_nm"] = set_torque_nm;
  machine["limits"]["safety_clutch"]["spike_rate_per_min"] = 5;
  machine["limits"]["safety_clutch"]["break_torque_nm"] = 700;
  machine["overload"] = {
      {"crew", ""}, {"repair", constant(repair_min)}, {"damage", damage}, {"scrap_probability", 0.3}};
  return shop;
}

double overload_cost(const shop::RunResult& r) {
  return mean(r, "cost/overload_reset") + mean(r, "cost/damage") + mean(r, "cost/repair");
}

}  // namespace

TEST_CASE("clutch: trips and breaks, their time and cost per part are those of the plan",
          "[shop][K204][long]") {
  const json shop = milling_with_clutch(560);
  const auto s = scenarios::load(shop);
  const auto plan = scenarios::plan(s, s.operations[0]);
  REQUIRE(plan.overload);
  const auto& o = *plan.overload;
  REQUIRE(o.self_reset);
  CHECK(o.trips_per_part > 1e-3);
  CHECK(o.breaks_per_part > 1e-4);
  const auto r = run(shop);
  // A part takes its main time and on average the time of its overloads.
  const double part_min =
      plan.main_time_min + o.trips_per_part * o.reset_min + o.breaks_per_part * repair_min;
  const double parts = 100'000 / part_min;
  check_truth(r, "machine/m/overload_trips", parts * o.trips_per_part, 0.1);
  check_truth(r, "machine/m/overload_breaks", parts * o.breaks_per_part, 0.2);
  check_truth(r, "machine/m/state/overload_reset", o.trips_per_part * o.reset_min / part_min, 0.1);
  check_truth(r, "machine/m/state/repair", o.breaks_per_part * repair_min / part_min, 0.2);
  check_truth(r, "cost/overload_reset", o.trips_per_part * o.reset_min * rate_per_min, 0.1);
  check_truth(r, "cost/damage", o.breaks_per_part * damage, 0.2);
  check_truth(r, "cost/repair", o.breaks_per_part * repair_min * rate_per_min, 0.2);
  // Of the breaks 30 % spoil the part: at least one in a part that has n of them.
  check_truth(r, "quality_ratio", std::exp(-0.3 * o.breaks_per_part), 0.01);
  check_audit(shop);
}

TEST_CASE("clutch: somebody must come when it does not close again by itself", "[shop][K204][long]") {
  json shop = milling_with_clutch(560);
  shop["machines"][0]["limits"]["safety_clutch"]["clutch"] = "ball_triangle";
  shop["crews"] = {{{"name", "fitter"}, {"rate_per_min", 0.5}}};
  shop["machines"][0]["overload"]["crew"] = "fitter";
  const auto s = scenarios::load(shop);
  const auto o = *scenarios::plan(s, s.operations[0]).overload;
  REQUIRE_FALSE(o.self_reset);
  CHECK(o.reset_min > 4);  // seen, reset by hand, run up
  const auto r = run(shop);
  // The fitter is there at once: only working minutes are added.
  check_truth(r, "cost/overload_reset", o.trips_per_part * o.reset_min * (rate_per_min + 0.5), 0.1);
}

TEST_CASE("clutch: of many settings simulated, the cheapest is the one of the card", "[shop][K204][long]") {
  const auto s = scenarios::load(milling_with_clutch(560));
  const auto plan = scenarios::plan(s, s.operations[0]);
  const double best_nm = operations::optimal_setting_nm(*s.machines[0].limits.safety_clutch, plan,
                                                        plan.overload->reset_min * rate_per_min,
                                                        damage + repair_min * rate_per_min);
  std::vector<double> settings;
  for (const double share : {0.8, 0.9, 1.0, 1.12, 1.25}) settings.push_back(share * best_nm);
  std::vector<double> costs;
  for (const double set_nm : settings) {
    costs.push_back(overload_cost(run(milling_with_clutch(set_nm))));
  }
  const auto cheapest = std::min_element(costs.begin(), costs.end()) - costs.begin();
  INFO("settings around " << best_nm << " N m cost " << costs[0] << ' ' << costs[1] << ' ' << costs[2] << ' '
                          << costs[3] << ' ' << costs[4]);
  CHECK(cheapest == 2);
}
