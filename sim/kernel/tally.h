#pragma once
// Streaming statistics of observations and of quantities that change over time.

#include <cmath>
#include <cstdint>
#include <limits>

namespace verstat::sim {

/// Mean, variance and extremes of observations in constant memory.
/// Welford, Technometrics 4 (1962) 419; merging after Chan, Golub, LeVeque, Am. Stat. 37 (1983) 242.
class Tally {
 public:
  void add(double x) noexcept {
    ++count_;
    const double from_old = x - mean_;
    mean_ += from_old / static_cast<double>(count_);
    squares_ += from_old * (x - mean_);
    min_ = x < min_ ? x : min_;
    max_ = x > max_ ? x : max_;
  }

  /// As if all observations of `other` had been added here (equal up to rounding).
  void merge(const Tally& other) noexcept {
    if (other.count_ == 0) return;
    const double n = static_cast<double>(count_);
    const double m = static_cast<double>(other.count_);
    const double apart = other.mean_ - mean_;
    count_ += other.count_;
    mean_ += apart * m / (n + m);
    squares_ += other.squares_ + apart * apart * n * m / (n + m);
    min_ = other.min_ < min_ ? other.min_ : min_;
    max_ = other.max_ > max_ ? other.max_ : max_;
  }

  void reset() noexcept { *this = Tally(); }

  [[nodiscard]] std::uint64_t count() const noexcept { return static_cast<std::uint64_t>(count_); }
  /// 0 without observations.
  [[nodiscard]] double mean() const noexcept { return mean_; }
  [[nodiscard]] double sum() const noexcept { return mean_ * static_cast<double>(count_); }
  /// Unbiased variance; 0 with fewer than two observations.
  [[nodiscard]] double variance() const noexcept {
    return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1);
  }
  [[nodiscard]] double standard_deviation() const noexcept { return std::sqrt(variance()); }
  /// Standard deviation of the mean, for independent observations.
  [[nodiscard]] double standard_error() const noexcept {
    return count_ == 0 ? 0.0 : std::sqrt(variance() / static_cast<double>(count_));
  }
  /// Infinity without observations.
  [[nodiscard]] double min() const noexcept { return min_; }
  /// -infinity without observations.
  [[nodiscard]] double max() const noexcept { return max_; }

 private:
  std::int64_t count_ = 0;  // signed: converts to double in one instruction
  double mean_ = 0.0;
  double squares_ = 0.0;  // sum of squared deviations from the mean
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
};

/// Time average of a quantity that keeps its value between changes (queue length, machines busy).
class TimeWeighted {
 public:
  explicit TimeWeighted(double start_time = 0.0, double value = 0.0) noexcept
      : start_(start_time), last_(start_time), value_(value), min_(value), max_(value) {}

  /// The quantity has the value `value` from `now` on; times must not go back.
  void set(double now, double value) noexcept {
    area_ += value_ * (now - last_);
    last_ = now;
    value_ = value;
    min_ = value < min_ ? value : min_;
    max_ = value > max_ ? value : max_;
  }
  void change(double now, double by) noexcept { set(now, value_ + by); }

  /// Forgets the past (end of the warm-up); the present value stays.
  void reset(double now) noexcept { *this = TimeWeighted(now, value_); }

  [[nodiscard]] double value() const noexcept { return value_; }
  /// Integral of the quantity over time since the start or the last reset.
  [[nodiscard]] double area(double now) const noexcept { return area_ + value_ * (now - last_); }
  /// Average over time; the present value while no time has passed.
  [[nodiscard]] double mean(double now) const noexcept {
    return now > start_ ? area(now) / (now - start_) : value_;
  }
  [[nodiscard]] double min() const noexcept { return min_; }
  [[nodiscard]] double max() const noexcept { return max_; }
  [[nodiscard]] double start() const noexcept { return start_; }

 private:
  double start_;
  double last_;
  double area_ = 0.0;
  double value_;
  double min_;
  double max_;
};

}  // namespace verstat::sim
