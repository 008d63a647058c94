// Checks of operations, supply, stores and transport that one member alone cannot show.
#include <fmt/format.h>

#include "operations/kinds/duration.h"
#include "scenarios/check.h"

namespace verstat::scenarios {

namespace {

void check_supply(const PartType& part, const std::string& at) {
  if (const auto* arrivals = std::get_if<Interarrival>(&part.supply))
    check_takes_time(arrivals->time, at + "/time");
  if (const auto* profile = std::get_if<WeeklyProfile>(&part.supply)) {
    double before_h = 0;
    double expected = 0;
    for (std::size_t k = 0; k < profile->rates.size(); ++k) {
      const RatePeriod& period = profile->rates[k];
      const std::string pointer = fmt::format("{}/rates/{}", at, k);
      if (period.from_h < before_h)
        fail(pointer + "/from_h", fmt::format("{}", period.from_h),
             fmt::format("must not be before the end {} h of the period before it", before_h));
      if (!(period.to_h > period.from_h))
        fail(pointer + "/to_h", fmt::format("{}", period.to_h),
             fmt::format("must be after {} h", period.from_h));
      before_h = period.to_h;
      expected += period.per_h * (period.to_h - period.from_h);
    }
    if (!(expected > 1e-9)) fail(at + "/rates", "no arrivals in the whole week", "one rate must be positive");
  }
  if (const auto* list = std::get_if<OrderList>(&part.supply)) {
    if (!list->file.empty())
      fail(at + "/file", quoted(list->file),
           list->orders.empty() ? "can only be read where the scenario is a file of its own"
                                : "give orders or a file, not both");
    if (list->orders.empty()) fail(at + "/orders", "no entries", "must have at least one order");
    for (std::size_t k = 0; k < list->orders.size(); ++k) {
      const Order& order = list->orders[k];
      if (k > 0 && order.arrives_min < list->orders[k - 1].arrives_min)
        fail(fmt::format("{}/orders/{}/arrives_min", at, k), fmt::format("{}", order.arrives_min),
             "must not be before the order above it");
    }
  }
}

void check_groups(const Scenario& s, const Operation& operation, const std::string& at) {
  const int given = static_cast<int>(!operation.machine.empty()) +
                    static_cast<int>(!operation.machines.empty()) +
                    static_cast<int>(!operation.capability.empty());
  if (given != 1)
    fail(at + "/machine", given == 0 ? "nothing" : "more than one way to say who does it",
         "give one of machine, machines, capability");
  if (!operation.machine.empty()) check_reference(s.machines, operation.machine, at + "/machine", "machine");
  for (std::size_t k = 0; k < operation.machines.size(); ++k)
    check_reference(s.machines, operation.machines[k], fmt::format("{}/machines/{}", at, k), "machine");
  if (!operation.capability.empty() && groups_of(s, operation).empty()) {
    std::vector<std::string> known;
    for (const Machine& m : s.machines)
      known.insert(known.end(), m.capabilities.begin(), m.capabilities.end());
    check_reference(known, operation.capability, at + "/capability", "capability of any machine");
  }
}

bool is_place(const Scenario& s, const std::string& name) {
  return name == "*" || find_named(s.machines, name) != nullptr || find_named(s.stores, name) != nullptr;
}

}  // namespace

void check_operation_names(const Scenario& s, const Operation& operation, const std::string& at) {
  check_groups(s, operation, at);
  if (!operation.tool.empty()) check_reference(s.tools, operation.tool, at + "/tool", "tool");
}

void check_operation(const Scenario& s, const Operation& operation, const std::string& at) {
  check_incoming(s, operation, at);
  if (const auto* plain = operation.process.as<operations::PlainOperation>())
    check_law(plain->time, at + "/process/time");
  for (const std::size_t g : groups_of(s, operation)) {
    operations::CutPlan plan;
    try {
      plan = scenarios::plan(s, operation, s.machines[g]);
    } catch (const models::ModelError& e) {
      throw InputError(at + "/process", fmt::format("{}/process cannot be planned: {}", at, e.what()));
    } catch (const models::DomainError& e) {  // members of the specification that contradict each other
      throw InputError(at + "/process/" + e.input(), fmt::format("{}/process/{}", at, e.what()));
    }
    if (plan.main_time_min < 1e-6)
      fail(at + "/process", fmt::format("{} min", plan.main_time_min), "must take at least 1e-6 min");
  }
}

void check_part(const Scenario& s, const PartType& part, const std::string& at) {
  check_route(s, part, at);
  check_received_on_route(s, part, at);
  check_requirements(s, part, at);
  check_reference(s.stores, part.store, at + "/store", "store");
  check_supply(part, at + "/supply");
  if (part.due_after) check_law(*part.due_after, at + "/due_after");
  if (const auto* threshold = std::get_if<StationThreshold>(&part.release))
    check_reference(s.machines, threshold->machine, at + "/release/machine", "machine");
}

void check_store(const Scenario& s, const Store& store, const std::string& at) {
  if (store.demand) check_takes_time(*store.demand, at + "/demand");
  if (!store.capacity || store.demand) return;
  for (const PartType& part : s.parts)
    for (const Step& step : part.steps)
      for (const Component& component : step.assembles)
        if (find_named(s.parts, component.part)->store == store.name) return;
  fail(at + "/capacity", fmt::format("{}", *store.capacity),
       "nobody takes anything out of this store: it fills up and everything stops; give it demand, or leave "
       "out "
       "the capacity");
}

void check_transport(const Scenario& s, const Transport& transport, const std::string& at) {
  if (!is_place(s, transport.from)) check_reference(s.machines, transport.from, at + "/from", "machine");
  if (!is_place(s, transport.to)) check_reference(s.machines, transport.to, at + "/to", "machine or store");
  if (const auto* delay = std::get_if<TransportDelay>(&transport.carrier))
    check_law(delay->time, at + "/carrier/time");
  const auto* vehicles = std::get_if<Vehicles>(&transport.carrier);
  if (vehicles == nullptr) return;
  if (!vehicles->crew.empty()) check_crew_or_skill(s, vehicles->crew, at + "/carrier/crew");
  if (s.layout.empty())
    fail(at + "/carrier", "vehicles", "need the ways they drive on: give layout at the top of the scenario");
}

}  // namespace verstat::scenarios
