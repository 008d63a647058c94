// The checks of card K205; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/criteria/k205_hierarchical_efficiency.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k205;

namespace {

SimulationResult worked_example() {
  SimulationResult r;
  r.defect_rejected = 46;
  r.defect_accepted = 4;
  r.good_rejected = 19;
  r.good_accepted = 931;
  r.parts_started = 1000;
  r.defects_by_type = {30, 15, 5};
  r.detected_by_type = {29, 13, 4};
  r.diagnosis_time_min = 0.8;
  r.diagnosis_time_ideal_min = 0.5;
  r.production_cost_cu = 12000;
  r.diagnosis_cost_cu = 900;
  r.losses_cu = 1400;
  r.output_value_cu = 18620;
  r.missions = 120;
  r.missions_failure_free = 111;
  r.availability = 0.91;
  r.performance = 0.95;
  r.quality = 0.931;
  r.operator_load = 0.55;
  r.operator_load_limit = 1;
  return r;
}

}  // namespace

TEST_CASE("K205: the worked example of the card", "[K205]") {
  const Criteria c = evaluate_all_criteria(worked_example());
  CHECK(*c.e01 == Approx(0.672).margin(5e-4));
  CHECK(*c.e02 == Approx(0.980).margin(5e-4));
  CHECK(*c.e03 == Approx(12.955).margin(5e-4));
  CHECK(*c.e04 == Approx(12.952).margin(5e-4));
  CHECK(*c.e05 == Approx(0.214).margin(5e-4));
  CHECK(*c.e06 == Approx(0.438).margin(5e-4));
  CHECK(*c.e07 == Approx(128.83).margin(5e-3));
  CHECK(*c.e08 == Approx(0.420).margin(5e-4));
  CHECK(*c.e09 == Approx(0.232).margin(5e-4));
  CHECK(*c.e10 == Approx(1.086).margin(5e-4));
  CHECK(*c.e04 == Approx(12.9 / (1 - 4.0 / 1000)));
}

TEST_CASE("K205: perfect and useless diagnosis bound the information", "[K205]") {
  SimulationResult r = worked_example();
  r.defect_rejected = 50;
  r.defect_accepted = r.good_rejected = 0;
  r.good_accepted = 950;
  const Criteria perfect = evaluate_all_criteria(r);
  CHECK(*perfect.e01 == Approx(1));
  CHECK(*perfect.e02 == 1);
  CHECK(*perfect.e08 == Approx(0.5 / 0.8));
  verstat::test::property([] {
    const double defective = *rc::gen::inRange(1, 500);
    const double good = *rc::gen::inRange(1, 500);
    const double reject = *rc::gen::inRange(0, 101) * 0.01;
    const InformationRatio coin = criterion_information_ratio(
        {defective * reject, defective * (1 - reject), good * reject, good * (1 - reject)});
    RC_ASSERT(coin.efficiency < 1e-9);
    const InformationRatio some = criterion_information_ratio(
        {defective * reject, defective * (1 - reject), good * (1 - reject) * 0.5, good * (1 + reject) * 0.5});
    RC_ASSERT(some.obtained_bit >= 0);
    RC_ASSERT(some.obtained_bit <= some.needed_bit * (1 + 1e-12));
  });
}

TEST_CASE("K205: criteria without a denominator are left out", "[K205]") {
  SimulationResult r = worked_example();
  r.defect_rejected = r.good_rejected = 0;
  r.defect_accepted = 50;
  r.good_accepted = 950;
  r.detected_by_type = {0, 0, 0};
  r.diagnosis_cost_cu = r.diagnosis_time_min = 0;
  Criteria c = evaluate_all_criteria(r);
  CHECK(*c.e01 == 0);
  CHECK(*c.e02 == 1);
  CHECK_FALSE(c.e05);
  CHECK_FALSE(c.e08);
  CHECK_FALSE(c.e10);

  SimulationResult clean = worked_example();
  clean.defect_rejected = clean.defect_accepted = 0;
  clean.defects_by_type = clean.detected_by_type = {0, 0, 0};
  c = evaluate_all_criteria(clean);
  CHECK(*c.e01 == 1);
  CHECK(*c.e04 == Approx(12.9));
  CHECK(*c.e05 == 0);

  SimulationResult scrap = worked_example();
  scrap.good_accepted = 0;
  scrap.output_value_cu = 0;
  c = evaluate_all_criteria(scrap);
  CHECK_FALSE(c.e03);
  CHECK_FALSE(c.e09);
  CHECK(*c.e06 == 0);
}

TEST_CASE("K205: criterion 4 falls with every detection probability", "[K205]") {
  CHECK(criterion_inspection_set({10, 0.1, {1, 1}, {0.6, 0.4}}).efficiency_cu == Approx(10));
  CHECK(criterion_inspection_set({10, 0.1, {0, 0}, {0.6, 0.4}}).efficiency_cu == Approx(10 / 0.9));
  verstat::test::property([] {
    const double p = *rc::gen::inRange(0, 100) * 0.01;
    const double other = *rc::gen::inRange(0, 101) * 0.01;
    RC_ASSERT(criterion_inspection_set({10, 0.3, {p + 0.01, other}, {0.6, 0.4}}).efficiency_cu <
              criterion_inspection_set({10, 0.3, {p, other}, {0.6, 0.4}}).efficiency_cu);
  });
}

TEST_CASE("K205: no set of inspection operations beats the chosen one", "[K205]") {
  verstat::test::property([] {
    InspectionChoice in{20, 0.01 * *rc::gen::inRange(0, 60), {0.5, 0.3, 0.2}, {}, {}};
    const auto operations = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
    for (std::size_t k = 0; k < operations; ++k) {
      in.operation_cost_cu.push_back(0.5 * *rc::gen::inRange(0, 4));
      std::vector<double> d;
      for (int i = 0; i < 3; ++i) d.push_back(0.25 * *rc::gen::inRange(0, 5));
      in.detection.push_back(d);
    }
    const InspectionOptimum best = optimal_inspection_set(in);
    for (std::size_t set = 0; set < (std::size_t{1} << operations); ++set) {
      double cost = in.base_cost_cu;
      std::vector<std::int64_t> chosen;
      std::vector<double> found{0, 0, 0};
      for (std::size_t k = 0; k < operations; ++k)
        if ((set >> k) & 1U) {
          cost += in.operation_cost_cu[k];
          chosen.push_back(static_cast<std::int64_t>(k));
          for (std::size_t i = 0; i < 3; ++i) found[i] = 1 - (1 - found[i]) * (1 - in.detection[k][i]);
        }
      const double value =
          criterion_inspection_set({cost, in.defective_share, found, in.defect_share}).efficiency_cu;
      RC_ASSERT(value >= best.efficiency_cu - 2e-12);
      if (value < best.efficiency_cu + 1e-13) {
        RC_ASSERT(chosen.size() >= best.operations.size());
        if (chosen.size() == best.operations.size()) RC_ASSERT(chosen >= best.operations);
      }
    }
  });
}

TEST_CASE("K205: above 20 operations no single change improves the set", "[K205]") {
  InspectionChoice in{20, 0.5, {0.5, 0.5}, {}, {}};
  for (int k = 0; k < 24; ++k) {
    in.operation_cost_cu.push_back(0.1 + 0.07 * ((k * 7) % 11));
    in.detection.push_back({0.05 * ((k * 5) % 13), 0.05 * ((k * 3) % 17)});
  }
  const InspectionOptimum best = optimal_inspection_set(in);
  CHECK(best.operations.size() > 1);
  for (std::int64_t changed = 0; changed < 24; ++changed) {
    double cost = in.base_cost_cu;
    std::vector<double> found{0, 0};
    for (std::int64_t k = 0; k < 24; ++k) {
      const bool in_best =
          std::find(best.operations.begin(), best.operations.end(), k) != best.operations.end();
      if (in_best == (k == changed)) continue;
      const auto op = static_cast<std::size_t>(k);
      cost += in.operation_cost_cu[op];
      for (std::size_t i = 0; i < 2; ++i) found[i] = 1 - (1 - found[i]) * (1 - in.detection[op][i]);
    }
    CHECK(criterion_inspection_set({cost, 0.5, found, in.defect_share}).efficiency_cu >=
          best.efficiency_cu - 1e-11);
  }
}

TEST_CASE("K205: minimum <= multiplicative <= additive", "[K205]") {
  verstat::test::property([] {
    Aggregate in{{}, std::vector<double>{}, Form::additive};
    const int n = *rc::gen::inRange(1, 6);
    for (int k = 0; k < n; ++k) {
      in.values.push_back(*rc::gen::inRange(0, 100) * 0.01);
      in.weights->push_back(*rc::gen::inRange(k == 0 ? 1 : 0, 5));
    }
    const double additive = aggregate_criteria(in).efficiency;
    in.form = Form::multiplicative;
    const double product = aggregate_criteria(in).efficiency;
    in.form = Form::minimum;
    const double least = aggregate_criteria(in).efficiency;
    RC_ASSERT(product <= additive + 1e-12);
    RC_ASSERT(least <= product + 1e-12);
    if (in.values[0] == 0) RC_ASSERT(product == 0);
  });
}

TEST_CASE("K205: groups without a weighted criterion are left out, missed limits are named", "[K205]") {
  Hierarchy h;
  h.criteria.e01 = 0.5;
  h.criteria.e07 = 100;
  h.best.e01 = 1;
  h.worst.e01 = 0;
  h.best.e07 = 60;
  h.worst.e07 = 160;
  h.local_weights.e07 = 0;
  h.minimum.e07 = 0.7;
  h.minimum.e10 = 0;
  const HierarchicalEfficiency out = hierarchical_efficiency(h);
  CHECK(out.efficiency == Approx(0.5));
  CHECK(*out.groups.information == Approx(0.5));
  CHECK_FALSE(out.groups.reliability);
  CHECK(out.feasible == 0);
  CHECK(out.violated == std::vector<std::string>{"e07", "e10"});
}

TEST_CASE("K205: an exact match lies inside thresholds around zero", "[K205]") {
  verstat::test::property([] {
    const double target = *rc::gen::inRange(-50, 50);
    const double low = -0.1 * *rc::gen::inRange(1, 50);
    const double high = 0.1 * *rc::gen::inRange(1, 50);
    TargetInputs in;
    in.required = in.achieved = {target};
    in.lower = {low};
    in.upper = {high};
    in.scale = {1};
    const TargetMatch m = target_match(in);
    RC_ASSERT(m.level == 1);
    RC_ASSERT(m.within_count == 1);
  });
}

TEST_CASE("K205: Kendall tau is symmetric and bounded; the Pareto set is undominated", "[K205]") {
  verstat::test::property([] {
    CriteriaMatrix in;
    const int n = *rc::gen::inRange(1, 8);
    for (int k = 0; k < n; ++k)
      in.matrix.push_back({*rc::gen::inRange(0, 4) * 1.0, *rc::gen::inRange(0, 4) * 1.0, 3.0});
    const Conflict c = criteria_conflict(in);
    for (std::size_t a = 0; a < 3; ++a) {
      RC_ASSERT(c.tau[a][a] == 1);
      for (std::size_t b = 0; b < 3; ++b) {
        RC_ASSERT(c.tau[a][b] == c.tau[b][a]);
        RC_ASSERT(std::abs(c.tau[a][b]) <= 1 + 1e-12);
      }
    }
    RC_ASSERT(c.tau[0][2] == 0);
    for (const std::int64_t p : c.pareto)
      for (const auto& row : in.matrix) {
        const auto& mine = in.matrix[static_cast<std::size_t>(p)];
        RC_ASSERT(!(row[0] >= mine[0] && row[1] >= mine[1] && (row[0] > mine[0] || row[1] > mine[1])));
      }
  });
  const Conflict opposite = criteria_conflict({{{1, 3}, {2, 2}, {3, 1}}});
  CHECK(opposite.tau[0][1] == Approx(-1));
  CHECK(opposite.winners == std::vector<std::int64_t>{2, 0});
}

TEST_CASE("K205: bad input names itself", "[K205]") {
  CHECK_THROWS_WITH(
      criterion_inspection_set({10, 0.1, {0.5}, {0.6, 0.4}}),
      "K205.criterion_inspection_set: detection_probability has 1 entries, must have as many as "
      "defect_share, that is 2");
  CHECK_THROWS_WITH(normalize_criterion({1, 2, 2}),
                    "K205.normalize_criterion: best = 2, must differ from worst");
  CHECK_THROWS_WITH(criterion_information_ratio({0, 0, 0, 0}),
                    "K205.criterion_information_ratio: tp + fn + fp + tn = 0, at least one object must be "
                    "diagnosed");
}
