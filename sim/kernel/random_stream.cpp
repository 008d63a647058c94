#include "sim/kernel/random_stream.h"

#include <cstddef>

namespace verstat::sim {
namespace {

// Bijective mixing of 64 bits: the finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014), variant 13 of
// Stafford.
constexpr std::uint64_t mix(std::uint64_t x) noexcept {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

/// Absorbs numbers and texts into two lanes of 64 bits, each fed with different constants.
class Hash {
 public:
  void absorb(std::uint64_t word) noexcept {
    low_ = mix(low_ + 0x9e3779b97f4a7c15ULL + word);
    high_ = mix((high_ ^ word) * 0xd1342543de82ef95ULL + 0x2545f4914f6cdd1dULL);
  }
  // The length goes first: ("ab", "c") and ("a", "bc") are different names.
  void absorb(std::string_view text) noexcept {
    absorb(static_cast<std::uint64_t>(text.size()));
    for (std::size_t i = 0; i < text.size(); i += 8) {
      std::uint64_t word = 0;
      for (std::size_t k = i; k < text.size() && k < i + 8; ++k) {
        word |= static_cast<std::uint64_t>(static_cast<unsigned char>(text[k])) << (8 * (k - i));
      }
      absorb(word);
    }
  }
  [[nodiscard]] std::uint64_t low() const noexcept { return low_; }
  [[nodiscard]] std::uint64_t high() const noexcept { return high_; }

 private:
  // Digits of pi and e: nothing up the sleeve.
  std::uint64_t low_ = 0x243f6a8885a308d3ULL;
  std::uint64_t high_ = 0xb7e151628aed2a6aULL;
};

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view entity, std::string_view purpose,
                           std::uint64_t replication, Sampling sampling) noexcept
    : flip_(sampling == Sampling::antithetic ? ~std::uint64_t{0} : 0) {
  Hash hash;
  hash.absorb(seed);
  hash.absorb(entity);
  hash.absorb(purpose);
  hash.absorb(replication);
  // Each lane fills two words, as SplitMix64 would; the pairs (0, 1) and (2, 3) determine the lanes, so that
  // different hashes give different states. All zero, the one forbidden state, cannot occur in word 0 and 1
  // together because mix() is bijective.
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15ULL;
  state_[0] = mix(hash.low() + step);
  state_[1] = mix(hash.low() + 2 * step);
  state_[2] = mix(hash.high() + step);
  state_[3] = mix(hash.high() + 2 * step);
  next_ = draw();
}

}  // namespace verstat::sim
