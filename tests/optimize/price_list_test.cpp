// The price list of losses: which losses a shop states, what removes each, and that removing it does.
#include <algorithm>

#include <catch2/catch.hpp>

#include "optimize/losses.h"
#include "optimize/renewal_reward.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

std::vector<std::string> names(const json& text) {
  std::vector<std::string> all;
  for (const Loss& loss : losses_of(scenarios::load(text))) all.push_back(loss.name);
  return all;
}
Loss find(const json& text, const std::string& name) {
  for (Loss& loss : losses_of(scenarios::load(text)))
    if (loss.name == name) return loss;
  FAIL("there is no loss \"" << name << "\"");
  return {};
}
bool has(const json& text, const std::string& name) {
  const auto all = names(text);
  return std::find(all.begin(), all.end(), name) != all.end();
}

// K117's lathes with nothing to lose, and one mill behind them.
json lossless() {
  json s = gallery("heavy-lathe.json");
  const json nothing = {{"kind", "constant"}, {"value_min", 0.0}};
  s["tools"][0]["change"] = {{"index", nothing}, {"replace", nothing}};
  s["tools"][0]["failure_damage"] = 0.0;
  s["tools"][0]["failure_scrap_probability"] = 0.0;
  s["crews"][0]["members"] = 3;
  s["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}});
  s["operations"].push_back(json::parse(R"({"name": "milling", "machine": "mill",
    "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}})"));
  s["parts"][0]["route"] = {"rough turning", "milling"};
  return s;
}

}  // namespace

TEST_CASE("a shop that loses nothing has no price list, and each loss alone is the only entry") {
  CHECK(names(lossless()).empty());
  struct Case {
    const char *pointer, *value, *name, *kind;
  };
  for (
      const Case& c : {
          Case{"/tools/0/failure_damage", "5", "failures of roughing tool", "failure"},
          Case{"/tools/0/change/failure_extra_min", "5", "failures of roughing tool", "failure"},
          Case{"/tools/0/change/positioning_min", "5", "changes of roughing tool", "change"},
          Case{"/tools/0/change/stop_min", "5", "changes of roughing tool", "change"},
          Case{"/tools/0/change/index/value_min", "5", "changes of roughing tool", "change"},
          Case{"/tools/0/change/replace/value_min", "5", "changes of roughing tool", "change"},
          Case{"/machines/1/setup", R"({"time": {"kind": "constant", "value_min": 9}})", "setting up mill",
               "change"},
          Case{
              "/machines/1/failures",
              R"([{"name": "belt", "time_to_failure": {"kind": "constant", "value_min": 900}, "repair": {"kind": "constant", "value_min": 9}}])",
              "belt of mill", "failure"},
          Case{"/machines/1/maintenance",
               R"([{"name": "oil", "interval": 900, "duration": {"kind": "constant", "value_min": 9}}])",
               "time of oil of mill", "change"},
          Case{"/operations/1/quality", R"({"scrap_probability": 0.1})", "scrap of milling", "scrap"},
          Case{"/operations/1/quality", R"({"defect_probability": 0.1})", "defects of milling", "scrap"},
          Case{"/operations/1/quality", R"({"defect_when_worn": 0.1})", "defects of milling", "scrap"},
          Case{"/spares", R"([{"name": "belt", "lead_time": {"kind": "constant", "value_min": 9}}])",
               "waiting for belt", "wait"},
          Case{"/inserts/0/crib", R"({"stock": 10, "lead_time": {"kind": "constant", "value_min": 60}})",
               "waiting for inserts T5K10", "wait"},
          Case{"/crews/0/walking_min", "2", "walking of setter", "wait"},
          Case{"/crews/0/members", "2", "waiting for setter", "wait"},
      }) {
    INFO(c.pointer << " " << c.value);
    const json s = scenarios::apply(lossless(), {{c.pointer, json::parse(c.value)}});
    const auto all = losses_of(scenarios::load(s));
    REQUIRE(all.size() == 1);
    CHECK(all[0].name == c.name);
    CHECK(all[0].kind == c.kind);
    // Removed, the list is empty again, but for machines: their failures come later than any study ends.
    const json without = scenarios::apply(s, all[0].removed_by);
    if (all[0].kind == "failure" && all[0].name == "belt of mill") {
      CHECK(mean_min(scenarios::load(without).machines[1].failures[0].time_to_failure) == 1e9);
    } else {
      CHECK(names(without).empty());
    }
  }
  // What takes no time, or is used by nobody, loses nothing.
  for (const auto& [pointer, value] :
       {std::pair{"/machines/1/maintenance",
                  R"([{"name": "oil", "interval": 900, "duration": {"kind": "constant", "value_min": 0}}])"},
        std::pair{"/spares", R"([{"name": "belt", "lead_time": {"kind": "constant", "value_min": 0}}])"},
        std::pair{"/operations/1/quality", "{}"}, std::pair{"/crews/0/members", "4"}})
    CHECK(names(scenarios::apply(lossless(), {{pointer, json::parse(value)}})).empty());
  json unused = lossless();
  unused["tools"].push_back(gallery("heavy-lathe.json")["tools"][0]);
  unused["tools"][1]["name"] = "in the drawer";
  CHECK(names(unused).empty());
}

TEST_CASE("a failure that costs no more than a planned change leaves the difference of renewal reward") {
  // K117: without damage, scrap and extra time, at the planned price of the edge, gamma alone remains.
  const json shop = gallery("heavy-lathe.json");
  const Loss failures = find(shop, "failures of roughing tool");
  const auto s = scenarios::load(scenarios::apply(shop, failures.removed_by));
  const LongRunModel model(s);
  const auto run = model.evaluate();
  const models::LifeLaw life(models::LifeLawKind::weibull, 60, 0.7);
  const double changes = run.plans[0].main_time_min / life.restricted_mean(life.gamma_percent_life(0.64));
  const double change_min = 5.0 / 3 + 1 / 0.3;
  CHECK(run.cost_per_part ==
        Approx(3 * run.plans[0].main_time_min + changes * (change_min * 3.5 + 80.0 / 4)));
  CHECK(has(shop, "scrap after failures of roughing tool"));
  const auto unspoilt =
      scenarios::load(scenarios::apply(shop, find(shop, "scrap after failures of roughing tool").removed_by));
  CHECK(LongRunModel(unspoilt).evaluate().quality_ratio == 1);
  const auto quick =
      scenarios::load(scenarios::apply(shop, find(shop, "changes of roughing tool").removed_by));
  // Failures still take their ten minutes.
  const auto quick_run = LongRunModel(quick).evaluate();
  CHECK(quick_run.operations[0].changing_per_part_min ==
        Approx(quick_run.operations[0].failures_per_part * 10));
}

TEST_CASE("tools that are swapped, elements, and crews by the shift or by their wages") {
  json s = lossless();
  s["tools"][0]["copies"] = 2;
  s["tools"][0]["change"]["swap"] = {{"kind", "constant"}, {"value_min", 3.0}};
  s["tools"][0]["change"]["stop_min"] = 2.0;
  const Loss changes = find(s, "changes of roughing tool");
  const auto without = scenarios::load(scenarios::apply(s, changes.removed_by));
  CHECK(mean_min(without.tools[0].change.swap) == 0);
  CHECK(without.tools[0].change.stop_min == 0);
  json line = gallery("camshaft-line.json");
  const Loss dressing = find(line, "changes of wheel dressing of grinding wheel");
  CHECK(mean_min(scenarios::load(scenarios::apply(line, dressing.removed_by)).tools[1].elements[0].change) ==
        0);
  line["tools"][1]["elements"][0]["change"]["value_min"] = 0.0;
  CHECK_FALSE(has(line, "changes of wheel dressing of grinding wheel"));
  // A crew as large as the shop, paid no more than today's.
  json paid = lossless();
  paid["crews"][0] = {{"name", "setter"}, {"members", 1}, {"rate_per_min", 0.6}, {"pay", "shift"}};
  const auto larger = scenarios::load(scenarios::apply(paid, find(paid, "waiting for setter").removed_by));
  CHECK(larger.crews[0].members == 3);
  CHECK(larger.crews[0].rate_per_min * 3 == Approx(0.6));
  paid["crews"][0] = json::parse(R"({"name": "setter", "members": 2, "wages": {"monthly_wage": 15000}})");
  const auto before = scenarios::load(paid);
  const auto after = scenarios::load(scenarios::apply(paid, find(paid, "waiting for setter").removed_by));
  CHECK(after.crews[0].members == 3);
  CHECK(after.crews[0].rate_per_min * 3 == Approx(before.crews[0].rate_per_min * 2));
  paid["crews"][0] = {{"name", "setter"}, {"members", 1}, {"rate_per_min", 0.6}, {"pay", "busy"}};
  CHECK(find(paid, "waiting for setter").removed_by.size() == 1);
}
