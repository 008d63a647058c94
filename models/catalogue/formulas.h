#pragma once
// What the header of a model function says of it: its formula, its place in the source, its errors.

#include <string_view>

namespace verstat::models {

/// The comment before the declaration of the function with this key ("K307.gauge_outer_span"), in one line;
/// empty when there is no such function.
[[nodiscard]] std::string_view formula_of(std::string_view key);

}  // namespace verstat::models
