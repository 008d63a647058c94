#include "sim/kernel/arrivals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "sim/kernel/engine.h"

namespace verstat::sim {

RateProfile::RateProfile(const std::vector<double>& lengths, const std::vector<double>& rates)
    : rates_(rates) {
  using detail::text_of;
  if (lengths.empty() || lengths.size() != rates.size()) {
    throw std::invalid_argument("rate profile: " + std::to_string(lengths.size()) + " lengths and " +
                                std::to_string(rates.size()) + " rates, must be as many and at least one");
  }
  double end = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::string piece = "rate profile, piece " + std::to_string(i) + ": ";
    if (!(lengths[i] > 0.0) || std::isinf(lengths[i])) {
      throw std::invalid_argument(piece + "length = " + text_of(lengths[i]) + ", allowed finite and > 0");
    }
    if (!(rates[i] >= 0.0) || std::isinf(rates[i])) {
      throw std::invalid_argument(piece + "rate = " + text_of(rates[i]) + ", allowed finite and >= 0");
    }
    end += lengths[i];
    count += lengths[i] * rates[i];
    ends_.push_back(end);
    counts_.push_back(count);
  }
  if (!(count > 0.0)) throw std::invalid_argument("rate profile: all rates are 0, at least one must be > 0");
}

double RateProfile::rate(double time) const {
  const double within = std::fmod(time, period());
  const auto piece = std::upper_bound(ends_.begin(), ends_.end(), within);
  return rates_[static_cast<std::size_t>(std::min(piece, ends_.end() - 1) - ends_.begin())];
}

double RateProfile::expected(double time) const {
  const double periods = std::floor(time / period());
  const double within = std::clamp(time - periods * period(), 0.0, period());
  const auto piece = std::min(std::upper_bound(ends_.begin(), ends_.end(), within), ends_.end() - 1);
  const auto i = static_cast<std::size_t>(piece - ends_.begin());
  return periods * counts_.back() + counts_[i] - rates_[i] * (ends_[i] - within);
}

double RateProfile::time_of(double count) const {
  const double periods = std::floor(count / counts_.back());
  const double within = std::clamp(count - periods * counts_.back(), 0.0, counts_.back());
  // First piece at whose end the count is reached: it has a positive rate, unless within is 0.
  const auto piece = std::min(std::lower_bound(counts_.begin(), counts_.end(), within), counts_.end() - 1);
  const auto i = static_cast<std::size_t>(piece - counts_.begin());
  const double start = i == 0 ? 0.0 : ends_[i - 1];
  const double before = i == 0 ? 0.0 : counts_[i - 1];
  const double into = rates_[i] > 0.0 ? (within - before) / rates_[i] : 0.0;
  return periods * period() + std::min(start + into, ends_[i]);
}

}  // namespace verstat::sim
