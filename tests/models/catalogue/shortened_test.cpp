// Texts of strangers in error messages: what is cut must still be UTF-8.
#include "models/catalogue/shortened.h"

#include <string>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/catalogue/value.h"
#include "tests/property.h"

using verstat::models::shortened;
using verstat::models::Value;

namespace {

bool begins_a_character(const std::string& text, std::size_t byte) {
  return byte == text.size() || (static_cast<unsigned char>(text[byte]) & 0xC0U) != 0x80U;
}

}  // namespace

TEST_CASE("a text is cut between characters", "[catalogue]") {
  CHECK(shortened("feed", 4) == "feed");
  CHECK(shortened("feed", 3) == "fee");
  CHECK(shortened("feed", 0).empty());
  CHECK(shortened("\xd1\x85\xd0\xb2", 3) == "\xd1\x85");                 // two letters of two bytes
  CHECK(shortened("a\xe2\x82\xac", 3) == "a");                           // one of three
  CHECK(shortened("\xf0\x9f\x94\xa7 wrench", 4) == "\xf0\x9f\x94\xa7");  // one of four
  verstat::test::property("as long as may be, whatever the letters", [] {
    static const std::string letters[] = {"a", "\xd1\x85", "\xe2\x82\xac", "\xf0\x9f\x94\xa7"};
    std::string text;
    for (const auto k : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4)))
      text += letters[static_cast<std::size_t>(k)];
    const auto bytes = static_cast<std::size_t>(*rc::gen::inRange(0, 60));
    const std::string head(shortened(text, bytes));
    RC_ASSERT(text.starts_with(head));
    RC_ASSERT(begins_a_character(text, head.size()));
    std::size_t next = head.size() + 1;
    while (next < text.size() && !begins_a_character(text, next)) ++next;
    const bool whole = head.size() == text.size();
    RC_ASSERT(head.size() <= bytes);
    RC_ASSERT(whole || next > bytes);
  });
}

TEST_CASE("a long value in a message ends with a whole letter", "[catalogue]") {
  for (std::size_t k = 0; k < 4; ++k) {
    std::string text(k, 'a');
    for (int i = 0; i < 200; ++i) text += "\xd1\x85";
    const std::string shown = Value(text).to_string();
    REQUIRE(shown.ends_with("..."));
    CHECK(begins_a_character(shown, shown.size() - 3));
    CHECK((shown.size() - k) % 2 ==
          0);  // the quotation mark, k letters of one byte, whole ones of two, three dots
  }
}
