#include "models/milling/k301_polygon_milling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "models/milling/helical_tooth_load.h"

namespace verstat::models::k301 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;
constexpr double least_arc_rad = 1e-9;  // the card's limit of "in cut"

// The path of the cutter centre around the polygon.
class Contour {
 public:
  explicit Contour(const Polygon& in)
      : faces_(static_cast<double>(in.faces)),
        apothem_mm_(in.apothem_mm),
        radius_mm_(in.cutter_radius_mm),
        half_face_mm_(in.apothem_mm * std::tan(pi / faces_)),
        vertex_mm_(in.apothem_mm / std::cos(pi / faces_)) {}

  struct Place {
    double x_mm;
    double chi_rad;
    bool on_corner;
  };

  [[nodiscard]] Place at(double c_deg) const {
    const double sector_deg = 360 / faces_;
    const double theta_deg = c_deg - sector_deg * std::floor(c_deg / sector_deg + 0.5);
    const double theta = theta_deg * rad_per_deg;
    if (std::abs(theta) <= flat_half_angle_rad()) return {x_min_mm() / std::cos(theta), theta, false};
    const double turned =
        (theta_deg > 0 ? theta_deg - sector_deg / 2 : theta_deg + sector_deg / 2) * rad_per_deg;
    const double offset_mm = vertex_mm_ * std::sin(turned);
    return {vertex_mm_ * std::cos(turned) + std::sqrt((radius_mm_ - offset_mm) * (radius_mm_ + offset_mm)),
            -std::asin(offset_mm / radius_mm_) + 0.0, true};
  }
  // On a flat, y from its middle.
  [[nodiscard]] Place on_flat(double y_mm) const {
    return {std::hypot(y_mm, x_min_mm()), std::atan2(y_mm, x_min_mm()), false};
  }
  // On a corner, pivot angle from its middle.
  [[nodiscard]] Place on_corner(double pivot_rad) const {
    const double along_mm = vertex_mm_ + radius_mm_ * std::cos(pivot_rad);
    const double across_mm = radius_mm_ * std::sin(pivot_rad);
    return {std::hypot(along_mm, across_mm), std::atan2(across_mm, along_mm) - pivot_rad, true};
  }

  [[nodiscard]] double flat_half_angle_rad() const { return std::atan(half_face_mm_ / x_min_mm()); }
  [[nodiscard]] double x_min_mm() const { return apothem_mm_ + radius_mm_; }
  [[nodiscard]] double half_face_mm() const { return half_face_mm_; }
  [[nodiscard]] double vertex_mm() const { return vertex_mm_; }

 private:
  double faces_;
  double apothem_mm_;
  double radius_mm_;
  double half_face_mm_;
  double vertex_mm_;
};

struct Arc {
  double start_rad = 0;
  double exit_rad = 0;
};

// Arc in stock; empty when out of cut.
Arc engaged_arc(const Contour::Place& place, double radius_mm, double blank_radius_mm) {
  const double cosine =
      (place.x_mm * place.x_mm + (radius_mm - blank_radius_mm) * (radius_mm + blank_radius_mm)) /
      (2 * radius_mm * place.x_mm);
  if (cosine >= 1) return {};
  if (cosine <= -1) return {0, pi};
  const double omega = std::acos(cosine);
  const Arc arc{std::max(0.0, -omega - place.chi_rad), std::min(pi, omega - place.chi_rad)};
  return arc.exit_rad - arc.start_rad > least_arc_rad ? arc : Arc{};
}

void require_blank(const RoundBlank& in) {
  require(in.blank_radius_mm >= in.apothem_mm, "blank_radius_mm", in.blank_radius_mm,
          "must not be below apothem_mm");
}

// Angle by which the trailing end of a tooth lags.
double helix_lag_rad(double axial_depth_mm, double helix_deg, double radius_mm) {
  const double lag = axial_depth_mm * std::tan(helix_deg * rad_per_deg) / radius_mm;
  require(lag < 1e6, "axial_depth_mm", axial_depth_mm,
          "winds the helix over more than 1e6 rad: too deep for this radius");
  return lag;
}

// Peak force at 1 mm per tooth; 0 out of cut.
double unit_peak_n(const ForceLimitedCut& in, const SinePowerIntegral& integral, const Arc& arc) {
  if (!(arc.exit_rad > arc.start_rad)) return 0;
  const double lag = helix_lag_rad(in.axial_depth_mm, in.helix_deg, in.cutter_radius_mm);
  const ToothLoad load{integral, arc.start_rad, arc.exit_rad, lag, in.teeth};
  return in.kc11_mpa * in.axial_depth_mm * load.peak();
}

double force_at_feed_n(const ForceLimitedCut& in, double unit_peak_n, double feed_mm_min) {
  const double fz_mm = feed_mm_min / (in.rpm * static_cast<double>(in.teeth));
  return unit_peak_n * std::pow(fz_mm, 1 - in.mc);
}

struct LimitedFeed {
  double feed_mm_min;
  FeedLimit by;
};

LimitedFeed limited_feed(const ForceLimitedCut& in, double unit_peak_n, const Contour::Place& place) {
  LimitedFeed feed{std::numeric_limits<double>::infinity(), FeedLimit::force};
  if (unit_peak_n > 0)
    feed.feed_mm_min =
        in.rpm * static_cast<double>(in.teeth) * std::pow(in.force_limit_n / unit_peak_n, 1 / (1 - in.mc));
  const auto at_most = [&](double bound_mm_min, FeedLimit by) {
    if (feed.feed_mm_min > bound_mm_min) feed = {bound_mm_min, by};
  };
  at_most(in.feed_max_mm_min, FeedLimit::feed_max);
  if (feed.feed_mm_min < in.feed_min_mm_min) feed = {in.feed_min_mm_min, FeedLimit::feed_min};
  const double sine = std::abs(std::sin(place.chi_rad));
  if (sine > 0) at_most(in.x_rate_max_mm_min / sine, FeedLimit::x_axis);
  at_most(in.c_rate_max_deg_min * rad_per_deg * place.x_mm / std::cos(place.chi_rad), FeedLimit::c_axis);
  return feed;
}

void require_feed_order(const ForceLimitedCut& in) {
  require_blank(in);
  require(in.feed_min_mm_min <= in.feed_max_mm_min, "feed_min_mm_min", in.feed_min_mm_min,
          "must not be above feed_max_mm_min");
}

struct BlockGeometry {
  double chord_mm;
  double travel;  // of the axis that carries the feed, mm or deg; 1 for inverse time
};

BlockGeometry block_geometry(const BlockMove& in) {
  const double scale = in.x_is_diameter ? 0.5 : 1;
  const double x1_mm = scale * in.x1_mm, x2_mm = scale * in.x2_mm;
  const double half_sine = std::sin(0.5 * (in.c2_deg - in.c1_deg) * rad_per_deg);
  const double chord_mm =
      std::sqrt((x2_mm - x1_mm) * (x2_mm - x1_mm) + 4 * x1_mm * x2_mm * half_sine * half_sine);
  switch (in.mode) {
    case FeedMode::radial:
      return {chord_mm, std::abs(x2_mm - x1_mm)};
    case FeedMode::c_rate:
      return {chord_mm, std::abs(in.c2_deg - in.c1_deg)};
    case FeedMode::inverse_time:
      break;
  }
  return {chord_mm, 1};
}

void require_same_length(std::size_t length, std::size_t as, std::string_view name, std::string_view other) {
  if (length != as)
    throw DomainError(std::string(name),
                      fmt::format("{} has {} entries, must have as many as {}, {}", name, length, other, as));
}

}  // namespace

ContourSummary polygon_contour_summary(const Polygon& in) {
  return guarded<&polygon_contour_summary>(in, [&] {
    const Contour contour(in);
    const auto faces = static_cast<double>(in.faces);
    const double half_faces_mm = faces * contour.half_face_mm();
    return ContourSummary{.vertex_radius_mm = contour.vertex_mm(),
                          .flat_half_angle_deg = contour.flat_half_angle_rad() / rad_per_deg,
                          .x_min_mm = contour.x_min_mm(),
                          .x_max_mm = contour.vertex_mm() + in.cutter_radius_mm,
                          .path_length_mm = 2 * half_faces_mm + 2 * pi * in.cutter_radius_mm,
                          .polygon_area_mm2 = half_faces_mm * in.apothem_mm};
  });
}

ContourPoint polygon_contour_point(const PolygonAtAngle& in) {
  return guarded<&polygon_contour_point>(in, [&] {
    const Contour::Place place = Contour(in).at(in.c_deg);
    return ContourPoint{place.x_mm, place.x_mm * std::tan(place.chi_rad), place.chi_rad / rad_per_deg,
                        place.on_corner ? 1 : 0};
  });
}

NcFeeds verify_gcode_feed(const NcProgram& in) {
  return guarded<&verify_gcode_feed>(in, [&] {
    const std::size_t n = in.x_mm.size();
    require_same_length(in.c_deg.size(), n, "c_deg", "x_mm");
    require_same_length(in.f_word.size(), n, "f_word", "x_mm");
    const double scale = in.x_is_diameter ? 0.5 : 1;
    NcFeeds out;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1;
      const std::size_t after = std::min(i + 1, n - 1);
      const double dx_mm = scale * (in.x_mm[after] - in.x_mm[before]);
      const double dc_rad = (in.c_deg[after] - in.c_deg[before]) * rad_per_deg;
      const auto blocks = [&] {
        return fmt::format("must differ from block {}: dx/dc is undefined", before);
      };
      if (dx_mm == 0) require(false, fmt::format("x_mm/{}", after), in.x_mm[after], blocks());
      if (dc_rad == 0) require(false, fmt::format("c_deg/{}", after), in.c_deg[after], blocks());
      const double slope = dx_mm / dc_rad;
      const double omega = in.f_word[i] / std::abs(slope);
      out.dx_dc_mm_rad.push_back(slope);
      out.c_rate_deg_min.push_back(omega / rad_per_deg);
      out.path_feed_mm_min.push_back(std::hypot(in.f_word[i], scale * in.x_mm[i] * omega));
    }
    return out;
  });
}

AxisFeeds radial_feed_for_path_feed(const PathFeed& in) {
  return guarded<&radial_feed_for_path_feed>(in, [&] {
    const double omega = in.path_feed_mm_min / std::hypot(in.dx_dc_mm_rad, in.x_mm);
    return AxisFeeds{std::abs(in.dx_dc_mm_rad) * omega, omega / rad_per_deg};
  });
}

PassMaxima tooth_pass_maxima(const ForceRecord& in) {
  return guarded<&tooth_pass_maxima>(in, [&] {
    require_same_length(in.force_n.size(), in.c_deg.size(), "force_n", "c_deg");
    require_same_length(in.end_index.size(), in.start_index.size(), "end_index", "start_index");
    PassMaxima out;
    for (std::size_t k = 0; k < in.start_index.size(); ++k) {
      const std::int64_t start = in.start_index[k], end = in.end_index[k];
      if (end >= static_cast<std::int64_t>(in.force_n.size()))
        require(false, fmt::format("end_index/{}", k), end, "must be below the number of points");
      if (start > end)
        require(false, fmt::format("start_index/{}", k), start, "must not be above its end_index");
      const auto from = in.force_n.begin() + start;
      const auto top = std::max_element(from, in.force_n.begin() + end + 1);
      out.c_at_max_deg.push_back(in.c_deg[static_cast<std::size_t>(top - in.force_n.begin())]);
      out.max_force_n.push_back(*top);
    }
    return out;
  });
}

BlockFeed block_path_feed(const NcBlock& in) {
  return guarded<&block_path_feed>(in, [&] {
    const BlockGeometry block = block_geometry(in);
    if (block.travel == 0) {
      const bool radial = in.mode == FeedMode::radial;
      require(false, radial ? "x2_mm" : "c2_deg", radial ? in.x2_mm : in.c2_deg,
              radial ? "must differ from x1_mm: the feed is of radial travel"
                     : "must differ from c1_deg: the feed is of C");
    }
    return BlockFeed{block.chord_mm, block.chord_mm * in.f_word / block.travel};
  });
}

FeedWord feed_word_for_block(const FeedForBlock& in) {
  return guarded<&feed_word_for_block>(in, [&] {
    const BlockGeometry block = block_geometry(in);
    require(block.chord_mm > 0, "x2_mm", in.x2_mm, "the block must have a length: x or c must change");
    return FeedWord{block.travel * in.path_feed_mm_min / block.chord_mm};
  });
}

FlatFit gcode_flat_fit(const FlatPoints& in) {
  return guarded<&gcode_flat_fit>(in, [&] {
    const std::size_t n = in.x_mm.size();
    require_same_length(in.c_deg.size(), n, "c_deg", "x_mm");
    double spread = 0;
    for (const double c : in.c_deg)
      spread = std::max(spread, std::abs(std::sin((c - in.c_deg[0]) * rad_per_deg)));
    require(spread > 1e-9, "c_deg", in.c_deg[0], "must differ between the points: they lie on one ray");
    // Least squares by orthogonalising the second column against the first.
    double uu = 0, uv = 0, u1 = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double u = in.x_mm[i] * std::cos(in.c_deg[i] * rad_per_deg);
      uu += u * u;
      uv += u * in.x_mm[i] * std::sin(in.c_deg[i] * rad_per_deg);
      u1 += u;
    }
    const double shift = uu > 0 ? uv / uu : 0;
    double ww = 0, w1 = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double c = in.c_deg[i] * rad_per_deg;
      const double w = in.x_mm[i] * (std::sin(c) - shift * std::cos(c));
      ww += w * w;
      w1 += w;
    }
    const double q = w1 / ww;
    const double p = uu > 0 ? u1 / uu - shift * q : 0;
    FlatFit out{1 / std::hypot(p, q), std::atan2(q, p) / rad_per_deg, 0};
    for (std::size_t i = 0; i < n; ++i) {
      const double line_mm = out.x0_mm / std::cos((in.c_deg[i] - out.c0_deg) * rad_per_deg);
      out.max_residual_mm = std::max(out.max_residual_mm, std::abs(in.x_mm[i] - line_mm));
    }
    return out;
  });
}

EngagedArc polygon_engagement(const BlankAtAngle& in) {
  return guarded<&polygon_engagement>(in, [&] {
    require_blank(in);
    const Arc arc = engaged_arc(Contour(in).at(in.c_deg), in.cutter_radius_mm, in.blank_radius_mm);
    if (!(arc.exit_rad > arc.start_rad)) return EngagedArc{0, 0, 0, 0};
    return EngagedArc{arc.start_rad / rad_per_deg, arc.exit_rad / rad_per_deg,
                      in.cutter_radius_mm * (std::cos(arc.start_rad) - std::cos(arc.exit_rad)), 1};
  });
}

MillingForce peak_milling_force(const ToothLoadCut& in) {
  return guarded<&peak_milling_force>(in, [&] {
    if (in.exit_angle_deg <= in.start_angle_deg) return MillingForce{0, 0, 0};
    const double start = in.start_angle_deg * rad_per_deg, exit = in.exit_angle_deg * rad_per_deg;
    const SinePowerIntegral integral(1 - in.mc);
    const double lag = helix_lag_rad(in.axial_depth_mm, in.helix_deg, in.cutter_radius_mm);
    const ToothLoad load{integral, start, exit, lag, in.teeth};
    const double unit_n = in.kc11_mpa * in.axial_depth_mm * std::pow(in.feed_per_tooth_mm, 1 - in.mc);
    const bool over_top = in.start_angle_deg <= 90 && in.exit_angle_deg >= 90;
    return MillingForce{unit_n * load.peak(), unit_n * load.mean(),
                        in.feed_per_tooth_mm * (over_top ? 1 : std::max(std::sin(start), std::sin(exit)))};
  });
}

StabilizedFeed stabilized_path_feed(const CutAtAngle& in) {
  return guarded<&stabilized_path_feed>(in, [&] {
    require_feed_order(in);
    const Contour::Place place = Contour(in).at(in.c_deg);
    const Arc arc = engaged_arc(place, in.cutter_radius_mm, in.blank_radius_mm);
    const double unit_n = unit_peak_n(in, SinePowerIntegral(1 - in.mc), arc);
    const LimitedFeed feed = limited_feed(in, unit_n, place);
    return StabilizedFeed{feed.feed_mm_min, force_at_feed_n(in, unit_n, feed.feed_mm_min),
                          feed.feed_mm_min * std::abs(std::sin(place.chi_rad)),
                          feed.feed_mm_min * std::cos(place.chi_rad) / place.x_mm / rad_per_deg, feed.by};
  });
}

PolygonTime polygon_milling_time(const PolygonPass& in) {
  return guarded<&polygon_milling_time>(in, [&] {
    require_feed_order(in);
    const Contour contour(in);
    const SinePowerIntegral integral(1 - in.mc);
    constexpr int midpoints = 100;
    struct Step {
      Contour::Place place;
      double length_mm;
      double unit_n;
    };
    std::vector<Step> steps;
    const double half_pivot = pi / static_cast<double>(in.faces);
    for (int k = 0; k < midpoints; ++k) {
      const double share = (2 * k + 1.0) / midpoints - 1;  // -1 to 1
      steps.push_back(
          {contour.on_flat(share * contour.half_face_mm()), 2 * contour.half_face_mm() / midpoints, 0});
      steps.push_back(
          {contour.on_corner(share * half_pivot), in.cutter_radius_mm * 2 * half_pivot / midpoints, 0});
    }
    double worst_unit_n = 0;
    for (Step& step : steps) {
      step.unit_n =
          unit_peak_n(in, integral, engaged_arc(step.place, in.cutter_radius_mm, in.blank_radius_mm));
      worst_unit_n = std::max(worst_unit_n, step.unit_n);
    }
    double constant_mm_min = std::numeric_limits<double>::infinity();
    for (const Step& step : steps)
      constant_mm_min = std::min(constant_mm_min, limited_feed(in, worst_unit_n, step.place).feed_mm_min);

    constexpr double most = std::numeric_limits<double>::infinity();
    PolygonTime out{0, 0, most, 0, 0, most};
    for (const Step& step : steps) {
      const double feed_mm_min = in.strategy == FeedStrategy::constant
                                     ? constant_mm_min
                                     : limited_feed(in, step.unit_n, step.place).feed_mm_min;
      const double force_n = force_at_feed_n(in, step.unit_n, feed_mm_min);
      out.loop_time_min += step.length_mm / feed_mm_min;
      out.feed_low_mm_min = std::min(out.feed_low_mm_min, feed_mm_min);
      out.feed_high_mm_min = std::max(out.feed_high_mm_min, feed_mm_min);
      out.peak_force_high_n = std::max(out.peak_force_high_n, force_n);
      out.peak_force_low_n = std::min(out.peak_force_low_n, force_n);
    }
    out.loop_time_min *= static_cast<double>(in.faces);
    out.main_time_min =
        static_cast<double>(in.axial_passes) * (out.loop_time_min + in.approach_mm / out.feed_low_mm_min);
    return out;
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K301",
       .title = "Control of milling of polyhedrons on lathes with CNC",
       .authors = "Petrakov Yu. V., Klavak A. M.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A polygon is milled from a round blank on a turning centre with an end mill parallel to the "
           "spindle. The contour feed is recovered from the NC program, the force maxima of the tooth passes "
           "are found, and the feed is chosen so that they stay constant.",
       .role = "milling",
       .errata = {
           "Eq. (2): the denominator is printed dc/dc; dx/dc is meant.",
           "The printed F words are not radial feeds: read as C rates in deg/min they give a constant "
           "contour "
           "feed of 300 mm/min. The increase in the middle of the face that the paper reports comes from "
           "reading them as radial feeds.",
           "Eq. (6) gives a radial feed of zero in the middle of every face and corner, where the cutter "
           "must "
           "keep moving: use a C rate or inverse time as the F word."}});

  const auto polygon = [](auto& f) {
    f.input(&Polygon::faces, "faces", "N", "1", at_least(3), "number of faces", 6)
        .input(&Polygon::apothem_mm, "apothem_mm", "a", "mm", positive(),
               "distance of a face from the axis (half of across flats)", 21.65)
        .input(&Polygon::cutter_radius_mm, "cutter_radius_mm", "R", "mm", positive(), "radius of the cutter",
               8.0);
  };
  const auto blank = [&](auto& f) {
    f.with(polygon).input(&RoundBlank::blank_radius_mm, "blank_radius_mm", "R_b", "mm", positive(),
                          "radius of the blank, not below the apothem", 25.0);
  };
  const auto c_of = [](auto pointer) {
    return [pointer](auto& f) {
      f.input(pointer, "c_deg", "c", "deg", any(), "part angle from the middle of a face", -20.0);
    };
  };

  source
      .function<&polygon_contour_summary>("polygon_contour_summary",
                                          "Extremes, length and area of the polygon contour.",
                                          "derived, Fig. 1", Provenance::completion)
      .with(polygon)
      .output(&ContourSummary::vertex_radius_mm, "vertex_radius_mm", "rho", "mm", positive(),
              "distance of a vertex from the axis")
      .output(&ContourSummary::flat_half_angle_deg, "flat_half_angle_deg", "theta_1", "deg", open(0, 90),
              "c at which the straight part ends")
      .output(&ContourSummary::x_min_mm, "x_min_mm", "d", "mm", positive(), "smallest x of the cutter centre")
      .output(&ContourSummary::x_max_mm, "x_max_mm", "-", "mm", positive(), "largest x of the cutter centre")
      .output(&ContourSummary::path_length_mm, "path_length_mm", "L", "mm", positive(),
              "length of the path of the cutter centre")
      .output(&ContourSummary::polygon_area_mm2, "polygon_area_mm2", "A", "mm2", positive(),
              "area of the polygon");
  source
      .function<&polygon_contour_point>("polygon_contour_point", "Cutter centre at a part angle.",
                                        "derived, Fig. 1", Provenance::completion)
      .with(polygon)
      .with(c_of(&PolygonAtAngle::c_deg))
      .output(&ContourPoint::x_mm, "x_mm", "x", "mm", positive(), "distance of the axes")
      .output(&ContourPoint::dx_dc_mm_rad, "dx_dc_mm_rad", "dx/dc", "mm/rad", any(), "its derivative")
      .output(&ContourPoint::chi_deg, "chi_deg", "chi", "deg", closed(-90, 90),
              "from the part axis to the contact, at the cutter centre, positive forward")
      .output(&ContourPoint::on_corner, "on_corner", "-", "1", closed(0, 1),
              "1: the cutter pivots about a vertex");
  source
      .function<&verify_gcode_feed>("verify_gcode_feed",
                                    "Contour feed of an NC program, F words read as radial feeds.",
                                    "eqs. (1)-(3)", Provenance::repaired)
      .input(&NcProgram::x_mm, "x_mm", "X", "mm", positive(), "X words",
             Value::List{66.69, 64.9, 63.52, 62.56, 62.05})
      .length(2, 100'000)
      .input(&NcProgram::c_deg, "c_deg", "C", "deg", any(), "C words",
             Value::List{-98.302, -102.689, -107.293, -112.068, -116.955})
      .length(2, 100'000)
      .input(&NcProgram::f_word, "f_word", "F", "mm/min", positive(),
             "radial feed of each block, the modal value carried on",
             Value::List{232.1, 246.3, 258.6, 258.6, 274.6})
      .length(2, 100'000)
      .optional(&NcProgram::x_is_diameter, "x_is_diameter", "-", "-", no_range(),
                "X words are diameters (halves x, not F)")
      .output(&NcFeeds::dx_dc_mm_rad, "dx_dc_mm_rad", "dx/dc", "mm/rad", any(), "slope, of the radius")
      .output(&NcFeeds::c_rate_deg_min, "c_rate_deg_min", "omega_c", "deg/min", positive(), "rate of C")
      .output(&NcFeeds::path_feed_mm_min, "path_feed_mm_min", "F_e", "mm/min", positive(), "contour feed")
      .note("Many controls take F as a C rate or vector feed: see block_path_feed.");
  source
      .function<&radial_feed_for_path_feed>("radial_feed_for_path_feed",
                                            "Radial feed and C rate for a contour feed.", "eqs. (6), (2)",
                                            Provenance::repaired)
      .input(&PathFeed::path_feed_mm_min, "path_feed_mm_min", "F_e", "mm/min", positive(), "contour feed",
             300.0)
      .input(&PathFeed::x_mm, "x_mm", "x", "mm", positive(), "distance of the axes", 62.0)
      .input(&PathFeed::dx_dc_mm_rad, "dx_dc_mm_rad", "dx/dc", "mm/rad", any(), "its derivative", 10.0)
      .output(&AxisFeeds::radial_feed_mm_min, "radial_feed_mm_min", "F_x", "mm/min", non_negative(),
              "feed of X")
      .output(&AxisFeeds::c_rate_deg_min, "c_rate_deg_min", "omega_c", "deg/min", positive(), "rate of C");
  source
      .function<&tooth_pass_maxima>("tooth_pass_maxima", "Largest force of every tooth pass.", "eq. (4)",
                                    Provenance::paper)
      .input(&ForceRecord::c_deg, "c_deg", "c", "deg", any(), "part angles of the record",
             Value::List{0.0, 1.0, 2.0, 3.0})
      .length(1, 1'000'000)
      .input(&ForceRecord::force_n, "force_n", "P_o", "N", any(), "tangential force",
             Value::List{4.0, 9.0, 9.0, 1.0})
      .length(1, 1'000'000)
      .input(&ForceRecord::start_index, "start_index", "k_1", "1", non_negative(),
             "first point of each pass, from 0", Value::List{0, 3})
      .input(&ForceRecord::end_index, "end_index", "k_2", "1", non_negative(), "last point of each pass",
             Value::List{3, 3})
      .output(&PassMaxima::c_at_max_deg, "c_at_max_deg", "c", "deg", any(),
              "where the maximum stands (first)")
      .output(&PassMaxima::max_force_n, "max_force_n", "P_m", "N", any(), "largest force");
  const auto block = [](auto& f) {
    f.input(&BlockMove::x1_mm, "x1_mm", "X_1", "mm", positive(), "X at the start", 62.0)
        .input(&BlockMove::c1_deg, "c1_deg", "C_1", "deg", any(), "C at the start", 10.0)
        .input(&BlockMove::x2_mm, "x2_mm", "X_2", "mm", positive(), "X at the end", 63.5)
        .input(&BlockMove::c2_deg, "c2_deg", "C_2", "deg", any(), "C at the end", 14.0);
  };
  const auto block_mode = [](auto& f) {
    f.input(&BlockMove::mode, "mode", "-", "-", no_range(),
            "F in mm/min of radial travel, deg/min of C, or 1/min", "c_rate")
        .optional(&BlockMove::x_is_diameter, "x_is_diameter", "-", "-", no_range(), "X words are diameters");
  };
  source
      .function<&block_path_feed>("block_path_feed", "Contour feed of one NC block.", "completion",
                                  Provenance::completion)
      .with(block)
      .input(&NcBlock::f_word, "f_word", "F", "per mode", positive(), "feed word", 258.6)
      .with(block_mode)
      .output(&BlockFeed::chord_mm, "chord_mm", "l", "mm", non_negative(),
              "length of the block in the frame of the part")
      .output(&BlockFeed::path_feed_mm_min, "path_feed_mm_min", "F_e", "mm/min", non_negative(),
              "contour feed");
  source
      .function<&feed_word_for_block>("feed_word_for_block", "F word that gives a contour feed.",
                                      "completion", Provenance::completion)
      .with(block)
      .input(&FeedForBlock::path_feed_mm_min, "path_feed_mm_min", "F_e", "mm/min", positive(), "contour feed",
             300.0)
      .with(block_mode)
      .output(&FeedWord::f_word, "f_word", "F", "per mode", non_negative(), "feed word");
  source
      .function<&gcode_flat_fit>("gcode_flat_fit", "Face that the points of an NC program lie on.",
                                 "completion", Provenance::completion)
      .input(&FlatPoints::x_mm, "x_mm", "X", "mm", positive(), "X words",
             Value::List{133.373, 129.803, 127.035, 125.12, 124.099, 123.99})
      .length(2, 100'000)
      .input(&FlatPoints::c_deg, "c_deg", "C", "deg", any(), "C words",
             Value::List{-98.302, -102.689, -107.293, -112.068, -116.955, -121.885})
      .length(2, 100'000)
      .output(&FlatFit::x0_mm, "x0_mm", "X_0", "mm", positive(),
              "a + R, or twice that in diameter programming")
      .output(&FlatFit::c0_deg, "c0_deg", "c_0", "deg", closed(-180, 180), "direction of the face normal")
      .output(&FlatFit::max_residual_mm, "max_residual_mm", "-", "mm", non_negative(), "largest misfit of X");
  source
      .function<&polygon_engagement>("polygon_engagement", "Engaged arc of the cutter in a round blank.",
                                     "completion C1", Provenance::completion)
      .with(blank)
      .with(c_of(&BlankAtAngle::c_deg))
      .output(&EngagedArc::start_angle_deg, "start_angle_deg", "phi_start", "deg", closed(0, 180),
              "start of the arc, from the contact with the finished contour")
      .output(&EngagedArc::exit_angle_deg, "exit_angle_deg", "phi_exit", "deg", closed(0, 180),
              "end of the arc")
      .output(&EngagedArc::radial_width_mm, "radial_width_mm", "a_e", "mm", non_negative(),
              "radial width of cut")
      .output(&EngagedArc::in_cut, "in_cut", "-", "1", closed(0, 1), "1 in cut, 0 (and zeros) out of cut")
      .note(
          "An exit angle of 180 deg over the middle of a face leaves an outer ring: another pass is needed.");
  const auto cutter = [](auto& f) {
    using In = ForceLimitedCut;
    f.input(&In::axial_depth_mm, "axial_depth_mm", "B", "mm", positive(), "axial depth of one pass", 10.0)
        .input(&In::teeth, "teeth", "z", "1", closed(1, 200), "number of teeth", 4)
        .input(&In::helix_deg, "helix_deg", "lambda", "deg", closed(0, 60), "helix angle", 30.0)
        .input(&In::rpm, "rpm", "n", "rpm", positive(), "speed of the cutter", 1200.0)
        .input(&In::kc11_mpa, "kc11_mpa", "k_c1.1", "MPa", positive(), "specific cutting force at 1 mm chip",
               1700.0)
        .input(&In::mc, "mc", "m_c", "1", open_high(0, 1), "exponent of the chip thickness", 0.25)
        .input(&In::force_limit_n, "force_limit_n", "P_lim", "N", positive(), "largest allowed peak force",
               900.0)
        .input(&In::feed_min_mm_min, "feed_min_mm_min", "F_min", "mm/min", positive(),
               "smallest contour feed", 20.0)
        .input(&In::feed_max_mm_min, "feed_max_mm_min", "F_max", "mm/min", positive(), "largest contour feed",
               600.0)
        .input(&In::x_rate_max_mm_min, "x_rate_max_mm_min", "-", "mm/min", positive(), "largest rate of X",
               10000.0)
        .input(&In::c_rate_max_deg_min, "c_rate_max_deg_min", "-", "deg/min", positive(), "largest rate of C",
               7200.0);
  };
  source
      .function<&peak_milling_force>("peak_milling_force",
                                     "Peak and mean tangential force of a helical cutter over an arc.",
                                     "completion C2 (Kienzle)", Provenance::completion)
      .input(&ToothLoadCut::start_angle_deg, "start_angle_deg", "phi_start", "deg", closed(0, 180),
             "start of the arc, from zero chip", 0.0)
      .input(&ToothLoadCut::exit_angle_deg, "exit_angle_deg", "phi_exit", "deg", closed(0, 180),
             "end of the arc", 60.0)
      .input(&ToothLoadCut::feed_per_tooth_mm, "feed_per_tooth_mm", "f_z", "mm", positive(), "feed per tooth",
             0.05)
      .input(&ToothLoadCut::axial_depth_mm, "axial_depth_mm", "B", "mm", positive(), "axial depth", 10.0)
      .input(&ToothLoadCut::cutter_radius_mm, "cutter_radius_mm", "R", "mm", positive(),
             "radius of the cutter", 10.0)
      .input(&ToothLoadCut::teeth, "teeth", "z", "1", closed(1, 200), "number of teeth", 4)
      .input(&ToothLoadCut::helix_deg, "helix_deg", "lambda", "deg", closed(0, 60), "helix angle", 30.0)
      .input(&ToothLoadCut::kc11_mpa, "kc11_mpa", "k_c1.1", "MPa", positive(),
             "specific cutting force at 1 mm chip", 1700.0)
      .input(&ToothLoadCut::mc, "mc", "m_c", "1", open_high(0, 1), "exponent of the chip thickness", 0.25)
      .output(&MillingForce::peak_force_n, "peak_force_n", "P", "N", non_negative(),
              "largest over one tooth pitch")
      .output(&MillingForce::mean_force_n, "mean_force_n", "-", "N", non_negative(), "mean")
      .output(&MillingForce::max_chip_mm, "max_chip_mm", "-", "mm", non_negative(), "largest chip thickness")
      .note("Kienzle's constants are the user's; typical structural steel 1700 MPa and 0.25.");
  source
      .function<&stabilized_path_feed>("stabilized_path_feed",
                                       "Contour feed that keeps the peak force at its limit.",
                                       "completion C3", Provenance::completion)
      .with(blank)
      .with(cutter)
      .with(c_of(&CutAtAngle::c_deg))
      .output(&StabilizedFeed::path_feed_mm_min, "path_feed_mm_min", "F_e", "mm/min", positive(),
              "contour feed")
      .output(&StabilizedFeed::peak_force_n, "peak_force_n", "P", "N", non_negative(), "peak force at it")
      .output(&StabilizedFeed::radial_feed_mm_min, "radial_feed_mm_min", "F_x", "mm/min", non_negative(),
              "feed of X")
      .output(&StabilizedFeed::c_rate_deg_min, "c_rate_deg_min", "omega_c", "deg/min", positive(),
              "rate of C")
      .output(&StabilizedFeed::limited_by, "limited_by", "-", "-", no_range(),
              "the last bound that changed the feed")
      .note("At feed_min the force limit may be exceeded; axis limits always hold.");
  source
      .function<&polygon_milling_time>("polygon_milling_time",
                                       "Main time of a polygon, with constant or stabilised feed.",
                                       "completion C4", Provenance::completion)
      .with(blank)
      .with(cutter)
      .input(&PolygonPass::strategy, "strategy", "-", "-", no_range(), "feed strategy", "stabilized")
      .optional(&PolygonPass::axial_passes, "axial_passes", "n_ax", "1", at_least(1),
                "number of axial passes")
      .optional(&PolygonPass::approach_mm, "approach_mm", "A_p", "mm", non_negative(),
                "approach of each pass at the lowest feed")
      .output(&PolygonTime::loop_time_min, "loop_time_min", "T_loop", "min", positive(),
              "one turn around the part")
      .output(&PolygonTime::main_time_min, "main_time_min", "T", "min", positive(), "main time")
      .output(&PolygonTime::feed_low_mm_min, "feed_low_mm_min", "F_low", "mm/min", positive(),
              "lowest contour feed")
      .output(&PolygonTime::feed_high_mm_min, "feed_high_mm_min", "-", "mm/min", positive(),
              "highest contour feed")
      .output(&PolygonTime::peak_force_high_n, "peak_force_high_n", "-", "N", non_negative(),
              "largest peak force")
      .output(&PolygonTime::peak_force_low_n, "peak_force_low_n", "-", "N", non_negative(),
              "smallest peak force; 0 out of cut")
      .note("The plunge into the full blank in the first loop is not modelled beyond the approach.");
}

}  // namespace verstat::models::k301
