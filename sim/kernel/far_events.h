#pragma once
// Events that are not due soon, sorted only roughly: what keeps a million pending events cheap.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sim/kernel/entry.h"
#include "sim/kernel/large_memory.h"

namespace verstat::sim::detail {

/// A row of buckets of equal width in time (the year), each an unordered bag, and one bag for all that comes
/// later. Adding an event writes one entry at the end of a bag. When the present bucket has been used up the
/// next one is handed out; when the year is over the later events are spread over a new one, whose width
/// fits their density. Related to the ladder queue (Tang, Goh, Thng, ACM TOMACS 15 (2005) 175), with a heap
/// in place of the lower rungs, so that many events at one time cost no more than in a heap.
///
/// Positions are computed by one monotone function of time, so buckets are in strict order whatever is
/// rounded, and events of equal time share a bucket.
class FarEvents {
 public:
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// True when an event at this time belongs to the present bucket or an earlier one: it is not far.
  [[nodiscard]] bool is_near(double time) const noexcept { return position(time) < near_end_; }

  /// Adds an event that is not near.
  void push(const Entry& entry) {
    const double at = position(entry.time);
    ++size_;
    if (at < year_end_) {
      stage(static_cast<std::uint32_t>(at), entry);
    } else {
      later_.push_back(entry);
    }
  }

  /// Takes over all events of a list that got too long, and starts a year with them.
  void spread(std::span<const Entry> entries);

  /// Moves the events of the next bucket that has any to the empty `out`; size() must not be 0. When few
  /// are left it hands out all, and everything is near from then on.
  void next_bucket(std::vector<Entry>& out);

  /// Removes all events for which `gone(id)` holds.
  template <class Gone>
  void remove_if(Gone gone);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t chunk_entries = 10;
  struct alignas(64) Chunk {  // four cache lines
    std::uint32_t next;
    Entry entries[chunk_entries];
  };
  static_assert(sizeof(Chunk) == 256);
  // The count stands here and not in the chunk: adding an event touches one line of the chunk only.
  struct Bucket {
    Bucket() = default;
    Bucket(std::uint32_t c, std::uint32_t n) : chunk(c), count(n) {}
    std::uint32_t chunk = none;           // the newest; all others are full
    std::uint32_t count = chunk_entries;  // entries in it
  };

  struct Staged {
    std::uint32_t bucket;
    Entry entry;
  };

  [[nodiscard]] double position(double time) const noexcept { return (time - start_) * per_time_; }
  void append(Bucket& bucket, const Entry& entry) {
    if (bucket.count == chunk_entries) add_chunk(bucket);
    chunks_[bucket.chunk].entries[bucket.count++] = entry;
  }
  void add_chunk(Bucket& bucket);
  // A bucket is memory that was not touched for long. A write to it would hold up all later writes until the
  // line has arrived: so the line is called for now, and the entry written some events later.
  void stage(std::uint32_t bucket, const Entry& entry) {
    const Bucket& target = buckets_[bucket];
    if (target.count != chunk_entries) __builtin_prefetch(&chunks_[target.chunk].entries[target.count], 1);
    Staged& slot = staged_[staged_count_++ % staged_.size()];
    if (staged_count_ > staged_.size()) append(buckets_[slot.bucket], slot.entry);
    slot = Staged{bucket, entry};
  }
  void write_staged();
  // The first bucket from `bucket` on that has events in memory; buckets_.size() when there is none.
  [[nodiscard]] std::size_t next_used(std::size_t bucket) const noexcept;
  // Lays out a year for `later_`; false when that is impossible (all at one time).
  bool start_year();
  template <class Bag>
  std::size_t collect(Bucket& bucket, Bag& out);
  void hand_out_all(std::vector<Entry>& out);
  // Inlined by force: g++ 12 takes a function that only prefetches for one without effect and drops the call.
  [[gnu::always_inline]] void prefetch_entries(std::size_t bucket) const noexcept;
  [[gnu::always_inline]] void prefetch_targets(std::size_t bucket) const noexcept;

  // Without far events everything is near: position 0 < infinity.
  double start_ = 0.0;
  double per_time_ = 0.0;  // buckets per unit of time
  double near_end_ = std::numeric_limits<double>::infinity();
  double year_end_ = 0.0;    // number of buckets
  std::size_t present_ = 0;  // the next bucket to hand out
  std::size_t size_ = 0;
  std::size_t planned_ = 0;  // events for which the year was laid out
  std::vector<Bucket> buckets_;
  std::vector<Chunk, LargeAllocator<Chunk>> chunks_;
  std::uint32_t free_chunk_ = none;
  std::vector<Entry, LargeAllocator<Entry>> later_;
  std::array<Staged, 16> staged_;  // a ring, the newest behind
  std::size_t staged_count_ = 0;   // ever staged since the last write_staged
};

template <class Bag>
std::size_t FarEvents::collect(Bucket& bucket, Bag& out) {
  std::size_t moved = 0;
  while (bucket.chunk != none) {
    const std::uint32_t index = bucket.chunk;
    Chunk& chunk = chunks_[index];
    out.insert(out.end(), chunk.entries, chunk.entries + bucket.count);
    moved += bucket.count;
    bucket = Bucket(chunk.next, chunk_entries);
    chunk.next = std::exchange(free_chunk_, index);
  }
  return moved;
}

template <class Gone>
void FarEvents::remove_if(Gone gone) {
  write_staged();
  size_ = 0;
  std::vector<Entry> bag;
  for (Bucket& bucket : buckets_) {
    if (bucket.chunk == none) continue;
    bag.clear();
    collect(bucket, bag);
    for (const Entry& entry : bag) {
      if (gone(entry.id)) continue;
      append(bucket, entry);
      ++size_;
    }
  }
  std::size_t kept = 0;
  for (const Entry& entry : later_) {
    if (!gone(entry.id)) later_[kept++] = entry;
  }
  later_.resize(kept);
  size_ += kept;
}

}  // namespace verstat::sim::detail
