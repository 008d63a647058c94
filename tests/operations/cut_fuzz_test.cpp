// Whatever a user changes in an example operation gives a plan of finite numbers, or an error.

#include <cmath>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;

namespace {

constexpr double factors[] = {-1, 0, 1e-3, 0.1, 0.5, 0.9, 1.1, 2, 10, 1e3};

bool all_finite(const operations::CutPlan& plan) {
  bool finite = std::isfinite(plan.main_time_min) && plan.main_time_min >= 0 && plan.scrap_probability >= 0 &&
                plan.scrap_probability <= 1;
  for (const auto& q : plan.quantities) finite = finite && std::isfinite(q.value);
  for (const auto& q : plan.consumables) finite = finite && std::isfinite(q.value);
  for (const auto& l : plan.limits) finite = finite && std::isfinite(l.margin());
  for (const auto& b : plan.bands) finite = finite && b.low <= b.high;
  return finite && (!plan.edge || (std::isfinite(plan.edge->mean_min) && plan.edge->mean_min > 0));
}

}  // namespace

TEST_CASE("changed examples give finite plans or errors") {
  for (const std::string name :
       {"turning", "hard_turning", "stone_turning", "roll_machining", "thermo_friction", "thread_rolling",
        "auger_winding", "gear_rolling", "tool_steel_finishing", "drill_finishing", "magnetic_abrasive",
        "pulse_current", "blade_finishing", "coating", "reaming", "gauge_inspection", "inspection",
        "cutting_off", "gear_generating"}) {
    const test::Gallery example(name);
    const auto leaves = example.json.at("process").flatten();
    test::property(name, [&] {
      auto flat = leaves;
      const int changes = *rc::gen::inRange(1, 4);
      for (int k = 0; k < changes; ++k) {
        auto leaf = flat.begin();
        std::advance(leaf, *rc::gen::inRange<int>(0, static_cast<int>(flat.size())));
        const double factor = factors[*rc::gen::inRange<std::size_t>(0, std::size(factors))];
        if (leaf->is_number_float()) *leaf = leaf->get<double>() * factor;
        if (leaf->is_number_integer()) *leaf = std::llround(leaf->get<double>() * factor);
        if (leaf->is_boolean()) *leaf = !leaf->get<bool>();
      }
      models::Field field;
      field.name = "process";
      operations::Process process;
      try {
        using Binding = models::detail::Binding<operations::Process>;
        Binding::read(process, scenarios::to_value(flat.unflatten()), field);
        Binding::check(process, field);
        RC_ASSERT(all_finite(process.plan(example.context())));
        RC_TAG("planned");
      } catch (const models::ModelError& e) {
        RC_ASSERT(std::string(e.what()).size() > 10);
        RC_TAG("refused by a model");
      } catch (const models::DomainError& e) {
        RC_ASSERT(std::string(e.what()).size() > 10);
        RC_TAG("refused");
      }
    });
  }
}
