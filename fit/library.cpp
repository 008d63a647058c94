#include "fit/library.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "models/catalogue/shortened.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using scenarios::Change;
using scenarios::InputError;

// Kinds whose members replace members; the others replace a value whole.
constexpr std::array by_members = {"insert", "failure"};
constexpr std::array as_whole = {"duration", "supply"};

template <std::size_t N>
bool holds(const std::array<const char*, N>& kinds, const std::string& kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

// A name of any alphabet as part of a file name.
std::string file_name(const LibraryEntry& entry) {
  std::string name;
  for (const char c : models::shortened(entry.name, 100)) {
    const bool harmless = static_cast<unsigned char>(c) > 0x20 && c != 0x7f &&
                          std::string_view("/\\:*?\"<>|'").find(c) == std::string_view::npos;
    name += harmless ? c : '_';
  }
  return entry.kind + "-" + (name.empty() ? "all" : name) + ".json";
}

}  // namespace

ordered_json library_json(const LibraryEntry& entry) {
  return {{"kind", entry.kind},
          {"name", entry.name},
          {"entry", entry.entry},
          {"provenance", origin_json(entry.origin)}};
}

std::vector<std::string> write_library(const std::string& folder, const std::vector<LibraryEntry>& entries) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why) {
    throw InputError("", fmt::format("--library {}: {}", folder, why));
  };
  if (entries.empty())
    refuse("there is no entry to write: the warnings and lines of the answer say what is missing");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) refuse("is no folder and none can be made there");
  std::vector<std::string> files;
  for (const LibraryEntry& entry : entries) {
    const fs::path path = fs::path(folder) / file_name(entry);
    if (std::find(files.begin(), files.end(), path.string()) != files.end())
      refuse(fmt::format("two entries would be {}", path.filename().string()));
    files.push_back(path.string());
  }
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::string beside = files[k] + ".part";
    {
      std::ofstream file(beside, std::ios::binary);
      file << library_json(entries[k]).dump(2) << "\n";
      file.close();
      if (!file) {
        fs::remove(beside, error);
        refuse("cannot be written");
      }
    }
    fs::rename(beside, files[k], error);
    if (error) refuse("cannot be written: " + error.message());
  }
  return files;
}

std::vector<Change> changes_of_use(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || text[0] != '/' || sign + 1 == text.size())
    throw InputError(
        "", fmt::format("--use {}: must be POINTER=FILE, for instance /inserts/0=library/insert-T5K10.json",
                        text));
  const std::string pointer = text.substr(0, sign);
  const std::string file = text.substr(sign + 1);
  const auto refuse = [&](const std::string& why) {
    throw InputError("", fmt::format("--use {}: {}", text, why));
  };
  json j;
  try {
    j = scenarios::parse_json(scenarios::read_text_file(file));
  } catch (const InputError& e) {
    refuse(e.what());
  }
  if (!j.is_object() || !j.contains("entry") || !j["entry"].is_object() || !j.contains("kind") ||
      !j["kind"].is_string())
    refuse("holds no library entry ({\"kind\": ..., \"name\": ..., \"entry\": {...}})");
  const std::string kind = j["kind"];
  const json& entry = j["entry"];
  if (holds(as_whole, kind)) return {{pointer, entry}};
  if (!holds(by_members, kind))
    refuse(
        fmt::format("kind \"{}\": must be insert, failure, duration or supply", models::shortened(kind, 60)));
  std::vector<Change> changes;
  for (const auto& [member, value] : entry.items()) {
    if (member == "name") continue;
    const std::string place = pointer + "/" + member;
    // An edge life keeps what the fit does not speak of, such as an exponent; a law is replaced whole.
    if (value.is_object() && !value.contains("kind"))
      for (const auto& [inner, number] : value.items()) changes.push_back({place + "/" + inner, number});
    else
      changes.push_back({place, value});
  }
  return changes;
}

}  // namespace verstat::fit
