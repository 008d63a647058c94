#pragma once
// Operation kind "disc_gear_roughing": tooth gaps of gears and racks of large module, roughed one by one or
// in pairs by disc cutters with indexable inserts that share the gap (K304).

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

struct DiscGearRoughing {
  static constexpr const char* kind = "disc_gear_roughing";
  double module_mm = 0;
  std::optional<double> depth_mm;  ///< absent: 2.25 modules
  double face_width_mm = 0;
  std::int64_t gaps = 0;
  double hardness_hb = 0;
  std::int64_t cutters = 1;  ///< at work at once
  double diameter_mm = 285;
  std::int64_t inserts_per_cutter = 30;
  std::int64_t groups = 5;
  std::int64_t edges_per_insert = 4;
  /// Absent: the published regime, modules 8, 10 and 12 and hardness up to HB 240 only.
  std::optional<double> rpm;
  std::optional<double> feed_mm_min;
  double return_feed_mm_min = 0;
  double indexing_min = 0;
  double clearance_mm = 2;
  bool full_exit = false;

  bool coolant = false;
  bool coated = false;
  double taylor_exponent = 0.25;
  std::optional<double> life_speed_ref_m_min;  ///< of the published life; absent: of the published regime
  double life_cv = 0.7;

  double allowance_mm = 0.8;
  double pressure_angle_deg = 20;
  /// Kienzle constants: with both, forces and power are computed.
  std::optional<double> kc11_mpa;
  std::optional<double> mc;
  double second_cutter_offset_deg = 28.5;
  std::optional<double> peak_force_max_n;
};

/// Throws models::ModelError or models::DomainError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const DiscGearRoughing& spec, const PlanContext& context);

}  // namespace verstat::operations
