#pragma once
// What the sub-commands that run studies share: the record in the database that grows trial by trial,
// resuming, ending early, and progress on standard error.

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "app/cli.h"
#include "app/progress.h"
#include "optimize/compare.h"
#include "optimize/ledger.h"
#include "optimize/study.h"
#include "store/database.h"

namespace verstat::app {

/// --progress: a bar (as `verstat run` shows), JSON lines for programs, or nothing.
void add_progress(CLI::App& command, std::string& progress);
/// Throws UsageError.
void check_progress(const std::string& progress);

class StudySession {
 public:
  /// Opens the database and begins a study. `record` has texts, names, variables.
  StudySession(const std::string& db, store::Study record, const std::string& progress);
  /// Goes on with study `id`. Throws UsageError when there is none, or when this program would not compute
  /// the same bits as the one that began it.
  StudySession(const std::string& db, std::int64_t id, const std::string& kind, const std::string& progress);

  StudySession(const StudySession&) = delete;
  StudySession& operator=(const StudySession&) = delete;
  ~StudySession() = default;

  [[nodiscard]] std::int64_t id() const { return id_; }
  [[nodiscard]] const store::Study& record() const { return record_; }
  [[nodiscard]] store::Writer& writer() { return *writer_; }
  [[nodiscard]] optimize::Ledger& ledger() { return ledger_; }
  [[nodiscard]] std::int64_t trials() const { return trials_; }
  [[nodiscard]] std::string database() const { return writer_->file().string(); }
  void set_budget(double time_s, std::int64_t trials) {
    time_budget_s_ = time_s;
    trial_budget_ = trials;
  }
  /// Runs replications on `threads` threads; ends between two of them when the study must end.
  [[nodiscard]] optimize::Simulate simulate(int threads);
  void progress(const optimize::StudyProgress& now);
  /// Progress of a stage that counts something else, such as replications.
  void progress(const std::string& stage, std::int64_t done, std::int64_t of) {
    progress({stage, done, of, {}});
  }

  /// A run that belongs to the study: as stored when it is there, else made by `make`, stored and noted.
  [[nodiscard]] shop::RunResult run_once(bool baseline, const LoadedScenario& loaded,
                                         const std::vector<scenarios::Change>& changes,
                                         const std::string& label,
                                         const std::function<shop::RunResult()>& make);
  [[nodiscard]] std::optional<std::int64_t> baseline_run() const { return record_.baseline_run; }
  [[nodiscard]] std::optional<std::int64_t> best_run() const { return record_.best_run; }
  void finish(const std::string& result, const std::string& status);

 private:
  void begin(const std::string& db);
  [[nodiscard]] std::string must_stop() const;
  void keep(const optimize::Trial& trial);

  std::int64_t id_ = 0;
  store::Study record_;
  std::unique_ptr<store::Writer> writer_;
  optimize::Ledger ledger_;
  std::int64_t trials_ = 0;
  bool durable_ = true;
  double time_budget_s_ = 0;
  std::int64_t trial_budget_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  // progress
  bool json_ = false;
  bool silent_ = false;
  std::string stage_;
  std::unique_ptr<ProgressBar> bar_;
  std::chrono::steady_clock::time_point stage_start_{};
  std::chrono::steady_clock::time_point said_{};
};

/// The KPIs and values of a stored run.
[[nodiscard]] shop::RunResult result_of(const store::Run& run);
/// The changes as stored: JSON list of {"pointer", "value"}.
[[nodiscard]] std::vector<scenarios::Change> changes_from_text(const std::string& text);
/// What `--json` prints of a study: its number, then the members of the answer.
void print_json(std::int64_t study, const nlohmann::ordered_json& members);
/// {"mean", `half_width`} with null where there is none.
[[nodiscard]] nlohmann::ordered_json estimate_json(const shop::Estimate& estimate,
                                                   const char* half_width = "half_width");
/// The same as text: "125.87 +- 0.21".
[[nodiscard]] std::string shown(const nlohmann::ordered_json& estimate,
                                const char* half_width = "half_width");
/// What the database said when it could not keep a trial, and how the study goes on.
[[nodiscard]] store::StoreError with_way_on(const store::StoreError& error, const std::string& command,
                                            const StudySession& session);
/// The value of --resume. Throws UsageError.
[[nodiscard]] std::int64_t study_number(const std::string& text);
/// The text of a scenario with changes made, in the order of its members.
[[nodiscard]] std::string changed_text(const std::string& scenario_text,
                                       const std::vector<scenarios::Change>& changes);

}  // namespace verstat::app
