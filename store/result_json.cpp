#include "store/result_json.h"

#include <cmath>

namespace verstat::store {

using nlohmann::ordered_json;

ordered_json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

namespace {

ordered_json provenance(const Provenance& p) {
  return {{"version", p.version}, {"platform", p.platform}, {"created", p.created}};
}

// Texts that are JSON themselves; a text that is not (it was written by hand) stays a text.
ordered_json embedded(const std::string& text) {
  ordered_json parsed = ordered_json::parse(text, nullptr, false);
  return parsed.is_discarded() ? ordered_json(text) : parsed;
}

}  // namespace

ordered_json to_json(const RunHeader& h) {
  return {{"id", h.id},
          {"label", h.label},
          {"scenario", h.scenario_name},
          {"changes", embedded(h.changes)},
          {"seed", std::to_string(h.seed)},
          {"replications", h.replications},
          {"horizon_min", h.horizon_min},
          {"warmup_min", h.warmup_min},
          {"elapsed_s", h.elapsed_s},
          {"provenance", provenance(h.provenance)},
          {"fingerprint", h.fingerprint.empty() ? ordered_json(nullptr) : ordered_json(h.fingerprint)}};
}

ordered_json to_json(const Run& run, bool replications) {
  ordered_json j = to_json(run.header);
  j["currency"] = run.currency;
  ordered_json kpis = ordered_json::array();
  for (std::size_t k = 0; k < run.kpis.size(); ++k) {
    const KpiSummary& s = run.kpis[k];
    ordered_json kpi = {{"name", s.kpi.name},
                        {"unit", s.kpi.unit},
                        {"meaning", s.kpi.meaning},
                        {"mean", number_or_null(s.mean)},
                        {"half_width_95", number_or_null(s.half_width)},
                        {"samples", s.samples}};
    if (replications) {
      ordered_json values = ordered_json::array();
      for (const auto& row : run.values) values.push_back(number_or_null(row.at(k)));
      kpi["values"] = std::move(values);
    }
    kpis.push_back(std::move(kpi));
  }
  j["kpis"] = std::move(kpis);
  return j;
}

ordered_json to_json(const StudyHeader& h) {
  return {{"id", h.id},
          {"name", h.name},
          {"scenario", h.scenario_name},
          {"kind", h.kind},
          {"status", h.status},
          {"objective", h.objective},
          {"trials", h.trials},
          {"seed", std::to_string(h.seed)},
          {"provenance", provenance(h.provenance)}};
}

ordered_json to_json(const Study& study) {
  ordered_json j = to_json(study.header);
  j["changes"] = embedded(study.changes);
  ordered_json variables = ordered_json::array();
  for (const Variable& v : study.variables) {
    variables.push_back({{"name", v.name},
                         {"pointer", v.pointer},
                         {"unit", v.unit},
                         {"low", v.low},
                         {"high", v.high},
                         {"type", v.type}});
    if (v.type == "categorical") variables.back()["options"] = embedded(v.options);
  }
  j["variables"] = std::move(variables);
  j["baseline_run"] = study.baseline_run ? ordered_json(*study.baseline_run) : ordered_json(nullptr);
  j["best_run"] = study.best_run ? ordered_json(*study.best_run) : ordered_json(nullptr);
  j["result"] = embedded(study.result);
  ordered_json trials = ordered_json::array();
  for (const Trial& t : study.trials) {
    trials.push_back({{"number", t.number},
                      {"stage", t.stage},
                      {"values", t.values},
                      {"objective", number_or_null(t.objective)},
                      {"feasible", t.feasible}});
    if (t.replications == 0) continue;
    trials.back()["half_width"] = number_or_null(t.half_width);
    trials.back()["first_replication"] = t.first_replication;
    trials.back()["replications"] = t.replications;
  }
  j["trial_list"] = std::move(trials);
  return j;
}

}  // namespace verstat::store
