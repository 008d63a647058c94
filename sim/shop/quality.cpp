// What goes wrong with parts, and who finds it.
#include <cmath>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

// Numbers are drawn only where there is a chance at all, from streams of their own.
bool Shop::breaks(MachineUnit& machine, const PlannedOperation& operation) {
  return operation.breaks > 0 && machine.breakage_stream.uniform() < operation.breaks;
}

bool Shop::spoils(MachineUnit& machine, const PlannedOperation& operation) {
  return operation.spoils > 0 && machine.quality_stream.uniform() < operation.spoils;
}

bool Shop::leaves_defect(MachineUnit& machine, const PlannedOperation& operation) {
  if (operation.quality == nullptr) return false;
  const scenarios::Quality& quality = *operation.quality;
  const double worn = quality.defect_when_worn > 0
                          ? quality.defect_when_worn * std::pow(machine.part_wear, quality.wear_exponent)
                          : 0;
  const double chance = quality.defect_probability + worn;
  return chance > 0 && machine.defect_stream.uniform() < chance;
}

std::int64_t Shop::inspect(MachineUnit& machine, const PlannedOperation& operation, Job& job) {
  scenarios::Inspection inspection = operation.spec->inspection.value_or(scenarios::Inspection());
  if (operation.plan.detection) {  // a gauge or an inspection by its process model (K307, K205)
    inspection.sensitivity = operation.plan.detection->sensitivity;
    inspection.specificity = operation.plan.detection->specificity;
  }
  std::int64_t rejected = 0;
  std::int64_t rejected_defects = 0;
  for (std::int64_t k = 0; k < job.quantity; ++k) {
    const bool defective = k < job.defects;
    const double looked_at = machine.inspection_stream.uniform();
    const double judged = machine.inspection_stream.uniform();
    if (looked_at >= inspection.share) continue;
    if (judged < (defective ? inspection.sensitivity : 1 - inspection.specificity)) {
      ++rejected;
      if (defective) ++rejected_defects;
    }
  }
  if (inspection.acceptance_number) {
    // The lot stands or falls as a whole.
    rejected = rejected > *inspection.acceptance_number ? job.quantity : 0;
    rejected_defects = rejected > 0 ? job.defects : 0;
  }
  job.defects -= rejected_defects;
  return rejected;
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
    ++again->reworks;
    again->step = step.rework;
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

}  // namespace verstat::shop
