// The scenario loader: JSON, schema, names, references, budgets; nothing is simulated.
#include "scenarios/load.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  try {
    (void)scenarios::load(scenarios::parse_json(bytes));
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  }
}

std::vector<std::string> seeds() {
  std::vector<std::string> all = json_in("scenarios/gallery", ".json", 4000);
  for (std::string& text : json_in("scenarios/tutorial", ".json", 4000)) all.push_back(std::move(text));
  std::erase_if(all, [](const std::string& text) { return text.find("\"variables\"") != std::string::npos; });
  return all;
}

}  // namespace

Target scenario_target() {
  return {"scenario", Form::json, eat, seeds};
}

}  // namespace verstat::fuzz
