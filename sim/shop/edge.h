#pragma once
// An insert in its holder: edges drawn when they come into use, spent while they cut.

#include <cstdint>

#include "models/math/life_law.h"
#include "scenarios/scenario.h"
#include "sim/kernel/random_stream.h"

namespace verstat::shop {

/// The insert a tool holds at present. Wear and lives are counted in mean lives at whatever regime cuts, so
/// that damage adds up linearly over regimes.
class FittedInsert {
 public:
  /// The streams belong to this tool on this machine in this replication: two variants of a shop see the same
  /// lives.
  FittedInsert(const scenarios::Insert& insert, std::uint64_t seed, const std::string& entity,
               std::uint64_t replication);

  [[nodiscard]] double wear() const { return wear_; }
  [[nodiscard]] double life() const { return life_; }
  void spend(double mean_lives) { wear_ += mean_lives; }

  /// Turns to the next edge (planned: always usable; after a failure: with the scenario's probability).
  /// False when a new insert is needed.
  [[nodiscard]] bool turn_to_next_edge(bool after_failure);
  /// Fits a new insert.
  void fit_new();

 private:
  void draw_life();

  const scenarios::Insert* insert_;
  models::LifeLaw unit_life_;
  sim::RandomStream life_stream_;
  sim::RandomStream reserve_stream_;
  sim::RandomStream single_edge_stream_;
  std::int64_t edges_left_ = 0;  // besides the one in place
  double wear_ = 0;
  double life_ = 0;
};

}  // namespace verstat::shop
