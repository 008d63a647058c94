// Description of K412; the formulas stand in k412_roll_geometry.cpp, k412_roll_turning.cpp and
// k412_roll_grinding.cpp.
#include "models/toolpath/k412_straightening_roll.h"

namespace verstat::models::k412 {
namespace {

// The worked example on a coarse grid: throat 200, pipe 60, 30 deg, half length 120.
const Value::List example_y = {-120.0, -80.0, -40.0, 0.0, 40.0, 80.0, 120.0};
const Value::List example_x = {116.2755, 107.4391, 101.8932, 100.0, 101.8932, 107.4391, 116.2755};

void describe_geometry(Source& source) {
  const auto roll = [](auto& f) {
    f.input(&RollAndPipe::throat_diameter_mm, "D_throat_mm", "D_g", "mm", positive(),
            "diameter of the roll at the throat", 200.0)
        .input(&RollAndPipe::pipe_diameter_mm, "D_pipe_mm", "D_t", "mm", positive(), "pipe diameter", 60.0)
        .input(&RollAndPipe::crossing_angle_deg, "alpha_deg", "alpha", "deg", closed(5, 90),
               "angle between the axes of roll and pipe", 30.0);
  };
  const auto sampling = [&](auto& f) {
    f.with(roll)
        .input(&ProfileSampling::half_length_mm, "half_length_mm", "-", "mm", positive(),
               "half length of the working profile", 120.0)
        .input(&ProfileSampling::n_points, "n_points", "-", "1", closed(3, 20'001), "number of points, odd",
               7);
  };
  const auto contour = [](auto& f) {
    f.input(&Contour::y_mm, "y_mm", "y", "mm", any(), "axial places, not falling", example_y)
        .length(2, 5000)
        .input(&Contour::x_radius_mm, "x_radius_mm", "x", "mm", non_negative(), "radii", example_x)
        .length(2, 5000);
  };
  const auto contour_out = [](auto& f) {
    f.output(&Contour::y_mm, "y_mm", "y", "mm", any(), "axial places")
        .output(&Contour::x_radius_mm, "x_radius_mm", "x", "mm", any(), "radii");
  };

  source
      .function<&roll_profile_point>("roll_profile_point", "Point of the roll profile.", "eqs. (1), (2)",
                                     Provenance::repaired)
      .with(roll)
      .input(&ProfileAngle::phi_deg, "phi_deg", "phi", "deg", open_low(0, 90),
             "parameter of the profile; 90 is the throat", 65.0)
      .output(&ProfilePoint::diameter_mm, "X_dia_mm", "X", "mm", positive(), "diameter")
      .output(&ProfilePoint::y_mm, "y_mm", "y", "mm", non_negative(), "axial place from the throat");
  source
      .function<&roll_phi_at_y>("roll_phi_at_y", "Parameter of the profile at an axial place.",
                                "inverse of eq. (2)", Provenance::completion)
      .with(roll)
      .input(&ProfilePlace::y_mm, "y_mm", "y", "mm", any(), "axial place; the sign does not matter", 80.0)
      .output(&Phi::phi_deg, "phi_deg", "phi", "deg", closed(0, 90), "parameter of the profile");
  source
      .function<&roll_profile>("roll_profile", "Working profile of the roll, uniform in y.", "eqs. (1), (2)",
                               Provenance::repaired)
      .with(sampling)
      .with(contour_out)
      .output(&RollProfile::phi_end_deg, "phi_end_deg", "phi", "deg", closed(0, 90), "parameter at the end")
      .output(&RollProfile::end_diameter_mm, "X_end_mm", "X", "mm", positive(), "diameter at the end")
      .output(&RollProfile::throat_curvature_radius_mm, "throat_curvature_radius_mm", "rho_0", "mm",
              positive(), "radius of curvature of the axial section at the throat")
      .note("Chord error spacing^2 / (8 rho): choose the spacing accordingly.");
  source
      .function<&roll_pipe_gap>("roll_pipe_gap", "Clearance between roll and pipe per section.", "completion",
                                Provenance::completion)
      .with(contour)
      .input(&RollSetup::pipe_diameter_mm, "D_pipe_mm", "D_t", "mm", positive(), "pipe diameter", 50.0)
      .input(&RollSetup::crossing_angle_deg, "alpha_deg", "alpha", "deg", closed(5, 90),
             "angle between the axes", 30.0)
      .input(&RollSetup::centre_distance_mm, "centre_distance_mm", "a", "mm", positive(),
             "distance of the axes of roll and pipe", 125.0)
      .output(&RollGap::gap_mm, "gap_mm", "-", "mm", any(), "clearance of every section")
      .output(&RollGap::gap_min_mm, "gap_min_mm", "-", "mm", any(), "smallest; negative: interference")
      .output(&RollGap::gap_max_mm, "gap_max_mm", "-", "mm", any(), "largest")
      .note("Geometry only: deformation is not in it.");
  source
      .function<&roll_pipe_fit>("roll_pipe_fit", "Best set-up of an existing roll for another pipe.",
                                "completion", Provenance::completion)
      .with(contour)
      .input(&FitSearch::pipe_diameter_mm, "D_pipe_mm", "D_t", "mm", positive(), "pipe diameter", 50.0)
      .input(&FitSearch::alpha_min_deg, "alpha_min_deg", "-", "deg", closed(5, 90), "smallest angle", 25.0)
      .input(&FitSearch::alpha_max_deg, "alpha_max_deg", "-", "deg", closed(5, 90), "largest angle", 35.0)
      .output(&RollFit::alpha_deg, "alpha_deg", "alpha", "deg", closed(5, 90), "best angle")
      .output(&RollFit::centre_distance_mm, "centre_distance_mm", "a", "mm", non_negative(),
              "distance at which the pipe touches the roll")
      .output(&RollFit::gap_max_mm, "gap_max_mm", "-", "mm", any(), "largest clearance")
      .note("A best angle at an end of the range is a limit, not an optimum.");
  source
      .function<&roll_end_fillet>("roll_end_fillet", "Fillet from the end of the profile to the face.",
                                  "eq. (3)", Provenance::repaired)
      .input(&ProfileEnd::y_k_mm, "y_k", "y_k", "mm", any(), "last point, right end", 120.0)
      .input(&ProfileEnd::x_k_mm, "x_k", "x_k", "mm", non_negative(), "its radius", 114.0)
      .input(&ProfileEnd::y_k1_mm, "y_k1", "y_{k-1}", "mm", any(), "last but one point", 119.0)
      .input(&ProfileEnd::x_k1_mm, "x_k1", "x_{k-1}", "mm", non_negative(), "its radius", 113.8)
      .input(&ProfileEnd::fillet_radius_mm, "R_c_mm", "R_C", "mm", positive(), "radius of the fillet", 12.0)
      .output(&EndFillet::beta_deg, "beta_deg", "beta", "deg", closed(0, 90),
              "rise of the profile at its end")
      .output(&EndFillet::y_c_mm, "y_c_mm", "y_c", "mm", any(), "centre of the fillet")
      .output(&EndFillet::x_c_mm, "x_c_mm", "x_c", "mm", non_negative(), "centre of the fillet")
      .output(&EndFillet::max_diameter_mm, "X_max_mm", "X_max", "mm", positive(), "diameter of the crest")
      .output(&EndFillet::y_face_mm, "y_face_mm", "-", "mm", any(), "axial place of the face")
      .output(&EndFillet::arc_length_mm, "arc_length_mm", "-", "mm", positive(), "length of the arc");
  source
      .function<&roll_contour>("roll_contour", "Fillets and profile, left face to right face.",
                               "eqs. (1)-(3)", Provenance::repaired)
      .with(sampling)
      .input(&ContourSampling::fillet_radius_mm, "R_c_mm", "R_C", "mm", positive(), "radius of the fillet",
             12.0)
      .input(&ContourSampling::arc_points, "arc_points", "-", "1", closed(1, 10'000),
             "steps of each fillet arc", 3)
      .with(contour_out)
      .output(&RollContour::max_diameter_mm, "X_max_mm", "X_max", "mm", positive(),
              "largest diameter: of the points or of the crest of the fillet")
      .output(&RollContour::length_mm, "length_mm", "-", "mm", positive(), "length of the contour");
}

void describe_turning(Source& source) {
  const auto contour = [](auto& f) {
    f.input(&Contour::y_mm, "y_mm", "y", "mm", any(), "axial places, not falling", example_y)
        .length(2, 100'000)
        .input(&Contour::x_radius_mm, "x_radius_mm", "x", "mm", non_negative(), "radii", example_x)
        .length(2, 100'000);
  };

  source.function<&path_length>("path_length", "Length of a contour.", "definition", Provenance::completion)
      .with(contour)
      .output(&Length::length_mm, "length_mm", "-", "mm", positive(), "length of the polyline");
  source
      .function<&offset_contour>("offset_contour", "Equidistant of a contour, mitred.", "completion",
                                 Provenance::completion)
      .with(contour)
      .input(&OffsetInput::offset_mm, "offset_mm", "-", "mm", any(), "distance, + away from the material",
             1.1)
      .output(&Contour::y_mm, "y_mm", "y", "mm", any(), "axial places")
      .output(&Contour::x_radius_mm, "x_radius_mm", "x", "mm", any(), "radii")
      .note("Valid for an offset below the smallest concave radius; loops are not removed.");
  source
      .function<&contour_pass_time>("contour_pass_time", "Length and main time of one contour pass.",
                                    "completion", Provenance::completion)
      .with(contour)
      .input(&PassInput::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.2)
      .input(&PassInput::speed_m_min, "v_m_min", "v", "m/min", any(), "surface speed; ignored in mode rpm",
             140.0)
      .input(&PassInput::max_rpm, "n_max_rpm", "n_max", "1/min", any(),
             "largest spindle speed; ignored in mode rpm", 1200.0)
      .optional(&PassInput::mode, "mode", "-", "-", no_range(), "constant surface speed or spindle speed")
      .optional(&PassInput::rpm, "n_rpm", "n", "1/min", any(), "spindle speed; ignored in mode css")
      .optional(&PassInput::approach_mm, "approach_mm", "-", "mm", non_negative(),
                "approach, at the radius of the first point")
      .optional(&PassInput::overrun_mm, "overrun_mm", "-", "mm", non_negative(),
                "overrun, at the radius of the last point")
      .output(&PassTime::length_mm, "length_mm", "-", "mm", positive(), "length with approach and overrun")
      .output(&PassTime::main_time_min, "t_main_min", "t", "min", positive(), "main time");
  source
      .function<&rough_turning_plan>("rough_turning_plan", "Roughing in two phases.",
                                     "completion, cylinder and equidistants", Provenance::completion)
      .with(contour)
      .input(&RoughTurning::blank_diameter_mm, "D_blank_mm", "-", "mm", positive(), "diameter of the blank",
             265.0)
      .input(&RoughTurning::finish_allowance_mm, "allowance_finish_mm", "-", "mm", non_negative(),
             "for finish turning, per side", 0.8)
      .input(&RoughTurning::grind_allowance_mm, "allowance_grind_mm", "-", "mm", non_negative(),
             "for grinding, per side", 0.3)
      .input(&RoughTurning::max_depth_mm, "depth_max_mm", "-", "mm", positive(), "largest depth of cut", 3.0)
      .input(&RoughTurning::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.4)
      .input(&RoughTurning::speed_m_min, "v_m_min", "v", "m/min", positive(), "surface speed", 90.0)
      .input(&RoughTurning::max_rpm, "n_max_rpm", "n_max", "1/min", positive(), "largest spindle speed",
             800.0)
      .input(&RoughTurning::approach_mm, "approach_mm", "-", "mm", non_negative(),
             "approach of a cylinder pass", 3.0)
      .input(&RoughTurning::overrun_mm, "overrun_mm", "-", "mm", non_negative(), "overrun of a cylinder pass",
             3.0)
      .input(&RoughTurning::rapid_mm_min, "rapid_mm_min", "-", "mm/min", positive(), "rapid speed", 4000.0)
      .output(&RoughPlan::cylinder_diameter_mm, "D_cylinder_mm", "-", "mm", positive(),
              "diameter after the first phase")
      .output(&RoughPlan::cylinder_passes, "passes_cylinder", "i_1", "1", non_negative(), "cylinder passes")
      .output(&RoughPlan::cylinder_depth_mm, "depth_cylinder_mm", "-", "mm", any(), "their depth")
      .output(&RoughPlan::contour_passes, "passes_contour", "i_2", "1", non_negative(), "contour passes")
      .output(&RoughPlan::contour_depth_mm, "depth_contour_mm", "-", "mm", non_negative(), "their depth")
      .output(&RoughPlan::contour_lengths_mm, "contour_lengths_mm", "-", "mm", non_negative(),
              "length of every contour pass, in cutting order")
      .output(&RoughPlan::cut_length_mm, "cut_length_mm", "-", "mm", non_negative(), "length of both phases")
      .output(&RoughPlan::cylinder_time_min, "t_main_cylinder_min", "-", "min", non_negative(),
              "main time of the cylinder passes")
      .output(&RoughPlan::main_time_min, "t_main_min", "-", "min", non_negative(), "main time of both phases")
      .output(&RoughPlan::rapid_time_min, "t_rapid_min", "-", "min", non_negative(), "rapid returns")
      .output(&RoughPlan::removed_cm3, "removed_cm3", "-", "cm3", any(), "volume removed")
      .note(
          "The paper fixes the first phase to the crest plus allowances and names the second an equidistant "
          "scheme.");
  source.function<&facing_time>("facing_time", "Main time of one face.", "completion", Provenance::completion)
      .input(&Facing::outer_diameter_mm, "D_outer_mm", "-", "mm", positive(), "outer diameter", 265.0)
      .input(&Facing::inner_diameter_mm, "D_inner_mm", "-", "mm", non_negative(), "inner diameter; 0: centre",
             0.0)
      .input(&Facing::allowance_mm, "allowance_mm", "-", "mm", non_negative(), "axial allowance", 4.0)
      .input(&Facing::max_depth_mm, "depth_max_mm", "-", "mm", positive(), "largest depth of cut", 2.0)
      .input(&Facing::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.3)
      .input(&Facing::speed_m_min, "v_m_min", "v", "m/min", positive(), "surface speed", 90.0)
      .input(&Facing::max_rpm, "n_max_rpm", "n_max", "1/min", positive(), "largest spindle speed", 800.0)
      .input(&Facing::approach_mm, "approach_mm", "-", "mm", non_negative(), "approach", 3.0)
      .output(&FacingTime::passes, "passes", "-", "1", non_negative(), "passes")
      .output(&FacingTime::main_time_min, "t_main_min", "-", "min", non_negative(), "main time");
  source
      .function<&revolve_volume>("revolve_volume", "Volume of a solid of revolution.", "geometry",
                                 Provenance::completion)
      .with(contour)
      .output(&Volume::volume_cm3, "volume_cm3", "V", "cm3", non_negative(), "volume");
  source
      .function<&roll_part_time>("roll_part_time", "Piece time and time per part of a batch.", "completion",
                                 Provenance::completion)
      .input(&OperationTimes::rough_main_min, "t_rough_main", "-", "min", non_negative(), "roughing, main",
             42.0)
      .input(&OperationTimes::rough_rapid_min, "t_rough_rapid", "-", "min", non_negative(), "roughing, rapid",
             1.0)
      .input(&OperationTimes::finish_main_min, "t_finish_main", "-", "min", non_negative(), "finish turning",
             8.0)
      .input(&OperationTimes::facing_main_min, "t_facing_main", "-", "min", non_negative(), "facing", 3.0)
      .input(&OperationTimes::grind_main_min, "t_grind_main", "-", "min", non_negative(), "grinding", 30.0)
      .input(&OperationTimes::handling_min, "t_handling_min", "-", "min", non_negative(),
             "handling per set-up of a piece", 6.0)
      .input(&OperationTimes::setups, "n_setups", "-", "1", non_negative(), "set-ups", 2)
      .input(&OperationTimes::setup_min, "t_setup_min", "-", "min", non_negative(), "machine set-up, each",
             25.0)
      .input(&OperationTimes::programming_min, "t_programming_min", "-", "min", non_negative(),
             "programming; 15-25 min with the integrated system", 20.0)
      .input(&OperationTimes::batch, "batch", "-", "1", at_least(1), "parts in the batch", 4)
      .output(&PartTime::main_min, "t_main_min", "-", "min", non_negative(), "main time")
      .output(&PartTime::piece_min, "t_piece_min", "-", "min", non_negative(), "piece time")
      .output(&PartTime::per_part_min, "t_per_part_min", "-", "min", non_negative(),
              "piece time and share of the batch");
  source
      .function<&gcode_contour>("gcode_contour", "NC text of one contour pass.", "completion (dialect)",
                                Provenance::completion)
      .with(contour)
      .input(&ProgramInput::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed", 0.2)
      .input(&ProgramInput::speed_m_min, "v_m_min", "v", "m/min", positive(), "surface speed", 120.0)
      .input(&ProgramInput::max_rpm, "n_max_rpm", "n_max", "1/min", positive(), "largest spindle speed",
             1500.0)
      .input(&ProgramInput::tool, "tool", "-", "1", closed(1, 99), "tool and offset number", 1)
      .input(&ProgramInput::clearance_mm, "clearance_mm", "-", "mm", non_negative(),
             "distance of the rapid moves from the part", 2.0)
      .optional(&ProgramInput::program, "program", "-", "1", closed(1, 9999), "program number")
      .output(&Program::lines, "lines", "-", "-", no_range(), "lines of the program")
      .note("Theoretical contour: for a nose radius offset it and program the nose centre.");
}

void describe_grinding(Source& source) {
  const auto wheel = [](auto& f, auto wheel_radius, auto profile_radius) {
    f.input(wheel_radius, "R_wheel_mm", "R", "mm", positive(), "dressing radius of the wheel", 250.0)
        .input(profile_radius, "profile_radius_mm", "rho", "mm", any(),
               "radius of the profile, > 0 concave, 0 straight, < 0 convex", 420.0);
  };

  source
      .function<&dressing_radius>("dressing_radius", "Largest dressing radius of the grinding wheel.",
                                  "eqs. (4)-(9)", Provenance::repaired)
      .input(&Contour::y_mm, "y_mm", "y", "mm", any(), "axial places, uniform", example_y)
      .length(5, 100'000)
      .input(&Contour::x_radius_mm, "x_radius_mm", "x", "mm", non_negative(), "radii", example_x)
      .length(5, 100'000)
      .input(&DressingSearch::allowance_mm, "allowance_mm", "a", "mm", non_negative(), "grinding allowance",
             0.3)
      .input(&DressingSearch::reserve, "k_z", "k_z", "1", closed(1, 2), "reserve, 1.1-1.3 in the paper", 1.2)
      .optional(&DressingSearch::variant, "variant", "-", "-", no_range(),
                "tangent to the finished profile, or the normal as printed")
      .optional(&DressingSearch::both_directions, "both_directions", "-", "-", no_range(),
                "also with the roles of the neighbours exchanged")
      .output(&DressingRadius::radius_mm, "R_dress_mm", "R", "mm", positive(), "smallest of the R_i")
      .output(&DressingRadius::index, "index", "i", "1", at_least(1), "its point, from 0; the first on ties")
      .output(&DressingRadius::largest_radius_mm, "R_max_over_profile_mm", "-", "mm", positive(),
              "largest of the R_i")
      .note(
          "Depends on the spacing of the points (a k_z / 2 on a fine grid): use dressing_radius_for_wheel.");
  source
      .function<&dressing_radius_for_wheel>("dressing_radius_for_wheel",
                                            "Dressing radius from the width of the wheel.", "completion",
                                            Provenance::completion)
      .input(&WheelOnProfile::wheel_width_mm, "wheel_width_mm", "B", "mm", positive(), "wheel width", 40.0)
      .input(&WheelOnProfile::allowance_mm, "allowance_mm", "a", "mm", non_negative(), "grinding allowance",
             0.3)
      .input(&WheelOnProfile::reserve, "k_z", "k_z", "1", closed(1, 2), "reserve", 1.2)
      .input(&WheelOnProfile::profile_radius_mm, "profile_radius_mm", "rho", "mm", any(),
             "radius of the profile, > 0 concave, 0 straight, < 0 convex", 420.0)
      .output(&WheelRadius::radius_mm, "R_dress_mm", "R", "mm", closed(0, 1e9), "radius; 1e9: unlimited");
  source
      .function<&wheel_contact_half_width>("wheel_contact_half_width", "Half-width of the contact zone.",
                                           "completion", Provenance::completion)
      .with([&](auto& f) { wheel(f, &WheelContact::wheel_radius_mm, &WheelContact::profile_radius_mm); })
      .input(&WheelContact::depth_mm, "depth_mm", "a k_z", "mm", non_negative(), "depth of the stock", 0.36)
      .output(&HalfWidth::half_width_mm, "half_width_mm", "-", "mm", closed(0, 1e9),
              "half-width; 1e9: the wheel is flatter than the profile");
  source
      .function<&grinding_feed_for_scallop>("grinding_feed_for_scallop",
                                            "Axial feed that leaves a scallop height.", "completion",
                                            Provenance::completion)
      .with([&](auto& f) { wheel(f, &Scallop::wheel_radius_mm, &Scallop::profile_radius_mm); })
      .input(&Scallop::scallop_um, "scallop_um", "h", "um", non_negative(), "scallop height", 0.5)
      .output(&Feed::feed_mm_rev, "feed_mm_rev", "f", "mm/rev", closed(0, 1e9),
              "feed per work revolution; 1e9: the wheel is flatter than the profile");
  source
      .function<&profile_grinding_time>("profile_grinding_time", "Time of traverse profile grinding.",
                                        "completion", Provenance::completion)
      .input(&ProfileGrinding::contour_length_mm, "contour_length_mm", "-", "mm", positive(),
             "length of the contour", 300.0)
      .input(&ProfileGrinding::mean_diameter_mm, "D_mean_mm", "D", "mm", positive(), "mean diameter", 225.0)
      .input(&ProfileGrinding::allowance_mm, "allowance_mm", "a", "mm", non_negative(), "grinding allowance",
             0.3)
      .input(&ProfileGrinding::infeed_mm, "infeed_mm", "-", "mm", positive(), "infeed of a pass", 0.02)
      .input(&ProfileGrinding::sparkout_passes, "sparkout_passes", "-", "1", non_negative(),
             "passes without infeed", 3)
      .input(&ProfileGrinding::feed_mm_rev, "feed_mm_rev", "f", "mm/rev", positive(),
             "axial feed per work revolution", 6.0)
      .input(&ProfileGrinding::work_speed_m_min, "v_work_m_min", "v_w", "m/min", positive(), "work speed",
             25.0)
      .output(&ProfileGrindingTime::work_rpm, "n_work_rpm", "n", "1/min", positive(), "work spindle speed")
      .output(&ProfileGrindingTime::passes, "passes", "-", "1", non_negative(), "passes with spark-out")
      .output(&ProfileGrindingTime::main_time_min, "t_main_min", "-", "min", non_negative(), "main time");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K412",
       .title = "CAD/CAM for manufacturing of the part 'roll' for pipe straightening",
       .authors = "Pasichnyk V. A., Shumaiev S. O.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "From the geometry of a concave roll of a skew-roll straightening machine to its toolpaths, times "
           "and NC program: profile as the envelope of the pipe, contact check, two-phase rough turning, "
           "equidistant allowances, limiting dressing radius of the grinding wheel. The turning functions "
           "serve any contour of revolution.",
       .role = "toolpath",
       .errata = {
           "Eq. (1) prints cos^2(alpha) under the root; eqs. (1), (2) as printed use alpha and its "
           "complement "
           "at once. sin^2(alpha) makes the clearance of roll and pipe zero to 1e-13 mm.",
           "Eq. (2) prints sin(phi) cos(phi) for sin(alpha) cos(phi) and misses the factor 1/2 of an axial "
           "place from the throat.",
           "Eq. (3) prints the fraction inverted: the centre would not lie on the normal.",
           "Eqs. (4)-(8): sign of the stock point, matrix for inverse matrix, a plus in the slope of the "
           "bisector, D_{i+1} for D_{i-1} and the index of P are corrected."}});
  describe_geometry(source);
  describe_turning(source);
  describe_grinding(source);
}

}  // namespace verstat::models::k412
