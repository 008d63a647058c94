#pragma once
// Working time of a calendar: when it opens and closes. Time 0 is Monday 00:00; times in minutes.

#include <vector>

#include "scenarios/people.h"

namespace verstat::scenarios {

inline constexpr double minutes_per_day = 1440;
inline constexpr double minutes_per_week = 7 * minutes_per_day;

class WorkingTime {
 public:
  explicit WorkingTime(const Calendar& calendar);

  /// Is there work at `time_min` >= 0? At a border: what begins there.
  [[nodiscard]] bool open(double time_min) const;
  /// The first time after `time_min` at which open() changes; infinity when it never does.
  [[nodiscard]] double next_change_min(double time_min) const;
  /// Working minutes from `from_min` to `to_min` >= from_min.
  [[nodiscard]] double working_min(double from_min, double to_min) const;
  /// Working share of an ordinary week.
  [[nodiscard]] double open_share() const;

 private:
  struct Span {
    double from_min;
    double to_min;
  };
  [[nodiscard]] bool holiday(double time_min) const;
  [[nodiscard]] bool open_in_week(double week_min) const;

  std::vector<Span> week_;      // working spans within a week, apart from each other, in order
  std::vector<Span> holidays_;  // absolute, apart from each other, in order
};

}  // namespace verstat::scenarios
