#pragma once
// Files that commands write.

#include <string>

namespace verstat::app {

/// Writes a whole file or nothing: beside the target first, then renamed. `flag` is the option that names it
/// ("--out"). Throws UsageError.
void write_file(const std::string& flag, const std::string& file, const std::string& text);

}  // namespace verstat::app
