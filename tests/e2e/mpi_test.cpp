// The same study on several ranks of one machine: the same bits, also when a rank dies.
#ifdef VERSTAT_MPI_PROGRAM

#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"

using nlohmann::json;
using verstat::test::Answer;
using verstat::test::call;
using verstat::test::read_file;
using verstat::test::Workspace;

namespace {

std::string study_file(const Workspace& w, double horizon_min) {
  json study = json::parse(read_file("scenarios/gallery/heavy-lathe.study.json"));
  std::ofstream(w.file("cell.json")) << read_file("scenarios/gallery/heavy-lathe.json");
  study["scenario"] = "cell.json";
  study["changes"] = {{{"pointer", "/simulation/horizon_min"}, {"value", horizon_min}},
                      {{"pointer", "/simulation/warmup_min"}, {"value", 1000}}};
  study["search"]["max_evaluations"] = 300;
  study["simulation"] = {{"trials", 12}, {"first_replications", 4}, {"levels", 2}};
  study["choice"] = {{"finalists", 2}, {"first_replications", 6}, {"max_replications", 12}};
  study["confirmation"]["replications"] = 6;
  std::ofstream(w.file("s.study.json")) << study.dump(2);
  return w.file("s.study.json");
}

std::string mpirun(int ranks, const std::string& options, const std::string& arguments) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
         "OMPI_MCA_btl_vader_single_copy_mechanism=none "
         "timeout -k 5 100 mpirun --oversubscribe --bind-to none -n " +
         std::to_string(ranks) + " " + options + " " + VERSTAT_MPI_PROGRAM + " " + arguments;
}

Answer shell(const std::string& line, const Workspace& w) {
  Answer a;
  const int status =
      std::system((line + " >" + w.file("out") + " 2>" + w.file("err") + " </dev/null").c_str());
  a.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  a.out = read_file(w.file("out"));
  a.err = read_file(w.file("err"));
  return a;
}

}  // namespace

TEST_CASE("results do not depend on the number of ranks") {
  const Workspace w;
  const std::string study = "optimize " + study_file(w, 10'000) + " --progress none --json --db ";
  const Answer alone = call(study + w.file("alone.db"));
  REQUIRE(alone.exit_code == 0);
  for (const int ranks : {1, 2, 4}) {
    INFO(ranks << " ranks");
    const Answer a = shell(mpirun(ranks, "", study + w.file(std::to_string(ranks) + ".db")), w);
    INFO(a.err);
    REQUIRE(a.exit_code == 0);
    CHECK(json::parse(a.out) == json::parse(alone.out));
  }
}

TEST_CASE("the work of a rank that dies is done by the others") {
  const Workspace w;
  const std::string study = "optimize " + study_file(w, 300'000) + " --progress none --json --db ";
  const Answer alone = call(study + w.file("alone.db"));
  REQUIRE(alone.exit_code == 0);
  // One of the ranks ends without a word as soon as simulation has begun.
  const std::string script = mpirun(4, "--enable-recovery", study + w.file("killed.db")) + " >" +
                             w.file("out") + " 2>" + w.file("err") +
                             " </dev/null & job=$!; for k in $(seq 1 200); do sleep 0.05; " +
                             VERSTAT_PROGRAM + " runs --study 1 --db " + w.file("killed.db") +
                             " 2>/dev/null | grep -q '\"simulation\",' && break; done; kill -9 $(pgrep -P "
                             "$(pgrep -P $job) | tail -1); "
                             "wait $job";
  std::ofstream(w.file("kill.sh")) << script;
  (void)std::system(("sh " + w.file("kill.sh") + " >/dev/null 2>&1").c_str());
  INFO(read_file(w.file("err")));
  CHECK(json::parse(read_file(w.file("out"))) == json::parse(alone.out));
}

#endif
