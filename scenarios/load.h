#pragma once
// From JSON to a checked scenario, and what-if changes on the way.

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"
#include "scenarios/scenario.h"

namespace verstat::scenarios {

/// One what-if change: a JSON pointer into the scenario and its new value.
struct Change {
  std::string pointer;
  nlohmann::json value;
};
/// Reads "POINTER=VALUE"; VALUE is JSON, or a plain text when it is not. Throws InputError naming --set.
[[nodiscard]] Change parse_change(std::string_view text);
/// The scenario with the changes made, in order. An object member may be added (the loader knows which
/// exist); an array entry must exist. Throws InputError naming the pointer and how far it leads.
[[nodiscard]] nlohmann::json apply(nlohmann::json scenario, const std::vector<Change>& changes);

/// Checks everything that can be checked before a run: shapes, types, ranges, names, references, orders.
/// Throws InputError: "/machines/0/count = 0, allowed count >= 1 (number of identical machines)".
[[nodiscard]] Scenario load(const nlohmann::json& scenario);

}  // namespace verstat::scenarios
