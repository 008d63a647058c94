#include "optimize/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "models/catalogue/closest.h"
#include "models/catalogue/shortened.h"
#include "sim/kernel/output_analysis.h"
#include "sim/kernel/random_stream.h"

namespace verstat::optimize {

using nlohmann::json;
using scenarios::Change;
using scenarios::InputError;
using scenarios::Scenario;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// The stages of one study share what they have found.
class Run {
 public:
  Run(Problem& problem, Ledger& ledger, const StudyTools& tools)
      : problem_(problem), study_(problem.study()), ledger_(ledger), tools_(tools) {
    seed_ = problem.typed_scenario_at(start()).simulation.seed.value;
    for (const ObjectiveSpec& o : study_.objectives)
      if (!o.kpi.empty()) column_of(o.kpi);
    for (const Condition& c : problem.conditions())
      if (c.kind == Condition::Kind::kpi) column_of(c.item);
    if (study_.robust.samples > 0) make_samples();
  }

  StudyAnswer answer() {
    answer_.baseline = problem_.baseline();
    answer_.not_covered = problem_.not_covered();
    if (covered()) {
      const Look look = problem_.look_at_baseline();
      answer_.baseline_value = finite(look.objectives.at(0));
      for (const Checked& c : look.conditions)
        answer_.baseline_feasible = answer_.baseline_feasible && c.margin >= -margin_tolerance;
    }
    try {
      stages();
    } catch (const Interrupted& why) {
      answer_.interrupted = why.what();
      // Before stage two has judged anything, the best of stage one stands.
      if (!answer_.best && answer_.analytic && answer_.analytic->feasible) answer_.best = answer_.analytic;
    }
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool covered() const { return problem_.not_covered().empty(); }
  [[nodiscard]] double sign(std::size_t objective) const {
    return study_.objectives[objective].direction == Direction::maximize ? -1 : 1;
  }
  [[nodiscard]] std::vector<double> start() const {
    std::vector<double> x = problem_.baseline();
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = std::clamp(x[k], problem_.dimensions()[k].bounds.low, problem_.dimensions()[k].bounds.high);
    return x;
  }
  std::size_t column_of(const std::string& kpi) {
    const auto found = std::find(columns_.begin(), columns_.end(), kpi);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    columns_.push_back(kpi);
    return columns_.size() - 1;
  }

  void make_samples() {
    const auto& inputs = study_.uncertain;
    // Latin hypercube: every input takes every n-th part of its range once.
    const auto n = static_cast<std::size_t>(study_.robust.samples);
    std::vector<std::vector<Shift>> samples(n);
    for (const UncertainSpec& input : inputs) {
      sim::RandomStream stream(seed_, input.pointer, "uncertain input");
      std::vector<std::size_t> order(n);
      for (std::size_t k = 0; k < n; ++k) order[k] = k;
      for (std::size_t k = n; k > 1; --k) std::swap(order[k - 1], order[stream.below(k)]);
      for (std::size_t k = 0; k < n; ++k) {
        const double u = (static_cast<double>(order[k]) + stream.uniform()) / static_cast<double>(n);
        samples[k].push_back({input.pointer, 1 + input.relative * (2 * u - 1)});
      }
    }
    for (auto& shifts : samples)
      samples_.push_back(std::make_unique<Problem>(study_, problem_.scenario(), std::move(shifts)));
  }

  // ------------------------------------------------------------------------------------- stage one
  Problem::Outcome long_run(const std::vector<double>& x) {
    if (samples_.empty()) return problem_.evaluate(x);
    Problem::Outcome all;
    for (const auto& sample : samples_) {
      const Problem::Outcome one = sample->evaluate(x);
      if (all.objectives.empty()) {
        all = one;
        continue;
      }
      const bool worst = study_.robust.measure == RobustMeasure::worst;
      for (std::size_t k = 0; k < all.objectives.size(); ++k)
        all.objectives[k] =
            worst ? std::max(all.objectives[k], one.objectives[k]) : all.objectives[k] + one.objectives[k];
      for (std::size_t k = 0; k < all.margins.size(); ++k)
        all.margins[k] = std::min(all.margins[k], one.margins[k]);
    }
    if (study_.robust.measure == RobustMeasure::mean)
      for (double& objective : all.objectives) objective /= static_cast<double>(samples_.size());
    return all;
  }

  // Gradients of the first objective and the margins in the long run; no trial: they belong to one.
  std::optional<MeasuredSlopes> long_run_slopes(const std::vector<double>& x) {
    if (samples_.empty()) return measured(problem_.slopes(x));
    const bool worst = study_.robust.measure == RobustMeasure::worst;
    const auto share = static_cast<double>(samples_.size());
    MeasuredSlopes all;
    Problem::Outcome least;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const auto one = measured(samples_[s]->slopes(x));
      if (!one) return std::nullopt;
      const Problem::Outcome outcome = samples_[s]->evaluate(x);
      if (s == 0) {
        all = *one;
        least = outcome;
        if (!worst)
          for (double& slope : all.value) slope /= share;
        continue;
      }
      if (worst && outcome.objectives[0] > least.objectives[0]) {
        all.value = one->value;
        least.objectives[0] = outcome.objectives[0];
      }
      for (std::size_t k = 0; !worst && k < x.size(); ++k) all.value[k] += one->value[k] / share;
      for (std::size_t c = 0; c < outcome.margins.size(); ++c)
        if (outcome.margins[c] < least.margins[c]) {
          all.margins[c] = one->margins[c];
          least.margins[c] = outcome.margins[c];
        }
    }
    return all;
  }

  // Objectives and margins of a point in the long run: a trial.
  ManyMeasured analytic(const std::vector<double>& x) {
    const std::size_t objectives = study_.objectives.size();
    const auto& outcome = ledger_.ask({.stage = "analytic", .x = x}, [&](Trial& trial) {
      const Problem::Outcome o = long_run(x);
      trial.outcome = o.objectives;
      trial.outcome.insert(trial.outcome.end(), o.margins.begin(), o.margins.end());
      trial.objective = finite(shown_value(study_.objective, o.objectives[0]));
      trial.feasible = violation({o.objectives[0], o.margins}) == 0;
    });
    ManyMeasured m{{outcome.begin(), outcome.begin() + static_cast<std::ptrdiff_t>(objectives)},
                   {outcome.begin() + static_cast<std::ptrdiff_t>(objectives), outcome.end()}};
    if (!simulating_) {
      ++asked_;
      note(x, {m.objectives[0], m.margins}, "analytic");
    }
    if (!simulating_) report(objectives > 1 ? "front" : "analytic", asked_, study_.search.max_evaluations);
    return m;
  }

  void note(const std::vector<double>& x, const Measured& m, const std::string& stage) {
    const SearchResult candidate{.x = x, .measured = m, .feasible = violation(m) == 0};
    if (!incumbent_.x.empty() && !better(candidate, incumbent_)) return;
    incumbent_ = candidate;
    if (candidate.feasible) answer_.best = Candidate{x, shown_value(study_.objective, m.value), true, stage};
  }

  void report(const std::string& stage, std::int64_t trials, std::int64_t of) {
    if (!tools_.progress) return;
    tools_.progress({stage, trials, of, answer_.best ? std::optional(answer_.best->value) : std::nullopt});
  }

  void stages() {
    const SearchOptions search = search_options(study_, seed_);
    if (study_.objectives.size() > 1) {
      make_front(search);
      return;
    }
    std::vector<std::vector<double>> starts{start()};
    if (covered()) {
      SearchOptions exact = search;
      exact.slopes = [this](const std::vector<double>& x) { return long_run_slopes(x); };
      const SearchResult found = minimize_mixed(
          [&](const std::vector<double>& x) {
            const ManyMeasured m = analytic(x);
            return Measured{m.objectives[0], m.margins};
          },
          problem_.dimensions(), start(), exact);
      answer_.analytic =
          Candidate{found.x, shown_value(study_.objective, found.measured.value), found.feasible, "analytic"};
      starts.insert(starts.begin(), found.x);
      if (starts[0] == starts[1]) starts.pop_back();
    }
    if (study_.simulation.trials > 0) {
      answer_.best.reset();  // what the long run believed is judged again
      incumbent_ = {};
      simulating_ = true;
      refine_and_choose(starts);
    }
  }

  // ------------------------------------------------------------------------- stages two and three
  // Replications of a point: a trial. Points that are no shop, or cannot be simulated, have no values.
  Rows simulate(const std::string& stage, const std::vector<double>& x, std::int64_t first,
                std::int64_t count, std::uint64_t seed) {
    const Trial question{.stage = stage, .x = x, .first_replication = first, .replications = count};
    const auto& outcome = ledger_.ask(question, [&](Trial& trial) {
      trial.outcome.assign(static_cast<std::size_t>(count) * columns_.size(), missing);
      try {
        Scenario scenario = scenarios::load(problem_.scenario_at(x));
        scenario.simulation.seed.value = seed;
        const shop::RunResult run = tools_.simulate(scenario, static_cast<std::uint64_t>(first), count);
        std::size_t at = 0;
        for (const auto& values : run.values)
          for (const std::string& column : columns_) {
            const auto k = run.index_of(column);
            trial.outcome[at++] = k ? values[*k].value_or(missing) : missing;
          }
        const auto k = run.index_of(study_.objective.kpi);
        if (k) {
          trial.objective = run.estimates[*k].mean;
          trial.half_width = run.estimates[*k].half_width;
        }
      } catch (const Interrupted&) {
        throw;
      } catch (const InputError&) {
        trial.feasible = false;
      } catch (const models::ModelError&) {
        trial.feasible = false;
      }
    });
    Rows rows;
    for (std::size_t r = 0; r < static_cast<std::size_t>(count); ++r)
      rows.emplace_back(outcome.begin() + static_cast<std::ptrdiff_t>(r * columns_.size()),
                        outcome.begin() + static_cast<std::ptrdiff_t>((r + 1) * columns_.size()));
    return rows;
  }

  NoisyProblem noisy() {
    NoisyProblem p{.dimensions = problem_.dimensions(),
                   .sample =
                       [this](const std::vector<double>& x, std::int64_t first, std::int64_t count) {
                         Rows rows = simulate("simulation", x, first, count, seed_);
                         ++asked_;
                         report("simulation", asked_, study_.simulation.trials);
                         return rows;
                       },
                   .objective = 0,
                   .sign = sign(0)};
    for (const Condition& c : problem_.conditions())
      if (c.kind == Condition::Kind::kpi)
        p.constraints.push_back({column_of(c.item), c.at_most, c.allowed, c.confidence});
    p.exact_margins = [this](const std::vector<double>& x) {
      const Problem::Outcome o = problem_.evaluate(x);
      std::vector<double> exact;
      for (std::size_t k = 0; k < o.margins.size(); ++k)
        if (problem_.conditions()[k].kind != Condition::Kind::kpi) exact.push_back(o.margins[k]);
      return exact;
    };
    return p;
  }

  // The long run solved again with what simulation adds to it: at every plan it proposes the difference
  // between simulation and long run, of the objective and of every simulated constraint, is taken over for
  // all plans with the same discrete settings (output space mapping: Bandler et al., IEEE Trans. MTT 52
  // (2004) 337). A setting not simulated yet is believed as the long run has it, and so is tried when it
  // might pay. Few simulations bring the start of stage two to the right side of its constraints. Returns the
  // plans proposed, best first.
  std::vector<SearchResult> correct_long_run(const NoisyProblem& problem, std::vector<double> start) {
    struct Correction {
      double objective = 0;
      std::vector<double> margins;
    };
    std::map<std::vector<double>, Correction> corrections;
    const auto settings_of = [&](const std::vector<double>& x) {
      std::vector<double> key;
      for (std::size_t k = 0; k < x.size(); ++k)
        if (problem_.dimensions()[k].discrete) key.push_back(x[k]);
      return key;
    };
    const auto corrected = [&](const std::vector<double>& x) {
      const ManyMeasured m = analytic(x);
      Measured one{m.objectives[0], m.margins};
      const auto known = corrections.find(settings_of(x));
      if (known == corrections.end()) return one;
      one.value += known->second.objective;
      for (std::size_t k = 0; k < one.margins.size(); ++k) one.margins[k] += known->second.margins[k];
      return one;
    };
    const std::int64_t n0 = study_.simulation.first_replications;
    std::vector<SearchResult> proposed;
    std::vector<double> x = std::move(start);
    constexpr int most_rounds = 10;
    for (int round = 0; round < most_rounds; ++round) {
      // In the blocks in which the refinement asks, so that its questions are answered already.
      Rows rows = problem.sample(x, 0, n0);
      for (std::int64_t level = 1; level < study_.simulation.levels; ++level) {
        const auto have = static_cast<std::int64_t>(rows.size());
        const Rows more = problem.sample(x, have, have);
        rows.insert(rows.end(), more.begin(), more.end());
      }
      SearchResult now{.x = x, .measured = judge(problem, rows, x)};
      now.feasible = violation(now.measured) == 0;
      proposed.push_back(now);
      const ManyMeasured believed = analytic(x);
      Correction c{.objective = now.measured.value - believed.objectives[0],
                   .margins = std::vector<double>(believed.margins.size(), 0.0)};
      if (!std::isfinite(c.objective)) break;
      // A third of the allowance for noise on top, so that the plan keeps its constraints on other samples,
      // too.
      const std::vector<double> allowances = confidence_allowances(problem, rows);
      std::size_t noisy_constraint = 0;
      for (std::size_t k = 0; k < c.margins.size(); ++k)
        if (problem_.conditions()[k].kind == Condition::Kind::kpi) {
          c.margins[k] =
              now.measured.margins[noisy_constraint] - believed.margins[k] - allowances[noisy_constraint];
          ++noisy_constraint;
        }
      corrections[settings_of(x)] = c;
      SearchOptions search = search_options(study_, seed_);
      search.max_evaluations = std::max(200, search.max_evaluations / 4);
      // A correction is constant as long as the discrete settings stay.
      search.slopes = [this](const std::vector<double>& at) { return long_run_slopes(at); };
      std::vector<double> next = minimize_mixed(corrected, problem_.dimensions(), x, search).x;
      const bool same = std::any_of(proposed.begin(), proposed.end(), [&](const SearchResult& p) {
        bool close = settings_of(p.x) == settings_of(next);
        for (std::size_t k = 0; close && k < next.size(); ++k) {
          const Bounds& b = problem_.dimensions()[k].bounds;
          close = std::abs(p.x[k] - next[k]) <= 1e-4 * (b.high - b.low);
        }
        return close;
      });
      if (same) break;
      x = std::move(next);
    }
    std::stable_sort(proposed.begin(), proposed.end(), better);
    return proposed;
  }

  void refine_and_choose(std::vector<std::vector<double>> starts) {
    asked_ = 0;
    const NoisyProblem problem = noisy();
    std::vector<SearchResult> proposed;
    if (covered() && samples_.empty()) {
      proposed = correct_long_run(problem, starts.front());
      starts.clear();
      for (const SearchResult& p : proposed) starts.push_back(p.x);
    }
    const std::size_t most_starts = 2;
    std::vector<std::vector<double>> from(
        starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(std::min(starts.size(), most_starts)));
    const Refined refined = refine(problem, from,
                                   {.trials = study_.simulation.trials,
                                    .first_replications = study_.simulation.first_replications,
                                    .levels = study_.simulation.levels,
                                    .neighbourhood = study_.simulation.neighbourhood,
                                    .seed = seed_});
    std::vector<SearchResult> candidates = refined.finalists;
    for (const SearchResult& p : proposed)
      if (std::none_of(candidates.begin(), candidates.end(),
                       [&](const SearchResult& r) { return r.x == p.x; }))
        candidates.push_back(p);
    std::stable_sort(candidates.begin(), candidates.end(), better);
    for (const SearchResult& r : candidates) note(r.x, r.measured, "simulation");
    std::vector<std::vector<double>> finalists;
    for (const SearchResult& r : candidates)
      if (finalists.size() < static_cast<std::size_t>(study_.choice.finalists) &&
          (r.feasible || finalists.empty()))
        finalists.push_back(r.x);
    choose(problem, finalists);
  }

  void choose(const NoisyProblem& problem, const std::vector<std::vector<double>>& points) {
    const ChoiceSpec& spec = study_.choice;
    const std::uint64_t fresh = stage_seed(seed_, "choice");
    std::int64_t asked = 0;
    const auto rows = [&](std::size_t i, std::int64_t first, std::int64_t count) {
      Rows r = simulate("choice", points[i], first, count, fresh);
      report("choice", ++asked, 0);
      return r;
    };
    Choice choice{.confidence = spec.confidence};
    // First the constraints, on samples that double until they are clear or the budget ends. The looks share
    // the confidence between them.
    std::vector<Rows> samples(points.size());
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < points.size(); ++i) {
      samples[i] = rows(i, 0, spec.first_replications);
      Measured m = judge(problem, samples[i], points[i]);
      while (!problem.constraints.empty() && violation(m) > 0 && std::isfinite(m.value) &&
             static_cast<std::int64_t>(2 * samples[i].size()) <= spec.max_replications &&
             could_be_met(problem, samples[i])) {
        const auto have = static_cast<std::int64_t>(samples[i].size());
        Rows more = rows(i, have, have);
        samples[i].insert(samples[i].end(), more.begin(), more.end());
        m = judge(problem, samples[i], points[i]);
      }
      Finalist f{.x = points[i], .feasible = violation(m) == 0};
      if (f.feasible) in.push_back(i);
      fill(f, samples[i]);
      choice.finalists.push_back(std::move(f));
    }
    if (in.empty()) {
      answer_.choice = std::move(choice);
      return;
    }
    double typical = 0;
    for (const std::size_t i : in)
      typical = std::max(typical, std::abs(choice.finalists[i].mean.value_or(0)));
    choice.indifference = spec.indifference * (typical > 0 ? typical : 1);
    const Ranking ranking = select_smallest(
        in.size(),
        [&](std::size_t system, std::int64_t first, std::int64_t count) {
          const std::size_t i = in[system];
          std::vector<double> values;
          for (std::int64_t r = first; r < first + count; ++r) {
            if (r >= static_cast<std::int64_t>(samples[i].size())) {
              Rows more = rows(i, r, first + count - r);
              samples[i].insert(samples[i].end(), more.begin(), more.end());
            }
            const double value = samples[i][static_cast<std::size_t>(r)][0];
            // A replication without a value ("cost per part" of no part) is as bad as can be.
            values.push_back(std::isfinite(value) ? sign(0) * value : 1e6 * choice.indifference);
          }
          return values;
        },
        {.confidence = spec.confidence,
         .indifference = choice.indifference,
         .first_replications = spec.first_replications,
         .max_replications = std::max(spec.max_replications, spec.first_replications),
         .batch = 5});
    for (std::size_t s = 0; s < in.size(); ++s) {
      Finalist& f = choice.finalists[in[s]];
      f.survived = ranking.systems[s].survived;
      fill(f, samples[in[s]]);
    }
    choice.best = in[ranking.best];
    choice.decided = ranking.decided;
    const Finalist& best = choice.finalists[choice.best];
    answer_.best = Candidate{best.x, best.mean.value_or(missing), true, "choice"};
    answer_.choice = std::move(choice);
  }

  // False when a constraint is violated with confidence: more replications would not help.
  static bool could_be_met(const NoisyProblem& problem, const Rows& rows) {
    NoisyProblem hopeful = problem;
    hopeful.exact_margins = nullptr;
    // The other side of the interval: allowed values moved by twice the half-width.
    for (NoisyConstraint& c : hopeful.constraints) {
      sim::Tally t;
      for (const auto& row : rows)
        if (std::isfinite(row[c.column])) t.add(row[c.column]);
      if (t.count() < 2) return false;
      const double half = sim::confidence_interval(t, 2 * c.confidence - 1).half_width;
      if (c.at_most ? t.mean() - half > c.allowed : t.mean() + half < c.allowed) return false;
    }
    return true;
  }

  void fill(Finalist& f, const Rows& rows) const {
    std::vector<std::optional<double>> values;
    for (const auto& row : rows) values.push_back(finite(row[0]));
    const shop::Estimate e = shop::estimate(values, study_.choice.confidence);
    f.mean = e.mean;
    f.half_width = e.half_width;
    f.replications = static_cast<std::int64_t>(rows.size());
  }

  // ------------------------------------------------------------------------------ several objectives
  void make_front(const SearchOptions& search) {
    const std::size_t m = study_.objectives.size();
    const NoisyProblem noise = noisy();
    const std::int64_t sample = study_.simulation.first_replications;
    const auto measure = [&](const std::vector<double>& x) -> ManyMeasured {
      if (covered()) return analytic(x);
      NoisyProblem one = noise;
      ManyMeasured all;
      const Rows rows = noise.sample(x, 0, sample);
      for (std::size_t k = 0; k < m; ++k) {
        one.objective = column_of(study_.objectives[k].kpi);
        one.sign = sign(k);
        const Measured judged = judge(one, rows, x);
        all.objectives.push_back(judged.value);
        all.margins = judged.margins;
      }
      note(x, {all.objectives[0], all.margins}, "simulation");
      return all;
    };
    SearchOptions options = search;
    // The budget is that of the whole front.
    const std::int64_t all = covered() ? study_.search.max_evaluations : study_.simulation.trials;
    std::int64_t searches = static_cast<std::int64_t>(m);
    std::int64_t combinations = 1;
    for (std::size_t k = 1; k < m; ++k) combinations *= study_.front.points;
    searches += combinations;
    options.max_evaluations = static_cast<int>(std::max<std::int64_t>(10, all / searches));
    const Front front = pareto_front(measure, problem_.dimensions(), start(), m,
                                     static_cast<int>(study_.front.points), options);
    if (front.points.empty()) return;
    FrontAnswer result{.hypervolume = front.hypervolume, .knee = front.knee};
    for (std::size_t k = 0; k < m; ++k) result.reference.push_back(sign(k) * front.reference[k]);
    for (const FrontPoint& p : front.points) {
      FrontEstimate e{.x = p.x};
      for (std::size_t k = 0; k < m; ++k) e.objectives.push_back(sign(k) * p.objectives[k]);
      result.points.push_back(std::move(e));
    }
    const FrontPoint& chosen = front.points[front.knee];
    answer_.best = Candidate{chosen.x, shown_value(study_.objective, chosen.objectives[0]), true,
                             covered() ? "analytic" : "simulation"};
    answer_.analytic = answer_.best;
    answer_.front = result;
    if (study_.front.replications > 0) {
      std::int64_t done = 0;
      for (FrontEstimate& e : answer_.front->points) {
        const Rows rows = simulate("front", e.x, 0, study_.front.replications, stage_seed(seed_, "front"));
        report("front simulated", ++done, static_cast<std::int64_t>(answer_.front->points.size()));
        for (std::size_t k = 0; k < m; ++k) {
          std::vector<std::optional<double>> values;
          for (const auto& row : rows) values.push_back(finite(row[column_of(study_.objectives[k].kpi)]));
          const shop::Estimate estimate = shop::estimate(values, study_.confirmation.confidence);
          e.means.push_back(estimate.mean);
          e.half_widths.push_back(estimate.half_width);
        }
      }
    }
  }

  Problem& problem_;
  const StudySpec& study_;
  Ledger& ledger_;
  const StudyTools& tools_;
  std::uint64_t seed_ = 0;
  std::vector<std::string> columns_;  // KPIs that trials keep, objectives first
  std::vector<std::unique_ptr<Problem>> samples_;
  StudyAnswer answer_;
  SearchResult incumbent_;
  std::int64_t asked_ = 0;
  bool simulating_ = false;  // stage one is over
};

// What a variable may become must be covered, too: a strategy among the options, a time that is zero today.
void check_covered_within(const Problem& problem) {
  const std::vector<Variable>& variables = problem.study().variables;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const Variable& v = variables[k];
    std::vector<double> ends{v.low, v.high};
    if (v.type == VariableType::categorical)
      for (double option = v.low + 1; option < v.high; option += 1) ends.push_back(option);
    for (const double x : ends) try {
        const Scenario there =
            scenarios::load(scenarios::apply(problem.scenario(), {{v.pointer, value_at(v, x)}}));
        (void)LongRunModel(there);
      } catch (const InputError& e) {
        throw InputError(
            "/simulation/trials",
            fmt::format("/simulation/trials = 0, but with /variables/{} at {} only simulation can tell: {}",
                        k, models::shortened(text_at(v, x), 200), e.what()));
      } catch (const models::ModelError&) {
        // A regime that the process models refuse: an undefined point.
      } catch (const models::DomainError&) {
      }
  }
}

}  // namespace

void check_study(const Problem& problem) {
  const StudySpec& study = problem.study();
  if (!problem.not_covered().empty() && study.simulation.trials == 0)
    throw InputError(
        "/simulation/trials",
        fmt::format("/simulation/trials = 0, but {}: only simulation can tell, so it needs trials",
                    problem.not_covered()));
  const bool long_run = std::any_of(study.objectives.begin(), study.objectives.end(),
                                    [](const ObjectiveSpec& o) { return !o.kpi.empty(); }) ||
                        std::any_of(study.constraints.begin(), study.constraints.end(),
                                    [](const ConstraintSpec& c) { return !c.kpi.empty(); });
  if (long_run && study.simulation.trials == 0) check_covered_within(problem);
  if (study.robust.samples > 0 && study.uncertain.empty())
    throw InputError("/robust", "/robust: say in /uncertain which inputs are uncertain, and by how much");
  for (const UncertainSpec& input : study.uncertain)
    (void)Problem(study, problem.scenario(), {{input.pointer, 1.0}});
  // KPIs that are only simulated must exist in the simulation, and the confirmation simulates the first.
  std::vector<std::string> names;
  for (const auto& info : shop::kpi_infos(scenarios::load(problem.scenario()))) names.push_back(info.name);
  const auto check = [&](const std::string& kpi, const std::string& at) {
    if (std::find(names.begin(), names.end(), kpi) == names.end())
      throw InputError(
          at, fmt::format("{} = \"{}\", there is no such KPI in a run of the scenario; closest: \"{}\"", at,
                          models::shortened(kpi, 100), models::closest(kpi, names)));
  };
  const bool simulates = study.simulation.trials > 0 || study.front.replications > 0;
  for (std::size_t k = 0; k < study.objectives.size(); ++k) {
    const ObjectiveSpec& o = study.objectives[k];
    if (!o.function.empty() && simulates)
      throw InputError(
          study.simulation.trials > 0 ? "/simulation/trials" : "/front/replications",
          fmt::format("{}: the objective is an output of {}, which no simulation knows; leave it out",
                      study.simulation.trials > 0 ? "/simulation/trials" : "/front/replications",
                      o.function));
    // The first is what the confirmation simulates.
    if (o.function.empty() && (k == 0 || simulates))
      check(o.kpi, study.objectives.size() > 1 ? fmt::format("/objectives/{}/kpi", k) : "/objective/kpi");
  }
  // Of every constraint on a KPI there is one condition, in the same order.
  auto condition = problem.conditions().begin();
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    const std::string& kpi = study.constraints[k].kpi;
    if (kpi.empty()) continue;
    while (condition->kind != Condition::Kind::kpi) ++condition;
    const bool known = (condition++)->long_run_kpi.has_value();
    if (study.simulation.trials > 0 || !known) check(kpi, fmt::format("/constraints/{}/kpi", k));
    if (study.simulation.trials == 0 && !known)
      throw InputError(
          "/simulation/trials",
          fmt::format("/simulation/trials = 0, but only simulation knows \"{}\" of a constraint", kpi));
  }
}

StudyAnswer run_study(Problem& problem, Ledger& ledger, const StudyTools& tools) {
  return Run(problem, ledger, tools).answer();
}

std::uint64_t stage_seed(std::uint64_t seed, const std::string& stage) {
  return sim::RandomStream(seed, "study", stage).bits();
}

SearchOptions search_options(const StudySpec& study, std::uint64_t seed) {
  return {.algorithm = study.search.algorithm,
          .local_algorithm = study.search.local_algorithm,
          .max_evaluations = static_cast<int>(study.search.max_evaluations),
          .relative_precision = study.search.relative_precision,
          .starts = static_cast<int>(study.search.starts),
          .seed = seed};
}

std::vector<Change> confirmation_changes(const StudySpec& study, std::uint64_t seed) {
  return {{"/simulation/seed", std::to_string(stage_seed(seed, "confirmation"))},
          {"/simulation/replications", study.confirmation.replications}};
}

Confirmation confirm(const StudySpec& study, shop::RunResult baseline, shop::RunResult best) {
  Confirmation result{.baseline = std::move(baseline), .best = std::move(best)};
  const bool maximize = study.objective.direction == Direction::maximize;
  const shop::RunResult& from = maximize ? result.baseline : result.best;
  const shop::RunResult& to = maximize ? result.best : result.baseline;
  result.saving = shop::paired_difference(from, to, study.objective.kpi, study.confirmation.confidence);
  if (!result.saving.mean || !result.saving.half_width ||
      std::abs(*result.saving.mean) <= *result.saving.half_width)
    result.verdict = "not distinguishable";
  else
    result.verdict = *result.saving.mean > 0 ? "better" : "worse";
  return result;
}

}  // namespace verstat::optimize
