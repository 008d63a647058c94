#pragma once
// A study from its file to its answer. Stage one searches the long-run model, stage two refines by simulation
// under common random numbers, stage three chooses among the finalists with fresh random numbers.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimize/ledger.h"
#include "optimize/pareto.h"
#include "optimize/problem.h"
#include "optimize/ranking.h"
#include "optimize/retrospective.h"
#include "optimize/study_spec.h"
#include "sim/shop/run.h"

namespace verstat::optimize {

struct StudyProgress {
  std::string stage;  ///< "analytic", "front", "simulation", "choice"
  std::int64_t trials = 0;
  std::int64_t of = 0;              ///< at most, of this stage
  std::optional<double> best = {};  ///< so far, as the user sees it
};

/// Runs the replications `first` ... of a scenario.
using Simulate = std::function<shop::RunResult(const scenarios::Scenario& scenario, std::uint64_t first,
                                               std::int64_t count)>;

struct StudyTools {
  Simulate simulate;
  std::function<void(const StudyProgress&)> progress;  ///< may be empty
};

/// A point with what the study believes of it.
struct Candidate {
  std::vector<double> x;
  double value = 0;  ///< first objective as the user sees it, by the stage that proposed the point
  bool feasible = false;
  std::string stage;  ///< "analytic", "simulation", "choice"
};

/// Stage three.
struct Finalist {
  std::vector<double> x;
  std::optional<double> mean;        ///< as the user sees it
  std::optional<double> half_width;  ///< at the confidence of the choice
  std::int64_t replications = 0;
  bool feasible = true;  ///< constraints met with confidence on the fresh sample
  bool survived = false;
};
struct Choice {
  std::vector<Finalist> finalists;
  std::size_t best = 0;
  bool decided = false;  ///< false: the budget ended before the stated probability was reached
  double confidence = 0;
  double indifference = 0;  ///< in units of the objective
};

struct FrontEstimate {
  std::vector<double> x;
  std::vector<double> objectives;            ///< as the user sees them
  std::vector<std::optional<double>> means;  ///< simulated; empty when not asked for
  std::vector<std::optional<double>> half_widths;
};
struct FrontAnswer {
  std::vector<FrontEstimate> points;
  std::vector<double> reference;  ///< of the hypervolume, as the user sees the objectives
  double hypervolume = 0;
  std::size_t knee = 0;
};

struct StudyAnswer {
  std::vector<double> baseline;          ///< the variables in the scenario as it stands
  std::optional<double> baseline_value;  ///< first objective there in the long run
  bool baseline_feasible = true;         ///< as far as the long run tells
  std::optional<Candidate> best;         ///< none before the first feasible point
  std::optional<Candidate> analytic;     ///< the best of stage one
  std::string not_covered;               ///< why there was no stage one
  std::optional<Choice> choice;
  std::optional<FrontAnswer> front;
  std::string interrupted;  ///< why it ended early; empty: it did not
};

/// Runs the stages. `scenario` is the JSON text with all changes made. Deterministic given study and
/// scenario: a ledger that remembers trials gives the same answer as an empty one. Ends early, with the best
/// so far, when the ledger says so. Throws scenarios::InputError for a study that cannot be run.
[[nodiscard]] StudyAnswer run_study(Problem& problem, Ledger& ledger, const StudyTools& tools);

/// What run_study would refuse, without computing anything. Throws scenarios::InputError.
void check_study(const Problem& problem);

/// Seed of one stage, so that its streams are fresh: "choice", "confirmation".
[[nodiscard]] std::uint64_t stage_seed(std::uint64_t seed, const std::string& stage);

/// The search of stage one as the study asks for it.
[[nodiscard]] SearchOptions search_options(const StudySpec& study, std::uint64_t seed);

/// Changes that make the runs of the confirmation: fresh seed, number of replications.
[[nodiscard]] std::vector<scenarios::Change> confirmation_changes(const StudySpec& study, std::uint64_t seed);

struct Confirmation {
  shop::RunResult baseline;
  shop::RunResult best;
  shop::Estimate
      saving;  ///< how much better the best is, per pair of replications, at the study's confidence
  /// "better", "worse" or "not distinguishable" at the study's confidence.
  std::string verdict;
};
/// Two runs under the same random numbers compared. Throws std::invalid_argument when they do not match.
[[nodiscard]] Confirmation confirm(const StudySpec& study, shop::RunResult baseline, shop::RunResult best);

}  // namespace verstat::optimize
