#include "models/catalogue/field.h"

#include <algorithm>

#include <fmt/format.h>

#include "models/catalogue/closest.h"

namespace verstat::models {

std::string Field::allowed() const {
  return fmt::format("{} ({})", range.text(name), meaning);
}

void read_fields(void* object, const std::vector<Field>& fields, const Value& value, std::string_view place) {
  const std::string prefix = place.empty() ? "" : std::string(place) + "/";
  const Value::Map* members = value.map();
  if (members == nullptr)
    throw DomainError(std::string(place), fmt::format("{} = {}, must be an object with named values",
                                                      place.empty() ? "inputs" : place, value.to_string()));
  for (const auto& [key, given] : *members) {
    const bool known =
        std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return f.name == key; });
    if (known) continue;
    std::vector<std::string> names;
    for (const Field& f : fields) names.push_back(f.name);
    throw DomainError(prefix + key, fmt::format("{}{} = {}, there is no such input; closest: \"{}\"", prefix,
                                                key, given.to_string(), closest(key, names)));
  }
  for (const Field& field : fields) {
    const Value* given = value.find(field.name);
    if (given == nullptr) {
      if (!field.required) continue;
      throw DomainError(prefix + field.name,
                        fmt::format("{}{} is missing, allowed {}", prefix, field.name, field.allowed()));
    }
    if (place.empty()) {
      field.access->read(object, *given, field);
    } else {
      Field placed = field;
      placed.name = prefix + field.name;
      placed.access->read(object, *given, placed);
    }
  }
}

Value write_fields(const void* object, const std::vector<Field>& fields) {
  Value::Map members;
  members.reserve(fields.size());
  for (const Field& field : fields) members.emplace_back(field.name, field.access->write(object));
  return members;
}

namespace detail {

void wrong_type(const Field& field, const Value& value, std::string_view expected) {
  throw DomainError(field.name, fmt::format("{} = {}, must be {} ({})", field.name, value.to_string(),
                                            expected, field.meaning));
}

void out_of_range(const Field& field, const Value& value) {
  throw DomainError(field.name,
                    fmt::format("{} = {}, allowed {}", field.name, value.to_string(), field.allowed()));
}

void check_length(const Field& field, std::size_t length) {
  if (length >= field.min_length && length <= field.max_length) return;
  throw DomainError(field.name, fmt::format("{} has {} entries, allowed {} to {} ({})", field.name, length,
                                            field.min_length, field.max_length, field.meaning));
}

double read_number(const Field& field, const Value& value) {
  if (const double* d = value.real()) return *d;
  if (const std::int64_t* i = value.integer()) return static_cast<double>(*i);
  wrong_type(field, value, "a number");
}

std::int64_t read_integer(const Field& field, const Value& value, std::int64_t low, std::int64_t high) {
  std::int64_t x = 0;
  if (const std::int64_t* i = value.integer()) {
    x = *i;
  } else if (const double* d = value.real(); d != nullptr && std::abs(*d) < 9e15 && *d == std::floor(*d)) {
    x = static_cast<std::int64_t>(*d);
  } else {
    wrong_type(field, value, "a whole number");
  }
  if (x < low || x > high) out_of_range(field, value);
  return x;
}

Field element_of(const Field& field, std::size_t index) {
  Field element = field;
  element.name = fmt::format("{}/{}", field.name, index);
  element.min_length = 0;
  element.max_length = 100'000;
  return element;
}

}  // namespace detail
}  // namespace verstat::models
