// Request targets: path and query.
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"
#include "web-ui/server/url.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  const auto target = web::parse_target(bytes);
  if (!target) return;
  for (const std::string& step : target->path)
    if (step.empty() || step == "." || step == ".." || step.find('/') != std::string::npos ||
        step.find('\\') != std::string::npos || step.find('\0') != std::string::npos)
      finding("a path that leads elsewhere: " + step);
}

std::vector<std::string> seeds() {
  return {"/",
          "/api/v1/runs/3?replications=1",
          "/api/v1/models/K117.part_cost",
          "/assets/index-3f2a.js",
          "/a%20b/c%2Fd?x=%41&y=+1",
          "/api/v1/../../etc/passwd",
          "/%2e%2e/%2e%2e/etc/passwd"};
}

}  // namespace

Target route_target() {
  return {"route", Form::bytes, eat, seeds};
}

}  // namespace verstat::fuzz
