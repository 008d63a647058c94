// What goes wrong with parts, and who finds it.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scenarios/incoming.h"
#include "sim/shop/shop_parts.h"

namespace verstat::shop {

// Numbers are drawn only where there is a chance at all, from streams of their own.
bool Shop::breaks(MachineUnit& machine, const PlannedOperation& operation) {
  return operation.breaks > 0 && machine.breakage_stream.uniform() < operation.breaks;
}

bool Shop::spoils(MachineUnit& machine, const PlannedOperation& operation) {
  return operation.spoils > 0 && machine.quality_stream.uniform() < operation.spoils;
}

// What the drawing asks is decided where the route leaves the quantity for the last time.
void Shop::build_quality() {
  states_.resize(scenario_.parts.size());
  for (std::size_t p = 0; p < scenario_.parts.size(); ++p) {
    const auto& requirements = scenario_.parts[p].requirements;
    requirement_counts_.emplace_back(requirements.size());
    bool known = !requirements.empty();
    for (const scenarios::RouteStep& step : routes_[p]) {
      const auto& quality = operations_[step.operation].spec->quality;
      known = known || (quality && (quality->defect_probability > 0 || quality->defect_when_worn > 0));
    }
    defects_known_.push_back(known);
    if (requirements.empty()) continue;
    states_[p].resize(routes_[p].size());
    for (std::size_t r = 0; r < requirements.size(); ++r)
      for (const std::size_t step :
           scenarios::last_steps_that_leave(scenario_, p, requirements[r].quantity)) {
        StateAtStep state{.requirement = r, .value = {}, .fails = {}};
        for (const PlannedOperation& planned : operations_[routes_[p][step].operation].on) {
          state.value.push_back(planned.plan.value_of(requirements[r].quantity).value_or(0));
          state.fails.push_back(scenarios::share_that_fails(requirements[r], planned.plan));
        }
        states_[p][step].push_back(std::move(state));
      }
  }
  for (const OperationUnit& operation : operations_)
    for (const PlannedOperation& planned : operation.on) {
      if (!planned.plan.gauge) continue;
      Group& group = *groups_[planned.group];
      group.has_gauge = true;
      for (MachineUnit* machine : group.machines)
        machine->gauges.push_back({.operation = &planned, .start = planned.plan.gauge->start});
    }
}

bool Shop::leaves_defect(MachineUnit& machine, const PlannedOperation& operation) {
  const Job& job = *machine.job;
  const bool judged = !states_[job.part].empty();
  if (operation.quality == nullptr && !judged) return false;
  double chance = 0;
  if (operation.quality != nullptr) {
    const scenarios::Quality& quality = *operation.quality;
    const double worn = quality.defect_when_worn > 0
                            ? quality.defect_when_worn * std::pow(machine.part_wear, quality.wear_exponent)
                            : 0;
    chance = quality.defect_probability + worn;
  }
  if (judged) {
    const auto group =
        static_cast<std::size_t>(&operation - operations_[routes_[job.part][job.step].operation].on.data());
    double kept = 1 - chance;
    for (const StateAtStep& state : states_[job.part][job.step]) {
      RequirementCounts& counts = requirement_counts_[job.part][state.requirement];
      ++counts.parts;
      // Running means: equal values leave them exactly there.
      const auto parts = static_cast<double>(counts.parts);
      counts.mean_value += (state.value[group] - counts.mean_value) / parts;
      counts.mean_fails += (state.fails[group] - counts.mean_fails) / parts;
      kept *= 1 - state.fails[group];
    }
    chance = 1 - kept;
  }
  return chance > 0 && machine.defect_stream.uniform() < chance;
}

void Shop::assume_defects(MachineUnit& machine, const PlannedOperation& operation, Job& job) {
  if (!operation.plan.detection || defects_known_[job.part] || job.defects_assumed) return;
  job.defects_assumed = true;
  for (std::int64_t k = 0; k < job.quantity; ++k)
    if (machine.defect_stream.uniform() < operation.plan.detection->defective_share) ++job.defects;
}

bool Shop::judge(MachineUnit& machine, const scenarios::Inspection& inspection, bool defective,
                 Verdict& verdict) {
  const double looked_at = machine.inspection_stream.uniform();
  const double judged = machine.inspection_stream.uniform();
  if (looked_at >= inspection.share) return false;
  if (judged < (defective ? inspection.sensitivity : 1 - inspection.specificity)) {
    ++verdict.rejected;
    if (defective) ++verdict.rejected_defects;
  }
  return true;
}

std::int64_t Shop::inspect(MachineUnit& machine, const PlannedOperation& operation, Job& job) {
  scenarios::Inspection inspection = operation.spec->inspection.value_or(scenarios::Inspection());
  if (operation.plan.detection) {  // an inspection by its process model (K205)
    inspection.sensitivity = operation.plan.detection->sensitivity;
    inspection.specificity = operation.plan.detection->specificity;
  }
  assume_defects(machine, operation, job);
  Verdict verdict;
  for (std::int64_t k = 0; k < job.quantity; ++k) judge(machine, inspection, k < job.defects, verdict);
  return conclude(machine, operation, job, verdict);
}

sim::Task<std::int64_t> Shop::inspect_with_gauges(MachineUnit& machine, const PlannedOperation& operation,
                                                  Job& job) {
  GaugeUnit& gauge = *std::find_if(machine.gauges.begin(), machine.gauges.end(),
                                   [&](const GaugeUnit& g) { return g.operation == &operation; });
  const operations::GaugeWear& wear = gauge.spec();
  scenarios::Inspection inspection = operation.spec->inspection.value_or(scenarios::Inspection());
  assume_defects(machine, operation, job);
  Verdict verdict;
  for (std::int64_t k = 0; k < job.quantity; ++k) {
    // Gauges that the check would wear beyond their limit are replaced before it.
    if (gauge.worn() + wear.wear_per_check > wear.replace_at * (1 + 1e-9) && gauge.checks_of_this_one > 0) {
      ++gauge.changes;
      gauge.start = 0;
      gauge.checks_of_this_one = 0;
      costs_.book(Cost::operations, wear.price);
      inspections_.cost += wear.price;
      if (wear.replace_min > 0) co_await spend(machine, MachineState::planned_change, wear.replace_min);
    }
    const bool defective = k < job.defects;
    const operations::Detection now = wear.at(gauge.worn());
    inspection.sensitivity = now.sensitivity;
    inspection.specificity = now.specificity;
    const std::int64_t rejected_before = verdict.rejected;
    if (!judge(machine, inspection, defective, verdict)) continue;
    const bool accepted = verdict.rejected == rejected_before;
    ++(defective ? gauge.defective : gauge.good);
    if (defective && accepted) ++gauge.defective_accepted;
    if (!defective && !accepted) ++gauge.good_rejected;
    gauge.worn_sum += gauge.worn();
    ++gauge.checks;
    ++gauge.checks_of_this_one;
  }
  co_return conclude(machine, operation, job, verdict);
}

std::int64_t Shop::conclude(const MachineUnit& machine, const PlannedOperation& operation, Job& job,
                            Verdict verdict) {
  if (operation.spec->inspection && operation.spec->inspection->acceptance_number) {
    // The lot stands or falls as a whole.
    verdict.rejected = verdict.rejected > *operation.spec->inspection->acceptance_number ? job.quantity : 0;
    verdict.rejected_defects = verdict.rejected > 0 ? job.defects : 0;
  }
  const double time_min = sim_.now() - job.since_min;  // since the batch came onto the station
  const auto parts = static_cast<double>(job.quantity);
  inspections_.defective_rejected += static_cast<std::uint64_t>(verdict.rejected_defects);
  inspections_.good_rejected += static_cast<std::uint64_t>(verdict.rejected - verdict.rejected_defects);
  inspections_.time_min += time_min;
  inspections_.planned_time_min += parts * operation.plan.main_time_min;
  inspections_.cost += time_min * machine.group->spec->rate_per_min + parts * operation.spec->cost;
  job.defects -= verdict.rejected_defects;
  return verdict.rejected;
}

void Shop::reject(MachineUnit& machine, Job& job, std::int64_t quantity) {
  machine.parts_rejected += static_cast<std::uint64_t>(quantity);
  const scenarios::RouteStep& step = routes_[job.part][job.step];
  PartCounts& counts = parts_[job.part];
  job.quantity -= quantity;
  Source& source = *sources_[job.part];
  if (step.rework != scenarios::route_end && job.reworks < step.rework_limit) {
    count_batch(job.part);
    Job* again = jobs_.make();
    *again = job;
    again->quantity = quantity;
    again->defects = 0;
    again->defects_assumed = false;
    ++again->reworks;
    again->step = step.rework;
    again->from = machine.group->index;
    counts.reworked += static_cast<std::uint64_t>(quantity);
    ++source.batches_in_shop;
    send(*again, choose_group(routes_[job.part][again->step].operation));
    return;
  }
  counts.scrapped += static_cast<std::uint64_t>(quantity);
  costs_.book(Cost::scrap, static_cast<double>(quantity) * scenario_.parts[job.part].value);
  source.ended_ever += static_cast<std::uint64_t>(quantity);
  source.parts_in_shop -= quantity;
  work_in_process_.change(sim_.now(), -static_cast<double>(quantity));
  count_lead_time(job, quantity);
}

void Shop::reset_quality_counts() {
  inspections_ = InspectionCounts();
  for (auto& part : requirement_counts_)
    for (RequirementCounts& counts : part) counts = RequirementCounts();
  for (const auto& machine : machines_) {
    if (scenario_.criteria)
      machine->missions.restart(sim_.now(), scenario_.simulation.horizon_min,
                                scenario_.criteria->mission_min);
    for (GaugeUnit& gauge : machine->gauges) {
      gauge.checks = gauge.changes = 0;
      gauge.worn_sum = 0;
      gauge.good = gauge.good_rejected = gauge.defective = gauge.defective_accepted = 0;
    }
  }
}

void Shop::gauge_kpis(const KpiSink& sink) const {
  for (const auto& machine : machines_)
    for (const GaugeUnit& gauge : machine->gauges) {
      const auto put = [&](const char* name, const char* meaning, std::optional<double> value) {
        sink(KpiInfo{fmt::format("machine/{}/gauge/{}/{}", machine->name, gauge.operation->spec->name, name),
                     "1", meaning},
             value);
      };
      const auto count = [](std::uint64_t n) { return static_cast<double>(n); };
      put("checks", "parts checked with the gauges in the counted time", count(gauge.checks));
      put("changes", "gauges replaced in the counted time", count(gauge.changes));
      put("worn", "share of the wear allowance worn off at the end", gauge.worn());
      put("mean_worn", "the same, mean over the checks", ratio(gauge.worn_sum, count(gauge.checks)));
      put("producer_risk", "good parts that the gauges rejected / good parts checked",
          ratio(count(gauge.good_rejected), count(gauge.good)));
      put("consumer_risk", "defective parts that the gauges passed / defective parts checked",
          ratio(count(gauge.defective_accepted), count(gauge.defective)));
    }
}

void Shop::requirement_kpis(std::size_t part, const KpiSink& sink) const {
  const scenarios::PartType& type = scenario_.parts[part];
  for (std::size_t r = 0; r < type.requirements.size(); ++r) {
    const scenarios::Requirement& requirement = type.requirements[r];
    const RequirementCounts& counts = requirement_counts_[part][r];
    const auto mean = [&](double value) {
      return counts.parts > 0 ? std::optional<double>(value) : std::nullopt;
    };
    const char* quantity_unit = "1";
    for (std::size_t step = 0; step < states_[part].size(); ++step)
      for (const StateAtStep& state : states_[part][step])
        if (state.requirement == r)
          quantity_unit =
              operations_[routes_[part][step].operation].on.front().plan.unit_of(requirement.quantity);
    const auto put = [&](const char* name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("part/{}/{}/{}", type.name, requirement.quantity, name), unit, meaning},
           value);
    };
    put("mean", quantity_unit, "mean over the parts made of what the operations leave",
        mean(counts.mean_value));
    put("short_share", "1", "expected share of the parts made that fall short of the drawing",
        mean(counts.mean_fails));
  }
}

}  // namespace verstat::shop
