#include "web-ui/server/url.h"

#include <catch2/catch.hpp>

using verstat::web::parse_target;
using verstat::web::percent_decode;
using Steps = std::vector<std::string>;

TEST_CASE("percent-decoding is strict") {
  CHECK(percent_decode("a%20b%2Fc") == "a b/c");
  CHECK(percent_decode("%d1%96") == "\xD1\x96");
  CHECK(percent_decode("%2525") == "%25");  // once, not twice
  for (const char* bad : {"%", "%2", "%zz", "a%0d%0ab", "%00", "%7f", "\x01"}) {
    CAPTURE(bad);
    CHECK_FALSE(percent_decode(bad));
  }
}

TEST_CASE("a target is taken apart once") {
  const auto target = parse_target("/api/v1/runs/3?limit=20&search=tool+life%21&flag");
  REQUIRE(target);
  CHECK(target->path == Steps{"api", "v1", "runs", "3"});
  CHECK(target->query ==
        std::map<std::string, std::string>{{"limit", "20"}, {"search", "tool life!"}, {"flag", ""}});
  CHECK(parse_target("/")->path.empty());
  CHECK(parse_target("/?a=1")->query.at("a") == "1");
  CHECK(parse_target("/runs/")->path == Steps{"runs"});
}

TEST_CASE("targets that lead elsewhere are refused") {
  for (const char* bad :
       {"", "runs", "http://host/", "/../etc/passwd", "/a/../../b", "/a/%2e%2e/b", "/%2e", "//etc", "/a//b",
        "/a%2fb", "/a%5c..%5cb", "/a\\b", "/%00", "/x?a=%zz", "/x?a=1&a=2", "*"}) {
    CAPTURE(bad);
    CHECK_FALSE(parse_target(bad));
  }
}
