#pragma once
// Objects that lie beside each other: from the pool that coroutine frames come from.

#include <cstddef>

#include "sim/kernel/frame_pool.h"

namespace verstat::sim {

/// Base of things a model has many of and visits in no order. The pool lays them out in the order they are
/// made, on huge pages when there are many: each event of a large plant touches dozens of cache lines, and
/// on small pages nearly every one would cost an address translation, too.
struct Pooled {
  static void* operator new(std::size_t bytes) { return detail::FramePool::allocate(bytes); }
  static void operator delete(void* block, std::size_t bytes) noexcept {
    detail::FramePool::release(block, bytes);
  }
};

/// The same for standard containers.
template <class T>
struct PoolAllocator {
  using value_type = T;
  PoolAllocator() = default;
  template <class U>
  PoolAllocator(const PoolAllocator<U>&) noexcept {}  // NOLINT: required conversion
  [[nodiscard]] T* allocate(std::size_t n) {
    return static_cast<T*>(detail::FramePool::allocate(n * sizeof(T)));
  }
  void deallocate(T* block, std::size_t n) noexcept { detail::FramePool::release(block, n * sizeof(T)); }
  template <class U>
  friend bool operator==(const PoolAllocator&, const PoolAllocator<U>&) noexcept {
    return true;
  }
};

}  // namespace verstat::sim
