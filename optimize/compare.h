#pragma once
// Variants of a shop compared under common random numbers, with as many replications as the answer takes.

#include <functional>
#include <string>
#include <vector>

#include "sim/shop/run.h"

namespace verstat::optimize {

struct CompareOptions {
  std::vector<std::string> kpis{"cost_per_part", "throughput_per_h"};  ///< the first decides when to stop
  double confidence = 0.95;
  /// A difference whose whole interval is within this share of the first variant's value is no difference.
  double indifference = 0.005;
  std::int64_t first_replications = 10;
  std::int64_t max_replications = 320;
};

enum class Verdict { less, more, unchanged, unclear };

/// One KPI of a variant against the first.
struct Difference {
  std::string kpi;
  std::string unit;
  shop::Estimate first;
  shop::Estimate other;
  shop::Estimate difference;  ///< other minus first, pair by pair
  Verdict verdict = Verdict::unclear;
};

struct Comparison {
  std::int64_t replications = 0;
  bool clear = false;                                ///< false: the budget ended first
  std::vector<std::vector<Difference>> differences;  ///< of variants 1, 2, ... against variant 0
  std::vector<shop::RunResult> runs;
};

/// Runs replications `first` ... of a variant.
using RunVariant =
    std::function<shop::RunResult(std::size_t variant, std::uint64_t first, std::int64_t count)>;

/// Doubles the replications of all `variants` >= 2 until the first KPI is less, more or unchanged in each of
/// them, or the budget ends. Looking several times and at several variants does not lower the confidence:
/// each interval gets its share of what the confidence leaves (Bonferroni). Throws std::invalid_argument when
/// a variant lacks a KPI.
[[nodiscard]] Comparison compare(std::size_t variants, const RunVariant& run, const CompareOptions& options);

/// Adds the replications of `more` to `to`, and estimates again.
void append(shop::RunResult& to, const shop::RunResult& more);

/// What a KPI is called in a sentence: "throughput", "failure share of roughing tool", "cost (idle)".
[[nodiscard]] std::string kpi_in_words(const std::string& kpi);
/// "costs 3.1 +- 0.4 % less per part"; for other KPIs "throughput is 1.2 +- 0.3 % higher".
[[nodiscard]] std::string in_words(const Difference& difference);
/// The verdict on a variant: "indexing at gamma 0.85 costs 3.1 +- 0.4 % less per part; throughput is
/// unchanged."
[[nodiscard]] std::string in_words(const std::string& variant, const std::vector<Difference>& differences);

}  // namespace verstat::optimize
