#include "operations/kinds/gauge_inspection.h"

#include <algorithm>

#include "models/math/gauss_legendre.h"
#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::models::k307::GaugeDesign> {
  static std::vector<Field> fields() {
    using S = k307::GaugeDesign;
    return {need<S>(&S::distance_mm, "distance_mm", "mm", open_low(0, 1e4), "nominal distance of the axes"),
            need<S>(&S::d1_min_mm, "d1_min_mm", "mm", open_low(0, 1e4), "least diameter of hole 1"),
            need<S>(&S::d2_min_mm, "d2_min_mm", "mm", open_low(0, 1e4), "least diameter of hole 2"),
            need<S>(&S::tolerance_mm, "tolerance_mm", "mm", open_low(0, 100), "position tolerance"),
            need<S>(&S::deviation_1_mm, "deviation_1_mm", "mm", closed(0, 10), "F of the new element 1"),
            need<S>(&S::deviation_2_mm, "deviation_2_mm", "mm", closed(0, 10), "F of the new element 2"),
            need<S>(&S::wear_value_1_mm, "wear_value_1_mm", "mm", closed(0, 10), "W of element 1"),
            need<S>(&S::wear_value_2_mm, "wear_value_2_mm", "mm", closed(0, 10), "W of element 2")};
  }
};

template <>
struct verstat::models::StructFields<verstat::operations::GaugeInspection> {
  static std::vector<Field> fields() {
    using S = operations::GaugeInspection;
    return {
        need<S>(&S::gauge, "gauge", "-", no_range(), "what the gauges check"),
        need<S>(&S::distance_mean_mm, "distance_mean_mm", "mm", open_low(0, 1e4), "mean of the process"),
        need<S>(&S::distance_sigma_mm, "distance_sigma_mm", "mm", open_low(0, 100), "its scatter"),
        need<S>(&S::d1_mean_mm, "d1_mean_mm", "mm", open_low(0, 1e4), "mean diameter of hole 1"),
        need<S>(&S::d1_sigma_mm, "d1_sigma_mm", "mm", closed(0, 100), "its scatter"),
        need<S>(&S::d2_mean_mm, "d2_mean_mm", "mm", open_low(0, 1e4), "mean diameter of hole 2"),
        need<S>(&S::d2_sigma_mm, "d2_sigma_mm", "mm", closed(0, 100), "its scatter"),
        need<S>(&S::check_min, "check_min", "min", closed(0, 1e4), "time of a check"),
        may<S>(&S::wear_per_check_um, "wear_per_check_um", "um", closed(1e-6, 100),
               "wear of the gauge per check"),
        may<S>(&S::replace_at_wear, "replace_at_wear", "1", closed(0.01, 3),
               "share of the wear allowance at which a gauge is replaced; above 1 beyond its limit"),
        may<S>(
            &S::worn_now, "worn_now", "1", closed(0, 3),
            "share of the allowance worn off, in a shop at its start; not given: mean over the gauge's life, "
            "in a shop new gauges"),
        may<S>(&S::gauge_cost, "gauge_cost", "money", closed(0, 1e9), "price of the pair of gauges"),
        may<S>(&S::replace_min, "replace_min", "min", closed(0, 1e4),
               "time of the station to replace the gauges at their wear limit"),
        may<S>(&S::consumer_risk_max, "consumer_risk_max", "1", probability(),
               "largest share of defective parts that may pass"),
        may<S>(&S::producer_risk_max, "producer_risk_max", "1", probability(),
               "largest share of good parts that may be rejected")};
  }
};

namespace verstat::operations {

namespace {

namespace k307 = models::k307;

class Gauges {
 public:
  explicit Gauges(const GaugeInspection& spec)
      : spec_(spec), outer_(k307::gauge_outer_span(spec.gauge)), inner_(k307::gauge_inner_span(spec.gauge)) {
    // A part is good by definition when it passes gauges at their wear limit.
    good_ = pass(1);
    models::require(good_ > 0, "distance_mean_mm", spec.distance_mean_mm,
                    "lies so far off that no part of this process is good");
  }
  [[nodiscard]] const k307::GaugeSizes& outer() const { return outer_; }
  [[nodiscard]] double good() const { return good_; }
  /// Probability that a part passes gauges of which this share of the allowance is worn off.
  [[nodiscard]] double pass(double worn) const {
    k307::GaugedProcess in;
    in.distance_mean_mm = spec_.distance_mean_mm;
    in.distance_sigma_mm = spec_.distance_sigma_mm;
    in.d1_mean_mm = spec_.d1_mean_mm;
    in.d1_sigma_mm = spec_.d1_sigma_mm;
    in.d2_mean_mm = spec_.d2_mean_mm;
    in.d2_sigma_mm = spec_.d2_sigma_mm;
    in.b_outer_mm = between(fresh(outer_), outer_.b_wear_mm, worn);
    in.b_inner_mm = between(fresh(inner_), inner_.b_wear_mm, worn);
    return k307::gauge_pass_probability(in).p;
  }
  /// Mean over the wear from `low` to `high`; smooth there, so few points do.
  [[nodiscard]] double mean_pass(double low, double high) const {
    static const std::vector<models::GaussPoint> rule = models::gauss_legendre(3);
    return models::integrate_gauss([this](double w) { return pass(w); }, low, high, rule) / (high - low);
  }
  [[nodiscard]] static double fresh(const k307::GaugeSizes& sizes) {
    return (sizes.b_max_mm + sizes.b_min_mm) / 2;
  }

 private:
  [[nodiscard]] static double between(double fresh_mm, double worn_mm, double share) {
    return fresh_mm + share * (worn_mm - fresh_mm);
  }
  const GaugeInspection& spec_;
  k307::GaugeSizes outer_, inner_;
  double good_ = 0;
};

/// Up to the wear limit all defective parts are rejected and some good ones; beyond, the other way round.
Detection detection(const GaugeInspection& spec, const Gauges& gauges) {
  const double good = gauges.good();
  const auto specificity = [&](double passing) { return std::min(1.0, passing / good); };
  const auto sensitivity = [&](double passing) {
    return good < 1 ? std::min(1.0, std::max(0.0, 1 - (passing - good) / (1 - good))) : 1.0;
  };
  Detection d;
  d.defective_share = 1 - good;
  d.origin = "K307.gauge_pass_probability; COMPLETION: good is what passes gauges at the wear limit";
  if (spec.worn_now) {
    const double passing = gauges.pass(*spec.worn_now);
    (*spec.worn_now <= 1 ? d.specificity : d.sensitivity) =
        *spec.worn_now <= 1 ? specificity(passing) : sensitivity(passing);
    return d;
  }
  const double end = spec.replace_at_wear;
  const double within = std::min(end, 1.0);
  d.specificity = (within * specificity(gauges.mean_pass(0, within)) + (end - within)) / end;
  if (end > 1) d.sensitivity = (1 + (end - 1) * sensitivity(gauges.mean_pass(1, end))) / end;
  return d;
}

/// The same at every state from new to replaced: risks change smoothly up to the wear limit and beyond it.
GaugeWear wear_of(const GaugeInspection& spec, const Gauges& gauges) {
  constexpr int nodes = 12;  // per range; linear between, less than 1e-3 of the risk of new gauges off
  GaugeWear wear;
  const k307::GaugeSizes& outer = gauges.outer();
  wear.wear_per_check = spec.wear_per_check_um / 1000 / std::abs(Gauges::fresh(outer) - outer.b_wear_mm);
  wear.start = spec.worn_now.value_or(0);
  wear.replace_at = spec.replace_at_wear;
  wear.replace_min = spec.replace_min;
  wear.price = spec.gauge_cost;
  wear.origin = "K307.gauge_pass_probability";
  const double end = std::max(wear.replace_at, wear.start);
  GaugeInspection at = spec;
  const auto add = [&](double worn) {
    at.worn_now = worn;
    const Detection d = detection(at, gauges);
    wear.worn.push_back(worn);
    wear.sensitivity.push_back(d.sensitivity);
    wear.specificity.push_back(d.specificity);
  };
  const double within = std::min(end, 1.0);
  for (int k = 0; k <= nodes; ++k) add(within * k / nodes);
  if (end > 1)
    for (int k = 1; k <= nodes; ++k) add(1 + (end - 1) * k / nodes);
  return wear;
}

}  // namespace

CutPlan plan(const GaugeInspection& spec, const PlanContext&) {
  const Gauges gauges(spec);
  const auto& outer = gauges.outer();
  const Detection d = detection(spec, gauges);
  const double accepted = gauges.good() * d.specificity + (1 - gauges.good()) * (1 - d.sensitivity);
  const double checks =
      static_cast<double>(k307::gauge_life_checks({.size_mm = Gauges::fresh(outer),
                                                   .wear_limit_mm = outer.b_wear_mm,
                                                   .wear_per_check_um = spec.wear_per_check_um})
                              .checks) *
      spec.replace_at_wear;
  CutPlan p;
  p.quantities.reserve(14);
  p.set_main_time(spec.check_min, "given");
  p.scrap_probability = 1 - accepted;
  p.detection = d;
  if (outer.wear_allowance_mm + outer.tolerance_mm > 0) p.gauge = wear_of(spec, gauges);
  auto& q = p.quantities;
  q.push_back({"good_share", gauges.good(), "1", "K307.gauge_pass_probability",
               "share of parts that conform: they pass gauges at the wear limit"});
  q.push_back({"pass_probability", accepted, "1", "K307.gauge_pass_probability", "share of parts accepted"});
  q.push_back({"producer_risk", 1 - d.specificity, "1", d.origin, "share of good parts that are rejected"});
  q.push_back({"consumer_risk", 1 - d.sensitivity, "1", d.origin, "share of defective parts that pass"});
  q.push_back(
      {"gauge_max_mm", outer.b_max_mm, "mm", "K307.gauge_outer_span", "new gauge over the far walls"});
  q.push_back({"gauge_min_mm", outer.b_min_mm, "mm", "K307.gauge_outer_span", "the same, least"});
  q.push_back(
      {"gauge_worn_mm", outer.b_wear_mm, "mm", "K307.gauge_outer_span", "the same at the wear limit"});
  q.push_back({"gauge_life_checks", checks, "1", "K307.gauge_life_checks", "checks that a gauge serves"});
  q.push_back({"allowed_deviation_mm",
               k307::allowed_center_deviation({spec.d1_mean_mm, spec.d2_mean_mm, spec.gauge.d1_min_mm,
                                               spec.gauge.d2_min_mm, spec.gauge.tolerance_mm})
                   .deviation_mm,
               "mm", "K307.allowed_center_deviation", "permitted at the mean diameters"});
  if (spec.producer_risk_max)
    p.limits.push_back({"producer_risk", 1 - d.specificity, *spec.producer_risk_max, true, "1", d.origin});
  if (spec.consumer_risk_max)
    p.limits.push_back({"consumer_risk", 1 - d.sensitivity, *spec.consumer_risk_max, true, "1", d.origin});
  if (checks > 0) {
    p.consumables.push_back(
        {"gauges", 1 / checks, "1", "K307.gauge_life_checks", "share of a pair of gauges"});
    p.consumables.push_back(
        {"gauge_cost", spec.gauge_cost / checks, "money", "K307.gauge_life_checks", "its price"});
  }
  return p;
}

namespace gauge_inspection {
void add_to(Kinds& kinds) {
  kinds.add<GaugeInspection>("The distance of two holes checked with gauges that wear.", {"K307"});
}
}  // namespace gauge_inspection

}  // namespace verstat::operations
