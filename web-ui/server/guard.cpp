#include "web-ui/server/guard.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "models/catalogue/shortened.h"

namespace verstat::web {

namespace {

std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return all;
}

bool reads_only(const Request& request) {
  return request.method == "GET" || request.method == "HEAD";
}

}  // namespace

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    difference |= static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]);
  return difference == 0;
}

Guard guard_for(const std::string& address, bool loopback, int port, const std::string& token) {
  Guard guard{.hosts = {}, .token = token};
  if (!loopback) return guard;
  const std::string bracketed = address.find(':') == std::string::npos ? address : "[" + address + "]";
  for (const std::string& name : {bracketed, std::string("localhost"), std::string("127.0.0.1")}) {
    guard.hosts.push_back(fmt::format("{}:{}", name, port));
    if (port == 80) guard.hosts.push_back(name);
  }
  return guard;
}

std::optional<Response> refusal(const Guard& guard, const Request& request, bool api) {
  const std::string host = lower(request.header("host"));
  if (host.empty()) return error_response(400, "the request has no Host header");
  if (!guard.hosts.empty() && std::find(guard.hosts.begin(), guard.hosts.end(), host) == guard.hosts.end())
    return error_response(403, fmt::format("this server answers to http://{}/ only, not to \"{}\"",
                                           guard.hosts.front(), models::shortened(host, 100)));
  if (!reads_only(request)) {
    const std::string origin = lower(request.header("origin"));
    const std::string_view site = request.header("sec-fetch-site");
    if ((!origin.empty() && origin != "http://" + host) ||
        (!site.empty() && site != "same-origin" && site != "none"))
      return error_response(403, "requests from other sites' pages are refused");
    if (request.header("x-verstat") != "1")
      return error_response(403, fmt::format("{} needs the header \"X-Verstat: 1\"", request.method));
  }
  if (api && !guard.token.empty()) {
    constexpr std::string_view scheme = "Bearer ";
    const std::string_view given = request.header("authorization");
    if (given.substr(0, scheme.size()) != scheme ||
        !equal_in_constant_time(given.substr(scheme.size()), guard.token)) {
      Response response =
          error_response(401, "the server was started with --token: send \"Authorization: Bearer TOKEN\"");
      response.headers["WWW-Authenticate"] = "Bearer";
      return response;
    }
  }
  return std::nullopt;
}

}  // namespace verstat::web
