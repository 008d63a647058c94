#include "sim/kernel/large_memory.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace verstat::sim::detail {

void* allocate_large(std::size_t bytes) {
  constexpr std::size_t huge_page = std::size_t{2} << 20U;
  const bool huge = bytes >= huge_page;
  const std::size_t alignment = huge ? huge_page : 64;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* block = std::aligned_alloc(alignment, rounded);
  if (block == nullptr) throw std::bad_alloc();
#if defined(__linux__)
  // Only advice: when it is refused, everything works, slower.
  if (huge) static_cast<void>(madvise(block, rounded, MADV_HUGEPAGE));
#endif
  return block;
}

void release_large(void* block) noexcept {
  std::free(block);
}

}  // namespace verstat::sim::detail
