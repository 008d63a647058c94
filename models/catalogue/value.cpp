#include "models/catalogue/value.h"

#include <fmt/format.h>

#include "models/catalogue/shortened.h"

namespace verstat::models {

const Value* Value::find(const std::string& name) const {
  const Map* members = map();
  if (members == nullptr) return nullptr;
  for (const auto& [key, value] : *members)
    if (key == name) return &value;
  return nullptr;
}

std::string Value::to_string() const {
  constexpr std::size_t longest = 80;
  std::string out;
  if (const bool* b = boolean()) {
    out = *b ? "true" : "false";
  } else if (const std::int64_t* i = integer()) {
    out = fmt::format("{}", *i);
  } else if (const double* d = real()) {
    out = fmt::format("{}", *d);
  } else if (const std::string* s = text()) {
    out = fmt::format("\"{}\"", *s);
  } else if (const List* l = list()) {
    out = "[";
    for (std::size_t k = 0; k < l->size() && out.size() < longest; ++k)
      out += (k == 0 ? "" : ", ") + (*l)[k].to_string();
    out += "]";
  } else if (const Map* m = map()) {
    out = "{";
    for (std::size_t k = 0; k < m->size() && out.size() < longest; ++k)
      out += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", (*m)[k].first, (*m)[k].second.to_string());
    out += "}";
  } else {
    out = "null";
  }
  if (out.size() > longest + 3) out.replace(shortened(out, longest).size(), std::string::npos, "...");
  return out;
}

}  // namespace verstat::models
