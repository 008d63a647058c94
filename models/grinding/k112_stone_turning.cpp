#include "models/grinding/k112_stone_turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k112 {
namespace {

using std::numbers::pi;

Regime regime(std::int64_t group, Operation operation) {
  // Table 3, rough external grinding.
  Regime r = group <= 2   ? Regime{40, 60, 0.10, 0.13, 0.050, 0.065}
             : group <= 4 ? Regime{16, 40, 0.07, 0.10, 0.035, 0.050}
                          : Regime{12.5, 16, 0.03, 0.07, 0.015, 0.035};
  if (operation == Operation::finish) {  // text after Table 3: feeds of all groups
    r.long_feed_min_mm_rev = 0.07;
    r.long_feed_max_mm_rev = 0.10;
    r.cross_feed_min_mm_rev = 0.035;
    r.cross_feed_max_mm_rev = 0.05;
  }
  return r;
}

LatheData lathe(Lathe machine) {  // Table 1
  switch (machine) {
    case Lathe::k1k62m:
      return {400, 200, 12.5, 2000, 0.07, 4.16, 0.035, 2.08, 2200};
    case Lathe::k16b05p:  // upper feeds printed 0.035 and 0.0175
      return {250, 145, 30, 3000, 0.02, 0.35, 0.01, 0.175, 715};
    case Lathe::k16b16a:
      break;
  }
  return {320, 180, 20, 2000, 0.01, 0.7, 0.005, 0.35, 2100};
}

struct Window {
  double low, high;
  [[nodiscard]] bool meets() const { return low <= high; }
};
Window common(double low_1, double high_1, double low_2, double high_2) {
  return {std::max(low_1, low_2), std::min(high_1, high_2)};
}

}  // namespace

Regime stone_turning_regime(const StoneOperation& in) {
  return guarded<&stone_turning_regime>(in, [&] { return regime(in.group, in.operation); });
}

LatheData machine_characteristics(const LatheName& in) {
  return guarded<&machine_characteristics>(in, [&] { return lathe(in.machine); });
}

LatheFit stone_machine_fit(const StoneOnLathe& in) {
  return guarded<&stone_machine_fit>(in, [&] {
    const LatheData can = lathe(in.machine);
    const Regime want = regime(in.group, in.operation);
    const Window rpm = common(can.rpm_min, can.rpm_max, want.rpm_min, want.rpm_max);
    const Window feed = common(can.long_feed_min_mm_rev, can.long_feed_max_mm_rev, want.long_feed_min_mm_rev,
                               want.long_feed_max_mm_rev);
    const Window cross = common(can.cross_feed_min_mm_rev, can.cross_feed_max_mm_rev,
                                want.cross_feed_min_mm_rev, want.cross_feed_max_mm_rev);
    const bool size_ok = in.work_diameter_mm <= can.swing_carriage_mm;
    LatheFit fit{.feasible = size_ok && rpm.meets() && feed.meets() ? 1 : 0,
                 .size_ok = size_ok ? 1 : 0,
                 .rpm_ok = rpm.meets() ? 1 : 0,
                 .long_feed_ok = feed.meets() ? 1 : 0,
                 .cross_feed_ok = cross.meets() ? 1 : 0,
                 .rpm_low = {},
                 .rpm_high = {},
                 .long_feed_low_mm_rev = {},
                 .long_feed_high_mm_rev = {}};
    if (rpm.meets()) {
      fit.rpm_low = rpm.low;
      fit.rpm_high = rpm.high;
    }
    if (feed.meets()) {
      fit.long_feed_low_mm_rev = feed.low;
      fit.long_feed_high_mm_rev = feed.high;
    }
    return fit;
  });
}

Speeds stone_turning_kinematics(const WheelOnStone& in) {
  return guarded<&stone_turning_kinematics>(in, [&] {
    const double work_m_min = pi * in.work_diameter_mm * in.rpm / 1000;
    const double wheel_m_s = in.relative_speed_m_s + (in.conventional == 1 ? -1 : 1) * work_m_min / 60;
    require(wheel_m_s > 0, "relative_speed_m_s", in.relative_speed_m_s,
            "must be above the work speed in opposed motion");
    return Speeds{work_m_min, wheel_m_s, 60000 * wheel_m_s / (pi * in.wheel_diameter_mm)};
  });
}

PassTime stone_turning_time(const LongitudinalPasses& in) {
  return guarded<&stone_turning_time>(in, [&] {
    // 1e-9 keeps a number of passes that is whole by design from being rounded up.
    const double passes = std::max(0.0, std::ceil(in.allowance_per_side_mm / in.depth_per_pass_mm - 1e-9));
    require(passes < 1e15, "depth_per_pass_mm", in.depth_per_pass_mm, "asks for more than 1e15 passes");
    const double pass_min = (in.length_mm + in.approach_mm) / (in.long_feed_mm_rev * in.rpm);
    return PassTime{static_cast<std::int64_t>(passes), pass_min, passes * pass_min};
  });
}

PlungeTime stone_plunge_time(const Plunge& in) {
  return guarded<&stone_plunge_time>(in, [&] {
    return PlungeTime{in.allowance_per_side_mm / (in.cross_feed_mm_rev * in.rpm) + in.sparkout_revs / in.rpm};
  });
}

RemovalRate stone_removal_rate(const StonePass& in) {
  return guarded<&stone_removal_rate>(in, [&] {
    require(in.depth_mm <= in.work_diameter_mm / 2, "depth_mm", in.depth_mm,
            "must not be above half of work_diameter_mm");
    return RemovalRate{pi * (in.work_diameter_mm - in.depth_mm) * in.depth_mm * in.long_feed_mm_rev * in.rpm};
  });
}

WheelLife diamond_wheel_life(const DiamondWheel& in) {
  return guarded<&diamond_wheel_life>(in, [&] {
    require(in.layer_depth_mm <= in.wheel_diameter_mm / 2, "layer_depth_mm", in.layer_depth_mm,
            "must not be above half of wheel_diameter_mm");
    // pi/4 [D^2 - (D - 2X)^2] without the cancellation
    const double volume_mm3 =
        pi * in.layer_depth_mm * (in.wheel_diameter_mm - in.layer_depth_mm) * in.rim_width_mm;
    constexpr double carat_per_cm3 = 4.4;  // at 100 % by definition
    return WheelLife{.layer_volume_mm3 = volume_mm3,
                     .diamond_carat = carat_per_cm3 * volume_mm3 / 1000 * in.concentration_percent / 100,
                     .parts_per_wheel =
                         in.usable_fraction * volume_mm3 * in.grinding_ratio / in.stone_volume_per_part_mm3};
  });
}

namespace {

void describe_tables(Source& source) {
  const auto stone = [](auto& f, auto group, auto operation) {
    f.input(group, "group", "-", "1", closed(1, 5), "machinability group of the stone", 1)
        .input(operation, "operation", "-", "-", no_range(), "rough or finish", "rough");
  };
  const auto lathe_name = [](auto& f, auto machine) {
    f.input(machine, "machine", "-", "-", no_range(), "lathe", "1K62M");
  };
  source
      .function<&stone_turning_regime>("stone_turning_regime", "Recommended window of speed and feeds.",
                                       "Table 3 and text after it", Provenance::paper)
      .with([&](auto& f) { stone(f, &StoneOperation::group, &StoneOperation::operation); })
      .output(&Regime::rpm_min, "rpm_min", "n", "rpm", positive(), "slowest work speed")
      .output(&Regime::rpm_max, "rpm_max", "n", "rpm", positive(), "fastest work speed")
      .output(&Regime::long_feed_min_mm_rev, "long_feed_min", "S", "mm/rev", positive(),
              "smallest longitudinal feed")
      .output(&Regime::long_feed_max_mm_rev, "long_feed_max", "S", "mm/rev", positive(),
              "largest longitudinal feed")
      .output(&Regime::cross_feed_min_mm_rev, "cross_feed_min", "S_cr", "mm/rev", positive(),
              "smallest cross feed")
      .output(&Regime::cross_feed_max_mm_rev, "cross_feed_max", "S_cr", "mm/rev", positive(),
              "largest cross feed")
      .note(
          "For parts up to 150 mm diameter. The paper gives feeds only for finishing; the rough speeds are "
          "kept (completion).")
      .note("The ends of a window are bounds; no optimum is known inside.");
  source
      .function<&machine_characteristics>("machine_characteristics", "Data of a lathe.", "Table 1",
                                          Provenance::repaired)
      .with([&](auto& f) { lathe_name(f, &LatheName::machine); })
      .output(&LatheData::swing_bed_mm, "swing_bed_mm", "-", "mm", positive(), "swing over the bed")
      .output(&LatheData::swing_carriage_mm, "swing_carriage_mm", "-", "mm", positive(),
              "swing over the carriage")
      .output(&LatheData::rpm_min, "rpm_min", "n", "rpm", positive(), "slowest spindle speed")
      .output(&LatheData::rpm_max, "rpm_max", "n", "rpm", positive(), "fastest spindle speed")
      .output(&LatheData::long_feed_min_mm_rev, "long_feed_min", "S", "mm/rev", positive(),
              "smallest longitudinal feed")
      .output(&LatheData::long_feed_max_mm_rev, "long_feed_max", "S", "mm/rev", positive(),
              "largest longitudinal feed")
      .output(&LatheData::cross_feed_min_mm_rev, "cross_feed_min", "S_cr", "mm/rev", positive(),
              "smallest cross feed")
      .output(&LatheData::cross_feed_max_mm_rev, "cross_feed_max", "S_cr", "mm/rev", positive(),
              "largest cross feed")
      .output(&LatheData::mass_kg, "mass_kg", "-", "kg", positive(), "mass");
  source
      .function<&stone_machine_fit>("stone_machine_fit", "Whether a lathe can run a stone group.",
                                    "Tables 1 and 3", Provenance::reconstructed)
      .with([&](auto& f) { lathe_name(f, &StoneOnLathe::machine); })
      .with([&](auto& f) { stone(f, &StoneOnLathe::group, &StoneOnLathe::operation); })
      .input(&StoneOnLathe::work_diameter_mm, "work_diameter_mm", "D", "mm", positive(), "work diameter",
             100.0)
      .output(&LatheFit::feasible, "feasible", "-", "1", closed(0, 1),
              "1 when size, speed and longitudinal feed fit")
      .output(&LatheFit::size_ok, "size_ok", "-", "1", closed(0, 1), "1 when it passes over the carriage")
      .output(&LatheFit::rpm_ok, "rpm_ok", "-", "1", closed(0, 1), "1 when the speeds meet")
      .output(&LatheFit::long_feed_ok, "long_feed_ok", "-", "1", closed(0, 1),
              "1 when the longitudinal feeds meet")
      .output(&LatheFit::cross_feed_ok, "cross_feed_ok", "-", "1", closed(0, 1),
              "1 when the cross feeds meet")
      .output(&LatheFit::rpm_low, "rpm_low", "n", "rpm", positive(), "slowest common speed, null for none")
      .output(&LatheFit::rpm_high, "rpm_high", "n", "rpm", positive(), "fastest common speed, null for none")
      .output(&LatheFit::long_feed_low_mm_rev, "long_feed_low", "S", "mm/rev", positive(),
              "smallest common longitudinal feed, null for none")
      .output(&LatheFit::long_feed_high_mm_rev, "long_feed_high", "S", "mm/rev", positive(),
              "largest common longitudinal feed, null for none")
      .note("The recommendation is for parts up to 150 mm; larger ones are judged by the swing alone.");
}

void describe_formulas(Source& source) {
  const auto rpm = [](auto& f, auto pointer) {
    f.input(pointer, "rpm", "n", "rpm", positive(), "work speed", 50.0);
  };
  source
      .function<&stone_turning_kinematics>("stone_turning_kinematics",
                                           "Work speed, and wheel speed for a relative speed.", "(C1)",
                                           Provenance::completion)
      .input(&WheelOnStone::work_diameter_mm, "work_diameter_mm", "D", "mm", positive(), "work diameter",
             150.0)
      .with([&](auto& f) { rpm(f, &WheelOnStone::rpm); })
      .input(&WheelOnStone::wheel_diameter_mm, "wheel_diameter_mm", "D_s", "mm", positive(), "wheel diameter",
             150.0)
      .input(&WheelOnStone::relative_speed_m_s, "relative_speed_m_s", "v_rel", "m/s", positive(),
             "relative speed, printed 5-15", 15.0)
      .input(&WheelOnStone::conventional, "conventional", "-", "1", closed(0, 1), "1 opposed motion, 0 climb",
             1)
      .output(&Speeds::work_speed_m_min, "work_speed_m_min", "v_w", "m/min", positive(), "work speed")
      .output(&Speeds::wheel_speed_m_s, "wheel_speed_m_s", "v_s", "m/s", positive(), "wheel speed")
      .output(&Speeds::wheel_rpm, "wheel_rpm", "n_s", "rpm", positive(), "wheel speed");
  source
      .function<&stone_turning_time>("stone_turning_time", "Time of longitudinal turning in passes.", "(C2)",
                                     Provenance::completion)
      .input(&LongitudinalPasses::length_mm, "length_mm", "L", "mm", positive(), "length", 100.0)
      .input(&LongitudinalPasses::approach_mm, "approach_mm", "l", "mm", non_negative(),
             "run-in plus run-out", 10.0)
      .input(&LongitudinalPasses::allowance_per_side_mm, "allowance_per_side_mm", "a", "mm", non_negative(),
             "allowance per side", 12.0)
      .input(&LongitudinalPasses::depth_per_pass_mm, "depth_per_pass_mm", "t", "mm", positive(),
             "depth per pass, printed up to 5", 5.0)
      .input(&LongitudinalPasses::long_feed_mm_rev, "long_feed_mm_rev", "S", "mm/rev", positive(),
             "longitudinal feed", 0.115)
      .with([&](auto& f) { rpm(f, &LongitudinalPasses::rpm); })
      .output(&PassTime::passes, "passes", "i", "1", at_least(0), "whole passes")
      .output(&PassTime::time_per_pass_min, "time_per_pass_min", "T_1", "min", positive(), "time of a pass")
      .output(&PassTime::main_time_min, "main_time_min", "T", "min", non_negative(), "main time");
  source
      .function<&stone_plunge_time>("stone_plunge_time", "Time of radial forming with spark-out.", "(C3)",
                                    Provenance::completion)
      .input(&Plunge::allowance_per_side_mm, "allowance_per_side_mm", "a", "mm", non_negative(),
             "allowance per side", 3.0)
      .input(&Plunge::cross_feed_mm_rev, "cross_feed_mm_rev", "S_cr", "mm/rev", positive(), "cross feed",
             0.055)
      .with([&](auto& f) { rpm(f, &Plunge::rpm); })
      .input(&Plunge::sparkout_revs, "sparkout_revs", "N_so", "1", non_negative(), "revolutions of spark-out",
             5.0)
      .output(&PlungeTime::main_time_min, "main_time_min", "T_pl", "min", non_negative(), "main time");
  source
      .function<&stone_removal_rate>("stone_removal_rate", "Stone removed per minute.", "(C4)",
                                     Provenance::completion)
      .input(&StonePass::work_diameter_mm, "work_diameter_mm", "D", "mm", positive(),
             "diameter before the pass", 150.0)
      .input(&StonePass::depth_mm, "depth_mm", "t", "mm", positive(), "depth, at most half the diameter", 5.0)
      .input(&StonePass::long_feed_mm_rev, "long_feed_mm_rev", "S", "mm/rev", positive(), "longitudinal feed",
             0.13)
      .with([&](auto& f) { rpm(f, &StonePass::rpm); })
      .output(&RemovalRate::removal_rate_mm3_min, "removal_rate_mm3_min", "Q", "mm3/min", positive(),
              "removal rate");
  source
      .function<&diamond_wheel_life>("diamond_wheel_life", "Diamond layer of a wheel and the parts it lasts.",
                                     "(C5)", Provenance::completion)
      .input(&DiamondWheel::wheel_diameter_mm, "wheel_diameter_mm", "D_s", "mm", positive(), "wheel diameter",
             150.0)
      .input(&DiamondWheel::rim_width_mm, "rim_width_mm", "B", "mm", positive(), "width of the rim", 10.0)
      .input(&DiamondWheel::layer_depth_mm, "layer_depth_mm", "X", "mm", positive(),
             "depth of the layer, at most half the wheel", 5.0)
      .input(&DiamondWheel::concentration_percent, "concentration_percent", "K", "%", non_negative(),
             "concentration, printed 50-100", 100.0)
      .input(&DiamondWheel::usable_fraction, "usable_fraction", "eta", "1", closed(0, 1),
             "share of the layer that can be used", 0.8)
      .input(&DiamondWheel::grinding_ratio, "grinding_ratio", "G", "mm3/mm3", non_negative(),
             "stone removed per volume of layer", 500.0)
      .input(&DiamondWheel::stone_volume_per_part_mm3, "stone_volume_per_part_mm3", "V_part", "mm3",
             positive(), "stone removed per part", 150000.0)
      .output(&WheelLife::layer_volume_mm3, "layer_volume_mm3", "V", "mm3", positive(), "volume of the layer")
      .output(&WheelLife::diamond_carat, "diamond_carat", "m", "carat", non_negative(),
              "diamond in the layer")
      .output(&WheelLife::parts_per_wheel, "parts_per_wheel", "N", "1", non_negative(),
              "parts per wheel; round down for planning")
      .note("The grinding ratio has no value in the paper; it must come from the shop.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K112",
       .title = "Choice of rational parameters of a diamond tool for turning natural stone",
       .authors = "Peglovskyi V. V., Sidorko V. I., Liakhov V. N.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Shaping bodies of revolution from decorative stone on an ordinary lathe with a driven diamond "
           "wheel. Five machinability groups with recommended spindle speeds and feeds, three lathes, "
           "tools and diamond layers: tables, no equation.",
       .role = "grinding",
       .errata = {
           "Table 1: the upper feeds of 16B05P are printed 0.035 and 0.0175 mm/rev, from which no rough "
           "regime could be reached; 0.35 and 0.175 restore cross = longitudinal / 2.",
           "Table 1: the speed range of 16B16A is printed \"2 0-2000\": 20-2000 rpm.",
           "The quoted thousandfold spread of labour between groups is far above the 21 times of the "
           "feed rates; it concerns other operations or passes and tool wear too."}});
  describe_tables(source);
  describe_formulas(source);
}

}  // namespace verstat::models::k112
