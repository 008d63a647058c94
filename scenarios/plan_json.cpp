#include "scenarios/plan_json.h"

#include "operations/fields.h"
#include "scenarios/json_text.h"
#include "scenarios/model_json.h"

template <>
struct verstat::models::StructFields<verstat::scenarios::OperationFile> {
  static std::vector<Field> fields() {
    using S = scenarios::OperationFile;
    return {may<S>(&S::description, "description", "-", no_range(), "what it shows"),
            need<S>(&S::process, "process", "-", no_range(), "what is done"),
            may<S>(&S::edge_life, "edge_life", "-", no_range(), "life of the tool's edge"),
            may<S>(&S::machine_limits, "machine_limits", "-", no_range(), "what the machine can do"),
            may<S>(&S::spindle, "spindle", "-", no_range(), "dynamics of the machine's spindle")};
  }
};

namespace verstat::scenarios {

using nlohmann::ordered_json;
using operations::CutPlan;
using operations::Quantity;

CutPlan OperationFile::plan() const {
  return process.plan({.edge = edge_life ? &*edge_life : nullptr,
                       .machine = &machine_limits,
                       .spindle = spindle ? &*spindle : nullptr});
}

OperationFile load_operation(const nlohmann::json& file) {
  OperationFile operation;
  const auto fields = models::StructFields<OperationFile>::fields();
  try {
    models::read_fields(&operation, fields, to_value(file));
    models::check_fields(&operation, fields);
  } catch (const models::DomainError& e) {
    throw InputError("/" + e.input(), (e.input().empty() ? "the operation" : "/") + std::string(e.what()));
  }
  return operation;
}

namespace {

ordered_json quantity_json(const Quantity& q, bool explain) {
  ordered_json j = {{"name", q.name}, {"value", q.value}, {"unit", q.unit}};
  if (explain) {
    j["origin"] = q.origin;
    j["meaning"] = q.meaning;
  }
  return j;
}

ordered_json element_json(const operations::ElementLife& e, bool explain) {
  const auto law = models::detail::Binding<models::LifeLawKind>::write(e.law);
  ordered_json j = {{"element", e.element}, {"law", to_json(law)}, {"mean_min", e.mean_min}, {"cv", e.cv}};
  if (explain) j["origin"] = e.origin;
  return j;
}

}  // namespace

ordered_json to_json(const CutPlan& plan, bool explain) {
  ordered_json j = {{"feasible", plan.feasible()}, {"main_time_min", plan.main_time_min}};
  j["edge_life"] = plan.edge ? element_json(*plan.edge, explain) : ordered_json(nullptr);
  j["more_elements"] = ordered_json::array();
  for (const auto& e : plan.more_elements) j["more_elements"].push_back(element_json(e, explain));
  j["scrap_probability"] = plan.scrap_probability;
  j["breakage_probability"] = plan.breakage_probability;
  j["quantities"] = ordered_json::array();
  for (const Quantity& q : plan.quantities) j["quantities"].push_back(quantity_json(q, explain));
  j["limits"] = ordered_json::array();
  for (const auto& l : plan.limits) {
    ordered_json limit = {
        {"name", l.name}, {"value", l.value},     {l.at_most ? "at_most" : "at_least", l.allowed},
        {"unit", l.unit}, {"margin", l.margin()}, {"met", l.met()}};
    if (explain) limit["origin"] = l.origin;
    j["limits"].push_back(std::move(limit));
  }
  j["forbidden_bands"] = ordered_json::array();
  for (const auto& b : plan.bands) {
    ordered_json band = {{"name", b.name}, {"value", b.value}, {"low", b.low},
                         {"high", b.high}, {"unit", b.unit},   {"inside", b.inside()}};
    if (explain) band["origin"] = b.origin;
    j["forbidden_bands"].push_back(std::move(band));
  }
  if (plan.detection) {
    j["detection"] = {{"defective_share", plan.detection->defective_share},
                      {"sensitivity", plan.detection->sensitivity},
                      {"specificity", plan.detection->specificity}};
    if (explain) j["detection"]["origin"] = plan.detection->origin;
  }
  if (plan.gauge) {
    j["gauge_wear"] = {{"wear_per_check", plan.gauge->wear_per_check},
                       {"start", plan.gauge->start},
                       {"replace_at", plan.gauge->replace_at},
                       {"replace_min", plan.gauge->replace_min},
                       {"price", plan.gauge->price},
                       {"worn", plan.gauge->worn},
                       {"sensitivity", plan.gauge->sensitivity},
                       {"specificity", plan.gauge->specificity}};
    if (explain) j["gauge_wear"]["origin"] = plan.gauge->origin;
  }
  if (plan.lot) {
    const auto law = models::detail::Binding<models::LifeLawKind>::write(plan.lot->law);
    j["prepared_lot"] = {{"law", to_json(law)},
                         {"life_factor", plan.lot->life_factor},
                         {"cv", plan.lot->cv},
                         {"breakage_fraction", plan.lot->breakage_fraction},
                         {"delivered_per_prepared", plan.lot->delivered_per_prepared},
                         {"added_cost_per_insert", plan.lot->added_cost_per_insert},
                         {"edges_used_by_test", plan.lot->edges_used_by_test}};
    if (explain) j["prepared_lot"]["origin"] = plan.lot->origin;
  }
  if (plan.overload) {
    j["overload"] = {{"trips_per_part", plan.overload->trips_per_part},
                     {"breaks_per_part", plan.overload->breaks_per_part},
                     {"trip_probability", plan.overload->trip_probability},
                     {"break_probability", plan.overload->break_probability},
                     {"reset_min", plan.overload->reset_min},
                     {"self_reset", plan.overload->self_reset}};
    if (explain) j["overload"]["origin"] = plan.overload->origin;
  }
  j["leaves"] = ordered_json::array();
  for (const auto& state : plan.leaves)
    j["leaves"].push_back({{"quantity", state.quantity},
                           {"value", plan.value_of(state.quantity).value_or(0)},
                           {"sd", state.sd},
                           {"unit", plan.unit_of(state.quantity)}});
  j["consumables"] = ordered_json::array();
  for (const Quantity& q : plan.consumables) j["consumables"].push_back(quantity_json(q, explain));
  return j;
}

}  // namespace verstat::scenarios
