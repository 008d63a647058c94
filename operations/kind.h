#pragma once
// Operation kinds: each a typed specification (what the engineer states) and a plan computed from it by the
// process models (what follows). One file pair operations/kinds/<kind>.{h,cpp}; CMake finds it by its name:
//
//   // operations/kinds/turning.h
//   namespace verstat::operations {
//   struct Turning {
//     static constexpr const char* kind = "turning";   // "kind" in JSON, and the file's name
//     double cutting_speed_m_min = 0; ...
//   };
//   [[nodiscard]] CutPlan plan(const Turning& spec, const PlanContext& context);
//   }
//   // operations/kinds/turning.cpp: StructFields<Turning> (see operations/fields.h), plan(), and
//   namespace verstat::operations::turning { void add_to(Kinds& kinds) { kinds.add<Turning>("summary",
//   {"K117"}); } }

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/catalogue/field.h"
#include "operations/cut_plan.h"
#include "operations/edge_life.h"
#include "operations/safety_clutch.h"

namespace verstat::operations {

/// What the machine can do; absent: no limit known.
struct MachineLimits {
  std::optional<double> power_kw;
  std::optional<double> spindle_speed_max_rpm;
  std::optional<double> spindle_speed_min_rpm;
  std::optional<double> torque_max_nm;
  std::optional<double> feed_force_max_n;
  std::optional<double> feed_rate_max_mm_min;
  std::optional<SafetyClutch> safety_clutch;
};
struct Spindle;

/// What the shop adds to the specification: the edge that the tool brings, the machine's limits and spindle.
struct PlanContext {
  const EdgeLife* edge = nullptr;  ///< null: the operation has no tool with edges
  const MachineLimits* machine = nullptr;
  const Spindle* spindle = nullptr;  ///< operations/spindle.h; null: nothing known of its dynamics
};

/// Holds a plan against what the machine adds whatever the operation: speed bands, stable width and form
/// error of its spindle, overloads of its safety clutch. Done for every plan that a Kind or Process makes.
/// Throws models::ModelError where the machine's own models refuse.
void add_machine(CutPlan& plan, const PlanContext& context);

/// A kind, type-erased.
class Kind {
 public:
  Kind(std::string kind_name, std::string kind_summary, std::vector<std::string> kind_sources)
      : name(std::move(kind_name)), summary(std::move(kind_summary)), sources(std::move(kind_sources)) {}
  Kind(const Kind&) = delete;
  Kind& operator=(const Kind&) = delete;
  virtual ~Kind() = default;

  const std::string name;                  ///< "turning"
  const std::string summary;               ///< one sentence
  const std::vector<std::string> sources;  ///< cards, "K117"

  [[nodiscard]] virtual const std::vector<models::Field>& fields() const = 0;
  [[nodiscard]] virtual std::shared_ptr<void> make() const = 0;
  [[nodiscard]] virtual std::shared_ptr<void> copy(const void* spec) const = 0;
  /// Throws models::ModelError for a specification outside the models' ranges.
  [[nodiscard]] virtual CutPlan plan(const void* spec, const PlanContext& context) const = 0;
};

class Kinds {
 public:
  template <class Spec>
  void add(std::string summary, std::vector<std::string> sources);
  [[nodiscard]] const std::vector<std::unique_ptr<Kind>>& all() const { return kinds_; }
  [[nodiscard]] const Kind* find(const std::string& name) const;

 private:
  template <class Spec>
  class KindOf;
  std::vector<std::unique_ptr<Kind>> kinds_;  // by name
};

/// The kinds of this program: built at the first call, constant afterwards.
[[nodiscard]] const Kinds& kinds();

/// An operation of any kind: a value, copied deeply.
class Process {
 public:
  Process() = default;
  template <class Spec>
  explicit Process(Spec spec)
      : kind_(kinds().find(Spec::kind)), spec_(std::make_shared<Spec>(std::move(spec))) {}
  Process(const Kind& kind, std::shared_ptr<void> spec) : kind_(&kind), spec_(std::move(spec)) {}
  Process(const Process& other) { *this = other; }
  Process& operator=(const Process& other) {
    if (this == &other) return *this;
    kind_ = other.kind_;
    spec_ = other.spec_ == nullptr ? nullptr : kind_->copy(other.spec_.get());
    return *this;
  }
  Process(Process&&) = default;
  Process& operator=(Process&&) = default;
  ~Process() = default;

  /// Null before anything is read into it.
  [[nodiscard]] const Kind* kind() const { return kind_; }
  [[nodiscard]] void* spec() const { return spec_.get(); }
  /// The specification when it is of this type, else null.
  template <class Spec>
  [[nodiscard]] const Spec* as() const {
    return kind_ != nullptr && kind_->name == Spec::kind ? static_cast<const Spec*>(spec_.get()) : nullptr;
  }
  [[nodiscard]] CutPlan plan(const PlanContext& context) const { return kind_->plan(spec_.get(), context); }

 private:
  const Kind* kind_ = nullptr;
  std::shared_ptr<void> spec_;
};

namespace detail {
template <class Spec>
CutPlan plan_of(const Spec& spec, const PlanContext& context) {
  CutPlan made = plan(spec, context);  // found by argument: each kind declares its own
  if (context.spindle != nullptr || context.machine != nullptr) add_machine(made, context);
  return made;
}
}  // namespace detail

template <class Spec>
class Kinds::KindOf final : public Kind {
 public:
  using Kind::Kind;
  [[nodiscard]] const std::vector<models::Field>& fields() const override {
    return models::detail::Binding<Spec>::fields();
  }
  [[nodiscard]] std::shared_ptr<void> make() const override { return std::make_shared<Spec>(); }
  [[nodiscard]] std::shared_ptr<void> copy(const void* spec) const override {
    return std::make_shared<Spec>(*static_cast<const Spec*>(spec));
  }
  [[nodiscard]] CutPlan plan(const void* spec, const PlanContext& context) const override {
    return detail::plan_of(*static_cast<const Spec*>(spec), context);
  }
};

template <class Spec>
void Kinds::add(std::string summary, std::vector<std::string> sources) {
  kinds_.push_back(std::make_unique<KindOf<Spec>>(Spec::kind, std::move(summary), std::move(sources)));
}

}  // namespace verstat::operations

/// Reads {"kind": "turning", ...} through the registry of kinds.
template <>
struct verstat::models::detail::Binding<verstat::operations::Process> {
  using Process = operations::Process;
  static void read(Process& to, const Value& v, const Field& f);
  static Value write(const Process& x);
  static void check(const Process& x, const Field& f);
  static bool finite(const Process& x);
  static double* locate(Process& x, std::span<const std::string> path);
  static TypeInfo type();
};
