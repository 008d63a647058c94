#pragma once
// What an operation asks of the shop: computed once from its specification by the process models, and used by
// the simulator, the optimizer, the command line and the pages alike. Every number says where it comes from.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "models/math/life_law.h"
#include "operations/duration.h"

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
  std::vector<Quantity> consumables;  ///< used per part

  [[nodiscard]] bool feasible() const;
  /// Value of the quantity with this name; none when there is none.
  [[nodiscard]] std::optional<double> value_of(const std::string& name) const;
  /// The quantity main_time_min, and its listing.
  void set_main_time(double value_min, const char* origin);
};

}  // namespace verstat::operations
