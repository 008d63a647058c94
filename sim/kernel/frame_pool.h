#pragma once
// Memory of coroutine frames: g++ never elides it, so a process would cost a malloc without this pool.

#include <cstddef>

namespace verstat::sim::detail {

/// Free lists by size, one set per thread, filled from chunks that grow with demand. A block taken in one
/// thread may be given back in another: it then serves that one. What a thread leaves behind goes to a depot
/// for the others; the memory stays with the program. Under address sanitizer the pool steps aside, so that
/// use after free shows.
class FramePool {
 public:
  static void* allocate(std::size_t bytes);
  static void release(void* block, std::size_t bytes) noexcept;
};

}  // namespace verstat::sim::detail
