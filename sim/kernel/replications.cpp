#include "sim/kernel/replications.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace verstat::sim::detail {
namespace {

/// The exception of the lowest index so far.
class FirstFailure {
 public:
  void note(std::size_t index, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (index < lowest_.load(std::memory_order_relaxed)) {
      lowest_.store(index, std::memory_order_relaxed);
      error_ = std::move(error);
    }
  }
  [[nodiscard]] bool below(std::size_t index) const noexcept {
    return lowest_.load(std::memory_order_relaxed) < index;
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::atomic<std::size_t> lowest_{~std::size_t{0}};
  std::exception_ptr error_;
};

}  // namespace

void run_jobs(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& job) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, n));
  FirstFailure failure;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (;;) {
      const std::size_t i = next.fetch_add(1, std::memory_order_relaxed);
      // Indices are taken in order, so everything below a failed one has been taken before.
      if (i >= n || failure.below(i)) return;
      try {
        job(i);
      } catch (...) {
        failure.note(i, std::current_exception());
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (unsigned t = 1; t < threads; ++t) pool.emplace_back(work);
    work();
  }
  failure.rethrow();
}

}  // namespace verstat::sim::detail
