#include "models/treatment/k305_thermo_friction_surface.h"

#include <cmath>
#include <numbers>
#include <span>

namespace verstat::models::k305 {
namespace {

PublishedRange published(Quantity quantity) {
  switch (quantity) {
    case Quantity::width_low_band:
      return {60, 70};
    case Quantity::width_high_band:
      return {80, 100};
    case Quantity::depth:
      return {1, 2.5};
    case Quantity::feed_low_band:
      return {160, 315};
    case Quantity::feed_high_band:
      return {100, 250};
    case Quantity::spindle:
      return {1600, 2500};
    case Quantity::roughness_rz:
      return {40, 80};
    case Quantity::hardening_factor:
      return {1.3, 1.5};
    case Quantity::hardened_depth:
      return {500, 500};
    case Quantity::base_hardness_depth:
    case Quantity::heat_affected_depth:
      return {600, 600};
    case Quantity::fine_structure_depth:
      return {200, 200};
    case Quantity::unchanged_structure_depth:
      return {1000, 1000};
    case Quantity::active_layer_depth:
      return {20, 30};
    case Quantity::residual_alloy:
      return {-1100, -750};
    case Quantity::residual_alloy_depth:
      return {100, 140};
    case Quantity::residual_45_surface:
      return {450, 1170};
    case Quantity::residual_45_tension_depth:
      return {7, 14};
    case Quantity::residual_45_subsurface:
      return {-600, -200};
    case Quantity::residual_45_depth:
      return {100, 300};
    case Quantity::drive_power:
      return {14, 14};
    case Quantity::disc_diameter:
      return {500, 500};
  }
  reject("there is no such published quantity");
}

bool within(double value, Quantity quantity) {
  const PublishedRange range = published(quantity);
  return value >= range.low && value <= range.high;
}

struct Node {
  double depth_um, stress_mpa;
};
// Straight lines between the nodes, zero below the last.
double along(std::span<const Node> nodes, double depth) {
  for (std::size_t k = 1; k < nodes.size(); ++k)
    if (depth <= nodes[k].depth_um) {
      const Node& a = nodes[k - 1];
      const Node& b = nodes[k];
      return a.stress_mpa + (b.stress_mpa - a.stress_mpa) * (depth - a.depth_um) / (b.depth_um - a.depth_um);
    }
  return 0;
}

// Whole quotients such as 4.2/1.4 must not round up to the next number.
double whole_above(double quotient) {
  return std::ceil(quotient - 1e-9);
}

}  // namespace

PublishedRange published_ranges(const PublishedQuantity& in) {
  return guarded<&published_ranges>(in, [&] { return published(in.quantity); });
}

SurfaceTemperature surface_temperature(const MachinedSteel& in) {
  return guarded<&surface_temperature>(in, [&]() -> SurfaceTemperature {
    switch (in.steel) {
      case Steel::steel_45:
        return {500, 600};
      case Steel::steel_12kh13:
      case Steel::steel_12kh18n12t:
        return {550, 650};
      case Steel::steel_38khgn:
      case Steel::steel_09kh15n8yu:
        return {600, 750};
    }
    reject("there is no temperature for this steel");
  });
}

DiscSpeed disc_speed(const Disc& in) {
  return guarded<&disc_speed>(
      in, [&] { return DiscSpeed{std::numbers::pi * in.diameter_mm * in.spindle_rpm / 60000}; });
}

Envelope regime_in_envelope(const DiscRegime& in) {
  return guarded<&regime_in_envelope>(in, [&] {
    const bool narrow =
        within(in.width_mm, Quantity::width_low_band) && within(in.feed_mm_min, Quantity::feed_low_band);
    const bool wide =
        within(in.width_mm, Quantity::width_high_band) && within(in.feed_mm_min, Quantity::feed_high_band);
    return Envelope{(narrow || wide) && within(in.depth_mm, Quantity::depth) &&
                            within(in.spindle_rpm, Quantity::spindle)
                        ? 1
                        : 0};
  });
}

StressTrend compressive_stress_trend(const RimSpeed& in) {
  return guarded<&compressive_stress_trend>(in, [&] { return StressTrend{in.speed_m_s > 50 ? 1 : -1}; });
}

HardnessRatio hardness_ratio(const HardenedPoint& in) {
  return guarded<&hardness_ratio>(in, [&] {
    if (in.depth_um <= 200) return HardnessRatio{in.factor};
    if (in.depth_um >= 600) return HardnessRatio{1};
    return HardnessRatio{in.factor + (1 - in.factor) * (in.depth_um - 200) / 400};
  });
}

ResidualStress residual_stress(const StressedPoint& in) {
  return guarded<&residual_stress>(in, [&] {
    const double level = in.level;
    if (in.steel == Steel::steel_45) {
      const std::array nodes{Node{0, 450 + 720 * level}, Node{7 + 7 * level, 0},
                             Node{20 + 10 * level, -(200 + 400 * level)}, Node{100 + 200 * level, 0}};
      return ResidualStress{along(nodes, in.depth_um)};
    }
    if (in.steel == Steel::steel_09kh15n8yu) {
      const std::array nodes{Node{0, -(750 + 350 * level)}, Node{100 + 40 * level, 0}};
      return ResidualStress{along(nodes, in.depth_um)};
    }
    std::string name;
    for (const auto& [steel, text] : EnumNames<Steel>::names)
      if (steel == in.steel) name = text;
    require(false, "steel", name, "has no published residual stress; allowed: \"45\", \"09Kh15N8Yu\"");
    return ResidualStress{0};
  });
}

FeedLimit feed_limit(const MachinedSection& in) {
  return guarded<&feed_limit>(in, [&] {
    const double x = std::log(in.depth_mm) / std::log(2.5);             // 0 at 1 mm, 1 at 2.5 mm
    const double y = std::log(in.width_mm / 65) / std::log(90.0 / 65);  // 0 and 1 at the middles of the bands
    const double narrow = std::log(315.0) + x * std::log(160.0 / 315);
    const double wide = std::log(250.0) + x * std::log(100.0 / 250);
    return FeedLimit{std::exp(narrow + y * (wide - narrow))};
  });
}

RemovalAndPower removal_and_power(const RemovalInputs& in) {
  return guarded<&removal_and_power>(in, [&] {
    const double removal = in.width_mm * in.depth_mm * in.feed_mm_min;
    return RemovalAndPower{removal, removal * in.specific_energy_j_mm3 / 60000,
                           60000 * in.drive_power_kw * in.efficiency / removal};
  });
}

PassTime pass_time(const PassInputs& in) {
  return guarded<&pass_time>(in, [&] {
    require(in.overlap_mm < in.disc_width_band_mm, "overlap_mm", in.overlap_mm,
            "must be below disc_width_band_mm");
    const double more = in.part_width_mm - in.disc_width_band_mm;
    const double rows = more <= 0 ? 1 : 1 + whole_above(more / (in.disc_width_band_mm - in.overlap_mm));
    const double layers = std::max(0.0, whole_above(in.stock_mm / in.depth_mm));
    const double passes = rows * layers;
    require(passes < 1e15, "part_width_mm", in.part_width_mm, "and stock_mm ask for more than 1e15 passes");
    return PassTime{static_cast<std::int64_t>(passes),
                    passes * (in.length_mm + in.run_in_out_mm) / in.feed_mm_min};
  });
}

Allowance following_allowance(const LayerLeft& in) {
  return guarded<&following_allowance>(in, [&] {
    return Allowance{in.rz_um + (in.keep_hardened ? 0 : in.hardened_depth_um) + in.positioning_error_um};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K305",
       .title = "Indices of surface quality in thermo-friction machining of steels and the influence of "
                "cutting-regime parameters on their change",
       .authors = "Pokintelitsa N. I.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A smooth steel disc at 40-65 m/s heats and removes 1-2.5 mm from a flat steel surface 60-100 mm "
           "wide: published ranges of regime, temperature, roughness, hardening and residual stress, with "
           "completions that turn the ranges into functions.",
       .role = "treatment",
       .errata = {
           "The influence of disc speed on compressive stress is stated twice with opposite signs; kept as a "
           "trend only.",
           "Steel 45 is said to have raised compressive stress while its stated result is tension at the "
           "surface; the result is used."}});
  const auto section = [](auto& f, auto width, auto depth, auto feed) {
    f.input(width, "width_mm", "B", "mm", positive(), "width of the surface", 65.0)
        .input(depth, "depth_mm", "t", "mm", positive(), "depth of cut", 1.5)
        .input(feed, "feed_mm_min", "S", "mm/min", positive(), "feed", 200.0);
  };

  source
      .function<&published_ranges>("published_ranges", "Published range of a quantity.", "text and tables",
                                   Provenance::paper)
      .input(&PublishedQuantity::quantity, "quantity", "-", "-", no_range(), "name of the quantity",
             "depth_mm")
      .output(&PublishedRange::low, "low", "-", "as named", any(), "lower end")
      .output(&PublishedRange::high, "high", "-", "as named", any(), "upper end");
  source
      .function<&surface_temperature>("surface_temperature", "Published surface temperature of a steel.",
                                      "text", Provenance::paper)
      .input(&MachinedSteel::steel, "steel", "-", "-", no_range(), "steel", "45")
      .output(&SurfaceTemperature::low_c, "low_c", "-", "degC", any(), "lower end")
      .output(&SurfaceTemperature::high_c, "high_c", "-", "degC", any(), "upper end");
  source.function<&disc_speed>("disc_speed", "Rim speed of the disc.", "definition", Provenance::paper)
      .optional(&Disc::diameter_mm, "diameter_mm", "D", "mm", positive(), "diameter of the disc")
      .input(&Disc::spindle_rpm, "rpm", "n", "rpm", positive(), "spindle speed (paper 1600-2500)", 2000.0)
      .output(&DiscSpeed::speed_m_s, "disc_speed_m_s", "V_d", "m/s", positive(), "rim speed");
  source
      .function<&regime_in_envelope>("regime_in_envelope",
                                     "Whether a regime lies inside the published ranges.", "tables",
                                     Provenance::paper)
      .with([&](auto& f) {
        section(f, &DiscRegime::width_mm, &DiscRegime::depth_mm, &DiscRegime::feed_mm_min);
      })
      .input(&DiscRegime::spindle_rpm, "rpm", "n", "rpm", positive(), "spindle speed", 2000.0)
      .output(&Envelope::in_envelope, "in_envelope", "-", "1", closed(0, 1), "1 inside, 0 outside");
  source
      .function<&compressive_stress_trend>("compressive_stress_trend",
                                           "Trend of compressive residual stress with disc speed.", "text",
                                           Provenance::paper)
      .input(&RimSpeed::speed_m_s, "disc_speed_m_s", "V_d", "m/s", positive(), "rim speed", 42.0)
      .output(&StressTrend::trend, "trend", "-", "1", closed(-1, 1), "-1 falls with speed, +1 rises")
      .note("The paper contradicts itself on this influence: a flag, not a number.");
  source
      .function<&hardness_ratio>("hardness_ratio", "Hardness below the surface over base hardness.",
                                 "completion on the printed ranges", Provenance::completion)
      .input(&HardenedPoint::depth_um, "depth_um", "y", "um", non_negative(), "depth below the surface",
             400.0)
      .input(&HardenedPoint::factor, "factor", "k", "1", at_least(1), "hardening factor (paper 1.3-1.5)", 1.4)
      .output(&HardnessRatio::ratio, "ratio", "r", "1", at_least(1), "ratio to base hardness");
  source
      .function<&residual_stress>("residual_stress", "Residual stress below the surface.",
                                  "completion on the printed ranges", Provenance::completion)
      .input(&StressedPoint::steel, "steel", "-", "-", no_range(), "45 or 09Kh15N8Yu", "45")
      .input(&StressedPoint::depth_um, "depth_um", "y", "um", non_negative(), "depth below the surface", 15.0)
      .input(&StressedPoint::level, "level", "L", "1", closed(0, 1), "0 mild end, 1 severe end of the ranges",
             0.5)
      .output(&ResidualStress::stress_mpa, "stress_mpa", "sigma", "MPa", any(), "stress, + tension")
      .note("Only the printed ends are data; the position of the compression peak is a reading.");
  source
      .function<&feed_limit>("feed_limit", "Feed at the edge of the published regimes.",
                             "completion on the printed ranges", Provenance::completion)
      .input(&MachinedSection::width_mm, "width_mm", "B", "mm", closed(60, 100), "width of the surface", 70.0)
      .input(&MachinedSection::depth_mm, "depth_mm", "t", "mm", closed(1, 2.5), "depth of cut", 1.5)
      .output(&FeedLimit::feed_mm_min, "feed_mm_min", "S", "mm/min", positive(), "feed")
      .note("Leaves the printed feeds slightly at the ends of the width range.");
  source
      .function<&removal_and_power>("removal_and_power",
                                    "Removal rate, cutting power and energy limit of the drive.",
                                    "completion", Provenance::completion)
      .with([&](auto& f) {
        section(f, &RemovalInputs::width_mm, &RemovalInputs::depth_mm, &RemovalInputs::feed_mm_min);
      })
      .input(&RemovalInputs::specific_energy_j_mm3, "specific_energy_j_mm3", "e", "J/mm3", positive(),
             "specific energy", 20.0)
      .optional(&RemovalInputs::drive_power_kw, "drive_power_kw", "N_d", "kW", positive(), "drive power")
      .input(&RemovalInputs::efficiency, "efficiency", "eta", "1", open_low(0, 1), "efficiency of the drive",
             0.8)
      .output(&RemovalAndPower::removal_mm3_min, "removal_mm3_min", "Q", "mm3/min", positive(),
              "removal rate")
      .output(&RemovalAndPower::power_kw, "power_kw", "N", "kW", positive(), "cutting power")
      .output(&RemovalAndPower::energy_limit_j_mm3, "energy_limit_j_mm3", "e_lim", "J/mm3", positive(),
              "specific energy that loads the drive fully");
  source
      .function<&pass_time>("pass_time", "Passes and main time of a surface.", "completion",
                            Provenance::completion)
      .input(&PassInputs::length_mm, "length_mm", "L", "mm", positive(), "length of the surface", 600.0)
      .input(&PassInputs::part_width_mm, "part_width_mm", "B_p", "mm", positive(), "width of the surface",
             135.0)
      .input(&PassInputs::disc_width_band_mm, "disc_width_band_mm", "B", "mm", positive(), "width of a pass",
             70.0)
      .input(&PassInputs::overlap_mm, "overlap_mm", "o", "mm", non_negative(),
             "overlap of neighbouring passes", 5.0)
      .input(&PassInputs::run_in_out_mm, "run_in_out_mm", "l", "mm", non_negative(), "run-in and run-out",
             40.0)
      .input(&PassInputs::stock_mm, "stock_mm", "h", "mm", non_negative(), "stock", 4.2)
      .input(&PassInputs::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut", 1.4)
      .input(&PassInputs::feed_mm_min, "feed_mm_min", "S", "mm/min", positive(), "feed", 200.0)
      .output(&PassTime::passes, "passes", "-", "1", non_negative(), "rows times layers, 0 without stock")
      .output(&PassTime::main_time_min, "main_time_min", "T", "min", non_negative(), "main time");
  source
      .function<&following_allowance>("following_allowance", "Smallest allowance of the following operation.",
                                      "completion", Provenance::completion)
      .input(&LayerLeft::rz_um, "rz_um", "Rz", "um", non_negative(), "roughness left", 80.0)
      .input(&LayerLeft::hardened_depth_um, "hardened_depth_um", "h_hard", "um", non_negative(),
             "hardened depth", 600.0)
      .input(&LayerLeft::keep_hardened, "keep_hardened", "-", "-", no_range(), "keep the hardened layer",
             false)
      .input(&LayerLeft::positioning_error_um, "positioning_error_um", "epsilon", "um", non_negative(),
             "positioning error", 50.0)
      .output(&Allowance::allowance_um, "allowance_um", "Z", "um", non_negative(), "allowance per side");
}

}  // namespace verstat::models::k305
