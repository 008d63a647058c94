// fit and calibrate as a user meets them: answers, changes that run, errors in one line.
#include <algorithm>
#include <cstdlib>
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
  CHECK(j["library"][0]["entry"]["edge_life"]["cutting_speed_ref_m_min"] == 60);
  // The law that fits best is the law the scenario gets.
  CHECK(j["library"][0]["entry"]["edge_life"]["law"] == group["best"]["family"]);
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

TEST_CASE("log to library to run: every kind of entry, with where it comes from") {
  const Workspace w;
  const std::string library = w.file("library");
  const auto fit = [&](const std::string& arguments) {
    const Answer a = call("fit " + arguments + " --library " + library);
    INFO(arguments << "\n" << a.err);
    REQUIRE(a.exit_code == 0);
    CHECK_THAT(a.out, Contains("library entry in " + library));
  };
  fit("life " + examples + "removals.csv --tool T5K10 --speed 60 --feed 1 --depth 10");
  fit("taylor " + examples + "wear.csv");
  fit("downtime " + examples + "downtime.csv");
  fit("arrivals " + examples + "orders.csv --as profile");
  fit("cycle " + examples + "cycles.csv");
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(library)) {
    names.push_back(file.path().filename().string());
    const json entry = json::parse(read_file(file.path().string()));
    INFO(names.back());
    for (const char* member : {"file", "rows_used", "rows_in_file", "method", "date", "version"})
      CHECK(entry["provenance"].contains(member));
    CHECK(entry["provenance"]["rows_used"].get<int>() > 0);
    CHECK_FALSE(entry["provenance"]["method"].get<std::string>().empty());
  }
  std::sort(names.begin(), names.end());
  CHECK(std::count_if(names.begin(), names.end(), [](const auto& n) { return n.starts_with("insert-"); }) ==
        2);
  CHECK(std::count_if(names.begin(), names.end(), [](const auto& n) { return n.starts_with("duration-"); }) >=
        2);
  CHECK(std::count_if(names.begin(), names.end(), [](const auto& n) { return n.starts_with("failure-"); }) >=
        1);
  CHECK(std::find(names.begin(), names.end(), "supply-orders.json") != names.end());

  // From the library into a shop: the insert's life, the time of an operation, arrivals, a failure mode.
  const auto use = [&](const std::string& pointer, const std::string& name) {
    return " --use " + pointer + "='" + library + "/" + name + "'";
  };
  const auto named = [&](const std::string& start) {
    return *std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.starts_with(start); });
  };
  const std::string quick =
      " --replications 2 --set /simulation/horizon_min=30000 --json --db " + w.file("a.db");
  const Answer run = call("run " + cell + use("/inserts/0", "insert-T5K10.json") +
                          use("/tools/0/change/index", named("duration-")) + quick);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("removals.csv, 60 of 87 rows") && Contains("lognormal"));
  // The entry keeps what it does not speak of: the exponents and the name are the scenario's.
  CHECK_THAT(run.out, !Contains("/inserts/0/name") && !Contains("speed_exponent"));
  const Answer taylor = call("run " + cell + use("/inserts/0", named("insert-40")) + quick);
  INFO(taylor.err);
  CHECK(taylor.exit_code == 0);
  CHECK_THAT(taylor.out, Contains("/inserts/0/edge_life/speed_exponent"));
  const Answer supplied = call("run " + cell + use("/parts/0/supply", "supply-orders.json") + quick);
  INFO(supplied.err);
  CHECK(supplied.exit_code == 0);
  json failing = json::parse(read_file(cell));
  failing["machines"][0]["failures"] = {{{"name", "any"},
                                         {"time_to_failure", {{"kind", "constant"}, {"value_min", 1e6}}},
                                         {"repair", {{"kind", "constant"}, {"value_min", 1}}}}};
  std::ofstream(w.file("failing.json")) << failing.dump();
  const Answer failed =
      call("run " + w.file("failing.json") + use("/machines/0/failures/0", named("failure-")) + quick);
  INFO(failed.err);
  REQUIRE(failed.exit_code == 0);
  CHECK_THAT(failed.out, Contains("/machines/0/failures/0/clock"));

  for (const auto& [arguments, says] :
       {std::pair{"run " + cell + " --use /inserts/0", std::string("must be POINTER=FILE")},
        std::pair{"run " + cell + " --use /inserts/0=none.json", std::string("none.json")},
        std::pair{"run " + cell + " --use /inserts/0=" + cell, std::string("holds no library entry")},
        std::pair{"run " + cell + use("/machines/0", "insert-T5K10.json"),
                  std::string("/machines/0/edge_life")},
        std::pair{"fit life " + examples + "removals.csv --library " + library,
                  std::string("--speed, --feed and --depth")},
        std::pair{"fit cycle " + examples + "cycles.csv --library " + cell, std::string("is no folder")}}) {
    const Answer a = call(arguments);
    INFO(arguments << "\n" << a.err);
    CHECK(a.exit_code == 2);
    CHECK(a.out.empty());
    CHECK_THAT(a.err, Contains(says));
  }
}

TEST_CASE("cycle times that no law fits run as they were observed") {
  const Workspace w;
  {
    std::ofstream log(w.file("two-kinds.csv"));
    log << "Operation,Cycle time (min)\n";
    for (int k = 0; k < 120; ++k) log << "turning," << (k % 3 == 0 ? 9 : 3) + 0.01 * (k * 37 % 50) << "\n";
  }
  const Answer a = call("fit cycle " + w.file("two-kinds.csv") +
                        " --to /operations/0/process/time --json --out " + w.file("changes.json"));
  REQUIRE(a.exit_code == 0);
  const json value = json::parse(a.out)["patch"]["changes"][0]["value"];
  CHECK(value["kind"] == "empirical");
  // One machine that always has blanks makes one part per mean of the log.
  std::ofstream(w.file("shop.json")) << R"({"name": "one machine", "simulation": {"horizon_min": 110000,
    "warmup_min": 10000, "seed": "3"}, "machines": [{"name": "m"}], "operations": [{"name": "o", "machine": "m",
    "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 1}}}], "stores": [{"name": "s"}],
    "parts": [{"name": "p", "supply": {"kind": "always_available"}, "route": ["o"], "store": "s"}]})";
  const Answer run = call("run " + w.file("shop.json") + " --replications 4 --changes " +
                          w.file("changes.json") + " --json --db " + w.file("a.db"));
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  double mean = 0;
  for (int k = 0; k < 120; ++k) mean += ((k % 3 == 0 ? 9 : 3) + 0.01 * (k * 37 % 50)) / 120;
  CHECK(value["values_min"].size() > 50);
  const json result = json::parse(run.out);
  CHECK_THAT(run.out, Contains("empirical"));
  for (const json& kpi : result["kpis"])
    if (kpi["name"] == "throughput_per_h")
      CHECK(kpi["mean"].get<double>() == Approx(60 / mean).epsilon(0.03));
}

TEST_CASE("orders as they came and rates over the week become supplies that run") {
  const Workspace w;
  for (const std::string form : {"law", "profile", "orders"}) {
    const Answer a = call("fit arrivals " + examples + "orders.csv --as " + form +
                          " --to /parts/0/supply --json --out " + w.file("changes.json"));
    INFO(a.err);
    REQUIRE(a.exit_code == 0);
    const json j = json::parse(a.out);
    const json supply = j["patch"]["changes"][0]["value"];
    if (form == "orders") {
      double parts = 0;
      for (const json& order : supply["orders"]) parts += order["quantity"].get<double>();
      CHECK(parts ==
            Approx(j["quantity"]["mean"].get<double>() * static_cast<double>(supply["orders"].size())));
    }
    if (form == "profile") {
      // Expected arrivals of a week are those of the log.
      double week = 0;
      for (const json& period : supply["rates"])
        week +=
            period["per_h"].get<double>() * (period["to_h"].get<double>() - period["from_h"].get<double>());
      double logged = 0;
      for (const json& day : j["weekdays"]["slots"]) logged += 24 * day["rate_per_h"].get<double>();
      CHECK(week == Approx(logged).epsilon(0.02));
    }
    const Answer run =
        call("run " + cell + " --replications 2 --set /simulation/horizon_min=20000 --changes " +
             w.file("changes.json") + " --db " + w.file("a.db"));
    INFO(form << run.err);
    CHECK(run.exit_code == 0);
  }
}

TEST_CASE("an xlsx workbook is fitted as its sheet says") {
  if (std::system("xlsx2csv --version >/dev/null 2>&1") != 0) {
    WARN("xlsx2csv is not installed: reading workbooks is not tested");
    return;
  }
  const std::string book = "tests/data/removals.xlsx";
  const Answer a = call("fit life " + book + " --sheet Зняття --tool T5K10 --json");
  INFO(a.err);
  REQUIRE(a.exit_code == 0);
  json from_book = json::parse(a.out);
  const json from_table = json::parse(call("fit life " + examples + "removals.csv --tool T5K10 --json").out);
  CHECK(from_book["groups"] == from_table["groups"]);
  CHECK(from_book["table"]["dropped"] == from_table["table"]["dropped"]);
  CHECK(from_book["table"]["notes"][0] == "sheet \"Зняття\" of the workbook, converted by xlsx2csv");
  // The first sheet is a title page; dates come through with their time.
  CHECK_THAT(call("fit life " + book).err, Contains("no column for"));
  const Answer stops = call("fit downtime " + book + " --sheet Простої --json");
  REQUIRE(stops.exit_code == 0);
  CHECK(json::parse(stops.out)["modes"][0]["repair"]["mean_min"].get<double>() ==
        Approx(46.875).margin(0.02));
  const Answer none = call("fit life " + book + " --sheet Нема");
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err, Contains("finds no sheet \"Нема\""));
}

TEST_CASE("without the converter a workbook is refused with its name") {
  const Answer a = call("fit life tests/data/removals.xlsx", "env PATH=/nowhere");
  CHECK(a.exit_code == 2);
  CHECK_THAT(a.err, Contains("install the Debian package xlsx2csv"));
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
  // A time to failure takes its clock along.
  const json mode = json::parse(call("fit downtime " + examples +
                                     "downtime.csv --mode spindle --clock calendar --json --to-failure "
                                     "/machines/0/failures/0/time_to_failure")
                                    .out)["patch"]["changes"];
  REQUIRE(mode.size() == 2);
  CHECK(mode[0]["value"]["kind"] == "weibull");
  CHECK(mode[1] == json{{"pointer", "/machines/0/failures/0/clock"}, {"value", "calendar"}});
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
        Case{"fit arrivals " + examples + "orders.csv --as list",
             "--as list: must be law, profile or orders"},
        Case{"fit arrivals " + examples + "orders.csv --as profile --hours 07:30-15:00",
             "--hours must begin and end with an hour"},
        Case{"fit life " + examples + "removals.csv --sheet One", "is no xlsx workbook"},
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
