#include "web-ui/server/site.h"

#include <cstdint>

#include <fmt/format.h>

#include "models/catalogue/shortened.h"

namespace verstat::web {

namespace {

// FNV-1a: an entity tag must tell versions apart, it keeps no secret.
std::string tag_of(std::string_view body) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("\"{:016x}-{:x}\"", hash, body.size());
}

/// True when an If-None-Match list names the tag (weak comparison, RFC 9110 section 13.1.2).
bool names_tag(std::string_view list, std::string_view tag) {
  while (!list.empty()) {
    std::string_view one = list.substr(0, list.find(','));
    list.remove_prefix(std::min(list.size(), one.size() + 1));
    while (!one.empty() && one.front() == ' ') one.remove_prefix(1);
    while (!one.empty() && one.back() == ' ') one.remove_suffix(1);
    if (one.substr(0, 2) == "W/") one.remove_prefix(2);
    if (one == tag || one == "*") return true;
  }
  return false;
}

/// True when an Accept-Encoding list names gzip without forbidding it.
bool accepts_gzip(std::string_view list) {
  const auto at = list.find("gzip");
  if (at == std::string_view::npos) return false;
  const std::string_view rest = list.substr(at, list.substr(at).find(','));
  return rest.find("q=0") == std::string_view::npos || rest.find("q=0.") != std::string_view::npos;
}

}  // namespace

Response Site::page(const Request& request, const Target& target) const {
  if (request.method != "GET" && request.method != "HEAD") {
    Response response = error_response(405, "pages can only be read");
    response.headers["Allow"] = "GET, HEAD";
    return response;
  }
  if (pages_.empty() && target.path.empty())
    return {.content_type = "text/plain; charset=utf-8",
            .body =
                "This verstat was built without pages (VERSTAT_WEB=OFF). The data: /api/v1/runs, "
                "/api/v1/studies, /api/v1/models; described in /api/v1/openapi.json\n"};
  std::string path;
  for (const std::string& step : target.path) path += "/" + step;
  if (path.empty()) path = "/index.html";
  for (const Asset& asset : pages_) {
    if (asset.path != path) continue;
    Response response{.content_type = std::string(asset.content_type)};
    const bool gzip = !asset.gzip.empty() && accepts_gzip(request.header("accept-encoding"));
    response.body = gzip ? asset.gzip : asset.plain;
    if (gzip) response.headers["Content-Encoding"] = "gzip";
    response.headers["Vary"] = "Accept-Encoding";
    response.headers["ETag"] = fmt::format("\"{}{}\"", asset.etag, gzip ? "-gz" : "");
    response.headers["Cache-Control"] = asset.immutable ? "public, max-age=31536000, immutable" : "no-cache";
    return response;
  }
  return error_response(404, fmt::format("there is no page {}", models::shortened(request.target, 100)));
}

Response Site::unguarded(const Guard& guard, const Request& request) const {
  const auto target = parse_target(request.target);
  if (!target) {
    if (auto refused = refusal(guard, request, true)) return *refused;
    return error_response(400, fmt::format("{}: not an address this server understands",
                                           models::shortened(request.target, 100)));
  }
  const bool api = !target->path.empty() && target->path.front() == "api";
  if (auto refused = refusal(guard, request, api)) return *refused;
  return api ? api_.answer(request, *target) : page(request, *target);
}

Response Site::answer(const Guard& guard, const Request& request) const {
  Response response = unguarded(guard, request);
  if (response.status == 200 && !response.stream && (request.method == "GET" || request.method == "HEAD")) {
    std::string& tag = response.headers["ETag"];
    if (tag.empty()) tag = tag_of(response.body);
    if (names_tag(request.header("if-none-match"), tag)) {
      response.status = 304;
      response.body.clear();
    }
  }
  response.headers.emplace("Cache-Control",
                           response.status == 200 || response.status == 304 ? "no-cache" : "no-store");
  response.headers.emplace(
      "Content-Security-Policy",
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
      "connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'");
  response.headers.emplace("X-Content-Type-Options", "nosniff");
  response.headers.emplace("X-Frame-Options", "DENY");
  response.headers.emplace("Referrer-Policy", "no-referrer");
  response.headers.emplace("Cross-Origin-Opener-Policy", "same-origin");
  response.headers.emplace("Cross-Origin-Resource-Policy", "same-origin");
  return response;
}

}  // namespace verstat::web
