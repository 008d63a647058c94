#pragma once
// What the tests of operation kinds share: an operation of the gallery with what its shop adds, to be varied,
// and what stands in a plan.

#include <optional>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "operations/fields.h"
#include "operations/kind.h"
#include "scenarios/json_text.h"
#include "scenarios/model_json.h"
#include "scenarios/plan_json.h"

namespace verstat::test {

/// scenarios/gallery/operations/<name>.json as the command line reads it.
struct Gallery {
  explicit Gallery(const std::string& name)
      : json(scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + name + ".json")),
        file(scenarios::load_operation(json)) {}

  nlohmann::json json;
  scenarios::OperationFile file;

  [[nodiscard]] operations::PlanContext context() const {
    return {.edge = file.edge_life ? &*file.edge_life : nullptr,
            .machine = &file.machine_limits,
            .spindle = file.spindle ? &*file.spindle : nullptr};
  }
  template <class Spec>
  [[nodiscard]] Spec spec() const {
    REQUIRE(file.process.as<Spec>() != nullptr);
    return *file.process.as<Spec>();
  }
  /// The plan of a changed specification in the same shop.
  template <class Spec>
  [[nodiscard]] operations::CutPlan plan(const Spec& changed) const {
    return operations::detail::plan_of(changed, context());
  }
};

/// A gallery operation with its specification in C++.
template <class Spec>
struct GalleryExample : Gallery {
  Spec spec;
  explicit GalleryExample(const std::string& name = Spec::kind)
      : Gallery(name), spec(Gallery::spec<Spec>()) {}
  /// The plan of the specification as it stands now.
  [[nodiscard]] operations::CutPlan plan() const { return Gallery::plan(spec); }
};

/// An operation from the JSON of its specification.
inline operations::Process process_of(const nlohmann::json& json) {
  using Binding = models::detail::Binding<operations::Process>;
  operations::Process process;
  models::Field field;
  field.name = "process";
  Binding::read(process, scenarios::to_value(json), field);
  Binding::check(process, field);
  return process;
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

inline double margin_of(const operations::CutPlan& plan, const std::string& name) {
  return limit_of(plan, name).margin();
}

/// The message with which a plan is refused; empty when it is not.
template <class Spec>
requires(!std::same_as<Spec, nlohmann::json>) std::string
    refusal(const Spec& spec, const operations::PlanContext& context = {}) {
  try {
    (void)operations::detail::plan_of(spec, context);
  } catch (const models::ModelError& e) {
    return e.what();
  } catch (const models::DomainError& e) {
    return e.what();
  }
  return {};
}
/// The message with which the JSON of a specification is refused.
inline std::string refusal(const nlohmann::json& process) {
  try {
    (void)process_of(process);
  } catch (const models::DomainError& e) {
    return e.what();
  }
  return {};
}

}  // namespace verstat::test
