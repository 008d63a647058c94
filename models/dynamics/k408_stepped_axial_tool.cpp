#include "models/dynamics/k408_stepped_axial_tool.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "models/dynamics/stepped_beam.h"

namespace verstat::models::k408 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_waves = 1e4;  // k L: far above any use, keeps the work bounded

std::vector<double> filled(const std::vector<double>& given, std::size_t size, double value,
                           std::string_view name) {
  if (given.empty()) return std::vector<double>(size, value);
  require(given.size() == size, name, static_cast<std::int64_t>(given.size()),
          fmt::format("entries: must have as many as length_mm ({})", size));
  return given;
}

dynamics::SteppedBeam beam_of(const AxialTool& in) {
  const std::size_t n = in.length_mm.size();
  require(in.outer_mm.size() == n, "outer_mm", static_cast<std::int64_t>(in.outer_mm.size()),
          fmt::format("entries: must have as many as length_mm ({})", n));
  const auto inner = filled(in.inner_mm, n, 0, "inner_mm");
  const auto j_factor = filled(in.j_factor, n, 1, "j_factor");
  const auto a_factor = filled(in.a_factor, n, 1, "a_factor");
  std::vector<dynamics::BeamSegment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    require(inner[i] < in.outer_mm[i], "inner_mm", inner[i], "must be below outer_mm of its segment");
    const double outer_2 = in.outer_mm[i] * in.outer_mm[i];
    const double inner_2 = inner[i] * inner[i];
    const double inertia_mm4 = pi / 64 * (outer_2 - inner_2) * (outer_2 + inner_2) * j_factor[i];
    const double area_mm2 = pi / 4 * (outer_2 - inner_2) * a_factor[i];
    // GPa mm4 = 1e-3 N m2; mm2 kg/m3 = 1e-6 kg/m
    segments.push_back(
        {in.length_mm[i] * 1e-3, in.modulus_gpa * inertia_mm4 * 1e-3, in.density_kg_m3 * area_mm2 * 1e-6});
  }
  using End = dynamics::BeamEnd;
  const End holder = in.scheme <= 2 ? End::clamped : in.scheme <= 4 ? End::pinned : End::sliding;
  return {std::move(segments), holder, in.scheme % 2 == 1 ? End::pinned : End::clamped};
}

}  // namespace

KrylovValues krylov_abcd(const KrylovArgument& in) {
  return guarded<&krylov_abcd>(in, [&] {
    const dynamics::Krylov k = dynamics::krylov(in.x);
    return KrylovValues{k.a, k.b, k.c, k.d};
  });
}

NaturalFrequencies axial_tool_frequencies(const ToolSpectrum& in) {
  return guarded<&axial_tool_frequencies>(in, [&] {
    NaturalFrequencies out;
    out.omega_rad_s = beam_of(in).frequencies(static_cast<int>(in.count));
    for (double omega : out.omega_rad_s) out.frequency_hz.push_back(omega / (2 * pi));
    return out;
  });
}

NodeShape axial_tool_mode(const ToolMode& in) {
  return guarded<&axial_tool_mode>(in, [&] {
    const auto beam = beam_of(in);
    bool any_moves = false;
    for (std::size_t node = 0; node <= in.length_mm.size(); ++node)
      any_moves = any_moves || !beam.fixed(node);
    require(any_moves, "length_mm", static_cast<std::int64_t>(in.length_mm.size()),
            "segment: none of its ends moves under this scheme; split it");
    const double omega = beam.frequencies(static_cast<int>(in.mode)).back();
    const auto shape = beam.mode(omega);
    double largest = 0;
    for (double y : shape.nodes) largest = std::max(largest, std::abs(y));
    require(largest >= 1e-6 * shape.largest, "mode", in.mode,
            "has its nodal points at all segment ends; split a segment");
    double scale = 0;
    for (double y : shape.nodes)
      if (scale == 0 && std::abs(y) >= largest * (1 - 1e-9)) scale = y;
    NodeShape out;
    for (double y : shape.nodes) out.displacement.push_back(y == 0 ? 0 : y / scale);
    return out;
  });
}

Receptance axial_tool_receptance(const ForcedTool& in) {
  return guarded<&axial_tool_receptance>(in, [&] {
    const auto beam = beam_of(in);
    const auto nodes = static_cast<std::int64_t>(in.length_mm.size());
    require(in.node_force <= nodes, "node_force", in.node_force, "must not be above the number of segments");
    require(in.node_response <= nodes, "node_response", in.node_response,
            "must not be above the number of segments");
    const double omega = 2 * pi * in.frequency_hz;
    require(beam.wave_length_sum(omega) <= most_waves, "freq_hz", in.frequency_hz,
            "is too high for a beam: more than a thousand waves along the tool");
    const std::complex<double> y =
        1e6 * beam.receptance(omega, in.loss_factor, static_cast<std::size_t>(in.node_force),
                              static_cast<std::size_t>(in.node_response));
    return Receptance{y.real(), y.imag(), std::abs(y)};
  });
}

ReamingSpeed reaming_speed_limit(const ToothFrequency& in) {
  return guarded<&reaming_speed_limit>(in, [&] {
    const double rpm = 60 * (1 - in.margin) * in.frequency_hz / static_cast<double>(in.teeth);
    return ReamingSpeed{rpm, pi * in.diameter_mm * rpm / 1000};
  });
}

ReamingTime reaming_main_time(const ReamedHole& in) {
  return guarded<&reaming_main_time>(in, [&] {
    const double rpm = 1000 * in.speed_m_min / (pi * in.diameter_mm);
    return ReamingTime{rpm, (in.length_mm + in.approach_mm + in.overrun_mm) / (rpm * in.feed_mm_rev)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K408",
       .title = "Dynamic models of axial tools for finishing of holes",
       .authors = "Sergeechev Z. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A reamer as a stepped elastic rod with distributed mass between a rigid, rocking or floating "
           "holder "
           "and the hole (short lands or full guidance): six support schemes, natural frequencies by Krylov "
           "functions, modes, forced response and the speed they allow.",
       .role = "dynamics",
       .errata = {
           "k is printed with a square root; the fourth root is meant.",
           "Eq. (4): printed k^3 EJ Theta C; k^2 by dimension and by differentiation of (3).",
           "The text assigns the tip conditions of cutting and entry the other way round than its schemes, "
           "equations and results; the equations are followed.",
           "Dimensions of the computed reamer are not printed; published frequencies are met within 12 % by "
           "a "
           "stand-in geometry."}});

  const auto tool = [](auto& f) {
    f.input(&AxialTool::scheme, "scheme", "-", "-", closed(1, 6),
            "support scheme: holder rigid 1-2, rocking 3-4, floating 5-6; tip pinned (odd) or clamped (even)",
            1)
        .input(&AxialTool::length_mm, "length_mm", "l", "mm", positive(), "segment lengths, holder end first",
               Value::List{28.0, 152.0, 78.0, 75.0})
        .length(1, 200)
        .input(&AxialTool::outer_mm, "outer_mm", "D", "mm", positive(), "outer diameters of the segments",
               Value::List{22.3, 18.9, 21.1, 22.1})
        .length(1, 200)
        .optional(&AxialTool::inner_mm, "inner_mm", "d", "mm", non_negative(),
                  "bores of the segments, empty: none")
        .length(0, 200)
        .optional(&AxialTool::j_factor, "j_factor", "-", "1", positive(),
                  "inertia of the fluted section over the full one, empty: 1")
        .length(0, 200)
        .optional(&AxialTool::a_factor, "a_factor", "-", "1", positive(),
                  "area of the fluted section over the full one, empty: 1")
        .length(0, 200)
        .optional(&AxialTool::modulus_gpa, "e_gpa", "E", "GPa", positive(), "modulus of elasticity")
        .optional(&AxialTool::density_kg_m3, "rho_kg_m3", "rho", "kg/m3", positive(), "density");
  };
  const char* const slender =
      "Shear and rotary inertia are neglected: good for L/D >= 10 and the first two modes (3.7 % of solid "
      "elements).";

  source.function<&krylov_abcd>("krylov_abcd", "Krylov functions.", "referenced", Provenance::completion)
      .input(&KrylovArgument::x, "x", "k l", "1", non_negative(), "argument", 1.875)
      .output(&KrylovValues::a, "A", "A", "1", any(), "(cosh x + cos x)/2")
      .output(&KrylovValues::b, "B", "B", "1", non_negative(), "(sinh x + sin x)/2")
      .output(&KrylovValues::c, "C", "C", "1", non_negative(), "(cosh x - cos x)/2")
      .output(&KrylovValues::d, "D", "D", "1", non_negative(), "(sinh x - sin x)/2");
  source
      .function<&axial_tool_frequencies>("axial_tool_frequencies",
                                         "Lowest natural frequencies of a stepped tool.",
                                         "frequency equations", Provenance::repaired)
      .with(tool)
      .optional(&ToolSpectrum::count, "count", "-", "1", closed(1, 6), "number of frequencies")
      .output(&NaturalFrequencies::omega_rad_s, "omega_rad_s", "omega", "rad/s", positive(),
              "angular frequencies")
      .output(&NaturalFrequencies::frequency_hz, "freq_hz", "f", "Hz", positive(), "frequencies")
      .note(slender);
  source
      .function<&axial_tool_mode>("axial_tool_mode", "Shape of a mode at the segment ends.",
                                  "initial parameters", Provenance::repaired)
      .with(tool)
      .input(&ToolMode::mode, "mode", "-", "1", closed(1, 6), "number of the mode", 1)
      .output(&NodeShape::displacement, "y_nodes", "y", "1", closed(-1, 1),
              "displacements from the holder end to the tip, the largest +1")
      .note(slender);
  source
      .function<&axial_tool_receptance>("axial_tool_receptance",
                                        "Response of a node to a harmonic force at a node.", "completion",
                                        Provenance::completion)
      .with(tool)
      .input(&ForcedTool::node_force, "node_force", "-", "1", at_least(0),
             "node of the force, 0 = holder end", 2)
      .input(&ForcedTool::node_response, "node_response", "-", "1", at_least(0), "node of the response", 2)
      .input(&ForcedTool::frequency_hz, "freq_hz", "f", "Hz", positive(), "frequency of the force", 100.0)
      .optional(&ForcedTool::loss_factor, "loss_factor", "eta", "1", closed(0, 0.2), "hysteretic loss factor")
      .output(&Receptance::real_um_n, "re_um_n", "-", "um/N", any(), "in phase with the force")
      .output(&Receptance::imaginary_um_n, "im_um_n", "-", "um/N", any(), "in quadrature")
      .output(&Receptance::magnitude_um_n, "abs_um_n", "-", "um/N", non_negative(), "magnitude");
  source
      .function<&reaming_speed_limit>("reaming_speed_limit",
                                      "Speed that keeps the tooth frequency below resonance.", "completion",
                                      Provenance::completion)
      .input(&ToothFrequency::frequency_hz, "freq_hz", "f_1", "Hz", positive(), "first natural frequency",
             629.6)
      .input(&ToothFrequency::teeth, "teeth", "z", "1", at_least(1), "number of teeth", 8)
      .input(&ToothFrequency::diameter_mm, "D_mm", "D", "mm", positive(), "diameter of the hole", 20.0)
      .optional(&ToothFrequency::margin, "margin", "-", "1", open_high(0, 1), "distance to the resonance")
      .output(&ReamingSpeed::spindle_rpm, "n_max_rpm", "n", "rpm", positive(), "largest spindle speed")
      .output(&ReamingSpeed::speed_m_min, "v_max_m_min", "v", "m/min", positive(), "largest cutting speed")
      .note(
          "Resonance alone does not explain the 2-4 m/min of practice: one constraint beside tool life and "
          "quality.");
  source
      .function<&reaming_main_time>("reaming_main_time", "Main time of reaming.", "completion",
                                    Provenance::completion)
      .input(&ReamedHole::length_mm, "length_mm", "L", "mm", positive(), "length of the hole", 50.0)
      .input(&ReamedHole::approach_mm, "approach_mm", "-", "mm", non_negative(), "approach", 3.0)
      .input(&ReamedHole::overrun_mm, "overrun_mm", "-", "mm", non_negative(), "overrun", 15.0)
      .input(&ReamedHole::speed_m_min, "v_m_min", "v", "m/min", positive(), "cutting speed", 4.0)
      .input(&ReamedHole::diameter_mm, "D_mm", "D", "mm", positive(), "diameter of the hole", 20.0)
      .input(&ReamedHole::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(), "feed", 1.0)
      .output(&ReamingTime::spindle_rpm, "n_rpm", "n", "rpm", positive(), "spindle speed")
      .output(&ReamingTime::main_time_min, "t_main_min", "t_0", "min", positive(), "main time");
}

}  // namespace verstat::models::k408
