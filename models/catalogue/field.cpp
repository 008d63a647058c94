#include "models/catalogue/field.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "models/catalogue/closest.h"

namespace verstat::models {

std::string Field::allowed() const {
  return fmt::format("{} ({})", range.text(name), meaning);
}

std::string TypeInfo::text() const {
  const auto quoted = [](const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "\"" : ", \"") + name + "\"";
    return all;
  };
  std::string out;
  switch (kind) {
    case Kind::number:
      out = "number";
      break;
    case Kind::integer:
      out = "integer";
      break;
    case Kind::flag:
      out = "flag";
      break;
    case Kind::text:
      out = "text";
      break;
    case Kind::choice:
      out = "one of " + quoted(choices);
      break;
    case Kind::list:
      out = "list of " + element.front().text();
      break;
    case Kind::structure: {
      std::vector<std::string> names;
      for (const Field& field : *fields) names.push_back(field.name);
      out = "structure " + quoted(names);
      break;
    }
    case Kind::alternatives: {
      std::vector<std::string> names;
      for (const auto& [name, members] : alternatives) names.push_back(name);
      out = "structure of kind " + quoted(names);
      break;
    }
  }
  return nullable ? out + " or null" : out;
}

void read_fields(void* object, const std::vector<Field>& fields, const Value& value) {
  const Value::Map* members = value.map();
  if (members == nullptr)
    throw DomainError("", fmt::format(" = {}, must be an object with named values", value.to_string()));
  for (const auto& [key, given] : *members) {
    const bool known =
        std::any_of(fields.begin(), fields.end(), [&name = key](const Field& f) { return f.name == name; });
    if (known) continue;
    std::vector<std::string> names;
    for (const Field& f : fields) names.push_back(f.name);
    throw DomainError(key, fmt::format("{} = {}, there is no such input; closest: \"{}\"", key,
                                       given.to_string(), closest(key, names)));
  }
  for (const Field& field : fields) {
    if (const Value* given = value.find(field.name)) {
      field.access->read(object, *given, field);
    } else if (field.required) {
      throw DomainError(field.name, fmt::format("{} is missing, allowed {}", field.name, field.allowed()));
    }
  }
}

void check_fields(const void* object, const std::vector<Field>& fields) {
  for (const Field& field : fields) field.access->check(object, field);
}

double* locate_in_fields(void* object, const std::vector<Field>& fields, std::span<const std::string> path) {
  if (path.empty()) return nullptr;
  for (const Field& field : fields)
    if (field.name == path.front()) return field.access->locate(object, path.subspan(1));
  return nullptr;
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

std::size_t list_index(const std::string& token, std::size_t size) {
  std::size_t index = size;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, index);
  return error == std::errc() && stop == end && index < size ? index : size;
}

Value without_kind(const Value& value) {
  Value::Map rest;
  for (const auto& [key, member] : *value.map())
    if (key != "kind") rest.emplace_back(key, member);
  return rest;
}

Field make_field(std::shared_ptr<const Access> access, const void* defaults, std::string_view name,
                 std::string_view symbol, std::string_view unit, const Range& range,
                 std::string_view meaning) {
  Field f;
  f.name = name;
  f.symbol = symbol;
  f.unit = unit;
  f.range = range;
  f.meaning = meaning;
  f.required = defaults == nullptr;
  f.access = std::move(access);
  if (defaults != nullptr) {
    f.default_value = f.access->write(defaults);
    f.example = f.default_value;
  }
  return f;
}

void rethrow_within(const Field& field, const DomainError& e) {
  // Messages open with the name of the member, so the path goes in front of both.
  if (e.input().empty()) throw DomainError(field.name, field.name + e.what());
  throw DomainError(field.name + "/" + e.input(), field.name + "/" + e.what());
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
