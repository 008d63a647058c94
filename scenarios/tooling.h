#pragma once
// Inserts, the tools that hold them, and the strategies by which edges are changed. Descriptions of the
// members: tooling_fields.cpp; checks that need the whole scenario: check_tooling.cpp.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "operations/edge_life.h"
#include "operations/kind.h"

namespace verstat::scenarios {

using operations::Duration;
using operations::EdgeLife;
using operations::ExponentialDuration;
using operations::mean_min;

struct Insert {
  std::string name;
  std::string grade;
  std::int64_t edges = 2;
  double price = 0;
  EdgeLife edge_life;
  double reserve_ok_probability = 1;   ///< a failed edge leaves the next one usable
  double single_edge_probability = 0;  ///< a fitted insert has only one usable edge
  std::string provenance;              ///< where the numbers come from
};

struct RunToFailure {
  static constexpr const char* kind = "run_to_failure";
};
/// Change an edge at its gamma-percent life or at failure.
struct AgeReplacement {
  static constexpr const char* kind = "age";
  double gamma = 0.64;
};
/// Change after the whole parts that fit into the gamma-percent life, or at failure.
struct PartCountReplacement {
  static constexpr const char* kind = "part_count";
  double gamma = 0.64;
};
/// Change every gamma-percent life of cutting, whatever the age of the edge; failures in between.
struct BlockReplacement {
  static constexpr const char* kind = "block";
  double gamma = 0.64;
};
using Strategy = std::variant<RunToFailure, AgeReplacement, PartCountReplacement, BlockReplacement>;
/// Reliability level of a strategy; none for run to failure.
[[nodiscard]] std::optional<double> gamma_of(const Strategy& strategy);

/// When the price of an insert is booked.
enum class InsertBooking {
  life_periods,  ///< price / periods at every change (K117): planned and failure changes waste different
                 ///< shares
  at_fitting     ///< the whole price when an insert is fitted
};

struct ToolChange {
  Duration index = ExponentialDuration{0.3};    ///< turn the insert to its next edge
  Duration replace = ExponentialDuration{0.3};  ///< fit a new insert
  double positioning_min = 0;                   ///< on top of both: approach, trial cut, measuring
  double failure_extra_min = 0;                 ///< on top of both after a failure
};

struct Tool {
  std::string name;
  std::string insert;
  Strategy strategy = AgeReplacement{};
  std::string crew;  ///< who changes edges
  ToolChange change;
  InsertBooking insert_booking = InsertBooking::life_periods;
  double periods_planned = 4;
  double periods_failure = 2;
  double regrind_planned = 0;
  double regrind_failure = 0;
  double failure_damage = 0;  ///< holder, shim, rework: money per failure
  double failure_scrap_probability = 0;
};

}  // namespace verstat::scenarios
