#include "sim/kernel/frame_pool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "sim/kernel/large_memory.h"

namespace verstat::sim::detail {
namespace {

constexpr std::size_t step_bytes = 64;       // a cache line: neighbours never share one
constexpr std::size_t largest_bytes = 2048;  // larger frames are rare enough for malloc
constexpr std::size_t classes = largest_bytes / step_bytes + 1;
constexpr std::size_t first_chunk_bytes = std::size_t{16} << 10U;
constexpr std::size_t largest_chunk_bytes = std::size_t{8} << 20U;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool pooling = false;
#else
constexpr bool pooling = true;
#endif

struct Block {
  Block* next;
};
using Heads = std::array<Block*, classes>;

/// Chunks of all threads, and free blocks of threads that have ended.
class Depot {
 public:
  void* new_chunk(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    chunks_.push_back(nullptr);
    return chunks_.back() = allocate_large(bytes);
  }
  void leave(Heads& heads) noexcept {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < classes; ++i) {
      while (heads[i] != nullptr) {
        Block* block = std::exchange(heads[i], heads[i]->next);
        block->next = std::exchange(left_[i], block);
        anything_.store(true, std::memory_order_relaxed);
      }
    }
  }
  Block* take_all(std::size_t index) noexcept {
    if (!anything_.load(std::memory_order_relaxed)) return nullptr;
    const std::lock_guard lock(mutex_);
    return std::exchange(left_[index], nullptr);
  }

 private:
  std::mutex mutex_;
  std::atomic<bool> anything_{false};
  Heads left_{};
  std::vector<void*> chunks_;
};

// Never destroyed: threads may end after static objects are gone.
Depot& depot() {
  static Depot& the_depot = *new Depot;
  return the_depot;
}

// Plain data without constructor, so that reaching it costs no initialisation check.
struct ThreadPool {
  Heads heads;
  std::byte* chunk;  // the rest of the present chunk
  std::size_t chunk_left;
  std::size_t next_chunk_bytes;
  bool guarded;  // a Guard of this thread will hand everything to the depot
  bool closed;   // it has: the thread is ending
};
constinit thread_local ThreadPool pool{};

struct Guard {
  Guard() = default;
  ~Guard() {
    depot().leave(pool.heads);
    pool.closed = true;
  }
};

void guard_this_thread() {
  static thread_local Guard guard;
  pool.guarded = true;
}

void* carve(std::size_t index) {
  if (!pool.guarded && !pool.closed) guard_this_thread();
  if (Block* blocks = depot().take_all(index); blocks != nullptr) {
    pool.heads[index] = blocks->next;
    return blocks;
  }
  const std::size_t bytes = index * step_bytes;
  if (pool.chunk_left < bytes) {
    pool.next_chunk_bytes = std::clamp(2 * pool.next_chunk_bytes, first_chunk_bytes, largest_chunk_bytes);
    pool.chunk = static_cast<std::byte*>(depot().new_chunk(pool.next_chunk_bytes));
    pool.chunk_left = pool.next_chunk_bytes;
  }
  pool.chunk_left -= bytes;
  return std::exchange(pool.chunk, pool.chunk + bytes);
}

}  // namespace

void* FramePool::allocate(std::size_t bytes) {
  const std::size_t index = (bytes + step_bytes - 1) / step_bytes;
  if (!pooling || index >= classes) return ::operator new(bytes);
  if (Block* block = pool.heads[index]; block != nullptr) {
    pool.heads[index] = block->next;
    return block;
  }
  return carve(index);
}

void FramePool::release(void* block, std::size_t bytes) noexcept {
  const std::size_t index = (bytes + step_bytes - 1) / step_bytes;
  if (!pooling || index >= classes) {
    ::operator delete(block);
    return;
  }
  if (!pool.guarded && !pool.closed) guard_this_thread();
  pool.heads[index] = new (block) Block{pool.heads[index]};
  if (pool.closed) depot().leave(pool.heads);
}

}  // namespace verstat::sim::detail
