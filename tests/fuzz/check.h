#pragma once
// What the doors have in common: how a finding ends the program, where honest inputs come from.

#include <string>
#include <string_view>
#include <vector>

namespace verstat::fuzz {

/// Says what was found and aborts.
[[noreturn]] void finding(const std::string& what);
/// An error is for a person: not empty, not a novel. (Names it repeats are made harmless where it is
/// printed.)
void check_words(std::string_view text);

/// The texts of the files of `folder` whose names end so, in the order of their names.
[[nodiscard]] std::vector<std::string> files_in(const std::string& folder, std::string_view ending);
/// The same as JSON without blanks and without what no program reads ("description", "provenance"), those of
/// at most `most_bytes`.
[[nodiscard]] std::vector<std::string> json_in(const std::string& folder, std::string_view ending,
                                               std::size_t most_bytes);

/// A folder in memory for this process alone, made at the first call and removed when the process ends.
[[nodiscard]] const std::string& own_folder();
/// Writes a file into own_folder() and returns its path.
std::string write_own(const std::string& name, std::string_view text);

}  // namespace verstat::fuzz
