#pragma once
// Hydrostatic spindle bearing with an adaptive supply (K210): pocket pressures, displacement under load,
// stiffness, the load that centring regulators can carry, and heat.
//
// Ponomarenko, Kucherenko 2011. The paper prints dimensions, viscosity and rules but no equations: the model
// is a COMPLETION, the textbook lumped-resistance bearing with capillary or controlled restrictors. Pocket i
// is centred at 2 pi i / N from +x; rotation is counterclockwise.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k210 {

struct Bearing {
  double diameter_mm = 175;
  double length_mm = 245;
  std::int64_t pockets = 5;
  double pocket_length_mm = 180;  // axial
  double pocket_width_mm = 90;    // circumferential
  double radial_clearance_um = 60;
  double viscosity_pa_s = 0.28;
  double supply_pressure_mpa = 4;  // gauge
  double pressure_ratio = 0.5;     // centred pocket over supply pressure
  double spindle_rpm = 100;
  double feedback_gain = 0;  // 0 = plain capillaries
  double conductance_max = 10;
};

struct PartTolerance {
  double part_tolerance_um = 0;
};
struct MachineError {
  double strict_um, loose_um;
};
/// Machine error 3 to 5 times below the tightest part tolerance: the paper's rule.
[[nodiscard]] MachineError required_machine_error(const PartTolerance& in);

struct Displacement : Bearing {
  double ex_um = 0;
  double ey_um = 0;
};
struct PocketState {
  std::vector<double> p_mpa;
  double flow_l_min;
  double fx_n, fy_n;
};
/// Pocket pressures, flow and film force on the shaft at a displacement below the clearance.
[[nodiscard]] PocketState pocket_state(const Displacement& in);

struct Load : Bearing {
  double load_x_n = 0;
  double load_y_n = 0;
};
struct Equilibrium {
  double ex_um, ey_um, eccentricity_um, h_min_um;
  double p_max_mpa, p_min_mpa;
  double flow_l_min;
};
/// Displacement under a load (Newton). Error when no equilibrium is found below 0.98 of the clearance.
[[nodiscard]] Equilibrium shaft_equilibrium(const Load& in);

struct Stiffness {
  double k_direct_n_um, k_cross_n_um;
};
/// -dFx/dx and -dFy/dx at the centre, central difference of 0.01 um.
[[nodiscard]] Stiffness static_stiffness(const Bearing& in);

struct CentringLoad {
  double load_n;
};
/// Largest load towards pocket 0 that individually set regulators carry with zero displacement, without
/// rotation; feedback_gain and spindle_rpm are not used.
[[nodiscard]] CentringLoad centring_load_capacity(const Bearing& in);

struct LossInputs : Bearing {
  double flow_l_min = 0;
  double specific_heat_j_kgk = 1900;
  double density_kg_m3 = 870;
  double inlet_c = 22;
};
struct Losses {
  double friction_kw, pump_kw, temp_rise_c, outlet_c;
};
/// Petroff friction on the lands, pump power and adiabatic temperature rise; viscosity as given.
[[nodiscard]] Losses bearing_losses(const LossInputs& in);

struct OilInputs {
  double temp_c = 0;
  double mu_ref_pa_s = 0.28;
  double t_ref_c = 22;
  double beta_per_c = 0.06;
};
struct Viscosity {
  double mu_pa_s;
};
/// Reynolds' law, mu_0 exp(-beta (T - T_0)).
[[nodiscard]] Viscosity oil_viscosity(const OilInputs& in);

struct Service {
  double h_min_um = 0;
  double outlet_c = 0;
  double h_allow_um = 0;
  double t_allow_c = 0;
};
struct Serviceable {
  int ok;
};
/// Film at least h_allow and outlet at most t_allow: the paper's criteria.
[[nodiscard]] Serviceable bearing_serviceable(const Service& in);

}  // namespace verstat::models::k210
