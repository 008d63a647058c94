// The event list against an ordered set that does the same in the obvious way.
#include "sim/kernel/event_list.h"

#include <set>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

using verstat::sim::detail::Entry;
using verstat::sim::detail::EventId;
using verstat::sim::detail::EventList;

namespace {

struct Model {
  // (time, id, payload): ids order by (priority, sequence).
  std::set<std::tuple<double, EventId, std::uintptr_t>> pending;
};

/// Plays `steps` random operations on both; `spread` is the range of delays, small for many ties.
void play(std::size_t steps, int spread, int push_percent, int cancel_percent) {
  EventList list;
  Model model;
  double now = 0.0;
  std::uintptr_t payload = 1;
  for (std::size_t i = 0; i < steps; ++i) {
    const int dice = *rc::gen::inRange(0, 100);
    if (dice < push_percent || model.pending.empty()) {
      const int dt = *rc::gen::inRange(0, spread);
      const int priority = *rc::gen::inRange(-2, 3);
      const bool instant = dt == 0 && priority == 0;
      const double time = instant ? now : now + dt;
      const EventId id = instant ? list.push_now(payload) : list.push(time, priority, payload);
      model.pending.emplace(time, id, payload);
      ++payload;
    } else if (dice < push_percent + cancel_percent) {
      auto victim = model.pending.begin();
      std::advance(victim, *rc::gen::inRange<std::size_t>(0, model.pending.size()));
      list.cancel(std::get<1>(*victim));
      model.pending.erase(victim);
    } else {
      const auto expected = *model.pending.begin();
      RC_ASSERT(list.next_time(now) == std::get<0>(expected));
      const Entry entry = list.pop(now);
      RC_ASSERT(std::make_tuple(entry.time, entry.id, entry.payload) == expected);
      model.pending.erase(model.pending.begin());
      now = entry.time;
    }
    RC_ASSERT(list.size() == model.pending.size());
    RC_ASSERT(list.empty() == model.pending.empty());
  }
  while (!model.pending.empty()) {
    const Entry entry = list.pop(now);
    RC_ASSERT(std::make_tuple(entry.time, entry.id, entry.payload) == *model.pending.begin());
    model.pending.erase(model.pending.begin());
    now = entry.time;
  }
  RC_ASSERT(list.empty());
}

}  // namespace

TEST_CASE("events leave in order of time, priority, sequence, whatever is cancelled", "[event_list]") {
  CHECK(rc::check("few pending, many ties", [] { play(400, 4, 45, 15); }));
  CHECK(rc::check("growing, many cancelled", [] { play(1500, 1000, 55, 35); }));
  CHECK(rc::check("growing, few ties", [] { play(1500, 1000000, 70, 5); }));
}

TEST_CASE("an event that would be first is recognised, one that ties is not", "[event_list]") {
  EventList list;
  CHECK(list.nothing_until(1e300));
  list.push(5.0, 0, 1);
  CHECK(list.nothing_until(4.0));
  CHECK_FALSE(list.nothing_until(5.0));
  const EventId instant = list.push_now(2);
  CHECK_FALSE(list.nothing_until(0.0));
  list.cancel(instant);
  CHECK(list.nothing_until(4.0));
}

TEST_CASE("cancelled events do not pile up", "[event_list]") {
  EventList list;
  list.push(1e9, 0, 1);
  // Every event is cancelled behind a later one; without sweeping this would hold a million entries.
  std::vector<EventId> window;
  for (int i = 0; i < 1'000'000; ++i) {
    window.push_back(list.push(1e6 + i, 0, 1));
    if (window.size() == 100) {
      for (const EventId id : window) list.cancel(id);
      window.clear();
    }
  }
  CHECK(list.size() == 1);
  CHECK(list.stored() < 1000);
}
