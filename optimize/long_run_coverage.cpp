#include "optimize/long_run_coverage.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "scenarios/input_error.h"
#include "scenarios/route.h"

namespace verstat::optimize {

using scenarios::InputError;
using scenarios::Scenario;
using scenarios::UsageClock;

namespace {

[[noreturn]] void leave_to_simulation(const std::string& pointer, const std::string& why) {
  throw InputError(pointer,
                   fmt::format("{}: {}, which the long-run model leaves to the simulation", pointer, why));
}

// Who is called to a machine: nobody, or one crew that is there whenever the machine works.
void check_crew(const Scenario& s, const std::string& name, const std::string& calendar,
                const std::string& at) {
  if (name.empty()) return;
  const scenarios::Crew* crew = scenarios::find_named(s.crews, name);
  if (crew == nullptr) leave_to_simulation(at, "several crews may be called");
  for (const scenarios::Crew& other : s.crews)
    if (&other != crew && std::find(other.skills.begin(), other.skills.end(), name) != other.skills.end())
      leave_to_simulation(at, "several crews may be called");
  if (!crew->calendar.empty() && crew->calendar != calendar)
    leave_to_simulation(at, "the crew works by a calendar that is not the machine's");
}

void check_spare(const Scenario& s, const std::string& name, const std::string& at) {
  if (name.empty()) return;
  if (mean_min(scenarios::find_named(s.spares, name)->lead_time) > 0)
    leave_to_simulation(at, "the repair may wait for a spare part");
}

void check_machine(const Scenario& s, const scenarios::Machine& m, const std::string& at) {
  const auto* calendar = scenarios::find_named(s.calendars, m.calendar);
  if (calendar != nullptr && !calendar->holidays.empty())
    leave_to_simulation(at + "/calendar", "the calendar has holidays");
  const bool stops = !m.failures.empty() || !m.maintenance.empty();
  if (calendar != nullptr && stops && m.repair_at_shift_end == scenarios::AtShiftEnd::finish)
    leave_to_simulation(at + "/repair_at_shift_end", "repairs go on after the shift");
  for (std::size_t k = 0; k < m.failures.size(); ++k) {
    const scenarios::FailureMode& mode = m.failures[k];
    const std::string here = fmt::format("{}/failures/{}", at, k);
    check_crew(s, mode.crew, m.calendar, here + "/crew");
    check_spare(s, mode.spare, here + "/spare");
    if (mode.effect == scenarios::StopEffect::when_idle)
      leave_to_simulation(here + "/effect", "the repair waits for an empty queue");
    if (mode.clock == UsageClock::calendar && calendar != nullptr)
      leave_to_simulation(here + "/clock", "the machine ages outside its shifts, too");
    if (mode.clock == UsageClock::parts &&
        !std::holds_alternative<operations::ConstantDuration>(mode.time_to_failure))
      leave_to_simulation(here + "/clock", "the life is a random number of parts");
  }
  for (std::size_t k = 0; k < m.maintenance.size(); ++k) {
    const scenarios::Maintenance& job = m.maintenance[k];
    const std::string here = fmt::format("{}/maintenance/{}", at, k);
    check_crew(s, job.crew, m.calendar, here + "/crew");
    check_spare(s, job.spare, here + "/spare");
    if (job.effect == scenarios::StopEffect::when_idle)
      leave_to_simulation(here + "/effect", "the maintenance waits for an empty queue");
    if (job.clock == UsageClock::calendar && calendar != nullptr)
      leave_to_simulation(here + "/clock", "it falls due outside the shifts, too");
    if (job.joins_from < 1) leave_to_simulation(here + "/joins_from", "the maintenance joins other stops");
    for (const std::string& renewed : job.renews) {
      const auto* mode = scenarios::find_named(m.failures, renewed);
      // A mode without ageing is as new at any time.
      if (mode != nullptr && !std::holds_alternative<operations::ExponentialDuration>(mode->time_to_failure))
        leave_to_simulation(here + "/renews", "the maintenance keeps an ageing part from failing");
    }
  }
  if (m.setup) {
    check_crew(s, m.setup->crew, m.calendar, at + "/setup/crew");
    if (m.dispatch != scenarios::Dispatch::fifo)
      leave_to_simulation(at + "/dispatch", "set-ups depend on the order of the queue");
  }
  if (m.attendance) {
    if (m.attendance->during == scenarios::Attendance::always)
      leave_to_simulation(at + "/attendance", "an operator stays with the machine");
    check_crew(s, m.attendance->crew, m.calendar, at + "/attendance/crew");
  }
  if (m.overload) check_crew(s, m.overload->crew, m.calendar, at + "/overload/crew");
  if (m.queue_capacity) leave_to_simulation(at + "/queue_capacity", "a full queue blocks");
  if (m.switch_off) leave_to_simulation(at + "/switch_off", "the machine is switched off");
  const scenarios::Power& power = m.power;
  if (s.energy_price_per_kwh > 0 && power.cutting_kw + power.working_kw + power.standby_kw + power.off_kw > 0)
    leave_to_simulation(at + "/power", "energy is paid for");
}

void check_tool(const Scenario& s, const scenarios::Tool& tool, const std::string& at) {
  if (tool.teeth > 1 || scenarios::changed_off_line(tool))
    leave_to_simulation(at, "the tool has teeth or copies");
  if (!tool.failure_crew.empty() && tool.failure_crew != tool.crew)
    leave_to_simulation(at + "/failure_crew", "another crew comes after a failure");
  if (tool.change.stop_min > 0)
    leave_to_simulation(at + "/change/stop_min", "edges share the stop of the machine");
  const scenarios::Insert* insert = scenarios::find_named(s.inserts, tool.insert);
  if (insert != nullptr && insert->lots)
    leave_to_simulation(at + "/insert", "its inserts come in lots that differ");
  if (insert != nullptr && insert->crib)
    leave_to_simulation(at + "/insert", "its inserts come from a crib that may be empty");
}

void check_part(const Scenario& s, const scenarios::PartType& part, const std::string& at) {
  if (!std::holds_alternative<scenarios::Push>(part.release))
    leave_to_simulation(at + "/release", "the release is held back");
  if (part.tardiness_cost_per_min > 0) leave_to_simulation(at + "/tardiness_cost_per_min", "late parts cost");
  for (const scenarios::RouteStep& step : scenarios::route_of(s, part)) {
    if (!step.assembles.empty() || !step.yields.empty())
      leave_to_simulation(at + "/steps", "parts are put together or divided");
    if (step.rework != scenarios::route_end) leave_to_simulation(at + "/steps", "parts are reworked");
    if (step.next.size() > 1 && step.choice == scenarios::BranchChoice::shortest_queue)
      leave_to_simulation(at + "/steps", "parts choose the shortest queue");
  }
}

}  // namespace

void check_covered(const Scenario& s) {
  for (std::size_t k = 0; k < s.machines.size(); ++k)
    check_machine(s, s.machines[k], fmt::format("/machines/{}", k));
  for (std::size_t k = 0; k < s.operations.size(); ++k) {
    const scenarios::Operation& o = s.operations[k];
    const std::string at = fmt::format("/operations/{}", k);
    const auto groups = scenarios::groups_of(s, o);
    if (groups.size() > 1) leave_to_simulation(at, "several machine groups share the operation");
    if (o.inspection) leave_to_simulation(at + "/inspection", "parts are inspected");
    if (o.quality && (o.quality->defect_probability > 0 || o.quality->defect_when_worn > 0))
      leave_to_simulation(at + "/quality", "defects stay hidden");
    if (o.tool.empty()) continue;
    const auto* tool = scenarios::find_named(s.tools, o.tool);
    const std::string tool_at = fmt::format("/tools/{}", tool - s.tools.data());
    check_tool(s, *tool, tool_at);
    check_crew(s, tool->crew, s.machines[groups.front()].calendar, tool_at + "/crew");
  }
  for (std::size_t k = 0; k < s.stores.size(); ++k)
    if (s.stores[k].capacity || s.stores[k].demand)
      leave_to_simulation(fmt::format("/stores/{}", k), "the store fills or runs empty");
  for (std::size_t k = 0; k < s.transport.size(); ++k)
    if (!std::holds_alternative<scenarios::TransportDelay>(s.transport[k].carrier))
      leave_to_simulation(fmt::format("/transport/{}/carrier", k), "parts wait for what carries them");
  for (std::size_t k = 0; k < s.parts.size(); ++k) check_part(s, s.parts[k], fmt::format("/parts/{}", k));
  // Blanks always at hand come in turn, not at random: which family follows which is not independent.
  for (std::size_t g = 0; g < s.machines.size(); ++g) {
    if (!s.machines[g].setup) continue;
    std::set<std::string> families;
    for (const scenarios::Operation& o : s.operations)
      if (scenarios::groups_of(s, o).front() == g) families.insert(o.family.empty() ? o.name : o.family);
    if (families.size() < 2) continue;
    for (std::size_t p = 0; p < s.parts.size(); ++p) {
      const auto route = scenarios::route_of(s, s.parts[p]);
      if (std::holds_alternative<scenarios::AlwaysAvailable>(s.parts[p].supply) &&
          scenarios::groups_of(s, s.operations[route.front().operation]).front() == g)
        leave_to_simulation(fmt::format("/machines/{}/setup", g),
                            "blanks that are always there come in turn");
    }
  }
}

}  // namespace verstat::optimize
