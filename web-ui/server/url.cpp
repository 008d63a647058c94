#include "web-ui/server/url.h"

#include <algorithm>

namespace verstat::web {

namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> query_decode(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), '+', ' ');
  return percent_decode(spaced);
}

bool add_query(Target& target, std::string_view query) {
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    if (pair.empty()) continue;
    const auto equals = pair.find('=');
    const auto name = query_decode(pair.substr(0, equals));
    const auto value =
        query_decode(equals == std::string_view::npos ? std::string_view{} : pair.substr(equals + 1));
    if (!name || !value || !target.query.emplace(*name, *value).second) return false;
  }
  return true;
}

}  // namespace

std::optional<std::string> percent_decode(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k) {
    char c = text[k];
    if (c == '%') {
      if (k + 2 >= text.size()) return std::nullopt;
      const int high = hex_digit(text[k + 1]);
      const int low = hex_digit(text[k + 2]);
      if (high < 0 || low < 0) return std::nullopt;
      c = static_cast<char>(high * 16 + low);
      k += 2;
    }
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return std::nullopt;
    decoded += c;
  }
  return decoded;
}

std::optional<Target> parse_target(std::string_view text) {
  if (text.empty() || text.front() != '/') return std::nullopt;
  Target target;
  const auto question = text.find('?');
  if (question != std::string_view::npos && !add_query(target, text.substr(question + 1)))
    return std::nullopt;
  std::string_view path = text.substr(1, question == std::string_view::npos ? question : question - 1);
  while (!path.empty()) {
    const auto slash = path.find('/');
    const auto step = percent_decode(path.substr(0, slash));
    if (!step || step->empty() || *step == "." || *step == ".." ||
        step->find_first_of("/\\") != std::string::npos)
      return std::nullopt;
    target.path.push_back(*step);
    if (slash == std::string_view::npos) break;
    path.remove_prefix(slash + 1);
  }
  return target;
}

}  // namespace verstat::web
