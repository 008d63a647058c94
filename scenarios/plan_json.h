#pragma once
// An operation by itself: read from a file, planned, and written as JSON for the command line and the pages.

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "operations/kind.h"
#include "operations/spindle.h"

namespace verstat::scenarios {

/// {"process": {"kind": ...}, "edge_life": {...}, "machine_limits": {...}, "spindle": {...}}; the last three
/// are optional.
struct OperationFile {
  std::string description;
  operations::Process process;
  std::optional<operations::EdgeLife> edge_life;
  operations::MachineLimits machine_limits;
  std::optional<operations::Spindle> spindle;

  /// Throws models::ModelError or models::DomainError when the process models refuse the specification.
  [[nodiscard]] operations::CutPlan plan() const;
};
/// Throws InputError naming the JSON pointer.
[[nodiscard]] OperationFile load_operation(const nlohmann::json& file);

/// The plan; with `explain` every number says where it comes from.
[[nodiscard]] nlohmann::ordered_json to_json(const operations::CutPlan& plan, bool explain);

}  // namespace verstat::scenarios
