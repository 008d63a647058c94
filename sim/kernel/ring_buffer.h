#pragma once
// A growing queue of values in one block of memory, with access to the middle.

#include <cstddef>
#include <new>
#include <utility>

#include "sim/kernel/pooled.h"

namespace verstat::sim {

/// Like std::deque, but it allocates only when it grows beyond its largest size so far.
template <class T>
class RingBuffer {
 public:
  RingBuffer() = default;
  RingBuffer(const RingBuffer&) = delete;
  RingBuffer& operator=(const RingBuffer&) = delete;
  ~RingBuffer() {
    while (size_ != 0) pop_front();
    release(slots_, capacity_);
  }

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return *at(i); }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return *at(i); }

  void push_back(T value) {
    if (size_ == capacity_) grow();
    new (static_cast<void*>(slots_ + ((head_ + size_) & (capacity_ - 1)))) T(std::move(value));
    ++size_;
  }
  void push_front(T value) {
    if (size_ == capacity_) grow();
    head_ = (head_ + capacity_ - 1) & (capacity_ - 1);
    new (static_cast<void*>(slots_ + head_)) T(std::move(value));
    ++size_;
  }
  T pop_front() {
    T value = std::move(*at(0));
    at(0)->~T();
    head_ = (head_ + 1) & (capacity_ - 1);
    --size_;
    return value;
  }
  T pop_back() {
    T value = std::move(*at(size_ - 1));
    at(--size_)->~T();
    return value;
  }
  /// Moves what lies behind position `i` (0 to size) one up; O(size - i).
  void insert(std::size_t i, T value) {
    push_back(std::move(value));
    for (std::size_t k = size_ - 1; k > i; --k) std::swap((*this)[k], (*this)[k - 1]);
  }
  /// Takes out element `i`; O(i).
  T erase(std::size_t i) {
    for (std::size_t k = i; k > 0; --k) std::swap((*this)[k], (*this)[k - 1]);
    return pop_front();
  }

 private:
  [[nodiscard]] T* at(std::size_t i) const noexcept { return slots_ + ((head_ + i) & (capacity_ - 1)); }
  static void release(T* slots, std::size_t capacity) noexcept {
    if (slots != nullptr) PoolAllocator<T>().deallocate(slots, capacity);
  }
  void grow() {
    const std::size_t wider = capacity_ == 0 ? 8 : 2 * capacity_;
    T* slots = PoolAllocator<T>().allocate(wider);
    for (std::size_t i = 0; i < size_; ++i) {
      new (static_cast<void*>(slots + i)) T(std::move(*at(i)));
      at(i)->~T();
    }
    release(slots_, capacity_);
    slots_ = slots;
    capacity_ = wider;
    head_ = 0;
  }

  T* slots_ = nullptr;
  std::size_t capacity_ = 0;  // a power of two
  std::size_t head_ = 0;
  std::size_t size_ = 0;
};

}  // namespace verstat::sim
