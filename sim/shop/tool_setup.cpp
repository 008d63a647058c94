// Tools of a shop built from the scenario: copies, crib, lots, elements.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

Shop::ElementUnit::ElementUnit(const scenarios::ElementService& service,
                               const operations::ElementLife& element, std::uint64_t seed,
                               const std::string& entity, std::uint64_t replication)
    : spec(&service),
      unit_life(element.law, 1.0, element.cv),
      limit(service.gamma ? unit_life.gamma_percent_life(*service.gamma)
                          : std::numeric_limits<double>::infinity()),
      change_time(law_of(service.change)),
      life_stream(seed, entity + "/" + service.element, "element life", replication),
      change_stream(seed, entity + "/" + service.element, "element change time", replication) {
  renew();
}

void Shop::ElementUnit::renew() {
  life = unit_life.quantile(life_stream.uniform());
  wear = 0;
  use_min = 0;
}

Shop::MountedTool::MountedTool(const scenarios::Scenario& scenario, std::size_t tool_index,
                               const scenarios::Insert& insert, const MachineUnit& unit,
                               const std::string& entity, std::uint64_t replication)
    : spec(&scenario.tools[tool_index]),
      insert_spec(&insert),
      index(tool_index),
      machine(unit.index),
      strategy(
          make_strategy(spec->strategy, models::LifeLaw(insert.edge_life.law, 1.0, insert.edge_life.cv))),
      clock(unit.group->working_time ? &*unit.group->working_time : nullptr),
      index_time(law_of(spec->change.index)),
      replace_time(law_of(spec->change.replace)),
      swap_time(law_of(spec->change.swap)),
      index_stream(scenario.simulation.seed.value, entity, "index time", replication),
      replace_stream(scenario.simulation.seed.value, entity, "replace time", replication),
      scrap_stream(scenario.simulation.seed.value, entity, "scrap", replication),
      swap_stream(scenario.simulation.seed.value, entity, "swap time", replication),
      inspection_stream(scenario.simulation.seed.value, entity, "edge inspection", replication),
      presetting_stream(scenario.simulation.seed.value, entity, "presetting time", replication),
      regrind_stream(scenario.simulation.seed.value, entity, "regrinding time", replication) {
  watch = std::get_if<scenarios::ConditionBased>(&spec->strategy);
  if (watch != nullptr) sign_share = share_of_life_shown(watch->sign);
  if (spec->presetting) presetting_time = law_of(spec->presetting->time);
  if (spec->regrind) regrind_time = law_of(spec->regrind->time);
}

ToolView Shop::MountedTool::view(double main_time_min) const {
  return {.edge_wear = body->age(),
          .wear_since_plan = body->wear_since_plan(),
          .mean_life_min = mean_life_min,
          .main_time_min = main_time_min,
          .cut_since_inspection_min = body->cut_since_inspection_min};
}

void Shop::build_tools() {
  const scenarios::SimulationSettings& settings = scenario_.simulation;
  const std::uint64_t seed = settings.seed.value;
  for (const scenarios::Insert& insert : scenario_.inserts) {
    inserts_.push_back(scenarios::prepared(insert));
    const std::string& entity = drawn_as(settings, insert.name);
    lots_.push_back(insert.lots ? std::make_unique<LotSource>(*insert.lots, seed, entity, replication_)
                                : nullptr);
    cribs_.push_back(
        insert.crib ? std::make_unique<InsertCrib>(sim_, *insert.crib, entity, seed, replication_) : nullptr);
  }
  inserts_.emplace_back();
  lots_.push_back(nullptr);
  cribs_.push_back(nullptr);

  mounted_.resize(scenario_.tools.size());
  pools_of_.resize(scenario_.tools.size());
  has_off_line_tools_ =
      std::any_of(scenario_.tools.begin(), scenario_.tools.end(), scenarios::changed_off_line);
  const auto insert_of = [&](const scenarios::Tool& tool) {
    return tool.insert.empty() ? inserts_.size() - 1 : scenarios::index_of(scenario_.inserts, tool.insert);
  };
  weeks_of_insert_.resize(inserts_.size());
  std::set<std::string> grades;
  for (const scenarios::Insert& insert : scenario_.inserts)
    if (!insert.grade.empty()) grades.insert(insert.grade);
  for (const std::string& grade : grades) grades_.push_back({grade, {}});
  for (const scenarios::Tool& tool : scenario_.tools) {
    insert_of_tool_.push_back(insert_of(tool));
    const auto grade = std::find_if(grades_.begin(), grades_.end(), [&](const Grade& g) {
      return g.name == inserts_[insert_of_tool_.back()].grade;
    });
    grade_of_tool_.push_back(grade == grades_.end() ? nullptr : &*grade);
  }
  const auto body_of = [&](const scenarios::Tool& tool, const std::string& entity) {
    const std::size_t insert = insert_of(tool);
    return std::make_unique<ToolBody>(tool, inserts_[insert], lots_[insert].get(), seed, entity,
                                      replication_);
  };
  const auto pool_of = [&](std::size_t index, const std::string& entity) {
    auto pool = std::make_unique<ToolPool>(sim_);
    pool->tool = index;
    const scenarios::Tool& tool = scenario_.tools[index];
    for (std::int64_t k = 0; k < tool.copies; ++k) {
      pool->copies.push_back(body_of(tool, k == 0 ? entity : fmt::format("{}/copy {}", entity, k + 1)));
      pool->ready.try_put(pool->copies.back().get());
    }
    pools_.push_back(std::move(pool));
    pools_of_[index].push_back(pools_.back().get());
    return pools_.back().get();
  };
  std::map<std::size_t, ToolPool*> shared;
  const auto mount = [&](MachineUnit& machine, std::size_t index) {
    const scenarios::Tool& tool = scenario_.tools[index];
    const std::size_t insert = insert_of(tool);
    const std::string entity = machine.drawn_as + "/" + drawn_as(settings, tool.name);
    auto mounted =
        std::make_unique<MountedTool>(scenario_, index, inserts_[insert], machine, entity, replication_);
    mounted->crews = labour_->crews_for(tool.crew);
    mounted->failure_crews =
        tool.failure_crew.empty() ? mounted->crews : labour_->crews_for(tool.failure_crew);
    mounted->presetting_crews = tool.presetting && !tool.presetting->crew.empty()
                                    ? labour_->crews_for(tool.presetting->crew)
                                    : mounted->crews;
    mounted->crib = cribs_[insert].get();
    if (tool.shared) {
      ToolPool*& pool = shared[index];
      if (pool == nullptr) pool = pool_of(index, drawn_as(settings, tool.name));
      mounted->pool = pool;
    } else if (scenarios::changed_off_line(tool)) {
      mounted->pool = pool_of(index, entity);
    } else {
      mounted->own = body_of(tool, entity);
      mounted->body = mounted->own.get();
    }
    if (std::holds_alternative<scenarios::Opportunistic>(tool.strategy)) machine.has_joiners = true;
    // The law of an element is that of the first operation which wears it.
    for (const scenarios::ElementService& service : tool.elements) {
      const operations::ElementLife* life = nullptr;
      for (const OperationUnit& operation : operations_)
        for (const operations::ElementLife& element : operation.on.front().plan.more_elements)
          if (life == nullptr && operation.spec->tool == tool.name && service.element == element.element)
            life = &element;
      mounted->elements.emplace_back(service, *life, seed, entity, replication_);
    }
    mounted_[index].push_back(mounted.get());
    machine.tools.push_back(std::move(mounted));
  };

  for (OperationUnit& operation : operations_) {
    if (operation.spec->tool.empty()) continue;
    const auto& services = scenarios::find_named(scenario_.tools, operation.spec->tool)->elements;
    for (PlannedOperation& on : operation.on) {
      on.element_mean_min.assign(services.size(), std::numeric_limits<double>::infinity());
      for (std::size_t k = 0; k < services.size(); ++k)
        for (const operations::ElementLife& element : on.plan.more_elements)
          if (services[k].element == element.element) on.element_mean_min[k] = element.mean_min;
    }
  }
  // Tools of each group by name, and where each operation finds its own.
  std::vector<std::vector<std::size_t>> held(groups_.size());
  for (OperationUnit& operation : operations_) {
    if (operation.spec->tool.empty()) continue;
    const std::size_t tool = scenarios::index_of(scenario_.tools, operation.spec->tool);
    for (PlannedOperation& on : operation.on) {
      on.tool_slot = tool;  // replaced by the place among the tools of the group
      auto& tools = held[on.group];
      if (std::find(tools.begin(), tools.end(), tool) == tools.end()) tools.push_back(tool);
    }
  }
  for (auto& tools : held)
    std::sort(tools.begin(), tools.end(), [&](std::size_t a, std::size_t b) {
      return drawn_as(settings, scenario_.tools[a].name) < drawn_as(settings, scenario_.tools[b].name);
    });
  for (OperationUnit& operation : operations_)
    for (PlannedOperation& on : operation.on) {
      const auto& tools = held[on.group];
      if (on.tool_slot != no_tool)
        on.tool_slot =
            static_cast<std::size_t>(std::find(tools.begin(), tools.end(), on.tool_slot) - tools.begin());
      on.uses_tool = on.wears || !on.element_mean_min.empty();
    }
  for (const auto& machine : machines_) {
    const auto& tools = held[machine->group->index];
    machine->group->has_tool = !tools.empty();
    for (const std::size_t tool : tools) mount(*machine, tool);
  }
  reset_tool_counts();
}

std::int64_t Shop::edges_in_tools(std::size_t tool) const {
  std::int64_t edges = 0;
  for (const MountedTool* mounted : mounted_[tool])
    if (mounted->own) edges += mounted->own->edges_held();
  for (const ToolPool* pool : pools_of_[tool])
    for (const auto& copy : pool->copies) edges += copy->edges_held();
  return edges;
}

void Shop::audit_tools(std::vector<std::string>& broken) const {
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const ToolCounts& c = tools_[t];
    const auto used = static_cast<std::int64_t>(c.edges_used);
    const std::int64_t now = edges_in_tools(t);
    if (c.edges_at_start + c.edges_fitted + c.edges_reground != used + c.edges_discarded + now)
      broken.push_back(
          fmt::format("tool \"{}\": edges {} at the start + {} fitted + {} reground, {} used + {} "
                      "discarded + {} there",
                      scenario_.tools[t].name, c.edges_at_start, c.edges_fitted, c.edges_reground, used,
                      c.edges_discarded, now));
  }
  for (std::size_t i = 0; i < cribs_.size(); ++i) {
    if (!cribs_[i]) continue;
    const InsertCrib::Counts& c = cribs_[i]->counts();
    if (c.stock_at_start + c.delivered != c.issued + cribs_[i]->stock())
      broken.push_back(fmt::format("insert \"{}\": {} at the start + {} delivered, {} issued + {} there",
                                   inserts_[i].name, c.stock_at_start, c.delivered, c.issued,
                                   cribs_[i]->stock()));
  }
  for (const auto& pool : pools_) {
    std::size_t mounted = 0;
    for (const auto& machine : machines_)
      for (const auto& tool : machine->tools)
        if (tool->pool == pool.get() && tool->body != nullptr) ++mounted;
    if (pool->ready.size() + mounted + pool->in_tool_room != pool->copies.size())
      broken.push_back(fmt::format("tool \"{}\": {} copies, {} ready + {} in machines + {} in the tool room",
                                   scenario_.tools[pool->tool].name, pool->copies.size(), pool->ready.size(),
                                   mounted, pool->in_tool_room));
  }
  for (const auto& machine : machines_)
    for (const auto& tool : machine->tools) {
      double sum_min = 0;
      for (std::size_t s = 0; s < machine_states; ++s)
        sum_min += tool->clock.time_min(static_cast<MachineState>(s));
      if (std::abs(sum_min - window_min()) > 1e-9 * scenario_.simulation.horizon_min)
        broken.push_back(fmt::format("tool \"{}\" on \"{}\": states add up to {} of {} min", tool->spec->name,
                                     machine->name, sum_min, window_min()));
    }
}

void Shop::reset_tool_counts() {
  for (std::size_t t = 0; t < tools_.size(); ++t) tools_[t] = ToolCounts{.edges_at_start = edges_in_tools(t)};
  const double end_min = scenario_.simulation.horizon_min;
  for (const auto& machine : machines_)
    for (const auto& tool : machine->tools) {
      tool->stops.restart(sim_.now(), end_min, scenario_.simulation.unattended_min);
      tool->changes.restart(sim_.now(), end_min, scenario_.simulation.unattended_min);
      for (ElementUnit& element : tool->elements) {
        element.changes = 0;
        element.use_min_sum = 0;
      }
    }
  for (IntervalCount& weeks : weeks_of_insert_) weeks.restart(sim_.now(), end_min, week_min);
  for (Grade& grade : grades_) grade.weeks.restart(sim_.now(), end_min, week_min);
  for (const auto& lots : lots_)
    if (lots) lots->reset_counts();
  for (const auto& crib : cribs_)
    if (crib) crib->reset_counts();
}

}  // namespace verstat::shop
