#include "fit/life_report.h"

#include <cmath>

#include <fmt/format.h>

#include "fit/fit_error.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using nlohmann::ordered_json;
using scenarios::InputError;

ordered_json law_json(const FittedLaw& law) {
  ordered_json j = {{"family", name_of(law.family)}};
  switch (law.family) {
    case LifeFamily::weibull:
    case LifeFamily::gamma:
      j["scale"] = law.first;
      j["shape"] = law.second;
      break;
    case LifeFamily::lognormal:
      j["log_mean"] = law.first;
      j["log_sd"] = law.second;
      break;
    case LifeFamily::normal:
      j["mean"] = law.first;
      j["sd"] = law.second;
      break;
    case LifeFamily::exponential:
      j["mean"] = law.first;
      break;
  }
  j["life_mean"] = law.mean();
  j["life_cv"] = law.cv();
  j["log_likelihood"] = law.log_likelihood;
  j["aicc"] = number(law.aicc);
  return j;
}

const char* first_name(LifeFamily family) {
  switch (family) {
    case LifeFamily::weibull:
    case LifeFamily::gamma:
      return "scale";
    case LifeFamily::lognormal:
      return "mean of ln life";
    default:
      return "mean";
  }
}

const char* second_name(LifeFamily family) {
  switch (family) {
    case LifeFamily::lognormal:
      return "standard deviation of ln life";
    case LifeFamily::normal:
      return "standard deviation";
    default:
      return "shape";
  }
}

// The best law whose CV a scenario accepts.
const LawReport* law_for_scenario(const LifeAnalysis& a) {
  for (const LawReport& one : a.laws) {
    const double cv = one.law.cv();
    if (one.law.family == LifeFamily::exponential) return &one;
    const double most = one.law.family == LifeFamily::normal ? 0.45 : 2;
    if (cv >= 0.05 && cv <= most) return &one;
  }
  return nullptr;
}

ordered_json bounded_json(const Bounded& b) {
  return {{"estimate", number(b.estimate)}, {"low", number(b.bounds.low)}, {"high", number(b.bounds.high)}};
}

}  // namespace

Report report_lives(const RemovalLog& log, const LifeAnalysisOptions& options, const LifeTarget& target,
                    Origin origin) {
  Report report;
  origin.rows_used = log.rows_used;
  origin.rows_in_file = log.table.rows_in_file;
  origin.method = "censored maximum likelihood";
  report.json["table"] = table_json(log.table, log.rows_used);
  report.json["unit"] = log.unit;
  report.json["confidence"] = options.confidence;
  report.json["groups"] = ordered_json::array();
  add_table_lines(report.lines, log.table, log.rows_used);
  if (!target.pointer.empty() && log.groups.size() > 1) {
    std::string all;
    for (const RemovalGroup& g : log.groups)
      all += fmt::format("{}\"{}\" in \"{}\"", all.empty() ? "" : ", ", g.tool, g.regime);
    throw InputError(
        "", fmt::format("--to {}: the log holds several tools or regimes ({}); choose one with --tool and "
                        "--regime",
                        target.pointer, all));
  }
  if (!target.pointer.empty() && log.unit == "parts" && !target.min_per_part)
    throw InputError(
        "", fmt::format("--to {}: lives are in parts, the scenario wants minutes: --min-per-part says how "
                        "long one part cuts",
                        target.pointer));
  std::size_t fitted = 0;
  for (const RemovalGroup& group : log.groups) {
    ordered_json j = {{"tool", group.tool},
                      {"regime", group.regime},
                      {"edges", group.lives.size()},
                      {"failures", failures_in(group.lives)}};
    std::string title = group.tool.empty() ? "all edges" : group.tool;
    if (!group.regime.empty()) title += ", regime " + group.regime;
    report.lines.emplace_back("");
    LifeAnalysis a;
    try {
      a = analyse_lives(group.lives, options);
    } catch (const FitError& e) {
      double exposure = 0;
      for (const Observation& o : group.lives) exposure += o.low;
      j["not_fitted"] = e.what();
      j["total_time"] = exposure;
      report.json["groups"].push_back(j);
      report.lines.push_back(fmt::format("{}: {} edges, not fitted: {} ({} {} in all)", title,
                                         group.lives.size(), e.what(), plain(exposure), log.unit));
      continue;
    }
    ++fitted;
    const FittedLaw& best = a.laws.front().law;
    const std::string percent = fmt::format("{:g} %", 100 * options.confidence);
    report.lines.push_back(
        fmt::format("{}: {} edges, {} failures ({} known only to an interval), {} still good when "
                    "taken out",
                    title, a.edges, a.failures, a.intervals, a.edges - a.failures));
    report.lines.push_back(fmt::format("  {:<12}{:>10}{:>10}{:>8}{:>14}{:>10}", "law", "mean", "CV", "AICc",
                                       "ln likelihood", "fit p"));
    ordered_json laws = ordered_json::array();
    for (const LawReport& one : a.laws) {
      ordered_json l = law_json(one.law);
      l["goodness_of_fit"] = {{"cramer_von_mises", one.goodness.statistic},
                              {"p_value", one.goodness.p_value},
                              {"bootstrap_samples", one.goodness.samples}};
      laws.push_back(l);
      report.lines.push_back(fmt::format("  {:<12}{:>10}{:>10}{:>8}{:>14.2f}{:>10.3f}{}",
                                         name_of(one.law.family), plain(one.law.mean()), plain(one.law.cv()),
                                         plain(one.law.aicc), one.law.log_likelihood, one.goodness.p_value,
                                         one.goodness.p_value < 0.05 ? "   does not fit" : ""));
    }
    j["laws"] = laws;
    ordered_json unfitted = ordered_json::array();
    for (const Unfitted& u : a.unfitted) {
      unfitted.push_back({{"family", name_of(u.family)}, {"reason", u.reason}});
      report.lines.push_back(fmt::format("  {}: {}", name_of(u.family), u.reason));
    }
    j["unfitted"] = unfitted;
    j["best"] = {{"family", name_of(best.family)},
                 {"first_parameter", first_name(best.family)},
                 {"first", bounded_json(a.first)},
                 {"second_parameter", second_name(best.family)},
                 {"second", bounded_json(a.second)},
                 {"mean", bounded_json(a.mean)},
                 {"gamma", a.gamma},
                 {"gamma_percent_life", bounded_json(a.gamma_percent_life)},
                 {"longest_observed", a.longest}};
    report.lines.push_back(fmt::format("  {} {}: {}{}", name_of(best.family), first_name(best.family),
                                       with_bounds(a.first.estimate, a.first.bounds),
                                       best.family == LifeFamily::lognormal ? "" : " " + log.unit));
    if (best.parameters() == 2)
      report.lines.push_back(
          fmt::format("  {}: {}", second_name(best.family), with_bounds(a.second.estimate, a.second.bounds)));
    report.lines.push_back(
        fmt::format("  mean life: {} {}", with_bounds(a.mean.estimate, a.mean.bounds), log.unit));
    report.lines.push_back(fmt::format(
        "  {:g} % of the edges outlive {} {} (profile-likelihood bounds, {})", 100 * a.gamma,
        with_bounds(a.gamma_percent_life.estimate, a.gamma_percent_life.bounds), log.unit, percent));
    if (a.gamma_percent_life.estimate > a.longest)
      report.warnings.push_back(fmt::format("{}: the {:g} % life lies beyond the longest edge seen ({} {})",
                                            title, 100 * a.gamma, plain(a.longest), log.unit));
    if (a.mean.estimate > a.longest)
      report.warnings.push_back(
          fmt::format("{}: the mean life lies beyond the longest edge seen ({} {}): it is the "
                      "law's word, not the data's",
                      title, plain(a.longest), log.unit));

    ordered_json plot = ordered_json::array();
    for (const PlotPoint& p : a.weibull_plot)
      plot.push_back({{"life", p.time},
                      {"rank", p.rank},
                      {"median_rank", p.median},
                      {"low_5", p.low},
                      {"high_95", p.high},
                      {"x", std::log(p.time)},
                      {"y", std::log(-std::log1p(-p.median))}});
    j["weibull_plot"] = {{"points", plot}};
    if (a.plot_line)
      j["weibull_plot"]["line"] = {{"shape", a.plot_line->shape},
                                   {"scale", a.plot_line->scale},
                                   {"correlation", a.plot_line->correlation}};
    ordered_json steps = ordered_json::array();
    for (const SurvivalStep& s : a.product_limit)
      steps.push_back(
          {{"life", s.time}, {"survival", s.survival}, {"at_risk", s.at_risk}, {"failures", s.failures}});
    j["product_limit"] = steps;

    if (!a.causes.empty()) {
      ordered_json causes = ordered_json::array();
      report.lines.emplace_back("  causes, each with the others as censoring (independent causes assumed):");
      for (const CauseReport& c : a.causes) {
        const std::string& cause = log.causes[static_cast<std::size_t>(c.cause)];
        ordered_json one = {{"cause", cause}, {"failures", c.failures}, {"incidence", c.incidence}};
        if (c.law)
          one["law"] = law_json(*c.law);
        else
          one["not_fitted"] = c.why_not;
        causes.push_back(one);
        report.lines.push_back(
            c.law ? fmt::format(
                        "    {:<10} {:>3} failures, ends {:.0f} % of the edges; alone: {}, mean {} {}, CV {}",
                        cause, c.failures, 100 * c.incidence, name_of(c.law->family), plain(c.law->mean()),
                        log.unit, plain(c.law->cv()))
                  : fmt::format("    {:<10} {:>3} failures, ends {:.0f} % of the edges; no law: {}", cause,
                                c.failures, 100 * c.incidence, c.why_not));
      }
      j["causes"] = causes;
      if (a.gamma_percent_life_of_causes) {
        j["gamma_percent_life_of_causes"] = *a.gamma_percent_life_of_causes;
        report.lines.push_back(fmt::format("    all causes together: {:g} % outlive {} {}", 100 * a.gamma,
                                           plain(*a.gamma_percent_life_of_causes), log.unit));
      }
    }
    if (a.batches) {
      const BatchReport& b = *a.batches;
      ordered_json ratios = ordered_json::array();
      report.lines.push_back(fmt::format("  batches ({}): same life p = {:.3f}, same scatter p = {:.3f}{}",
                                         name_of(b.family), b.scale_p_value, b.shape_p_value,
                                         b.scale_p_value < 0.05 ? "; the batches differ in life" : ""));
      for (const auto& r : b.ratios) {
        ratios.push_back({{"batch", log.batches[r.batch]},
                          {"edges", r.edges},
                          {"failures", r.failures},
                          {"life_ratio", bounded_json(r.life_ratio)}});
        report.lines.push_back(fmt::format("    {:<12} {} edges, {} failures, life {} times the first",
                                           log.batches[r.batch], r.edges, r.failures,
                                           with_bounds(r.life_ratio.estimate, r.life_ratio.bounds)));
      }
      ordered_json without = ordered_json::array();
      for (const std::size_t batch : b.without_failures) without.push_back(log.batches[batch]);
      j["batches"] = {{"family", name_of(b.family)},
                      {"same_life_p_value", b.scale_p_value},
                      {"same_scatter_p_value", b.shape_p_value},
                      {"ratios", ratios},
                      {"without_failures", without}};
      if (b.scale_p_value < 0.05)
        report.warnings.push_back(
            title + ": the batches differ in life; one law for all of them is too wide for each");
    }
    if (!a.batches_not_compared.empty()) {
      j["batches_not_compared"] = a.batches_not_compared;
      report.lines.push_back("  batches not compared: " + a.batches_not_compared);
    }
    if (a.laws.front().goodness.p_value < 0.05)
      report.warnings.push_back(title +
                                ": even the best law does not fit (p < 0.05): look at causes and batches");

    const LawReport* chosen = law_for_scenario(a);
    if (!target.pointer.empty() && chosen == nullptr)
      throw InputError(
          "", fmt::format("--to {}: no fitted law has a CV that a scenario accepts", target.pointer));
    const bool in_minutes = log.unit != "parts" || target.min_per_part;
    if (chosen != nullptr && in_minutes) {
      const FittedLaw& law = chosen->law;
      Origin own = origin;
      own.rows_used = group.lives.size();
      own.method = fmt::format("censored maximum likelihood, {} law, {} failures of {} edges",
                               name_of(law.family), a.failures, a.edges);
      ordered_json life = {{"law", name_of(law.family)}};
      if (law.family != LifeFamily::exponential) life["cv"] = law.cv();
      life["mean_ref_min"] = law.mean() * (log.unit == "parts" ? *target.min_per_part : 1);
      if (target.cutting_speed_m_min) life["cutting_speed_ref_m_min"] = *target.cutting_speed_m_min;
      if (target.feed_mm_rev) life["feed_ref_mm_rev"] = *target.feed_mm_rev;
      if (target.depth_of_cut_mm) life["depth_of_cut_ref_mm"] = *target.depth_of_cut_mm;
      // An entry stands for itself: without the regime of the log its mean would say nothing.
      if (target.cutting_speed_m_min && target.feed_mm_rev && target.depth_of_cut_mm)
        report.library.push_back(
            insert_entry(group.regime.empty() ? group.tool : group.tool + " " + group.regime, life, own));
      if (!target.pointer.empty()) {
        if (law.family != best.family)
          report.warnings.push_back(fmt::format(
              "the {} law has a CV that a scenario does not accept: the changes carry {} (AICc {} more)",
              name_of(best.family), name_of(law.family), plain(law.aicc - best.aicc)));
        origin = own;
        report.changes = insert_changes(target.pointer, life, origin);
        if (!target.cutting_speed_m_min)
          report.warnings.emplace_back(
              "the fitted mean replaces the life at the scenario's reference regime; --speed, --feed and "
              "--depth name the "
              "regime of the log when it is another one");
      }
    }
    report.json["groups"].push_back(j);
  }
  if (fitted == 0 && log.groups.size() == 1)
    throw InputError("", fmt::format("table {}: {}", log.table.file,
                                     report.json["groups"][0]["not_fitted"].get<std::string>()));
  finish(report, origin);
  return report;
}

}  // namespace verstat::fit
