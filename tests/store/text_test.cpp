// UTF-8 by its definition: every code point but surrogates has one encoding, and nothing else is text.
#include <array>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "store/text_search.h"

using verstat::store::is_utf8;

namespace {

std::string encoded(unsigned code) {
  const auto byte = [](unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0U | (code >> 6U)), byte(0x80U | (code & 0x3FU))};
  if (code < 0x10000)
    return {byte(0xE0U | (code >> 12U)), byte(0x80U | ((code >> 6U) & 0x3FU)), byte(0x80U | (code & 0x3FU))};
  return {byte(0xF0U | (code >> 18U)), byte(0x80U | ((code >> 12U) & 0x3FU)),
          byte(0x80U | ((code >> 6U) & 0x3FU)), byte(0x80U | (code & 0x3FU))};
}

}  // namespace

TEST_CASE("every character is UTF-8 but the end of a text and surrogates") {
  std::size_t wrong = 0;
  for (unsigned code = 0; code < 0x120000; ++code) {
    const bool character = code != 0 && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    wrong += is_utf8(encoded(code)) == character ? 0 : 1;
    if (code >= 0x80) wrong += is_utf8(encoded(code).substr(0, encoded(code).size() - 1)) ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("no other sequence of up to three bytes is UTF-8, nor are longer ways to write a character") {
  std::set<std::string> characters;
  for (unsigned code = 1; code < 0x10000; ++code)
    if (code < 0xD800 || code > 0xDFFF) characters.insert(encoded(code));
  std::size_t wrong = 0;
  for (unsigned a = 0x80; a < 0x100; ++a) {
    wrong += is_utf8(std::string(1, static_cast<char>(a))) ? 1 : 0;
    for (unsigned b = 0; b < 0x100; ++b) {
      const std::string two{static_cast<char>(a), static_cast<char>(b)};
      wrong += is_utf8(two) == characters.contains(two) ? 0 : 1;
      if (a < 0xE0 || a > 0xEF) continue;
      for (unsigned c = 0x70; c < 0xD0; ++c) {
        const std::string three = two + static_cast<char>(c);
        wrong += is_utf8(three) == characters.contains(three) ? 0 : 1;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK_FALSE(is_utf8("\xf0\x80\x80\x80"));  // four bytes for what needs one
  CHECK_FALSE(is_utf8("\xf0\x8f\xbf\xbf"));
  CHECK_FALSE(is_utf8("\xf4\x90\x80\x80"));  // beyond the last
  CHECK_FALSE(is_utf8("a\xf8\x88\x80\x80\x80"));
  CHECK(is_utf8(""));
  CHECK(is_utf8("\xd1\x85\xd0\xb2 \xf4\x8f\xbf\xbf"));
}
