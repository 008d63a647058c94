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

std::vector<Field> StructFields<ReplaceAtFailedTeeth>::fields() {
  using S = ReplaceAtFailedTeeth;
  return {need<S>(&S::failed_teeth, "failed_teeth", "1", closed(1, 1000),
                  "failed teeth at which the cutter is pulled"),
          may<S>(&S::load_sharing, "load_sharing", "-", no_range(), "who takes the chip of a failed tooth"),
          may<S>(&S::load_exponent, "load_exponent", "1", closed(0, 4),
                 "exponent of the chip in the wear rate, feed exponent of the tool life law"),
          may<S>(&S::reduce_feed, "reduce_feed", "-", no_range(),
                 "table feed in proportion to the working teeth: their chip stays, parts take longer"),
          may<S>(&S::replace, "replace", "-", no_range(), "which teeth get new edges at failed_teeth"),
          may<S>(&S::older_than, "older_than", "1", closed(0, 100),
                 "wear in mean lives from which failed_and_older_than replaces a tooth that still cuts"),
          may<S>(&S::gamma, "gamma", "1", closed(0.01, 0.99),
                 "reliability level: all teeth are also changed at the gamma-percent life of one")};
}
std::vector<Field> StructFields<ShareOfLife>::fields() {
  return {need<ShareOfLife>(&ShareOfLife::share, "share", "1", closed(0, 1),
                            "share of its own life from which an edge shows its wear")};
}
std::vector<Field> StructFields<ForceGrowth>::fields() {
  using S = ForceGrowth;
  return {
      need<S>(&S::factor, "factor", "1", closed(1, 100), "radial force over that of a sharp edge"),
      may<S>(&S::wear_limit_mm, "wear_limit_mm", "mm", closed(0.01, 0.2), "flank wear at the end of life"),
      may<S>(&S::cylindrical_rake, "cylindrical_rake", "-", no_range(), "cylindrical instead of flat rake")};
}
std::vector<Field> StructFields<ConditionBased>::fields() {
  using S = ConditionBased;
  return {may<S>(&S::every_min, "every_min", "min", closed(1e-3, 1e9),
                 "cutting since the change or the last inspection; either this or every_parts"),
          may<S>(&S::every_parts, "every_parts", "1", closed(1, 1e9), "parts between inspections"),
          need<S>(&S::sign, "sign", "-", no_range(), "what shows that an edge is worn"),
          may<S>(&S::detection_probability, "detection_probability", "1", probability(),
                 "chance that an inspection notices a worn edge"),
          may<S>(&S::false_alarm_probability, "false_alarm_probability", "1", probability(),
                 "chance that an inspection takes a good edge for a worn one"),
          may<S>(&S::inspection_min, "inspection_min", "min", closed(0, 1e6),
                 "machine and crew time of one inspection; 0: monitored without a stop")};
}
std::vector<Field> StructFields<Opportunistic>::fields() {
  using S = Opportunistic;
  return {need<S>(&S::gamma, "gamma", "1", closed(0.01, 0.99),
                  "reliability level: probability that an edge survives its scheduled period"),
          may<S>(&S::window, "window", "1", closed(0, 1),
                 "last share of the scheduled period in which any stop of the machine is used")};
}

std::vector<Field> StructFields<InsertStock>::fields() {
  using S = InsertStock;
  return {need<S>(&S::stock, "stock", "1", closed(0, 1e9), "inserts on the shelf at the start"),
          may<S>(&S::reorder_point, "reorder_point", "1", closed(0, 1e9),
                 "an order is placed when shelf and orders less debts fall to this"),
          may<S>(&S::order_quantity, "order_quantity", "1", closed(1, 1e9), "inserts of one order"),
          need<S>(&S::lead_time, "lead_time", "min", no_range(), "from order to shelf")};
}
std::vector<Field> StructFields<CertifiedLots>::fields() {
  using S = CertifiedLots;
  return {
      may<S>(&S::lot_size, "lot_size", "1", closed(1, 1e6), "inserts of one lot"),
      need<S>(&S::ln_sd_between, "ln_sd_between", "1", closed(0, 2),
              "standard deviation of the logarithm of the lots' mean lives"),
      may<S>(&S::ln_sd_within, "ln_sd_within", "1", closed(0, 2),
             "standard deviation of the logarithm of the test result within a lot"),
      may<S>(&S::sample_size, "sample_size", "1", closed(1, 1e6), "inserts tested per lot"),
      may<S>(&S::test_correlation, "test_correlation", "1", closed(0, 1),
             "correlation of the lot means of test and life, in logarithms"),
      may<S>(&S::reject_fraction, "reject_fraction", "1", closed(0, 0.9), "share of the lots rejected"),
      may<S>(&S::rejected, "rejected", "-", no_range(), "what becomes of a rejected lot"),
      may<S>(&S::retreat_life_factor, "retreat_life_factor", "1", closed(0.01, 100),
             "mean life of a treated insert of a rejected lot over that before"),
      may<S>(&S::retreat_cost, "retreat_cost", "money", money, "treatment of one insert of a rejected lot"),
      may<S>(&S::test_cost, "test_cost", "money", money, "test of one insert of the sample")};
}

std::vector<Field> StructFields<Presetting>::fields() {
  return {may<Presetting>(&Presetting::crew, "crew", "-", no_range(),
                          "name of the crew that sets tools off the machines; empty: the tool's crew"),
          may<Presetting>(&Presetting::time, "time", "min", no_range(),
                          "setting one tool, on top of indexing or replacing its inserts")};
}
std::vector<Field> StructFields<Regrind>::fields() {
  return {need<Regrind>(&Regrind::time, "time", "min", no_range(), "a worn tool is away for regrinding"),
          may<Regrind>(&Regrind::max_regrinds, "max_regrinds", "1", closed(1, 1000),
                       "regrinds until the tool is thrown away"),
          may<Regrind>(&Regrind::life_factor, "life_factor", "1", closed(0.01, 2),
                       "lives after k regrinds are those of a new tool times this to the power of k")};
}
std::vector<Field> StructFields<ElementService>::fields() {
  using S = ElementService;
  return {need<S>(&S::element, "element", "-", no_range(),
                  "element that the plan of an operation names: \"guide pads\", \"wheel dressing\""),
          may<S>(&S::change, "change", "min", no_range(), "machine and crew time of a change"),
          may<S>(&S::price, "price", "money", money, "material of one change"),
          may<S>(&S::gamma, "gamma", "1", closed(0.01, 0.99),
                 "reliability level at which it is changed before the end of its life")};
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
          may<Insert>(&Insert::provenance, "provenance", "-", no_range(), "where the numbers come from"),
          may<Insert>(&Insert::preparation, "preparation", "-", no_range(),
                      "how the lot is sorted and treated before use: an operation kind that prepares a lot"),
          may<Insert>(&Insert::lots, "lots", "-", no_range(), "lots that differ, certified by samples"),
          may<Insert>(&Insert::crib, "crib", "-", no_range(),
                      "stock and reordering; none: there are always inserts")};
}

std::vector<Field> StructFields<ToolChange>::fields() {
  return {may<ToolChange>(&ToolChange::index, "index", "min", no_range(),
                          "time to turn the insert to its next edge"),
          may<ToolChange>(&ToolChange::replace, "replace", "min", no_range(), "time to fit a new insert"),
          may<ToolChange>(&ToolChange::positioning_min, "positioning_min", "min", closed(0, 1e6),
                          "added to every change: approach, trial cut, measuring"),
          may<ToolChange>(&ToolChange::failure_extra_min, "failure_extra_min", "min", closed(0, 1e6),
                          "added to a change after a failure"),
          may<ToolChange>(&ToolChange::stop_min, "stop_min", "min", closed(0, 1e6),
                          "added once per stop of the machine: edges changed in the same stop share it"),
          may<ToolChange>(&ToolChange::swap, "swap", "min", no_range(),
                          "time to put in a sister tool from the magazine or a copy from the crib")};
}

std::vector<Field> StructFields<Tool>::fields() {
  return {
      need<Tool>(&Tool::name, "name", "-", no_range(), "name that operations refer to"),
      may<Tool>(&Tool::insert, "insert", "-", no_range(),
                "name of the insert it holds; empty: only its elements wear"),
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
                "chance that a failure scraps the part in the machine"),
      may<Tool>(&Tool::teeth, "teeth", "1", closed(1, 200), "teeth, each with an insert"),
      may<Tool>(&Tool::failure_crew, "failure_crew", "-", no_range(),
                "name of the crew that comes after a failure; empty: the same"),
      may<Tool>(&Tool::copies, "copies", "1", closed(1, 1000),
                "sister tools in the magazine of each machine, or copies in all when shared"),
      may<Tool>(&Tool::shared, "shared", "-", no_range(), "the copies go from machine to machine"),
      may<Tool>(&Tool::magazine_places, "magazine_places", "1", closed(0, 100),
                "places that one copy takes in the magazine"),
      may<Tool>(&Tool::presetting, "presetting", "-", no_range(), "changed copies are set off the machine"),
      may<Tool>(&Tool::regrind, "regrind", "-", no_range(), "worn copies are reground"),
      entries(may<Tool>(&Tool::elements, "elements", "-", no_range(),
                        "further elements that operations wear, and what changing them takes"),
              0, 20),
      may<Tool>(&Tool::unattended_target, "unattended_target", "1", open(0, 1),
                "wanted share of unattended intervals that the sister tools last")};
}

}  // namespace verstat::models
