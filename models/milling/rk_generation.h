#pragma once
// Plane generation of an RK hole by a rotating cutter (S3): teeth, their tracks in the frame of the hole, and
// the cusp between two of them. Angles in radians, lengths in mm.

#include <cstdint>
#include <vector>

namespace verstat::models::s3 {

struct RkCutter;
struct RkHole;

/// One tooth: the contact with the profile, and the branch of its track on which the polar angle increases
/// with psi, |psi| < psi_max (psi: tooth angle against the line of centres).
struct Tooth {
  double theta;      ///< polar angle on the cutter
  double t;          ///< normal angle of the profile point it cuts
  double radius_mm;  ///< of the tooth on the cutter
  double psi;        ///< at the contact
  double psi_max;    ///< negative: the track has no such branch
  double polar;      ///< polar angle of the contact in the hole
};

struct Cusp {
  double height_mm;  ///< infinite when the tracks never meet
  double polar;      ///< of the crossing; NaN when there is none
  double pitch_mm;   ///< distance of the two contacts
};

/// Checks R > (N^2 - 1) e; throws DomainError.
void require_convex(const RkHole& hole);

class RkGeneration {
 public:
  /// Throws DomainError when the profile is not convex or its normals miss the pitch circle.
  explicit RkGeneration(const RkCutter& in);

  /// gamma - t: direction of the line of centres against the normal.
  [[nodiscard]] double lead(double t) const;
  /// Polar angle on the cutter of the tooth that cuts t, nearest to N t.
  [[nodiscard]] double tooth_angle(double t) const;
  [[nodiscard]] double tooth_radius_mm(double t) const;
  /// Distance of the contact from the pitch point.
  [[nodiscard]] double pitch_arm_mm(double t) const;
  /// Normal angle cut by the tooth at theta; of several (above the undercut limit) the one nearest theta/N.
  /// Throws DomainError when no profile point fits.
  [[nodiscard]] double parameter(double theta) const;

  [[nodiscard]] Tooth tooth(double theta) const;
  [[nodiscard]] Cusp cusp(const Tooth& first, const Tooth& second) const;
  /// Smallest pitch at which the cusp behind `from` reaches `tolerance_mm`; at most a full turn.
  /// `guess` speeds the search.
  [[nodiscard]] double pitch_reaching(const Tooth& from, double tolerance_mm, double guess) const;

  /// Undercut limit of the cutter radius.
  [[nodiscard]] static double max_cutter_radius_mm(const RkHole& hole);
  /// Below it the track of the tooth at the flat loops.
  [[nodiscard]] static double min_cutter_radius_mm(const RkHole& hole);

 private:
  [[nodiscard]] double tooth_angle_slope(double t) const;
  [[nodiscard]] double track_polar(const Tooth& tooth, double psi) const;
  [[nodiscard]] double track_radius_mm(const Tooth& tooth, double psi) const;
  [[nodiscard]] double psi_at(const Tooth& tooth, double polar, double start) const;
  [[nodiscard]] double profile_radius_mm(double polar) const;
  [[nodiscard]] double pitch_by_growth(const Tooth& from, double tolerance_mm, double guess) const;
  [[nodiscard]] double pitch_by_scan(const Tooth& from, double tolerance_mm) const;

  double r_mm_;
  double e_mm_;
  double n_;
  double a_mm_;                     // centre distance
  bool grows_;                      // cutter between its limits: the cusp grows with the pitch
  std::vector<double> turn_backs_;  // t in (0, pi/N) where the tooth angle reverses; none below undercut
};

}  // namespace verstat::models::s3
