// All KPIs of a shop, names beside formulas.
#include "sim/shop/kpis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include <fmt/format.h>

#include "sim/kernel/errors.h"
#include "sim/shop/shop_parts.h"

namespace verstat::shop {
namespace {

constexpr std::string_view meaning_of(MachineState state) {
  constexpr std::array<std::string_view, machine_states> texts = {
      "share of the time spent cutting",
      "share of the time spent on operations given as durations",
      "share of the time spent loading and unloading",
      "share of the time spent changing over",
      "share of the time in planned changes of inserts or gauges",
      "share of the time in insert changes after a failure, crew at work",
      "share of the time waiting for a crew that is busy elsewhere or off",
      "share of the time waiting for a tool or an insert",
      "share of the time under repair",
      "share of the time waiting for a repair or maintenance to begin",
      "share of the time in planned maintenance",
      "share of the time resetting the overload clutch",
      "share of the time warming up",
      "share of the time blocked by a full place downstream",
      "share of the time without a part to work on",
      "share of the time switched off for lack of work",
      "share of the time outside the calendar",
      "share of the time in which a sister tool comes out of the magazine"};
  return texts[static_cast<std::size_t>(state)];
}

constexpr std::array<std::string_view, phases> phase_names = {"release", "components", "queue",
                                                              "machine", "blocked",    "transport"};
constexpr std::array<std::string_view, phases> phase_meanings = {
    "waiting to be let into the shop",
    "waiting for parts to assemble",
    "waiting for a machine",
    "on a machine: set-up, loading, work and stops",
    "waiting for room at the next place",
    "under way"};

bool has_due_dates(const scenarios::PartType& part) {
  return part.due_after || std::holds_alternative<scenarios::OrderList>(part.supply);
}

// Electric energy of a machine by its state times, kWh.
double energy_of(const scenarios::Power& power, const StateClock& clock) {
  double energy_kwh = 0;
  for (std::size_t s = 0; s < machine_states; ++s) {
    const auto state = static_cast<MachineState>(s);
    const bool working = state == MachineState::working || state == MachineState::loading;
    const bool off = state == MachineState::off || state == MachineState::off_shift;
    const double kw = state == MachineState::cutting ? power.cutting_kw
                      : working                      ? power.working_kw
                      : off                          ? power.off_kw
                                                     : power.standby_kw;
    energy_kwh += kw * clock.time_min(state) / 60;
  }
  return energy_kwh;
}

}  // namespace

std::string numbered(const std::string& group, std::int64_t count, std::int64_t index) {
  return count == 1 ? group : fmt::format("{} {}", group, index + 1);
}
std::string machine_name(const scenarios::Machine& machine, std::int64_t index) {
  return numbered(machine.name, machine.count, index);
}

// States that cannot occur are left out of the results: a lathe without a calendar has no off-shift share.
bool Shop::can_occur(const Group& group, MachineState state) const {
  const scenarios::Machine& machine = *group.spec;
  switch (state) {
    case MachineState::cutting:
    case MachineState::working:
    case MachineState::idle:
      return true;
    case MachineState::planned_change:
      return group.has_tool || group.has_gauge;
    case MachineState::failure_change:
      return group.has_tool;
    case MachineState::waiting_crew:
      return group.has_tool || machine.attendance || (machine.setup && !machine.setup->crew.empty());
    case MachineState::waiting_tool:
      return group.has_tool;
    case MachineState::tool_swap:
      return group.has_tool && has_off_line_tools_;
    case MachineState::loading:
      return machine.loading || machine.unloading;
    case MachineState::setup:
      return machine.setup.has_value();
    case MachineState::repair:
      return !machine.failures.empty() || machine.limits.safety_clutch;
    case MachineState::maintenance:
      return !machine.maintenance.empty();
    case MachineState::waiting_repair:
      return !machine.failures.empty() || !machine.maintenance.empty() || machine.limits.safety_clutch;
    case MachineState::overload_reset:
      return machine.limits.safety_clutch.has_value();
    case MachineState::warm_up:
    case MachineState::off:
      return machine.switch_off.has_value();
    case MachineState::blocked:
      return can_block_;
    case MachineState::off_shift:
      return !machine.calendar.empty();
  }
  return true;
}

// Headings under which this scenario can spend money.
bool Shop::can_occur(Cost cost) const {
  const auto any_group = [&](auto&& predicate) {
    return std::any_of(groups_.begin(), groups_.end(), [&](const auto& group) { return predicate(*group); });
  };
  for (std::size_t s = 0; s < machine_states; ++s) {
    const auto state = static_cast<MachineState>(s);
    if (heading_of(state) == cost && cost != Cost::off)
      return any_group([&](const Group& group) { return can_occur(group, state); });
  }
  switch (cost) {
    case Cost::tool_room:
      return has_off_line_tools_;
    case Cost::elements:
      return std::any_of(scenario_.tools.begin(), scenario_.tools.end(),
                         [](const scenarios::Tool& tool) { return !tool.elements.empty(); });
    case Cost::off:
      return any_group([](const Group& group) { return group.spec->switch_off.has_value(); });
    case Cost::transport:
      return !scenario_.transport.empty();
    case Cost::spares:
      return !scenario_.spares.empty();
    case Cost::operations:
      for (const scenarios::Operation& operation : scenario_.operations)
        if (operation.cost > 0) return true;
      return any_group([](const Group& group) { return group.has_gauge; });
    case Cost::escapes:
      for (const scenarios::PartType& part : scenario_.parts)
        if (part.escape_cost > 0) return true;
      return false;
    case Cost::tardiness:
      for (const scenarios::PartType& part : scenario_.parts)
        if (part.tardiness_cost_per_min > 0) return true;
      return false;
    case Cost::lost_demand:
      for (const scenarios::Store& store : scenario_.stores)
        if (store.demand_lost_cost > 0) return true;
      return false;
    case Cost::energy:
      return scenario_.energy_price_per_kwh > 0;
    default:
      return true;
  }
}

void Shop::settle() {
  for (const auto& machine : machines_)
    if (machine->clock.state() == MachineState::blocked) told_blocked(*machine);
  labour_->settle(sim_.now());
  for (IntervalCount& weeks : weeks_of_insert_) weeks.close();
  for (Grade& grade : grades_) grade.weeks.close();
  for (const auto& machine : machines_) {
    machine->clock.settle(sim_.now());
    machine->missions.close();
    for (const auto& tool : machine->tools) {
      tool->clock.settle(sim_.now());
      tool->stops.close();
      tool->changes.close();
    }
  }
}

void Shop::reset_counts() {
  settle();
  const double now = sim_.now();
  labour_->reset_counts(now);
  costs_.reset();
  reset_tool_counts();
  reset_limits();
  reset_quality_counts();
  for (PartCounts& part : parts_) part = PartCounts();
  for (const auto& machine : machines_) {
    machine->clock.reset(now);
    for (const auto& tool : machine->tools) tool->clock.reset(now);
    machine->parts_done = 0;
    machine->parts_rejected = 0;
    machine->planned_min = 0;
    machine->setups = 0;
    machine->failures = 0;
    machine->maintenance_jobs = 0;
    machine->overload_trips = 0;
    machine->overload_breaks = 0;
    machine->active_periods = is_passive(machine->clock.state()) ? 0 : 1;
    for (const auto& stop : machine->stops) stop->count = 0;
  }
  for (const auto& group : groups_) group->queue_length.reset(now);
  for (const auto& spares : spares_) {
    spares->used = 0;
    spares->stock_outs = 0;
  }
  for (const auto& store : stores_) {
    store->mean_level.reset(now);
    store->customers = 0;
    store->lost = 0;
  }
  for (const auto& carrier : carriers_) {
    carrier->busy_min = 0;
    carrier->moves = 0;
  }
  work_in_process_.reset(now);
  lead_times_ = sim::QuantileSketch();
}

// What is known only at the end: machine minutes by state, presence of crews, energy.
void Shop::book_totals() {
  for (const auto& lots : lots_)
    if (lots) costs_.book(Cost::inserts, lots->counts().cost);
  for (const auto& machine : machines_) {
    const scenarios::Machine& spec = *machine->group->spec;
    for (std::size_t s = 0; s < machine_states; ++s) {
      const auto state = static_cast<MachineState>(s);
      if (state != MachineState::off_shift)
        costs_.book(heading_of(state), machine->clock.time_min(state) * spec.rate_per_min);
    }
    costs_.book(Cost::energy, energy_of(spec.power, machine->clock) * scenario_.energy_price_per_kwh);
  }
  for (std::size_t k = 0; k < scenario_.crews.size(); ++k) {
    const scenarios::Crew& crew = scenario_.crews[k];
    if (crew.pay == scenarios::CrewPay::shift)
      costs_.book(Cost::labour, crew.rate_per_min * labour_->present_min(k, scenario_.simulation.warmup_min,
                                                                         scenario_.simulation.horizon_min));
  }
}

void Shop::shop_kpis(const KpiSink& sink) const {
  const std::string& money = scenario_.currency;
  double good = 0;
  double scrapped = 0;
  double lead_time_min = 0;
  std::array<double, phases> phase_min{};
  for (const PartCounts& part : parts_) {
    good += static_cast<double>(part.good);
    scrapped += static_cast<double>(part.scrapped);
    lead_time_min += part.lead_time_min;
    for (std::size_t k = 0; k < phases; ++k) phase_min[k] += part.phase_min[k];
  }
  const double finished = good + scrapped;

  // The whole is the sum of the parts as they are shown, so that the bridge closes exactly.
  std::optional<double> per_part;
  std::optional<double> per_good_part;
  for (std::size_t c = 0; c < cost_headings; ++c) {
    const double amount = costs_[static_cast<Cost>(c)];
    if (!can_occur(static_cast<Cost>(c))) continue;
    if (const auto share = ratio(amount, finished)) per_part = per_part.value_or(0) + *share;
    if (const auto share = ratio(amount, good)) per_good_part = per_good_part.value_or(0) + *share;
  }
  sink(KpiInfo{"cost_per_part", money, "all costs / parts finished, good or scrapped"}, per_part);
  sink(KpiInfo{"cost_per_good_part", money, "all costs / good parts"}, per_good_part);
  sink(KpiInfo{"throughput_per_h", "parts/h", "good parts per hour of calendar time"},
       ratio(good, window_min() / 60));
  sink(KpiInfo{"parts_good", "parts", "good parts in the counted time"}, good);
  sink(KpiInfo{"parts_scrapped", "parts", "scrapped parts in the counted time"}, scrapped);
  sink(KpiInfo{"quality_ratio", "1", "good parts / parts finished (ISO 22400)"}, ratio(good, finished));
  sink(KpiInfo{"work_in_process", "parts", "mean number of parts in the shop"},
       work_in_process_.mean(sim_.now()));
  sink(KpiInfo{"lead_time_min", "min", "mean time from the start or arrival of a part to its end"},
       ratio(lead_time_min, finished));
  if (can_block_ || scenario_.crews.size() > 1) {
    const double from_min = std::max(stands_since_min_.value_or(sim_.now()), scenario_.simulation.warmup_min);
    sink(KpiInfo{"standstill_share", "1",
                 "share of the time in which machines stand for good: they block each other or keep each "
                 "other's people"},
         ratio(sim_.now() - from_min, window_min()));
  }
  const auto quantile = [&](double p) -> std::optional<double> {
    if (lead_times_.count() == 0) return std::nullopt;
    return lead_times_.quantile(p);
  };
  sink(KpiInfo{"lead_time_p50_min", "min", "median of the lead times of batches"}, quantile(0.5));
  sink(KpiInfo{"lead_time_p90_min", "min", "90 % of the batches take no longer"}, quantile(0.9));
  for (std::size_t k = 0; k < phases; ++k)
    sink(KpiInfo{fmt::format("lead_time/{}_min", phase_names[k]), "min",
                 fmt::format("mean part of the lead time spent {}", phase_meanings[k])},
         ratio(phase_min[k], finished));
  for (std::size_t c = 0; c < cost_headings; ++c) {
    const auto cost = static_cast<Cost>(c);
    if (can_occur(cost))
      sink(KpiInfo{fmt::format("cost/{}", name_of(cost)), money + "/part",
                   fmt::format("{}, per part finished", meaning_of(cost))},
           ratio(costs_[cost], finished));
  }
}

void Shop::machine_kpis(const KpiSink& sink) const {
  for (const auto& machine : machines_) {
    const scenarios::Machine& spec = *machine->group->spec;
    const auto time_in = [&](MachineState state) { return machine->clock.time_min(state); };
    const auto put = [&](const char* name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("machine/{}/{}", machine->name, name), unit, meaning}, value);
    };
    const double production_min = time_in(MachineState::cutting) + time_in(MachineState::working);
    const auto planned = scenario_.simulation.planned_change;
    double busy_min = window_min() - time_in(MachineState::off_shift) - time_in(MachineState::maintenance);
    if (planned == scenarios::PlannedChange::planned_downtime)
      busy_min -= time_in(MachineState::planned_change);
    const double setup_min =
        time_in(MachineState::setup) +
        (planned == scenarios::PlannedChange::setup ? time_in(MachineState::planned_change) : 0.0);
    const double breakdown_min = time_in(MachineState::failure_change) + time_in(MachineState::repair) +
                                 time_in(MachineState::waiting_repair) +
                                 time_in(MachineState::overload_reset);
    const double start_up_min = time_in(MachineState::warm_up);
    const double stops_min = busy_min - production_min - setup_min - breakdown_min - start_up_min;
    const auto done = static_cast<double>(machine->parts_done);
    const auto rejected = static_cast<double>(machine->parts_rejected);
    const double kept = done > 0 ? (done - rejected) / done : 1;
    put("availability", "1", "actual production time / planned busy time (ISO 22400)",
        ratio(production_min, busy_min));
    put("effectiveness", "1", "planned main time of the parts made / actual production time (ISO 22400)",
        ratio(machine->planned_min, production_min));
    put("quality_ratio", "1", "parts not rejected at the machine / parts made (ISO 22400)",
        ratio(done - rejected, done));
    put("oee", "1",
        "availability x effectiveness x quality ratio = value-adding share of the planned busy time",
        ratio(machine->planned_min * kept, busy_min));
    double active_min = 0;
    for (std::size_t s = 0; s < machine_states; ++s)
      if (!is_passive(static_cast<MachineState>(s))) active_min += time_in(static_cast<MachineState>(s));
    put("utilization", "1", "active time / time inside the calendar",
        ratio(active_min, window_min() - time_in(MachineState::off_shift)));
    put("active_period_min", "min",
        "mean uninterrupted active period; the longest in the shop marks the bottleneck (Roser 2001)",
        ratio(active_min, static_cast<double>(machine->active_periods)));
    if (spec.setup)
      put("setups", "1", "changeovers in the counted time", static_cast<double>(machine->setups));
    if (spec.limits.safety_clutch) {
      put("overload_trips", "1", "trips of the safety clutch in the counted time",
          static_cast<double>(machine->overload_trips));
      put("overload_breaks", "1", "breaks that the safety clutch did not prevent",
          static_cast<double>(machine->overload_breaks));
    }
    const scenarios::Power& power = spec.power;
    if (power.cutting_kw > 0 || power.working_kw > 0 || power.standby_kw > 0 || power.off_kw > 0)
      put("energy_kwh_per_part", "kWh", "electric energy / parts made",
          ratio(energy_of(power, machine->clock), done));
    if (!spec.failures.empty()) {
      const auto failures = static_cast<double>(machine->failures);
      put("mtbf_min", "min", "production time / failures", ratio(production_min, failures));
      put("mttr_min", "min", "repair time without waiting / failures",
          ratio(time_in(MachineState::repair), failures));
    }
    put("loss/breakdowns", "1",
        "share of the planned busy time: repairs, changes after a failure, waiting for them",
        ratio(breakdown_min, busy_min));
    put("loss/setup", "1",
        "share of the planned busy time: set-ups (and planned changes, as the scenario says)",
        ratio(setup_min, busy_min));
    put("loss/stops", "1",
        "share of the planned busy time: idling, blocking, waiting, loading, planned changes",
        ratio(stops_min, busy_min));
    put("loss/speed", "1", "share of the planned busy time: production slower than planned",
        ratio(production_min - machine->planned_min, busy_min));
    put("loss/rejects", "1", "share of the planned busy time: spent on parts that were rejected",
        ratio(machine->planned_min * (1 - kept), busy_min));
    put("loss/start_up", "1", "share of the planned busy time: warming up", ratio(start_up_min, busy_min));
    for (std::size_t s = 0; s < machine_states; ++s) {
      const auto state = static_cast<MachineState>(s);
      if (!can_occur(*machine->group, state)) continue;
      sink(KpiInfo{fmt::format("machine/{}/state/{}", machine->name, name_of(state)), "1",
                   std::string(meaning_of(state))},
           ratio(time_in(state), window_min()));
    }
    for (const auto& stop : machine->stops)
      if (stop->failure != nullptr)
        sink(KpiInfo{fmt::format("machine/{}/failures/{}", machine->name, stop->failure->name), "1",
                     "failures of this mode in the counted time"},
             static_cast<double>(stop->count));
    for (const auto& stop : machine->stops)
      if (stop->maintenance != nullptr)
        sink(KpiInfo{fmt::format("machine/{}/maintenance/{}", machine->name, stop->maintenance->name), "1",
                     "maintenance jobs in the counted time"},
             static_cast<double>(stop->count));
  }
  for (const auto& group : groups_)
    sink(KpiInfo{fmt::format("queue/{}/mean_length", group->spec->name), "batches",
                 "mean number of batches that wait before the machine group"},
         group->queue_length.mean(sim_.now()));
}

void Shop::part_kpis(const KpiSink& sink) const {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const PartCounts& counts = parts_[p];
    const scenarios::PartType& type = scenario_.parts[p];
    const auto good = static_cast<double>(counts.good);
    const double finished = good + static_cast<double>(counts.scrapped);
    const auto put = [&](const char* name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("part/{}/{}", type.name, name), unit, meaning}, value);
    };
    put("good", "parts", "good parts in the counted time", good);
    put("scrapped", "parts", "scrapped parts in the counted time", static_cast<double>(counts.scrapped));
    put("throughput_per_h", "parts/h", "good parts per hour of calendar time",
        ratio(good, window_min() / 60));
    put("lead_time_min", "min", "mean time from the start or arrival of a part to its end",
        ratio(counts.lead_time_min, finished));
    bool reworks = false;
    bool inspected = false;
    for (const scenarios::RouteStep& step : routes_[p]) {
      reworks = reworks || step.rework != scenarios::route_end;
      inspected = inspected || operations_[step.operation].spec->quality.has_value() ||
                  operations_[step.operation].on.front().plan.detection.has_value();
    }
    if (reworks)
      put("rework_ratio", "1", "parts sent to rework / parts finished",
          ratio(static_cast<double>(counts.reworked), finished));
    if (inspected || !type.requirements.empty())
      put("escape_ratio", "1", "good parts with a defect that nobody saw / good parts",
          ratio(static_cast<double>(counts.escaped), good));
    if (has_due_dates(type)) {
      put("late_share", "1", "good parts finished after their due date",
          ratio(static_cast<double>(counts.late), good));
      put("tardiness_min", "min", "mean time after the due date, parts in time count as zero",
          ratio(counts.tardiness_min, good));
    }
    requirement_kpis(p, sink);
  }
}

void Shop::crew_kpis(const KpiSink& sink) const {
  for (std::size_t k = 0; k < scenario_.crews.size(); ++k) {
    const scenarios::Crew& crew = scenario_.crews[k];
    const auto put = [&](const char* name, const char* meaning, std::optional<double> value) {
      sink(KpiInfo{fmt::format("crew/{}/{}", crew.name, name), "1", meaning}, value);
    };
    const double present_min =
        labour_->present_min(k, scenario_.simulation.warmup_min, scenario_.simulation.horizon_min);
    const double all_min = window_min() * static_cast<double>(crew.members);
    const double overtime_min = labour_->overtime_min(k);
    const double working_min = labour_->busy_min(k) - overtime_min;
    put("utilization", "minutes worked / minutes present", ratio(labour_->busy_min(k), present_min));
    put("state/working", "share of the members' calendar time: called somewhere, on the way included",
        ratio(working_min, all_min));
    put("state/free", "share of the members' calendar time: on shift, nobody calls",
        ratio(std::max(0.0, present_min - working_min), all_min));
    if (crew.calendar.empty()) continue;
    put("state/overtime", "share of the members' calendar time: finishing a job after the end of the shift",
        ratio(overtime_min, all_min));
    put("state/off_shift", "share of the members' calendar time: off shift and not at work",
        ratio(all_min - present_min - overtime_min, all_min));
  }
}

void Shop::store_and_transport_kpis(const KpiSink& sink) const {
  for (const auto& store : stores_) {
    const auto put = [&](const char* name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("store/{}/{}", store->spec->name, name), unit, meaning}, value);
    };
    bool assembled_from = false;
    for (const scenarios::Route& route : routes_)
      for (const scenarios::RouteStep& step : route)
        for (const scenarios::RouteComponent& c : step.assembles)
          assembled_from = assembled_from || scenario_.parts[c.part].store == store->spec->name;
    if (store->spec->demand || assembled_from)
      put("mean_level", "parts", "mean number of parts in the store", store->mean_level.mean(sim_.now()));
    if (store->spec->demand) {
      put("fill_rate", "1", "customers served at once / customers",
          ratio(static_cast<double>(store->customers - store->lost), static_cast<double>(store->customers)));
    }
  }
  for (const auto& spares : spares_) {
    sink(KpiInfo{fmt::format("spare/{}/used", spares->spec->name), "1",
                 "spare parts used in the counted time"},
         static_cast<double>(spares->used));
    sink(KpiInfo{fmt::format("spare/{}/stock_outs", spares->spec->name), "1",
                 "times that a repair had to wait for this spare part"},
         static_cast<double>(spares->stock_outs));
  }
  for (const auto& carrier : carriers_) {
    sink(KpiInfo{fmt::format("transport/{}/moves", carrier->spec->name), "1", "batches carried"},
         static_cast<double>(carrier->moves));
    if (carrier->fleet)
      sink(KpiInfo{fmt::format("transport/{}/utilization", carrier->spec->name), "1",
                   "minutes driven, empty ways included / minutes of all vehicles"},
           ratio(carrier->busy_min, window_min() * static_cast<double>(carrier->fleet->vehicles.size())));
  }
}

void Shop::each_kpi(const KpiSink& sink) const {
  shop_kpis(sink);
  machine_kpis(sink);
  limit_kpis(sink);
  gauge_kpis(sink);
  double finished = 0;
  for (const PartCounts& part : parts_) finished += static_cast<double>(part.good + part.scrapped);
  tool_kpis(finished, sink);
  insert_kpis(finished, sink);
  crew_kpis(sink);
  part_kpis(sink);
  store_and_transport_kpis(sink);
  criteria_kpis(sink);
}

// A budget that ran out is the scenario's affair: said in its words, with the way out.
void Shop::simulate_until(double time_min) {
  const char* const way_out =
      " (/simulation/max_events): shorten /simulation/horizon_min, check the durations, or allow more";
  try {
    sim_.run_until(time_min);
  } catch (const sim::BudgetError& e) {
    throw sim::BudgetError(fmt::format("replication {}: {}{}", replication_, e.what(), way_out));
  } catch (const sim::ProcessError& e) {
    try {
      std::rethrow_if_nested(e);
    } catch (const sim::BudgetError&) {  // thrown by a process: what it says stands with time and name
      throw sim::BudgetError(fmt::format("replication {}: {}", replication_, e.what()));
    } catch (const std::bad_alloc&) {  // whoever runs the shop has words for it
      throw;
    } catch (...) {
    }
    throw;
  }
}

void Shop::watch_event_order() {
  sim_.set_trace([this](const sim::TraceRecord& record) {
    event_order_.add(record.time);
    event_order_.add(record.process);
  });
}

std::vector<std::optional<double>> Shop::run() {
  sim_.set_budget(static_cast<std::uint64_t>(scenario_.simulation.max_events), events_at_one_instant);
  simulate_until(scenario_.simulation.warmup_min);
  reset_counts();
  simulate_until(scenario_.simulation.horizon_min);
  settle();
  book_totals();
  std::vector<std::optional<double>> values;
  each_kpi([&](const KpiInfo& info, std::optional<double> value) {
    // Beyond this squares overflow, and with them every interval.
    if (value && !(std::abs(*value) < 1e150))
      throw sim::BudgetError(
          fmt::format("replication {}: {} = {}, more than can be counted: prices, times or "
                      "life periods of the scenario are too large or too small",
                      replication_, info.name, *value));
    values.push_back(value);
  });
  return values;
}

std::vector<KpiInfo> kpi_infos(const scenarios::Scenario& scenario) {
  std::vector<KpiInfo> infos;
  const Shop shop(scenario, 0);
  shop.each_kpi([&](KpiInfo info, std::optional<double>) { infos.push_back(std::move(info)); });
  return infos;
}

}  // namespace verstat::shop
