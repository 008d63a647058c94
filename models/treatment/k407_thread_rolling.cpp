#include "models/treatment/k407_thread_rolling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k407 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

// One ridge: closed forms of section, perimeter, width and first moment over the depth.
class Ridge {
 public:
  explicit Ridge(const RidgeShape& in)
      : flat_(in.tip_flat_mm),
        radius_(in.tip_radius_mm),
        angle_(in.half_angle_deg * degree),
        tan_(std::tan(angle_)),
        cos_(std::cos(angle_)) {
    tangent_depth_ = radius_ * (1 - std::sin(angle_));
    closing_ = 2 * tan_;
    gap_ = in.pitch_mm - (radius_ > 0 ? 2 * radius_ * (1 - std::sin(angle_)) / cos_ : flat_);
    require(gap_ > 0, radius_ > 0 ? "tip_radius_mm" : "tip_flat_mm", radius_ > 0 ? radius_ : flat_,
            "must leave a gap between the ridges (A above 0)");
  }
  [[nodiscard]] double gap() const { return gap_; }
  [[nodiscard]] double closing() const { return closing_; }
  [[nodiscard]] double area(double h) const {
    if (radius_ <= 0) return flat_ * h + h * h * tan_;
    if (h <= tangent_depth_) return segment(h);
    const double e = h - tangent_depth_;
    return segment(tangent_depth_) + e * (2 * radius_ * cos_ + e * tan_);
  }
  [[nodiscard]] double perimeter(double h) const {
    if (h <= 0) return 0;
    if (radius_ <= 0) return flat_ + 2 * h / cos_;
    if (h <= tangent_depth_) return 2 * radius_ * arc_angle(h);
    return 2 * radius_ * (pi / 2 - angle_) + 2 * (h - tangent_depth_) / cos_;
  }
  [[nodiscard]] double width(double h) const {
    if (radius_ <= 0) return flat_ + 2 * h * tan_;
    if (h <= tangent_depth_) return 2 * std::sqrt(h * (2 * radius_ - h));
    return 2 * radius_ * cos_ + 2 * (h - tangent_depth_) * tan_;
  }
  // Integral of e width(e) from 0 to h.
  [[nodiscard]] double moment(double h) const {
    if (radius_ <= 0) return flat_ * h * h / 2 + 2 * tan_ * h * h * h / 3;
    const double arc = std::min(h, tangent_depth_);
    const double half_width = std::sqrt(arc * (2 * radius_ - arc));
    double sum = radius_ * segment(arc) - 2 * half_width * half_width * half_width / 3;
    if (h > tangent_depth_) {
      const double e = h - tangent_depth_;
      const double start = 2 * radius_ * cos_;
      sum += tangent_depth_ * start * e + (start + 2 * tangent_depth_ * tan_) * e * e / 2 +
             2 * tan_ * e * e * e / 3;
    }
    return sum;
  }
  // Eq. (6), in the form without cancellation; no value when the profile is overfilled.
  [[nodiscard]] std::optional<double> extruded(double h) const {
    return extruded(gap_, closing_, h, area(h));
  }
  [[nodiscard]] static std::optional<double> extruded(double gap, double closing, double h, double area) {
    const double left = gap - closing * h;
    const double square = left * left - 2 * closing * area;
    if (!(left > 0) || !(square >= 0)) return std::nullopt;
    return 2 * area / (left + std::sqrt(square));
  }

 private:
  [[nodiscard]] double arc_angle(double h) const { return 2 * std::asin(std::sqrt(h / (2 * radius_))); }
  // Circular segment of the height h: r^2 (theta - sin theta cos theta), by series where that cancels.
  [[nodiscard]] double segment(double h) const {
    const double t = arc_angle(h);
    const double s = t * t;
    const double share =
        t < 0.05 ? t * s * (2.0 / 3 - s * (2.0 / 15 - s * 4 / 315)) : t - std::sin(t) * std::cos(t);
    return radius_ * radius_ * share;
  }

  double flat_, radius_, angle_, tan_, cos_;
  double tangent_depth_ = 0, closing_ = 0, gap_ = 0;
};

ContactArc arc_of(double blank, double roller, double depth, std::string_view input) {
  require(depth <= blank, input, depth, "must not sink deeper than R_blank_mm");
  const double sagitta = (2 * depth * roller - depth * depth) / (2 * (blank - depth + roller));
  const double chord = blank - sagitta;
  require(chord <= blank + roller - depth, input, depth,
          "makes the contact angle of the roller exceed 90 deg");
  const double half_chord = std::sqrt(std::max(0.0, sagitta * (2 * blank - sagitta)));
  const double gamma = std::asin(std::min(1.0, half_chord / roller));
  return {chord, gamma / degree, roller * gamma};
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

RidgeProfile ridge_profile(const SunkRidge& in) {
  return guarded<&ridge_profile>(in, [&] {
    const Ridge ridge(in);
    return RidgeProfile{ridge.area(in.depth_mm), ridge.perimeter(in.depth_mm), ridge.width(in.depth_mm),
                        ridge.gap(), ridge.closing()};
  });
}

ExtrudedHeight extrusion_height(const Extrusion& in) {
  return guarded<&extrusion_height>(in, [&] {
    require(in.gap_mm - in.closing * in.depth_mm > 0, "H_mm", in.depth_mm,
            "must leave a gap: A - B H above 0");
    const auto height = Ridge::extruded(in.gap_mm, in.closing, in.depth_mm, in.area_mm2);
    require(height.has_value(), "F_mm2", in.area_mm2,
            "overfills the profile: must not be above (A - B H)^2 / (2 B)");
    return ExtrudedHeight{*height};
  });
}

SizingRidge calibrating_penetration(const ThreadProfile& in) {
  return guarded<&calibrating_penetration>(in, [&] {
    const Ridge ridge(in);
    const double full = in.profile_height_mm + in.half_tolerance_mm;
    require(ridge.width(full) <= in.pitch_mm, "profile_height_mm", in.profile_height_mm,
            "makes neighbouring ridges overlap: the width at the full depth must not be above the pitch");
    const double root = in.minor_diameter_mm - 2 * in.half_tolerance_mm;
    require(root > 0, "minor_diameter_mm", in.minor_diameter_mm, "must be above twice half_tolerance_mm");
    const double extruded = ridge.area(full) / in.pitch_mm;
    const double penetration = full - extruded;
    // Integral of (d0/2 + e)(P - width(e)) over the depth.
    const double ring = root / 2 * (in.pitch_mm * full - ridge.area(full)) + in.pitch_mm * full * full / 2 -
                        ridge.moment(full);
    return SizingRidge{full, penetration, extruded, root + 2 * penetration,
                       std::sqrt(root * root + 8 / in.pitch_mm * ring)};
  });
}

ContactArc contact_arc(const RollerContact& in) {
  return guarded<&contact_arc>(
      in, [&] { return arc_of(in.blank_radius_mm, in.roller_radius_mm, in.depth_mm, "H_mm"); });
}

TurnSequence turn_sequence(const RidgeSequence& in) {
  return guarded<&turn_sequence>(in, [&] {
    const Ridge ridge(in);
    for (std::size_t k = 0; k < in.drops_mm.size(); ++k) {
      require(in.drops_mm[k] < in.sizing_depth_mm, "drop_mm", in.drops_mm[k], "must be below H_cal_mm");
      require(k == 0 || in.drops_mm[k] < in.drops_mm[k - 1], "drop_mm", in.drops_mm[k],
              "must be below the drop of the ridge before");
    }
    const auto extruded = [&](double depth) {
      const auto height = ridge.extruded(depth);
      require(height.has_value(), "H_cal_mm", in.sizing_depth_mm,
              "overfills the profile: the displaced metal does not fit between the ridges");
      return *height;
    };
    TurnSequence out{};
    double depth_before = 0;
    double extruded_before = 0;
    for (double drop : in.drops_mm) {
      const double depth = in.sizing_depth_mm - drop;
      const double own = depth - depth_before;
      const double raised = extruded(depth);
      const double filled = depth + extruded_before;  // with the metal raised by the ridge before
      out.depth_mm.push_back(depth);
      out.own_depth_mm.push_back(own);
      out.extruded_mm.push_back(raised);
      out.displaced_mm2.push_back(ridge.area(filled) - ridge.area(std::max(0.0, filled - own)));
      out.perimeter_mm.push_back(ridge.perimeter(filled));
      out.arc_mm.push_back(arc_of(in.blank_radius_mm, in.roller_radius_mm, own, "H_cal_mm").arc_mm);
      // The first ridge meets a smooth blank: half of its product is contact.
      out.contact_area_mm2 +=
          (out.arc_mm.size() == 1 ? 0.5 : 1) * out.perimeter_mm.back() * out.arc_mm.back();
      depth_before = depth;
      extruded_before = raised;
    }
    out.displaced_mean_mm2 = mean(out.displaced_mm2);
    out.perimeter_mean_mm = mean(out.perimeter_mm);
    out.arc_mean_mm = mean(out.arc_mm);
    out.sizing_perimeter_mm = static_cast<double>(in.sizing_turns) *
                              ridge.perimeter(in.sizing_depth_mm + extruded(in.sizing_depth_mm));
    out.layer_mm = out.displaced_mean_mm2 / out.perimeter_mean_mm;
    return out;
  });
}

RollingForce rolling_radial_force(const RollingZone& in) {
  return guarded<&rolling_radial_force>(in, [&] {
    const double area = in.perimeter_mean_mm * in.arc_mean_mm;
    const double radial = in.coefficient * std::pow(in.layer_mm, in.layer_exponent) *
                          std::pow(area, in.area_exponent) *
                          std::pow(in.sizing_perimeter_mm, in.sizing_exponent);
    const auto inside = [](double value, double low, double high) { return value >= low && value <= high; };
    return RollingForce{radial, in.tangential_ratio * radial, 1000 * radial / area,
                        inside(in.layer_mm, 0.05, 0.25) && inside(in.perimeter_mean_mm, 6, 20) &&
                            inside(in.arc_mean_mm, 5, 10) && inside(in.sizing_perimeter_mm, 10, 56)};
  });
}

ForceCoefficient force_coefficient(const BlankQuality& in) {
  return guarded<&force_coefficient>(
      in, [&] { return ForceCoefficient{in.base * in.form * in.hardness * in.diameter * in.location}; });
}

StrengthFactor rolled_thread_strength(const StrengthQuestion& in) {
  return guarded<&rolled_thread_strength>(in, [&]() -> StrengthFactor {
    switch (in.property) {
      case StrengthProperty::tension_static:
        return {1.10, 1.10};
      case StrengthProperty::shear_static:
        return {1.20, 1.35};
      case StrengthProperty::bending_fatigue:
        return {2.0, 3.0};
      case StrengthProperty::axial_fatigue:
        return {3.5, 3.5};
    }
    reject("there is no such property");
  });
}

RollingDrive rolling_drive(const RollingLoad& in) {
  return guarded<&rolling_drive>(in, [&] {
    const double tangential_n = 1000 * in.radial_kn * in.tangential_ratio;
    return RollingDrive{tangential_n * in.roller_diameter_mm / 2000,
                        static_cast<double>(in.rollers) * tangential_n * in.speed_m_min / 60000};
  });
}

PlungeTime plunge_cycle_time(const PlungeCycle& in) {
  return guarded<&plunge_cycle_time>(in, [&] {
    const double blank_rpm = 1000 * in.speed_m_min / (pi * in.blank_diameter_mm);
    const double roller_rpm = 1000 * in.speed_m_min / (pi * in.roller_diameter_mm);
    const double rolling = (in.sizing_depth_mm + in.approach_mm) / (in.feed_mm_rev * blank_rpm) +
                           in.sizing_revolutions / blank_rpm;
    return PlungeTime{blank_rpm, roller_rpm, rolling, rolling + in.handling_min};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K407",
       .title = "Improving the accuracy of the mathematical model of external thread rolling on two-roller "
                "machines",
       .authors = "Lipka V. M.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A smooth blank rolled between two driven thread rollers: penetration of every ridge, height of "
           "the "
           "metal it raises, displaced areas and contact arcs, a radial force fitted on trapezoidal threads "
           "in "
           "steel 45, blank diameter, drive and cycle time, and the strength of rolled against cut threads.",
       .role = "treatment",
       .errata = {
           "Eq. (5): printed sqrt(R^2 - X^3); X^2 by dimension and as the intersection of two circles.",
           "Step 6 of the procedure: printed H' = H_f + h makes the displaced area negative; minus is meant.",
           "The unit of eq. (7) is not printed: kN, from the contact pressure.",
           "The slip \"equality of F_K and H_ext\" means the two areas.",
           "K4 = 3.05 of the printed batch is out of line with the other factors and may mean 1.05."}});

  const auto shape = [](auto& f) {
    f.input(&RidgeShape::pitch_mm, "pitch_mm", "P", "mm", closed(1, 12), "pitch", 8.0)
        .input(&RidgeShape::half_angle_deg, "half_angle_deg", "a", "deg", open_high(0, 90),
               "half angle of the profile (30 metric, 15 trapezoidal)", 15.0)
        .input(&RidgeShape::tip_flat_mm, "tip_flat_mm", "w_0", "mm", non_negative(),
               "width of a flat tip, ignored with a rounded one", 2.93)
        .input(&RidgeShape::tip_radius_mm, "tip_radius_mm", "r", "mm", non_negative(),
               "radius of a rounded tip, 0: flat", 0.0);
  };
  const auto radii = [](auto& f, auto blank, auto roller) {
    f.input(blank, "R_blank_mm", "R_D", "mm", positive(), "radius of the blank", 37.6736)
        .input(roller, "R_roller_mm", "R_P", "mm", positive(), "radius of the roller", 52.5);
  };

  source
      .function<&ridge_profile>("ridge_profile", "Section of one roller ridge sunk into the blank.",
                                "completion of eq. (6)", Provenance::completion)
      .with(shape)
      .input(&SunkRidge::depth_mm, "depth_mm", "H", "mm", non_negative(), "penetration", 2.0)
      .output(&RidgeProfile::area_mm2, "area_mm2", "F", "mm2", non_negative(), "displaced area")
      .output(&RidgeProfile::perimeter_mm, "perimeter_mm", "l_P", "mm", non_negative(),
              "contact perimeter, 0 at zero depth")
      .output(&RidgeProfile::width_mm, "width_mm", "w", "mm", non_negative(),
              "width at the surface of the blank")
      .output(&RidgeProfile::gap_mm, "A_mm", "A", "mm", positive(), "gap between ridges at zero depth")
      .output(&RidgeProfile::closing, "B", "B", "1", non_negative(), "narrowing of the gap per depth");
  source
      .function<&extrusion_height>("extrusion_height", "Height of the metal raised between the ridges.",
                                   "eq. (6)", Provenance::paper)
      .input(&Extrusion::gap_mm, "A_mm", "A", "mm", positive(), "gap between ridges at zero depth", 5.07)
      .input(&Extrusion::closing, "B", "B", "1", non_negative(), "narrowing of the gap per depth", 0.5359)
      .input(&Extrusion::depth_mm, "H_mm", "H", "mm", non_negative(), "penetration", 1.2)
      .input(&Extrusion::area_mm2, "F_mm2", "F", "mm2", non_negative(), "displaced area", 3.9)
      .output(&ExtrudedHeight::height_mm, "H_ext_mm", "H_ext", "mm", non_negative(), "height raised");
  source
      .function<&calibrating_penetration>(
          "calibrating_penetration", "Penetration of the sizing ridge and blank diameter of a full profile.",
          "section on the sizing ridges", Provenance::reconstructed)
      .with(shape)
      .input(&ThreadProfile::profile_height_mm, "profile_height_mm", "t", "mm", positive(),
             "nominal height of the profile", 4.5)
      .optional(&ThreadProfile::half_tolerance_mm, "half_tolerance_mm", "delta t", "mm", non_negative(),
                "half of the lower deviation of the minor diameter, magnitude")
      .input(&ThreadProfile::minor_diameter_mm, "minor_diameter_mm", "d_minor", "mm", positive(),
             "nominal minor diameter", 71.0)
      .output(&SizingRidge::full_mm, "t_full_mm", "t'", "mm", positive(), "full height")
      .output(&SizingRidge::penetration_mm, "H_cal_mm", "H_cal", "mm", non_negative(), "penetration")
      .output(&SizingRidge::extruded_mm, "H_ext_cal_mm", "H_ext,cal", "mm", non_negative(), "height raised")
      .output(&SizingRidge::blank_mm, "blank_diameter_mm", "d_b", "mm", positive(),
              "blank by equal plane areas")
      .output(&SizingRidge::blank_exact_mm, "blank_diameter_exact_mm", "d_b", "mm", positive(),
              "blank by equal ring volumes")
      .note("Equal areas instead of equal volumes misjudge the raised height by at most 3 %.");
  source
      .function<&contact_arc>("contact_arc", "Arc of contact of roller and blank.", "eq. (5)",
                              Provenance::repaired)
      .with([&](auto& f) { radii(f, &RollerContact::blank_radius_mm, &RollerContact::roller_radius_mm); })
      .input(&RollerContact::depth_mm, "H_mm", "H", "mm", non_negative(), "penetration, at most R_blank", 0.5)
      .output(&ContactArc::chord_mm, "X_mm", "X", "mm", any(),
              "distance of the common chord from the blank's axis")
      .output(&ContactArc::gamma_deg, "gamma_deg", "gamma", "deg", closed(0, 90),
              "contact angle on the roller")
      .output(&ContactArc::arc_mm, "l_K_mm", "l_K", "mm", non_negative(), "arc of contact");
  source
      .function<&turn_sequence>("turn_sequence", "What each lead-in ridge of a roller displaces.",
                                "ten-step procedure", Provenance::repaired)
      .input(&RidgeSequence::drops_mm, "drop_mm", "-", "mm", non_negative(),
             "drop of each lead-in ridge below the sizing ridges, falling",
             Value::List{1.4346, 0.8695, 0.4347, 0.1739})
      .length(1, 1000)
      .input(&RidgeSequence::sizing_depth_mm, "H_cal_mm", "H_cal", "mm", positive(),
             "penetration of the sizing ridges", 2.17363)
      .with(shape)
      .with([&](auto& f) { radii(f, &RidgeSequence::blank_radius_mm, &RidgeSequence::roller_radius_mm); })
      .input(&RidgeSequence::sizing_turns, "n_cal_turns", "n_cal", "1", at_least(1),
             "sizing ridges in contact", 2)
      .output(&TurnSequence::depth_mm, "H_mm", "H_i", "mm", non_negative(), "accumulated penetration")
      .output(&TurnSequence::own_depth_mm, "h_mm", "h_i", "mm", non_negative(), "own penetration")
      .output(&TurnSequence::extruded_mm, "H_ext_mm", "H_ext,i", "mm", non_negative(), "height raised")
      .output(&TurnSequence::displaced_mm2, "f_mm2", "f_i", "mm2", non_negative(),
              "area displaced by this ridge")
      .output(&TurnSequence::perimeter_mm, "l_p_mm", "l_P,i", "mm", non_negative(), "contact perimeter")
      .output(&TurnSequence::arc_mm, "l_k_mm", "l_K,i", "mm", non_negative(), "arc of contact")
      .output(&TurnSequence::displaced_mean_mm2, "f_mean_mm2", "f", "mm2", non_negative(),
              "mean displaced area")
      .output(&TurnSequence::perimeter_mean_mm, "l_pz_mm", "l_PZ", "mm", non_negative(), "mean perimeter")
      .output(&TurnSequence::arc_mean_mm, "l_kz_mm", "l_KZ", "mm", non_negative(), "mean arc")
      .output(&TurnSequence::sizing_perimeter_mm, "l_pk_mm", "l_PK", "mm", non_negative(),
              "perimeter of all sizing ridges")
      .output(&TurnSequence::layer_mm, "layer_mm", "f/l_PZ", "mm", non_negative(), "mean displaced layer")
      .output(&TurnSequence::contact_area_mm2, "contact_area_mm2", "S_K", "mm2", non_negative(),
              "contact area")
      .note("Means are taken over the lead-in ridges of one roller; the text can also be read as sums.");
  source
      .function<&rolling_radial_force>("rolling_radial_force", "Radial and tangential rolling force.",
                                       "eq. (3), (7)", Provenance::paper)
      .input(&RollingZone::layer_mm, "layer_mm", "f/l_PZ", "mm", positive(),
             "mean displaced layer (0.05-0.25)", 0.15)
      .input(&RollingZone::perimeter_mean_mm, "l_pz_mm", "l_PZ", "mm", positive(), "mean perimeter (6-20)",
             13.0)
      .input(&RollingZone::arc_mean_mm, "l_kz_mm", "l_KZ", "mm", positive(), "mean arc (5-10)", 7.5)
      .input(&RollingZone::sizing_perimeter_mm, "l_pk_mm", "l_PK", "mm", positive(),
             "perimeter of the sizing ridges (10-56)", 33.0)
      .optional(&RollingZone::coefficient, "C", "C", "kN/mm^n", positive(), "coefficient")
      .optional(&RollingZone::layer_exponent, "x", "x", "1", any(), "exponent of the layer")
      .optional(&RollingZone::area_exponent, "y", "y", "1", any(), "exponent of perimeter times arc")
      .optional(&RollingZone::sizing_exponent, "z", "z", "1", any(), "exponent of the sizing perimeter")
      .optional(&RollingZone::tangential_ratio, "tangential_ratio", "P_T/P_p", "1", closed(0.12, 0.15),
                "tangential over radial force")
      .output(&RollingForce::radial_kn, "P_radial_kN", "P_p", "kN", positive(), "radial force")
      .output(&RollingForce::tangential_kn, "P_tangential_kN", "P_T", "kN", positive(), "tangential force")
      .output(&RollingForce::pressure_mpa, "nominal_pressure_MPa", "-", "MPa", positive(),
              "force over mean perimeter times mean arc")
      .output(&RollingForce::in_range, "in_range", "-", "-", no_range(), "inside the fitted ranges")
      .note(
          "Fitted on steel 45, HB 190-212, trapezoidal threads of pitch 5-10 mm; elsewhere a lower "
          "estimate.");
  source
      .function<&force_coefficient>("force_coefficient", "Force coefficient from the quality of the blanks.",
                                    "eq. (4)", Provenance::paper)
      .input(&BlankQuality::form, "K1", "K_1", "1", positive(), "form error", 1.15)
      .input(&BlankQuality::hardness, "K2", "K_2", "1", positive(), "hardness scatter", 1.25)
      .input(&BlankQuality::diameter, "K3", "K_3", "1", positive(), "deviation of the diameter", 1.2)
      .input(&BlankQuality::location, "K4", "K_4", "1", positive(), "locating error", 1.05)
      .optional(&BlankQuality::base, "C0", "C_0", "1", positive(), "coefficient of a perfect blank")
      .output(&ForceCoefficient::coefficient, "C", "C", "1", positive(), "coefficient")
      .note(
          "C0 = 1 is the paper's literal form; for what-if studies use C0 = 9.4 and factors over a "
          "reference.");
  source
      .function<&rolled_thread_strength>("rolled_thread_strength", "Strength of a rolled over a cut thread.",
                                         "text", Provenance::paper)
      .input(&StrengthQuestion::property, "property", "-", "-", no_range(), "kind of strength",
             "bending_fatigue")
      .output(&StrengthFactor::low, "factor_low", "-", "1", positive(), "lower end")
      .output(&StrengthFactor::high, "factor_high", "-", "1", positive(), "upper end");
  source
      .function<&rolling_drive>("rolling_drive", "Torque and power of the rollers.", "completion",
                                Provenance::completion)
      .input(&RollingLoad::radial_kn, "P_radial_kN", "P_p", "kN", non_negative(), "radial force", 110.0)
      .input(&RollingLoad::tangential_ratio, "tangential_ratio", "P_T/P_p", "1", positive(),
             "tangential over radial force", 0.135)
      .input(&RollingLoad::roller_diameter_mm, "D_roller_mm", "D", "mm", positive(), "diameter of the roller",
             105.0)
      .input(&RollingLoad::speed_m_min, "v_m_min", "v", "m/min", positive(), "rolling speed", 30.0)
      .optional(&RollingLoad::rollers, "n_rollers", "n", "1", at_least(1), "number of rollers")
      .output(&RollingDrive::torque_nm, "torque_per_roller_Nm", "M", "N*m", non_negative(),
              "torque of a roller")
      .output(&RollingDrive::power_kw, "power_kW", "N", "kW", non_negative(), "power of all rollers");
  source
      .function<&plunge_cycle_time>("plunge_cycle_time", "Speeds and times of plunge rolling.", "completion",
                                    Provenance::completion)
      .input(&PlungeCycle::sizing_depth_mm, "H_cal_mm", "H_cal", "mm", positive(), "penetration", 0.5184)
      .input(&PlungeCycle::approach_mm, "approach_mm", "-", "mm", non_negative(),
             "approach, in the measure of the penetration", 0.5)
      .input(&PlungeCycle::feed_mm_rev, "feed_mm_per_rev", "-", "mm/rev", positive(),
             "growth of the penetration per revolution of the blank", 0.08)
      .input(&PlungeCycle::sizing_revolutions, "sizing_revs", "-", "1", non_negative(), "sizing revolutions",
             6.0)
      .input(&PlungeCycle::speed_m_min, "v_m_min", "v", "m/min", positive(), "rolling speed", 45.0)
      .input(&PlungeCycle::blank_diameter_mm, "D_blank_mm", "d", "mm", positive(), "diameter of the blank",
             10.89)
      .input(&PlungeCycle::roller_diameter_mm, "D_roller_mm", "D", "mm", positive(), "diameter of the roller",
             120.0)
      .input(&PlungeCycle::handling_min, "handling_min", "-", "min", non_negative(), "handling time", 0.08)
      .output(&PlungeTime::blank_rpm, "blank_rpm", "-", "rpm", positive(), "speed of the blank")
      .output(&PlungeTime::roller_rpm, "roller_rpm", "-", "rpm", positive(), "speed of the roller")
      .output(&PlungeTime::rolling_min, "t_roll_min", "-", "min", positive(), "rolling time")
      .output(&PlungeTime::cycle_min, "t_cycle_min", "-", "min", positive(), "piece time");
}

}  // namespace verstat::models::k407
