#include "fit/downtime_log.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"start",
       Quantity::moment_min,
       {"start", "begin", "from", "stopped", "down since", "початок", "початок простою", "начало",
        "начало простоя"}},
      {"end",
       Quantity::moment_min,
       {"end", "finish", "to", "restarted", "up again", "кінець", "кінець простою", "конец", "окончание",
        "конец простоя"}},
      {"duration",
       Quantity::time_min,
       {"duration", "downtime", "stop", "repair", "repair time", "тривалість", "простій", "час ремонту",
        "длительность", "простой", "время ремонта"}},
      {"machine",
       Quantity::text,
       {"machine", "asset", "equipment", "верстат", "обладнання", "станок", "оборудование"}},
      {"mode",
       Quantity::text,
       {"mode", "failure mode", "cause", "reason", "fault", "причина", "вид відмови", "відмова", "вид отказа",
        "отказ"}},
      {"operating",
       Quantity::time_min,
       {"operating", "operating time", "operating hours", "running hours", "running time", "напрацювання",
        "мотогодини", "наработка", "моточасы"}},
      {"cutting", Quantity::time_min, {"cutting", "cutting time", "час різання", "время резания"}},
      {"record", Quantity::text, {"record", "id", "no", "№", "номер"}, true}};
  return all;
}

struct Stop {
  std::size_t line = 0;
  std::string mode;
  double start = 0, end = 0;
  std::optional<double> operating, cutting;
};

double moment_option(const char* flag, const std::string& text) {
  const auto moment = parse_moment(text);
  if (!moment)
    throw scenarios::InputError(
        "", fmt::format("{} {}: must be a time such as 2026-03-01 or \"2026-03-01 06:00\"", flag, text));
  return *moment;
}

}  // namespace

const char* name_of(Clock clock) {
  return clock == Clock::calendar ? "calendar" : clock == Clock::operating ? "operating" : "cutting";
}

DowntimeLog read_downtime(const std::string& path, const DowntimeOptions& options) {
  DowntimeLog log;
  log.table = read_table(path, options.table);
  Table& table = log.table;
  const Columns columns(table, roles(), options.columns, options.table);
  columns.require("start", "when the machine stopped, 2026-03-01 14:05, or minutes of a counter");
  if (!columns.has("end")) columns.require("duration", "how long it stood, or \"end\", when it ran again");
  std::map<std::string, std::vector<Stop>> stops;
  for (const Row& row : table.rows) {
    Stop stop{.line = row.line, .mode = columns.text(row, "mode")};
    std::string reason;
    const auto drop = [&] { table.dropped.push_back({row.line, reason}); };
    const auto start = columns.value(row, "start", reason);
    if (!start) {
      drop();
      continue;
    }
    stop.start = *start;
    if (columns.has("end")) {
      const auto end = columns.value(row, "end", reason);
      if (!end) {
        drop();
        continue;
      }
      stop.end = *end;
    } else {
      const auto duration = columns.value(row, "duration", reason);
      if (!duration) {
        drop();
        continue;
      }
      stop.end = stop.start + *duration;
    }
    if (!(stop.end > stop.start)) {
      reason = fmt::format("the stop ends {} min after it starts: must be above 0", stop.end - stop.start);
      drop();
      continue;
    }
    if (columns.has("mode") && is_missing(stop.mode)) {
      reason = fmt::format("\"{}\" is empty", columns.header("mode"));
      drop();
      continue;
    }
    bool counters = true;
    for (const char* key : {"operating", "cutting"}) {
      if (!columns.has(key)) continue;
      const auto value = columns.value(row, key, reason);
      if (!value) {
        counters = false;
        break;
      }
      (std::string_view(key) == "operating" ? stop.operating : stop.cutting) = value;
    }
    if (!counters) {
      drop();
      continue;
    }
    stops[columns.text(row, "machine")].push_back(std::move(stop));
  }

  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (auto& [machine, list] : stops) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Stop& a, const Stop& b) { return a.start < b.start; });
    std::vector<Stop> kept;
    for (const Stop& stop : list) {
      if (!kept.empty() && stop.start < kept.back().end) {
        table.dropped.push_back(
            {stop.line, fmt::format("starts before the stop of line {} has ended", kept.back().line)});
        continue;
      }
      const auto back = [&](const std::optional<double>& now, const std::optional<double>& before) {
        return now && before && *now < *before;
      };
      if (!kept.empty() &&
          (back(stop.operating, kept.back().operating) || back(stop.cutting, kept.back().cutting))) {
        table.dropped.push_back(
            {stop.line, fmt::format("a counter runs backwards after line {}", kept.back().line)});
        continue;
      }
      kept.push_back(stop);
      first = std::min(first, stop.start);
      last = std::max(last, stop.end);
    }
    list = std::move(kept);
    log.machines.push_back(machine);
    log.rows_used += list.size();
  }
  if (log.rows_used == 0) {
    std::string why;
    if (!table.dropped.empty())
      why = fmt::format("; line {}: {}", table.dropped.front().line, table.dropped.front().reason);
    throw scenarios::InputError(
        "", fmt::format("table {}: no row of {} can be used{}", path, table.rows_in_file, why));
  }
  log.from_min = options.from.empty() ? first : moment_option("--from", options.from);
  log.to_min = options.to.empty() ? last : moment_option("--to-time", options.to);
  if (log.from_min > first || log.to_min < last)
    throw scenarios::InputError(
        "", fmt::format("table {}: the log has stops before --from or after --to-time", path));
  if (options.from.empty() || options.to.empty())
    table.notes.emplace_back(
        "watching is taken from the first stop to the end of the last one where --from and --to-time do not "
        "say it: "
        "stopless time before and after is lost");

  std::vector<std::string> modes;
  for (const auto& [machine, list] : stops)
    for (const Stop& stop : list)
      if (std::find(modes.begin(), modes.end(), stop.mode) == modes.end()) modes.push_back(stop.mode);
  std::sort(modes.begin(), modes.end());
  std::vector<Clock> clocks = {Clock::calendar, Clock::operating};
  if (columns.has("cutting")) clocks.push_back(Clock::cutting);
  if (!columns.has("operating"))
    table.notes.emplace_back(
        options.calendar.always()
            ? "no counter of operating time: the operating clock is the calendar without the recorded stops; "
              "--hours and --weekdays tell when the shop works"
            : "no counter of operating time: the operating clock is working time without the recorded stops");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const std::string& mode : modes) {
    ModeRepairs repairs{.mode = mode};
    for (const Clock clock : clocks) {
      ModeTimes times{.mode = mode, .clock = clock};
      for (const auto& [machine, list] : stops) {
        double stood = 0;  // recorded stops so far, in working time
        const auto worked = [&](double from, double to) {
          return options.calendar.worked_min(to) - options.calendar.worked_min(from);
        };
        std::optional<double> age_from;
        if (options.new_at_start) age_from = 0;
        EventSeries series;
        const Stop& opening = list.front();
        // A counter's zero is not the start of watching: it is set at the first stop.
        const auto at_stop = [&](const Stop& stop) {
          if (clock == Clock::calendar) return stop.start - log.from_min;
          if (clock == Clock::cutting) return *stop.cutting - *opening.cutting;
          return stop.operating ? *stop.operating - *opening.operating
                                : worked(log.from_min, stop.start) - stood;
        };
        const bool counter = clock == Clock::cutting || (clock == Clock::operating && opening.operating);
        double now = 0;
        for (const Stop& stop : list) {
          now = at_stop(stop);
          const bool mine = stop.mode == mode;
          if (mine) {
            if (age_from && now > *age_from) {
              Observation o = exact_life(now - *age_from);
              o.line = stop.line;
              times.between.push_back(o);
            }
            if (now > 0) series.times.push_back(now);
          }
          stood += worked(stop.start, stop.end);
          if (mine) age_from = clock == Clock::calendar ? stop.end - log.from_min : now;
          if (mine && clock == Clock::calendar) repairs.repairs.push_back(exact_life(stop.end - stop.start));
        }
        // A counter is known at stops only; the other clocks run to the end of watching.
        series.end = counter                     ? now
                     : clock == Clock::operating ? worked(log.from_min, log.to_min) - stood
                                                 : log.to_min - log.from_min;
        if (age_from && series.end > *age_from)
          times.between.push_back({.low = series.end - *age_from, .high = infinity});
        times.series.push_back(std::move(series));
      }
      log.times.push_back(std::move(times));
    }
    log.repairs.push_back(std::move(repairs));
  }
  return log;
}

}  // namespace verstat::fit
