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
    report.warnings.push_back(fmt::format(
        "{}: no law fits (the best one is off by up to {:.3f} in probability): changes and library "
        "carry the observations themselves",
        what, fit.largest_gap));
  }
}

// The duration, with a warning where it is less than the log.
ordered_json written_duration(Report& report, const std::string& what, const DurationFit& fit,
                              Written written) {
  const ScenarioDuration duration = duration_of(fit, written);
  if (duration.law == "empirical" && fit.weight_beyond > 0)
    report.warnings.push_back(fmt::format(
        "{}: {} unfinished ones outlast the longest complete one ({} min), which stands for a share "
        "of {:.3f}",
        what, fit.censored, plain(fit.most), fit.weight_beyond));
  if (duration.law != "empirical" && !fit.constant && duration.law != name_of(fit.laws.front().law.family))
    report.warnings.push_back(
        fmt::format("{}: the law first by AICc does not fit or has a CV that a scenario does not accept "
                    "(0.05 to 2); {} is "
                    "written instead",
                    what, duration.law));
  return duration.value;
}

// For the provenance: "maximum likelihood (weibull)".
std::string how_written(const ordered_json& duration) {
  const std::string kind = duration["kind"].get<std::string>();
  return kind == "empirical" ? "observed values" : fmt::format("maximum likelihood ({})", kind);
}

}  // namespace

ScenarioDuration duration_of(const DurationFit& fit, Written written) {
  if (fit.constant) return {{{"kind", "constant"}, {"value_min", fit.mean}}, "constant"};
  if (written == Written::best)
    for (const LawReport& one : fit.laws) {
      const FittedLaw& law = one.law;
      if (one.goodness.p_value < 0.05) continue;
      if (law.family == LifeFamily::exponential)
        return {{{"kind", "exponential"}, {"rate_per_min", 1 / law.mean()}}, "exponential"};
      if (law.cv() >= 0.05 && law.cv() <= 2)
        return {{{"kind", name_of(law.family)}, {"mean_min", law.mean()}, {"cv", law.cv()}},
                name_of(law.family)};
    }
  constexpr std::size_t most_values = 1000;
  if (fit.distinct.size() <= most_values) {
    nlohmann::json value = {{"kind", "empirical"}, {"values_min", fit.distinct}};
    if (std::any_of(fit.weights.begin(), fit.weights.end(),
                    [&](double w) { return std::abs(w - fit.weights[0]) > 1e-9 * fit.weights[0]; }))
      value["weights"] = fit.weights;
    return {value, "empirical"};
  }
  // Between neighbours lies half the weight of each, evenly spread, as the scenario takes it.
  std::vector<double> cumulative = {0};
  for (std::size_t k = 1; k < fit.weights.size(); ++k)
    cumulative.push_back(cumulative.back() + (fit.weights[k - 1] + fit.weights[k]) / 2);
  std::vector<double> quantiles;
  std::size_t piece = 1;
  for (std::size_t q = 0; q <= most_values; ++q) {
    const double at = cumulative.back() * static_cast<double>(q) / most_values;
    while (piece + 1 < cumulative.size() && cumulative[piece] < at) ++piece;
    const double share = (at - cumulative[piece - 1]) / (cumulative[piece] - cumulative[piece - 1]);
    quantiles.push_back(fit.distinct[piece - 1] +
                        std::min(1.0, share) * (fit.distinct[piece] - fit.distinct[piece - 1]));
  }
  return {{{"kind", "empirical"}, {"values_min", quantiles}}, "empirical"};
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
    // A failure mode for the library: both times on the clock of the changes.
    ordered_json failure = {{"name", repairs.mode.empty() ? "all stops" : repairs.mode},
                            {"clock", name_of(target.clock)}};
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
        report.changes.push_back({target.to_failure, written_duration(report, what, *fit, options.written)});
        // The law speaks of this clock and no other.
        const std::string member = "/time_to_failure";
        if (target.to_failure.ends_with(member))
          report.changes.push_back(
              {target.to_failure.substr(0, target.to_failure.size() - member.size()) + "/clock",
               name_of(target.clock)});
      }
      if (fit && times.clock == target.clock && (!changing || target.accept_trend))
        failure["time_to_failure"] = duration_of(*fit, options.written).value;
      j["clocks"].push_back(c);
    }
    try {
      const DurationFit fit = fit_durations(repairs.repairs, options.goodness_samples, options.seed);
      j["repair"] = duration_json(fit);
      add_duration_lines(report, "time a stop lasts", fit);
      failure["repair"] = duration_of(fit, options.written).value;
      if (chosen && !target.to_repair.empty())
        report.changes.push_back(
            {target.to_repair, written_duration(report, "time a stop lasts", fit, options.written)});
    } catch (const FitError& e) {
      j["repair"] = {{"not_fitted", e.what()}};
      report.lines.push_back(fmt::format("  time a stop lasts: not fitted: {}", e.what()));
      if (chosen && !target.to_repair.empty())
        throw InputError("", fmt::format("--to-repair {}: {}", target.to_repair, e.what()));
    }
    if (failure.contains("time_to_failure") && failure.contains("repair")) {
      Origin own = origin;
      own.rows_used = repairs.repairs.size();
      own.method = fmt::format("{} of times to failure on the {} clock, {} of repairs",
                               how_written(failure["time_to_failure"]), name_of(target.clock),
                               how_written(failure["repair"]));
      report.library.push_back({"failure", failure["name"].get<std::string>(), failure, own});
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

namespace {

// Arrivals an hour over the week: the rate of all, times what the day of the week and the hour of the day
// have of it, where the test sees a difference. Neighbouring hours of one rate are one period.
ordered_json weekly_profile(const ArrivalLog& log) {
  if (!log.calendar)
    throw InputError("", "--as profile: the arrivals have no dates, so the log shows no week");
  // A slot that the shop works for a part only cannot stand as a whole one.
  if (log.dates_only)
    for (const RateSlot& day : log.weekdays)
      if (std::fmod(day.exposure_h, 24) != 0)
        throw InputError("", "--as profile: the arrivals have dates only, which say nothing of --hours");
  double whole_h = 0;
  for (const RateSlot& hour : log.hours) whole_h = std::max(whole_h, hour.exposure_h);
  for (const RateSlot& hour : log.hours)
    if (hour.exposure_h > 0 && hour.exposure_h != whole_h)
      throw InputError("", "--as profile: --hours must begin and end with an hour, such as 07:00-15:00");
  double arrivals = 0;
  double exposure_h = 0;
  for (const RateSlot& day : log.weekdays) {
    arrivals += static_cast<double>(day.arrivals);
    exposure_h += day.exposure_h;
  }
  const double mean_per_h = arrivals / exposure_h;
  const auto share = [&](const std::vector<RateSlot>& slots, double p_value, std::size_t k) {
    if (slots.empty()) return 1.0;
    if (!(slots[k].exposure_h > 0)) return 0.0;  // the shop does not work then
    return p_value < 0.05 ? slots[k].rate_per_h / mean_per_h : 1.0;
  };
  ordered_json rates = ordered_json::array();
  double before = 0;
  for (std::size_t hour = 0; hour < 168; ++hour) {
    const double per_h = mean_per_h * share(log.weekdays, log.weekday_p_value, hour / 24) *
                         share(log.hours, log.hour_p_value, hour % 24);
    if (per_h > 0 && per_h == before)
      rates.back()["to_h"] = hour + 1;
    else if (per_h > 0)
      rates.push_back({{"from_h", hour}, {"to_h", hour + 1}, {"per_h", per_h}});
    before = per_h;
  }
  return {{"kind", "weekly_profile"}, {"rates", rates}};
}

// The orders themselves; dates count from the Monday, 00:00, before the first.
ordered_json order_list(const ArrivalLog& log) {
  constexpr double week_min = 10'080;
  constexpr double first_monday_min = 4 * 1'440;  // 1970-01-05
  const double start_min =
      log.calendar
          ? first_monday_min + week_min * std::floor((log.moments_min.front() - first_monday_min) / week_min)
          : 0;
  ordered_json orders = ordered_json::array();
  for (std::size_t k = 0; k < log.moments_min.size(); ++k) {
    const double quantity = log.quantities[k];
    if (quantity != std::floor(quantity) || quantity > 1e6)
      throw InputError("", fmt::format("--as orders: a quantity of {}: must be a whole number of parts up to "
                                       "1000000",
                                       quantity));
    orders.push_back(
        {{"arrives_min", log.moments_min[k] - start_min}, {"quantity", static_cast<std::int64_t>(quantity)}});
  }
  return {{"kind", "orders"}, {"orders", orders}};
}

}  // namespace

Report report_arrivals(const ArrivalLog& log, const EventReportOptions& options, SupplyForm form,
                       const std::string& pointer, const std::string& name, Origin origin) {
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
    if (form != SupplyForm::orders && mean > 1)
      report.warnings.push_back(fmt::format(
          "parts come {} at a time; changes and library carry the moments of arrival only (--as orders: all)",
          plain(mean)));
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
    if (p_value < 0.05 && form == SupplyForm::law)
      report.warnings.push_back(
          fmt::format("arrivals differ over the {}: a law of times between them does not know that (--as "
                      "profile does)",
                      what));
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
  ordered_json supply;
  switch (form) {
    case SupplyForm::law:
      supply = {{"kind", "interarrival"},
                {"time", written_duration(report, "time between arrivals", fit, options.written)}};
      origin.method = how_written(supply["time"]) + " of times between arrivals";
      break;
    case SupplyForm::profile:
      origin.method = "rates over the week by maximum likelihood";
      supply = weekly_profile(log);
      break;
    case SupplyForm::orders:
      origin.method = "orders as they came";
      supply = order_list(log);
      break;
  }
  report.library.push_back({"supply", name, supply, origin});
  if (!pointer.empty()) report.changes.push_back({pointer, supply});
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
      const ordered_json duration = written_duration(report, what, fit, options.written);
      Origin own = origin;
      own.rows_used = group.times.size();
      own.method = fmt::format("{} of cycle times of \"{}\"", how_written(duration), what);
      report.library.push_back({"duration", what, duration, own});
      if (!pointer.empty()) report.changes.push_back({pointer, duration});
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
