#pragma once
// Uncertain inputs from last month's totals, with any simulator: approximate Bayesian calibration.
//
// One month is one realisation, so the simulator is run once per design point, for exactly one month. A
// quadratic surface per total is fitted to these months; the scatter around it is the scatter of a month (and
// what the surface misses), and its covariance over the totals makes the likelihood of the observed month: a
// multivariate Student density, because the covariance is estimated (synthetic likelihood: Wood, Nature 466
// (2010) 1102; response surface: Box, Wilson (1951)). Adaptive Metropolis sampling gives the posterior; the
// next round puts its design where the posterior is.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/statistics.h"

namespace verstat::fit {

struct UncertainInput {
  std::string name;
  double low = 0, high = 1;
  bool logarithmic = false;        ///< equally likely on the logarithmic scale
  std::optional<double> mean, sd;  ///< normal knowledge within the limits; none: equally likely
};

struct ObservedTotal {
  std::string name;
  double value = 0;
  double measurement_sd = 0;  ///< how far the record itself may be off
};

struct CalibrationOptions {
  int points_per_round = 100;
  int rounds = 3;
  int check_points = 40;  ///< months simulated from the posterior, and as many from the start
  double confidence = 0.95;
  std::uint64_t seed = 1;
  int chain_steps = 20'000;  ///< of each of four chains
};

/// Simulates one month at each point; `first` numbers the months, so that no two share random numbers.
/// Answers [point][total].
using SimulateMonths = std::function<std::vector<std::vector<double>>(
    const std::vector<std::vector<double>>& points, std::uint64_t first)>;

struct CalibratedInput {
  double mean = 0, sd = 0, median = 0;
  Interval bounds;
  double prior_sd = 0;
  double sd_ratio = 1;  ///< posterior / prior standard deviation, on the scale of the prior
};

struct CheckedTotal {
  double observed = 0;
  double start_mean = 0;    ///< of the scenario as it was
  Interval start_interval;  ///< of single months
  double mean = 0;          ///< after calibration
  Interval interval;
  bool inside = false;
};

/// A combination of inputs (each in units of its prior standard deviation) and how much the totals narrowed
/// it.
struct Direction {
  std::vector<double> weights;
  double sd_ratio = 1;
};

struct Calibration {
  std::vector<CalibratedInput> inputs;
  std::vector<std::vector<double>> correlation;  ///< of the posterior
  std::vector<Direction> directions;             ///< best known first
  std::vector<CheckedTotal> totals;
  double misfit_p_value = 1;               ///< chance of a month at least as far from the calibrated model
  std::vector<std::vector<double>> draws;  ///< some of the posterior
  double largest_r_hat = 1;                ///< agreement of the chains; 1 is perfect
  int months = 0;                          ///< simulated in all
};

/// `start`: the inputs as they are now. Throws FitError when a total never varies, and what `simulate`
/// throws.
[[nodiscard]] Calibration calibrate(const std::vector<UncertainInput>& inputs,
                                    const std::vector<ObservedTotal>& totals,
                                    const std::vector<double>& start, const SimulateMonths& simulate,
                                    const CalibrationOptions& options);

}  // namespace verstat::fit
