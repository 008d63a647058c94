#include "web-ui/server/guard.h"

#include <catch2/catch.hpp>

using namespace verstat::web;

namespace {

int status(const Guard& guard, const std::string& method, std::map<std::string, std::string> headers,
           bool api = true) {
  const auto refused =
      refusal(guard, {.method = method, .target = "/", .headers = std::move(headers), .body = ""}, api);
  return refused ? refused->status : 200;
}

}  // namespace

TEST_CASE("a loopback server answers to its own names only") {
  const Guard guard = guard_for("127.0.0.1", true, 8080, "");
  for (const char* good : {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080"}) {
    CAPTURE(good);
    CHECK(status(guard, "GET", {{"host", good}}) == 200);
  }
  for (const char* bad : {"evil.example:8080", "127.0.0.1", "127.0.0.1:8081", "localhost.evil.example:8080",
                          "127.0.0.1:8080, evil.example"}) {
    CAPTURE(bad);
    CHECK(status(guard, "GET", {{"host", bad}}) == 403);
  }
  CHECK(status(guard, "GET", {}) == 400);
  CHECK(status(guard_for("::1", true, 80, ""), "GET", {{"host", "[::1]"}}) == 200);
}

TEST_CASE("changes need the own header and the own origin") {
  const Guard guard = guard_for("127.0.0.1", true, 8080, "");
  const std::pair<const std::string, std::string> host{"host", "127.0.0.1:8080"};
  CHECK(status(guard, "POST", {host}) == 403);
  CHECK(status(guard, "POST", {host, {"x-verstat", "1"}}) == 200);
  CHECK(status(guard, "POST", {host, {"x-verstat", "1"}, {"origin", "http://127.0.0.1:8080"}}) == 200);
  CHECK(status(guard, "POST", {host, {"x-verstat", "1"}, {"origin", "http://evil.example"}}) == 403);
  CHECK(status(guard, "POST", {host, {"x-verstat", "1"}, {"origin", "null"}}) == 403);
  CHECK(status(guard, "POST", {host, {"x-verstat", "1"}, {"sec-fetch-site", "cross-site"}}) == 403);
  CHECK(status(guard, "DELETE", {host}) == 403);
}

TEST_CASE("a token is asked of the API, not of the pages that ask for it") {
  const std::string token = "0123456789abcdef";
  const Guard guard = guard_for("192.168.1.5", false, 8080, token);
  const std::pair<const std::string, std::string> host{"host", "workshop.example:8080"};
  CHECK(status(guard, "GET", {host}) == 401);
  CHECK(status(guard, "GET", {host}, false) == 200);
  CHECK(status(guard, "GET", {host, {"authorization", "Bearer " + token}}) == 200);
  for (const char* bad : {"Bearer 0123456789abcdeX", "Bearer 0123456789abcde", "Bearer ", "",
                          "0123456789abcdef", "Basic 0123456789abcdef", "Bearer 0123456789abcdef0"}) {
    CAPTURE(bad);
    CHECK(status(guard, "GET", {host, {"authorization", bad}}) == 401);
  }
}
