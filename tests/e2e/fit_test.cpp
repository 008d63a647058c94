// fit and calibrate as a user meets them: answers, changes that run, errors in one line.
#include <algorithm>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"

using Catch::Contains;
using nlohmann::json;
using verstat::test::Answer;
using verstat::test::call;
using verstat::test::read_file;
using verstat::test::Workspace;

namespace {

const std::string examples = "docs/examples/fit/";
const std::string cell = "scenarios/gallery/heavy-lathe.json";

}  // namespace

TEST_CASE("a removal log becomes changes, and the changes run") {
  const Workspace w;
  const std::string fit =
      "fit life " + examples + "removals.csv --tool T5K10 --speed 60 --feed 1 --depth 10 ";
  const Answer a = call(fit + "--to /inserts/0 --json --out " + w.file("changes.json"));
  REQUIRE(a.exit_code == 0);
  const json j = json::parse(a.out);
  // Every row of the file is used, named, or of another tool.
  CHECK(j["table"]["rows_in_file"] == 87);
  CHECK(j["table"]["rows_used"] == 60);
  CHECK(j["table"]["dropped"].size() == 3);
  CHECK(j["table"]["dropped"][0]["line"] == 12);
  const json& group = j["groups"][0];
  CHECK(group["laws"].size() == 5);
  CHECK(group["weibull_plot"]["points"].size() == group["failures"]);
  for (std::size_t k = 1; k < 5; ++k) CHECK(group["laws"][k - 1]["aicc"] <= group["laws"][k]["aicc"]);
  const json& t = group["best"]["gamma_percent_life"];
  CHECK(t["low"] < t["estimate"]);
  CHECK(t["estimate"] < t["high"]);
  CHECK(group["causes"].size() == 2);
  CHECK(group["batches"]["ratios"].size() == 2);
  CHECK(j["library_entry"]["edge_life"]["cutting_speed_ref_m_min"] == 60);
  CHECK_THAT(j["provenance"]["method"].get<std::string>(), Contains("30 failures of 60 edges"));

  const json patch = json::parse(read_file(w.file("changes.json")));
  CHECK(patch == j["patch"]);
  const Answer run = call("run " + cell + " --replications 2 --set /simulation/horizon_min=30000 --changes " +
                          w.file("changes.json") + " --json --db " + w.file("a.db"));
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("mean_ref_min") && Contains("removals.csv, 60 of 87 rows"));
  // The same answer again, but for the date.
  json again = json::parse(call(fit + "--to /inserts/0 --json").out);
  CHECK(again["groups"] == j["groups"]);
}

TEST_CASE("the example at the end of every fit --help runs") {
  for (const char* command : {"fit", "fit life", "fit taylor", "fit downtime", "fit arrivals", "fit cycle",
                              "fit value", "calibrate"}) {
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
    if (line.starts_with("calibrate")) line += " --points 40 --rounds 1";
    const Answer answer = call(line);
    INFO(line << "\n" << answer.err);
    CHECK(answer.exit_code == 0);
    CHECK_FALSE(answer.out.empty());
    CHECK_THAT(answer.out, !Contains(" nan") && !Contains("(nan"));
    const Answer as_json = call(line + " --json");
    CHECK(json::parse(as_json.out).contains("provenance"));
  }
}

TEST_CASE("wear curves, stops, orders and cycles become changes that the loader takes") {
  const Workspace w;
  const std::vector<std::string> fits = {
      "taylor " + examples + "wear.csv --to /inserts/0",
      "arrivals " + examples + "orders.csv --to /parts/0/supply",
      "downtime " + examples + "downtime.csv --mode chuck --to-repair /tools/0/change/index",
      "cycle " + examples + "cycles.csv --operation turning --to /tools/0/change/replace"};
  for (const std::string& one : fits) {
    INFO(one);
    const Answer a = call("fit " + one + " --json --out " + w.file("changes.json"));
    REQUIRE(a.exit_code == 0);
    const Answer run =
        call("run " + cell + " --replications 1 --set /simulation/horizon_min=20000 --changes " +
             w.file("changes.json") + " --db " + w.file("a.db"));
    INFO(run.err);
    CHECK(run.exit_code == 0);
  }
  // The exponents that made the wear readings were 3.2 and 1.1.
  const json j = json::parse(call("fit taylor " + examples + "wear.csv --json --to /inserts/0").out);
  const json& exponents = j["groups"][0]["fits"][0]["exponents"];
  CHECK(exponents[0]["bounds"]["low"] < 3.2);
  CHECK(exponents[0]["bounds"]["high"] > 3.2);
  CHECK(exponents[1]["bounds"]["low"] < 1.1);
  CHECK(exponents[1]["bounds"]["high"] > 1.1);
  CHECK(exponents[2].contains("not_fitted"));
}

TEST_CASE("fit and calibrate: bad input is one clear line, exit code 2, nothing written") {
  const Workspace w;
  std::ofstream(w.file("book.xlsx")) << "PK\x03\x04";
  std::ofstream(w.file("totals.json"))
      << R"({"counted_hours": 10, "totals": [{"kpi": "parts_good", "value": 9}]})";
  std::ofstream(w.file("odd.json")) << R"([{"pointer": "/name"}])";
  std::ofstream(w.file("none.csv")) << "Minutes,Cause\n30,planned\n";
  struct Case {
    std::string arguments, says;
  };
  for (const Case& c :
       {Case{"fit life none/such.csv", "none/such.csv"},
        Case{"fit life " + w.file("book.xlsx"), "xlsx2csv"},
        Case{"fit life " + w.file("none.csv"), "no failure"},
        Case{"fit life " + examples + "removals.csv --gamma 1.5",
             "--gamma 1.5: must be a number from 0.001 to 0.999"},
        Case{"fit life " + examples + "removals.csv --gamma nan", "--gamma nan"},
        Case{"fit life " + examples + "removals.csv --seed 1.5", "--seed 1.5: must be a whole number"},
        Case{"fit life " + examples + "removals.csv --to /inserts/0", "several tools or regimes"},
        Case{"fit life " + examples + "removals.csv --duplicates maybe", "--duplicates maybe"},
        Case{"fit life " + examples + "removals.csv --separator pipe", "--separator pipe: must be one of"},
        Case{"fit life " + examples + "removals.csv --column life", "--column life: must be ROLE=HEADER"},
        Case{"fit life " + examples + "removals.csv --tool T5K10 --out " + w.file("x.json"),
             "there are no changes"},
        Case{"fit taylor " + examples + "wear.csv --at 100,2", "--at 100,2: must be SPEED,FEED,DEPTH"},
        Case{"fit taylor tests/data/turning_wear.csv --to /inserts/0", "49 pairs of material and tool"},
        Case{"fit downtime " + examples + "downtime.csv --clock cutting",
             "--clock cutting: the log has no column"},
        Case{"fit downtime " + examples + "downtime.csv --to-repair /x", "several modes"},
        Case{"fit downtime " + examples + "downtime.csv --from soon", "--from soon: must be a time"},
        Case{"fit value " + examples + "removals.csv --plans " + w.file("odd.json"), "must be an object"},
        Case{"calibrate " + cell + " --totals " + w.file("totals.json"), "names no uncertain input"},
        Case{"calibrate " + cell + " --totals " + w.file("totals.json") + " --uncertain /nothing=1..2",
             "no such member"},
        Case{"calibrate " + cell + " --totals " + w.file("totals.json") + " --uncertain /tools/0=2",
             "POINTER=LOW..HIGH"},
        Case{"run " + cell + " --changes " + w.file("odd.json"), "change 0 must be"},
        Case{"run " + cell + " --changes no/file.json", "--changes no/file.json: cannot be read"}}) {
    INFO(c.arguments);
    const Answer a = call(c.arguments);
    CHECK(a.exit_code == 2);
    CHECK(a.out.empty());
    CHECK(a.err.starts_with("error: "));
    CHECK(std::count(a.err.begin(), a.err.end(), '\n') == 1);
    CHECK_THAT(a.err, Contains(c.says));
  }
  CHECK_FALSE(std::filesystem::exists(w.file("x.json")));
}
