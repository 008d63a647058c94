// Studies as a user meets them: killed, interrupted, resumed; compared, swept, priced.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sys/mount.h>

#include "tests/e2e/command.h"

using nlohmann::json;
using verstat::test::Answer;
using verstat::test::call;
using verstat::test::read_file;
using verstat::test::Workspace;

namespace {

const std::string cell = "scenarios/gallery/heavy-lathe.json";
const std::string lathe_study = "scenarios/gallery/heavy-lathe.study.json";

// The gallery's study with stages two and three, on a short shop.
std::string noisy_study(const Workspace& w) {
  json study = json::parse(read_file(lathe_study));
  std::ofstream(w.file("cell.json")) << read_file(cell);
  study["scenario"] = "cell.json";
  study["changes"] = json::parse(
      R"([{"pointer": "/simulation/horizon_min", "value": 100000}, {"pointer": "/simulation/warmup_min", "value": 1000}])");
  study["search"]["max_evaluations"] = 400;
  study["simulation"] = {{"trials", 24}, {"first_replications", 4}, {"levels", 2}};
  study["choice"] = {{"finalists", 3}, {"first_replications", 6}, {"max_replications", 40}};
  study["confirmation"]["replications"] = 6;
  std::ofstream(w.file("noisy.study.json")) << study.dump(2);
  return w.file("noisy.study.json");
}

// The program on its own, so that it can be killed.
pid_t start(const std::string& arguments) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string line =
        "exec " + std::string(VERSTAT_PROGRAM) + " " + arguments + " >/dev/null 2>&1 </dev/null";
    ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  return child;
}
int ended(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

json stored(const Workspace& w, const std::string& db) {
  return json::parse(call("runs --study 1 --db " + w.file(db)).out);
}
// Trials in any order a database may give them, without numbers.
std::vector<std::string> trials(const json& study) {
  std::vector<std::string> all;
  for (json t : study["trial_list"]) {
    t.erase("number");
    all.push_back(t.dump());
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("a study killed again and again ends with the trials and the answer of one that was not") {
  const Workspace w;
  const std::string file = noisy_study(w);
  const auto begin = std::chrono::steady_clock::now();
  const Answer whole = call("optimize " + file + " --json --db " + w.file("whole.db"));
  REQUIRE(whole.exit_code == 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::string killed_db = " --db " + w.file("killed.db");

  // VERSTAT_KILLS=20 test_e2e "a study killed*" does it as often as the promise says.
  const char* const asked = std::getenv("VERSTAT_KILLS");
  const int wanted = asked == nullptr ? 5 : std::stoi(asked);
  unsigned random = 12345;
  int kills = 0;
  for (int k = 0; k < 3 * wanted && kills < wanted; ++k) {
    const pid_t child = start("optimize " + (k == 0 ? file : std::string("--resume 1")) + killed_db);
    // The first one at least until there is something to resume.
    for (int wait = 0; k == 0 && wait < 1000; ++wait) {
      if (call("runs --study 1" + killed_db).exit_code == 0) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    random = random * 1103515245U + 12345U;
    const double share = static_cast<double>(random >> 16U) / 65536.0;
    // Every start costs some time of its own; together they leave something to do for the last.
    const double most = k == 0 ? 0.3 * seconds : 0.05 + 1.2 * seconds / wanted;
    std::this_thread::sleep_for(std::chrono::duration<double>(most * share));
    ::kill(child, SIGKILL);
    kills += ended(child) == 128 + SIGKILL ? 1 : 0;
    if (k == 0) REQUIRE(stored(w, "killed.db")["status"] == "interrupted");
    if (stored(w, "killed.db")["status"] == "finished") break;
  }
  CHECK(kills >= 1);  // the first always lands; on an idle machine the study may be through before the last
  const Answer rest = call("optimize --resume 1 --json" + killed_db);
  REQUIRE(rest.exit_code == 0);
  const auto answer = [](const std::string& text) {
    json j = json::parse(text);
    // A kill between a run and the note of it leaves the run behind: numbers may differ.
    j.erase("baseline_run");
    j.erase("best_run");
    return j;
  };
  CHECK(answer(rest.out) == answer(whole.out));
  const json a = stored(w, "whole.db");
  const json b = stored(w, "killed.db");
  CHECK(a["status"] == "finished");
  CHECK(b["status"] == "finished");
  CHECK(trials(a) == trials(b));
  CHECK(b["trials"] == b["trial_list"].size());
  // Finished, it is only read again.
  const Answer again = call("optimize --resume 1 --json" + killed_db);
  CHECK(again.out == rest.out);
  CHECK(stored(w, "killed.db")["trials"] == b["trials"]);
}

TEST_CASE("a disk that fills up in the middle of a study: said in words, nothing lost, and it goes on") {
  const Workspace w;
  const std::string file = noisy_study(w);
  const Answer whole = call("optimize " + file + " --progress none --json --db " + w.file("whole.db"));
  REQUIRE(whole.exit_code == 0);
  // Files that may not grow beyond some blocks: without the rights to mount a disk of that size, too.
  for (const char* blocks : {"300", "700"}) {
    const std::string db = w.file(std::string("full") + blocks + ".db");
    const Answer full = call("optimize " + file + " --progress none --json --db " + db,
                             std::string("ulimit -f ") + blocks + ";");
    INFO(full.err);
    REQUIRE(full.exit_code == 1);
    CHECK(full.err.find("database " + db) != std::string::npos);
    CHECK(
        full.err.find("finished trials of study 1 are kept: when there is room, go on with verstat optimize "
                      "--resume 1 --db " +
                      db) != std::string::npos);
    const json half = json::parse(call("runs --study 1 --db " + db).out);
    CHECK(half["trial_list"].size() > 3);
    CHECK(half["status"] == "interrupted");
    const Answer rest = call("optimize --resume 1 --progress none --json --db " + db);
    REQUIRE(rest.exit_code == 0);
    CHECK(rest.out == whole.out);
    CHECK(trials(json::parse(call("runs --study 1 --db " + db).out)) == trials(stored(w, "whole.db")));
  }
  // A disk of its own.
  const std::string disk = w.file("disk");
  std::filesystem::create_directories(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=600k") != 0) {
    WARN("a small disk is not tested here: mounting one needs root");
    return;
  }
  const std::string db = disk + "/night.db";
  const Answer full = call("optimize " + file + " --progress none --json --db " + db);
  CHECK(full.exit_code == 1);
  CHECK(full.err.find("full") != std::string::npos);
  CHECK(full.err.find("--resume 1") != std::string::npos);
  CHECK(::mount("tmpfs", disk.c_str(), "tmpfs", MS_REMOUNT, "size=20m") == 0);
  const Answer rest = call("optimize --resume 1 --progress none --json --db " + db);
  CHECK(rest.out == whole.out);
  ::umount2(disk.c_str(), MNT_DETACH);
}

TEST_CASE("Ctrl-C ends a study with the best so far, and it goes on later") {
  const Workspace w;
  json study = json::parse(read_file(noisy_study(w)));
  study["changes"][0]["value"] = 2'000'000;  // long enough to be interrupted for certain
  study["simulation"]["trials"] = 400;
  std::ofstream(w.file("long.study.json")) << study.dump();
  const std::string db = " --db " + w.file("a.db");
  const pid_t child = start("optimize " + w.file("long.study.json") + db);
  for (int k = 0; k < 600; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Answer a = call("runs --study 1" + db);
    if (a.exit_code == 0 && a.out.find("\"simulation\",\n") != std::string::npos) break;
  }
  ::kill(child, SIGINT);
  CHECK(ended(child) == 130);
  const json s = stored(w, "a.db");
  CHECK(s["status"] == "interrupted");
  CHECK(s["result"]["interrupted"] == "interrupted");
  CHECK(s["result"]["words"].get<std::string>().find("--resume 1") != std::string::npos);
  // A time budget ends it likewise, and says so.
  const Answer timed = call("optimize --resume 1 --time 0.2 --json" + db);
  CHECK(timed.exit_code == 0);
  CHECK(json::parse(timed.out)["interrupted"] == "the time budget of 0.2 s is used up");
}

TEST_CASE("progress for programs is one JSON object per line") {
  const Workspace w;
  const Answer a = call("optimize " + noisy_study(w) + " --progress json --db " + w.file("a.db"));
  REQUIRE(a.exit_code == 0);
  std::istringstream lines(a.err);
  std::set<std::string> stages;
  for (std::string line; std::getline(lines, line);) {
    const json j = json::parse(line);
    stages.insert(j.at("stage").get<std::string>());
    CHECK(j.at("study") == 1);
    CHECK(j.contains("best"));
    CHECK(j.contains("left_s"));
  }
  CHECK(stages == std::set<std::string>{"analytic", "simulation", "choice", "confirmation"});
}

TEST_CASE("the best plan is a scenario file that gives the promised run") {
  const Workspace w;
  const std::string plan = w.file("plan.json");
  const Answer a = call("optimize " + lathe_study +
                        " --set /simulation/horizon_min=30000 --replications 4 --json --write-plan " + plan +
                        " --db " + w.file("a.db"));
  REQUIRE(a.exit_code == 0);
  const json answer = json::parse(a.out);
  const json text = json::parse(read_file(plan));
  for (const json& change : answer["plan"])
    CHECK(text.at(json::json_pointer(change["pointer"].get<std::string>())) == change["value"]);
  CHECK(text["simulation"]["horizon_min"] == 30000);
  CHECK(call("validate " + plan).exit_code == 0);
  // The stored best run can be computed again from the plan and the seed beside it.
  const json best =
      json::parse(call("runs --json --run " + answer["best_run"].dump() + " --db " + w.file("a.db")).out);
  const json again = json::parse(call("run " + plan + " --json --seed " + best["seed"].get<std::string>() +
                                      " --replications 4 --db " + w.file("b.db"))
                                     .out);
  CHECK(again["kpis"] == best["kpis"]);
}

TEST_CASE("compare says what differs, and only then") {
  const Workspace w;
  const std::string quick = " --set /simulation/horizon_min=30000 --json --db " + w.file("a.db");
  const Answer a =
      call("compare " + cell + " --variant 'gamma 0.47: /tools/0/strategy/gamma=0.47; " +
           "/operations/0/process/cutting_speed_m_min=47' --variant 'same: /tools/0/name=roughing\\ tool'" +
           quick);
  INFO(a.err);
  REQUIRE(a.exit_code == 2);  // a name with a backslash is no tool of the operations
  const Answer b =
      call("compare " + cell + " --variant 'gamma 0.47: /tools/0/strategy/gamma=0.47; " +
           "/operations/0/process/cutting_speed_m_min=47' --variant 'same: /description=as it is'" + quick);
  INFO(b.err);
  REQUIRE(b.exit_code == 0);
  const json j = json::parse(b.out);
  CHECK(j["clear"] == true);
  CHECK(j["variants"][1]["differences"][0]["verdict"] == "less");
  CHECK(j["variants"][1]["words"].get<std::string>().find("gamma 0.47 costs ") == 0);
  CHECK(j["variants"][2]["differences"][0]["verdict"] == "unchanged");
  CHECK(j["variants"][2]["differences"][0]["difference"]["mean"] == 0.0);
  CHECK(json::parse(call("runs --study 1 --db " + w.file("a.db")).out)["kind"] == "compare");
  // In words as an engineer says it, and names as long as they are.
  CHECK(std::regex_match(
      j["variants"][1]["words"].get<std::string>(),
      std::regex(
          "gamma 0\\.47 costs [0-9.]+ \\+- [0-9.]+ % less per part; throughput is [0-9.]+ \\+- [0-9.]+ % "
          "(higher|lower)\\.")));
  CHECK(j["variants"][2]["words"] == "same costs the same per part; throughput is unchanged.");
  const Answer text = call("compare " + cell +
                           " --variant 'a name of more than twenty-two letters: "
                           "/tools/0/strategy/gamma=0.47' --kpi cost_per_part --kpi "
                           "'tool/roughing tool/failure_share' --set /simulation/horizon_min=30000 --db " +
                           w.file("a.db"));
  CHECK(text.out.find(cell + "  a name of more than twenty-two letters  ") != std::string::npos);
  CHECK(text.out.find("failure share of roughing tool is") != std::string::npos);
  CHECK(call("compare " + cell).exit_code == 2);
  CHECK(call("compare " + cell + " --variant nonsense").exit_code == 2);
  CHECK(call("compare " + cell + " " + cell + " --kpi beauty").exit_code == 2);
}

TEST_CASE("sweeps: effects with the signs of the shop, any design, resumed when they were stopped") {
  const Workspace w;
  const std::string quick = " --set /simulation/horizon_min=12000 --replications 3 --json --db ";
  const std::string factors =
      " --factor /tools/0/failure_damage=20..80 --factor /crews/0/members=1..2 --factor "
      "/tools/0/insert_booking=life_periods,at_fitting";
  const Answer a = call("sweep " + cell + factors + quick + w.file("a.db"));
  INFO(a.err);
  REQUIRE(a.exit_code == 0);
  const json j = json::parse(a.out);
  CHECK(j["points"].size() == 8);
  const json effects = j["kpis"][0]["effects"];
  REQUIRE(effects.size() == 6);
  CHECK(effects[0]["effect"] == "/tools/0/failure_damage");
  CHECK(effects[0]["value"].get<double>() > 0);  // damage costs
  CHECK(effects[1]["value"].get<double>() < 0);  // a second setter saves waiting
  CHECK(j["points"][0]["values"] == json::parse(R"([20.0, 1, "life_periods"])"));
  for (const std::string design : {"fractional", "lhs --points 6", "sobol --points 4", "tornado"}) {
    INFO(design);
    const Answer b = call("sweep " + cell + factors + " --design " + design + quick + w.file("b.db"));
    REQUIRE(b.exit_code == 0);
  }
  CHECK(json::parse(call("sweep " + cell + factors + " --design tornado" + quick + w.file("b.db"))
                        .out)["kpis"][0]["tornado"]
            .size() == 3);
  CHECK(
      call("sweep " + cell + " --factor /tools/0/strategy/gamma=0.5..2" + quick + w.file("c.db")).exit_code ==
      2);
  // Names of any length stand apart.
  const Answer wide =
      call("sweep " + cell + factors +
           " --kpi 'tool/roughing tool/inserts_per_100_parts' --kpi 'tool/roughing "
           "tool/insert_cycle_availability' --set /simulation/horizon_min=12000 --replications 2 --db " +
           w.file("b.db"));
  CHECK(wide.out.find(
            "tool/roughing tool/inserts_per_100_parts  tool/roughing tool/insert_cycle_availability") !=
        std::string::npos);
  CHECK(call("sweep " + cell + " --factor gamma" + quick + w.file("c.db")).exit_code == 2);
  CHECK(call("sweep " + cell + factors + " --design magic" + quick + w.file("c.db")).exit_code == 2);
  CHECK_FALSE(std::filesystem::exists(w.file("c.db")));  // nothing half-written
  // Stopped and resumed: the points of before are not simulated again, and the answer is that of the whole.
  const std::string long_sweep =
      "sweep " + cell + factors + " --set /simulation/horizon_min=600000 --replications 3 --json --db ";
  const pid_t child = start(long_sweep + w.file("d.db"));
  for (int k = 0; k < 600; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const Answer s = call("runs --study 1 --db " + w.file("d.db"));
    if (s.exit_code == 0 && json::parse(s.out)["trials"] >= 2) break;
  }
  ::kill(child, SIGKILL);
  (void)ended(child);
  const json rest = json::parse(call("sweep --resume 1 --json --db " + w.file("d.db")).out);
  CHECK(rest == json::parse(call(long_sweep + w.file("e.db")).out));
}

TEST_CASE("an objective of the catalogue: K117's rational gamma from the command line") {
  const Workspace w;
  std::ofstream(w.file("cell.json")) << read_file(cell);
  std::ofstream(w.file("f.study.json")) << R"({"name": "rational gamma", "scenario": "cell.json",
    "variables": [{"name": "gamma", "pointer": "/tools/0/strategy/gamma", "low": 0.4, "high": 0.99}],
    "objective": {"function": "K117.part_cost_at_gamma", "output": "part_cost",
                  "inputs": {"gamma": {"pointer": "/tools/0/strategy/gamma"}, "accounting": "renewal"}}})";
  const Answer a = call("optimize " + w.file("f.study.json") + " --json --db " + w.file("a.db"));
  INFO(a.err);
  REQUIRE(a.exit_code == 0);
  const json j = json::parse(a.out);
  CHECK(j["verdict"] == "computed");
  CHECK(j["best"]["values"][0]["value"].get<double>() == Approx(0.775).margin(0.0006));
  CHECK(j["objective"] == "part_cost of K117.part_cost_at_gamma");
  const Answer wrong =
      call("optimize " + w.file("f.study.json") + " --set /tools/0/strategy/gamm=1 --db " + w.file("a.db"));
  CHECK(wrong.exit_code == 2);
}

TEST_CASE("the price list of losses is in order and has the right signs") {
  const Workspace w;
  const Answer a = call("losses " + cell +
                        " --set /simulation/horizon_min=60000 --replications 6 --loss 'dear inserts: "
                        "/inserts/0/price=0' --json --db " +
                        w.file("a.db"));
  INFO(a.err);
  REQUIRE(a.exit_code == 0);
  const json j = json::parse(a.out);
  std::map<std::string, json> by_name;
  double before = 1e300;
  for (const json& loss : j["losses"]) {
    by_name[loss["name"]] = loss;
    CHECK(loss["saving_per_good_part"]["mean"].get<double>() <= before);
    before = loss["saving_per_good_part"]["mean"].get<double>();
  }
  REQUIRE(by_name.size() == 5);
  for (const char* name : {"failures of roughing tool", "changes of roughing tool", "waiting for setter",
                           "scrap after failures of roughing tool", "dear inserts"}) {
    INFO(name);
    CHECK(by_name.at(name)["saving_per_good_part"]["mean"].get<double>() > 0);
  }
  // Free inserts make no parts; and the saving is the inserts of one part.
  CHECK(by_name["dear inserts"]["parts"]["mean"] == 0.0);
  CHECK(by_name["changes of roughing tool"]["parts"]["mean"].get<double>() > 0);
}
