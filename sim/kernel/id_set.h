#pragma once
// A set of 64-bit numbers other than zero: open addressing, no allocation at a steady size.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace verstat::sim::detail {

class IdSet {
 public:
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  void insert(std::uint64_t id) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::size_t at = home(id);
    while (slots_[at] != 0) at = next(at);
    slots_[at] = id;
    ++size_;
  }

  [[nodiscard]] bool contains(std::uint64_t id) const noexcept {
    if (size_ == 0) return false;
    for (std::size_t at = home(id); slots_[at] != 0; at = next(at)) {
      if (slots_[at] == id) return true;
    }
    return false;
  }

  /// Removes `id`; true when it was there. Later members of the probe chain move up, so no marks are left.
  bool erase(std::uint64_t id) noexcept {
    if (size_ == 0) return false;
    std::size_t hole = home(id);
    while (slots_[hole] != id) {
      if (slots_[hole] == 0) return false;
      hole = next(hole);
    }
    for (std::size_t at = next(hole); slots_[at] != 0; at = next(at)) {
      const std::size_t mask = slots_.size() - 1;
      const std::size_t from_home = (at - home(slots_[at])) & mask;
      const std::size_t from_hole = (at - hole) & mask;
      if (from_home >= from_hole) {
        slots_[hole] = slots_[at];
        hole = at;
      }
    }
    slots_[hole] = 0;
    --size_;
    return true;
  }

  void clear() noexcept {
    if (size_ == 0) return;
    for (std::uint64_t& slot : slots_) slot = 0;
    size_ = 0;
  }

 private:
  [[nodiscard]] std::size_t home(std::uint64_t id) const noexcept {
    // Fibonacci hashing: ids are consecutive numbers, which the multiplication spreads evenly.
    return static_cast<std::size_t>((id * 0x9e3779b97f4a7c15ULL) >> 32U) & (slots_.size() - 1);
  }
  [[nodiscard]] std::size_t next(std::size_t at) const noexcept { return (at + 1) & (slots_.size() - 1); }

  void grow() {
    std::vector<std::uint64_t> old(slots_.empty() ? 16 : 2 * slots_.size(), 0);
    old.swap(slots_);
    size_ = 0;
    for (const std::uint64_t id : old) {
      if (id != 0) insert(id);
    }
  }

  std::vector<std::uint64_t> slots_;
  std::size_t size_ = 0;
};

}  // namespace verstat::sim::detail
