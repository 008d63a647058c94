// Gauges and sets of checks: risks against direct calculation and simulation of parts.
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include "models/inspection/k307_location_gauges.h"
#include "operations/kinds/gauge_inspection.h"
#include "operations/kinds/inspection.h"
#include "tests/operations/gallery.h"

using namespace verstat;
using namespace verstat::operations;
using Catch::Matchers::Contains;
using namespace verstat::test;
namespace k307 = models::k307;

TEST_CASE("gauges: new ones reject good parts, worn-out ones pass bad parts", "[K307]") {
  GalleryExample<GaugeInspection> example;
  const auto risks = [&](double worn) {
    auto spec = example.spec;
    spec.worn_now = worn;
    const auto p = example.Gallery::plan(spec);
    return std::pair{value_of(p, "producer_risk"), value_of(p, "consumer_risk")};
  };
  double producer_before = 1;
  for (const double worn : {0.0, 0.25, 0.5, 0.75}) {
    const auto [producer, consumer] = risks(worn);
    CHECK(producer < producer_before);
    CHECK(producer > 0);
    CHECK(consumer == 0);
    producer_before = producer;
  }
  CHECK(risks(1) == std::pair{0.0, 0.0});
  CHECK(risks(1.5).first == 0);
  CHECK(risks(1.5).second > 0);
  CHECK(risks(2.5).second > risks(1.5).second);

  // The mean over the life of a gauge lies between its ends, and is the mean of many states.
  const auto p = example.plan();
  CHECK(p.feasible());
  double mean = 0;
  for (int k = 0; k < 200; ++k) mean += risks((k + 0.5) / 200).first / 200;
  CHECK(value_of(p, "producer_risk") == Approx(mean).epsilon(1e-4));
  // Gauge of 119.814 +- 0.006 with 14 um to wear at 2 nm a check.
  CHECK(value_of(p, "gauge_life_checks") == 7000);
  CHECK(p.consumables.at(1).value == Approx(150.0 / 7000));
  REQUIRE(p.detection);
  const Detection& d = *p.detection;
  CHECK(p.scrap_probability ==
        Approx(d.defective_share * d.sensitivity + (1 - d.defective_share) * (1 - d.specificity)));
}

TEST_CASE("gauges: risks agree with parts drawn one by one", "[K307]") {
  GalleryExample<GaugeInspection> example;
  auto& spec = example.spec;
  spec.distance_sigma_mm = 0.15;  // a poor process: both risks large enough to count
  const auto outer = k307::gauge_outer_span(spec.gauge);
  const auto inner = k307::gauge_inner_span(spec.gauge);
  boost::random::mt19937_64 engine(20261122);
  const auto draw = [&](double mean, double sigma) {
    return boost::random::normal_distribution<double>(mean, sigma)(engine);
  };
  for (const double worn : {0.0, 2.0}) {
    spec.worn_now = worn;
    const auto p = example.plan();
    const auto at = [&](const k307::GaugeSizes& sizes, double share) {
      const double fresh = (sizes.b_max_mm + sizes.b_min_mm) / 2;
      return fresh + share * (sizes.b_wear_mm - fresh);
    };
    int good = 0, good_rejected = 0, bad_accepted = 0;
    constexpr int parts = 60'000;
    for (int k = 0; k < parts; ++k) {
      k307::GaugedPart part;
      part.distance_mm = draw(spec.distance_mean_mm, spec.distance_sigma_mm);
      part.d1_mm = draw(spec.d1_mean_mm, spec.d1_sigma_mm);
      part.d2_mm = draw(spec.d2_mean_mm, spec.d2_sigma_mm);
      part.b_outer_mm = outer.b_wear_mm;
      part.b_inner_mm = inner.b_wear_mm;
      const bool conforms = k307::gauge_accepts(part).accept;
      part.b_outer_mm = at(outer, worn);
      part.b_inner_mm = at(inner, worn);
      const bool accepted = k307::gauge_accepts(part).accept;
      good += conforms;
      good_rejected += conforms && !accepted;
      bad_accepted += !conforms && accepted;
    }
    const double n_good = good, n_bad = parts - good;
    const auto within = [](double seen, double of, double expected) {
      const double share = seen / of;
      return std::abs(share - expected) <= 4 * std::sqrt(std::max(expected * (1 - expected), 1e-12) / of);
    };
    CHECK(within(good, parts, value_of(p, "good_share")));
    CHECK(within(good_rejected, n_good, value_of(p, "producer_risk")));
    CHECK(within(bad_accepted, n_bad, value_of(p, "consumer_risk")));
    CHECK((worn < 1 ? good_rejected : bad_accepted) > 100);  // enough to notice a fault
  }
}

TEST_CASE("a set of checks: the cheapest set, its risks and its time", "[K205]") {
  GalleryExample<Inspection> example;
  const auto p = example.plan();
  CHECK(p.feasible());
  // By hand: gauge and look. Found: 0.5 0.9 + 0.3 0.4 + 0.2 0.5.
  REQUIRE(p.detection);
  CHECK(p.detection->sensitivity == Approx(0.67));
  CHECK(p.detection->specificity == Approx(0.99 * 0.98));
  CHECK(p.main_time_min == Approx(0.3));
  CHECK(value_of(p, "cost_per_conforming") == Approx(20.35 / (1 - 0.08 * 0.33)));
  CHECK(p.scrap_probability == Approx(0.08 * 0.67 + 0.92 * (1 - 0.99 * 0.98)));

  // No set of checks costs less per part that does not escape with a defect.
  const std::size_t checks = example.spec.checks.size();
  for (std::size_t set = 0; set < (std::size_t{1} << checks); ++set) {
    auto spec = example.spec;
    spec.chosen.emplace();
    for (std::size_t k = 0; k < checks; ++k)
      if ((set >> k & 1) != 0) spec.chosen->push_back(spec.checks[k].name);
    CHECK(value_of(example.Gallery::plan(spec), "cost_per_conforming") >=
          value_of(p, "cost_per_conforming") * (1 - 1e-12));
  }
  auto all = example.spec;
  all.chosen = {"measuring machine"};
  CHECK(value_of(example.Gallery::plan(all), "escape_probability") == Approx(0.08 * 0.05));
  all.chosen = {"measuring maschine"};
  CHECK_THAT(refusal(all), Contains("chosen/0"));
  auto ragged = example.spec;
  ragged.checks[1].detection.pop_back();
  CHECK_THAT(refusal(ragged), Contains("checks/1/detection"));
}
