#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace verstat::models {

/// Edit distance (Levenshtein) between two names.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);
/// The candidate with the smallest edit distance to `name` (the first of equals); empty when there is none.
[[nodiscard]] std::string closest(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace verstat::models
