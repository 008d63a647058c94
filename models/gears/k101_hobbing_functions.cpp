// The public functions of K101 on top of the kinematic model in hobbing_process.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/gears/hobbing_process.h"
#include "models/gears/k101_hobbing_chip_thickness.h"
#include "models/math/trig_degrees.h"

namespace verstat::models::k101 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double chip_step_mm = 0.05;  // scan along the normal for one point
constexpr double sweep_step_mm = 0.1;  // the same for the sweep over all teeth
constexpr std::int64_t earlier_revs = 4;

// Tooth angle in its turn, 0 to 2 pi.
double turn_angle(double tooth_angle_deg) {
  const double turn = std::fmod(tooth_angle_deg, 360);
  return to_radians(turn < 0 ? turn + 360 : turn);
}

double contact_half_angle(double centre_mm, double hob_radius_mm, double gear_radius_mm) {
  const double sine = (centre_mm - gear_radius_mm) / hob_radius_mm;
  if (sine >= 1) reject("the tip cylinders of hob and blank do not meet: there is no contact arc");
  if (sine <= -1) reject("the hob lies inside the blank: there is no contact arc");
  return std::asin(sine);
}

// Samples along the edge of one tooth, with the length that each stands for by the trapezoidal rule.
struct Edge {
  std::vector<OutlinePoint> points;
  std::vector<double> weight_mm;
};

Edge sampled_edge(const HobbingProcess& process, std::int64_t n_flank, std::int64_t n_round,
                  std::int64_t n_tip) {
  Edge edge{process.edge_samples(n_flank, n_round, n_tip), {}};
  edge.weight_mm.assign(edge.points.size(), 0);
  for (std::size_t k = 0; k + 1 < edge.points.size(); ++k) {
    const double chord =
        std::hypot(edge.points[k + 1].r - edge.points[k].r, edge.points[k + 1].w - edge.points[k].w);
    edge.weight_mm[k] += chord / 2;
    edge.weight_mm[k + 1] += chord / 2;
  }
  return edge;
}

}  // namespace

HobGeometry hob_geometry(const HobInputs& in) {
  return guarded<&hob_geometry>(in, [&] {
    const Hob hob(in);
    return HobGeometry{.pitch_radius_mm = hob.pitch_radius,
                       .lead_angle_deg = to_degrees(hob.lead_angle),
                       .helix_parameter_mm_rad = hob.helix,
                       .lead_mm = 2 * pi * hob.helix,
                       .a1_mm = hob.a1,
                       .tip_centre_radial_mm = hob.corner_radial,
                       .tip_centre_axial_mm = hob.corner_axial,
                       .section_angle_deg = to_degrees(hob.section_angle)};
  });
}

HobbingSetup hobbing_setup(const SetupInputs& in) {
  return guarded<&hobbing_setup>(in, [&] {
    const double hob_pitch_radius = in.hob_diameter_mm / 2 - in.hob_addendum_factor * in.module_mm;
    require(in.module_mm < 2 * hob_pitch_radius, "hob_diameter_mm", in.hob_diameter_mm,
            "is too small: the pitch diameter hob_diameter_mm - 2 hob_addendum_factor module_mm must be "
            "above module_mm");
    const double lead_angle = std::asin(in.module_mm / (2 * hob_pitch_radius));
    const double z = static_cast<double>(in.gear_teeth);
    const double gear_pitch_radius = in.module_mm * z / (2 * cos_deg(in.gear_helix_deg));
    const double centre = gear_pitch_radius + in.profile_shift * in.module_mm + hob_pitch_radius;
    const double outer = gear_pitch_radius + in.module_mm * (1 + in.profile_shift);
    return HobbingSetup{.centre_distance_mm = centre,
                        .gear_outer_radius_mm = outer,
                        .setting_angle_deg = to_degrees(lead_angle) - in.gear_helix_deg,
                        .cutting_depth_mm = in.module_mm * (1 + in.hob_addendum_factor),
                        .ratio_i12 = 1 / z};
  });
}

HobbingKinematics hobbing_kinematics(const KinematicsInputs& in) {
  return guarded<&hobbing_kinematics>(in, [&] {
    const HobbingProcess process(in);
    const double hob_rotation = to_radians(in.hob_angle_deg);
    return HobbingKinematics{process.blank_rate * in.hob_angle_deg, process.travel_rate * hob_rotation};
  });
}

EdgePoint hob_edge_point(const EdgePointInputs& in) {
  return guarded<&hob_edge_point>(in, [&] {
    const HobbingProcess process(in);
    const double t = process.tooth_angle(in.tooth_index);
    const Eigen::Vector3d point = process.place(process.outline_point(in.segment, in.parameter), t, t);
    return EdgePoint{point.x(), point.y(), point.z()};
  });
}

BlankPoint hob_point_in_blank_frame(const BlankPointInputs& in) {
  return guarded<&hob_point_in_blank_frame>(in, [&] {
    const HobbingProcess process(in);
    const double c = cos_deg(in.hob_angle_deg);
    const double s = sin_deg(in.hob_angle_deg);
    const Eigen::Vector3d point0(c * in.x1_mm - s * in.y1_mm, s * in.x1_mm + c * in.y1_mm, in.z1_mm);
    const Eigen::Vector3d point = process.to_blank(point0, to_radians(in.hob_angle_deg));
    return BlankPoint{point.x(), point.y(), point.z()};
  });
}

Approach hob_approach_length(const ApproachInputs& in) {
  return guarded<&hob_approach_length>(in, [&] {
    const CylinderContact contact =
        cylinder_contact(in.centre_distance_mm, in.hob_diameter_mm / 2, in.gear_outer_radius_mm,
                         to_radians(in.setting_angle_deg));
    return Approach{contact.length_mm, to_degrees(contact.angle_rad)};
  });
}

MainTime hobbing_main_time(const MainTimeInputs& in) {
  return guarded<&hobbing_main_time>(in, [&] {
    const double ratio = static_cast<double>(in.hob_starts) / static_cast<double>(in.gear_teeth);
    const double revolutions =
        (2 * in.approach_length_mm + in.face_width_mm) / (in.axial_feed_mm_rev * ratio);
    return MainTime{2 * pi * revolutions, revolutions, revolutions / in.hob_speed_rpm};
  });
}

ContactArc hob_contact_arc(const ContactArcInputs& in) {
  return guarded<&hob_contact_arc>(in, [&] {
    const double half_deg = to_degrees(
        contact_half_angle(in.centre_distance_mm, in.hob_diameter_mm / 2, in.gear_outer_radius_mm));
    return ContactArc{180 + half_deg, 360 - half_deg};
  });
}

Engaged hob_tooth_engaged(const EngagedInputs& in) {
  return guarded<&hob_tooth_engaged>(in, [&] {
    constexpr double rounding_deg = 1e-9;
    const auto turn = [](double angle_deg) {
      const double rest = std::fmod(angle_deg, 360);
      return rest < 0 ? rest + 360 : rest;
    };
    const double arc = turn(in.exit_angle_deg - in.entry_angle_deg);
    const double into = turn(in.tooth_angle_deg - in.entry_angle_deg);
    return Engaged{into <= arc + rounding_deg || into >= 360 - rounding_deg};
  });
}

WorkingTeeth hob_working_teeth(const WorkingTeethInputs& in) {
  return guarded<&hob_working_teeth>(in, [&] {
    const double half_mm = cylinder_contact(in.centre_distance_mm, in.gear_outer_radius_mm,
                                            in.hob_diameter_mm / 2, to_radians(in.setting_angle_deg))
                               .length_mm;
    const double pitches = std::floor(half_mm / (in.lead_mm / static_cast<double>(in.hob_gashes)));
    require(pitches < 1e9, "lead_mm", in.lead_mm, "is too small against the zone of intersection");
    return WorkingTeeth{half_mm, 2 * static_cast<std::int64_t>(pitches) + 1};
  });
}

RelativeVelocity hob_relative_velocity(const VelocityInputs& in) {
  return guarded<&hob_relative_velocity>(in, [&] {
    const HobbingProcess process(in);
    const OutlinePoint point = process.outline_point(in.segment, in.parameter);
    const Eigen::Vector3d v = process.velocity(
        process.place(point, turn_angle(in.tooth_angle_deg), process.tooth_angle(in.tooth_index)));
    RelativeVelocity out{v.x(), v.y(), v.z(), std::nullopt};
    if (in.hob_speed_rpm) out.speed_m_min = v.norm() * 2 * pi * *in.hob_speed_rpm / 1000;
    return out;
  });
}

SurfaceNormal cutting_surface_normal(const ToothPointInputs& in) {
  return guarded<&cutting_surface_normal>(in, [&] {
    const HobbingProcess process(in);
    const OutlinePoint point = process.outline_point(in.segment, in.parameter);
    const double theta = turn_angle(in.tooth_angle_deg);
    const double t = process.tooth_angle(in.tooth_index);
    const Eigen::Vector3d n = process.direction_to_blank(process.swept(point, theta, t).normal0, theta - t);
    return SurfaceNormal{n.x(), n.y(), n.z()};
  });
}

Chip hobbing_chip_thickness(const ChipInputs& in) {
  return guarded<&hobbing_chip_thickness>(in, [&] {
    const HobbingProcess process(in);
    const OutlinePoint point = process.outline_point(in.segment, in.parameter);
    std::optional<ToothPosition::EndFaces> faces;
    if (in.blank_limited) {
      require(in.face_width_mm.has_value(), "face_width_mm", Value(), "is needed when blank_limited is true");
      const double near_mm = process.approach;
      const double far_mm = process.approach + *in.face_width_mm;
      faces = process.climb ? ToothPosition::EndFaces{-far_mm, -near_mm}
                            : ToothPosition::EndFaces{near_mm, far_mm};
    }
    const ToothPosition position(process, in.tooth_index, turn_angle(in.tooth_angle_deg),
                                 in.previous_blank_revs, in.blank_limited ? in.hob_turns : 0, faces);
    return Chip{position.chip_thickness(point, chip_step_mm)};
  });
}

ToothLoad hobbing_tooth_load(const ToothLoadInputs& in) {
  return guarded<&hobbing_tooth_load>(in, [&] {
    constexpr double contact_mm = 1e-4;
    const HobbingProcess process(in);
    const Edge edge = sampled_edge(process, in.n_flank, in.n_round, in.n_tip);
    const ToothPosition position(process, in.tooth_index, turn_angle(in.tooth_angle_deg), earlier_revs);
    const bool force = in.kc11_n_mm2.has_value() && in.mc.has_value();
    ToothLoad out{0, 0, 0, std::nullopt};
    double force_n = 0;
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const double chip = position.chip_thickness(edge.points[k], chip_step_mm);
      out.max_chip_thickness_mm = std::max(out.max_chip_thickness_mm, chip);
      if (chip > contact_mm) out.contact_length_mm += edge.weight_mm[k];
      out.chip_section_mm2 += chip * edge.weight_mm[k];
      if (force && chip > 0) force_n += *in.kc11_n_mm2 * std::pow(chip, 1 - *in.mc) * edge.weight_mm[k];
    }
    if (force) out.cutting_force_n = force_n;
    return out;
  });
}

LoadSummary hobbing_load_summary(const LoadSummaryInputs& in) {
  return guarded<&hobbing_load_summary>(in, [&] {
    const HobbingProcess process(in);
    const Edge edge = sampled_edge(process, 16, 5, 7);
    const double half_deg = to_degrees(
        contact_half_angle(process.centre_distance, process.hob.tip_radius, process.gear_outer_radius));
    const std::int64_t last = process.last_tooth + 1;
    LoadSummary out{};
    out.first_tooth_index = -last;
    std::vector<double> volumes;
    double total = 0;
    for (std::int64_t j = -last; j <= last; ++j) {
      double volume = 0;
      for (std::int64_t k = 0;; ++k) {
        const double theta_deg = 180 + half_deg - 2 + (static_cast<double>(k) + 0.5) * in.angle_step_deg;
        if (theta_deg >= 360 - half_deg + 2) break;
        const ToothPosition position(process, j, to_radians(theta_deg), earlier_revs);
        for (std::size_t s = 0; s < edge.points.size(); ++s) {
          const ToothPosition::Sample chip = position.sample(edge.points[s], sweep_step_mm);
          out.max_chip_thickness_mm = std::max(out.max_chip_thickness_mm, chip.thickness_mm);
          volume += chip.thickness_mm * chip.width_mm_rad * edge.weight_mm[s];
        }
      }
      volume *= to_radians(in.angle_step_deg);
      volumes.push_back(volume);
      total += volume;
    }
    if (!(total > 0)) reject("no tooth cuts anything at this angle step");
    out.chip_volume_per_gap_mm3 = total;
    for (std::size_t k = 0; k < volumes.size(); ++k) {
      const double share = volumes[k] / total;
      out.tooth_shares.push_back(share);
      if (k == 0 || share > out.most_loaded_share) {
        out.most_loaded_share = share;
        out.most_loaded_tooth = static_cast<std::int64_t>(k) - last;
      }
    }
    return out;
  });
}

HoffmeisterChip hoffmeister_chip_thickness(const HoffmeisterInputs& in) {
  return guarded<&hoffmeister_chip_thickness>(in, [&] {
    const double b = std::abs(in.gear_helix_deg);
    const double m = in.module_mm;
    return HoffmeisterChip{
        4.9 * m * std::pow(static_cast<double>(in.gear_teeth), 0.00925 * b - 0.542) * std::exp(-0.015 * b) *
        std::exp(-0.015 * in.profile_shift) * std::pow(in.hob_diameter_mm / (2 * m), -0.00825 * b - 0.225) *
        std::pow(static_cast<double>(in.hob_gashes) / static_cast<double>(in.hob_starts), -0.877) *
        std::pow(in.axial_feed_mm_rev / m, 0.511) * std::pow(in.cutting_depth_mm / m, 0.319)};
  });
}

}  // namespace verstat::models::k101
