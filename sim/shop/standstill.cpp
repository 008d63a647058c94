// Machines that block each other for good: found when it happens, told with the result.
#include <algorithm>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

using scenarios::route_end;

namespace {

constexpr std::size_t machines_named = 6;

}  // namespace

// A machine moves on unless it is blocked; a blocked one when its place gets room. A queue gets room when a
// machine behind it moves on. A store gets room from customers, or from an assembly that has all its
// components at hand or can still get them. Starting from nothing and adding what follows, everything that
// can move is found; whatever is left stands for good. In doubt something moves: no shop is called dead that
// is not.
struct Shop::Movement {
  explicit Movement(const Shop& shop)
      : group(shop.groups_.size()), store(shop.stores_.size()), part(shop.parts_.size()) {
    for (bool more = true; more;) more = spread(shop);
  }
  [[nodiscard]] bool room(Place place) const {
    return place.store != route_end ? store[place.store] : place.group == route_end || group[place.group];
  }
  [[nodiscard]] bool moves(const MachineUnit& machine) const {
    return machine.clock.state() != MachineState::blocked || room(machine.waits_for);
  }

  std::vector<bool> group;  // has a machine that moves
  std::vector<bool> store;  // gets room
  std::vector<bool> part;   // passes all its operations

 private:
  bool done_by_some(const Shop& shop, std::size_t operation) const {
    const auto& on = shop.operations_[operation].on;
    return std::any_of(on.begin(), on.end(), [&](const PlannedOperation& o) { return group[o.group]; });
  }
  bool empties(const Shop& shop, const StoreUnit& unit) const {
    if (unit.spec->demand) return true;
    for (std::size_t p = 0; p < shop.routes_.size(); ++p)
      for (const scenarios::RouteStep& step : shop.routes_[p]) {
        const auto& wanted = step.assembles;
        const bool from_here = std::any_of(wanted.begin(), wanted.end(),
                                           [&](const auto& c) { return shop.store_of_[c.part] == &unit; });
        const bool complete = std::all_of(wanted.begin(), wanted.end(), [&](const auto& c) {
          const std::int64_t batch = shop.scenario_.parts[p].batch_size;
          return part[c.part] || shop.store_of_[c.part]->parts[c.part] >= c.count * batch;
        });
        if (from_here && complete && done_by_some(shop, step.operation)) return true;
      }
    return false;
  }
  static bool set(std::vector<bool>& known, std::size_t k, bool now) {
    const bool news = now && !known[k];
    if (news) known[k] = true;
    return news;
  }
  bool spread(const Shop& shop) {
    bool news = false;
    for (const auto& machine : shop.machines_)
      if (!group[machine->group->index]) news |= set(group, machine->group->index, moves(*machine));
    for (std::size_t p = 0; p < part.size(); ++p) {
      const auto& route = shop.routes_[p];
      news |= set(part, p, std::all_of(route.begin(), route.end(), [&](const scenarios::RouteStep& step) {
                    return done_by_some(shop, step.operation);
                  }));
    }
    for (std::size_t s = 0; s < store.size(); ++s)
      if (!store[s]) news |= set(store, s, empties(shop, *shop.stores_[s]));
    return news;
  }
};

std::string Shop::standstill() const {
  return stands_since_min_ ? fmt::format("from {:.6g} min on: {}", *stands_since_min_, standstill_) : "";
}

void Shop::note_standstill(const std::vector<Labour::Wait>& waits) {
  if (stands_since_min_) return;
  stands_since_min_ = sim_.now();
  for (std::size_t k = 0; k < std::min(waits.size(), machines_named); ++k)
    standstill_ += fmt::format("{}\"{}\" keeps one of \"{}\" and waits for \"{}\"", k == 0 ? "" : ", ",
                               machines_[waits[k].machine]->name, scenario_.crews[waits[k].keeps].name,
                               scenario_.crews[waits[k].wants].name);
}

// Asked whenever a machine is blocked; nearly always a machine behind the full place is at work and that is
// all.
void Shop::look_for_standstill(const MachineUnit& blocked) {
  if (stands_since_min_) return;
  const Place wanted = blocked.waits_for;
  if (wanted.store != route_end) {
    if (stores_[wanted.store]->spec->demand) return;
  } else {
    for (const MachineUnit* machine : groups_[wanted.group]->machines)
      if (machine->clock.state() != MachineState::blocked) return;
  }
  const Movement movement(*this);
  if (movement.room(wanted)) return;
  stands_since_min_ = sim_.now();
  std::size_t named = 0;
  for (const auto& machine : machines_) {
    if (movement.moves(*machine)) continue;
    const Place to = machine->waits_for;
    if (named++ == machines_named) break;
    standstill_ +=
        fmt::format("{}\"{}\" holds \"{}\" for \"{}\"", named == 1 ? "" : ", ", machine->name,
                    scenario_.parts[machine->job->part].name,
                    to.store != route_end ? stores_[to.store]->spec->name : groups_[to.group]->spec->name);
  }
  if (named > machines_named) standstill_ += ", ...";
}

}  // namespace verstat::shop
