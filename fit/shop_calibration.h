#pragma once
// Calibration with the simulator of the shop: which inputs, which totals, and the answer in words.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fit/calibration.h"
#include "fit/report.h"

namespace verstat::fit {

/// {"counted_hours": 720, "totals": [{"kpi", "value" or "hours", "sd"}], "uncertain": [{"pointer", "low",
/// "high", "scale": "log", "mean", "sd"}]}.
struct CalibrationSpec {
  std::string file;
  double counted_min = 0;
  std::vector<ObservedTotal> totals;
  std::vector<UncertainInput> inputs;  ///< named by their pointers
};
/// "POINTER=LOW..HIGH" of --uncertain is added to the inputs of the file. Throws InputError naming the place.
[[nodiscard]] CalibrationSpec read_calibration(const std::string& file,
                                               const std::vector<std::string>& uncertain);

/// `scenario`: the JSON of the shop with its changes made. Throws InputError for a pointer, KPI or limit that
/// the scenario does not have or accept.
[[nodiscard]] Report calibrate_shop(const nlohmann::json& scenario, const CalibrationSpec& spec,
                                    const CalibrationOptions& options, int threads, Origin origin);

}  // namespace verstat::fit
