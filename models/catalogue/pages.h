#pragma once
// The catalogue as pages to read, made from the descriptions alone: one Markdown page per source, and an
// index.

#include <string>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models {

/// What stands outside the descriptions: how often a source is tested, and who uses it.
struct SourceUse {
  std::size_t reference_points = 0;
  std::vector<std::string> kinds;  ///< operation kinds, or parts of machines, that use it
};

/// "K117.md"
[[nodiscard]] std::string page_name(const Source& source);
/// What it models, what the paper says and what is a completion, errors found in print, and every function
/// with its inputs, ranges, defaults and outputs.
[[nodiscard]] std::string source_page(const Source& source, const SourceUse& use);
/// All sources by role, in the order of the catalogue; `uses` has one entry per source.
[[nodiscard]] std::string index_page(const Catalogue& catalogue, const std::vector<SourceUse>& uses);
/// "59 sources, 512 functions, 4831 reference points".
[[nodiscard]] std::string count_line(const Catalogue& catalogue, const std::vector<SourceUse>& uses);

}  // namespace verstat::models
