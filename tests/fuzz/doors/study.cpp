// The study loader.
#include "optimize/study_spec.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  try {
    const optimize::StudySpec study = optimize::load_study(scenarios::parse_json(bytes));
    (void)optimize::fixed_changes(study);
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  }
}

std::vector<std::string> seeds() {
  std::vector<std::string> all = json_in("scenarios/gallery", ".study.json", 4000);
  for (std::string& text : json_in("scenarios/tutorial", ".study.json", 4000)) all.push_back(std::move(text));
  return all;
}

}  // namespace

Target study_target() {
  return {"study", Form::json, eat, seeds};
}

}  // namespace verstat::fuzz
