#include "fit/taylor_report.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using nlohmann::ordered_json;
using scenarios::InputError;

const char* law_name(ErrorLaw law) {
  return law == ErrorLaw::normal ? "lognormal" : "weibull";
}

ordered_json regime_json(const std::array<double, 3>& regime) {
  return {{"cutting_speed_m_min", regime[0]}, {"feed_mm_rev", regime[1]}, {"depth_of_cut_mm", regime[2]}};
}

ordered_json fit_json(const TaylorFit& fit) {
  ordered_json j = {{"law", law_name(fit.law)},
                    {"center", regime_json(fit.center)},
                    {"mean_at_center_min", fit.mean_min(fit.center)},
                    {"median_at_center_min", fit.median_min(fit.center)},
                    {"sigma_ln_life", fit.scatter()},
                    {"sigma_ln_life_maximum_likelihood", fit.regression.sigma},
                    {"cv", fit.cv()},
                    {"degrees_of_freedom", fit.degrees()},
                    {"aicc", number(fit.aicc)}};
  ordered_json exponents = ordered_json::array();
  for (const TaylorExponent& e : fit.exponents) {
    if (e.fitted)
      exponents.push_back(
          {{"factor", e.factor}, {"life_exponent", e.value}, {"bounds", interval_json(e.bounds)}});
    else
      exponents.push_back({{"factor", e.factor}, {"not_fitted", e.why_not}});
  }
  j["exponents"] = exponents;
  ordered_json levels = ordered_json::array();
  for (std::size_t l = 0; l < fit.laboratories.size(); ++l)
    levels.push_back(
        {{"laboratory", fit.laboratories[l]},
         {"life_ratio", l == 0 ? 1.0 : std::exp(fit.regression.coefficients[static_cast<Eigen::Index>(l)])}});
  j["levels"] = levels;
  return j;
}

// Why a scenario cannot hold the fit; empty: it can.
std::string why_not_for_scenario(const TaylorFit& fit) {
  const double mu = fit.exponents[0].value;
  if (!(mu > 1 && mu <= 50))
    return fmt::format(
        "the exponent of the cutting speed is {:.3g}; a scenario wants 1 to 50, so these runs do not give a "
        "Taylor law",
        mu);
  if (!(fit.cv() >= 0.05 && fit.cv() <= 2))
    return fmt::format("the CV of life is {:.3g}; a scenario wants 0.05 to 2", fit.cv());
  return {};
}

// The edge life of a scenario; what stays as the scenario has it is said in `stays`.
ordered_json edge_life_of(const TaylorFit& fit, std::vector<std::string>& stays) {
  const double mu = fit.exponents[0].value;
  if (fit.laboratories.size() > 1)
    stays.push_back(fmt::format("mean_ref_min is the level of laboratory {}, the first of {}",
                                fit.laboratories[0], fit.laboratories.size()));
  ordered_json life = {{"law", law_name(fit.law)},
                       {"cv", fit.cv()},
                       {"mean_ref_min", fit.mean_min(fit.center)},
                       {"cutting_speed_ref_m_min", fit.center[0]},
                       {"feed_ref_mm_rev", fit.center[1]},
                       {"depth_of_cut_ref_mm", fit.center[2]},
                       {"speed_exponent", mu}};
  const std::array<const char*, 3> members = {"", "feed_exponent", "depth_exponent"};
  for (std::size_t k = 1; k < 3; ++k) {
    const TaylorExponent& e = fit.exponents[k];
    // The scenario writes feed and depth as exponents of the speed at equal life.
    if (e.fitted && e.value >= 0 && e.value / mu <= 5)
      life[members[k]] = e.value / mu;
    else
      stays.push_back(fmt::format(
          "{} stays as the scenario has it: {}", members[k],
          e.fitted ? fmt::format("the fitted one, {:.3g}, is outside 0 to 5", e.value / mu) : e.why_not));
  }
  return life;
}

}  // namespace

Report report_taylor(const WearData& data, const TaylorOptions& options, const TaylorTarget& target,
                     Origin origin) {
  Report report;
  origin.rows_used = data.rows_used;
  origin.rows_in_file = data.table.rows_in_file;
  origin.method =
      fmt::format("extended Taylor equation, censored maximum likelihood, VB {:g} mm", data.criterion_mm);
  report.json["table"] = table_json(data.table, data.rows_used);
  report.json["criterion_mm"] = data.criterion_mm;
  report.json["confidence"] = options.confidence;
  report.json["groups"] = ordered_json::array();
  add_table_lines(report.lines, data.table, data.rows_used);
  if (!target.pointer.empty() && data.groups.size() > 1)
    throw InputError(
        "", fmt::format("--to {}: the table holds {} pairs of material and tool; choose one with --material "
                        "and --tool",
                        target.pointer, data.groups.size()));
  std::size_t fitted = 0;
  for (const WearGroup& group : data.groups) {
    ordered_json j = {{"material", group.material}, {"tool", group.tool}, {"runs", ordered_json::array()}};
    std::size_t falling = 0;
    for (const WearRun& run : group.runs) {
      falling += run.falling_readings;
      j["runs"].push_back({{"line", run.life.line},
                           {"laboratory", run.laboratory},
                           {"cutting_speed_m_min", run.cutting_speed_m_min},
                           {"feed_mm_rev", run.feed_mm_rev},
                           {"depth_of_cut_mm", run.depth_of_cut_mm},
                           {"readings", run.readings},
                           {"last_wear_mm", run.last_wear_mm},
                           {"life_low_min", run.life.low},
                           {"life_high_min", number(run.life.high)}});
    }
    j["falling_readings"] = falling;
    const std::string title = fmt::format("{} / {}", group.material, group.tool);
    std::optional<TaylorFit> lognormal;
    std::optional<TaylorFit> weibull;
    try {
      lognormal = fit_taylor(group, ErrorLaw::normal, options);
      weibull = fit_taylor(group, ErrorLaw::smallest_extreme_value, options);
    } catch (const FitError& e) {
      j["not_fitted"] = e.what();
      report.json["groups"].push_back(j);
      report.lines.push_back(fmt::format("{}: not fitted: {}", title, e.what()));
      if (!target.pointer.empty())
        throw InputError("", fmt::format("--to {}: {}: {}", target.pointer, title, e.what()));
      continue;
    }
    ++fitted;
    j["fits"] = {fit_json(*lognormal), fit_json(*weibull)};
    const TaylorFit& fit = *lognormal;
    report.lines.push_back(
        fmt::format("{}: {} runs: {} crossed VB {:g} mm, {} before the first reading, {} never", title,
                    group.runs.size(), fit.exact, data.criterion_mm, fit.left_censored, fit.right_censored));
    report.lines.push_back(
        fmt::format("  T = {} min at v {} m/min, f {} mm/rev, a_p {} mm (median); CV {} ({:g} degrees "
                    "of freedom)",
                    plain(fit.median_min(fit.center)), plain(fit.center[0]), plain(fit.center[1]),
                    plain(fit.center[2]), plain(fit.cv()), fit.degrees()));
    for (const TaylorExponent& e : fit.exponents)
      report.lines.push_back(
          e.fitted ? fmt::format("  life goes as {}^-m, m = {}", e.factor, with_bounds(e.value, e.bounds))
                   : fmt::format("  no exponent of the {}: {}", e.factor, e.why_not));
    for (std::size_t l = 1; l < fit.laboratories.size(); ++l)
      report.lines.push_back(fmt::format(
          "  laboratory {}: life {} times that of {}", fit.laboratories[l],
          plain(std::exp(fit.regression.coefficients[static_cast<Eigen::Index>(l)])), fit.laboratories[0]));
    if (fit.exponents[0].value <= 0)
      report.warnings.push_back(title + ": life does not fall with the cutting speed in these runs");
    else if (fit.exponents[0].bounds.low <= 0)
      report.warnings.push_back(
          title + ": the runs do not show that life falls with the cutting speed (bounds hold 0)");
    if (falling > 0)
      report.warnings.push_back(fmt::format(
          "{}: {} readings are lower than the one before; the first crossing counts", title, falling));
    std::vector<std::array<double, 3>> regimes = target.regimes;
    if (regimes.empty()) regimes.push_back(fit.center);
    j["predictions"] = ordered_json::array();
    for (const auto& regime : regimes) {
      const TaylorPrediction p = predict(fit, regime, options.confidence);
      j["predictions"].push_back({{"regime", regime_json(regime)},
                                  {"median_min", number(p.median_min)},
                                  {"median_bounds", interval_json(p.median_bounds)},
                                  {"one_edge_bounds", interval_json(p.one_edge_bounds)},
                                  {"warnings", p.warnings}});
      report.lines.push_back(fmt::format(
          "  at v {} f {} a_p {}: median {} min, the next edge {} to {} min ({:g} %)", plain(regime[0]),
          plain(regime[1]), plain(regime[2]), with_bounds(p.median_min, p.median_bounds),
          plain(p.one_edge_bounds.low), plain(p.one_edge_bounds.high), 100 * options.confidence));
      for (const std::string& warning : p.warnings) report.warnings.push_back(title + ": " + warning);
    }
    // Both laws have as many parameters: the likelier one goes into the scenario.
    const TaylorFit& kept =
        weibull->regression.log_likelihood > lognormal->regression.log_likelihood ? *weibull : *lognormal;
    const std::string why_not = why_not_for_scenario(kept);
    if (!target.pointer.empty() && !why_not.empty())
      throw InputError("", fmt::format("--to {}: {}", target.pointer, why_not));
    if (why_not.empty()) {
      Origin own = origin;
      own.method = fmt::format(
          "extended Taylor equation, censored maximum likelihood, {} law, VB {:g} mm, {} runs of \"{}\" "
          "with \"{}\"",
          law_name(kept.law), data.criterion_mm, kept.runs, group.material, group.tool);
      std::vector<std::string> stays;
      const ordered_json life = edge_life_of(kept, stays);
      report.library.push_back(insert_entry(title, life, own));
      if (!target.pointer.empty()) {
        origin = own;
        report.warnings.insert(report.warnings.end(), stays.begin(), stays.end());
        report.changes = insert_changes(target.pointer, life, origin);
      }
    }
    report.json["groups"].push_back(j);
  }
  report.json["groups_fitted"] = fitted;
  report.lines.push_back(
      fmt::format("{} of {} pairs of material and tool fitted", fitted, data.groups.size()));
  finish(report, origin);
  return report;
}

}  // namespace verstat::fit
