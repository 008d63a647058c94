#include "optimize/search.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include <nlopt.hpp>

namespace verstat::optimize {
namespace {

// Stands for an undefined objective: finite, because NLopt mistakes NaN and infinity for success or failure.
constexpr double penalty = 1e100;

class Search {
 public:
  Search(const Objective& objective, const std::vector<Bounds>& bounds, const SearchOptions& options)
      : objective_(objective), bounds_(bounds), options_(options) {
    result_.best.value = std::numeric_limits<double>::infinity();
  }

  void run(nlopt::algorithm algorithm, const std::vector<double>& start, int evaluations, double tolerance) {
    const auto n = static_cast<unsigned>(bounds_.size());
    nlopt::opt opt(algorithm, n);
    nlopt::opt local(nlopt::LN_SBPLX, n);
    local.set_xtol_rel(1e-6);
    opt.set_local_optimizer(local);  // of the algorithms that want one
    opt.set_lower_bounds(0.0);
    opt.set_upper_bounds(1.0);
    opt.set_min_objective(&Search::call, this);
    opt.set_maxeval(evaluations);
    if (tolerance > 0) opt.set_xtol_abs(tolerance);
    nlopt::srand(options_.seed);  // in this thread, right before the search
    budget_ = result_.evaluations.size() + static_cast<std::size_t>(evaluations);
    std::vector<double> x = scaled(start);
    double value = 0;
    try {
      opt.optimize(x, value);
    } catch (const nlopt::roundoff_limited&) {
      // As far as doubles go; the incumbent stands.
    } catch (const std::exception&) {
      // NLopt replaces the objective's exception by one of its own; ours is kept in error_.
      if (!error_ && result_.evaluations.empty()) throw;
    }
    if (error_) std::rethrow_exception(error_);
  }

  SearchResult take() { return std::move(result_); }
  [[nodiscard]] std::vector<double> best() const { return result_.best.x; }

 private:
  static double call(const std::vector<double>& u, std::vector<double>&, void* self) {
    return static_cast<Search*>(self)->evaluate(u);
  }

  double evaluate(const std::vector<double>& u) {
    // Some algorithms overshoot maxeval or go on after an error: nothing more is computed then.
    if (error_ || result_.evaluations.size() >= budget_) return penalty;
    Evaluation e{.x = std::vector<double>(u.size())};
    for (std::size_t k = 0; k < u.size(); ++k) {
      const Bounds& b = bounds_[k];
      e.x[k] = std::clamp(b.low + std::clamp(u[k], 0.0, 1.0) * (b.high - b.low), b.low, b.high);
    }
    try {
      e.value = objective_(e.x);
    } catch (...) {
      error_ = std::current_exception();
      throw nlopt::forced_stop();
    }
    if (!std::isfinite(e.value)) e.value = std::numeric_limits<double>::infinity();
    if (e.value < result_.best.value || result_.best.x.empty()) result_.best = e;
    result_.evaluations.push_back(e);
    return std::min(e.value, penalty);
  }

  [[nodiscard]] std::vector<double> scaled(const std::vector<double>& x) const {
    std::vector<double> u(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double width = bounds_[k].high - bounds_[k].low;
      u[k] = width > 0 ? std::clamp((x[k] - bounds_[k].low) / width, 0.0, 1.0) : 0.0;
    }
    return u;
  }

  const Objective& objective_;
  const std::vector<Bounds>& bounds_;
  const SearchOptions& options_;
  SearchResult result_;
  std::exception_ptr error_;
  std::size_t budget_ = 0;
};

}  // namespace

bool known_algorithm(const std::string& algorithm) {
  // "GN_...", "LN_...": the second letter says no derivatives.
  if (algorithm.size() < 2 || algorithm[1] != 'N') return false;
  const int a = nlopt_algorithm_from_string(algorithm.c_str());
  return a >= 0 && a < NLOPT_NUM_ALGORITHMS;
}

SearchResult minimize(const Objective& objective, const std::vector<Bounds>& bounds,
                      const std::vector<double>& start, const SearchOptions& options) {
  if (bounds.empty() || bounds.size() != start.size())
    throw std::invalid_argument("a search needs at least one variable, and a start for each");
  Search search(objective, bounds, options);
  if (!options.algorithm.empty()) {
    if (!known_algorithm(options.algorithm))
      throw std::invalid_argument(
          "algorithm \"" + options.algorithm +
          "\" is unknown or needs derivatives; for instance LN_BOBYQA, LN_COBYLA, LN_SBPLX, "
          "GN_DIRECT_L, GN_CRS2_LM, GN_ISRES");
    const auto algorithm =
        static_cast<nlopt::algorithm>(nlopt_algorithm_from_string(options.algorithm.c_str()));
    search.run(algorithm, start, options.max_evaluations, options.relative_precision);
    return search.take();
  }
  const nlopt::algorithm local = bounds.size() == 1 ? nlopt::LN_SBPLX : nlopt::LN_BOBYQA;
  const int share = std::max(1, options.max_evaluations / 4);
  search.run(nlopt::GN_DIRECT_L, start, share, 0);
  search.run(local, search.best(), share, options.relative_precision);
  search.run(local, start, share, options.relative_precision);
  // Once more from the best point: the trust region starts wide again.
  search.run(local, search.best(), share, options.relative_precision);
  return search.take();
}

}  // namespace verstat::optimize
