#include "fit/work_calendar.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

constexpr std::array<std::string_view, 7> day_names = {"thu", "fri", "sat", "sun", "mon", "tue", "wed"};

std::optional<double> time_of_day(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos || colon + 3 != text.size()) return std::nullopt;
  int hour = -1;
  int minute = -1;
  const auto [h, he] = std::from_chars(text.data(), text.data() + colon, hour);
  const auto [m, me] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), minute);
  if (he != std::errc() || me != std::errc() || h != text.data() + colon || m != text.data() + text.size())
    return std::nullopt;
  const double result = hour * 60 + minute;
  if (hour < 0 || minute < 0 || minute > 59 || result > 1440) return std::nullopt;
  return result;
}

std::size_t day_of(std::string_view name, const std::string& all) {
  const auto at = std::find(day_names.begin(), day_names.end(), name);
  if (at == day_names.end())
    throw scenarios::InputError(
        "", fmt::format("--weekdays {}: must be days such as mon-fri or mon,wed,fri", all));
  return static_cast<std::size_t>(at - day_names.begin());
}

}  // namespace

WorkCalendar::WorkCalendar(const std::string& hours, const std::string& days)
    : always_(hours.empty() && days.empty()) {
  if (!hours.empty()) {
    const auto dash = hours.find('-');
    const auto from = time_of_day(std::string_view(hours).substr(0, dash));
    const auto to =
        dash == std::string::npos ? std::nullopt : time_of_day(std::string_view(hours).substr(dash + 1));
    if (!from || !to || !(*from < *to))
      throw scenarios::InputError(
          "", fmt::format("--hours {}: must be such as 07:00-15:00, within one day", hours));
    from_min_ = *from;
    to_min_ = *to;
  }
  if (days.empty()) return;
  days_.fill(false);
  std::string_view rest = days;
  while (true) {
    const auto comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const auto dash = part.find('-');
    std::size_t day = day_of(part.substr(0, dash), days);
    const std::size_t last = dash == std::string_view::npos ? day : day_of(part.substr(dash + 1), days);
    days_[day] = true;
    while (day != last) {
      day = (day + 1) % 7;
      days_[day] = true;
    }
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
}

double WorkCalendar::worked_min(double moment_min) const {
  if (always_) return moment_min;
  const double day = std::floor(moment_min / 1440);
  const double shift = to_min_ - from_min_;
  const auto working_days = static_cast<double>(std::count(days_.begin(), days_.end(), true));
  const double weeks = std::floor(day / 7);
  double worked = weeks * working_days * shift;
  const auto today = static_cast<std::size_t>(day - 7 * weeks);
  for (std::size_t d = 0; d < today; ++d) worked += days_[d] ? shift : 0;
  if (days_[today]) worked += std::clamp(moment_min - day * 1440 - from_min_, 0.0, shift);
  return worked;
}

bool WorkCalendar::working(double moment_min) const {
  if (always_) return true;
  const double day = std::floor(moment_min / 1440);
  const double of_day = moment_min - day * 1440;
  const auto today = static_cast<std::size_t>(day - 7 * std::floor(day / 7));
  return days_[today] && of_day >= from_min_ && of_day < to_min_;
}

}  // namespace verstat::fit
