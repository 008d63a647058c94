#pragma once
// Operation kind "cam_milling": the cams of a shaft milled with one cylindrical cutter of turned axis (S1).
//
// Stabilised: the part turns at the speed that keeps the contour feed constant, with the contact in one
// plane. Uniform: the usual scheme; its contour feed swings, and its peak is what the tool stands.

#include <cstdint>

#include "models/milling/s1_cam_milling.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class CamScheme {
  stabilised,  ///< constant contour feed, normal contact
  uniform      ///< constant part speed, cutter centre in the plane of the axes
};

struct CamMilling {
  static constexpr const char* kind = "cam_milling";
  models::s1::Cam cam;
  std::int64_t cams = 1;
  double width_mm = 0;
  double overrun_mm = 0;
  double allowance_mm = 0;
  double axial_feed_mm_rev = 0;
  double contour_feed_mm_min = 0;
  double tool_diameter_mm = 0;
  std::int64_t teeth = 1;
  double tool_speed_rpm = 0;
  double orientation_deg = 0;
  double edge_length_mm = 10;
  CamScheme scheme = CamScheme::stabilised;
  double radius_loss_mm = 0;
  std::optional<double> kc11_mpa;
  double mc = 0.25;
  std::optional<double> ra_max_um;
  std::optional<double> roundness_max_um;
  std::optional<double> form_error_max_mm;
  std::optional<double> part_speed_max_rpm;
  std::optional<double> axis_feed_max_mm_min;
};

/// Throws models::ModelError for values outside the models' ranges and for a cam whose arcs do not join,
/// models::DomainError for a turned axis in the uniform scheme.
[[nodiscard]] CutPlan plan(const CamMilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::CamScheme> {
  static constexpr std::array names{std::pair{operations::CamScheme::stabilised, "stabilised"},
                                    std::pair{operations::CamScheme::uniform, "uniform"}};
};
