#pragma once
// Drilling of steel with twist drills by handbook laws, and power laws fitted to a table of simulated or
// measured runs, with how far they agree with a reference (K410).
//
// Globa, Kulbachnyi 2011 print no equations; the laws are those of the handbook they cite.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k410 {

struct DrillRotation {
  double diameter_mm = 0;
  double spindle_rpm = 0;
};
struct CuttingSpeed {
  double speed_m_min;
};
/// pi D n / 1000.
[[nodiscard]] CuttingSpeed cutting_speed(const DrillRotation& in);

struct Drilling {
  double diameter_mm = 0;
  double feed_mm_rev = 0;
  double spindle_rpm = 0;
  double strength_mpa = 750;
  double thrust_coefficient = 68;
  double thrust_diameter_exponent = 1.0;
  double thrust_feed_exponent = 0.7;
  double torque_coefficient = 0.0345;
  double torque_diameter_exponent = 2.0;
  double torque_feed_exponent = 0.8;
  double material_exponent = 0.75;
};
struct DrillingLoads {
  double material_factor;
  double thrust_n;
  double torque_nm;
  double power_kw;
};
/// Thrust, torque and power of a twist drill in structural steel. COMPLETION.
[[nodiscard]] DrillingLoads drilling_loads(const Drilling& in);

struct DrillLife {
  double diameter_mm = 0;
  double feed_mm_rev = 0;
  double life_min = 0;
  double speed_factor = 1;
};
struct HandbookSpeed {
  double speed_m_min, spindle_rpm;
};
/// Speed for a drill life; 0.2 mm/rev belongs to the first line. COMPLETION.
[[nodiscard]] HandbookSpeed drilling_handbook_speed(const DrillLife& in);

struct DrilledHole {
  double diameter_mm = 0;
  double depth_mm = 0;
  double point_angle_deg = 118;
  double approach_mm = 0;
  double overrun_mm = 0;
  double spindle_rpm = 0;
  double feed_mm_rev = 0;
  bool through = false;
};
struct DrillingTime {
  double cone_mm, path_mm, main_time_min;
};
/// Path and main time; the depth of a blind hole reaches to the drill tip. COMPLETION.
[[nodiscard]] DrillingTime drilling_main_time(const DrilledHole& in);

struct Runs {
  std::vector<std::vector<double>> factors;
  std::vector<double> response;
};
struct PowerLawFit {
  double coefficient;
  std::vector<double> exponents;
  double rms_log_error;
  double max_relative_error;
};
/// y = C prod x_j^e_j by least squares of the logarithms. COMPLETION.
[[nodiscard]] PowerLawFit fit_power_law(const Runs& in);

struct PowerLaw {
  double coefficient = 1;
  std::vector<double> exponents;
  std::vector<double> x;
};
struct PowerLawValue {
  double value;
};
/// C prod x_j^e_j. COMPLETION.
[[nodiscard]] PowerLawValue power_law_value(const PowerLaw& in);

struct Comparison {
  std::vector<double> model, reference;
};
struct Agreement {
  double mean_relative_error;
  double max_abs_relative_error;
  double scale;
};
/// Errors model/reference - 1 and the factor that makes the geometric mean agree. COMPLETION.
[[nodiscard]] Agreement model_agreement(const Comparison& in);

}  // namespace verstat::models::k410
