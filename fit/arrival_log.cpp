#include "fit/arrival_log.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"arrival",
       Quantity::moment_min,
       {"arrival", "arrived", "time", "date", "moment", "received", "order date", "надходження", "дата",
        "час", "дата замовлення", "поступление", "время", "дата заказа"}},
      {"quantity",
       Quantity::number,
       {"quantity", "qty", "pieces", "lot", "кількість", "штук", "количество", "партія"}},
      {"part", Quantity::text, {"part", "item", "product", "деталь", "виріб", "изделие"}},
      {"order",
       Quantity::text,
       {"order", "order no", "record", "id", "no", "№", "замовлення", "заказ", "номер"},
       true}};
  return all;
}

// Chi-square against one common rate; slots without time do not take part.
double same_rate_p_value(const std::vector<RateSlot>& slots) {
  double arrivals = 0;
  double exposure = 0;
  for (const RateSlot& s : slots) {
    arrivals += static_cast<double>(s.arrivals);
    exposure += s.exposure_h;
  }
  double chi = 0;
  int used = 0;
  for (const RateSlot& s : slots) {
    const double expected = arrivals * s.exposure_h / exposure;
    if (!(expected > 0)) continue;
    ++used;
    chi += (static_cast<double>(s.arrivals) - expected) * (static_cast<double>(s.arrivals) - expected) /
           expected;
  }
  return used < 2 ? 1 : chi_square_tail(chi, used - 1);
}

}  // namespace

ArrivalLog read_arrivals(const std::string& path, const ArrivalOptions& options, double confidence) {
  ArrivalLog log;
  log.table = read_table(path, options.table);
  Table& table = log.table;
  const Columns columns(table, roles(), options.columns, options.table);
  columns.require("arrival", "when it came, 2026-03-01 14:05, or minutes of a counter");
  log.with_quantities = columns.has("quantity");
  std::map<double, double> arrivals;  // moment -> quantity
  std::size_t dates = 0;
  std::size_t counters = 0;
  std::size_t together = 0;
  bool sorted = true;
  double before = -std::numeric_limits<double>::infinity();
  for (const Row& row : table.rows) {
    if (!options.part.empty() && columns.text(row, "part") != options.part) continue;
    std::string reason;
    const auto moment = columns.value(row, "arrival", reason);
    const auto quantity = !moment               ? std::nullopt
                          : log.with_quantities ? columns.value(row, "quantity", reason)
                                                : std::optional<double>(1);
    if (quantity && !(*quantity > 0)) reason = fmt::format("quantity {} is not above 0", *quantity);
    if (!quantity || !(*quantity > 0)) {
      table.dropped.push_back({row.line, reason});
      continue;
    }
    const std::string cell = columns.text(row, "arrival");
    if (parse_moment(cell))
      dates += 1;
    else
      counters += 1;
    if (*moment < before) sorted = false;
    before = *moment;
    const auto [place, fresh] = arrivals.emplace(*moment, *quantity);
    if (!fresh) {
      place->second += *quantity;
      ++together;
    }
    ++log.rows_used;
  }
  if (dates > 0 && counters > 0)
    throw scenarios::InputError(
        "", fmt::format("table {}: {} arrivals are dates and {} are plain numbers; they cannot be one "
                        "time axis",
                        path, dates, counters));
  if (arrivals.size() < 3)
    throw scenarios::InputError(
        "", fmt::format("table {}: {} different arrivals, at least 3 are needed", path, arrivals.size()));
  log.calendar = dates > 0;
  if (!sorted) table.notes.emplace_back("arrivals were not in order of time: sorted");
  if (together > 0)
    table.notes.push_back(fmt::format(
        "{} arrivals at the moment of an earlier one: taken as one arrival of several parts", together));
  log.dates_only = log.calendar;
  for (const auto& [moment, quantity] : arrivals) {
    if (std::fmod(moment, 1440) != 0) log.dates_only = false;
    log.moments_min.push_back(moment);
    log.quantities.push_back(quantity);
  }
  if (log.dates_only)
    table.notes.emplace_back(
        "arrivals have dates only: times between them are whole days, no profile of the day");
  if (!options.calendar.always() && !log.calendar)
    throw scenarios::InputError(
        "",
        fmt::format("table {}: --hours and --weekdays need arrivals with dates, these are counters", path));
  // On the clock of the shop what comes outside working time waits at the door.
  std::vector<double> worked;
  std::size_t outside = 0;
  for (const double moment : log.moments_min) {
    if (!options.calendar.working(moment)) ++outside;
    const double now = options.calendar.worked_min(moment);
    if (worked.empty() || now > worked.back()) worked.push_back(now);
  }
  if (outside > 0)
    table.notes.push_back(
        fmt::format("{} arrivals outside working time: taken as come when work begins", outside));
  // The first arrival starts the clock, the last one stops it.
  EventSeries series{.end = worked.back() - worked.front()};
  for (std::size_t i = 1; i < worked.size(); ++i) {
    log.between.push_back(exact_life(worked[i] - worked[i - 1]));
    series.times.push_back(worked[i] - worked.front());
  }
  log.trend = laplace_test({series});

  if (log.calendar) {
    static constexpr std::array<const char*, 7> names = {
        "Thursday", "Friday", "Saturday", "Sunday", "Monday", "Tuesday", "Wednesday"};  // 1970-01-01 on
    for (std::size_t d = 0; d < 7; ++d) log.weekdays.push_back({.name = names[d]});
    for (int h = 0; h < 24; ++h) log.hours.push_back({.name = fmt::format("{:02}:00", h)});
    // Whole days, from the first to the last one with an arrival.
    const auto day = [](double moment) { return static_cast<std::int64_t>(std::floor(moment / 1440)); };
    const std::int64_t first = day(log.moments_min.front());
    const std::int64_t last = day(log.moments_min.back());
    const auto weekday = [](std::int64_t d) { return static_cast<std::size_t>(((d % 7) + 7) % 7); };
    // Every week works alike: so many days of each kind, each with these hours.
    std::array<double, 7> days{};
    for (std::int64_t d = 0; d < 7; ++d)
      if (last - first >= d) {
        const std::int64_t whole_weeks = (last - first - d) / 7;
        days[weekday(first + d)] = static_cast<double>(whole_weeks + 1);
      }
    std::array<bool, 7> works{};
    for (std::size_t d = 0; d < 7; ++d)
      for (std::size_t h = 0; h < 24; ++h) {
        const double start = static_cast<double>(d) * 1440 + static_cast<double>(h) * 60;
        const double worked_h =
            (options.calendar.worked_min(start + 60) - options.calendar.worked_min(start)) / 60;
        log.hours[h].exposure_h += days[d] * worked_h;
        log.weekdays[d].exposure_h += days[d] * worked_h;
        if (worked_h > 0) works[d] = true;
      }
    std::map<std::int64_t, double> per_day;  // of days that work and have arrivals
    for (const double moment : log.moments_min) {
      const std::int64_t d = day(moment);
      if (works[weekday(d)]) ++per_day[d];
      ++log.weekdays[weekday(d)].arrivals;
      const double of_day = moment - static_cast<double>(d) * 1440;
      ++log.hours[std::min<std::size_t>(23, static_cast<std::size_t>(of_day / 60))].arrivals;
    }
    std::rotate(log.weekdays.begin(), log.weekdays.begin() + 4, log.weekdays.end());  // Monday first
    for (auto* slots : {&log.weekdays, &log.hours})
      for (RateSlot& s : *slots) {
        if (!(s.exposure_h > 0)) continue;
        s.rate_per_h = static_cast<double>(s.arrivals) / s.exposure_h;
        const Interval counts = poisson_interval(s.arrivals, confidence);
        s.bounds = {counts.low / s.exposure_h, counts.high / s.exposure_h};
      }
    log.weekday_p_value = same_rate_p_value(log.weekdays);
    if (log.dates_only)
      log.hours.clear();
    else
      log.hour_p_value = same_rate_p_value(log.hours);
    double working_days = 0;
    for (std::size_t d = 0; d < 7; ++d) working_days += works[d] ? days[d] : 0;
    double arrived = 0;
    for (const auto& [d, n] : per_day) arrived += n;
    const double mean = working_days > 0 ? arrived / working_days : 0;
    double squares = (working_days - static_cast<double>(per_day.size())) * mean * mean;
    for (const auto& [d, n] : per_day) squares += (n - mean) * (n - mean);
    if (working_days > 1 && mean > 0) {
      const double degrees = working_days - 1;
      log.dispersion_of_days = squares / degrees / mean;
      const double tail = chi_square_tail(squares / mean, degrees);
      log.dispersion_p_value = std::min(1.0, 2 * std::min(tail, 1 - tail));
    }
  }
  return log;
}

}  // namespace verstat::fit
