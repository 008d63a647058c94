#include "models/dynamics/k210_hydrostatic_bearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace verstat::models::k210 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double l_min_per_m3_s = 6e4;

// Solution of the cyclic tridiagonal system with diagonal d, left neighbour -left, right neighbour -right
// (indices modulo n): Thomas' elimination with Sherman and Morrison's correction for the corners. The matrix
// is diagonally dominant, so no pivoting is needed.
std::vector<double> solve_cyclic(std::vector<double> d, const std::vector<double>& left,
                                 const std::vector<double>& right, std::vector<double> rhs) {
  const std::size_t n = d.size();
  const double gamma = -d[0];
  const double top = -left[0];          // row 0, column n-1
  const double bottom = -right[n - 1];  // row n-1, column 0
  std::vector<double> u(n, 0.0);
  u[0] = gamma;
  u[n - 1] = bottom;
  d[0] -= gamma;
  d[n - 1] -= bottom * top / gamma;
  for (std::size_t k = 1; k < n; ++k) {
    const double factor = -left[k] / d[k - 1];
    d[k] += factor * right[k - 1];
    rhs[k] -= factor * rhs[k - 1];
    u[k] -= factor * u[k - 1];
  }
  rhs[n - 1] /= d[n - 1];
  u[n - 1] /= d[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) {
    rhs[k] = (rhs[k] + right[k] * rhs[k + 1]) / d[k];
    u[k] = (u[k] + right[k] * u[k + 1]) / d[k];
  }
  const double share = (rhs[0] + top / gamma * rhs[n - 1]) / (1 + u[0] + top / gamma * u[n - 1]);
  for (std::size_t k = 0; k < n; ++k) rhs[k] -= share * u[k];
  return rhs;
}

// The bearing in SI units.
class Film {
 public:
  explicit Film(const Bearing& b)
      : n_(static_cast<std::size_t>(b.pockets)),
        clearance_(b.radial_clearance_um * 1e-6),
        supply_(b.supply_pressure_mpa * 1e6),
        gain_(b.feedback_gain),
        opening_max_(b.conductance_max) {
    const double diameter = b.diameter_mm * 1e-3;
    const double pitch = pi * diameter / static_cast<double>(b.pockets);
    const double pocket_length = b.pocket_length_mm * 1e-3;
    require(b.pocket_length_mm < b.length_mm, "pocket_length_mm", b.pocket_length_mm,
            "must be below length_mm");
    require(b.pocket_width_mm * 1e-3 < pitch, "pocket_width_mm", b.pocket_width_mm,
            fmt::format("must be below the pocket pitch pi D / N = {:.6g} mm", pitch * 1e3));
    const double axial_land = (b.length_mm - b.pocket_length_mm) * 1e-3 / 2;
    const double between = pitch - b.pocket_width_mm * 1e-3;
    axial_ = 2 * pitch / (12 * b.viscosity_pa_s * axial_land);
    around_ = pocket_length / (12 * b.viscosity_pa_s * between);
    dragged_ = 0.5 * pocket_length * pi * diameter * b.spindle_rpm / 60;
    restrictor_ = axial_conductance(clearance_) * b.pressure_ratio / (1 - b.pressure_ratio);
    // Projected area of a pocket sector.
    area_ = (pocket_length + axial_land) * diameter * std::sin(pi / static_cast<double>(b.pockets));
  }

  struct State {
    std::vector<double> pressure_pa;
    double flow_m3_s;
    Eigen::Vector2d force_n;
    double largest_term_n;  // sum of moduli: what rounding of the force is measured by
  };

  [[nodiscard]] State at(const Eigen::Vector2d& e_m) const {
    std::vector<double> openings(n_);
    for (std::size_t i = 0; i < n_; ++i)
      openings[i] =
          std::clamp(1 + gain_ * e_m.dot(direction(static_cast<double>(i))) / clearance_, 0.0, opening_max_);
    return with_openings(e_m, openings, dragged_);
  }

  // Centred shaft, no rotation, pockets 0, +-1 .. +-j fully open and the others shut.
  [[nodiscard]] double centred_load_n(std::size_t j) const {
    std::vector<double> openings(n_, 0.0);
    for (std::size_t i = 0; i < n_; ++i)
      if (std::min(i, n_ - i) <= j) openings[i] = opening_max_;
    return -with_openings(Eigen::Vector2d::Zero(), openings, 0).force_n.x();
  }

  [[nodiscard]] double clearance_m() const { return clearance_; }
  [[nodiscard]] std::size_t pockets() const { return n_; }

 private:
  [[nodiscard]] Eigen::Vector2d direction(double pocket) const {
    const double angle = 2 * pi * pocket / static_cast<double>(n_);
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] double axial_conductance(double h) const { return axial_ * h * h * h; }

  [[nodiscard]] State with_openings(const Eigen::Vector2d& e_m, const std::vector<double>& openings,
                                    double dragged) const {
    const auto film = [&](double pocket) { return clearance_ - e_m.dot(direction(pocket)); };
    std::vector<double> diagonal(n_), left(n_), right(n_), inflow(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const double pocket = static_cast<double>(i);
      const double after = film(pocket + 0.5);
      const double before = film(pocket - 0.5);
      const double g = restrictor_ * openings[i];
      right[i] = around_ * after * after * after;
      left[i] = around_ * before * before * before;
      diagonal[i] = g + axial_conductance(film(pocket)) + left[i] + right[i];
      inflow[i] = g * supply_ - dragged * (after - before);
    }
    State s{solve_cyclic(std::move(diagonal), left, right, std::move(inflow)), 0, Eigen::Vector2d::Zero(), 0};
    for (std::size_t i = 0; i < n_; ++i) {
      const double p = s.pressure_pa[i];
      s.flow_m3_s += restrictor_ * openings[i] * (supply_ - p);
      s.force_n -= p * area_ * direction(static_cast<double>(i));
      s.largest_term_n += std::abs(p) * area_;
    }
    return s;
  }

  std::size_t n_;
  double clearance_, supply_, gain_, opening_max_;
  double axial_ = 0;       // k_a / h^3
  double around_ = 0;      // k_c / h^3
  double dragged_ = 0;     // l_p U / 2
  double restrictor_ = 0;  // G_0
  double area_ = 0;
};

}  // namespace

MachineError required_machine_error(const PartTolerance& in) {
  return guarded<&required_machine_error>(in, [&] {
    return MachineError{in.part_tolerance_um / 5, in.part_tolerance_um / 3};
  });
}

PocketState pocket_state(const Displacement& in) {
  return guarded<&pocket_state>(in, [&] {
    const Film film(in);
    const double eccentricity = std::hypot(in.ex_um, in.ey_um);
    require(eccentricity < in.radial_clearance_um, "ex_um", in.ex_um,
            fmt::format("and ey_um = {} displace the shaft by {:.6g} um, must be below radial_clearance_um",
                        in.ey_um, eccentricity));
    const Film::State s = film.at(Eigen::Vector2d(in.ex_um, in.ey_um) * 1e-6);
    PocketState out{{}, s.flow_m3_s * l_min_per_m3_s, s.force_n.x(), s.force_n.y()};
    for (const double p : s.pressure_pa) out.p_mpa.push_back(p * 1e-6);
    return out;
  });
}

Equilibrium shaft_equilibrium(const Load& in) {
  return guarded<&shaft_equilibrium>(in, [&] {
    const Film film(in);
    const Eigen::Vector2d load(in.load_x_n, in.load_y_n);
    const double c = film.clearance_m();
    constexpr double step_m = 1e-10;
    Eigen::Vector2d e = Eigen::Vector2d::Zero();
    for (int k = 0; k < 100; ++k) {
      const Film::State s = film.at(e);
      const Eigen::Vector2d residual = s.force_n + load;
      // The card's bound, or what rounding of the pocket forces leaves of it in a very large bearing.
      const double bound =
          std::max(1e-9 * (1 + load.norm()), 32 * std::numeric_limits<double>::epsilon() * s.largest_term_n);
      if (residual.norm() <= bound) {
        const auto [least, most] = std::minmax_element(s.pressure_pa.begin(), s.pressure_pa.end());
        return Equilibrium{.ex_um = e.x() * 1e6,
                           .ey_um = e.y() * 1e6,
                           .eccentricity_um = e.norm() * 1e6,
                           .h_min_um = (c - e.norm()) * 1e6,
                           .p_max_mpa = *most * 1e-6,
                           .p_min_mpa = *least * 1e-6,
                           .flow_l_min = s.flow_m3_s * l_min_per_m3_s};
      }
      Eigen::Matrix2d jacobian;
      for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector2d h = step_m * Eigen::Vector2d::Unit(axis);
        jacobian.col(axis) = (film.at(e + h).force_n - film.at(e - h).force_n) / (2 * step_m);
      }
      Eigen::Vector2d step = -jacobian.partialPivLu().solve(residual);
      if (!step.allFinite()) break;
      if (const double length = step.norm(); length > 0.3 * c) step *= 0.3 * c / length;
      e += step;
      if (const double length = e.norm(); length > 0.98 * c) e *= 0.98 * c / length;
    }
    reject(
        fmt::format("no equilibrium below 0.98 of the clearance under load_x_n = {}, load_y_n = {}: the "
                    "bearing is overloaded, or feedback_gain drives the regulators to their limits",
                    in.load_x_n, in.load_y_n));
  });
}

Stiffness static_stiffness(const Bearing& in) {
  return guarded<&static_stiffness>(in, [&] {
    const Film film(in);
    constexpr double step_um = 0.01;
    const Eigen::Vector2d step(step_um * 1e-6, 0);
    require(in.radial_clearance_um > step_um, "radial_clearance_um", in.radial_clearance_um,
            "must be above the 0.01 um step of the difference");
    const Eigen::Vector2d slope = (film.at(step).force_n - film.at(-step).force_n) / (2 * step_um);
    return Stiffness{-slope.x(), -slope.y()};
  });
}

CentringLoad centring_load_capacity(const Bearing& in) {
  return guarded<&centring_load_capacity>(in, [&] {
    const Film film(in);
    double best = film.centred_load_n(0);
    for (std::size_t j = 1; j <= (film.pockets() - 1) / 2; ++j) best = std::max(best, film.centred_load_n(j));
    return CentringLoad{best};
  });
}

Losses bearing_losses(const LossInputs& in) {
  return guarded<&bearing_losses>(in, [&] {
    const Film checked(in);  // the dimensions must make a bearing
    const double diameter = in.diameter_mm * 1e-3;
    const double speed = pi * diameter * in.spindle_rpm / 60;
    const double lands = pi * diameter * in.length_mm * 1e-3 - static_cast<double>(checked.pockets()) *
                                                                   in.pocket_length_mm * in.pocket_width_mm *
                                                                   1e-6;
    const double friction_w = in.viscosity_pa_s * speed * speed * lands / checked.clearance_m();
    const double flow = in.flow_l_min / l_min_per_m3_s;
    const double pump_w = in.supply_pressure_mpa * 1e6 * flow;
    const double rise = (friction_w + pump_w) / (in.density_kg_m3 * in.specific_heat_j_kgk * flow);
    return Losses{friction_w * 1e-3, pump_w * 1e-3, rise, in.inlet_c + rise};
  });
}

Viscosity oil_viscosity(const OilInputs& in) {
  return guarded<&oil_viscosity>(
      in, [&] { return Viscosity{in.mu_ref_pa_s * std::exp(-in.beta_per_c * (in.temp_c - in.t_ref_c))}; });
}

Serviceable bearing_serviceable(const Service& in) {
  return guarded<&bearing_serviceable>(
      in, [&] { return Serviceable{in.h_min_um >= in.h_allow_um && in.outlet_c <= in.t_allow_c ? 1 : 0}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K210",
       .title = "Investigation of hydrostatic spindle bearings with an adaptive supply system",
       .authors = "Ponomarenko O. V., Kucherenko N. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011, "
                    "pp. 195-198",
       .models =
           "A radial multi-pocket hydrostatic bearing of a heavy lathe spindle whose pocket pressures "
           "follow the measured position of the spindle: displacement under load, stiffness, the load it "
           "can centre, flow and heat.",
       .role = "dynamics",
       .errata = {}});
  constexpr auto completion = Provenance::completion;
  const auto bearing = [](auto& f) {
    f.optional(&Bearing::diameter_mm, "diameter_mm", "D", "mm", positive(), "journal diameter")
        .optional(&Bearing::length_mm, "length_mm", "L", "mm", positive(), "bearing length")
        .optional(&Bearing::pockets, "pockets", "N", "1", at_least(3), "pockets")
        .optional(&Bearing::pocket_length_mm, "pocket_length_mm", "l_p", "mm", positive(),
                  "axial length of a pocket, below the bearing length")
        .optional(&Bearing::pocket_width_mm, "pocket_width_mm", "w_p", "mm", positive(),
                  "circumferential width of a pocket, below the pocket pitch")
        .optional(&Bearing::radial_clearance_um, "radial_clearance_um", "c", "um", positive(),
                  "radial clearance")
        .optional(&Bearing::viscosity_pa_s, "viscosity_pa_s", "mu", "Pa*s", positive(), "viscosity")
        .optional(&Bearing::supply_pressure_mpa, "supply_pressure_mpa", "p_s", "MPa", positive(),
                  "supply pressure, gauge")
        .optional(&Bearing::pressure_ratio, "pressure_ratio", "beta", "1", open(0, 1),
                  "centred pocket pressure over supply pressure")
        .optional(&Bearing::spindle_rpm, "spindle_rpm", "n", "rpm", any(),
                  "spindle speed, counterclockwise positive")
        .optional(&Bearing::feedback_gain, "feedback_gain", "K", "1", non_negative(),
                  "gain of the regulators, 0 = plain capillaries")
        .optional(&Bearing::conductance_max, "conductance_max", "G_max", "1", at_least(1),
                  "opening limit of a regulator relative to the centred setting");
  };
  const std::string film_note = "Cavitation is not modelled: a pocket pressure below 0 is outside validity.";

  source
      .function<&required_machine_error>(
          "required_machine_error", "Machine error that a part tolerance demands.", "text", Provenance::paper)
      .input(&PartTolerance::part_tolerance_um, "part_tolerance_um", "-", "um", positive(),
             "tightest tolerance of the part", 30.0)
      .output(&MachineError::strict_um, "strict_um", "-", "um", positive(), "a fifth of the tolerance")
      .output(&MachineError::loose_um, "loose_um", "-", "um", positive(), "a third of the tolerance");
  source
      .function<&pocket_state>("pocket_state", "Pressures, flow and force at a displacement.", "completion",
                               completion)
      .input(&Displacement::ex_um, "ex_um", "e_x", "um", any(), "displacement, below the clearance", 5.0)
      .input(&Displacement::ey_um, "ey_um", "e_y", "um", any(), "displacement, below the clearance", -8.0)
      .with(bearing)
      .output(&PocketState::p_mpa, "p_mpa", "p_i", "MPa", any(), "pocket pressures")
      .output(&PocketState::flow_l_min, "flow_l_min", "Q", "l/min", any(), "flow")
      .output(&PocketState::fx_n, "fx_n", "F_x", "N", any(), "film force on the shaft")
      .output(&PocketState::fy_n, "fy_n", "F_y", "N", any(), "film force on the shaft")
      .note(film_note);
  source
      .function<&shaft_equilibrium>("shaft_equilibrium", "Displacement of the shaft under a load.",
                                    "completion", completion)
      .input(&Load::load_x_n, "load_x_n", "W_x", "N", any(), "load", 5000.0)
      .input(&Load::load_y_n, "load_y_n", "W_y", "N", any(), "load", 0.0)
      .with(bearing)
      .output(&Equilibrium::ex_um, "ex_um", "e_x", "um", any(), "displacement")
      .output(&Equilibrium::ey_um, "ey_um", "e_y", "um", any(), "displacement")
      .output(&Equilibrium::eccentricity_um, "eccentricity_um", "e", "um", non_negative(), "eccentricity")
      .output(&Equilibrium::h_min_um, "h_min_um", "h_min", "um", positive(), "least film thickness")
      .output(&Equilibrium::p_max_mpa, "p_max_mpa", "p_max", "MPa", any(), "largest pocket pressure")
      .output(&Equilibrium::p_min_mpa, "p_min_mpa", "p_min", "MPa", any(), "smallest pocket pressure")
      .output(&Equilibrium::flow_l_min, "flow_l_min", "Q", "l/min", any(), "flow")
      .note(film_note);
  source
      .function<&static_stiffness>("static_stiffness", "Stiffness of the centred bearing.", "completion",
                                   completion)
      .with(bearing)
      .output(&Stiffness::k_direct_n_um, "k_direct_n_um", "k_xx", "N/um", any(), "-dFx/dx")
      .output(&Stiffness::k_cross_n_um, "k_cross_n_um", "k_yx", "N/um", any(), "-dFy/dx");
  source
      .function<&centring_load_capacity>(
          "centring_load_capacity", "Largest load carried without displacement.", "completion", completion)
      .with(bearing)
      .output(&CentringLoad::load_n, "load_n", "W", "N", any(), "load towards pocket 0")
      .note("Without rotation; feedback_gain and spindle_rpm are not used.");
  source
      .function<&bearing_losses>("bearing_losses", "Friction, pump power and temperature rise.", "completion",
                                 completion)
      .input(&LossInputs::flow_l_min, "flow_l_min", "Q", "l/min", positive(), "flow", 0.261)
      .optional(&LossInputs::specific_heat_j_kgk, "specific_heat_j_kgk", "c_p", "J/(kg*K)", positive(),
                "specific heat of the oil")
      .optional(&LossInputs::density_kg_m3, "density_kg_m3", "rho", "kg/m3", positive(), "density of the oil")
      .optional(&LossInputs::inlet_c, "inlet_c", "T_0", "degC", at_least(-273.15), "inlet temperature")
      .with(bearing)
      .output(&Losses::friction_kw, "friction_kw", "P_f", "kW", non_negative(), "friction on the lands")
      .output(&Losses::pump_kw, "pump_kw", "P_p", "kW", positive(), "pump power")
      .output(&Losses::temp_rise_c, "temp_rise_c", "Delta T", "K", positive(), "temperature rise")
      .output(&Losses::outlet_c, "outlet_c", "T", "degC", any(), "outlet temperature")
      .note("Viscosity as given, no iteration with the temperature.");
  source
      .function<&oil_viscosity>("oil_viscosity", "Viscosity at a temperature.", "completion (Reynolds)",
                                completion)
      .input(&OilInputs::temp_c, "temp_c", "T", "degC", at_least(-273.15), "temperature", 40.0)
      .optional(&OilInputs::mu_ref_pa_s, "mu_ref_pa_s", "mu_0", "Pa*s", positive(), "reference viscosity")
      .optional(&OilInputs::t_ref_c, "t_ref_c", "T_0", "degC", at_least(-273.15), "reference temperature")
      .optional(&OilInputs::beta_per_c, "beta_per_c", "beta_T", "1/K", non_negative(),
                "temperature coefficient")
      .output(&Viscosity::mu_pa_s, "mu_pa_s", "mu", "Pa*s", non_negative(), "viscosity");
  source
      .function<&bearing_serviceable>("bearing_serviceable", "Whether film and temperature allow service.",
                                      "text", Provenance::paper)
      .input(&Service::h_min_um, "h_min_um", "h_min", "um", any(), "least film thickness", 25.0)
      .input(&Service::outlet_c, "outlet_c", "T", "degC", any(), "outlet temperature", 50.0)
      .input(&Service::h_allow_um, "h_allow_um", "-", "um", any(), "least allowed film", 20.0)
      .input(&Service::t_allow_c, "t_allow_c", "-", "degC", any(), "highest allowed temperature", 60.0)
      .output(&Serviceable::ok, "ok", "-", "-", closed(0, 1), "the bearing may serve")
      .note("The paper names the highest temperature; the outlet temperature in its place is a completion.");
}

}  // namespace verstat::models::k210
