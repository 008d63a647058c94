#pragma once
// Natural frequencies of a spindle in a sleeve on an elastic base (K206): two rods of uniform segments joined
// by bearings, the sleeve resting on springs. From them the compliance at the tool, forbidden speed bands and
// the stable width of cut.
//
// Danylchenko, Petryshyn 2011. Rods run from the nose to the tail; section i is the right end of segment i,
// section 0 the left end of the rod. Inputs carry the names of the card in JSON.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k206 {

struct KrylovArgument {
  double x = 0;
};
struct KrylovValues {
  double s, t, u, v;
};
/// Krylov functions of 0 < x <= 700. Definitions under eq. (1).
[[nodiscard]] KrylovValues krylov_functions(const KrylovArgument& in);

struct Steel {
  double e_gpa = 210;
  double rho_kg_m3 = 7850;
};
struct SegmentInputs : Steel {
  double length_mm = 0;
  double outer_mm = 0;
  double inner_mm = 0;
  double freq_hz = 0;
  double ref_length_mm = 0;
  double ref_ej_n_m2 = 0;
};
struct SegmentMatrix {
  std::vector<double> m;  // 16 numbers, row-major
};
/// Dimensionless 4x4 matrix of one segment, state {y, l phi, a M, b Q}. COMPLETION (Krylov): not printed.
[[nodiscard]] SegmentMatrix segment_transfer_matrix(const SegmentInputs& in);

struct SupportedRod : Steel {
  std::vector<double> length_mm;
  std::vector<double> outer_mm;
  std::vector<double> inner_mm;
  std::vector<std::int64_t> support_section;
  std::vector<double> support_k_n_um;
};
struct InfluenceInputs : SupportedRod {
  std::int64_t i = 0;
  std::int64_t j = 0;
  double freq_hz = 0;
};
struct Influence {
  double alpha_um_n;
};
/// Harmonic influence coefficient alpha_ij: displacement at section i from a unit force at section j.
/// Repaired: the last term exists only for i > j. Error at a natural frequency and where the frequency is
/// too high for transfer matrices (sum of lambda L above 25).
[[nodiscard]] Influence harmonic_influence(const InfluenceInputs& in);

struct RodFrequencyInputs : SupportedRod {
  std::int64_t count = 1;
};
struct Frequencies {
  std::vector<double> p_hz;
};
/// First `count` natural frequencies of a rod between 1 Hz and 20 kHz, ascending; rigid motions at 0 Hz are
/// left out. Fewer come back when there are fewer.
[[nodiscard]] Frequencies rod_natural_frequencies(const RodFrequencyInputs& in);

/// Spindle and sleeve joined by bearings: bearing j joins section bearing_section[j] of both rods. The sleeve
/// rests on springs at support_section.
struct SpindleUnit : Steel {
  std::vector<double> spindle_length_mm;
  std::vector<double> spindle_outer_mm;
  std::vector<double> spindle_inner_mm;
  std::vector<double> sleeve_length_mm;
  std::vector<double> sleeve_outer_mm;
  std::vector<double> sleeve_inner_mm;
  std::vector<std::int64_t> bearing_section;
  std::vector<double> bearing_k_n_um;
  std::vector<std::int64_t> support_section;
};
struct SeatedUnit : SpindleUnit {
  std::vector<double> support_k_n_um;
};
struct UnitFrequencyInputs : SeatedUnit {
  std::int64_t count = 1;
};
/// Natural frequencies of the joint system, zeros of the determinant (4), as rod_natural_frequencies.
[[nodiscard]] Frequencies spindle_base_natural_frequencies(const UnitFrequencyInputs& in);

struct MountTarget : SpindleUnit {
  double target_hz = 0;
  std::int64_t mode = 1;  // 1-based, rigid motions not counted
  double k_lo_n_um = 0;
  double k_hi_n_um = 0;
};
struct MountStiffness {
  double k_n_um;
};
/// Smallest equal seat stiffness in [k_lo, k_hi] with p_mode >= target; k_lo if that is enough, error if k_hi
/// is not. COMPLETION.
[[nodiscard]] MountStiffness required_mount_stiffness(const MountTarget& in);

struct NoseInputs : SeatedUnit {
  std::int64_t section = 0;
  double freq_hz = 0;
  double loss_factor = 0;
};
struct NoseCompliance {
  double re_um_n;
  double im_um_n;
  double abs_um_n;
};
/// Compliance of the joint system at a spindle section by receptance coupling, with hysteretic damping of
/// both rods and all springs, loss factor 0..0.2. COMPLETION.
[[nodiscard]] NoseCompliance nose_compliance(const NoseInputs& in);

struct BearingBore {
  double bore_mm = 0;
  double dn_mm_rpm = 2.4e6;
};
struct SpeedLimit {
  double n_max_rpm;
};
/// Bearing speed limit dn / d.
[[nodiscard]] SpeedLimit max_spindle_speed_dn(const BearingBore& in);

struct ResonanceInputs {
  std::vector<double> natural_hz;
  std::vector<double> harmonics;
  double margin = 0;
  double n_min_rpm = 0;
  double n_max_rpm = 0;
};
struct SpeedBands {
  std::vector<double> n_lo_rpm;
  std::vector<double> n_hi_rpm;
};
/// Forbidden bands 60 p (1 -+ margin) / h, cut at n_min and n_max; empty ones dropped, overlapping or
/// touching ones joined. COMPLETION.
[[nodiscard]] SpeedBands resonance_speed_bands(const ResonanceInputs& in);

struct ChatterInputs {
  double ks_n_mm2 = 0;
  double min_re_um_n = 0;
  double orientation_factor = 1;
};
struct ChatterLimit {
  double b_lim_mm;
};
/// Stable width of cut 1 / (2 K_s u |min Re G|) (Tlusty). COMPLETION. min Re G < 0, else there is no limit.
[[nodiscard]] ChatterLimit chatter_limit_width(const ChatterInputs& in);

}  // namespace verstat::models::k206
