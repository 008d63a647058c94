// Tools of the gallery load; bad ones are refused with the place, the value and what would be right.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "scenarios/load.h"

using namespace verstat::scenarios;
using nlohmann::json;

namespace {

json gallery(const std::string& name) {
  return read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/" + name + ".json");
}

// Loads a scenario of the gallery with one change and returns the message of the error.
std::string error_of(const std::string& name, const std::string& change) {
  try {
    (void)load(apply(gallery(name), {parse_change(change)}));
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

constexpr const char* with_tools[] = {"tools-face-mill", "tools-unattended", "tools-drills", "tools-elements",
                                      "tools-certified-inserts"};

void collect(const json& j, const std::string& at, std::vector<std::string>& into) {
  if (!at.empty()) into.push_back(at);
  if (j.is_object())
    for (const auto& [key, value] : j.items()) collect(value, at + "/" + key, into);
  if (j.is_array())
    for (std::size_t k = 0; k < j.size(); ++k) collect(j[k], fmt::format("{}/{}", at, k), into);
}

}  // namespace

TEST_CASE("a magazine that is too small for its tools is refused, with what they need") {
  CHECK(error_of("tools-unattended", "/machines/0/magazine=8") == "accepted");
  CHECK(error_of("tools-unattended", "/machines/0/magazine=7") ==
        "/machines/0/magazine = 7, its tools need 8 places: 4 x \"roughing tool\"");
  // A shared copy takes its places in each machine once.
  CHECK(error_of("tools-drills", "/machines/0/magazine=1") == "accepted");
}

TEST_CASE("teeth, elements, inspections and copies that do not fit are refused") {
  CHECK(error_of("tools-face-mill", "/tools/0/strategy/failed_teeth=11") ==
        "/tools/0/strategy/failed_teeth = 11, must not exceed the teeth of the tool, 10");
  CHECK(error_of("tools-face-mill", "/tools/0/teeth=8") ==
        "/tools/0/teeth = 8, operation \"face milling\" mills with 10 teeth: both must be the same");
  CHECK(
      error_of("tools-face-mill", "/tools/0/strategy/load_sharing=left") ==
      "/tools/0/strategy/load_sharing = \"left\", must be one of \"local\", \"global\", \"none\" (who takes "
      "the chip of a failed tooth)");
  CHECK(error_of("tools-face-mill", R"(/tools/0/regrind={"time":{"kind":"constant","value_min":1}})") ==
        "/tools/0/teeth = 10, must be 1: a tool with inserts is not reground");
  CHECK(error_of("tools-elements", "/tools/0/elements/0/element=guide pad") ==
        "/tools/0/elements/0/element = \"guide pad\", there is no such element that an operation with this "
        "tool wears; closest: \"guide pads\"");
  CHECK(error_of("tools-elements", "/tools/1/insert=") ==
        "/tools/1/insert = \"\", there is no such insert; closest: \"head insert\"");
  CHECK(error_of("tools-elements", "/tools/1/copies=2")
            .starts_with("/tools/1/strategy = \"opportunistic\", is for edges changed on the machine"));
  CHECK(error_of("tools-drills", "/tools/0/strategy/every_min=5") ==
        "/tools/0/strategy = both every_min and every_parts, must have exactly one of them");
  CHECK(error_of("tools-drills", "/tools/0/presetting/crew=toolrum") ==
        "/tools/0/presetting/crew = \"toolrum\", there is no such crew or skill; closest: \"tool room\"");
  CHECK(
      error_of("tools-unattended", "/inserts/0/crib/order_quantity=0") ==
      "/inserts/0/crib/order_quantity = 0, allowed 1 <= order_quantity <= 1000000000 (inserts of one order)");
  CHECK(error_of("tools-certified-inserts", "/inserts/0/edges=1") ==
        "/inserts/0/preparation/edges_used_by_test = 0 edges left, must leave at least one of the 1 edges of "
        "the insert");
  CHECK(error_of("tools-certified-inserts",
                 R"(/inserts/0/preparation={"kind":"duration","time":{"kind":"constant","value_min":1}})")
            .starts_with("/inserts/0/preparation/kind = \"duration\", must be one that prepares a lot"));
  CHECK(error_of("tools-certified-inserts", "/inserts/0/preparation/mean_life_min=-1") != "accepted");
}

TEST_CASE("any member of the tool galleries replaced by anything loads or gives one line with a pointer") {
  const std::vector<json> absurd = {nullptr, -1, 0, 1e308, 1e-308, "", "x", json::array(), json::object()};
  for (const char* name : with_tools) {
    const json whole = gallery(name);
    (void)load(whole);
    std::vector<std::string> pointers;
    for (const char* list : {"inserts", "tools"}) collect(whole[list], std::string("/") + list, pointers);
    for (const std::string& pointer : pointers)
      for (const json& value : absurd) {
        INFO(name << " " << pointer << " = " << value.dump());
        try {
          (void)load(apply(whole, {Change{pointer, value}}));
        } catch (const InputError& e) {
          const std::string message = e.what();
          CHECK(message.find('\n') == std::string::npos);
          CHECK(message.size() < 600);
        }
      }
  }
}
