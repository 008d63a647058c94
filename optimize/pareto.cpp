#include "optimize/pareto.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace verstat::optimize {

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool somewhere = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    somewhere = somewhere || a[k] < b[k];
  }
  return somewhere;
}

std::vector<std::size_t> nondominated(const std::vector<std::vector<double>>& points) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < points.size() && !beaten; ++j)
      beaten = dominates(points[j], points[i]) || (j < i && points[j] == points[i]);
    if (!beaten) kept.push_back(i);
  }
  return kept;
}

double hypervolume(const std::vector<std::vector<double>>& points, const std::vector<double>& reference) {
  const std::size_t m = reference.size();
  std::vector<std::vector<double>> inside;
  for (const auto& p : points) {
    bool better_everywhere = true;
    for (std::size_t k = 0; k < m; ++k) better_everywhere = better_everywhere && p[k] < reference[k];
    if (better_everywhere) inside.push_back(p);
  }
  if (inside.empty()) return 0;
  std::sort(inside.begin(), inside.end(), [&](const auto& a, const auto& b) { return a[m - 1] < b[m - 1]; });
  if (m == 1) return reference[0] - inside.front()[0];
  // Slices between neighbouring values of the last objective; the lower ones hold fewer points.
  const std::vector<double> rest(reference.begin(), reference.end() - 1);
  double volume = 0;
  std::vector<std::vector<double>> slice;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    slice.emplace_back(inside[i].begin(), inside[i].end() - 1);
    const double top = i + 1 < inside.size() ? inside[i + 1][m - 1] : reference[m - 1];
    const double height = top - inside[i][m - 1];
    if (height > 0) volume += height * hypervolume(slice, rest);
  }
  return volume;
}

std::size_t knee(const std::vector<std::vector<double>>& front) {
  const std::size_t m = front.front().size();
  std::vector<double> low(m);
  std::vector<double> high(m);
  for (std::size_t k = 0; k < m; ++k) {
    const auto by = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
    low[k] = (*std::min_element(front.begin(), front.end(), by))[k];
    high[k] = (*std::max_element(front.begin(), front.end(), by))[k];
  }
  const auto scaled = [&](const std::vector<double>& p) {
    Eigen::VectorXd s(static_cast<Eigen::Index>(m));
    for (std::size_t k = 0; k < m; ++k)
      s[static_cast<Eigen::Index>(k)] = high[k] > low[k] ? (p[k] - low[k]) / (high[k] - low[k]) : 0;
    return s;
  };
  // Plane through the best point of each objective: normal n with n . p = 1 there.
  Eigen::MatrixXd anchors(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(m));
  for (std::size_t k = 0; k < m; ++k) {
    const auto best = std::min_element(front.begin(), front.end(), [k](const auto& a, const auto& b) {
      return a[k] < b[k] || (a[k] == b[k] && std::accumulate(a.begin(), a.end(), 0.0) <
                                                 std::accumulate(b.begin(), b.end(), 0.0));
    });
    anchors.row(static_cast<Eigen::Index>(k)) = scaled(*best).transpose();
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(anchors);
  Eigen::VectorXd normal = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(m));
  if (lu.isInvertible()) {
    const Eigen::VectorXd solved = lu.solve(normal);
    if ((solved.array() > 0).all()) normal = solved;
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < front.size(); ++i)
    if (normal.dot(scaled(front[i])) < normal.dot(scaled(front[best])) - 1e-12) best = i;
  return best;
}

namespace {

Measured one_of(const ManyMeasured& m, std::size_t objective) {
  return {m.objectives[objective], m.margins};
}

}  // namespace

Front pareto_front(const std::function<ManyMeasured(const std::vector<double>&)>& measure,
                   const std::vector<Dimension>& dimensions, const std::vector<double>& start,
                   std::size_t objectives, int points, const SearchOptions& options) {
  std::vector<FrontPoint> found;
  const auto keep = [&](const SearchResult& result) {
    if (!result.feasible) return;
    FrontPoint point{result.x, measure(result.x).objectives};
    if (std::all_of(point.objectives.begin(), point.objectives.end(),
                    [](double f) { return std::isfinite(f); }))
      found.push_back(std::move(point));
  };
  for (std::size_t k = 0; k < objectives; ++k)
    keep(minimize_mixed([&](const std::vector<double>& x) { return one_of(measure(x), k); }, dimensions,
                        start, options));
  Front front;
  if (found.empty()) return front;

  std::vector<double> low(objectives);
  std::vector<double> high(objectives);
  for (std::size_t k = 0; k < objectives; ++k) {
    const auto by = [k](const FrontPoint& a, const FrontPoint& b) {
      return a.objectives[k] < b.objectives[k];
    };
    low[k] = std::min_element(found.begin(), found.end(), by)->objectives[k];
    high[k] = std::max_element(found.begin(), found.end(), by)->objectives[k];
  }
  // Bounds on the objectives after the first, all combinations, neighbours one after the other
  // (boustrophedon).
  const auto grid = static_cast<std::size_t>(points);
  std::size_t combinations = 1;
  for (std::size_t k = 1; k < objectives; ++k) combinations *= grid;
  std::vector<double> warm = found.front().x;
  SearchOptions local = options;
  for (std::size_t c = 0; c < combinations; ++c) {
    std::vector<double> epsilon(objectives, 0.0);
    std::size_t rest = c;
    bool back = false;
    for (std::size_t k = objectives; k-- > 1;) {
      const std::size_t block = [&] {
        std::size_t b = 1;
        for (std::size_t j = 1; j < k; ++j) b *= grid;
        return b;
      }();
      std::size_t step = rest / block;
      rest %= block;
      if (back) step = grid - 1 - step;
      back = step % 2 == 1;
      epsilon[k] = high[k] - (high[k] - low[k]) * static_cast<double>(step) / static_cast<double>(grid - 1);
    }
    const auto bounded = [&](const std::vector<double>& x) {
      const ManyMeasured m = measure(x);
      Measured one = one_of(m, 0);
      for (std::size_t k = 1; k < objectives; ++k) {
        const double scale = std::max({std::abs(high[k]), std::abs(low[k]), 1e-300});
        one.margins.push_back(std::isfinite(m.objectives[k]) ? (epsilon[k] - m.objectives[k]) / scale : -1.0);
      }
      return one;
    };
    local.global = false;
    SearchResult result = minimize_mixed(bounded, dimensions, warm, local);
    if (!result.feasible) {
      local.global = true;
      result = minimize_mixed(bounded, dimensions, warm, local);
    }
    if (!result.feasible) continue;
    keep(result);
    warm = result.x;
  }

  std::vector<std::vector<double>> values;
  for (const FrontPoint& p : found) values.push_back(p.objectives);
  for (const std::size_t k : nondominated(values)) front.points.push_back(found[k]);
  std::sort(front.points.begin(), front.points.end(),
            [](const FrontPoint& a, const FrontPoint& b) { return a.objectives < b.objectives; });
  values.clear();
  for (const FrontPoint& p : front.points) values.push_back(p.objectives);
  for (std::size_t k = 0; k < objectives; ++k) {
    const auto by = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
    const double worst = (*std::max_element(values.begin(), values.end(), by))[k];
    const double best = (*std::min_element(values.begin(), values.end(), by))[k];
    front.reference.push_back(worst + 0.1 * std::max(worst - best, 1e-9 * std::abs(worst)));
  }
  front.hypervolume = hypervolume(values, front.reference);
  front.knee = knee(values);
  return front;
}

}  // namespace verstat::optimize
