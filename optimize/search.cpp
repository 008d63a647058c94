#include "optimize/search.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>

#include <nlopt.hpp>

#include "sim/kernel/random_stream.h"

namespace verstat::optimize {
namespace {

constexpr double difference_step = 1e-6;

bool defined(const Measured& m) {
  return std::isfinite(m.value) &&
         std::all_of(m.margins.begin(), m.margins.end(), [](double g) { return std::isfinite(g); });
}

class Search {
 public:
  Search(const Measure& measure, const std::vector<Bounds>& bounds, const SearchOptions& options)
      : measure_(measure), bounds_(bounds), options_(options) {}

  // One NLopt run from `start` with at most `evaluations` >= 1 more.
  void run(nlopt::algorithm algorithm, const std::vector<double>& start, int evaluations, double tolerance) {
    if (result_.evaluations >= options_.max_evaluations) return;
    const auto n = static_cast<unsigned>(bounds_.size());
    if (n < 2 && algorithm == nlopt::LN_NEWUOA_BOUND) algorithm = nlopt::LN_SBPLX;  // needs two
    budget_ = std::min(options_.max_evaluations, result_.evaluations + evaluations);
    std::vector<double> u = scaled(start);
    start_u_ = u;
    start_x_ = start;
    // The first point is measured before NLopt starts: it says how many constraints there are.
    std::size_t margins = 0;
    try {
      margins = at(u).margins.size();
    } catch (const nlopt::forced_stop&) {
      std::rethrow_exception(error_);  // there is room for one evaluation: the measure has thrown
    }

    nlopt::opt opt(algorithm, n);
    nlopt::opt local(inner_algorithm(algorithm), n);
    local.set_xtol_rel(1e-6);
    opt.set_local_optimizer(local);  // of the algorithms that want one
    opt.set_lower_bounds(0.0);
    opt.set_upper_bounds(1.0);
    opt.set_min_objective(&Search::objective, this);
    penalised_ = false;
    std::vector<Constraint> constraints(margins);
    for (std::size_t k = 0; k < margins; ++k) {
      constraints[k] = {this, k};
      try {
        opt.add_inequality_constraint(&Search::constraint, &constraints[k], 0.1 * margin_tolerance);
      } catch (const std::invalid_argument&) {
        penalised_ = true;  // this algorithm knows no constraints
        break;
      }
    }
    // Evaluations answered from memory (a constraint of a point whose objective is known) cost NLopt's count
    // nothing; ours ends the work.
    opt.set_maxeval(evaluations);
    if (tolerance > 0) opt.set_xtol_abs(tolerance);
    nlopt::srand(options_.seed);  // in this thread, right before the search
    double value = 0;
    try {
      opt.optimize(u, value);
    } catch (const nlopt::roundoff_limited&) {
      // As far as doubles go; the incumbent stands.
    } catch (const nlopt::forced_stop&) {
      // Out of budget, or our own error.
    } catch (const std::exception&) {
      // NLopt replaces what the objective throws by exceptions of its own; ours is kept in error_.
    }
    if (error_) std::rethrow_exception(error_);
  }

  [[nodiscard]] const SearchResult& result() const { return result_; }

  [[nodiscard]] nlopt::algorithm inner_algorithm(nlopt::algorithm of) const {
    if (!options_.local_algorithm.empty())
      return static_cast<nlopt::algorithm>(nlopt_algorithm_from_string(options_.local_algorithm.c_str()));
    const bool gradients = of == nlopt::GD_MLSL || of == nlopt::GD_MLSL_LDS || of == nlopt::LD_AUGLAG ||
                           of == nlopt::LD_AUGLAG_EQ;
    return gradients ? nlopt::LD_SLSQP : nlopt::LN_SBPLX;
  }

 private:
  struct Constraint {
    Search* search = nullptr;
    std::size_t index = 0;
  };
  struct Known {
    std::vector<double> u;
    Measured measured;
  };

  static double objective(const std::vector<double>& u, std::vector<double>& gradient, void* self) {
    Search& search = *static_cast<Search*>(self);
    const double value = search.value_at(u);
    if (gradient.empty()) return value;
    if (const MeasuredSlopes* slopes = search.slopes_at(u)) {
      const std::vector<double>& margins = search.at(u).margins;
      for (std::size_t k = 0; k < u.size(); ++k) {
        double slope = slopes->value[k];
        // The penalty of value_at.
        for (std::size_t c = 0; search.penalised_ && c < margins.size(); ++c)
          if (margins[c] < 0) slope -= 10 * search.scale_ * slopes->margins[c][k];
        gradient[k] = slope * search.width(k);
      }
      return value;
    }
    search.differences(u, gradient.data(), [&](const std::vector<double>& v) { return search.value_at(v); });
    return value;
  }
  static double constraint(const std::vector<double>& u, std::vector<double>& gradient, void* which) {
    const Constraint& c = *static_cast<Constraint*>(which);
    Search& search = *c.search;
    const auto unmet = [&](const std::vector<double>& v) {
      const Measured& m = search.at(v);
      return defined(m) ? -m.margins[c.index] : 1.0;
    };
    const double value = unmet(u);
    if (gradient.empty()) return value;
    if (const MeasuredSlopes* slopes = search.slopes_at(u))
      for (std::size_t k = 0; k < u.size(); ++k) gradient[k] = -slopes->margins[c.index][k] * search.width(k);
    else
      search.differences(u, gradient.data(), unmet);
    return value;
  }

  template <class F>
  void differences(const std::vector<double>& u, double* gradient, F&& f) {
    for (std::size_t k = 0; k < u.size(); ++k) {
      std::vector<double> low = u;
      std::vector<double> high = u;
      low[k] = std::max(0.0, u[k] - difference_step);
      high[k] = std::min(1.0, u[k] + difference_step);
      const double f_high = f(high);
      gradient[k] = (f_high - f(low)) / (high[k] - low[k]);
    }
  }

  [[nodiscard]] double width(std::size_t k) const { return bounds_[k].high - bounds_[k].low; }

  // Exact gradients of a point that is defined; null when there are none.
  const MeasuredSlopes* slopes_at(const std::vector<double>& u) {
    if (!options_.slopes || !defined(at(u))) return nullptr;
    if (slopes_u_ != u) {
      try {
        slopes_ = options_.slopes(point_of(u));
      } catch (...) {
        error_ = std::current_exception();
        throw nlopt::forced_stop();
      }
      slopes_u_ = u;
    }
    return slopes_ ? &*slopes_ : nullptr;
  }

  // What NLopt sees of the objective: finite always, with the penalty where it must be.
  double value_at(const std::vector<double>& u) {
    const Measured& m = at(u);
    // An undefined point is worse than every point seen, but not by so much that a quadratic model breaks.
    if (!defined(m)) return worst_ + std::abs(worst_) + 1;
    if (!penalised_) return m.value;
    double unmet = 0;
    for (const double g : m.margins) unmet += std::max(0.0, -g);
    return m.value + 10 * scale_ * unmet;
  }

  // The point measured, once: objective, constraints and differences of one point share it.
  const Measured& at(const std::vector<double>& asked) {
    // Some algorithms rescale what they are given: the start comes back with another last bit.
    const std::vector<double>& u = is_start(asked) ? start_u_ : asked;
    for (std::size_t k = known_.size(); k-- > 0;)
      if (known_[k].u == u) return known_[k].measured;
    // Some algorithms overshoot maxeval or go on after an error: nothing more is computed then.
    if (error_ || result_.evaluations >= budget_) throw nlopt::forced_stop();
    std::vector<double> x = point_of(u);
    Known known{u, {}};
    try {
      known.measured = measure_(x);
    } catch (...) {
      error_ = std::current_exception();
      throw nlopt::forced_stop();
    }
    ++result_.evaluations;
    if (defined(known.measured)) {
      worst_ = std::max(worst_, known.measured.value);
      if (scale_ == 0) scale_ = std::max(std::abs(known.measured.value), 1e-300);
    } else {
      known.measured.value = std::numeric_limits<double>::infinity();
    }
    const SearchResult candidate{.x = std::move(x),
                                 .measured = known.measured,
                                 .feasible = violation(known.measured) == 0,
                                 .evaluations = result_.evaluations};
    if (result_.x.empty() || better(candidate, result_)) result_ = candidate;
    result_.evaluations = candidate.evaluations;
    const std::size_t memory = 2 * u.size() + 4;
    if (known_.size() >= memory) known_.erase(known_.begin());
    known_.push_back(std::move(known));
    return known_.back().measured;
  }

  [[nodiscard]] std::vector<double> point_of(const std::vector<double>& u) const {
    std::vector<double> x(u.size());
    for (std::size_t k = 0; k < u.size(); ++k) {
      const Bounds& b = bounds_[k];
      // The start itself, bit for bit: it may have been measured before.
      x[k] = u == start_u_ ? std::clamp(start_x_[k], b.low, b.high)
                           : std::clamp(b.low + std::clamp(u[k], 0.0, 1.0) * (b.high - b.low), b.low, b.high);
    }
    return x;
  }

  [[nodiscard]] bool is_start(const std::vector<double>& u) const {
    for (std::size_t k = 0; k < u.size(); ++k)
      if (!(std::abs(u[k] - start_u_[k]) < 1e-13)) return false;
    return true;
  }

  [[nodiscard]] std::vector<double> scaled(const std::vector<double>& x) const {
    std::vector<double> u(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double width = bounds_[k].high - bounds_[k].low;
      u[k] = width > 0 ? std::clamp((x[k] - bounds_[k].low) / width, 0.0, 1.0) : 0.0;
    }
    return u;
  }

  const Measure& measure_;
  const std::vector<Bounds>& bounds_;
  const SearchOptions& options_;
  SearchResult result_;
  std::vector<Known> known_;
  std::vector<double> start_u_;
  std::vector<double> start_x_;
  std::vector<double> slopes_u_;  // of slopes_
  std::optional<MeasuredSlopes> slopes_;
  std::exception_ptr error_;
  double worst_ = 0;
  double scale_ = 0;
  int budget_ = 0;
  bool penalised_ = false;
};

nlopt::algorithm by_name(const std::string& name) {
  if (!known_algorithm(name))
    throw std::invalid_argument("algorithm \"" + name +
                                "\" is unknown; for instance LN_BOBYQA, LN_COBYLA, LD_SLSQP, GN_DIRECT_L, "
                                "GN_CRS2_LM, GN_ISRES");
  return static_cast<nlopt::algorithm>(nlopt_algorithm_from_string(name.c_str()));
}

// A point of the box, the same for the same seed and number.
std::vector<double> scattered(const std::vector<Bounds>& bounds, std::uint64_t seed, int number) {
  sim::RandomStream stream(seed, "search", "scattered start", static_cast<std::uint64_t>(number));
  std::vector<double> x;
  for (const Bounds& b : bounds) x.push_back(stream.uniform(b.low, b.high));
  return x;
}

}  // namespace

double violation(const Measured& m) {
  if (!defined(m)) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const double g : m.margins)
    if (g < -margin_tolerance) sum -= g;
  return sum;
}

bool better(const SearchResult& a, const SearchResult& b) {
  if (a.feasible != b.feasible) return a.feasible;
  if (a.feasible) return a.measured.value < b.measured.value;
  const double va = violation(a.measured);
  const double vb = violation(b.measured);
  return va < vb || (va == vb && a.measured.value < b.measured.value);
}

bool known_algorithm(const std::string& algorithm) {
  const int a = nlopt_algorithm_from_string(algorithm.c_str());
  return a >= 0 && a < NLOPT_NUM_ALGORITHMS;
}

std::vector<std::string> algorithms() {
  std::vector<std::string> names;
  for (int a = 0; a < NLOPT_NUM_ALGORITHMS; ++a)
    names.emplace_back(nlopt_algorithm_to_string(static_cast<nlopt_algorithm>(a)));
  return names;
}

SearchResult minimize(const Measure& measure, const std::vector<Bounds>& bounds,
                      const std::vector<double>& start, const SearchOptions& options) {
  if (bounds.empty() || bounds.size() != start.size())
    throw std::invalid_argument("a search needs at least one variable, and a start for each");
  for (const std::string& name : {options.algorithm, options.local_algorithm})
    if (!name.empty()) (void)by_name(name);  // before the first run takes it for an inner search
  Search search(measure, bounds, options);
  const int all = options.max_evaluations;
  const double precision = options.relative_precision;
  if (!options.algorithm.empty()) {
    const nlopt::algorithm algorithm = by_name(options.algorithm);
    if (options.local_algorithm.empty()) {
      search.run(algorithm, start, all, precision);
    } else {
      search.run(algorithm, start, std::max(1, all / 2), precision);
      search.run(by_name(options.local_algorithm), search.result().x, all, precision);
    }
    return search.result();
  }
  const auto n = static_cast<int>(bounds.size());
  const bool constrained = [&] {
    search.run(nlopt::LN_COBYLA, start, 1, 0);
    return !search.result().measured.margins.empty();
  }();
  const nlopt::algorithm local =
      constrained ? nlopt::LN_COBYLA : (n == 1 ? nlopt::LN_SBPLX : nlopt::LN_BOBYQA);
  const int share = std::max(1, all / 4);
  if (options.global) search.run(nlopt::GN_DIRECT_L, start, std::min(share, 100 * n), 0);
  const bool exact = static_cast<bool>(options.slopes);
  const nlopt::algorithm first = exact ? nlopt::LD_SLSQP : local;
  const auto polish = [&](bool last) {
    if (exact) search.run(nlopt::LD_SLSQP, search.result().x, share, precision);
    if (!exact || last) search.run(local, std::vector<double>(search.result().x), share, precision);
    if (constrained && (exact ? last : options.differences))
      search.run(nlopt::LD_SLSQP, search.result().x, share, precision);
  };
  polish(!options.global);
  if (options.global) {
    search.run(first, start, share, precision);
    for (int k = 0; k < options.starts; ++k)
      search.run(first, scattered(bounds, options.seed, k), std::max(1, share / std::max(1, options.starts)),
                 precision);
    // Once more from the best point: the trust region starts wide again.
    polish(true);
  }
  return search.result();
}

// ---------------------------------------------------------------------------------------- mixed variables
namespace {

constexpr double most_enumerated_searches = 64;    // settings, each with a continuous search
constexpr double most_enumerated_points = 20'000;  // settings without continuous variables

class MixedSearch {
 public:
  MixedSearch(const Measure& measure, const std::vector<Dimension>& dimensions, const SearchOptions& options)
      : measure_(measure), dimensions_(dimensions), options_(options) {
    for (std::size_t k = 0; k < dimensions.size(); ++k) {
      if (dimensions[k].discrete) {
        discrete_.push_back(k);
        settings_ *= dimensions[k].bounds.high - dimensions[k].bounds.low + 1;
      } else {
        continuous_.push_back(k);
        bounds_.push_back(dimensions[k].bounds);
      }
    }
  }

  SearchResult run(std::vector<double> start) {
    for (std::size_t k = 0; k < start.size(); ++k) {
      const Bounds& b = dimensions_[k].bounds;
      start[k] = std::clamp(start[k], b.low, b.high);
      if (dimensions_[k].discrete) start[k] = std::round(start[k]);
    }
    if (discrete_.empty()) return minimize(measure_, bounds_, start, options_);
    const double cheap = continuous_.empty() ? most_enumerated_points : most_enumerated_searches;
    if (settings_ <= cheap) {
      enumerate(start);
    } else {
      // Set aside for the end: the plan that wins is searched with full precision.
      if (!continuous_.empty())
        reserve_ = std::min(options_.max_evaluations / 5, 200 * static_cast<int>(bounds_.size()));
      descend(start);
      for (int k = 0; k < options_.starts && left() > 0; ++k) {
        std::vector<Bounds> box;
        for (const Dimension& d : dimensions_) box.push_back(d.bounds);
        std::vector<double> x = scattered(box, options_.seed, 1000 + k);
        for (const std::size_t d : discrete_) x[d] = std::round(x[d]);
        descend(x);
      }
      // What one change at a time does not reach, two may.
      descend(best_.x, true);
      reserve_ = 0;
      if (!continuous_.empty()) (void)solve(best_.x, left(), false, true);
    }
    best_.evaluations = used_;
    return best_;
  }

 private:
  [[nodiscard]] int left() const { return options_.max_evaluations - used_ - reserve_; }

  // The best continuous coordinates at the discrete ones of `x`. `evaluations` at most.
  SearchResult solve(const std::vector<double>& x, int evaluations, bool global, bool precise = false) {
    SearchResult found;
    evaluations = std::min(evaluations, left());
    if (evaluations < 1) {
      found.x = x;
      found.measured.value = std::numeric_limits<double>::infinity();
      return found;
    }
    if (continuous_.empty()) {
      found = point(x);
    } else {
      SearchOptions inner = options_;
      inner.max_evaluations = evaluations;
      inner.global = global && options_.global;
      if (!inner.global) {
        inner.algorithm.clear();
        if (!precise) inner.relative_precision = std::max(inner.relative_precision, 1e-6);
      }
      std::vector<double> start;
      for (const std::size_t c : continuous_) start.push_back(x[c]);
      std::vector<double> whole = x;
      if (options_.slopes)
        inner.slopes = [&](const std::vector<double>& part) -> std::optional<MeasuredSlopes> {
          for (std::size_t k = 0; k < part.size(); ++k) whole[continuous_[k]] = part[k];
          const auto all = options_.slopes(whole);
          if (!all) return std::nullopt;
          MeasuredSlopes own{.margins = std::vector<std::vector<double>>(all->margins.size())};
          for (const std::size_t c : continuous_) {
            own.value.push_back(all->value[c]);
            for (std::size_t m = 0; m < own.margins.size(); ++m) own.margins[m].push_back(all->margins[m][c]);
          }
          return own;
        };
      found = minimize(
          [&](const std::vector<double>& part) {
            for (std::size_t k = 0; k < part.size(); ++k) whole[continuous_[k]] = part[k];
            return measure_(whole);
          },
          bounds_, start, inner);
      used_ += found.evaluations;
      std::vector<double> full = x;
      for (std::size_t k = 0; k < found.x.size(); ++k) full[continuous_[k]] = found.x[k];
      found.x = std::move(full);
    }
    if (best_.x.empty() || better(found, best_)) best_ = found;
    return found;
  }

  SearchResult point(const std::vector<double>& x) {
    SearchResult found{.x = x, .measured = measure_(x)};
    ++used_;
    found.feasible = violation(found.measured) == 0;
    return found;
  }

  void enumerate(const std::vector<double>& start) {
    const int share = std::max(1, static_cast<int>(options_.max_evaluations / settings_));
    std::vector<double> x = start;
    for (const std::size_t d : discrete_) x[d] = dimensions_[d].bounds.low;
    for (;;) {
      (void)solve(x, share, true);
      std::size_t k = 0;
      for (; k < discrete_.size(); ++k) {
        const std::size_t d = discrete_[k];
        if (x[d] < dimensions_[d].bounds.high) {
          x[d] += 1;
          break;
        }
        x[d] = dimensions_[d].bounds.low;
      }
      if (k == discrete_.size()) break;
    }
    // The winner once more with all that is left.
    if (!continuous_.empty()) (void)solve(best_.x, left(), true);
  }

  [[nodiscard]] std::vector<std::vector<double>> neighbours(const std::vector<double>& x, bool pairs) const {
    struct Step {
      std::size_t dimension;
      double to;
    };
    std::vector<Step> steps;
    for (const std::size_t d : discrete_) {
      const Bounds& b = dimensions_[d].bounds;
      if (dimensions_[d].ordered) {
        // Long steps first get out of flat places.
        for (const double step : {1.0, -1.0, 4.0, -4.0})
          if (x[d] + step >= b.low && x[d] + step <= b.high) steps.push_back({d, x[d] + step});
      } else {
        for (double to = b.low; to <= b.high; to += 1)
          if (to != x[d]) steps.push_back({d, to});
      }
    }
    std::vector<std::vector<double>> all;
    for (std::size_t a = 0; a < steps.size(); ++a) {
      std::vector<double> one = x;
      one[steps[a].dimension] = steps[a].to;
      if (!pairs) all.push_back(one);
      for (std::size_t b = a + 1; pairs && b < steps.size(); ++b) {
        if (steps[b].dimension == steps[a].dimension) continue;
        std::vector<double> two = one;
        two[steps[b].dimension] = steps[b].to;
        all.push_back(std::move(two));
      }
    }
    return all;
  }

  void descend(const std::vector<double>& start, bool pairs = false) {
    const int share =
        std::max(20, std::min(options_.max_evaluations / 12, 60 * static_cast<int>(bounds_.size())));
    SearchResult here = pairs ? best_ : solve(start, 2 * share, true);
    bool moved = true;
    while (moved && left() > 0) {
      moved = false;
      // Looked at without moving the continuous coordinates first, then searched in that order.
      std::vector<SearchResult> looks;
      for (const auto& x : neighbours(here.x, pairs)) {
        if (left() < 1) break;
        looks.push_back(point(x));
        if (better(looks.back(), best_)) best_ = looks.back();
      }
      std::stable_sort(looks.begin(), looks.end(), better);
      const std::size_t tries = std::min<std::size_t>(pairs ? 4 : 8, looks.size());
      for (std::size_t k = 0; k < tries && left() > 0; ++k) {
        const SearchResult there = continuous_.empty() ? looks[k] : solve(looks[k].x, share, false);
        if (!better(there, here)) continue;
        here = there;
        moved = true;
        break;
      }
    }
  }

  const Measure& measure_;
  const std::vector<Dimension>& dimensions_;
  const SearchOptions& options_;
  std::vector<std::size_t> discrete_;
  std::vector<std::size_t> continuous_;
  std::vector<Bounds> bounds_;
  double settings_ = 1;
  SearchResult best_;
  int used_ = 0;
  int reserve_ = 0;
};

}  // namespace

SearchResult minimize_mixed(const Measure& measure, const std::vector<Dimension>& dimensions,
                            const std::vector<double>& start, const SearchOptions& options) {
  if (dimensions.empty() || dimensions.size() != start.size())
    throw std::invalid_argument("a search needs at least one variable, and a start for each");
  return MixedSearch(measure, dimensions, options).run(start);
}

}  // namespace verstat::optimize
