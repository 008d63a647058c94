// Checks of inserts and tools that one member alone cannot show.
#include <fmt/format.h>

#include "models/math/life_law.h"
#include "operations/kinds/face_milling.h"
#include "scenarios/check.h"

namespace verstat::scenarios {

namespace {

void check_preparation(const Insert& insert, const std::string& at) {
  try {
    const Insert fitted = prepared(insert);
    if (fitted.edges < 1)
      fail(at + "/preparation/edges_used_by_test", fmt::format("{} edges left", fitted.edges),
           fmt::format("must leave at least one of the {} edges of the insert", insert.edges));
  } catch (const models::DomainError& e) {
    throw InputError(at + "/preparation/" + e.input(), fmt::format("{}/preparation/{}", at, e.what()));
  } catch (const models::ModelError& e) {
    throw InputError(at + "/preparation", fmt::format("{}/preparation cannot be planned: {}", at, e.what()));
  }
}

void check_strategy(const Tool& tool, const Insert& insert, const std::string& at) {
  if (const auto gamma = gamma_of(tool.strategy)) {
    const models::LifeLaw unit(insert.edge_life.law, 1.0, insert.edge_life.cv);
    if (!(unit.gamma_percent_life(*gamma) > 1e-6))
      fail(at + "/gamma", fmt::format("{}", *gamma),
           fmt::format("leaves a scheduled period of zero for the life of insert \"{}\"; lower it",
                       tool.insert));
  }
  if (const auto* mill = std::get_if<ReplaceAtFailedTeeth>(&tool.strategy)) {
    if (mill->failed_teeth > tool.teeth)
      fail(at + "/failed_teeth", fmt::format("{}", mill->failed_teeth),
           fmt::format("must not exceed the teeth of the tool, {}", tool.teeth));
  }
  if (const auto* watch = std::get_if<ConditionBased>(&tool.strategy)) {
    if (watch->every_min.has_value() == watch->every_parts.has_value())
      fail(at, watch->every_min ? "both every_min and every_parts" : "neither every_min nor every_parts",
           "must have exactly one of them");
  }
}

bool uses(const Operation& operation, const Tool& tool) {
  return operation.tool == tool.name;
}

// A mill whose teeth the shop follows one by one must be the mill that the operation speaks of.
void check_mill(const Scenario& s, const Tool& tool, const std::string& at) {
  if (tool.teeth == 1) return;
  for (const Operation& operation : s.operations) {
    if (!uses(operation, tool)) continue;
    const auto* mill = operation.process.as<operations::FaceMilling>();
    if (mill != nullptr && mill->teeth != tool.teeth)
      fail(at + "/teeth", fmt::format("{}", tool.teeth),
           fmt::format("operation \"{}\" mills with {} teeth: both must be the same", operation.name,
                       mill->teeth));
  }
}

void check_elements(const Scenario& s, const Tool& tool, const std::string& at) {
  std::vector<std::string> worn;
  for (const Operation& operation : s.operations) {
    if (!uses(operation, tool)) continue;
    for (const auto& element : plan(s, operation).more_elements) worn.emplace_back(element.element);
  }
  for (std::size_t k = 0; k < tool.elements.size(); ++k) {
    const ElementService& service = tool.elements[k];
    const std::string here = fmt::format("{}/elements/{}", at, k);
    check_law(service.change, here + "/change");
    check_reference(worn, service.element, here + "/element",
                    "element that an operation with this tool wears");
    for (std::size_t j = 0; j < k; ++j)
      if (tool.elements[j].element == service.element)
        fail(here + "/element", quoted(service.element),
             fmt::format("is already that of {}/elements/{}", at, j));
  }
}

void check_copies(const Tool& tool, const std::string& at) {
  if (tool.regrind && tool.teeth > 1)
    fail(at + "/teeth", fmt::format("{}", tool.teeth), "must be 1: a tool with inserts is not reground");
  if (!changed_off_line(tool)) return;
  if (std::holds_alternative<Opportunistic>(tool.strategy))
    fail(at + "/strategy", "\"opportunistic\"",
         "is for edges changed on the machine: sister tools, shared tools, presetting and regrinding go "
         "without");
}

}  // namespace

bool changed_off_line(const Tool& tool) {
  return tool.copies > 1 || tool.shared || tool.presetting.has_value() || tool.regrind.has_value();
}

std::int64_t failed_teeth_to_change(const Tool& tool) {
  const auto* mill = std::get_if<ReplaceAtFailedTeeth>(&tool.strategy);
  return mill == nullptr ? 1 : mill->failed_teeth;
}

void check_insert(const Scenario&, const Insert& insert, const std::string& at) {
  const EdgeLife& life = insert.edge_life;
  if (life.law == models::LifeLawKind::normal && life.cv > 0.45)
    fail(at + "/edge_life/cv", fmt::format("{}", life.cv), "allowed 0.05 <= cv <= 0.45 for the normal law");
  check_preparation(insert, at);
  if (insert.crib) check_law(insert.crib->lead_time, at + "/crib/lead_time");
  if (insert.lots && insert.lots->ln_sd_between > 0 && !(insert.lots->ln_sd_within > 0))
    fail(at + "/lots/ln_sd_within", fmt::format("{}", insert.lots->ln_sd_within),
         fmt::format("must be above 0 where ln_sd_between = {}: lots are told apart by samples that scatter",
                     insert.lots->ln_sd_between));
}

void check_tool(const Scenario& s, const Tool& tool, const std::string& at) {
  if (!tool.insert.empty() || tool.elements.empty())
    check_reference(s.inserts, tool.insert, at + "/insert", "insert");
  check_crew_or_skill(s, tool.crew, at + "/crew");
  if (!tool.failure_crew.empty()) check_crew_or_skill(s, tool.failure_crew, at + "/failure_crew");
  check_law(tool.change.index, at + "/change/index");
  check_law(tool.change.replace, at + "/change/replace");
  check_law(tool.change.swap, at + "/change/swap");
  if (tool.presetting) {
    check_law(tool.presetting->time, at + "/presetting/time");
    if (!tool.presetting->crew.empty())
      check_crew_or_skill(s, tool.presetting->crew, at + "/presetting/crew");
  }
  if (tool.regrind) check_law(tool.regrind->time, at + "/regrind/time");
  check_copies(tool, at);
  if (!tool.insert.empty())
    check_strategy(tool, prepared(*find_named(s.inserts, tool.insert)), at + "/strategy");
}

void check_tool_use(const Scenario& s, const Tool& tool, const std::string& at) {
  check_mill(s, tool, at);
  check_elements(s, tool, at);
}

void check_magazine(const Scenario& s, const Machine& machine, const std::string& at) {
  if (!machine.magazine) return;
  std::int64_t places = 0;
  std::string contents;
  for (const Tool& tool : s.tools) {
    const bool used = std::any_of(s.operations.begin(), s.operations.end(), [&](const Operation& operation) {
      if (!uses(operation, tool)) return false;
      const auto groups = groups_of(s, operation);
      return std::any_of(groups.begin(), groups.end(),
                         [&](std::size_t g) { return &s.machines[g] == &machine; });
    });
    if (!used || tool.magazine_places == 0) continue;
    const std::int64_t copies = tool.shared ? 1 : tool.copies;
    places += copies * tool.magazine_places;
    contents += fmt::format("{}{} x \"{}\"", contents.empty() ? "" : ", ", copies, tool.name);
  }
  if (places > *machine.magazine)
    fail(at + "/magazine", fmt::format("{}", *machine.magazine),
         fmt::format("its tools need {} places: {}", places, contents));
}

}  // namespace verstat::scenarios
