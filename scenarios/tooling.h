#pragma once
// Inserts, the tools that hold them, and the strategies by which edges are changed. Descriptions of the
// members: tooling_fields.cpp; checks that need the whole scenario: check_tooling.cpp.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "operations/edge_life.h"
#include "operations/kind.h"

namespace verstat::scenarios {

using operations::ConstantDuration;
using operations::Duration;
using operations::EdgeLife;
using operations::ExponentialDuration;
using operations::mean_min;

/// What the tool crib does about an insert: the stock at the start, and orders by reorder point.
struct InsertStock {
  std::int64_t stock = 0;           ///< inserts on the shelf at the start
  std::int64_t reorder_point = 0;   ///< an order is placed when shelf and orders less debts fall to this
  std::int64_t order_quantity = 1;  ///< inserts of one order
  Duration lead_time = ExponentialDuration{1.0 / 1440};  ///< from order to shelf
};

/// What becomes of a lot that its sample condemns.
enum class RejectedLot {
  send_back,  ///< the supplier sends another lot, which is tested in turn
  retreat     ///< every insert of it is treated and used
};
/// Lots of inserts differ, and a sample of each is tested before it is used (K119).
struct CertifiedLots {
  std::int64_t lot_size = 100;
  double ln_sd_between = 0.3;      ///< scatter of the logarithm of the lots' mean lives
  double ln_sd_within = 0.35;      ///< scatter of the logarithm of the test result within a lot
  std::int64_t sample_size = 5;    ///< inserts tested per lot
  double test_correlation = 0.95;  ///< of the lot means of test and life
  double reject_fraction = 0.2;    ///< of the lots
  RejectedLot rejected = RejectedLot::send_back;
  double retreat_life_factor = 1;
  double retreat_cost = 0;  ///< money per insert
  double test_cost = 0;     ///< money per insert tested
};

struct Insert {
  std::string name;
  std::string grade;
  std::int64_t edges = 2;
  double price = 0;
  EdgeLife edge_life;
  double reserve_ok_probability = 1;   ///< a failed edge leaves the next one usable
  double single_edge_probability = 0;  ///< a fitted insert has only one usable edge
  std::string provenance;              ///< where the numbers come from
  /// How the lot is sorted and treated before use; `edge_life`, `price` and `edges` are those delivered.
  std::optional<operations::Process> preparation;
  std::optional<CertifiedLots> lots;
  std::optional<InsertStock> crib;  ///< none: there are always inserts
};

/// The insert as it is fitted, after its preparation: other life law, price and number of edges.
/// Throws models::ModelError or models::DomainError when the preparation cannot be planned or prepares no
/// lot.
[[nodiscard]] Insert prepared(const Insert& insert);

struct RunToFailure {
  static constexpr const char* kind = "run_to_failure";
};
/// Change an edge at its gamma-percent life or at failure.
struct AgeReplacement {
  static constexpr const char* kind = "age";
  double gamma = 0.64;
};
/// Change after the whole parts that fit into the gamma-percent life, or at failure.
struct PartCountReplacement {
  static constexpr const char* kind = "part_count";
  double gamma = 0.64;
};
/// Change every gamma-percent life of cutting, whatever the age of the edge; failures in between.
struct BlockReplacement {
  static constexpr const char* kind = "block";
  double gamma = 0.64;
};
/// Who takes the chip of a failed tooth.
enum class LoadSharing {
  local,   ///< the tooth behind the gap
  global,  ///< all survivors in equal parts
  none     ///< nobody: the survivors wear as before
};
/// Which teeth of a cutter get new edges when it is taken off at its failed teeth.
enum class ReplaceTeeth { all, failed, failed_and_older_than };
/// Take the cutter off when so many of its teeth have failed (K109).
struct ReplaceAtFailedTeeth {
  static constexpr const char* kind = "replace_at_failed_teeth";
  std::int64_t failed_teeth = 1;
  LoadSharing load_sharing = LoadSharing::global;
  double load_exponent = 2;  ///< wear rate of a tooth ~ (its chip)^this
  bool reduce_feed = false;  ///< table feed in proportion to the working teeth: their chip stays
  ReplaceTeeth replace = ReplaceTeeth::all;
  double older_than = 0.5;      ///< mean lives
  std::optional<double> gamma;  ///< also change all teeth at the gamma-percent life of one
};
/// The edge has used up this share of its own life.
struct ShareOfLife {
  static constexpr const char* kind = "share_of_life";
  double share = 0.8;
};
/// The radial cutting force has grown by this factor; flank wear grows evenly to its limit (K106).
struct ForceGrowth {
  static constexpr const char* kind = "force_growth";
  double factor = 2;
  double wear_limit_mm = 0.15;
  bool cylindrical_rake = false;
};
using WearSign = std::variant<ShareOfLife, ForceGrowth>;
/// Change an edge when an inspection notices that it is worn, or at failure.
struct ConditionBased {
  static constexpr const char* kind = "condition_based";
  std::optional<double> every_min;          ///< of cutting since the change or the last inspection; or
  std::optional<std::int64_t> every_parts;  ///< looked at before the next part
  WearSign sign;
  double detection_probability = 1;
  double false_alarm_probability = 0;
  double inspection_min = 0;  ///< machine and crew; 0: monitored without a stop
};
/// Age replacement that uses other stops of the machine.
struct Opportunistic {
  static constexpr const char* kind = "opportunistic";
  double gamma = 0.64;
  double window = 0.2;  ///< last share of the scheduled period in which any stop is used
};
using Strategy = std::variant<RunToFailure, AgeReplacement, PartCountReplacement, BlockReplacement,
                              ReplaceAtFailedTeeth, ConditionBased, Opportunistic>;
/// Reliability level of a strategy; none for run to failure.
[[nodiscard]] std::optional<double> gamma_of(const Strategy& strategy);

/// When the price of an insert is booked.
enum class InsertBooking {
  life_periods,  ///< price / periods at every change (K117): planned and failure changes waste different
                 ///< shares
  at_fitting     ///< the whole price when an insert is fitted
};

struct ToolChange {
  Duration index = ExponentialDuration{0.3};    ///< turn the insert to its next edge
  Duration replace = ExponentialDuration{0.3};  ///< fit a new insert
  double positioning_min = 0;                   ///< on top of both: approach, trial cut, measuring
  double failure_extra_min = 0;                 ///< on top of both after a failure
  double stop_min = 0;                 ///< once per stop of the machine, shared by the edges changed in it
  Duration swap = ConstantDuration{};  ///< a sister tool comes out of the magazine or the crib
};

/// Changed tools are set off the machine.
struct Presetting {
  std::string crew;  ///< empty: who changes edges
  Duration time;     ///< on top of indexing or replacing
};
/// A worn tool is ground and used again.
struct Regrind {
  Duration time;
  std::int64_t max_regrinds = 5;
  double life_factor = 1;  ///< of every regrind: lives after k of them are this to the power of k shorter
};
/// A second replaceable element that the plan of an operation names (guide pads, wheel dressing).
struct ElementService {
  std::string element;
  Duration change;              ///< machine and crew
  double price = 0;             ///< money per change
  std::optional<double> gamma;  ///< changed at its gamma-percent life; none: at the end of its life
};

struct Tool {
  std::string name;
  std::string insert;  ///< empty: nothing that wears but the elements below
  Strategy strategy = AgeReplacement{};
  std::string crew;  ///< who changes edges
  ToolChange change;
  InsertBooking insert_booking = InsertBooking::life_periods;
  double periods_planned = 4;
  double periods_failure = 2;
  double regrind_planned = 0;
  double regrind_failure = 0;
  double failure_damage = 0;  ///< holder, shim, rework: money per failure
  double failure_scrap_probability = 0;
  std::int64_t teeth = 1;            ///< each with an insert
  std::string failure_crew;          ///< who comes after a failure; empty: `crew`
  std::int64_t copies = 1;           ///< sister tools in each machine's magazine, or in all when shared
  bool shared = false;               ///< the copies go from machine to machine
  std::int64_t magazine_places = 1;  ///< that one copy takes
  std::optional<Presetting> presetting;
  std::optional<Regrind> regrind;
  std::vector<ElementService> elements;
  double unattended_target = 0.95;  ///< wanted share of unattended intervals that the sisters last
};
/// Whether worn copies leave the machine and others take their place; else edges are changed on the machine.
[[nodiscard]] bool changed_off_line(const Tool& tool);
/// Failed teeth at which the tool is taken off: 1 unless its strategy says more.
[[nodiscard]] std::int64_t failed_teeth_to_change(const Tool& tool);

}  // namespace verstat::scenarios
