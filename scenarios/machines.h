#pragma once
// Machines and what stops them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "operations/kind.h"
#include "operations/spindle.h"

namespace verstat::scenarios {

using operations::Duration;

/// What wears a machine out, and what an interval is counted in.
enum class UsageClock {
  calendar,   ///< minutes of the clock on the wall
  operating,  ///< minutes in which the machine works on parts
  cutting,    ///< minutes in the cut
  parts       ///< parts worked on
};
/// When a stop takes effect.
enum class StopEffect {
  at_once,     ///< the part in work waits in the machine and is finished afterwards
  after_part,  ///< the part in work is finished first
  when_idle    ///< the machine first works off what is in its queue
};
/// What becomes of a repair or a part in work when the shift ends.
enum class AtShiftEnd { finish, pause };

/// One way in which a machine fails; modes are independent of each other.
struct FailureMode {
  std::string name;
  UsageClock clock = UsageClock::operating;
  Duration time_to_failure;  ///< in minutes of that clock, or in parts
  Duration repair;
  std::string crew;           ///< empty: nobody is needed
  std::int64_t priority = 0;  ///< of the call for the crew; smaller is more urgent
  std::string spare;          ///< part that a repair uses up; empty: none
  StopEffect effect = StopEffect::at_once;
  double scrap_probability = 0;  ///< of the part in work
  double damage = 0;             ///< money per failure
};

/// Work that keeps a machine from failing.
struct Maintenance {
  std::string name;
  UsageClock clock = UsageClock::calendar;
  double interval = 0;  ///< in minutes of that clock, or in parts
  Duration duration;
  std::string crew;
  std::int64_t priority = 0;
  std::string spare;
  StopEffect effect = StopEffect::after_part;
  std::vector<std::string> renews;  ///< failure modes that are as new afterwards
  /// Joins any other stop of the machine once this share of its interval has passed; 1: never early.
  double joins_from = 1;
  /// Condition-based: the modes are renewed only when at least this share of their life is used up and it
  /// is noticed; 0: always.
  double condition_threshold = 0;
  double detection_probability = 1;
};

struct SetupTime {
  std::string from;  ///< family; "*": any
  std::string to;
  Duration time;
};
/// Changing over between families of operations.
struct Setup {
  Duration time;                 ///< between families that `times` does not name
  std::vector<SetupTime> times;  ///< sequence-dependent
  std::string crew;              ///< who does it; empty: nobody is needed
  double cost = 0;               ///< money per changeover
};

enum class Dispatch {
  fifo,            ///< first come, first served
  spt,             ///< shortest processing time
  edd,             ///< earliest due date
  critical_ratio,  ///< time to the due date / work left, smallest first
  least_setup,     ///< the family that is set up first, then first come
  priority         ///< the part type's priority, then first come
};

/// Electric power drawn.
struct Power {
  double cutting_kw = 0;
  double working_kw = 0;  ///< operations given as durations, loading
  double standby_kw = 0;  ///< any other state while switched on
  double off_kw = 0;      ///< switched off, and outside the calendar
};

/// Hands that the machine needs.
enum class Attendance {
  loading,  ///< while parts are loaded and unloaded
  always    ///< from loading to unloading
};
struct Operator {
  std::string crew;
  Attendance during = Attendance::loading;
};

/// What happens when the safety clutch of the drive (limits/safety_clutch, K204) trips or does not save the
/// drive.
struct Overload {
  std::string crew;              ///< who resets a clutch that does not close again by itself, and repairs
  Duration repair;               ///< of a drive or tool that breaks
  double damage = 0;             ///< money per break
  double scrap_probability = 0;  ///< of the part in work, at a break
};

struct SwitchOff {
  double after_idle_min = 0;  ///< idle time after which the machine is switched off
  Duration warm_up;           ///< from switching on to the first chip; also at the start of a shift
};

struct Machine {
  std::string name;
  std::string model;
  std::int64_t count = 1;
  double rate_per_min = 0;
  operations::MachineLimits limits;
  std::optional<operations::Spindle> spindle;
  std::optional<std::int64_t> magazine;  ///< tool places; none: no bound
  std::vector<std::string> capabilities;
  Dispatch dispatch = Dispatch::fifo;
  std::optional<std::int64_t> queue_capacity;  ///< batches waiting before the group; none: no bound
  std::optional<Duration> loading;             ///< per part
  std::optional<Duration> unloading;           ///< per part
  std::optional<Setup> setup;
  std::optional<Operator> attendance;
  std::string calendar;  ///< empty: round the clock
  AtShiftEnd part_at_shift_end = AtShiftEnd::finish;
  AtShiftEnd repair_at_shift_end = AtShiftEnd::finish;
  std::vector<FailureMode> failures;
  std::vector<Maintenance> maintenance;
  std::optional<scenarios::Overload> overload;
  std::optional<SwitchOff> switch_off;
  Power power;
};

/// A spare part that repairs use up.
struct Spare {
  std::string name;
  double price = 0;
  std::int64_t stock = 1;          ///< at the start
  std::int64_t reorder_point = 0;  ///< an order is placed when stock and orders under way fall to this
  std::int64_t order_quantity = 1;
  Duration lead_time;
};

}  // namespace verstat::scenarios
