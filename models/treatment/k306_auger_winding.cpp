#include "models/treatment/k306_auger_winding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace verstat::models::k306 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double stretch_correction = 0.021;  // eq. (1), from the paper's experiments

double mandrel_mm(const ScrewFlight& in) {
  const double outer = in.outer_diameter_mm;
  const double inner = in.inner_diameter_mm;
  require(outer > inner, "D", outer, "must be above d");
  const double correction = stretch_correction * in.pitch_mm / inner;
  require(correction < 1, "T", in.pitch_mm, "must be below d/0.021");
  // Ratio of the edge lengths less 1, without the cancellation of the root and 1 for narrow flights.
  const double q =
      pi * pi * (outer - inner) * (outer + inner) / (pi * pi * inner * inner + in.pitch_mm * in.pitch_mm);
  const double excess = q / (std::sqrt(1 + q) + 1);
  return 2 * in.strip_width_mm * (1 - correction) / excess;
}

// `force_input` and its value: what to blame when the neutral line would leave the strip.
double neutral_mm(double outer, double inner, double force_radius, std::string_view force_input,
                  double force_value) {
  const double middle = std::sqrt(outer * inner);
  const double arm = force_radius - middle;
  // R^2 + 2 sqrt(R r^3) - 3 R r as a product that vanishes exactly at R = r.
  const double x = std::sqrt(outer);
  const double y = std::sqrt(inner);
  const double third = x * (x - y) * (x - y) * (x + 2 * y) / 3;
  const double radius = middle - third / (std::sqrt(arm * arm + third) + arm);
  require(radius >= inner * (1 - 1e-12), force_input, force_value,
          fmt::format("puts the neutral radius {} mm inside the inner edge of the coil, {} mm: the strip is "
                      "too wide for its radius",
                      radius, inner));
  return std::max(radius, inner);
}

void check_neutral(double inner, double neutral, double outer) {
  require(inner <= neutral, "rho0", neutral, "must not be below r");
  require(neutral <= outer, "rho0", neutral, "must not be above R");
}

StripLength strip_mm(const ScrewStrip& in) {
  const double neutral_diameter = 2 * in.neutral_radius_mm - in.mandrel_diameter_mm + in.inner_diameter_mm;
  require(neutral_diameter > 0, "d0", in.mandrel_diameter_mm, "must be below 2 rho0 + d");
  const double net = in.screw_length_mm / in.pitch_mm * std::hypot(pi * neutral_diameter, in.pitch_mm) *
                     in.developed_length_factor;
  return {net, net + in.trim * in.strip_width_mm};
}

double stack_mm(const CoilStack& in) {
  return in.strip_length_mm * in.thickness_mm * (in.radius_ratio - 1) /
         (2 * pi * in.strip_width_mm * std::sqrt(std::sqrt(in.radius_ratio)));
}

}  // namespace

Mandrel mandrel_diameter(const ScrewFlight& in) {
  return guarded<&mandrel_diameter>(in, [&] { return Mandrel{mandrel_mm(in)}; });
}

MandrelStep mandrel_step_range(const ScrewDiameter& in) {
  return guarded<&mandrel_step_range>(in, [&] {
    return MandrelStep{0.8 * in.outer_diameter_mm, 1.2 * in.outer_diameter_mm};
  });
}

Groove groove_dimensions(const Blank& in) {
  return guarded<&groove_dimensions>(in, [&] {
    const double h = in.thickness_mm;
    return Groove{h + 0.1, h + 0.2, 10 * h, 12 * h};
  });
}

NeutralRadius neutral_radius(const Coil& in) {
  return guarded<&neutral_radius>(in, [&] {
    require(in.outer_radius_mm >= in.inner_radius_mm, "R", in.outer_radius_mm, "must not be below r");
    require(in.force_radius_mm > in.outer_radius_mm, "rho_np", in.force_radius_mm, "must be above R");
    return NeutralRadius{
        neutral_mm(in.outer_radius_mm, in.inner_radius_mm, in.force_radius_mm, "rho_np", in.force_radius_mm)};
  });
}

Force spring_clamp_force(const SpringClamp& in) {
  return guarded<&spring_clamp_force>(in, [&] {
    const double wrap = 2 * pi * in.turns + in.k_device_f * in.deformation_radius_mm / in.mandrel_radius_mm;
    return Force{in.k1 * in.k_device_r * in.friction * wrap * in.force_n};
  });
}

Spacing recess_spacing(const Recess& in) {
  return guarded<&recess_spacing>(
      in, [&] { return Spacing{in.coils * pi * in.wire_radius_mm + in.device_constant_mm}; });
}

BlankThickness blank_thickness(const RequiredEdge& in) {
  return guarded<&blank_thickness>(in, [&] {
    check_neutral(in.inner_radius_mm, in.neutral_radius_mm, in.outer_radius_mm);
    const double edge_radius = in.edge == Edge::inner ? in.inner_radius_mm : in.outer_radius_mm;
    return BlankThickness{in.edge_thickness_mm * std::sqrt(edge_radius / in.neutral_radius_mm)};
  });
}

StripLength strip_length(const ScrewStrip& in) {
  return guarded<&strip_length>(in, [&] { return strip_mm(in); });
}

StackLength coil_stack_length(const CoilStack& in) {
  return guarded<&coil_stack_length>(in, [&] { return StackLength{stack_mm(in)}; });
}

Force release_force(const Release& in) {
  return guarded<&release_force>(in, [&] {
    // 8 pi: the friction of four turns.
    return Force{in.redistribution * in.friction * (8 * pi * in.k_force * in.force_n + in.radial_force_n)};
  });
}

Force longitudinal_force(const EdgeBending& in) {
  return guarded<&longitudinal_force>(in, [&] {
    check_neutral(in.inner_radius_mm, in.neutral_radius_mm, in.outer_radius_mm);
    const double middle = std::sqrt(in.outer_radius_mm * in.inner_radius_mm);
    return Force{2 * in.flow_stress_mpa * in.thickness_mm * in.neutral_radius_mm *
                 std::log(middle / in.neutral_radius_mm)};
  });
}

WindingTime winding_time(const Winding& in) {
  return guarded<&winding_time>(in, [&] {
    const double turns = in.strip_length_mm / (2 * pi * in.neutral_radius_mm);
    // 1e-9 keeps a number of windings that is whole by design from being rounded up.
    const double windings =
        std::max(1.0, std::ceil(turns / static_cast<double>(in.turns_per_winding) - 1e-9));
    require(windings < 1e15, "L_strip", in.strip_length_mm, "asks for more than 1e15 windings");
    return WindingTime{turns, static_cast<std::int64_t>(windings),
                       turns / in.spindle_rpm + windings * in.setup_min};
  });
}

AugerBlank auger_blank_plan(const AugerScrew& in) {
  return guarded<&auger_blank_plan>(in, [&] {
    require(in.outer_diameter_mm > in.inner_diameter_mm, "D", in.outer_diameter_mm, "must be above d");
    const double width = (in.outer_diameter_mm - in.inner_diameter_mm) / 2;
    const double mandrel = mandrel_mm({width, in.pitch_mm, in.outer_diameter_mm, in.inner_diameter_mm});
    // Radii of the tight coil, not of the stretched screw.
    const double inner = mandrel / 2;
    const double outer = inner + width;
    const double neutral =
        neutral_mm(outer, inner, in.force_radius_factor * outer, "rho_np_factor", in.force_radius_factor);
    const double thickness = in.inner_thickness_mm * std::sqrt(inner / neutral);
    const StripLength strip =
        strip_mm({in.length_mm, neutral, mandrel, in.inner_diameter_mm, in.pitch_mm, width, in.trim, 1});
    return AugerBlank{width,
                      mandrel,
                      neutral,
                      thickness,
                      strip.net_mm,
                      strip.trimmed_mm,
                      stack_mm({thickness, width, outer / inner, strip.net_mm})};
  });
}

namespace {

void describe_coil(Source& source) {
  source
      .function<&mandrel_diameter>("mandrel_diameter", "Diameter of the winding mandrel.", "eq. (1)",
                                   Provenance::repaired)
      .input(&ScrewFlight::strip_width_mm, "B", "B", "mm", positive(), "width of the strip", 50.0)
      .input(&ScrewFlight::pitch_mm, "T", "T", "mm", positive(), "pitch of the screw, below d/0.021", 100.0)
      .input(&ScrewFlight::outer_diameter_mm, "D", "D", "mm", positive(), "outer diameter of the screw",
             150.0)
      .input(&ScrewFlight::inner_diameter_mm, "d", "d", "mm", positive(), "inner diameter of the screw", 50.0)
      .output(&Mandrel::diameter_mm, "d0", "d_0", "mm", positive(), "diameter of the mandrel")
      .note("At small pitch the result falls below d by up to 0.15 %: harmless.");
  source
      .function<&mandrel_step_range>("mandrel_step_range", "Diameter of the step of the mandrel.", "eq. (2)",
                                     Provenance::paper)
      .input(&ScrewDiameter::outer_diameter_mm, "D", "D", "mm", positive(), "outer diameter of the screw",
             150.0)
      .output(&MandrelStep::min_mm, "d_min", "-", "mm", positive(), "least diameter")
      .output(&MandrelStep::max_mm, "d_max", "-", "mm", positive(), "largest diameter");
  source
      .function<&groove_dimensions>("groove_dimensions", "Slot that holds the end of the strip.", "item 3",
                                    Provenance::paper)
      .input(&Blank::thickness_mm, "H", "H", "mm", positive(), "thickness of the blank", 3.0)
      .output(&Groove::width_min_mm, "b_min", "b", "mm", positive(), "least width")
      .output(&Groove::width_max_mm, "b_max", "b", "mm", positive(), "largest width")
      .output(&Groove::length_min_mm, "l_min", "l", "mm", positive(), "least length")
      .output(&Groove::length_max_mm, "l_max", "l", "mm", positive(), "largest length");
  source
      .function<&neutral_radius>("neutral_radius", "Neutral radius of the edge bending.", "eq. (3)",
                                 Provenance::repaired)
      .input(&Coil::outer_radius_mm, "R", "R", "mm", positive(), "outer radius of the tight coil", 75.0)
      .input(&Coil::inner_radius_mm, "r", "r", "mm", positive(), "inner radius of the tight coil", 25.0)
      .input(&Coil::force_radius_mm, "rho_np", "rho_np", "mm", positive(),
             "radius at which the longitudinal force acts, above R", 112.5)
      .output(&NeutralRadius::radius_mm, "rho0", "rho_0", "mm", positive(), "neutral radius")
      .note("The radii are those of the coil on the mandrel, although the paper says of the screw.")
      .note("rho_np is a device constant without a value; it moves the strip length by up to 24 %.");
}

void describe_forces(Source& source) {
  source
      .function<&spring_clamp_force>("spring_clamp_force", "Force of the spring clamp.", "eq. (4)",
                                     Provenance::paper)
      .optional(&SpringClamp::k1, "k1", "k_1", "1", non_negative(), "coefficient, usually 0.5 to 0.7")
      .optional(&SpringClamp::k_device_r, "k_r", "k_r", "1", non_negative(), "device factor")
      .optional(&SpringClamp::k_device_f, "k_f", "k_f", "1", non_negative(), "device factor")
      .input(&SpringClamp::friction, "mu0", "mu_0", "1", positive(), "friction coefficient", 0.15)
      .input(&SpringClamp::turns, "n", "n", "1", positive(), "turns of the strip", 3.0)
      .input(&SpringClamp::deformation_radius_mm, "rho_cp", "rho_cp", "mm", positive(),
             "radius of deformation", 42.0)
      .input(&SpringClamp::mandrel_radius_mm, "r", "r", "mm", positive(), "radius of the mandrel", 30.0)
      .input(&SpringClamp::force_n, "N", "N", "N", non_negative(), "longitudinal force", 2000.0)
      .output(&Force::force_n, "F", "F_np", "N", non_negative(), "clamp force");
  source
      .function<&recess_spacing>("recess_spacing", "Spacing of the recesses for the spring.", "eq. (5)",
                                 Provenance::paper)
      .input(&Recess::coils, "n_coils", "n", "1", positive(), "coils of the spring", 6.0)
      .input(&Recess::wire_radius_mm, "r0", "r_0", "mm", positive(), "radius of the spring wire", 0.75)
      .input(&Recess::device_constant_mm, "c", "c", "mm", non_negative(), "device constant", 2.0)
      .output(&Spacing::spacing_mm, "l1", "l_1", "mm", positive(), "spacing");
}

void describe_blank(Source& source) {
  source
      .function<&blank_thickness>("blank_thickness", "Thickness of the strip from that of an edge.",
                                  "eq. (6)", Provenance::repaired)
      .input(&RequiredEdge::edge, "edge", "-", "-", no_range(), "edge of the flight", "inner")
      .input(&RequiredEdge::edge_thickness_mm, "H_edge", "H", "mm", positive(),
             "required thickness of the edge", 3.0)
      .input(&RequiredEdge::outer_radius_mm, "R", "R", "mm", positive(), "outer radius of the tight coil",
             80.0)
      .input(&RequiredEdge::inner_radius_mm, "r", "r", "mm", positive(), "inner radius of the tight coil",
             30.0)
      .input(&RequiredEdge::neutral_radius_mm, "rho0", "rho_0", "mm", positive(), "neutral radius, r to R",
             45.0)
      .output(&BlankThickness::thickness_mm, "H0", "H_0", "mm", positive(), "thickness of the strip");
  source
      .function<&strip_length>("strip_length", "Length of the strip of one screw.", "eqs. (7), (8)",
                               Provenance::repaired)
      .input(&ScrewStrip::screw_length_mm, "L", "L", "mm", positive(), "length of the screw", 1000.0)
      .input(&ScrewStrip::neutral_radius_mm, "rho0", "rho_0", "mm", positive(),
             "neutral radius on the mandrel", 45.0)
      .input(&ScrewStrip::mandrel_diameter_mm, "d0", "d_0", "mm", positive(), "diameter of the mandrel", 60.0)
      .input(&ScrewStrip::inner_diameter_mm, "d", "d", "mm", positive(), "inner diameter of the screw", 50.0)
      .input(&ScrewStrip::pitch_mm, "T", "T", "mm", positive(), "pitch of the screw", 100.0)
      .input(&ScrewStrip::strip_width_mm, "B", "B", "mm", positive(), "width of the strip", 50.0)
      .optional(&ScrewStrip::trim, "trim", "-", "1", non_negative(),
                "trimmed ends in strip widths, usually 3 to 5")
      .optional(&ScrewStrip::developed_length_factor, "developed_length_factor", "-", "1", at_least(1),
                "arc over chord of the corrugation")
      .output(&StripLength::net_mm, "L0", "L_0", "mm", positive(), "net length")
      .output(&StripLength::trimmed_mm, "L3", "L_3", "mm", positive(), "length with the trimmed ends")
      .note("The paper ignores the strip that the corrugation takes up; the factor for it is a completion.");
  source
      .function<&coil_stack_length>("coil_stack_length", "Axial length of the tight coil.", "eq. (9)",
                                    Provenance::repaired)
      .input(&CoilStack::thickness_mm, "H", "H", "mm", positive(), "thickness of the blank", 2.5)
      .input(&CoilStack::strip_width_mm, "B", "B", "mm", positive(), "width of the strip", 50.0)
      .input(&CoilStack::radius_ratio, "psi", "psi", "1", above(1), "R/r of the tight coil", 2.6)
      .input(&CoilStack::strip_length_mm, "L_strip", "L", "mm", positive(), "length of the strip", 3000.0)
      .output(&StackLength::length_mm, "l", "l", "mm", positive(), "length on the mandrel");
  source
      .function<&release_force>("release_force", "Force that releases the coil.", "eq. (10)",
                                Provenance::paper)
      .input(&Release::redistribution, "nu", "nu", "1", non_negative(), "redistribution of friction", 1.1)
      .input(&Release::friction, "mu0", "mu_0", "1", positive(), "friction coefficient", 0.15)
      .input(&Release::k_force, "k_N", "k_N", "1", non_negative(), "reduction of the longitudinal force", 0.6)
      .input(&Release::force_n, "N", "N", "N", non_negative(), "longitudinal force", 2000.0)
      .input(&Release::radial_force_n, "P_r", "P_r", "N", non_negative(), "radial clamp force", 800.0)
      .output(&Force::force_n, "Q", "Q", "N", non_negative(), "release force");
  source
      .function<&longitudinal_force>("longitudinal_force", "Longitudinal force of the edge bending.",
                                     "completion", Provenance::completion)
      .input(&EdgeBending::flow_stress_mpa, "sigma_s", "sigma_s", "MPa", positive(), "flow stress", 400.0)
      .input(&EdgeBending::thickness_mm, "H0", "H_0", "mm", positive(), "thickness of the strip", 2.5)
      .input(&EdgeBending::outer_radius_mm, "R", "R", "mm", positive(), "outer radius of the tight coil",
             75.0)
      .input(&EdgeBending::inner_radius_mm, "r", "r", "mm", positive(), "inner radius of the tight coil",
             25.0)
      .input(&EdgeBending::neutral_radius_mm, "rho0", "rho_0", "mm", positive(), "neutral radius, r to R",
             40.0)
      .output(&Force::force_n, "N", "N", "N", any(), "longitudinal force, tension positive")
      .note("Rigid-plastic strip with thickness inversely proportional to the radius.");
}

void describe_plan(Source& source) {
  source
      .function<&winding_time>("winding_time", "Turns, windings and time of one strip.", "completion",
                               Provenance::completion)
      .input(&Winding::strip_length_mm, "L_strip", "L", "mm", positive(), "length of the strip", 3000.0)
      .input(&Winding::neutral_radius_mm, "rho0", "rho_0", "mm", positive(), "neutral radius", 45.0)
      .input(&Winding::spindle_rpm, "n_spindle", "n", "rpm", positive(), "spindle speed", 12.0)
      .optional(&Winding::turns_per_winding, "turns_per_winding", "-", "1", at_least(1),
                "turns the mandrel holds, usually 10 to 15")
      .input(&Winding::setup_min, "t_setup", "-", "min", non_negative(), "set-up time of one winding", 4.0)
      .output(&WindingTime::turns, "turns", "-", "1", non_negative(), "turns of the coil")
      .output(&WindingTime::windings, "windings", "-", "1", at_least(1), "loads of the mandrel")
      .output(&WindingTime::time_min, "t", "t", "min", non_negative(), "time of winding");
  source
      .function<&auger_blank_plan>("auger_blank_plan", "Mandrel and blank of a screw.",
                                   "chain of eqs. (1), (3), (6)-(9)", Provenance::repaired)
      .input(&AugerScrew::outer_diameter_mm, "D", "D", "mm", positive(), "outer diameter of the screw", 150.0)
      .input(&AugerScrew::inner_diameter_mm, "d", "d", "mm", positive(), "inner diameter of the screw", 50.0)
      .input(&AugerScrew::pitch_mm, "T", "T", "mm", positive(), "pitch of the screw", 100.0)
      .input(&AugerScrew::length_mm, "L", "L", "mm", positive(), "length of the screw", 1000.0)
      .input(&AugerScrew::inner_thickness_mm, "H_inner", "H", "mm", positive(), "thickness of the inner edge",
             3.0)
      .input(&AugerScrew::force_radius_factor, "rho_np_factor", "rho_np/R", "1", above(1),
             "radius of the longitudinal force over R", 1.5)
      .optional(&AugerScrew::trim, "trim", "-", "1", non_negative(),
                "trimmed ends in strip widths, usually 3 to 5")
      .output(&AugerBlank::strip_width_mm, "B", "B", "mm", positive(), "width of the strip")
      .output(&AugerBlank::mandrel_diameter_mm, "d0", "d_0", "mm", positive(), "diameter of the mandrel")
      .output(&AugerBlank::neutral_radius_mm, "rho0", "rho_0", "mm", positive(), "neutral radius")
      .output(&AugerBlank::thickness_mm, "H0", "H_0", "mm", positive(), "thickness of the strip")
      .output(&AugerBlank::net_mm, "L0", "L_0", "mm", positive(),
              "net length of the strip, without corrugation")
      .output(&AugerBlank::trimmed_mm, "L3", "L_3", "mm", positive(), "length with the trimmed ends")
      .output(&AugerBlank::stack_mm, "l", "l", "mm", positive(), "length of the tight coil")
      .note(
          "Eq. (1) keeps the ratio of the edge lengths, not the lengths: the coil has fewer turns than the "
          "screw. Take the strip from L0 and the turns from winding_time.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K306",
       .title = "Theoretical preconditions for designing the spiral corrugated working bodies of mixers",
       .authors = "Hevko B. M., Diachun A. Ye., Babaryka S. F., Liashuk O. L., Liubachivskyi R. O.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A strip bent on edge is wound turn against turn on a mandrel in a lathe, corrugated by cams and "
           "stretched to the pitch of a screw. The chain of design: mandrel, neutral radius, thickness and "
           "length of the blank, clamp and release forces, length of the coil, time of winding.",
       .role = "treatment",
       .errata = {
           "Eq. (1) is printed with the -1 under the root, which for small pitch does not give d0 = d.",
           "Eq. (3) has mm^2 + mm - mm^2 under the root; 2 sqrt(R r^3) has the unit, vanishes at R = r and "
           "agrees with the moment balance.",
           "Eq. (6) is printed with r for both edges, so that they would be equal; the outer one takes R.",
           "Eq. (7) has T^2/T under the root; the length is L/T turns of a helix.",
           "Eq. (9) prints B^4 sqrt(psi) for B psi^(1/4) and does not define psi = R/r.",
           "The carriage feed is printed S_n > m; the sentence says it equals the corrugation height."}});
  describe_coil(source);
  describe_forces(source);
  describe_blank(source);
  describe_plan(source);
}

}  // namespace verstat::models::k306
