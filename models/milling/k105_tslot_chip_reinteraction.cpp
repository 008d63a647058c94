#include "models/milling/k105_tslot_chip_reinteraction.h"

#include <cmath>
#include <numbers>

#include "models/math/trig_degrees.h"

namespace verstat::models::k105 {

ChipShares chip_group_shares(const ChipCounts& in) {
  return guarded<&chip_group_shares>(in, [&] {
    const double all = static_cast<double>(in.untouched) + static_cast<double>(in.section) +
                       static_cast<double>(in.lengthwise) + static_cast<double>(in.broken);
    require(all > 0, "n1", in.untouched, "at least one of n1 to n4 must be above 0");
    const auto share = [all](std::int64_t n) { return static_cast<double>(n) / all; };
    return ChipShares{.total = in.untouched + in.section + in.lengthwise + in.broken,
                      .untouched = share(in.untouched),
                      .section = share(in.section),
                      .lengthwise = share(in.lengthwise),
                      .broken = share(in.broken),
                      .reinteraction = 1 - share(in.untouched)};
  });
}

ChipDimensions chip_dimensions(const ChipGroup& in) {
  return guarded<&chip_dimensions>(in, [&] {
    switch (in.group) {
      case 1:
        return ChipDimensions{6, 2.5, 0.38};
      case 2:
        return ChipDimensions{6, 2.5, 0.46};
      default:
        return ChipDimensions{5.8, 2.0, 0.52};  // the range admits 1 to 3
    }
  });
}

AddedForce repeated_chip_force(const AddedForceInputs& in) {
  return guarded<&repeated_chip_force>(in, [&] {
    const double added_n = in.added_share * in.lateral_force_n;
    return AddedForce{added_n, in.lateral_force_n + added_n};
  });
}

SlotEngagement t_slot_engagement(const SlotInputs& in) {
  return guarded<&t_slot_engagement>(in, [&] {
    require(in.throat_width_mm < in.cutter_diameter_mm, "throat_width", in.throat_width_mm,
            "must be below d_cutter");
    const double half_deg = to_degrees(std::asin(in.throat_width_mm / in.cutter_diameter_mm));
    return SlotEngagement{2 * half_deg, 180, 90 - half_deg, 2 * (90 - half_deg) / 360};
  });
}

Pass t_slot_pass(const PassInputs& in) {
  return guarded<&t_slot_pass>(in, [&] {
    const double z = static_cast<double>(in.teeth);
    const double time_min = in.length_mm / in.table_feed_mm_min;
    return Pass{std::numbers::pi * in.cutter_diameter_mm * in.spindle_speed_rpm / 1000,
                in.table_feed_mm_min / (in.spindle_speed_rpm * z), time_min,
                2 * in.spindle_speed_rpm * z * time_min};
  });
}

Recirculation chip_recirculation(const RecirculationInputs& in) {
  return guarded<&chip_recirculation>(in, [&] {
    const double q = in.escape_probability;
    const double mean = (1 - q) / q;
    return Recirculation{q * std::pow(1 - q, static_cast<double>(in.recuts)), mean, mean};
  });
}

FormError t_slot_form_error(const FormErrorInputs& in) {
  return guarded<&t_slot_form_error>(in, [&] {
    const double force_n = (1 + in.added_share) * in.lateral_force_n;
    const double rigidity_n_mm2 =
        in.elastic_modulus_mpa * std::numbers::pi * std::pow(in.stem_diameter_mm, 4) / 64;
    const double l = in.overhang_mm;
    const double tilt_rad = force_n * l * l / (2 * rigidity_n_mm2);
    return FormError{1000 * force_n * l * l * l / (3 * rigidity_n_mm2), to_degrees(tilt_rad),
                     1000 * in.cutter_diameter_mm / 2 * std::sin(tilt_rad)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K105",
       .title =
           "Analysis of the repeated interaction of steel chips with the tool when milling profile slots",
       .authors = "Nechepaev V. G., Gnitko A. N., Myshov M. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "In T-slots, dovetails and angular slots chips circulate with the cutter and are cut again: "
                 "what happens to them, the force they add (up to a quarter of the lateral force), the arcs "
                 "of a revolution, the chips of a pass, and the form error of the slot.",
       .role = "milling",
       .errata = {}});

  // Sums of four counts must stay whole numbers of a double.
  const Range count = closed(0, 1e15);
  source
      .function<&chip_group_shares>("chip_group_shares", "Shares of chips by what happened to them.",
                                    "Table 1 and text", Provenance::paper)
      .input(&ChipCounts::untouched, "n1", "N_1", "pcs", count, "chips not plastically deformed", 536)
      .input(&ChipCounts::section, "n2", "N_2", "pcs", count, "chips with a deformed cross-section", 203)
      .input(&ChipCounts::lengthwise, "n3", "N_3", "pcs", count, "chips deformed lengthwise or both ways",
             209)
      .input(&ChipCounts::broken, "n4", "N_4", "pcs", count, "chips broken up", 482)
      .output(&ChipShares::total, "total", "N", "pcs", at_least(1), "all chips")
      .output(&ChipShares::untouched, "share_1", "N_1/N", "1", probability(), "share not deformed")
      .output(&ChipShares::section, "share_2", "N_2/N", "1", probability(), "share with a deformed section")
      .output(&ChipShares::lengthwise, "share_3", "N_3/N", "1", probability(), "share deformed lengthwise")
      .output(&ChipShares::broken, "share_4", "N_4/N", "1", probability(), "share broken up")
      .output(&ChipShares::reinteraction, "reinteraction_share", "p", "1", probability(),
              "share that met the tool again, at least")
      .note(
          "A lower bound: group 1 also holds chips that met the tool elastically. Group 4 probably counts "
          "particles, not chips.");
  source
      .function<&chip_dimensions>("chip_dimensions", "Mean chip sizes of a group.", "Table 1",
                                  Provenance::paper)
      .input(&ChipGroup::group, "group", "-", "1", closed(1, 3),
             "group of chips; group 4, broken up, has no sizes", 1)
      .output(&ChipDimensions::length_mm, "length", "-", "mm", positive(), "length")
      .output(&ChipDimensions::diameter_mm, "diameter", "-", "mm", positive(), "diameter")
      .output(&ChipDimensions::thickness_mm, "thickness", "-", "mm", positive(), "thickness");
  source
      .function<&repeated_chip_force>("repeated_chip_force", "Force added by cutting chips again.", "text",
                                      Provenance::paper)
      .input(&AddedForceInputs::lateral_force_n, "p_v", "P_v", "N", non_negative(),
             "component normal to the feed in the cutter plane", 100.0)
      .input(&AddedForceInputs::added_share, "k_add", "k", "1", closed(0, 0.25),
             "added force over P_v; 0.25 is the paper's upper value", 0.25)
      .output(&AddedForce::added_n, "p_add", "P_add", "N", non_negative(), "added force")
      .output(&AddedForce::total_n, "p_total", "P_total", "N", non_negative(), "force with it")
      .note("How the added force depends on the amount of chips is unknown.");
  source
      .function<&t_slot_engagement>("t_slot_engagement", "Arcs of a revolution in a T-slot.", "eq. (C1)",
                                    Provenance::completion)
      .input(&SlotInputs::cutter_diameter_mm, "d_cutter", "D", "mm", positive(), "cutter diameter", 21.0)
      .input(&SlotInputs::throat_width_mm, "throat_width", "b", "mm", non_negative(),
             "width of the throat already milled, below d_cutter", 12.0)
      .output(&SlotEngagement::throat_idle_deg, "arc_throat_idle", "-", "deg", closed(0, 180),
              "idle arc in the throat")
      .output(&SlotEngagement::rear_idle_deg, "arc_rear_idle", "-", "deg", closed(180, 180),
              "idle arc of the rear half")
      .output(&SlotEngagement::cut_each_deg, "arc_cut_each", "-", "deg", closed(0, 90),
              "each of the two cutting arcs")
      .output(&SlotEngagement::cutting_fraction, "cutting_fraction", "-", "1", closed(0, 0.5),
              "share of a revolution in cut");
  source.function<&t_slot_pass>("t_slot_pass", "Kinematics of one pass.", "eq. (C2)", Provenance::completion)
      .input(&PassInputs::cutter_diameter_mm, "d_cutter", "D", "mm", positive(), "cutter diameter", 21.0)
      .input(&PassInputs::spindle_speed_rpm, "n", "n", "rpm", positive(), "spindle speed", 315.0)
      .input(&PassInputs::table_feed_mm_min, "v_f", "v_f", "mm/min", positive(), "table feed", 160.0)
      .input(&PassInputs::length_mm, "length", "l", "mm", positive(), "slot length", 120.0)
      .input(&PassInputs::teeth, "z", "z", "1", at_least(1), "teeth of the cutter", 6)
      .output(&Pass::cutting_speed_m_min, "v_c", "v_c", "m/min", non_negative(), "cutting speed")
      .output(&Pass::feed_mm_tooth, "f_z", "f_z", "mm/tooth", non_negative(), "feed per tooth")
      .output(&Pass::time_min, "t_pass", "t", "min", non_negative(), "time of the pass without approach")
      .output(&Pass::chips, "chips", "N", "pcs", non_negative(),
              "expected number of chips, two per tooth per revolution: for a throat above 0");
  source
      .function<&chip_recirculation>("chip_recirculation", "How often a chip is cut again.", "eq. (C3)",
                                     Provenance::completion)
      .input(&RecirculationInputs::escape_probability, "q_escape", "q", "1", open_low(0, 1),
             "probability that a chip leaves in an idle arc", 0.375)
      .input(&RecirculationInputs::recuts, "k", "k", "1", non_negative(), "number of re-cuts", 2)
      .output(&Recirculation::p_exactly_k, "p_exactly_k", "P(k)", "1", probability(),
              "probability of exactly k re-cuts")
      .output(&Recirculation::mean_recuts, "mean_recuts", "-", "1", non_negative(), "mean re-cuts of a chip")
      .output(&Recirculation::mean_resident_chips, "mean_resident_chips", "-", "1", non_negative(),
              "mean chips in a tooth pocket");
  source
      .function<&t_slot_form_error>("t_slot_form_error",
                                    "Form error of the slot from the bending of the stem.", "eq. (C4)",
                                    Provenance::completion)
      .input(&FormErrorInputs::lateral_force_n, "p_v", "P_v", "N", non_negative(), "lateral force", 400.0)
      .input(&FormErrorInputs::added_share, "k_add", "k", "1", closed(0, 0.25), "added force over P_v", 0.25)
      .input(&FormErrorInputs::overhang_mm, "overhang", "l", "mm", positive(), "overhang of the stem", 25.0)
      .input(&FormErrorInputs::stem_diameter_mm, "d_stem", "d", "mm", positive(), "diameter of the stem",
             10.0)
      .input(&FormErrorInputs::cutter_diameter_mm, "d_cutter", "D", "mm", positive(), "cutter diameter", 21.0)
      .input(&FormErrorInputs::elastic_modulus_mpa, "e_modulus", "E", "MPa", positive(), "elastic modulus",
             210000.0)
      .output(&FormError::side_um, "delta_side", "delta_side", "um", non_negative(), "lateral shift")
      .output(&FormError::tilt_deg, "tilt", "d_alpha", "deg", non_negative(), "tilt of the cutter")
      .output(&FormError::face_um, "delta_face", "delta_face", "um", any(),
              "axial rise of the rim: taper of the slot bottom")
      .note(
          "The figure that defines the paper's two slot errors is lost; shift and rise are proposed for "
          "them. First order: for small tilts.");
}

}  // namespace verstat::models::k105
