// docs/catalogue/ is what the program writes, and the counts are counts.
#include "scenarios/catalogue_pages.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"

using namespace verstat;

namespace {

const std::string points = VERSTAT_SOURCE_DIR "/tests/catalogue";
const std::string docs = VERSTAT_SOURCE_DIR "/docs/catalogue";

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("docs/catalogue is up to date: run verstat models doc") {
  const auto pages = scenarios::catalogue_pages(points);
  CHECK(pages.size() == models::catalogue().sources().size() + 1);
  for (const auto& [name, text] : pages) {
    INFO(name);
    CHECK((text_of(std::filesystem::path(docs) / name) == text));
  }
  // And nothing else lies there.
  for (const auto& entry : std::filesystem::directory_iterator(docs)) {
    INFO(entry.path().string());
    CHECK(std::any_of(pages.begin(), pages.end(),
                      [&](const auto& page) { return page.first == entry.path().filename().string(); }));
  }
}

TEST_CASE("the catalogue is counted, not typed") {
  std::size_t listed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(points))
    listed += nlohmann::json::parse(text_of(entry.path())).size();
  std::size_t counted = 0;
  const auto uses = scenarios::source_uses(points);
  for (const auto& use : uses) {
    counted += use.reference_points;
    CHECK(use.reference_points > 0);
  }
  CHECK(counted == listed);
  CHECK(uses.size() == 59);
  CHECK(models::count_line(models::catalogue(), uses) ==
        "59 sources, " + std::to_string(models::catalogue().function_count()) + " functions, " +
            std::to_string(listed) + " reference points");
}

TEST_CASE("a page names every function, input and erratum of its source") {
  for (const models::Source& source : models::catalogue().sources()) {
    const std::string page = models::source_page(source, {});
    INFO(source.info().id);
    for (const auto& f : source.functions()) {
      CHECK(page.find("### " + f.name + "\n") != std::string::npos);
      for (const auto& input : f.inputs) CHECK(page.find("| `" + input.name + "` |") != std::string::npos);
    }
    for (const auto& erratum : source.info().errata) CHECK(page.find(erratum) != std::string::npos);
    // Tables keep their columns: no bar of a text ends a cell.
    std::istringstream lines(page);
    std::string line;
    while (std::getline(lines, line)) {
      if (line.rfind("| `", 0) != 0) continue;
      std::size_t bars = 0;
      for (std::size_t k = 0; k < line.size(); ++k) bars += line[k] == '|' && (k == 0 || line[k - 1] != '\\');
      INFO(line);
      CHECK((bars == 7 || bars == 5));
    }
  }
}
