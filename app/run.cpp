// verstat run: simulate a scenario and keep the result.
#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/progress.h"
#include "app/results.h"
#include "sim/shop/fingerprint.h"
#include "store/database.h"
#include "store/result_json.h"

namespace verstat::app {

namespace {

// Nothing is stored: a result that breaks a law is wrong, whatever it says.
[[noreturn]] void report_broken_laws(const std::vector<std::string>& laws) {
  constexpr std::size_t shown = 20;
  std::string text = fmt::format("{} laws of conservation do not hold, nothing was stored:", laws.size());
  for (std::size_t k = 0; k < std::min(laws.size(), shown); ++k) text += (k == 0 ? " " : "; ") + laws[k];
  if (laws.size() > shown) text += fmt::format("; and {} more", laws.size() - shown);
  throw std::runtime_error(text);
}

void report_standstills(const shop::RunResult& result) {
  if (result.standstills.empty()) return;
  fmt::print(stderr,
             "warning: machines stand for good in {} of {} replications; {}. Give them more room "
             "(queue_capacity, capacity of stores), let fewer batches in (release) or have more people\n",
             result.standstills.size(), result.values.size(), result.standstills.front());
}

// The fingerprint holds every bit of every KPI of every replication, the number of events and their order.
nlohmann::ordered_json check_of(const shop::RunResult& result) {
  shop::Fingerprint all;
  for (const shop::KpiInfo& kpi : result.kpis) all.add(std::string_view(kpi.name));
  for (const auto& replication : result.values)
    for (const auto& value : replication) {
      all.add(static_cast<std::uint64_t>(value.has_value()));
      all.add(value.value_or(0.0));
    }
  all.add(result.events);
  all.add(result.event_order.value_or(0));
  return {{"broken_laws", result.broken_laws.size()},
          {"events", result.events},
          {"fingerprint", fmt::format("{:016x}", all.value())}};
}

}  // namespace

void add_run(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  auto label = std::make_shared<std::string>("run");
  CLI::App* command = program.add_subcommand("run", "Simulate a scenario and store its KPIs");
  command->add_option("SCENARIO", *file, "scenario file (JSON)")->required();
  command->add_option("--label", *label, "a name to find the run by")->capture_default_str();
  auto check = std::make_shared<bool>(false);
  command->add_flag(
      "--check", *check,
      "check the laws of conservation after every replication and print the fingerprint of the run");
  add_json(*command, *options);
  add_db(*command, *options);
  add_run_options(*command, *options);
  command->footer(
      "Example:\n  verstat run scenarios/gallery/heavy-lathe.json --set /tools/0/strategy/gamma=0.47 "
      "--replications 10\n"
      "Every mean comes with the half-width of its 95 % confidence interval.");
  command->callback([options, file, label, check] {
    const auto changes = changes_of(*options);
    const LoadedScenario loaded = load_scenario(*file, changes);
    const auto warned = scenarios::warnings(loaded.scenario);
    print_warnings(warned);
    const int threads = thread_count(*options);
    const auto start = std::chrono::steady_clock::now();
    shop::RunResult result;
    {
      ProgressBar bar("replications");
      result = shop::run_scenario(
          loaded.scenario, threads, [&](std::int64_t done, std::int64_t of) { bar.update(done, of); },
          *check ? shop::Checks::on : shop::Checks::off);
    }
    if (!result.broken_laws.empty()) report_broken_laws(result.broken_laws);
    report_standstills(result);
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    store::Run run = record_of(result, loaded, changes, *label, elapsed_s);
    run.header.id = store::Writer(options->db).add_run(run);
    if (options->json) {
      nlohmann::ordered_json answer = store::to_json(run);
      if (!warned.empty()) answer["warnings"] = scenarios::to_json(warned);
      if (!result.standstills.empty()) answer["standstills"] = result.standstills;
      if (*check) answer["check"] = check_of(result);
      fmt::print("{}\n", answer.dump(2));
    } else {
      print_run(run);
      fmt::print("\nrun {} in {} ({:.1f} s, {:.2g} events)\n", run.header.id, options->db, elapsed_s,
                 static_cast<double>(result.events));
      if (*check)
        fmt::print(
            "every law of conservation holds in {} replications; fingerprint {} of {} events in order\n",
            result.values.size(), check_of(result)["fingerprint"].get<std::string>(), result.events);
    }
  });
}

}  // namespace verstat::app
