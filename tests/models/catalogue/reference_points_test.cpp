// Every reference point of every source: tests/catalogue/<ID>.json, evaluated as a user would, by key and
// names. Points are `published` (printed in the paper) or `derived` (a second computation from the card's
// text).
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/model_json.h"

using namespace verstat;
using nlohmann::json;

namespace {

struct Tolerance {
  std::optional<double> abs, rel;
  [[nodiscard]] bool meets(double got, double expected) const {
    const double gap = std::abs(got - expected);
    if (gap == 0) return true;
    if (!abs && !rel) return gap <= 1e-9 * std::max(1.0, std::abs(expected));
    return (abs && gap <= *abs) || (rel && gap <= *rel * std::abs(expected));
  }
};

// First difference between what came and what should have come; empty when there is none. Outputs that the
// point does not list are not compared.
std::string difference(const json& got, const json& expected, const Tolerance& tol,
                       const std::string& place) {
  if (expected.is_number()) {
    if (!got.is_number()) return fmt::format("{} is {}, expected {}", place, got.dump(), expected.dump());
    if (tol.meets(got.get<double>(), expected.get<double>())) return "";
    return fmt::format("{} is {}, expected {}", place, got.dump(), expected.dump());
  }
  if (expected.is_array()) {
    if (!got.is_array() || got.size() != expected.size())
      return fmt::format("{} is {}, expected {}", place, got.dump(), expected.dump());
    for (std::size_t k = 0; k < expected.size(); ++k)
      if (auto d = difference(got[k], expected[k], tol, fmt::format("{}/{}", place, k)); !d.empty()) return d;
    return "";
  }
  if (expected.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      if (!got.is_object() || !got.contains(key)) return fmt::format("{}/{} is missing", place, key);
      if (auto d = difference(got[key], value, tol, place + "/" + key); !d.empty()) return d;
    }
    return "";
  }
  return got == expected ? "" : fmt::format("{} is {}, expected {}", place, got.dump(), expected.dump());
}

}  // namespace

TEST_CASE("every reference point of every source is met", "[catalogue]") {
  const std::filesystem::path folder = std::filesystem::path(VERSTAT_SOURCE_DIR) / "tests/catalogue";
  std::size_t points = 0;
  std::set<std::string> functions_with_points;
  for (const models::Source& source : models::catalogue().sources()) {
    const auto file = folder / (source.info().id + ".json");
    INFO(file.string());
    REQUIRE(std::filesystem::exists(file));
    std::ifstream in(file);
    for (const json& point : json::parse(in)) {
      ++points;
      const auto key = source.info().id + "." + point["function"].get<std::string>();
      functions_with_points.insert(key);
      Tolerance tol;
      if (point.contains("abs_tol")) tol.abs = point["abs_tol"].get<double>();
      if (point.contains("rel_tol")) tol.rel = point["rel_tol"].get<double>();
      std::string verdict;
      try {
        const json got =
            scenarios::to_json(models::catalogue().at(key).evaluate(scenarios::to_value(point["inputs"])));
        verdict = difference(got, point["outputs"], tol, "");
      } catch (const std::exception& e) {
        verdict = e.what();
      }
      if (!verdict.empty()) FAIL_CHECK(point["id"].get<std::string>() << " " << key << ": " << verdict);
    }
  }
  CHECK(points > 0);
}
