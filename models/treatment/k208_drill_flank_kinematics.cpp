#include "models/treatment/k208_drill_flank_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "models/treatment/drill_point.h"

namespace verstat::models::k208 {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;
using Vector = Eigen::Vector3d;

Vector turn_z(double deg, const Vector& p) {
  const double c = std::cos(deg * rad_per_deg);
  const double s = std::sin(deg * rad_per_deg);
  return {p.x() * c - p.y() * s, p.x() * s + p.y() * c, p.z()};
}

Vector turn_y(double deg, const Vector& p) {
  const double c = std::cos(deg * rad_per_deg);
  const double s = std::sin(deg * rad_per_deg);
  return {p.x() * c + p.z() * s, p.y(), -p.x() * s + p.z() * c};
}

// Flank 2 is flank 1 turned half round the drill axis.
Vector half_turn(const Vector& p) {
  return {-p.x(), -p.y(), p.z()};
}

struct EdgePoint {
  Vector point;
  Vector normal;
};

EdgePoint edge_point(const EdgeInputs& in) {
  const DrillPoint drill(in);
  const Vector point =
      in.edge == Edge::cutting ? drill.cutting_edge(in.position_mm) : drill.chisel_edge(in.position_mm);
  return {point, drill.outward_normal(point)};
}

Attack attack(const EdgePoint& edge, const Bath& bath, double spin_angle_deg) {
  const auto into_station = [&](const Vector& p) {
    return turn_y(-bath.tilt_deg, turn_z(spin_angle_deg, p));
  };
  const Vector q = into_station(edge.point);
  const Vector station = turn_z(bath.azimuth_deg, q + Vector(bath.offset_x_mm, 0, bath.offset_z_mm));
  const Vector in_bath = station - Vector(0, bath.bath_radius_mm, 0);
  const Vector normal = turn_z(bath.azimuth_deg, into_station(edge.normal));
  const Vector axis = turn_z(bath.azimuth_deg, turn_y(-bath.tilt_deg, Vector::UnitZ()));
  constexpr double rad_s = std::numbers::pi / 30;
  const Vector velocity = rad_s / 1000 *
                          (bath.rotor_rpm * Vector::UnitZ().cross(in_bath) +
                           bath.spin_rpm * axis.cross(turn_z(bath.azimuth_deg, q)) +
                           bath.azimuth_rpm * Vector::UnitZ().cross(station));
  const double speed = velocity.norm();
  if (!(speed > 0)) reject("the edge point does not move: rotor_rpm, spin_rpm or azimuth_rpm must move it");
  const double sine = std::clamp(velocity.dot(normal) / speed, -1.0, 1.0);
  return {std::asin(sine) / rad_per_deg, speed, velocity.x(), velocity.y(), velocity.z()};
}

}  // namespace

OffsetX azimuth_offset_x_max(const OffsetXInputs& in) {
  return guarded<&azimuth_offset_x_max>(in, [&] {
    const double tilt = in.tilt_deg * rad_per_deg;
    const double phi = in.half_point_angle_deg * rad_per_deg;
    const double corner =
        in.zone_width_mm / 2 - in.working_gap_mm - in.drill_diameter_mm * std::cos(tilt) / 2;
    const double tip = in.half_point_angle_deg < in.tilt_deg
                           ? in.drill_diameter_mm / (2 * std::sin(phi)) * std::sin(tilt - phi)
                           : 0;
    return OffsetX{corner - tip};
  });
}

OffsetZ azimuth_offset_z(const OffsetZInputs& in) {
  return guarded<&azimuth_offset_z>(in, [&] {
    return OffsetZ{(in.pole_height_mm - in.drill_diameter_mm * std::sin(in.tilt_deg * rad_per_deg)) / 2};
  });
}

ConeSetup cone_grind_setup(const Drill& in) {
  return guarded<&cone_grind_setup>(in, [&] { return DrillPoint(in).setup(); });
}

Point flank_point(const FlankParameters& in) {
  return guarded<&flank_point>(in, [&] {
    const DrillPoint drill(in);
    const Vector p = in.surface == 1 ? drill.flank(in.u_mm, in.v_deg * rad_per_deg)
                                     : half_turn(drill.flank(in.u_mm, (in.v_deg - 180) * rad_per_deg));
    return Point{p.x(), p.y(), p.z()};
  });
}

Normal flank_normal(const FlankLocation& in) {
  return guarded<&flank_normal>(in, [&] {
    const DrillPoint drill(in);
    const Vector p(in.x_mm, in.y_mm, in.z_mm);
    const Vector n =
        in.surface == 1 ? drill.outward_normal(p) : half_turn(drill.outward_normal(half_turn(p)));
    return Normal{n.x(), n.y(), n.z()};
  });
}

Point cutting_edge_point(const EdgeRadius& in) {
  return guarded<&cutting_edge_point>(in, [&] {
    const Vector p = DrillPoint(in).cutting_edge(in.radius_mm);
    return Point{p.x(), p.y(), p.z()};
  });
}

ChiselPoint chisel_edge_point(const ChiselPosition& in) {
  return guarded<&chisel_edge_point>(in, [&] {
    const Vector p = DrillPoint(in).chisel_edge(in.x_mm);
    return ChiselPoint{p.y(), p.z()};
  });
}

ChiselEdge chisel_edge(const Drill& in) {
  return guarded<&chisel_edge>(in, [&] { return DrillPoint(in).chisel(); });
}

Attack edge_attack_angle(const AttackInputs& in) {
  return guarded<&edge_attack_angle>(in, [&] { return attack(edge_point(in), in, in.spin_angle_deg); });
}

AttackCycle attack_angle_cycle(const CycleInputs& in) {
  return guarded<&attack_angle_cycle>(in, [&] {
    const double samples = std::round(360 / in.step_deg);
    require(samples >= 1 && std::abs(samples * in.step_deg - 360) <= 1e-9 * 360, "step_deg", in.step_deg,
            "must divide 360");
    require(samples <= 36000, "step_deg", in.step_deg, "asks for more than 36000 samples");
    const EdgePoint edge = edge_point(in);
    AttackCycle out{-90, 90, 0, 0};
    for (int k = 0; k < static_cast<int>(samples); ++k) {
      const double chi = attack(edge, in, 360 * k / samples).chi_deg;
      out.chi_max_deg = std::max(out.chi_max_deg, chi);
      out.chi_min_deg = std::min(out.chi_min_deg, chi);
      out.chi_mean_deg += chi / samples;
      if (chi > 0) out.active_fraction += 1;
    }
    out.active_fraction /= samples;
    return out;
  });
}

Efficiency kinematic_efficiency(const Azimuth& in) {
  return guarded<&kinematic_efficiency>(in, [&] {
    // Lagrange parabola through (0; 1.6), (48; 1.0), (90; -0.6), conclusions of the paper.
    const double a = in.azimuth_deg;
    return Efficiency{1.6 * (a - 48) * (a - 90) / (48.0 * 90) + 1.0 * a * (a - 90) / (48.0 * (48 - 90)) -
                      0.6 * a * (a - 48) / (90.0 * (90 - 48))};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K208",
       .title = "Rotor machine tools for magnetic-abrasive treatment on the base of a 'ring bath' magnetic "
                "system: kinematics of treatment of the flank surface of twist drills",
       .authors = "Heichuk V. M.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011, "
                    "pp. 180-188",
       .models =
           "A twist drill carried round a ring-shaped magnetic gap filled with abrasive powder: where it "
           "fits, its conical flanks and edges, the attack angle between powder and flank along the "
           "edges, and an index of how evenly the flank is worked.",
       .role = "treatment",
       .errata = {
           "Eq. (2): l1 is l0, and theta_N is the tangent of theta_N; both follow from the geometry.",
           "The second flank is printed with the matrices of the first; it uses the opposite angle and "
           "shift, as eq. (6) itself does, and eq. (6) is printed with the arguments of the first."}});

  const auto angle = [](auto& f, auto pointer, const char* name, const char* symbol, const char* meaning) {
    f.optional(pointer, name, symbol, "deg", open(0, 90), meaning);
  };
  const auto diameter = [](auto& f, auto pointer) {
    f.optional(pointer, "drill_diameter_mm", "D", "mm", positive(), "diameter of the drill");
  };
  const auto drill = [&](auto& f) {
    diameter(f, &Drill::drill_diameter_mm);
    f.optional(&Drill::core_radius_mm, "core_radius_mm", "r", "mm", positive(),
               "half the web, below half of the diameter");
    angle(f, &Drill::half_point_angle_deg, "half_point_angle_deg", "phi_c", "half of the point angle");
    angle(f, &Drill::cone_half_angle_deg, "cone_half_angle_deg", "rho", "half angle of the grinding cone");
    angle(f, &Drill::chisel_angle_deg, "chisel_angle_deg", "psi", "chisel edge angle");
    angle(f, &Drill::clearance_deg, "clearance_deg", "alpha", "clearance at the corner");
  };
  const auto tilt = [](auto& f, auto pointer) {
    f.optional(pointer, "tilt_deg", "xi", "deg", closed(0, 90), "tilt of the drill from the vertical");
  };
  const auto bath = [&](auto& f) {
    tilt(f, &Bath::tilt_deg);
    f.optional(&Bath::azimuth_deg, "azimuth_deg", "alpha", "deg", any(), "turn about the station's vertical")
        .optional(&Bath::offset_x_mm, "offset_x_mm", "T_X", "mm", any(), "radial offset of the drill")
        .optional(&Bath::offset_z_mm, "offset_z_mm", "T_Z", "mm", any(), "vertical offset of the drill")
        .optional(&Bath::bath_radius_mm, "bath_radius_mm", "R", "mm", positive(), "radius of the ring bath")
        .optional(&Bath::rotor_rpm, "rotor_rpm", "n_p", "rpm", any(), "speed of the rotor")
        .optional(&Bath::spin_rpm, "spin_rpm", "n_S", "rpm", any(), "spin of the drill (circular feed)")
        .optional(&Bath::azimuth_rpm, "azimuth_rpm", "n_a", "rpm", any(), "azimuth feed");
  };
  const auto edge = [](auto& f) {
    f.input(&EdgeInputs::edge, "edge", "-", "-", no_range(), "which edge", "cutting")
        .input(&EdgeInputs::position_mm, "position_mm", "R", "mm", any(),
               "radius on the cutting edge, x on the chisel edge", 8.0);
  };
  const auto surface = [](auto& f, auto pointer) {
    f.input(pointer, "surface", "-", "1", closed(1, 2), "flank", 1);
  };

  source
      .function<&azimuth_offset_x_max>("azimuth_offset_x_max", "Largest radial offset that keeps the gap.",
                                       "eq. (1)", Provenance::paper)
      .input(&OffsetXInputs::zone_width_mm, "zone_width_mm", "H", "mm", positive(), "width of the gap", 40.0)
      .input(&OffsetXInputs::working_gap_mm, "working_gap_mm", "delta", "mm", non_negative(), "working gap",
             4.0)
      .with([&](auto& f) {
        diameter(f, &OffsetXInputs::drill_diameter_mm);
        angle(f, &OffsetXInputs::half_point_angle_deg, "half_point_angle_deg", "phi_c",
              "half of the point angle");
        tilt(f, &OffsetXInputs::tilt_deg);
      })
      .output(&OffsetX::tx_max_mm, "tx_max_mm", "T_x", "mm", any(),
              "largest modulus of the offset; negative: the drill does not fit");
  source
      .function<&azimuth_offset_z>("azimuth_offset_z", "Vertical offset of the drill.", "T_Z",
                                   Provenance::paper)
      .input(&OffsetZInputs::pole_height_mm, "pole_height_mm", "H_PN", "mm", positive(),
             "height of the poles", 30.0)
      .with([&](auto& f) {
        diameter(f, &OffsetZInputs::drill_diameter_mm);
        tilt(f, &OffsetZInputs::tilt_deg);
      })
      .output(&OffsetZ::tz_mm, "tz_mm", "T_Z", "mm", any(), "vertical offset");
  source
      .function<&cone_grind_setup>("cone_grind_setup", "Position of the grinding cone.", "eq. (2)",
                                   Provenance::repaired)
      .with(drill)
      .output(&ConeSetup::mu_deg, "mu_deg", "mu_D", "deg", open(0, 90), "angle of the web at the corner")
      .output(&ConeSetup::theta_n_deg, "theta_n_deg", "theta_N", "deg", open(-90, 90),
              "clearance reduced to the cone")
      .output(&ConeSetup::c1, "c1", "c_1", "1", any(), "rise of the surface along the edge")
      .output(&ConeSetup::l0_mm, "l0_mm", "l_0", "mm", positive(), "offset of the cone along the edge")
      .output(&ConeSetup::k0_mm, "k0_mm", "k_0", "mm", positive(), "offset of the cone across the edge")
      .output(&ConeSetup::b_mm, "b_mm", "B", "mm", positive(), "axial distance of the apex")
      .output(&ConeSetup::delta_z_deg, "delta_z_deg", "delta_z", "deg", open(-90, 90),
              "inclination of the cone axis")
      .note(
          "With the defaults the exact surface has a clearance of 12.03 deg and a chisel angle of 52.8 deg.");
  source.function<&flank_point>("flank_point", "Point of a flank.", "eqs. (5), (6)", Provenance::repaired)
      .with([&](auto& f) { surface(f, &FlankParameters::surface); })
      .input(&FlankParameters::u_mm, "u_mm", "u", "mm", positive(), "radius on the cone", 9.0)
      .input(&FlankParameters::v_deg, "v_deg", "v", "deg", any(), "angle on the cone", 5.0)
      .with(drill)
      .output(&Point::x_mm, "x_mm", "x", "mm", any(), "point")
      .output(&Point::y_mm, "y_mm", "y", "mm", any(), "point")
      .output(&Point::z_mm, "z_mm", "z", "mm", any(), "point, tip towards -z");
  source
      .function<&flank_normal>("flank_normal", "Outward normal of a flank.", "gradient of the cone",
                               Provenance::completion)
      .with([&](auto& f) { surface(f, &FlankLocation::surface); })
      .input(&FlankLocation::x_mm, "x_mm", "x", "mm", any(), "point on the flank", 9.8869)
      .input(&FlankLocation::y_mm, "y_mm", "y", "mm", any(), "point on the flank", -1.5)
      .input(&FlankLocation::z_mm, "z_mm", "z", "mm", any(), "point on the flank", 0.0108)
      .with(drill)
      .output(&Normal::nx, "nx", "n", "1", closed(-1, 1), "unit normal")
      .output(&Normal::ny, "ny", "n", "1", closed(-1, 1), "unit normal")
      .output(&Normal::nz, "nz", "n", "1", closed(-1, 0), "unit normal, to the tip")
      .note("The point is taken to lie on the flank; that is not checked.");
  source
      .function<&cutting_edge_point>("cutting_edge_point", "Point of the cutting edge.", "completion",
                                     Provenance::completion)
      .input(&EdgeRadius::radius_mm, "radius_mm", "R", "mm", positive(), "radius, above the core radius", 8.0)
      .with(drill)
      .output(&Point::x_mm, "x_mm", "x", "mm", any(), "point")
      .output(&Point::y_mm, "y_mm", "y", "mm", any(), "point, at minus the core radius")
      .output(&Point::z_mm, "z_mm", "z", "mm", any(), "point")
      .note("The flute surface is not in the paper: flank cut by the plane y = -r, a straight edge.");
  source
      .function<&chisel_edge_point>("chisel_edge_point", "Point of the chisel edge.",
                                    "intersection of (5) and (6)", Provenance::paper)
      .input(&ChiselPosition::x_mm, "x_mm", "x", "mm", any(), "position, 0 is the drill axis", 0.8)
      .with(drill)
      .output(&ChiselPoint::y_mm, "y_mm", "y", "mm", any(), "point")
      .output(&ChiselPoint::z_mm, "z_mm", "z", "mm", any(), "point");
  source
      .function<&chisel_edge>("chisel_edge", "End and true angle of the chisel edge.",
                              "intersection of (5) and (6)", Provenance::paper)
      .with(drill)
      .output(&ChiselEdge::x_end_mm, "x_end_mm", "x", "mm", positive(), "corner of the edge at x > 0")
      .output(&ChiselEdge::chisel_angle_true_deg, "chisel_angle_true_deg", "psi", "deg", open(0, 90),
              "acute angle to the x axis at the drill axis");
  source
      .function<&edge_attack_angle>("edge_attack_angle", "Attack angle of the powder at a point of an edge.",
                                    "eq. (6b)", Provenance::completion)
      .with(edge)
      .input(&AttackInputs::spin_angle_deg, "spin_angle_deg", "phi", "deg", any(), "turn of the drill", 0.0)
      .with(drill)
      .with(bath)
      .output(&Attack::chi_deg, "chi_deg", "chi", "deg", closed(-90, 90),
              "attack angle; positive: the flank runs into the powder")
      .output(&Attack::speed_m_s, "speed_m_s", "V", "m/s", positive(), "speed of the point")
      .output(&Attack::vx_m_s, "vx_m_s", "V_x", "m/s", any(), "velocity in the bath frame")
      .output(&Attack::vy_m_s, "vy_m_s", "V_y", "m/s", any(), "velocity in the bath frame")
      .output(&Attack::vz_m_s, "vz_m_s", "V_z", "m/s", any(), "velocity in the bath frame")
      .note("The frame chain is a completion; it reproduces the published extremes within 2 deg.");
  source
      .function<&attack_angle_cycle>("attack_angle_cycle", "Attack angle over one drill revolution.",
                                     "eq. (6b)", Provenance::completion)
      .with(edge)
      .optional(&CycleInputs::step_deg, "step_deg", "-", "deg", open_low(0, 360),
                "step of the samples, divides 360")
      .with(drill)
      .with(bath)
      .output(&AttackCycle::chi_max_deg, "chi_max_deg", "chi", "deg", closed(-90, 90), "largest")
      .output(&AttackCycle::chi_min_deg, "chi_min_deg", "chi", "deg", closed(-90, 90), "smallest")
      .output(&AttackCycle::chi_mean_deg, "chi_mean_deg", "chi", "deg", closed(-90, 90), "mean")
      .output(&AttackCycle::active_fraction, "active_fraction", "-", "1", probability(),
              "share of the revolution in which the flank is worked");
  source
      .function<&kinematic_efficiency>("kinematic_efficiency", "How evenly the flank is worked.",
                                       "conclusions", Provenance::completion)
      .input(&Azimuth::azimuth_deg, "azimuth_deg", "alpha", "deg", closed(0, 90), "azimuth", 30.0)
      .output(&Efficiency::k_kef, "k_kef", "k_kef", "1", any(),
              "index: 1 balanced, above 1 impact dominates, near 0 shadow")
      .note("Three published points for the feed ratio -3, interpolated by a parabola.");
}

}  // namespace verstat::models::k208
