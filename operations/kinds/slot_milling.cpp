#include "operations/kinds/slot_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/milling/k105_tslot_chip_reinteraction.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::SlotMilling> {
  static std::vector<Field> fields() {
    using S = operations::SlotMilling;
    return {
        need<S>(&S::cutter_diameter_mm, "cutter_diameter_mm", "mm", open_low(0, 500), "cutter diameter D"),
        need<S>(&S::throat_width_mm, "throat_width_mm", "mm", open_low(0, 500),
                "width of the throat milled before, below the cutter diameter"),
        need<S>(&S::head_height_mm, "head_height_mm", "mm", open_low(0, 500),
                "height of the cutter head: width of cut of a tooth"),
        need<S>(&S::stem_diameter_mm, "stem_diameter_mm", "mm", open_low(0, 500),
                "diameter of the stem, below the throat width"),
        need<S>(&S::overhang_mm, "overhang_mm", "mm", open_low(0, 2000), "overhang of the stem"),
        may<S>(&S::elastic_modulus_mpa, "elastic_modulus_mpa", "MPa", closed(1e4, 1e6),
               "elastic modulus of the stem"),
        may<S>(&S::teeth, "teeth", "1", closed(1, 100), "number of teeth"),
        need<S>(&S::spindle_speed_rpm, "spindle_speed_rpm", "rpm", open_low(0, 1e5), "spindle speed"),
        need<S>(&S::table_feed_mm_min, "table_feed_mm_min", "mm/min", open_low(0, 1e5), "table feed"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e5), "length of a slot"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1e4), "approach and overrun at table feed"),
        may<S>(&S::slots, "slots", "1", closed(1, 1000), "slots of this kind on a part"),
        need<S>(&S::kc11_mpa, "kc11_mpa", "MPa", open_low(0, 1e5),
                "specific cutting force at 1 mm chip thickness"),
        may<S>(&S::mc, "mc", "1", closed(0, 0.9), "exponent of the specific cutting force"),
        may<S>(&S::lateral_force_n, "lateral_force_n", "N", closed(0, 1e6),
               "measured force across the slot without re-cut chips; estimated when not given"),
        may<S>(&S::reinteraction_share, "reinteraction_share", "1", closed(0, 1),
               "share of the chips that meet the tool again without a device"),
        may<S>(&S::evacuation, "evacuation", "-", no_range(), "equipment that takes the chips out"),
        may<S>(&S::evacuation_efficiency, "evacuation_efficiency", "1", closed(0, 1),
               "share of the re-interacting chips that the device takes out"),
        may<S>(&S::side_error_max_um, "side_error_max_um", "um", above(0),
               "largest lateral shift of the slot"),
        may<S>(&S::face_error_max_um, "face_error_max_um", "um", above(0),
               "largest axial error of the slot face")};
  }
};

namespace verstat::operations {

namespace k105 = models::k105;

namespace {

// The paper's share and added force of a slot without a device.
constexpr double share_of_paper = 0.63;
constexpr double added_of_paper = 0.25;

// One tooth where its chip is thickest, at the edge of the throat; the tangential force has this part across
// the slot.
struct ToothForce {
  double tangential_n;
  double lateral_n;
};

ToothForce heaviest_tooth(const SlotMilling& spec, double feed_per_tooth_mm) {
  const double throat = spec.throat_width_mm / spec.cutter_diameter_mm;
  const double sine = std::sqrt(1 - throat * throat);
  const double chip_mm = feed_per_tooth_mm * sine;
  const double tangential_n = kienzle_n_mm2(spec.kc11_mpa, spec.mc, chip_mm) * chip_mm * spec.head_height_mm;
  return {tangential_n, tangential_n * sine};
}

}  // namespace

CutPlan plan(const SlotMilling& spec, const PlanContext& context) {
  models::require(spec.throat_width_mm < spec.cutter_diameter_mm, "throat_width_mm", spec.throat_width_mm,
                  "must be below the cutter diameter");
  models::require(spec.stem_diameter_mm < spec.throat_width_mm, "stem_diameter_mm", spec.stem_diameter_mm,
                  "must be below the throat width: the stem runs in the throat");

  k105::PassInputs pass;
  pass.cutter_diameter_mm = spec.cutter_diameter_mm;
  pass.spindle_speed_rpm = spec.spindle_speed_rpm;
  pass.table_feed_mm_min = spec.table_feed_mm_min;
  pass.length_mm = spec.length_mm;
  pass.teeth = spec.teeth;
  const k105::Pass run = k105::t_slot_pass(pass);
  const k105::SlotEngagement arcs = k105::t_slot_engagement({spec.cutter_diameter_mm, spec.throat_width_mm});

  const double kept = spec.evacuation == ChipEvacuation::device ? 1 - spec.evacuation_efficiency : 1;
  const double share = spec.reinteraction_share * kept;
  const double added_share = std::min(added_of_paper, added_of_paper * share / share_of_paper);
  const ToothForce tooth = heaviest_tooth(spec, run.feed_mm_tooth);
  const double lateral_n = spec.lateral_force_n.value_or(tooth.lateral_n);
  const k105::AddedForce force = k105::repeated_chip_force({lateral_n, added_share});

  k105::FormErrorInputs bending;
  bending.lateral_force_n = lateral_n;
  bending.added_share = added_share;
  bending.overhang_mm = spec.overhang_mm;
  bending.stem_diameter_mm = spec.stem_diameter_mm;
  bending.cutter_diameter_mm = spec.cutter_diameter_mm;
  bending.elastic_modulus_mpa = spec.elastic_modulus_mpa;
  const k105::FormError error = k105::t_slot_form_error(bending);

  CutPlan p;
  p.quantities.reserve(20);
  const double slots = static_cast<double>(spec.slots);
  p.set_main_time(slots * (run.time_min + spec.approach_mm / spec.table_feed_mm_min), "K105.t_slot_pass");
  p.quantities.push_back(
      {"cutting_speed_m_min", run.cutting_speed_m_min, "m/min", "K105.t_slot_pass", "cutting speed"});
  p.quantities.push_back(
      {"feed_per_tooth_mm", run.feed_mm_tooth, "mm", "K105.t_slot_pass", "feed per tooth"});
  p.quantities.push_back(
      {"cutting_fraction", arcs.cutting_fraction, "1", "K105.t_slot_engagement", "share of a turn in cut"});
  p.quantities.push_back({"chips", slots * run.chips, "1", "K105.t_slot_pass", "chips of one part"});
  p.quantities.push_back({"reinteraction_share", share, "1", "K105.chip_group_shares",
                          "share of the chips that meet the tool again"});
  if (share < 1)
    p.quantities.push_back({"mean_recuts", k105::chip_recirculation({1 - share, 0}).mean_recuts, "1",
                            "K105.chip_recirculation", "mean number of times that a chip is cut again"});
  p.quantities.push_back({"lateral_force_n", lateral_n, "N",
                          spec.lateral_force_n ? "given" : "COMPLETION: Kienzle, heaviest tooth",
                          "force across the slot without re-cut chips"});
  p.quantities.push_back({"added_share", added_share, "1", "COMPLETION: 0.25 p/0.63, at most 0.25",
                          "force added by re-cut chips over the lateral force"});
  p.quantities.push_back(
      {"added_force_n", force.added_n, "N", "K105.repeated_chip_force", "force added by re-cut chips"});
  p.quantities.push_back(
      {"total_lateral_force_n", force.total_n, "N", "K105.repeated_chip_force", "force that bends the stem"});
  p.quantities.push_back(
      {"side_error_um", error.side_um, "um", "K105.t_slot_form_error", "lateral shift of the slot"});
  p.quantities.push_back({"tilt_deg", error.tilt_deg, "deg", "K105.t_slot_form_error", "tilt of the head"});
  p.quantities.push_back(
      {"face_error_um", error.face_um, "um", "K105.t_slot_form_error", "axial rise of the rim"});

  const double tangential_n = tooth.tangential_n * (1 + added_share);
  // Both cutting arcs hold a tooth at the same time only by chance: teeth in cut on average, at least one.
  const double in_cut = std::max(1.0, arcs.cutting_fraction * static_cast<double>(spec.teeth));
  p.spindle.teeth = spec.teeth;
  p.spindle.normal_force_n = force.total_n;
  MachineLoad load;
  load.spindle_speed_rpm = spec.spindle_speed_rpm;
  load.feed_rate_mm_min = spec.table_feed_mm_min;
  load.torque_nm = tangential_n * in_cut * spec.cutter_diameter_mm / 2000;
  load.power_kw = *load.torque_nm * spec.spindle_speed_rpm * std::numbers::pi / 30'000;
  p.quantities.push_back({"torque_nm", *load.torque_nm, "N m", "COMPLETION: Kienzle, heaviest tooth",
                          "torque with the mean number of teeth in cut, upper estimate"});
  p.quantities.push_back({"cutting_power_kw", *load.power_kw, "kW", "COMPLETION: Kienzle, heaviest tooth",
                          "cutting power, upper estimate"});

  if (spec.side_error_max_um)
    p.limits.push_back(
        {"side_error_um", error.side_um, *spec.side_error_max_um, true, "um", "K105.t_slot_form_error"});
  if (spec.face_error_max_um)
    p.limits.push_back(
        {"face_error_um", error.face_um, *spec.face_error_max_um, true, "um", "K105.t_slot_form_error"});
  add_machine_limits(p, context, load);
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, run.cutting_speed_m_min, run.feed_mm_tooth, spec.head_height_mm);
  return p;
}

namespace slot_milling {
void add_to(Kinds& kinds) {
  kinds.add<SlotMilling>("A T-slot milled in one pass; chips that stay in it are cut again.", {"K105"});
}
}  // namespace slot_milling

}  // namespace verstat::operations
