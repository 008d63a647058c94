// The one description of operations, routes, supply, transport and stores: name, unit, valid range, default,
// meaning.
#include "scenarios/flow_fields.h"

#include "operations/fields.h"

namespace verstat::models {

using namespace scenarios;

namespace {
constexpr Range money = closed(0, 1e12);
constexpr Range minutes = closed(0, 1e9);
constexpr Range counts = closed(1, 1'000'000);
}  // namespace

std::vector<Field> StructFields<Quality>::fields() {
  using Q = Quality;
  return {may<Q>(&Q::scrap_probability, "scrap_probability", "1", probability(),
                 "chance that the operation spoils a part and everybody sees it"),
          may<Q>(&Q::defect_probability, "defect_probability", "1", probability(),
                 "chance of a defect that stays hidden until an inspection"),
          may<Q>(&Q::defect_when_worn, "defect_when_worn", "1", probability(),
                 "added to it when the edge has cut for its mean life"),
          may<Q>(&Q::wear_exponent, "wear_exponent", "1", open_low(0, 10),
                 "the addition grows as the used share of the mean life to this power")};
}
std::vector<Field> StructFields<Inspection>::fields() {
  using I = Inspection;
  return {
      may<I>(&I::share, "share", "1", probability(), "share of the parts that are inspected"),
      may<I>(&I::sensitivity, "sensitivity", "1", probability(), "chance that a defective part is rejected"),
      may<I>(&I::specificity, "specificity", "1", probability(), "chance that a good part passes"),
      may<I>(&I::acceptance_number, "acceptance_number", "parts", closed(0, 1'000'000),
             "more rejects than this in a batch reject the whole batch; null: parts are judged one by one")};
}
std::vector<Field> StructFields<Incoming>::fields() {
  using I = Incoming;
  return {need<I>(&I::from, "from", "-", no_range(), "name of an operation earlier on every route"),
          need<I>(&I::quantity, "quantity", "-", no_range(), "quantity that it leaves with the part"),
          need<I>(&I::input, "input", "-", no_range(),
                  "member of this operation's process that becomes it, for instance \"ra_before_um\""),
          may<I>(&I::factor, "factor", "1", closed(-1e9, 1e9), "multiplies it on the way")};
}
std::vector<Field> StructFields<Requirement>::fields() {
  using R = Requirement;
  return {need<R>(&R::quantity, "quantity", "-", no_range(),
                  "quantity that an operation of the route leaves with the part"),
          may<R>(&R::at_least, "at_least", "1", any(), "in the unit of the quantity; null: no lower bound"),
          may<R>(&R::at_most, "at_most", "1", any(), "in the unit of the quantity; null: no upper bound"),
          may<R>(&R::sd, "sd", "1", closed(0, 1e12),
                 "scatter from part to part, besides that which the operation states")};
}
std::vector<Field> StructFields<Operation>::fields() {
  using O = Operation;
  return {
      need<O>(&O::name, "name", "-", no_range(), "name that routes refer to"),
      may<O>(&O::machine, "machine", "-", no_range(), "name of the machine group that does it"),
      entries(may<O>(&O::machines, "machines", "-", no_range(),
                     "instead of machine: names of several groups to choose from"),
              0, 1000),
      may<O>(&O::capability, "capability", "-", no_range(),
             "instead of machine: any group that has this capability"),
      may<O>(&O::choice, "choice", "-", no_range(), "which of several groups is chosen"),
      may<O>(&O::tool, "tool", "-", no_range(), "name of the tool; empty: nothing that wears"),
      may<O>(&O::family, "family", "-", no_range(), "family for setting up; empty: the operation's name"),
      need<O>(&O::process, "process", "-", no_range(), "what is done: a process model or a plain duration"),
      entries(may<O>(&O::incoming, "incoming", "-", no_range(),
                     "members of the process that follow from the state in which the part arrives"),
              0, 100),
      may<O>(&O::quality, "quality", "-", no_range(), "what goes wrong besides tool failures"),
      may<O>(&O::inspection, "inspection", "-", no_range(), "makes the operation an inspection"),
      may<O>(&O::cost, "cost", "money", money, "per part besides machine and people")};
}

std::vector<Field> StructFields<AlwaysAvailable>::fields() {
  return {};
}
std::vector<Field> StructFields<Interarrival>::fields() {
  return {need<Interarrival>(&Interarrival::time, "time", "min", no_range(), "time between batches")};
}
std::vector<Field> StructFields<RatePeriod>::fields() {
  using R = RatePeriod;
  return {
      need<R>(&R::from_h, "from_h", "h", closed(0, 168), "from this hour of the week (Monday 00:00 is 0)"),
      need<R>(&R::to_h, "to_h", "h", open_low(0, 168), "to this hour of the week"),
      need<R>(&R::per_h, "per_h", "1/h", closed(0, 1e6), "batches an hour")};
}
std::vector<Field> StructFields<WeeklyProfile>::fields() {
  return {entries(need<WeeklyProfile>(&WeeklyProfile::rates, "rates", "-", no_range(),
                                      "rates by hours of the week; nothing comes in between"),
                  1, 1000)};
}
std::vector<Field> StructFields<Order>::fields() {
  return {need<Order>(&Order::arrives_min, "arrives_min", "min", minutes, "when the order comes"),
          may<Order>(&Order::quantity, "quantity", "parts", counts, "parts ordered"),
          may<Order>(&Order::due_min, "due_min", "min", minutes, "when they are due; null: see due_after")};
}
std::vector<Field> StructFields<OrderList>::fields() {
  return {
      entries(may<OrderList>(&OrderList::orders, "orders", "-", no_range(), "orders"), 0, 1'000'000),
      may<OrderList>(
          &OrderList::file, "file", "-", no_range(),
          "instead of orders: a CSV table beside the scenario with columns arrives, quantity, due, part")};
}

std::vector<Field> StructFields<Push>::fields() {
  return {};
}
std::vector<Field> StructFields<Conwip>::fields() {
  return {
      need<Conwip>(&Conwip::cap, "cap", "batches", counts, "batches of the part type in the shop at most")};
}
std::vector<Field> StructFields<StationThreshold>::fields() {
  using T = StationThreshold;
  return {need<T>(&T::machine, "machine", "-", no_range(), "machine group whose queue is watched"),
          may<T>(&T::queue, "queue", "batches", counts, "released while fewer than this wait")};
}

std::vector<Field> StructFields<Branch>::fields() {
  return {may<Branch>(&Branch::to, "to", "-", no_range(), "name of a step; empty: the part is finished"),
          may<Branch>(&Branch::probability, "probability", "1", probability(), "share of the parts")};
}
std::vector<Field> StructFields<Component>::fields() {
  return {need<Component>(&Component::part, "part", "-", no_range(), "name of a part type"),
          may<Component>(&Component::count, "count", "1", counts, "pieces per part")};
}
std::vector<Field> StructFields<Step>::fields() {
  using S = Step;
  return {need<S>(&S::name, "name", "-", no_range(), "name that branches refer to"),
          need<S>(&S::operation, "operation", "-", no_range(), "name of the operation"),
          entries(may<S>(&S::next, "next", "-", no_range(),
                         "where parts go; empty: to the next step of the list, after the last to the store"),
                  0, 1000),
          may<S>(&S::choice, "choice", "-", no_range(), "how one of several branches is chosen"),
          entries(may<S>(&S::assembles, "assembles", "-", no_range(),
                         "finished parts of other types that are taken from their stores"),
                  0, 100),
          entries(may<S>(&S::yields, "yields", "-", no_range(),
                         "blanks of other part types that are set free, each starting its own route"),
                  0, 100),
          may<S>(&S::rework, "rework", "-", no_range(),
                 "step that rejected parts go to; empty: they are scrapped"),
          may<S>(&S::rework_limit, "rework_limit", "1", closed(1, 1000), "times a part may be reworked")};
}
std::vector<Field> StructFields<PartType>::fields() {
  using P = PartType;
  return {
      need<P>(&P::name, "name", "-", no_range(), "name of the part"),
      may<P>(&P::supply, "supply", "-", no_range(), "how blanks come"),
      entries(may<P>(&P::route, "route", "-", no_range(), "names of the operations in order; or steps"), 0,
              1000),
      entries(may<P>(&P::steps, "steps", "-", no_range(), "instead of route: a graph of operations"), 0,
              1000),
      may<P>(&P::value, "value", "money", money, "what a scrapped part loses"),
      need<P>(&P::store, "store", "-", no_range(), "name of the store for good parts"),
      may<P>(&P::batch_size, "batch_size", "parts", closed(1, 100'000), "parts that move together"),
      may<P>(&P::priority, "priority", "1", closed(-1000, 1000), "smaller is more urgent"),
      may<P>(&P::release, "release", "-", no_range(), "when blanks are let into the shop"),
      may<P>(&P::due_after, "due_after", "min", no_range(), "allowance from arrival to due date; null: none"),
      may<P>(&P::escape_cost, "escape_cost", "money", money, "when a defective part leaves the shop"),
      may<P>(&P::tardiness_cost_per_min, "tardiness_cost_per_min", "money/min", money,
             "per part and minute after the due date"),
      entries(may<P>(&P::requirements, "requirements", "-", no_range(),
                     "what the drawing asks of the finished part; one that falls short is defective"),
              0, 100),
      may<P>(&P::price, "price", "money", money, "what a good part brings: for the criteria of efficiency")};
}
std::vector<Field> StructFields<scenarios::Store>::fields() {
  using S = scenarios::Store;
  return {
      need<S>(&S::name, "name", "-", no_range(), "name that parts refer to"),
      may<S>(&S::capacity, "capacity", "parts", counts, "parts it can hold; null: no bound"),
      may<S>(&S::demand, "demand", "min", no_range(), "time between customers who take one part; null: none"),
      may<S>(&S::demand_lost_cost, "demand_lost_cost", "money", money,
             "when a customer finds the store empty and leaves")};
}

std::vector<Field> StructFields<TransportDelay>::fields() {
  return {need<TransportDelay>(&TransportDelay::time, "time", "min", no_range(), "law of the time")};
}
std::vector<Field> StructFields<Conveyor>::fields() {
  return {may<Conveyor>(&Conveyor::capacity, "capacity", "batches", counts, "batches on it at the same time"),
          need<Conveyor>(&Conveyor::time_min, "time_min", "min", minutes, "from end to end")};
}
std::vector<Field> StructFields<Vehicles>::fields() {
  using V = Vehicles;
  return {may<V>(&V::count, "count", "1", closed(1, 10'000), "vehicles or cranes"),
          may<V>(&V::speed_m_min, "speed_m_min", "m/min", open_low(0, 1e5), "speed"),
          may<V>(&V::pick_up_min, "pick_up_min", "min", minutes, "time to take a batch"),
          may<V>(&V::set_down_min, "set_down_min", "min", minutes, "time to set it down"),
          may<V>(&V::crew, "crew", "-", no_range(), "crew or skill that drives; empty: nobody is needed"),
          may<V>(&V::rate_per_min, "rate_per_min", "money/min", money, "cost of a minute of work")};
}
std::vector<Field> StructFields<Transport>::fields() {
  using T = Transport;
  return {need<T>(&T::name, "name", "-", no_range(), "name in the results"),
          may<T>(&T::from, "from", "-", no_range(), "machine group; \"*\": any"),
          may<T>(&T::to, "to", "-", no_range(), "machine group or store; \"*\": any"),
          need<T>(&T::carrier, "carrier", "-", no_range(), "how batches are carried")};
}
std::vector<Field> StructFields<LayoutEdge>::fields() {
  using L = LayoutEdge;
  return {need<L>(&L::from, "from", "-", no_range(), "place: a machine group, a store, or a crossing"),
          need<L>(&L::to, "to", "-", no_range(), "place"),
          need<L>(&L::length_m, "length_m", "m", closed(0, 1e6), "length of the way"),
          may<L>(&L::one_way, "one_way", "-", no_range(), "passable only from from to to")};
}

}  // namespace verstat::models
