// Toolpaths, times and the NC program of K412.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "models/toolpath/straightening_roll_contour.h"

namespace verstat::models::k412 {
namespace {

constexpr double most_passes = 10'000;

// ceil that forgives the rounding of a whole quotient.
double whole_passes(double stock_mm, double depth_mm, std::string_view input) {
  const double passes = std::max(0.0, std::ceil(stock_mm / depth_mm - 1e-9));
  require(passes <= most_passes, input, depth_mm, "asks for more than 10000 passes");
  return passes;
}

// Constant surface speed, capped at the largest spindle speed.
struct SurfaceSpeed {
  double feed_mm_rev, speed_m_min, max_rpm;

  [[nodiscard]] double cap_radius_mm() const { return 1000 * speed_m_min / (2 * std::numbers::pi * max_rpm); }
  // Exact for a straight segment: the spindle speed falls with the mean radius.
  [[nodiscard]] double minutes(double length_mm, double from_radius_mm, double to_radius_mm) const {
    const double cap = cap_radius_mm();
    const double small = std::min(from_radius_mm, to_radius_mm);
    const double large = std::max(from_radius_mm, to_radius_mm);
    const double capped = large <= cap ? 1 : small >= cap ? 0 : (cap - small) / (large - small);
    const double mean_free = (std::max(small, cap) + large) / 2;
    return length_mm / feed_mm_rev *
           (capped / max_rpm + (1 - capped) * 2 * std::numbers::pi * mean_free / (1000 * speed_m_min));
  }
  [[nodiscard]] double minutes(std::span<const ContourPoint> contour) const {
    double time = 0;
    for (std::size_t k = 1; k < contour.size(); ++k)
      time += minutes(contour_length_mm(contour.subspan(k - 1, 2)), contour[k - 1].radius_mm,
                      contour[k].radius_mm);
    return time;
  }
};

double axial_extent_mm(std::span<const ContourPoint> contour) {
  const auto [least, largest] = std::minmax_element(
      contour.begin(), contour.end(),
      [](const ContourPoint& a, const ContourPoint& b) { return a.axial_mm < b.axial_mm; });
  return largest->axial_mm - least->axial_mm;
}

// printf %.3f without a minus before zero.
std::string millimetres(double x) {
  const std::string text = fmt::format("{:.3f}", x);
  return text == "-0.000" ? "0.000" : text;
}

}  // namespace

Length path_length(const Contour& in) {
  return guarded<&path_length>(in, [&] { return Length{contour_length_mm(checked(in))}; });
}

Contour offset_contour(const OffsetInput& in) {
  return guarded<&offset_contour>(in,
                                  [&] { return to_lists(offset_contour_mitred(checked(in), in.offset_mm)); });
}

PassTime contour_pass_time(const PassInput& in) {
  return guarded<&contour_pass_time>(in, [&] {
    const TurnedContour contour = checked(in);
    const double length_mm = contour_length_mm(contour) + in.approach_mm + in.overrun_mm;
    if (in.mode == SpindleMode::rpm) {
      require(in.rpm > 0, "n_rpm", in.rpm, "must be positive in mode \"rpm\"");
      return PassTime{length_mm, length_mm / (in.feed_mm_rev * in.rpm)};
    }
    require(in.speed_m_min > 0, "v_m_min", in.speed_m_min, "must be positive in mode \"css\"");
    require(in.max_rpm > 0, "n_max_rpm", in.max_rpm, "must be positive in mode \"css\"");
    const SurfaceSpeed speed{in.feed_mm_rev, in.speed_m_min, in.max_rpm};
    const double first = contour.front().radius_mm;
    const double last = contour.back().radius_mm;
    return PassTime{length_mm, speed.minutes(in.approach_mm, first, first) + speed.minutes(contour) +
                                   speed.minutes(in.overrun_mm, last, last)};
  });
}

RoughPlan rough_turning_plan(const RoughTurning& in) {
  return guarded<&rough_turning_plan>(in, [&] {
    const TurnedContour base =
        offset_contour_mitred(checked(in), in.finish_allowance_mm + in.grind_allowance_mm);
    const auto [least, largest] = std::minmax_element(
        base.begin(), base.end(),
        [](const ContourPoint& a, const ContourPoint& b) { return a.radius_mm < b.radius_mm; });
    const double cylinder_mm = largest->radius_mm;
    const double extent_mm = axial_extent_mm(base);
    const double stock_mm = in.blank_diameter_mm / 2 - cylinder_mm;
    require(stock_mm >= -1e-9 * cylinder_mm, "D_blank_mm", in.blank_diameter_mm,
            fmt::format("must not be below the largest diameter with allowances, {:.6g}", 2 * cylinder_mm));
    const SurfaceSpeed speed{in.feed_mm_rev, in.speed_m_min, in.max_rpm};
    RoughPlan plan{};
    plan.cylinder_diameter_mm = 2 * cylinder_mm;

    const double cylinder_passes = whole_passes(stock_mm, in.max_depth_mm, "depth_max_mm");
    const double stroke_mm = extent_mm + in.approach_mm + in.overrun_mm;
    plan.cylinder_passes = static_cast<std::int64_t>(cylinder_passes);
    plan.cylinder_depth_mm = cylinder_passes > 0 ? stock_mm / cylinder_passes : 0;
    for (double k = 0; k < cylinder_passes; ++k) {
      const double radius_mm = in.blank_diameter_mm / 2 - k * plan.cylinder_depth_mm;  // before the cut
      plan.cylinder_time_min += speed.minutes(stroke_mm, radius_mm, radius_mm);
      plan.rapid_time_min += stroke_mm / in.rapid_mm_min;
    }
    plan.main_time_min = plan.cylinder_time_min;
    plan.cut_length_mm = cylinder_passes * stroke_mm;

    const double profile_mm = cylinder_mm - least->radius_mm;
    const double contour_passes = whole_passes(profile_mm, in.max_depth_mm, "depth_max_mm");
    plan.contour_passes = static_cast<std::int64_t>(contour_passes);
    plan.contour_depth_mm = contour_passes > 0 ? profile_mm / contour_passes : 0;
    for (double j = contour_passes - 1; j >= 0; --j) {
      double length_mm = 0;
      const TurnedContour path = offset_contour_mitred(base, j * plan.contour_depth_mm);
      for (const TurnedContour& piece : pieces_below(path, cylinder_mm)) {
        length_mm += contour_length_mm(piece);
        plan.main_time_min += speed.minutes(piece);
        plan.rapid_time_min += axial_extent_mm(piece) / in.rapid_mm_min;
      }
      plan.contour_lengths_mm.push_back(length_mm);
      plan.cut_length_mm += length_mm;
    }
    plan.removed_cm3 = (std::numbers::pi / 4 * in.blank_diameter_mm * in.blank_diameter_mm * extent_mm -
                        revolved_volume_mm3(base)) /
                       1000;
    return plan;
  });
}

FacingTime facing_time(const Facing& in) {
  return guarded<&facing_time>(in, [&] {
    require(in.inner_diameter_mm < in.outer_diameter_mm, "D_inner_mm", in.inner_diameter_mm,
            "must be below D_outer_mm");
    const SurfaceSpeed speed{in.feed_mm_rev, in.speed_m_min, in.max_rpm};
    const double outer = in.outer_diameter_mm / 2;
    const double inner = in.inner_diameter_mm / 2;
    const double passes = whole_passes(in.allowance_mm, in.max_depth_mm, "depth_max_mm");
    return FacingTime{
        static_cast<std::int64_t>(passes),
        passes * (speed.minutes(outer - inner, outer, inner) + speed.minutes(in.approach_mm, outer, outer))};
  });
}

Volume revolve_volume(const Contour& in) {
  return guarded<&revolve_volume>(in, [&] { return Volume{revolved_volume_mm3(checked(in)) / 1000}; });
}

PartTime roll_part_time(const OperationTimes& in) {
  return guarded<&roll_part_time>(in, [&] {
    const auto setups = static_cast<double>(in.setups);
    const double main_min = in.rough_main_min + in.finish_main_min + in.facing_main_min + in.grind_main_min;
    const double piece_min = main_min + in.rough_rapid_min + setups * in.handling_min;
    return PartTime{main_min, piece_min,
                    piece_min + (setups * in.setup_min + in.programming_min) / static_cast<double>(in.batch)};
  });
}

Program gcode_contour(const ProgramInput& in) {
  return guarded<&gcode_contour>(in, [&] {
    const TurnedContour contour = checked(in);
    Program out;
    int block = 0;
    const auto numbered = [&](const std::string& words) {
      block += 10;
      out.lines.push_back(fmt::format("N{} {}", block, words));
    };
    const auto rounded = [](double x) { return std::floor(x + 0.5); };  // halves up
    const auto place = [](const ContourPoint& p) {
      return fmt::format("G01 X{} Z{}", millimetres(2 * p.radius_mm), millimetres(p.axial_mm));
    };
    out.lines = {"%", fmt::format("O{:04}", in.program)};
    numbered("G21 G18 G40 G95");
    numbered(fmt::format("T{0:02}{0:02}", in.tool));
    numbered(fmt::format("G50 S{:.0f}", rounded(in.max_rpm)));
    numbered(fmt::format("G96 S{:.0f} M03", rounded(in.speed_m_min)));
    numbered(fmt::format("G00 X{} Z{}", millimetres(2 * (contour.front().radius_mm + in.clearance_mm)),
                         millimetres(contour.front().axial_mm - in.clearance_mm)));
    double largest_mm = 0;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      numbered(place(contour[k]) + (k == 0 ? " F" + millimetres(in.feed_mm_rev) : ""));
      largest_mm = std::max(largest_mm, contour[k].radius_mm);
    }
    numbered("G00 X" + millimetres(2 * (largest_mm + in.clearance_mm)));
    numbered("M05");
    numbered("M30");
    out.lines.emplace_back("%");
    return out;
  });
}

}  // namespace verstat::models::k412
