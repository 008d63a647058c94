#include "scenarios/calendar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace verstat::scenarios {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Weekly spans of the shifts, cut at the end of the week where they pass midnight on Sunday.
template <class Span>
std::vector<Span> weekly(const std::vector<Shift>& shifts) {
  std::vector<Span> spans;
  for (const Shift& shift : shifts)
    for (const Weekday day : shift.days) {
      const double begin_min = static_cast<double>(day) * minutes_per_day;
      const double from_min = begin_min + 60 * shift.from_h;
      const double to_min = begin_min + 60 * shift.to_h;
      if (from_min < minutes_per_week) spans.push_back({from_min, std::min(to_min, minutes_per_week)});
      if (to_min > minutes_per_week)
        spans.push_back({std::max(0.0, from_min - minutes_per_week), to_min - minutes_per_week});
    }
  return spans;
}

template <class Span>
std::vector<Span> merged(std::vector<Span> spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from_min < b.from_min; });
  std::vector<Span> result;
  for (const Span& span : spans) {
    if (!result.empty() && span.from_min <= result.back().to_min)
      result.back().to_min = std::max(result.back().to_min, span.to_min);
    else
      result.push_back(span);
  }
  return result;
}

template <class Span>
std::vector<Span> without(const std::vector<Span>& spans, const std::vector<Span>& taken) {
  std::vector<Span> result;
  for (Span span : spans) {
    for (const Span& out : taken) {
      if (out.to_min <= span.from_min || out.from_min >= span.to_min) continue;
      if (out.from_min > span.from_min) result.push_back({span.from_min, out.from_min});
      span.from_min = out.to_min;
      if (span.from_min >= span.to_min) break;
    }
    if (span.from_min < span.to_min) result.push_back(span);
  }
  return result;
}

}  // namespace

WorkingTime::WorkingTime(const Calendar& calendar) {
  week_ = without(merged(weekly<Span>(calendar.shifts)), merged(weekly<Span>(calendar.breaks)));
  for (const Holiday& holiday : calendar.holidays)
    holidays_.push_back({static_cast<double>(holiday.first_day) * minutes_per_day,
                         static_cast<double>(holiday.first_day + holiday.days) * minutes_per_day});
  holidays_ = merged(holidays_);
}

bool WorkingTime::holiday(double time_min) const {
  const auto after = std::upper_bound(holidays_.begin(), holidays_.end(), time_min,
                                      [](double t, const Span& span) { return t < span.from_min; });
  return after != holidays_.begin() && time_min < std::prev(after)->to_min;
}

bool WorkingTime::open_in_week(double week_min) const {
  const auto after = std::upper_bound(week_.begin(), week_.end(), week_min,
                                      [](double t, const Span& span) { return t < span.from_min; });
  return after != week_.begin() && week_min < std::prev(after)->to_min;
}

bool WorkingTime::open(double time_min) const {
  return open_in_week(std::fmod(time_min, minutes_per_week)) && !holiday(time_min);
}

double WorkingTime::next_change_min(double time_min) const {
  if (week_.empty()) return infinity;
  const bool now = open(time_min);
  double at = time_min;
  // Every border of the week and of the holidays is a candidate; two years without a change mean never.
  for (const double last = time_min + 106 * minutes_per_week; at < last;) {
    const double week_start = std::floor(at / minutes_per_week) * minutes_per_week;
    double next = week_start + minutes_per_week;
    for (const Span& span : week_) {
      if (week_start + span.from_min > at) next = std::min(next, week_start + span.from_min);
      if (week_start + span.to_min > at) next = std::min(next, week_start + span.to_min);
    }
    for (const Span& span : holidays_) {
      if (span.from_min > at) next = std::min(next, span.from_min);
      if (span.to_min > at) next = std::min(next, span.to_min);
    }
    if (open(next) != now) return next;
    at = next;
  }
  return infinity;
}

double WorkingTime::working_min(double from_min, double to_min) const {
  double sum = 0;
  for (double at = from_min; at < to_min;) {
    const double until = std::min(to_min, next_change_min(at));
    if (open(at)) sum += until - at;
    at = until;
  }
  return sum;
}

double WorkingTime::open_share() const {
  double sum = 0;
  for (const Span& span : week_) sum += span.to_min - span.from_min;
  return sum / minutes_per_week;
}

}  // namespace verstat::scenarios
