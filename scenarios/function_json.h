#pragma once
// Model functions described as JSON: what `verstat models --json` prints, the server answers and forms are
// made of.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "models/catalogue/catalogue.h"

namespace verstat::scenarios {

/// Key, summary and provenance; with `whole` also source, inputs, outputs, notes and the evaluated example.
[[nodiscard]] nlohmann::ordered_json function_json(const models::Source& source, const models::Function& f,
                                                   bool whole);
/// The source that describes `function`, which must be of the catalogue.
[[nodiscard]] const models::Source& source_of(const models::Function& function);
/// True when every word stands somewhere in the function's description, whatever the case.
[[nodiscard]] bool function_matches(const models::Source& source, const models::Function& f,
                                    const std::vector<std::string>& words);
/// The words of a text, split at white space.
[[nodiscard]] std::vector<std::string> words_of(const std::string& text);

}  // namespace verstat::scenarios
