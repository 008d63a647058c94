#include "store/text_search.h"

#include <cstddef>

namespace verstat::store {

bool is_utf8(std::string_view text) {
  for (std::size_t k = 0; k < text.size();) {
    const auto lead = static_cast<unsigned char>(text[k]);
    std::size_t more = 0;
    unsigned code = 0;
    if (lead < 0x80) {
      if (lead == 0) return false;  // SQLite's texts end there
      ++k;
      continue;
    }
    if (lead >= 0xC2 && lead <= 0xDF) {
      more = 1;
      code = lead & 0x1FU;
    } else if (lead >= 0xE0 && lead <= 0xEF) {
      more = 2;
      code = lead & 0x0FU;
    } else if (lead >= 0xF0 && lead <= 0xF4) {
      more = 3;
      code = lead & 0x07U;
    } else {
      return false;
    }
    if (text.size() - k <= more) return false;
    for (std::size_t j = 1; j <= more; ++j) {
      const auto next = static_cast<unsigned char>(text[k + j]);
      if ((next & 0xC0U) != 0x80U) return false;
      code = (code << 6U) | (next & 0x3FU);
    }
    const bool overlong = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
    if (overlong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return false;
    k += more + 1;
  }
  return true;
}

std::string folded(std::string_view text) {
  std::string all(text);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto c = static_cast<unsigned char>(all[k]);
    if (c >= 'A' && c <= 'Z') {
      all[k] = static_cast<char>(c + 32);
      continue;
    }
    if (k + 1 >= all.size()) continue;
    const auto next = static_cast<unsigned char>(all[k + 1]);
    if (c == 0xD0 && next >= 0x80 && next <= 0xBF) {
      const unsigned code = 0x400U + (next & 0x3FU);
      unsigned lower = code;
      if (code <= 0x40F) lower = code + 80;                   // Ѐ to Џ
      if (code >= 0x410 && code <= 0x42F) lower = code + 32;  // А to Я
      all[k] = static_cast<char>(0xC0U | (lower >> 6U));
      all[k + 1] = static_cast<char>(0x80U | (lower & 0x3FU));
      ++k;
    } else if (c == 0xD2 && next == 0x90) {  // Ґ
      all[k + 1] = static_cast<char>(0x91);
      ++k;
    }
  }
  return all;
}

}  // namespace verstat::store
