#pragma once
// What the handlers of the interface share: refusals, query parameters, bodies, answers.

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/load.h"
#include "web-ui/server/csv.h"
#include "web-ui/server/message.h"
#include "web-ui/server/url.h"

namespace verstat::web {

/// An answer that is an error: thrown where it is found, caught in Api::answer.
struct Refused {
  int status;
  std::string message;
  std::string pointer = "";  ///< place in a scenario that is to blame
};

[[nodiscard]] Response json_response(const nlohmann::ordered_json& body, int status = 200);
/// Without indentation, which would double what thousands of rows take.
[[nodiscard]] Response dense_response(const nlohmann::ordered_json& body);
[[nodiscard]] Response csv_response(std::string body, const std::string& file);
/// At most 100 bytes, for messages.
[[nodiscard]] std::string clipped(const std::string& text);

/// Throws Refused when the query has a parameter that is not in `known`.
void check_query(const Target& target, std::initializer_list<std::string_view> known);
/// A whole number of the query, `otherwise` when it is not there.
[[nodiscard]] std::int64_t whole(const Target& target, const std::string& name, std::int64_t low,
                                 std::int64_t high, std::int64_t otherwise);
/// One of the words, the first when the parameter is not given.
[[nodiscard]] std::string word(const Target& target, const std::string& name,
                               std::initializer_list<std::string_view> words);
/// A text of the query, empty when it is not there; at most 200 bytes.
[[nodiscard]] std::string text_in(const Target& target, const std::string& name);
/// A list of at most 16 names with commas between.
[[nodiscard]] std::vector<std::string> names_in(const Target& target, const std::string& name);
[[nodiscard]] std::int64_t id_of(const char* what, const std::string& text);
[[nodiscard]] CsvFormat csv_format(const Target& target);

/// The body as JSON, an object with no members but the `known` ones. Throws Refused.
[[nodiscard]] nlohmann::json body_of(const Request& request, std::initializer_list<std::string_view> known);
/// A text member of a body, `otherwise` when it is not there. Throws Refused when it is longer than
/// `longest`.
[[nodiscard]] std::string text_member(const nlohmann::json& body, const char* name,
                                      const std::string& otherwise, std::size_t longest);

/// A scenario as a body brings it: {"scenario": TEXT or OBJECT, "changes": [{"pointer", "value"}...]}.
struct GivenScenario {
  std::string text;  ///< as it came
  std::vector<scenarios::Change> changes;
  nlohmann::json changed;  ///< with the changes made
};
/// Throws Refused (400) when the members are missing or of another shape and scenarios::InputError when text
/// or changes are wrong.
[[nodiscard]] GivenScenario scenario_of(const nlohmann::json& body);
/// The member "changes" of a body. Throws Refused.
[[nodiscard]] std::vector<scenarios::Change> changes_of(const nlohmann::json& body);

}  // namespace verstat::web
