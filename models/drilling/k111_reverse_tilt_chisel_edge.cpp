#include "models/drilling/k111_reverse_tilt_chisel_edge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/trig_degrees.h"

namespace verstat::models::k111 {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

double tan_deg(double angle_deg) {
  return std::tan(to_radians(angle_deg));
}

// What every function needs of the plane-ground point.
struct Flank {
  double mu_rad;
  double theta_rad;  // clearance of the flank across the axis (4)
  double cot_phi;    // slope of the main edge along the axis
  double steepness;  // cot(phi) / cos(Theta): steepest slope of the flank
};

Flank flank(const DrillPoint& in) {
  require(in.core_radius_mm < in.drill_radius_mm, "core_radius_mm", in.core_radius_mm,
          "must be below drill_radius_mm");
  Flank f{};
  f.mu_rad = std::asin(in.core_radius_mm / in.drill_radius_mm);
  const double tan_phi = tan_deg(in.half_point_angle_deg);
  const double tan_theta =
      tan_deg(in.clearance_periphery_deg) * tan_phi / std::cos(f.mu_rad) - std::tan(f.mu_rad);
  f.theta_rad = std::atan(tan_theta);
  f.cot_phi = 1 / tan_phi;
  f.steepness = f.cot_phi / std::cos(f.theta_rad);
  return f;
}

// Slotted chisel: its half point angle and the two static clearances.
struct Slot {
  double tilt_rad;
  double half_point_rad;
  double axial_rad;
  double normal_rad;
};

Slot slot(const SlottedPoint& in, const Flank& f) {
  const double tilt_deg = to_degrees(f.theta_rad) + in.reverse_tilt_deg;
  require(tilt_deg > 0 && tilt_deg < 90, "reverse_tilt_deg", in.reverse_tilt_deg,
          "with theta_p_deg it must give a tilt from the standard chisel between 0 and 90 deg, outside which "
          "the point cannot cut");
  Slot s{};
  s.tilt_rad = to_radians(tilt_deg);
  // cot(phi_pk) = g sin(Theta + psi), tan(alpha_ax) = g cos(Theta + psi): no indeterminate products.
  s.half_point_rad = std::atan2(1, f.steepness * std::sin(s.tilt_rad));
  const double tan_axial = f.steepness * std::cos(s.tilt_rad);
  s.axial_rad = std::atan(tan_axial);
  s.normal_rad = std::atan(std::sin(s.half_point_rad) * tan_axial);
  return s;
}

// Half width of the chisel strip left of the axis, s = sqrt(r^2 - Delta^2/4).
double along_wall_mm(double radius_mm, double slot_width_mm) {
  const double half = slot_width_mm / 2;
  return std::sqrt((radius_mm - half) * (radius_mm + half));
}

void check_radius(double radius_mm, double slot_width_mm, double drill_radius_mm) {
  require(radius_mm > slot_width_mm / 2, "radius_mm", radius_mm, "must be above slot_width_mm / 2");
  require(radius_mm <= drill_radius_mm, "radius_mm", radius_mm, "must not be above drill_radius_mm");
}

// s tan(tau) of (9), without the division by s.
double turning_mm(const Slot& s, double feed_mm_rev, double slot_width_mm) {
  return feed_mm_rev / two_pi * std::sin(s.half_point_rad) - slot_width_mm / 2 * std::cos(s.half_point_rad);
}

}  // namespace

StandardChisel standard_chisel_geometry(const DrillPoint& in) {
  return guarded<&standard_chisel_geometry>(in, [&] {
    const Flank f = flank(in);
    const double theta_deg = to_degrees(f.theta_rad);
    const double clearance_deg = to_degrees(std::atan(f.steepness));
    return StandardChisel{.mu_deg = to_degrees(f.mu_rad),
                          .theta_p_deg = theta_deg,
                          .chisel_tilt_deg = 90 - theta_deg,
                          .chisel_half_length_mm = in.core_radius_mm / std::cos(f.theta_rad),
                          .chisel_clearance_deg = clearance_deg,
                          .chisel_rake_deg = clearance_deg - 90};
  });
}

MainEdgeClearance main_edge_clearance(const MainEdgePoint& in) {
  return guarded<&main_edge_clearance>(in, [&] {
    constexpr double slack = 1e-12;  // the junction radius is itself computed
    const Flank f = flank(in);
    const double least_mm = f.theta_rad < 0 ? in.core_radius_mm : in.core_radius_mm / std::cos(f.theta_rad);
    require(in.radius_mm >= least_mm * (1 - slack), "radius_mm", in.radius_mm,
            "must not be inside the chisel edge (chisel_half_length_mm, or core_radius_mm when theta_p_deg "
            "is negative)");
    require(in.radius_mm <= in.drill_radius_mm, "radius_mm", in.radius_mm,
            "must not be above drill_radius_mm");
    const double mu_x = std::asin(std::min(1.0, in.core_radius_mm / in.radius_mm));
    const double tan_clearance =
        (std::cos(mu_x) * tan_deg(in.clearance_periphery_deg) + f.cot_phi * std::sin(mu_x - f.mu_rad)) /
        std::cos(f.mu_rad);
    return MainEdgeClearance{to_degrees(std::atan(tan_clearance))};
  });
}

SlottedChisel slotted_chisel_geometry(const SlottedPoint& in) {
  return guarded<&slotted_chisel_geometry>(in, [&] {
    const Flank f = flank(in);
    const Slot s = slot(in, f);
    return SlottedChisel{.theta_p_deg = to_degrees(f.theta_rad),
                         .tilt_from_standard_deg = to_degrees(f.theta_rad) + in.reverse_tilt_deg,
                         .chisel_half_point_deg = to_degrees(s.half_point_rad),
                         .clearance_axial_deg = to_degrees(s.axial_rad),
                         .clearance_normal_deg = to_degrees(s.normal_rad),
                         .rake_deg = 0};
  });
}

SlottedKinematics slotted_chisel_kinematics(const WorkingPoint& in) {
  return guarded<&slotted_chisel_kinematics>(in, [&] {
    const Slot s = slot(in, flank(in));
    check_radius(in.radius_mm, in.slot_width_mm, in.drill_radius_mm);
    const double wall_mm = along_wall_mm(in.radius_mm, in.slot_width_mm);
    const double tau = std::atan(turning_mm(s, in.feed_mm_rev, in.slot_width_mm) / wall_mm);
    // (7) as printed has the cosine of the half point angle in both terms.
    const double tau_printed =
        std::atan(std::cos(s.half_point_rad) * (in.feed_mm_rev / two_pi - in.slot_width_mm / 2) / wall_mm);
    return SlottedKinematics{.delta_deg = to_degrees(std::atan(in.feed_mm_rev / (two_pi * in.radius_mm))),
                             .mu_point_deg = to_degrees(std::atan2(in.slot_width_mm / 2, wall_mm)),
                             .tau_deg = to_degrees(tau),
                             .tau_printed_deg = to_degrees(tau_printed),
                             .kinematic_clearance_deg = to_degrees(s.normal_rad - tau),
                             .kinematic_rake_deg = to_degrees(tau)};
  });
}

FeedLimit slotted_chisel_max_feed(const FeedLimitInputs& in) {
  return guarded<&slotted_chisel_max_feed>(in, [&] {
    const Slot s = slot(in, flank(in));
    check_radius(in.radius_mm, in.slot_width_mm, in.drill_radius_mm);
    const double wall_mm = along_wall_mm(in.radius_mm, in.slot_width_mm);
    const double spare = std::tan(s.normal_rad - to_radians(in.min_kinematic_clearance_deg));
    return FeedLimit{two_pi * (wall_mm * spare + in.slot_width_mm / 2 * std::cos(s.half_point_rad)) /
                     std::sin(s.half_point_rad)};
  });
}

Rubbing slotted_chisel_rubbing_radius(const RubbingInputs& in) {
  return guarded<&slotted_chisel_rubbing_radius>(in, [&] {
    const Slot s = slot(in, flank(in));
    const double spare_rad = s.normal_rad - to_radians(in.min_kinematic_clearance_deg);
    require(spare_rad > 0, "min_kinematic_clearance_deg", in.min_kinematic_clearance_deg,
            "must be below clearance_normal_deg of the slotted chisel");
    const double rub_mm =
        std::max(0.0, turning_mm(s, in.feed_mm_rev, in.slot_width_mm) / std::tan(spare_rad));
    return Rubbing{std::hypot(rub_mm, in.slot_width_mm / 2)};
  });
}

ThrustRatio drill_thrust_ratio(const ThrustShares& in) {
  return guarded<&drill_thrust_ratio>(
      in, [&] { return ThrustRatio{1 - in.chisel_share * (1 - in.chisel_force_ratio)}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K111",
       .title = "Geometric parameters of the chisel edge of a twist drill with a reverse angle of its "
                "inclination",
       .authors = "Ravska N. S., Besarabets Yu. Y., Plivak O. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "A narrow slot cut across the web of a plane-ground twist drill at a reverse inclination "
                 "turns the chisel edge from a rake of about -58 deg to zero. Static and working angles of "
                 "both chisel edges, the feed that keeps them cutting, the core that rubs.",
       .role = "drilling",
       .errata = {"Eq. (6) is printed for the section normal to the edge but is the section perpendicular "
                  "to the slot wall; both are given.",
                  "Eq. (7) is printed with the cosine of the half point angle in the feed term; an edge "
                  "perpendicular to the axis must turn by the full angle of the resultant motion, which "
                  "only the sine gives."}});

  const auto point = [](auto& f) {
    f.input(&DrillPoint::half_point_angle_deg, "half_point_angle_deg", "phi", "deg", closed(45, 75),
            "half point angle", 59.0)
        .input(&DrillPoint::clearance_periphery_deg, "clearance_periphery_deg", "alpha", "deg", closed(5, 30),
               "clearance at the periphery", 12.0)
        .input(&DrillPoint::core_radius_mm, "core_radius_mm", "r", "mm", positive(),
               "radius of the web, below the drill radius", 1.5)
        .input(&DrillPoint::drill_radius_mm, "drill_radius_mm", "R", "mm", positive(), "drill radius", 10.0);
  };
  const auto tilt = [](auto& f) {
    f.input(&SlottedPoint::reverse_tilt_deg, "reverse_tilt_deg", "psi", "deg", any(),
            "tilt of the slot from the perpendicular to the main edge, 0 < theta_p_deg + psi < 90", 30.0);
  };
  source
      .function<&standard_chisel_geometry>("standard_chisel_geometry",
                                           "Chisel edge of the plane-ground standard drill.",
                                           "eqs. (1), (3), (4)", Provenance::paper)
      .with(point)
      .output(&StandardChisel::mu_deg, "mu_deg", "mu", "deg", closed(0, 90),
              "angle of the core at the corner")
      .output(&StandardChisel::theta_p_deg, "theta_p_deg", "Theta", "deg", closed(-90, 90),
              "clearance of the flank in the section perpendicular to the axis")
      .output(&StandardChisel::chisel_tilt_deg, "chisel_tilt_deg", "psi_st", "deg", closed(0, 180),
              "angle in plan between chisel and main edge")
      .output(&StandardChisel::chisel_half_length_mm, "chisel_half_length_mm", "r/sin(psi_st)", "mm",
              non_negative(), "chisel edge from the axis to the main edge")
      .output(&StandardChisel::chisel_clearance_deg, "chisel_clearance_deg", "alpha_ch", "deg", closed(0, 90),
              "clearance of the chisel edge")
      .output(&StandardChisel::chisel_rake_deg, "chisel_rake_deg", "gamma_ch", "deg", closed(-90, 0),
              "rake of the chisel edge");
  source
      .function<&main_edge_clearance>("main_edge_clearance", "Static clearance of the main edge at a radius.",
                                      "eq. (2)", Provenance::paper)
      .with(point)
      .input(&MainEdgePoint::radius_mm, "radius_mm", "r_x", "mm", positive(),
             "radius of the point, from the chisel edge to the drill radius", 5.0)
      .output(&MainEdgeClearance::clearance_deg, "clearance_deg", "alpha_x", "deg", closed(-90, 90),
              "clearance in the plane tangent to the cylinder");
  source
      .function<&slotted_chisel_geometry>("slotted_chisel_geometry", "Static angles of the slotted chisel.",
                                          "eqs. (5), (6), (6c)", Provenance::repaired)
      .with(point)
      .with(tilt)
      .output(&SlottedChisel::theta_p_deg, "theta_p_deg", "Theta", "deg", closed(-90, 90),
              "clearance of the flank in the section perpendicular to the axis")
      .output(&SlottedChisel::tilt_from_standard_deg, "tilt_from_standard_deg", "Theta+psi", "deg",
              open(0, 90), "angle in plan between slot and standard chisel edge")
      .output(&SlottedChisel::chisel_half_point_deg, "chisel_half_point_deg", "phi_pk", "deg", closed(0, 90),
              "angle between edge and axis")
      .output(&SlottedChisel::clearance_axial_deg, "clearance_axial_deg", "alpha_ax", "deg", closed(0, 90),
              "clearance perpendicular to the slot wall, as the printed formula gives")
      .output(&SlottedChisel::clearance_normal_deg, "clearance_normal_deg", "alpha_n", "deg", closed(0, 90),
              "clearance in the section normal to the edge, for use with the working angles")
      .output(&SlottedChisel::rake_deg, "rake_deg", "gamma", "deg", closed(0, 0),
              "rake: zero for a wall parallel to the axis")
      .note(
          "The edge is read as rising towards the axis with the flank kept up to the slot; the other "
          "reading cannot cut.");
  source
      .function<&slotted_chisel_kinematics>("slotted_chisel_kinematics",
                                            "Working angles at one point of the slotted chisel.",
                                            "eqs. (7c), (8)", Provenance::repaired)
      .with(point)
      .with(tilt)
      .input(&WorkingPoint::slot_width_mm, "slot_width_mm", "Delta", "mm", positive(),
             "width of the slot, small against the core", 0.3)
      .input(&WorkingPoint::feed_mm_rev, "feed_mm_rev", "S_o", "mm/rev", non_negative(), "feed", 0.3)
      .input(&WorkingPoint::radius_mm, "radius_mm", "r_i", "mm", positive(),
             "radius of the point, above half the slot, at most the drill radius", 1.0)
      .output(&SlottedKinematics::delta_deg, "delta_deg", "delta", "deg", closed(0, 90),
              "direction of the resultant motion")
      .output(&SlottedKinematics::mu_point_deg, "mu_point_deg", "mu_i", "deg", closed(0, 90),
              "angle of the slot wall at the point")
      .output(&SlottedKinematics::tau_deg, "tau_deg", "tau", "deg", closed(-90, 90),
              "rotation of the cutting plane")
      .output(&SlottedKinematics::tau_printed_deg, "tau_printed_deg", "tau", "deg", closed(-90, 90),
              "the same by the paper's formula, for record only")
      .output(&SlottedKinematics::kinematic_clearance_deg, "kinematic_clearance_deg", "alpha_k", "deg",
              closed(-90, 180), "clearance in work")
      .output(&SlottedKinematics::kinematic_rake_deg, "kinematic_rake_deg", "gamma_k", "deg", closed(-90, 90),
              "rake in work")
      .note("At zero feed the rotation is negative, not zero: the wall lags the axis by half the slot.");
  source
      .function<&slotted_chisel_max_feed>("slotted_chisel_max_feed",
                                          "Largest feed with at least a given working clearance.",
                                          "eq. (10), derived", Provenance::repaired)
      .with(point)
      .with(tilt)
      .input(&FeedLimitInputs::slot_width_mm, "slot_width_mm", "Delta", "mm", positive(),
             "width of the slot, small against the core", 0.3)
      .input(&FeedLimitInputs::radius_mm, "radius_mm", "r_i", "mm", positive(),
             "radius of the point, above half the slot, at most the drill radius", 0.5)
      .input(&FeedLimitInputs::min_kinematic_clearance_deg, "min_kinematic_clearance_deg", "alpha_min", "deg",
             open_high(0, 90), "least working clearance", 2.0)
      .output(&FeedLimit::max_feed_mm_rev, "max_feed_mm_rev", "S_max", "mm/rev", any(),
              "largest feed; 0 or less means infeasible");
  source
      .function<&slotted_chisel_rubbing_radius>("slotted_chisel_rubbing_radius",
                                                "Radius inside which the edge rubs instead of cutting.",
                                                "eq. (10), derived", Provenance::repaired)
      .with(point)
      .with(tilt)
      .input(&RubbingInputs::slot_width_mm, "slot_width_mm", "Delta", "mm", positive(),
             "width of the slot, small against the core", 0.1)
      .input(&RubbingInputs::feed_mm_rev, "feed_mm_rev", "S_o", "mm/rev", non_negative(), "feed", 0.4)
      .input(&RubbingInputs::min_kinematic_clearance_deg, "min_kinematic_clearance_deg", "alpha_min", "deg",
             open_high(0, 90), "least working clearance, below the static normal clearance", 2.0)
      .output(&Rubbing::rubbing_radius_mm, "rubbing_radius_mm", "r_rub", "mm", non_negative(),
              "rubbing radius; half the slot when the whole edge clears");
  source
      .function<&drill_thrust_ratio>("drill_thrust_ratio",
                                     "Thrust of the modified point over the standard one.", "eq. (C1)",
                                     Provenance::completion)
      .input(&ThrustShares::chisel_share, "chisel_share", "k_ch", "1", closed(0, 1),
             "share of the standard thrust carried by the chisel edge", 0.5)
      .input(&ThrustShares::chisel_force_ratio, "chisel_force_ratio", "kappa", "1", closed(0, 1),
             "force of the new chisel edge over the old", 0.4)
      .output(&ThrustRatio::thrust_ratio, "thrust_ratio", "P/P_st", "1", closed(0, 1), "thrust ratio")
      .note("The paper models no forces; half of the thrust on the chisel edge is typical.");
}

}  // namespace verstat::models::k111
