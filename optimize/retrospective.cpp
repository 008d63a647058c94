#include "optimize/retrospective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/kernel/output_analysis.h"

namespace verstat::optimize {

Measured judge(const NoisyProblem& problem, const Rows& rows, const std::vector<double>& x) {
  const auto tally = [&](std::size_t column) {
    sim::Tally t;
    for (const auto& row : rows)
      if (std::isfinite(row[column])) t.add(row[column]);
    return t;
  };
  Measured m;
  const sim::Tally objective = tally(problem.objective);
  m.value = objective.count() < 2 ? std::numeric_limits<double>::infinity() : problem.sign * objective.mean();
  for (const NoisyConstraint& c : problem.constraints) {
    const sim::Tally t = tally(c.column);
    if (t.count() < 2) {
      m.value = std::numeric_limits<double>::infinity();
      m.margins.push_back(-1);
      continue;
    }
    // One-sided: half of what a two-sided interval leaves out lies on the wrong side.
    const double limit = sim::confidence_interval(t, 2 * c.confidence - 1).half_width;
    const double scale = c.allowed != 0 ? std::abs(c.allowed) : 1;
    m.margins.push_back((c.at_most ? c.allowed - t.mean() - limit : t.mean() - limit - c.allowed) / scale);
  }
  if (problem.exact_margins) {
    const auto exact = problem.exact_margins(x);
    m.margins.insert(m.margins.end(), exact.begin(), exact.end());
  }
  return m;
}

std::vector<double> confidence_allowances(const NoisyProblem& problem, const Rows& rows) {
  std::vector<double> all;
  for (const NoisyConstraint& c : problem.constraints) {
    sim::Tally t;
    for (const auto& row : rows)
      if (std::isfinite(row[c.column])) t.add(row[c.column]);
    const double scale = c.allowed != 0 ? std::abs(c.allowed) : 1;
    all.push_back(t.count() < 2 ? 0 : sim::confidence_interval(t, 2 * c.confidence - 1).half_width / scale);
  }
  return all;
}

Refined refine(const NoisyProblem& problem, const std::vector<std::vector<double>>& starts,
               const RefineOptions& options) {
  std::map<std::vector<double>, Rows> samples;
  const auto at = [&](const std::vector<double>& x, std::int64_t n) {
    Rows& rows = samples[x];
    const auto have = static_cast<std::int64_t>(rows.size());
    if (have < n) {
      Rows more = problem.sample(x, have, n - have);
      rows.insert(rows.end(), more.begin(), more.end());
    }
    return judge(problem, Rows(rows.begin(), rows.begin() + n), x);
  };
  const auto as_result = [&](const std::vector<double>& x, std::int64_t n) {
    SearchResult r{.x = x, .measured = at(x, n)};
    r.feasible = violation(r.measured) == 0;
    return r;
  };

  Refined refined;
  std::vector<std::vector<double>> from = starts;
  std::int64_t n = options.first_replications;
  std::int64_t left = options.trials;
  double half = options.neighbourhood;
  std::vector<std::vector<double>> visited = starts;
  for (std::int64_t level = 0; level < options.levels; ++level, n *= 2, half /= 2) {
    // Later levels look closer at fewer points.
    const std::int64_t share = left / (options.levels - level) / static_cast<std::int64_t>(from.size());
    std::vector<SearchResult> found;
    for (const std::vector<double>& start : from) {
      std::vector<Dimension> box = problem.dimensions;
      for (std::size_t k = 0; k < box.size(); ++k) {
        Bounds& b = box[k].bounds;
        if (box[k].discrete && !box[k].ordered) continue;
        double reach = half * (b.high - b.low);
        if (box[k].discrete) reach = std::max(1.0, std::round(reach));
        b = {std::max(b.low, start[k] - reach), std::min(b.high, start[k] + reach)};
      }
      SearchOptions search{.max_evaluations = static_cast<int>(std::max<std::int64_t>(1, share)),
                           .relative_precision = 1e-3,
                           .starts = 0,
                           .global = false,
                           .differences = false,
                           .seed = options.seed};
      SearchResult best =
          minimize_mixed([&](const std::vector<double>& x) { return at(x, n); }, box, start, search);
      left -= best.evaluations;
      found.push_back(as_result(start, n));
      visited.push_back(best.x);
      found.push_back(std::move(best));
    }
    std::stable_sort(found.begin(), found.end(), better);
    refined.best = found.front();
    refined.replications = n;
    from = {found.front().x};
    // The second start goes on while nobody knows better.
    if (level == 0)
      for (const SearchResult& r : found)
        if (from.size() < 2 && r.x != from.front()) from.push_back(r.x);
    if (left < 1) break;
  }
  const std::int64_t last = refined.replications;
  for (const auto& x : visited) {
    const bool known = std::any_of(refined.finalists.begin(), refined.finalists.end(),
                                   [&](const SearchResult& r) { return r.x == x; });
    if (!known) refined.finalists.push_back(as_result(x, last));
  }
  std::stable_sort(refined.finalists.begin(), refined.finalists.end(), better);
  return refined;
}

}  // namespace verstat::optimize
