#include "models/surface/k311_lapping_cycle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "models/surface/lapping_grains.h"

namespace verstat::models::k311 {
namespace {

constexpr double slack_um = 1e-12;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void require_depth_below_grain(const DepthLaw& law, double grain_um) {
  require(law.greatest_um <= grain_um, "t_f", law.greatest_um, "must not be above the grain diameter d");
}

double reset_run_min(const LapReset& in, std::int64_t parts) {
  const double n = static_cast<double>(parts);
  return in.first_min * (1 + in.growth * (n - 1) / 2) + in.preparation_min + in.change_min / n;
}

}  // namespace

LappedState lapping_cycle(const LappingPasses& in) {
  return guarded<&lapping_cycle>(in, [&] {
    require(in.sign != 0, "sign", in.sign, "must be -1 or +1");
    LappedState out{in.radii_um, 0, in.roughness_max_um, in.defect_depth_um, in.allowance_um, in.web_um};
    for (std::size_t pass = 0; pass < in.removals_um.size(); ++pass) {
      const std::vector<double>& removal = in.removals_um[pass];
      if (removal.size() != in.radii_um.size())
        throw DomainError("removals",
                          fmt::format("removals/{} has {} entries, must have one per radius of r, that is {}",
                                      pass, removal.size(), in.radii_um.size()));
      for (std::size_t k = 0; k < removal.size(); ++k)
        out.radii_um[k] += static_cast<double>(in.sign) * removal[k];
      const double depth = mean(removal);
      const double roughness = std::max(out.roughness_max_um - depth, in.roughness_floor_um);
      out.defect_depth_um =
          std::max(out.defect_depth_um + out.roughness_max_um - roughness - depth, in.defect_floor_um);
      out.roughness_max_um = roughness;
      out.allowance_um -= depth;
      out.web_um -= static_cast<double>(in.sides) * depth;
    }
    const auto [least, most] = std::minmax_element(out.radii_um.begin(), out.radii_um.end());
    out.form_deviation_um = *most - *least;
    return out;
  });
}

CycleVerdict cycle_constraints(const CycleState& in) {
  return guarded<&cycle_constraints>(in, [&] {
    CycleVerdict out{};
    out.roughness_ok = in.roughness_max_um <= in.allowance_um + in.roughness_final_um + slack_um;
    out.defect_ok = in.defect_depth_um + in.roughness_max_um <=
                    in.allowance_um + in.defect_final_um + in.roughness_final_um + slack_um;
    out.force_ok = in.force_n <= in.force_max_n;
    out.speed_ok = in.speed_m_min <= in.speed_max_m_min;
    out.ok = out.roughness_ok && out.defect_ok && out.force_ok && out.speed_ok;
    return out;
  });
}

Verdict final_conditions(const FinishedPart& in) {
  return guarded<&final_conditions>(in, [&] {
    return Verdict{in.web_um >= in.web_min_um && in.web_um <= in.web_max_um &&
                   in.form_deviation_um <= in.form_max_um && in.roughness_max_um <= in.roughness_final_um &&
                   in.roughness_ra_um <= in.roughness_ra_max_um && in.defect_depth_um <= in.defect_final_um};
  });
}

Allowance switch_allowance(const ForcedStage& in) {
  return guarded<&switch_allowance>(in, [&] {
    const double roughness = in.roughness_forced_um - in.roughness_final_um;
    return Allowance{std::max({0.0, roughness, roughness + in.defect_forced_um - in.defect_final_um})};
  });
}

StageTimes two_stage_time(const TwoStages& in) {
  return guarded<&two_stage_time>(in, [&] {
    const double forced = std::max(0.0, in.allowance_um - in.allowance_switch_um) / in.rate_forced_um_min;
    const double finish = std::min(in.allowance_um, in.allowance_switch_um) / in.rate_finish_um_min;
    return StageTimes{forced, finish, forced + finish};
  });
}

PieceTime piece_time(const Piece& in) {
  return guarded<&piece_time>(in, [&] {
    return PieceTime{in.allowance_um / in.rate_um_min * in.infeed_factor + in.preparation_min +
                     in.change_min * in.changes / in.parts};
  });
}

PieceCost piece_cost(const PieceExpense& in) {
  return guarded<&piece_cost>(in, [&] {
    const double removed_mm3 = in.allowance_um * 1e-3 * in.width_mm * in.length_mm;
    return PieceCost{in.machine_rate_per_min * in.time_min +
                     in.paste_g_mm3 * removed_mm3 * in.paste_price_per_g +
                     in.changes * in.reset_cost / in.parts};
  });
}

DepthParameters grain_depth_parameters(const GrainSizes& in) {
  return guarded<&grain_depth_parameters>(in, [&] {
    return DepthParameters{in.mean_size_um - in.mean_in_lap_um - in.mean_in_gap_um,
                           std::sqrt(in.sd_in_lap_um * in.sd_in_lap_um + in.sd_in_gap_um * in.sd_in_gap_um +
                                     in.sd_size_um * in.sd_size_um)};
  });
}

Density grain_depth_pdf(const DepthAt& in) {
  return guarded<&grain_depth_pdf>(in,
                                   [&] { return Density{grains::TruncatedNormal(in).density(in.depth_um)}; });
}

Probability non_removal_probability(const GrainContactLevel& in) {
  return guarded<&non_removal_probability>(in, [&] {
    require_depth_below_grain(in, in.grain_um);
    const grains::TruncatedNormal law(in);
    return Probability{std::exp(-grains::sweep_per_um(in) *
                                grains::mean_half_chord_um(law, in.greatest_um - in.level_um, in.grain_um))};
  });
}

LappedRoughness lapped_roughness(const GrainContact& in) {
  return guarded<&lapped_roughness>(in, [&] {
    require_depth_below_grain(in, in.grain_um);
    return grains::roughness(in);
  });
}

LappingForce lapping_force(const LapContact& in) {
  return guarded<&lapping_force>(in, [&] {
    require_depth_below_grain(in, in.grain_um);
    const grains::TruncatedNormal law(in);
    const double count = in.width_mm * in.length_mm * 1e6 / (in.spacing_um * in.spacing_um);
    const double single_n = in.contact_fraction * std::numbers::pi * in.hardness_mpa * 1e-6 *
                            grains::mean_cap_um2(law, in.grain_um);
    return LappingForce{count, count * in.material_probability * single_n};
  });
}

CycleTime cycle_time_with_lap_wear(const LapLife& in) {
  return guarded<&cycle_time_with_lap_wear>(in, [&] {
    require(in.part <= in.parts_per_life, "j", in.part, "must not be above n_life");
    const double share = static_cast<double>(in.part - 1) / static_cast<double>(in.parts_per_life - 1);
    return CycleTime{in.first_min * (1 + (in.ratio - 1) * share)};
  });
}

BestReset best_lap_reset(const LapReset& in) {
  return guarded<&best_lap_reset>(in, [&] {
    // Convex in n: the best whole number stands beside the real minimum.
    const double slope = in.growth * in.first_min;
    const double most = static_cast<double>(in.parts_max);
    const double real = slope > 0 ? std::clamp(std::sqrt(2 * in.change_min / slope), 1.0, most) : most;
    const std::int64_t below = real < most ? static_cast<std::int64_t>(real) : in.parts_max;
    const std::int64_t above = below < in.parts_max ? below + 1 : below;
    const double best = std::min(reset_run_min(in, below), reset_run_min(in, above));
    const auto as_good = [&](std::int64_t n) { return reset_run_min(in, n) <= best + 1e-12; };
    // Smallest n as good as the best: the run time falls up to there.
    std::int64_t low = 0;  // not as good, or below the range
    std::int64_t high = as_good(below) ? below : above;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (as_good(middle) ? high : low) = middle;
    }
    return BestReset{high, reset_run_min(in, high)};
  });
}

RemovalRate preston_rate(const PrestonInputs& in) {
  return guarded<&preston_rate>(
      in, [&] { return RemovalRate{in.coefficient_um_mpa_m * (in.force_n / in.area_mm2) * in.speed_m_min}; });
}

}  // namespace verstat::models::k311
