// Description of K203; the formulas stand in k203_groove_geometry.cpp and k203_groove_process.cpp.
#include "models/grinding/k203_crossed_axis_groove_grinding.h"

namespace verstat::models::k203 {

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K203",
       .title = "Forming helical surfaces of ball-screw parts by grinding with crossed tool and part axes",
       .authors = "Kalchenko V. V., Yeroshenko A. M.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Finish grinding of the circular-arc helical groove of a ball screw or nut with a wheel whose "
           "axis "
           "crosses the part axis: the wheel profile a groove needs, the groove a wheel makes, stock removal "
           "with wear and grain structure, and a narrow wheel that is tilted more at every pass so that the "
           "arc grows along equidistant curves. Also the dressing depth that restores a worn profile.",
       .role = "grinding",
       .errata = {
           "Eq. (10) misses the position vector on the right-hand side.",
           "Eq. (14) prints -y_c - t k, right for a nut; for a screw the wheel is farther out. The functions "
           "take the centre distance itself.",
           "Eq. (16) mixes mm and rad in the width factor (for a worn profile it is (rho - I) dphi), leaves "
           "y_e without the unit of a speed (taken as the retreat speed of the wheel surface), and must be "
           "clipped where V.n <= y_e.",
           "Eq. (17): the text measures alpha from the crown, which inverts the result; alpha is the angle "
           "from the wheel axis direction."}});

  const auto groove = [](auto& f) {
    f.input(&Groove::center_radius_mm, "center_radius_mm", "R", "mm", positive(),
            "radius of the profile centre from the part axis", 20.0)
        .input(&Groove::profile_radius_mm, "profile_radius_mm", "rho", "mm", any(),
               "profile radius, > 0 nut, < 0 screw", -3.1)
        .input(&Groove::lead_mm, "lead_mm", "S", "mm", positive(), "lead, right hand", 10.0);
  };
  const auto internal = [](auto& f, auto member) {
    f.optional(member, "internal", "-", "1", closed(0, 1), "1 for a nut, 0 for a screw");
  };
  const auto setting = [&](auto& f) {
    f.input(&WheelSetting::wheel_center_radius_mm, "wheel_center_radius_mm", "R_u", "mm", positive(),
            "radius of the profile centre of the wheel", 147.0)
        .input(&WheelSetting::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho_u", "mm", positive(),
               "profile radius of the wheel", 2.5)
        .input(&WheelSetting::lead_mm, "lead_mm", "S", "mm", positive(), "lead, right hand", 10.0)
        .input(&WheelSetting::center_distance_mm, "center_distance_mm", "a_c", "mm", positive(),
               "distance of the axes along y", 166.5)
        .input(&WheelSetting::tilt_deg, "tilt_deg", "psi", "deg", closed(-90, 90), "tilt of the wheel axis",
               3.0);
    internal(f, &WheelSetting::internal);
  };
  const auto wheel = [&](auto& f) {
    f.input(&CrossedWheel::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho_u", "mm", positive(),
            "profile radius of the wheel", 2.7)
        .input(&CrossedWheel::wheel_outer_radius_mm, "wheel_outer_radius_mm", "R_w", "mm", positive(),
               "outer radius of the wheel", 150.0)
        .input(&CrossedWheel::groove_bottom_radius_mm, "groove_bottom_radius_mm", "Y", "mm", positive(),
               "radius of the groove bottom", 16.9)
        .input(&CrossedWheel::lead_mm, "lead_mm", "S", "mm", positive(), "lead, right hand", 10.0);
    internal(f, &CrossedWheel::internal);
  };
  const auto fit = [](auto& f, auto radius, auto center, auto form, auto rms) {
    f.output(radius, "fit_radius_mm", "-", "mm", positive(), "radius of the least-squares arc")
        .output(center, "fit_center_radius_mm", "-", "mm", any(), "distance of its centre from the part axis")
        .output(form, "form_error_mm", "-", "mm", non_negative(), "largest minus smallest deviation")
        .output(rms, "rms_error_mm", "-", "mm", non_negative(), "root mean square deviation");
  };
  const auto fit_arc = [](auto& f) {
    f.note("Algebraic (Kasa) least squares, centre free in both coordinates; axial section.");
  };

  source
      .function<&helical_groove_point>("helical_groove_point", "Point and unit normal of the groove surface.",
                                       "eqs. (1)-(3)", Provenance::paper)
      .with(groove)
      .input(&GroovePosition::theta_deg, "theta_deg", "theta", "deg", any(), "angle along the helix", 30.0)
      .input(&GroovePosition::phi_deg, "phi_deg", "phi", "deg", open(-90, 90), "angle of the arc", 40.0)
      .output(&GroovePoint::x_mm, "x_mm", "x", "mm", any(), "point")
      .output(&GroovePoint::y_mm, "y_mm", "y", "mm", any(), "point")
      .output(&GroovePoint::z_mm, "z_mm", "z", "mm", any(), "point, along the part axis")
      .output(&GroovePoint::nx, "nx", "n_x", "1", closed(-1, 1), "unit normal")
      .output(&GroovePoint::ny, "ny", "n_y", "1", closed(-1, 1), "unit normal")
      .output(&GroovePoint::nz, "nz", "n_z", "1", closed(-1, 1), "unit normal")
      .note("The normal is derived from eq. (1).");
  source
      .function<&wheel_profile_point>("wheel_profile_point",
                                      "Point of the wheel profile that a groove needs.", "eqs. (4)-(11)",
                                      Provenance::repaired)
      .with(groove)
      .input(&GrooveToWheel::center_distance_mm, "center_distance_mm", "a_c", "mm", positive(),
             "distance of the axes along y", 166.9)
      .input(&GrooveToWheel::tilt_deg, "tilt_deg", "psi", "deg", closed(-15, 15), "tilt of the wheel axis",
             -4.55)
      .input(&GrooveToWheel::phi_deg, "phi_deg", "phi", "deg", closed(-60, 60), "angle of the arc", 30.0)
      .output(&WheelPoint::theta_deg, "theta_deg", "theta", "deg", closed(-40, 40), "angle of the contact")
      .output(&WheelPoint::wheel_radius_mm, "wheel_radius_mm", "-", "mm", non_negative(), "wheel radius")
      .output(&WheelPoint::wheel_axial_mm, "wheel_axial_mm", "-", "mm", any(), "axial place on the wheel")
      .note("Undercut is checked at this point only: sample phi for a whole wheel.");
  source
      .function<&ground_groove_point>("ground_groove_point",
                                      "Axial-section point that a toroidal wheel makes.", "eqs. (12)-(15)",
                                      Provenance::repaired)
      .with(setting)
      .input(&WheelToGroove::phi_deg, "phi_deg", "phi", "deg", closed(-60, 60), "angle of the wheel profile",
             20.0)
      .output(&GrooveSectionPoint::wheel_angle_deg, "wheel_angle_deg", "theta_u", "deg", any(),
              "angle of the contact on the wheel")
      .output(&GrooveSectionPoint::groove_radius_mm, "groove_radius_mm", "-", "mm", non_negative(),
              "radius in the axial section")
      .output(&GrooveSectionPoint::groove_axial_mm, "groove_axial_mm", "-", "mm", any(),
              "axial place in the section");
  source
      .function<&groove_profile_fit>("groove_profile_fit", "Arc of the section that a toroidal wheel makes.",
                                     "eqs. (12)-(15), least squares", Provenance::completion)
      .with(setting)
      .input(&SectionSampling::phi_max_deg, "phi_max_deg", "phi_max", "deg", open_low(0, 60),
             "half angle of the sampled wheel arc", 40.0)
      .optional(&SectionSampling::points, "points", "-", "1", closed(5, 10'000), "sampled points")
      .with([&](auto& f) {
        fit(f, &GrooveFit::fit_radius_mm, &GrooveFit::fit_center_radius_mm, &GrooveFit::form_error_mm,
            &GrooveFit::rms_error_mm);
      })
      .output(&GrooveFit::half_width_mm, "half_width_mm", "-", "mm", non_negative(),
              "half of the axial extent")
      .with(fit_arc);
  source
      .function<&pass_form_error>("pass_form_error", "Groove left by a pass before the final settings.",
                                  "eqs. (4)-(15)", Provenance::repaired)
      .with(groove)
      .input(&IntermediatePass::final_center_distance_mm, "final_center_distance_mm", "a_c", "mm", positive(),
             "centre distance the wheel is dressed for", 166.9)
      .input(&IntermediatePass::final_tilt_deg, "final_tilt_deg", "psi", "deg", closed(-15, 15),
             "tilt the wheel is dressed for", 3.8)
      .input(&IntermediatePass::pass_center_distance_mm, "pass_center_distance_mm", "a_c", "mm", positive(),
             "centre distance of the pass", 166.94)
      .input(&IntermediatePass::pass_tilt_deg, "pass_tilt_deg", "psi", "deg", closed(-90, 90),
             "tilt of the pass", 3.0)
      .input(&IntermediatePass::phi_max_deg, "phi_max_deg", "phi_max", "deg", open_low(0, 60),
             "half angle of the groove arc", 40.0)
      .optional(&IntermediatePass::points, "points", "-", "1", closed(5, 10'000), "sampled points")
      .with([&](auto& f) {
        fit(f, &PassFormError::fit_radius_mm, &PassFormError::fit_center_radius_mm,
            &PassFormError::form_error_mm, &PassFormError::rms_error_mm);
      })
      .with(fit_arc);
  source
      .function<&effective_groove_radius>("effective_groove_radius",
                                          "Radius of the groove arc at its bottom.",
                                          "completion, second-order envelope", Provenance::completion)
      .with(wheel)
      .input(&TiltedWheel::tilt_deg, "tilt_deg", "psi", "deg", closed(-90, 90), "tilt of the wheel axis", 3.0)
      .output(&GrooveRadius::groove_radius_mm, "groove_radius_mm", "rho_axial", "mm", non_negative(),
              "radius in the axial section");
  source
      .function<&tilt_for_radius>("tilt_for_radius", "Tilt that makes a wanted groove radius.",
                                  "completion, inverse", Provenance::completion)
      .input(&WantedRadius::groove_radius_mm, "groove_radius_mm", "rho", "mm", positive(), "wanted radius",
             3.1)
      .with(wheel)
      .output(&Tilt::tilt_deg, "tilt_deg", "psi", "deg", closed(-90, 90), "tilt of the wheel axis")
      .note("From the aligned position up to 40 deg further, against the helix direction.");
  source
      .function<&pass_schedule>("pass_schedule", "Settings of every working pass of the narrow wheel.",
                                "completion of the proposed method", Provenance::completion)
      .input(&PassPlan::groove_center_radius_mm, "groove_center_radius_mm", "R", "mm", positive(),
             "radius of the profile centre", 20.0)
      .input(&PassPlan::final_profile_radius_mm, "final_profile_radius_mm", "rho_d", "mm", positive(),
             "final profile radius", 3.1)
      .input(&PassPlan::stock_mm, "stock_mm", "delta", "mm", non_negative(), "stock along the normal", 0.2)
      .input(&PassPlan::infeed_mm, "infeed_mm", "t", "mm", positive(), "depth of a pass", 0.05)
      .input(&PassPlan::lead_mm, "lead_mm", "S", "mm", positive(), "lead, right hand", 10.0)
      .input(&PassPlan::wheel_outer_radius_mm, "wheel_outer_radius_mm", "R_w", "mm", positive(),
             "outer radius of the wheel", 150.0)
      .input(&PassPlan::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho_u", "mm", positive(),
             "profile radius of the wheel", 2.7)
      .with([&](auto& f) { internal(f, &PassPlan::internal); })
      .output(&PassSchedule::profile_radius_mm, "profile_radius_mm", "rho_k", "mm", positive(),
              "groove radius after the pass")
      .output(&PassSchedule::center_distance_mm, "center_distance_mm", "a_k", "mm", any(),
              "centre distance of the pass")
      .output(&PassSchedule::tilt_deg, "tilt_deg", "psi_k", "deg", closed(-90, 90), "tilt of the pass")
      .note("An exact final arc needs the wheel dressed along the arc in the tilted position.");
  source
      .function<&grinding_removal_rate>("grinding_removal_rate",
                                        "Removal rate with wear, retreat and grain coverage.", "eq. (16)",
                                        Provenance::repaired)
      .input(&RemovalRegime::wheel_center_radius_mm, "wheel_center_radius_mm", "R_u", "mm", positive(),
             "radius of the profile centre", 147.0)
      .input(&RemovalRegime::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho_u", "mm", positive(),
             "profile radius of the wheel", 3.1)
      .input(&RemovalRegime::wear_mm, "wear_mm", "I", "mm", non_negative(), "wear of the profile", 0.02)
      .input(&RemovalRegime::phi_max_deg, "phi_max_deg", "phi_max", "deg", open(0, 90),
             "half angle of the profile in contact", 45.0)
      .input(&RemovalRegime::traverse_speed_m_min, "traverse_speed_m_min", "v", "m/min", positive(),
             "speed along the groove", 2.0)
      .input(&RemovalRegime::infeed_mm, "infeed_mm", "t", "mm", positive(), "depth of the pass", 0.02)
      .input(&RemovalRegime::retreat_speed_mm_s, "retreat_speed_mm_s", "y_e", "mm/s", non_negative(),
             "retreat of the wheel surface by wear and deflection", 0.1)
      .input(&RemovalRegime::grain_ratio, "grain_ratio", "sum b_i / b_0", "1", non_negative(),
             "grain trace widths over the reference width; >= 5 for a dense wheel", 2.0)
      .input(&RemovalRegime::scheme, "scheme", "-", "-", no_range(),
             "stock as the arc moved radially, or of equal normal depth", "shifted")
      .output(&RemovalRate::q_mm3_min, "q_mm3_min", "Q", "mm3/min", non_negative(), "removal rate")
      .output(&RemovalRate::q_center_mm2_min, "q_center_mm2_min", "q'(0)", "mm2/min", non_negative(),
              "rate per mm of profile at the crown")
      .output(&RemovalRate::contact_arc_deg, "contact_arc_deg", "-", "deg", non_negative(),
              "angle of contact at the crown")
      .note("Kinematics of a straight traverse: completion.");
  source
      .function<&removed_volume>("removed_volume", "Metal removed from one part.",
                                 "completion, helical sweep", Provenance::completion)
      .with(groove)
      .input(&StockOnGroove::thread_length_mm, "thread_length_mm", "L", "mm", positive(),
             "length of the thread", 300.0)
      .input(&StockOnGroove::stock_mm, "stock_mm", "delta", "mm", non_negative(), "stock", 0.2)
      .input(&StockOnGroove::phi_max_deg, "phi_max_deg", "phi_max", "deg", open_low(0, 90),
             "half angle of the arc", 45.0)
      .input(&StockOnGroove::scheme, "scheme", "-", "-", no_range(),
             "stock as the arc moved radially, or of equal normal depth", "concentric")
      .output(&RemovedVolume::section_mm2, "section_mm2", "A", "mm2", non_negative(), "axial section")
      .output(&RemovedVolume::groove_length_mm, "groove_length_mm", "L_g", "mm", positive(),
              "helix of the profile centre")
      .output(&RemovedVolume::volume_mm3, "volume_mm3", "V", "mm3", any(), "volume per part");
  source
      .function<&plunge_length>("plunge_length", "Infeed path of the copying method.", "text",
                                Provenance::paper)
      .input(&Plunge::stock_mm, "stock_mm", "delta", "mm", non_negative(), "stock along the normal", 0.2)
      .input(&Plunge::theta_max_deg, "theta_max_deg", "Theta_max", "deg", open_high(0, 90),
             "largest rise angle of the profile", 45.0)
      .output(&PlungeLength::length_mm, "length_mm", "l", "mm", non_negative(), "infeed path");
  source
      .function<&dressing_depth>("dressing_depth", "Depth of dressing that restores a worn arc.", "eq. (17)",
                                 Provenance::repaired)
      .input(&WornProfile::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho", "mm", positive(),
             "profile radius of the wheel", 3.1)
      .input(&WornProfile::wear_mm, "wear_mm", "I", "mm", non_negative(), "wear at the point", 0.02)
      .input(&WornProfile::alpha_deg, "alpha_deg", "alpha", "deg", closed(0, 90),
             "place on the arc from the wheel axis direction; 90 is the crown", 30.0)
      .output(&DressingDepth::depth_mm, "depth_mm", "k'", "mm", non_negative(), "depth at the profile centre")
      .note("The angle convention is inferred: the printed 3.16 mm fits a radius of 100 mm at alpha 0.");
  source
      .function<&dressing_volume>("dressing_volume", "Abrasive lost in one dressing.", "derived",
                                  Provenance::completion)
      .input(&Dressing::wheel_center_radius_mm, "wheel_center_radius_mm", "R_u", "mm", positive(),
             "radius of the profile centre", 147.0)
      .input(&Dressing::wheel_profile_radius_mm, "wheel_profile_radius_mm", "rho", "mm", positive(),
             "profile radius of the wheel", 3.1)
      .input(&Dressing::wheel_width_mm, "wheel_width_mm", "H", "mm", positive(), "wheel width", 4.4)
      .input(&Dressing::depth_mm, "depth_mm", "k'", "mm", non_negative(), "depth of dressing", 0.05)
      .output(&DressingVolume::section_mm2, "section_mm2", "-", "mm2", non_negative(), "section removed")
      .output(&DressingVolume::volume_mm3, "volume_mm3", "-", "mm3", non_negative(), "volume removed")
      .note("Counts the already worn layer too: an upper bound.");
  source
      .function<&wheel_wear_per_part>("wheel_wear_per_part", "Wheel wear and dressings per part.",
                                      "completion, grinding ratio", Provenance::completion)
      .input(&WearInputs::stock_mm, "stock_mm", "delta", "mm", non_negative(), "stock", 0.2)
      .input(&WearInputs::groove_length_mm, "groove_length_mm", "L_g", "mm", positive(),
             "length of the groove", 3780.0)
      .input(&WearInputs::wheel_outer_radius_mm, "wheel_outer_radius_mm", "R_w", "mm", positive(),
             "outer radius of the wheel", 150.0)
      .input(&WearInputs::grinding_ratio, "grinding_ratio", "G", "1", positive(),
             "volume of metal per volume of wheel", 60.0)
      .input(&WearInputs::wear_limit_mm, "wear_limit_mm", "I_limit", "mm", positive(),
             "wear that calls for dressing", 0.02)
      .input(&WearInputs::phi_max_deg, "phi_max_deg", "phi_max", "deg", open_high(0, 90),
             "half angle of the arc", 45.0)
      .input(&WearInputs::method, "method", "-", "-", no_range(), "narrow tilted wheel or copying wheel",
             "narrow")
      .output(&WheelWear::wear_per_part_mm, "wear_per_part_mm", "I_1", "mm", non_negative(), "wear per part")
      .output(&WheelWear::dressings_per_part, "dressings_per_part", "-", "1", non_negative(),
              "dressings per part")
      .note(
          "Both methods get the same load per mm of profile; a narrow wheel carries more by groove arc over "
          "wheel arc.");
  source
      .function<&groove_grinding_time>("groove_grinding_time", "Passes and time per part.", "completion",
                                       Provenance::completion)
      .input(&GrindingPlan::thread_length_mm, "thread_length_mm", "L", "mm", positive(),
             "length of the thread", 300.0)
      .input(&GrindingPlan::lead_mm, "lead_mm", "S", "mm", positive(), "lead", 10.0)
      .input(&GrindingPlan::overrun_mm, "overrun_mm", "-", "mm", non_negative(), "overrun of a stroke", 20.0)
      .input(&GrindingPlan::stock_mm, "stock_mm", "delta", "mm", non_negative(), "stock", 0.2)
      .input(&GrindingPlan::infeed_mm, "infeed_mm", "t", "mm", positive(), "depth of a pass", 0.02)
      .input(&GrindingPlan::sparkout_passes, "sparkout_passes", "-", "1", non_negative(),
             "passes without infeed", 2)
      .input(&GrindingPlan::part_speed_rpm, "part_speed_rpm", "n_w", "1/min", positive(), "part speed", 6.0)
      .input(&GrindingPlan::return_speed_ratio, "return_speed_ratio", "r", "1", positive(),
             "return speed over working speed", 3.0)
      .input(&GrindingPlan::setting_time_min, "setting_time_min", "t_set", "min", non_negative(),
             "setting before every stroke", 0.05)
      .input(&GrindingPlan::dressing_time_min, "dressing_time_min", "t_dress", "min", non_negative(),
             "time of a dressing", 5.0)
      .input(&GrindingPlan::dressings_per_part, "dressings_per_part", "-", "1", non_negative(),
             "dressings per part", 0.25)
      .output(&GrindingTime::passes, "passes", "k", "1", non_negative(), "passes with spark-out")
      .output(&GrindingTime::pass_time_min, "pass_time_min", "-", "min", positive(),
              "working stroke without return")
      .output(&GrindingTime::time_min, "time_min", "T", "min", non_negative(), "time per part");
}

}  // namespace verstat::models::k203
