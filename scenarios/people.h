#pragma once
// Who works, and when: crews, their skills, calendars of shifts. Time 0 is Monday 00:00.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace verstat::scenarios {

enum class Weekday { monday, tuesday, wednesday, thursday, friday, saturday, sunday };

/// Working time that comes again every week. `to_h` may pass midnight: 22 to 30 is the night shift.
struct Shift {
  std::vector<Weekday> days;
  double from_h = 0;
  double to_h = 24;
};
/// Whole days without work, counted from the first Monday.
struct Holiday {
  std::int64_t first_day = 0;
  std::int64_t days = 1;
};
struct Calendar {
  std::string name;
  std::vector<Shift> shifts;
  std::vector<Shift> breaks;  ///< taken out of the shifts
  std::vector<Holiday> holidays;
};

enum class CrewPay {
  busy,  ///< paid for the minutes worked (K117)
  shift  ///< paid for the whole scheduled time
};
struct Crew {
  std::string name;
  std::int64_t members = 1;
  double rate_per_min = 0;
  CrewPay pay = CrewPay::busy;
  std::vector<std::string> skills;       ///< besides the crew's own name
  std::string calendar;                  ///< empty: always there
  double walking_min = 0;                ///< to the machine, at every call
  std::int64_t machines_per_member = 1;  ///< that one member can tend at the same time
};

}  // namespace verstat::scenarios
