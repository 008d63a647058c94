#include "app/study_session.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "app/elsewhere.h"
#include "app/interrupt.h"
#include "app/results.h"
#include "models/catalogue/shortened.h"
#include "store/result_json.h"

namespace verstat::app {

using nlohmann::json;
using nlohmann::ordered_json;
using optimize::Trial;

void add_progress(CLI::App& command, std::string& progress) {
  command.add_option("--progress", progress, "on standard error: bar, json (a line per step) or none")
      ->capture_default_str();
}

void check_progress(const std::string& progress) {
  if (progress != "bar" && progress != "json" && progress != "none")
    throw UsageError(
        fmt::format("--progress {}: must be bar, json or none", models::shortened(progress, 100)));
}

StudySession::StudySession(const std::string& db, store::Study record, const std::string& progress)
    : record_(std::move(record)), json_(progress == "json"), silent_(progress == "none") {
  begin(db);
  id_ = writer_->begin_study(record_);
}

StudySession::StudySession(const std::string& db, std::int64_t id, const std::string& kind,
                           const std::string& progress)
    : id_(id), json_(progress == "json"), silent_(progress == "none") {
  begin(db);  // first: a database of an older schema is brought up to date
  auto found = store::Reader(db).study(id);
  if (!found || found->header.kind != kind)
    throw UsageError(fmt::format("--resume {}: there is no such {} study in {}", id, kind, db));
  record_ = std::move(*found);
  const store::Provenance here = provenance();
  const store::Provenance& then = record_.header.provenance;
  if (then.version != here.version || then.platform != here.platform)
    throw UsageError(fmt::format(
        "--resume {}: begun by Verstat {} on {}; this is {} on {}, which may not compute the same bits", id,
        then.version, then.platform, here.version, here.platform));
  for (const store::Trial& t : record_.trials) {
    trials_ = std::max(trials_, t.number);
    if (t.outcome.empty()) continue;  // of schema 1
    ledger_.remember({.stage = t.stage,
                      .x = t.values,
                      .first_replication = t.first_replication,
                      .replications = t.replications,
                      .outcome = t.outcome});
  }
  record_.trials.clear();
  writer_->resume_study(id);
}

void StudySession::begin(const std::string& db) {
  note_interrupts();
  writer_ = std::make_unique<store::Writer>(db);
  ledger_ = optimize::Ledger([this](const Trial& trial) { keep(trial); }, [this] { return must_stop(); });
}

std::string StudySession::must_stop() const {
  if (end_asked()) return "interrupted";
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (time_budget_s_ > 0 && elapsed_s >= time_budget_s_)
    return fmt::format("the time budget of {:g} s is used up", time_budget_s_);
  if (trial_budget_ > 0 && trials_ >= trial_budget_)
    return fmt::format("the budget of {} trials is used up", trial_budget_);
  return {};
}

void StudySession::keep(const Trial& trial) {
  // A trial of microseconds must not wait for the disk; what a power cut takes of them is asked again.
  const bool durable = trial.replications > 0;
  if (durable != durable_) {
    writer_->set_durable(durable);
    durable_ = durable;
  }
  const auto finite = [](const std::optional<double>& x) {
    return x && std::isfinite(*x) ? x : std::nullopt;
  };
  writer_->add_trials(id_, {{.number = trials_ + 1,
                             .stage = trial.stage,
                             .values = trial.x,
                             .objective = finite(trial.objective),
                             .feasible = trial.feasible,
                             .half_width = finite(trial.half_width),
                             .first_replication = trial.first_replication,
                             .replications = trial.replications,
                             .outcome = trial.outcome}});
  ++trials_;
}

optimize::Simulate StudySession::simulate(int threads) {
  return [this, threads](const scenarios::Scenario& scenario, std::uint64_t first, std::int64_t count) {
    return simulate_anywhere(scenario, first, count, threads,
                             [this](std::int64_t, std::int64_t) { ledger_.check(); });
  };
}

void StudySession::progress(const optimize::StudyProgress& now) {
  if (silent_) return;
  const auto time = std::chrono::steady_clock::now();
  const bool fresh = now.stage != stage_;
  if (fresh) {
    stage_ = now.stage;
    stage_start_ = time;
    bar_ = json_ ? nullptr : std::make_unique<ProgressBar>(now.stage);
  }
  if (!json_) {
    // A stage that stops when it has converged knows only its limit.
    if (now.of > 0) bar_->update(std::min(now.trials, now.of), now.of, now.best);
    return;
  }
  if (!fresh && time - said_ < std::chrono::milliseconds(200)) return;
  said_ = time;
  const double elapsed_s = std::chrono::duration<double>(time - start_).count();
  const double stage_s = std::chrono::duration<double>(time - stage_start_).count();
  ordered_json line = {{"study", id_},    {"stage", now.stage},     {"trials", now.trials}, {"of", nullptr},
                       {"best", nullptr}, {"elapsed_s", elapsed_s}, {"left_s", nullptr}};
  if (now.of > 0) line["of"] = now.of;
  if (now.best && std::isfinite(*now.best)) line["best"] = *now.best;
  double left_s = -1;
  if (now.of > 0 && now.trials > 0)
    left_s = stage_s * static_cast<double>(now.of - now.trials) / static_cast<double>(now.trials);
  if (time_budget_s_ > 0)
    left_s = left_s < 0 ? time_budget_s_ - elapsed_s : std::min(left_s, time_budget_s_ - elapsed_s);
  if (left_s >= 0) line["left_s"] = left_s;
  fmt::print(stderr, "{}\n", line.dump());
}

shop::RunResult StudySession::run_once(bool baseline, const LoadedScenario& loaded,
                                       const std::vector<scenarios::Change>& changes,
                                       const std::string& label,
                                       const std::function<shop::RunResult()>& make) {
  auto& stored = baseline ? record_.baseline_run : record_.best_run;
  if (stored) {
    const auto run = store::Reader(writer_->file()).run(*stored);
    if (run) return result_of(*run);
  }
  const auto start = std::chrono::steady_clock::now();
  shop::RunResult result = make();
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stored = writer_->add_run(
      record_of(result, loaded, changes, fmt::format("study {}: {}", id_, label), elapsed_s));
  writer_->set_study_run(id_, baseline, *stored);
  return result;
}

void StudySession::finish(const std::string& result, const std::string& status) {
  bar_.reset();
  writer_->set_durable(true);
  writer_->finish_study(id_, record_.baseline_run, record_.best_run, result, status);
}

shop::RunResult result_of(const store::Run& run) {
  shop::RunResult result;
  result.values = run.values;
  for (const store::KpiSummary& k : run.kpis) {
    result.kpis.push_back({k.kpi.name, k.kpi.unit, k.kpi.meaning});
    result.estimates.push_back({k.mean, k.half_width, k.samples});
  }
  return result;
}

std::vector<scenarios::Change> changes_from_text(const std::string& text) {
  std::vector<scenarios::Change> changes;
  for (const json& change : json::parse(text)) changes.push_back({change.at("pointer"), change.at("value")});
  return changes;
}

void print_json(std::int64_t study, const ordered_json& members) {
  ordered_json out = {{"study", study}};
  out.update(members);
  fmt::print("{}\n", out.dump(2));
}

std::string shown(const ordered_json& estimate, const char* half_width) {
  const auto value = [](const ordered_json& x) {
    return x.is_null() ? std::nullopt : std::optional(x.get<double>());
  };
  return shown(value(estimate.at("mean")), value(estimate.at(half_width)));
}

ordered_json estimate_json(const shop::Estimate& e, const char* half_width) {
  return {{"mean", store::number_or_null(e.mean)}, {half_width, store::number_or_null(e.half_width)}};
}

store::StoreError with_way_on(const store::StoreError& error, const std::string& command,
                              const StudySession& session) {
  return store::StoreError(fmt::format(
      "{}; the {} finished trials of study {} are kept: when there is room, go on with verstat {} "
      "--resume {} --db {}",
      error.what(), session.trials(), session.id(), command, session.id(), session.database()));
}

std::int64_t study_number(const std::string& text) {
  std::int64_t id = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || stop != text.data() + text.size() || id < 1)
    throw UsageError(fmt::format("--resume {}: must be the number of a study", models::shortened(text, 100)));
  return id;
}

std::string changed_text(const std::string& scenario_text, const std::vector<scenarios::Change>& changes) {
  ordered_json scenario = ordered_json::parse(scenario_text);
  for (const scenarios::Change& change : changes)
    scenario[ordered_json::json_pointer(change.pointer)] = ordered_json::parse(change.value.dump());
  return scenario.dump(2) + "\n";
}

}  // namespace verstat::app
