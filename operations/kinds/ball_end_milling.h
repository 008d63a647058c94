#pragma once
// Operation kind "ball_end_milling": finishing of a surface with a ball-end mill, patch by patch.
//
// Forces by the regressions for hardened die steel (K401), inside their explored box, or from the chip flow
// of least energy (K406), for any regime. The forces found for a level surface turn with the patch (K406
// C7): what bends the tool is the part across its axis.

#include <cstdint>
#include <vector>

#include "models/milling/k406_ball_end_energy_forces.h"
#include "operations/kind.h"

namespace verstat::operations {

/// A part of the surface with one inclination and one allowance.
struct SurfacePatch {
  double area_cm2 = 0;
  double inclination_deg = 0;
  double depth_mm = 0;
};

enum class BallForceModel {
  regression,  ///< K401: hardened die steel, HRC 40 to 55
  energy       ///< K406: minimum cutting energy
};
enum class BallFeed {
  given,     ///< the feed per tooth as specified, everywhere
  constant,  ///< one feed for the whole surface, lowered until the worst patch keeps the force limits
  patchwise  ///< on each patch the largest feed that keeps the force limits, at most the specified one
};

struct BallEndMilling {
  static constexpr const char* kind = "ball_end_milling";
  std::vector<SurfacePatch> patches;
  double diameter_mm = 0;
  std::int64_t teeth = 2;
  double overhang_mm = 0;
  double modulus_mpa = 600'000;
  double spindle_speed_rpm = 0;
  double feed_per_tooth_mm = 0;
  double step_over_mm = 0;
  BallFeed feed = BallFeed::given;
  BallForceModel force_model = BallForceModel::regression;
  // of the regressions
  double relief_deg = 12;
  double hardness_hrc = 47.5;
  // of the energy model
  double helix_deg = 30;
  double normal_rake_deg = 0;
  models::k406::CutMode mode = models::k406::CutMode::down;
  double stress_scale = 1;
  // limits
  std::optional<double> feed_force_max_n;
  std::optional<double> axial_force_max_n;
  std::optional<double> normal_force_max_n;
  std::optional<double> form_error_max_um;
  std::optional<double> scallop_max_um;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a regime outside
/// the box of the regressions and for a feed choice without the limits or the model it needs.
[[nodiscard]] CutPlan plan(const BallEndMilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::BallForceModel> {
  static constexpr std::array names{std::pair{operations::BallForceModel::regression, "regression"},
                                    std::pair{operations::BallForceModel::energy, "energy"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::BallFeed> {
  static constexpr std::array names{std::pair{operations::BallFeed::given, "given"},
                                    std::pair{operations::BallFeed::constant, "constant"},
                                    std::pair{operations::BallFeed::patchwise, "patchwise"}};
};
template <>
struct verstat::models::StructFields<verstat::operations::SurfacePatch> {
  static std::vector<Field> fields();
};
