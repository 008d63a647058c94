#include "sim/kernel/frame_pool.h"

#include <array>
#include <new>

namespace verstat::sim::detail {
namespace {

constexpr std::size_t step_bytes = 64;       // a cache line: neighbours never share one
constexpr std::size_t largest_bytes = 2048;  // larger frames are rare enough for malloc
constexpr std::size_t classes = largest_bytes / step_bytes + 1;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool pooling = false;
#else
constexpr bool pooling = true;
#endif

struct Block {
  Block* next;
};

// Plain data without constructor, so that reaching it costs no initialisation check.
struct FreeLists {
  std::array<Block*, classes> heads;
  bool guarded;  // a Guard of this thread will empty the lists
  bool closed;   // the thread is ending: nothing may be kept any more
};
constinit thread_local FreeLists lists{};

struct Guard {
  Guard() = default;
  ~Guard() {
    lists.closed = true;
    for (Block*& head : lists.heads) {
      while (head != nullptr) {
        Block* next = head->next;
        ::operator delete(head);
        head = next;
      }
    }
  }
};

void guard_this_thread() {
  static thread_local Guard guard;
  lists.guarded = true;
}

}  // namespace

void* FramePool::allocate(std::size_t bytes) {
  const std::size_t index = (bytes + step_bytes - 1) / step_bytes;
  if (!pooling || index >= classes) return ::operator new(bytes);
  if (Block* block = lists.heads[index]; block != nullptr) {
    lists.heads[index] = block->next;
    return block;
  }
  return ::operator new(index* step_bytes);
}

void FramePool::release(void* block, std::size_t bytes) noexcept {
  const std::size_t index = (bytes + step_bytes - 1) / step_bytes;
  if (!pooling || index >= classes || lists.closed) {
    ::operator delete(block);
    return;
  }
  if (!lists.guarded) guard_this_thread();
  lists.heads[index] = new (block) Block{lists.heads[index]};
}

}  // namespace verstat::sim::detail
