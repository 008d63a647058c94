#pragma once
// What a study has computed so far: every finished trial is handed on before the next begins, and a question
// asked twice is answered from memory. A study resumed with the trials of its first half asks the same
// questions in the same order and finds their answers here.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace verstat::optimize {

struct Trial {
  std::string stage;      ///< "analytic", "simulation", "choice", "design", ...
  std::vector<double> x;  ///< a category is the index of its option
  std::int64_t first_replication = 0;
  std::int64_t replications = 0;  ///< 0: computed without simulation
  std::vector<double> outcome;    ///< what the study reads; NaN where there is no value
  std::optional<double> objective = {};
  std::optional<double> half_width = {};
  bool feasible = true;
};

/// The study was asked to end: Ctrl-C, or a budget. What is finished stays.
class Interrupted : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Ledger {
 public:
  Ledger() = default;
  /// `keep` is called with every new trial before anything else happens; `stop` before every new trial, and
  /// says why the study must end, or nothing.
  Ledger(std::function<void(const Trial&)> keep, std::function<std::string()> stop)
      : keep_(std::move(keep)), stop_(std::move(stop)) {}

  /// Trials of an earlier run of the same study.
  void remember(const Trial& trial) { known_.emplace(key_of(trial), trial.outcome); }

  /// The outcome of a trial, computed by `work(trial)` (which fills outcome, objective, half_width and
  /// feasible) unless it is known. Throws Interrupted.
  template <class Work>
  const std::vector<double>& ask(Trial question, Work&& work) {
    const std::string key = key_of(question);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    check();
    work(question);
    ++computed_;
    if (keep_) keep_(question);
    return known_.emplace(key, std::move(question.outcome)).first->second;
  }
  /// Throws Interrupted when the study must end.
  void check() const {
    if (!stop_) return;
    if (std::string why = stop_(); !why.empty()) throw Interrupted(why);
  }
  /// Trials computed, not counting those remembered.
  [[nodiscard]] std::int64_t computed() const { return computed_; }
  [[nodiscard]] std::int64_t known() const { return static_cast<std::int64_t>(known_.size()); }

 private:
  [[nodiscard]] static std::string key_of(const Trial& trial);

  std::function<void(const Trial&)> keep_;
  std::function<std::string()> stop_;
  std::unordered_map<std::string, std::vector<double>> known_;  // never iterated
  std::int64_t computed_ = 0;
};

}  // namespace verstat::optimize
