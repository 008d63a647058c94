#pragma once
// The clock that runs only while the shop works: 07:00 to 15:00 from Monday to Friday, say.

#include <array>
#include <string>

namespace verstat::fit {

class WorkCalendar {
 public:
  /// Always working.
  WorkCalendar() = default;
  /// `hours`: "07:00-15:00" (midnight is 24:00); `days`: "mon-fri" or "mon-fri,sun"; empty: all of them.
  /// Throws InputError naming --hours or --weekdays.
  WorkCalendar(const std::string& hours, const std::string& days);

  [[nodiscard]] bool always() const { return always_; }
  /// Working minutes from 1970-01-01 00:00 to `moment_min` >= 0, minutes of the calendar.
  [[nodiscard]] double worked_min(double moment_min) const;
  [[nodiscard]] bool working(double moment_min) const;

 private:
  bool always_ = true;
  double from_min_ = 0;
  double to_min_ = 1440;
  std::array<bool, 7> days_ = {true, true, true, true,
                               true, true, true};  // Thursday first: 1970-01-01 was one
};

}  // namespace verstat::fit
