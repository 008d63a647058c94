#pragma once
// An operation of the gallery with its specification in C++, to be varied by tests.

#include <string>

#include <catch2/catch.hpp>

#include "operations/kind.h"
#include "scenarios/json_text.h"
#include "scenarios/model_json.h"
#include "scenarios/plan_json.h"

namespace verstat::test {

template <class Spec>
struct GalleryExample {
  scenarios::OperationFile file;
  Spec spec;

  explicit GalleryExample(const std::string& name = Spec::kind)
      : file(scenarios::load_operation(scenarios::read_json_file(
            std::string(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/") + name + ".json"))) {
    REQUIRE(file.process.as<Spec>() != nullptr);
    spec = *file.process.as<Spec>();
  }
  [[nodiscard]] operations::PlanContext context() const {
    return {.edge = file.edge_life ? &*file.edge_life : nullptr, .machine = &file.machine_limits};
  }
  /// The plan of the specification as it stands now.
  [[nodiscard]] operations::CutPlan plan() const { return operations::detail::plan_of(spec, context()); }
};

inline double value(const operations::CutPlan& plan, const std::string& name) {
  INFO(name);
  const auto found = plan.value_of(name);
  REQUIRE(found.has_value());
  return *found;
}

inline const operations::Limit& limit(const operations::CutPlan& plan, const std::string& name) {
  for (const operations::Limit& l : plan.limits)
    if (name == l.name) return l;
  FAIL("no limit " << name);
  throw std::logic_error("unreachable");
}

/// What is written is read again to the same, member by member.
template <class Spec>
void check_round_trip(const GalleryExample<Spec>& example) {
  using Binding = models::detail::Binding<operations::Process>;
  const models::Value written = Binding::write(example.file.process);
  operations::Process again;
  models::Field field;
  field.name = "process";
  Binding::read(again, scenarios::to_value(scenarios::to_json(written)), field);
  CHECK(scenarios::to_json(Binding::write(again)) == scenarios::to_json(written));
  CHECK(again.plan(example.context()).main_time_min == example.plan().main_time_min);
}

}  // namespace verstat::test
