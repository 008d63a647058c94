#pragma once
// That inserts, tools and strategies are described; the descriptions stand in tooling_fields.cpp.

#include "models/catalogue/field.h"
#include "scenarios/tooling.h"

namespace verstat::models {

template <>
struct EnumNames<scenarios::InsertBooking> {
  static constexpr std::array names{std::pair{scenarios::InsertBooking::life_periods, "life_periods"},
                                    std::pair{scenarios::InsertBooking::at_fitting, "at_fitting"}};
};
template <>
struct StructFields<scenarios::Insert> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::RunToFailure> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::AgeReplacement> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::PartCountReplacement> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::BlockReplacement> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ToolChange> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::Tool> {
  static std::vector<Field> fields();
};

}  // namespace verstat::models
