// All KPIs of a shop, names beside formulas.
#include "sim/shop/kpis.h"

#include <array>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {
namespace {

struct Money {
  const char* name;
  const char* meaning;
  double amount;
};

constexpr std::string_view meaning_of(MachineState state) {
  constexpr std::array<std::string_view, machine_states> texts = {
      "share of the time spent cutting",
      "share of the time spent on operations given as durations",
      "share of the time in planned insert changes, crew at work",
      "share of the time in insert changes after a failure, crew at work",
      "share of the time waiting for the crew to change an edge",
      "share of the time without a part to work on",
      "share of the time waiting for a sister tool or for inserts",
      "share of the time in which a sister tool comes out of the magazine"};
  return texts[static_cast<std::size_t>(state)];
}

}  // namespace

std::string machine_name(const scenarios::Machine& machine, std::int64_t index) {
  return machine.count == 1 ? machine.name : fmt::format("{} {}", machine.name, index + 1);
}

void Shop::each_kpi(const KpiSink& sink) const {
  const double window_min = scenario_.simulation.horizon_min - scenario_.simulation.warmup_min;
  const std::string& money = scenario_.currency;

  double good = 0;
  double scrapped = 0;
  double lead_time_min = 0;
  double scrap_cost = 0;
  for (const PartCounts& part : parts_) {
    good += static_cast<double>(part.good);
    scrapped += static_cast<double>(part.scrapped);
    lead_time_min += part.lead_time_min;
    scrap_cost += part.scrap_cost;
  }
  const double finished = good + scrapped;

  // Costs: every machine minute by its state, crews by work or by shift, inserts, damage, scrap.
  std::array<double, machine_states> machine_cost{};
  for (const auto& machine : machines_)
    for (std::size_t s = 0; s < machine_states; ++s)
      machine_cost[s] +=
          machine->clock.time_min(static_cast<MachineState>(s)) * machine->group->spec->rate_per_min;
  double planned_wage = 0;
  double failure_wage = 0;
  std::map<const CrewUnit*, double> crew_busy_min;
  for (const auto& machine : machines_)
    for (const auto& [name, tool] : machine->tools) {
      const double planned_min = tool->clock.time_min(MachineState::planned_change);
      const double failure_min = tool->clock.time_min(MachineState::failure_change);
      if (tool->crew == tool->failure_crew) {
        crew_busy_min[tool->crew] += planned_min + failure_min;
      } else {
        crew_busy_min[tool->crew] += planned_min;
        crew_busy_min[tool->failure_crew] += failure_min;
      }
      if (tool->crew->spec->pay == scenarios::CrewPay::busy)
        planned_wage += planned_min * tool->crew->spec->rate_per_min;
      if (tool->failure_crew->spec->pay == scenarios::CrewPay::busy)
        failure_wage += failure_min * tool->failure_crew->spec->rate_per_min;
    }
  double tool_room_wage = 0;
  for (const auto& crew : crews_) {
    crew_busy_min[crew.get()] += crew->off_line.area_min();
    if (crew->spec->pay == scenarios::CrewPay::busy)
      tool_room_wage += crew->off_line.area_min() * crew->spec->rate_per_min;
  }
  double shift_wage = 0;
  for (const auto& crew : crews_)
    if (crew->spec->pay == scenarios::CrewPay::shift)
      shift_wage += crew->spec->rate_per_min * static_cast<double>(crew->spec->members) * window_min;
  double insert_cost = 0;
  double regrind_cost = 0;
  double damage_cost = 0;
  double element_cost = 0;
  for (const ToolCounts& tool : tools_) {
    insert_cost += tool.insert_cost;
    regrind_cost += tool.regrind_cost;
    damage_cost += tool.damage_cost;
    element_cost += tool.element_cost;
  }
  for (const auto& lots : lots_)
    if (lots) insert_cost += lots->counts().cost;
  const auto machine_in = [&](MachineState s) { return machine_cost[static_cast<std::size_t>(s)]; };
  const std::array components = {
      Money{"machining", "machine minutes of cutting", machine_in(MachineState::cutting)},
      Money{"other_operations", "machine minutes of operations given as durations",
            machine_in(MachineState::working)},
      Money{"planned_change", "machine and crew minutes of planned insert changes",
            machine_in(MachineState::planned_change) + planned_wage},
      Money{"failure_change", "machine and crew minutes of changes after a failure",
            machine_in(MachineState::failure_change) + failure_wage},
      Money{"waiting_crew", "machine minutes of waiting for the crew",
            machine_in(MachineState::waiting_crew)},
      Money{"idle", "machine minutes without a part", machine_in(MachineState::idle)},
      Money{"labour", "crews paid by the shift", shift_wage},
      Money{"inserts", "inserts", insert_cost},
      Money{"regrinding", "regrinding", regrind_cost},
      Money{"damage", "holders, shims and rework after failures", damage_cost},
      Money{"scrap", "value of scrapped parts", scrap_cost},
      Money{"waiting_tool", "machine minutes of waiting for a sister tool or for inserts",
            machine_in(MachineState::waiting_tool)},
      Money{"tool_swap", "machine minutes of swapping sister tools", machine_in(MachineState::tool_swap)},
      Money{"tool_room", "crew minutes at tools off the machines", tool_room_wage},
      Money{"elements", "guide pads, dressings and other second elements", element_cost}};
  // The whole is the sum of the parts as they are shown, so that the bridge closes exactly.
  std::optional<double> per_part;
  std::optional<double> per_good_part;
  for (const Money& m : components) {
    if (const auto share = ratio(m.amount, finished)) per_part = per_part.value_or(0) + *share;
    if (const auto share = ratio(m.amount, good)) per_good_part = per_good_part.value_or(0) + *share;
  }

  sink(KpiInfo{"cost_per_part", money, "all costs / parts finished, good or scrapped"}, per_part);
  sink(KpiInfo{"cost_per_good_part", money, "all costs / good parts"}, per_good_part);
  sink(KpiInfo{"throughput_per_h", "parts/h", "good parts per hour of calendar time"},
       ratio(good, window_min / 60));
  sink(KpiInfo{"parts_good", "parts", "good parts in the counted time"}, good);
  sink(KpiInfo{"parts_scrapped", "parts", "scrapped parts in the counted time"}, scrapped);
  sink(KpiInfo{"quality_ratio", "1", "good parts / parts finished (ISO 22400)"}, ratio(good, finished));
  sink(KpiInfo{"lead_time_min", "min", "mean time from the start or arrival of a part to its end"},
       ratio(lead_time_min, finished));
  for (const Money& m : components)
    sink(KpiInfo{fmt::format("cost/{}", m.name), money + "/part",
                 fmt::format("{}, per part finished", m.meaning)},
         ratio(m.amount, finished));

  for (const auto& machine : machines_) {
    const double production_min =
        machine->clock.time_min(MachineState::cutting) + machine->clock.time_min(MachineState::working);
    sink(KpiInfo{fmt::format("machine/{}/availability", machine->name), "1",
                 "production time / planned busy time (ISO 22400)"},
         ratio(production_min, window_min));
    for (std::size_t s = 0; s < machine_states; ++s) {
      const auto state = static_cast<MachineState>(s);
      sink(KpiInfo{fmt::format("machine/{}/state/{}", machine->name, name_of(state)), "1",
                   std::string(meaning_of(state))},
           ratio(machine->clock.time_min(state), window_min));
    }
  }

  tool_kpis(finished, sink);
  insert_kpis(finished, sink);

  for (const auto& crew : crews_) {
    const auto busy = crew_busy_min.find(crew.get());
    const double busy_min = busy == crew_busy_min.end() ? 0 : busy->second;
    sink(KpiInfo{fmt::format("crew/{}/utilization", crew->spec->name), "1",
                 "minutes worked / minutes present"},
         ratio(busy_min, window_min * static_cast<double>(crew->spec->members)));
  }
}

std::vector<std::optional<double>> Shop::compute_kpis() const {
  std::vector<std::optional<double>> values;
  each_kpi([&](KpiInfo, std::optional<double> value) { values.push_back(value); });
  return values;
}

std::vector<KpiInfo> kpi_infos(const scenarios::Scenario& scenario) {
  std::vector<KpiInfo> infos;
  const Shop shop(scenario, 0);
  shop.each_kpi([&](KpiInfo info, std::optional<double>) { infos.push_back(std::move(info)); });
  return infos;
}

}  // namespace verstat::shop
