// Derivatives of a study's objectives and constraints.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "models/catalogue/error.h"
#include "operations/kinds/turning.h"
#include "optimize/problem_world.h"

namespace verstat::optimize {

using scenarios::InputError;
using scenarios::Scenario;

namespace {

std::size_t index_of(const std::string& token) {
  std::size_t index = 0;
  std::from_chars(token.data(), token.data() + token.size(), index);
  return index;
}

// The operations whose plans hang on the number at this place of the scenario.
std::vector<std::size_t> operations_behind(const Scenario& s, const std::vector<std::string>& place) {
  std::vector<std::size_t> all;
  if (place.size() < 4) return all;
  const std::size_t index = index_of(place[1]);
  for (std::size_t o = 0; o < s.operations.size(); ++o) {
    const scenarios::Operation& operation = s.operations[o];
    bool behind = false;
    if (place[0] == "operations" && place[2] == "process") behind = o == index;
    if (place[0] == "machines" && (place[2] == "limits" || place[2] == "spindle")) {
      const auto groups = scenarios::groups_of(s, operation);
      behind = std::find(groups.begin(), groups.end(), index) != groups.end();
    }
    // The scatter moves the law itself, and a preparation makes another life of the one delivered.
    if (place[0] == "inserts" && place[2] == "edge_life" && place[3] != "cv" &&
        !s.inserts[index].preparation && !operation.tool.empty())
      behind = scenarios::find_named(s.tools, operation.tool)->insert == s.inserts[index].name;
    if (behind) all.push_back(o);
  }
  // What takes parts as one of these leaves them, and what takes them from there.
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t o = 0; o < s.operations.size(); ++o) {
      const auto& incoming = s.operations[o].incoming;
      const bool receives = std::any_of(incoming.begin(), incoming.end(), [&](const scenarios::Incoming& i) {
        return i.from == s.operations[all[k]].name;
      });
      if (receives && std::find(all.begin(), all.end(), o) == all.end()) all.push_back(o);
    }
  return all;
}

// Main time and life of turning are powers of the regime (K117), but where hot spots wear the edge besides
// (K110): their derivatives in closed form.
std::optional<PlanSlope> turning_slope(const Scenario& s, const scenarios::Operation& operation,
                                       const operations::CutPlan& plan, const std::string& member,
                                       double value) {
  const auto* turning = operation.process.as<operations::Turning>();
  if (turning == nullptr || turning->scrap_above_roughness || turning->contact || plan.overload ||
      plan.breakage_probability > 0)
    return std::nullopt;
  double time_power = 0;
  double life_power = 0;
  const bool speed = member == "cutting_speed_m_min";
  const bool feed = member == "feed_mm_rev";
  const bool depth = member == "depth_of_cut_mm";
  if (speed || feed) time_power = -1;
  if (member == "diameter_mm" || member == "length_mm") time_power = 1;
  if (time_power == 0 && !depth) return std::nullopt;
  if (plan.edge) {
    const scenarios::Tool& tool = *scenarios::find_named(s.tools, operation.tool);
    const scenarios::Insert& delivered = *scenarios::find_named(s.inserts, tool.insert);
    const operations::EdgeLife life =
        delivered.preparation ? scenarios::prepared(delivered).edge_life : delivered.edge_life;
    if (speed) life_power = -life.speed_exponent;
    if (feed) life_power = -life.speed_exponent * life.feed_exponent;
    if (depth) life_power = -life.speed_exponent * life.depth_exponent;
  }
  return PlanSlope{.main_time_min = time_power * plan.main_time_min / value,
                   .mean_life_min = plan.edge ? life_power * plan.edge->mean_min / value : 0};
}

PlanSlope difference(const operations::CutPlan& low, const operations::CutPlan& high, double width) {
  const auto overload = [](const operations::CutPlan& plan) {
    return plan.overload.value_or(operations::Overload{});
  };
  return {.main_time_min = (high.main_time_min - low.main_time_min) / width,
          .mean_life_min = low.edge && high.edge ? (high.edge->mean_min - low.edge->mean_min) / width : 0,
          .breakage_probability = (high.breakage_probability - low.breakage_probability) / width,
          .scrap_probability = (high.scrap_probability - low.scrap_probability) / width,
          .trips_per_part = (overload(high).trips_per_part - overload(low).trips_per_part) / width,
          .breaks_per_part = (overload(high).breaks_per_part - overload(low).breaks_per_part) / width};
}

bool hangs_on(const models::Value& inputs, const std::string& pointer) {
  for (const auto& [name, input] : *inputs.map()) {
    const models::Value* inside = input.find("pointer");
    if (inside != nullptr && inside->text() != nullptr && *inside->text() == pointer) return true;
  }
  return false;
}

}  // namespace

struct Problem::Slope {
  std::vector<double> objectives;
  std::vector<double> margins;
};

Problem::Slope Problem::slope(World& world, const Look& look, std::size_t variable) {
  Slope slope{std::vector<double>(study_.objectives.size(), 0.0),
              std::vector<double>(conditions_.size(), 0.0)};
  double* const moved = world.variables[variable];
  if (moved == nullptr) return slope;  // a category without this number
  const Variable& v = study_.variables[variable];
  const double value = *moved;
  const double step = 1e-6 * (v.high - v.low);
  const double low = std::max(v.low, value - step);
  const double high = std::min(v.high, value + step);
  const auto at = [&](double there, auto&& what) {
    *moved = there;
    auto answer = what();
    *moved = value;
    return answer;
  };

  const std::vector<std::string> place = pointer_tokens(v.pointer);
  const std::vector<std::size_t> behind = operations_behind(world.scenario, place);
  std::vector<std::pair<std::size_t, PlanSlope>> plans;
  for (const std::size_t o : behind) {
    const scenarios::Operation& operation = world.scenario.operations[o];
    std::optional<PlanSlope> exact;
    if (place[0] == "operations" && place.size() == 4 && o == index_of(place[1]) &&
        operation.incoming.empty())
      exact = turning_slope(world.scenario, operation, look.long_run->plans[o], place[3], value);
    const bool constrained = std::any_of(conditions_.begin(), conditions_.end(), [&](const Condition& c) {
      return c.operation == o && (c.kind == Condition::Kind::quantity || c.kind == Condition::Kind::limit ||
                                  c.kind == Condition::Kind::band);
    });
    if (!exact || constrained) {
      const auto planned = [&] { return scenarios::plan(world.scenario, operation); };
      const operations::CutPlan below = at(low, planned);
      const operations::CutPlan above = at(high, planned);
      if (!exact) exact = difference(below, above, high - low);
      for (std::size_t k = 0; k < conditions_.size(); ++k) {
        const Condition& c = conditions_[k];
        if (c.operation != o || c.kind == Condition::Kind::kpi || c.kind == Condition::Kind::function)
          continue;
        slope.margins[k] = (check_plan(c, above).margin - check_plan(c, below).margin) / (high - low);
      }
    }
    plans.emplace_back(o, *exact);
  }
  for (std::size_t k = 0; k < conditions_.size(); ++k)
    if (conditions_[k].kind == Condition::Kind::function && hangs_on(conditions_[k].inputs, v.pointer)) {
      const auto margin = [&] { return check_function(conditions_[k], world).margin; };
      slope.margins[k] = (at(high, margin) - at(low, margin)) / (high - low);
    }

  const auto put = [&](std::size_t objective, double derivative) {
    slope.objectives[objective] =
        (study_.objectives[objective].direction == Direction::maximize ? -1 : 1) * derivative;
  };
  const auto put_margin = [&](std::size_t k, double derivative) {
    const Condition& c = conditions_[k];
    slope.margins[k] = (c.at_most ? -1 : 1) * derivative / look.conditions[k].scale;
  };
  for (std::size_t k = 0; k < slope.objectives.size(); ++k)
    if (objective_functions_[k] && hangs_on(objective_functions_[k]->inputs, v.pointer)) {
      const auto worth = [&] { return check_function(*objective_functions_[k], world).value; };
      put(k, (at(high, worth) - at(low, worth)) / (high - low));
    }
  if (const auto run = world.model->differentiate(*look.long_run, moved, plans)) {
    for (std::size_t k = 0; k < slope.objectives.size(); ++k)
      if (objective_kpis_[k]) put(k, world.model->value(*run, *objective_kpis_[k]).slope);
    for (std::size_t k = 0; k < conditions_.size(); ++k)
      if (conditions_[k].kind == Condition::Kind::kpi && conditions_[k].long_run_kpi)
        put_margin(k, world.model->value(*run, *conditions_[k].long_run_kpi).slope);
    return slope;
  }
  // The whole by differences.
  const auto evaluated = [&] { return world.model->evaluate(); };
  const LongRun below = at(low, evaluated);
  const LongRun above = at(high, evaluated);
  const auto of = [&](std::size_t kpi) {
    return (world.model->value(above, kpi) - world.model->value(below, kpi)) / (high - low);
  };
  for (std::size_t k = 0; k < slope.objectives.size(); ++k)
    if (objective_kpis_[k]) put(k, of(*objective_kpis_[k]));
  for (std::size_t k = 0; k < conditions_.size(); ++k)
    if (conditions_[k].kind == Condition::Kind::kpi && conditions_[k].long_run_kpi)
      put_margin(k, of(*conditions_[k].long_run_kpi));
  return slope;
}

std::optional<Problem::OutcomeSlopes> Problem::slopes(const std::vector<double>& x) {
  World& world = world_at(x);
  if (!world.refused.empty() || world.model == nullptr) return std::nullopt;
  OutcomeSlopes all{
      std::vector<std::vector<double>>(study_.objectives.size(), std::vector<double>(x.size(), 0.0)),
      std::vector<std::vector<double>>(conditions_.size(), std::vector<double>(x.size(), 0.0))};
  std::vector<double> standing;
  for (const double* address : world.variables) standing.push_back(address == nullptr ? 0 : *address);
  try {
    const Look look = look_in(world);
    bool finite = true;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (dimensions_[k].discrete) continue;
      const auto one = slope(world, look, k);
      for (std::size_t o = 0; o < all.objectives.size(); ++o) {
        all.objectives[o][k] = one.objectives[o];
        finite = finite && std::isfinite(one.objectives[o]);
      }
      for (std::size_t c = 0; c < all.margins.size(); ++c) {
        all.margins[c][k] = one.margins[c];
        finite = finite && std::isfinite(one.margins[c]);
      }
    }
    if (finite) return all;
  } catch (const models::ModelError&) {
    // A neighbour that the process models refuse: the point lies on the edge of what is defined.
  } catch (const models::DomainError&) {
  } catch (const InputError&) {
  }
  for (std::size_t k = 0; k < x.size(); ++k)
    if (world.variables[k] != nullptr) *world.variables[k] = standing[k];
  return std::nullopt;
}

}  // namespace verstat::optimize
