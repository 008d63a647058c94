#pragma once
// The built pages, compiled into the program.

#include <span>
#include <string_view>

namespace verstat::web {

struct Asset {
  std::string_view path;  ///< "/index.html"
  std::string_view content_type;
  std::string_view etag;   ///< hash of the content, without quotes
  bool immutable = false;  ///< the name holds a hash of the content: browsers may keep it for ever
  std::string_view plain;
  std::string_view gzip;  ///< empty when compression gains nothing
};

/// Every file of the pages; empty when the program was built without them. The list is the allow-list: no
/// file system path is ever formed from a request.
[[nodiscard]] std::span<const Asset> pages();

}  // namespace verstat::web
