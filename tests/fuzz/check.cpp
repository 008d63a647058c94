#include "tests/fuzz/check.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "scenarios/json_text.h"

namespace verstat::fuzz {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

void check_words(std::string_view text) {
  if (text.empty() || text.size() > 5000) finding(fmt::format("an error of {} characters", text.size()));
}

std::vector<std::string> files_in(const std::string& folder, std::string_view ending) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().ends_with(ending)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(scenarios::read_text_file(path.string()));
  return texts;
}

namespace {

void strip(ordered_json& at) {
  if (at.is_object())
    for (const char* unread : {"$schema", "description", "provenance"}) at.erase(unread);
  if (at.is_structured())
    for (ordered_json& child : at) strip(child);
}

}  // namespace

std::vector<std::string> json_in(const std::string& folder, std::string_view ending, std::size_t most_bytes) {
  std::vector<std::string> texts;
  for (const std::string& text : files_in(folder, ending)) {
    ordered_json j = ordered_json::parse(text);
    strip(j);
    if (std::string dense = j.dump(); dense.size() <= most_bytes) texts.push_back(std::move(dense));
  }
  return texts;
}

const std::string& own_folder() {
  struct Folder {
    Folder() {
      const fs::path memory = "/dev/shm";
      std::string pattern =
          ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "verstat-fuzz-XXXXXX").string();
      if (::mkdtemp(pattern.data()) == nullptr) finding("no folder of its own can be made: " + pattern);
      path = pattern;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    std::string path;
  };
  static const Folder folder;
  return folder.path;
}

std::string write_own(const std::string& name, std::string_view text) {
  const std::string path = own_folder() + "/" + name;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const bool whole =
      file >= 0 && ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (file >= 0) ::close(file);
  if (!whole) finding("cannot write " + path);
  return path;
}

}  // namespace verstat::fuzz
