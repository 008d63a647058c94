// Checks of inserts and tools that one member alone cannot show.
#include <fmt/format.h>

#include "models/math/life_law.h"
#include "scenarios/check.h"

namespace verstat::scenarios {

void check_insert(const Scenario&, const Insert& insert, const std::string& at) {
  const EdgeLife& life = insert.edge_life;
  if (life.law == models::LifeLawKind::normal && life.cv > 0.45)
    fail(at + "/edge_life/cv", fmt::format("{}", life.cv), "allowed 0.05 <= cv <= 0.45 for the normal law");
}

void check_tool(const Scenario& s, const Tool& tool, const std::string& at) {
  check_reference(s.inserts, tool.insert, at + "/insert", "insert");
  check_reference(s.crews, tool.crew, at + "/crew", "crew");
  check_law(tool.change.index, at + "/change/index");
  check_law(tool.change.replace, at + "/change/replace");
  const EdgeLife& life = find_named(s.inserts, tool.insert)->edge_life;
  const auto gamma = gamma_of(tool.strategy);
  if (!gamma) return;
  const models::LifeLaw unit(life.law, 1.0, life.cv);
  if (!(unit.gamma_percent_life(*gamma) > 1e-6))
    fail(at + "/strategy/gamma", fmt::format("{}", *gamma),
         fmt::format("leaves a scheduled period of zero for the life of insert \"{}\"; lower it",
                     tool.insert));
}

}  // namespace verstat::scenarios
