#pragma once
// Short forms for describing the members of an operation's specification, and the structures that kinds
// share.

#include "models/catalogue/field.h"
#include "operations/duration.h"
#include "operations/edge_life.h"
#include "operations/kind.h"
#include "operations/spindle.h"

namespace verstat::models {

/// A member that must be given.
template <class S, class T, class B>
Field need(T B::*pointer, std::string_view name, std::string_view unit, const Range& range,
           std::string_view meaning) {
  return member<S>(pointer, name, "", unit, range, meaning, true);
}
/// A member that may be left out: the default is what a default-constructed S holds.
template <class S, class T, class B>
Field may(T B::*pointer, std::string_view name, std::string_view unit, const Range& range,
          std::string_view meaning) {
  return member<S>(pointer, name, "", unit, range, meaning, false);
}
/// A list with a number of entries.
inline Field entries(Field f, std::size_t least, std::size_t most) {
  f.min_length = least;
  f.max_length = most;
  return f;
}

/// Durations up to nineteen centuries: beyond any plan, and still exact in a double.
inline constexpr Range duration_min = closed(0, 1e9);

template <>
struct StructFields<operations::ConstantDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::ExponentialDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::UniformDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::TriangularDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::LognormalDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::GammaDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::WeibullDuration> {
  static std::vector<Field> fields();
};
template <>
struct EnumNames<operations::BetweenValues> {
  static constexpr std::array names{std::pair{operations::BetweenValues::linear, "linear"},
                                    std::pair{operations::BetweenValues::step, "step"}};
};
template <>
struct StructFields<operations::EmpiricalDuration> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::EdgeLife> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::MachineLimits> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::SafetyClutch> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<operations::Spindle> {
  static std::vector<Field> fields();
};

}  // namespace verstat::models

namespace verstat::operations {

/// Throws models::DomainError when a law's own members contradict each other (low above high); `name` opens
/// the path.
void check_duration(const Duration& duration, const std::string& name);

}  // namespace verstat::operations
