#pragma once
// Magneto-abrasive treatment of high-speed-steel drills in a ring bath with six powder charges (K103): edge
// radius, roughness, hardness and life of a treated drill, time and cost of the treatment.
//
// Maiboroda, Anisimova 2011. No equations; the bar charts are lost, only the numbers of the text remain.

#include <array>
#include <cstdint>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k103 {

enum class Powder {
  polimam_m,
  tsaramam,
  pr_r6m5,
  polimam_t,
  polimam_m_plus_5_polimam_t,  // 5 % finer Polimam-T
  polimam_t_plus_10_pr_r6m5    // 10 % finer PR R6M5, the recommended charge
};
enum class GrainShape { rounded, splintered, non_equiaxed, mixture };
enum class RoundsEdge { yes, no, unknown };

struct PowderChoice {
  Powder powder = Powder::polimam_t_plus_10_pr_r6m5;
};
struct PowderClass {
  GrainShape shape;
  RoundsEdge rounds_edge;
  bool top_drilling_speed;
};
/// What the paper says of a charge: grain shape, whether it rounds edges, whether its drills were among the
/// fastest under constant thrust. K103, discussion of the figures.
[[nodiscard]] PowderClass mat_powder_class(const PowderChoice& in);

struct TreatedDrill {
  Powder powder = Powder::polimam_t_plus_10_pr_r6m5;
  double hardness_before_gpa = 0;
};
struct TreatmentEffect {
  double ra_after_max_um;
  double hardness_after_min_gpa;
  double edge_radius_min_um;
  double edge_radius_max_um;
  double life_factor_min;
  double life_factor_typical;
};
/// Result of the treatment with the recommended charge. K103, conclusions (Ra < 0.12 um, hardness + more than
/// 12 %, edge radius 15-20 um) and introduction (life at least x1.8-2). Error for the other charges: no data.
[[nodiscard]] TreatmentEffect mat_treatment_effect(const TreatedDrill& in);

struct TreatmentCourse {
  double time_s = 0;
  double ra_before_um = 0.435;         // middle of 0.40-0.47
  double ra_180_um = 0.12;             // printed bound
  double edge_radius_before_um = 8.5;  // middle of 8-9
  double edge_radius_180_um = 17.5;    // middle of 15-20
};
struct TreatedSurface {
  double ra_um;
  double edge_radius_um;
};
/// Roughness and edge radius after 0..300 s, from the states at 0 and 180 s: Ra geometric up to 180 s and
/// constant after, radius linear. K103 (C1), COMPLETION.
[[nodiscard]] TreatedSurface mat_surface_kinetics(const TreatmentCourse& in);

struct EdgeTarget {
  double target_um = 0;
  double edge_radius_before_um = 8.5;
  double edge_radius_180_um = 17.5;
};
struct TreatmentTime {
  double time_s;
};
/// Time to an edge radius, 0 when already reached. Inverse of (C1). Error above the radius at 300 s, or when
/// the radius does not grow.
[[nodiscard]] TreatmentTime mat_time_for_edge_radius(const EdgeTarget& in);

struct UntreatedLife {
  double scale_min = 0;
  double shape = 0;
  double life_factor = 1.8;
};
struct TreatedLife {
  double scale_min;
  double shape;
  double mean_min;
};
/// Weibull life of a treated drill: the scale times the life factor, the shape kept. K103 (C2), COMPLETION.
[[nodiscard]] TreatedLife mat_weibull_life(const UntreatedLife& in);

struct Batch {
  std::int64_t size = 1;
  double cycle_s = 180;
  double handling_s = 60;
};
struct TimePerTool {
  double time_min;
};
/// Time per tool, (cycle + handling)/(60 batch), handling per batch. K103 (C3), COMPLETION.
[[nodiscard]] TimePerTool mat_batch_time(const Batch& in);

struct ToolCost {
  double tool_cost = 0;
  double life_factor = 1.8;
};
struct BreakEven {
  double max_treatment_cost;
};
/// Treatment cost per tool life below which the cost per unit of life falls, (k - 1) C; negative for a factor
/// below 1. K103 (C4), COMPLETION; saved tool changes are not counted.
[[nodiscard]] BreakEven mat_break_even_cost(const ToolCost& in);

struct ThrustTest {
  double rate_mm_min = 0;
  double reference_rate_mm_min = 0;
  double speed_rpm = 880;
  double drill_diameter_mm = 6.8;
};
struct ThrustTestResult {
  double feed_mm_rev;
  double relative_performance;
  double cutting_speed_m_min;
};
/// Evaluation of a drilling test at constant thrust against a reference drill. K103 (E1), from the
/// description of the test (520 N, 880 rpm, diameter 6.8 mm).
[[nodiscard]] ThrustTestResult constant_thrust_test(const ThrustTest& in);

}  // namespace verstat::models::k103

template <>
struct verstat::models::EnumNames<verstat::models::k103::Powder> {
  static constexpr std::array names{
      std::pair{k103::Powder::polimam_m, "polimam_m"},
      std::pair{k103::Powder::tsaramam, "tsaramam"},
      std::pair{k103::Powder::pr_r6m5, "pr_r6m5"},
      std::pair{k103::Powder::polimam_t, "polimam_t"},
      std::pair{k103::Powder::polimam_m_plus_5_polimam_t, "polimam_m_plus_5_polimam_t"},
      std::pair{k103::Powder::polimam_t_plus_10_pr_r6m5, "polimam_t_plus_10_pr_r6m5"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k103::GrainShape> {
  static constexpr std::array names{std::pair{k103::GrainShape::rounded, "rounded"},
                                    std::pair{k103::GrainShape::splintered, "splintered"},
                                    std::pair{k103::GrainShape::non_equiaxed, "non_equiaxed"},
                                    std::pair{k103::GrainShape::mixture, "mixture"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k103::RoundsEdge> {
  static constexpr std::array names{std::pair{k103::RoundsEdge::yes, "yes"},
                                    std::pair{k103::RoundsEdge::no, "no"},
                                    std::pair{k103::RoundsEdge::unknown, "unknown"}};
};
