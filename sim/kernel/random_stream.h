#pragma once
// RandomStream: reproducible random numbers with a name.

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>

#include "sim/kernel/fast_log.h"

namespace verstat::sim {

/// What sort of numbers a replication draws.
enum class Sampling {
  plain,
  antithetic  ///< 1 - u in place of every u: pairs of runs whose errors tend to cancel
};

/// A stream of uniform random numbers, independent of every stream with another (seed, entity, purpose,
/// replication), the same on every machine. The generator is xoshiro256++ (Blackman, Vigna, ACM Trans. Math.
/// Softw. 47 (2021) 36); its 256 bits of state come from hashing the four parts, so streams do not depend on
/// the order in which they are made, and adding a machine changes nothing for the others.
class RandomStream {
 public:
  /// `entity`: whose randomness ("mill-2"); `purpose`: what for ("life of edges"); any text.
  RandomStream(std::uint64_t seed, std::string_view entity, std::string_view purpose,
               std::uint64_t replication = 0, Sampling sampling = Sampling::plain) noexcept;

  /// A stream that starts in a given state, not all zero: for comparison with other programs.
  static RandomStream from_state(const std::array<std::uint64_t, 4>& state) noexcept {
    RandomStream stream;
    stream.state_ = state;
    stream.next_ = stream.draw();
    return stream;
  }

  /// The next 64 bits (not affected by antithetic sampling).
  std::uint64_t bits() noexcept {
    log_known_ = false;
    return std::exchange(next_, draw());
  }

  /// The number (k + 1/2) / 2^52, where k is the upper 52 of the bits: never 0 or 1, and 1 - u is exact.
  [[nodiscard]] static double to_uniform(std::uint64_t bits) noexcept {
    return std::bit_cast<double>((bits >> 12U) | 0x3ff0000000000000ULL) - (1.0 - 0x1p-53);
  }
  /// Uniform in the open interval (0, 1).
  double uniform() noexcept { return to_uniform(bits() ^ flip_); }
  /// Uniform in (low, high).
  double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }

  /// Exponential with the given mean > 0, by inversion: one uniform each, so that runs with other means stay
  /// paired.
  double exponential(double mean) noexcept {
    if (!log_known_) next_log_ = log_of_next();
    const double result = -mean * next_log_;
    next_ = draw();
    // Computed now, for the next call, while the processor has other things to do: the branches of the event
    // loop wait for what this returns.
    next_log_ = log_of_next();
    log_known_ = true;
    return result;
  }

  /// Whole number from 0 to n - 1 (n >= 1), by inversion of one uniform: bias below n / 2^52.
  std::uint64_t below(std::uint64_t n) noexcept {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
  }

  /// Two streams are equal when everything they will ever give is: two variants of a model are still paired
  /// as long as this holds.
  friend bool operator==(const RandomStream& a, const RandomStream& b) noexcept {
    return a.state_ == b.state_ && a.next_ == b.next_ && a.flip_ == b.flip_;
  }

 private:
  RandomStream() = default;

  std::uint64_t draw() noexcept {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }
  [[nodiscard]] double log_of_next() const noexcept {
    return detail::log_table.log(1.0 - to_uniform(next_ ^ flip_));
  }

  std::array<std::uint64_t, 4> state_{};
  std::uint64_t next_ = 0;  // drawn already, not yet given away
  double next_log_ = 0.0;   // log(1 - u) of it, if known
  bool log_known_ = false;
  std::uint64_t flip_ = 0;  // all ones: antithetic
};

}  // namespace verstat::sim
