#pragma once
// Who may ask. A server on the loopback address is reachable by every page the user's browser has open, so
// the address it is called by (DNS rebinding), the origin of a change (forgery) and, beyond this machine, a
// token are checked before anything is looked at.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "web-ui/server/message.h"

namespace verstat::web {

struct Guard {
  /// Names this server answers to, lower case with port: "127.0.0.1:8080". Empty: any, which is safe only
  /// behind a token, since a rebinding page cannot know it.
  std::vector<std::string> hosts;
  std::string token;  ///< asked of every API request; empty: none
};

/// Guard of a server on `address` (numeric) and `port`. Loopback addresses answer to their usual names only.
[[nodiscard]] Guard guard_for(const std::string& address, bool loopback, int port, const std::string& token);

/// The refusal, or none when the request may be answered. `api` is false for the pages themselves, which hold
/// no secrets and are served without a token (they ask for it).
[[nodiscard]] std::optional<Response> refusal(const Guard& guard, const Request& request, bool api);

/// Compares in a time that depends on the lengths only.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

}  // namespace verstat::web
