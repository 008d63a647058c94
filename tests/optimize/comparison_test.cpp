// Comparisons of variants: what is refused, when they end, and what is said of them in words.
#include <cmath>

#include <catch2/catch.hpp>

#include "optimize/compare.h"
#include "sim/kernel/random_stream.h"

using namespace verstat;
using namespace verstat::optimize;

namespace {

shop::RunResult table(const std::vector<std::vector<std::optional<double>>>& values,
                      std::vector<shop::KpiInfo> kpis) {
  shop::RunResult r;
  r.kpis = std::move(kpis);
  r.values = values;
  std::vector<std::optional<double>> column(values.size());
  for (std::size_t k = 0; k < r.kpis.size(); ++k) {
    for (std::size_t i = 0; i < values.size(); ++i) column[i] = values[i][k];
    r.estimates.push_back(shop::estimate(column));
  }
  return r;
}

Difference difference(const char* kpi, double first, double mean, double half, Verdict verdict,
                      const char* unit = "UAH") {
  return {.kpi = kpi,
          .unit = unit,
          .first = {first, 0.1, 10},
          .other = {first + mean, 0.1, 10},
          .difference = {mean, half, 10},
          .verdict = verdict};
}

}  // namespace

TEST_CASE("replications are appended as if they had been made at once") {
  const std::vector<shop::KpiInfo> kpis{{"a", "1", ""}, {"b", "h", ""}};
  shop::RunResult to;
  append(to, table({{1, 5}, {2, std::nullopt}}, kpis));
  to.events = 7;
  auto more = table({{6, 8}}, kpis);
  more.events = 5;
  append(to, more);
  const auto whole = table({{1, 5}, {2, std::nullopt}, {6, 8}}, kpis);
  CHECK(to.events == 12);
  CHECK(to.values == whole.values);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(to.estimates[k].mean == whole.estimates[k].mean);
    CHECK(to.estimates[k].half_width == whole.estimates[k].half_width);
    CHECK(to.estimates[k].samples == whole.estimates[k].samples);
  }
  CHECK(*to.estimates[0].mean == Approx(3));
  CHECK(*to.estimates[1].mean == Approx(6.5));
  CHECK_THROWS_WITH(append(to, table({{1}}, {{"a", "1", ""}})), "two runs of one scenario differ in KPIs");
}

TEST_CASE("comparisons that cannot be made") {
  const auto run = [](std::size_t variant, std::uint64_t, std::int64_t count) {
    std::vector<std::vector<std::optional<double>>> rows(static_cast<std::size_t>(count), {1.0});
    return table(rows, {{variant == 1 ? "other" : "cost_per_part", "UAH", ""}});
  };
  CHECK_THROWS_WITH(compare(1, run, {}), "a comparison needs two variants");
  CHECK_THROWS_WITH(compare(2, run, {.kpis = {}}), "a comparison needs a KPI");
  CHECK_THROWS_WITH(compare(2, run, {.kpis = {"cost_per_part"}}),
                    "there is no KPI \"cost_per_part\" in every variant");
  CHECK_THROWS_WITH(compare(2, run, {.kpis = {"other"}}), "there is no KPI \"other\" in every variant");
}

TEST_CASE(
    "a comparison doubles until the first KPI is clear of every variant; each interval gets its share") {
  // Differences of known size, with noise of standard deviation 1 in pairs.
  std::vector<std::pair<std::size_t, std::int64_t>> asked;
  const auto run_with = [&](const std::vector<double>& shifts) {
    return [&asked, shifts](std::size_t variant, std::uint64_t first, std::int64_t count) {
      asked.emplace_back(variant, count);
      std::vector<std::vector<std::optional<double>>> rows;
      for (std::uint64_t r = first; r < first + static_cast<std::uint64_t>(count); ++r) {
        sim::RandomStream own(5, "variant " + std::to_string(variant), "noise", r);
        sim::RandomStream shared(5, "all", "noise", r);
        const double noise = variant == 0 ? 0 : own.uniform(-1.7, 1.7);
        rows.push_back({100 + 30 * shared.uniform() + shifts[variant] + noise, 1.0});
      }
      return table(rows, {{"cost_per_part", "UAH", ""}, {"constant", "1", ""}});
    };
  };
  const CompareOptions options{.kpis = {"cost_per_part", "constant"},
                               .indifference = 1e-4,
                               .first_replications = 10,
                               .max_replications = 160};
  const Comparison clear = compare(3, run_with({0, 8, -8}), options);
  CHECK(clear.clear);
  CHECK(clear.replications == 10);
  CHECK(clear.differences[0][0].verdict == Verdict::more);
  CHECK(clear.differences[1][0].verdict == Verdict::less);
  CHECK(clear.differences[0][1].verdict == Verdict::unchanged);  // no difference at all
  CHECK(*clear.differences[0][1].difference.half_width == 0);
  CHECK(asked.size() == 3);
  asked.clear();
  // Nothing to be told apart: up to the budget, each replication once.
  const Comparison unclear = compare(2, run_with({0, 0.001}), options);
  CHECK_FALSE(unclear.clear);
  CHECK(unclear.replications == 160);
  CHECK(unclear.differences[0][0].verdict == Verdict::unclear);
  std::int64_t made = 0;
  for (const auto& [variant, count] : asked)
    if (variant == 1) made += count;
  CHECK(made == 160);
  // Five looks at one variant, five at each of two: the intervals are wider, in the ratio of the quantiles.
  const auto half_of = [&](std::size_t variants) {
    return *compare(variants, run_with({0, 0.001, 0.001}), options).differences[0][0].difference.half_width;
  };
  CHECK(half_of(3) / half_of(2) == Approx(2.851 / 2.607).epsilon(0.01));  // Student, 159, at 0.9975 and 0.995
}

TEST_CASE("a comparison without values is unclear") {
  const auto empty = [](std::size_t variant, std::uint64_t, std::int64_t count) {
    std::vector<std::vector<std::optional<double>>> rows(
        static_cast<std::size_t>(count), {variant == 0 ? std::optional<double>() : std::optional(1.0)});
    return table(rows, {{"lead_time_min", "min", ""}});
  };
  const Comparison c = compare(2, empty, {.kpis = {"lead_time_min"}, .max_replications = 20});
  CHECK_FALSE(c.clear);
  CHECK(c.differences[0][0].verdict == Verdict::unclear);
  CHECK(in_words(c.differences[0][0]) == "lead time: there are too few values to compare");
}

TEST_CASE("names of KPIs in words") {
  CHECK(kpi_in_words("throughput_per_h") == "throughput");
  CHECK(kpi_in_words("lead_time_min") == "lead time");
  CHECK(kpi_in_words("energy_kwh") == "energy");
  CHECK(kpi_in_words("quality_ratio") == "quality ratio");
  CHECK(kpi_in_words("_min") == " min");  // nothing would be left
  CHECK(kpi_in_words("cost/idle") == "cost (idle)");
  CHECK(kpi_in_words("load/cam_mill") == "load (cam mill)");
  CHECK(kpi_in_words("tool/roughing tool/failure_share") == "failure share of roughing tool");
  CHECK(kpi_in_words("machine/lathe/state/idle") == "idle of lathe");
  CHECK(kpi_in_words("store/finished/waiting_min") == "waiting of finished");
  CHECK(kpi_in_words("already in words") == "already in words");
}

TEST_CASE("differences in words: sign, digits, percent or unit") {
  CHECK(in_words(difference("cost_per_part", 200, -6.2, 0.8, Verdict::less)) ==
        "costs 3.10 +- 0.40 % less per part");
  CHECK(in_words(difference("cost_per_part", 200, 6.2, 0.8, Verdict::more)) ==
        "costs 3.10 +- 0.40 % more per part");
  CHECK(in_words(difference("cost_per_good_part", 200, 0, 0.8, Verdict::unchanged)) ==
        "costs the same per good part");
  CHECK(in_words(difference("cost_per_good_part", 200, -6.2, 0.8, Verdict::less)) ==
        "costs 3.10 +- 0.40 % less per good part");
  CHECK(in_words(difference("throughput_per_h", 4, 0.5, 0.05, Verdict::more)) ==
        "throughput is 12.5 +- 1.2 % higher");
  CHECK(in_words(difference("throughput_per_h", 4, -0.5, 0.4, Verdict::less)) ==
        "throughput is 12 +- 10 % lower");
  CHECK(in_words(difference("throughput_per_h", 4, 0, 0.001, Verdict::unchanged)) ==
        "throughput is unchanged");
  CHECK(in_words(difference("throughput_per_h", 4, -0.01, 0.04, Verdict::unclear)) ==
        "throughput: no difference can be told (-0.2 +- 1.0 %)");
  // Of nothing there is no percentage; a negative first value has a size all the same.
  CHECK(in_words(difference("lead_time_min", 0, 3.25, 0.5, Verdict::more, "min")) ==
        "lead time is 3.25 +- 0.50 min higher");
  CHECK(in_words(difference("profit", -200, 6.2, 0.8, Verdict::more)) == "profit is 3.10 +- 0.40 % higher");
  CHECK(in_words(difference("lead_time_min", 0, 0.1, 0.5, Verdict::unclear, "min")) ==
        "lead time: no difference can be told (+0.10 +- 0.50 min)");
  // No scatter at all, and very little of it.
  CHECK(in_words(difference("throughput_per_h", 4, 1, 0, Verdict::more)) ==
        "throughput is 25.00 +- 0.00 % higher");
  CHECK(in_words(difference("throughput_per_h", 4, 1, 4e-12, Verdict::more)) ==
        "throughput is 25.000000 +- 0.000000 % higher");
  Difference few = difference("throughput_per_h", 4, 1, 0.1, Verdict::unclear);
  few.difference.half_width.reset();
  CHECK(in_words(few) == "throughput: there are too few values to compare");
  few = difference("throughput_per_h", 4, 1, 0.1, Verdict::unclear);
  few.difference.mean.reset();
  CHECK(in_words(few) == "throughput: there are too few values to compare");
  const auto cheaper = difference("cost_per_part", 200, -6.2, 0.8, Verdict::less);
  const auto same = difference("throughput_per_h", 4, 0, 0.001, Verdict::unchanged);
  CHECK(in_words("gamma 0.85", {cheaper, same}) ==
        "gamma 0.85 costs 3.10 +- 0.40 % less per part; throughput is unchanged.");
  CHECK(in_words("gamma 0.85", {same, cheaper}) ==
        "gamma 0.85: throughput is unchanged; costs 3.10 +- 0.40 % less per part.");
}
