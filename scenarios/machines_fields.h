#pragma once
// That machines, people and what stops them are described; the descriptions stand in machines_fields.cpp.

#include "models/catalogue/field.h"
#include "scenarios/machines.h"
#include "scenarios/people.h"

namespace verstat::models {

template <>
struct EnumNames<scenarios::Weekday> {
  using W = scenarios::Weekday;
  static constexpr std::array names{std::pair{W::monday, "monday"},       std::pair{W::tuesday, "tuesday"},
                                    std::pair{W::wednesday, "wednesday"}, std::pair{W::thursday, "thursday"},
                                    std::pair{W::friday, "friday"},       std::pair{W::saturday, "saturday"},
                                    std::pair{W::sunday, "sunday"}};
};
template <>
struct EnumNames<scenarios::CrewPay> {
  static constexpr std::array names{std::pair{scenarios::CrewPay::busy, "busy"},
                                    std::pair{scenarios::CrewPay::shift, "shift"}};
};
template <>
struct EnumNames<scenarios::UsageClock> {
  using U = scenarios::UsageClock;
  static constexpr std::array names{std::pair{U::calendar, "calendar"}, std::pair{U::operating, "operating"},
                                    std::pair{U::cutting, "cutting"}, std::pair{U::parts, "parts"}};
};
template <>
struct EnumNames<scenarios::StopEffect> {
  using E = scenarios::StopEffect;
  static constexpr std::array names{std::pair{E::at_once, "at_once"}, std::pair{E::after_part, "after_part"},
                                    std::pair{E::when_idle, "when_idle"}};
};
template <>
struct EnumNames<scenarios::AtShiftEnd> {
  static constexpr std::array names{std::pair{scenarios::AtShiftEnd::finish, "finish"},
                                    std::pair{scenarios::AtShiftEnd::pause, "pause"}};
};
template <>
struct EnumNames<scenarios::Dispatch> {
  using D = scenarios::Dispatch;
  static constexpr std::array names{std::pair{D::fifo, "fifo"},
                                    std::pair{D::spt, "spt"},
                                    std::pair{D::edd, "edd"},
                                    std::pair{D::critical_ratio, "critical_ratio"},
                                    std::pair{D::least_setup, "least_setup"},
                                    std::pair{D::priority, "priority"}};
};
template <>
struct EnumNames<scenarios::Attendance> {
  static constexpr std::array names{std::pair{scenarios::Attendance::loading, "loading"},
                                    std::pair{scenarios::Attendance::always, "always"}};
};

#define VERSTAT_DESCRIBED(S)            \
  template <>                           \
  struct StructFields<scenarios::S> {   \
    static std::vector<Field> fields(); \
  }
VERSTAT_DESCRIBED(Shift);
VERSTAT_DESCRIBED(Holiday);
VERSTAT_DESCRIBED(Calendar);
VERSTAT_DESCRIBED(Crew);
VERSTAT_DESCRIBED(FailureMode);
VERSTAT_DESCRIBED(Maintenance);
VERSTAT_DESCRIBED(SetupTime);
VERSTAT_DESCRIBED(Setup);
VERSTAT_DESCRIBED(Power);
VERSTAT_DESCRIBED(Operator);
VERSTAT_DESCRIBED(Overload);
VERSTAT_DESCRIBED(SwitchOff);
VERSTAT_DESCRIBED(Machine);
VERSTAT_DESCRIBED(Spare);
#undef VERSTAT_DESCRIBED

}  // namespace verstat::models
