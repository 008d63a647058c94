#include "models/cutting/k102_insert_nose_radius_forces.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace verstat::models::k102 {
namespace {

// A row of a table: the argument and the values of the three components.
struct Row {
  double at;
  double z, y, x;
};

// Handbook corrections as the card prints them (2); linear between the rows, clamped at the ends.
constexpr std::array lead_angle_table{Row{30, 1.08, 1.30, 0.78}, Row{45, 1.0, 1.0, 1.0},
                                      Row{60, 0.94, 0.77, 1.11}, Row{90, 0.89, 0.50, 1.17}};
constexpr std::array rake_table{Row{-15, 1.25, 2.0, 2.0}, Row{0, 1.1, 1.4, 1.4}, Row{10, 1.0, 1.0, 1.0}};
constexpr std::array inclination_table{Row{-5, 1.0, 0.75, 1.07}, Row{0, 1.0, 1.0, 1.0},
                                       Row{5, 1.0, 1.25, 0.85}, Row{15, 1.0, 1.7, 0.65}};
constexpr std::array nose_table{Row{0, 0.81, 0.48, 1},   Row{0.5, 0.87, 0.66, 1}, Row{1, 0.93, 0.82, 1},
                                Row{1.5, 0.96, 0.92, 1}, Row{2, 1.00, 1.00, 1},   Row{2.5, 1.02, 1.07, 1},
                                Row{3, 1.04, 1.14, 1}};
// Table 3, finite elements, N.
constexpr std::array fem_table{Row{0, 6720, 2260, 1380},  Row{0.5, 4690, 1820, 1260},
                               Row{1, 11100, 4630, 1850}, Row{1.5, 7940, 3190, 1670},
                               Row{2, 8350, 3210, 1560},  Row{2.5, 7760, 3180, 1300},
                               Row{3, 8000, 3260, 1370}};
// Table 5, N; `at` is the rake face.
constexpr std::array rake_shape_table{Row{0, 8620, 3600, 2480}, Row{1, 6160, 2540, 1520},
                                      Row{2, 2630, 1260, 711}};

Row interpolate(std::span<const Row> table, double at) {
  if (at <= table.front().at) return table.front();
  for (std::size_t k = 1; k < table.size(); ++k) {
    if (at > table[k].at) continue;
    const Row& a = table[k - 1];
    const Row& b = table[k];
    const double f = (at - a.at) / (b.at - a.at);
    return {at, a.z + f * (b.z - a.z), a.y + f * (b.y - a.y), a.x + f * (b.x - a.x)};
  }
  return table.back();
}

TurningForce with_resultant(double pz, double py, double px) {
  return {pz, py, px, std::hypot(pz, py, px)};
}

// C, exponents of depth, feed and speed: handbook, carbide on structural steel of 750 MPa.
struct PowerLaw {
  double c, depth, feed, speed;
};
constexpr PowerLaw law_z{300, 1.0, 0.75, -0.15};
constexpr PowerLaw law_y{243, 0.9, 0.6, -0.3};
constexpr PowerLaw law_x{339, 1.0, 0.5, -0.4};

double power_law_n(const PowerLaw& law, const TurningInputs& in) {
  return 10 * law.c * std::pow(in.depth_mm, law.depth) * std::pow(in.feed_mm_rev, law.feed) *
         std::pow(in.speed_m_min, law.speed);
}

// Depths and heights are decimal fractions: equality must survive their rounding.
bool splitter_works(double depth_mm, double height_mm) {
  return depth_mm <= height_mm / 1.2 * (1 + 1e-12);
}

}  // namespace

TurningForce handbook_turning_force(const TurningInputs& in) {
  return guarded<&handbook_turning_force>(in, [&] {
    const Row phi = interpolate(lead_angle_table, in.lead_angle_deg);
    const Row gamma = interpolate(rake_table, in.rake_angle_deg);
    const Row lambda = interpolate(inclination_table, in.inclination_deg);
    const Row nose = interpolate(nose_table, in.nose_radius_mm);
    const double k_m = in.material_factor;
    return with_resultant(power_law_n(law_z, in) * k_m * phi.z * gamma.z * lambda.z * nose.z,
                          power_law_n(law_y, in) * k_m * phi.y * gamma.y * lambda.y * nose.y,
                          power_law_n(law_x, in) * k_m * phi.x * gamma.x * lambda.x * nose.x);
  });
}

NoseRadiusFactors nose_radius_force_factor(const NoseRadius& in) {
  return guarded<&nose_radius_force_factor>(in, [&] {
    const Row k = interpolate(nose_table, in.nose_radius_mm);
    return NoseRadiusFactors{k.z, k.y, k.x};
  });
}

Resultant resultant_force(const ForceComponents& in) {
  return guarded<&resultant_force>(in, [&] { return Resultant{std::hypot(in.pz_n, in.py_n, in.px_n)}; });
}

TurningForce fem_turning_force(const NoseRadius& in) {
  return guarded<&fem_turning_force>(in, [&] {
    const Row p = interpolate(fem_table, in.nose_radius_mm);
    return with_resultant(p.z, p.y, p.x);
  });
}

RakeShapeForce rake_shape_force(const RakeShapeInputs& in) {
  return guarded<&rake_shape_force>(in, [&] {
    const Row& row = rake_shape_table[static_cast<std::size_t>(in.rake_shape)];
    const Row& flat = rake_shape_table.front();
    const TurningForce force = with_resultant(row.z, row.y, row.x);
    return RakeShapeForce{force, row.z / flat.z, row.y / flat.y, row.x / flat.x,
                          force.p_n / with_resultant(flat.z, flat.y, flat.x).p_n};
  });
}

Discrepancy force_model_discrepancy(const DiscrepancyInputs& in) {
  return guarded<&force_model_discrepancy>(in, [&] {
    const double difference_n = in.fem_n - in.handbook_n;
    return Discrepancy{difference_n, difference_n / in.fem_n};
  });
}

SplitterLimit chip_splitter_depth_limit(const SplitterInputs& in) {
  return guarded<&chip_splitter_depth_limit>(in, [&] { return SplitterLimit{in.splitter_height_mm / 1.2}; });
}

SplitterForce chip_splitter_force_factor(const SplitterForceInputs& in) {
  return guarded<&chip_splitter_force_factor>(in, [&] {
    const bool effective = splitter_works(in.depth_mm, in.splitter_height_mm);
    return SplitterForce{effective, effective ? 1 - in.reduction : 1};
  });
}

TurningPower turning_power(const TurningPowerInputs& in) {
  return guarded<&turning_power>(in, [&] { return TurningPower{in.pz_n * in.speed_m_min / 60000}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K102",
       .title = "Influence of a changed rake-face shape of the cutting wedge on its service properties",
       .authors = "Pasichnyk V. A., Chystiakova K. Ye., Batiuk A. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Rough turning of an alloy-steel shaft with carbide inserts: uncut chip section and active "
                 "edge for a nose radius, force components by the handbook power law and by finite elements, "
                 "the relative worth of three rake faces, and the depth rule of chip splitters.",
       .role = "cutting",
       .errata = {"Table 4, r = 3.0: the printed edge length 3.391 mm leaves out the straight part and the "
                  "printed area 0.784 mm2 is the arc part with two digits exchanged; 5.124 mm and 1.498 mm2.",
                  "Table 3, r = 0.5: the printed FEM resultant 4809 N repeats a handbook value; the "
                  "components give 5186 N.",
                  "The smallest discrepancy of the two models is 12.4 % at r = 0.5, not 40.6 % at r = 0."}});

  const auto forces = [](auto& f) {
    f.output(&TurningForce::pz_n, "pz_n", "P_z", "N", non_negative(), "main force")
        .output(&TurningForce::py_n, "py_n", "P_y", "N", non_negative(), "radial force")
        .output(&TurningForce::px_n, "px_n", "P_x", "N", non_negative(), "feed force")
        .output(&TurningForce::p_n, "p_n", "P", "N", non_negative(), "resultant force");
  };
  source
      .function<&uncut_chip_section>("uncut_chip_section",
                                     "Uncut chip section, active edge length and residual height.",
                                     "eq. (1), recovered from Table 4", Provenance::reconstructed)
      .input(&ChipSectionInputs::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut", 3.0)
      .input(&ChipSectionInputs::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.5)
      .input(&ChipSectionInputs::lead_angle_deg, "lead_angle_deg", "phi", "deg", closed(10, 90),
             "approach angle of the main edge to the feed direction", 60.0)
      .input(&ChipSectionInputs::end_angle_deg, "end_angle_deg", "phi_1", "deg", closed(1, 90),
             "approach angle of the minor edge", 60.0)
      .input(&ChipSectionInputs::nose_radius_mm, "nose_radius_mm", "r", "mm", non_negative(), "nose radius",
             1.0)
      .output(&ChipSection::chip_area_mm2, "chip_area_mm2", "A", "mm2", non_negative(), "chip section")
      .output(&ChipSection::edge_length_mm, "edge_length_mm", "L", "mm", non_negative(), "active edge length")
      .output(&ChipSection::mean_chip_thickness_mm, "mean_chip_thickness_mm", "a_mean", "mm", non_negative(),
              "mean chip thickness, area over edge length")
      .output(&ChipSection::residual_height_mm, "residual_height_mm", "y*", "mm", non_negative(),
              "residual height: theoretical roughness");
  source
      .function<&handbook_turning_force>("handbook_turning_force",
                                         "Force components by the handbook power law.",
                                         "eq. (2), Kosilova-Meshcheryakov", Provenance::completion)
      .input(&TurningInputs::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut", 3.0)
      .input(&TurningInputs::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.5)
      .input(&TurningInputs::speed_m_min, "speed_m_min", "V", "m/min", positive(), "cutting speed", 100.0)
      .input(&TurningInputs::nose_radius_mm, "nose_radius_mm", "r", "mm", non_negative(), "nose radius", 1.0)
      .optional(&TurningInputs::lead_angle_deg, "lead_angle_deg", "phi", "deg", any(), "approach angle")
      .optional(&TurningInputs::rake_angle_deg, "rake_angle_deg", "gamma", "deg", any(), "rake angle")
      .optional(&TurningInputs::inclination_deg, "inclination_deg", "lambda", "deg", any(),
                "inclination, positive when the nose is the lowest point of the edge")
      .optional(&TurningInputs::material_factor, "material_factor", "K_m", "1", positive(),
                "material factor, the same for all components")
      .with(forces)
      .note(
          "Carbide on structural steel, external longitudinal turning. Reproduces the 28 handbook values "
          "of Table 3 to 1 N.")
      .note(
          "The handbook tabulates the nose-radius factor for high-speed steel only; a radius of 2 mm "
          "switches it off.")
      .note("Angles and radii beyond the ends of the correction tables take the end values.");
  source
      .function<&nose_radius_force_factor>("nose_radius_force_factor",
                                           "Correction of the force components for the nose radius.",
                                           "table of eq. (2)", Provenance::completion)
      .input(&NoseRadius::nose_radius_mm, "nose_radius_mm", "r", "mm", non_negative(), "nose radius", 0.8)
      .output(&NoseRadiusFactors::k_pz, "k_pz", "K_r,z", "1", positive(), "factor on P_z")
      .output(&NoseRadiusFactors::k_py, "k_py", "K_r,y", "1", positive(), "factor on P_y")
      .output(&NoseRadiusFactors::k_px, "k_px", "K_r,x", "1", positive(), "factor on P_x")
      .note("At 0, 1.5 and 2.5 mm the values are the authors' own, read back from Table 3.");
  source
      .function<&resultant_force>("resultant_force", "Resultant of the three force components.", "eq. (2)",
                                  Provenance::paper)
      .input(&ForceComponents::pz_n, "pz_n", "P_z", "N", any(), "main force", 8620.0)
      .input(&ForceComponents::py_n, "py_n", "P_y", "N", any(), "radial force", 3600.0)
      .input(&ForceComponents::px_n, "px_n", "P_x", "N", any(), "feed force", 2480.0)
      .output(&Resultant::p_n, "p_n", "P", "N", non_negative(), "resultant force");
  source
      .function<&fem_turning_force>("fem_turning_force",
                                    "Force components that the finite-element runs gave.", "Table 3",
                                    Provenance::paper)
      .input(&NoseRadius::nose_radius_mm, "nose_radius_mm", "r", "mm", non_negative(),
             "nose radius; above 3 mm the last row holds", 1.0)
      .with(forces)
      .note(
          "Single runs at V = 100 m/min, S = 0.5 mm/rev, t = 3 mm, without mesh study or experiment: do "
          "not predict forces with them.");
  source
      .function<&rake_shape_force>("rake_shape_force", "Finite-element forces of three rake faces.",
                                   "Table 5", Provenance::paper)
      .input(&RakeShapeInputs::rake_shape, "rake_shape", "-", "-", no_range(), "shape of the rake face",
             "peripheral_groove")
      .with(forces)
      .output(&RakeShapeForce::factor_pz, "factor_pz", "-", "1", positive(), "P_z over that of the flat rake")
      .output(&RakeShapeForce::factor_py, "factor_py", "-", "1", positive(), "P_y over that of the flat rake")
      .output(&RakeShapeForce::factor_px, "factor_px", "-", "1", positive(), "P_x over that of the flat rake")
      .output(&RakeShapeForce::factor_p, "factor_p", "-", "1", positive(), "P over that of the flat rake")
      .note("Usable as relative factors only; take the 69 % of the bevelled land as an upper bound.");
  source
      .function<&force_model_discrepancy>("force_model_discrepancy",
                                          "How far finite elements and handbook are apart.", "eq. (4)",
                                          Provenance::paper)
      .input(&DiscrepancyInputs::fem_n, "fem_n", "P_FEM", "N", positive(), "force by finite elements",
             12168.0)
      .input(&DiscrepancyInputs::handbook_n, "handbook_n", "P_h", "N", any(), "force by the handbook", 4809.0)
      .output(&Discrepancy::difference_n, "difference_n", "dP", "N", any(), "FEM minus handbook")
      .output(&Discrepancy::relative_to_fem, "relative_to_fem", "dP/P_FEM", "1", any(),
              "difference as a fraction of the FEM value");
  source
      .function<&chip_splitter_depth_limit>("chip_splitter_depth_limit",
                                            "Largest depth of cut at which a chip splitter works.", "eq. (3)",
                                            Provenance::paper)
      .input(&SplitterInputs::splitter_height_mm, "splitter_height_mm", "l", "mm", positive(),
             "height of the splitter", 0.5)
      .output(&SplitterLimit::max_depth_mm, "max_depth_mm", "t", "mm", non_negative(), "largest depth");
  source
      .function<&chip_splitter_force_factor>("chip_splitter_force_factor",
                                             "Factor of a chip splitter on the main force.",
                                             "eq. (3), step completed", Provenance::completion)
      .input(&SplitterForceInputs::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut", 0.4)
      .input(&SplitterForceInputs::splitter_height_mm, "splitter_height_mm", "l", "mm", positive(),
             "height of the splitter", 0.5)
      .optional(&SplitterForceInputs::reduction, "reduction", "-", "1", closed(0.20, 0.25),
                "reduction of the main force where the splitter works")
      .output(&SplitterForce::effective, "effective", "-", "-", no_range(), "the splitter works")
      .output(&SplitterForce::force_factor, "force_factor", "-", "1", closed(0.75, 1), "factor on P_z")
      .note(
          "The paper's own 20 % was simulated at a depth of 1 mm, where its rule says the splitter of "
          "0.5 mm has no effect.");
  source
      .function<&turning_power>("turning_power", "Cutting power in turning.", "completion",
                                Provenance::completion)
      .input(&TurningPowerInputs::pz_n, "pz_n", "P_z", "N", non_negative(), "main force", 4077.0)
      .input(&TurningPowerInputs::speed_m_min, "speed_m_min", "V", "m/min", positive(), "cutting speed",
             100.0)
      .output(&TurningPower::power_kw, "power_kw", "N", "kW", non_negative(), "cutting power");
}

}  // namespace verstat::models::k102
