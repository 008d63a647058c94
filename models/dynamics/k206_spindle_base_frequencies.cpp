#include "models/dynamics/k206_spindle_base_frequencies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "models/dynamics/elastic_rod.h"

namespace verstat::models::k206 {
namespace {

constexpr double scan_low_hz = 1;
constexpr double scan_high_hz = 20000;
constexpr double n_m_per_n_um = 1e6;
// Relative error of a compliance is about 1e-16 exp(sum of lambda L): 1e-5 here.
constexpr double largest_phase = 25;

std::vector<RodSegment> rod_of(const std::vector<double>& length_mm, const std::vector<double>& outer_mm,
                               const std::vector<double>& inner_mm, const Steel& steel,
                               const std::string& prefix) {
  const auto same = [&](const std::vector<double>& list, const char* name) {
    if (list.size() != length_mm.size())
      throw DomainError(prefix + name, fmt::format("{}{} has {} entries, must have as many as {}length_mm, "
                                                   "that is {}",
                                                   prefix, name, list.size(), prefix, length_mm.size()));
  };
  same(outer_mm, "outer_mm");
  same(inner_mm, "inner_mm");
  std::vector<RodSegment> rod;
  for (std::size_t k = 0; k < length_mm.size(); ++k) {
    require(inner_mm[k] < outer_mm[k], fmt::format("{}inner_mm/{}", prefix, k), inner_mm[k],
            "must be below the outer diameter");
    rod.push_back(round_segment(length_mm[k], outer_mm[k], inner_mm[k], steel.e_gpa, steel.rho_kg_m3));
  }
  return rod;
}

std::size_t section_of(std::int64_t section, const std::string& input, std::size_t sections) {
  require(section >= 0 && static_cast<std::size_t>(section) <= sections, input, section,
          fmt::format("must be a section 0..{}", sections));
  return static_cast<std::size_t>(section);
}

std::vector<GroundSpring> springs_of(const std::vector<std::int64_t>& sections,
                                     const std::vector<double>& k_n_um, std::size_t last_section) {
  if (k_n_um.size() != sections.size())
    throw DomainError("support_k_n_um",
                      fmt::format("support_k_n_um has {} entries, must have as many as support_section, "
                                  "that is {}",
                                  k_n_um.size(), sections.size()));
  std::vector<GroundSpring> springs;
  for (std::size_t k = 0; k < sections.size(); ++k)
    springs.push_back({section_of(sections[k], fmt::format("support_section/{}", k), last_section),
                       k_n_um[k] * n_m_per_n_um});
  return springs;
}

struct Unit {
  std::vector<RodSegment> spindle;
  std::vector<RodSegment> sleeve;
  std::vector<RodSystem::Link> links;
};

Unit unit_of(const SpindleUnit& in) {
  Unit unit{rod_of(in.spindle_length_mm, in.spindle_outer_mm, in.spindle_inner_mm, in, "spindle_"),
            rod_of(in.sleeve_length_mm, in.sleeve_outer_mm, in.sleeve_inner_mm, in, "sleeve_"),
            {}};
  if (in.bearing_k_n_um.size() != in.bearing_section.size())
    throw DomainError("bearing_k_n_um",
                      fmt::format("bearing_k_n_um has {} entries, must have as many as bearing_section, "
                                  "that is {}",
                                  in.bearing_k_n_um.size(), in.bearing_section.size()));
  // A bearing joins the same section of both rods.
  const std::size_t last = std::min(unit.spindle.size(), unit.sleeve.size());
  for (std::size_t k = 0; k < in.bearing_section.size(); ++k) {
    const std::size_t section = section_of(in.bearing_section[k], fmt::format("bearing_section/{}", k), last);
    unit.links.push_back({section, section, in.bearing_k_n_um[k] * n_m_per_n_um});
  }
  return unit;
}

void require_accurate(const std::vector<RodSegment>& rod, double freq_hz) {
  const double phase = bending_phase(rod, 2 * std::numbers::pi * freq_hz);
  require(phase <= largest_phase, "freq_hz", freq_hz,
          fmt::format("is too high for transfer matrices: sum of lambda L is {:.4g}, must not exceed {}",
                      phase, largest_phase));
}

void require_off_resonance(bool finite, double freq_hz) {
  require(finite, "freq_hz", freq_hz, "must not be a natural frequency: the compliance has a pole there");
}

}  // namespace

KrylovValues krylov_functions(const KrylovArgument& in) {
  return guarded<&krylov_functions>(in, [&] {
    const Krylov<double> k = krylov(in.x);
    return KrylovValues{k.s, k.t, k.u, k.v};
  });
}

SegmentMatrix segment_transfer_matrix(const SegmentInputs& in) {
  return guarded<&segment_transfer_matrix>(in, [&] {
    require(in.inner_mm < in.outer_mm, "inner_mm", in.inner_mm, "must be below outer_mm");
    const RodSegment segment = round_segment(in.length_mm, in.outer_mm, in.inner_mm, in.e_gpa, in.rho_kg_m3);
    const double phase = bending_phase({segment}, 2 * std::numbers::pi * in.freq_hz);
    require(phase <= 700, "freq_hz", in.freq_hz, "is too high: lambda L must not exceed 700");
    const TransferMatrix<double> m = transfer_matrix<double>(segment, 2 * std::numbers::pi * in.freq_hz,
                                                             in.ref_length_mm * 1e-3, in.ref_ej_n_m2, 1.0);
    SegmentMatrix out;
    for (Eigen::Index r = 0; r < 4; ++r)
      for (Eigen::Index c = 0; c < 4; ++c) out.m.push_back(m(r, c));
    return out;
  });
}

Influence harmonic_influence(const InfluenceInputs& in) {
  return guarded<&harmonic_influence>(in, [&] {
    const auto rod = rod_of(in.length_mm, in.outer_mm, in.inner_mm, in, "");
    const auto springs = springs_of(in.support_section, in.support_k_n_um, rod.size());
    const std::size_t i = section_of(in.i, "i", rod.size());
    const std::size_t j = section_of(in.j, "j", rod.size());
    require_accurate(rod, in.freq_hz);
    const RodCompliance<double> compliance(rod, springs, 2 * std::numbers::pi * in.freq_hz, 1.0);
    const double alpha = compliance.under_force_at(j)[i] * 1e6;
    require_off_resonance(std::isfinite(alpha), in.freq_hz);
    return Influence{alpha};
  });
}

Frequencies rod_natural_frequencies(const RodFrequencyInputs& in) {
  return guarded<&rod_natural_frequencies>(in, [&] {
    auto rod = rod_of(in.length_mm, in.outer_mm, in.inner_mm, in, "");
    auto springs = springs_of(in.support_section, in.support_k_n_um, rod.size());
    const RodSystem system(std::move(rod), std::move(springs));
    return Frequencies{system.frequencies_hz(static_cast<int>(std::min<std::int64_t>(in.count, 100'000)),
                                             scan_low_hz, scan_high_hz)};
  });
}

Frequencies spindle_base_natural_frequencies(const UnitFrequencyInputs& in) {
  return guarded<&spindle_base_natural_frequencies>(in, [&] {
    Unit unit = unit_of(in);
    auto springs = springs_of(in.support_section, in.support_k_n_um, unit.sleeve.size());
    const RodSystem system(std::move(unit.spindle), std::move(unit.sleeve), std::move(unit.links),
                           std::move(springs));
    return Frequencies{system.frequencies_hz(static_cast<int>(std::min<std::int64_t>(in.count, 100'000)),
                                             scan_low_hz, scan_high_hz)};
  });
}

MountStiffness required_mount_stiffness(const MountTarget& in) {
  return guarded<&required_mount_stiffness>(in, [&] {
    require(in.k_lo_n_um <= in.k_hi_n_um, "k_lo_n_um", in.k_lo_n_um, "must not be above k_hi_n_um");
    const Unit unit = unit_of(in);
    // p_mode >= target exactly when fewer than `mode` frequencies lie between 0 and the target.
    const auto enough = [&](double k_n_um) {
      const RodSystem system(
          unit.spindle, unit.sleeve, unit.links,
          springs_of(in.support_section, std::vector<double>(in.support_section.size(), k_n_um),
                     unit.sleeve.size()));
      return system.count_below(in.target_hz) - system.rigid_motions() < in.mode;
    };
    if (enough(in.k_lo_n_um)) return MountStiffness{in.k_lo_n_um};
    require(enough(in.k_hi_n_um), "k_hi_n_um", in.k_hi_n_um,
            fmt::format("is too soft: frequency {} stays below {} Hz", in.mode, in.target_hz));
    double low = std::log(in.k_lo_n_um);
    double high = std::log(in.k_hi_n_um);
    while (high - low > 1e-13) {
      const double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) break;
      (enough(std::exp(middle)) ? high : low) = middle;
    }
    return MountStiffness{std::min(std::exp(high), in.k_hi_n_um)};
  });
}

NoseCompliance nose_compliance(const NoseInputs& in) {
  return guarded<&nose_compliance>(in, [&] {
    using Complex = std::complex<double>;
    const Unit unit = unit_of(in);
    const auto springs = springs_of(in.support_section, in.support_k_n_um, unit.sleeve.size());
    const std::size_t nose = section_of(in.section, "section", unit.spindle.size());
    require_accurate(unit.spindle, in.freq_hz);
    require_accurate(unit.sleeve, in.freq_hz);
    const double omega = 2 * std::numbers::pi * in.freq_hz;
    const Complex damped(1, in.loss_factor);
    const RodCompliance<Complex> spindle(unit.spindle, {}, omega, damped);
    const RodCompliance<Complex> sleeve(unit.sleeve, springs, omega, damped);
    // Forces in the bearings from equal displacements at the joints, eq. (3) with the nose force on the
    // right.
    const auto joints = static_cast<Eigen::Index>(unit.links.size());
    Eigen::MatrixXcd joint(joints, joints);
    Eigen::VectorXcd reach(joints);
    for (Eigen::Index c = 0; c < joints; ++c) {
      const RodSystem::Link& link = unit.links[static_cast<std::size_t>(c)];
      const std::vector<Complex> a1 = spindle.under_force_at(link.first_section);
      const std::vector<Complex> a2 = sleeve.under_force_at(link.second_section);
      reach(c) = a1[nose];
      for (Eigen::Index r = 0; r < joints; ++r) {
        const RodSystem::Link& other = unit.links[static_cast<std::size_t>(r)];
        joint(r, c) = a1[other.first_section] + a2[other.second_section];
      }
      joint(c, c) += 1.0 / (link.stiffness_n_m * damped);
    }
    const Eigen::VectorXcd forces = joint.partialPivLu().solve(reach);
    const Complex relief = (reach.transpose() * forces)(0);
    const Complex g = (spindle.under_force_at(nose)[nose] - relief) * 1e6;
    require_off_resonance(std::isfinite(g.real()) && std::isfinite(g.imag()), in.freq_hz);
    return NoseCompliance{g.real(), g.imag(), std::abs(g)};
  });
}

SpeedLimit max_spindle_speed_dn(const BearingBore& in) {
  return guarded<&max_spindle_speed_dn>(in, [&] { return SpeedLimit{in.dn_mm_rpm / in.bore_mm}; });
}

SpeedBands resonance_speed_bands(const ResonanceInputs& in) {
  return guarded<&resonance_speed_bands>(in, [&] {
    require(in.n_min_rpm <= in.n_max_rpm, "n_min_rpm", in.n_min_rpm, "must not be above n_max_rpm");
    std::vector<std::pair<double, double>> bands;
    for (const double p : in.natural_hz)
      for (const double h : in.harmonics) {
        const double low = std::max(60 * p * (1 - in.margin) / h, in.n_min_rpm);
        const double high = std::min(60 * p * (1 + in.margin) / h, in.n_max_rpm);
        if (low < high) bands.emplace_back(low, high);
      }
    std::sort(bands.begin(), bands.end());
    SpeedBands out;
    for (const auto& [low, high] : bands) {
      if (!out.n_hi_rpm.empty() && low <= out.n_hi_rpm.back()) {
        out.n_hi_rpm.back() = std::max(out.n_hi_rpm.back(), high);
      } else {
        out.n_lo_rpm.push_back(low);
        out.n_hi_rpm.push_back(high);
      }
    }
    return out;
  });
}

ChatterLimit chatter_limit_width(const ChatterInputs& in) {
  return guarded<&chatter_limit_width>(in, [&] {
    const double re_mm_n = std::abs(in.min_re_um_n) * 1e-3;
    return ChatterLimit{1 / (2 * in.ks_n_mm2 * in.orientation_factor * re_mm_n)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K206",
       .title = "Dynamical analysis of the mechanical vibration system 'spindle unit - base'",
       .authors = "Danylchenko Yu. M., Petryshyn A. I.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011, "
                    "pp. 169-174",
       .models =
           "A grinding head as two elastic rods, the spindle and the sleeve clamped in the machine, joined "
           "by angular-contact bearings; the sleeve rests on springs. How the stiffness of the seat "
           "shifts the natural frequencies, which spindle speeds to avoid, and the compliance at the "
           "tool.",
       .role = "dynamics",
       .errata = {
           "The last term of the influence coefficient is printed unconditionally; it exists only for i > j, "
           "otherwise reciprocity fails.",
           "583 Hz is called an asymptote; it is the sleeve rocking on its springs and still grows with the "
           "square root of their stiffness at the end of the published sweep."}});

  const auto numbers = [](std::initializer_list<double> values) {
    Value::List list;
    for (const double v : values) list.emplace_back(v);
    return Value(list);
  };
  const auto steel = [](auto& f) {
    f.optional(&Steel::e_gpa, "e_gpa", "E", "GPa", positive(), "modulus of elasticity")
        .optional(&Steel::rho_kg_m3, "rho_kg_m3", "rho", "kg/m3", positive(), "density");
  };
  const auto segments = [&](auto& f, auto length, auto outer, auto inner, const std::string& prefix,
                            const std::string& rod, const Value& l, const Value& d, const Value& bore) {
    f.input(length, prefix + "length_mm", "l_i", "mm", positive(), "segment lengths of the " + rod, l)
        .length(1, 1000)
        .input(outer, prefix + "outer_mm", "D_i", "mm", positive(), "outer diameters of the " + rod, d)
        .length(1, 1000)
        .input(inner, prefix + "inner_mm", "d_i", "mm", non_negative(),
               "inner diameters of the " + rod + ", 0 for solid", bore)
        .length(1, 1000);
  };
  // The stand-in geometry calibrated to the published frequencies.
  const Value spindle_l = numbers({67.8, 12, 35.5, 12, 73.1});
  const Value spindle_d = numbers({14, 20, 35, 20, 10});
  const Value spindle_bore = numbers({0, 0, 0, 0, 0});
  const Value sleeve_l = numbers({17.3, 12, 35.5, 12, 173.2});
  const Value sleeve_d = numbers({65, 65, 65, 65, 65});
  const Value sleeve_bore = numbers({42, 42, 52, 42, 42});
  const Value seat = Value::List{1, 4};

  const auto supports = [&](auto& f) {
    f.input(&SupportedRod::support_section, "support_section", "-", "-", at_least(0),
            "sections on springs to the ground", seat)
        .length(0, 1000)
        .input(&SupportedRod::support_k_n_um, "support_k_n_um", "k_k", "N/um", positive(),
               "stiffness of each spring", numbers({120, 120}))
        .length(0, 1000);
  };
  const auto rod = [&](auto& f) {
    segments(f, &SupportedRod::length_mm, &SupportedRod::outer_mm, &SupportedRod::inner_mm, "", "rod",
             sleeve_l, sleeve_d, sleeve_bore);
    supports(f);
    steel(f);
  };
  const auto unit = [&](auto& f) {
    segments(f, &SpindleUnit::spindle_length_mm, &SpindleUnit::spindle_outer_mm,
             &SpindleUnit::spindle_inner_mm, "spindle_", "spindle", spindle_l, spindle_d, spindle_bore);
    segments(f, &SpindleUnit::sleeve_length_mm, &SpindleUnit::sleeve_outer_mm, &SpindleUnit::sleeve_inner_mm,
             "sleeve_", "sleeve", sleeve_l, sleeve_d, sleeve_bore);
    f.input(&SpindleUnit::bearing_section, "bearing_section", "-", "-", at_least(0),
            "sections of both rods that a bearing joins", Value::List{1, 2, 3, 4})
        .length(1, 1000)
        .input(&SpindleUnit::bearing_k_n_um, "bearing_k_n_um", "k_i", "N/um", positive(),
               "stiffness of each bearing", numbers({113, 113, 113, 113}))
        .length(1, 1000);
    steel(f);
  };
  const auto seated = [&](auto& f) {
    unit(f);
    f.input(&SeatedUnit::support_section, "support_section", "-", "-", at_least(0),
            "sleeve sections on springs", seat)
        .length(0, 1000)
        .input(&SeatedUnit::support_k_n_um, "support_k_n_um", "k_k", "N/um", positive(),
               "stiffness of each spring of the seat", numbers({120, 120}))
        .length(0, 1000);
  };
  const std::string range_note = "Frequencies below 1 Hz and above 20 kHz are not looked for.";
  const std::string beam_note =
      "Euler-Bernoulli rods: no shear, no gyroscopic terms, bearing stiffness independent of speed.";

  source
      .function<&krylov_functions>("krylov_functions", "Krylov functions S, T, U, V.", "definition",
                                   Provenance::completion)
      .input(&KrylovArgument::x, "x", "x", "1", open_low(0, 700), "argument", 0.5)
      .output(&KrylovValues::s, "s", "S", "1", any(), "(cosh x + cos x) / 2")
      .output(&KrylovValues::t, "t", "T", "1", any(), "(sinh x + sin x) / 2")
      .output(&KrylovValues::u, "u", "U", "1", any(), "(cosh x - cos x) / 2")
      .output(&KrylovValues::v, "v", "V", "1", any(), "(sinh x - sin x) / 2");
  source
      .function<&segment_transfer_matrix>("segment_transfer_matrix",
                                          "Dimensionless transfer matrix of one segment.", "eqs. (1), (2)",
                                          Provenance::completion)
      .input(&SegmentInputs::length_mm, "length_mm", "l_i", "mm", positive(), "length", 67.8)
      .input(&SegmentInputs::outer_mm, "outer_mm", "D_i", "mm", positive(), "outer diameter", 14.0)
      .input(&SegmentInputs::inner_mm, "inner_mm", "d_i", "mm", non_negative(), "inner diameter, 0 for solid",
             0.0)
      .with(steel)
      .input(&SegmentInputs::freq_hz, "freq_hz", "f", "Hz", positive(), "frequency", 1000.0)
      .input(&SegmentInputs::ref_length_mm, "ref_length_mm", "l", "mm", positive(), "reference length", 200.4)
      .input(&SegmentInputs::ref_ej_n_m2, "ref_ej_n_m2", "EJ", "N*m2", positive(),
             "reference bending stiffness", 396.0)
      .output(&SegmentMatrix::m, "m", "U_i", "1", any(), "matrix, row by row, for {y, l phi, a M, b Q}")
      .note("The paper does not print the segment matrix; textbook form by Krylov functions.");
  source
      .function<&harmonic_influence>("harmonic_influence",
                                     "Displacement at section i from a unit harmonic force at section j.",
                                     "influence coefficients", Provenance::repaired)
      .with(rod)
      .input(&InfluenceInputs::i, "i", "i", "-", at_least(0), "section of the displacement", 2)
      .input(&InfluenceInputs::j, "j", "j", "-", at_least(0), "section of the force", 3)
      .input(&InfluenceInputs::freq_hz, "freq_hz", "f", "Hz", positive(), "frequency", 300.0)
      .output(&Influence::alpha_um_n, "alpha_um_n", "alpha_ij", "um/N", any(), "influence coefficient")
      .note(beam_note);
  source
      .function<&rod_natural_frequencies>("rod_natural_frequencies",
                                          "Natural frequencies of a rod, free or on springs.", "Delta = 0",
                                          Provenance::paper)
      .with(rod)
      .input(&RodFrequencyInputs::count, "count", "-", "1", at_least(1), "frequencies wanted", 2)
      .output(&Frequencies::p_hz, "p_hz", "p", "Hz", positive(), "natural frequencies, ascending")
      .note(range_note)
      .note(beam_note);
  source
      .function<&spindle_base_natural_frequencies>("spindle_base_natural_frequencies",
                                                   "Natural frequencies of a spindle in a sleeve on springs.",
                                                   "eqs. (3), (4)", Provenance::paper)
      .with(seated)
      .input(&UnitFrequencyInputs::count, "count", "-", "1", at_least(1), "frequencies wanted", 3)
      .output(&Frequencies::p_hz, "p_hz", "p", "Hz", positive(), "natural frequencies, ascending")
      .note("Counted by Wittrick and Williams' method, which misses no close pair; same zeros as eq. (4).")
      .note(range_note)
      .note(beam_note);
  source
      .function<&required_mount_stiffness>("required_mount_stiffness",
                                           "Seat stiffness that lifts a natural frequency to a target.",
                                           "completion", Provenance::completion)
      .with(unit)
      .input(&MountTarget::support_section, "support_section", "-", "-", at_least(0),
             "sleeve sections on equal springs", seat)
      .length(0, 1000)
      .input(&MountTarget::target_hz, "target_hz", "-", "Hz", open_low(0, scan_high_hz), "frequency to reach",
             300.0)
      .input(&MountTarget::mode, "mode", "-", "1", at_least(1), "number of the frequency, from 1", 1)
      .input(&MountTarget::k_lo_n_um, "k_lo_n_um", "-", "N/um", positive(), "softest seat considered", 0.1)
      .input(&MountTarget::k_hi_n_um, "k_hi_n_um", "-", "N/um", positive(), "stiffest seat considered",
             1000.0)
      .output(&MountStiffness::k_n_um, "k_n_um", "k_k", "N/um", positive(), "least stiffness of each spring");
  source
      .function<&nose_compliance>("nose_compliance",
                                  "Compliance of the unit at a spindle section, with damping.", "completion",
                                  Provenance::completion)
      .with(seated)
      .input(&NoseInputs::section, "section", "-", "-", at_least(0), "spindle section, 0 is the nose", 0)
      .input(&NoseInputs::freq_hz, "freq_hz", "f", "Hz", positive(), "frequency", 100.0)
      .input(&NoseInputs::loss_factor, "loss_factor", "eta", "1", closed(0, 0.2),
             "loss factor; 0.02-0.05 for bolted spindle assemblies", 0.03)
      .output(&NoseCompliance::re_um_n, "re_um_n", "Re G", "um/N", any(), "real part")
      .output(&NoseCompliance::im_um_n, "im_um_n", "Im G", "um/N", any(), "imaginary part")
      .output(&NoseCompliance::abs_um_n, "abs_um_n", "|G|", "um/N", non_negative(), "modulus")
      .note(beam_note);
  source
      .function<&max_spindle_speed_dn>("max_spindle_speed_dn", "Speed limit of a rolling bearing.",
                                       "introduction", Provenance::paper)
      .input(&BearingBore::bore_mm, "bore_mm", "d", "mm", positive(), "bore", 20.0)
      .optional(&BearingBore::dn_mm_rpm, "dn_mm_rpm", "d n", "mm*rpm", positive(), "speed factor")
      .output(&SpeedLimit::n_max_rpm, "n_max_rpm", "n_max", "rpm", positive(), "highest speed");
  source
      .function<&resonance_speed_bands>("resonance_speed_bands", "Forbidden spindle speeds.", "completion",
                                        Provenance::completion)
      .input(&ResonanceInputs::natural_hz, "natural_hz", "p", "Hz", positive(), "natural frequencies",
             numbers({583, 1296}))
      .input(&ResonanceInputs::harmonics, "harmonics", "h", "1", positive(),
             "orders of excitation: 1 unbalance, z teeth", numbers({1, 2}))
      .input(&ResonanceInputs::margin, "margin", "-", "1", closed(0, 0.5),
             "distance to keep from a resonance, usually 0.15-0.20", 0.1)
      .input(&ResonanceInputs::n_min_rpm, "n_min_rpm", "-", "rpm", non_negative(), "lowest speed", 1000.0)
      .input(&ResonanceInputs::n_max_rpm, "n_max_rpm", "-", "rpm", non_negative(), "highest speed", 90000.0)
      .output(&SpeedBands::n_lo_rpm, "n_lo_rpm", "-", "rpm", non_negative(), "lower ends, ascending")
      .output(&SpeedBands::n_hi_rpm, "n_hi_rpm", "-", "rpm", non_negative(), "upper ends");
  source
      .function<&chatter_limit_width>("chatter_limit_width", "Width of cut that is stable at any speed.",
                                      "completion (Tlusty)", Provenance::completion)
      .input(&ChatterInputs::ks_n_mm2, "ks_n_mm2", "K_s", "N/mm2", positive(), "specific cutting force",
             2000.0)
      .input(&ChatterInputs::min_re_um_n, "min_re_um_n", "min Re G", "um/N", below(0),
             "least real part of the compliance; none negative means no limit", -0.05)
      .optional(&ChatterInputs::orientation_factor, "orientation_factor", "u", "1", positive(),
                "direction factor of the vibration")
      .output(&ChatterLimit::b_lim_mm, "b_lim_mm", "b_lim", "mm", positive(), "stable width of cut");
}

}  // namespace verstat::models::k206
