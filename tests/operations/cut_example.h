#pragma once
// Reads the example operations of the gallery, and looks things up in a plan.

#include <string>

#include <catch2/catch.hpp>

#include "operations/fields.h"
#include "operations/kind.h"
#include "scenarios/load.h"
#include "scenarios/model_json.h"

namespace verstat::test {

/// A gallery operation as the command line reads it.
struct CutExample {
  explicit CutExample(const std::string& name)
      : json(
            scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + name + ".json")) {
    models::Field field;
    field.name = "process";
    models::detail::Binding<operations::Process>::read(process, scenarios::to_value(json.at("process")),
                                                       field);
    models::detail::Binding<operations::Process>::check(process, field);
    if (json.contains("edge_life")) {
      field.name = "edge_life";
      models::detail::Binding<operations::EdgeLife>::read(edge, scenarios::to_value(json.at("edge_life")),
                                                          field);
      context.edge = &edge;
    }
    if (json.contains("machine_limits")) {
      field.name = "machine_limits";
      models::detail::Binding<operations::MachineLimits>::read(
          machine, scenarios::to_value(json.at("machine_limits")), field);
      context.machine = &machine;
    }
  }
  CutExample(const CutExample&) = delete;
  CutExample& operator=(const CutExample&) = delete;

  nlohmann::json json;
  operations::Process process;
  operations::EdgeLife edge;
  operations::MachineLimits machine;
  operations::PlanContext context;
};

/// What is written can be read again and says the same.
inline void check_round_trip(const operations::Process& process) {
  using Binding = models::detail::Binding<operations::Process>;
  const auto written = scenarios::to_json(Binding::write(process)).dump();
  models::Field field;
  field.name = "process";
  operations::Process again;
  Binding::read(again, scenarios::to_value(nlohmann::json::parse(written)), field);
  CHECK(scenarios::to_json(Binding::write(again)).dump() == written);
}

inline double value_of(const operations::CutPlan& plan, const std::string& name) {
  INFO(name);
  const auto value = plan.value_of(name);
  REQUIRE(value.has_value());
  return *value;
}

inline const operations::Limit& limit_of(const operations::CutPlan& plan, const std::string& name) {
  for (const operations::Limit& limit : plan.limits)
    if (name == limit.name) return limit;
  FAIL("the plan has no limit " << name);
  throw std::logic_error("not reached");
}

/// Message of the error that planning raises, "planned" when there is none.
template <class Spec>
std::string planning_error(const Spec& spec, const operations::PlanContext& context = {}) {
  try {
    (void)plan(spec, context);
  } catch (const models::ModelError& e) {
    return e.what();
  } catch (const models::DomainError& e) {
    return e.what();
  }
  return "planned";
}

}  // namespace verstat::test
