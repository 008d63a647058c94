#pragma once
// A tool as a thing: a body with teeth, each with an insert. What the teeth do to each other stands here.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/tooling.h"
#include "sim/kernel/pooled.h"
#include "sim/shop/edge.h"

namespace verstat::shop {

/// One copy of a tool. Wear is counted in mean lives of an edge at the load of a tool with all its teeth.
///
/// A tooth fails when its own exposure reaches its life; the exposure grows at the rate (chip over that of
/// the full tool)^load_exponent: z/(z-j) with global sharing after j failures, the pitches to the working
/// tooth ahead with local sharing (K109 C2, C4, C6). With reduced table feed the rate stays 1 and cutting
/// takes z/(z-j) times as long.
class ToolBody : public sim::Pooled {
 public:
  /// `insert` as it is fitted, see scenarios::prepared. The streams of the first tooth are those of `entity`.
  ToolBody(const scenarios::Tool& tool, const scenarios::Insert& insert, LotSource* lots, std::uint64_t seed,
           const std::string& entity, std::uint64_t replication);

  struct Tooth {
    FittedInsert insert;
    bool failed = false;
    double load = 1;       ///< rate of wear over that at nominal load
    bool changed = false;  ///< in the change under way
    FittedInsert::Outlook outlook;
  };
  using Teeth = std::vector<Tooth, sim::PoolAllocator<Tooth>>;
  [[nodiscard]] Teeth& teeth() { return teeth_; }
  [[nodiscard]] const Teeth& teeth() const { return teeth_; }
  [[nodiscard]] std::int64_t failed_teeth() const { return failed_; }

  struct Failure {
    double wear_left = std::numeric_limits<double>::infinity();  ///< mean lives at nominal load
    std::size_t tooth = 0;
  };
  /// The next tooth to fail if nothing changes; ties: the first.
  [[nodiscard]] Failure next_failure() const;
  /// Cuts `mean_lives` at nominal load.
  void spend(double mean_lives);
  /// The tooth cuts no more; the others take its chip.
  void fail(std::size_t tooth);
  /// The tool breaks: none of its edges cuts any more.
  void break_off();

  /// Table feed over that of the full tool.
  [[nodiscard]] double feed_factor() const { return feed_factor_; }
  /// Cutting since all teeth were changed together, mean lives at nominal load.
  [[nodiscard]] double age() const { return age_; }
  /// Cutting since the last planned change.
  [[nodiscard]] double wear_since_plan() const { return wear_since_plan_; }
  /// Largest share of its own life that a working edge has used up.
  [[nodiscard]] double worst_share_of_life() const;
  /// Of a working edge, mean lives.
  [[nodiscard]] double largest_wear() const;
  [[nodiscard]] std::int64_t edges_held() const;

  /// Decides which teeth are changed and what comes after their edges (draws, changes nothing else). Returns
  /// the number of inserts used up.
  std::int64_t decide_change(bool after_failure);
  /// The change is made: teeth with `changed` have new edges.
  void change_made(bool after_failure);

  // What an inspection looks at.
  double cut_since_inspection_min = 0;
  std::int64_t parts_since_inspection = 0;
  std::int64_t regrinds = 0;

 private:
  void share_load();

  Teeth teeth_;
  std::int64_t failed_ = 0;
  double feed_factor_ = 1;
  double age_ = 0;
  double wear_since_plan_ = 0;
  std::optional<scenarios::ReplaceAtFailedTeeth> mill_;
};

}  // namespace verstat::shop
