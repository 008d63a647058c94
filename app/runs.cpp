// verstat runs: what the database holds, and whether it comes out again.
#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/elsewhere.h"
#include "app/progress.h"
#include "app/results.h"
#include "app/study_session.h"
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

// What a repetition of a stored run found.
struct Repeated {
  std::size_t values = 0;
  std::size_t different = 0;
  std::string first_difference;
  std::string fingerprint;
  bool same_fingerprint = true;  // or none was stored
  [[nodiscard]] bool identical() const { return different == 0 && same_fingerprint; }
};

bool same_bits(const std::optional<double>& a, const std::optional<double>& b) {
  if (a.has_value() != b.has_value()) return false;
  return !a || std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b);
}

// Computes a stored run again from what is stored with it: nothing else may matter.
Repeated repeat(const store::Run& run, int threads) {
  const LoadedScenario loaded = load_scenario_text(run.scenario_text, fmt::format("run {}", run.header.id),
                                                   changes_from_text(run.header.changes));
  ProgressBar bar("replications");
  const shop::RunResult again =
      simulate_anywhere(loaded.scenario, 0, run.header.replications, threads,
                        [&](std::int64_t done, std::int64_t of) { bar.update(done, of); });
  Repeated found;
  found.fingerprint = shop::fingerprint_of(again);
  found.same_fingerprint = run.header.fingerprint.empty() || run.header.fingerprint == found.fingerprint;
  const auto differs = [&](const std::string& where) {
    if (found.different++ == 0) found.first_difference = where;
  };
  if (again.kpis.size() != run.kpis.size())
    differs(fmt::format("{} KPIs are {} now", run.kpis.size(), again.kpis.size()));
  for (std::size_t k = 0; k < std::min(run.kpis.size(), again.kpis.size()); ++k) {
    const std::string& name = run.kpis[k].kpi.name;
    if (name != again.kpis[k].name) differs(fmt::format("{} is {} now", name, again.kpis[k].name));
    for (std::size_t r = 0; r < run.values.size(); ++r, ++found.values)
      if (!same_bits(run.values[r][k], again.values[r][k]))
        differs(fmt::format("{} of replication {}", name, r));
  }
  return found;
}

void verify(const store::Run& run, int threads, bool json) {
  const Repeated found = repeat(run, threads);
  const store::Provenance now = provenance();
  const store::Provenance& then = run.header.provenance;
  if (json) {
    const nlohmann::ordered_json before = store::to_json(run.header);
    fmt::print("{}\n", nlohmann::ordered_json{{"run", run.header.id},
                                              {"identical", found.identical()},
                                              {"values", found.values},
                                              {"different", found.different},
                                              {"first_difference", found.first_difference},
                                              {"fingerprint", before["fingerprint"]},
                                              {"fingerprint_now", found.fingerprint},
                                              {"versions", {then.version, now.version}},
                                              {"platforms", {then.platform, now.platform}}}
                           .dump(2));
    if (!found.identical()) exit_with(failure);
    return;
  }
  if (found.identical()) {
    fmt::print("run {}: all {} values of {} replications come out the same, bit for bit; fingerprint {}{}\n",
               run.header.id, found.values, run.header.replications, found.fingerprint,
               run.header.fingerprint.empty() ? " (none was stored)" : "");
    return;
  }
  const std::string made = then.version == now.version && then.platform == now.platform
                               ? "by this version on this platform: the file or the program is damaged"
                               : fmt::format("by version {} on {}, this is {} on {}", then.version,
                                             then.platform, now.version, now.platform);
  if (found.different == 0)
    throw std::runtime_error(
        fmt::format("run {}: all {} values come out the same, but the course of events does not (fingerprint "
                    "{} stored, {} computed); it was made {}",
                    run.header.id, found.values, run.header.fingerprint, found.fingerprint, made));
  throw std::runtime_error(
      fmt::format("run {}: {} of {} values come out otherwise, the first is {}; it was made {}",
                  run.header.id, found.different, found.values, found.first_difference, made));
}

}  // namespace

void add_runs(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto run_id = std::make_shared<std::int64_t>(0);
  auto study_id = std::make_shared<std::int64_t>(0);
  auto verified_id = std::make_shared<std::int64_t>(0);
  auto replications = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("runs", "List stored runs and studies, or show one");
  command->add_option("--run", *run_id, "show this run");
  command->add_option("--study", *study_id, "show this study");
  command->add_flag("--all-replications", *replications,
                    "with --run --json: the values of every replication");
  command->add_option(
      "--verify", *verified_id,
      "compute this run again and compare every value bit for bit; exit code 1 when one differs");
  command->add_option("--threads", options->threads, "with --verify: threads to use");
  add_json(*command, *options);
  add_db(*command, *options);
  command->footer("Example:\n  verstat runs --db verstat.db --run 1");
  command->callback([=] {
    const store::Reader reader(options->db);
    if (*verified_id != 0) {
      const auto run = reader.run(*verified_id);
      if (!run)
        throw UsageError(fmt::format("--verify {}: there is no such run in {}", *verified_id, options->db));
      verify(*run, thread_count(*options), options->json);
    } else if (*run_id != 0) {
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
