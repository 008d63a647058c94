// Runs, studies and trials out of the database, and the notes beside them.

#include <algorithm>

#include <fmt/format.h>

#include "scenarios/function_json.h"
#include "scenarios/load.h"
#include "scenarios/warnings.h"
#include "store/database.h"
#include "store/listing.h"
#include "store/notes.h"
#include "store/result_json.h"
#include "web-ui/server/api_handlers.h"
#include "web-ui/server/api_support.h"

namespace verstat::web {

using nlohmann::json;
using nlohmann::ordered_json;
using store::number_or_null;

namespace {

constexpr std::int64_t default_page = 50;
constexpr std::int64_t largest_page = 200;
constexpr std::int64_t largest_trial_page = 5000;

store::ListQuery list_query(const Call& call, const std::vector<std::string>& sorts,
                            const store::Listing& listing, bool kpis) {
  store::ListQuery query;
  query.limit = whole(call.target, "limit", 1, largest_page, default_page);
  query.offset = whole(call.target, "offset", 0, INT64_MAX, 0);
  query.words = scenarios::words_of(text_in(call.target, "search"));
  query.tag = text_in(call.target, "tag");
  query.descending = word(call.target, "order", {"desc", "asc"}) == "desc";
  if (const std::string sort = text_in(call.target, "sort"); !sort.empty()) {
    if (std::find(sorts.begin(), sorts.end(), sort) == sorts.end() && !(kpis && listing.has_kpi(sort)))
      throw Refused{400, fmt::format("?sort={}: must be one of {}{}", clipped(sort), fmt::join(sorts, ", "),
                                     kpis ? " or the name of a KPI" : "")};
    query.sort = sort;
  }
  return query;
}

void put(ordered_json& row, const std::map<std::int64_t, store::Annotation>& all, std::int64_t id) {
  const auto found = all.find(id);
  row["note"] = found == all.end() ? "" : found->second.note;
  row["tags"] = found == all.end() ? std::vector<std::string>{} : found->second.tags;
}

ordered_json kpi_json(const store::KpiSummary& k) {
  return {{"name", k.kpi.name},
          {"unit", k.kpi.unit},
          {"meaning", k.kpi.meaning},
          {"mean", number_or_null(k.mean)},
          {"half_width_95", number_or_null(k.half_width)},
          {"samples", k.samples}};
}

template <class Row>
std::vector<std::int64_t> ids_of(const std::vector<Row>& rows) {
  std::vector<std::int64_t> ids;
  for (const Row& row : rows) ids.push_back(row.id);
  return ids;
}

Response annotate(const Call& call, store::Subject subject, std::int64_t id) {
  const json body = body_of(call.request, {"note", "tags"});
  store::Annotation annotation{.note = text_member(body, "note", "", store::Notes::longest_note)};
  if (body.contains("tags")) {
    if (!body["tags"].is_array()) throw Refused{400, "body: tags: must be a list of texts"};
    for (const json& tag : body["tags"]) {
      if (!tag.is_string()) throw Refused{400, "body: tags: must be a list of texts"};
      annotation.tags.push_back(tag.get<std::string>());
    }
  }
  const store::Notes notes(call.database);
  try {
    notes.set(subject, id, annotation);
  } catch (const std::invalid_argument& e) {
    throw Refused{422, e.what()};
  }
  const store::Annotation kept = notes.get(subject, id);
  return json_response({{"note", kept.note}, {"tags", kept.tags}});
}

}  // namespace

Response list_runs(const Call& call) {
  check_query(call.target, {"limit", "offset", "kpis", "search", "tag", "sort", "order"});
  const store::Listing listing(call.database);
  const store::ListQuery query = list_query(call, store::Listing::run_sorts(), listing, true);
  const std::vector<std::string> names = names_in(call.target, "kpis");
  const auto page = listing.runs(query);
  const auto ids = ids_of(page.rows);
  const auto kpis = listing.kpis(ids, names);
  const auto currencies = listing.currencies(ids);
  const auto notes = store::Notes(call.database).of(store::Subject::run, ids);
  ordered_json list = ordered_json::array();
  for (const store::RunHeader& header : page.rows) {
    ordered_json row = store::to_json(header);
    put(row, notes, header.id);
    if (!names.empty()) {
      row["currency"] = currencies.at(header.id);
      row["kpis"] = ordered_json::array();
      if (const auto found = kpis.find(header.id); found != kpis.end())
        for (const store::KpiSummary& k : found->second) row["kpis"].push_back(kpi_json(k));
    }
    list.push_back(std::move(row));
  }
  ordered_json body = {{"total", page.total}, {"limit", query.limit}, {"offset", query.offset}};
  body["runs"] = std::move(list);
  return json_response(body);
}

namespace {

// What the run should not have been made with, from the scenario that is stored with it. One that this
// version no longer reads has none.
ordered_json warnings_of(const store::Run& run) {
  try {
    std::vector<scenarios::Change> changes;
    for (const json& change : scenarios::parse_json(run.header.changes))
      changes.push_back({change.at("pointer").get<std::string>(), change.at("value")});
    return scenarios::to_json(scenarios::warnings(
        scenarios::load(scenarios::apply(scenarios::parse_json(run.scenario_text), changes))));
  } catch (const std::exception&) {
    return ordered_json::array();
  }
}

}  // namespace

Response show_run(const Call& call) {
  check_query(call.target, {"replications", "format", "separator", "decimal", "notes", "warnings"});
  const std::int64_t id = id_of("run", call.parameters[0]);
  const bool csv = word(call.target, "format", {"json", "csv"}) == "csv";
  const bool replications = word(call.target, "replications", {"0", "1"}) == "1";
  const bool notes = word(call.target, "notes", {"0", "1"}) == "1";
  const bool warnings = word(call.target, "warnings", {"0", "1"}) == "1";
  const CsvFormat format = csv_format(call.target);
  const auto found = store::Reader(call.database).run(id, replications);
  if (!found) throw Refused{404, fmt::format("there is no run {}", id)};
  if (csv) return csv_response(kpi_table(*found, format), fmt::format("run-{}.csv", id));
  ordered_json body = store::to_json(*found, replications);
  if (warnings) body["warnings"] = warnings_of(*found);
  if (notes) put(body, store::Notes(call.database).of(store::Subject::run, {id}), id);
  return json_response(body);
}

Response show_run_scenario(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("run", call.parameters[0]);
  const auto found = store::Reader(call.database).run(id, false);
  if (!found) throw Refused{404, fmt::format("there is no run {}", id)};
  ordered_json changes = ordered_json::parse(found->header.changes, nullptr, false);
  ordered_json body = {{"run", id}, {"name", found->header.scenario_name}};
  body["scenario"] = found->scenario_text;
  body["changes"] = changes.is_array() ? std::move(changes) : ordered_json::array();
  return json_response(body);
}

Response annotate_run(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("run", call.parameters[0]);
  if (!store::Reader(call.database).run(id, false)) throw Refused{404, fmt::format("there is no run {}", id)};
  return annotate(call, store::Subject::run, id);
}

Response list_studies(const Call& call) {
  check_query(call.target, {"limit", "offset", "search", "tag", "sort", "order"});
  const store::Listing listing(call.database);
  const store::ListQuery query = list_query(call, store::Listing::study_sorts(), listing, false);
  const auto page = listing.studies(query);
  const auto notes = store::Notes(call.database).of(store::Subject::study, ids_of(page.rows));
  ordered_json list = ordered_json::array();
  for (const store::StudyHeader& header : page.rows) {
    ordered_json row = store::to_json(header);
    put(row, notes, header.id);
    list.push_back(std::move(row));
  }
  ordered_json body = {{"total", page.total}, {"limit", query.limit}, {"offset", query.offset}};
  body["studies"] = std::move(list);
  return json_response(body);
}

Response show_study(const Call& call) {
  check_query(call.target, {"trials", "format", "separator", "decimal", "notes"});
  const std::int64_t id = id_of("study", call.parameters[0]);
  const bool csv = word(call.target, "format", {"json", "csv"}) == "csv";
  const bool trials = word(call.target, "trials", {"1", "0"}) == "1";
  const bool notes = word(call.target, "notes", {"0", "1"}) == "1";
  const CsvFormat format = csv_format(call.target);
  const auto found = store::Reader(call.database).study(id, trials || csv);
  if (!found) throw Refused{404, fmt::format("there is no study {}", id)};
  if (csv) return csv_response(trial_table(*found, format), fmt::format("study-{}.csv", id));
  ordered_json body = store::to_json(*found);
  if (!trials) body.erase("trial_list");
  if (notes) put(body, store::Notes(call.database).of(store::Subject::study, {id}), id);
  return json_response(body);
}

Response list_trials(const Call& call) {
  check_query(call.target, {"limit", "offset", "after", "sort", "sample", "best"});
  const std::int64_t id = id_of("study", call.parameters[0]);
  const bool by_objective = word(call.target, "sort", {"number", "objective"}) == "objective";
  const std::int64_t sample = whole(call.target, "sample", 0, largest_trial_page, 0);
  const bool highest = word(call.target, "best", {"low", "high"}) == "high";
  const store::TrialQuery query{.by_objective = by_objective,
                                .highest = highest,
                                .after = whole(call.target, "after", 0, INT64_MAX, 0),
                                .limit = whole(call.target, "limit", 1, largest_trial_page, largest_page),
                                .offset = whole(call.target, "offset", 0, INT64_MAX, 0)};
  const store::Listing listing(call.database);
  if (!listing.has_study(id)) throw Refused{404, fmt::format("there is no study {}", id)};
  const auto page = sample > 0 ? listing.sample(id, sample, highest) : listing.trials(id, query);
  ordered_json list = ordered_json::array();
  for (const store::TrialRow& t : page.rows) {
    list.push_back({{"number", t.number},
                    {"stage", t.stage},
                    {"values", t.values},
                    {"objective", number_or_null(t.objective)},
                    {"feasible", t.feasible}});
    if (t.replications == 0) continue;
    list.back()["half_width"] = number_or_null(t.half_width);
    list.back()["replications"] = t.replications;
  }
  ordered_json body = {{"total", page.total}, {"limit", query.limit}, {"offset", query.offset}};
  body["trials"] = std::move(list);
  return dense_response(body);
}

Response annotate_study(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("study", call.parameters[0]);
  if (!store::Reader(call.database).study(id, false))
    throw Refused{404, fmt::format("there is no study {}", id)};
  return annotate(call, store::Subject::study, id);
}

Response list_tags(const Call& call) {
  check_query(call.target, {});
  ordered_json tags = ordered_json::array();
  for (const auto& [name, count] : store::Notes(call.database).tags())
    tags.push_back({{"name", name}, {"count", count}});
  return json_response({{"tags", std::move(tags)}});
}

}  // namespace verstat::web
