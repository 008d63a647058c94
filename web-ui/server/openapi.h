#pragma once
#include <string_view>

namespace verstat::web {

/// The OpenAPI 3.0 description of /api/v1, JSON text.
[[nodiscard]] std::string_view openapi_text();

}  // namespace verstat::web
