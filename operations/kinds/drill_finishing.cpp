#include "operations/kinds/drill_finishing.h"

#include <cmath>

#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::models::k208::Drill> {
  static std::vector<Field> fields() {
    using S = k208::Drill;
    return {
        may<S>(&S::drill_diameter_mm, "drill_diameter_mm", "mm", open_low(0, 200), "drill diameter"),
        may<S>(&S::core_radius_mm, "core_radius_mm", "mm", open_low(0, 100), "half the web"),
        may<S>(&S::half_point_angle_deg, "half_point_angle_deg", "deg", open(0, 90), "half point angle"),
        may<S>(&S::cone_half_angle_deg, "cone_half_angle_deg", "deg", open(0, 90), "of the grinding cone"),
        may<S>(&S::chisel_angle_deg, "chisel_angle_deg", "deg", open(0, 180), "of the chisel edge"),
        may<S>(&S::clearance_deg, "clearance_deg", "deg", closed(0, 45), "clearance at the corner")};
  }
};

template <>
struct verstat::models::StructFields<verstat::models::k208::Bath> {
  static std::vector<Field> fields() {
    using S = k208::Bath;
    return {may<S>(&S::tilt_deg, "tilt_deg", "deg", closed(0, 90), "tilt of the drill from the vertical"),
            may<S>(&S::azimuth_deg, "azimuth_deg", "deg", closed(0, 90), "turn about the vertical"),
            may<S>(&S::offset_x_mm, "offset_x_mm", "mm", closed(-1000, 1000), "radial offset"),
            may<S>(&S::offset_z_mm, "offset_z_mm", "mm", closed(-1000, 1000), "vertical offset"),
            may<S>(&S::bath_radius_mm, "bath_radius_mm", "mm", open_low(0, 5000), "radius of the ring"),
            may<S>(&S::rotor_rpm, "rotor_rpm", "rpm", closed(-1e4, 1e4), "speed of the carrier"),
            may<S>(&S::spin_rpm, "spin_rpm", "rpm", closed(-1e4, 1e4), "speed of the drill about its axis"),
            may<S>(&S::azimuth_rpm, "azimuth_rpm", "rpm", closed(-1e4, 1e4), "speed about the vertical")};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::DrillFinishing> {
  static std::vector<Field> fields() {
    using S = operations::DrillFinishing;
    return {may<S>(&S::drill, "drill", "-", no_range(), "geometry of the drills"),
            may<S>(&S::bath, "bath", "-", no_range(), "how they are held and moved"),
            may<S>(&S::powder, "powder", "-", no_range(), "powder of the bath"),
            may<S>(&S::hardness_gpa, "hardness_gpa", "GPa", open_low(0, 50), "hardness of the edge before"),
            may<S>(&S::cycle_s, "cycle_s", "s", open_low(0, 1e5), "time of the batch in the bath"),
            may<S>(&S::handling_s, "handling_s", "s", closed(0, 1e5), "handling per batch"),
            may<S>(&S::batch_size, "batch_size", "1", closed(1, 100'000), "drills of a batch"),
            may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2), "scatter of the lives of the drills"),
            may<S>(&S::breakage_fraction, "breakage_fraction", "1", probability(),
                   "share of lives that end by breakage"),
            may<S>(&S::treatment_cost, "treatment_cost", "money", closed(0, 1e9), "cost per drill"),
            may<S>(&S::unevenness_max, "unevenness_max", "1", closed(0, 10),
                   "largest difference of the kinematic efficiency from 1"),
            may<S>(&S::active_fraction_min, "active_fraction_min", "1", probability(),
                   "least share of a turn in which the powder attacks the corner")};
  }
};

namespace verstat::operations {

namespace k103 = models::k103;
namespace k208 = models::k208;

CutPlan plan(const DrillFinishing& spec, const PlanContext&) {
  const auto at = [&](k208::Edge edge, double position_mm) {
    k208::CycleInputs in;
    static_cast<k208::Drill&>(in) = spec.drill;
    static_cast<k208::Bath&>(in) = spec.bath;
    in.edge = edge;
    in.position_mm = position_mm;
    in.step_deg = 10;
    return k208::attack_angle_cycle(in);
  };
  const double corner_mm = spec.drill.drill_diameter_mm / 2;
  models::require(spec.drill.core_radius_mm < corner_mm, "drill/core_radius_mm", spec.drill.core_radius_mm,
                  "must be below the radius of the drill");
  const double middle_mm = (corner_mm + spec.drill.core_radius_mm) / 2;
  const auto corner = at(k208::Edge::cutting, corner_mm);
  const auto middle = at(k208::Edge::cutting, middle_mm);
  const auto chisel = at(k208::Edge::chisel, 0);
  const double efficiency = k208::kinematic_efficiency({spec.bath.azimuth_deg}).k_kef;
  const auto effect =
      k103::mat_treatment_effect({.powder = spec.powder, .hardness_before_gpa = spec.hardness_gpa});
  const auto surface = k103::mat_surface_kinetics({.time_s = spec.cycle_s});

  CutPlan p;
  p.quantities.reserve(16);
  p.set_main_time(
      k103::mat_batch_time({.size = spec.batch_size, .cycle_s = spec.cycle_s, .handling_s = spec.handling_s})
          .time_min,
      "K103.mat_batch_time");
  auto& q = p.quantities;
  constexpr const char* attack = "K208.attack_angle_cycle";
  q.push_back({"attack_corner_deg", corner.chi_mean_deg, "deg", attack,
               "mean attack angle of the powder at the corner"});
  q.push_back({"attack_middle_deg", middle.chi_mean_deg, "deg", attack, "at the middle of the edge"});
  q.push_back({"attack_chisel_deg", chisel.chi_mean_deg, "deg", attack, "at the chisel edge"});
  q.push_back({"active_fraction", corner.active_fraction, "1", attack,
               "share of a turn in which the flank at the corner runs into the powder"});
  q.push_back({"kinematic_efficiency", efficiency, "1", "K208.kinematic_efficiency",
               "1: all of the edge is worked alike; feed ratio -3"});
  q.push_back({"life_factor_min", effect.life_factor_min, "1", "K103.mat_treatment_effect",
               "life over that of untreated drills, least"});
  q.push_back(
      {"life_factor", effect.life_factor_typical, "1", "K103.mat_treatment_effect", "the same, typical"});
  q.push_back({"ra_um", surface.ra_um, "um", "K103.mat_surface_kinetics", "roughness Ra after the bath"});
  q.push_back(
      {"edge_radius_um", surface.edge_radius_um, "um", "K103.mat_surface_kinetics", "edge radius after"});
  q.push_back({"hardness_min_gpa", effect.hardness_after_min_gpa, "GPa", "K103.mat_treatment_effect",
               "hardness after, at least"});
  if (spec.unevenness_max)
    p.limits.push_back({"unevenness", std::abs(efficiency - 1), *spec.unevenness_max, true, "1",
                        "K208.kinematic_efficiency"});
  if (spec.active_fraction_min)
    p.limits.push_back(
        {"active_fraction", corner.active_fraction, *spec.active_fraction_min, false, "1", attack});
  p.lot = PreparedLot{.law = models::LifeLawKind::weibull,
                      .life_factor = effect.life_factor_typical,
                      .cv = spec.life_cv,
                      .breakage_fraction = spec.breakage_fraction,
                      .added_cost_per_insert = spec.treatment_cost,
                      .origin = "K103.mat_treatment_effect"};
  return p;
}

namespace drill_finishing {
void add_to(Kinds& kinds) {
  kinds.add<DrillFinishing>("Drills finished in a magnetic-abrasive ring bath: a lot with longer lives.",
                            {"K208", "K103"});
}
}  // namespace drill_finishing

}  // namespace verstat::operations
