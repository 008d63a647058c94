#pragma once
// That operations, routes, supply, transport and stores are described; the descriptions stand in
// flow_fields.cpp.

#include "models/catalogue/field.h"
#include "scenarios/flow.h"

namespace verstat::models {

template <>
struct EnumNames<scenarios::Choice> {
  static constexpr std::array names{std::pair{scenarios::Choice::shortest_queue, "shortest_queue"},
                                    std::pair{scenarios::Choice::in_turn, "in_turn"}};
};
template <>
struct EnumNames<scenarios::BranchChoice> {
  static constexpr std::array names{std::pair{scenarios::BranchChoice::by_probability, "by_probability"},
                                    std::pair{scenarios::BranchChoice::shortest_queue, "shortest_queue"}};
};

#define VERSTAT_DESCRIBED(S)            \
  template <>                           \
  struct StructFields<scenarios::S> {   \
    static std::vector<Field> fields(); \
  }
VERSTAT_DESCRIBED(Quality);
VERSTAT_DESCRIBED(Inspection);
VERSTAT_DESCRIBED(Incoming);
VERSTAT_DESCRIBED(Requirement);
VERSTAT_DESCRIBED(Operation);
VERSTAT_DESCRIBED(AlwaysAvailable);
VERSTAT_DESCRIBED(Interarrival);
VERSTAT_DESCRIBED(RatePeriod);
VERSTAT_DESCRIBED(WeeklyProfile);
VERSTAT_DESCRIBED(Order);
VERSTAT_DESCRIBED(OrderList);
VERSTAT_DESCRIBED(Push);
VERSTAT_DESCRIBED(Conwip);
VERSTAT_DESCRIBED(StationThreshold);
VERSTAT_DESCRIBED(Branch);
VERSTAT_DESCRIBED(Component);
VERSTAT_DESCRIBED(Step);
VERSTAT_DESCRIBED(PartType);
VERSTAT_DESCRIBED(Store);
VERSTAT_DESCRIBED(TransportDelay);
VERSTAT_DESCRIBED(Conveyor);
VERSTAT_DESCRIBED(Vehicles);
VERSTAT_DESCRIBED(Transport);
VERSTAT_DESCRIBED(LayoutEdge);
#undef VERSTAT_DESCRIBED

}  // namespace verstat::models
