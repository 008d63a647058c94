#pragma once
// A pending event, and the order of events.

#include <bit>
#include <cstdint>

namespace verstat::sim::detail {

/// Identity of a scheduled event: priority in the upper 16 bits (biased), sequence number in the lower 48.
/// Comparing two ids compares (priority, sequence). Zero is never issued.
using EventId = std::uint64_t;

constexpr int lowest_priority = -32768;
constexpr int highest_priority = 32767;

/// A pending event. `payload` belongs to the caller; zero never occurs. It should point to what the event
/// will touch (its lowest bit aside): that memory is fetched ahead.
struct Entry {
  double time;
  EventId id;
  std::uintptr_t payload;
};

/// Times are never negative, so their bits order like the numbers, and (time, id) is one 128-bit number:
/// compared without a branch.
__extension__ typedef unsigned __int128 Key;
[[nodiscard]] inline Key key_of(const Entry& entry) noexcept {
  return (static_cast<Key>(std::bit_cast<std::uint64_t>(entry.time)) << 64U) | entry.id;
}

}  // namespace verstat::sim::detail
