#include "fit/csv_table.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "fit/workbook.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using scenarios::InputError;

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
  throw InputError("", fmt::format("table {}: {}", file, text));
}

// First byte that cannot belong to UTF-8 (RFC 3629), or none.
std::optional<std::size_t> bad_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    std::size_t more = 0;
    if (byte < 0x80) {
    } else if (byte >= 0xC2 && byte < 0xE0) {
      more = 1;
    } else if (byte >= 0xE0 && byte < 0xF0) {
      more = 2;
    } else if (byte >= 0xF0 && byte < 0xF5) {
      more = 3;
    } else {
      return i;
    }
    for (std::size_t k = 1; k <= more; ++k)
      if (i + k >= text.size() || (static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) return i;
    i += more + 1;
  }
  return std::nullopt;
}

void append_utf8(std::string& to, unsigned code) {
  if (code < 0x80) {
    to += static_cast<char>(code);
  } else if (code < 0x800) {
    to += static_cast<char>(0xC0U | (code >> 6U));
    to += static_cast<char>(0x80U | (code & 0x3FU));
  } else {
    to += static_cast<char>(0xE0U | (code >> 12U));
    to += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
    to += static_cast<char>(0x80U | (code & 0x3FU));
  }
}

// Windows-1251 above 0x7F: the letters are in one block, the rest as Unicode's table CP1251.TXT lists them.
std::string from_cp1251(std::string_view bytes) {
  static constexpr std::array<unsigned, 64> head = {
      0x402, 0x403,  0x201A, 0x453, 0x201E, 0x2026, 0x2020, 0x2021, 0x20AC, 0x2030, 0x409,  0x2039, 0x40A,
      0x40C, 0x40B,  0x40F,  0x452, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0xFFFD, 0x2122,
      0x459, 0x203A, 0x45A,  0x45C, 0x45B,  0x45F,  0xA0,   0x40E,  0x45E,  0x408,  0xA4,   0x490,  0xA6,
      0xA7,  0x401,  0xA9,   0x404, 0xAB,   0xAC,   0xAD,   0xAE,   0x407,  0xB0,   0xB1,   0x406,  0x456,
      0x491, 0xB5,   0xB6,   0xB7,  0x451,  0x2116, 0x454,  0xBB,   0x458,  0x405,  0x455,  0x457};
  std::string text;
  text.reserve(bytes.size() * 2);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
      text += c;
    else if (byte < 0xC0)
      append_utf8(text, head[byte - 0x80U]);
    else
      append_utf8(text, 0x410U + (byte - 0xC0U));
  }
  return text;
}

std::string_view trim(std::string_view text) {
  const auto strip = [&](std::string_view what) {
    while (text.starts_with(what)) text.remove_prefix(what.size());
    while (text.ends_with(what)) text.remove_suffix(what.size());
  };
  for (std::size_t before = text.size() + 1; text.size() < before;) {
    before = text.size();
    for (const std::string_view blank : {" ", "\t", "\r", "\n", "\xC2\xA0", "\xE2\x80\xAF"}) strip(blank);
  }
  return text;
}

struct Record {
  std::size_t line = 0;
  std::vector<std::string> cells;
};

// Records of RFC 4180: a quoted cell may hold separators, line ends and doubled quotes.
std::vector<Record> split_records(const std::string& file, std::string_view text, char separator) {
  std::vector<Record> records;
  std::size_t line = 1;
  std::size_t i = 0;
  while (i < text.size()) {
    Record record{.line = line};
    bool more = true;
    while (more) {
      std::string cell;
      std::size_t start = i;
      while (start < text.size() && text[start] == ' ') ++start;
      if (start < text.size() && text[start] == '"') {
        i = start + 1;
        for (;;) {
          if (i >= text.size())
            refuse(file, fmt::format("line {}: a quoted cell that opens here is never closed", record.line));
          if (text[i] == '"') {
            if (i + 1 < text.size() && text[i + 1] == '"') {
              cell += '"';
              i += 2;
              continue;
            }
            ++i;
            break;
          }
          if (text[i] == '\n') ++line;
          cell += text[i++];
        }
      }
      while (i < text.size() && text[i] != separator && text[i] != '\n' && text[i] != '\r') cell += text[i++];
      record.cells.emplace_back(trim(cell));
      more = i < text.size() && text[i] == separator;
      if (more) ++i;
    }
    if (i < text.size() && text[i] == '\r') ++i;
    if (i < text.size() && text[i] == '\n') ++i;
    ++line;
    records.push_back(std::move(record));
  }
  return records;
}

bool blank(const Record& record) {
  return std::all_of(record.cells.begin(), record.cells.end(), [](const auto& c) { return c.empty(); });
}

char found_separator(std::string_view header) {
  bool quoted = false;
  bool semicolon = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\t') return '\t';
    if (c == ';') semicolon = true;
  }
  return semicolon ? ';' : ',';
}

const char* name_of_separator(char separator) {
  return separator == '\t' ? "tab" : separator == ';' ? "semicolon" : "comma";
}

// "Час різання, хв" and "VB [mm]" and "time_min" carry their unit; "V (m/min)" too.
Column column_of(const std::string& header) {
  Column column{.header = header};
  std::string text = lower_case(header);
  const auto cut = [&](std::size_t from, std::size_t to) {
    column.unit = std::string(trim(std::string_view(text).substr(from + 1, to - from - 1)));
    text.resize(from);
  };
  const auto open = text.find_last_of("([");
  const auto close = text.find_last_of(")]");
  if (open != std::string::npos && close != std::string::npos && open < close)
    cut(open, close);
  else if (const auto comma = text.rfind(','); comma != std::string::npos)
    cut(comma, text.size());
  std::string name(trim(text));
  if (column.unit.empty()) {
    // The unit of a name in the manner of Verstat's own files: cutting_speed_m_min.
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 16> suffixes = {
        {{"_m_min", "m/min"},
         {"_m_s", "m/s"},
         {"_mm_rev", "mm/rev"},
         {"_mm_min", "mm/min"},
         {"_minutes", "min"},
         {"_hours", "h"},
         {"_min", "min"},
         {"_sec", "s"},
         {"_mm", "mm"},
         {"_um", "um"},
         {"_deg", "deg"},
         {"_h", "h"},
         {"_s", "s"},
         {" min", "min"},
         {" хв", "хв"},
         {" мин", "мин"}}};
    for (const auto& [suffix, unit] : suffixes)
      if (name.size() > suffix.size() && name.ends_with(suffix)) {
        column.unit = unit;
        name.resize(name.size() - suffix.size());
        break;
      }
  }
  for (char& c : name)
    if (c == '_' || c == '-' || c == '\n') c = ' ';
  column.name = std::string(trim(name));
  return column;
}

}  // namespace

std::string lower_case(std::string_view utf8) {
  std::string result;
  result.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) {
      result += static_cast<char>(byte >= 'A' && byte <= 'Z' ? byte + 32 : byte);
    } else if ((byte == 0xD0 || byte == 0xD2) && i + 1 < utf8.size()) {
      const auto next = static_cast<unsigned char>(utf8[i + 1]);
      unsigned code = ((byte & 0x1FU) << 6U) | (next & 0x3FU);
      if (code >= 0x410 && code < 0x430)
        code += 32;  // А..Я
      else if (code >= 0x400 && code < 0x410)
        code += 80;  // Ё Є І Ї
      else if (code == 0x490)
        code = 0x491;  // Ґ
      append_utf8(result, code);
      ++i;
    } else {
      result += utf8[i];
    }
  }
  return result;
}

bool is_missing(std::string_view cell) {
  static constexpr std::array<std::string_view, 21> ways = {
      "",    "-",   "--",   "—",    "–",           "no data",    "nodata", "n/a", "na", "#n/a", "#н/д",
      "н/д", "nan", "null", "none", "немає даних", "нет данных", "немає",  "нет", "?",  "."};
  const std::string text = lower_case(trim(cell));
  return std::find(ways.begin(), ways.end(), text) != ways.end();
}

Table parse_table(std::string file, std::string_view bytes, const TableOptions& options) {
  Table table;
  table.file = std::move(file);
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0"))
    refuse(
        table.file,
        "is a workbook, not a CSV table; save it as xlsx under a name that ends so (Debian package xlsx2csv "
        "reads it then), or the sheet as \"CSV UTF-8\"");
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    refuse(table.file, "is UTF-16; save it as \"CSV UTF-8\", or convert it: iconv -f UTF-16 -t UTF-8");
  std::string text;
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    bytes.remove_prefix(3);
    table.notes.emplace_back("byte-order mark skipped");
  }
  const auto bad = bad_utf8(bytes);
  if (options.encoding == "cp1251") {
    text = from_cp1251(bytes);
  } else if (!bad) {
    text = std::string(bytes);
  } else if (options.encoding.empty()) {
    text = from_cp1251(bytes);
    table.notes.push_back(fmt::format(
        "not UTF-8 (byte {} of the file): read as Windows-1251; --encoding says otherwise", *bad + 1));
  } else {
    refuse(table.file, fmt::format("byte {} is not UTF-8; --encoding cp1251 reads Windows-1251", *bad + 1));
  }
  if (text.find('\0') != std::string::npos) refuse(table.file, "holds binary zeros: not a CSV table");

  std::size_t start = 0;
  while (start < text.size()) {
    const auto end = std::min(text.find('\n', start), text.size());
    if (!trim(std::string_view(text).substr(start, end - start)).empty()) break;
    start = end + 1;
  }
  if (start >= text.size()) refuse(table.file, "is empty; the first line must name the columns");
  const std::string_view header = std::string_view(text).substr(start, text.find('\n', start) - start);
  char separator = found_separator(header);
  if (options.separator == "comma") separator = ',';
  if (options.separator == "semicolon") separator = ';';
  if (options.separator == "tab") separator = '\t';

  const std::vector<Record> records = split_records(table.file, text, separator);
  std::size_t k = 0;
  while (k < records.size() && blank(records[k])) ++k;
  if (k == records.size()) refuse(table.file, "has no header; the first line must name the columns");
  for (const std::string& cell : records[k].cells) table.columns.push_back(column_of(cell));
  // Spreadsheets leave empty columns at the right.
  while (table.columns.size() > 1 && table.columns.back().header.empty()) table.columns.pop_back();
  table.notes.push_back(
      fmt::format("{} columns, separated by {}", table.columns.size(), name_of_separator(separator)));
  for (++k; k < records.size(); ++k) {
    const Record& record = records[k];
    if (blank(record)) continue;
    ++table.rows_in_file;
    const auto width = table.columns.size();
    const bool over =
        std::any_of(record.cells.begin() + static_cast<std::ptrdiff_t>(std::min(width, record.cells.size())),
                    record.cells.end(), [](const auto& c) { return !c.empty(); });
    if (record.cells.size() < width || over) {
      table.dropped.push_back(
          {record.line, fmt::format("has {} cells, the header has {}", record.cells.size(), width)});
      continue;
    }
    Row row{record.line, record.cells};
    row.cells.resize(width);
    if (std::equal(row.cells.begin(), row.cells.end(), table.columns.begin(),
                   [](const std::string& cell, const Column& c) { return cell == c.header; })) {
      table.dropped.push_back({record.line, "repeats the header"});
      continue;
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table read_table(const std::string& path, const TableOptions& options) {
  const auto one_of = [](const char* flag, const std::string& given,
                         std::initializer_list<const char*> known) {
    if (given.empty()) return;
    std::string all;
    for (const char* one : known) {
      if (given == one) return;
      all += all.empty() ? one : std::string(", ") + one;
    }
    throw InputError("", fmt::format("{} {}: must be one of {}", flag, given, all));
  };
  one_of("--encoding", options.encoding, {"utf-8", "cp1251"});
  one_of("--separator", options.separator, {"comma", "semicolon", "tab"});
  one_of("--decimal", options.decimal, {"point", "comma"});
  std::string text;
  try {
    text = scenarios::read_text_file(path);
  } catch (const InputError& e) {
    refuse(path, e.what());
  }
  // A table that only calls itself a workbook is read as what it is.
  const bool workbook = is_workbook_name(path) && text.starts_with("PK\x03\x04");
  if (!options.sheet.empty() && !workbook)
    throw InputError("", fmt::format("--sheet {}: {} is no xlsx workbook", options.sheet, path));
  if (!workbook) return parse_table(path, text, options);
  TableOptions converted = options;
  if (converted.separator.empty()) converted.separator = "semicolon";
  Table table = parse_table(path, workbook_as_table(path, options.sheet), converted);
  table.notes.insert(table.notes.begin(),
                     fmt::format("{} of the workbook, converted by xlsx2csv",
                                 options.sheet.empty() ? "first sheet" : "sheet \"" + options.sheet + "\""));
  return table;
}

}  // namespace verstat::fit
