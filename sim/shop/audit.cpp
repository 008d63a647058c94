// Laws of conservation, checked from the state of the shop itself and not from what the KPIs say.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

std::vector<std::string> Shop::audit() const {
  std::vector<std::string> broken;
  std::vector<std::int64_t> in_shop(parts_.size(), 0);
  jobs_.for_each_in_use([&](const Job& job) { in_shop[job.part] += job.quantity; });
  std::int64_t wip = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Source& source = *sources_[p];
    wip += in_shop[p];
    if (static_cast<std::int64_t>(source.released_ever) !=
        static_cast<std::int64_t>(source.ended_ever) + in_shop[p])
      broken.push_back(fmt::format("parts \"{}\": {} released, {} stored or scrapped, {} in the shop",
                                   scenario_.parts[p].name, source.released_ever, source.ended_ever,
                                   in_shop[p]));
    if (source.parts_in_shop != in_shop[p])
      broken.push_back(fmt::format("parts \"{}\": {} counted in the shop, {} found", scenario_.parts[p].name,
                                   source.parts_in_shop, in_shop[p]));
  }
  if (static_cast<double>(wip) != work_in_process_.value())
    broken.push_back(fmt::format("work in process: {} recorded, {} found", work_in_process_.value(), wip));
  for (const auto& store : stores_) {
    std::int64_t level = 0;
    for (const std::int64_t parts : store->parts) level += parts;
    if (level != store->level || static_cast<std::int64_t>(store->stored) !=
                                     level + static_cast<std::int64_t>(store->taken + store->assembled))
      broken.push_back(fmt::format("store \"{}\": {} stored, {} taken, {} assembled, {} there",
                                   store->spec->name, store->stored, store->taken, store->assembled, level));
    std::int64_t largest_batch = 1;
    for (const std::size_t kind : store->kinds)
      largest_batch = std::max(largest_batch, scenario_.parts[kind].batch_size);
    if (store->spec->capacity && level > std::max(*store->spec->capacity, largest_batch))
      broken.push_back(fmt::format("store \"{}\": {} parts, capacity {}", store->spec->name, level,
                                   *store->spec->capacity));
  }
  for (const auto& spares : spares_)
    if (spares->stock != spares->spec->stock + static_cast<std::int64_t>(spares->delivered_ever) -
                             static_cast<std::int64_t>(spares->used_ever))
      broken.push_back(fmt::format("spare \"{}\": {} there, {} delivered, {} used", spares->spec->name,
                                   spares->stock, spares->delivered_ever, spares->used_ever));
  for (const auto& machine : machines_) {
    double sum_min = 0;
    for (std::size_t s = 0; s < machine_states; ++s)
      sum_min += machine->clock.time_min(static_cast<MachineState>(s));
    if (std::abs(sum_min - window_min()) > 1e-9 * scenario_.simulation.horizon_min)
      broken.push_back(
          fmt::format("machine \"{}\": states add up to {} of {} min", machine->name, sum_min, window_min()));
  }
  audit_tools(broken);
  for (std::size_t k = 0; k < scenario_.crews.size(); ++k)
    if (labour_->busy_min(k) < 0)
      broken.push_back(
          fmt::format("crew \"{}\": {} min of work", scenario_.crews[k].name, labour_->busy_min(k)));
  return broken;
}

}  // namespace verstat::shop
