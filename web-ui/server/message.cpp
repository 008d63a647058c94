#include "web-ui/server/message.h"

#include <nlohmann/json.hpp>

namespace verstat::web {

Response error_response(int status, const std::string& message, const std::string& input,
                        const std::string& pointer) {
  nlohmann::ordered_json error = {{"status", status}, {"message", message}};
  if (!input.empty()) error["input"] = input;
  if (!pointer.empty()) error["pointer"] = pointer;
  const nlohmann::ordered_json body = {{"error", error}};
  // What a client sent may stand in the message and need not be UTF-8.
  return {.status = status,
          .body = body.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"};
}

}  // namespace verstat::web
