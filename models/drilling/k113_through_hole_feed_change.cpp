#include "models/drilling/k113_through_hole_feed_change.h"

namespace verstat::models::k113 {
namespace {

void describe_loads(Source& source) {
  source
      .function<&drill_thrust>("drill_thrust", "Thrust of a drill from diameter, feed and hardness.",
                               "eq. (1)", Provenance::paper)
      .input(&DrillThrustInputs::coefficient, "c1", "C_1", "N", positive(), "coefficient of the thrust", 11.6)
      .input(&DrillThrustInputs::diameter_mm, "diameter_mm", "D", "mm", positive(), "drill diameter", 20.0)
      .input(&DrillThrustInputs::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.3)
      .input(&DrillThrustInputs::hardness_hb, "hardness_hb", "HB", "HB", positive(), "Brinell hardness",
             217.0)
      .input(&DrillThrustInputs::exp_diameter, "exp_diameter", "z", "1", any(), "exponent of the diameter",
             1.0)
      .input(&DrillThrustInputs::exp_feed, "exp_feed", "y", "1", any(), "exponent of the feed", 0.7)
      .input(&DrillThrustInputs::exp_hardness, "exp_hardness", "n", "1", any(), "exponent of the hardness",
             0.75)
      .output(&DrillThrust::thrust_n, "thrust_n", "P_o", "N", non_negative(), "thrust")
      .note("The paper prints no coefficients.");
  source
      .function<&drill_feed_rule>("drill_feed_rule", "Feed of a drill from its diameter.", "eq. (2)",
                                  Provenance::paper)
      .input(&FeedRuleInputs::feed_coefficient, "feed_coefficient", "C_s", "mm^0.4/rev", positive(),
             "coefficient of the feed", 0.05)
      .input(&FeedRuleInputs::diameter_mm, "diameter_mm", "D", "mm", positive(), "drill diameter", 20.0)
      .output(&FeedRule::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", non_negative(), "feed");
  source
      .function<&thrust_diameter_law>("thrust_diameter_law",
                                      "Power law of thrust against diameter when the feed follows it.",
                                      "eq. (3)", Provenance::paper)
      .input(&ThrustLawInputs::coefficient, "c1", "C_1", "N", positive(), "coefficient of the thrust", 11.6)
      .input(&ThrustLawInputs::hardness_hb, "hardness_hb", "HB", "HB", positive(), "Brinell hardness", 217.0)
      .input(&ThrustLawInputs::feed_coefficient, "feed_coefficient", "C_s", "mm^0.4/rev", positive(),
             "coefficient of the feed", 0.05)
      .input(&ThrustLawInputs::exp_diameter, "exp_diameter", "z", "1", any(), "exponent of the diameter", 1.0)
      .input(&ThrustLawInputs::exp_feed, "exp_feed", "y", "1", any(), "exponent of the feed", 0.7)
      .input(&ThrustLawInputs::exp_hardness, "exp_hardness", "n", "1", any(), "exponent of the hardness",
             0.75)
      .output(&ThrustLaw::coefficient, "c_o", "C_o", "N*mm^-x_o", non_negative(), "coefficient of the law")
      .output(&ThrustLaw::exponent, "x_o", "x_o", "1", any(), "exponent of the law");
  source
      .function<&fit_load_diameter_law>("fit_load_diameter_law",
                                        "Power law of mean loads against diameter by least squares.",
                                        "eq. (4)", Provenance::paper)
      .input(&LoadFitInputs::diameters_mm, "diameters_mm", "D_k", "mm", positive(),
             "diameters of the batches, at least two distinct", Value::List{5.0, 10.0, 15.0, 20.0, 25.0})
      .length(2, 100'000)
      .input(&LoadFitInputs::loads, "loads", "P_k", "N or N*m", positive(), "mean load of each batch",
             Value::List{920.0, 2460.0, 4400.0, 6600.0, 9100.0})
      .length(2, 100'000)
      .output(&LoadFit::coefficient, "coefficient", "C_o", "N*mm^-x or N*m*mm^-x", non_negative(),
              "coefficient of the law")
      .output(&LoadFit::exponent, "exponent", "x_o", "1", any(), "exponent of the law")
      .output(&LoadFit::r_squared, "r_squared", "R^2", "1", closed(0, 1),
              "share of the variance of the log loads explained; 1 when all loads are equal")
      .note("The paper reads slope and intercept off a graph; least squares are used instead.");
  source
      .function<&group_load_bounds>("group_load_bounds",
                                    "Most likely and largest load over a group of materials.",
                                    "eqs. (5), (6)", Provenance::paper)
      .input(&GroupLoadInputs::coefficients, "coefficients", "C_i", "N*mm^-x or N*m*mm^-x", positive(),
             "coefficients of the materials", Value::List{82.0, 90.5, 97.0, 110.0, 101.0, 106.0})
      .length(2, 100'000)
      .input(&GroupLoadInputs::exponents, "exponents", "x_i", "1", any(), "exponents of the materials",
             Value::List{1.43, 1.41, 1.42, 1.39, 1.42, 1.4})
      .length(2, 100'000)
      .input(&GroupLoadInputs::diameter_mm, "diameter_mm", "D", "mm", positive(), "drill diameter", 20.0)
      .optional(&GroupLoadInputs::sigma_multiplier, "sigma_multiplier", "k_sigma", "1", non_negative(),
                "standard deviations up to the bound")
      .output(&GroupLoad::coefficient_mean, "coefficient_mean", "mean C", "N*mm^-x or N*m*mm^-x",
              non_negative(), "mean coefficient")
      .output(&GroupLoad::coefficient_sd, "coefficient_sd", "s_C", "N*mm^-x or N*m*mm^-x", non_negative(),
              "standard deviation of the coefficient")
      .output(&GroupLoad::exponent_mean, "exponent_mean", "mean x", "1", any(), "mean exponent")
      .output(&GroupLoad::exponent_sd, "exponent_sd", "s_x", "1", non_negative(),
              "standard deviation of the exponent")
      .output(&GroupLoad::load_likely, "load_likely", "P_likely", "N or N*m", non_negative(),
              "most likely load (paper)")
      .output(&GroupLoad::load_max, "load_max", "P_max", "N or N*m", non_negative(), "largest load (paper)")
      .output(&GroupLoad::load_median_joint, "load_median_joint", "P_med", "N or N*m", non_negative(),
              "median load (C8, completion)")
      .output(&GroupLoad::load_max_joint, "load_max_joint", "P_max,joint", "N or N*m", non_negative(),
              "largest load that keeps coefficient and exponent correlated (C8, completion)")
      .note(
          "load_max puts coefficient and exponent at +k sigma together although the two of one fit are "
          "strongly negatively correlated: it exceeds the joint bound about 1.4 times. Use load_max for "
          "conservative sizing, load_max_joint for planning.")
      .note(
          "Below 1 mm of diameter a larger exponent lowers the load, so load_max may lie under "
          "load_likely.");
  source
      .function<&drill_strength_feed_limits>("drill_strength_feed_limits",
                                             "Largest feeds that the drill stands in torsion and buckling.",
                                             "formulas (a), (b)", Provenance::reconstructed)
      .input(&FeedLimitInputs::diameter_mm, "diameter_mm", "D", "mm", positive(), "drill diameter", 2.0)
      .input(&FeedLimitInputs::torsion_allow_mpa, "torsion_allow_mpa", "[tau]", "MPa", positive(),
             "allowed torsional stress", 800.0)
      .input(&FeedLimitInputs::section_modulus_mm3, "section_modulus_mm3", "W", "mm3", positive(),
             "polar section modulus", 0.16)
      .input(&FeedLimitInputs::torque_coefficient_nm, "torque_coefficient_nm", "C_m", "N*m", positive(),
             "coefficient of the torque", 0.345)
      .input(&FeedLimitInputs::torque_exp_diameter, "torque_exp_diameter", "x_m", "1", any(),
             "exponent of the diameter in the torque", 2.0)
      .input(&FeedLimitInputs::torque_exp_feed, "torque_exp_feed", "y_m", "1", positive(),
             "exponent of the feed in the torque", 0.8)
      .input(&FeedLimitInputs::elastic_modulus_mpa, "elastic_modulus_mpa", "E", "MPa", positive(),
             "elastic modulus of the drill", 210000.0)
      .input(&FeedLimitInputs::inertia_mm4, "inertia_mm4", "I", "mm4", positive(),
             "least second moment of area of the drill", 0.0864)
      .input(&FeedLimitInputs::overhang_mm, "overhang_mm", "l", "mm", positive(), "overhang of the drill",
             45.0)
      .input(&FeedLimitInputs::length_factor, "length_factor", "M", "1", positive(),
             "effective length over overhang, 0.5 to 2 in textbooks", 0.7)
      .input(&FeedLimitInputs::thrust_coefficient_n, "thrust_coefficient_n", "C_po", "N", positive(),
             "coefficient of the thrust", 680.0)
      .input(&FeedLimitInputs::thrust_exp_diameter, "thrust_exp_diameter", "x_po", "1", any(),
             "exponent of the diameter in the thrust", 1.0)
      .input(&FeedLimitInputs::thrust_exp_feed, "thrust_exp_feed", "y_po", "1", positive(),
             "exponent of the feed in the thrust", 0.7)
      .output(&FeedLimits::feed_torsion_mm_rev, "feed_torsion_mm_rev", "S_tor", "mm/rev", non_negative(),
              "largest feed in torsion")
      .output(&FeedLimits::critical_thrust_n, "critical_thrust_n", "P_cr", "N", non_negative(),
              "buckling load")
      .output(&FeedLimits::feed_buckling_mm_rev, "feed_buckling_mm_rev", "S_st", "mm/rev", non_negative(),
              "largest feed in buckling")
      .output(&FeedLimits::feed_limit_mm_rev, "feed_limit_mm_rev", "S", "mm/rev", non_negative(),
              "the smaller of the two")
      .output(&FeedLimits::buckling_governs, "buckling_governs", "-", "1", closed(0, 1),
              "1 when the buckling feed is strictly the smaller")
      .note(
          "The print scatters the exponents and runs the denominators together; the units leave one "
          "reading.");
}

void describe_spring(Source& source) {
  source
      .function<&spring_holder_setup>("spring_holder_setup", "Spring and limit switch of the drill holder.",
                                      "eqs. (7), (8), (C4), (C10)", Provenance::repaired)
      .input(&SpringHolderInputs::thrust_n, "thrust_n", "P_o", "N", positive(), "steady thrust", 6600.0)
      .input(&SpringHolderInputs::spring_rate_n_mm, "spring_rate_n_mm", "C_np", "N/mm", positive(),
             "spring rate", 400.0)
      .input(&SpringHolderInputs::diameter_mm, "diameter_mm", "D", "mm", positive(), "drill diameter", 20.0)
      .input(&SpringHolderInputs::half_point_angle_deg, "half_point_angle_deg", "phi", "deg", open(0, 90),
             "half point angle", 59.0)
      .input(&SpringHolderInputs::zone_fraction, "zone_fraction", "Delta/D", "1", closed(0.2, 0.5),
             "exit zone over diameter", 0.3)
      .input(&SpringHolderInputs::part_thickness_mm, "part_thickness_mm", "l_0", "mm", positive(),
             "part thickness", 40.0)
      .output(&SpringHolder::spring_compression_mm, "spring_compression_mm", "x_0", "mm", non_negative(),
              "compression under the steady thrust")
      .output(&SpringHolder::point_height_mm, "point_height_mm", "l_p", "mm", non_negative(),
              "height of the drill point")
      .output(&SpringHolder::zone_mm, "zone_mm", "Delta", "mm", non_negative(), "exit zone")
      .output(&SpringHolder::switch_distance_mm, "switch_distance_mm", "h", "mm", non_negative(),
              "quill travel from full engagement to the limit switch")
      .output(&SpringHolder::spring_rate_limit_n_mm, "spring_rate_limit_n_mm", "C_max", "N/mm",
              non_negative(), "stiffest spring that completes the hole (derived)")
      .output(&SpringHolder::spring_completes, "spring_completes", "-", "1", closed(0, 1),
              "1 when the spring completes the hole (derived)");
  source
      .function<&feed_clutch_torque>("feed_clutch_torque",
                                     "Torque of the feed clutch on the rack-pinion shaft.", "formula (9)",
                                     Provenance::repaired)
      .input(&FeedClutchInputs::safety_factor, "safety_factor", "K_z", "1", closed(1.15, 1.25),
             "safety factor", 1.2)
      .input(&FeedClutchInputs::rack_module_mm, "rack_module_mm", "m_p", "mm", positive(),
             "module of rack and pinion", 3.0)
      .input(&FeedClutchInputs::rack_pinion_teeth, "rack_pinion_teeth", "z", "1", at_least(1),
             "teeth of the rack pinion", 14)
      .input(&FeedClutchInputs::feed_force_limit_n, "feed_force_limit_n", "[P_feed]", "N", positive(),
             "passport feed force of the machine", 9000.0)
      .input(&FeedClutchInputs::efficiency, "efficiency", "eta", "1", open_low(0, 1),
             "efficiency of the drive", 0.85)
      .output(&FeedClutch::clutch_torque_nm, "clutch_torque_nm", "M_B", "N*m", non_negative(),
              "least slipping torque of the clutch")
      .note("For a clutch on another shaft divide by the transmission ratio between the two.");
  source
      .function<&feed_jump_load_factor>("feed_jump_load_factor",
                                        "Load over the steady one when the feed jumps.",
                                        "derived from the power law", Provenance::completion)
      .input(&LoadFactorInputs::feed_jump, "feed_jump", "j", "1", at_least(1), "feed over the nominal feed",
             1.85)
      .input(&LoadFactorInputs::exp_feed, "exp_feed", "y", "1", non_negative(), "exponent of the feed", 0.8)
      .output(&LoadFactor::load_factor, "load_factor", "k_P", "1", at_least(1), "load over the steady load");
}

void describe_breakthrough(Source& source) {
  source
      .function<&breakthrough_feed_jump>("breakthrough_feed_jump",
                                         "Feed jump at breakthrough from the compliance of the machine.",
                                         "eq. (C1)", Provenance::completion)
      .input(&FeedJumpInputs::thrust_n, "thrust_n", "P", "N", non_negative(), "steady thrust", 6600.0)
      .input(&FeedJumpInputs::axial_stiffness_n_mm, "axial_stiffness_n_mm", "c", "N/mm", positive(),
             "axial stiffness of the machine", 6000.0)
      .input(&FeedJumpInputs::relieved_share, "relieved_share", "kappa", "1", closed(0, 1),
             "share of the thrust lost at breakthrough", 0.5)
      .input(&FeedJumpInputs::relief_travel_mm, "relief_travel_mm", "a", "mm", positive(),
             "drill travel over which it is lost", 1.5)
      .output(&FeedJump::springback_mm, "springback_mm", "d", "mm", non_negative(),
              "deformation that the machine gives back")
      .output(&FeedJump::stable, "stable", "-", "1", closed(0, 1), "0 when the drill is pulled through")
      .output(&FeedJump::feed_jump, "feed_jump", "j", "1", at_least(1),
              "feed over the nominal feed; null when not stable");
  source
      .function<&spring_exit_phase>("spring_exit_phase", "Motion of the drill after the quill has stopped.",
                                    "eqs. (C2)-(C4)", Provenance::completion)
      .input(&SpringExitInputs::feed_mm_rev, "feed_mm_rev", "S_0", "mm/rev", positive(), "nominal feed", 0.3)
      .input(&SpringExitInputs::rpm, "rpm", "n", "rpm", positive(), "spindle speed", 400.0)
      .input(&SpringExitInputs::spring_compression_mm, "spring_compression_mm", "x_0", "mm", positive(),
             "spring compression when the quill stops", 16.5)
      .input(&SpringExitInputs::zone_mm, "zone_mm", "Delta", "mm", non_negative(), "exit zone", 6.0)
      .input(&SpringExitInputs::point_height_mm, "point_height_mm", "l_p", "mm", positive(),
             "height of the drill point", 6.0)
      .input(&SpringExitInputs::exp_feed, "exp_feed", "y", "1", positive(),
             "exponent of the feed in the thrust", 0.7)
      .input(&SpringExitInputs::chisel_share, "chisel_share", "k_ch", "1", open_high(0, 1),
             "share of the thrust carried by the chisel edge", 0.5)
      .input(&SpringExitInputs::feed_cap_ratio, "feed_cap_ratio", "j_cap", "1", at_least(1),
             "mechanical limit of the feed over the nominal feed", 1.85)
      .output(&SpringExit::completed, "completed", "-", "1", closed(0, 1), "1 when the hole is finished")
      .output(&SpringExit::stall_advance_mm, "stall_advance_mm", "x_0", "mm", non_negative(),
              "advance after which the drill stalls; null when completed")
      .output(&SpringExit::zone_time_min, "zone_time_min", "t_1", "min", non_negative(),
              "time through the zone; null when the drill stalls in it")
      .output(&SpringExit::feed_ratio_before, "feed_ratio_before", "S_before/S_0", "1", closed(0, 1),
              "feed over nominal just before the chisel edge leaves; null when it does not")
      .output(&SpringExit::feed_ratio_after, "feed_ratio_after", "S_after/S_0", "1", non_negative(),
              "feed over nominal just after; null when it does not")
      .output(&SpringExit::exit_time_min, "exit_time_min", "t_2", "min", non_negative(),
              "time of the exit of the point; null when not completed")
      .output(&SpringExit::total_time_min, "total_time_min", "t", "min", non_negative(),
              "time after the stop of the quill; null when not completed")
      .output(&SpringExit::residual_compression_mm, "residual_compression_mm", "x_0-Delta-l_p", "mm",
              non_negative(), "compression left after the exit; null when not completed")
      .note(
          "Quasi-static power-law cutting. The residual compression is released freely: the drill jumps "
          "forward by it unless stopped.");
  source
      .function<&spring_critical_design>("spring_critical_design",
                                         "Spring that is relaxed exactly at the end of the exit.", "eq. (C5)",
                                         Provenance::completion)
      .input(&CriticalSpringInputs::thrust_n, "thrust_n", "P_o", "N", positive(), "steady thrust", 6600.0)
      .input(&CriticalSpringInputs::point_height_mm, "point_height_mm", "l_p", "mm", positive(),
             "height of the drill point", 6.0)
      .input(&CriticalSpringInputs::chisel_share, "chisel_share", "k_ch", "1", open_high(0, 1),
             "share of the thrust carried by the chisel edge", 0.5)
      .input(&CriticalSpringInputs::exp_feed, "exp_feed", "y", "1", positive(),
             "exponent of the feed in the thrust", 0.7)
      .input(&CriticalSpringInputs::zone_mm, "zone_mm", "Delta", "mm", non_negative(), "exit zone", 6.0)
      .output(&CriticalSpring::spring_rate_n_mm, "spring_rate_n_mm", "C_np", "N/mm", non_negative(),
              "spring rate")
      .output(&CriticalSpring::feed_ratio_before, "feed_ratio_before", "S_before/S_0", "1", closed(0, 1),
              "feed over nominal just before the chisel edge leaves")
      .output(&CriticalSpring::feed_ratio_after, "feed_ratio_after", "S_after/S_0", "1", non_negative(),
              "feed over nominal after it, constant to the end")
      .output(&CriticalSpring::zone_for_unit_feed_mm, "zone_for_unit_feed_mm", "Delta_1", "mm",
              non_negative(), "zone after which the exit runs at the nominal feed");
}

void describe_times(Source& source) {
  const auto hole = [](auto& f) {
    f.input(&HoleTimeInputs::point_height_mm, "point_height_mm", "l_p", "mm", non_negative(),
            "height of the drill point", 6.0)
        .input(&HoleTimeInputs::approach_mm, "approach_mm", "A", "mm", non_negative(), "approach", 2.0)
        .input(&HoleTimeInputs::overrun_mm, "overrun_mm", "o", "mm", non_negative(), "overrun", 1.0)
        .input(&HoleTimeInputs::feed_mm_rev, "feed_mm_rev", "S_0", "mm/rev", positive(), "nominal feed", 0.3)
        .input(&HoleTimeInputs::rpm, "rpm", "n", "rpm", positive(), "spindle speed", 400.0);
  };
  source
      .function<&through_hole_time>("through_hole_time", "Main time of a through hole by exit strategy.",
                                    "eq. (C6)", Provenance::completion)
      .input(&HoleTimeInputs::strategy, "strategy", "-", "-", no_range(), "what is done at breakthrough",
             "spring_exit")
      .input(&HoleTimeInputs::part_thickness_mm, "part_thickness_mm", "L", "mm", positive(), "part thickness",
             40.0)
      .with(hole)
      .optional(&HoleTimeInputs::zone_mm, "zone_mm", "Delta", "mm", non_negative(),
                "exit zone (reduced_exit, spring_exit)")
      .example(6.0)
      .optional(&HoleTimeInputs::feed_divisor, "feed_divisor", "k", "1", at_least(1),
                "nominal feed over the reduced feed (reduced_full_depth, reduced_exit)")
      .example(1.25)
      .optional(&HoleTimeInputs::spring_compression_mm, "spring_compression_mm", "x_0", "mm", non_negative(),
                "spring compression (spring_exit)")
      .example(16.5)
      .optional(&HoleTimeInputs::spring_time_min, "spring_time_min", "t", "min", non_negative(),
                "total_time_min of spring_exit_phase (spring_exit)")
      .example(0.097054)
      .output(&HoleTime::main_time_min, "main_time_min", "T", "min", non_negative(), "main time")
      .note("Inputs that the strategy does not use are ignored and may be left out.");
  source
      .function<&spring_break_even_thickness>(
          "spring_break_even_thickness",
          "Part thickness above which the spring exit is faster than the feed reduced over the full depth.",
          "eq. (C7)", Provenance::completion)
      .input(&BreakEvenInputs::point_height_mm, "point_height_mm", "l_p", "mm", non_negative(),
             "height of the drill point", 6.0)
      .input(&BreakEvenInputs::approach_mm, "approach_mm", "A", "mm", non_negative(), "approach", 2.0)
      .input(&BreakEvenInputs::overrun_mm, "overrun_mm", "o", "mm", non_negative(), "overrun", 1.0)
      .input(&BreakEvenInputs::zone_mm, "zone_mm", "Delta", "mm", non_negative(), "exit zone", 6.0)
      .input(&BreakEvenInputs::feed_mm_rev, "feed_mm_rev", "S_0", "mm/rev", positive(), "nominal feed", 0.3)
      .input(&BreakEvenInputs::rpm, "rpm", "n", "rpm", positive(), "spindle speed", 400.0)
      .input(&BreakEvenInputs::feed_divisor, "feed_divisor", "k", "1", above(1),
             "nominal feed over the reduced feed", 1.25)
      .input(&BreakEvenInputs::spring_compression_mm, "spring_compression_mm", "x_0", "mm", non_negative(),
             "spring compression", 16.5)
      .input(&BreakEvenInputs::spring_time_min, "spring_time_min", "t", "min", non_negative(),
             "total_time_min of spring_exit_phase", 0.097054)
      .output(&BreakEven::break_even_thickness_mm, "break_even_thickness_mm", "L*", "mm", non_negative(),
              "break-even thickness; 0 when the spring is always faster")
      .note("A value below zone + point height means faster for every part that the scheme can drill.");
  source
      .function<&drill_break_probability>("drill_break_probability",
                                          "Probability that the torque peak breaks the drill.", "eq. (C9)",
                                          Provenance::completion)
      .input(&BreakInputs::torque_mean_nm, "torque_mean_nm", "M", "N*m", non_negative(), "mean torque", 50.0)
      .input(&BreakInputs::torque_sd_nm, "torque_sd_nm", "s_M", "N*m", non_negative(),
             "standard deviation of the torque", 5.0)
      .input(&BreakInputs::load_factor, "load_factor", "k_P", "1", positive(),
             "torque at breakthrough over the steady torque", 1.6358)
      .input(&BreakInputs::strength_mean_nm, "strength_mean_nm", "M_str", "N*m", non_negative(),
             "mean breaking torque", 120.0)
      .input(&BreakInputs::strength_sd_nm, "strength_sd_nm", "s_str", "N*m", non_negative(),
             "standard deviation of the breaking torque; above 0 when torque_sd_nm is 0", 15.0)
      .output(&BreakRisk::safety_index, "safety_index", "beta", "1", any(), "safety index")
      .output(&BreakRisk::break_probability, "break_probability", "p", "1", probability(),
              "probability of breakage");
}

void describe_data(Source& source) {
  source
      .function<&steel_hardness>("steel_hardness", "Hardness of the alloy steels of the sample.",
                                 "text, sample of alloy steels", Provenance::paper)
      .input(&SteelInputs::grade, "grade", "-", "-", no_range(), "steel grade", "40KhF")
      .output(&SteelHardness::hardness_hb, "hardness_hb", "HB", "HB", positive(), "Brinell hardness");
  source
      .function<&published_ranges>("published_ranges", "Ranges of quantities that the paper prints.", "text",
                                   Provenance::paper)
      .input(&PublishedRangeInputs::quantity, "quantity", "-", "-", no_range(), "quantity",
             "breakthrough_feed_jump")
      .output(&PublishedRange::low, "low", "-", "of the quantity", positive(), "lower end")
      .output(&PublishedRange::high, "high", "-", "of the quantity", positive(), "upper end");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K113",
       .title = "Design and technological provision of tool feed change in drilling of through holes",
       .authors = "Kryvyi P. D., Kobelnyk V. R.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Breakthrough of a drill: thrust and torque as random quantities over a group of steels, the "
           "feed that the drill stands, the feed jump when the machine relaxes and the risk of "
           "breakage, and a spring-loaded holder that finishes the hole with the quill at rest against "
           "three other exit strategies.",
       .role = "drilling",
       .errata = {"The exponents of the torsion and buckling limits are scattered in print and their "
                  "denominators run together; the units leave one reading.",
                  "The switch distance is printed with symbols other than those explained after it: part "
                  "length and height of the cutting point are meant.",
                  "The thrust in the spring compression is printed in mm; it is in N.",
                  "The efficiency of the clutch formula is printed after the slash as a factor; it belongs "
                  "to the denominator."}});
  describe_loads(source);
  describe_spring(source);
  describe_data(source);
  describe_breakthrough(source);
  describe_times(source);
}

}  // namespace verstat::models::k113
