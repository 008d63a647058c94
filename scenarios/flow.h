#pragma once
// What parts go through: operations, routes, supply, release, transport, stores.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "operations/kind.h"

namespace verstat::scenarios {

using operations::Duration;

/// What goes wrong in an operation, besides tool failures.
struct Quality {
  double scrap_probability = 0;   ///< seen at once
  double defect_probability = 0;  ///< stays hidden until somebody inspects
  double defect_when_worn = 0;    ///< added at the end of the edge's mean life
  double wear_exponent = 1;       ///< the addition grows as (used share of the mean life)^this
};

/// The operation is an inspection.
struct Inspection {
  double share = 1;        ///< of the parts that are looked at
  double sensitivity = 1;  ///< chance that a defect is found
  double specificity = 1;  ///< chance that a good part passes
  /// Lot acceptance: when more than this many of a batch are found defective, the whole batch is rejected.
  std::optional<std::int64_t> acceptance_number;
};

/// A number of the process that an operation before it decides: the state in which the part arrives.
struct Incoming {
  std::string from;      ///< name of an operation that the part has been through
  std::string quantity;  ///< that it leaves with the part: "ra_um"
  std::string input;     ///< member of this operation's process that it becomes: "ra_before_um"
  double factor = 1;     ///< multiplies it on the way
};

/// Which of several machine groups does it.
enum class Choice {
  shortest_queue,  ///< fewest batches waiting and in work per machine
  in_turn
};

struct Operation {
  std::string name;
  std::string machine;                ///< the machine group that does it, or
  std::vector<std::string> machines;  ///< several groups to choose from, or
  std::string capability;             ///< any group that has it
  Choice choice = Choice::shortest_queue;
  std::string tool;    ///< empty: no tool that wears
  std::string family;  ///< for setting up; empty: the operation's name
  operations::Process process;
  std::vector<Incoming> incoming;
  std::optional<Quality> quality;
  std::optional<Inspection> inspection;
  double cost = 0;  ///< money per part besides machine and people (gauges, laboratory)
};

// ------------------------------------------------------------------------------------------------- supply
struct AlwaysAvailable {
  static constexpr const char* kind = "always_available";
};
struct Interarrival {
  static constexpr const char* kind = "interarrival";
  Duration time;
};
/// So many batches an hour within these hours of the week.
struct RatePeriod {
  double from_h = 0;  ///< of the week, from Monday 00:00
  double to_h = 168;
  double per_h = 0;
};
/// Arrivals at a rate that changes over the week (non-stationary Poisson).
struct WeeklyProfile {
  static constexpr const char* kind = "weekly_profile";
  std::vector<RatePeriod> rates;
};
struct Order {
  double arrives_min = 0;
  std::int64_t quantity = 1;
  std::optional<double> due_min;
};
/// A list of orders; the rows can be read from a CSV file.
struct OrderList {
  static constexpr const char* kind = "orders";
  std::vector<Order> orders;
  std::string file;  ///< a CSV table beside the scenario, read in before the scenario is loaded
};
using Supply = std::variant<AlwaysAvailable, Interarrival, WeeklyProfile, OrderList>;

// ------------------------------------------------------------------------------------------------ release
struct Push {
  static constexpr const char* kind = "push";
};
/// No more than `cap` batches of the part type are in the shop.
struct Conwip {
  static constexpr const char* kind = "conwip";
  std::int64_t cap = 10;
};
/// Released while fewer than `queue` batches wait before the named machine group.
struct StationThreshold {
  static constexpr const char* kind = "station_threshold";
  std::string machine;
  std::int64_t queue = 1;
};
using Release = std::variant<Push, Conwip, StationThreshold>;

// ------------------------------------------------------------------------------------------------- routes
struct Branch {
  std::string to;          ///< name of a step; empty: the part is finished
  double probability = 1;  ///< used where the step chooses by probability
};
enum class BranchChoice { by_probability, shortest_queue };
struct Component {
  std::string part;
  std::int64_t count = 1;
};
struct Step {
  std::string name;
  std::string operation;
  std::vector<Branch> next;  ///< empty: the next step of the list, or the end
  BranchChoice choice = BranchChoice::by_probability;
  std::vector<Component> assembles;  ///< finished parts taken from their stores before the operation starts
  std::vector<Component> yields;     ///< blanks of other part types that the operation sets free
  std::string rework;                ///< step that parts rejected here go to; empty: they are scrapped
  std::int64_t rework_limit = 1;     ///< times a part may be sent to rework
};

/// What the drawing asks of the finished part. A part that falls short has a defect that nobody sees before
/// an inspection.
struct Requirement {
  std::string quantity;  ///< left by an operation of the route: "ra_um"
  std::optional<double> at_least;
  std::optional<double> at_most;
  double sd = 0;  ///< scatter from part to part, besides that which the operation itself states
};

struct PartType {
  std::string name;
  Supply supply;
  std::vector<std::string> route;  ///< names of operations, one after the other; or
  std::vector<Step> steps;         ///< a graph
  double value = 0;                ///< lost when the part is scrapped
  std::string store;               ///< where good parts go
  std::int64_t batch_size = 1;     ///< parts that move together
  std::int64_t priority = 0;       ///< smaller is more urgent
  Release release = Push{};
  std::optional<Duration> due_after;  ///< allowance from arrival to due date
  double escape_cost = 0;             ///< money when a defective part leaves the shop unseen
  double tardiness_cost_per_min = 0;  ///< money per part and minute after the due date
  std::vector<Requirement> requirements;
  double price = 0;  ///< what a good part brings; used by the criteria of efficiency
};

struct Store {
  std::string name;
  std::optional<std::int64_t> capacity;  ///< parts; a full store blocks
  std::optional<Duration> demand;        ///< time between customers who take one part each
  double demand_lost_cost = 0;           ///< money when a customer finds the store empty
};

// ---------------------------------------------------------------------------------------------- transport
struct TransportDelay {
  static constexpr const char* kind = "delay";
  Duration time;
};
/// Carries batches side by side, each for the same time; full, it blocks.
struct Conveyor {
  static constexpr const char* kind = "conveyor";
  std::int64_t capacity = 1;
  double time_min = 0;
};
/// Vehicles or cranes that drive over the layout.
struct Vehicles {
  static constexpr const char* kind = "vehicles";
  std::int64_t count = 1;
  double speed_m_min = 60;
  double pick_up_min = 0;
  double set_down_min = 0;
  std::string crew;  ///< who drives; empty: nobody is needed
  double rate_per_min = 0;
};
using Carrier = std::variant<TransportDelay, Conveyor, Vehicles>;
/// How batches go from one place to another. The first entry that fits is used.
struct Transport {
  std::string name;
  std::string from = "*";  ///< machine group; "*": any
  std::string to = "*";    ///< machine group or store; "*": any
  Carrier carrier = TransportDelay{};
};
struct LayoutEdge {
  std::string from;
  std::string to;
  double length_m = 0;
  bool one_way = false;
};

}  // namespace verstat::scenarios
