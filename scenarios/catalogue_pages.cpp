#include "scenarios/catalogue_pages.h"

#include <algorithm>

#include "operations/kind.h"
#include "operations/spindle.h"
#include "scenarios/json_text.h"

namespace verstat::scenarios {

std::vector<models::SourceUse> source_uses(const std::filesystem::path& points) {
  std::vector<models::SourceUse> uses;
  for (const models::Source& source : models::catalogue().sources()) {
    models::SourceUse use;
    const std::string& id = source.info().id;
    const auto file = points / (id + ".json");
    if (std::filesystem::exists(file)) {
      const auto list = read_json_file(file.string());
      if (!list.is_array()) throw InputError("", file.string() + " must be a list of reference points");
      use.reference_points = list.size();
    }
    for (const auto& kind : operations::kinds().all())
      if (std::find(kind->sources.begin(), kind->sources.end(), id) != kind->sources.end())
        use.kinds.push_back(kind->name);
    const auto lists = [&](const auto& sources) {
      return std::find(sources.begin(), sources.end(), id) != sources.end();
    };
    if (lists(operations::spindle_sources)) use.kinds.emplace_back("spindle of a machine");
    if (lists(operations::safety_clutch_sources)) use.kinds.emplace_back("safety clutch of a machine");
    if (id == "K409") use.kinds.emplace_back("wages of a crew");
    if (id == "K205") use.kinds.emplace_back("criteria of a shop");
    uses.push_back(std::move(use));
  }
  return uses;
}

std::vector<std::pair<std::string, std::string>> catalogue_pages(const std::filesystem::path& points) {
  const auto& catalogue = models::catalogue();
  const auto uses = source_uses(points);
  std::vector<std::pair<std::string, std::string>> pages{{"README.md", models::index_page(catalogue, uses)}};
  std::size_t k = 0;
  for (const models::Source& source : catalogue.sources())
    pages.emplace_back(models::page_name(source), models::source_page(source, uses[k++]));
  return pages;
}

}  // namespace verstat::scenarios
