#pragma once
// Requests and answers without a socket, so that everything but the transport is tested as plain functions.

#include <map>
#include <string>
#include <string_view>

namespace verstat::web {

struct Request {
  std::string method;                          ///< "GET"
  std::string target;                          ///< as sent: "/api/v1/runs?limit=20"
  std::map<std::string, std::string> headers;  ///< names in lower case; repeated ones joined by ", "
  std::string body;

  /// Value of a header (name in lower case), empty when it was not sent.
  [[nodiscard]] std::string_view header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string_view{} : std::string_view(found->second);
  }
};

struct Response {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::map<std::string, std::string>
      headers;  ///< beyond Content-Type, Content-Length and those on every answer
};

/// {"error": {"status", "message"}}, with "input" when one input of a model function is to blame.
[[nodiscard]] Response error_response(int status, const std::string& message, const std::string& input = "");

}  // namespace verstat::web
