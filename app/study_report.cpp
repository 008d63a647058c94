#include "app/study_report.h"

#include <cmath>

#include <fmt/format.h>

#include "app/results.h"
#include "app/study_session.h"
#include "app/table.h"
#include "models/catalogue/catalogue.h"
#include "optimize/compare.h"
#include "store/result_json.h"

namespace verstat::app {

using nlohmann::ordered_json;
using store::number_or_null;
using namespace optimize;

namespace {

ordered_json point(const StudySpec& study, const std::vector<double>& x) {
  ordered_json values = ordered_json::array();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Variable& v = study.variables[k];
    values.push_back({{"name", v.name}, {"pointer", v.pointer}, {"unit", v.unit}, {"value", x[k]}});
    if (v.type == VariableType::categorical) values.back()["text"] = text_at(v, x[k]);
  }
  return values;
}

std::string words_of(const StudyFindings& f) {
  if (!f.answer.interrupted.empty())
    return fmt::format(
        "Ended early ({}) after {} trials; {}. It goes on with --resume {}.", f.answer.interrupted, f.trials,
        f.answer.best ? "the best so far is not confirmed" : "no feasible plan was found so far", f.id);
  if (!f.answer.best)
    return f.nearest_miss.empty() ? "No feasible plan was found."
                                  : "No feasible plan was found: " + f.nearest_miss + ".";
  if (!f.study.objective.function.empty()) {
    const double best = f.answer.best->value;
    std::string words = fmt::format("The best plan's {} is {:.6g}", f.study.objective.label(), best);
    if (f.answer.baseline_value && *f.answer.baseline_value != 0) {
      const double share = best / *f.answer.baseline_value - 1;
      words += std::abs(share) < 1e-6
                   ? std::string(", which is today's")
                   : fmt::format(", {:+.3g} % against today's {:.6g}", 100 * share, *f.answer.baseline_value);
    }
    words += ", as the catalogue computes it.";
    if (!f.answer.baseline_feasible) words += " Today's plan does not meet the constraints.";
    return words;
  }
  if (!f.confirmation) return "The best plan was not confirmed by simulation.";
  const auto kpi = *f.confirmation->baseline.index_of(f.study.objective.kpi);
  const auto base = f.confirmation->baseline.estimates[kpi].mean;
  const auto saving = f.confirmation->saving.mean;
  const auto half = f.confirmation->saving.half_width;
  if (!base || !saving || !half || *base == 0) return "The best plan and today's could not be compared.";
  const double percent = 100 * *saving / std::abs(*base);
  const double percent_half = 100 * *half / std::abs(*base);
  const bool cost = f.study.objective.kpi == "cost_per_part";
  const std::string what = kpi_in_words(f.study.objective.kpi);
  std::string words;
  if (f.confirmation->verdict == "not distinguishable") {
    words = fmt::format("The best plan and today's cannot be told apart: {:.2f} +- {:.2f} % of the {}.",
                        percent, percent_half, what);
  } else if (cost) {
    words =
        fmt::format("The best plan costs {:.2f} +- {:.2f} % {} per part: {:.2f} +- {:.2f} {} of {:.2f} {}.",
                    std::abs(percent), percent_half, percent > 0 ? "less" : "more", std::abs(*saving), *half,
                    f.currency, *base, f.currency);
  } else {
    const bool up = (f.study.objective.direction == Direction::maximize) == (*saving > 0);
    words = fmt::format("The best plan's {} is {:.2f} +- {:.2f} % {}: by {:.4g} +- {:.2g} of {:.6g} {}.",
                        what, std::abs(percent), percent_half, up ? "higher" : "lower", std::abs(*saving),
                        *half, *base, f.confirmation->baseline.kpis[kpi].unit);
  }
  if (!f.answer.baseline_feasible) words += " Today's plan does not meet the constraints.";
  if (f.answer.choice) {
    const Choice& c = *f.answer.choice;
    if (c.finalists.size() > 1 && c.decided)
      words += fmt::format(
          " Among {} finalists it is the best, or within {:.3g} of it, with probability {:g} or more.",
          c.finalists.size(), c.indifference, c.confidence);
    else if (c.finalists.size() > 1)
      words += fmt::format(" The choice among {} finalists was not decided within the budget.",
                           c.finalists.size());
  }
  return words;
}

ordered_json choice_json(const StudySpec& study, const Choice& choice) {
  ordered_json finalists = ordered_json::array();
  for (const Finalist& f : choice.finalists)
    finalists.push_back({{"values", point(study, f.x)},
                         {"mean", number_or_null(f.mean)},
                         {"half_width", number_or_null(f.half_width)},
                         {"replications", f.replications},
                         {"feasible", f.feasible},
                         {"survived", f.survived}});
  return {{"finalists", finalists},
          {"best", choice.best},
          {"decided", choice.decided},
          {"confidence", choice.confidence},
          {"indifference", choice.indifference}};
}

ordered_json front_json(const StudySpec& study, const FrontAnswer& front) {
  ordered_json objectives = ordered_json::array();
  for (const ObjectiveSpec& o : study.objectives)
    objectives.push_back(
        {{"kpi", o.label()}, {"direction", o.direction == Direction::maximize ? "maximize" : "minimize"}});
  ordered_json points = ordered_json::array();
  for (const FrontEstimate& p : front.points) {
    points.push_back({{"values", point(study, p.x)}, {"objectives", p.objectives}});
    if (p.means.empty()) continue;
    points.back()["simulated"] = ordered_json::array();
    for (std::size_t k = 0; k < p.means.size(); ++k)
      points.back()["simulated"].push_back(
          {{"mean", number_or_null(p.means[k])}, {"half_width", number_or_null(p.half_widths[k])}});
  }
  return {{"objectives", objectives},
          {"points", points},
          {"knee", front.knee},
          {"hypervolume", front.hypervolume},
          {"reference", front.reference}};
}

}  // namespace

ordered_json to_json(const StudyFindings& f) {
  const StudySpec& study = f.study;
  const auto simulated = [&](bool baseline) -> ordered_json {
    if (!f.confirmation) return {{"mean", nullptr}, {"half_width_95", nullptr}};
    const shop::RunResult& run = baseline ? f.confirmation->baseline : f.confirmation->best;
    const auto kpi = *run.index_of(study.objective.kpi);
    return {{"mean", number_or_null(run.estimates[kpi].mean)},
            {"half_width_95", number_or_null(run.estimates[kpi].half_width)}};
  };
  std::string unit = study.objective.kpi.starts_with("cost") ? f.currency : "1";
  if (f.confirmation)
    unit = f.confirmation->baseline.kpis[*f.confirmation->baseline.index_of(study.objective.kpi)].unit;
  if (!study.objective.function.empty())
    for (const auto& output : models::catalogue().at(study.objective.function).outputs)
      if (output.name == study.objective.output) unit = output.unit;
  ordered_json j = {{"objective", study.objective.label()},
                    {"direction", study.objective.direction == Direction::maximize ? "maximize" : "minimize"},
                    {"unit", unit},
                    {"baseline",
                     {{"values", point(study, f.answer.baseline)},
                      {"analytic", number_or_null(f.answer.baseline_value)},
                      {"feasible", f.answer.baseline_feasible},
                      {"simulated", simulated(true)}}}};
  if (f.answer.best)
    j["best"] = {{"values", point(study, f.answer.best->x)},
                 {"analytic", number_or_null(f.best_long_run)},
                 {"stage", f.answer.best->stage},
                 {"simulated", simulated(false)}};
  j["evaluations"] = f.trials;
  if (f.confirmation)
    j["saving"] = {{"mean", number_or_null(f.confirmation->saving.mean)},
                   {"half_width", number_or_null(f.confirmation->saving.half_width)},
                   {"confidence", study.confirmation.confidence}};
  if (!f.answer.interrupted.empty())
    j["verdict"] = "interrupted";
  else if (!f.answer.best)
    j["verdict"] = "infeasible";
  else
    j["verdict"] = f.confirmation ? f.confirmation->verdict
                                  : (study.objective.function.empty() ? "not confirmed" : "computed");
  j["words"] = words_of(f);
  if (!f.answer.interrupted.empty()) j["interrupted"] = f.answer.interrupted;
  if (!f.answer.not_covered.empty()) j["simulation_only"] = f.answer.not_covered;
  if (f.answer.best && f.answer.interrupted.empty()) {
    ordered_json plan = ordered_json::array();
    for (const auto& change : changes_at(study.variables, f.answer.best->x))
      plan.push_back({{"pointer", change.pointer}, {"value", change.value}});
    j["plan"] = plan;
  }
  if (f.answer.choice) j["choice"] = choice_json(study, *f.answer.choice);
  if (f.answer.front) j["front"] = front_json(study, *f.answer.front);
  if (!f.binding.empty()) {
    j["binding"] = ordered_json::array();
    for (const Binding& b : f.binding) {
      std::string room = b.unit == "1" ? "unit" : b.unit;
      if (f.confirmation)  // a KPI has its unit from the run
        if (const auto k = f.confirmation->best.index_of(b.name)) room = f.confirmation->best.kpis[*k].unit;
      const bool saves = study.objective.kpi.starts_with("cost_per_");
      j["binding"].push_back(
          {{"name", b.name},
           {"unit", b.unit},
           {"value", b.value},
           {"allowed", b.allowed},
           {"shadow_price", b.shadow_price},
           {"words",
            saves
                ? fmt::format("1 {} more room at \"{}\" saves {:.3g} {} per {}", room, b.name, b.shadow_price,
                              unit, study.objective.kpi == "cost_per_part" ? "part" : "good part")
                : fmt::format("1 {} more room at \"{}\" improves the {} by {:.3g} {}", room, b.name,
                              kpi_in_words(study.objective.label()), b.shadow_price, unit)}});
    }
  }
  if (!f.sensitivity.empty()) {
    j["sensitivity"] = ordered_json::array();
    for (const Sensitivity& s : f.sensitivity)
      j["sensitivity"].push_back({{"name", s.name},
                                  {"pointer", s.pointer},
                                  {"relative", s.relative},
                                  {"objective_low", number_or_null(s.objective_low)},
                                  {"objective_high", number_or_null(s.objective_high)},
                                  {"regret_low", number_or_null(s.regret_low)},
                                  {"regret_high", number_or_null(s.regret_high)},
                                  {"values_low", s.x_low},
                                  {"values_high", s.x_high}});
  }
  if (!f.one_cut.empty()) {
    j["one_cut"] = ordered_json::array();
    for (const OneCut& c : f.one_cut)
      j["one_cut"].push_back({{"operation", c.operation},
                              {"speed_min_cost_m_min", c.speed_min_cost_m_min},
                              {"speed_max_rate_m_min", number_or_null(c.speed_max_rate_m_min)},
                              {"life_min_cost_min", c.life_min_cost_min},
                              {"life_max_rate_min", c.life_max_rate_min},
                              {"speed_shop_m_min", c.speed_shop_m_min},
                              {"life_shop_min", c.life_shop_min},
                              {"load", c.load},
                              {"waits_for_crew", c.waits_for_crew},
                              {"waits_for_stock", c.waits_for_stock},
                              {"why", c.why}});
  }
  return j;
}

namespace {

std::string value_text(const ordered_json& value) {
  return value.contains("text") ? value["text"].get<std::string>()
                                : fmt::format("{:.6g}", value["value"].get<double>());
}
std::string six(const ordered_json& j) {
  return j.is_null() ? "-" : fmt::format("{:.6g}", j.get<double>());
}

void print_plan(const ordered_json& r) {
  const auto& today = r["baseline"];
  const bool has_best = r.contains("best");
  Table table("lrrl");
  table.add({"", "today", "best"});
  for (std::size_t k = 0; k < today["values"].size(); ++k) {
    const std::string unit = today["values"][k]["unit"].get<std::string>();
    table.add({today["values"][k]["name"].get<std::string>(), value_text(today["values"][k]),
               has_best ? value_text(r["best"]["values"][k]) : "-", unit == "1" ? "" : unit});
  }
  const std::string unit = r["unit"].get<std::string>();
  const std::string what = kpi_in_words(r["objective"].get<std::string>());
  const bool computed = r["verdict"] == "computed";
  table.add({what + (computed ? "" : ", long run"), six(today["analytic"]),
             has_best ? six(r["best"]["analytic"]) : "-", unit});
  if (!computed)
    table.add({what + ", simulated", shown(today["simulated"], "half_width_95"),
               has_best ? shown(r["best"]["simulated"], "half_width_95") : "-", unit});
  table.print();
}

void print_front(const ordered_json& front) {
  fmt::print("\nfront (* is the knee), hypervolume {:.6g}\n", front["hypervolume"].get<double>());
  const std::size_t columns = front["points"][0]["values"].size() + front["objectives"].size();
  Table table("l" + std::string(columns, 'r'));
  std::vector<std::string> head{""};
  for (const auto& v : front["points"][0]["values"]) head.push_back(v["name"].get<std::string>());
  for (const auto& o : front["objectives"]) head.push_back(o["kpi"].get<std::string>());
  table.add(std::move(head));
  for (std::size_t k = 0; k < front["points"].size(); ++k) {
    const auto& p = front["points"][k];
    std::vector<std::string> row{k == front["knee"].get<std::size_t>() ? "*" : ""};
    for (const auto& v : p["values"]) row.push_back(value_text(v));
    for (std::size_t o = 0; o < p["objectives"].size(); ++o)
      row.push_back(p.contains("simulated") ? shown(p["simulated"][o]) : six(p["objectives"][o]));
    table.add(std::move(row));
  }
  table.print();
}

}  // namespace

void print_findings(const ordered_json& r) {
  print_plan(r);
  fmt::print("\n{}\n", r["words"].get<std::string>());
  if (r.contains("simulation_only"))
    fmt::print("By simulation alone: {}.\n", r["simulation_only"].get<std::string>());
  if (r.contains("front")) print_front(r["front"]);
  if (r.contains("binding")) {
    fmt::print("\nwhat holds the plan back\n");
    for (const auto& b : r["binding"])
      fmt::print("  {}: {:.6g} of {:.6g}; {}\n", b["name"].get<std::string>(), b["value"].get<double>(),
                 b["allowed"].get<double>(), b["words"].get<std::string>());
  }
  if (r.contains("one_cut")) {
    fmt::print("\none cut against the shop, m/min\n");
    Table table("lrrrl");
    table.add({"operation", "least cost", "most parts", "the plan", "why"});
    const auto four = [](const ordered_json& j) {
      return j.is_null() ? std::string("-") : fmt::format("{:.4g}", j.get<double>());
    };
    for (const auto& c : r["one_cut"])
      table.add({c["operation"].get<std::string>(), four(c["speed_min_cost_m_min"]),
                 four(c["speed_max_rate_m_min"]), four(c["speed_shop_m_min"]), c["why"].get<std::string>()});
    table.print();
  }
  if (r.contains("sensitivity")) {
    fmt::print("\nbest objective if the input is off, and what keeping this plan loses then\n");
    Table table("lrrrr");
    table.add({"input", "lower", "higher", "lost, lower", "lost, higher"});
    const auto lost = [](const ordered_json& j) {
      return j.is_null() ? std::string("broken") : fmt::format("{:.2g}", j.get<double>());
    };
    for (const auto& s : r["sensitivity"])
      table.add({fmt::format("{} +- {:g} %", s["name"].get<std::string>(), 100 * s["relative"].get<double>()),
                 six(s["objective_low"]), six(s["objective_high"]), lost(s["regret_low"]),
                 lost(s["regret_high"])});
    table.print();
  }
}

}  // namespace verstat::app
