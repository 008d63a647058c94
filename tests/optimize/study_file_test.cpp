// The study file: every refusal names the place, what stands there and what would be right; what is read is
// what was written.
#include <catch2/catch.hpp>

#include "optimize/study_spec.h"
#include "scenarios/input_error.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;

namespace {

json plain() {
  return json::parse(R"({"name": "n", "scenario": "s.json",
    "variables": [{"name": "speed", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 20, "high": 120}]})");
}

struct Refused {
  std::string pointer, text;
};
Refused refused(const json& study) {
  try {
    (void)load_study(study);
  } catch (const scenarios::InputError& e) {
    return {e.pointer(), e.what()};
  }
  return {"accepted", "accepted"};
}
// A study with this member beside the plain ones, or instead of one.
Refused with(const char* member, const char* value) {
  json study = plain();
  study[member] = json::parse(value);
  return refused(study);
}
Refused variable(const char* text) {
  json study = plain();
  study["variables"].push_back(json::parse(text));
  return refused(study);
}
Refused constraint(const char* text) {
  json study = plain();
  // The second of two, so that the place must be counted.
  study["constraints"] = {{{"kpi", "throughput_per_h"}, {"at_least", 1}}, json::parse(text)};
  return refused(study);
}

}  // namespace

TEST_CASE("study file: shapes, types and ranges are refused by place and value") {
  CHECK(refused(plain()).text == "accepted");
  CHECK(refused(json::array()).text.starts_with("the study"));
  CHECK(with("variabels", "[]").text.starts_with("/variabels"));
  CHECK(with("variabels", "[]").text.find("variables") != std::string::npos);  // the closest
  json nameless = plain();
  nameless.erase("name");
  CHECK(refused(nameless).pointer == "/name");
  struct Case {
    const char *member, *value, *pointer, *given, *allowed;
  };
  for (const Case& c : {
           Case{"search", R"({"max_evaluations": 0})", "/search/max_evaluations", " = 0", "1"},
           Case{"search", R"({"relative_precision": 0.5})", "/search/relative_precision", " = 0.5", "0.1"},
           Case{"search", R"({"starts": -1})", "/search/starts", " = -1", "1000"},
           Case{"simulation", R"({"trials": -2})", "/simulation/trials", " = -2", "100000"},
           Case{"simulation", R"({"first_replications": 1})", "/simulation/first_replications", " = 1", "2"},
           Case{"simulation", R"({"levels": 11})", "/simulation/levels", " = 11", "10"},
           Case{"simulation", R"({"neighbourhood": 0})", "/simulation/neighbourhood", " = 0", "1"},
           Case{"choice", R"({"finalists": 0})", "/choice/finalists", " = 0", "100"},
           Case{"choice", R"({"confidence": 1})", "/choice/confidence", " = 1", "0.5"},
           Case{"choice", R"({"indifference": 0})", "/choice/indifference", " = 0", "1"},
           Case{"choice", R"({"first_replications": 2})", "/choice/first_replications", " = 2", "3"},
           Case{"choice", R"({"max_replications": 2})", "/choice/max_replications", " = 2", "3"},
           Case{"confirmation", R"({"replications": 1})", "/confirmation/replications", " = 1", "2"},
           Case{"confirmation", R"({"confidence": 0.4})", "/confirmation/confidence", " = 0.4", "0.5"},
           Case{"budget", R"({"time_s": -1})", "/budget/time_s", " = -1", "0"},
           Case{"budget", R"({"trials": -1})", "/budget/trials", " = -1", "0"},
           Case{"front", R"({"points": 1})", "/front/points", " = 1", "2"},
           Case{"front", R"({"replications": -1})", "/front/replications", " = -1", "0"},
           Case{"robust", R"({"samples": 1001})", "/robust/samples", " = 1001", "1000"},
           Case{"robust", R"({"measure": "median"})", "/robust/measure", " = \"median\"", "worst"},
           Case{"uncertain", R"([{"name": "a", "pointer": "/b", "relative": 1}])", "/uncertain/0/relative",
                " = 1", "0"},
           Case{"objective", R"({"kpi": "a", "direction": "up"})", "/objective/direction", " = \"up\"",
                "maximize"},
           Case{"changes", R"([{"pointer": "/a"}])", "/changes/0/value", "", "value"},
           Case{"name", "3", "/name", " = 3", "text"},
       }) {
    const Refused r = with(c.member, c.value);
    INFO(c.member << " " << c.value << ": " << r.text);
    CHECK(r.pointer == c.pointer);
    CHECK(r.text.starts_with(std::string(c.pointer) + c.given));
    CHECK(r.text.find(c.allowed, std::string(c.pointer).size()) != std::string::npos);
  }
}

TEST_CASE("study file: objectives") {
  CHECK(with("objective", "{}").text == "/objective: must have exactly one of kpi and function");
  CHECK(with("objective", R"({"kpi": "a", "function": "b", "output": "c"})").text ==
        "/objective: must have exactly one of kpi and function");
  CHECK(with("objective", R"({"kpi": "a", "output": "c"})").text ==
        "/objective/output: goes with function, and only with it");
  CHECK(with("objective", R"({"function": "b"})").text ==
        "/objective/output: goes with function, and only with it");
  CHECK(with("objectives", R"([{"kpi": "a"}, {"function": "b"}])").text ==
        "/objectives/1/output: goes with function, and only with it");
  CHECK(with("objectives", R"([{"kpi": "a"}, {}])").pointer == "/objectives/1");
  CHECK(with("objectives", R"([{"kpi": "a"}, {"kpi": "b"}, {"kpi": "c"}, {"kpi": "d"}, {"kpi": "e"}])")
            .text.starts_with("/objectives has 5 entries, allowed 0 to 4"));
  json both = plain();
  both["objective"] = {{"kpi", "a"}};
  both["objectives"] = {{{"kpi", "a"}}, {{"kpi", "b"}}};
  CHECK(refused(both).text == "/objectives: a study has either objective or objectives");
  // Nothing said: what a part costs. Several: the first leads.
  CHECK(load_study(plain()).objective.kpi == "cost_per_part");
  CHECK(load_study(plain()).objectives.size() == 1);
  both.erase("objective");
  CHECK(load_study(both).objective.kpi == "a");
  both["objectives"] =
      json::parse(R"([{"function": "K117.part_cost", "output": "part_cost", "direction": "maximize"}])");
  CHECK(load_study(both).objective.label() == "part_cost of K117.part_cost");
  CHECK(load_study(both).objective.direction == Direction::maximize);
  CHECK(load_study(plain()).objective.label() == "cost_per_part");
}

TEST_CASE("study file: variables") {
  CHECK(variable(R"({"name": "a", "pointer": "/b", "type": "categorical", "options": [1]})").text ==
        "/variables/1/options: a categorical variable needs at least 2 options");
  CHECK(variable(R"({"name": "a", "pointer": "/b", "options": [1, 2]})").text ==
        "/variables/1/options: only a categorical variable has options; this one has low and high");
  CHECK(
      variable(R"({"name": "a", "pointer": "/b", "type": "integer", "low": 1, "high": 2, "options": [1, 2]})")
          .pointer == "/variables/1/options");
  CHECK(variable(R"({"name": "a", "pointer": "/b", "low": 2, "high": 2})").text ==
        "/variables/1/low = 2, must be below high = 2");
  CHECK(variable(R"({"name": "a", "pointer": "/b", "type": "integer", "low": 1, "high": 2.5})").text ==
        "/variables/1/high = 2.5, must be a whole number");
  // A double has no whole numbers to tell apart out there.
  CHECK(variable(R"({"name": "a", "pointer": "/b", "type": "integer", "low": -2e15, "high": 2})").pointer ==
        "/variables/1/low");
  CHECK(variable(R"({"name": "a", "pointer": "/b", "type": "integer", "low": -3, "high": 2})").text ==
        "accepted");
}

TEST_CASE("study file: constraints") {
  const char* one_kind = "/constraints/1: must have exactly one of kpi, operation and function";
  CHECK(constraint(R"({"at_most": 1})").text == one_kind);
  CHECK(constraint(R"({"kpi": "a", "function": "b", "output": "c", "at_most": 1})").text == one_kind);
  const char* one_item =
      "/constraints/1: exactly one of quantity, limits and bands goes with operation, and only with it";
  CHECK(constraint(R"({"kpi": "a", "quantity": "b", "at_most": 1})").text == one_item);
  CHECK(constraint(R"({"operation": "a", "at_most": 1})").text == one_item);
  CHECK(constraint(R"({"operation": "a", "limits": "all", "bands": "all"})").text == one_item);
  CHECK(constraint(R"({"function": "a", "bands": "all"})").text == one_item);
  CHECK(constraint(R"({"function": "a", "at_most": 1})").text ==
        "/constraints/1/output: which output of the function?");
  const char* one_end = "/constraints/1: must have either at_most or at_least";
  CHECK(constraint(R"({"kpi": "a"})").text == one_end);
  CHECK(constraint(R"({"kpi": "a", "at_most": 2, "at_least": 1})").text == one_end);
  CHECK(constraint(R"({"operation": "a", "quantity": "b"})").text == one_end);
  const char* own = "/constraints/1: limits and bands of a plan bring their own allowed values";
  CHECK(constraint(R"({"operation": "a", "limits": "all", "at_most": 1})").text == own);
  CHECK(constraint(R"({"operation": "a", "bands": "all", "at_least": 1})").text == own);
  CHECK(constraint(R"({"operation": "a", "limits": "all", "at_most": 2, "at_least": 1})").text == own);
  CHECK(constraint(R"({"kpi": "a", "at_most": 1, "confidence": 1})").pointer == "/constraints/1/confidence");
  for (const char* good :
       {R"({"kpi": "a", "at_least": 1})", R"({"operation": "*", "quantity": "b", "at_most": 1})",
        R"({"operation": "a", "limits": "all"})", R"({"operation": "a", "bands": "feed_mm_rev"})",
        R"({"function": "a", "output": "b", "at_least": 1})"})
    CHECK(constraint(good).text == "accepted");
}

TEST_CASE("study file: algorithms by name") {
  CHECK(with("search", R"({"algorithm": "LN_NEWTON"})")
            .text.starts_with("/search/algorithm = \"LN_NEWTON\", must be an NLopt algorithm"));
  CHECK(with("search", R"({"local_algorithm": "BOBYQA"})")
            .text.starts_with("/search/local_algorithm = \"BOBYQA\", must be an NLopt algorithm"));
  // A long name is cut.
  json study = plain();
  study["search"]["algorithm"] = std::string(5000, 'x');
  CHECK(refused(study).text.size() < 400);
  CHECK(with("search", R"({"algorithm": "GN_CRS2_LM", "local_algorithm": "LN_COBYLA"})").text == "accepted");
}

TEST_CASE("study file: a value of a variable, as the scenario and as a person has it") {
  const StudySpec study = load_study(json::parse(R"({"$schema": "s", "name": "n", "scenario": "s.json",
    "changes": [{"pointer": "/crews/0/members", "value": 2}, {"pointer": "/tools/0/strategy", "value": {"kind": "run_to_failure"}}],
    "variables": [{"name": "v", "pointer": "/v", "low": 0, "high": 1},
                  {"name": "edges", "pointer": "/e", "type": "integer", "low": 2, "high": 8},
                  {"name": "strategy", "pointer": "/s", "type": "categorical",
                   "options": [{"kind": "run_to_failure"}, {"gamma": 0.5}, "plain", 3, true]}]})"));
  const auto& [v, edges, strategy] = std::tie(study.variables[0], study.variables[1], study.variables[2]);
  CHECK(StudySpec::settings_of(v) == 0);
  CHECK(StudySpec::settings_of(edges) == 7);
  CHECK(StudySpec::settings_of(strategy) == 5);
  CHECK(strategy.low == 0);
  CHECK(strategy.high == 4);
  CHECK(value_at(v, 0.25) == json(0.25));
  CHECK(value_at(edges, 3.4) == json(3));
  CHECK(value_at(edges, 3.4).is_number_integer());
  CHECK(value_at(strategy, 0) == json({{"kind", "run_to_failure"}}));
  CHECK(value_at(strategy, 2) == json("plain"));
  CHECK(text_at(v, 1.0 / 3) == "0.333333");
  CHECK(text_at(edges, 4) == "4");
  CHECK(text_at(strategy, 0) == R"({"kind":"run_to_failure"})");
  CHECK(text_at(strategy, 1) == R"({"gamma":0.5})");
  CHECK(text_at(strategy, 2) == "plain");
  CHECK(text_at(strategy, 3) == "3");
  CHECK(text_at(strategy, 4) == "true");
  CHECK_THROWS_AS(value_at(strategy, 5), std::out_of_range);
  const auto changes = changes_at(study.variables, {0.5, 2, 2});
  REQUIRE(changes.size() == 3);
  CHECK(changes[1].pointer == "/e");
  CHECK(changes[1].value == json(2));
  CHECK(changes[2].value == json("plain"));
  const auto fixed = fixed_changes(study);
  REQUIRE(fixed.size() == 2);
  CHECK(fixed[0].pointer == "/crews/0/members");
  CHECK(fixed[0].value == json(2));
  CHECK(fixed[1].value == json({{"kind", "run_to_failure"}}));
  CHECK(pointer_tokens("/a/b~1c/~0d") == std::vector<std::string>{"a", "b/c", "~d"});
  CHECK(pointer_tokens("").empty());
  CHECK_THROWS_AS(pointer_tokens("a"), json::exception);
}
