#pragma once
// Key performance indicators of a shop: names, units and formulas (ISO 22400-2 names where it has them).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::shop {

struct KpiInfo {
  std::string name;  ///< "cost_per_part", "machine/lathe 1/state/cutting"
  std::string unit;
  std::string meaning;  ///< one line with the formula
};

/// Takes one KPI: what it is, and its value (none where it is not defined).
using KpiSink = std::function<void(KpiInfo, std::optional<double>)>;

/// part / whole; none when the whole is not positive.
[[nodiscard]] inline std::optional<double> ratio(double part, double whole) {
  if (!(whole > 0)) return std::nullopt;
  return part / whole;
}

/// The KPIs that a run of this scenario yields, in order.
[[nodiscard]] std::vector<KpiInfo> kpi_infos(const scenarios::Scenario& scenario);

/// Name of member `index`, from 0, of a group of `count` identical machines: "lathe 2", or "lathe" when it is
/// alone.
[[nodiscard]] std::string numbered(const std::string& group, std::int64_t count, std::int64_t index);
[[nodiscard]] std::string machine_name(const scenarios::Machine& machine, std::int64_t index);

}  // namespace verstat::shop
