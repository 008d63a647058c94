#include "sim/shop/run.h"

#include <mutex>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/kernel/errors.h"
#include "sim/kernel/output_analysis.h"
#include "sim/kernel/replications.h"
#include "sim/shop/fingerprint.h"
#include "sim/shop/shop.h"

namespace verstat::shop {

Estimate estimate(const std::vector<std::optional<double>>& values, double confidence) {
  sim::Tally tally;
  for (const auto& value : values)
    if (value) tally.add(*value);
  Estimate result{.samples = static_cast<std::int64_t>(tally.count())};
  if (tally.count() > 0) result.mean = tally.mean();
  if (tally.count() > 1) result.half_width = sim::confidence_interval(tally, confidence).half_width;
  return result;
}

std::optional<std::size_t> RunResult::index_of(const std::string& kpi) const {
  for (std::size_t k = 0; k < kpis.size(); ++k)
    if (kpis[k].name == kpi) return k;
  return std::nullopt;
}

namespace {

// Each replication gives Wilson's interval of its own unattended intervals; what the run tells comes from all
// of them together, not from the mean of the bounds.
void pool_unattended_intervals(RunResult& result) {
  const auto sum_of = [&](std::size_t kpi) {
    double sum = 0;
    for (const auto& values : result.values) sum += values[kpi].value_or(0);
    return static_cast<std::int64_t>(sum);
  };
  constexpr std::string_view first = "/unattended/intervals";  // then quiet, no_stop_low, no_stop_high
  for (std::size_t k = 0; k + 3 < result.kpis.size(); ++k) {
    if (!result.kpis[k].name.ends_with(first)) continue;
    const std::int64_t intervals = sum_of(k);
    if (intervals == 0) continue;
    const auto sure = sim::wilson_interval(sum_of(k + 1), intervals);
    result.estimates[k + 2] = {.mean = sure.low, .samples = result.estimates[k + 2].samples};
    result.estimates[k + 3] = {.mean = sure.high, .samples = result.estimates[k + 3].samples};
  }
}

}  // namespace

std::string fingerprint_of(const RunResult& result) {
  if (result.courses.size() != result.values.size()) return {};
  Fingerprint all;
  for (const KpiInfo& kpi : result.kpis) all.add(std::string_view(kpi.name));
  for (const auto& replication : result.values)
    for (const auto& value : replication) {
      all.add(static_cast<std::uint64_t>(value.has_value()));
      all.add(value.value_or(0.0));
    }
  all.add(result.events);
  for (const std::uint64_t course : result.courses) all.add(course);
  return fmt::format("{:016x}", all.value());
}

RunResult run_scenario(const scenarios::Scenario& scenario, int threads, const Progress& progress,
                       Checks checks) {
  return run_replications(scenario, 0, scenario.simulation.replications, threads, progress, checks);
}

RunResult run_replications(const scenarios::Scenario& scenario, std::uint64_t first, std::int64_t count,
                           int threads, const Progress& progress, Checks checks) {
  const auto replications = static_cast<std::size_t>(count);
  RunResult result;
  result.kpis = kpi_infos(scenario);
  if (replications > most_values / result.kpis.size())
    throw sim::BudgetError(
        fmt::format("{} replications of {} KPIs are more than {} values: ask for fewer replications "
                    "(/simulation/replications) or machines",
                    replications, result.kpis.size(), most_values));
  std::mutex progress_mutex;
  std::int64_t done = 0;
  struct Outcome {
    std::vector<std::optional<double>> values;
    std::uint64_t events;
    std::uint64_t course;
    std::uint64_t event_order;
    std::vector<std::string> broken_laws;
    std::string standstill;
  };
  const auto one = [&](std::size_t replication) {
    Shop shop(scenario, first + replication);
    if (checks == Checks::on) shop.watch_event_order();
    Outcome outcome{shop.run(), shop.events_executed(), shop.course(), shop.event_order(),
                    {},         shop.standstill()};
    if (checks == Checks::on)
      for (const std::string& law : shop.audit())
        outcome.broken_laws.push_back(fmt::format("replication {}: {}", first + replication, law));
    if (progress) {
      const std::scoped_lock lock(progress_mutex);
      progress(++done, count);
    }
    return outcome;
  };
  std::vector<Outcome> outcomes = sim::run_replications(replications, static_cast<unsigned>(threads), one);

  Fingerprint event_order;
  for (Outcome& outcome : outcomes) {
    result.events += outcome.events;
    result.courses.push_back(outcome.course);
    event_order.add(outcome.event_order);
    for (std::string& law : outcome.broken_laws) result.broken_laws.push_back(std::move(law));
    if (!outcome.standstill.empty())
      result.standstills.push_back(
          fmt::format("replication {}, {}", first + result.values.size(), outcome.standstill));
    result.values.push_back(std::move(outcome.values));
  }
  if (checks == Checks::on) result.event_order = event_order.value();
  std::vector<std::optional<double>> column(replications);
  for (std::size_t k = 0; k < result.kpis.size(); ++k) {
    for (std::size_t r = 0; r < replications; ++r) column[r] = result.values[r][k];
    result.estimates.push_back(estimate(column));
  }
  pool_unattended_intervals(result);
  return result;
}

Estimate paired_difference(const RunResult& a, const RunResult& b, const std::string& kpi,
                           double confidence) {
  const auto in_a = a.index_of(kpi);
  const auto in_b = b.index_of(kpi);
  if (!in_a || !in_b) throw std::invalid_argument("there is no KPI \"" + kpi + "\"");
  if (a.values.size() != b.values.size())
    throw std::invalid_argument("the runs differ in their number of replications");
  std::vector<std::optional<double>> difference(a.values.size());
  for (std::size_t r = 0; r < difference.size(); ++r)
    if (a.values[r][*in_a] && b.values[r][*in_b]) difference[r] = *b.values[r][*in_b] - *a.values[r][*in_a];
  return estimate(difference, confidence);
}

}  // namespace verstat::shop
