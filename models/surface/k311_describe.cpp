#include "models/surface/k311_lapping_cycle.h"

namespace verstat::models::k311 {
namespace {

void describe_cycle(Source& source) {
  source
      .function<&lapping_cycle>("lapping_cycle",
                                "Form, roughness, defect layer and allowance after a sequence of passes.",
                                "eqs. (1)-(5)", Provenance::repaired)
      .input(&LappingPasses::radii_um, "r", "r_j", "um", any(), "radius of the groove round the profile",
             Value::List{1000.0, 1000.8, 1000.2, 1001.0})
      .length(1, 100'000)
      .input(&LappingPasses::removals_um, "removals", "Delta r_j", "um", non_negative(),
             "passes, each a list of radial removals, one per radius",
             Value::List{Value(Value::List{0.6, 0.4, 0.5, 0.7}), Value(Value::List{0.3, 0.2, 0.3, 0.4})})
      .input(&LappingPasses::sign, "sign", "-", "1", closed(-1, 1),
             "-1 as printed, +1 for a concave groove whose radius grows", -1)
      .input(&LappingPasses::roughness_max_um, "R_max0", "R_max0", "um", non_negative(),
             "roughness height at the start", 3.0)
      .input(&LappingPasses::defect_depth_um, "h_d0", "h_d0", "um", non_negative(),
             "depth of the defect layer at the start", 4.0)
      .input(&LappingPasses::allowance_um, "allowance0", "Pi_0", "um", any(),
             "allowance per lapped side at the start", 6.0)
      .input(&LappingPasses::web_um, "h0", "h_0", "um", non_negative(), "web thickness at the start", 60.0)
      .input(&LappingPasses::roughness_floor_um, "R_max_floor", "-", "um", non_negative(),
             "roughness that the process leaves", 0.2)
      .input(&LappingPasses::defect_floor_um, "h_d_floor", "-", "um", non_negative(),
             "defect depth that the process leaves", 0.0)
      .input(&LappingPasses::sides, "sides", "-", "1", closed(1, 2), "lapped sides of the web", 1)
      .output(&LappedState::radii_um, "r", "r_k", "um", any(), "radius of the groove round the profile")
      .output(&LappedState::form_deviation_um, "form_dev", "Delta_k", "um", non_negative(), "form deviation")
      .output(&LappedState::roughness_max_um, "R_max", "R_max", "um", non_negative(), "roughness height")
      .output(&LappedState::defect_depth_um, "h_d", "h_d", "um", non_negative(),
              "depth of the defect layer below the valleys")
      .output(&LappedState::allowance_um, "allowance", "Pi", "um", any(),
              "remaining allowance; negative when too much was removed")
      .output(&LappedState::web_um, "h", "h", "um", any(), "web thickness")
      .note("Floors of roughness and defect depth and the number of lapped sides are completions.");
  source
      .function<&cycle_constraints>("cycle_constraints", "Whether a pass keeps the in-process limits.",
                                    "eqs. (9)-(12)", Provenance::repaired)
      .input(&CycleState::roughness_max_um, "R_max", "R_max j", "um", non_negative(), "roughness height", 1.2)
      .input(&CycleState::defect_depth_um, "h_d", "h_dj", "um", non_negative(), "depth of the defect layer",
             1.0)
      .input(&CycleState::allowance_um, "allowance", "Pi_j", "um", any(), "remaining allowance", 1.0)
      .input(&CycleState::roughness_final_um, "R_max_final", "R_max d", "um", non_negative(),
             "roughness of the finished part", 0.3)
      .input(&CycleState::defect_final_um, "h_d_final", "h_dd", "um", non_negative(),
             "defect depth of the finished part", 0.5)
      .input(&CycleState::force_n, "P_y", "P_y", "N", non_negative(), "pressing force", 2.0)
      .input(&CycleState::force_max_n, "P_y_max", "P_y adm", "N", non_negative(), "greatest pressing force",
             3.0)
      .input(&CycleState::speed_m_min, "V", "V", "m/min", non_negative(), "lap speed", 20.0)
      .input(&CycleState::speed_max_m_min, "V_max", "V_max", "m/min", non_negative(), "greatest lap speed",
             40.0)
      .output(&CycleVerdict::roughness_ok, "roughness_ok", "-", "-", no_range(), "limit (9) holds")
      .output(&CycleVerdict::defect_ok, "defect_ok", "-", "-", no_range(), "limit (10) holds")
      .output(&CycleVerdict::force_ok, "force_ok", "-", "-", no_range(), "limit (11) holds")
      .output(&CycleVerdict::speed_ok, "speed_ok", "-", "-", no_range(), "limit (12) holds")
      .output(&CycleVerdict::ok, "ok", "-", "-", no_range(), "all limits hold");
  source
      .function<&final_conditions>("final_conditions", "Whether the finished web meets its tolerances.",
                                   "eqs. (7), (8)", Provenance::paper)
      .input(&FinishedPart::web_um, "h", "h", "um", any(), "web thickness", 30.0)
      .input(&FinishedPart::web_min_um, "h_min", "h_min", "um", any(), "least web thickness", 29.0)
      .input(&FinishedPart::web_max_um, "h_max", "h_max", "um", any(), "greatest web thickness", 31.0)
      .input(&FinishedPart::form_deviation_um, "form_dev", "Delta_k", "um", non_negative(), "form deviation",
             0.3)
      .input(&FinishedPart::form_max_um, "form_max", "Delta_adm", "um", non_negative(),
             "greatest form deviation", 0.5)
      .input(&FinishedPart::roughness_max_um, "R_max", "R_max k", "um", non_negative(), "roughness height",
             0.2)
      .input(&FinishedPart::roughness_final_um, "R_max_final", "R_max adm", "um", non_negative(),
             "greatest roughness height", 0.3)
      .input(&FinishedPart::roughness_ra_um, "Ra", "Ra_k", "um", non_negative(), "roughness Ra", 0.03)
      .input(&FinishedPart::roughness_ra_max_um, "Ra_max", "Ra_adm", "um", non_negative(), "greatest Ra",
             0.05)
      .input(&FinishedPart::defect_depth_um, "h_d", "h_dk", "um", non_negative(), "depth of the defect layer",
             0.1)
      .input(&FinishedPart::defect_final_um, "h_d_final", "h_d adm", "um", non_negative(),
             "greatest defect depth", 0.5)
      .output(&Verdict::ok, "ok", "-", "-", no_range(), "all tolerances are met");
  source
      .function<&switch_allowance>("switch_allowance", "Least allowance at which the forced stage must end.",
                                   "from (9), (10)", Provenance::repaired)
      .input(&ForcedStage::roughness_forced_um, "R_max_forced", "R_max f", "um", non_negative(),
             "steady roughness of the forced stage", 1.5)
      .input(&ForcedStage::defect_forced_um, "h_d_forced", "h_d f", "um", non_negative(),
             "steady defect depth of the forced stage", 2.0)
      .input(&ForcedStage::roughness_final_um, "R_max_final", "R_max d", "um", non_negative(),
             "roughness of the finished part", 0.3)
      .input(&ForcedStage::defect_final_um, "h_d_final", "h_dd", "um", non_negative(),
             "defect depth of the finished part", 0.5)
      .output(&Allowance::allowance_um, "allowance", "Pi_s", "um", non_negative(), "switching allowance");
}

void describe_time_and_cost(Source& source) {
  source
      .function<&two_stage_time>("two_stage_time", "Time of a forced and a finishing stage.", "completion",
                                 Provenance::completion)
      .input(&TwoStages::allowance_um, "allowance", "Pi", "um", non_negative(), "allowance", 20.0)
      .input(&TwoStages::rate_forced_um_min, "Q_forced", "Q_1", "um/min", positive(),
             "removal rate of the forced stage", 4.0)
      .input(&TwoStages::rate_finish_um_min, "Q_finish", "Q_2", "um/min", positive(),
             "removal rate of the finishing stage", 0.5)
      .input(&TwoStages::allowance_switch_um, "allowance_switch", "Pi_s", "um", non_negative(),
             "allowance left for the finishing stage", 2.7)
      .output(&StageTimes::forced_min, "t_forced", "t_1", "min", non_negative(), "time of the forced stage")
      .output(&StageTimes::finish_min, "t_finish", "t_2", "min", non_negative(),
              "time of the finishing stage")
      .output(&StageTimes::total_min, "t", "t", "min", non_negative(), "main time");
  source
      .function<&piece_time>("piece_time", "Piece time with the share of lap changes.", "eq. (13)",
                             Provenance::paper)
      .input(&Piece::allowance_um, "allowance", "Pi", "um", non_negative(), "allowance", 20.0)
      .input(&Piece::rate_um_min, "Q", "Q_Sigma", "um/min", positive(), "total removal rate", 2.0)
      .input(&Piece::infeed_factor, "K_p", "K_Pi", "1", at_least(1), "infeed-path factor", 1.2)
      .input(&Piece::preparation_min, "T_p", "T_Pi", "min", non_negative(), "preparation time per part", 3.0)
      .input(&Piece::change_min, "T_change", "T_c", "min", non_negative(), "time of a lap change", 15.0)
      .input(&Piece::changes, "n_changes", "n_c", "1", non_negative(), "lap changes per batch", 4)
      .input(&Piece::parts, "n_parts", "n_parts", "1", positive(), "parts per batch", 100)
      .output(&PieceTime::time_min, "t", "t", "min", non_negative(), "piece time");
  source
      .function<&piece_cost>("piece_cost", "Cost of a part: machine, paste and lap resets.", "eq. (14)",
                             Provenance::repaired)
      .input(&PieceExpense::machine_rate_per_min, "R", "R", "money/min", non_negative(),
             "cost of machine time", 0.8)
      .input(&PieceExpense::time_min, "t", "t", "min", non_negative(), "piece time", 15.6)
      .input(&PieceExpense::paste_g_mm3, "q", "q", "g/mm3", non_negative(),
             "paste consumed per removed volume", 0.5)
      .input(&PieceExpense::allowance_um, "allowance", "Pi", "um", non_negative(), "allowance", 20.0)
      .input(&PieceExpense::width_mm, "B", "B", "mm", non_negative(), "width of the lapped surface", 4.0)
      .input(&PieceExpense::length_mm, "L", "L", "mm", non_negative(), "length of the lapped surface", 6.0)
      .input(&PieceExpense::paste_price_per_g, "C_paste", "C_u", "money/g", non_negative(), "price of paste",
             12.0)
      .input(&PieceExpense::changes, "n_changes", "n_c", "1", non_negative(), "lap resets per batch", 4)
      .input(&PieceExpense::reset_cost, "C_reset", "C_reset", "money", non_negative(), "cost of a lap reset",
             30.0)
      .input(&PieceExpense::parts, "n_parts", "n_parts", "1", positive(), "parts per batch", 100)
      .output(&PieceCost::cost, "C", "C", "money", non_negative(), "cost of a part");
  source
      .function<&cycle_time_with_lap_wear>("cycle_time_with_lap_wear",
                                           "Cycle time of a part as the lap wears.", "completion",
                                           Provenance::completion)
      .input(&LapLife::part, "j", "j", "1", at_least(1), "number of the part in the lap life, 1..n_life", 10)
      .input(&LapLife::first_min, "t_first", "t_1", "min", non_negative(), "cycle time of the first part",
             10.0)
      .input(&LapLife::parts_per_life, "n_life", "n", "1", at_least(2), "parts per lap life", 40)
      .optional(&LapLife::ratio, "ratio", "rho", "1", positive(),
                "cycle time of the last part over that of the first")
      .output(&CycleTime::time_min, "t", "t_j", "min", non_negative(), "cycle time")
      .note("The ratio 1.38 is printed; linear growth in between is a completion.");
  source
      .function<&best_lap_reset>("best_lap_reset", "Parts between lap resets with the least mean piece time.",
                                 "completion", Provenance::completion)
      .input(&LapReset::first_min, "t_first", "t_1", "min", non_negative(), "cycle time of the first part",
             10.0)
      .input(&LapReset::growth, "growth", "g", "1", non_negative(), "relative growth of the time per part",
             0.0097)
      .input(&LapReset::preparation_min, "T_p", "T_p", "min", non_negative(), "preparation time per part",
             2.0)
      .input(&LapReset::change_min, "T_change", "T_c", "min", non_negative(), "time of a lap reset", 15.0)
      .input(&LapReset::parts_max, "n_max", "-", "1", at_least(1), "largest number of parts considered", 200)
      .output(&BestReset::parts, "n", "n", "1", at_least(1), "parts per reset")
      .output(&BestReset::time_min, "t", "t", "min", non_negative(), "mean piece time");
  source
      .function<&preston_rate>("preston_rate", "Removal rate after Preston.", "completion",
                               Provenance::completion)
      .input(&PrestonInputs::coefficient_um_mpa_m, "k_p", "k_p", "um/(MPa*m)", non_negative(),
             "Preston's coefficient", 0.05)
      .input(&PrestonInputs::force_n, "P_y", "P_y", "N", non_negative(), "normal force", 3.0)
      .input(&PrestonInputs::area_mm2, "area", "A", "mm2", positive(), "contact area", 6.0)
      .input(&PrestonInputs::speed_m_min, "V", "V", "m/min", non_negative(), "relative speed", 20.0)
      .output(&RemovalRate::rate_um_min, "Q", "Q", "um/min", non_negative(), "removal rate");
}

void describe_grains(Source& source) {
  const auto law = [](auto& f) {
    f.input(&DepthLaw::mean_um, "m", "m", "um", any(), "mean penetration depth of a grain", 0.5)
        .input(&DepthLaw::sd_um, "sigma", "sigma", "um", positive(), "standard deviation of the depth", 0.2)
        .input(&DepthLaw::greatest_um, "t_f", "t_f", "um", positive(),
               "greatest depth, not above the grain diameter", 1.1);
  };
  const auto contact = [&](auto& f) {
    f.input(&GrainContact::grain_um, "d", "d", "um", positive(), "grain diameter", 3.0)
        .with(law)
        .input(&GrainContact::spacing_um, "l0", "l_0", "um", positive(), "mean spacing of the grains", 40.0)
        .optional(&GrainContact::shape_factor, "chi", "chi", "1", positive(),
                  "shape factor; 2 is the full chord")
        .input(&GrainContact::speed_m_min, "V", "V", "m/min", non_negative(), "relative speed", 10.0)
        .input(&GrainContact::time_s, "t", "t", "s", non_negative(), "contact time of a surface point",
               0.005);
  };
  const std::string contact_note =
      "The contact time of a surface point is the cycle time times the share of time it is under the lap.";

  source
      .function<&grain_depth_parameters>("grain_depth_parameters",
                                         "Mean and standard deviation of the depth of grain penetration.",
                                         "Table 1, row 1", Provenance::paper)
      .input(&GrainSizes::mean_size_um, "m_d", "m_d", "um", non_negative(), "mean grain size", 3.0)
      .input(&GrainSizes::mean_in_lap_um, "m_u1", "m_u1", "um", non_negative(), "mean embedding in the lap",
             1.2)
      .input(&GrainSizes::mean_in_gap_um, "m_u2", "m_u2", "um", non_negative(), "mean share in the gap", 1.3)
      .input(&GrainSizes::sd_size_um, "sigma_d", "sigma_d", "um", non_negative(), "deviation of the size",
             0.3)
      .input(&GrainSizes::sd_in_lap_um, "sigma_u1", "sigma_u1", "um", non_negative(),
             "deviation of the embedding", 0.2)
      .input(&GrainSizes::sd_in_gap_um, "sigma_u2", "sigma_u2", "um", non_negative(),
             "deviation of the gap share", 0.2)
      .output(&DepthParameters::mean_um, "m", "m", "um", any(), "mean penetration depth")
      .output(&DepthParameters::sd_um, "sigma", "sigma", "um", non_negative(),
              "standard deviation of the depth")
      .note("u_2 is not defined in the paper; read as the part of the grain that stays in the gap.");
  source
      .function<&grain_depth_pdf>("grain_depth_pdf", "Density of the depth of grain penetration.",
                                  "Table 1, row 1", Provenance::completion)
      .input(&DepthAt::depth_um, "a", "a", "um", any(), "depth", 0.5)
      .with(law)
      .output(&Density::density_per_um, "f", "f", "1/um", non_negative(), "density, zero outside 0..t_f")
      .note("The paper does not define the factor mu; it normalizes to the range 0..t_f.");
  source
      .function<&non_removal_probability>("non_removal_probability",
                                          "Probability that no grain has touched a level.", "Table 1, row 2",
                                          Provenance::repaired)
      .input(&GrainContactLevel::level_um, "y", "y", "um", non_negative(), "level below the outermost line",
             0.4)
      .with(contact)
      .output(&Probability::probability, "p", "P", "1", probability(), "probability of material at the level")
      .note(contact_note);
  source
      .function<&lapped_roughness>("lapped_roughness", "Mean removal and roughness of a lapped surface.",
                                   "Table 1, rows 1-3", Provenance::repaired)
      .with(contact)
      .output(&LappedRoughness::mean_removal_um, "mean_removal", "y", "um", non_negative(),
              "mean line below the outermost line")
      .output(&LappedRoughness::ra_um, "Ra", "Ra", "um", non_negative(), "mean absolute deviation")
      .output(&LappedRoughness::r_max_um, "R_max", "R_max", "um", non_negative(), "roughness height, 6 Ra")
      .note("The surface starts flat.")
      .note(contact_note);
  source
      .function<&lapping_force>("lapping_force", "Grains in contact and normal force of the lap.",
                                "Table 1, row 4", Provenance::repaired)
      .input(&LapContact::width_mm, "b", "b", "mm", positive(), "contact width", 2.0)
      .input(&LapContact::length_mm, "L_k", "L_k", "mm", positive(), "contact length", 3.0)
      .input(&LapContact::spacing_um, "l0", "l_0", "um", positive(), "mean spacing of the grains", 40.0)
      .input(&LapContact::grain_um, "d", "d", "um", positive(), "grain diameter", 3.0)
      .with(law)
      .input(&LapContact::hardness_mpa, "HV", "HV", "MPa", positive(), "hardness of the workpiece", 9000.0)
      .optional(&LapContact::contact_fraction, "contact_fraction", "c", "1", probability(),
                "share of the grain's section that bears (only the front half of a sliding grain)")
      .optional(&LapContact::material_probability, "p_material", "P", "1", probability(),
                "probability that a grain meets material")
      .output(&LappingForce::grains, "grains", "-", "1", positive(), "grains in contact")
      .output(&LappingForce::force_n, "P_y", "P_y", "N", non_negative(), "normal force")
      .note("The force of a single grain, c pi a (d - a) HV, is a completion.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K311",
       .title = "Process management lapping precision surfaces",
       .authors = "Sazonov S. Ye.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Finish lapping of grooves that form a thin elastic web, with a diamond-charged lap: form, "
           "roughness, defect layer and allowance pass by pass, the limits that split the cycle into a "
           "forced "
           "and a gentle stage, piece time and cost with the share of lap resets, and a probabilistic model "
           "of the grains.",
       .role = "surface",
       .errata = {
           "Eq. (10) is printed with h_dj on both sides; Table 1 has the defect depth of the finished part.",
           "Eq. (14) charges all lap resets of a batch to every part; divided by the parts, as in (13).",
           "Table 1, row 2 is printed with a positive exponent (a probability above 1) and with the density "
           "at the height over the level instead of the depth; both repaired.",
           "Table 1, row 4 has the single-grain symbol on the left side and a stray l; repaired."}});
  describe_cycle(source);
  describe_time_and_cost(source);
  describe_grains(source);
}

}  // namespace verstat::models::k311
