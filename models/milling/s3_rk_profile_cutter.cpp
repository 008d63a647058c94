#include "models/milling/s3_rk_profile_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/math/bracketed.h"
#include "models/milling/rk_generation.h"

namespace verstat::models::s3 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;
constexpr double full_turn_slack = 1e-7 * rad_per_deg;  // the card's 1e-7 deg
constexpr std::int64_t most_teeth = 2000;               // of a search; no disc cutter carries more
constexpr std::int64_t most_equalised = 500;

// ISO 286 tolerances IT6 to IT16 in micrometres, for nominal sizes up to and including `to_mm`.
struct ItRow {
  double to_mm;
  std::array<double, 11> it_um;
};
constexpr std::array<ItRow, 6> it_table{{
    {18, {11, 18, 27, 43, 70, 110, 180, 270, 430, 700, 1100}},
    {30, {13, 21, 33, 52, 84, 130, 210, 330, 520, 840, 1300}},
    {50, {16, 25, 39, 62, 100, 160, 250, 390, 620, 1000, 1600}},
    {80, {19, 30, 46, 74, 120, 190, 300, 460, 740, 1200, 1900}},
    {120, {22, 35, 54, 87, 140, 220, 350, 540, 870, 1400, 2200}},
    {180, {25, 40, 63, 100, 160, 250, 400, 630, 1000, 1600, 2500}},
}};

std::optional<double> finite(double x) {
  return std::isfinite(x) ? std::optional(x) : std::nullopt;
}

// Only the angle within the turn matters to spacing.
double first_tooth_rad(double angle_deg) {
  return std::remainder(angle_deg, 360) * rad_per_deg;
}

struct Swing {
  double least_mm;
  double most_mm;
};

Swing uniform_swing(const RkGeneration& g, double first_rad, std::int64_t teeth) {
  Swing swing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  Tooth before = g.tooth(first_rad);
  for (std::int64_t k = 1; k <= teeth; ++k) {
    const Tooth next = g.tooth(first_rad + 2 * pi * static_cast<double>(k) / static_cast<double>(teeth));
    const double height_mm = g.cusp(before, next).height_mm;
    swing.least_mm = std::min(swing.least_mm, height_mm);
    swing.most_mm = std::max(swing.most_mm, height_mm);
    before = next;
  }
  return swing;
}

// Whether all cusps of equally spaced teeth keep the tolerance. The cusp that broke it last time is tried
// first: near the lobe tip or the flat it is nearly always the worst.
bool uniform_keeps(const RkGeneration& g, double first_rad, std::int64_t teeth, double tolerance_mm,
                   double& worst_rad) {
  const double pitch = 2 * pi / static_cast<double>(teeth);
  const auto start = static_cast<std::int64_t>(std::floor(worst_rad / pitch));
  for (std::int64_t k = 0; k < teeth; ++k) {
    const auto index = static_cast<double>((start + k) % teeth);
    const double from_rad = first_rad + pitch * index;
    const double to_rad = first_rad + 2 * pi * (index + 1) / static_cast<double>(teeth);
    if (!(g.cusp(g.tooth(from_rad), g.tooth(to_rad)).height_mm <= tolerance_mm)) {
      worst_rad = pitch * (index + 0.5);
      return false;
    }
  }
  return true;
}

double initial_guess(std::int64_t teeth) {
  return 2 * pi / static_cast<double>(std::max<std::int64_t>(teeth, 2));
}

// The loop of the paper's algorithm: teeth, each at the smallest pitch that reaches the tolerance. The last
// lies at or past the full turn.
std::vector<Tooth> chain(const RkGeneration& g, double first_rad, double tolerance_mm) {
  std::vector<Tooth> teeth{g.tooth(first_rad)};
  double pitch = initial_guess(24);
  while (teeth.back().theta < first_rad + 2 * pi - full_turn_slack) {
    require(teeth.size() <= static_cast<std::size_t>(most_teeth), "tolerance_mm", tolerance_mm,
            "asks for more than 2000 teeth");
    pitch = g.pitch_reaching(teeth.back(), tolerance_mm, pitch);
    if (pitch < 1e-10)
      reject(
          "the track of a tooth near the flat loops and meets no other: the cutter radius is below its "
          "smallest value, see rk_cutter_radius_limits");
    teeth.push_back(g.tooth(teeth.back().theta + pitch));
  }
  return teeth;
}

std::int64_t count_below_full_turn(const std::vector<Tooth>& teeth, double first_rad) {
  return std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) {
    return tooth.theta < first_rad + 2 * pi - full_turn_slack;
  });
}

// Angles from the first tooth of `teeth` teeth, and the angle where the next would stand.
std::vector<double> equal_chain(const RkGeneration& g, double first_rad, std::int64_t teeth,
                                double tolerance_mm) {
  std::vector<double> angles{0};
  Tooth last = g.tooth(first_rad);
  double pitch = initial_guess(teeth);
  for (std::int64_t k = 0; k < teeth; ++k) {
    // A chain that has closed long ago need not go on.
    pitch = angles.back() > 4 * pi ? 2 * pi : g.pitch_reaching(last, tolerance_mm, pitch);
    last = g.tooth(last.theta + pitch);
    angles.push_back(last.theta - first_rad);
  }
  return angles;
}

}  // namespace

RkProfilePoint rk_profile_point(const RkHoleAtNormal& in) {
  return guarded<&rk_profile_point>(in, [&] {
    require_convex(in);
    const auto n = static_cast<double>(in.lobes);
    const double t = in.normal_angle_deg * rad_per_deg;
    const double h_mm = in.mean_radius_mm + in.eccentricity_mm * std::cos(n * t);
    const double dh_mm = -n * in.eccentricity_mm * std::sin(n * t);
    return RkProfilePoint{h_mm * std::cos(t) - dh_mm * std::sin(t), h_mm * std::sin(t) + dh_mm * std::cos(t),
                          std::hypot(h_mm, dh_mm),
                          in.mean_radius_mm - (n * n - 1) * in.eccentricity_mm * std::cos(n * t)};
  });
}

RkCutterPoint rk_cutter_point(const RkCutterAtNormal& in) {
  return guarded<&rk_cutter_point>(in, [&] {
    const RkGeneration g(in);
    const double t = in.normal_angle_deg * rad_per_deg;
    return RkCutterPoint{g.tooth_radius_mm(t), g.tooth_angle(t) / rad_per_deg,
                         in.normal_angle_deg + g.lead(t) / rad_per_deg,
                         static_cast<double>(in.lobes) * in.normal_angle_deg};
  });
}

RkRadiusLimits rk_cutter_radius_limits(const RkHole& in) {
  return guarded<&rk_cutter_radius_limits>(in, [&] {
    require_convex(in);
    return RkRadiusLimits{
        RkGeneration::max_cutter_radius_mm(in),
        in.eccentricity_mm + (in.mean_radius_mm - in.eccentricity_mm) / static_cast<double>(in.lobes)};
  });
}

RkCusp rk_cusp(const RkToothPair& in) {
  return guarded<&rk_cusp>(in, [&] {
    require(in.tooth1_angle_deg < in.tooth2_angle_deg, "tooth1_angle_deg", in.tooth1_angle_deg,
            "must be below tooth2_angle_deg");
    require(in.tooth2_angle_deg <= in.tooth1_angle_deg + 360, "tooth2_angle_deg", in.tooth2_angle_deg,
            "must not be more than a full turn above tooth1_angle_deg");
    const RkGeneration g(in);
    const Cusp cusp =
        g.cusp(g.tooth(in.tooth1_angle_deg * rad_per_deg), g.tooth(in.tooth2_angle_deg * rad_per_deg));
    return RkCusp{finite(cusp.height_mm), finite(cusp.polar / rad_per_deg), cusp.pitch_mm};
  });
}

RkDeviations rk_form_error_uniform(const RkUniformCutter& in) {
  return guarded<&rk_form_error_uniform>(in, [&] {
    const Swing swing = uniform_swing(RkGeneration(in), first_tooth_rad(in.first_tooth_angle_deg), in.teeth);
    return RkDeviations{finite(swing.most_mm), finite(swing.least_mm)};
  });
}

RkToothPositions rk_tooth_positions(const RkTolerance& in) {
  return guarded<&rk_tooth_positions>(in, [&] {
    const RkGeneration g(in);
    const double first_rad = first_tooth_rad(in.first_tooth_angle_deg);
    const std::vector<Tooth> teeth = chain(g, first_rad, in.tolerance_mm);
    RkToothPositions out{};
    out.positions_listed = static_cast<std::int64_t>(teeth.size());
    out.teeth = count_below_full_turn(teeth, first_rad);
    const auto lobes = static_cast<double>(in.lobes);
    for (std::size_t k = 0; k < teeth.size(); ++k) {
      if (static_cast<std::int64_t>(k) < out.teeth)
        out.tooth_angles_deg.push_back((teeth[k].theta - first_rad) / rad_per_deg);
      out.parameter_angles_deg.push_back(lobes * (teeth[k].t - teeth[0].t) / rad_per_deg);
      if (k > 0) out.parameter_pitches_deg.push_back(lobes * (teeth[k].t - teeth[k - 1].t) / rad_per_deg);
    }
    const Tooth& last = teeth[static_cast<std::size_t>(out.teeth - 1)];
    out.closing_cusp_mm = finite(g.cusp(last, g.tooth(first_rad + 2 * pi)).height_mm);
    return out;
  });
}

RkEqualisedCutter rk_equalised_cutter(const RkUniformCutter& in) {
  return guarded<&rk_equalised_cutter>(in, [&] {
    require(in.teeth <= most_equalised, "teeth", in.teeth, "must not be more than 500");
    const RkGeneration g(in);
    const double first_rad = first_tooth_rad(in.first_tooth_angle_deg);
    constexpr std::string_view too_few = "too few: the tracks of neighbouring teeth do not meet";
    if (in.teeth == 1) {
      const double height_mm = g.cusp(g.tooth(first_rad), g.tooth(first_rad + 2 * pi)).height_mm;
      require(std::isfinite(height_mm), "teeth", in.teeth, too_few);
      return RkEqualisedCutter{height_mm, {0}};
    }
    const auto excess = [&](double tolerance_mm) {
      return equal_chain(g, first_rad, in.teeth, tolerance_mm).back() - 2 * pi;
    };
    // The uniform deviation lies near; it may be infinite or zero.
    const double uniform_mm = uniform_swing(g, first_rad, in.teeth).most_mm;
    double high_mm = std::isfinite(uniform_mm) && uniform_mm > 0 ? uniform_mm : 0.01;
    double excess_high = excess(high_mm);
    while (excess_high < 0) {
      require(high_mm < in.mean_radius_mm + in.eccentricity_mm, "teeth", in.teeth, too_few);
      high_mm *= 2;
      excess_high = excess(high_mm);
    }
    double low_mm = 0.5 * high_mm, excess_low = excess(low_mm);
    while (excess_low >= 0) {
      if (low_mm < 1e-12) reject("no common cusp: the cutter is beyond the undercut limit");
      high_mm = low_mm;
      excess_high = excess_low;
      low_mm *= 0.5;
      excess_low = excess(low_mm);
    }
    RkEqualisedCutter out{};
    out.equal_deviation_mm =
        bracketed_root(excess, low_mm, high_mm, excess_low, excess_high, 1e-12 * high_mm);
    out.tooth_angles_deg = equal_chain(g, first_rad, in.teeth, out.equal_deviation_mm);
    out.tooth_angles_deg.pop_back();
    for (double& angle : out.tooth_angles_deg) angle /= rad_per_deg;
    return out;
  });
}

RkTeeth rk_min_teeth(const RkTeethForTolerance& in) {
  return guarded<&rk_min_teeth>(in, [&] {
    const RkGeneration g(in);
    const double first_rad = first_tooth_rad(in.first_tooth_angle_deg);
    if (in.spacing == Spacing::equalised)
      return RkTeeth{count_below_full_turn(chain(g, first_rad, in.tolerance_mm), first_rad)};
    double worst_rad = 0;
    for (std::int64_t teeth = 2; teeth <= most_teeth; ++teeth)
      if (uniform_keeps(g, first_rad, teeth, in.tolerance_mm, worst_rad)) return RkTeeth{teeth};
    require(false, "tolerance_mm", in.tolerance_mm, "asks for more than 2000 teeth");
    return RkTeeth{};
  });
}

ItGrade it_grade_for_deviation(const FormDeviation& in) {
  return guarded<&it_grade_for_deviation>(in, [&] {
    const auto row = std::find_if(it_table.begin(), it_table.end(),
                                  [&](const ItRow& r) { return in.nominal_mm <= r.to_mm; });
    for (std::size_t k = 0; k < row->it_um.size(); ++k) {
      const double allowed_mm = in.share * row->it_um[k] / 1000;
      if (allowed_mm >= in.deviation_mm - 1e-12) return ItGrade{6 + static_cast<std::int64_t>(k), allowed_mm};
    }
    return ItGrade{17, std::nullopt};
  });
}

RkKinematics rk_cutting_kinematics(const RkCutting& in) {
  return guarded<&rk_cutting_kinematics>(in, [&] {
    const RkGeneration g(in);
    const auto n = static_cast<double>(in.lobes);
    const double arm_mm = g.pitch_arm_mm(in.normal_angle_deg * rad_per_deg);
    return RkKinematics{n * in.work_speed_rpm, (n - 1) * 2 * pi * in.work_speed_rpm * arm_mm / 1000};
  });
}

RkTime rk_hole_machining_time(const RkPass& in) {
  return guarded<&rk_hole_machining_time>(in, [&] {
    return RkTime{in.infeed_mm / in.cross_feed_mm_min + in.finish_revolutions / in.work_speed_rpm};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "S3",
       .title = "Method for determining the position of the teeth of a milling cutter with a constructive "
                "radial feed for processing RK (EC, polygon) profile holes",
       .authors = "Kuts V. V., Mitrofanov M. V., Malneva Yu. A., Kirillov O. N.",
       .published = "Bulletin of Voronezh State Technical University, vol. 18, no. 4, 2022",
       .models =
           "Milling of an N-lobed polygon hole by a disc cutter of variable tooth radius, which turns N "
           "times "
           "per turn of the part at a fixed centre distance: every tooth touches the profile at one point "
           "per "
           "lobe and leaves cusps. Form error with equal spacing, and the spacing that makes all cusps equal "
           "to a tolerance.",
       .role = "milling",
       .errata = {
           "Table 2, R_f = 20 and 22: the printed deviations 0.38 and 0.31 do not come out (0.836 and 0.385) "
           "and break the smooth row; taken as misprints.",
           "Fig. 8: the 21 listed positions end past the full turn; 20 teeth are needed.",
           "Tables 1 and 2: the printed grades 12 for 0.218 and 0.22 and 10 for 0.075 are one better than "
           "the "
           "60 % rule gives.",
           "Designation RK3-40/3.4: 40 is the mean radius and 3.4 the eccentricity; read as diameters the "
           "tables do not come out."}});

  const auto hole = [](auto& f) {
    f.optional(&RkHole::mean_radius_mm, "mean_radius_mm", "R", "mm", positive(), "mean radius of the hole")
        .optional(&RkHole::eccentricity_mm, "eccentricity_mm", "e", "mm", non_negative(),
                  "eccentricity of the profile, below R/(N^2 - 1)")
        .optional(&RkHole::lobes, "lobes", "N", "1", at_least(2), "number of lobes");
  };
  const auto cutter = [&](auto& f) {
    f.with(hole).optional(&RkCutter::cutter_radius_mm, "cutter_radius_mm", "R_f", "mm", positive(),
                          "mean radius of the cutter");
  };
  const auto first_tooth = [](auto& f) {
    f.optional(&RkTolerance::first_tooth_angle_deg, "first_tooth_angle_deg", "theta_1", "deg", any(),
               "angle of the first tooth; 0 cuts the lobe tip, 180 the flat");
  };
  const auto first_tooth_uniform = [](auto& f) {
    f.optional(&RkUniformCutter::first_tooth_angle_deg, "first_tooth_angle_deg", "theta_1", "deg", any(),
               "angle of the first tooth; 0 cuts the lobe tip, 180 the flat");
  };
  const std::string overcut =
      "Above the largest cutter radius (rk_cutter_radius_limits) the hole is overcut; the answer is given "
      "all "
      "the same.";

  source
      .function<&rk_profile_point>("rk_profile_point", "Point of the hole profile with a given normal.",
                                   "references of the paper", Provenance::completion)
      .with(hole)
      .input(&RkHoleAtNormal::normal_angle_deg, "normal_angle_deg", "t", "deg", any(),
             "direction of the normal, from the lobe tip", 10.0)
      .output(&RkProfilePoint::x_mm, "x_mm", "x", "mm", any(), "towards the lobe tip")
      .output(&RkProfilePoint::y_mm, "y_mm", "y", "mm", any(), "across")
      .output(&RkProfilePoint::r_mm, "r_mm", "r", "mm", positive(), "distance from the axis")
      .output(&RkProfilePoint::curvature_radius_mm, "curvature_radius_mm", "-", "mm", positive(),
              "radius of curvature");
  source
      .function<&rk_cutter_point>("rk_cutter_point", "Cutter point that generates a profile point.",
                                  "eqs. (1)-(3)", Provenance::reconstructed)
      .with(cutter)
      .input(&RkCutterAtNormal::normal_angle_deg, "normal_angle_deg", "t", "deg", any(),
             "direction of the normal, from the lobe tip", 10.0)
      .output(&RkCutterPoint::tooth_radius_mm, "tooth_radius_mm", "rho", "mm", positive(),
              "radius of the tooth")
      .output(&RkCutterPoint::tooth_angle_deg, "tooth_angle_deg", "theta", "deg", any(), "angle of the tooth")
      .output(&RkCutterPoint::centre_line_angle_deg, "centre_line_angle_deg", "gamma", "deg", any(),
              "direction of the line of centres")
      .output(&RkCutterPoint::parameter_angle_deg, "parameter_angle_deg", "N t", "deg", any(),
              "parameter of Fig. 8");
  source
      .function<&rk_cutter_radius_limits>(
          "rk_cutter_radius_limits", "Largest cutter without undercut, smallest without a looping track.",
          "completion", Provenance::completion)
      .with(hole)
      .output(&RkRadiusLimits::max_cutter_radius_mm, "max_cutter_radius_mm", "-", "mm", positive(),
              "no undercut at the lobe tip")
      .output(&RkRadiusLimits::min_cutter_radius_mm, "min_cutter_radius_mm", "-", "mm", positive(),
              "no looping track at the flat")
      .note("Maximum below minimum (strongly lobed profile): no admissible cutter.");
  source
      .function<&rk_cusp>("rk_cusp", "Cusp between two neighbouring teeth.", "eqs. (5)-(9)",
                          Provenance::reconstructed)
      .with(cutter)
      .input(&RkToothPair::tooth1_angle_deg, "tooth1_angle_deg", "theta_k", "deg", any(),
             "angle of the first tooth", 18.0)
      .input(&RkToothPair::tooth2_angle_deg, "tooth2_angle_deg", "theta_k+1", "deg", any(),
             "angle of the next tooth, at most 360 more", 36.0)
      .output(&RkCusp::cusp_height_mm, "cusp_height_mm", "Delta", "mm", any(),
              "radial height of the cusp; null: the tracks never meet")
      .output(&RkCusp::cusp_polar_angle_deg, "cusp_polar_angle_deg", "-", "deg", any(),
              "polar angle of the cusp; null where the tracks do not cross")
      .output(&RkCusp::contact_pitch_mm, "contact_pitch_mm", "-", "mm", non_negative(),
              "distance of the two contact points")
      .note(overcut);
  source
      .function<&rk_form_error_uniform>("rk_form_error_uniform", "Form error with equally spaced teeth.",
                                        "eqs. (5)-(9), Tables 1 and 2", Provenance::reconstructed)
      .with(cutter)
      .input(&RkUniformCutter::teeth, "teeth", "Z_f", "1", closed(1, 5000), "number of teeth", 20)
      .with(first_tooth_uniform)
      .output(&RkDeviations::max_deviation_mm, "max_deviation_mm", "-", "mm", any(),
              "largest cusp; null: infinite, material stays")
      .output(&RkDeviations::min_deviation_mm, "min_deviation_mm", "-", "mm", any(),
              "smallest cusp; null: all infinite")
      .note("Table 1 within 8 %; Table 2 at R_f = 18, 24, 25 within 6 %.")
      .note(overcut);
  source
      .function<&rk_tooth_positions>("rk_tooth_positions",
                                     "Tooth positions with all cusps equal to a tolerance.",
                                     "eq. (10), Fig. 7", Provenance::reconstructed)
      .with(cutter)
      .input(&RkTolerance::tolerance_mm, "tolerance_mm", "T", "mm", positive(), "allowed cusp", 0.2)
      .with(first_tooth)
      .output(&RkToothPositions::positions_listed, "positions_listed", "n", "1", at_least(2),
              "positions the algorithm lists; the last closes the turn")
      .output(&RkToothPositions::teeth, "teeth", "Z_f", "1", at_least(1), "teeth needed")
      .output(&RkToothPositions::tooth_angles_deg, "tooth_angles_deg", "theta", "deg", non_negative(),
              "angles from the first tooth")
      .output(&RkToothPositions::parameter_angles_deg, "parameter_angles_deg", "N t", "deg", any(),
              "parameter of every position from the first")
      .output(&RkToothPositions::parameter_pitches_deg, "parameter_pitches_deg", "-", "deg", any(),
              "differences of the parameter (Fig. 8)")
      .output(&RkToothPositions::closing_cusp_mm, "closing_cusp_mm", "-", "mm", any(),
              "cusp between the last tooth and the first; null: infinite")
      .note("For T = 0.2 mm the paper lists 21 positions; the 21st lies past the full turn, 20 teeth do.")
      .note(overcut);
  source
      .function<&rk_equalised_cutter>("rk_equalised_cutter", "A number of teeth with exactly equal cusps.",
                                      "completion", Provenance::completion)
      .with(cutter)
      .input(&RkUniformCutter::teeth, "teeth", "Z_f", "1", closed(1, 500), "number of teeth", 20)
      .with(first_tooth_uniform)
      .output(&RkEqualisedCutter::equal_deviation_mm, "equal_deviation_mm", "-", "mm", non_negative(),
              "common cusp")
      .output(&RkEqualisedCutter::tooth_angles_deg, "tooth_angles_deg", "theta", "deg", non_negative(),
              "angles from the first tooth")
      .note(overcut);
  source
      .function<&rk_min_teeth>("rk_min_teeth", "Fewest teeth for a tolerance.", "completion",
                               Provenance::completion)
      .with(cutter)
      .input(&RkTeethForTolerance::tolerance_mm, "tolerance_mm", "T", "mm", positive(), "allowed cusp", 0.2)
      .input(&RkTeethForTolerance::spacing, "spacing", "-", "-", no_range(), "spacing of the teeth",
             "uniform")
      .with(first_tooth)
      .output(&RkTeeth::teeth, "teeth", "Z_f", "1", at_least(1), "number of teeth")
      .note(overcut);
  source
      .function<&it_grade_for_deviation>("it_grade_for_deviation", "Accuracy grade reached with a deviation.",
                                         "Tables 1, 2; ISO 286", Provenance::completion)
      .input(&FormDeviation::deviation_mm, "deviation_mm", "-", "mm", non_negative(), "form deviation", 0.31)
      .input(&FormDeviation::nominal_mm, "nominal_mm", "-", "mm", open_low(10, 180),
             "nominal size, of a hole 2 R", 80.0)
      .optional(&FormDeviation::share, "share", "-", "1", positive(),
                "share of the size tolerance that the form may take")
      .output(&ItGrade::it_grade, "it_grade", "-", "1", closed(6, 17), "grade; 17: worse than IT16")
      .output(&ItGrade::allowed_deviation_mm, "allowed_deviation_mm", "-", "mm", positive(),
              "share * IT of that grade; null for 17");
  source
      .function<&rk_cutting_kinematics>("rk_cutting_kinematics",
                                        "Cutter speed and sliding speed at the contact.",
                                        "eq. (1); completion", Provenance::completion)
      .with(cutter)
      .input(&RkCutting::work_speed_rpm, "work_speed_rpm", "n_y", "rpm", positive(), "speed of the part",
             100.0)
      .input(&RkCutting::normal_angle_deg, "normal_angle_deg", "t", "deg", any(),
             "direction of the normal, from the lobe tip", 0.0)
      .output(&RkKinematics::cutter_speed_rpm, "cutter_speed_rpm", "n_f", "rpm", positive(),
              "speed of the cutter")
      .output(&RkKinematics::cutting_speed_m_min, "cutting_speed_m_min", "v", "m/min", non_negative(),
              "cutting speed");
  source
      .function<&rk_hole_machining_time>("rk_hole_machining_time", "Main time of the hole.",
                                         "eq. (4); completion", Provenance::completion)
      .input(&RkPass::infeed_mm, "infeed_mm", "-", "mm", non_negative(), "radial infeed", 2.0)
      .input(&RkPass::cross_feed_mm_min, "cross_feed_mm_min", "S_m", "mm/min", positive(), "infeed speed",
             4.0)
      .input(&RkPass::work_speed_rpm, "work_speed_rpm", "n_y", "rpm", positive(), "speed of the part", 50.0)
      .optional(&RkPass::finish_revolutions, "finish_revolutions", "-", "1", non_negative(),
                "revolutions of the part at full depth")
      .output(&RkTime::time_min, "time_min", "-", "min", non_negative(), "main time");
}

}  // namespace verstat::models::s3
