#include "scenarios/check.h"

#include <map>

#include <fmt/format.h>

#include "models/catalogue/closest.h"
#include "models/catalogue/shortened.h"
#include "operations/fields.h"

namespace verstat::scenarios {

void fail(const std::string& pointer, const std::string& value, const std::string& allowed) {
  throw InputError(pointer, fmt::format("{} = {}, {}", pointer, value, allowed));
}

std::string quoted(const std::string& text) {
  return fmt::format("\"{}\"", models::shortened(text, 100));
}

void check_names(const std::vector<std::string>& names, const std::string& list) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string pointer = fmt::format("{}/{}/name", list, k);
    if (names[k].empty() || names[k].size() > 100)
      fail(pointer, quoted(names[k]), "must have 1 to 100 characters");
    const auto [first, fresh] = seen.emplace(names[k], k);
    if (!fresh)
      fail(pointer, quoted(names[k]), fmt::format("is already the name of {}/{}", list, first->second));
  }
}

void check_reference(const std::vector<std::string>& names, const std::string& name,
                     const std::string& pointer, const std::string& what) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  fail(pointer, quoted(name),
       names.empty()
           ? fmt::format("there is no {} at all", what)
           : fmt::format("there is no such {}; closest: \"{}\"", what, models::closest(name, names)));
}

void check_law(const Duration& duration, const std::string& pointer) {
  try {
    operations::check_duration(duration, pointer);
  } catch (const models::DomainError& e) {
    throw InputError(e.input(), e.what());
  }
}

void check_takes_time(const Duration& duration, const std::string& pointer) {
  check_law(duration, pointer);
  if (mean_min(duration) < 1e-6)
    fail(pointer, fmt::format("mean {} min", mean_min(duration)), "must have a mean of at least 1e-6 min");
}

}  // namespace verstat::scenarios
