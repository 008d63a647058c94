#pragma once
#include <nlohmann/json.hpp>

namespace verstat::scenarios {

/// The JSON Schema (draft 7) of a scenario file, made from the descriptions in scenario_fields.cpp: editors
/// complete and check with it, the web forms are built from it. Cross references are the loader's business.
[[nodiscard]] nlohmann::ordered_json scenario_schema();

}  // namespace verstat::scenarios
