#pragma once
// A value as a user writes it: what the command line, the scenario and the web explorer exchange with a model
// function. The formulas themselves never see it; they take plain structs.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace verstat::models {

class Value {
 public:
  using List = std::vector<Value>;
  /// Members keep the order of the description, so that output reads like the card.
  using Map = std::vector<std::pair<std::string, Value>>;

  Value() = default;
  Value(bool b) : data_(b) {}                            // NOLINT(google-explicit-constructor)
  Value(int i) : data_(static_cast<std::int64_t>(i)) {}  // NOLINT(google-explicit-constructor)
  Value(std::int64_t i) : data_(i) {}                    // NOLINT(google-explicit-constructor)
  Value(double d) : data_(d) {}                          // NOLINT(google-explicit-constructor)
  Value(const char* s) : data_(std::string(s)) {}        // NOLINT(google-explicit-constructor)
  Value(std::string s) : data_(std::move(s)) {}          // NOLINT(google-explicit-constructor)
  Value(List l) : data_(std::move(l)) {}                 // NOLINT(google-explicit-constructor)
  Value(Map m) : data_(std::move(m)) {}                  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(data_); }
  [[nodiscard]] const bool* boolean() const { return std::get_if<bool>(&data_); }
  [[nodiscard]] const std::int64_t* integer() const { return std::get_if<std::int64_t>(&data_); }
  [[nodiscard]] const double* real() const { return std::get_if<double>(&data_); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&data_); }
  [[nodiscard]] const List* list() const { return std::get_if<List>(&data_); }
  [[nodiscard]] const Map* map() const { return std::get_if<Map>(&data_); }

  /// Member of a map, or null when this is no map or has no such member.
  [[nodiscard]] const Value* find(const std::string& name) const;
  /// The value as a user would type it in JSON, shortened: for error messages.
  [[nodiscard]] std::string to_string() const;

  friend bool operator==(const Value&, const Value&) = default;

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Map> data_;
};

}  // namespace verstat::models
