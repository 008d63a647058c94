#include "models/gears/k101_hobbing_chip_thickness.h"

namespace verstat::models::k101 {
namespace {

// The inputs that describe hob, gear and feed, with the worked example as default.
const Range module_range = closed(1, 20);
const Range teeth_range = closed(8, 300);
const Range helix_range = closed(-45, 45);
const Range shift_range = closed(-1, 1.5);
const Range hob_range = closed(20, 400);
const Range gash_range = closed(6, 30);
const Range addendum_range = closed(0.8, 2);
const Range feed_range = closed(0.1, 8);
// Not the card's: keeps the tooth angles and the size of a sweep within sense.
const Range index_range = closed(-1e4, 1e4);

template <class Builder>
void hob_inputs(Builder& f) {
  f.optional(&HobInputs::module_mm, "module_mm", "m_n", "mm", module_range, "normal module")
      .optional(&HobInputs::hob_diameter_mm, "hob_diameter_mm", "d_a0", "mm", hob_range,
                "outer diameter of the hob")
      .optional(&HobInputs::hob_tip_radius_mm, "hob_tip_radius_mm", "rho_a0", "mm", non_negative(),
                "tip corner radius of the hob")
      .optional(&HobInputs::pressure_angle_deg, "pressure_angle_deg", "alpha_n", "deg", closed(10, 35),
                "pressure angle")
      .optional(&HobInputs::hob_addendum_factor, "hob_addendum_factor", "h_a0*", "1", addendum_range,
                "addendum of the hob over the module")
      .optional(&HobInputs::hob_profile, "hob_profile", "-", "-", no_range(), "flank profile of the hob");
}

template <class Builder>
void process_inputs(Builder& f, std::int64_t gashes_example = 10) {
  hob_inputs(f);
  f.optional(&Hobbing::gear_teeth, "gear_teeth", "Z_k", "1", teeth_range, "teeth of the gear")
      .optional(&Hobbing::gear_helix_deg, "gear_helix_deg", "beta_w", "deg", helix_range,
                "helix angle of the gear, right-hand positive")
      .optional(&Hobbing::profile_shift, "profile_shift", "x", "1", shift_range, "profile shift factor")
      .optional(&Hobbing::hob_gashes, "hob_gashes", "Z_f", "1", gash_range, "gashes of the hob")
      .example(gashes_example)
      .optional(&Hobbing::axial_feed_mm_rev, "axial_feed_mm_rev", "S_oc", "mm/rev", feed_range,
                "axial feed per blank revolution")
      .optional(&Hobbing::feed_mode, "feed_mode", "sigma", "-", no_range(),
                "conventional: feed in the direction of tooth motion; climb: against it");
}

template <class Builder>
void edge_inputs(Builder& f) {
  f.input(&EdgePointInputs::segment, "segment", "-", "-", no_range(), "part of the tooth edge", "34")
      .input(&EdgePointInputs::parameter, "parameter", "u, mu, u_1", "mm or deg", any(),
             "position on it: u (mm) on 12 and 56, u_1 (mm) on 34, mu (deg) on 23 and 45", 1.1)
      .input(&EdgePointInputs::tooth_index, "tooth_index", "j", "1", index_range,
             "tooth, 0 = centre, below 0 on the entry side", 0);
}

template <class Builder>
void position_inputs(Builder& f) {
  edge_inputs(f);
  f.input(&ToothPointInputs::tooth_angle_deg, "tooth_angle_deg", "theta", "deg", closed(-1e6, 1e6),
          "position of the tooth in its turn, 270 = nearest to the blank axis", 260.0);
}

void describe_geometry(Source& source) {
  source
      .function<&hob_geometry>("hob_geometry", "Constants of the hob tooth.", "(C1)", Provenance::completion)
      .with([](auto& f) { hob_inputs(f); })
      .output(&HobGeometry::pitch_radius_mm, "pitch_radius_mm", "r_m0", "mm", positive(), "pitch radius")
      .output(&HobGeometry::lead_angle_deg, "lead_angle_deg", "gamma", "deg", closed(0, 90),
              "lead angle on the pitch cylinder")
      .output(&HobGeometry::helix_parameter_mm_rad, "helix_parameter_mm_rad", "p", "mm/rad", positive(),
              "axial travel of the thread per radian")
      .output(&HobGeometry::lead_mm, "lead_mm", "2 pi p", "mm", positive(), "lead")
      .output(&HobGeometry::a1_mm, "a1_mm", "A_1", "mm", positive(),
              "half tooth width extrapolated to the hob axis")
      .output(&HobGeometry::tip_centre_radial_mm, "tip_centre_radial_mm", "c_y", "mm", any(),
              "radial position of the centre of the corner arc")
      .output(&HobGeometry::tip_centre_axial_mm, "tip_centre_axial_mm", "c_z", "mm", positive(),
              "transverse position of the centre of the corner arc")
      .output(&HobGeometry::section_angle_deg, "section_angle_deg", "beta_1", "deg", closed(-90, 0),
              "angle of the section that holds the outline")
      .note(
          "The paper gives beta_1 = +gamma for convolute hobs; with its own signs the section is normal to "
          "the thread only for -gamma.");
  source
      .function<&hobbing_setup>("hobbing_setup", "Setting of hob and blank.", "eq. (1), (C1)",
                                Provenance::paper)
      .optional(&SetupInputs::module_mm, "module_mm", "m_n", "mm", module_range, "normal module")
      .optional(&SetupInputs::gear_teeth, "gear_teeth", "Z_k", "1", teeth_range, "teeth of the gear")
      .optional(&SetupInputs::gear_helix_deg, "gear_helix_deg", "beta_w", "deg", helix_range,
                "helix angle of the gear, right-hand positive")
      .optional(&SetupInputs::profile_shift, "profile_shift", "x", "1", shift_range, "profile shift factor")
      .optional(&SetupInputs::hob_diameter_mm, "hob_diameter_mm", "d_a0", "mm", hob_range,
                "outer diameter of the hob")
      .optional(&SetupInputs::hob_addendum_factor, "hob_addendum_factor", "h_a0*", "1", addendum_range,
                "addendum of the hob over the module")
      .output(&HobbingSetup::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
              "centre distance")
      .output(&HobbingSetup::gear_outer_radius_mm, "gear_outer_radius_mm", "R_a", "mm", positive(),
              "outer radius of the blank")
      .output(&HobbingSetup::setting_angle_deg, "setting_angle_deg", "beta_set", "deg", any(),
              "setting angle of the hob")
      .output(&HobbingSetup::cutting_depth_mm, "cutting_depth_mm", "h", "mm", positive(), "cutting depth")
      .output(&HobbingSetup::ratio_i12, "ratio_i12", "i_12", "1", positive(),
              "blank revolutions per hob revolution");
  source
      .function<&hobbing_kinematics>("hobbing_kinematics",
                                     "Blank rotation and axial travel at a hob rotation.", "eqs. (2), (3)",
                                     Provenance::repaired)
      .with([](auto& f) { process_inputs(f); })
      .input(&KinematicsInputs::hob_angle_deg, "hob_angle_deg", "phi_01", "deg", any(), "hob rotation",
             7200.0)
      .output(&HobbingKinematics::blank_angle_deg, "blank_angle_deg", "phi_02", "deg", any(),
              "blank rotation")
      .output(&HobbingKinematics::axial_travel_mm, "axial_travel_mm", "psi", "mm", any(),
              "axial travel of the hob, signed");
  source
      .function<&hob_edge_point>("hob_edge_point", "A point of a tooth edge in the hob frame.", "eq. (5)",
                                 Provenance::repaired)
      .with([](auto& f) { process_inputs(f); })
      .with([](auto& f) { edge_inputs(f); })
      .output(&EdgePoint::x1_mm, "x1_mm", "X_1", "mm", any(), "across the hob axis")
      .output(&EdgePoint::y1_mm, "y1_mm", "Y_1", "mm", any(), "across the hob axis")
      .output(&EdgePoint::z1_mm, "z1_mm", "Z_1", "mm", any(), "along the hob axis")
      .note("The limits of the segments are not printed; they follow from the continuity of the outline.");
  source
      .function<&hob_point_in_blank_frame>("hob_point_in_blank_frame",
                                           "A point of the hob frame in the blank frame.", "eq. (4)",
                                           Provenance::repaired)
      .with([](auto& f) { process_inputs(f); })
      .input(&BlankPointInputs::x1_mm, "x1_mm", "X_1", "mm", any(), "across the hob axis", 50.0)
      .input(&BlankPointInputs::y1_mm, "y1_mm", "Y_1", "mm", any(), "across the hob axis", 0.0)
      .input(&BlankPointInputs::z1_mm, "z1_mm", "Z_1", "mm", any(), "along the hob axis", 0.0)
      .input(&BlankPointInputs::hob_angle_deg, "hob_angle_deg", "phi_01", "deg", any(), "hob rotation", 270.0)
      .output(&BlankPoint::x2_mm, "x2_mm", "X_2", "mm", any(), "along the blank axis")
      .output(&BlankPoint::y2_mm, "y2_mm", "Y_2", "mm", any(), "across the blank axis")
      .output(&BlankPoint::z2_mm, "z2_mm", "Z_2", "mm", any(), "across the blank axis");
}

void describe_times(Source& source) {
  const auto cylinders = [](auto& f) {
    f.input(&ApproachInputs::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
            "centre distance", 95.75)
        .optional(&ApproachInputs::hob_diameter_mm, "hob_diameter_mm", "d_a0", "mm", hob_range,
                  "outer diameter of the hob")
        .input(&ApproachInputs::gear_outer_radius_mm, "gear_outer_radius_mm", "R_a", "mm", positive(),
               "outer radius of the blank", 57.0)
        .input(&ApproachInputs::setting_angle_deg, "setting_angle_deg", "beta_set", "deg", open(-90, 90),
               "setting angle of the hob", 3.276);
  };
  source
      .function<&hob_approach_length>("hob_approach_length",
                                      "Axial distance of the hob centre at first contact.", "eq. (7)",
                                      Provenance::repaired)
      .with(cylinders)
      .output(&Approach::approach_length_mm, "approach_length_mm", "L", "mm", non_negative(),
              "approach length; the overrun is the same")
      .output(&Approach::contact_angle_deg, "contact_angle_deg", "tau", "deg", closed(-90, 90),
              "angle of first contact on the blank cylinder; 90 when the cylinders do not meet");
  source
      .function<&hobbing_main_time>("hobbing_main_time", "Main time of one gear.", "eq. (8)",
                                    Provenance::paper)
      .input(&MainTimeInputs::approach_length_mm, "approach_length_mm", "L", "mm", non_negative(),
             "approach length", 31.7256)
      .input(&MainTimeInputs::face_width_mm, "face_width_mm", "B", "mm", positive(),
             "face width or height of the stack", 30.0)
      .optional(&MainTimeInputs::axial_feed_mm_rev, "axial_feed_mm_rev", "S_oc", "mm/rev", feed_range,
                "axial feed per blank revolution")
      .optional(&MainTimeInputs::gear_teeth, "gear_teeth", "Z_k", "1", teeth_range, "teeth of the gear")
      .input(&MainTimeInputs::hob_speed_rpm, "hob_speed_rpm", "n", "rpm", positive(), "hob speed", 120.0)
      .optional(&MainTimeInputs::hob_starts, "hob_starts", "z_0", "1", at_least(1), "starts of the hob")
      .output(&MainTime::hob_rotation_rad, "hob_rotation_rad", "phi_tot", "rad", non_negative(),
              "rotation of the hob")
      .output(&MainTime::hob_revolutions, "hob_revolutions", "-", "rev", non_negative(),
              "revolutions of the hob")
      .output(&MainTime::main_time_min, "main_time_min", "T", "min", non_negative(), "main time")
      .note("More starts than one are a generalization of this function only.");
  source
      .function<&hob_contact_arc>("hob_contact_arc", "Arc in which a hob tooth is in the blank.", "eq. (9)",
                                  Provenance::paper)
      .input(&ContactArcInputs::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
             "centre distance", 95.75)
      .optional(&ContactArcInputs::hob_diameter_mm, "hob_diameter_mm", "d_a0", "mm", hob_range,
                "outer diameter of the hob")
      .input(&ContactArcInputs::gear_outer_radius_mm, "gear_outer_radius_mm", "R_a", "mm", positive(),
             "outer radius of the blank", 57.0)
      .output(&ContactArc::entry_angle_deg, "entry_angle_deg", "phi_in", "deg", closed(90, 270),
              "tooth angle at entry")
      .output(&ContactArc::exit_angle_deg, "exit_angle_deg", "phi_out", "deg", closed(270, 450),
              "tooth angle at exit")
      .note("Mid-plane, zero swivel.");
  source
      .function<&hob_tooth_engaged>("hob_tooth_engaged", "Whether a hob tooth is in the arc.", "eq. (12)",
                                    Provenance::paper)
      .input(&EngagedInputs::tooth_angle_deg, "tooth_angle_deg", "theta", "deg", any(), "tooth angle", 260.0)
      .input(&EngagedInputs::entry_angle_deg, "entry_angle_deg", "phi_in", "deg", any(), "entry", 230.8)
      .input(&EngagedInputs::exit_angle_deg, "exit_angle_deg", "phi_out", "deg", any(), "exit", 309.2)
      .output(&Engaged::engaged, "engaged", "-", "-", no_range(), "in the arc, ends included");
  source
      .function<&hob_working_teeth>("hob_working_teeth",
                                    "Teeth within the intersection of the tip cylinders.", "(C2)",
                                    Provenance::completion)
      .with(cylinders)
      .input(&WorkingTeethInputs::lead_mm, "lead_mm", "2 pi p", "mm", positive(), "lead of the hob", 15.7337)
      .optional(&WorkingTeethInputs::hob_gashes, "hob_gashes", "Z_f", "1", gash_range, "gashes of the hob")
      .output(&WorkingTeeth::zone_half_length_mm, "zone_half_length_mm", "Z_half", "mm", non_negative(),
              "half length of the zone along the hob axis")
      .output(&WorkingTeeth::teeth_in_zone, "teeth_in_zone", "-", "1", at_least(1), "teeth in the zone");
}

void describe_chips(Source& source) {
  source
      .function<&hob_relative_velocity>("hob_relative_velocity",
                                        "Velocity of an edge point relative to the blank.", "eq. (10)",
                                        Provenance::repaired)
      .with([](auto& f) { process_inputs(f); })
      .with([](auto& f) { position_inputs(f); })
      .optional(&VelocityInputs::hob_speed_rpm, "hob_speed_rpm", "n", "rpm", positive(), "hob speed")
      .example(120.0)
      .output(&RelativeVelocity::vx_mm_rad, "vx_mm_rad", "V_0x", "mm/rad", any(), "in the fixed frame")
      .output(&RelativeVelocity::vy_mm_rad, "vy_mm_rad", "V_0y", "mm/rad", any(), "in the fixed frame")
      .output(&RelativeVelocity::vz_mm_rad, "vz_mm_rad", "V_0z", "mm/rad", any(),
              "in the fixed frame, along the hob axis")
      .output(&RelativeVelocity::speed_m_min, "speed_m_min", "V", "m/min", non_negative(),
              "cutting speed; null without hob speed");
  source
      .function<&cutting_surface_normal>("cutting_surface_normal",
                                         "Unit normal of the cutting surface in the blank frame.", "eq. (11)",
                                         Provenance::paper)
      .with([](auto& f) { process_inputs(f); })
      .with([](auto& f) { position_inputs(f); })
      .output(&SurfaceNormal::nx, "nx", "N_2x", "1", closed(-1, 1), "along the blank axis")
      .output(&SurfaceNormal::ny, "ny", "N_2y", "1", closed(-1, 1), "across the blank axis")
      .output(&SurfaceNormal::nz, "nz", "N_2z", "1", closed(-1, 1), "across the blank axis")
      .note("Directed into the tooth body.");
  source
      .function<&hobbing_chip_thickness>("hobbing_chip_thickness",
                                         "Chip thickness at a point of a tooth edge.",
                                         "eqs. (13)-(15), steps 1-9", Provenance::repaired)
      .with([](auto& f) { process_inputs(f); })
      .with([](auto& f) { position_inputs(f); })
      .optional(&ChipInputs::previous_blank_revs, "previous_blank_revs", "n", "1", closed(0, 20),
                "earlier blank revolutions looked at")
      .optional(&ChipInputs::blank_limited, "blank_limited", "-", "-", no_range(),
                "false: steady state; true: a blank with end faces")
      .optional(&ChipInputs::face_width_mm, "face_width_mm", "B", "mm", positive(),
                "face width, when blank_limited")
      .optional(&ChipInputs::hob_turns, "hob_turns", "k", "1", closed(-1e6, 1e6),
                "full turns of the hob since its centre stood the approach length before the blank, when "
                "blank_limited")
      .output(&Chip::chip_thickness_mm, "chip_thickness_mm", "a", "mm", non_negative(),
              "chip thickness; 0 where nothing is cut")
      .note("At the worked example the paper's counter feed corresponds to climb by the usual definition.");
  source
      .function<&hobbing_tooth_load>("hobbing_tooth_load", "Load of one tooth at one angle.", "(C4)",
                                     Provenance::completion)
      .with([](auto& f) { process_inputs(f); })
      .input(&ToothLoadInputs::tooth_index, "tooth_index", "j", "1", index_range,
             "tooth, 0 = centre, below 0 on the entry side", -2)
      .input(&ToothLoadInputs::tooth_angle_deg, "tooth_angle_deg", "theta", "deg", closed(-1e6, 1e6),
             "position of the tooth in its turn, 270 = nearest to the blank axis", 260.0)
      .optional(&ToothLoadInputs::n_flank, "n_flank", "-", "1", closed(2, 500), "points on each flank")
      .optional(&ToothLoadInputs::n_round, "n_round", "-", "1", closed(1, 500), "points on each corner")
      .optional(&ToothLoadInputs::n_tip, "n_tip", "-", "1", closed(1, 500), "points on the tip land")
      .optional(&ToothLoadInputs::kc11_n_mm2, "kc11_n_mm2", "k_c1.1", "N/mm2", positive(),
                "specific cutting force at 1 mm")
      .example(1700.0)
      .optional(&ToothLoadInputs::mc, "mc", "m_c", "1", open_high(0, 1), "exponent of the chip thickness")
      .example(0.25)
      .output(&ToothLoad::max_chip_thickness_mm, "max_chip_thickness_mm", "a_max", "mm", non_negative(),
              "largest chip thickness")
      .output(&ToothLoad::contact_length_mm, "contact_length_mm", "-", "mm", non_negative(),
              "edge with a chip above 1e-4 mm")
      .output(&ToothLoad::chip_section_mm2, "chip_section_mm2", "-", "mm2", non_negative(), "chip section")
      .output(&ToothLoad::cutting_force_n, "cutting_force_n", "F", "N", non_negative(),
              "cutting force (Kienzle); null unless both constants are given");
  source
      .function<&hobbing_load_summary>("hobbing_load_summary", "Loads of all teeth over the whole arc.",
                                       "(C3)", Provenance::completion)
      .with([](auto& f) { process_inputs(f, 6); })
      .optional(&LoadSummaryInputs::angle_step_deg, "angle_step_deg", "-", "deg", closed(0.1, 10),
                "step of the tooth angle")
      .example(10.0)
      .output(&LoadSummary::max_chip_thickness_mm, "max_chip_thickness_mm", "a_max", "mm", non_negative(),
              "largest chip thickness")
      .output(&LoadSummary::chip_volume_per_gap_mm3, "chip_volume_per_gap_mm3", "-", "mm3", non_negative(),
              "chip volume per tooth gap and blank revolution")
      .output(&LoadSummary::most_loaded_tooth, "most_loaded_tooth", "j", "1", any(),
              "tooth that removes most")
      .output(&LoadSummary::most_loaded_share, "most_loaded_share", "-", "1", probability(),
              "its share of the volume")
      .output(&LoadSummary::first_tooth_index, "first_tooth_index", "-(J+1)", "1", any(),
              "tooth of the first share")
      .output(&LoadSummary::tooth_shares, "tooth_shares", "-", "1", probability(), "shares of all teeth")
      .note("Peaks change by up to 2 % with the angle grid.");
  source
      .function<&hoffmeister_chip_thickness>("hoffmeister_chip_thickness",
                                             "Fast estimate of the largest chip thickness.", "(C5)",
                                             Provenance::completion)
      .optional(&HoffmeisterInputs::module_mm, "module_mm", "m_n", "mm", module_range, "normal module")
      .optional(&HoffmeisterInputs::gear_teeth, "gear_teeth", "Z_k", "1", teeth_range, "teeth of the gear")
      .optional(&HoffmeisterInputs::gear_helix_deg, "gear_helix_deg", "beta_w", "deg", helix_range,
                "helix angle of the gear")
      .optional(&HoffmeisterInputs::profile_shift, "profile_shift", "x", "1", shift_range,
                "profile shift factor")
      .optional(&HoffmeisterInputs::hob_diameter_mm, "hob_diameter_mm", "d_a0", "mm", hob_range,
                "outer diameter of the hob")
      .optional(&HoffmeisterInputs::hob_gashes, "hob_gashes", "Z_f", "1", gash_range, "gashes of the hob")
      .optional(&HoffmeisterInputs::hob_starts, "hob_starts", "z_0", "1", at_least(1), "starts of the hob")
      .optional(&HoffmeisterInputs::axial_feed_mm_rev, "axial_feed_mm_rev", "S_oc", "mm/rev", feed_range,
                "axial feed per blank revolution")
      .input(&HoffmeisterInputs::cutting_depth_mm, "cutting_depth_mm", "h_cut", "mm", positive(),
             "cutting depth", 11.25)
      .output(&HoffmeisterChip::max_chip_thickness_mm, "max_chip_thickness_mm", "h", "mm", non_negative(),
              "largest chip thickness")
      .note("Do not trust the helix dependence above about 15 deg; confirm the exponents before planning.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K101",
       .title = "Determination of chip thickness in hobbing of gear wheels",
       .authors = "Ravska N. S., Okhrimenko O. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "A single-start hob cuts a spur or helical gear by continuous generation with axial feed. "
                 "Chip thickness at any point of any tooth is the normal distance to what earlier teeth and "
                 "blank revolutions left; from it tooth loads, removed volumes and their spread over the "
                 "teeth. The same geometry gives approach length and main time.",
       .role = "gears",
       .errata = {
           "Eq. (2): the feed is missing in the differential rotation of the blank, which without it has "
           "the unit 1/mm; the same in (10).",
           "Eq. (4): the second row of the second matrix is printed 1 1 1 A; it is 0 1 0 A.",
           "Eq. (5): the section of a convolute hob is at minus the lead angle with the printed signs.",
           "Eq. (6): the sign of the third component of the hob cylinder contradicts (4).",
           "Eq. (7): the root covers the whole expression in print and two angles are confused.",
           "The worked example is called counter feed; by the usual definition it is climb."}});
  describe_geometry(source);
  describe_times(source);
  describe_chips(source);
}

}  // namespace verstat::models::k101
