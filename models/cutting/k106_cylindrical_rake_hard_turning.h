#pragma once
// Finish turning of hardened bearing steel with PCBN tools of flat and cylindrical rake (K106): force levels,
// their growth with wear and time, power, chatter of ceramic inserts, deflection of the part.
//
// Melnichuk, Klimenko, Manokhin 2011. The paper prints no equation: every formula is a COMPLETION calibrated
// on its statements.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k106 {

enum class Rake { flat, cylindrical };
enum class ToolMaterial { cbn, ceramic };

struct HardTurning {
  double speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_mm = 0;
  double flank_wear_mm = 0;
  Rake rake = Rake::flat;
  ToolMaterial tool_material = ToolMaterial::cbn;
};
struct HardTurningForces {
  double p_x_n;
  double p_y_n;
  double p_z_n;
  bool in_published_envelope;
};
/// Force components of hard turning, K106 (C1). Speed, feed, depth > 0, flank wear >= 0. Outside the
/// published box (v 30..150, s 0.1..0.7, t 0.05..0.25) or forces the flag is false and the forces are
/// extrapolations.
[[nodiscard]] HardTurningForces hard_turning_forces(const HardTurning& in);

struct CuttingTime {
  double cutting_time_min = 0;
};
struct ForceGrowth {
  double factor_y;
  double factor_z;
};
/// Growth of radial and tangential force over the first 10 s of a sharp tool, 0..60 min. K106 (C2), through
/// the printed points at 10 and 40 min.
[[nodiscard]] ForceGrowth force_growth_with_time(const CuttingTime& in);

struct RoundInsert {
  double radius_mm = 0;
  double depth_mm = 0;
  double feed_mm_rev = 0;
};
struct EdgeLength {
  double length_mm;
};
/// Active edge of a flat-rake round insert, b = r (arccos(1 - t/r) + arcsin(s/2r)), 0 < t <= r, 0 <= s <= 2r.
/// K106 (C3).
[[nodiscard]] EdgeLength active_edge_length(const RoundInsert& in);

struct FlankLoad {
  double force_growth_n = 0;  // of the radial force with wear
  double flank_wear_mm = 0;
  double edge_length_mm = 0;
};
struct Pressure {
  double pressure_mpa;
};
/// Contact pressure on the worn flank, p = dP_y / (h b). K106 (C4).
[[nodiscard]] Pressure flank_contact_pressure(const FlankLoad& in);

struct PowerInputs {
  double p_z_n = 0;
  double speed_m_min = 0;
};
struct Power {
  double power_kw;
};
/// Cutting power N = P_z v / 60000. K106 (C5).
[[nodiscard]] Power cutting_power(const PowerInputs& in);

struct CeramicRegime {
  double speed_m_min = 0;
  double depth_mm = 0;
};
struct ChatterRisk {
  bool risk;
};
/// Whether a ceramic insert chatters: t >= 0.1 mm and 60 <= v <= 100 m/min. Printed for t = 0.1 mm.
[[nodiscard]] ChatterRisk ceramic_chatter_risk(const CeramicRegime& in);

struct BarLoad {
  double p_y_n = 0;
  double length_mm = 0;
  double diameter_mm = 0;
  double elastic_modulus_mpa = 0;
};
struct Deflection {
  double deflection_um;
};
/// Deflection of a bar between centres under a force at mid-span, P L^3 / (48 E I). K106 (C6).
[[nodiscard]] Deflection part_deflection(const BarLoad& in);

}  // namespace verstat::models::k106

template <>
struct verstat::models::EnumNames<verstat::models::k106::Rake> {
  static constexpr std::array names{std::pair{k106::Rake::flat, "flat"},
                                    std::pair{k106::Rake::cylindrical, "cylindrical"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k106::ToolMaterial> {
  static constexpr std::array names{std::pair{k106::ToolMaterial::cbn, "cbn"},
                                    std::pair{k106::ToolMaterial::ceramic, "ceramic"}};
};
