// K109: the paper's formulas and the exact reliability of one mission.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/solve.h"
#include "models/reliability/detail/k109_chain.h"
#include "models/reliability/detail/k109_local.h"
#include "models/reliability/k109_face_mill_replacement.h"

namespace verstat::models::k109 {
namespace {

// A target counts as met within rounding (card, Functions).
constexpr double met = 1e-12;

void require_allowed(std::int64_t failed_allowed, std::int64_t teeth) {
  require(failed_allowed < teeth, "failed_allowed", failed_allowed, "must be below z");
}

double chain_reliability(std::int64_t teeth, std::int64_t now, std::int64_t allowed, double alpha,
                         double exposure) {
  if (now > allowed) return 0;
  return std::min(1.0, detail::run_chain(detail::stage_rates(teeth, now, allowed, alpha), exposure).alive());
}

}  // namespace

MillReliability mill_reliability_paper(const MillPaper& in) {
  return guarded<&mill_reliability_paper>(in, [&] {
    require(in.m <= in.teeth, "m", in.m, "must not be above z");
    const double chain = std::pow(in.r_tooth, static_cast<double>(in.teeth));
    return MillReliability{-std::expm1(static_cast<double>(in.m + 1) * std::log1p(-chain))};
  });
}

RequiredM required_m_paper(const MillTarget& in) {
  return guarded<&required_m_paper>(in, [&] {
    const double chain = std::pow(in.r_tooth, static_cast<double>(in.teeth));
    require(chain > 0, "r_tooth", in.r_tooth, "is too small: r_tooth^z underflows to 0");
    RequiredM out{};
    out.m_real = std::log1p(-in.r_mill) / std::log1p(-chain) - 1;
    const double m = std::clamp(std::ceil(out.m_real - 1e-9), 0.0, 1e9);
    out.m = static_cast<std::int64_t>(m);
    out.replace_at_failed = std::clamp<std::int64_t>(in.teeth - out.m, 1, in.teeth);
    out.feasible = out.m <= in.teeth - 1;
    return out;
  });
}

ToothReliability required_tooth_reliability_paper(const MillTargetPaper& in) {
  return guarded<&required_tooth_reliability_paper>(in, [&] {
    require(in.m <= in.teeth, "m", in.m, "must not be above z");
    const double chain = -std::expm1(std::log1p(-in.r_mill) / static_cast<double>(in.m + 1));
    return ToothReliability{std::pow(chain, 1 / static_cast<double>(in.teeth))};
  });
}

Score property_score(const Property& in) {
  return guarded<&property_score>(
      in, [&] { return Score{in.higher_is_better ? in.value / in.reference : in.reference / in.value}; });
}

Quality quality_level(const Scores& in) {
  return guarded<&quality_level>(in, [&] {
    require(in.weights.size() == in.scores.size(), "weights", static_cast<std::int64_t>(in.weights.size()),
            "is their number: must be as many as scores");
    double sum = 0;
    double weights = 0;
    for (std::size_t k = 0; k < in.scores.size(); ++k) {
      sum += in.weights[k] * in.scores[k];
      weights += in.weights[k];
    }
    require(weights > 0, "weights", weights, "is their sum: must be above 0");
    return Quality{sum / weights};
  });
}

MillReliability mill_reliability_binomial(const MillBinomial& in) {
  return guarded<&mill_reliability_binomial>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    const auto z = static_cast<double>(in.teeth);
    double sum = 0;
    double choose = 1;
    for (std::int64_t j = 0; j <= in.failed_allowed; ++j) {
      const auto failed = static_cast<double>(j);
      sum += choose * std::pow(1 - in.r_tooth, failed) * std::pow(in.r_tooth, z - failed);
      choose *= (z - failed) / (failed + 1);
    }
    return MillReliability{std::min(1.0, sum)};
  });
}

LoadFactor load_factor(const Load& in) {
  return guarded<&load_factor>(in, [&] {
    require(in.failed < in.teeth, "failed", in.failed, "must be below z");
    return LoadFactor{detail::load_factor(in.teeth, in.failed, in.alpha)};
  });
}

FailedTeethPmf failed_teeth_pmf(const MillMission& in) {
  return guarded<&failed_teeth_pmf>(in, [&] {
    detail::Occupancy end =
        detail::run_chain(detail::stage_rates(in.teeth, 0, in.teeth - 1, in.alpha), -std::log(in.r_tooth));
    end.stage.push_back(end.absorbed);
    return FailedTeethPmf{std::move(end.stage)};
  });
}

MillReliability mill_reliability_load_sharing(const MillSharing& in) {
  return guarded<&mill_reliability_load_sharing>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    return MillReliability{
        chain_reliability(in.teeth, 0, in.failed_allowed, in.alpha, -std::log(in.r_tooth))};
  });
}

MillReliability mill_reliability_local_sharing(const MillSharing& in) {
  return guarded<&mill_reliability_local_sharing>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    const detail::LocalSharing states(static_cast<int>(in.teeth), static_cast<int>(in.failed_allowed),
                                      in.alpha);
    return MillReliability{states.reliability(-std::log(in.r_tooth))};
  });
}

MillReliability mission_reliability_from_state(const MissionFromState& in) {
  return guarded<&mission_reliability_from_state>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    require(in.failed_now <= in.teeth, "failed_now", in.failed_now, "must not be above z");
    return MillReliability{
        chain_reliability(in.teeth, in.failed_now, in.failed_allowed, in.alpha, -std::log(in.r_tooth))};
  });
}

RequiredFailedAllowed required_failed_allowed(const MissionTarget& in) {
  return guarded<&required_failed_allowed>(in, [&] {
    RequiredFailedAllowed out{};
    for (std::int64_t allowed = 0; allowed < in.teeth && !out.feasible; ++allowed) {
      out.failed_allowed = allowed;
      out.replace_at_failed = allowed + 1;
      out.r_mill_achieved = chain_reliability(in.teeth, 0, allowed, in.alpha, -std::log(in.r_tooth));
      out.feasible = out.r_mill_achieved >= in.r_mill_target - met;
    }
    return out;
  });
}

ControlLimit control_limit(const ControlTarget& in) {
  return guarded<&control_limit>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    const double exposure = -std::log(in.r_tooth);
    const auto start_with = [&](std::int64_t failed) {
      return chain_reliability(in.teeth, failed, in.failed_allowed, in.alpha, exposure);
    };
    ControlLimit out{};
    out.replace_at_failed = 1;
    out.r_last_admissible = start_with(0);
    out.feasible = out.r_last_admissible >= in.r_mill_target - met;
    // Reliability falls with every tooth that is already gone, so the first miss is the limit.
    while (out.feasible && out.replace_at_failed <= in.failed_allowed) {
      const double next = start_with(out.replace_at_failed);
      if (next < in.r_mill_target - met) break;
      out.r_last_admissible = next;
      ++out.replace_at_failed;
    }
    out.working_at_replacement = in.teeth - out.replace_at_failed;
    return out;
  });
}

ToothReliability required_tooth_reliability(const SharingTarget& in) {
  return guarded<&required_tooth_reliability>(in, [&] {
    require_allowed(in.failed_allowed, in.teeth);
    const std::vector<double> rates = detail::stage_rates(in.teeth, 0, in.failed_allowed, in.alpha);
    const double slowest = *std::min_element(rates.begin(), rates.end());
    // In ln L, and from the smaller of both tails: L spans twenty orders of magnitude.
    const auto excess = [&](double log_exposure) {
      const detail::Occupancy end = detail::run_chain(rates, std::exp(log_exposure));
      return in.r_mill < 0.5 ? end.alive() - in.r_mill : (1 - in.r_mill) - end.absorbed;
    };
    const double exposure = std::exp(find_root(excess, std::log(1e-20), std::log(1001 / slowest), 1e-15));
    return ToothReliability{std::exp(-exposure)};
  });
}

SpindleSpeed spindle_speed(const SpindleIn& in) {
  return guarded<&spindle_speed>(
      in, [&] { return SpindleSpeed{1000 * in.cutting_speed_m_min / (std::numbers::pi * in.diameter_mm)}; });
}

TableFeed table_feed(const TableFeedIn& in) {
  return guarded<&table_feed>(
      in, [&] { return TableFeed{in.feed_per_tooth_mm * static_cast<double>(in.teeth) * in.speed_rpm}; });
}

RemovalRate material_removal_rate(const Removal& in) {
  return guarded<&material_removal_rate>(
      in, [&] { return RemovalRate{in.width_mm * in.depth_mm * in.feed_mm_min / 1000}; });
}

}  // namespace verstat::models::k109
