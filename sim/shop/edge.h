#pragma once
// An insert in its holder: edges drawn when they come into use, spent while they cut.

#include <cstdint>

#include "models/math/life_law.h"
#include "scenarios/scenario.h"
#include "sim/kernel/random_stream.h"
#include "sim/shop/lots.h"

namespace verstat::shop {

/// The insert a tooth holds at present. Wear and lives are counted in mean lives at whatever regime cuts, so
/// that damage adds up linearly over regimes.
class FittedInsert {
 public:
  /// The streams belong to this tooth on this machine in this replication: two variants of a shop see the
  /// same lives. `lots` may be null: all inserts come from one lot.
  FittedInsert(const scenarios::Insert& insert, LotSource* lots, std::uint64_t seed,
               const std::string& entity, std::uint64_t replication);

  [[nodiscard]] double wear() const { return wear_; }
  [[nodiscard]] double life() const { return life_; }
  void spend(double mean_lives) { wear_ += mean_lives; }
  /// Edges that can still cut or are cutting.
  [[nodiscard]] std::int64_t edges_held() const { return 1 + edges_left_; }

  /// What comes after the edge in place.
  enum class Next {
    edge,    ///< the next edge of the insert
    used_up  ///< nothing: the insert has no usable edge left
  };
  /// Draws whether a failure leaves the other edges usable (a planned change always does). Decides, changes
  /// nothing. `broken` tells whether it was the failure that made the insert useless.
  struct Outlook {
    Next next = Next::used_up;
    bool broken = false;
  };
  [[nodiscard]] Outlook after_this_edge(bool after_failure);

  void turn_to_next_edge();
  /// Fits a new insert. Returns its usable edges.
  std::int64_t fit_new();
  /// The same insert with all its edges again, their lives `life_factor` times those of a new one.
  void regrind(double life_factor);

 private:
  void draw_life();

  double wear_ = 0;
  double life_ = 0;
  std::int64_t edges_left_ = 0;  // besides the one in place
  const scenarios::Insert* insert_;
  LotSource* lots_;
  double lot_factor_ = 1;  // of the mean life
  double regrind_factor_ = 1;
  models::LifeLaw unit_life_;
  sim::RandomStream life_stream_;
  sim::RandomStream reserve_stream_;
  sim::RandomStream single_edge_stream_;
};

}  // namespace verstat::shop
