#include "scenarios/warnings.h"

#include <fmt/format.h>

#include "scenarios/incoming.h"
#include "scenarios/route.h"

namespace verstat::scenarios {

namespace {

std::string unit_of(const char* unit) {
  return std::string_view(unit) == "1" ? "" : " " + std::string(unit);
}

void of_operation(const Scenario& s, std::size_t index, std::vector<Warning>& all) {
  const Operation& operation = s.operations[index];
  const std::string pointer = fmt::format("/operations/{}/process", index);
  for (const std::size_t g : groups_of(s, operation)) {
    const Machine& machine = s.machines[g];
    const operations::CutPlan planned = plan(s, operation, machine);
    const std::string who = fmt::format("operation \"{}\" on \"{}\"", operation.name, machine.name);
    for (const operations::Limit& l : planned.limits)
      if (!l.met())
        all.push_back({pointer, operation.name, machine.name, l.name, l.value, l.allowed, l.allowed,
                       fmt::format("{}: {} is {:.6g}{}, must be at {} {:.6g} ({})", who, l.name, l.value,
                                   unit_of(l.unit), l.at_most ? "most" : "least", l.allowed, l.origin)});
    for (const operations::ForbiddenBand& b : planned.bands)
      if (b.inside())
        all.push_back({pointer, operation.name, machine.name, b.name, b.value, b.low, b.high,
                       fmt::format("{}: {} is {:.6g}{}, inside the forbidden band {:.6g} to {:.6g} ({})", who,
                                   b.name, b.value, unit_of(b.unit), b.low, b.high, b.origin)});
  }
}

void of_requirement(const Scenario& s, std::size_t p, std::size_t r, std::vector<Warning>& all) {
  const PartType& part = s.parts[p];
  const Requirement& requirement = part.requirements[r];
  const Route route = route_of(s, part);
  for (const std::size_t step : last_steps_that_leave(s, p, requirement.quantity)) {
    const Operation& operation = s.operations[route[step].operation];
    for (const std::size_t g : groups_of(s, operation)) {
      const operations::CutPlan planned = plan(s, operation, s.machines[g]);
      const double value = planned.value_of(requirement.quantity).value_or(0);
      const auto short_of = [&](const std::optional<double>& bound, bool most) {
        if (!bound || (most ? value <= *bound : value >= *bound)) return;
        all.push_back(
            {fmt::format("/parts/{}/requirements/{}", p, r), part.name, s.machines[g].name,
             requirement.quantity, value, *bound, *bound,
             fmt::format("part \"{}\": operation \"{}\" leaves {} = {:.6g}{}, the drawing asks for at {} "
                         "{:.6g}",
                         part.name, operation.name, requirement.quantity, value,
                         unit_of(planned.unit_of(requirement.quantity)), most ? "most" : "least", *bound)});
      };
      short_of(requirement.at_least, false);
      short_of(requirement.at_most, true);
    }
  }
}

}  // namespace

std::vector<Warning> warnings(const Scenario& scenario) {
  std::vector<Warning> all;
  for (std::size_t o = 0; o < scenario.operations.size(); ++o) of_operation(scenario, o, all);
  for (std::size_t p = 0; p < scenario.parts.size(); ++p)
    for (std::size_t r = 0; r < scenario.parts[p].requirements.size(); ++r)
      of_requirement(scenario, p, r, all);
  return all;
}

nlohmann::ordered_json to_json(const std::vector<Warning>& all) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Warning& w : all)
    list.push_back({{"pointer", w.pointer},
                    {"operation", w.operation},
                    {"machine", w.machine},
                    {"limit", w.limit},
                    {"value", w.value},
                    {"low", w.low},
                    {"high", w.high},
                    {"text", w.text}});
  return list;
}

}  // namespace verstat::scenarios
