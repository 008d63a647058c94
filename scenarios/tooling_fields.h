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
struct EnumNames<scenarios::RejectedLot> {
  static constexpr std::array names{std::pair{scenarios::RejectedLot::send_back, "send_back"},
                                    std::pair{scenarios::RejectedLot::retreat, "retreat"}};
};
template <>
struct EnumNames<scenarios::LoadSharing> {
  static constexpr std::array names{std::pair{scenarios::LoadSharing::local, "local"},
                                    std::pair{scenarios::LoadSharing::global, "global"},
                                    std::pair{scenarios::LoadSharing::none, "none"}};
};
template <>
struct EnumNames<scenarios::ReplaceTeeth> {
  using E = scenarios::ReplaceTeeth;
  static constexpr std::array names{std::pair{E::all, "all"}, std::pair{E::failed, "failed"},
                                    std::pair{E::failed_and_older_than, "failed_and_older_than"}};
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
struct StructFields<scenarios::InsertStock> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::CertifiedLots> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ReplaceAtFailedTeeth> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ShareOfLife> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ForceGrowth> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ConditionBased> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::Opportunistic> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::Presetting> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::Regrind> {
  static std::vector<Field> fields();
};
template <>
struct StructFields<scenarios::ElementService> {
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
