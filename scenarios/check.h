#pragma once
// What the checks of a scenario share. A check throws InputError: "/tools/0/insert = "x", there is no such
// insert; closest: "y"".

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/input_error.h"
#include "scenarios/scenario.h"

namespace verstat::scenarios {

[[noreturn]] void fail(const std::string& pointer, const std::string& value, const std::string& allowed);
[[nodiscard]] std::string quoted(const std::string& text);

/// Names have 1 to 100 characters and differ.
void check_names(const std::vector<std::string>& names, const std::string& list);
void check_reference(const std::vector<std::string>& names, const std::string& name,
                     const std::string& pointer, const std::string& what);
/// Members of a law that contradict each other.
void check_law(const Duration& duration, const std::string& pointer);
/// A process that takes no time would repeat for ever at one instant.
void check_takes_time(const Duration& duration, const std::string& pointer);

template <class T>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<T>& all) {
  std::vector<std::string> names;
  for (const T& one : all) names.push_back(one.name);
  return names;
}
/// The name must be that of one of `all`; `what` is what they are called.
template <class T>
void check_reference(const std::vector<T>& all, const std::string& name, const std::string& pointer,
                     const std::string& what) {
  if (find_named(all, name) == nullptr) check_reference(names_of(all), name, pointer, what);
}

void check_insert(const Scenario& s, const Insert& insert, const std::string& at);
void check_tool(const Scenario& s, const Tool& tool, const std::string& at);
/// Of the operations that use it, when those have been checked.
void check_tool_use(const Scenario& s, const Tool& tool, const std::string& at);
/// The tools that its operations need have room in the magazine of the machine.
void check_magazine(const Scenario& s, const Machine& machine, const std::string& at);
void check_operation(const Scenario& s, const Operation& operation, const std::string& at);
/// Operations that hand the state of parts on exist, and no state goes round in a circle.
void check_sources(const Scenario& s);
/// What the operation receives is left by the one that it names and fits the member that it becomes.
/// Operations before it have been checked.
void check_incoming(const Scenario& s, const Operation& operation, const std::string& at);
/// Parts have been where their state comes from.
void check_received_on_route(const Scenario& s, const PartType& part, const std::string& at);
/// What the drawing asks is decided on every way through the route.
void check_requirements(const Scenario& s, const PartType& part, const std::string& at);
/// Who does it, and with which tool.
void check_operation_names(const Scenario& s, const Operation& operation, const std::string& at);
void check_part(const Scenario& s, const PartType& part, const std::string& at);
void check_route(const Scenario& s, const PartType& part, const std::string& at);
void check_store(const Scenario& s, const Store& store, const std::string& at);
void check_transport(const Scenario& s, const Transport& transport, const std::string& at);
void check_machine(const Scenario& s, const Machine& machine, const std::string& at);
void check_crew(const Scenario& s, const Crew& crew, const std::string& at);
void check_calendar(const Calendar& calendar, const std::string& at);
void check_spare(const Spare& spare, const std::string& at);
/// Best and worst values come in pairs that differ, and a mission fits into the counted time.
void check_criteria(const Scenario& s, const std::string& at);
/// Vehicles find a way between all places that they serve.
void check_layout(const Scenario& s);
/// Names that are there now, and old ones that nothing else has.
void check_renamed(const Scenario& s);
/// Refuses a shop that no computer holds: limits on sums and products of what single members allow.
void check_size(const Scenario& s);
/// Refuses a shop whose machines cannot keep up with the demand, unless it says that it knows.
void check_capacity(const Scenario& s);
/// The name must be that of a crew, or a skill that some crew has.
void check_crew_or_skill(const Scenario& s, const std::string& name, const std::string& pointer);

}  // namespace verstat::scenarios
