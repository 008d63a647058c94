#pragma once
// Is it worth measuring more edges before choosing between plans? Expected value of sample information
// (Raiffa, Schlaifer, Applied Statistical Decision Theory (1961)), by simulating the measurements.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/observation.h"
#include "sim/kernel/random_stream.h"

namespace verstat::fit {

/// What is not known of one tool: equally likely parameter draws, of which only these functions know the
/// meaning.
struct UnknownGroup {
  std::string name;
  std::size_t draws = 0;
  /// Simulates `n` new measurements under draw `truth` and adds the log-likelihood of every draw to
  /// `log_weights` (as many as there are draws, zero at the start).
  std::function<void(std::size_t truth, int n, sim::RandomStream& stream, std::vector<double>& log_weights)>
      measure;
};

/// A plan costs costs[d] when draw d of its group is the truth.
struct PlanCosts {
  std::string name;
  std::size_t group = 0;
  std::vector<double> costs;
};

struct ChoiceNow {
  std::vector<double> expected;     ///< cost of each plan
  std::vector<double> best_chance;  ///< that the plan is the cheapest
  std::size_t best = 0;
  double perfect_information = 0;  ///< expected loss of choosing now, against knowing the truth
};
[[nodiscard]] ChoiceNow choose_now(const std::vector<UnknownGroup>& groups,
                                   const std::vector<PlanCosts>& plans, std::uint64_t seed,
                                   int truths = 20'000);

struct SampleValue {
  int measured = 0;           ///< new measurements of every group
  double value = 0;           ///< expected saving of choosing after them instead of now
  double standard_error = 0;  ///< of `value`, from the number of simulated truths
  double wrong_chance = 0;    ///< that the plan chosen after them is not the cheapest
};
/// `truths` simulated truths; the same ones for every n (common random numbers), so that values compare.
[[nodiscard]] SampleValue value_of_sample(const std::vector<UnknownGroup>& groups,
                                          const std::vector<PlanCosts>& plans, int n, int truths,
                                          std::uint64_t seed);

/// Scale and shape of a Weibull law.
struct WeibullDraw {
  double scale = 1;
  double shape = 1;
};
/// Equally likely draws from the posterior under a prior flat in ln scale and ln shape, by sampling from a
/// Student law around the maximum-likelihood estimate and resampling by likelihood. Throws FitError.
[[nodiscard]] std::vector<WeibullDraw> weibull_posterior(const std::vector<Observation>& lives,
                                                         std::size_t draws, std::uint64_t seed,
                                                         const std::string& name);

/// The group of edges with these draws; new edges are watched until they fail, or to `watched_min`.
[[nodiscard]] UnknownGroup weibull_group(std::string name, std::vector<WeibullDraw> draws,
                                         double watched_min);

/// Long-run cost of a minute of cutting with change at failure or at age `age_min` (infinite: at failure
/// only): (planned R(age) + failure F(age)) / E[min(life, age)]; Barlow, Hunter, Operations Research 8
/// (1960) 90.
[[nodiscard]] double age_replacement_cost(const WeibullDraw& law, double age_min, double planned_cost,
                                          double failure_cost);

}  // namespace verstat::fit
