#include "scenarios/json_text.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>

namespace verstat::scenarios {

using nlohmann::json;

json parse_json(std::string_view text) {
  if (text.size() > largest_file_bytes)
    throw InputError("", fmt::format("is larger than {} MiB", largest_file_bytes >> 20U));
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto watch = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > deepest_json)
      throw InputError("", fmt::format("is nested deeper than {} levels", deepest_json));
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key) {
      const auto& key = parsed.get_ref<const std::string&>();
      if (!keys.back().insert(key).second)
        throw InputError("", fmt::format("holds the key \"{}\" twice in one object", key));
    }
    return true;
  };
  try {
    return json::parse(text, watch);
  } catch (const json::parse_error& e) {
    // nlohmann counts bytes; a person counts lines.
    const std::size_t byte = std::min(e.byte == 0 ? 0 : e.byte - 1, text.size());
    const std::string_view head = text.substr(0, byte);
    const auto line = 1 + std::count(head.begin(), head.end(), '\n');
    const std::size_t start = head.rfind('\n') == std::string_view::npos ? 0 : head.rfind('\n') + 1;
    std::string what = e.what();
    if (const auto colon = what.find(": ", what.find("column")); colon != std::string::npos)
      what = what.substr(colon + 2);
    throw InputError("", fmt::format("is not JSON: line {}, column {}: {}", line, byte - start + 1, what));
  } catch (const json::out_of_range& e) {
    throw InputError("", fmt::format("holds a number no computer can: {}", e.what()));
  }
}

std::string read_text_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw InputError("", "is a directory, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError("", "cannot be read: no such file, or no permission");
  std::string text;
  std::vector<char> block(1U << 16U);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_file_bytes)
      throw InputError("", fmt::format("is larger than {} MiB", largest_file_bytes >> 20U));
  }
  return text;
}

json read_json_file(const std::string& path) {
  try {
    return parse_json(read_text_file(path));
  } catch (const InputError& e) {
    throw InputError(e.pointer(), path + " " + e.what());
  }
}

}  // namespace verstat::scenarios
