// Variations of honest inputs. A byte changed at random ends in the JSON parser; a member changed at random
// ends where it is used.
#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

using nlohmann::json;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::uint64_t roll() {  // splitmix64
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(roll() % n); }

 private:
  std::uint64_t state_;
};

void collect(json& at, std::vector<json*>& all) {
  all.push_back(&at);
  if (at.is_structured())
    for (json& child : at) collect(child, all);
}

json odd_value(Dice& dice) {
  static const std::vector<json> odd = {nullptr,
                                        true,
                                        false,
                                        0,
                                        1,
                                        -1,
                                        2,
                                        1000000,
                                        9007199254740993,
                                        INT64_MAX,
                                        INT64_MIN,
                                        UINT64_MAX,
                                        0.0,
                                        -0.0,
                                        1e-320,
                                        1e-300,
                                        1e-9,
                                        0.5,
                                        1.0000000001,
                                        1e9,
                                        1e17,
                                        1.7e308,
                                        -1e308,
                                        "",
                                        "x",
                                        "*",
                                        "a/b~1",
                                        "\xd1\x85\xd0\xb2",
                                        std::string(300, 'a'),
                                        json::array(),
                                        json::object(),
                                        json::array({json::array()})};
  return odd[dice.below(odd.size())];
}

void change_number(json& at, Dice& dice) {
  if (at.is_number_integer()) {
    const auto old = at.get<std::int64_t>();
    const std::array<std::int64_t, 6> to{old / 2,
                                         old > INT64_MAX / 2 || old < INT64_MIN / 2 ? 0 : old * 2,
                                         0,
                                         1,
                                         old == INT64_MAX ? 0 : old + 1,
                                         old == INT64_MIN ? 0 : old - 1};
    at = to[dice.below(to.size())];
  } else {
    const auto old = at.get<double>();
    const std::array<double, 8> to{old / 2, old * 2, -old, old * 1e-6, old * 1e6, old / 1000, 0, old * 1.01};
    at = to[dice.below(to.size())];
  }
}

std::string mutated_tree(json tree, Dice& dice) {
  const std::size_t changes = 1 + dice.below(4);
  for (std::size_t k = 0; k < changes; ++k) {
    std::vector<json*> all;
    collect(tree, all);
    json& at = *all[dice.below(all.size())];
    const json other = *all[dice.below(all.size())];
    switch (dice.below(8)) {
      case 0:
        at = odd_value(dice);
        break;
      case 1:
        if (at.dump().size() + other.dump().size() < 20'000) at = other;
        break;
      case 2:
        if (at.is_object() && !at.empty()) {
          auto member = at.begin();
          std::advance(member, static_cast<std::ptrdiff_t>(dice.below(at.size())));
          at.erase(member);
        } else if (at.is_array() && !at.empty()) {
          at.erase(dice.below(at.size()));
        }
        break;
      case 3:
        if (at.is_array() && !at.empty()) at.push_back(json(at[dice.below(at.size())]));
        break;
      default:
        if (at.is_number()) {
          change_number(at, dice);
        } else if (at.is_boolean()) {
          at = !at.get<bool>();
        } else if (dice.below(4) == 0) {
          at = odd_value(dice);
        }
    }
  }
  return tree.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string mutated_bytes(std::string text, Dice& dice) {
  static const std::vector<std::string> odd = {"\"",
                                               "\\",
                                               "{",
                                               "}",
                                               "[",
                                               "]",
                                               ",",
                                               ":",
                                               ";",
                                               "\t",
                                               "\n",
                                               "\r",
                                               "0",
                                               "-",
                                               "1e9",
                                               "1e400",
                                               "nan",
                                               "\xff",
                                               "%00",
                                               "%2f",
                                               "..",
                                               "/",
                                               std::string(1, '\0'),
                                               "\xef\xbb\xbf",
                                               "=",
                                               "\"\"",
                                               "9999999999999999999"};
  const std::size_t changes = 1 + dice.below(5);
  for (std::size_t k = 0; k < changes; ++k) {
    const std::size_t at = dice.below(text.size() + 1);
    const std::size_t length = std::min(dice.below(12), text.size() - at);
    switch (dice.below(5)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, odd[dice.below(odd.size())]);
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(dice.below(256));
        break;
      case 3:
        text.insert(dice.below(text.size() + 1), text.substr(at, length));
        break;
      default:
        if (dice.below(50) == 0) text.resize(at);
    }
  }
  return text;
}

}  // namespace

namespace {

// Where the body of a request begins.
std::size_t body_of(const std::string& text) {
  const auto end = text.find("\n\n");
  return end == std::string::npos ? text.size() : end + 2;
}

std::string mutated_json(const std::string& text, Dice& dice) {
  json tree = json::parse(text, nullptr, false);
  return tree.is_discarded() ? mutated_bytes(text, dice) : mutated_tree(std::move(tree), dice);
}

// A member or entry of one tree in place of one of the other, or beside those that stand there.
std::string crossed_json(const std::string& text, const std::string& other, Dice& dice) {
  json tree = json::parse(text, nullptr, false);
  json donor = json::parse(other, nullptr, false);
  if (tree.is_discarded() || donor.is_discarded()) return {};
  std::vector<json*> places;
  std::vector<json*> parts;
  collect(tree, places);
  collect(donor, parts);
  json& at = *places[dice.below(places.size())];
  const json& part = *parts[dice.below(parts.size())];
  if (at.is_object() && part.is_object() && !part.empty() && dice.below(4) != 0) {
    auto member = part.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(dice.below(part.size())));
    at[member.key()] = member.value();
  } else if (at.is_array() && dice.below(2) == 0) {
    at.push_back(part);
  } else {
    at = json(part);
  }
  return tree.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string mutated(const std::string& text, Form form, std::uint64_t seed) {
  Dice dice(seed);
  if (form == Form::bytes || dice.below(16) == 0) return mutated_bytes(text, dice);
  if (form == Form::json) return mutated_json(text, dice);
  const std::size_t body = body_of(text);
  if (body == text.size() || dice.below(3) == 0)
    return mutated_bytes(text.substr(0, body), dice) + text.substr(body);
  return text.substr(0, body) + mutated_json(text.substr(body), dice);
}

std::string crossed(const std::string& text, const std::string& other, Form form, std::uint64_t seed) {
  Dice dice(seed);
  if (form == Form::json) return crossed_json(text, other, dice);
  if (form == Form::bytes) return {};
  const std::size_t body = body_of(text);
  const std::size_t other_body = body_of(other);
  if (dice.below(3) == 0) return text.substr(0, body) + other.substr(other_body);
  const std::string mixed = crossed_json(text.substr(body), other.substr(other_body), dice);
  return mixed.empty() ? mixed : text.substr(0, body) + mixed;
}

}  // namespace verstat::fuzz
