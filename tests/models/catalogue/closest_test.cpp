// What a misspelt name is taken for.
#include "models/catalogue/closest.h"

#include <algorithm>
#include <functional>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/property.h"

using namespace verstat::models;

namespace {

// By the definition: delete, insert or replace a letter.
std::size_t by_definition(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::size_t replaced = by_definition(a.substr(1), b.substr(1)) + (a[0] == b[0] ? 0 : 1);
  return std::min({replaced, by_definition(a.substr(1), b) + 1, by_definition(a, b.substr(1)) + 1});
}

std::string word() {
  std::string text;
  for (const int k : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3)))
    text += static_cast<char>('a' + k);
  return text.substr(0, 6);
}

}  // namespace

TEST_CASE("the edit distance is that of its definition", "[catalogue]") {
  CHECK(edit_distance("kitten", "sitting") == 3);
  verstat::test::property("edit distance", [] {
    const std::string a = word(), b = word();
    RC_ASSERT(edit_distance(a, b) == by_definition(a, b));
  });
}

TEST_CASE("the closest is the first of those with the least distance", "[catalogue]") {
  CHECK(closest("feed_mm_rv", {"speed_m_min", "feed_mm_rev", "feed_mm_tooth"}) == "feed_mm_rev");
  CHECK(closest("x", {}).empty());
  CHECK(closest(std::string(1'000'000, 'x'), {"a", "b"}) == "a");
  verstat::test::property("closest", [] {
    std::vector<std::string> candidates;
    for (int k = *rc::gen::inRange(1, 8); k > 0; --k) candidates.push_back(word());
    const std::string name = word();
    const auto best = std::min_element(
        candidates.begin(), candidates.end(),
        [&](const auto& a, const auto& b) { return edit_distance(name, a) < edit_distance(name, b); });
    RC_ASSERT(closest(name, candidates) == *best);
  });
}
