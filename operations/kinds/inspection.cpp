#include "operations/kinds/inspection.h"

#include <algorithm>

#include "models/criteria/k205_hierarchical_efficiency.h"
#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::operations::DefectType> {
  static std::vector<Field> fields() {
    using S = operations::DefectType;
    return {need<S>(&S::name, "name", "-", no_range(), "type of defect"),
            need<S>(&S::share, "share", "1", probability(), "share of all defects")};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::CheckOperation> {
  static std::vector<Field> fields() {
    using S = operations::CheckOperation;
    return {need<S>(&S::name, "name", "-", no_range(), "name of the check"),
            need<S>(&S::time_min, "time_min", "min", closed(0, 1e4), "time of a part"),
            need<S>(&S::cost, "cost", "money", closed(0, 1e9), "cost of a part"),
            may<S>(&S::false_alarm, "false_alarm", "1", probability(), "share of good parts that it rejects"),
            entries(need<S>(&S::detection, "detection", "1", probability(),
                            "probability of finding each type of defect"),
                    1, 100)};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::Inspection> {
  static std::vector<Field> fields() {
    using S = operations::Inspection;
    return {
        need<S>(&S::defective_share, "defective_share", "1", closed(0, 0.999), "share of defective parts"),
        need<S>(&S::part_cost, "part_cost", "money", open_low(0, 1e9), "cost of a part before"),
        entries(need<S>(&S::defects, "defects", "-", no_range(), "types of defect"), 1, 100),
        entries(need<S>(&S::checks, "checks", "-", no_range(), "checks that can be made"), 1, 100),
        entries(may<S>(&S::chosen, "chosen", "-", no_range(),
                       "names of the checks that are made; not given: the cheapest set"),
                0, 100),
        may<S>(&S::escape_probability_max, "escape_probability_max", "1", probability(),
               "largest share of parts that may escape with a defect")};
  }
};

namespace verstat::operations {

namespace {

namespace k205 = models::k205;

void check(const Inspection& spec) {
  double shares = 0;
  for (const DefectType& d : spec.defects) shares += d.share;
  models::require(shares > 1 - 1e-6 && shares < 1 + 1e-6, "defects", shares,
                  "must have shares that sum to 1");
  for (std::size_t k = 0; k < spec.checks.size(); ++k)
    models::require(
        spec.checks[k].detection.size() == spec.defects.size(), "checks/" + std::to_string(k) + "/detection",
        static_cast<std::int64_t>(spec.checks[k].detection.size()), "must have one entry per type of defect");
}

k205::InspectionChoice choice(const Inspection& spec) {
  k205::InspectionChoice in;
  in.base_cost_cu = spec.part_cost;
  in.defective_share = spec.defective_share;
  for (const DefectType& d : spec.defects) in.defect_share.push_back(d.share);
  for (const CheckOperation& c : spec.checks) {
    in.operation_cost_cu.push_back(c.cost);
    in.detection.push_back(c.detection);
  }
  return in;
}

std::vector<std::size_t> chosen_checks(const Inspection& spec) {
  std::vector<std::size_t> made;
  if (!spec.chosen) {
    for (const std::int64_t k : k205::optimal_inspection_set(choice(spec)).operations)
      made.push_back(static_cast<std::size_t>(k));
    return made;
  }
  for (std::size_t n = 0; n < spec.chosen->size(); ++n) {
    const std::string& name = (*spec.chosen)[n];
    const auto found = std::find_if(spec.checks.begin(), spec.checks.end(),
                                    [&](const CheckOperation& c) { return c.name == name; });
    models::require(found != spec.checks.end(), "chosen/" + std::to_string(n), models::Value(name),
                    "must be the name of a check");
    const auto k = static_cast<std::size_t>(found - spec.checks.begin());
    models::require(std::find(made.begin(), made.end(), k) == made.end(), "chosen/" + std::to_string(n),
                    models::Value(name), "must not be named twice");
    made.push_back(k);
  }
  return made;
}

}  // namespace

CutPlan plan(const Inspection& spec, const PlanContext&) {
  check(spec);
  const auto made = chosen_checks(spec);
  const double q0 = spec.defective_share;
  double time_min = 0;
  double cost = spec.part_cost;
  double specificity = 1;
  std::vector<double> missed(spec.defects.size(), 1);
  for (const std::size_t k : made) {
    const CheckOperation& c = spec.checks[k];
    time_min += c.time_min;
    cost += c.cost;
    specificity *= 1 - c.false_alarm;
    for (std::size_t i = 0; i < missed.size(); ++i) missed[i] *= 1 - c.detection[i];
  }
  k205::InspectionSet set;
  set.cost_cu = cost;
  set.defective_share = q0;
  double sensitivity = 0;
  for (std::size_t i = 0; i < missed.size(); ++i) {
    set.detection_probability.push_back(1 - missed[i]);
    set.defect_share.push_back(spec.defects[i].share);
    sensitivity += spec.defects[i].share * (1 - missed[i]);
  }
  const auto criterion = k205::criterion_inspection_set(set);
  k205::Diagnosis d;
  d.defect_rejected = q0 * sensitivity;
  d.defect_accepted = q0 * (1 - sensitivity);
  d.good_rejected = (1 - q0) * (1 - specificity);
  d.good_accepted = (1 - q0) * specificity;
  const double released = d.defect_accepted + d.good_accepted;
  const auto information = k205::criterion_information_ratio(d);

  CutPlan p;
  p.quantities.reserve(12);
  p.set_main_time(time_min, "definition: the checks that are made");
  p.scrap_probability = 1 - released;
  p.detection = Detection{.defective_share = q0,
                          .sensitivity = sensitivity,
                          .specificity = specificity,
                          .origin = "K205.optimal_inspection_set; COMPLETION: checks detect independently"};
  auto& q = p.quantities;
  const char* origin = spec.chosen ? "given" : "K205.optimal_inspection_set";
  q.push_back({"checks_made", static_cast<double>(made.size()), "1", origin, "number of checks"});
  q.push_back({"sensitivity", sensitivity, "1", "COMPLETION: checks detect independently",
               "share of defective parts that are found"});
  q.push_back({"specificity", specificity, "1", "COMPLETION: checks err independently",
               "share of good parts that are accepted"});
  q.push_back({"pass_probability", released, "1", "definition", "share of parts accepted"});
  q.push_back({"escape_probability", criterion.escape_probability, "1", "K205.criterion_inspection_set",
               "share of parts that escape with a defect"});
  q.push_back({"cost_per_conforming", criterion.efficiency_cu, "money", "K205.criterion_inspection_set",
               "cost over the share that does not escape with a defect"});
  q.push_back({"inspected_cost", cost, "money", "definition", "part and checks"});
  q.push_back({"information_ratio", information.efficiency, "1", "K205.criterion_information_ratio",
               "information that the checks give over what is needed"});
  if (q0 < 1)
    q.push_back({"yield_ratio", k205::criterion_yield_ratio({d.good_rejected, d.good_accepted}).efficiency,
                 "1", "K205.criterion_yield_ratio", "share of the good parts that survives"});
  if (spec.escape_probability_max)
    p.limits.push_back({"escape_probability", criterion.escape_probability, *spec.escape_probability_max,
                        true, "1", "K205.criterion_inspection_set"});
  return p;
}

namespace inspection {
void add_to(Kinds& kinds) {
  kinds.add<Inspection>("Parts pass checks, each of which finds some types of defect.", {"K205"});
}
}  // namespace inspection

}  // namespace verstat::operations
