#pragma once
// Milling of T-slots and other profile slots (K105): chips that do not get out are cut again. Shares of chips
// by what happened to them, the added force, the kinematics of a pass, recirculation, and the form error of
// the slot.
//
// Nechepaev, Gnitko, Myshov 2011. The paper prints no equation; verbal statements are turned into formulas
// and (C1)-(C4) are completions.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k105 {

struct ChipCounts {
  std::int64_t untouched = 0;   // 1: no plastic deformation visible
  std::int64_t section = 0;     // 2: cross-section deformed
  std::int64_t lengthwise = 0;  // 3: longitudinal or combined
  std::int64_t broken = 0;      // 4: broken up
};
struct ChipShares {
  std::int64_t total;
  double untouched;
  double section;
  double lengthwise;
  double broken;
  double reinteraction;
};
/// Shares of the four groups and of chips that met the tool again, 1 - N_1/N (a lower bound).
[[nodiscard]] ChipShares chip_group_shares(const ChipCounts& in);

struct ChipGroup {
  std::int64_t group = 1;
};
struct ChipDimensions {
  double length_mm;
  double diameter_mm;
  double thickness_mm;
};
/// Mean chip sizes of groups 1 to 3 (Table 1).
[[nodiscard]] ChipDimensions chip_dimensions(const ChipGroup& in);

struct AddedForceInputs {
  double lateral_force_n = 0;
  double added_share = 0;  // 0..0.25
};
struct AddedForce {
  double added_n;
  double total_n;
};
/// Force added by repeated cutting of chips, P_add = k P_v, k <= 0.25.
[[nodiscard]] AddedForce repeated_chip_force(const AddedForceInputs& in);

struct SlotInputs {
  double cutter_diameter_mm = 0;
  double throat_width_mm = 0;
};
struct SlotEngagement {
  double throat_idle_deg;
  double rear_idle_deg;
  double cut_each_deg;
  double cutting_fraction;
};
/// Arcs of a revolution in a T-slot whose throat of width b is already milled. COMPLETION (C1).
[[nodiscard]] SlotEngagement t_slot_engagement(const SlotInputs& in);

struct PassInputs {
  double cutter_diameter_mm = 0;
  double spindle_speed_rpm = 0;
  double table_feed_mm_min = 0;
  double length_mm = 0;
  std::int64_t teeth = 0;
};
struct Pass {
  double cutting_speed_m_min;
  double feed_mm_tooth;
  double time_min;
  double chips;  // expected, not rounded: two per tooth per revolution
};
/// Kinematics of one pass. COMPLETION (C2).
[[nodiscard]] Pass t_slot_pass(const PassInputs& in);

struct RecirculationInputs {
  double escape_probability = 0;
  std::int64_t recuts = 0;
};
struct Recirculation {
  double p_exactly_k;
  double mean_recuts;
  double mean_resident_chips;  // per tooth pocket
};
/// Re-cuts of a chip with one escape trial per idle arc, P(k) = q (1 - q)^k. COMPLETION (C3).
[[nodiscard]] Recirculation chip_recirculation(const RecirculationInputs& in);

struct FormErrorInputs {
  double lateral_force_n = 0;
  double added_share = 0;
  double overhang_mm = 0;
  double stem_diameter_mm = 0;
  double cutter_diameter_mm = 0;
  double elastic_modulus_mpa = 0;
};
struct FormError {
  double side_um;
  double tilt_deg;
  double face_um;
};
/// Lateral shift, tilt and axial rise of the rim of a cutter on a cantilever stem. COMPLETION (C4).
[[nodiscard]] FormError t_slot_form_error(const FormErrorInputs& in);

}  // namespace verstat::models::k105
