#include "fit/columns.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "models/catalogue/shortened.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using scenarios::InputError;

struct Unit {
  std::string_view name;
  double factor;
};
struct UnitsOf {
  Quantity quantity;
  const char* base;
  std::vector<Unit> units;
};

const UnitsOf* units_of(Quantity quantity) {
  static const std::vector<UnitsOf> all = {
      {Quantity::time_min,
       "min",
       {{"min", 1},
        {"minutes", 1},
        {"хв", 1},
        {"мин", 1},
        {"h", 60},
        {"hours", 60},
        {"hour", 60},
        {"год", 60},
        {"ч", 60},
        {"час", 60},
        {"s", 1.0 / 60},
        {"sec", 1.0 / 60},
        {"с", 1.0 / 60},
        {"сек", 1.0 / 60},
        {"d", 1440},
        {"days", 1440},
        {"діб", 1440},
        {"сут", 1440}}},
      {Quantity::moment_min,
       "min",
       {{"min", 1}, {"хв", 1}, {"мин", 1}, {"h", 60}, {"год", 60}, {"ч", 60}, {"s", 1.0 / 60}, {"d", 1440}}},
      {Quantity::length_mm,
       "mm",
       {{"mm", 1}, {"мм", 1}, {"um", 1e-3}, {"µm", 1e-3}, {"μm", 1e-3}, {"мкм", 1e-3}}},
      {Quantity::speed_m_min, "m/min", {{"m/min", 1}, {"м/хв", 1}, {"м/мин", 1}, {"m/s", 60}, {"м/с", 60}}},
      {Quantity::feed_mm_rev, "mm/rev", {{"mm/rev", 1}, {"мм/об", 1}, {"mm/r", 1}}}};
  for (const UnitsOf& one : all)
    if (one.quantity == quantity) return &one;
  return nullptr;
}

std::string headers_of(const Table& table) {
  std::string all;
  for (const Column& c : table.columns) all += (all.empty() ? "\"" : ", \"") + c.header + "\"";
  return all;
}

// How a cell would be a number: with a point, with a comma, either way, or not at all.
enum class Form { none, plain, point, comma, thousands };
Form form_of(const std::string& cell) {
  bool digits = false;
  std::size_t after = 0;
  std::size_t before = 0;
  char sign = 0;
  for (const char c : cell) {
    if (c >= '0' && c <= '9') {
      digits = true;
      (sign != 0 ? after : before) += 1;
    } else if ((c == '.' || c == ',') && sign == 0) {
      sign = c;
    } else if (c == '.' || c == ',') {
      return Form::thousands;  // 1,234.5 or 1.234.567
    } else if (c != '+' && c != '-' && c != ' ' && c != 'e' && c != 'E' && c != '\xC2' && c != '\xA0') {
      return Form::none;
    }
  }
  if (!digits) return Form::none;
  if (sign == 0) return Form::plain;
  if (sign == '.') return Form::point;
  // 1,234 could be one and a bit or a thousand and more; 0,234 could not.
  return after == 3 && before >= 1 && before <= 3 && cell.front() != '0' ? Form::thousands : Form::comma;
}

int whole(std::string_view text, std::size_t from, std::size_t length) {
  int value = -1;
  if (from + length > text.size()) return -1;
  const auto [stop, error] = std::from_chars(text.data() + from, text.data() + from + length, value);
  return error == std::errc() && stop == text.data() + from + length ? value : -1;
}

}  // namespace

ColumnChoice parse_column_choice(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    throw InputError("", fmt::format("--column {}: must be ROLE=HEADER, for instance life=Minutes", text));
  return {text.substr(0, sign), text.substr(sign + 1)};
}

std::optional<double> parse_number(std::string_view cell, char decimal) {
  std::string plain;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] == ' ') continue;
    if (cell.substr(i).starts_with("\xC2\xA0")) {
      ++i;
      continue;
    }
    if (cell.substr(i).starts_with("\xE2\x80\xAF")) {
      i += 2;
      continue;
    }
    if ((cell[i] == '.' || cell[i] == ',') && cell[i] != decimal) return std::nullopt;
    plain += cell[i] == decimal ? '.' : cell[i];
  }
  if (plain.starts_with('+')) plain.erase(0, 1);
  double value = 0;
  const auto [stop, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (error != std::errc() || stop != plain.data() + plain.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<double> parse_moment(std::string_view cell) {
  using namespace std::chrono;
  int y = -1;
  int m = -1;
  int d = -1;
  if (cell.size() < 10) return std::nullopt;
  if (cell[4] == '-' && cell[7] == '-') {
    y = whole(cell, 0, 4);
    m = whole(cell, 5, 2);
    d = whole(cell, 8, 2);
  } else if (cell[2] == '.' && cell[5] == '.') {
    d = whole(cell, 0, 2);
    m = whole(cell, 3, 2);
    y = whole(cell, 6, 4);
  }
  if (y < 1900 || m < 1 || d < 1) return std::nullopt;
  const year_month_day date{year(y), month(static_cast<unsigned>(m)), day(static_cast<unsigned>(d))};
  if (!date.ok()) return std::nullopt;
  double minutes = static_cast<double>(sys_days(date).time_since_epoch().count()) * 1440;
  std::string_view rest = cell.substr(10);
  if (rest.empty()) return minutes;
  if (rest[0] != ' ' && rest[0] != 'T') return std::nullopt;
  rest.remove_prefix(1);
  if (rest.ends_with('Z')) rest.remove_suffix(1);
  const bool short_hour = rest.size() >= 2 && rest[1] == ':';  // 9:05
  const std::size_t hour_digits = short_hour ? 1 : 2;
  const int hour = whole(rest, 0, hour_digits);
  const int minute =
      rest.size() > hour_digits && rest[hour_digits] == ':' ? whole(rest, hour_digits + 1, 2) : -1;
  if (hour < 0 || hour > 24 || minute < 0 || minute > 59) return std::nullopt;
  minutes += hour * 60 + minute;
  rest.remove_prefix(hour_digits + 3);
  if (rest.empty()) return minutes;
  const int second = rest[0] == ':' && rest.size() == 3 ? whole(rest, 1, 2) : -1;
  if (second < 0 || second > 60) return std::nullopt;
  return minutes + second / 60.0;
}

Columns::Columns(Table& table, const std::vector<Role>& roles, const std::vector<ColumnChoice>& choices,
                 const TableOptions& options)
    : table_(table) {
  const auto refuse = [&](const std::string& text) {
    throw InputError("", fmt::format("table {}: {}", table.file, text));
  };
  for (const ColumnChoice& choice : choices) {
    if (std::none_of(roles.begin(), roles.end(), [&](const Role& r) { return r.key == choice.key; })) {
      std::string known;
      for (const Role& r : roles) known += (known.empty() ? "" : ", ") + r.key;
      throw InputError("", fmt::format("--column {}={}: there is no role \"{}\"; there are {}", choice.key,
                                       choice.header, choice.key, known));
    }
  }
  for (const Role& role : roles) {
    std::vector<std::size_t> candidates;
    const auto chosen =
        std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.key == role.key; });
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const Column& column = table.columns[k];
      if (chosen != choices.end()
              ? column.header == chosen->header
              : std::find(role.names.begin(), role.names.end(), column.name) != role.names.end())
        candidates.push_back(k);
    }
    if (candidates.empty()) {
      if (chosen != choices.end())
        refuse(fmt::format("--column {}={}: there is no such header; there are {}", role.key, chosen->header,
                           headers_of(table)));
      continue;
    }
    if (candidates.size() > 1)
      refuse(fmt::format("both \"{}\" and \"{}\" could be the {}; say which with --column {}=HEADER",
                         table.columns[candidates[0]].header, table.columns[candidates[1]].header, role.key,
                         role.key));
    Found found{role, candidates[0], 1};
    const Column& column = table.columns[found.index];
    if (const UnitsOf* units = units_of(role.quantity)) {
      if (column.unit.empty()) {
        if (role.quantity != Quantity::moment_min)
          table.notes.push_back(
              fmt::format("column \"{}\" names no unit: taken as {}", column.header, units->base));
      } else {
        const auto unit = std::find_if(units->units.begin(), units->units.end(),
                                       [&](const Unit& u) { return u.name == column.unit; });
        if (unit == units->units.end())
          refuse(fmt::format("column \"{}\": the unit \"{}\" is not one of the {}; convert the column to {}",
                             column.header, column.unit, role.key, units->base));
        found.factor = unit->factor;
        if (unit->factor != 1)
          table.notes.push_back(
              fmt::format("column \"{}\" converted from {} to {}", column.header, unit->name, units->base));
      }
    }
    found_.push_back(found);
  }

  // The decimal sign, from the cells of the columns that are numbers.
  std::size_t points = 0;
  std::size_t commas = 0;
  const std::string* doubtful = nullptr;
  std::size_t doubtful_line = 0;
  for (const Found& found : found_) {
    if (found.role.quantity == Quantity::text || found.role.quantity == Quantity::moment_min) continue;
    for (const Row& row : table.rows) {
      switch (form_of(row.cells[found.index])) {
        case Form::point:
          ++points;
          break;
        case Form::comma:
          ++commas;
          break;
        case Form::thousands:
          if (doubtful == nullptr) {
            doubtful = &row.cells[found.index];
            doubtful_line = row.line;
          }
          break;
        default:
          break;
      }
    }
  }
  if (options.decimal.empty()) {
    if (points > 0 && commas > 0)
      refuse(
          fmt::format("{} numbers have a decimal point and {} a comma; say which with --decimal point or "
                      "--decimal comma (the others are then left out, with their lines)",
                      points, commas));
    if (doubtful != nullptr && commas == 0)
      refuse(
          fmt::format("line {}: \"{}\" has a comma that may be a decimal or a thousands sign; say which with "
                      "--decimal comma or --decimal point",
                      doubtful_line, *doubtful));
    table.decimal = commas > 0 ? ',' : '.';
    if (commas > 0) table.notes.push_back(fmt::format("decimal comma in {} numbers", commas));
  } else {
    table.decimal = options.decimal == "comma" ? ',' : '.';
  }

  // Rows written twice.
  std::string identity;
  for (const Found& found : found_)
    if (found.role.identifies) identity = table.columns[found.index].header;
  std::map<std::vector<std::string>, std::size_t> first_line;
  std::vector<Row> kept;
  std::vector<std::size_t> repeated;
  for (Row& row : table.rows) {
    const auto [place, fresh] = first_line.emplace(row.cells, row.line);
    if (!fresh) {
      repeated.push_back(row.line);
      if (options.duplicates == Duplicates::drop ||
          (options.duplicates == Duplicates::by_identity && !identity.empty())) {
        table.dropped.push_back({row.line, fmt::format("repeats line {}", place->second)});
        continue;
      }
    }
    kept.push_back(std::move(row));
  }
  if (!repeated.empty() && kept.size() == table.rows.size())
    table.notes.push_back(fmt::format(
        "{} rows equal an earlier one (the first is line {}) and are kept, because no column tells "
        "items apart; --duplicates drop leaves them out",
        repeated.size(), repeated.front()));
  table.rows = std::move(kept);
}

const Columns::Found* Columns::find(const std::string& key) const {
  for (const Found& found : found_)
    if (found.role.key == key) return &found;
  return nullptr;
}

std::string Columns::header(const std::string& key) const {
  const Found* found = find(key);
  return found == nullptr ? "" : table_.columns[found->index].header;
}

std::string Columns::unit(const std::string& key) const {
  const Found* found = find(key);
  return found == nullptr ? "" : table_.columns[found->index].unit;
}

void Columns::require(const std::string& key, const std::string& meaning) const {
  if (find(key) != nullptr) return;
  throw InputError(
      "", fmt::format("table {}: no column for the {} ({}); there are {}; say which with --column {}=HEADER",
                      table_.file, key, meaning, headers_of(table_), key));
}

std::string Columns::text(const Row& row, const std::string& key) const {
  const Found* found = find(key);
  return found == nullptr ? "" : row.cells[found->index];
}

std::optional<double> Columns::value(const Row& row, const std::string& key, std::string& reason) const {
  const Found* found = find(key);
  if (found == nullptr) return std::nullopt;
  const std::string& cell = row.cells[found->index];
  const std::string& head = table_.columns[found->index].header;
  if (is_missing(cell)) {
    reason =
        cell.empty() ? fmt::format("\"{}\" is empty", head) : fmt::format("\"{}\" is \"{}\"", head, cell);
    return std::nullopt;
  }
  std::optional<double> value;
  if (found->role.quantity == Quantity::moment_min) value = parse_moment(cell);
  if (!value) value = parse_number(cell, table_.decimal);
  if (!value) {
    reason = fmt::format(
        "\"{}\" is \"{}\", not a {}", head, models::shortened(cell, 60),
        found->role.quantity == Quantity::moment_min ? "time such as 2026-03-01 14:05" : "number");
    return std::nullopt;
  }
  return *value * found->factor;
}

}  // namespace verstat::fit
