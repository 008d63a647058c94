#include "sim/kernel/quantile_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sim/kernel/engine.h"

namespace verstat::sim {

QuantileSketch::QuantileSketch(double compression)
    : compression_(compression),
      min_(std::numeric_limits<double>::infinity()),
      max_(-std::numeric_limits<double>::infinity()) {
  if (!(compression >= 20.0 && compression <= 1e6)) {
    throw std::invalid_argument("quantile sketch: compression = " + detail::text_of(compression) +
                                ", allowed 20 to 1e6");
  }
  // Room for the observations and the centroids they are merged with: nothing is allocated later.
  buffer_.reserve(buffered() + static_cast<std::size_t>(2.0 * compression) + 10);
}

void QuantileSketch::add(double x) {
  if (std::isnan(x)) throw std::invalid_argument("quantile sketch: observation is not a number");
  if (buffer_.size() >= buffered()) compress();
  buffer_.push_back(Centroid{x, 1.0});
  ++count_;
  min_ = std::min(min_, x);
  max_ = std::max(max_, x);
}

void QuantileSketch::merge(const QuantileSketch& other) {
  other.compress();
  for (const Centroid& centroid : other.centroids_) {
    if (buffer_.size() >= buffered()) compress();
    buffer_.push_back(centroid);
  }
  count_ += other.count_;
  min_ = std::min(min_, other.min_);
  max_ = std::max(max_, other.max_);
}

void QuantileSketch::compress() const {
  if (buffer_.empty()) return;
  buffer_.insert(buffer_.end(), centroids_.begin(), centroids_.end());
  std::stable_sort(buffer_.begin(), buffer_.end(),
                   [](const Centroid& a, const Centroid& b) { return a.mean < b.mean; });
  double total = 0.0;
  for (const Centroid& centroid : buffer_) total += centroid.weight;

  // A centroid may grow as long as it spans at most one unit of the scale function.
  const double scale = compression_ / (2.0 * std::numbers::pi);
  const auto limit_after = [&](double q) {
    const double k = scale * std::asin(2.0 * q - 1.0) + 1.0;
    return k >= compression_ / 4.0 ? 1.0 : 0.5 * (std::sin(k / scale) + 1.0);
  };
  centroids_.clear();
  Centroid open = buffer_.front();
  double before = 0.0;  // weight in front of the open centroid
  double limit = limit_after(0.0);
  for (std::size_t i = 1; i < buffer_.size(); ++i) {
    const Centroid& next = buffer_[i];
    const double q = std::min((before + open.weight + next.weight) / total, 1.0);
    if (q <= limit) {
      open.weight += next.weight;
      if (next.mean != open.mean) open.mean += (next.mean - open.mean) * next.weight / open.weight;
      continue;
    }
    centroids_.push_back(open);
    before += open.weight;
    limit = limit_after(std::min(before / total, 1.0));
    open = next;
  }
  centroids_.push_back(open);
  buffer_.clear();
}

std::size_t QuantileSketch::centroids() const {
  compress();
  return centroids_.size();
}

double QuantileSketch::quantile(double p) const {
  if (count_ == 0) throw std::invalid_argument("quantile sketch: no observations yet");
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("quantile sketch: p = " + detail::text_of(p) + ", allowed 0 <= p <= 1");
  }
  compress();
  // Each centroid stands for its weight around its mean; linear in between, extremes are known exactly.
  const double rank = p * static_cast<double>(count_);
  double before = 0.0;
  double left_rank = 0.0;
  double left_value = min_;
  for (const Centroid& centroid : centroids_) {
    const double middle = before + 0.5 * centroid.weight;
    if (rank < middle) {
      const double part = middle > left_rank ? (rank - left_rank) / (middle - left_rank) : 0.0;
      return left_value + part * (centroid.mean - left_value);
    }
    left_rank = middle;
    left_value = centroid.mean;
    before += centroid.weight;
  }
  const double total = static_cast<double>(count_);
  const double part = total > left_rank ? (rank - left_rank) / (total - left_rank) : 1.0;
  return left_value + part * (max_ - left_value);
}

}  // namespace verstat::sim
