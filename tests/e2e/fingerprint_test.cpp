// Every bit of every KPI of the gallery, and the order of all events behind them. A change here is a change
// of results: it goes into tests/e2e/fingerprints.txt together with a line of CHANGELOG.md that says why.
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"

using nlohmann::json;
using namespace verstat::test;
namespace fs = std::filesystem;

namespace {

struct Kept {
  std::string platform;
  std::map<std::string, std::string> line;  // by scenario
};

// "# platform: x86-64 ..." and then "name fingerprint events" per line.
Kept kept_fingerprints() {
  Kept kept;
  std::istringstream in(read_file("tests/e2e/fingerprints.txt"));
  const std::string mark = "# platform: ";
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(mark)) kept.platform = line.substr(mark.size());
    if (line.empty() || line[0] == '#') continue;
    kept.line[line.substr(0, line.find(' '))] = line;
  }
  return kept;
}

}  // namespace

TEST_CASE("the gallery gives the results that the changelog knows of") {
  const Kept kept = kept_fingerprints();
  const Workspace w;
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator("scenarios/gallery")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".json" || name.ends_with(".study")) continue;
    const Answer a =
        call("run " + entry.path().string() + " --replications 2 --check --json --db " + w.file("a.db"));
    INFO(name << ": " << a.err);
    REQUIRE(a.exit_code == 0);
    const json j = json::parse(a.out);
    CHECK(j["check"]["broken_laws"] == 0);
    CHECK(j["check"]["events"].get<std::int64_t>() > 1000);
    ++seen;
    const std::string line = name + " " + j["check"]["fingerprint"].get<std::string>() + " " +
                             std::to_string(j["check"]["events"].get<std::int64_t>());
    if (j["provenance"]["platform"] != kept.platform) {
      WARN("kept for " << kept.platform << ", not compared on " << j["provenance"]["platform"]);
      return;
    }
    REQUIRE(kept.line.contains(name));
    CHECK(line == kept.line.at(name));
  }
  CHECK(seen == kept.line.size());
}

TEST_CASE("a fingerprint does not depend on threads, and one changed bit of input shows in it") {
  const Workspace w;
  const auto fingerprint = [&](const std::string& more) {
    const Answer a = call(
        "run scenarios/gallery/pump-shop.json --set /simulation/horizon_min=40000 --replications 3 "
        "--check --json --db " +
        w.file("a.db") + " " + more);
    REQUIRE(a.exit_code == 0);
    return json::parse(a.out)["check"]["fingerprint"].get<std::string>();
  };
  const std::string first = fingerprint("--threads 1");
  CHECK(first.size() == 16);
  CHECK(fingerprint("--threads 3") == first);
  CHECK(fingerprint("--seed 7") != first);
  CHECK(fingerprint("--set /parts/0/value=0.0000001") != first);
}

TEST_CASE("checks change no result") {
  const Workspace w;
  const std::string run =
      "run scenarios/gallery/mixed-plant.json --set /simulation/horizon_min=30000 --replications 2 "
      "--json --db " +
      w.file("a.db");
  const json plain = json::parse(call(run).out);
  const json checked = json::parse(call(run + " --check").out);
  CHECK(plain["kpis"] == checked["kpis"]);
  CHECK_FALSE(plain.contains("check"));
  const Answer words = call(
      "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=30000 --replications 2 "
      "--check --db " +
      w.file("a.db"));
  CHECK_THAT(words.out, Catch::Contains("every law of conservation holds in 2 replications; fingerprint "));
}
