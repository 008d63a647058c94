// Failures, maintenance, people and calendars against closed forms.
#include "models/maintenance/k409_repair_service.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

TEST_CASE("failures on every clock", "[shop][stops]") {
  SECTION("operating time, exponential: availability MTTF / (MTTF + MTTR)") {
    json shop = small_shop(always(), constant(1));
    shop["machines"][0]["failures"] = {
        {{"name", "spindle"}, {"time_to_failure", exponential(200)}, {"repair", exponential(50)}}};
    const auto result = run(shop);
    check_truth(result, "machine/m/availability", 0.8, 0.03);
    check_truth(result, "machine/m/mtbf_min", 200, 0.1);
    check_truth(result, "machine/m/mttr_min", 50, 0.1);
    check_truth(result, "machine/m/loss/breakdowns", 0.2, 0.1);
    check_audit(shop);
  }
  SECTION("independent modes add: 1 / (1 + r1 / m1 + r2 / m2)") {
    json shop = small_shop(always(), constant(1));
    shop["machines"][0]["failures"] = {
        {{"name", "spindle"}, {"time_to_failure", exponential(200)}, {"repair", exponential(20)}},
        {{"name", "hydraulics"},
         {"clock", "parts"},
         {"time_to_failure", constant(100)},
         {"repair", constant(30)},
         {"effect", "after_part"}}};
    check_truth(run(shop), "machine/m/availability", 1 / (1 + 0.1 + 0.3), 0.02);
  }
  SECTION("calendar time counts while the machine is idle") {
    json shop = small_shop(arrivals(constant(1'000)), constant(1));
    shop["machines"][0]["failures"] = {{{"name", "control"},
                                        {"clock", "calendar"},
                                        {"time_to_failure", exponential(90)},
                                        {"repair", constant(10)}}};
    check_truth(run(shop), "machine/m/state/repair", 0.1, 0.05);
  }
  SECTION("at once stretches the part in work, after the part does not; parts are spoiled as stated") {
    json shop = small_shop(always(), constant(10));
    shop["simulation"] = {{"horizon_min", 1000}, {"replications", 1}};
    shop["machines"][0]["failures"] = {{{"name", "trip"},
                                        {"time_to_failure", constant(15)},
                                        {"repair", constant(5)},
                                        {"scrap_probability", 1}}};
    // Operating 15, repair 5, ...: every second part is hit (15, 30 = end of a part, 45, ...).
    const auto at_once = run(shop);
    CHECK(mean(at_once, "machine/m/failures/trip") == 50);
    CHECK(mean(at_once, "machine/m/state/repair") == Approx(0.25));
    CHECK(mean(at_once, "parts_scrapped") > 0);
    shop["machines"][0]["failures"][0]["effect"] = "after_part";
    const auto later = run(shop);
    // The third part is under way at 15: repaired at 20, then 15 more: at 40 (two parts later), ...
    CHECK(mean(later, "lead_time_min") == Approx(10));
    CHECK(mean(later, "machine/m/failures/trip") == 40);
  }
}

TEST_CASE("one repairer for three machines: the machine-repair model", "[shop][stops]") {
  // Failures 1/100, repairs 1/50, one repairer, 3 machines, birth and death.
  json shop = small_shop(always(), constant(1));
  shop["machines"][0]["count"] = 3;
  shop["machines"][0]["failures"] = {{{"name", "f"},
                                      {"time_to_failure", exponential(100)},
                                      {"repair", exponential(50)},
                                      {"crew", "fitters"}}};
  shop["crews"] = {{{"name", "fitters"}, {"rate_per_min", 1}}};
  const double r = 0.5;
  const double weight[] = {1, 3 * r, 6 * r * r, 6 * r * r * r};
  const double sum = weight[0] + weight[1] + weight[2] + weight[3];
  const double up = (3 * weight[0] + 2 * weight[1] + weight[2]) / sum / 3;
  const auto result = run(shop);
  check_truth(result, "machine/m 1/availability", up, 0.05);
  check_truth(result, "crew/fitters/utilization", 1 - weight[0] / sum, 0.03);
  // Wages are paid for the minutes worked.
  for (const auto& replication : result.values) {
    const auto value = [&](const char* name) { return *replication[*result.index_of(name)]; };
    CHECK(value("cost/repair") * value("parts_good") == Approx(value("crew/fitters/utilization") * 100'000));
  }
  check_audit(shop);
}

TEST_CASE("the gallery's repair service is K409's machine-repair queue, paid from its wage fund",
          "[shop][stops][long]") {
  json shop = scenarios_of("repair-service");
  shop["simulation"] = {
      {"horizon_min", 1'050'000}, {"warmup_min", 50'000}, {"replications", 10}, {"seed", "3"}};
  const auto theory = models::k409::machine_repair_queue({{.machines = 20, .mtbf_h = 80, .mttr_h = 6}, 3});
  const auto result = run(shop);
  double availability = 0;
  for (int k = 1; k <= 20; ++k)
    availability += mean(result, "machine/lathe " + std::to_string(k) + "/availability") / 20;
  CHECK(availability == Approx(theory.availability).epsilon(0.003));
  check_truth(result, "crew/repairmen/utilization", theory.crew_utilization, 0.05);
  // 18.3 an hour for each of three members, all the time.
  const double parts = mean(result, "parts_good");
  CHECK(mean(result, "cost/labour") == Approx(18.3 / 60 * 3 * 1'000'000 / parts).epsilon(1e-3));
}

TEST_CASE("maintenance prevents what it renews", "[shop][stops]") {
  json shop = small_shop(always(), constant(1));
  shop["machines"][0]["failures"] = {
      {{"name", "belt"}, {"time_to_failure", constant(100)}, {"repair", constant(40)}}};
  SECTION("without it") {
    CHECK(mean(run(shop), "machine/m/availability") == Approx(100.0 / 140).epsilon(2e-3));
  }
  SECTION("in time") {
    shop["machines"][0]["maintenance"] = {{{"name", "new belt"},
                                           {"clock", "operating"},
                                           {"interval", 80},
                                           {"duration", constant(5)},
                                           {"renews", {"belt"}}}};
    const auto result = run(shop);
    CHECK(mean(result, "machine/m/failures/belt") == 0);
    CHECK(mean(result, "machine/m/state/maintenance") == Approx(5.0 / 85).epsilon(2e-3));
    // Planned maintenance is outside the planned busy time (ISO 22400).
    CHECK(mean(result, "machine/m/availability") == Approx(1).epsilon(1e-9));
  }
  SECTION("too late") {
    shop["machines"][0]["maintenance"] = {{{"name", "new belt"},
                                           {"clock", "operating"},
                                           {"interval", 130},
                                           {"duration", constant(5)},
                                           {"renews", {"belt"}}}};
    CHECK(mean(run(shop), "machine/m/failures/belt") > 0);
  }
  SECTION("on condition: only what is worn beyond the threshold is renewed") {
    shop["machines"][0]["maintenance"] = {{{"name", "look"},
                                           {"clock", "operating"},
                                           {"interval", 30},
                                           {"duration", constant(1)},
                                           {"renews", {"belt"}},
                                           {"condition_threshold", 0.75}}};
    const auto result = run(shop);
    CHECK(mean(result, "machine/m/failures/belt") == 0);  // found at 90 of 100
    shop["machines"][0]["maintenance"][0]["condition_threshold"] = 0.95;
    CHECK(mean(run(shop), "machine/m/failures/belt") > 0);  // 90 is not enough, at 100 it fails
  }
  SECTION("joining other stops saves stops") {
    shop["machines"][0]["maintenance"] = {{{"name", "oil"},
                                           {"clock", "operating"},
                                           {"interval", 110},
                                           {"duration", constant(5)},
                                           {"joins_from", 0.8}}};
    const auto result = run(shop);
    // Every repair at 100 finds the oil change at 91 % of its interval.
    CHECK(mean(result, "machine/m/maintenance/oil") ==
          Approx(mean(result, "machine/m/failures/belt")).margin(1.1));
  }
}

TEST_CASE("repairs use up spare parts and wait for them", "[shop][stops]") {
  json shop = small_shop(always(), constant(1));
  shop["machines"][0]["failures"] = {
      {{"name", "belt"}, {"time_to_failure", constant(100)}, {"repair", constant(10)}, {"spare", "belt"}}};
  shop["spares"] = {{{"name", "belt"}, {"price", 7}, {"stock", 1}, {"lead_time", constant(30)}}};
  SECTION("reordered in time") {
    const auto result = run(shop);
    CHECK(mean(result, "spare/belt/stock_outs") == 0);
    CHECK(mean(result, "cost/spares") == Approx(7 / 100.0).epsilon(2e-3));
  }
  SECTION("delivery takes longer than the belt lasts") {
    shop["spares"][0]["lead_time"] = constant(160);
    const auto result = run(shop);
    // Cycle: 100 operating, 60 of waiting (ordered when the last one was taken, 10 of repair before), 10
    // repair.
    CHECK(mean(result, "machine/m/state/waiting_repair") == Approx(50.0 / 160).epsilon(5e-3));
    CHECK(mean(result, "spare/belt/stock_outs") > 0);
  }
  check_audit(shop);
}

TEST_CASE("shifts: work stops, or is finished, as the machine says", "[shop][stops]") {
  json shop = small_shop(always(), constant(50));
  shop["simulation"] = {{"horizon_min", 10'080}, {"replications", 1}};
  shop["calendars"] = {{{"name", "day"},
                        {"shifts",
                         {{{"days", {"monday", "tuesday", "wednesday", "thursday", "friday"}},
                           {"from_h", 6},
                           {"to_h", 14}}}}}};
  shop["machines"][0]["calendar"] = "day";
  SECTION("the part in work is finished: ten parts a day, twenty minutes of overtime") {
    const auto result = run(shop);
    CHECK(mean(result, "parts_good") == 50);
    CHECK(mean(result, "machine/m/state/working") == Approx(5 * 500 / 10'080.0));
  }
  SECTION("the part in work waits for the next shift") {
    shop["machines"][0]["part_at_shift_end"] = "pause";
    const auto result = run(shop);
    CHECK(mean(result, "parts_good") == 48);  // 2400 / 50
    CHECK(mean(result, "machine/m/state/working") == Approx(2400 / 10'080.0));
    CHECK(mean(result, "machine/m/state/off_shift") == Approx(1 - 2400 / 10'080.0));
    CHECK(mean(result, "machine/m/availability") == Approx(1));
  }
  SECTION("a holiday and a break") {
    shop["machines"][0]["part_at_shift_end"] = "pause";
    shop["calendars"][0]["holidays"] = {{{"first_day", 2}}};
    shop["calendars"][0]["breaks"] = {
        {{"days", {"monday", "tuesday", "wednesday", "thursday", "friday"}}, {"from_h", 10}, {"to_h", 10.5}}};
    CHECK(mean(run(shop), "machine/m/state/working") == Approx(4 * 450 / 10'080.0));
  }
  SECTION("a repair goes on, or waits for the morning") {
    shop["machines"][0]["part_at_shift_end"] = "pause";
    shop["machines"][0]["failures"] = {{{"name", "f"},
                                        {"clock", "operating"},
                                        {"time_to_failure", constant(450)},
                                        {"repair", constant(100)}}};
    // 450 of 480 minutes, then 100 of repair: 30 in the shift and 70 after it, or the next morning.
    CHECK(mean(run(shop), "machine/m/state/working") == Approx((4 * 450 + 450) / 10'080.0));
    shop["machines"][0]["repair_at_shift_end"] = "pause";
    CHECK(mean(run(shop), "machine/m/state/working") < 2100 / 10'080.0);
    CHECK(mean(run(shop), "machine/m/state/repair") > 0);
  }
  check_audit(shop);
}

TEST_CASE("people: skills, urgency, walking, several machines", "[shop][stops]") {
  json shop = small_shop(always(), constant(1));
  shop["machines"][0]["failures"] = {
      {{"name", "f"}, {"time_to_failure", constant(100)}, {"repair", constant(10)}, {"crew", "electrical"}}};
  shop["crews"] = {{{"name", "fitters"}, {"skills", {"electrical"}}, {"walking_min", 5}}};
  SECTION("by skill, walking counts as waiting") {
    const auto result = run(shop);
    CHECK(mean(result, "machine/m/state/waiting_repair") == Approx(5.0 / 115).epsilon(2e-3));
    CHECK(mean(result, "crew/fitters/utilization") == Approx(15.0 / 115).epsilon(2e-3));
  }
  SECTION("nobody there at night") {
    shop["calendars"] = {
        {{"name", "day"},
         {"shifts",
          {{{"days", {"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"}},
            {"from_h", 0},
            {"to_h", 12}}}}}};
    shop["crews"][0]["calendar"] = "day";
    const auto result = run(shop);
    CHECK(mean(result, "machine/m/state/waiting_repair") > 0.3);
  }
  SECTION("an operator tends two machines, or one") {
    json tended = small_shop(always(), constant(9));
    tended["machines"][0]["count"] = 2;
    tended["machines"][0]["loading"] = constant(1);
    tended["machines"][0]["attendance"] = {{"crew", "operators"}, {"during", "always"}};
    tended["crews"] = {
        {{"name", "operators"}, {"machines_per_member", 2}, {"pay", "shift"}, {"rate_per_min", 2}}};
    CHECK(mean(run(tended), "throughput_per_h") == Approx(12).epsilon(2e-3));
    tended["crews"][0]["machines_per_member"] = 1;
    const auto one = run(tended);
    CHECK(mean(one, "throughput_per_h") == Approx(6).epsilon(2e-3));
    CHECK(mean(one, "cost/labour") == Approx(20).epsilon(2e-3));
  }
  SECTION("the urgent call goes first") {
    json two = small_shop(always(), constant(10));
    two["machines"] = {{{"name", "m"},
                        {"failures",
                         {{{"name", "f"},
                           {"time_to_failure", constant(10)},
                           {"repair", constant(30)},
                           {"crew", "c"},
                           {"priority", 5},
                           {"effect", "after_part"}}}}},
                       {{"name", "n"},
                        {"failures",
                         {{{"name", "f"},
                           {"time_to_failure", constant(10)},
                           {"repair", constant(30)},
                           {"crew", "c"},
                           {"priority", 1},
                           {"effect", "after_part"}}}}},
                       {{"name", "u"},
                        {"failures",
                         {{{"name", "f"},
                           {"time_to_failure", constant(10)},
                           {"repair", constant(30)},
                           {"crew", "c"},
                           {"priority", 1},
                           {"effect", "after_part"}}}}}};
    two["operations"] = {
        {{"name", "o"}, {"machines", {"m", "n", "u"}}, {"process", duration_process(constant(10))}}};
    two["crews"] = {{{"name", "c"}}};
    const auto result = run(two);
    // Two urgent machines keep the crew busy for ever: the third never gets a turn again.
    CHECK(mean(result, "machine/m/state/waiting_repair") > 0.99);
  }
}

TEST_CASE("switching off, warming up, energy", "[shop][stops]") {
  json shop = small_shop(arrivals(constant(100)), constant(10));
  shop["simulation"] = {{"horizon_min", 101'000}, {"warmup_min", 1000}, {"replications", 1}};
  shop["machines"][0]["switch_off"] = {{"after_idle_min", 20}, {"warm_up", constant(5)}};
  shop["machines"][0]["power"] = {{"working_kw", 12}, {"standby_kw", 3}, {"off_kw", 0.6}};
  shop["energy_price_per_kwh"] = 2;
  const auto result = run(shop);
  CHECK(mean(result, "machine/m/state/warm_up") == Approx(0.05).epsilon(2e-3));
  CHECK(mean(result, "machine/m/state/off") == Approx(0.65).epsilon(2e-3));
  const double kwh = (10 * 12 + (5 + 20) * 3 + 65 * 0.6) / 60;
  CHECK(mean(result, "machine/m/energy_kwh_per_part") == Approx(kwh).epsilon(2e-3));
  CHECK(mean(result, "cost/energy") == Approx(2 * kwh).epsilon(2e-3));
}

TEST_CASE("OEE and its six losses fill the planned busy time", "[shop][stops]") {
  json shop = small_shop(arrivals(exponential(4)), exponential(2));
  shop["machines"][0]["failures"] = {
      {{"name", "f"}, {"time_to_failure", exponential(50)}, {"repair", exponential(20)}}};
  shop["machines"][0]["maintenance"] = {{{"name", "pm"}, {"interval", 500}, {"duration", constant(20)}}};
  shop["machines"][0]["setup"] = {{"time", constant(1)}};
  shop["operations"].push_back({{"name", "q"},
                                {"machine", "m"},
                                {"process", duration_process(constant(0.5))},
                                {"quality", {{"scrap_probability", 0.1}}}});
  shop["parts"][0]["route"] = {"o", "q"};
  const auto result = run(shop);
  for (const auto& replication : result.values) {
    double sum = 0;
    for (const char* name : {"oee", "loss/breakdowns", "loss/setup", "loss/stops", "loss/speed",
                             "loss/rejects", "loss/start_up"})
      sum += *replication[*result.index_of("machine/m/" + std::string(name))];
    CHECK(sum == Approx(1).epsilon(1e-9));
    const auto value = [&](const char* name) {
      return *replication[*result.index_of("machine/m/" + std::string(name))];
    };
    CHECK(value("oee") ==
          Approx(value("availability") * value("effectiveness") * value("quality_ratio")).epsilon(1e-9));
  }
}
