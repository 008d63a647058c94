#include "fit/event_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit/fit_error.h"

namespace verstat::fit {
namespace {

using nlohmann::ordered_json;
using scenarios::InputError;

ordered_json duration_json(const DurationFit& fit) {
  ordered_json laws = ordered_json::array();
  for (const LawReport& one : fit.laws)
    laws.push_back({{"family", name_of(one.law.family)},
                    {"mean_min", one.law.mean()},
                    {"cv", one.law.cv()},
                    {"log_likelihood", one.law.log_likelihood},
                    {"aicc", number(one.law.aicc)},
                    {"goodness_p_value", one.goodness.p_value}});
  return {{"values", fit.values},
          {"censored", fit.censored},
          {"mean_min", fit.mean},
          {"sd_min", fit.sd},
          {"least_min", fit.least},
          {"most_min", fit.most},
          {"constant", fit.constant},
          {"laws", laws},
          {"no_law_fits", fit.empirical},
          {"largest_gap", fit.largest_gap},
          {"quantiles_0_to_100_min", fit.quantiles}};
}

void add_duration_lines(Report& report, const std::string& what, const DurationFit& fit) {
  report.lines.push_back(fmt::format("  {}: {} values{}, mean {} min, standard deviation {}, {} to {}", what,
                                     fit.values,
                                     fit.censored > 0 ? fmt::format(" and {} unfinished", fit.censored) : "",
                                     plain(fit.mean), plain(fit.sd), plain(fit.least), plain(fit.most)));
  if (fit.constant) {
    report.lines.emplace_back("    always the same: a constant");
    return;
  }
  for (const LawReport& one : fit.laws)
    report.lines.push_back(fmt::format("    {:<12} mean {:>9} CV {:>7} AICc {:>9} fit p {:.3f}{}",
                                       name_of(one.law.family), plain(one.law.mean()), plain(one.law.cv()),
                                       plain(one.law.aicc), one.goodness.p_value,
                                       one.goodness.p_value < 0.05 ? "   does not fit" : ""));
  if (fit.empirical) {
    report.lines.push_back(
        fmt::format("    no law fits: quantiles 5/25/50/75/95 % are {} / {} / {} / {} / {} min",
                    plain(fit.quantiles[5]), plain(fit.quantiles[25]), plain(fit.quantiles[50]),
                    plain(fit.quantiles[75]), plain(fit.quantiles[95])));
    report.warnings.push_back(
        fmt::format("{}: no law fits; the empirical quantiles are in the JSON answer, and the best law "
                    "is off by up to {:.3f} in probability",
                    what, fit.largest_gap));
  }
}

void add_duration_change(Report& report, const std::string& pointer, const std::string& what,
                         const DurationFit& fit, const char* member = nullptr) {
  const auto duration = duration_of(fit);
  if (!duration)
    throw InputError(
        "", fmt::format("{}: no fitted law of the {} has a CV that a scenario accepts (0.05 to 2)", pointer,
                        what));
  if (duration->aicc_more > 0)
    report.warnings.push_back(
        fmt::format("{}: the best law has a CV that a scenario does not accept; {} is written instead", what,
                    duration->law));
  if (member == nullptr) {
    report.changes.push_back({pointer, duration->value});
  } else {
    report.changes.push_back({pointer, {{"kind", "interarrival"}, {member, duration->value}}});
  }
}

void finish(Report& report, const Origin& origin) {
  report.json["warnings"] = report.warnings;
  report.json["provenance"] = origin_json(origin);
  if (!report.changes.empty()) report.json["patch"] = patch_json(report.changes, origin);
}

}  // namespace

std::optional<ScenarioDuration> duration_of(const DurationFit& fit) {
  if (fit.constant) return ScenarioDuration{{{"kind", "constant"}, {"value_min", fit.mean}}, "constant", 0};
  for (const LawReport& one : fit.laws) {
    const FittedLaw& law = one.law;
    const double more = law.aicc - fit.laws.front().law.aicc;
    if (law.family == LifeFamily::exponential)
      return ScenarioDuration{
          {{"kind", "exponential"}, {"rate_per_min", 1 / law.mean()}}, "exponential", more};
    if (law.cv() >= 0.05 && law.cv() <= 2)
      return ScenarioDuration{{{"kind", name_of(law.family)}, {"mean_min", law.mean()}, {"cv", law.cv()}},
                              name_of(law.family),
                              more};
    // Hardly any scatter: a constant is nearer than a law with more of it.
    if (law.cv() < 0.05)
      return ScenarioDuration{{{"kind", "constant"}, {"value_min", law.mean()}}, "constant", more};
  }
  return std::nullopt;
}

Report report_downtime(const DowntimeLog& log, const EventReportOptions& options,
                       const DowntimeTarget& target, Origin origin) {
  Report report;
  origin.rows_used = log.rows_used;
  origin.rows_in_file = log.table.rows_in_file;
  origin.method = fmt::format("maximum likelihood of times on the {} clock", name_of(target.clock));
  report.json["table"] = table_json(log.table, log.rows_used);
  add_table_lines(report.lines, log.table, log.rows_used);
  report.json["machines"] = log.machines;
  report.json["watched_min"] = log.to_min - log.from_min;
  report.json["modes"] = ordered_json::array();
  const bool wants_changes = !target.to_failure.empty() || !target.to_repair.empty();
  bool mode_found = false;
  if (wants_changes && target.mode.empty() && log.repairs.size() > 1) {
    std::string all;
    for (const ModeRepairs& r : log.repairs) all += (all.empty() ? "\"" : ", \"") + r.mode + "\"";
    throw InputError("", fmt::format("the log has several modes ({}); --mode says whose laws to write", all));
  }
  for (const ModeRepairs& repairs : log.repairs) {
    ordered_json j = {
        {"mode", repairs.mode}, {"stops", repairs.repairs.size()}, {"clocks", ordered_json::array()}};
    const bool chosen = target.mode.empty() || target.mode == repairs.mode;
    mode_found = mode_found || chosen;
    report.lines.emplace_back("");
    report.lines.push_back(fmt::format("{}: {} stops", repairs.mode.empty() ? "all stops" : repairs.mode,
                                       repairs.repairs.size()));
    for (const ModeTimes& times : log.times) {
      if (times.mode != repairs.mode) continue;
      const TrendTest trend = laplace_test(times.series);
      const std::string what = fmt::format("time between failures, {} clock", name_of(times.clock));
      ordered_json c = {
          {"clock", name_of(times.clock)},
          {"laplace",
           {{"statistic", trend.statistic}, {"p_value", trend.p_value}, {"events", trend.events}}}};
      const bool changing = trend.p_value < 0.05;
      std::optional<DurationFit> fit;
      try {
        fit = fit_durations(times.between, options.goodness_samples, options.seed);
        c["between_failures"] = duration_json(*fit);
        add_duration_lines(report, what, *fit);
      } catch (const FitError& e) {
        c["not_fitted"] = e.what();
        report.lines.push_back(fmt::format("  {}: not fitted: {}", what, e.what()));
      }
      report.lines.push_back(fmt::format("    Laplace trend test: {:+.2f}, p = {:.3f}: {}", trend.statistic,
                                         trend.p_value,
                                         !changing             ? "no trend seen"
                                         : trend.statistic > 0 ? "failures come faster and faster"
                                                               : "failures become rarer"));
      if (changing) {
        try {
          const PowerLaw law = fit_power_law(times.series, options.confidence);
          c["power_law"] = {{"growth", law.growth},
                            {"growth_bounds", interval_json(law.growth_bounds)},
                            {"lambda", law.lambda},
                            {"rate_at_end_per_min", law.rate_at_end}};
          report.lines.push_back(fmt::format("    power law: growth {}, now one in {} min per machine",
                                             with_bounds(law.growth, law.growth_bounds),
                                             plain(1 / law.rate_at_end)));
        } catch (const FitError& e) {
          c["power_law"] = {{"not_fitted", e.what()}};
        }
        if (times.clock == target.clock)
          report.warnings.push_back(
              fmt::format("{}: the rate of failures changes on the {} clock: a renewal law is wrong",
                          repairs.mode, name_of(times.clock)));
      }
      if (chosen && !target.to_failure.empty() && times.clock == target.clock) {
        if (!fit)
          throw InputError(
              "", fmt::format("--to-failure {}: {}", target.to_failure, c["not_fitted"].get<std::string>()));
        if (changing && !target.accept_trend)
          throw InputError(
              "", fmt::format("--to-failure {}: failures of \"{}\" show a trend (Laplace p = {:.3f}); "
                              "--accept-trend writes a renewal law all the same",
                              target.to_failure, repairs.mode, trend.p_value));
        add_duration_change(report, target.to_failure, what, *fit);
      }
      j["clocks"].push_back(c);
    }
    try {
      const DurationFit fit = fit_durations(repairs.repairs, options.goodness_samples, options.seed);
      j["repair"] = duration_json(fit);
      add_duration_lines(report, "time a stop lasts", fit);
      if (chosen && !target.to_repair.empty())
        add_duration_change(report, target.to_repair, "time a stop lasts", fit);
    } catch (const FitError& e) {
      j["repair"] = {{"not_fitted", e.what()}};
      report.lines.push_back(fmt::format("  time a stop lasts: not fitted: {}", e.what()));
      if (chosen && !target.to_repair.empty())
        throw InputError("", fmt::format("--to-repair {}: {}", target.to_repair, e.what()));
    }
    report.json["modes"].push_back(j);
  }
  if (wants_changes && !mode_found)
    throw InputError("", fmt::format("--mode {}: the log has no such mode", target.mode));
  const bool clock_known =
      std::any_of(log.times.begin(), log.times.end(), [&](const auto& t) { return t.clock == target.clock; });
  if (!clock_known)
    throw InputError("", fmt::format("--clock {}: the log has no column for it", name_of(target.clock)));
  finish(report, origin);
  return report;
}

Report report_arrivals(const ArrivalLog& log, const EventReportOptions& options, const std::string& pointer,
                       Origin origin) {
  Report report;
  origin.rows_used = log.rows_used;
  origin.rows_in_file = log.table.rows_in_file;
  origin.method = "maximum likelihood of times between arrivals";
  report.json["table"] = table_json(log.table, log.rows_used);
  add_table_lines(report.lines, log.table, log.rows_used);
  report.lines.emplace_back("");
  DurationFit fit;
  try {
    fit = fit_durations(log.between, options.goodness_samples, options.seed);
  } catch (const FitError& e) {
    throw InputError("", fmt::format("table {}: {}", log.table.file, e.what()));
  }
  report.json["between_arrivals"] = duration_json(fit);
  add_duration_lines(report, "time between arrivals", fit);
  report.json["laplace"] = {
      {"statistic", log.trend.statistic}, {"p_value", log.trend.p_value}, {"events", log.trend.events}};
  report.lines.push_back(fmt::format("  Laplace trend test: {:+.2f}, p = {:.3f}: {}", log.trend.statistic,
                                     log.trend.p_value,
                                     log.trend.p_value >= 0.05 ? "a steady rate"
                                     : log.trend.statistic > 0 ? "arrivals become more frequent"
                                                               : "arrivals become rarer"));
  if (log.trend.p_value < 0.05)
    report.warnings.emplace_back("the rate of arrivals changes over the log: one law averages over it");
  if (log.with_quantities) {
    double mean = 0;
    for (const double q : log.quantities) mean += q / static_cast<double>(log.quantities.size());
    double squares = 0;
    for (const double q : log.quantities) squares += (q - mean) * (q - mean);
    const double sd = std::sqrt(squares / static_cast<double>(log.quantities.size() - 1));
    report.json["quantity"] = {{"mean", mean}, {"sd", sd}};
    report.lines.push_back(
        fmt::format("  parts per arrival: mean {}, standard deviation {}", plain(mean), plain(sd)));
    if (!pointer.empty() && mean > 1)
      report.warnings.push_back(fmt::format(
          "parts come {} at a time; the changes carry the times between arrivals only", plain(mean)));
  }
  const auto profile = [&](const char* key, const char* what, const std::vector<RateSlot>& slots,
                           double p_value) {
    if (slots.empty()) return;
    ordered_json list = ordered_json::array();
    std::string shown;
    for (const RateSlot& s : slots) {
      if (!(s.exposure_h > 0)) continue;  // the shop does not work then
      list.push_back({{"slot", s.name},
                      {"arrivals", s.arrivals},
                      {"exposure_h", s.exposure_h},
                      {"rate_per_h", s.rate_per_h},
                      {"bounds", interval_json(s.bounds)}});
      shown += fmt::format(" {} {}", s.name, plain(s.rate_per_h));
    }
    report.json[key] = {{"slots", list}, {"same_rate_p_value", p_value}};
    report.lines.push_back(fmt::format("  arrivals per hour over the {}:{} (the same everywhere: p = {:.3f})",
                                       what, shown, p_value));
    if (p_value < 0.05 && !pointer.empty())
      report.warnings.push_back(
          fmt::format("arrivals differ over the {}: a law of times between them does not know that", what));
  };
  if (log.calendar) {
    profile("weekdays", "week", log.weekdays, log.weekday_p_value);
    profile("hours", "day", log.hours, log.hour_p_value);
    report.json["dispersion_of_days"] = {{"variance_over_mean", log.dispersion_of_days},
                                         {"p_value", log.dispersion_p_value}};
    report.lines.push_back(
        fmt::format("  arrivals per day: variance / mean = {} (1 for independent arrivals, p = {:.3f})",
                    plain(log.dispersion_of_days), log.dispersion_p_value));
  }
  if (!pointer.empty()) add_duration_change(report, pointer, "time between arrivals", fit, "time");
  finish(report, origin);
  return report;
}

Report report_cycles(const CycleLog& log, const EventReportOptions& options, const std::string& pointer,
                     Origin origin) {
  Report report;
  origin.rows_used = log.rows_used;
  origin.rows_in_file = log.table.rows_in_file;
  origin.method = "maximum likelihood of cycle times";
  report.json["table"] = table_json(log.table, log.rows_used);
  add_table_lines(report.lines, log.table, log.rows_used);
  report.lines.emplace_back("");
  report.json["operations"] = ordered_json::array();
  if (!pointer.empty() && log.groups.size() > 1)
    throw InputError("", fmt::format("--to {}: the log holds {} operations; choose one with --operation",
                                     pointer, log.groups.size()));
  for (const CycleGroup& group : log.groups) {
    ordered_json j = {{"operation", group.operation}};
    const std::string what = group.operation.empty() ? "cycle time" : group.operation;
    try {
      const DurationFit fit = fit_durations(group.times, options.goodness_samples, options.seed);
      j["cycle"] = duration_json(fit);
      add_duration_lines(report, what, fit);
      if (!pointer.empty()) add_duration_change(report, pointer, what, fit);
    } catch (const FitError& e) {
      if (!pointer.empty()) throw InputError("", fmt::format("--to {}: {}: {}", pointer, what, e.what()));
      j["not_fitted"] = e.what();
      report.lines.push_back(fmt::format("  {}: not fitted: {}", what, e.what()));
    }
    report.json["operations"].push_back(j);
  }
  finish(report, origin);
  return report;
}

}  // namespace verstat::fit
