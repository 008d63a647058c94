#pragma once
// The kinematic model behind K101: tooth outline, motion of hob and blank, and the chip thickness as the
// normal distance to what earlier passes swept. Angles in radians, lengths in mm.
//
// Not a catalogue function itself: the public functions in k101_hobbing_chip_thickness.h are built on it.

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "models/gears/k101_hobbing_chip_thickness.h"

namespace verstat::models::k101 {

/// (7): first contact of the tip cylinders. `beta` the setting angle.
struct CylinderContact {
  double length_mm;
  double angle_rad;
};
[[nodiscard]] CylinderContact cylinder_contact(double centre_mm, double hob_radius_mm, double gear_radius_mm,
                                               double beta);

/// (C1): what the hob alone fixes.
struct Hob {
  explicit Hob(const HobInputs& in);
  double tip_radius;    // r_a0
  double pitch_radius;  // r_m0
  double lead_angle;    // gamma
  double helix;         // p, mm/rad
  double a1;
  double corner_radius;                // rho
  double corner_radial, corner_axial;  // c_y, c_z
  double section_angle;                // beta_1
  double sin_pressure, cos_pressure, tan_pressure;
};

/// A point of the outline: radial and transverse coordinate, unit tangent, outward normal.
struct OutlinePoint {
  double r, w;
  double tangent_r, tangent_w;
  double normal_r, normal_w;
};

/// A pass that has already cut: tooth i, so many turns of the hob earlier. The tooth angle th belongs to the
/// hob rotation th + shift.
struct Pass {
  double tooth_angle;  // t_i
  double shift;        // offset - t_i
};

class HobbingProcess {
 public:
  explicit HobbingProcess(const Hobbing& in);

  Hob hob;
  double centre_distance, gear_outer_radius, setting_angle, cutting_depth;
  double travel_rate;  // psi' = sigma S i12 / (2 pi), mm per radian of hob rotation
  double blank_rate;   // w_2 = d phi02 / d phi01
  double approach;     // L
  double zone_half_length;
  std::int64_t gear_teeth, gashes;
  std::int64_t last_tooth;  // J: teeth -J..J can have cut
  bool climb;

  [[nodiscard]] double tooth_angle(std::int64_t tooth) const;
  /// Outline point by segment and parameter (u, u_1 in mm; mu in degrees); error outside the segment's range.
  [[nodiscard]] OutlinePoint outline_point(Segment segment, double parameter) const;
  /// The points of section "Edge sampling": from the root along the edge to the other root.
  [[nodiscard]] std::vector<OutlinePoint> edge_samples(std::int64_t n_flank, std::int64_t n_round,
                                                       std::int64_t n_tip) const;
  /// Point of the outline in the frame turned by `angle`: t_j for S1, theta for S0.
  [[nodiscard]] Eigen::Vector3d place(const OutlinePoint& point, double angle, double tooth_t) const;
  [[nodiscard]] Eigen::Vector3d velocity(const Eigen::Vector3d& point0) const;
  [[nodiscard]] Eigen::Vector3d tangent(const OutlinePoint& point, double theta) const;
  /// Unit normal in S0 into the tooth body, and the width swept per radian, |V x T| / |T|.
  struct Swept {
    Eigen::Vector3d normal0;
    double width_mm_rad;
  };
  [[nodiscard]] Swept swept(const OutlinePoint& point, double theta, double tooth_t) const;
  [[nodiscard]] Eigen::Vector3d to_blank(const Eigen::Vector3d& point0, double hob_rotation) const;
  [[nodiscard]] Eigen::Vector3d direction_to_blank(const Eigen::Vector3d& v0, double hob_rotation) const;

  /// Signed distance of a point of the blank frame from what a pass sweeps; below 0 inside. `start` is a
  /// first guess of the tooth angle at which the pass meets the point.
  [[nodiscard]] double clearance(const Eigen::Vector3d& q, const Pass& pass, double start) const;
  /// Signed distance from the outline in its section.
  [[nodiscard]] double outline_distance(double r, double w) const;

  double cos_section, sin_section;
  double cos_setting, sin_setting;
};

/// One tooth at one angle with everything that has cut before it.
class ToothPosition {
 public:
  struct EndFaces {
    double low_mm, high_mm;
  };
  /// `hob_turns` and `faces` only for a blank of finite width.
  ToothPosition(const HobbingProcess& process, std::int64_t tooth, double theta,
                std::int64_t previous_blank_revs, std::int64_t hob_turns = 0,
                std::optional<EndFaces> faces = std::nullopt);

  /// Chip thickness at an outline point; `step_mm` of the scan along the normal.
  [[nodiscard]] double chip_thickness(const OutlinePoint& point, double step_mm) const;
  /// The same with the swept width of the point.
  struct Sample {
    double thickness_mm;
    double width_mm_rad;
  };
  [[nodiscard]] Sample sample(const OutlinePoint& point, double step_mm) const;

 private:
  struct EarlierPass : Pass {
    double cos_blank, sin_blank, travel;  // at the tooth angle theta
  };
  struct Candidate {
    double bound;
    std::size_t pass;
  };
  [[nodiscard]] double lower_bound(const Eigen::Vector3d& q, const EarlierPass& pass) const;
  [[nodiscard]] double distance_to_boundary(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const;

  const HobbingProcess* process_;
  double theta_, tooth_t_, hob_rotation_;
  double cos_theta_, sin_theta_;
  std::optional<EndFaces> faces_;
  double lipschitz_;
  std::vector<EarlierPass> passes_;
};

}  // namespace verstat::models::k101
