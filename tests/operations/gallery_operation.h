#pragma once
// An operation of the gallery, scenarios/gallery/operations/<name>.json, with what its shop adds.

#include <fstream>
#include <optional>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "operations/fields.h"
#include "scenarios/model_json.h"

namespace verstat::test {

struct GalleryOperation {
  operations::Process process;
  std::optional<operations::EdgeLife> edge;
  std::optional<operations::MachineLimits> machine;

  [[nodiscard]] operations::PlanContext context() const {
    return {edge ? &*edge : nullptr, machine ? &*machine : nullptr};
  }
  template <class Spec>
  [[nodiscard]] Spec spec() const {
    REQUIRE(process.as<Spec>() != nullptr);
    return *process.as<Spec>();
  }
};

inline models::Field field_named(const char* name) {
  models::Field f;
  f.name = name;
  return f;
}

template <class T>
T from_json(const nlohmann::json& json, const char* name) {
  T value{};
  models::detail::Binding<T>::read(value, scenarios::to_value(json), field_named(name));
  models::detail::Binding<T>::check(value, field_named(name));
  return value;
}

/// Reads the file; writing the operation and reading it again must give the same text.
inline GalleryOperation gallery_operation(const std::string& name) {
  std::ifstream file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + name + ".json");
  REQUIRE(file);
  const nlohmann::json json = nlohmann::json::parse(file);
  GalleryOperation read;
  read.process = from_json<operations::Process>(json.at("process"), "process");
  if (json.contains("edge_life")) read.edge = from_json<operations::EdgeLife>(json["edge_life"], "edge_life");
  if (json.contains("machine_limits"))
    read.machine = from_json<operations::MachineLimits>(json["machine_limits"], "machine_limits");

  using Binding = models::detail::Binding<operations::Process>;
  const models::Value written = Binding::write(read.process);
  operations::Process again;
  Binding::read(again, written, field_named("process"));
  CHECK(Binding::write(again) == written);
  return read;
}

inline double number(const operations::CutPlan& plan, const std::string& name) {
  INFO(name);
  const auto value = plan.value_of(name);
  REQUIRE(value.has_value());
  return *value;
}

inline double margin_of(const operations::CutPlan& plan, const std::string& name) {
  for (const operations::Limit& limit : plan.limits)
    if (name == limit.name) return limit.margin();
  FAIL("no limit " + name);
  return 0;
}

/// Message of the error that planning this specification raises.
template <class Spec>
std::string plan_error(const Spec& spec, const operations::PlanContext& context = {}) {
  try {
    (void)plan(spec, context);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "planned";
}

}  // namespace verstat::test
