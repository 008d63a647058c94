#include "optimize/ranking.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/kernel/output_analysis.h"

namespace verstat::optimize {

Ranking select_smallest(std::size_t systems, const SystemSampler& sample, const RankingOptions& options) {
  const auto k = static_cast<double>(systems);
  if (systems < 1) throw std::invalid_argument("a choice needs at least one system");
  if (!(options.confidence > 0 && options.confidence < 1) || !(options.indifference > 0) ||
      options.first_replications < 3 || options.max_replications < options.first_replications ||
      options.batch < 1)
    throw std::invalid_argument(
        "a choice needs 0 < confidence < 1, indifference > 0, first_replications >= 3, max_replications at "
        "least as many, batch >= 1");

  std::vector<std::vector<double>> values(systems);
  for (std::size_t i = 0; i < systems; ++i) values[i] = sample(i, 0, options.first_replications);
  std::int64_t taken = options.first_replications;
  std::vector<bool> in(systems, true);
  std::vector<double> sums(systems, 0.0);
  for (std::size_t i = 0; i < systems; ++i)
    for (const double v : values[i]) sums[i] += v;

  const auto n0 = static_cast<double>(options.first_replications);
  const double delta = options.indifference;
  std::vector<std::vector<double>> reach(systems, std::vector<double>(systems, 0.0));  // h^2 S^2 / delta^2
  if (systems > 1) {
    const double alpha = 1 - options.confidence;
    const double eta = 0.5 * (std::pow(2 * alpha / (k - 1), -2 / (n0 - 1)) - 1);
    const double h2 = 2 * eta * (n0 - 1);
    for (std::size_t i = 0; i < systems; ++i)
      for (std::size_t l = 0; l < i; ++l) {
        const double mean = (sums[i] - sums[l]) / n0;
        double s2 = 0;
        for (std::size_t r = 0; r < values[i].size(); ++r) {
          const double d = values[i][r] - values[l][r] - mean;
          s2 += d * d;
        }
        s2 /= n0 - 1;
        reach[i][l] = reach[l][i] = h2 * s2 / (delta * delta);
      }
  }
  const auto survivors = [&] { return std::count(in.begin(), in.end(), true); };
  const auto screen = [&] {
    const auto r = static_cast<double>(taken);
    std::vector<bool> next = in;
    for (std::size_t i = 0; i < systems; ++i)
      for (std::size_t l = 0; in[i] && l < systems; ++l) {
        if (l == i || !in[l]) continue;
        // The allowance W_il shrinks with the replications; a tie at its end keeps the lower number.
        const double allowance = std::max(0.0, 0.5 * delta * (reach[i][l] - r));
        const double behind = sums[i] - sums[l];
        if (behind > allowance || (behind == 0 && allowance == 0 && l < i)) next[i] = false;
      }
    in = next;
  };
  screen();
  while (survivors() > 1 && taken < options.max_replications) {
    const std::int64_t more = std::min(options.batch, options.max_replications - taken);
    for (std::size_t i = 0; i < systems; ++i) {
      if (!in[i]) continue;
      for (const double v : sample(i, taken, more)) {
        values[i].push_back(v);
        sums[i] += v;
      }
    }
    taken += more;
    screen();
  }

  Ranking ranking{.decided = survivors() == 1};
  bool first = true;
  for (std::size_t i = 0; i < systems; ++i) {
    sim::Tally tally;
    for (const double v : values[i]) tally.add(v);
    ranking.systems.push_back({.mean = tally.mean(),
                               .half_width = sim::confidence_interval(tally, options.confidence).half_width,
                               .replications = static_cast<std::int64_t>(values[i].size()),
                               .survived = in[i]});
    if (!in[i]) continue;
    if (first || ranking.systems[i].mean < ranking.systems[ranking.best].mean) ranking.best = i;
    first = false;
  }
  return ranking;
}

}  // namespace verstat::optimize
