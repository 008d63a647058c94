#pragma once
// Operation kind "gauge_inspection": the distance of two holes checked with a pair of go gauges (K307). A new
// gauge rejects some good parts (producer's risk); as it wears the risk vanishes, and a gauge used beyond its
// wear limit lets defective parts pass (consumer's risk).

#include <cstdint>

#include "models/inspection/k307_location_gauges.h"
#include "operations/kind.h"

namespace verstat::operations {

struct GaugeInspection {
  static constexpr const char* kind = "gauge_inspection";
  models::k307::GaugeDesign gauge;
  double distance_mean_mm = 0;  ///< of the process
  double distance_sigma_mm = 0;
  double d1_mean_mm = 0;
  double d1_sigma_mm = 0;
  double d2_mean_mm = 0;
  double d2_sigma_mm = 0;
  double check_min = 0;
  double wear_per_check_um = 0.002;
  double replace_at_wear = 1;      ///< share of the wear allowance at which a gauge is replaced
  std::optional<double> worn_now;  ///< share used; not given: the mean over the life of the gauge
  double gauge_cost = 0;           ///< of the pair
  double replace_min = 0;          ///< time of the station to replace it
  std::optional<double> consumer_risk_max;
  std::optional<double> producer_risk_max;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const GaugeInspection& spec, const PlanContext& context);

}  // namespace verstat::operations
