#pragma once
// Results as JSON: the command line's --json and the server's answers are made here, so that they cannot
// differ.

#include <optional>

#include <nlohmann/json.hpp>

#include "store/records.h"

namespace verstat::store {

/// The number; null when there is none or it is not finite.
[[nodiscard]] nlohmann::ordered_json number_or_null(const std::optional<double>& value);
[[nodiscard]] nlohmann::ordered_json to_json(const RunHeader& header);
/// With `replications` the values of every replication are added, one list per KPI.
[[nodiscard]] nlohmann::ordered_json to_json(const Run& run, bool replications = false);
[[nodiscard]] nlohmann::ordered_json to_json(const StudyHeader& header);
[[nodiscard]] nlohmann::ordered_json to_json(const Study& study);

}  // namespace verstat::store
