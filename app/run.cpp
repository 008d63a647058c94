// verstat run: simulate a scenario and keep the result.
#include <chrono>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/progress.h"
#include "app/results.h"
#include "store/database.h"
#include "store/result_json.h"

namespace verstat::app {

void add_run(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  auto label = std::make_shared<std::string>("run");
  CLI::App* command = program.add_subcommand("run", "Simulate a scenario and store its KPIs");
  command->add_option("SCENARIO", *file, "scenario file (JSON)")->required();
  command->add_option("--label", *label, "a name to find the run by")->capture_default_str();
  add_json(*command, *options);
  add_db(*command, *options);
  add_run_options(*command, *options);
  command->footer(
      "Example:\n  verstat run scenarios/gallery/heavy-lathe.json --set /tools/0/strategy/gamma=0.47 "
      "--replications 10\n"
      "Every mean comes with the half-width of its 95 % confidence interval.");
  command->callback([options, file, label] {
    const auto changes = changes_of(*options);
    const LoadedScenario loaded = load_scenario(*file, changes);
    const int threads = thread_count(*options);
    const auto start = std::chrono::steady_clock::now();
    shop::RunResult result;
    {
      ProgressBar bar("replications");
      result = shop::run_scenario(loaded.scenario, threads,
                                  [&](std::int64_t done, std::int64_t of) { bar.update(done, of); });
    }
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    store::Run run = record_of(result, loaded, changes, *label, elapsed_s);
    run.header.id = store::Writer(options->db).add_run(run);
    if (options->json) {
      fmt::print("{}\n", store::to_json(run).dump(2));
    } else {
      print_run(run);
      fmt::print("\nrun {} in {} ({:.1f} s, {:.2g} events)\n", run.header.id, options->db, elapsed_s,
                 static_cast<double>(result.events));
    }
  });
}

}  // namespace verstat::app
