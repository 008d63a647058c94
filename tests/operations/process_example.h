#pragma once
// What the tests of operation kinds share: the example of the gallery, and what is wrong with a changed one.

#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "operations/fields.h"
#include "operations/kind.h"
#include "scenarios/model_json.h"

namespace verstat::test {

using ProcessBinding = models::detail::Binding<operations::Process>;

inline nlohmann::json gallery_json(const std::string& name) {
  std::ifstream file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + name + ".json");
  if (!file) throw std::runtime_error("no gallery operation " + name + "; run from the root of the tree");
  return nlohmann::json::parse(file);
}

inline operations::Process process_of(const nlohmann::json& json) {
  operations::Process process;
  models::Field field;
  field.name = "process";
  ProcessBinding::read(process, scenarios::to_value(json), field);
  ProcessBinding::check(process, field);
  return process;
}

/// The specification of a gallery operation.
template <class Spec>
Spec gallery_spec(const std::string& name) {
  const operations::Process process = process_of(gallery_json(name).at("process"));
  if (process.as<Spec>() == nullptr) throw std::runtime_error(name + " is of another kind");
  return *process.as<Spec>();
}

inline operations::MachineLimits gallery_machine(const std::string& name) {
  operations::MachineLimits limits;
  models::detail::Binding<operations::MachineLimits>::read(
      limits, scenarios::to_value(gallery_json(name).at("machine_limits")), models::Field{});
  return limits;
}

/// Written and read again, the operation is the same.
inline bool survives_json(const std::string& name) {
  const operations::Process process = process_of(gallery_json(name).at("process"));
  const models::Value written = ProcessBinding::write(process);
  return ProcessBinding::write(process_of(scenarios::to_json(written))) == written;
}

/// The message with which a plan is refused; empty when it is not.
template <class Spec>
std::string refusal(const Spec& spec) {
  try {
    (void)plan(spec, operations::PlanContext{});
    return {};
  } catch (const std::exception& e) {
    return e.what();
  }
}
/// The message with which a changed JSON is refused.
inline std::string refusal(const nlohmann::json& process) {
  try {
    (void)process_of(process);
    return {};
  } catch (const std::exception& e) {
    return e.what();
  }
}

inline const operations::Limit& limit_of(const operations::CutPlan& plan, const std::string& name) {
  for (const operations::Limit& limit : plan.limits)
    if (name == limit.name) return limit;
  throw std::runtime_error("no limit " + name);
}

}  // namespace verstat::test
