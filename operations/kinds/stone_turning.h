#pragma once
// Operation kind "stone_turning": a body of revolution of natural stone, turned with a driven diamond wheel
// on the carriage of a lathe (K112). The stone's machinability group sets the regime, the lathe decides
// whether it can run it.

#include "models/grinding/k112_stone_turning.h"
#include "operations/kind.h"

namespace verstat::operations {

/// How the wheel takes the allowance: along the part in passes, or straight into it.
enum class StoneFeed { longitudinal, plunge };
/// How wheel and part move at the contact.
enum class StoneMotion { opposed, climb };

/// A straight diamond wheel and how much stone its layer removes.
struct StoneWheel {
  double rim_width_mm = 10;
  double layer_depth_mm = 3;
  double concentration_percent = 100;
  double usable_fraction = 0.9;
  double grinding_ratio = 0;  ///< mm3 of stone per mm3 of layer; the shop's own
  models::LifeLawKind life_law = models::LifeLawKind::weibull;
  double life_cv = 0.7;
};

struct StoneTurning {
  static constexpr const char* kind = "stone_turning";
  std::int64_t group = 1;
  models::k112::Operation operation = models::k112::Operation::rough;
  models::k112::Lathe lathe = models::k112::Lathe::k1k62m;
  StoneFeed feed_path = StoneFeed::longitudinal;
  double diameter_mm = 0;
  double length_mm = 0;  ///< of the turned surface; of the formed width in a plunge
  double approach_mm = 0;
  double allowance_per_side_mm = 0;
  double depth_per_pass_mm = 5;
  double spindle_speed_rpm = 0;
  double feed_mm_rev = 0;  ///< longitudinal, or cross feed in a plunge
  double sparkout_revs = 0;
  double wheel_diameter_mm = 150;
  double relative_speed_m_s = 10;
  StoneMotion motion = StoneMotion::opposed;
  std::optional<StoneWheel> wheel;  ///< adds the consumption of diamond
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const StoneTurning& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::StoneFeed> {
  static constexpr std::array names{std::pair{operations::StoneFeed::longitudinal, "longitudinal"},
                                    std::pair{operations::StoneFeed::plunge, "plunge"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::StoneMotion> {
  static constexpr std::array names{std::pair{operations::StoneMotion::opposed, "opposed"},
                                    std::pair{operations::StoneMotion::climb, "climb"}};
};
template <>
struct verstat::models::StructFields<verstat::operations::StoneWheel> {
  static std::vector<Field> fields();
};
