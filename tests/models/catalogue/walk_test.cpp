// What every described function promises, walked over the whole catalogue: examples give finite outputs
// inside the declared range; a step outside any bound, NaN and infinity give an error that names the input;
// and anywhere in the box the answer is finite or a clear error.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/catalogue/catalogue.h"

using namespace verstat::models;

namespace {

Value with(const Value& inputs, const std::string& name, const Value& value) {
  Value::Map map = *inputs.map();
  for (auto& [key, old] : map)
    if (key == name) {
      old = value;
      return map;
    }
  map.emplace_back(name, value);
  return map;
}

bool is_number(const Field& field) {
  const std::string type = field.access->type();
  return type == "number" || type == "integer";
}

std::optional<double> number(const Value& value) {
  if (const double* d = value.real()) return *d;
  if (const std::int64_t* i = value.integer()) return static_cast<double>(*i);
  return std::nullopt;
}

void check_outputs(const Function& f, const Value& outputs) {
  for (const Field& field : f.outputs) {
    const Value* value = outputs.find(field.name);
    REQUIRE(value != nullptr);
    if (const auto x = number(*value)) {
      INFO(f.key << " " << field.name << " = " << *x);
      // A bound may be missed by rounding.
      const double slack = 1e-9 * std::max(1.0, std::abs(*x));
      CHECK(std::isfinite(*x));
      CHECK(*x >= field.range.low - slack);
      CHECK(*x <= field.range.high + slack);
    }
  }
}

}  // namespace

TEST_CASE("the example of every function gives outputs inside their declared ranges", "[catalogue]") {
  for (const Source& source : catalogue().sources())
    for (const Function& f : source.functions()) {
      INFO(f.key);
      Value outputs;
      REQUIRE_NOTHROW(outputs = f.evaluate(f.example_inputs()));
      check_outputs(f, outputs);
    }
}

TEST_CASE("every description is complete", "[catalogue]") {
  for (const Source& source : catalogue().sources()) {
    CHECK_FALSE(source.info().title.empty());
    CHECK_FALSE(source.info().models.empty());
    for (const Function& f : source.functions()) {
      INFO(f.key);
      CHECK_FALSE(f.summary.empty());
      CHECK_FALSE(f.equation.empty());
      CHECK_FALSE(f.outputs.empty());
      for (const auto& list : {f.inputs, f.outputs})
        for (const Field& field : list) {
          INFO(field.name);
          CHECK_FALSE(field.meaning.empty());
          CHECK_FALSE(field.unit.empty());
        }
    }
  }
}

TEST_CASE("a step outside a bound, NaN and infinity give an error that names the input", "[catalogue]") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Source& source : catalogue().sources())
    for (const Function& f : source.functions())
      for (const Field& field : f.inputs) {
        if (!is_number(field)) continue;
        const bool whole = field.access->type() == "integer";
        std::vector<Value> bad;
        if (whole) {
          if (std::isfinite(field.range.low))
            bad.emplace_back(static_cast<std::int64_t>(std::ceil(field.range.low)) - 1);
          if (std::isfinite(field.range.high))
            bad.emplace_back(static_cast<std::int64_t>(std::floor(field.range.high)) + 1);
          bad.emplace_back(0.5);
        } else {
          bad = {std::nan(""), inf, -inf};
          if (std::isfinite(field.range.low))
            bad.emplace_back(field.range.low_open ? field.range.low : std::nextafter(field.range.low, -inf));
          if (std::isfinite(field.range.high))
            bad.emplace_back(field.range.high_open ? field.range.high
                                                   : std::nextafter(field.range.high, inf));
        }
        for (const Value& value : bad) {
          INFO(f.key << " " << field.name << " = " << value.to_string());
          try {
            (void)f.evaluate(with(f.example_inputs(), field.name, value));
            FAIL_CHECK("accepted");
          } catch (const ModelError& e) {
            CHECK(e.input() == field.name);
            CHECK(std::string(e.what()).starts_with(f.key + ": " + field.name + " = "));
          }
        }
      }
}

TEST_CASE("anywhere in the valid box the answer is finite or a clear error", "[catalogue]") {
  for (const Source& source : catalogue().sources())
    for (const Function& f : source.functions()) {
      const Value example = f.example_inputs();
      for (const Field& field : f.inputs) {
        if (!is_number(field)) continue;
        const double at = number(field.example).value_or(1.0);
        std::vector<double> points = {at * 1e-6, at * 0.1, at * 0.5, at * 0.9, at * 1.1, at * 2,
                                      at * 10,   at * 1e6, 0.0,      1.0,      -1.0};
        if (std::isfinite(field.range.low))
          points.push_back(std::nextafter(field.range.low, field.range.high));
        if (std::isfinite(field.range.high))
          points.push_back(std::nextafter(field.range.high, field.range.low));
        if (std::isfinite(field.range.low) && std::isfinite(field.range.high))
          for (int k = 0; k <= 8; ++k)
            points.push_back(field.range.low + (field.range.high - field.range.low) * k / 8);
        for (double x : points) {
          if (!field.range.contains(x)) continue;
          Value value = x;
          if (field.access->type() == "integer") {
            if (std::abs(x) > 1e4 || !field.range.contains(std::round(x)))
              continue;  // counts: size, not value, is limited
            value = static_cast<std::int64_t>(std::round(x));
          }
          INFO(f.key << " " << field.name << " = " << value.to_string());
          try {
            check_outputs(f, f.evaluate(with(example, field.name, value)));
          } catch (const ModelError& e) {
            CHECK(std::string(e.what()).size() > f.key.size() + 2);
          }
        }
      }
    }
}
