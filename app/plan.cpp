// verstat plan: what an operation takes, wears and risks, before any shop is simulated.
#include <fmt/format.h>

#include "app/cli.h"
#include "models/catalogue/error.h"
#include "scenarios/plan_json.h"

namespace verstat::app {

namespace {

void print_plan(const operations::CutPlan& plan, bool explain) {
  const auto origin = [&](const char* text) {
    return explain ? fmt::format("   [{}]", text) : std::string();
  };
  for (const auto& q : plan.quantities)
    fmt::print("{:<34} {:>14.6g} {:<10} {}{}\n", q.name, q.value,
               std::string_view(q.unit) == "1" ? "" : q.unit, q.meaning, origin(q.origin));
  const auto element = [&](const operations::ElementLife& e) {
    fmt::print("{:<34} {:>14.6g} {:<10} mean life of cutting, CV {:g}{}\n",
               fmt::format("life of {}", e.element), e.mean_min, "min", e.cv, origin(e.origin));
  };
  if (plan.edge) element(*plan.edge);
  for (const auto& e : plan.more_elements) element(e);
  if (plan.scrap_probability > 0)
    fmt::print("{:<34} {:>14.6g}\n", "scrap_probability", plan.scrap_probability);
  if (plan.breakage_probability > 0)
    fmt::print("{:<34} {:>14.6g}\n", "breakage_probability", plan.breakage_probability);
  for (const auto& q : plan.consumables)
    fmt::print("{:<34} {:>14.6g} {:<10} per part: {}{}\n", q.name, q.value,
               std::string_view(q.unit) == "1" ? "" : q.unit, q.meaning, origin(q.origin));
  for (const auto& state : plan.leaves)
    fmt::print("leaves {:<27} {:>14.6g} {}{}\n", state.quantity, plan.value_of(state.quantity).value_or(0),
               std::string_view(plan.unit_of(state.quantity)) == "1" ? "" : plan.unit_of(state.quantity),
               state.sd > 0 ? fmt::format(", scatter {:g}", state.sd) : "");
  for (const auto& l : plan.limits)
    fmt::print("{} {:<29} {:>14.6g} {} {:g} {}, margin {:+.1f} %{}\n", l.met() ? "ok  " : "OVER", l.name,
               l.value, l.at_most ? "<=" : ">=", l.allowed, l.unit, 100 * l.margin(), origin(l.origin));
  for (const auto& b : plan.bands)
    fmt::print("{} {:<29} {:>14.6g} {}, forbidden {:g} to {:g}{}\n", b.inside() ? "OVER" : "ok  ", b.name,
               b.value, b.unit, b.low, b.high, origin(b.origin));
  fmt::print("{}\n", plan.feasible() ? "feasible" : "NOT feasible");
}

}  // namespace

void add_plan(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  auto explain = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("plan", "Plan one operation: time, life, forces, limits with margins");
  command->add_option("OPERATION", *file, "operation file (JSON)")->required();
  command->add_flag("--explain", *explain, "say where every number comes from");
  add_json(*command, *options);
  command->add_option("--set", options->set, "change one value: POINTER=VALUE; may be repeated")
      ->allow_extra_args(false);
  command->footer("Example:\n  verstat plan scenarios/gallery/operations/turning.json --explain");
  command->callback([=] {
    std::vector<scenarios::Change> changes;
    for (const std::string& text : options->set) changes.push_back(scenarios::parse_change(text));
    operations::CutPlan plan;
    try {
      const auto operation = scenarios::load_operation(
          scenarios::apply(scenarios::parse_json(scenarios::read_text_file(*file)), changes));
      plan = operation.plan();
    } catch (const scenarios::InputError& e) {
      throw UsageError(fmt::format("operation {}: {}", *file, e.what()));
    } catch (const models::ModelError& e) {
      throw UsageError(fmt::format("operation {}: {}", *file, e.what()));
    } catch (const models::DomainError& e) {
      throw UsageError(fmt::format("operation {}: {}", *file, e.what()));
    }
    if (options->json) {
      fmt::print("{}\n", scenarios::to_json(plan, *explain).dump(2));
    } else {
      print_plan(plan, *explain);
    }
  });
}

}  // namespace verstat::app
