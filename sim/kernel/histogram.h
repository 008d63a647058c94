#pragma once
// Counts of observations in equal bins.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sim/kernel/engine.h"

namespace verstat::sim {

/// Bins [low + i w, low + (i+1) w), w = (high - low) / bins; what lies outside is counted apart.
class Histogram {
 public:
  /// low < high, both finite, bins >= 1; else std::invalid_argument.
  Histogram(double low, double high, std::size_t bins) : low_(low), high_(high), counts_(bins, 0) {
    if (!(low < high) || std::isinf(low) || std::isinf(high) || bins == 0) {
      throw std::invalid_argument("histogram: low = " + detail::text_of(low) +
                                  ", high = " + detail::text_of(high) + ", bins = " + std::to_string(bins) +
                                  ", allowed low < high, both finite, bins >= 1");
    }
  }

  void add(double x) {
    if (std::isnan(x)) throw std::invalid_argument("histogram: observation is not a number");
    if (x < low_) {
      ++below_;
    } else if (x >= high_) {
      ++above_;
    } else {
      const double at = (x - low_) / (high_ - low_) * static_cast<double>(counts_.size());
      const auto i = static_cast<std::size_t>(at);
      ++counts_[i < counts_.size() ? i : counts_.size() - 1];
    }
  }
  /// Adds the counts of a histogram with the same bins (else std::invalid_argument).
  void merge(const Histogram& other) {
    if (other.low_ != low_ || other.high_ != high_ || other.counts_.size() != counts_.size()) {
      throw std::invalid_argument("histogram: only histograms with the same bins can be merged");
    }
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
    below_ += other.below_;
    above_ += other.above_;
  }

  [[nodiscard]] std::size_t bins() const noexcept { return counts_.size(); }
  [[nodiscard]] std::uint64_t count(std::size_t bin) const { return counts_.at(bin); }
  [[nodiscard]] double lower_edge(std::size_t bin) const noexcept {
    return low_ + (high_ - low_) * static_cast<double>(bin) / static_cast<double>(counts_.size());
  }
  [[nodiscard]] std::uint64_t below() const noexcept { return below_; }
  [[nodiscard]] std::uint64_t above() const noexcept { return above_; }
  [[nodiscard]] std::uint64_t total() const noexcept {
    std::uint64_t sum = below_ + above_;
    for (const std::uint64_t count : counts_) sum += count;
    return sum;
  }

 private:
  double low_;
  double high_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t below_ = 0;
  std::uint64_t above_ = 0;
};

}  // namespace verstat::sim
