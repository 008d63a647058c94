// verstat runs: what the database holds.
#include <fmt/format.h>

#include "app/cli.h"
#include "app/results.h"
#include "store/database.h"
#include "store/result_json.h"

namespace verstat::app {

namespace {

void list_all(const store::Reader& reader, bool json) {
  const auto runs = reader.runs();
  const auto studies = reader.studies();
  if (json) {
    nlohmann::ordered_json answer = {{"runs", nlohmann::ordered_json::array()},
                                     {"studies", nlohmann::ordered_json::array()}};
    for (const auto& run : runs) answer["runs"].push_back(store::to_json(run));
    for (const auto& study : studies) answer["studies"].push_back(store::to_json(study));
    fmt::print("{}\n", answer.dump(2));
    return;
  }
  fmt::print("{:>5}  {:<20}  {:<24}  {:>4}  {}\n", "run", "created", "label", "reps", "scenario");
  for (const auto& r : runs)
    fmt::print("{:>5}  {:<20}  {:<24}  {:>4}  {}\n", r.id, r.provenance.created, r.label, r.replications,
               r.scenario_name);
  if (!studies.empty())
    fmt::print("\n{:>5}  {:<20}  {:<10}  {:>6}  {}\n", "study", "created", "status", "trials", "name");
  for (const auto& s : studies)
    fmt::print("{:>5}  {:<20}  {:<10}  {:>6}  {}\n", s.id, s.provenance.created, s.status, s.trials, s.name);
}

}  // namespace

void add_runs(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto run_id = std::make_shared<std::int64_t>(0);
  auto study_id = std::make_shared<std::int64_t>(0);
  auto replications = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("runs", "List stored runs and studies, or show one");
  command->add_option("--run", *run_id, "show this run");
  command->add_option("--study", *study_id, "show this study");
  command->add_flag("--all-replications", *replications,
                    "with --run --json: the values of every replication");
  add_json(*command, *options);
  add_db(*command, *options);
  command->footer("Example:\n  verstat runs --db verstat.db --run 1");
  command->callback([=] {
    const store::Reader reader(options->db);
    if (*run_id != 0) {
      const auto run = reader.run(*run_id);
      if (!run) throw UsageError(fmt::format("--run {}: there is no such run in {}", *run_id, options->db));
      if (options->json) {
        fmt::print("{}\n", store::to_json(*run, *replications).dump(2));
      } else {
        print_run(*run);
      }
    } else if (*study_id != 0) {
      const auto study = reader.study(*study_id);
      if (!study)
        throw UsageError(fmt::format("--study {}: there is no such study in {}", *study_id, options->db));
      fmt::print("{}\n", store::to_json(*study).dump(2));
    } else {
      list_all(reader, options->json);
    }
  });
}

}  // namespace verstat::app
