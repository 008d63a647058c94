#pragma once
// Lots of inserts that differ from each other, certified by a sample of each (K119).

#include <cstdint>

#include "scenarios/tooling.h"
#include "sim/kernel/random_stream.h"

namespace verstat::shop {

/// Lots as they are opened in the tool crib, one after the other, for all tools that hold the insert.
///
/// The logarithm of a lot's mean life is s z with z normal and s = ln_sd_between, shifted so that the mean
/// over all lots is that of the insert. The sample shows x, normal, with correlation
/// rho = test_correlation * K119.lot_mean_correlation; a lot with x below the reject_fraction quantile is
/// sent back or treated.
class LotSource {
 public:
  LotSource(const scenarios::CertifiedLots& spec, std::uint64_t seed, const std::string& insert,
            std::uint64_t replication);

  /// Mean life of the next insert over that of the insert's description.
  [[nodiscard]] double next_life_factor();

  /// Since the last reset.
  struct Counts {
    std::uint64_t tested = 0;
    std::uint64_t rejected = 0;
    double cost = 0;  ///< tests and treatment, money
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }
  void reset_counts() { counts_ = Counts(); }

 private:
  void open_lot();

  const scenarios::CertifiedLots* spec_;
  sim::RandomStream lot_stream_;
  sim::RandomStream sample_stream_;
  double correlation_;
  double threshold_;  // of the sample's normal score
  double life_factor_ = 1;
  std::int64_t left_ = 0;
  Counts counts_;
};

}  // namespace verstat::shop
