#pragma once
// The spindle of a machine as its dynamics see it: bearings that resonate parametrically (K201), a spindle in
// a sleeve on an elastic base (K206), a hydrostatic bearing (K210), a grinding wheel that sits eccentrically
// (K209), the holder of an axial tool (K408). Each part is optional and adds its own to the plans of the
// operations done on the machine: forbidden speed bands, the stable width of cut, terms of form error.

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace verstat::models::k209 {
enum class Mounting;
}

namespace verstat::operations {

struct CutPlan;

/// Angular-contact bearings whose stiffness varies as the cage turns, K201. Between the nodes the natural
/// frequency and the modulation are linear in speed, outside constant.
struct BearingResonance {
  double ball_diameter_mm = 3.17;
  double pitch_diameter_mm = 41;
  double contact_angle_deg = 15;
  std::int64_t harmonic = 4;  ///< of the cage speed
  double damping_ratio = 0.02;
  std::vector<double> speed_nodes_rpm;
  std::vector<double> natural_frequency_hz;  ///< of the ring, one per node
  std::vector<double> stiffness_ratio;       ///< amplitude over mean stiffness, one per node
  double speed_step_rpm = 20;                ///< a band narrower than this can be missed
};

/// Spindle and sleeve as rods joined by bearings, the sleeve on springs, K206. The nose is section 0.
struct ElasticBase {
  std::vector<double> spindle_length_mm;
  std::vector<double> spindle_outer_mm;
  std::vector<double> spindle_inner_mm;
  std::vector<double> sleeve_length_mm;
  std::vector<double> sleeve_outer_mm;
  std::vector<double> sleeve_inner_mm;
  std::vector<std::int64_t> bearing_section;
  std::vector<double> bearing_k_n_um;
  std::vector<std::int64_t> support_section;
  std::vector<double> support_k_n_um;
  double modulus_gpa = 210;
  double density_kg_m3 = 7850;
  std::int64_t modes = 3;         ///< that are looked at
  double loss_factor = 0.03;      ///< of rods and springs
  double resonance_margin = 0.1;  ///< half width of a band over its frequency
  double orientation_factor = 1;  ///< of the cutting force to the mode, for the stable width
};

/// K210. Defaults: the bearing of the paper.
struct HydrostaticSupport {
  double diameter_mm = 175;
  double length_mm = 245;
  std::int64_t pockets = 5;
  double pocket_length_mm = 180;
  double pocket_width_mm = 90;
  double radial_clearance_um = 60;
  double viscosity_pa_s = 0.28;
  double supply_pressure_mpa = 4;
  double pressure_ratio = 0.5;
  double feedback_gain = 0;  ///< 0: plain capillaries
  double conductance_max = 10;
  double inlet_c = 22;
  std::optional<double> film_min_um;
  std::optional<double> outlet_max_c;
};

/// How the grinding wheel sits on the spindle, K209.
struct WheelSeat {
  models::k209::Mounting mounting = {};  ///< standard flange
  std::optional<double> amplitude_um;    ///< of the first harmonic; not given: as measured for the mounting
  std::optional<double> waviness_max_um;
};

/// End of an axial tool in the machine, K408.
enum class ToolHolder { rigid, rocking, floating };

/// What the rods and bearings give whatever the operation.
struct SpindleDynamics {
  struct Band {
    double low_rpm, high_rpm;
  };
  std::vector<Band> parametric;    ///< K201
  std::vector<double> natural_hz;  ///< K206, ascending
  double least_real_um_n = 0;      ///< most negative real part of the compliance at the nose; 0: none found
  double static_um_n = 0;          ///< compliance at the nose at rest
};

/// Computed when first asked for, again when a number has moved, and copied with its owner; safe to ask from
/// many threads.
class DynamicsMemo {
 public:
  DynamicsMemo() = default;
  DynamicsMemo(const DynamicsMemo& other) { *this = other; }
  DynamicsMemo& operator=(const DynamicsMemo& other);
  ~DynamicsMemo() = default;

 private:
  friend struct Spindle;
  struct Entry {
    std::vector<double> key;
    SpindleDynamics dynamics;
  };
  [[nodiscard]] std::shared_ptr<const Entry> get() const;
  void set(std::shared_ptr<const Entry> entry);
  mutable std::mutex mutex_;
  std::shared_ptr<const Entry> entry_;
};

struct Spindle {
  double speed_min_rpm = 0;
  double speed_max_rpm = 0;
  std::optional<BearingResonance> bearings;
  std::optional<ElasticBase> elastic_base;
  std::optional<HydrostaticSupport> hydrostatic;
  std::optional<WheelSeat> wheel;
  ToolHolder holder = ToolHolder::rigid;
  std::optional<double> bearing_bore_mm;       ///< limits the speed by d n = 2.4e6 mm/min, K206
  std::optional<double> machine_error_max_um;  ///< bound on the form error that the spindle adds

  /// Bands, natural frequencies and compliances of the parts that are given; costs milliseconds once.
  /// Throws models::ModelError or models::DomainError for a spindle that the models refuse.
  [[nodiscard]] SpindleDynamics dynamics() const;

 private:
  [[nodiscard]] std::vector<double> key() const;
  mutable DynamicsMemo memo_;
};

/// The sources behind it, as a kind names its own.
inline constexpr std::array spindle_sources{"K201", "K206", "K209", "K210"};
inline constexpr std::array safety_clutch_sources{"K204"};

/// Adds to the plan what the spindle does to the operation, as far as plan.spindle tells.
void add_spindle(CutPlan& plan, const Spindle& spindle);

}  // namespace verstat::operations
