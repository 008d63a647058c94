#include "fit/order_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit/columns.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using nlohmann::json;

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"arrives",
       Quantity::moment_min,
       {"arrives", "arrival", "arrived", "received", "order date", "date", "time", "надходження", "дата",
        "дата замовлення", "поступление", "дата заказа"}},
      {"quantity", Quantity::number, {"quantity", "qty", "pieces", "кількість", "штук", "количество"}},
      {"due", Quantity::moment_min, {"due", "due date", "deadline", "термін", "строк", "срок"}},
      {"part", Quantity::text, {"part", "item", "product", "деталь", "виріб", "изделие"}},
      {"order",
       Quantity::text,
       {"order", "order no", "id", "no", "№", "замовлення", "заказ", "номер"},
       true}};
  return all;
}

// A counter of minutes never gets there; a date of our times always does.
constexpr double first_date_min = 5e6;
constexpr double week_min = 10'080;
constexpr double first_monday_min = 4 * 1'440;  // 1970-01-05

json orders_of(const std::filesystem::path& file, const std::string& part, const std::string& pointer) {
  Table table = read_table(file.string(), TableOptions());
  const Columns columns(table, roles(), {}, TableOptions());
  columns.require("arrives", "when the order comes, 2026-03-02 14:05, or minutes");
  const auto refuse = [&](const Row& row, const std::string& text) {
    throw scenarios::InputError(pointer,
                                fmt::format("{}: {}, line {}: {}", pointer, file.string(), row.line, text));
  };
  struct Line {
    double arrives_min;
    double quantity;
    std::optional<double> due_min;
  };
  std::vector<Line> lines;
  for (const DroppedRow& dropped : table.dropped)
    throw scenarios::InputError(
        pointer, fmt::format("{}: {}, line {}: {}", pointer, file.string(), dropped.line, dropped.reason));
  for (const Row& row : table.rows) {
    if (columns.has("part") && columns.text(row, "part") != part) continue;
    std::string reason;
    Line line{};
    const auto arrives = columns.value(row, "arrives", reason);
    if (!arrives) refuse(row, reason);
    line.arrives_min = *arrives;
    line.quantity = 1;
    if (columns.has("quantity")) {
      const auto quantity = columns.value(row, "quantity", reason);
      if (!quantity) refuse(row, reason);
      if (!(*quantity >= 1) || *quantity > 1e6 || *quantity != std::floor(*quantity))
        refuse(row, fmt::format("quantity {}, must be a whole number from 1 to 1000000", *quantity));
      line.quantity = *quantity;
    }
    if (columns.has("due") && !is_missing(columns.text(row, "due"))) {
      line.due_min = columns.value(row, "due", reason);
      if (!line.due_min) refuse(row, reason);
    }
    lines.push_back(line);
  }
  if (lines.empty())
    throw scenarios::InputError(pointer,
                                fmt::format("{}: {} has no orders for \"{}\"", pointer, file.string(), part));
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return a.arrives_min < b.arrives_min; });
  const double first = lines.front().arrives_min;
  const double start_min =
      first < first_date_min
          ? 0
          : first_monday_min + week_min * std::floor((first - first_monday_min) / week_min);
  json orders = json::array();
  for (const Line& line : lines) {
    json order = {{"arrives_min", line.arrives_min - start_min},
                  {"quantity", static_cast<std::int64_t>(line.quantity)}};
    if (line.due_min) order["due_min"] = std::max(0.0, *line.due_min - start_min);
    orders.push_back(std::move(order));
  }
  return orders;
}

}  // namespace

std::string with_order_files(const std::string& text, const std::filesystem::path& folder) {
  if (text.find("\"orders\"") == std::string::npos) return text;
  json scenario = scenarios::parse_json(text);
  if (!scenario.is_object() || !scenario.contains("parts") || !scenario["parts"].is_array()) return text;
  bool any = false;
  for (std::size_t p = 0; p < scenario["parts"].size(); ++p) {
    json& part = scenario["parts"][p];
    if (!part.is_object() || !part.contains("supply") || !part["supply"].is_object()) continue;
    json& supply = part["supply"];
    if (supply.value("kind", json()) != "orders" || !supply.contains("file") || !supply["file"].is_string())
      continue;
    if (supply.contains("orders")) continue;  // the loader says that it is one or the other
    const std::string pointer = fmt::format("/parts/{}/supply/file", p);
    const json name = part.value("name", json());
    supply["orders"] = orders_of(folder / supply["file"].get<std::string>(),
                                 name.is_string() ? name.get<std::string>() : "", pointer);
    supply.erase("file");
    any = true;
  }
  return any ? scenario.dump(2) : text;
}

}  // namespace verstat::fit
