// Written by tools/make-formulas from the headers in models/: change those, not this.
#include "models/catalogue/formulas.h"

#include <algorithm>
#include <array>
#include <utility>

namespace verstat::models {

namespace {

// clang-format off
constexpr std::array<std::pair<std::string_view, std::string_view>, 694> formulas{{
    {"K101.cutting_surface_normal",
     "Unit normal of the cutting surface in the blank frame, into the tooth body. K101 eq. (11)."},
    {"K101.hob_approach_length",
     "Axial distance of the hob centre at first contact of the tip cylinders; 0 and 90 deg when they do not "
     "meet. K101 eq. (7), repaired."},
    {"K101.hob_contact_arc",
     "Arc of the hob in which a tooth is in the blank, mid-plane and zero swivel. K101 eq. (9)."},
    {"K101.hob_edge_point",
     "A point of a tooth edge in the hob frame. K101 eq. (5) with beta_1 = -gamma for convolute hobs, "
     "repaired."},
    {"K101.hob_geometry",
     "Constants of the hob tooth. COMPLETION (C1), standard hob geometry. Error when the tip radius leaves "
     "no tip land or the module reaches the pitch diameter."},
    {"K101.hob_point_in_blank_frame",
     "A point of the hob frame in the blank frame. K101 eq. (4), repaired: one row of the matrix is "
     "misprinted."},
    {"K101.hob_relative_velocity",
     "Velocity of an edge point relative to the blank per radian of hob rotation, components in S0. K101 "
     "eq. (10), repaired."},
    {"K101.hob_tooth_engaged",
     "Whether a tooth is in the arc, angle modulo 360, ends included. K101 eq. (12)."},
    {"K101.hob_working_teeth",
     "Teeth within the intersection of the tip cylinders along the hob axis. COMPLETION (C2)."},
    {"K101.hobbing_chip_thickness",
     "Chip thickness at an edge point: distance along the surface normal to what earlier teeth and blank "
     "revolutions left, or to the boundary of the blank. K101 eqs. (13)-(15), steps 1-9."},
    {"K101.hobbing_kinematics",
     "Blank rotation and axial hob travel at a hob rotation. K101 eqs. (2), repaired: the feed is missing "
     "in print; (3)."},
    {"K101.hobbing_load_summary",
     "Sweep of all teeth over the whole arc: largest chip, removed volume and its distribution over the "
     "teeth. K101, (C3)."},
    {"K101.hobbing_main_time",
     "Hob rotation and main time of one gear, phi = 2 pi (2L + B) Z_k/(S z_0). K101 eq. (8)."},
    {"K101.hobbing_setup",
     "Setting of hob and blank, beta_set = -(beta_w - gamma). K101 eq. (1), (C1)."},
    {"K101.hobbing_tooth_load",
     "Load of one tooth at one angle by the trapezoidal rule along its edge. K101, (C4)."},
    {"K101.hoffmeister_chip_thickness",
     "Fast estimate of the largest head chip thickness. COMPLETION (C5), Hoffmeister; helix angle in "
     "degrees."},
    {"K102.chip_splitter_depth_limit",
     "Largest depth of cut at which a chip splitter of height l works, t <= l / 1.2. K102 (3)."},
    {"K102.chip_splitter_force_factor",
     "Factor of a chip splitter on P_z: 1 - reduction where it works, else 1. The step is a COMPLETION."},
    {"K102.fem_turning_force",
     "What the finite-element run said (Table 3: V = 100 m/min, S = 0.5 mm/rev, t = 3 mm), linear between "
     "the rows, clamped outside, resultant recomputed. Single runs without experiment: not a prediction."},
    {"K102.force_model_discrepancy",
     "FEM minus handbook, and that over FEM (> 0). K102 (4)."},
    {"K102.handbook_turning_force",
     "Handbook force, P_c = 10 C t^x S^y V^n K_m K_phi K_gamma K_lambda K_r, K102 (2). Corrections linear "
     "between the entries of their tables and clamped at the ends. COMPLETION: Kosilova-Meshcheryakov, "
     "carbide on structural steel."},
    {"K102.nose_radius_force_factor",
     "Correction factors of the nose radius (>= 0): handbook at 0.5, 1, 2, 3 mm; the authors' own at 0, "
     "1.5, 2.5."},
    {"K102.rake_shape_force",
     "Finite-element forces of three rake faces (Table 5) and their ratios to the flat one; usable as "
     "relative factors only."},
    {"K102.resultant_force",
     "Resultant of three components."},
    {"K102.turning_power",
     "Cutting power N = P_z V / 60000. COMPLETION."},
    {"K102.uncut_chip_section",
     "Uncut chip section of a tool with two straight edges and a round nose, K102 (1). The residual height "
     "y* is where the width of the tool outline equals the feed, or the depth when the outline stays "
     "narrower. Depth, feed > 0; lead angle 10..90, end angle 1..90 deg; nose radius >= 0. A sharp nose "
     "with both angles 90 has no width: an error."},
    {"K103.constant_thrust_test",
     "Evaluation of a drilling test at constant thrust against a reference drill. K103 (E1), from the "
     "description of the test (520 N, 880 rpm, diameter 6.8 mm)."},
    {"K103.mat_batch_time",
     "Time per tool, (cycle + handling)/(60 batch), handling per batch. K103 (C3), COMPLETION."},
    {"K103.mat_break_even_cost",
     "Treatment cost per tool life below which the cost per unit of life falls, (k - 1) C; negative for a "
     "factor below 1. K103 (C4), COMPLETION; saved tool changes are not counted."},
    {"K103.mat_powder_class",
     "What the paper says of a charge: grain shape, whether it rounds edges, whether its drills were among "
     "the fastest under constant thrust. K103, discussion of the figures."},
    {"K103.mat_surface_kinetics",
     "Roughness and edge radius after 0..300 s, from the states at 0 and 180 s: Ra geometric up to 180 s "
     "and constant after, radius linear. K103 (C1), COMPLETION."},
    {"K103.mat_time_for_edge_radius",
     "Time to an edge radius, 0 when already reached. Inverse of (C1). Error above the radius at 300 s, or "
     "when the radius does not grow."},
    {"K103.mat_treatment_effect",
     "Result of the treatment with the recommended charge. K103, conclusions (Ra < 0.12 um, hardness + more "
     "than 12 %, edge radius 15-20 um) and introduction (life at least x1.8-2). Error for the other "
     "charges: no data."},
    {"K103.mat_weibull_life",
     "Weibull life of a treated drill: the scale times the life factor, the shape kept. K103 (C2), "
     "COMPLETION."},
    {"K104.cutoff_time_and_kerf",
     "Main time d/(60 S_y) of a cut and kerf width, wheel plus side layer. COMPLETION."},
    {"K104.density_coefficient",
     "Coefficient of eq. (3), c = ln 2 * 2^(k-1.5) (k+m+1) / (k B(m+1, k)); printed 3.53 for k = 1.5, m = "
     "0.5. median_exponent stands for ln 2, the removal exponent at the mean line of the profile."},
    {"K104.grain_cut_regime",
     "What a grain does at a relative depth >= 0: plastic below 0.04, transition to 0.08, cutting to 0.25, "
     "intensive cutting from there. K104 condition (0)."},
    {"K104.max_side_grain_density",
     "Largest number of side grains per mm2 at which each still penetrates t/rho. K104 eqs. (3), (4), with "
     "V_k in m/s: n = c S_x / (K_c rho^2 (t/rho)^(m+1) 1000 V_k)."},
    {"K104.min_radial_feed",
     "Smallest radial feed at which the side grains reach t/rho. K104 eq. (4) inverted, k = 1.5, m = 0.5."},
    {"K104.relative_cut_depth",
     "Relative depth t/rho that the side grains reach. K104 eq. (4) inverted, k = 1.5, m = 0.5."},
    {"K104.side_feed",
     "Side feed that takes the layer during the cut, S_x = dh S_y / d. K104, implied before eq. (4)."},
    {"K104.side_layer_thickness",
     "Layer that the wheel's sides take in one cut of a pipe of 20..120 mm. K104 Table 1 with the "
     "interpolation of the card (COMPLETION): a base column for a 300 mm wheel, 5e-5 mm less per mm of "
     "wheel above, the wheel clamped to 300..600 mm and the layer to 0.002..0.003 of the pipe."},
    {"K104.side_removal_exponent",
     "Probability P = 1 - exp(-a) that wall material is removed after a contact time >= 0: a = 1000 k K_c "
     "C_b B(m+1, k) n V_k (V_y tau)^(k+m+1) / (H_u^k (k+m+1) V_y),   C_b = 2 sqrt(2) rho^(1-m) K104 eq. "
     "(1); C_b is not printed: recovered from eq. (3) for m = 1/2, COMPLETION for other m. The path V_y tau "
     "must not leave the active layer H_u (1e-9 relative allowed for rounding)."},
    {"K105.chip_dimensions",
     "Mean chip sizes of groups 1 to 3 (Table 1)."},
    {"K105.chip_group_shares",
     "Shares of the four groups and of chips that met the tool again, 1 - N_1/N (a lower bound)."},
    {"K105.chip_recirculation",
     "Re-cuts of a chip with one escape trial per idle arc, P(k) = q (1 - q)^k. COMPLETION (C3)."},
    {"K105.repeated_chip_force",
     "Force added by repeated cutting of chips, P_add = k P_v, k <= 0.25."},
    {"K105.t_slot_engagement",
     "Arcs of a revolution in a T-slot whose throat of width b is already milled. COMPLETION (C1)."},
    {"K105.t_slot_form_error",
     "Lateral shift, tilt and axial rise of the rim of a cutter on a cantilever stem. COMPLETION (C4)."},
    {"K105.t_slot_pass",
     "Kinematics of one pass. COMPLETION (C2)."},
    {"K106.active_edge_length",
     "Active edge of a flat-rake round insert, b = r (arccos(1 - t/r) + arcsin(s/2r)), 0 < t <= r, 0 <= s "
     "<= 2r. K106 (C3)."},
    {"K106.ceramic_chatter_risk",
     "Whether a ceramic insert chatters: t >= 0.1 mm and 60 <= v <= 100 m/min. Printed for t = 0.1 mm."},
    {"K106.cutting_power",
     "Cutting power N = P_z v / 60000. K106 (C5)."},
    {"K106.flank_contact_pressure",
     "Contact pressure on the worn flank, p = dP_y / (h b). K106 (C4)."},
    {"K106.force_growth_with_time",
     "Growth of radial and tangential force over the first 10 s of a sharp tool, 0..60 min. K106 (C2), "
     "through the printed points at 10 and 40 min."},
    {"K106.hard_turning_forces",
     "Force components of hard turning, K106 (C1). Speed, feed, depth > 0, flank wear >= 0. Outside the "
     "published box (v 30..150, s 0.1..0.7, t 0.05..0.25) or forces the flag is false and the forces are "
     "extrapolations."},
    {"K106.part_deflection",
     "Deflection of a bar between centres under a force at mid-span, P L^3 / (48 E I). K106 (C6)."},
    {"K107.active_edge_length",
     "Active edge b = r (theta_lead + theta_trail). COMPLETION (C3)."},
    {"K107.allowed_depth",
     "Largest depth not above the wanted one and outside every forbidden interval; 0 when there is none. "
     "COMPLETION (C1)."},
    {"K107.allowed_feed",
     "Largest feed not above the wanted one and outside every forbidden interval; 0 when there is none. "
     "COMPLETION (C1)."},
    {"K107.concave_radius_ok",
     "Whether the insert fits the profile: its smallest concave radius must exceed the insert radius."},
    {"K107.forbidden_depth",
     "Depth that brings the tip onto the leading notch on an ascending slope, t = r (1 - cos(omega)). K107 "
     "eq. (4), with the subscript \"out\" that the print lacks."},
    {"K107.forbidden_depth_interval",
     "Open interval of forbidden depths. COMPLETION (C1)."},
    {"K107.forbidden_feed",
     "Feed that brings the tip onto the trailing notch on a descending slope, S = 2 r sin(omega). K107 eq. "
     "(3)."},
    {"K107.forbidden_feed_interval",
     "Open interval of forbidden feeds with the guard half-angle w/r, arguments clipped to 0..90 deg. "
     "COMPLETION (C1)."},
    {"K107.insert_rnun_070300",
     "Dimensions of the insert RNUN 070300 of the paper."},
    {"K107.notch_angles",
     "Angles from the tip to the two notches, sin(theta_trail) = S/(2r), cos(theta_lead) = (r - t)/r. K107 "
     "eqs. (1), (2) read backwards."},
    {"K107.profile_clashes",
     "Pairs of straight segments whose tip and notch angles coincide within the guard. COMPLETION (C2)."},
    {"K107.scallop_height",
     "Theoretical height of the ridges, r - sqrt(r^2 - S^2/4). COMPLETION (C4)."},
    {"K108.edge_radius_after",
     "Edge radius growing at a rate > 0, from t_break on at slow_factor (0..1) of it. K108 (C4), "
     "COMPLETION. The rates are the user's: fine uniform (1), coarse slower after 300-360 s."},
    {"K108.final_roughness",
     "Roughness Ra at which the faces settle: the middle of the printed 0.06-0.07 (fine) or 0.10-0.11 um "
     "(coarse)."},
    {"K108.hardness_factor",
     "Hardness over initial hardness after 0..480 s, 1 + 0.135 (1 - exp(-3 t / 120)). K108 (C3), "
     "COMPLETION: the printed final +13-14 %; the printed wave before it is not modelled."},
    {"K108.recommended_setting",
     "Whether a setting is the recommended one: mandrel angles p and q both 20..30 deg, ends included, and "
     "the fine mixture. K108, conclusions."},
    {"K108.ring_radius",
     "Radius of the ring bath from the linear speed > 0 and the speed of the carrier > 0. K108 (C1), "
     "COMPLETION."},
    {"K108.roughness_after",
     "Roughness after a time, exponential towards the final one with 95 % of the change at the printed "
     "settling time of 200 s. K108 (C2), COMPLETION. A face smoother than the final level becomes rougher."},
    {"K108.time_for_edge_radius",
     "Time to reach an edge radius, 0 when already reached. Inverse of (C4). Error when slow_factor is 0 "
     "and the target lies above the radius at t_break."},
    {"K108.treatment_time",
     "Time of a treatment in equal stages. K108, description of the experiments."},
    {"K109.control_limit",
     "Smallest number of failed teeth with which the next mission may not be started any more (at least 1)."},
    {"K109.failed_teeth_pmf",
     "Probabilities of 0..z failed teeth at the end of a mission begun with a fresh mill.   K109 (C3)."},
    {"K109.failure_times",
     "Times and order of the tooth failures when every tooth wears at the rate of its load and fails at its "
     "own exposure; ties go to the lowest index.   K109 (C6)."},
    {"K109.load_factor",
     "Hazard (or wear rate) multiplier of each survivor, (z/(z-j))^alpha.   K109 (C2)."},
    {"K109.material_removal_rate",
     "q = width depth v_f/1000"},
    {"K109.mean_time_to_nth_failure",
     "Mean time to the n-th failure, equal sharing, exposure model.   K109 (C7) as the integral E[T_n] = "
     "integral of sum_{j<n} C(z,j) F^j S^(z-j) / phi_j,  accurate also where (C7) alternates."},
    {"K109.mill_reliability_binomial",
     "Independent teeth: at most `failed_allowed` of them fail.   K109 (C1)."},
    {"K109.mill_reliability_exposure",
     "Reliability at time t under the exposure model with equal sharing.   K109 (C8): quadrature for at "
     "most two tolerated failures, otherwise 2^20 draws of a fixed seed (standard error below 5e-4, takes "
     "about 0.2 s)."},
    {"K109.mill_reliability_load_sharing",
     "Load shared equally by the survivors; at most `failed_allowed` failures.   K109 (C3)."},
    {"K109.mill_reliability_local_sharing",
     "Only the tooth behind a gap takes the extra chip: factor g^alpha for a gap of g pitches. z <= 16. "
     "(C4)."},
    {"K109.mill_reliability_paper",
     "Whole-system redundancy of multiplicity m,  R = 1 - (1 - R_z^z)^(m+1).   K109 eq. (0), as printed. A "
     "lower bound of the load-sharing reliability with m tolerated failures for alpha <= 2."},
    {"K109.mission_reliability_from_state",
     "Probability that a mission begun with failed_now failed teeth ends with at most failed_allowed.   "
     "(C3)."},
    {"K109.mission_time",
     "Mission that a tooth survives with probability r_tooth. Inverse of (C5)."},
    {"K109.policy_cost",
     "Long-run cost of replacing all edges at failure failed_allowed + 1 or at age t_planned.   K109 (C9)."},
    {"K109.property_score",
     "Ratio of a design's property to the reference design, inverted when smaller is better (COMPLETION)."},
    {"K109.quality_level",
     "Weighted arithmetic mean of the scores of one level of the quality tree.   K109 (C10), COMPLETION."},
    {"K109.required_failed_allowed",
     "Smallest number of failures that must be tolerated for a fresh mill to meet the target."},
    {"K109.required_m_paper",
     "Teeth that must still work when the mill is pulled, m = ln(1-R)/ln(1-R_z^z) - 1 rounded up.  K109 eq. "
     "(1). Rounding up, the clamp of replace_at_failed to 1..z and `feasible` are COMPLETION. m stops at "
     "1e9."},
    {"K109.required_tooth_reliability",
     "Tooth reliability that gives the mill reliability under equal sharing: inverse of (C3)."},
    {"K109.required_tooth_reliability_paper",
     "Tooth reliability that gives the mill reliability: inverse of eq. (0)."},
    {"K109.spindle_speed",
     "n = 1000 v_c/(pi d)"},
    {"K109.table_feed",
     "v_f = f_z z n"},
    {"K109.tooth_reliability",
     "R_z(t) = exp(-(t/eta)^beta), eta = t_mean/Gamma(1 + 1/beta).   K109 (C5)."},
    {"K110.asperity_flash_temperature",
     "Rise of temperature on one contact spot, 2 beta q r / (k sqrt(pi (1.273 + Pe))). COMPLETION (C4), "
     "Jaeger's source in the interpolation of Tian and Kennedy."},
    {"K110.hot_zone_wear_multiplier",
     "Factor on a thermally activated wear rate when a fraction of the contact is hotter than the rest. "
     "COMPLETION (C5), Arrhenius."},
    {"K110.mean_interface_temperature",
     "Mean tool-chip interface temperature, T = T_0 + c u/(rho c) (v h/a)^(1/3). COMPLETION (C2), Cook."},
    {"K110.melting_temperature",
     "Melting temperature of the two alloys, as quoted."},
    {"K110.published_contact_temperature",
     "One contact temperature that the paper quotes; both ends equal when it gives one value."},
    {"K110.speed_limit_by_temperature",
     "Highest speed at which mean rise times hot-spot factor stays within a limit. COMPLETION (C3), the "
     "inverse of (C2); not clamped to its speed range."},
    {"K110.thermal_severity",
     "Contact temperature against the mean (as rises above ambient) and against melting. COMPLETION (C1)."},
    {"K111.drill_thrust_ratio",
     "Thrust of the modified point over the standard one, 1 - k (1 - kappa). COMPLETION (C1)."},
    {"K111.main_edge_clearance",
     "Static clearance of the main edge in the plane tangent to the cylinder of a radius, from the chisel "
     "junction to the periphery. K111 eq. (2)."},
    {"K111.slotted_chisel_geometry",
     "Static angles of the slotted chisel, 0 < Theta + psi < 90. K111 (5), (6) as printed and (6c) "
     "corrected for the section normal to the edge."},
    {"K111.slotted_chisel_kinematics",
     "Angles in work at one point of the slotted chisel, slot/2 < radius <= R. K111 (7c), corrected: the "
     "feed term carries the sine of the half point angle; alpha_k = alpha_n - tau, gamma_k = tau (8)."},
    {"K111.slotted_chisel_max_feed",
     "Largest feed with at least a given kinematic clearance (0 to below 90) at a radius; 0 or less means "
     "infeasible. K111 (10), derived."},
    {"K111.slotted_chisel_rubbing_radius",
     "Radius inside which the kinematic clearance is below the minimum; half the slot when the whole edge "
     "clears, not clipped at its outer end. The minimum must be below the static normal clearance. K111 "
     "(10), derived."},
    {"K111.standard_chisel_geometry",
     "Chisel edge of the standard drill. sin(mu) = r/R, tan(Theta) = tan(alpha) tan(phi)/cos(mu) - tan(mu) "
     "(4), psi_st = 90 - Theta (1), tan(alpha_ch) = cot(phi)/cos(Theta), gamma_ch = alpha_ch - 90 (3)."},
    {"K112.diamond_wheel_life",
     "Volume of the diamond layer of a straight wheel, its diamond (100 % = 4.4 carat/cm3) and the parts it "
     "lasts for a grinding ratio in mm3 of stone per mm3 of layer. K112 (C5), COMPLETION."},
    {"K112.machine_characteristics",
     "The lathes of K112 Table 1; the upper feeds of 16B05P are repaired (0.35 and 0.175, a lost zero "
     "place)."},
    {"K112.stone_machine_fit",
     "Whether the lathe can run the group: the part passes over the carriage, and the closed windows of "
     "speed and longitudinal feed of Tables 1 and 3 meet. The cross feed is reported but does not decide. "
     "Flags are 0 or 1."},
    {"K112.stone_plunge_time",
     "Time of radial forming with spark-out, a/(S n) + N/n. K112 (C3), COMPLETION."},
    {"K112.stone_removal_rate",
     "Removal rate pi (D - t) t S n of a pass of depth t <= D/2 on the diameter D. K112 (C4), COMPLETION."},
    {"K112.stone_turning_kinematics",
     "Work speed, and the wheel speed that gives the relative speed in opposed (1) or climb (0) motion. "
     "K112 (C1), COMPLETION. Error when the work alone is already as fast as the required relative speed."},
    {"K112.stone_turning_regime",
     "Recommended window for the machinability group 1..5, parts up to 150 mm diameter. K112 Table 3 and "
     "the finish feeds after it; the speeds for finishing are those of roughing (COMPLETION)."},
    {"K112.stone_turning_time",
     "Whole passes (0 for no allowance), time of one and of all. K112 (C2), COMPLETION."},
    {"K113.breakthrough_feed_jump",
     "Feed jump from the compliance of the machine: d = kappa P / c, j = 1 / (1 - d/a). COMPLETION (C1)."},
    {"K113.drill_break_probability",
     "Probability that the torque peak breaks the drill: normal stress against normal strength, beta = "
     "(M_str - k M) / sqrt(s_str^2 + k^2 s_M^2), p = Phi(-beta). COMPLETION (C9)."},
    {"K113.drill_feed_rule",
     "Feed from the diameter, S = C_s D^0.6. K113 eq. (2)."},
    {"K113.drill_strength_feed_limits",
     "Largest feeds that the drill stands in torsion and as a compressed bar: S_tor = ([tau] W / (1000 C_m "
     "D^x_m))^(1/y_m),  S_st = (pi^2 E I / (C_po D^x_po M^2 l^2))^(1/y_po). K113 (a), (b), reconstructed "
     "from a scattered print; 1000 turns N m into N mm."},
    {"K113.drill_thrust",
     "Thrust of a drill, P = C_1 D^z S^y HB^n. All but the exponents > 0. K113 eq. (1); the paper prints no "
     "coefficients."},
    {"K113.feed_clutch_torque",
     "Torque of the clutch on the rack-pinion shaft, M_B = K m z F / (2000 eta). K113 (9), repaired: the "
     "efficiency belongs to the denominator. For a clutch elsewhere divide by the transmission ratio."},
    {"K113.feed_jump_load_factor",
     "Load over the steady one when the feed jumps j times, k = j^y. Derived from the power law."},
    {"K113.fit_load_diameter_law",
     "Least squares of lg P = x_o lg D + lg C_o. K113 eq. (4); the paper reads slope and intercept off a "
     "graph."},
    {"K113.group_load_bounds",
     "Most likely and largest load over a group of materials: P = mean(C) D^mean(x), P_max = (mean(C) + k "
     "s_C) D^(mean(x) + k s_x). K113 eqs. (5), (6). The joint values are a COMPLETION (C8): mean and "
     "standard deviation of ln P_i at the given diameter. The unit is that of the coefficients (N, N m)."},
    {"K113.published_ranges",
     "Ranges that the paper prints."},
    {"K113.spring_break_even_thickness",
     "Thickness above which the spring exit is faster than the feed reduced over the full depth; 0 when it "
     "always is. A value below zone + point height means faster for every part the scheme can drill. "
     "COMPLETION (C7)."},
    {"K113.spring_critical_design",
     "Spring that is relaxed exactly at the end of the exit, x_0 = zone + l_p. COMPLETION (C5)."},
    {"K113.spring_exit_phase",
     "Motion of the drill after the quill has stopped, quasi-static: the spring force equals the thrust at "
     "the current feed times the engaged share of the edges. COMPLETION (C2)-(C4). The zone in closed form, "
     "the exit of the point by the midpoint rule on 20000 panels."},
    {"K113.spring_holder_setup",
     "Spring and limit switch of the holder: x_0 = P / C (7), zone = fraction D, l_p = D/2 cot(phi) (C10), "
     "h = L - (l_p + zone) (8), softest need C <= P / (zone + l_p) (C4, relative slack 1e-9). Error when "
     "the part is thinner than point and zone: the switch would trip before full engagement."},
    {"K113.steel_hardness",
     "Brinell hardness of the alloy steels of the paper's sample."},
    {"K113.through_hole_time",
     "Main time of a through hole under one of four exit strategies. COMPLETION (C6)."},
    {"K113.thrust_diameter_law",
     "Thrust against diameter when the feed follows (2): P = C_o D^x_o, C_o = C_1 HB^n C_s^y, x_o = z + 0.6 "
     "y. K113 eq. (3)."},
    {"K114.chisel_edge_clearance",
     "Clearance in the section normal to the chisel edge, tan(alpha_c) = (sin phi_c cos eps1 + cos phi_c "
     "sin eps1 sin psi) / (sin eps1 cos psi). K114 eq. (1) in its compact form (1c)."},
    {"K114.chisel_edge_limits",
     "Clearance at eps1 = 90 and rake at eps2 = 90: alpha_min = atan(cos phi_c tan psi), gamma_max = 90 - "
     "alpha_min. K114 (3)."},
    {"K114.chisel_edge_rake",
     "Rake in the section normal to the chisel edge, tan(gamma_c) = sin eps2 cos psi / (sin phi_c cos eps2 "
     "+ sign cos phi_c sin eps2 sin psi). K114 eq. (2), repaired: printed with the minus sign, which "
     "contradicts the paper's own numbers."},
    {"K114.chisel_edge_setting_angles",
     "Setting angles for a wanted clearance and rake, K114 (4): the inversion of (1c) and (2c). Feasible "
     "when the targets are within the limits (3) and leave a wedge, alpha + gamma < 90; otherwise the "
     "angles are for information only."},
    {"K114.flat_flank_chisel_rake",
     "Chisel rake of the conventional one-plane point, -(90 - atan(cot phi / sin psi)). COMPLETION (5)."},
    {"K114.two_plane_chisel_plan_angle",
     "Half angle of the chisel edge of a point ground with two planes per flank. COMPLETION (6)."},
    {"K115.gear_rolling_quality",
     "Profile error over that of conventional rolling and accuracy grade of the rolled gear. K115, "
     "measured."},
    {"K115.hyperboloid_roller_point",
     "Point of the roller tooth surface touched at the involute roll angle psi 0..60 deg and the axial "
     "position Z = z1 + S0 of the tool gear. K115 eqs. (1), (2), repaired, with the closed form (4) of the "
     "contact angle. branch +1 is the working flank, -1 the root on the other line of action; flank +-1 the "
     "side of the tooth. Null outputs when the meshing equation has no root, which needs a centre distance "
     "other than the default."},
    {"K115.hyperboloid_roller_section_point",
     "Point of the roller profile in the plane z2 = const: the axial position is found by the secant method "
     "from Z = 0 and 1 mm to 1e-12 mm within 100 steps. Null outputs when it does not converge or a trial "
     "position has no contact. K115, section profile."},
    {"K115.roller_design_range",
     "Range of the rollers actually made. K115, text."},
    {"K115.roller_pitch_geometry",
     "Pitch diameter m z2/cos(gamma), centre distance (m z1 + d2)/2 and signed ratio -z1/z2 of a spur tool "
     "gear and a roller of helix angle gamma (0..60 deg). COMPLETION."},
    {"K115.ruled_hyperboloid_radius",
     "Radius of the blank, a one-sheet hyperboloid of revolution, sqrt(R0^2 + z^2 tan^2 gamma). K115 (5)."},
    {"K116.austenite_after_grinding",
     "Retained austenite at a depth >= 0 after grinding, linear between the depths of K116 Table 1 (10..160 "
     "um), end values outside."},
    {"K116.austenite_after_turning",
     "Retained austenite after hard turning, linear between the speeds of K116 Table 2 (20..250 m/min), end "
     "values outside."},
    {"K116.fatigue_life_cycles",
     "Mean life in rotating bending at a stress amplitude of 500..1000 MPa, lg N = A - M lg(sigma / 10 "
     "MPa). K116 eq. (3), repaired: decimal logarithms, falling, stress in kgf/mm2. Outside 1e5..1e7 cycles "
     "the value is an extrapolation; it is never clamped."},
    {"K116.fatigue_limit_MPa",
     "Fatigue limit for a base of 1e5..1e7 cycles. Inverse of fatigue_life_cycles."},
    {"K116.retained_austenite_percent",
     "Retained austenite from the integral intensities >= 0 (not both 0) of the (110) alpha and (111) gamma "
     "X-ray lines, 100 S_gamma / (0.66 S_alpha + S_gamma). K116 eq. (1)."},
    {"K116.tempered_zone_depth",
     "Depth range of the high-temperature-tempered zone. K116, text."},
    {"K116.turned_fatigue_limit_vs_speed",
     "Fatigue limit at 1e7 cycles after hard turning, linear between the printed limits at 50, 100 and 200 "
     "m/min and their end values outside. COMPLETION."},
    {"K116.xray_principal_stress_sum",
     "Sum of the principal residual stresses, E/mu cot(Theta) dTheta, from the shift of the Bragg angle "
     "(machined minus initial) at normal incidence; tension positive. E > 0, 0 < mu <= 0.5, 0 < Theta < 90 "
     "deg. K116 eq. (2)."},
    {"K117.age_replacement_cost_rate",
     "Long-run cost per cutting minute of age replacement: [R Q1 + (1-R) Q2]/M at tau > 0. COMPLETION."},
    {"K117.block_replacement_cost_rate",
     "Long-run cost per cutting minute of block replacement: [Q1 + Q2 H(T)]/T, 0 < T <= 50 means. "
     "COMPLETION."},
    {"K117.change_costs",
     "Cost of a planned change Q1 = (E + a_set) t_c1 + A_u/K_1 + A_z1 and of a failure Q2 = (E + a_set) "
     "t_c2 + C_d + A_u/K_2 + A_z2.   K117 section C, reconstructed from the printed derivative."},
    {"K117.failure_penalty_for_gamma",
     "Failure cost Q2 at which gamma > exp(1/(b mu) - 1) is the local minimum of eq. (4) with a = 0."},
    {"K117.gamma_percent_life",
     "Age survived with probability gamma in (0, 1); 0 for the normal law from gamma = Phi(1/cv) on. K117 "
     "section B. COMPLETION."},
    {"K117.insert_consumption",
     "Inserts per cutting hour when edges are changed at T_gamma: N = 60/(K_eff M(T_gamma)).   K117 eq. "
     "(9)."},
    {"K117.insert_cycle_availability",
     "Stationary availability of a two-edge insert as a semi-Markov process (states 1 edge 1 with reserve, "
     "2 edge 1 alone, 3 edge 2, 4 indexing, 5 insert change):  K_r = U/(U + W).   K117 eq. (1c): eq. (1) "
     "repaired (1/t is a scheduled age, the denominator is the mean restoration time, the fraction was "
     "inverted)."},
    {"K117.insert_cycle_availability_edges",
     "The same for an insert of 1..8 edges. K117 section A, \"n edges\". COMPLETION."},
    {"K117.joint_speed_gamma_optimum",
     "Speed and gamma of least part cost under age replacement:  T* = (mu-1) q*/E, A* = t0* E mu/(mu-1), "
     "with gamma*, q* from optimal_age_replacement at unit mean.   K117 eq. (10). COMPLETION."},
    {"K117.life_reliability",
     "Reliability, density (without the atom at zero of the normal law) and hazard at an age >= 0 min (> 0 "
     "for Weibull cv > 1, whose hazard is infinite at 0). K117 section B. COMPLETION."},
    {"K117.machining_time_turning",
     "Machining time t0 = pi D L i/(1000 V S) of longitudinal turning."},
    {"K117.mean_life_for_regime",
     "Mean life at a regime (extended Taylor law; COMPLETION: the paper shows the exponent 1/mu only)."},
    {"K117.optimal_age_replacement",
     "Change age of least cost rate among 0.01..6 mean lives and run to failure, which wins ties. Root of "
     "h(tau) M(tau) + R(tau) = Q2/(Q2 - Q1), the only stationary point for a rising hazard. COMPLETION."},
    {"K117.part_cost",
     "Cost of a part at a regime under a replacement strategy: A = t0 (E + q), q the cost rate of the "
     "edges. K117 section E. COMPLETION (renewal reward, Barlow-Proschan). `block` costs a renewal function "
     "(ms)."},
    {"K117.part_cost_at_gamma",
     "Part cost when the speed is chosen so that a Weibull edge survives the period T_e with probability "
     "gamma (0.40..0.99 scheduled, 0.01..0.99 renewal).   K117 eq. (4)-(7): (4), (5) reconstructed from the "
     "printed derivative, (6) its derivative, (7) COMPLETION."},
    {"K117.part_cost_base",
     "Variable part cost A = t0 E + t_c E_T/z_T + (A_u/K + A_z)/z_T.   K117 eq. (3), repaired: K is in the "
     "legend but not in the printed formula."},
    {"K117.pulse_treatment_effect",
     "Gamma-percent life before (Weibull) and after (normal, mean times factor >= 1) magnetic-pulse "
     "treatment. K117 section F; laws and coefficients of variation from the paper."},
    {"K117.rational_gamma_consumption",
     "The gamma of least insert consumption."},
    {"K117.rational_gamma_cost",
     "The gamma of least part cost in [gamma_min, gamma_max], and the largest gamma that costs at most (1 + "
     "knee_tolerance) times as much.   Minimum of K117 eq. (4) or (7)."},
    {"K117.rational_gamma_expenditure",
     "The gamma of least total expenditure in 0.20..0.99."},
    {"K117.reliability_expenditure",
     "Manufacturing and operating expenditure of a tool of reliability gamma per period. A_v = A_v0 (ln "
     "gamma_0/ln gamma)^(k/b), A_e = C_f (1 - gamma).   K117 eq. (8), COMPLETION of Fig. 2."},
    {"K117.required_mean_life",
     "Mean life at which the period T_e is survived with probability gamma: inverse of gamma_percent_life."},
    {"K117.required_restoration_rate",
     "Common restoration rate of indexing and insert change at which the availability reaches the target in "
     "(0, 1): lambda = (n4 + n5)/[U (1/K - 1)].   Inverse of K117 eq. (1c)."},
    {"K117.restricted_mean_life",
     "M(tau) = integral of R over 0..tau = E[min(life, tau)], tau >= 0 min. K117 eq. (1), repair 1."},
    {"K117.semi_markov_steady_state",
     "Stationary distribution of a semi-Markov process with one recurrent class (transient states and "
     "periods are allowed): embedded chain by the Grassmann-Taksar-Heyman elimination, time fractions pi_i "
     "m_i / sum."},
    {"K117.series_reliability",
     "Reliability of a tool whose parts (insert, clamp, holder) must all survive: the product."},
    {"K117.speed_for_mean_life",
     "Speed that gives a mean life: inverse of mean_life_for_regime."},
    {"K117.weibull_from_moments",
     "Weibull law with a given mean and coefficient of variation: cv^2 = Gamma(1+2/b)/Gamma(1+1/b)^2 - 1,  "
     "eta = mean/Gamma(1+1/b).   K117 section B. COMPLETION."},
    {"K117.weibull_restricted_mean_series",
     "The series of eq. (1) for M(tau) of a Weibull law, terms n = 0..terms-1. The alternating series loses "
     "all digits for long ages: an error for (tau/scale)^shape > 15. restricted_mean_life has no such "
     "limit."},
    {"K118.clamp_force_at_temperature",
     "Forces at the given depth if the zone were at the given temperature, K118 eq. (6) with T in kelvin. "
     "-273 < T < C/alpha - 273."},
    {"K118.elastic_depth_from_clamp",
     "Depth, 1..60 um, that a set clamp force produces. COMPLETION. Error when the force is outside P_n(1 "
     "um) .. P_n(60 um)."},
    {"K118.elastic_grinding_state",
     "Force and temperature solved together for a given depth. COMPLETION."},
    {"K118.elastic_grinding_time",
     "Passes and main time for an allowance, without spark-out and reversal. COMPLETION."},
    {"K118.grinding_contact_geometry",
     "Kinematics of the wheel surface and the arc of contact; K118, unnumbered equations before eq. (1). "
     "The work advance between two grains is limited to the contact length (completion)."},
    {"K118.grinding_grain_cut",
     "Cut of one grain and the force factors of all grains (force = factor x flow stress); K118, brackets "
     "of eq. (1), the tangential one a completion. Error when the chip is thicker than the grain."},
    {"K118.grinding_temperature_rise",
     "Temperature rise of the surface, K118 eq. (4), with H = V_d L/(4a) (completion). Good for H > 2 or "
     "so."},
    {"K118.tangential_force_limit",
     "Tangential force that brings the allowed rise, K118 eq. (5): eq. (4) solved for the force, heat "
     "fraction outside the root."},
    {"K118.thermal_limit_state",
     "Largest depth in 1..60 um, and its clamp force, without reaching the critical temperature. "
     "COMPLETION. Not limited: 60 um; exceeded already at 1 um: 1 um."},
    {"K119.breaking_feed_predict",
     "Life and breakages from a stepped-feed test: eq. (1) read backwards, then (2), (3). COMPLETION."},
    {"K119.chipping_test_predict",
     "Breaking feed, mean life and breakages from the chipping resistance T_c > 0 s (fitted for 55..190): "
     "S_p = 0.26 T_c^0.46, T_3 = 2.28 T_c^1.35 s, q = 56.3 T_c^-0.98.   K119 eqs. (1)-(3); q clamped to "
     "0..1."},
    {"K119.insert_strength_by_thickness",
     "Load that breaks an insert of a thickness of 3.18..7.94 mm: Table 2, linear between its rows "
     "(COMPLETION)."},
    {"K119.inspection_decision",
     "Cost per minute of cutting with and without sorting the inserts. COMPLETION (renewal reward)."},
    {"K119.life_model_from_chipping_test",
     "Life of a lot for the simulation: Weibull with the mean of eq. (2); it ends by breakage with "
     "probability breakage_fraction, else by wear. COMPLETION."},
    {"K119.lot_acceptance",
     "Probability of accepting a lot by the geometric mean of T_c of a sample. COMPLETION."},
    {"K119.lot_mean_correlation",
     "Correlation of the sample mean with the lot mean of ln T_c. COMPLETION."},
    {"K119.optimal_reject_fraction",
     "Reject fraction of least cost on 0.01, 0.02 .. 0.90, or 0 when doing without is as cheap. COMPLETION."},
    {"K119.reject_fraction_for_target",
     "Share to reject so that the accepted hold target_bad_fraction of bad ones: 0 when nothing needs "
     "rejecting, 1 and not feasible when rejecting 0.999 is not enough. COMPLETION."},
    {"K119.required_chip_resistance",
     "Chipping resistance at which a lot meets both targets: eqs. (2), (3) inverted, the larger. "
     "COMPLETION."},
    {"K119.screen_by_correlated_test",
     "Sorting by a test whose score correlates with the property (0 <= rho <= 0.995, Gaussian copula); the "
     "lowest reject_fraction of the scores is rejected. COMPLETION (Taylor-Russell selection)."},
    {"K119.screened_life",
     "Life of the accepted inserts; the equivalent Weibull law has their mean and cv. COMPLETION."},
    {"K119.screened_survival",
     "Survival of all and of the accepted inserts at a time >= 0 min. COMPLETION."},
    {"K119.stepped_feed_applicable",
     "Whether a lathe can run the stepped-feed test: holder <= 32 mm, insert <= 6.35 mm, and feed and power "
     "of Table 2 within the machine's (COMPLETION)."},
    {"K119.stepped_feed_test",
     "Steps, time and length of cut until the edge breaks in a stepped-feed test. COMPLETION."},
    {"K119.strength_test_score",
     "Total score of a strength-test method: the sum, the weights are inside the scores.   K119 Table 1."},
    {"K119.treatment_variant",
     "Test and service results of T5K10 inserts by edge treatment.   K119 Tables 3 and 4."},
    {"K119.ultrasonic_failure_cycles",
     "Cycles to destruction on the ultrasonic stand from the cycles to an indicator: N_p = 0.91 N_c^0.84 "
     "(shift of the parts), N_p = 2.65 N_k^0.55 (contact damage).   K119 eqs. (4), (5). Beyond N_p = N_c or "
     "N_k an error: the indicator would come after the destruction."},
    {"K119.weibull_from_mean_cv",
     "Weibull law with a mean life and a coefficient of variation of 0.05..3. COMPLETION."},
    {"K120.deep_drilling_time",
     "Spindle speed n = 1000 v / (pi D), feed rate s n and time 1000 L / (s n); all inputs > 0. COMPLETION "
     "(kinematics): equals the sliding path over the cutting speed."},
    {"K120.fit_pad_wear",
     "Least-squares a, b, c of h = a L^b + c through at least 4 measurements (lengths increasing, positive; "
     "wear not all equal). COMPLETION: variable projection, b on the grid 0.10, 0.11 .. 4.00 with the "
     "linear least squares of a and c inside, then golden section between the grid neighbours of the first "
     "minimum."},
    {"K120.pad_length_from_path",
     "Drilled length in which a pad point slides `path_m`. Inverse of pad_sliding_path."},
    {"K120.pad_length_to_wear",
     "Drilled length at which the wear > 0 is reached; the shift when wear <= c. Inverse of "
     "pad_radial_wear."},
    {"K120.pad_life",
     "Drilled length at which the lead-in begins to move, at which the pads are due, and whole holes until "
     "then (0 when the pads do not last one hole). COMPLETION."},
    {"K120.pad_radial_wear",
     "Radial wear of one pad point: 0 up to the shift, then max(0, a (L - shift)^b + c). K120 eq. (1). L >= "
     "0, a > 0, b > 0, shift >= 0, c of any sign. The shift and the zero before it are a COMPLETION."},
    {"K120.pad_sliding_path",
     "Path of a pad point along the hole wall, l = pi D L / s; all inputs > 0. The helix adds less than "
     "1e-6. K120, not printed as a formula: recovered from the 35168 m and 23445 m of the text and Table 1."},
    {"K120.pad_state",
     "State of a pad after a drilled length: the ten points follow one law, each shifted by the same length "
     "behind its predecessor. Replace when point 8 shows wear. COMPLETION."},
    {"K120.pad_wear_effect",
     "What a radial wear h >= 0 does: 2 h less diameter over the pads, h more insert overhang, and the "
     "lead-in lost from 0.04 mm on (the cautious end of the printed 0.04-0.05, where \"um\" is repaired to "
     "mm)."},
    {"K121.emf_cutting_speed",
     "v = (501 - 41 E) K_v/(T^0.2 t^0.15 S^0.35 E^0.24).   K121 eq. (2) as printed."},
    {"K121.emf_group_plan",
     "Speed of each group at equal life, and life of each group at equal speed, at its mean EMF. "
     "COMPLETION."},
    {"K121.emf_life_scatter",
     "Share of the life scatter that sorting removes (lognormal life, law of total variance). COMPLETION."},
    {"K121.emf_limit_for_regime",
     "Largest E that still gives the life at the speed; 0 and not feasible when E = 0.05 mV is too slow. "
     "COMPLETION (eq. (2) solved for E)."},
    {"K121.emf_room_correction",
     "EMF at the reference temperature of the cold side:  E (100 - T_ref)/(100 - T_room). COMPLETION."},
    {"K121.emf_screened_life",
     "Mean life when only inserts with E <= limit are used. COMPLETION."},
    {"K121.emf_sensitivity",
     "d ln v/dE = -41/(501 - 41 E) - 0.24/E and five times that for the life. COMPLETION."},
    {"K121.emf_sort_groups",
     "Bounds, shares and mean EMF of the groups, lowest EMF (best group) first. COMPLETION."},
    {"K121.emf_speed_coefficient",
     "c_v = (501 - 41 E)/E^0.24, 0 < E < 501/41 mV.   K121 eq. (2), all of E in one factor."},
    {"K121.emf_tool_life",
     "Eq. (2) solved for the tool life."},
    {"K121.handbook_cutting_speed",
     "v = C_v K_v/(T^m t^x S^y).   K121 eq. (1)."},
    {"K121.multi_insert_set_life",
     "Median life of a set of n inserts, which ends with the first of them, drawn at random and from one "
     "group. median exp(-u s), u = Phi^-1(2^(-1/n)). COMPLETION."},
    {"K201.bearing_excitation_regime",
     "Conclusions 1-3: growth beats damping, or plain resonance |sqrt(a)/2 - 1| < tolerance, or neither."},
    {"K201.bearing_natural_frequencies",
     "Natural frequencies of the ring on the stiffness matrix, ascending, eqs. (1), (2); 0 for an "
     "eigenvalue that is not positive."},
    {"K201.bearing_static_stiffness",
     "Stiffness at rest with a fixed contact angle 5..40 deg (Hertz, Hamrock-Brewe). COMPLETION."},
    {"K201.bearing_stiffness_at_speed",
     "Quasi-static stiffness at speed with constant axial preload (Jones). COMPLETION; does not reproduce "
     "the paper's bearing. Error when the centrifugal load is too large for the preload."},
    {"K201.cage_speed_ratio",
     "Cage speed over spindle speed, rotating inner ring: (1 - d cos(alpha) / D) / 2. COMPLETION (rolling). "
     "0 < d < D, 0..40 deg."},
    {"K201.forced_vibration_amplitude",
     "Amplitude under kinematic excitation through the spring, damper to the ground. COMPLETION. Error "
     "without damping at resonance."},
    {"K201.mathieu_floquet",
     "Stability of y'' + (a + 2 b cos 2 tau) y = 0, eq. (7), by the monodromy matrix over pi (Runge-Kutta "
     "4). -5 <= a <= 100, |b| <= 20."},
    {"K201.mathieu_parameters",
     "Parameters of Mathieu's equation for the excitation at r omega_c, eq. (8)."},
    {"K201.mathieu_zone_edges",
     "Borders of zone k = 1..10 of the Ince-Strutt diagram: the Mathieu characteristic values b_k, a_k at q "
     "= |b|."},
    {"K201.parametric_critical_speed",
     "Speed at the tip of instability zone k (a = k^2): n = 60 p / (pi k r ratio). From eq. (8)."},
    {"K201.parametric_growth_rate",
     "Net exponential growth rate with viscous damping, 1/s; negative decays. COMPLETION (exact)."},
    {"K201.parametric_speed_bands",
     "Speed bands in which the vibration grows; p(n) and K_r/K_0(n) piecewise linear in the nodes, constant "
     "outside. A band narrower than the step can be missed."},
    {"K201.principal_stiffness_modulation",
     "Mean principal stiffness and amplitude of a harmonic in every mode, eqs. (5), (6), modes ascending in "
     "K_0. Where mean eigenvalues coincide (within 1e-9 of the largest) the modes also diagonalize the "
     "harmonic. Error when a K_0 is not positive."},
    {"K201.stiffness_harmonics",
     "Fourier form (4) of stiffness samples at equal cage angles over one revolution; 1 <= harmonics < N/2. "
     "The phase of a zero harmonic is arbitrary."},
    {"K202.contact_mu",
     "Axial position at which a profile point is in contact, from n.v12 = 0. COMPLETION (Litvin). The "
     "normal need not be of unit length. Error where its rotated x component vanishes."},
    {"K202.gear_generation_time",
     "Main time along the generator, feed per gear revolution. COMPLETION."},
    {"K202.gear_tooth_point",
     "Point of the generated tooth surface: involute tool, meshing, eq. (2)."},
    {"K202.generating_setup",
     "r1 = m z1 / 2, r2 = m z2 / (2 cos gamma), a_w = r1 + r2, u21 = -z1/z2 (external). COMPLETION; spur "
     "tool."},
    {"K202.hyperboloid_blank_radius",
     "Radius of the hyperboloid of the tool's generator nearest to the gear axis, sqrt((a_w - r)^2 + z2^2 "
     "tan^2 gamma). 0 < r < a_w, 0..89 deg."},
    {"K202.involute_tool_profile",
     "Involute profile of the tool with the roll parameter 0 < t < 1.2 (tan alpha at the pitch circle), and "
     "its derivatives. COMPLETION: the paper leaves the profile open."},
    {"K202.normal_curvature",
     "Normal curvature in a direction, eq. (10). Error for a zero direction."},
    {"K202.producing_surface_geometry",
     "Unit normal, first and second quadratic form and principal curvatures of the tool tooth surface, eqs. "
     "(5)-(11). Repaired: sign of n_y and of K_mu. Error where df1 = df2 = 0."},
    {"K202.sliding_cutting_speed",
     "Sliding speed at the pitch point, 2 pi r1 n1 tan(gamma). Derived from eq. (2)."},
    {"K202.tool_to_gear_transform",
     "Point of the tool in the gear's frame, eq. (2), repaired so that the map is a rigid motion. phi2 = "
     "phi1 u21."},
    {"K203.dressing_depth",
     "Depth of dressing that restores the arc, K203 eq. (17); alpha from the wheel axis direction (90 = "
     "crown)."},
    {"K203.dressing_volume",
     "Abrasive lost in one dressing; counts the worn layer too. Width <= 2 rho, depth < R_u."},
    {"K203.effective_groove_radius",
     "Radius of the groove arc at its bottom, second-order envelope. COMPLETION. For a nut the wheel must "
     "be smaller than the groove bottom."},
    {"K203.grinding_removal_rate",
     "Removal rate with wear, elastic retreat and grain coverage; K203 eq. (16) repaired, with the straight "
     "traverse of the wheel along the groove (completion)."},
    {"K203.groove_grinding_time",
     "Passes, working stroke and time per part. COMPLETION."},
    {"K203.groove_profile_fit",
     "Least-squares arc (algebraic) of the section made by a toroidal wheel, sampled from -phi_max to "
     "phi_max."},
    {"K203.ground_groove_point",
     "Axial-section point of the groove made by a toroidal wheel, K203 eqs. (12)-(15). |phi| <= 60. Error "
     "without a contact within 25 deg of the line of centres."},
    {"K203.helical_groove_point",
     "Point of the groove surface and its unit normal, away from the part axis at theta = 0; K203 eqs. "
     "(1)-(3). |phi| < 90, R + rho cos(phi) > 0."},
    {"K203.pass_form_error",
     "Groove left by an intermediate pass with the wheel dressed for the final groove at the final "
     "settings; K203 eqs. (4)-(15), the paper's Delta_kj."},
    {"K203.pass_schedule",
     "Settings of every working pass of the narrow tilted wheel: groove radius, centre distance and tilt. "
     "COMPLETION of the process the paper proposes."},
    {"K203.plunge_length",
     "Infeed path of the copying method, stock / cos(largest rise angle of the profile)."},
    {"K203.removed_volume",
     "Metal removed from one part, exact for a section swept along the helix. COMPLETION."},
    {"K203.tilt_for_radius",
     "Tilt that makes the wanted radius, from the aligned position up to 40 deg further. COMPLETION. Error "
     "unless the radius lies between those of both ends."},
    {"K203.wheel_profile_point",
     "Contact point and wheel profile point for the groove angle phi, K203 eqs. (4)-(11): the normal meets "
     "the wheel axis. |phi| <= 60, |tilt| <= 15. Error without a contact within 40 deg, or where the wheel "
     "would undercut the groove."},
    {"K203.wheel_wear_per_part",
     "Radial wear and dressings per part from the grinding ratio. COMPLETION."},
    {"K204.clutch_coefficients",
     "Published ranges of the coefficients. The tripping frequency of the cone clutch is not published: 1."},
    {"K204.clutch_cost_rate",
     "Rates per minute of cutting and availability 1 / (1 + sum rate * downtime), renewal-reward."},
    {"K204.clutch_dynamic_factor",
     "Dynamic factor, piecewise linear through (0, 1) and the published points, last segment extrapolated; "
     "0..600 rpm. COMPLETION (interpolation)."},
    {"K204.clutch_dynamic_factor_inertial",
     "Dynamic factor from stored kinetic energy, K_d = 1 + omega sqrt(J c) / T. COMPLETION."},
    {"K204.clutch_max_speed",
     "Highest speed with a non-empty window, at most 600; 0 if none. Says nothing about re-engagement."},
    {"K204.clutch_reengage_torque",
     "Torque below which the clutch re-engages, K_ch T. COMPLETION."},
    {"K204.clutch_set_torque_drift",
     "Setting after N trips, T K_s^(N / N_ref). COMPLETION."},
    {"K204.clutch_setting_window",
     "Settings without false trips and with the drive protected, equation (e)."},
    {"K204.clutch_static_trip_torque",
     "Static trip torque of a pin or ball in a pocket, F R tan(alpha + arctan mu); none when self-locking. "
     "COMPLETION. Friction of the sliding flange is left out."},
    {"K204.clutch_stop_event",
     "Downtime and impacts of one overload stop, equation (j). Polygon-slot clutches stay open above 170 "
     "rpm."},
    {"K204.clutch_test_metrics",
     "Coefficients of an own test series; lists may differ in length. Equation (l)."},
    {"K204.clutch_trip_band",
     "Band of the trip torque: T_min = 2 T / (1 + K_T), T_max = K_T T_min, sigma a sixth of its width. "
     "COMPLETION."},
    {"K204.motor_torque",
     "T = P / omega."},
    {"K204.optimal_clutch_setting",
     "Setting in [T_c (1 + K_T) / 2, T_b] with the least expected cost per spike; error unless T_b lies "
     "above the lower end. The optimum may be T_b: then the clutch does not pay."},
    {"K204.overload_spike_outcome",
     "Probabilities per spike, equation (f): the demand T_c (1 + X), X exponential, meets a normal "
     "threshold. COMPLETION. 1 < K_T <= 1.5."},
    {"K204.torque_growth_trip_time",
     "Cutting time until torque growing with tool wear trips the clutch; 0 if it is already above."},
    {"K205.aggregate_criteria",
     "Additive sum w E, multiplicative prod E^w or minimum, weights rescaled to sum 1; a value of weight 0 "
     "is left out in every form. Values >= 0."},
    {"K205.criteria_conflict",
     "Kendall tau-b between the criteria (0 against a constant criterion, 1 on the diagonal), the first "
     "best alternative of each, and the Pareto set (equal alternatives are all kept). COMPLETION."},
    {"K205.criterion_cost_per_conforming",
     "Criterion 3: cost over the probability that a released part conforms, C / p'."},
    {"K205.criterion_cost_per_reliability",
     "Criterion 7: cost over the failure-free probability of a mission."},
    {"K205.criterion_dynamic_information",
     "Criterion 8: actual over ideal rate of information, (I_p / I_n) (T_0 / T), with I_p / I_n = 1 for I_n "
     "= 0."},
    {"K205.criterion_economic",
     "Criterion 9: (QJ - (PR + PZ)) / QJ; negative when costs exceed the output."},
    {"K205.criterion_effect_per_cost",
     "Criterion 10: effect per cost, D / C."},
    {"K205.criterion_generalized_ratio",
     "Criterion 2: actual over required value of a probability-like quality index."},
    {"K205.criterion_information_per_cost",
     "Criterion 5: information per unit of generalized cost w_c C / C_ref + w_m m / m_ref + w_k k / k_ref."},
    {"K205.criterion_information_ratio",
     "Criterion 1: information that the diagnosis gives about the state of the object over the entropy of "
     "that state; 1 when the state is certain. Counts >= 0, at least one object. Blind to the sign: a "
     "diagnosis that is always wrong also gives 1."},
    {"K205.criterion_inspection_set",
     "Criterion 4: C / (1 - q_0 sum (1 - P_i) q_i). Repaired: printed with two different indices."},
    {"K205.criterion_socio_ergonomic",
     "Criterion 6: f(E_T, E_S, E_W), f one of the forms of aggregate_criteria."},
    {"K205.criterion_yield_ratio",
     "Criterion 2, yield form: share of the good output that survives the diagnosis, tn / (tn + fp)."},
    {"K205.efficiency_increments",
     "Derivative (E - E_0) / (x - x_0) and elasticity (times x_0 / E_0) of one changed parameter per entry."},
    {"K205.evaluate_all_criteria",
     "All ten criteria of a simulation result; a criterion whose denominator is zero in this run is empty. "
     "Meanings of the letters: COMPLETION."},
    {"K205.goal_composition_feasible",
     "States common to all required functions, ascending; infeasible when there is none."},
    {"K205.hierarchical_efficiency",
     "Normalized criteria combined into groups and groups into one value. A normalized criterion below its "
     "minimum, or a minimum for a criterion that is left out, makes the result infeasible; the value stays."},
    {"K205.normalize_criterion",
     "(value - worst) / (best - worst) clipped to 0..1; best may be below worst (cost criteria). "
     "COMPLETION."},
    {"K205.optimal_inspection_set",
     "Set of inspection operations with the least criterion 4, P_i = 1 - prod (1 - d_ki). Up to 20 "
     "operations every subset is tried; ties within 1e-12 go to fewer operations, then to lexicographic "
     "order. Above 20 the best single addition or removal is taken from the empty set until none improves. "
     "COMPLETION (product rule, search)."},
    {"K205.select_by_relaxed_criterion",
     "Alternative that meets the hardest criterion: the highest efficiency within levels 1 and 2 (first on "
     "ties); at level 3 the least discrepancy (rounded to 12 decimals), then most targets within the "
     "thresholds, then the first. COMPLETION (tie rules)."},
    {"K205.target_match",
     "Hardness of the criterion that is met: 1 exact, 2 lower < required - achieved < upper for all "
     "targets, 3 best approximation. Discrepancy: mean of |required - achieved| / scale."},
    {"K206.chatter_limit_width",
     "Stable width of cut 1 / (2 K_s u |min Re G|) (Tlusty). COMPLETION. min Re G < 0, else there is no "
     "limit."},
    {"K206.harmonic_influence",
     "Harmonic influence coefficient alpha_ij: displacement at section i from a unit force at section j. "
     "Repaired: the last term exists only for i > j. Error at a natural frequency and where the frequency "
     "is too high for transfer matrices (sum of lambda L above 25)."},
    {"K206.krylov_functions",
     "Krylov functions of 0 < x <= 700. Definitions under eq. (1)."},
    {"K206.max_spindle_speed_dn",
     "Bearing speed limit dn / d."},
    {"K206.nose_compliance",
     "Compliance of the joint system at a spindle section by receptance coupling, with hysteretic damping "
     "of both rods and all springs, loss factor 0..0.2. COMPLETION."},
    {"K206.required_mount_stiffness",
     "Smallest equal seat stiffness in [k_lo, k_hi] with p_mode >= target; k_lo if that is enough, error if "
     "k_hi is not. COMPLETION."},
    {"K206.resonance_speed_bands",
     "Forbidden bands 60 p (1 -+ margin) / h, cut at n_min and n_max; empty ones dropped, overlapping or "
     "touching ones joined. COMPLETION."},
    {"K206.rod_natural_frequencies",
     "First `count` natural frequencies of a rod between 1 Hz and 20 kHz, ascending; rigid motions at 0 Hz "
     "are left out. Fewer come back when there are fewer."},
    {"K206.segment_transfer_matrix",
     "Dimensionless 4x4 matrix of one segment, state {y, l phi, a M, b Q}. COMPLETION (Krylov): not "
     "printed."},
    {"K206.spindle_base_natural_frequencies",
     "Natural frequencies of the joint system, zeros of the determinant (4), as rod_natural_frequencies."},
    {"K207.closed_loop_spectral_radius",
     "Largest modulus of the roots of A D + z^-delay B F; stable below 1, 0 without roots. From eqs. (6), "
     "(7)."},
    {"K207.drive_polynomial",
     "Denominator of the drive, K207 eq. (5): (T_M p + 1)[(product of four lags) - 1] / p."},
    {"K207.entropy_interval",
     "Entropy interval of uncertainty exp(H)/2, H the differential entropy of the law; K207 second eq. (2) "
     "corrected."},
    {"K207.feed_change_time",
     "Time of n passes while the feed follows a change; the first pass still runs at the old feed. "
     "COMPLETION."},
    {"K207.feed_channel_block",
     "Frequency response of blocks (1)-(5) at p = j 2 pi f; phase in (-180, 180]."},
    {"K207.feed_channel_step_response",
     "Response of the closed loop to a unit step. COMPLETION (plant)."},
    {"K207.feed_loop_spectral_radius",
     "Stability of the same loop without dead band."},
    {"K207.longitudinal_feed",
     "Measured feed of one pass, S = l / t."},
    {"K207.longitudinal_pass_time",
     "Time of one pass; inverse of longitudinal_feed."},
    {"K207.reference_model_numerator",
     "Coefficients of z^-1 and z^-2 of the reference model, K207 eq. (9)."},
    {"K207.regulator_gains",
     "Controller (14) regrouped into P, I and D with its real zeros, zero_1 <= zero_2."},
    {"K207.regulator_polynomials",
     "Polynomials of the controller, K207 eqs. (10)-(12). All a nonzero."},
    {"K207.regulator_step",
     "One step of the controller: u = u_prev + (n0 e0 + n1 e1 + n2 e2) / d0. K207 eq. (14)."},
    {"K208.attack_angle_cycle",
     "Attack angle over one drill revolution, samples 0, step, ..., 360 - step; active means chi > 0."},
    {"K208.azimuth_offset_x_max",
     "Largest modulus of T_X that keeps the working gap, eq. (1); negative: the drill does not fit."},
    {"K208.azimuth_offset_z",
     "Vertical offset (H - D sin xi) / 2."},
    {"K208.chisel_edge",
     "Corner of the chisel edge at x > 0 (y = -core radius) and its exact angle to the x axis at the drill "
     "axis."},
    {"K208.chisel_edge_point",
     "Point of the chisel edge, intersection of both cones; x = 0 is the drill axis."},
    {"K208.cone_grind_setup",
     "Position of the grinding cone for the wanted clearance and chisel angle, eq. (2), repaired. Error "
     "when the drill admits none (l_0 <= 0) or the web is as thick as the drill."},
    {"K208.cutting_edge_point",
     "Point of the cutting edge of flank 1 at a radius above the core radius, in the plane y = -r. "
     "COMPLETION."},
    {"K208.edge_attack_angle",
     "Velocity of an edge point in the bath and attack angle of the powder, eq. (6b); positive: the flank "
     "runs into the powder. Both edges use the normal of flank 1. Frame chain: COMPLETION. Error without "
     "motion."},
    {"K208.flank_normal",
     "Outward unit normal at a point of the flank, nz < 0: gradient of the cone. The point is taken to lie "
     "on the flank."},
    {"K208.flank_point",
     "Point of flank 1 or 2, eqs. (5), (6)."},
    {"K208.kinematic_efficiency",
     "Kinematic efficiency index by interpolation of three published points, 0..90 deg, feed ratio -3."},
    {"K209.depth_modulation",
     "Swing of the depth of cut, amplitude over depth."},
    {"K209.flat_grinding_waviness",
     "Waviness of one pass: envelope of a wheel that oscillates with one harmonic. Up to the critical "
     "amplitude 1/(k^2 R) the height is 2 A, above it the wheel no longer reaches into the troughs. "
     "COMPLETION."},
    {"K209.headstock_amplitude",
     "Vibration of the spindle housing at the rotation frequency, linear in the offset (in phase: worst "
     "case). COMPLETION."},
    {"K209.rotation_frequency",
     "First harmonic, n / 60."},
    {"K209.significant_harmonics",
     "Harmonics with an amplitude of at least the threshold."},
    {"K209.unbalance_force",
     "Centrifugal force m e omega^2. COMPLETION."},
    {"K209.wheel_radial_displacement",
     "x(t) = sum of A_k cos(2 pi k f t + phi_k). Lists of the same length."},
    {"K209.wheel_speed",
     "Peripheral speed, pi D n / 60000."},
    {"K209.wheel_vibration_amplitude",
     "Measured amplitude of the wheel axis, K209 data (3D711AF11, 2230 1/min). The device was not measured "
     "idle."},
    {"K210.bearing_losses",
     "Petroff friction on the lands, pump power and adiabatic temperature rise; viscosity as given."},
    {"K210.bearing_serviceable",
     "Film at least h_allow and outlet at most t_allow: the paper's criteria."},
    {"K210.centring_load_capacity",
     "Largest load towards pocket 0 that individually set regulators carry with zero displacement, without "
     "rotation; feedback_gain and spindle_rpm are not used."},
    {"K210.oil_viscosity",
     "Reynolds' law, mu_0 exp(-beta (T - T_0))."},
    {"K210.pocket_state",
     "Pocket pressures, flow and film force on the shaft at a displacement below the clearance."},
    {"K210.required_machine_error",
     "Machine error 3 to 5 times below the tightest part tolerance: the paper's rule."},
    {"K210.shaft_equilibrium",
     "Displacement under a load (Newton). Error when no equilibrium is found below 0.98 of the clearance."},
    {"K210.static_stiffness",
     "-dFx/dx and -dFy/dx at the centre, central difference of 0.01 um."},
    {"K301.block_path_feed",
     "Contour feed of one block. Error when the axis that carries the feed does not move. COMPLETION."},
    {"K301.feed_word_for_block",
     "F word that gives a contour feed: inverse of block_path_feed. Error for a block of no length. "
     "COMPLETION."},
    {"K301.gcode_flat_fit",
     "Least-squares line X cos(C - c0) = X0 through points of one face. COMPLETION."},
    {"K301.peak_milling_force",
     "Peak over one tooth pitch, and mean, of the total tangential force of a helical cutter (Kienzle). No "
     "arc (exit <= start) gives zeros. COMPLETION C2."},
    {"K301.polygon_contour_point",
     "Cutter centre at part angle c; dx/dc = x tan chi. Derived, implied by K301 Fig. 1."},
    {"K301.polygon_contour_summary",
     "Extremes, length and area of the contour: d = a + R, rho = a/cos(pi/N), theta_1 = atan(a "
     "tan(pi/N)/d), L = 2 N a tan(pi/N) + 2 pi R. Derived, implied by K301 Fig. 1."},
    {"K301.polygon_engagement",
     "Engaged arc of the cutter in a round blank: omega = acos[(x^2 + R^2 - R_b^2)/(2 R x)], exit = min(pi, "
     "omega - chi), start = max(0, -omega - chi). COMPLETION C1."},
    {"K301.polygon_milling_time",
     "Main time with the stabilised feed, or with one constant feed that the worst position allows: 100 "
     "midpoints on a flat, 100 on a corner. COMPLETION C4."},
    {"K301.radial_feed_for_path_feed",
     "Radial feed and C rate for a contour feed: F_x = F_e |dx/dc|/sqrt((dx/dc)^2 + x^2), omega = "
     "F_x/|dx/dc| (its limit F_e/x where dx/dc = 0). K301 eqs. (6), (2)."},
    {"K301.stabilized_path_feed",
     "Contour feed that holds the peak force at its limit, F_e = n z (P/G)^(1/(1-mc)), then the bounds "
     "feed_max, feed_min, X rate, C rate in this order; `limited_by` is the last that changed the feed. "
     "COMPLETION C3."},
    {"K301.tooth_pass_maxima",
     "Largest force of every tooth pass; the first of equal values. K301 eq. (4)."},
    {"K301.verify_gcode_feed",
     "Contour feed of an NC program whose F word is a radial feed: F_e = sqrt(F_x^2 + (x omega)^2), omega = "
     "F_x/(dx/dc), dx/dc by central differences (one-sided at the ends). K301 eqs. (1)-(3), (2) repaired. "
     "Error where dx or dc is zero."},
    {"K302.abrasive_mark_intensity",
     "Exponent nu = m + chi + 1/2, intensity G of abrasive marks (mm^-nu) and intensity Theta of tips per "
     "length (mm^-(chi+3/2)); K302, text of eqs. (4) and (12). Lengths > 0, 0 < K_C <= 1; the work may not "
     "overtake the wheel in down grinding."},
    {"K302.combined_ra",
     "Ra after dissolution, lowered as the layer is. COMPLETION C2 (in place of eqs. 9 and 10)."},
    {"K302.defect_depth_after_pass",
     "h_i = max{0, h_{i-1} - removed, introduced}, K302 eq. (17)."},
    {"K302.defect_depth_specific_work",
     "Depth of the defect layer from the heat per area, h = alpha xi (q - q_0)_+ h_q / V, and the specific "
     "work W = q h_q / (K V); K302 eq. (15), with the speed of the work as V."},
    {"K302.defect_depth_temperature",
     "Depth to which the transformation temperature reaches: K302 eq. (16) with the sign repaired, and the "
     "exact half-space solution 2 sqrt(a tau) erfc^-1(T_tr / T) (completion). Both 0 for T <= T_tr."},
    {"K302.electrochemical_removal",
     "Depth dissolved at peaks and valleys by Faraday's law at a constant gap. COMPLETION C3."},
    {"K302.extreme_height_coefficients",
     "Coefficients c of R = H - c [V_u H_u^chi / (n_3 (V_K +- V_u) sqrt(D) l)]^(1/(chi + 1/2)) for Rmax and "
     "Rz."},
    {"K302.layer_height_steady",
     "Height of the layer in which the removal probability grows to beta, and the depth that brings it: G "
     "S_nu(H) = -ln(1 - beta), t_f = H + Q. COMPLETION C1. 0 < beta < 1."},
    {"K302.median_depth",
     "Distance W_m from the deepest valley to the mean line: G S_nu(W_m) = ln 2, K302 eq. (7) with i from 0 "
     "and spark-out contacts (completion)."},
    {"K302.passes_to_reach_defect",
     "Equal passes until the defect layer is no deeper than the target; -1 when it never is. COMPLETION."},
    {"K302.profile_distribution",
     "Probability that the level y above the mean line has been removed, F = 1 - exp(-G S_nu(W_m + y)), and "
     "its density; K302 eq. (4). Both 0 at and below the deepest reach."},
    {"K302.roughness_extremes",
     "Expected Rmax and Rz over the base length, K302 eqs. (11), (12) with 1/(Theta l) for the printed Q/l. "
     "Negative when the layer is too thin for the order statistics."},
    {"K302.roughness_extremes_chi15",
     "The same for tips with chi = 1.5 and a wheel layer as deep as the cut, K302 eqs. (13), (14); constant "
     "2.948 as printed (exactly 2.94704)."},
    {"K302.roughness_layer",
     "H_mech = t_f - Q_mech and H = H_mech - (Q_peak - Q_valley), the latter not below 0; K302 eqs. (1), "
     "(2)."},
    {"K302.roughness_ra",
     "Ra = 2 / (pi G nu S_{nu-1}(W_m)), K302 eq. (6). W_m > 0 from median_depth, or half the layer (eq. 8)."},
    {"K302.roughness_ra_exact",
     "Ra, Rq and mean depth by integrating eq. (4), without the assumption of a normal profile."},
    {"K303.contact_arc",
     "Equivalent diameter and chord length sqrt(De t) of the contact. Internal: work radius above wheel "
     "radius."},
    {"K303.cutting_surface_profile",
     "Rmax along the whole arc: the top layer leaves once it is covered, and the count starts afresh on the "
     "new top."},
    {"K303.cutting_surface_roughness",
     "Largest Rmax along the arc; K303 eqs. (1)-(9), sum of grooves per interval. At most 10000 intervals "
     "in the depth."},
    {"K303.max_depth_for_protrusion",
     "Largest whole multiple of the interval up to 0.1 mm with Rmax < protrusion; 0 when there is none. "
     "COMPLETION."},
    {"K303.max_work_speed_for_protrusion",
     "Largest work speed with Rmax < protrusion, by bisection between low and high; 0 when already the low "
     "end is too fast. COMPLETION."},
    {"K303.minimum_interval",
     "Smallest multiple of the step for which at least one grain of the first layer passes, K303 eq. (10)."},
    {"K303.residual_height",
     "Largest Rmax and the height left at the end of the arc of whole intervals."},
    {"K303.scratch_width",
     "Width of the groove of a rounded cone at a depth, K303 eq. (9)."},
    {"K303.specific_removal_rate",
     "Volume per minute and mm of wheel width, 1000 V_d t_f."},
    {"K303.tip_layer_probability",
     "Share of grains whose tips lie in the i-th layer under the wheel face, K303 eq. (8)."},
    {"K304.disc_cutter_feeds",
     "S_o = S_m/n = S_z z_f. K304 Table 1, \"S_z S_f\" repaired."},
    {"K304.disc_cutter_life",
     "Tool life to 1 mm flank wear: 180 min dry, 300-360 min with coolant; coating low x 1.3, high x 1.5."},
    {"K304.disc_cutter_rpm",
     "n = 1000 V/(pi D). K304 Table 1."},
    {"K304.disc_cutter_speed",
     "V = pi D n / 1000. K304 Table 1."},
    {"K304.disc_cutter_travel",
     "Approach sqrt(t (D - t)) and travel b + approach (twice on a full exit) + 2 clearances. COMPLETION."},
    {"K304.gap_time",
     "Working stroke, return and indexing of one gap. K304 Table 1."},
    {"K304.gear_roughing_time",
     "Main time T_oi z/k as printed, and with whole strokes ceil(z/k) (COMPLETION, for the shop). K304 "
     "Table 1."},
    {"K304.insert_consumption",
     "Long-run means, not rounded: k T/T_p, ceil(z/k) T_p/T, changes x inserts x k/edges. COMPLETION."},
    {"K304.life_at_speed",
     "Taylor: T = T_ref (V_ref/V)^(1/m). COMPLETION."},
    {"K304.rack_gap_section",
     "Straight-sided section of the roughed gap; error when the bottom width is not positive. COMPLETION."},
    {"K304.recommended_regime",
     "Regime of K304 Table 2: first column to HB 217, second to HB 240; a pair of cutters takes 0.8 of the "
     "feed. The printed speed does not match the printed rpm at D = 285; both are given."},
    {"K304.split_profile_inserts",
     "Split of the gap among six positions a to f: two halves of the bottom, lower and upper halves of both "
     "flanks. COMPLETION; the paper does not say which flank insert cuts lower."},
    {"K304.split_scheme_force",
     "Tangential force of all inserts in contact, summed as a scalar over 7200 midpoints of one period "
     "(Kienzle). COMPLETION."},
    {"K305.compressive_stress_trend",
     "Trend of compressive stress with disc speed: -1 up to 50 m/s, +1 above."},
    {"K305.disc_speed",
     "Rim speed pi D n / 60000."},
    {"K305.feed_limit",
     "Feed at the edge of the published regimes: bilinear in logarithms between four corners. COMPLETION."},
    {"K305.following_allowance",
     "Smallest allowance of the following operation. COMPLETION."},
    {"K305.hardness_ratio",
     "Hardness over base hardness: the factor to 200 um, then linear to 1 at 600 um. COMPLETION."},
    {"K305.pass_time",
     "Rows times layers, and the main time. COMPLETION."},
    {"K305.published_ranges",
     "Range of a quantity as printed; its unit is part of the name."},
    {"K305.regime_in_envelope",
     "Whether a regime lies inside the published ranges, ends included; the feed is judged by the width "
     "band."},
    {"K305.removal_and_power",
     "Removal rate, cutting power and the specific energy that loads the drive fully. COMPLETION."},
    {"K305.residual_stress",
     "Residual stress below the surface, piecewise linear through the printed ends; `level` 0 = mild, 1 = "
     "severe end of the ranges. Steels 45 and 09Kh15N8Yu only. COMPLETION."},
    {"K305.surface_temperature",
     "Range of the surface temperature of a steel."},
    {"K306.auger_blank_plan",
     "Blank and mandrel of a screw: the chain of eqs. (1), (3), (6)-(9) on the radii of the tight coil."},
    {"K306.blank_thickness",
     "Thickness of the strip that leaves an edge its thickness, H0 = H sqrt(r/rho0) or h sqrt(R/rho0). r <= "
     "rho0 <= R. K306 eq. (6), repaired: printed with r for both edges."},
    {"K306.coil_stack_length",
     "Axial length of the tight coil, L H (psi - 1)/(2 pi B psi^(1/4)). K306 eq. (9), repaired: printed B^4 "
     "sqrt(psi)."},
    {"K306.groove_dimensions",
     "Slot of the mandrel that holds the end of the strip: width H + 0.1..0.2 mm, length 10..12 H. K306 "
     "item 3."},
    {"K306.longitudinal_force",
     "Longitudinal force of a rigid-plastic strip, 2 sigma_s H0 rho0 ln(sqrt(R r)/rho0): tension positive. "
     "r <= rho0 <= R. COMPLETION."},
    {"K306.mandrel_diameter",
     "Mandrel that gives the screw its inner diameter after stretching: keeps the ratio of the edge lengths "
     "of one turn, times the paper's 1 - 0.021 T/d. D > d > 0, 0.021 T/d < 1. K306 eq. (1), repaired: the "
     "-1 stands outside the root."},
    {"K306.mandrel_step_range",
     "Diameter of the step of the mandrel, 0.8..1.2 D. K306 eq. (2)."},
    {"K306.neutral_radius",
     "Neutral radius of the edge bending. R >= r > 0, rho_np > R. K306 eq. (3), repaired under the root. "
     "Rejected where it falls below r (R/r above about 20 with the force close to the outer edge)."},
    {"K306.recess_spacing",
     "Spacing of the recesses, n pi r0 + c. K306 eq. (5)."},
    {"K306.release_force",
     "Force that releases the coil, nu mu0 (8 pi k_N N + P_r). K306 eq. (10)."},
    {"K306.spring_clamp_force",
     "Force of the spring clamp, k1 k_r mu0 (2 pi n + k_f rho_cp/r) N. K306 eq. (4)."},
    {"K306.strip_length",
     "Strip of one screw: L/T turns of a helix of the neutral diameter after stretching, 2 rho0 - d0 + d > "
     "0. K306 eq. (7), repaired, and (8)."},
    {"K306.winding_time",
     "Turns, loads of the mandrel and time of winding a strip. COMPLETION."},
    {"K307.allowed_center_deviation",
     "Permitted +- deviation of the axis distance with gauges at the wear limit: T_p and half of what the "
     "holes exceed their least diameters by."},
    {"K307.axial_gap",
     "Gap at the shoulder when the hub seizes at its far end, an upper bound: alpha l (t_seize - t_room). "
     "COMPLETION."},
    {"K307.gauge_accepts",
     "Whether both gauges enter: C + (D1 + D2)/2 >= B_outer and C - (D1 + D2)/2 <= B_inner. A fit to within "
     "1e-9 mm counts as equality, which accepts. The inner half is COMPLETION."},
    {"K307.gauge_inner_span",
     "Gauge over the near walls, the mirror image: B_W = L - (D1 + D2)/2 + T_p, new sizes below it. "
     "COMPLETION."},
    {"K307.gauge_life_checks",
     "Checks left to the wear limit. COMPLETION. Which side of the limit is new is for the caller to know."},
    {"K307.gauge_outer_span",
     "Gauge over the far walls of the holes: B_W = L + (D1 + D2)/2 - T_p, B_min and B_max above it by the "
     "mean W and F. K307, formulas of the text."},
    {"K307.gauge_pass_probability",
     "Probability that a part passes both gauges, distance and diameters normal and independent. "
     "COMPLETION."},
    {"K307.heating_temperature",
     "Temperature at which the hub slides on with a clearance: t_room + (delta + clearance)/(alpha d). "
     "COMPLETION."},
    {"K307.reduced_deviation",
     "Deviation from the middle of the tolerance in halves of it: -1 and +1 at the limits. COMPLETION."},
    {"K308.bushing_life",
     "Holes until a bushing with the wear ratio k3 > 0 is worn out, wear proportional to path. COMPLETION."},
    {"K308.bushing_wear_ratio",
     "Wear of a bushing that turns with the drill over that of a fixed one, K308 eq. (1): k3 = k1 (1 + k2) "
     "/ (sqrt(4 pi^2 r^2 + S1^2)/S1 + k2 sqrt(4 pi^2 r^2 + S2^2)/S2) k1 > 0 factor for the lag of the "
     "bushing, 0 <= k2 <= 1 factor for the smaller normal force on the return stroke, drill radius r, feeds "
     "S1 and S2 of cutting and return > 0. Optimistic: almost complete entrainment."},
    {"K308.bushing_wear_ratio_slip",
     "As bushing_wear_ratio, from the share of circumferential sliding 0..1 instead of the factor k1. "
     "COMPLETION. For planning take a slip of 0.01-0.05."},
    {"K308.gauge_error",
     "Error of the measuring device, the root of the sum of squares. K308 eq. (3), repaired: printed 2/p "
     "for p^2."},
    {"K308.head_angle",
     "Angle between the arms for a centre distance, 180 deg when it is out of reach; `ok` when the gears "
     "clear each other (d_gear <= A) and reach (A <= d_pinion + d_gear). COMPLETION. Tip circles ask two "
     "modules more."},
    {"K308.head_center_distance",
     "Distance of the two spindles, (d_pinion + d_gear) sin(phi/2), phi 0..180 deg between their arms, both "
     "gears in mesh with the central pinion. COMPLETION (geometry)."},
    {"K308.inspection_accept_probability",
     "Probability that a part of true value x is measured inside the limits (both included) when the "
     "measuring error is normal with sigma = eps/k; without error 1 inside, 0 outside. COMPLETION."},
    {"K308.multi_spindle_drilling",
     "Drill speed n z_pinion/z_gear, strokes ceil(holes/drills) and main time with indexing between "
     "strokes. COMPLETION."},
    {"K308.setup_error",
     "Error of setting up, the root of the sum of squares of its components >= 0. K308 eq. (2)."},
    {"K308.sliding_path",
     "Sliding of the drill margin along the bushing wall in one stroke, depth * sqrt((2 pi r s)^2 + S^2) / "
     "S: slip s = 1 for a fixed bushing, 0 for a fully entrained one. Between them COMPLETION."},
    {"K309.grain_position",
     "Point of grain k at a time: x = k dh + V_S t, y = R cos(V_n t/R), z = +-R sin(V_n t/R). K309 eqs. "
     "(1)-(3), repaired: printed V_n t/(2 pi R), which is revolutions, not an angle."},
    {"K309.ground_state",
     "Surface after grinding, before finishing. K309 text; the middle of the printed 0.30-0.32."},
    {"K309.mao_pass_time",
     "Time of the passes of the row over a width, passes (width + (K - 1) dh)/V_S. COMPLETION."},
    {"K309.mao_result",
     "Whether a setting lies in the recommended window, and the roughness published for it. K309 "
     "conclusions."},
    {"K309.oscillating_grain_position",
     "As grain_position, with a triangular oscillation along the axis around the mean feed. COMPLETION."},
    {"K309.oscillation_frequency",
     "Frequency of the axial oscillation. Printed f = V_S/A counts strokes of length A; a cycle is 2 A when "
     "A is the stroke and 4 A when it is the amplitude."},
    {"K309.roughness_after_mao",
     "Roughness after a time of finishing, Ra_f + (Ra_0 - Ra_f) exp(-t/tau). COMPLETION."},
    {"K309.scratch_length",
     "Path of a grain, t sqrt(V_n^2 + V_S^2)."},
    {"K309.scratch_pattern",
     "Helix of one grain and its crossing with that of the opposite rotation. From eq. (1), repaired."},
    {"K309.track_max_gap",
     "Largest axial distance between neighbouring tracks of a row of grains. COMPLETION."},
    {"K310.constriction_resistance",
     "Constriction resistance of n equal independent round spots, R = rho / (2 n a). COMPLETION (Holm). The "
     "cold resistivity underestimates a hot spot."},
    {"K310.constriction_temperature",
     "Highest temperature of a quasi-steady constriction with the voltage drop U >= 0: T^2 - T_0^2 = U^2 / "
     "(4 L) in kelvin, L = 2.4e-8 V^2/K^2.   K310 eq. (2), repaired: printed L (U/4)^2. Upper bound for "
     "pulses shorter than the settling time."},
    {"K310.constriction_voltage",
     "Voltage drop that heats the constriction to T >= T_body. Inverse of constriction_temperature."},
    {"K310.contact_heat_power",
     "Heat released in the constriction, P = I^2 R. Current any sign, resistance >= 0. K310 eq. (1)."},
    {"K310.current_density",
     "Current density j = I / area."},
    {"K310.pulse_energy",
     "Heat of one rectangular pulse, E = I^2 R tau."},
    {"K310.quasi_steady",
     "Whether the spot reaches its steady temperature within the pulse; both limits count as intermediate."},
    {"K310.setup_feasible",
     "Whether the published set-up can generate the pulse and whether its sensors can record it."},
    {"K310.specific_power",
     "Heat power per area of real contact, p = P / (n pi a^2). COMPLETION."},
    {"K310.treatment_time",
     "Pulses and time to cover an area spot by spot with overlapping spots. COMPLETION."},
    {"K311.best_lap_reset",
     "Parts between lap resets with the least mean piece time t_1 (1 + g (n - 1) / 2) + T_p + T_c / n, n = "
     "1..n_max; the smallest n within 1e-12 min of it. COMPLETION (renewal-reward)."},
    {"K311.cycle_constraints",
     "In-process limits (9)-(12), equality allowed (slack 1e-12 um in (9), (10)). (10) repaired: printed "
     "with h_dj on both sides; the defect depth of the finished part stands on the right."},
    {"K311.cycle_time_with_lap_wear",
     "Cycle time of part j of a lap life, growing linearly to `ratio` at the last part (printed: 1.38). "
     "COMPLETION (linear). Error: j outside 1..n_life."},
    {"K311.final_conditions",
     "End conditions (7), (8); equality passes."},
    {"K311.grain_depth_parameters",
     "Mean and standard deviation of the depth of grain penetration a = d - u_1 - u_2. Table 1, row 1."},
    {"K311.grain_depth_pdf",
     "Density of the penetration depth, zero outside 0..t_f. Table 1, row 1; the normalization mu to 0..t_f "
     "is a COMPLETION. Error when the law has no mass in 0..t_f that a double can hold."},
    {"K311.lapped_roughness",
     "Mean removal, Ra (exact mean absolute deviation) and R_max = 6 Ra of a surface that started flat. "
     "Table 1, rows 1-3."},
    {"K311.lapping_cycle",
     "State after the passes, eqs. (1)-(5). Removals >= 0; sign -1 as printed, +1 for a concave groove; 1 "
     "or 2 lapped sides. The floors of roughness and defect depth and `sides` are COMPLETION: (3) as "
     "printed runs below zero. A negative allowance means that too much was removed. Errors: no radius, a "
     "pass of another length."},
    {"K311.lapping_force",
     "Grains in contact and total normal force. Table 1, row 4, repaired (the total on the left side, a "
     "stray l dropped); the force of a single grain, c pi a (d - a) HV, is a COMPLETION."},
    {"K311.non_removal_probability",
     "Probability that no grain has touched the level y below the outermost line, Table 1, row 2, repaired: "
     "P = exp(-(chi V t / l_0^2) * integral over a in y..t_f of sqrt((a - y)(d - a + y)) f(a)). Printed "
     "with a positive exponent and the density at a - y. Errors: t_f > d."},
    {"K311.piece_cost",
     "Cost of a part, eq. (14), repaired: the lap resets are divided by the parts of the batch, as in (13)."},
    {"K311.piece_time",
     "Piece time, eq. (13): t = Pi K / Q + T_p + T_c n_c / n_parts."},
    {"K311.preston_rate",
     "Preston's removal rate, Q = k (P / A) V. COMPLETION."},
    {"K311.switch_allowance",
     "Least allowance at which the forced stage must end: max(0, R_f - R_d, R_f + h_f - R_d - h_d), the "
     "exact consequence of (9), (10)."},
    {"K311.two_stage_time",
     "Times of the forced and the finishing stage. COMPLETION. An allowance below the switching one leaves "
     "only the second stage."},
    {"K312.endurance_after_dose",
     "Endurance limit over the hardening dose, intensity times time: linear between the four tested doses, "
     "constant above the largest. COMPLETION, an engineering guess."},
    {"K312.endurance_limit_midpoint",
     "Endurance limit as the middle of the two stresses, 0 <= min <= max. K312, formula of the text."},
    {"K312.endurance_test_time",
     "Time of one specimen in the fatigue test."},
    {"K312.fatigue_failure_probability",
     "P(working stress > endurance limit), both normal and independent. Not both deviations zero. "
     "COMPLETION."},
    {"K312.finish_state",
     "Measured state of the surface after a route. K312 Table 2."},
    {"K312.guaranteed_endurance",
     "Endurance limit that a share `reliability` of the blades exceeds, sigma_-1 - z_R s. COMPLETION."},
    {"K312.hardening_degree",
     "Degree of work hardening u = 100 (H - H_ref)/H_ref. Not printed; reproduces Table 2."},
    {"K312.hardening_regime",
     "Regime of the ultrasonic hardening. K312 Table 1."},
    {"K312.residual_stress",
     "Residual stress below the back of the blade, compression negative: printed points, linear between "
     "(COMPLETION). P and VP constant beyond 30 um."},
    {"K312.roughness_ok",
     "Whether the roughness of a route meets the limit (equality does)."},
    {"K312.route_scrap",
     "Scrap of the forming route, the printed upper values. K312 text."},
    {"K312.staircase",
     "Mean and deviation of the endurance limit from an up-and-down test, Dixon and Mood on the rarer "
     "outcome. COMPLETION. Both outcomes must occur; the levels must lie on one grid of the step."},
    {"K312.stress_from_swing",
     "Stress in the blade root from the swing 2A of its tip: 30.9 MPa per 0.2 mm. K312, step of the test."},
    {"K401.ball_end_force_gradient",
     "Derivatives of the logarithms of the three forces, eq. (4)-(6)."},
    {"K401.ball_end_forces",
     "Maxima over a revolution, eq. (1)-(3)."},
    {"K401.ball_finishing_rates",
     "Rates, effective diameter and speed, scallop of raster finishing, (C1)-(C4). COMPLETION."},
    {"K401.best_regime",
     "Global maximum of the removal rate in the box under the force limits."},
    {"K401.max_feed_for_force_limits",
     "Largest feed in 0.04..0.12 mm/tooth that keeps three force limits."},
    {"K401.power_bound",
     "Upper bound of the cutting power, (C5). COMPLETION."},
    {"K401.tool_deflection",
     "Tip deflection of a cantilever of 0.8 d, (C6). COMPLETION."},
    {"K402.coating_friction",
     "Friction coefficient of a coating, literature cited by the paper."},
    {"K402.coating_temperature_drop",
     "Temperature drop over the coating, q h / lambda, eq. (2)."},
    {"K402.delamination_margin",
     "Thermal plus friction shear against adhesion. COMPLETION (C4)."},
    {"K402.discrete_coating_life_factor",
     "Wear resistance over that of the continuous coating."},
    {"K402.discrete_shear_ratio",
     "Thermal shear of an island over that of a continuous coating. COMPLETION (C3), calibrated on the "
     "paper."},
    {"K402.insert_face_temperatures",
     "Temperatures below the coating and at the support face, one-dimensional. COMPLETION (C1)."},
    {"K402.interface_thermal_shear",
     "Largest interface shear and stress in the middle of a heated island, shear lag. COMPLETION (C2)."},
    {"K402.island_coverage",
     "Area share of island tops, (side/pitch)^2."},
    {"K402.largest_safe_island",
     "Largest island in 10..200 um that holds. COMPLETION."},
    {"K402.mean_interface_shear",
     "Interface shear averaged over an island, mu q: equilibrium, eq. (1)."},
    {"K402.size_effect",
     "Thermal shear of a larger island over a smaller one. COMPLETION."},
    {"K402.thermal_conductivity",
     "Thermal conductivity used in the study."},
    {"K403.chip_side_coefficients",
     "K1..K4 under eq. (2)."},
    {"K403.contact_temperatures",
     "Mean rises of rake, flank and both (weighted by their lengths), eq. (3), (4)."},
    {"K403.cutting_temperature",
     "Temperatures and fluxes at a time after the start of the cut (negative: steady). COMPLETION around "
     "eq. (2)-(4)."},
    {"K403.heat_fluxes",
     "Fluxes into the tool through rake and flank from equal temperatures on both sides, eq. (2), repaired."},
    {"K403.heat_sources",
     "Forces, contact and heat sources: Kienzle, Merchant, Abuladze, Boothroyd, (C1)-(C3). COMPLETION."},
    {"K403.interrupted_cutting_temperature",
     "Peak (end of a contact) of interrupted cutting in the periodic state. COMPLETION."},
    {"K403.m_fo_exact",
     "Exact warm-up of a rectangle (eta = width/length) at the edge of a 90 degree wedge, (C6). COMPLETION."},
    {"K403.m_fo_paper",
     "Share of the steady rise at the dimensionless time Fo, eq. (1): 4e-3 Fo up to 200, 0.147 Fo^0.32 up "
     "to 400, then 1; 0 for Fo <= 0. Starts too slowly (a constant flux heats as sqrt(Fo)): for "
     "reproduction only."},
    {"K403.m_periodic",
     "Warm-up at the end of a contact in the periodic state, pulses of constant flux superposed, (C7). "
     "COMPLETION."},
    {"K403.settling_time",
     "Time at which the rise of the mean temperature first reaches a fraction of its steady value. "
     "COMPLETION."},
    {"K403.speed_for_temperature",
     "Largest speed in 10..600 m/min whose steady mean temperature keeps the limit. COMPLETION."},
    {"K403.wedge_functions",
     "Influence functions of the wedge, \"paper\" eq. (5), (6), repaired; \"exact\" images (C4), (C5)."},
    {"K404.bending_stiffness",
     "Bending stiffness of the uncut ply, D = E h^3 / (12 (1 - nu^2)); E, h > 0. K404 under eq. (1)."},
    {"K404.best_step_ratio",
     "Ratio 0.1..0.9 of the largest exit feed by (C1) and (C2): where the limits of both stages cross, or "
     "the end of the range. COMPLETION."},
    {"K404.critical_thrust_clamped",
     "Critical thrust of a clamped annulus loaded on its hole edge, 0 <= xi < 1 (0: the first stage): F = 4 "
     "pi sqrt(2 gd) [(1-nu) + (1+nu) xi^2] / [(1-nu)(1-xi^2) - 2 (1+nu) xi^2 ln xi].   K404 (C1) "
     "COMPLETION: one boundary condition for both stages, no pole. Recommended for both."},
    {"K404.critical_thrust_first_stage",
     "Critical thrust of the first stage, a point load on a simply supported disc: P = 4 pi sqrt(2 G_IC D "
     "(1 + nu) / (3 + nu)).   K404 eq. (1)"},
    {"K404.critical_thrust_next_stage",
     "Critical thrust of the next stage, a load on a ring round the open hole, 0 < xi <= 1. K404 eq. (2) as "
     "printed. Its bracket changes sign at next_stage_pole: beyond it the absolute value is taken, which "
     "reproduces the printed table, and `valid` is false: do not use the force then. Error at the pole."},
    {"K404.delamination_probability",
     "Probability that a normal thrust exceeds a normal critical thrust, K404 (C3), COMPLETION. Without "
     "scatter 0, 0.5 or 1 for a mean below, at or above the critical thrust."},
    {"K404.energy_release_rate",
     "Critical energy release rate, G_IC = (1 - nu^2) K_I^2 / E, times 1000 from MPa m to N/mm. K404 under "
     "(1)."},
    {"K404.next_stage_pole",
     "Ratio at which the bracket of eq. (2) changes sign; eq. (2) is usable well below it."},
    {"K404.plate_deflection",
     "Deflection at the radius 0 <= r <= a of a simply supported disc under a central load: w = P / (16 pi "
     "D) [(3+nu)/(1+nu) (a^2 - r^2) + 2 r^2 ln(r/a)].   K404 eq. (3)"},
    {"K404.stage_radius_for_deflection",
     "Smallest radius with a deflection not above the limit >= 0: 0 when even the centre meets it, a when "
     "the limit is 0. Inverse of plate_deflection."},
    {"K404.step_drill_feed_limit",
     "Largest exit feed per stage with the thrust model F = c w f^y, w the diameter that the stage takes, "
     "and the stage that limits (1 on a tie). 0 < xi < 1, y 0.5..1, safety >= 1. K404 (C2), COMPLETION."},
    {"K404.step_drill_geometry",
     "The published geometry of the step drill with the stage diameters xi d and d. K404, table of the "
     "geometry."},
    {"K404.step_drilling_time",
     "Travel until the second stage is through, both cones and the first stage's cylinder included, and its "
     "time. Full point angles. K404 (C5), COMPLETION."},
    {"K404.working_relief",
     "Relief left at the radius r by the feed, alpha - arctan(f / (2 pi r)), in the plane parallel to the "
     "axis. K404 (C4), COMPLETION."},
    {"K405.contact_point_speeds",
     "Speeds of the contact point on both surfaces from its paths between two contact lines, eq. (1) in "
     "words."},
    {"K405.contact_velocities",
     "Speeds of both bodies at a point and the velocity of the tool relative to the gear, (C1). Gear axis = "
     "z; tool axis through (A, 0, 0) with direction (0, sin S, cos S). Speeds signed."},
    {"K405.crossed_pair",
     "Pitch diameters, centre distance and speeds of a crossed helical pair, (C3). Helix angles signed "
     "(right hand positive); the shaft angle is their signed sum."},
    {"K405.generating_time",
     "Main time, passes (B + overrun) / (s_a n_g), (C7)."},
    {"K405.line_contact_pressure",
     "Hertz line contact, (C8)."},
    {"K405.reduced_curvature",
     "Reduced curvature of a convex tool and a convex or concave gear, (C4)."},
    {"K405.rolling_window",
     "Tool rotation over which contact rolls across the gear, (C5); below one pair the mesh is interrupted."},
    {"K405.sliding_contact_angle",
     "Angle 0..90 between the relative velocity and the tangent of the contact line, (C2). Error for a zero "
     "vector."},
    {"K405.surface_deviation",
     "Statistics of normal deviations from the model surface, rms about zero, (C6)."},
    {"K405.tool_speed_for_sliding",
     "Tool speed for a sliding speed: inverse of crossed_pair. Error for a shaft angle of 0."},
    {"K406.ball_end_force_summary",
     "Peaks and means over a tooth pitch."},
    {"K406.ball_end_forces_at",
     "Forces and torque at a tool angle, (C2)-(C5). COMPLETION of eq. (25)."},
    {"K406.ball_geometry",
     "Radius, polar angle, edge inclination and lag of the helix at a height above the tip, (C2). "
     "COMPLETION."},
    {"K406.cutting_state",
     "Shear angle, shear stress and friction angle from x = vf_scale v f, eq. (14)-(16)."},
    {"K406.effective_rake",
     "Rake in the plane of cutting and chip velocity, eq. (17), corrected."},
    {"K406.inclined_ball_speed",
     "Effective diameter and speed on a surface inclined to the normal of the axis, (C6). COMPLETION."},
    {"K406.mean_edge_speed",
     "Mean speed of the engaged edge, (C3)."},
    {"K406.oblique_specific_forces",
     "Specific forces at the chip-flow angle of least power, eq. (20)-(24)."},
    {"K406.rotate_forces",
     "Tool frame to machine frame: tilt about x, then lead about y, (C7). COMPLETION."},
    {"K406.shear_area_factor",
     "Shear area per uncut thickness and edge length, (C1). COMPLETION."},
    {"K406.specific_energy",
     "Cutting power per speed, uncut thickness and edge length at a given chip-flow angle, eq. (18), (19)."},
    {"K407.calibrating_penetration",
     "Penetration of the sizing ridges for a full profile, and the blank that fills it."},
    {"K407.contact_arc",
     "Arc of contact of the roller, eq. (5), repaired: sqrt(R^2 - X^2)."},
    {"K407.extrusion_height",
     "Height to which the displaced area rises in the gap between ridges, eq. (6)."},
    {"K407.force_coefficient",
     "Coefficient of eq. (1) from the blank-quality factors, eq. (4)."},
    {"K407.plunge_cycle_time",
     "Speeds and times of plunge rolling. COMPLETION."},
    {"K407.ridge_profile",
     "One ridge sunk by a depth. COMPLETION of the tables the paper refers to."},
    {"K407.rolled_thread_strength",
     "Strength of a rolled over that of a cut thread."},
    {"K407.rolling_drive",
     "Drive load of the rollers. COMPLETION."},
    {"K407.rolling_radial_force",
     "Radial and tangential force, eq. (3), (7)."},
    {"K407.turn_sequence",
     "What every lead-in ridge of one roller displaces, in ten steps."},
    {"K408.axial_tool_frequencies",
     "Lowest natural frequencies, ascending: roots of the frequency determinant."},
    {"K408.axial_tool_mode",
     "Displacements of a mode at the segment ends."},
    {"K408.axial_tool_receptance",
     "Displacement at a node per unit harmonic force at a node, hysteretic damping. COMPLETION."},
    {"K408.krylov_abcd",
     "Krylov functions: halves of cosh + cos, sinh + sin, cosh - cos, sinh - sin, for x >= 0."},
    {"K408.reaming_main_time",
     "Main time of reaming. COMPLETION."},
    {"K408.reaming_speed_limit",
     "Speed that keeps the tooth frequency below (1 - margin) f1. COMPLETION."},
    {"K409.break_even_bonus",
     "Largest bonus, as a share of the base wage bill, that a shorter repair pays back. COMPLETION."},
    {"K409.crew_cost_rate",
     "Cost per hour of a crew size, K(c) = L c_down + c c_crew + Lambda c_spare. COMPLETION."},
    {"K409.crew_for_availability",
     "Fewest crews with A >= target - 1e-12. No crew exceeds MTBF/(MTBF + MTTR). COMPLETION."},
    {"K409.elasticity",
     "Elasticity a x_mean / y_mean, % per %. The paper's 1.5 and 1.1 are 100 times too large."},
    {"K409.machine_repair_queue",
     "Stationary state of N machines and c crews with exponential times, M/M/c//N (Palm). COMPLETION: "
     "p_{n+1} = p_n (N - n) lambda / (min(n + 1, c) mu). Pessimistic for more regular repair times when "
     "crews are scarce, exact for any of them when c >= N."},
    {"K409.maintenance_wage_fund",
     "Headcount, wage fund and the hourly cost of a crew that follows from them. COMPLETION."},
    {"K409.normal_sums_diagnostics",
     "Whether sums can come from data at all, before anything is solved. COMPLETION."},
    {"K409.ols_two_factor",
     "Ordinary least squares y = a0 + a1 x1 + a2 x2 from raw data, by QR of the centred columns. "
     "COMPLETION. Error when 1, x1, x2 are linearly dependent or y is constant."},
    {"K409.optimal_crew_size",
     "Cheapest number of crews in 1..N, the smallest of equal ones. COMPLETION."},
    {"K409.overhaul_minimal_repair",
     "Overhaul interval with minimal repair between overhauls, durations neglected. COMPLETION "
     "(Barlow-Hunter): T* = eta (c_o/(c_m (b - 1)))^(1/b)."},
    {"K409.planned_repair_labour",
     "Labour by planned-preventive-repair norms per complexity unit: inspection 0.85 h, minor repair 6.1, "
     "medium repair 23.5, overhaul 35. COMPLETION; replace by plant norms where available."},
    {"K409.pm_age_policy",
     "Age replacement of a Weibull life with durations, renewal-reward. COMPLETION: A(T) = M/(M + R t_p + "
     "(1 - R) t_c),  M(T) = MTBF P(1/b, (T/eta)^b)."},
    {"K409.pm_optimal_age",
     "Best age of preventive replacement in 0.01..4 MTBF, or never when that is no worse or shape <= 1. "
     "COMPLETION."},
    {"K409.regression_from_sums",
     "Solves the normal equations, also of impossible sums; a singular matrix is an error. K409 eq. (1), "
     "third line repaired: it starts with a0 sum x2."},
    {"K409.shop_cost_per_part",
     "Cost per good part of identical machines in parallel. COMPLETION."},
    {"K409.wage_fund_regression",
     "Regression with the printed coefficients, 949.216 + 0.00325 x1 + 0.0203 x2. K409 eq. (3). An example "
     "only: the sums behind it are impossible (see normal_sums_diagnostics)."},
    {"K410.cutting_speed",
     "pi D n / 1000."},
    {"K410.drilling_handbook_speed",
     "Speed for a drill life; 0.2 mm/rev belongs to the first line. COMPLETION."},
    {"K410.drilling_loads",
     "Thrust, torque and power of a twist drill in structural steel. COMPLETION."},
    {"K410.drilling_main_time",
     "Path and main time; the depth of a blind hole reaches to the drill tip. COMPLETION."},
    {"K410.fit_power_law",
     "y = C prod x_j^e_j by least squares of the logarithms. COMPLETION."},
    {"K410.model_agreement",
     "Errors model/reference - 1 and the factor that makes the geometric mean agree. COMPLETION."},
    {"K410.power_law_value",
     "C prod x_j^e_j. COMPLETION."},
    {"K411.finish_pass_time",
     "Main time of a finish pass at the feed of max_feed_for_ra_reliability. COMPLETION."},
    {"K411.handbook_finish_feed",
     "Handbook finishing feed for a roughness class, linear in the nose radius, held outside 0.4..2.4 mm. "
     "COMPLETION."},
    {"K411.insert_angles",
     "Corner angle 180 - 360/n and minor edge angle of a regular polygon insert of n = 3..8 faces set at "
     "kr. Error when no minor angle is left. COMPLETION."},
    {"K411.max_feed_for_ra",
     "Largest feed between the bounds with Ra <= limit. Inverse of turning_ra (\"hold_factor\")."},
    {"K411.max_feed_for_ra_reliability",
     "Largest feed with P(Ra <= limit) >= gamma. COMPLETION."},
    {"K411.ra_confidence_half_width",
     "Two-sided confidence half-width of a mean, t((1+confidence)/2; dof) sqrt(variance/n)."},
    {"K411.ra_exceed_probability",
     "Probability that Ra of a part is above the limit, normal scatter. COMPLETION."},
    {"K411.ra_scatter",
     "Standard deviation of Ra of a part: repetition plus (optional) difference between tools. COMPLETION."},
    {"K411.theoretical_roughness",
     "Height h of the profile left by a nose arc between two straight edges tangent to it, from x_kr(h) + "
     "x_kr1(h) = s, and its mean deviation in closed form. COMPLETION (the paper takes h from another)."},
    {"K411.turning_ra",
     "Ra = a exp(alpha s^2 + beta s) 0.2 h, eq. (1), with s the feed that leaves the same h with a 2 mm "
     "nose; \"hold_factor\" holds s inside the fitted 0.15..0.55 mm/rev, \"printed\" does not."},
    {"K412.contour_pass_time",
     "One pass along the contour: at constant surface speed up to the largest spindle speed, or at a fixed "
     "spindle speed."},
    {"K412.dressing_radius",
     "Largest radius of the dressed wheel that does not grind with its side; K412 eqs. (4)-(9) on a uniform "
     "grid. Depends on the spacing of the points: for parity with the paper, see dressing_radius_for_wheel."},
    {"K412.dressing_radius_for_wheel",
     "The same criterion with half the wheel width as span, 1/R = 1/rho + 8 a k_z / B^2. COMPLETION. 1e9: "
     "unlimited."},
    {"K412.facing_time",
     "Main time of one face. COMPLETION."},
    {"K412.gcode_contour",
     "NC text of one contour pass: X diametral, constant surface speed. COMPLETION (dialect)."},
    {"K412.grinding_feed_for_scallop",
     "Axial feed that leaves the scallop height h = f^2 / 8 (1/R - 1/rho). COMPLETION. 1e9 when the wheel "
     "is flatter than the profile."},
    {"K412.offset_contour",
     "Equidistant with mitred vertices; valid while a concave part has a larger radius than the offset."},
    {"K412.path_length",
     "Length of a contour, the sum of its lines and arcs."},
    {"K412.profile_grinding_time",
     "Traverse profile grinding. COMPLETION."},
    {"K412.revolve_volume",
     "Solid of revolution, as a sum of frustums."},
    {"K412.roll_contour",
     "Both fillets and the profile, left face to right face."},
    {"K412.roll_end_fillet",
     "Fillet from the end of the profile to the face, K412 eq. (3) with the fraction turned over. Right "
     "end, radii."},
    {"K412.roll_part_time",
     "Piece time and the part's share of set-up and programming. COMPLETION."},
    {"K412.roll_phi_at_y",
     "Parameter of the profile at |y|, inverse of eq. (2). alpha = 90: |y| below half the pipe diameter."},
    {"K412.roll_pipe_fit",
     "Set-up of an existing roll for another pipe: touching, with the smallest largest gap. COMPLETION. A "
     "result at an end of the range is a limit, not an optimum."},
    {"K412.roll_pipe_gap",
     "Clearance between roll and pipe in every section; negative where they interfere. COMPLETION."},
    {"K412.roll_profile",
     "Working profile, uniform in y; n_points odd."},
    {"K412.roll_profile_point",
     "Point of the roll profile for the parameter phi (90 deg: throat); K412 eqs. (1), (2) as corrected. 5 "
     "<= alpha <= 90, 0 < phi <= 90."},
    {"K412.rough_turning_plan",
     "Roughing in two phases: cylinder passes down to the crest, then equidistants of the contour. "
     "COMPLETION of what the paper names."},
    {"K412.wheel_contact_half_width",
     "Half-width of the contact of wheel and profile. COMPLETION. 1e9 when the wheel is flatter than the "
     "profile."},
    {"S1.allowance_split",
     "What of the allowance the periphery and the end face remove: the end-face circle comes down to H = "
     "l^2 sin^2 a / (2 (rho + R cos^2 a)) above the finished surface. Second order in l. COMPLETION C3."},
    {"S1.axial_roughness",
     "Geometric roughness along the cam's axis: R_eff = (R + rho cos^2 a)/sin^2 a, Rz = s^2/(8 R_eff), Ra = "
     "4 Rz/(9 sqrt 3). |alpha| <= 90 deg. Derived."},
    {"S1.cam_geometry",
     "Joints of the arcs, lift and contour length; error when the arcs do not join. COMPLETION C1."},
    {"S1.cam_milling_time",
     "Main time of one cam at constant contour feed: (width + overrun)/s revolutions of L/v each. Derived."},
    {"S1.cam_rotation_law",
     "Rotation and axis feeds that keep the contour feed v: omega = v/rho, v_Y = h' omega, v_X = (h - rho) "
     "omega. They jump at the joints. Derived."},
    {"S1.cam_support",
     "Support function and point of the cam with the given outward normal, any angle; a joint belongs to "
     "the arc nearer the nose. COMPLETION C1."},
    {"S1.cam_tool_setting",
     "Cutter position with the contact in the horizontal plane: Y = h + R, X = -h' (in the tilted frame "
     "-h'/cos alpha). |alpha| < 90 deg. Derived from the paper's rule and eq. (8)."},
    {"S1.contact_point",
     "Where one height of the cutter touches the surface it generates: the triple product of eq. (8) is "
     "zero, theta_f = pi - atan[(X cos a + Z_k sin a + Y') / (Y cos a - X' + Z' sin a)]. Error when the "
     "denominator is zero. S1 eq. (8), solved in closed form."},
    {"S1.conventional_feed_nonuniformity",
     "Swing of the contour feed in the usual scheme. Exact: on each arc the feed is monotone in the cosine "
     "of the angle from the line to the arc's centre, so the extremes lie at the ends of the arcs. Derived."},
    {"S1.conventional_state",
     "The usual scheme: tool centre in the plane of the axes, uniform rotation, alpha = 0. Derived."},
    {"S1.material_removal_rate",
     "Mean removal rate Q = t s v. Derived."},
    {"S1.max_orientation_for_roughness",
     "Largest orientation that keeps Ra; 90 deg when any does. Inverse of axial_roughness."},
    {"S1.roundness_deviation",
     "Height of the facets the teeth leave: f_z^2/8 (1/rho + cos^2 a / R). COMPLETION C2 (chord formula)."},
    {"S1.tool_point_in_part",
     "Point of the cutter surface in the part frame. S1 eq. (7), repaired: the print carries the part angle "
     "where the tool angle belongs and a stray matrix."},
    {"S1.tool_wear_form_error",
     "Form error left when the loss of tool radius is corrected by a constant offset: loss * max(1 - cos "
     "psi), tan psi = h'/(h + R), in the usual scheme; none with normal contact. First order in the loss. "
     "Derived."},
    {"S2.concave_arc_motion",
     "Coordination of kind 1, concave arc of the tool's own radius: S = (R_A + r0)(cos phi, sin phi) and "
     "its rate. S2 eqs. (2), (3), the sign of V_y repaired."},
    {"S2.coordination_kind",
     "The paper's choice of coordination: concave arc 1, convex and straight 2, junction 3 below 90 deg, "
     "else 2; the tool fits when alpha <= beta."},
    {"S2.edge_wear_spread",
     "Travel of the contact along the edge, |p| L, and the gain in life 1 + |p| L/b, wear taken "
     "proportional to the time of contact per length of edge. COMPLETION."},
    {"S2.facet_error",
     "Height left between two successive tangents, r (sec(step/2) - 1). COMPLETION."},
    {"S2.rolling_path",
     "Motion along a whole side relative to the start, at its end and at half of the (even) steps. S2 eqs. "
     "(5)-(11) summed without accumulation of error."},
    {"S2.rolling_path_limited",
     "Path with the slip reduced where the vertex would enter the opposite side. S2 kind 3, rebuilt."},
    {"S2.rolling_time",
     "Time of one generating stroke: every step takes what feed, rotation or the slower axis needs. "
     "COMPLETION."},
    {"S2.rolling_transfer",
     "Coordination of kind 2: rotation and translation that carry the contact from A1, where the edge "
     "touches the unrotated profile, to A2. Error when no point of the profile has the edge's slope. S2 "
     "eqs. (5)-(11)."},
    {"S2.rotation_step_for_tolerance",
     "Rotation step that leaves a facet error. Inverse of facet_error. COMPLETION."},
    {"S2.vertex_gouge",
     "Deepest penetration (along y of the part) of the vertex into the opposite side without limiting."},
    {"S2.vertex_limit",
     "Coordination of kind 3: the farthest the vertex may lie from the contact before it meets the opposite "
     "side. S2 eq. (12), second line rebuilt from the text."},
    {"S3.it_grade_for_deviation",
     "First ISO 286 grade with share * IT(nominal) >= deviation (equality counts, within 1e-12 mm). 10 < "
     "nominal <= 180 mm."},
    {"S3.rk_cusp",
     "Cusp that two neighbouring teeth leave: radial distance from the crossing of their tracks to the "
     "profile. tooth1 < tooth2 <= tooth1 + 360. S3 eqs. (5)-(9), closed form for straight teeth."},
    {"S3.rk_cutter_point",
     "Cutter point that generates the profile point t: the normal passes through the pitch point on the "
     "line of centres, gamma = t + asin(h'/r_w), r_w = N a/(N - 1). S3 eqs. (1)-(3), closed form for "
     "straight teeth."},
    {"S3.rk_cutter_radius_limits",
     "Largest cutter without undercut at the lobe tip: the larger root of R_f^2 - (R - (N-1)^2 e) R_f + "
     "((N-1) e)^2 = 0; smallest without a looping track at the flat, e + (R - e)/N. COMPLETION."},
    {"S3.rk_cutting_kinematics",
     "Cutter speed N n, eq. (1), and sliding speed at the contact, (N - 1) 2 pi n times the distance of the "
     "contact from the pitch point. COMPLETION."},
    {"S3.rk_equalised_cutter",
     "The common cusp of `teeth` teeth (1 to 500) spaced so that all cusps are equal all the way round. "
     "Error when so few teeth cannot close the turn. COMPLETION."},
    {"S3.rk_form_error_uniform",
     "Largest and smallest cusp of equally spaced teeth. S3 Tables 1 and 2."},
    {"S3.rk_hole_machining_time",
     "Main time: infeed/S_m + finish revolutions/n. COMPLETION from eq. (4)."},
    {"S3.rk_min_teeth",
     "Fewest teeth for a tolerance: uniform, the first Z = 2, 3, ... whose largest deviation keeps it; "
     "equalised, the teeth of rk_tooth_positions. At most 2000. COMPLETION."},
    {"S3.rk_profile_point",
     "Point of the hole profile with the normal t: (h cos t - h' sin t, h sin t + h' cos t), radius of "
     "curvature h + h''. From the paper's references, confirmed by Tables 1 and 2."},
    {"S3.rk_tooth_positions",
     "The paper's algorithm: each tooth at the smallest pitch at which the cusp reaches the tolerance, "
     "until the turn is full. S3 eq. (10), Fig. 7 rebuilt from the text. At most 2000 teeth."},
    {"S4.block_feed_limit",
     "Largest feed at which the control keeps up with the blocks. S4 eq. (6)."},
    {"S4.block_length_for_tolerance",
     "Longest block within a chord tolerance, 2 sqrt(2 R tol - tol^2). COMPLETION."},
    {"S4.contact_radius",
     "Radius of the contact on the part, R2' = sqrt(a_w^2 + R1^2 - 2 a_w R1 cos rho), and its angle at the "
     "part axis by atan2 (the printed arcsine is wrong beyond 90 deg). S4 eqs. (1)-(3)."},
    {"S4.edge_speed_components",
     "Speed along and normal to the edge: v sin lambda, v cos lambda. Textbook formula behind the example."},
    {"S4.engagement_limit",
     "Angles of entry and exit (plus and minus), where R2' = R2; zero when the circles do not meet, 180 and "
     "0 when the whole tool circle lies in the part. Derived from eq. (1)."},
    {"S4.finishing_rule",
     "The paper's rule: at v >= 600 m/min and a ratio of depth to feed of at most 0.2, Ra 1.6-3.2 um."},
    {"S4.flat_axis_law",
     "Synchronised axes that generate a flat: x = (d + R1)/cos theta, s = (d + R1) tan theta, and the "
     "speeds for a constant feed along the flat. Derived."},
    {"S4.flat_layer",
     "Layer of a flat on a bar: cos alpha = (R - t)/R, X travel t, width 2 sqrt(R^2 - (R - t)^2). The "
     "formula behind the printed angles."},
    {"S4.flat_milling_speeds",
     "Resultant speed at entry, middle and exit of a flat: v = 2 pi n1 R1 -+ (v_f - 2 pi n2 R1), minus in "
     "down milling. Derived."},
    {"S4.flat_milling_time",
     "Main time of a flat in layers: each from first to last touch of the full blank. COMPLETION."},
    {"S4.flat_projection",
     "Projection l sin alpha of a flat, as printed; it is not the X travel."},
    {"S4.flat_step_error",
     "Errors of a flat made in angular steps: blocks linear in x and theta; imprints where the tool stops. "
     "COMPLETION."},
    {"S4.flat_x_increments",
     "X moves for equal angular steps from -half angle to +half angle (0 to 90 deg, exclusive). Derived."},
    {"S4.kinematic_inclination",
     "Turn of the main plane by a second motion, eta = atan2(i sin eps, 1 + i cos eps), and the inclination "
     "in motion, lambda_C - eta. Error when the motions cancel. COMPLETION."},
    {"S4.resultant_speed",
     "Velocity of the edge relative to the part, the vector sum of rotation and both feeds. S4 eqs. (4), "
     "(5), repaired: printed as products of speeds, which have the unit m^2/min^2."},
    {"S4.uncut_chip_thickness",
     "Uncut chip thickness f sin kappa. Textbook formula behind the example."},
}};
// clang-format on

}  // namespace

std::string_view formula_of(std::string_view key) {
  const auto found = std::lower_bound(formulas.begin(), formulas.end(), key,
                                      [](const auto& entry, std::string_view k) { return entry.first < k; });
  return found != formulas.end() && found->first == key ? found->second : std::string_view();
}

}  // namespace verstat::models
