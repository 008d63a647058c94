#pragma once
// Quantiles of a stream of observations in bounded memory.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace verstat::sim {

/// Merging t-digest (Dunning, Ertl, "Computing extremely accurate quantiles using t-digests", 2019) with the
/// scale function k(q) = (delta / 2 pi) asin(2 q - 1): centroids are small at the tails and large in the
/// middle, so tail quantiles are sharp. Deterministic: the same observations in the same order give the
/// same answer. Exact while no two observations had to share a centroid.
class QuantileSketch {
 public:
  /// `compression` delta >= 20: about that many centroids are kept; the error in rank at the median is of
  /// the order of 1 / delta, far less at the tails.
  explicit QuantileSketch(double compression = 200.0);

  /// Adds an observation, which must not be NaN (std::invalid_argument).
  void add(double x);
  /// As if the observations of `other` had been added here.
  void merge(const QuantileSketch& other);

  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  /// Estimate of the p-quantile, 0 <= p <= 1; NaN never: std::invalid_argument without observations.
  [[nodiscard]] double quantile(double p) const;
  /// Centroids kept at present.
  [[nodiscard]] std::size_t centroids() const;

 private:
  struct Centroid {
    double mean;
    double weight;
  };
  void compress() const;
  // Observations collected before they are merged in.
  [[nodiscard]] std::size_t buffered() const noexcept { return static_cast<std::size_t>(5.0 * compression_); }

  double compression_;
  std::uint64_t count_ = 0;
  double min_;
  double max_;
  // Sorted centroids, and observations not yet merged into them.
  mutable std::vector<Centroid> centroids_;
  mutable std::vector<Centroid> buffer_;
};

}  // namespace verstat::sim
