#pragma once
// What a shop can be simulated with and yet should not be: regimes that overload a machine, resonate or make
// bad parts, and drawings that are not met.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/scenario.h"

namespace verstat::scenarios {

struct Warning {
  std::string pointer;    ///< "/operations/0/process" or "/parts/0/requirements/1"
  std::string operation;  ///< name; of a requirement: of the part type
  std::string machine;    ///< group it is planned on
  std::string limit;      ///< what is limited: "spindle_speed_rpm"
  double value = 0;
  double low = 0;    ///< lower end of a forbidden band, else the bound
  double high = 0;   ///< upper end
  std::string text;  ///< one line with all of it
};

/// Of a checked scenario: every limit that the plan of an operation on one of its machine groups exceeds,
/// every forbidden band that it lies in, and every requirement whose mean lies on the wrong side of the
/// bound. In the order of the scenario.
[[nodiscard]] std::vector<Warning> warnings(const Scenario& scenario);

/// {"pointer", "operation", "machine", "limit", "value", "low", "high", "text"} for each.
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<Warning>& all);

}  // namespace verstat::scenarios
