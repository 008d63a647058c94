#pragma once
// What an operation asks of the shop: computed once from its specification by the process models, and used by
// the simulator, the optimizer, the command line and the pages alike. Every number says where it comes from.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/math/life_law.h"
#include "operations/duration.h"
#include "operations/edge_life.h"

namespace verstat::operations {

/// A number of the plan. Texts are literals of the kind.
struct Quantity {
  const char* name = "";  ///< with its unit: "cutting_force_n"
  double value = 0;
  const char* unit = "1";
  const char* origin =
      "";  ///< function keys, "K117.machining_time_turning"; "COMPLETION: ..." for textbook additions
  const char* meaning = "";  ///< one line
};

/// A condition on a quantity: at most (or at least) an allowed value.
struct Limit {
  const char* name = "";  ///< what is limited: "power_kw"
  double value = 0;
  double allowed = 0;
  bool at_most = true;
  const char* unit = "1";
  const char* origin = "";
  /// Positive when met, relative to the allowed value (to 1 when that is zero): graded, so that an optimizer
  /// can follow it.
  [[nodiscard]] double margin() const {
    const double scale = allowed != 0 ? std::abs(allowed) : 1.0;
    return (at_most ? allowed - value : value - allowed) / scale;
  }
  [[nodiscard]] bool met() const { return margin() >= 0; }
};

/// Values of a knob that must be avoided: low < value < high is forbidden.
struct ForbiddenBand {
  const char* name = "";  ///< of the knob: "feed_mm_rev"
  double value = 0;       ///< where the knob stands
  double low = 0;
  double high = 0;
  const char* unit = "1";
  const char* origin = "";
  [[nodiscard]] bool inside() const { return value > low && value < high; }
};

/// Life of an element that the operation wears.
struct ElementLife {
  const char* element = "edge";  ///< "edge", "guide pads", "wheel"
  models::LifeLawKind law = models::LifeLawKind::weibull;
  double mean_min = 0;  ///< of cutting
  double cv = 0.7;
  const char* origin = "";
};

/// What an inspection finds out about a part that is defective or good.
struct Detection {
  double defective_share = 0;  ///< of the parts that the plan assumes to come
  double sensitivity = 1;      ///< probability that a defective part is rejected; 1 - consumer's risk
  double specificity = 1;      ///< probability that a good part is accepted; 1 - producer's risk
  const char* origin = "";
};

/// A quantity of the plan in which the part leaves: later operations receive it, and the drawing may ask for
/// it.
struct PartState {
  const char* quantity = "";  ///< name of a quantity of the plan: "ra_um"
  double sd = 0;              ///< scatter from part to part, in its unit; 0: none known
};

/// Gauges of an inspection that wear with every check (K307): what they find out as the wear goes on.
struct GaugeWear {
  double wear_per_check = 0;  ///< share of the wear allowance that a check takes
  double start = 0;           ///< share worn off when the shop starts; new gauges have 0
  double replace_at = 1;      ///< share at which a new gauge comes
  double replace_min = 0;     ///< time of the station that this takes
  double price = 0;           ///< of the gauges that are replaced
  const char* origin = "";
  /// At shares of the wear from 0 to replace_at or beyond, ascending; linear between.
  std::vector<double> worn;
  std::vector<double> sensitivity;
  std::vector<double> specificity;
  /// Sensitivity and specificity of gauges of which this share of the allowance is worn off, >= 0.
  [[nodiscard]] Detection at(double worn_share) const;
};

/// Inserts or drills after a preparation: what the tools of a shop fit instead of those delivered.
struct PreparedLot {
  models::LifeLawKind law = models::LifeLawKind::weibull;
  double life_factor = 1;               ///< multiplies EdgeLife::mean_ref_min
  double cv = 0.7;                      ///< replaces EdgeLife::cv
  double breakage_fraction = 0;         ///< of the lives that end by breakage
  double delivered_per_prepared = 1;    ///< inserts bought for one that is used: multiplies the price
  double added_cost_per_insert = 0;     ///< tests and treatment, less what rejected inserts bring
  std::int64_t edges_used_by_test = 0;  ///< of one insert
  const char* origin = "";
  /// The edge life of the lot, from that of the lot as delivered. The treatment acts on the law, not on how
  /// speed, feed and depth change the mean.
  [[nodiscard]] EdgeLife edge_life(const EdgeLife& delivered) const;
  /// Price of one prepared insert, from that of one delivered.
  [[nodiscard]] double price(double delivered_price) const {
    return delivered_price * delivered_per_prepared + added_cost_per_insert;
  }
};

/// Drive overloads within one part, K204: the safety clutch opens, or something breaks in spite of it.
struct Overload {
  double trips_per_part = 0;  ///< mean, without a break
  double breaks_per_part = 0;
  double trip_probability = 0;  ///< of at least one in a part
  double break_probability = 0;
  double reset_min = 0;     ///< downtime of one trip
  bool self_reset = false;  ///< the clutch closes again by itself: nobody is needed
  const char* origin = "";
};

/// What the operation asks of the machine's spindle, so that the machine's dynamics and its safety clutch can
/// be held against it. Zero: not known, or not so in this operation.
struct SpindleLoad {
  double speed_low_rpm = 0;
  double speed_high_rpm = 0;
  std::int64_t teeth = 1;  ///< that meet the work in one revolution
  double torque_nm = 0;
  double normal_force_n = 0;        ///< pushes the tool away from the surface
  double specific_force_n_mm2 = 0;  ///< cutting stiffness k_c
  double width_of_cut_mm = 0;
  double wheel_diameter_mm = 0;  ///< grinding: equivalent diameter on a flat face
  double work_speed_m_min = 0;   ///< grinding
  double infeed_mm = 0;          ///< grinding
};

struct CutPlan {
  double main_time_min = 0;                ///< mean main time of one part
  std::optional<Duration> time_law;        ///< when the main time is random
  std::optional<ElementLife> edge;         ///< the tool's edge, when the operation wears one
  std::vector<ElementLife> more_elements;  ///< replaceable elements besides the edge (guide pads, dressing)
  double scrap_probability = 0;            ///< of a part, besides tool failures
  double breakage_probability = 0;         ///< of the tool within one part, besides wear
  std::vector<Quantity> quantities;        ///< everything worth showing, main time first
  std::vector<Limit> limits;
  std::vector<ForbiddenBand> bands;
  std::vector<Quantity> consumables;   ///< used per part
  std::optional<Detection> detection;  ///< of an inspection
  std::optional<GaugeWear> gauge;      ///< of an inspection with gauges, besides its mean detection
  std::optional<PreparedLot> lot;      ///< of the preparation of a lot of tools
  std::vector<PartState> leaves;       ///< the state in which the part leaves
  std::optional<Overload> overload;    ///< on a machine with a safety clutch
  SpindleLoad spindle;

  [[nodiscard]] bool feasible() const;
  /// Value of the quantity with this name; none when there is none.
  [[nodiscard]] std::optional<double> value_of(const std::string& name) const;
  /// Its unit; "1" when there is none.
  [[nodiscard]] const char* unit_of(const std::string& name) const;
  /// The quantity with this name stays with the part; `sd` is its scatter from part to part.
  void leave(const char* quantity, double sd = 0) { leaves.push_back({quantity, sd}); }
  /// The state of the part with this name; null when the operation does not leave it.
  [[nodiscard]] const PartState* left(const std::string& quantity) const;
  /// The quantity main_time_min, and its listing.
  void set_main_time(double value_min, const char* origin);
};

}  // namespace verstat::operations
