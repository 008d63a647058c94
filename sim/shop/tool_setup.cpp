// Tools of a shop built from the scenario: copies, crib, lots, elements.
#include <limits>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

namespace {

template <class T>
std::size_t position_of(const std::vector<T>& all, const std::string& name) {
  return static_cast<std::size_t>(scenarios::find_named(all, name) - all.data());
}

}  // namespace

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

Shop::MountedTool::MountedTool(const scenarios::Scenario& scenario, const scenarios::Tool& tool,
                               std::size_t tool_index, const scenarios::Insert& insert,
                               const std::string& entity, std::uint64_t replication)
    : spec(&tool),
      insert_spec(&insert),
      index(tool_index),
      strategy(make_strategy(tool.strategy, models::LifeLaw(insert.edge_life.law, 1.0, insert.edge_life.cv))),
      index_time(law_of(tool.change.index)),
      replace_time(law_of(tool.change.replace)),
      swap_time(law_of(tool.change.swap)),
      index_stream(scenario.simulation.seed.value, entity, "index time", replication),
      replace_stream(scenario.simulation.seed.value, entity, "replace time", replication),
      scrap_stream(scenario.simulation.seed.value, entity, "scrap", replication),
      swap_stream(scenario.simulation.seed.value, entity, "swap time", replication),
      inspection_stream(scenario.simulation.seed.value, entity, "edge inspection", replication),
      presetting_stream(scenario.simulation.seed.value, entity, "presetting time", replication),
      regrind_stream(scenario.simulation.seed.value, entity, "regrinding time", replication) {
  if (const auto* watch = std::get_if<scenarios::ConditionBased>(&tool.strategy))
    sign_share = share_of_life_shown(watch->sign);
  if (tool.presetting) presetting_time = law_of(tool.presetting->time);
  if (tool.regrind) regrind_time = law_of(tool.regrind->time);
}

ToolView Shop::MountedTool::view(double main_time_min) const {
  return {.edge_wear = body->age(),
          .wear_since_plan = body->wear_since_plan(),
          .mean_life_min = mean_life_min,
          .main_time_min = main_time_min,
          .cut_since_inspection_min = body->cut_since_inspection_min};
}

void Shop::build_tools() {
  const std::uint64_t seed = scenario_.simulation.seed.value;
  for (const scenarios::Insert& insert : scenario_.inserts) {
    inserts_.push_back(scenarios::prepared(insert));
    lots_.push_back(insert.lots ? std::make_unique<LotSource>(*insert.lots, seed, insert.name, replication_)
                                : nullptr);
    cribs_.push_back(insert.crib
                         ? std::make_unique<InsertCrib>(sim_, *insert.crib, insert.name, seed, replication_)
                         : nullptr);
  }
  inserts_.emplace_back();
  lots_.push_back(nullptr);
  cribs_.push_back(nullptr);

  const auto insert_of = [&](const scenarios::Tool& tool) {
    return tool.insert.empty() ? inserts_.size() - 1 : position_of(scenario_.inserts, tool.insert);
  };
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
    return pools_.back().get();
  };
  const auto crew_of = [&](const std::string& name) {
    return crews_[position_of(scenario_.crews, name)].get();
  };

  std::map<std::size_t, ToolPool*> shared;
  for (const auto& machine : machines_)
    for (PlannedOperation& operation : operations_) {
      const std::string& name = operation.spec->tool;
      if (name.empty() || groups_[operation.group].get() != machine->group) continue;
      if (!machine->tools.contains(name)) {
        const std::size_t index = position_of(scenario_.tools, name);
        const scenarios::Tool& tool = scenario_.tools[index];
        const std::string entity = machine->name + "/" + name;
        const std::size_t insert = insert_of(tool);
        auto mounted =
            std::make_unique<MountedTool>(scenario_, tool, index, inserts_[insert], entity, replication_);
        mounted->crew = crew_of(tool.crew);
        mounted->failure_crew = tool.failure_crew.empty() ? mounted->crew : crew_of(tool.failure_crew);
        mounted->presetting_crew = tool.presetting && !tool.presetting->crew.empty()
                                       ? crew_of(tool.presetting->crew)
                                       : mounted->crew;
        mounted->crib = cribs_[insert].get();
        if (tool.shared) {
          ToolPool*& pool = shared[index];
          if (pool == nullptr) pool = pool_of(index, name);
          mounted->pool = pool;
        } else if (scenarios::changed_off_line(tool)) {
          mounted->pool = pool_of(index, entity);
        } else {
          mounted->own = body_of(tool, entity);
          mounted->body = mounted->own.get();
        }
        if (std::holds_alternative<scenarios::Opportunistic>(tool.strategy)) machine->has_joiners = true;
        machine->tools[name] = std::move(mounted);
      }
      MountedTool& tool = *machine->tools.at(name);
      operation.element_mean_min.assign(tool.spec->elements.size(), std::numeric_limits<double>::infinity());
      for (std::size_t k = 0; k < tool.spec->elements.size(); ++k)
        for (const operations::ElementLife& element : operation.plan.more_elements)
          if (tool.spec->elements[k].element == element.element)
            operation.element_mean_min[k] = element.mean_min;
    }
  // The law of an element is that of the first operation which wears it.
  for (const auto& machine : machines_)
    for (const auto& [name, tool] : machine->tools)
      for (const scenarios::ElementService& service : tool->spec->elements) {
        const operations::ElementLife* life = nullptr;
        for (const PlannedOperation& operation : operations_)
          for (const operations::ElementLife& element : operation.plan.more_elements)
            if (life == nullptr && operation.spec->tool == name && service.element == element.element)
              life = &element;
        tool->elements.emplace_back(service, *life, seed, machine->name + "/" + name, replication_);
      }
  reset_tool_counts();
}

std::int64_t Shop::edges_in_tools(std::size_t tool) const {
  std::int64_t edges = 0;
  for (const auto& machine : machines_)
    for (const auto& [name, mounted] : machine->tools)
      if (mounted->index == tool && mounted->own) edges += mounted->own->edges_held();
  for (const auto& pool : pools_)
    if (pool->tool == tool)
      for (const auto& copy : pool->copies) edges += copy->edges_held();
  return edges;
}

void Shop::reset_tool_counts() {
  for (std::size_t t = 0; t < tools_.size(); ++t) tools_[t] = ToolCounts{.edges_at_start = edges_in_tools(t)};
  const double end_min = scenario_.simulation.horizon_min;
  for (const auto& machine : machines_)
    for (const auto& [name, tool] : machine->tools) {
      tool->stops.restart(sim_.now(), end_min, scenario_.simulation.unattended_min);
      tool->changes.restart(sim_.now(), end_min, scenario_.simulation.unattended_min);
      for (ElementUnit& element : tool->elements) {
        element.changes = 0;
        element.use_min_sum = 0;
      }
    }
  for (const auto& lots : lots_)
    if (lots) lots->reset_counts();
  for (const auto& crib : cribs_)
    if (crib) crib->reset_counts();
  for (const auto& crew : crews_) crew->off_line.reset(sim_.now());
}

void Shop::settle_tools() {
  for (const auto& crib : cribs_)
    if (crib) crib->settle();
  for (const auto& crew : crews_) crew->off_line.settle(sim_.now());
  for (const auto& machine : machines_)
    for (const auto& [name, tool] : machine->tools) {
      tool->stops.close();
      tool->changes.close();
    }
}

}  // namespace verstat::shop
