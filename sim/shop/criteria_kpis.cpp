// The criteria of efficiency of K205, computed from a run.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

namespace {

namespace k205 = models::k205;

// Headings that are losses: scrap, what leaves wrong or late, and what stoppages cost.
constexpr std::array loss_headings{Cost::scrap,       Cost::escapes,        Cost::tardiness,
                                   Cost::lost_demand, Cost::damage,         Cost::failure_change,
                                   Cost::repair,      Cost::waiting_repair, Cost::overload_reset};

struct Criterion {
  const char* name;
  const char* unit;
  const char* meaning;
};
constexpr std::array<Criterion, k205::PerCriterion::count> criteria{
    {{"e01", "1", "information that the inspections give / information needed"},
     {"e02", "1", "good parts accepted / good parts"},
     {"e03", "MONEY", "cost of a part started / probability that a released part conforms"},
     {"e04", "MONEY", "cost of a part started / share that does not escape with a defect"},
     {"e05", "bit/MONEY", "information that the inspections give / their cost"},
     {"e06", "1", "socio-ergonomic: technical, social and economic index, geometric mean"},
     {"e07", "MONEY", "cost of a mission / probability that it passes without a failure"},
     {"e08", "1", "rate of information / rate of an ideal inspection"},
     {"e09", "1", "(value of the output - cost - losses) / value of the output"},
     {"e10", "1/MONEY", "right decisions of the inspections / their cost"}}};

}  // namespace

std::optional<k205::SimulationResult> Shop::criteria_inputs() const {
  k205::SimulationResult in;
  const auto number = [](std::uint64_t n) { return static_cast<double>(n); };
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const PartCounts& part = parts_[p];
    in.parts_started += number(part.released);
    in.defect_accepted += number(part.escaped);
    in.good_accepted += number(part.good - part.escaped);
    in.output_value_cu += scenario_.parts[p].price * number(part.good - part.escaped);
  }
  in.defect_rejected = number(inspections_.defective_rejected);
  in.good_rejected = number(inspections_.good_rejected);
  const double judged = in.defect_rejected + in.good_rejected + in.defect_accepted + in.good_accepted;
  if (!(in.parts_started > 0) || !(judged > 0)) return std::nullopt;
  in.defects_by_type = {in.defect_rejected + in.defect_accepted};
  in.detected_by_type = {in.defect_rejected};
  in.diagnosis_time_min = inspections_.time_min / judged;
  if (inspections_.planned_time_min > 0)
    in.diagnosis_time_ideal_min = inspections_.planned_time_min / judged;
  else
    in.diagnosis_time_ideal_min = 1;  // any: without inspections there is no rate to compare
  in.diagnosis_cost_cu = inspections_.cost;
  double total = 0;
  for (std::size_t c = 0; c < cost_headings; ++c) total += costs_[static_cast<Cost>(c)];
  for (const Cost heading : loss_headings) in.losses_cu += costs_[heading];
  in.production_cost_cu = std::max(0.0, total - in.losses_cu - in.diagnosis_cost_cu);

  double production_min = 0;
  double busy_min = 0;
  double planned_min = 0;
  double made = 0;
  double rejected = 0;
  for (const auto& machine : machines_) {
    const StateClock& clock = machine->clock;
    production_min += clock.time_min(MachineState::cutting) + clock.time_min(MachineState::working);
    busy_min +=
        window_min() - clock.time_min(MachineState::off_shift) - clock.time_min(MachineState::maintenance);
    planned_min += machine->planned_min;
    made += number(machine->parts_done);
    rejected += number(machine->parts_rejected);
    in.missions += static_cast<double>(machine->missions.intervals());
    in.missions_failure_free += static_cast<double>(machine->missions.at_most(0));
  }
  // A part under way when counting starts is planned as a whole: more than was worked since.
  in.availability = std::min(1.0, ratio(production_min, busy_min).value_or(0));
  in.performance = std::min(1.0, ratio(planned_min, production_min).value_or(0));
  in.quality = std::max(0.0, ratio(made - rejected, made).value_or(0));
  for (std::size_t k = 0; k < scenario_.crews.size(); ++k)
    in.operator_load = std::max(
        in.operator_load, ratio(labour_->busy_min(k), labour_->present_min(k, scenario_.simulation.warmup_min,
                                                                           scenario_.simulation.horizon_min))
                              .value_or(0));
  in.operator_load_limit = scenario_.criteria->operator_load_limit;
  return in;
}

void Shop::criteria_kpis(const KpiSink& sink) const {
  if (!scenario_.criteria) return;
  const scenarios::CriteriaSettings& settings = *scenario_.criteria;
  const auto in = criteria_inputs();
  k205::Criteria values;
  if (in) values = k205::evaluate_all_criteria(*in);
  const auto all = values.values();
  const auto unit_of = [&](const Criterion& criterion) {
    std::string unit = criterion.unit;
    if (const auto at = unit.find("MONEY"); at != std::string::npos) unit.replace(at, 5, scenario_.currency);
    return unit;
  };
  for (std::size_t k = 0; k < criteria.size(); ++k)
    sink(KpiInfo{fmt::format("criteria/{}", criteria[k].name), unit_of(criteria[k]),
                 fmt::format("{} (K205)", criteria[k].meaning)},
         all[k]);
  if (!settings.has_hierarchy()) return;
  const auto hierarchy = settings.hierarchy(values);
  const auto judged = hierarchy.criteria.values();
  std::optional<double> efficiency;
  std::optional<double> feasible;
  if (std::any_of(judged.begin(), judged.end(), [](const auto& v) { return v.has_value(); })) {
    try {
      const auto result = k205::hierarchical_efficiency(hierarchy);
      efficiency = result.efficiency;
      feasible = result.feasible;
    } catch (const models::ModelError&) {
      // Of the criteria that this run defines none has a weight.
    }
  }
  sink(
      KpiInfo{"criteria/efficiency", "1", "hierarchy of the criteria that have best and worst values (K205)"},
      efficiency);
  sink(KpiInfo{"criteria/feasible", "1", "1: no normalized criterion lies below its minimum"}, feasible);
}

}  // namespace verstat::shop
