#pragma once
// Large blocks of memory, on huge pages where the system has them.

#include <cstddef>
#include <new>

namespace verstat::sim::detail {

/// Memory of `bytes` for random access. From 2 MB on it asks for huge pages: with a million processes nearly
/// every access would otherwise miss the address translation cache. Given back by release_large.
[[nodiscard]] void* allocate_large(std::size_t bytes);
void release_large(void* block) noexcept;

/// The same for standard containers.
template <class T>
struct LargeAllocator {
  using value_type = T;
  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) noexcept {}  // NOLINT: required conversion
  [[nodiscard]] T* allocate(std::size_t n) { return static_cast<T*>(allocate_large(n * sizeof(T))); }
  void deallocate(T* block, std::size_t) noexcept { release_large(block); }
  template <class U>
  friend bool operator==(const LargeAllocator&, const LargeAllocator<U>&) noexcept {
    return true;
  }
};

}  // namespace verstat::sim::detail
