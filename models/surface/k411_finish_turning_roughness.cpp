#include "models/surface/k411_finish_turning_roughness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::models::k411 {
namespace {

constexpr double fitted_radius_mm = 2.0;  // nose radius of the tests
constexpr double fitted_feed_low_mm = 0.15;
constexpr double fitted_feed_high_mm = 0.55;
constexpr double variance_within_um2 = 0.007128;
constexpr double mean_range_of_three = 1.693;  // range of three normal values in standard deviations
constexpr double infeasible_time_min = 1e9;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// One side of the tool contour: nose arc, then a straight edge tangent to it at `angle` (rad) to the feed.
class Side {
 public:
  Side(double radius, double angle)
      : radius_(radius), cos_(std::cos(angle)), sin_(std::sin(angle)), tangent_height_(radius * (1 - cos_)) {}

  // Distance from the nose bottom to the contour at a height.
  [[nodiscard]] double reach(double height) const {
    if (height <= tangent_height_) return std::sqrt(height * (2 * radius_ - height));
    return radius_ * sin_ / (1 + cos_) + height * cos_ / sin_;  // tan(angle/2) = sin/(1 + cos)
  }
  // Area between the contour and the level of the nose bottom, up to a height.
  [[nodiscard]] double area_below(double height) const {
    const double arc_height = std::min(height, tangent_height_);
    const double sine = std::min(1.0, std::sqrt(arc_height * (2 * radius_ - arc_height)) / radius_);
    const double theta = std::atan2(sine, 1 - arc_height / radius_);
    const double square = theta * theta;
    // sin t - t/2 - sin t cos t/2 loses all digits for small t: series.
    const double share = theta < 0.02 ? theta * square * (1.0 / 6 - square * (7.0 / 120 - square * 31 / 5040))
                                      : sine - (theta + sine * (1 - arc_height / radius_)) / 2;
    double area = radius_ * radius_ * share;
    if (height > arc_height) area += (height - arc_height) * (height + arc_height) / 2 * cos_ / sin_;
    return area;
  }

 private:
  double radius_, cos_, sin_, tangent_height_;
};

struct Profile {
  double height_mm;
  ProfileRegime regime;
  double limit_nose_mm;
  double limit_edge_mm;
};

Profile profile(const NoseGeometry& nose, double feed) {
  const double r = nose.nose_radius_mm;
  const double kr = radians(nose.kr_deg);
  const double kr1 = radians(nose.kr1_deg);
  const double flat = std::min(kr, kr1);
  const double steep = std::max(kr, kr1);
  const double cot_flat = std::cos(flat) / std::sin(flat);
  const double limit_nose = 2 * r * std::sin(flat);
  // Equal angles: both limits are the same number, not two rounded ones.
  const double limit_edge =
      flat == steep ? limit_nose
                    : r * std::sin(steep) + r * std::tan(flat / 2) + r * (1 - std::cos(steep)) * cot_flat;
  if (feed <= limit_nose) {
    const double half_square = feed * feed / 4;
    return {half_square / (r + std::sqrt(r * r - half_square)), ProfileRegime::nose_nose, limit_nose,
            limit_edge};
  }
  if (feed <= limit_edge) {
    const double p = feed - r * std::tan(flat / 2);
    const double q = r + p * cot_flat;
    const double sine = std::sin(flat);
    const double height = p * p / (q + std::sqrt(std::max(0.0, q * q - p * p / (sine * sine))));
    return {height, ProfileRegime::nose_edge, limit_nose, limit_edge};
  }
  const double height = (feed - r * (std::tan(kr / 2) + std::tan(kr1 / 2))) /
                        (std::cos(kr) / std::sin(kr) + std::cos(kr1) / std::sin(kr1));
  return {height, ProfileRegime::edge_edge, limit_nose, limit_edge};
}

// Mean absolute deviation of the periodic profile: twice the area below the mean line, over the feed.
double mean_deviation_mm(const NoseGeometry& nose, double feed, double height) {
  const Side main(nose.nose_radius_mm, radians(nose.kr_deg));
  const Side minor(nose.nose_radius_mm, radians(nose.kr1_deg));
  double area = main.area_below(height) + minor.area_below(height);
  // An upright edge (kr = 90) ends below `height` at the same reach; area_below is then exact too.
  const double mean = area / feed;
  area = main.area_below(mean) + minor.area_below(mean);
  return 2 * (mean * (main.reach(mean) + minor.reach(mean)) - area) / feed;
}

double equivalent_feed_mm(double height_mm) {
  const double h = std::min(height_mm, fitted_radius_mm);
  return 2 * std::sqrt(h * (2 * fitted_radius_mm - h));
}

struct Fitted {
  Profile shape;
  double equivalent_mm;
  double factor;
  double ra_um;
};

Fitted fitted_ra(const NoseGeometry& nose, double feed, const FittedSurface& law) {
  const Profile shape = profile(nose, feed);
  const double equivalent = equivalent_feed_mm(shape.height_mm);
  const double s = law.policy == FactorPolicy::printed
                       ? equivalent
                       : std::clamp(equivalent, fitted_feed_low_mm, fitted_feed_high_mm);
  const double factor = law.a * std::exp(law.alpha * s * s + law.beta * s);
  return {shape, equivalent, factor, factor * 0.2 * shape.height_mm * 1000};
}

Fitted fitted_ra(const NoseGeometry& nose, double feed) {
  static const FittedSurface printed_law{};
  return fitted_ra(nose, feed, printed_law);
}

// Difference between the three tool designs as a share of Ra (table, first column), against the feed.
double between_tools_share(double equivalent_mm) {
  struct Row {
    double feed_mm, range;
  };
  static constexpr std::array<Row, 4> rows{{{0.15, 0.1999}, {0.21, 0.1287}, {0.33, 0.0523}, {0.55, 0.0485}}};
  if (equivalent_mm <= rows.front().feed_mm) return rows.front().range;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (equivalent_mm <= rows[k].feed_mm)
      return std::lerp(rows[k - 1].range, rows[k].range,
                       (equivalent_mm - rows[k - 1].feed_mm) / (rows[k].feed_mm - rows[k - 1].feed_mm));
  return rows.back().range;
}

double sigma_um(const Fitted& fitted, double variance_um2, bool include_between) {
  const double between =
      include_between ? between_tools_share(fitted.equivalent_mm) / mean_range_of_three * fitted.ra_um : 0;
  return std::sqrt(variance_um2 + between * between);
}

// Largest feed at which an increasing level stays at or below the limit.
LargestFeed largest_feed(const Function1& level, double limit, double feed_min, double feed_max) {
  if (level(feed_min) > limit) return {0, FeedStatus::infeasible};
  if (level(feed_max) <= limit) return {feed_max, FeedStatus::at_feed_max};
  return {find_root([&](double s) { return level(s) - limit; }, feed_min, feed_max),
          FeedStatus::roughness_active};
}

LargestFeed reliable_feed(const NoseGeometry& nose, double limit_um, double gamma, bool include_between,
                          double feed_min, double feed_max) {
  const double z = boost::math::quantile(boost::math::normal_distribution<double, MathPolicy>(0, 1), gamma);
  const auto level = [&](double s) {
    const Fitted fitted = fitted_ra(nose, s);
    return fitted.ra_um + z * sigma_um(fitted, variance_within_um2, include_between);
  };
  return largest_feed(level, limit_um, feed_min, feed_max);
}

void check_bounds(const FeedBounds& in) {
  require(in.feed_min_mm_rev <= in.feed_max_mm_rev, "feed_min", in.feed_min_mm_rev,
          "must not be above feed_max");
}

}  // namespace

InsertAngles insert_angles(const InsertShape& in) {
  return guarded<&insert_angles>(in, [&] {
    const double corner = 180 - 360.0 / static_cast<double>(in.faces);
    const double kr1 = 180 - corner - in.kr_deg;
    require(kr1 > 0, "kr_deg", in.kr_deg,
            "must be below 360/n_faces, or the insert has no minor edge angle left");
    return InsertAngles{corner, kr1};
  });
}

TheoreticalProfile theoretical_roughness(const TurnedSurface& in) {
  return guarded<&theoretical_roughness>(in, [&] {
    const Profile p = profile(in, in.feed_mm_rev);
    return TheoreticalProfile{1000 * p.height_mm, p.regime,
                              p.limit_nose_mm,    p.limit_edge_mm,
                              200 * p.height_mm,  1000 * mean_deviation_mm(in, in.feed_mm_rev, p.height_mm)};
  });
}

FittedRoughness turning_ra(const FittedSurface& in) {
  return guarded<&turning_ra>(in, [&] {
    const Fitted fitted = fitted_ra(in, in.feed_mm_rev, in);
    constexpr double slack = 1e-9;
    const bool in_range = std::abs(in.nose_radius_mm - fitted_radius_mm) <= slack &&
                          in.feed_mm_rev <= fitted.shape.limit_nose_mm + slack &&
                          fitted.equivalent_mm >= fitted_feed_low_mm - slack &&
                          fitted.equivalent_mm <= fitted_feed_high_mm + slack;
    return FittedRoughness{fitted.ra_um, fitted.factor, 1000 * fitted.shape.height_mm, fitted.equivalent_mm,
                           in_range};
  });
}

LargestFeed max_feed_for_ra(const RaLimit& in) {
  return guarded<&max_feed_for_ra>(in, [&] {
    check_bounds(in);
    return largest_feed([&](double s) { return fitted_ra(in, s).ra_um; }, in.ra_max_um, in.feed_min_mm_rev,
                        in.feed_max_mm_rev);
  });
}

RaScatter ra_scatter(const ScatteredSurface& in) {
  return guarded<&ra_scatter>(in, [&] {
    const Fitted fitted = fitted_ra(in, in.feed_mm_rev);
    return RaScatter{sigma_um(fitted, in.variance_within_um2, in.include_between), fitted.ra_um};
  });
}

ExceedProbability ra_exceed_probability(const LimitedSurface& in) {
  return guarded<&ra_exceed_probability>(in, [&] {
    const Fitted fitted = fitted_ra(in, in.feed_mm_rev);
    const double z =
        (fitted.ra_um - in.ra_limit_um) / sigma_um(fitted, variance_within_um2, in.include_between);
    return ExceedProbability{0.5 * std::erfc(-z / std::numbers::sqrt2)};
  });
}

LargestFeed max_feed_for_ra_reliability(const RaReliability& in) {
  return guarded<&max_feed_for_ra_reliability>(in, [&] {
    check_bounds(in);
    return reliable_feed(in, in.ra_limit_um, in.gamma, in.include_between, in.feed_min_mm_rev,
                         in.feed_max_mm_rev);
  });
}

HalfWidth ra_confidence_half_width(const MeanReading& in) {
  return guarded<&ra_confidence_half_width>(in, [&] {
    const boost::math::students_t_distribution<double, MathPolicy> t(in.degrees_of_freedom);
    // The upper tail keeps its digits for confidences close to 1.
    const double factor = boost::math::quantile(boost::math::complement(t, (1 - in.confidence) / 2));
    return HalfWidth{factor * std::sqrt(in.variance_um2 / static_cast<double>(in.readings))};
  });
}

FinishTime finish_pass_time(const FinishPass& in) {
  return guarded<&finish_pass_time>(in, [&] {
    const LargestFeed feed =
        reliable_feed(in, in.ra_limit_um, in.gamma, true, FeedBounds{}.feed_min_mm_rev, in.feed_max_mm_rev);
    const double rpm = 1000 * in.cutting_speed_m_min / (std::numbers::pi * in.diameter_mm);
    const double time =
        feed.status == FeedStatus::infeasible ? infeasible_time_min : in.length_mm / (rpm * feed.feed_mm_rev);
    return FinishTime{feed.feed_mm_rev, rpm, time, feed.status};
  });
}

HandbookFeed handbook_finish_feed(const HandbookSurface& in) {
  return guarded<&handbook_finish_feed>(in, [&] {
    // Rows: Ra 0.63, 1.25, 2.5, Rz 20, 40, 80; columns: nose radius 0.4, 0.8 ... 2.4 mm.
    static constexpr std::array<std::array<double, 6>, 6> feeds{{{0.07, 0.10, 0.12, 0.14, 0.15, 0.17},
                                                                 {0.10, 0.13, 0.165, 0.19, 0.21, 0.23},
                                                                 {0.144, 0.20, 0.246, 0.29, 0.32, 0.35},
                                                                 {0.25, 0.33, 0.42, 0.49, 0.55, 0.60},
                                                                 {0.35, 0.51, 0.63, 0.72, 0.80, 0.87},
                                                                 {0.47, 0.66, 0.81, 0.94, 1.04, 1.14}}};
    const auto& row = feeds[static_cast<std::size_t>(in.roughness_class)];
    const double place = (std::clamp(in.nose_radius_mm, 0.4, 2.4) - 0.4) / 0.4;
    const double left = std::min(std::floor(place + 1e-12), 4.0);
    const auto k = static_cast<std::size_t>(left);
    return HandbookFeed{std::lerp(row[k], row[k + 1], std::max(0.0, place - left))};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K411",
       .title = "Study of the influence of structural characteristics of universal turning tools with a "
                "rotatable working part on surface roughness",
       .authors = "Grinyov Yu. A., Tsarenko E. N.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Finish turning of steel 45 with indexable carbide inserts on a standard holder and two universal "
           "holders with a rotatable head: Ra as a share of the theoretical profile height times a fitted "
           "exponential in feed. Tool design and edge angle do not matter in the tested range (nose radius 2 "
           "mm, feed 0.15-0.55 mm/rev).",
       .role = "surface",
       .errata = {"The height h of the theoretical profile is used but not printed; it is rebuilt from the "
                  "exact geometry of a rounded nose between two straight edges."}});

  const auto radius = [](auto& f) {
    f.optional(&NoseGeometry::nose_radius_mm, "r_mm", "r", "mm", closed(0.1, 5), "nose radius");
  };
  const auto nose = [&](auto& f) {
    radius(f);
    f.optional(&NoseGeometry::kr_deg, "kr_deg", "k_r", "deg", closed(10, 90), "main edge angle")
        .optional(&NoseGeometry::kr1_deg, "kr1_deg", "k_r1", "deg", closed(2, 80), "minor edge angle");
  };
  const auto feed = [](auto& f) {
    f.input(&TurnedSurface::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", closed(0.01, 1.5), "feed", 0.25);
  };
  const auto bounds = [](auto& f) {
    f.optional(&FeedBounds::feed_min_mm_rev, "feed_min", "s_min", "mm/rev", closed(0.01, 1.5),
               "smallest feed allowed")
        .optional(&FeedBounds::feed_max_mm_rev, "feed_max", "s_max", "mm/rev", closed(0.01, 1.5),
                  "largest feed allowed");
  };
  const auto largest = [](auto& f) {
    f.output(&LargestFeed::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", closed(0, 1.5),
             "largest feed, 0 when infeasible")
        .output(&LargestFeed::status, "status", "-", "-", no_range(), "what limits the feed");
  };
  const char* const fit_note =
      "Fitted at r = 2 mm, feed 0.15-0.55 mm/rev, v about 120 m/min, depth 1 mm, steel 45, fresh edge; below "
      "0.15 mm/rev real surfaces level off.";

  source
      .function<&insert_angles>("insert_angles", "Corner and minor edge angle of a regular polygon insert.",
                                "geometry", Provenance::completion)
      .input(&InsertShape::faces, "n_faces", "n", "1", closed(3, 8), "number of faces", 4)
      .input(&InsertShape::kr_deg, "kr_deg", "k_r", "deg", closed(10, 90), "main edge angle", 45.0)
      .output(&InsertAngles::corner_deg, "corner_deg", "epsilon", "deg", closed(60, 135), "corner angle")
      .output(&InsertAngles::kr1_deg, "kr1_deg", "k_r1", "deg", open(0, 110), "minor edge angle");
  source
      .function<&theoretical_roughness>("theoretical_roughness",
                                        "Height and mean deviation of the theoretical profile.", "geometry",
                                        Provenance::completion)
      .with(feed)
      .input(&TurnedSurface::nose_radius_mm, "r_mm", "r", "mm", closed(0.1, 5), "nose radius", 0.8)
      .input(&TurnedSurface::kr_deg, "kr_deg", "k_r", "deg", closed(10, 90), "main edge angle", 75.0)
      .input(&TurnedSurface::kr1_deg, "kr1_deg", "k_r1", "deg", closed(2, 80), "minor edge angle", 15.0)
      .output(&TheoreticalProfile::height_um, "h_um", "h", "um", positive(), "height of the profile")
      .output(&TheoreticalProfile::regime, "regime", "-", "-", no_range(), "what forms the two sides")
      .output(&TheoreticalProfile::feed_limit_nose_mm, "feed_limit_nose_mm", "s_1", "mm/rev", positive(),
              "feed up to which the nose alone forms the profile")
      .output(&TheoreticalProfile::feed_limit_edge_mm, "feed_limit_edge_mm", "s_2", "mm/rev", positive(),
              "feed from which both straight edges form it")
      .output(&TheoreticalProfile::ra_02h_um, "Ra_02h_um", "0.2 h", "um", positive(),
              "Ra by the paper's share")
      .output(&TheoreticalProfile::ra_profile_um, "Ra_profile_um", "Ra", "um", positive(),
              "exact mean deviation of the theoretical profile")
      .note(
          "The mean deviation is evaluated in closed form. For the nose arc it is 0.2566 h, so 0.2 h is 22 % "
          "below it; the factor of eq. (1) absorbs this.");
  source.function<&turning_ra>("turning_ra", "Ra after finish turning.", "eq. (1)", Provenance::reconstructed)
      .with(feed)
      .with(nose)
      .optional(&FittedSurface::policy, "policy", "-", "-", no_range(),
                "hold the factor outside the fitted feeds, or extrapolate as printed")
      .optional(&FittedSurface::a, "a", "a", "1", positive(), "coefficient of eq. (1)")
      .optional(&FittedSurface::alpha, "alpha", "alpha", "(mm/rev)^-2", any(), "coefficient of eq. (1)")
      .optional(&FittedSurface::beta, "beta", "beta", "(mm/rev)^-1", any(), "coefficient of eq. (1)")
      .output(&FittedRoughness::ra_um, "Ra_um", "Ra", "um", non_negative(), "mean deviation of the profile")
      .output(&FittedRoughness::factor, "factor", "-", "1", non_negative(), "a exp(alpha s^2 + beta s) used")
      .output(&FittedRoughness::height_um, "h_um", "h", "um", positive(), "theoretical profile height")
      .output(&FittedRoughness::equivalent_feed_mm, "equivalent_feed_mm", "s_eq", "mm/rev", positive(),
              "feed that leaves the same height with a 2 mm nose, not clamped")
      .output(&FittedRoughness::in_range, "in_range", "-", "-", no_range(),
              "eq. (1) applies without extension")
      .note(fit_note)
      .note("The height h and the extension to other nose radii and angles are COMPLETION.");
  source
      .function<&max_feed_for_ra>("max_feed_for_ra", "Largest feed that keeps a limit of Ra.",
                                  "eq. (1), inverse", Provenance::reconstructed)
      .input(&RaLimit::ra_max_um, "Ra_max_um", "Ra_max", "um", positive(), "limit of Ra", 3.2)
      .with(nose)
      .with(bounds)
      .with(largest)
      .note(fit_note);
  source
      .function<&ra_scatter>("ra_scatter", "Standard deviation of Ra of a part.", "completion",
                             Provenance::completion)
      .with(feed)
      .with(nose)
      .optional(&ScatteredSurface::variance_within_um2, "var_within", "s^2", "um2", non_negative(),
                "variance between repetitions")
      .optional(&ScatteredSurface::include_between, "include_between", "-", "-", no_range(),
                "count the difference between tools")
      .output(&RaScatter::sigma_um, "sigma_um", "sigma", "um", non_negative(), "standard deviation of Ra")
      .output(&RaScatter::ra_um, "Ra_um", "Ra", "um", positive(), "mean Ra");
  source
      .function<&ra_exceed_probability>("ra_exceed_probability",
                                        "Probability that a part is rougher than the limit.", "completion",
                                        Provenance::completion)
      .input(&LimitedSurface::ra_limit_um, "Ra_limit_um", "L", "um", positive(), "limit of Ra", 3.2)
      .with(feed)
      .with(nose)
      .optional(&LimitedSurface::include_between, "include_between", "-", "-", no_range(),
                "count the difference between tools")
      .output(&ExceedProbability::probability, "p_exceed", "P", "1", probability(), "P(Ra > limit)");
  source
      .function<&max_feed_for_ra_reliability>("max_feed_for_ra_reliability",
                                              "Largest feed that keeps a limit of Ra with a probability.",
                                              "completion", Provenance::completion)
      .input(&RaReliability::ra_limit_um, "Ra_limit_um", "L", "um", positive(), "limit of Ra", 3.2)
      .input(&RaReliability::gamma, "gamma", "gamma", "1", closed(0.5, 0.999), "P(Ra <= limit) asked for",
             0.95)
      .with(nose)
      .optional(&RaReliability::include_between, "include_between", "-", "-", no_range(),
                "count the difference between tools")
      .with(bounds)
      .with(largest)
      .note(fit_note);
  source
      .function<&ra_confidence_half_width>("ra_confidence_half_width",
                                           "Confidence half-width of a mean of readings.", "text",
                                           Provenance::paper)
      .input(&MeanReading::variance_um2, "variance", "s^2", "um2", non_negative(), "variance of a reading",
             0.007128)
      .input(&MeanReading::readings, "n", "n", "1", at_least(1), "readings in the mean", 2)
      .input(&MeanReading::degrees_of_freedom, "dof", "f", "1", positive(),
             "degrees of freedom of the variance", 192.0)
      .optional(&MeanReading::confidence, "confidence", "P", "1", open(0, 1), "two-sided confidence")
      .output(&HalfWidth::half_width_um, "half_width_um", "-", "um", non_negative(), "half-width");
  source
      .function<&finish_pass_time>("finish_pass_time",
                                   "Feed, spindle speed and main time of a finish pass under a limit of Ra.",
                                   "completion", Provenance::completion)
      .input(&FinishPass::ra_limit_um, "Ra_limit_um", "L", "um", positive(), "limit of Ra", 3.2)
      .input(&FinishPass::gamma, "gamma", "gamma", "1", closed(0.5, 0.999), "P(Ra <= limit) asked for", 0.95)
      .input(&FinishPass::cutting_speed_m_min, "v_m_min", "v", "m/min", positive(), "cutting speed", 120.0)
      .input(&FinishPass::diameter_mm, "D_mm", "D", "mm", positive(), "diameter of the work", 35.0)
      .input(&FinishPass::length_mm, "L_mm", "L", "mm", positive(), "length of the pass", 200.0)
      .with(nose)
      .optional(&FinishPass::feed_max_mm_rev, "feed_max", "s_max", "mm/rev", closed(0.05, 1.5),
                "largest feed allowed (the smallest is 0.05)")
      .output(&FinishTime::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", closed(0, 1.5),
              "feed, 0 when infeasible")
      .output(&FinishTime::spindle_rpm, "n_rpm", "n", "rpm", positive(), "spindle speed")
      .output(&FinishTime::main_time_min, "t_main_min", "t_0", "min", positive(),
              "main time, 1e9 when infeasible")
      .output(&FinishTime::status, "status", "-", "-", no_range(), "what limits the feed")
      .note(fit_note);
  source
      .function<&handbook_finish_feed>("handbook_finish_feed", "Handbook feed for a roughness class.",
                                       "handbook the paper cites", Provenance::completion)
      .input(&HandbookSurface::roughness_class, "roughness_class", "-", "-", no_range(), "roughness class",
             "Ra2.5")
      .optional(&HandbookSurface::nose_radius_mm, "r_mm", "r", "mm", closed(0.1, 5),
                "nose radius, held to 0.4..2.4")
      .output(&HandbookFeed::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(), "feed")
      .note("At small feeds eq. (1) gives a rougher surface than the class promises.");
}

}  // namespace verstat::models::k411
