#pragma once
// Everything behind the socket: guard, pages, API, entity tags and the headers that keep browsers safe.

#include <span>

#include "web-ui/server/api.h"
#include "web-ui/server/guard.h"
#include "web-ui/server/pages.h"

namespace verstat::web {

class Site {
 public:
  /// `pages` empty: the API alone, and "/" says so.
  Site(Api api, std::span<const Asset> pages) : api_(std::move(api)), pages_(pages) {}
  /// Never throws. May be called from several threads at once.
  [[nodiscard]] Response answer(const Guard& guard, const Request& request) const;

 private:
  [[nodiscard]] Response unguarded(const Guard& guard, const Request& request) const;
  [[nodiscard]] Response page(const Request& request, const Target& target) const;
  Api api_;
  std::span<const Asset> pages_;
};

}  // namespace verstat::web
