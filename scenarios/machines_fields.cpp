// The one description of machines, people and what stops machines: name, unit, valid range, default, meaning.
#include "scenarios/machines_fields.h"

#include "operations/fields.h"

namespace verstat::models {

using namespace scenarios;

namespace {
constexpr Range money = closed(0, 1e12);
constexpr Range minutes = closed(0, 1e9);
constexpr Range priority_range = closed(-1000, 1000);
}  // namespace

std::vector<Field> StructFields<Shift>::fields() {
  return {entries(need<Shift>(&Shift::days, "days", "-", no_range(), "days on which it begins"), 1, 7),
          need<Shift>(&Shift::from_h, "from_h", "h", closed(0, 24), "hour of the day at which it begins"),
          need<Shift>(&Shift::to_h, "to_h", "h", open_low(0, 48),
                      "hour at which it ends; above 24: on the next day")};
}
std::vector<Field> StructFields<Holiday>::fields() {
  return {need<Holiday>(&Holiday::first_day, "first_day", "d", closed(0, 1'000'000),
                        "first day without work, counted from Monday = 0 at the start"),
          may<Holiday>(&Holiday::days, "days", "d", closed(1, 3660), "number of days")};
}
std::vector<Field> StructFields<Calendar>::fields() {
  return {
      need<Calendar>(&Calendar::name, "name", "-", no_range(), "name that machines and crews refer to"),
      entries(need<Calendar>(&Calendar::shifts, "shifts", "-", no_range(), "working time of every week"), 1,
              100),
      entries(may<Calendar>(&Calendar::breaks, "breaks", "-", no_range(), "taken out of the shifts"), 0, 100),
      entries(may<Calendar>(&Calendar::holidays, "holidays", "-", no_range(), "whole days without work"), 0,
              10'000)};
}
std::vector<Field> StructFields<Crew>::fields() {
  return {
      need<Crew>(&Crew::name, "name", "-", no_range(), "name that tools and machines refer to"),
      may<Crew>(&Crew::members, "members", "1", closed(1, 10'000), "people who can work at the same time"),
      may<Crew>(&Crew::rate_per_min, "rate_per_min", "money/min", money, "wage of one member"),
      may<Crew>(&Crew::pay, "pay", "-", no_range(), "paid for the minutes worked or for the whole shift"),
      entries(
          may<Crew>(&Crew::skills, "skills", "-", no_range(),
                    "what the crew can do besides: whoever is asked for by a skill may come from any crew "
                    "that has it"),
          0, 100),
      may<Crew>(&Crew::calendar, "calendar", "-", no_range(), "name of the calendar; empty: always there"),
      may<Crew>(&Crew::walking_min, "walking_min", "min", minutes, "walk to the machine at every call"),
      may<Crew>(&Crew::machines_per_member, "machines_per_member", "1", closed(1, 1000),
                "machines that one member can attend at the same time")};
}

std::vector<Field> StructFields<FailureMode>::fields() {
  using F = FailureMode;
  return {need<F>(&F::name, "name", "-", no_range(), "name of the failure mode"),
          may<F>(&F::clock, "clock", "-", no_range(), "what the time to failure is counted in"),
          need<F>(&F::time_to_failure, "time_to_failure", "min or parts", no_range(),
                  "law of the time to failure on that clock"),
          need<F>(&F::repair, "repair", "min", no_range(), "law of the repair time"),
          may<F>(&F::crew, "crew", "-", no_range(), "crew or skill that repairs; empty: nobody is needed"),
          may<F>(&F::priority, "priority", "1", priority_range, "of the call; smaller is more urgent"),
          may<F>(&F::spare, "spare", "-", no_range(), "name of the spare part that a repair uses up"),
          may<F>(&F::effect, "effect", "-", no_range(), "when the stop takes effect"),
          may<F>(&F::scrap_probability, "scrap_probability", "1", probability(),
                 "chance that the failure scraps the part in the machine"),
          may<F>(&F::damage, "damage", "money", money, "cost of one failure besides time and spare")};
}
std::vector<Field> StructFields<Maintenance>::fields() {
  using M = Maintenance;
  return {
      need<M>(&M::name, "name", "-", no_range(), "name of the maintenance job"),
      may<M>(&M::clock, "clock", "-", no_range(), "what the interval is counted in"),
      need<M>(&M::interval, "interval", "min or parts", open_low(0, 1e9),
              "from the end of one job to the next, on that clock"),
      need<M>(&M::duration, "duration", "min", no_range(), "law of the duration"),
      may<M>(&M::crew, "crew", "-", no_range(), "crew or skill that does it; empty: nobody is needed"),
      may<M>(&M::priority, "priority", "1", priority_range, "of the call; smaller is more urgent"),
      may<M>(&M::spare, "spare", "-", no_range(), "name of the spare part that the job uses up"),
      may<M>(&M::effect, "effect", "-", no_range(), "when the stop takes effect"),
      entries(may<M>(&M::renews, "renews", "-", no_range(), "failure modes that are as new afterwards"), 0,
              100),
      may<M>(&M::joins_from, "joins_from", "1", closed(0, 1),
             "share of the interval from which the job joins any other stop; 1: never early"),
      may<M>(&M::condition_threshold, "condition_threshold", "1", closed(0, 1),
             "share of a mode's life from which the job can see that it must be renewed; 0: always renewed"),
      may<M>(&M::detection_probability, "detection_probability", "1", probability(),
             "chance that a mode beyond the threshold is noticed")};
}

std::vector<Field> StructFields<SetupTime>::fields() {
  return {need<SetupTime>(&SetupTime::from, "from", "-", no_range(), "family before; \"*\": any"),
          need<SetupTime>(&SetupTime::to, "to", "-", no_range(), "family after; \"*\": any"),
          need<SetupTime>(&SetupTime::time, "time", "min", no_range(), "law of the set-up time")};
}
std::vector<Field> StructFields<Setup>::fields() {
  return {
      may<Setup>(&Setup::time, "time", "min", no_range(), "between families that no entry of times names"),
      entries(may<Setup>(&Setup::times, "times", "-", no_range(), "sequence-dependent times, first fit"), 0,
              10'000),
      may<Setup>(&Setup::crew, "crew", "-", no_range(),
                 "crew or skill that sets up; empty: nobody is needed"),
      may<Setup>(&Setup::cost, "cost", "money", money, "per changeover besides time")};
}
std::vector<Field> StructFields<Power>::fields() {
  const Range kw = closed(0, 1e6);
  return {
      may<Power>(&Power::cutting_kw, "cutting_kw", "kW", kw, "drawn in the cut"),
      may<Power>(&Power::working_kw, "working_kw", "kW", kw, "drawn in operations given as durations"),
      may<Power>(&Power::standby_kw, "standby_kw", "kW", kw, "drawn in any other state while switched on"),
      may<Power>(&Power::off_kw, "off_kw", "kW", kw, "drawn while switched off or outside the calendar")};
}
std::vector<Field> StructFields<Operator>::fields() {
  return {need<Operator>(&Operator::crew, "crew", "-", no_range(), "crew or skill that attends the machine"),
          may<Operator>(&Operator::during, "during", "-", no_range(), "while loading, or from part to part")};
}
std::vector<Field> StructFields<scenarios::Overload>::fields() {
  using O = scenarios::Overload;
  return {
      may<O>(&O::crew, "crew", "-", no_range(),
             "crew or skill that resets a clutch which does not close by itself, and repairs"),
      may<O>(&O::repair, "repair", "min", no_range(), "law of the repair time after a break of the drive"),
      may<O>(&O::damage, "damage", "money", money, "cost of a break besides time"),
      may<O>(&O::scrap_probability, "scrap_probability", "1", probability(),
             "chance that a break scraps the part in work")};
}
std::vector<Field> StructFields<SwitchOff>::fields() {
  return {need<SwitchOff>(&SwitchOff::after_idle_min, "after_idle_min", "min", minutes,
                          "idle time after which the machine is switched off"),
          may<SwitchOff>(&SwitchOff::warm_up, "warm_up", "min", no_range(),
                         "from switching on to the first part; also at the start of a shift")};
}

std::vector<Field> StructFields<Machine>::fields() {
  using M = Machine;
  return {
      need<M>(&M::name, "name", "-", no_range(), "name that operations refer to"),
      may<M>(&M::model, "model", "-", no_range(), "maker's model"),
      may<M>(&M::count, "count", "1", closed(1, 10'000), "number of identical machines"),
      may<M>(&M::rate_per_min, "rate_per_min", "money/min", money,
             "cost of a machine minute inside its calendar"),
      may<M>(&M::limits, "limits", "-", no_range(), "what the machine can do"),
      may<M>(&M::spindle, "spindle", "-", no_range(), "dynamics of its spindle; null: not known"),
      may<M>(&M::magazine, "magazine", "1", closed(1, 10'000), "tool places; none: as many as are wanted"),
      entries(may<M>(&M::capabilities, "capabilities", "-", no_range(), "names that operations may ask for"),
              0, 1000),
      may<M>(&M::dispatch, "dispatch", "-", no_range(), "which waiting batch is taken next"),
      may<M>(&M::queue_capacity, "queue_capacity", "batches", closed(0, 1'000'000),
             "batches that can wait before the group, those on their way to it included; null: no bound"),
      may<M>(&M::loading, "loading", "min", no_range(), "law of the loading time of a part"),
      may<M>(&M::unloading, "unloading", "min", no_range(), "law of the unloading time of a part"),
      may<M>(&M::setup, "setup", "-", no_range(), "changing over between families"),
      may<M>(&M::attendance, "attendance", "-", no_range(), "who attends the machine"),
      may<M>(&M::calendar, "calendar", "-", no_range(), "name of its calendar; empty: round the clock"),
      may<M>(&M::part_at_shift_end, "part_at_shift_end", "-", no_range(),
             "the part in work is finished, or waits for the next shift"),
      may<M>(&M::repair_at_shift_end, "repair_at_shift_end", "-", no_range(),
             "a repair or maintenance job is finished, or goes on in the next shift"),
      entries(may<M>(&M::failures, "failures", "-", no_range(), "independent ways to fail"), 0, 100),
      entries(may<M>(&M::maintenance, "maintenance", "-", no_range(), "preventive maintenance"), 0, 100),
      may<M>(&M::overload, "overload", "-", no_range(),
             "when the drive's safety clutch (limits/safety_clutch) trips or breaks"),
      may<M>(&M::switch_off, "switch_off", "-", no_range(), "switching off when idle"),
      may<M>(&M::power, "power", "-", no_range(), "electric power by state")};
}
std::vector<Field> StructFields<Spare>::fields() {
  const Range pieces = closed(0, 1'000'000);
  return {need<Spare>(&Spare::name, "name", "-", no_range(), "name that failure modes refer to"),
          may<Spare>(&Spare::price, "price", "money", money, "of one piece"),
          may<Spare>(&Spare::stock, "stock", "1", pieces, "pieces at the start"),
          may<Spare>(&Spare::reorder_point, "reorder_point", "1", pieces,
                     "an order is placed when stock and orders under way fall to this"),
          may<Spare>(&Spare::order_quantity, "order_quantity", "1", closed(1, 1'000'000), "pieces per order"),
          may<Spare>(&Spare::lead_time, "lead_time", "min", no_range(), "law of the delivery time")};
}

}  // namespace verstat::models
