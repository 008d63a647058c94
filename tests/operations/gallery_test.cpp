// Every operation of the gallery loads, plans and says where its numbers come from; every kind has one.
#include "tests/operations/gallery.h"

#include <cmath>
#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

using namespace verstat;

TEST_CASE("every operation kind has a gallery operation that plans") {
  std::set<std::string> shown;
  for (const auto& entry :
       std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations")) {
    INFO(entry.path().string());
    const auto operation = scenarios::load_operation(scenarios::read_json_file(entry.path().string()));
    CHECK_FALSE(operation.description.empty());
    shown.insert(operation.process.kind()->name);
    const operations::CutPlan plan = operation.plan();
    // Written and read again, the operation says the same.
    using Binding = models::detail::Binding<operations::Process>;
    const auto written = scenarios::to_json(Binding::write(operation.process));
    CHECK(scenarios::to_json(Binding::write(test::process_of(written))) == written);
    CHECK(plan.main_time_min >= 0);
    REQUIRE_FALSE(plan.quantities.empty());
    CHECK(plan.value_of("main_time_min") == plan.main_time_min);
    std::set<std::string> names;
    for (const auto& list : {plan.quantities, plan.consumables})
      for (const operations::Quantity& q : list) {
        INFO(q.name);
        CHECK(std::isfinite(q.value));
        CHECK(std::string(q.origin) != "");
        CHECK(std::string(q.meaning) != "");
      }
    for (const auto& limit : plan.limits) {
      INFO(limit.name);
      CHECK(std::isfinite(limit.margin()));
    }
  }
  for (const auto& kind : operations::kinds().all()) {
    INFO(kind->name);
    CHECK(shown.contains(kind->name));
    CHECK_FALSE(kind->summary.empty());
  }
}
