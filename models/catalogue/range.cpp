#include "models/catalogue/range.h"

#include <cmath>

#include <fmt/format.h>

namespace verstat::models {

std::string Range::text(std::string_view name) const {
  const bool has_low = std::isfinite(low);
  const bool has_high = std::isfinite(high);
  if (has_low && has_high)
    return fmt::format("{} {} {} {} {}", low, low_open ? "<" : "<=", name, high_open ? "<" : "<=", high);
  if (has_low) return fmt::format("{} {} {}", name, low_open ? ">" : ">=", low);
  if (has_high) return fmt::format("{} {} {}", name, high_open ? "<" : "<=", high);
  return fmt::format("{} finite", name);
}

}  // namespace verstat::models
