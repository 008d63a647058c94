#include "fit/removal_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"life", Quantity::time_min, {"minutes",   "cutting time",     "cutting minutes",  "time",
                                    "life",      "tool life",        "edge life",        "min",
                                    "стійкість", "час різання",      "час роботи",       "час",
                                    "хвилини",   "напрацювання",     "наробіток",        "стойкость",
                                    "время",     "время резания",    "время работы",     "минуты",
                                    "наработка", "стійкість кромки", "стойкость кромки", "наробіток кромки"}},
      {"parts",
       Quantity::number,
       {"parts", "part count", "pieces", "деталі", "деталей", "кількість деталей", "детали",
        "количество деталей"}},
      {"last_good",
       Quantity::time_min,
       {"last good", "last ok", "last inspection", "last inspected", "остання перевірка", "останній огляд",
        "справна на", "последняя проверка", "последний осмотр"}},
      {"cause",
       Quantity::text,
       {"cause", "reason", "removal cause", "причина", "причина зняття", "причина заміни", "причина снятия",
        "причина замены"}},
      {"tool",
       Quantity::text,
       {"tool", "insert", "cutter", "інструмент", "пластина", "різець", "фреза", "свердло", "инструмент",
        "резец", "сверло"}},
      {"regime", Quantity::text, {"regime", "режим", "cutting regime", "режим різання", "режим резания"}},
      {"batch", Quantity::text, {"batch", "lot", "партія", "партия"}},
      {"edge",
       Quantity::text,
       {"edge", "edge id", "edge no", "id", "no", "record", "кромка", "грань", "№", "номер", "вершина",
        "лезо", "лезвие", "різальна кромка", "режущая кромка", "номер кромки", "№ кромки"},
       true}};
  return all;
}

struct CauseWord {
  std::string_view word;
  std::string_view cause;  ///< empty: planned
};
constexpr std::array<CauseWord, 58> cause_words = {{{"planned", ""},          {"plan", ""},
                                                    {"scheduled", ""},        {"preventive", ""},
                                                    {"still running", ""},    {"running", ""},
                                                    {"in use", ""},           {"good", ""},
                                                    {"censored", ""},         {"планова", ""},
                                                    {"планово", ""},          {"за планом", ""},
                                                    {"за графіком", ""},      {"план", ""},
                                                    {"ще працює", ""},        {"в роботі", ""},
                                                    {"справна", ""},          {"плановая", ""},
                                                    {"по плану", ""},         {"по графику", ""},
                                                    {"в работе", ""},         {"worn", "worn"},
                                                    {"wear", "worn"},         {"зношення", "worn"},
                                                    {"зношена", "worn"},      {"знос", "worn"},
                                                    {"спрацювання", "worn"},  {"износ", "worn"},
                                                    {"chipped", "chipped"},   {"chip", "chipped"},
                                                    {"chipping", "chipped"},  {"викришування", "chipped"},
                                                    {"викришена", "chipped"}, {"сколювання", "chipped"},
                                                    {"скол", "chipped"},      {"выкрашивание", "chipped"},
                                                    {"broken", "broken"},     {"break", "broken"},
                                                    {"breakage", "broken"},   {"fracture", "broken"},
                                                    {"поломка", "broken"},    {"зламана", "broken"},
                                                    {"злам", "broken"},       {"руйнування", "broken"},
                                                    {"разрушение", "broken"}, {"size", "size"},
                                                    {"dimension", "size"},    {"розмір", "size"},
                                                    {"размер", "size"},       {"finish", "finish"},
                                                    {"surface", "finish"},    {"roughness", "finish"},
                                                    {"шорсткість", "finish"}, {"шероховатость", "finish"},
                                                    {"failed", "failed"},     {"failure", "failed"},
                                                    {"відмова", "failed"},    {"отказ", "failed"}}};

std::size_t index_of(std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

}  // namespace

RemovalLog read_removals(const std::string& path, const RemovalOptions& options) {
  RemovalLog log;
  log.table = read_table(path, options.table);
  Table& table = log.table;
  const Columns columns(table, roles(), options.columns, options.table);
  columns.require("cause", "why the edge was taken out: planned, worn, chipped, broken, size, finish");
  const bool in_parts = !columns.has("life");
  if (in_parts && !columns.has("parts"))
    columns.require("life", "minutes the edge cut, or \"parts\" for whole parts");
  if (in_parts) {
    log.unit = "parts";
    table.notes.emplace_back(
        "lives are counted in whole parts: a failure in part n lies between n - 1 and n parts");
  } else if (columns.has("parts")) {
    table.notes.push_back(fmt::format("column \"{}\" is not used: \"{}\" gives the lives",
                                      columns.header("parts"), columns.header("life")));
  }

  const auto drop = [&](const Row& row, std::string reason) {
    table.dropped.push_back({row.line, std::move(reason)});
  };
  const auto among = [](const std::vector<std::string>& words, const std::string& word) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& w) { return lower_case(w) == word; });
  };
  std::size_t elsewhere = 0;
  for (const Row& row : table.rows) {
    const std::string tool = columns.text(row, "tool");
    const std::string regime = columns.text(row, "regime");
    if ((!options.tool.empty() && tool != options.tool) ||
        (!options.regime.empty() && regime != options.regime)) {
      ++elsewhere;
      continue;
    }
    std::string reason;
    const auto life = columns.value(row, in_parts ? "parts" : "life", reason);
    if (!life) {
      drop(row, reason);
      continue;
    }
    const std::string written = columns.text(row, "cause");
    const std::string word = lower_case(written);
    Observation o{.line = row.line};
    bool planned = among(options.planned_causes, word);
    if (!planned && among(options.failure_causes, word)) {
      o.cause = static_cast<int>(index_of(log.causes, word));
    } else if (!planned) {
      if (is_missing(written)) {
        drop(row, fmt::format("\"{}\" is empty: planned or a failure is not known", columns.header("cause")));
        continue;
      }
      const auto known =
          std::find_if(cause_words.begin(), cause_words.end(), [&](const auto& w) { return w.word == word; });
      if (known == cause_words.end()) {
        drop(row, fmt::format(
                      "cause \"{}\" is not known; --failure-cause or --planned-cause \"{}\" says what it is",
                      written, written));
        continue;
      }
      planned = known->cause.empty();
      if (!planned) o.cause = static_cast<int>(index_of(log.causes, std::string(known->cause)));
    }
    if (!(*life > 0) && !(in_parts && *life == 0 && planned)) {
      drop(row, fmt::format("life {} is not above 0", *life));
      continue;
    }
    if (in_parts && *life != std::floor(*life)) {
      drop(row, fmt::format("{} parts is not a whole number", *life));
      continue;
    }
    o.low = o.high = *life;
    if (planned) {
      if (*life == 0) {
        drop(row, "taken out before its first part: tells nothing");
        continue;
      }
      o.high = std::numeric_limits<double>::infinity();
    } else if (in_parts) {
      o.low = *life - 1;
    } else if (columns.has("last_good") && !columns.text(row, "last_good").empty()) {
      const auto last_good = columns.value(row, "last_good", reason);
      if (!last_good) {
        drop(row, reason);
        continue;
      }
      if (!(*last_good >= 0) || !(*last_good <= *life)) {
        drop(row, fmt::format("last good at {}, taken out at {}: the wrong way round", *last_good, *life));
        continue;
      }
      o.low = *last_good;
    }
    std::string batch = columns.text(row, "batch");
    if (columns.has("batch") && is_missing(batch)) {
      drop(row, fmt::format("\"{}\" is empty", columns.header("batch")));
      continue;
    }
    o.batch = index_of(log.batches, batch);
    auto group = std::find_if(log.groups.begin(), log.groups.end(),
                              [&](const RemovalGroup& g) { return g.tool == tool && g.regime == regime; });
    if (group == log.groups.end()) group = log.groups.insert(log.groups.end(), {tool, regime, {}});
    group->lives.push_back(o);
    ++log.rows_used;
  }
  if (elsewhere > 0) table.notes.push_back(fmt::format("{} rows are of another tool or regime", elsewhere));
  if (log.groups.empty()) {
    std::string first;
    if (!table.dropped.empty())
      first = fmt::format("; line {}: {}", table.dropped.front().line, table.dropped.front().reason);
    throw scenarios::InputError(
        "", fmt::format("table {}: no row of {} can be used{}", path, table.rows_in_file, first));
  }
  return log;
}

}  // namespace verstat::fit
