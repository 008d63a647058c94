#pragma once
// Between JSON, which users write, and Value, which model functions understand.

#include <string>

#include <nlohmann/json.hpp>

#include "models/catalogue/catalogue.h"

namespace verstat::scenarios {

/// Integers stay integers, everything else as in JSON. Unsigned integers above 2^63 become doubles.
[[nodiscard]] models::Value to_value(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json to_json(const models::Value& value);

/// Evaluates a list of points `[{"id", "function", "inputs"}...]` into `[{"id", "outputs"} | {"id",
/// "error"}...]`. `source` is put before function names without a dot ("K117" + "part_cost"). A bad point
/// gives an error entry; it never stops the batch. Throws std::invalid_argument when `points` is no list of
/// objects.
[[nodiscard]] nlohmann::ordered_json evaluate_batch(const nlohmann::json& points, const std::string& source);

}  // namespace verstat::scenarios
