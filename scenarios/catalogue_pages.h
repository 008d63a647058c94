#pragma once
// The catalogue as files: what stands in docs/catalogue/, and how it is counted.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "models/catalogue/pages.h"

namespace verstat::scenarios {

/// One entry per source of the catalogue: its reference points, counted in the files <ID>.json of `points`
/// (0 where there is none), and the operation kinds that use it.
/// Throws InputError for a file that is not a JSON list.
[[nodiscard]] std::vector<models::SourceUse> source_uses(const std::filesystem::path& points);

/// Name and text of every page, the index README.md first.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> catalogue_pages(
    const std::filesystem::path& points);

}  // namespace verstat::scenarios
