// The installed program as a user meets it: answers, errors, exit codes, determinism, and help that runs.
#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"

using nlohmann::json;
using verstat::test::Answer;
using verstat::test::call;
using verstat::test::Workspace;

namespace {

const std::string cell = "scenarios/gallery/heavy-lathe.json";
const std::string study = "scenarios/gallery/heavy-lathe.study.json";
const std::string quick = " --set /simulation/horizon_min=30000 --replications 4 ";

// What may differ between two runs of the same thing: when and how long.
json without_timings(json j) {
  j.erase("id");
  j.erase("elapsed_s");
  if (j.contains("provenance")) j["provenance"].erase("created");
  return j;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("the same seed gives byte-identical answers on any number of threads") {
  const Workspace w;
  std::string first;
  for (const char* threads : {"1", "2", "7"}) {
    const Answer a = call("run " + cell + quick + "--json --threads " + threads + " --db " + w.file("a.db"));
    REQUIRE(a.exit_code == 0);
    const std::string text = without_timings(json::parse(a.out)).dump();
    if (first.empty()) first = text;
    CHECK(text == first);
  }
  const Answer other = call("run " + cell + quick + "--json --seed 7 --db " + w.file("a.db"));
  CHECK(without_timings(json::parse(other.out)).dump() != first);
}

TEST_CASE("what was stored is what was said") {
  const Workspace w;
  const json said = json::parse(call("run " + cell + quick + "--json --db " + w.file("a.db")).out);
  json kept = json::parse(call("runs --json --run " + said["id"].dump() + " --db " + w.file("a.db")).out);
  CHECK(kept == said);
  const json all = json::parse(call("runs --json --run 1 --all-replications --db " + w.file("a.db")).out);
  CHECK(all["kpis"][0]["values"].size() == 4);
  CHECK(json::parse(call("runs --json --db " + w.file("a.db")).out)["runs"].size() == 1);
}

TEST_CASE("a plan that breaks a limit is run, and said on the error stream and in the JSON") {
  const Workspace w;
  const std::string rings = "scenarios/gallery/bearing-rings.json";
  const std::string run = "run " + rings + quick + "--json --db " + w.file("a.db");
  const std::string line =
      "warning: /operations/0/process: operation \"turn the raceway\" on \"hard-turning lathe\": feed_mm_rev "
      "is "
      "0.3 mm/rev, inside the forbidden band 0.205403 to 0.405206";
  const Answer warned = call(run);
  CHECK(warned.exit_code == 0);
  CHECK(warned.err.find(line) != std::string::npos);
  const json said = json::parse(warned.out);
  REQUIRE(said["warnings"].size() == 1);
  CHECK(said["warnings"][0]["limit"] == "feed_mm_rev");
  CHECK(said["warnings"][0]["value"] == 0.3);
  CHECK(said["warnings"][0]["high"].get<double>() > 0.4);
  const Answer checked = call("validate --json " + rings);
  CHECK(checked.exit_code == 0);
  CHECK(checked.err.find(line) != std::string::npos);
  CHECK(json::parse(checked.out)["warnings"] == said["warnings"]);

  const std::string outside = " --set /operations/0/process/feed_mm_rev=0.15";
  const Answer kept = call(run + outside);
  CHECK(kept.err.find("warning") == std::string::npos);
  CHECK_FALSE(json::parse(kept.out).contains("warnings"));
  CHECK(json::parse(call("validate --json " + rings + outside).out)["warnings"].empty());
  // Names from strangers' files do not reach the terminal as they are.
  const Answer named =
      call("validate " + rings +
           R"( --set '/operations/0/name="a\u001b[31mb"' --set '/parts/0/route=["a\u001b[31mb"]')");
  CHECK(named.err.find("warning") != std::string::npos);
  CHECK(named.err.find('\x1b') == std::string::npos);
}

TEST_CASE("malformed and absurd input: one clear line, exit code 2, no database") {
  const Workspace w;
  const std::string db = " --db " + w.file("none.db");
  struct Case {
    std::string arguments, says;
  };
  for (const Case& c :
       {Case{"run " + cell + " --set /machines/0/count=0", "/machines/0/count = 0, allowed 1 <= count"},
        Case{"run " + cell + " --set /machines/0/count=1e99",
             "/machines/0/count = 1e+99, must be a whole number"},
        Case{"run " + cell + " --set /nothing/here=1", "/nothing: there is no such member"},
        Case{"run " + cell + " --set machines=1", "--set machines=1: must be POINTER=VALUE"},
        Case{"run " + cell + " --seed -1",
             "--seed -1: must be a whole number from 0 to 18446744073709551615"},
        Case{"run " + cell + " --seed 18446744073709551616",
             "--seed 18446744073709551616: must be a whole number"},
        Case{"run " + cell + " --replications 0",
             "--replications 0: must be a whole number from 1 to 100000"},
        Case{"run " + cell + " --replications 2.5", "--replications 2.5: must be a whole number"},
        Case{"run " + cell + " --threads many", "--threads many: must be a whole number from 1 to 1024"},
        Case{"run no/such/file.json", "scenario no/such/file.json: cannot be read"},
        Case{"run scenarios", "scenario scenarios: is a directory"},
        Case{"run README.md", "scenario README.md: is not JSON: line 1"}, Case{"run", "SCENARIO is required"},
        Case{"run " + cell + " --colour", "--colour"}, Case{"optimize " + cell, "study " + cell + ": /"},
        Case{"optimize " + study + " --replications 1", "at least 2 pairs"},
        Case{"optimize " + study + " --set /parts/0/route=[]", "/parts/0/route = nothing"}}) {
    INFO(c.arguments);
    const Answer a = call(c.arguments + db);
    CHECK(a.exit_code == 2);
    CHECK(a.out.empty());
    CHECK(a.err.starts_with("error: "));
    CHECK(lines(a.err) == 1);
    CHECK_THAT(a.err, Catch::Contains(c.says));
    CHECK_FALSE(std::filesystem::exists(w.file("none.db")));
  }
}

TEST_CASE("an argument that is no text is refused before anything is done") {
  const Workspace w;
  const Answer a = call(
      "fit cycle docs/examples/fit/cycles.csv --json --to /n\xff"
      "ame --out " +
      w.file("c.json"));
  CHECK(a.exit_code == 2);
  CHECK(a.out.empty());
  CHECK(lines(a.err) == 1);
  CHECK(a.err.find("argument 6, \"/n?ame\", is not UTF-8 text") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(w.file("c.json")));
}

TEST_CASE("bad input leaves an existing database as it was") {
  const Workspace w;
  REQUIRE(call("run " + cell + quick + "--db " + w.file("a.db")).exit_code == 0);
  const std::string before = verstat::test::read_file(w.file("a.db"));
  CHECK(call("run " + cell + " --set /machines/0/count=0 --db " + w.file("a.db")).exit_code == 2);
  CHECK(call("optimize " + study + " --set /tools/0/strategy/gamma=7 --db " + w.file("a.db")).exit_code == 2);
  CHECK(verstat::test::read_file(w.file("a.db")) == before);
}

TEST_CASE("a database that cannot be used is named, exit code 1") {
  const Workspace w;
  CHECK(call("runs --db " + w.file("none.db")).exit_code == 1);
  const Answer a = call("run " + cell + quick + "--db /no/such/folder/a.db");
  CHECK(a.exit_code == 1);
  CHECK_THAT(a.err, Catch::Contains("database /no/such/folder/a.db"));
  const Answer b = call("runs --run 1 --db README.md");
  CHECK(b.exit_code == 1);
  CHECK_THAT(b.err, Catch::Contains("README.md"));
}

TEST_CASE("the study finds the published optimum and confirms the saving") {
  const Workspace w;
  const Answer a = call("optimize " + study + quick + "--json --db " + w.file("a.db"));
  REQUIRE(a.exit_code == 0);
  const json j = json::parse(a.out);
  CHECK(j["best"]["values"][0]["value"].get<double>() == Approx(0.4703).epsilon(2e-4));
  CHECK(j["best"]["values"][1]["value"].get<double>() == Approx(46.97).epsilon(2e-4));
  CHECK(j["verdict"] == "better");
  CHECK(j["saving"]["mean"].get<double>() > j["saving"]["half_width"].get<double>());
  const json kept = json::parse(call("runs --study 1 --json --db " + w.file("a.db")).out);
  CHECK(kept["status"] == "finished");
  CHECK(kept["result"]["words"] == j["words"]);
  CHECK(kept["trials"] == kept["trial_list"].size());
}

TEST_CASE("reference points evaluated as a batch meet their values") {
  const Answer a = call("models eval --batch tests/catalogue/K117.json --source K117");
  REQUIRE(a.exit_code == 0);
  const json got = json::parse(a.out);
  const json points = json::parse(verstat::test::read_file("tests/catalogue/K117.json"));
  REQUIRE(got.size() == points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    INFO(points[k]["id"]);
    CHECK(got[k]["id"] == points[k]["id"]);
    REQUIRE(got[k].contains("outputs"));
    for (const auto& [name, value] : points[k]["outputs"].items()) {
      if (!value.is_number()) continue;
      const double tolerance = points[k].contains("abs_tol")
                                   ? points[k]["abs_tol"].get<double>()
                                   : points[k]["rel_tol"].get<double>() * std::abs(value.get<double>());
      CHECK(std::abs(got[k]["outputs"][name].get<double>() - value.get<double>()) <= tolerance + 1e-300);
    }
  }
}

TEST_CASE("a batch reports bad points one by one") {
  const Workspace w;
  std::ofstream(w.file("points.json")) << R"([
    {"id": "good", "function": "weibull_from_moments", "inputs": {"mean_min": 1, "cv": 1}},
    {"id": "bad", "function": "weibull_from_moments", "inputs": {"mean_min": -1, "cv": 1}},
    {"id": "none", "function": "no_such_function", "inputs": {}},
    7])";
  const Answer a = call("models eval --source K117 --batch " + w.file("points.json"));
  REQUIRE(a.exit_code == 0);
  const json got = json::parse(a.out);
  CHECK(got[0]["outputs"]["shape"].get<double>() == Approx(1));
  CHECK_THAT(got[1]["error"].get<std::string>(),
             Catch::Contains("K117.weibull_from_moments: mean_min = -1, allowed mean_min > 0"));
  CHECK_THAT(got[2]["error"].get<std::string>(), Catch::Contains("closest"));
  CHECK(got[3]["id"] == 3);
}

TEST_CASE("one model: shown, evaluated, refused") {
  CHECK(call("models show K117.part_cost").exit_code == 0);
  CHECK(json::parse(call("models show K117.part_cost --json").out)["source"]["id"] == "K117");
  const Answer good = call(R"(models eval K117.weibull_from_moments --inputs '{"mean_min": 60, "cv": 0.7}')");
  CHECK(json::parse(good.out)["shape"].get<double>() == Approx(1.451263666).epsilon(1e-8));
  const Answer bad = call(R"(models eval K117.weibull_from_moments --inputs '{"mean_min": 60, "cv": 7}')");
  CHECK(bad.exit_code == 2);
  CHECK_THAT(bad.err, Catch::Contains("K117.weibull_from_moments: cv = 7, allowed 0.05 <= cv <= 2"));
  CHECK(call("models show K117.part_coast").exit_code == 2);
  CHECK_THAT(call("models show K117.part_coast").err, Catch::Contains("K117.part_cost"));
}

TEST_CASE("the example at the end of every --help runs") {
  const Workspace w;
  for (const char* command :
       {"", "validate", "run", "compare", "sweep", "losses", "optimize", "plan", "models", "models list",
        "models search", "models show", "models eval", "schema"}) {
    INFO(command);
    const Answer help = call(std::string(command) + " --help");
    REQUIRE(help.exit_code == 0);
    const auto example = help.out.find("Example:");
    REQUIRE(example != std::string::npos);
    std::istringstream rest(help.out.substr(example));
    std::string line;
    std::getline(rest, line);
    std::getline(rest, line);
    line = line.substr(line.find("verstat ") + 8);
    if (const auto redirect = line.find(" > "); redirect != std::string::npos)
      line = line.substr(0, redirect);
    const std::string_view verb = std::string_view(line).substr(0, line.find(' '));
    const bool stores =
        verb == "run" || verb == "compare" || verb == "sweep" || verb == "losses" || verb == "optimize";
    if (stores) line += " --db " + w.file("help.db") + " --set /simulation/horizon_min=20000";
    if (stores && line.find("--replications") == std::string::npos) line += " --replications 2";
    const Answer answer = call(line);
    INFO(line << "\n" << answer.err);
    CHECK(answer.exit_code == 0);
    CHECK_FALSE(answer.out.empty());
  }
}

TEST_CASE("talk goes to standard error without colour when NO_COLOR is set or it is no terminal") {
  const Answer a = call("run none.json");
  CHECK(a.err.find('\033') == std::string::npos);
  CHECK(call("--version").out.starts_with("verstat "));
}

TEST_CASE("the version says what a report needs: the release, the compiler and the platform of the bits") {
  const std::string text = call("--version").out;
  CHECK(std::count(text.begin(), text.end(), '\n') == 2);
  for (const char* part :
       {"\nbuilt by g++ " __VERSION__, "Boost 1_81", "runs on x86-64", "glibc 2.", "SQLite 3."}) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  }
}
