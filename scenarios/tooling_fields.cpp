// The one description of inserts, tools and strategies: name, unit, valid range, default and meaning.
#include "scenarios/tooling_fields.h"

#include "operations/fields.h"

namespace verstat::models {

using namespace scenarios;

namespace {

constexpr Range money = closed(0, 1e12);

template <class S>
std::vector<Field> reliability_level() {
  return {need<S>(&S::gamma, "gamma", "1", closed(0.01, 0.99),
                  "reliability level: probability that an edge survives its scheduled period")};
}

}  // namespace

std::vector<Field> StructFields<RunToFailure>::fields() {
  return {};
}
std::vector<Field> StructFields<AgeReplacement>::fields() {
  return reliability_level<AgeReplacement>();
}
std::vector<Field> StructFields<PartCountReplacement>::fields() {
  return reliability_level<PartCountReplacement>();
}
std::vector<Field> StructFields<BlockReplacement>::fields() {
  return reliability_level<BlockReplacement>();
}

std::vector<Field> StructFields<Insert>::fields() {
  return {need<Insert>(&Insert::name, "name", "-", no_range(), "name that tools refer to"),
          may<Insert>(&Insert::grade, "grade", "-", no_range(), "carbide grade or cutting material"),
          may<Insert>(&Insert::edges, "edges", "1", closed(1, 16), "cutting edges of one insert"),
          need<Insert>(&Insert::price, "price", "money", money, "price of one insert"),
          need<Insert>(&Insert::edge_life, "edge_life", "-", no_range(), "life of one edge"),
          may<Insert>(&Insert::reserve_ok_probability, "reserve_ok_probability", "1", probability(),
                      "chance that a failed edge leaves the next one usable"),
          may<Insert>(&Insert::single_edge_probability, "single_edge_probability", "1", probability(),
                      "chance that a fitted insert has only one usable edge"),
          may<Insert>(&Insert::provenance, "provenance", "-", no_range(), "where the numbers come from")};
}

std::vector<Field> StructFields<ToolChange>::fields() {
  return {may<ToolChange>(&ToolChange::index, "index", "min", no_range(),
                          "time to turn the insert to its next edge"),
          may<ToolChange>(&ToolChange::replace, "replace", "min", no_range(), "time to fit a new insert"),
          may<ToolChange>(&ToolChange::positioning_min, "positioning_min", "min", closed(0, 1e6),
                          "added to every change: approach, trial cut, measuring"),
          may<ToolChange>(&ToolChange::failure_extra_min, "failure_extra_min", "min", closed(0, 1e6),
                          "added to a change after a failure")};
}

std::vector<Field> StructFields<Tool>::fields() {
  return {need<Tool>(&Tool::name, "name", "-", no_range(), "name that operations refer to"),
          need<Tool>(&Tool::insert, "insert", "-", no_range(), "name of the insert it holds"),
          may<Tool>(&Tool::strategy, "strategy", "-", no_range(), "when an edge is changed"),
          need<Tool>(&Tool::crew, "crew", "-", no_range(), "name of the crew that changes edges"),
          may<Tool>(&Tool::change, "change", "-", no_range(), "how long a change takes"),
          may<Tool>(&Tool::insert_booking, "insert_booking", "-", no_range(),
                    "when the price of an insert is booked"),
          may<Tool>(&Tool::periods_planned, "periods_planned", "1", open_low(0, 1000),
                    "life periods one insert yields when changed as planned"),
          may<Tool>(&Tool::periods_failure, "periods_failure", "1", open_low(0, 1000),
                    "life periods one insert yields when run to failure"),
          may<Tool>(&Tool::regrind_planned, "regrind_planned", "money", money,
                    "regrinding after a planned change"),
          may<Tool>(&Tool::regrind_failure, "regrind_failure", "money", money, "regrinding after a failure"),
          may<Tool>(&Tool::failure_damage, "failure_damage", "money", money,
                    "holder, shim and rework per failure"),
          may<Tool>(&Tool::failure_scrap_probability, "failure_scrap_probability", "1", probability(),
                    "chance that a failure scraps the part in the machine")};
}

}  // namespace verstat::models
