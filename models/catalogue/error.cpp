#include "models/catalogue/error.h"

#include <fmt/format.h>

namespace verstat::models {

void require(bool ok, std::string_view input, const Value& value, std::string_view allowed) {
  if (ok) return;
  throw DomainError(std::string(input), fmt::format("{} = {}, {}", input, value.to_string(), allowed));
}

void reject(std::string_view text) {
  throw DomainError("", std::string(text));
}

}  // namespace verstat::models
