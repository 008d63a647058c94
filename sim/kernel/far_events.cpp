#include "sim/kernel/far_events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace verstat::sim::detail {
namespace {

constexpr std::size_t per_bucket = 5;  // events in a bucket when the year starts, on average
constexpr std::size_t few = 64;        // so few are not worth a year

}  // namespace

inline void FarEvents::prefetch_entries(std::size_t bucket) const noexcept {
  if (bucket >= buckets_.size() || buckets_[bucket].chunk == none) return;
  const auto* bytes = reinterpret_cast<const char*>(&chunks_[buckets_[bucket].chunk]);
  const std::size_t used = buckets_[bucket].count * sizeof(Entry);
  for (std::size_t byte = 0; byte < used; byte += 64) __builtin_prefetch(bytes + byte);
}

inline void FarEvents::prefetch_targets(std::size_t bucket) const noexcept {
  if (bucket >= buckets_.size() || buckets_[bucket].chunk == none) return;
  const Chunk& chunk = chunks_[buckets_[bucket].chunk];
  for (std::uint32_t i = 0; i < buckets_[bucket].count; ++i) {
    const auto* bytes = reinterpret_cast<const char*>(chunk.entries[i].payload);
    __builtin_prefetch(bytes, 1);
    __builtin_prefetch(bytes + 64, 1);
    __builtin_prefetch(bytes + 128, 1);
  }
}

void FarEvents::spread(std::span<const Entry> entries) {
  later_.insert(later_.end(), entries.begin(), entries.end());
  size_ += entries.size();
  start_year();
}

void FarEvents::write_staged() {
  const std::size_t n = std::min(staged_count_, staged_.size());
  for (std::size_t i = staged_count_ - n; i < staged_count_; ++i) {
    const Staged& slot = staged_[i % staged_.size()];
    append(buckets_[slot.bucket], slot.entry);
  }
  staged_count_ = 0;
}

std::size_t FarEvents::next_used(std::size_t bucket) const noexcept {
  while (bucket < buckets_.size() && buckets_[bucket].chunk == none) ++bucket;
  return bucket;
}

void FarEvents::next_bucket(std::vector<Entry>& out) {
  // The year was laid out for far fewer events: lay out a new one.
  if (size_ > 4 * planned_ + 1024) {
    write_staged();
    for (; present_ < buckets_.size(); ++present_) {
      collect(buckets_[present_], later_);
    }
    start_year();
  }
  while (size_ == later_.size()) {
    if (size_ <= few || !start_year()) {
      hand_out_all(out);
      return;
    }
  }
  std::size_t next = next_used(present_);
  for (std::size_t i = staged_count_ - std::min(staged_count_, staged_.size()); i < staged_count_; ++i) {
    if (staged_[i % staged_.size()].bucket <= next) {
      write_staged();
      next = next_used(present_);
    }
  }
  present_ = next;
  prefetch_targets(present_ + 1);
  prefetch_entries(present_ + 3);
  size_ -= collect(buckets_[present_], out);
  ++present_;
  near_end_ = static_cast<double>(present_);
}

bool FarEvents::start_year() {
  buckets_.clear();
  present_ = 0;
  near_end_ = 0.0;
  year_end_ = 0.0;
  // Half of the events lie before the median: their density sets the width, and as many buckets again cover
  // most of the other half. A tail, however long, waits for the next year. A sample gives the median well
  // enough.
  const std::size_t n = later_.size();
  double first = later_.front().time;
  double last = first;
  for (const Entry& entry : later_) {
    first = entry.time < first ? entry.time : first;
    last = entry.time > last ? entry.time : last;
  }
  std::array<double, 101> sample;
  for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = later_[i * n / sample.size()].time;
  const auto middle = sample.begin() + sample.size() / 2;
  std::nth_element(sample.begin(), middle, sample.end());
  double span = 2.0 * (*middle - first);
  if (!(span > 0.0)) span = last - first;
  const auto count = static_cast<double>(std::max<std::size_t>(1, n / per_bucket));
  const double scale = count / span;
  if (!(span > 0.0) || !std::isfinite(scale) || !(first + span / count > first)) return false;
  start_ = first;
  per_time_ = scale;
  year_end_ = count;
  planned_ = n;
  buckets_.assign(static_cast<std::size_t>(count), Bucket());
  std::size_t kept = 0;
  for (const Entry& entry : later_) {
    const double at = position(entry.time);
    if (at < year_end_) {
      stage(static_cast<std::uint32_t>(at), entry);
    } else {
      later_[kept++] = entry;
    }
  }
  later_.resize(kept);
  write_staged();
  return true;
}

void FarEvents::hand_out_all(std::vector<Entry>& out) {
  out.insert(out.end(), later_.begin(), later_.end());
  later_.clear();
  buckets_.clear();
  size_ = 0;
  present_ = 0;
  start_ = 0.0;
  per_time_ = 0.0;
  near_end_ = std::numeric_limits<double>::infinity();
  year_end_ = 0.0;
}

void FarEvents::add_chunk(Bucket& bucket) {
  std::uint32_t fresh = free_chunk_;
  if (fresh != none) {
    free_chunk_ = chunks_[fresh].next;
  } else {
    fresh = static_cast<std::uint32_t>(chunks_.size());
    chunks_.emplace_back();
  }
  chunks_[fresh].next = bucket.chunk;
  bucket = Bucket(fresh, 0);
}

}  // namespace verstat::sim::detail
