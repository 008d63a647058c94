// Checks of machines, crews, calendars and spare parts that one member alone cannot show.
#include <fmt/format.h>

#include "scenarios/check.h"

namespace verstat::scenarios {

namespace {

void check_shift(const Shift& shift, const std::string& at) {
  if (!(shift.to_h > shift.from_h))
    fail(at + "/to_h", fmt::format("{}", shift.to_h), fmt::format("must be after from_h = {}", shift.from_h));
  if (shift.to_h - shift.from_h > 24)
    fail(at + "/to_h", fmt::format("{}", shift.to_h), "makes the shift longer than a day");
}

void check_stop(const Scenario& s, const std::string& crew, const std::string& spare, const std::string& at) {
  if (!crew.empty()) check_crew_or_skill(s, crew, at + "/crew");
  if (!spare.empty()) check_reference(s.spares, spare, at + "/spare", "spare part");
}

}  // namespace

void check_crew_or_skill(const Scenario& s, const std::string& name, const std::string& pointer) {
  std::vector<std::string> known;
  for (const Crew& crew : s.crews) {
    known.push_back(crew.name);
    known.insert(known.end(), crew.skills.begin(), crew.skills.end());
  }
  check_reference(known, name, pointer, "crew or skill");
}

void check_calendar(const Calendar& calendar, const std::string& at) {
  for (std::size_t k = 0; k < calendar.shifts.size(); ++k)
    check_shift(calendar.shifts[k], fmt::format("{}/shifts/{}", at, k));
  for (std::size_t k = 0; k < calendar.breaks.size(); ++k)
    check_shift(calendar.breaks[k], fmt::format("{}/breaks/{}", at, k));
}

void check_crew(const Scenario& s, const Crew& crew, const std::string& at) {
  if (!crew.calendar.empty()) check_reference(s.calendars, crew.calendar, at + "/calendar", "calendar");
}

void check_spare(const Spare& spare, const std::string& at) {
  check_law(spare.lead_time, at + "/lead_time");
}

void check_machine(const Scenario& s, const Machine& machine, const std::string& at) {
  if (!machine.calendar.empty()) check_reference(s.calendars, machine.calendar, at + "/calendar", "calendar");
  if (machine.loading) check_law(*machine.loading, at + "/loading");
  if (machine.unloading) check_law(*machine.unloading, at + "/unloading");
  if (machine.attendance) check_crew_or_skill(s, machine.attendance->crew, at + "/attendance/crew");
  if (machine.overload) {
    check_law(machine.overload->repair, at + "/overload/repair");
    if (!machine.overload->crew.empty())
      check_crew_or_skill(s, machine.overload->crew, at + "/overload/crew");
  }
  if (machine.switch_off) check_law(machine.switch_off->warm_up, at + "/switch_off/warm_up");
  if (machine.setup) {
    check_law(machine.setup->time, at + "/setup/time");
    for (std::size_t k = 0; k < machine.setup->times.size(); ++k)
      check_law(machine.setup->times[k].time, fmt::format("{}/setup/times/{}/time", at, k));
    if (!machine.setup->crew.empty()) check_crew_or_skill(s, machine.setup->crew, at + "/setup/crew");
  }
  check_names(names_of(machine.failures), at + "/failures");
  for (std::size_t k = 0; k < machine.failures.size(); ++k) {
    const FailureMode& mode = machine.failures[k];
    const std::string pointer = fmt::format("{}/failures/{}", at, k);
    check_takes_time(mode.time_to_failure, pointer + "/time_to_failure");
    check_law(mode.repair, pointer + "/repair");
    check_stop(s, mode.crew, mode.spare, pointer);
  }
  check_names(names_of(machine.maintenance), at + "/maintenance");
  for (std::size_t k = 0; k < machine.maintenance.size(); ++k) {
    const Maintenance& job = machine.maintenance[k];
    const std::string pointer = fmt::format("{}/maintenance/{}", at, k);
    check_law(job.duration, pointer + "/duration");
    check_stop(s, job.crew, job.spare, pointer);
    for (std::size_t r = 0; r < job.renews.size(); ++r)
      check_reference(machine.failures, job.renews[r], fmt::format("{}/renews/{}", pointer, r),
                      "failure mode");
  }
}

}  // namespace verstat::scenarios
