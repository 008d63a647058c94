#pragma once
// Requests and answers without a socket, so that everything but the transport is tested as plain functions.

#include <map>
#include <memory>
#include <optional>
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

/// An answer that goes on: text/event-stream. Asked again and again by the connection it belongs to.
class EventStream {
 public:
  EventStream() = default;
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;
  virtual ~EventStream() = default;
  /// What is new since the last call, possibly nothing; none when the stream has ended. Must not wait.
  [[nodiscard]] virtual std::optional<std::string> next() = 0;
};

struct Response {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::map<std::string, std::string>
      headers;                          ///< beyond Content-Type, Content-Length and those on every answer
  std::shared_ptr<EventStream> stream;  ///< sent after `body`, piece by piece, until it ends
};

/// {"error": {"status", "message"}}, with "input" when one input of a model function is to blame and
/// "pointer" when a place in a scenario is.
[[nodiscard]] Response error_response(int status, const std::string& message, const std::string& input = "",
                                      const std::string& pointer = "");

}  // namespace verstat::web
