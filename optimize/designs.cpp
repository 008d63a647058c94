#include "optimize/designs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>
#include <boost/random/sobol.hpp>

#include "sim/kernel/output_analysis.h"
#include "sim/kernel/random_stream.h"

namespace verstat::optimize {

Design full_factorial(const std::vector<int>& levels) {
  double size = 1;
  for (const int l : levels) size *= l;
  if (levels.empty() || *std::min_element(levels.begin(), levels.end()) < 2 || size > 1e6)
    throw std::invalid_argument(
        "a full factorial needs at least 2 levels per factor, and at most 1e6 points");
  Design design{.resolution = 0};
  std::vector<int> at(levels.size(), 0);
  for (;;) {
    std::vector<double> point;
    for (std::size_t k = 0; k < levels.size(); ++k) point.push_back(2.0 * at[k] / (levels[k] - 1) - 1);
    design.points.push_back(std::move(point));
    std::size_t k = 0;
    while (k < levels.size() && ++at[k] == levels[k]) at[k++] = 0;
    if (k == levels.size()) return design;
  }
}

namespace {

// Length of the shortest word of the defining relation, and how many have it. A generator is a set of base
// factors (bits); factor base + i is their product.
struct Words {
  int shortest = 99;
  int count = 0;
};
Words words_of(const std::vector<unsigned>& generators) {
  Words words;
  // Sets in the order of Gray's code: each differs from the one before in one generator.
  unsigned base = 0;
  for (unsigned k = 1; k < (1U << generators.size()); ++k) {
    base ^= generators[static_cast<std::size_t>(std::countr_zero(k))];
    const int length = std::popcount(base) + std::popcount(k ^ (k >> 1U));
    if (length < words.shortest) words = {length, 0};
    if (length == words.shortest) ++words.count;
  }
  return words;
}
bool better_words(const Words& a, const Words& b) {
  return a.shortest > b.shortest || (a.shortest == b.shortest && a.count < b.count);
}

}  // namespace

Design fractional_factorial(int factors, int q) {
  if (q < 2 || q > 10 || factors < 2 || factors > 31 || factors > (1 << q) - 1)
    throw std::invalid_argument(
        "a fraction of 2^q points takes 2 to min(31, 2^q - 1) factors, q from 2 to 10");
  const int base = std::min(factors, q);
  const int extra = factors - base;
  std::vector<unsigned> chosen;
  // One generator after the other, each the best beside those before; then each is replaced by a better one
  // as long as there is one. The defining relation has 2^extra words: up to 16 extra factors are weighed so,
  // more take the longest words that are left.
  std::vector<unsigned> candidates;
  for (unsigned word = 1; word < (1U << q); ++word)
    if (std::popcount(word) >= 2) candidates.push_back(word);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](unsigned a, unsigned b) { return std::popcount(a) > std::popcount(b); });
  const auto free_of = [&](unsigned word) {
    return std::find(chosen.begin(), chosen.end(), word) == chosen.end();
  };
  constexpr int most_weighed = 10;
  for (int e = 0; e < extra; ++e) {
    unsigned best = 0;
    Words best_words;
    for (const unsigned word : candidates) {
      if (!free_of(word)) continue;
      if (e >= most_weighed) {
        best = word;
        break;
      }
      chosen.push_back(word);
      const Words words = words_of(chosen);
      chosen.pop_back();
      if (best == 0 || better_words(words, best_words)) {
        best = word;
        best_words = words;
      }
    }
    chosen.push_back(best);
  }
  for (bool changed = extra <= most_weighed && extra > 0; changed;) {
    changed = false;
    for (auto& generator : chosen)
      for (const unsigned word : candidates) {
        if (!free_of(word)) continue;
        const Words now = words_of(chosen);
        const unsigned before = std::exchange(generator, word);
        if (better_words(words_of(chosen), now))
          changed = true;
        else
          generator = before;
      }
  }
  Design design;
  design.resolution = extra == 0 ? 0 : words_of(chosen).shortest;
  for (unsigned run = 0; run < (1U << q); ++run) {
    std::vector<double> point;
    for (int k = 0; k < base; ++k) point.push_back((run >> k) & 1U ? 1.0 : -1.0);
    for (const unsigned word : chosen) {
      // Product of the base columns of the word.
      const int minus = std::popcount(word & ~run);
      point.push_back(minus % 2 == 0 ? 1.0 : -1.0);
    }
    design.points.push_back(std::move(point));
  }
  return design;
}

Design latin_hypercube(int factors, int points, std::uint64_t seed) {
  if (factors < 1 || points < 2) throw std::invalid_argument("a Latin hypercube needs 2 points and 1 factor");
  const auto n = static_cast<std::size_t>(points);
  Design design;
  design.points.assign(n, std::vector<double>(static_cast<std::size_t>(factors)));
  for (std::size_t f = 0; f < static_cast<std::size_t>(factors); ++f) {
    sim::RandomStream stream(seed, "design", "latin hypercube", f);
    std::vector<std::size_t> order(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = k;
    for (std::size_t k = n; k > 1; --k) std::swap(order[k - 1], order[stream.below(k)]);
    for (std::size_t k = 0; k < n; ++k)
      design.points[k][f] =
          2 * (static_cast<double>(order[k]) + stream.uniform()) / static_cast<double>(n) - 1;
  }
  return design;
}

Design sobol(int factors, int points) {
  if (factors < 1 || points < 1) throw std::invalid_argument("a Sobol design needs a point and a factor");
  boost::random::sobol engine(static_cast<std::size_t>(factors));
  Design design;
  // Boost's sequence starts behind the zero point.
  for (int i = 0; i < points; ++i) {
    std::vector<double> point;
    for (int f = 0; f < factors; ++f)
      point.push_back(2 * (static_cast<double>(engine()) / 18446744073709551616.0) - 1);
    design.points.push_back(std::move(point));
  }
  return design;
}

Design one_at_a_time(int factors) {
  if (factors < 1) throw std::invalid_argument("a tornado needs a factor");
  const auto k = static_cast<std::size_t>(factors);
  Design design;
  design.points.assign(2 * k + 1, std::vector<double>(k, 0.0));
  for (std::size_t f = 0; f < k; ++f) {
    design.points[1 + 2 * f][f] = -1;
    design.points[2 + 2 * f][f] = 1;
  }
  return design;
}

std::vector<Effect> effects(const Design& design, const std::vector<std::vector<double>>& responses,
                            double confidence) {
  const std::size_t n = design.points.size();
  if (n == 0 || responses.size() != n)
    throw std::invalid_argument("one row of responses per point of the design");
  const std::size_t k = design.points.front().size();
  const auto rows = static_cast<Eigen::Index>(n);

  // Columns that are not a combination of those before them; an alias of a single one is noted with it.
  std::vector<Eigen::VectorXd> columns{Eigen::VectorXd::Ones(rows)};
  std::vector<Eigen::VectorXd> orthogonal{Eigen::VectorXd::Ones(rows).normalized()};
  std::vector<Effect> found;
  const auto offer = [&](const std::vector<std::size_t>& factors) {
    Eigen::VectorXd column = Eigen::VectorXd::Ones(rows);
    for (const std::size_t f : factors)
      for (std::size_t i = 0; i < n; ++i) column[static_cast<Eigen::Index>(i)] *= design.points[i][f];
    Eigen::VectorXd rest = column;
    for (int twice = 0; twice < 2; ++twice)
      for (const Eigen::VectorXd& q : orthogonal) {
        const double along = q.dot(rest);
        rest -= along * q;
      }
    if (rest.norm() > 1e-8 * std::max(column.norm(), 1e-300) && columns.size() < n) {
      orthogonal.push_back(rest.normalized());
      columns.push_back(std::move(column));
      found.push_back({.factors = factors});
      return;
    }
    for (std::size_t c = 1; c < columns.size(); ++c) {
      const double cosine = columns[c].dot(column) / (columns[c].norm() * column.norm());
      if (std::abs(std::abs(cosine) - 1) < 1e-9) found[c - 1].aliases.push_back(factors);
    }
  };
  for (std::size_t f = 0; f < k; ++f) offer({f});
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) offer({a, b});

  Eigen::MatrixXd x(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) x.col(static_cast<Eigen::Index>(c)) = columns[c];
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(x);
  std::vector<sim::Tally> tallies(found.size());
  for (std::size_t r = 0; r < responses.front().size(); ++r) {
    Eigen::VectorXd y(rows);
    bool complete = true;
    for (std::size_t i = 0; i < n; ++i) {
      if (responses[i].size() != responses.front().size())
        throw std::invalid_argument("every point of the design needs the same replications");
      y[static_cast<Eigen::Index>(i)] = responses[i][r];
      complete = complete && std::isfinite(responses[i][r]);
    }
    if (!complete) continue;
    const Eigen::VectorXd beta = solver.solve(y);
    for (std::size_t e = 0; e < found.size(); ++e) tallies[e].add(2 * beta[static_cast<Eigen::Index>(e) + 1]);
  }
  if (found.empty() || tallies.front().count() == 0)
    throw std::invalid_argument("no replication has all values");
  for (std::size_t e = 0; e < found.size(); ++e) {
    found[e].effect = tallies[e].mean();
    if (tallies[e].count() > 1)
      found[e].half_width = sim::confidence_interval(tallies[e], confidence).half_width;
  }
  return found;
}

}  // namespace verstat::optimize
