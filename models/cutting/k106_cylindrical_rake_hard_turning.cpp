#include "models/cutting/k106_cylindrical_rake_hard_turning.h"

#include <cmath>
#include <numbers>

namespace verstat::models::k106 {
namespace {

// (C1): exponents and levels that meet the statements of the text.
struct ForceLaw {
  double feed_exponent_yz = std::log(3.0) / std::log(0.67 / 0.14);  // threefold from 0.14 to 0.67 mm/rev
  double feed_exponent_x = std::log(1.35) / std::log(0.67 / 0.14);  // +30-40 % over the same
  double depth_exponent_x = (std::log(2.0) - feed_exponent_x * std::log(7.0)) / std::log(5.0);
  // P_x runs from 20 to 40 N over the box s 0.1-0.7, t 0.05-0.25.
  double p_x0_n = 20 * std::pow(1.4, feed_exponent_x) * std::pow(2.0, depth_exponent_x);
};
constexpr double sharp_force_n = 100;  // P_y and P_z at s 0.14, t 0.1
constexpr double reference_feed_mm_rev = 0.14;
constexpr double reference_depth_mm = 0.1;

// Growth of P_y and P_z with flank wear, 1/mm, and of P_y in ceramic.
struct WearGrowth {
  double y;
  double z;
};
WearGrowth wear_growth(Rake rake) {
  return rake == Rake::flat ? WearGrowth{15, 2} : WearGrowth{20, 4.0 / 3};
}

bool published(const HardTurning& in, double p_x, double p_y, double p_z) {
  const auto within = [](double x, double low, double high) {
    constexpr double tolerance_n = 1e-9;
    return x >= low - tolerance_n && x <= high + tolerance_n;
  };
  return in.speed_m_min >= 30 && in.speed_m_min <= 150 && in.feed_mm_rev >= 0.1 && in.feed_mm_rev <= 0.7 &&
         in.depth_mm >= 0.05 && in.depth_mm <= 0.25 && within(p_x, 20, 40) && within(p_y, 100, 500) &&
         within(p_z, 100, 400);
}

}  // namespace

HardTurningForces hard_turning_forces(const HardTurning& in) {
  return guarded<&hard_turning_forces>(in, [&] {
    static const ForceLaw law;
    const double feed = in.feed_mm_rev / reference_feed_mm_rev;
    const double depth = in.depth_mm / reference_depth_mm;
    const WearGrowth growth = wear_growth(in.rake);
    const double ceramic = in.tool_material == ToolMaterial::ceramic ? 2 : 1;  // "almost twice", P_y only
    const double p_x =
        law.p_x0_n * std::pow(feed, law.feed_exponent_x) * std::pow(depth, law.depth_exponent_x);
    const double sharp = sharp_force_n * std::pow(feed, law.feed_exponent_yz) * depth;
    const double p_y = sharp * (1 + growth.y * in.flank_wear_mm) * ceramic;
    const double p_z = sharp * (1 + growth.z * in.flank_wear_mm);
    return HardTurningForces{p_x, p_y, p_z, published(in, p_x, p_y, p_z)};
  });
}

ForceGrowth force_growth_with_time(const CuttingTime& in) {
  return guarded<&force_growth_with_time>(in, [&] {
    static const double exponent = std::log(2.4) / std::log(4.0);  // from 2.25 at 10 min to 4 at 40 min
    return ForceGrowth{1 + 1.25 * std::pow(in.cutting_time_min / 10, exponent),
                       1 + 0.2 * in.cutting_time_min / 40};
  });
}

EdgeLength active_edge_length(const RoundInsert& in) {
  return guarded<&active_edge_length>(in, [&] {
    require(in.depth_mm <= in.radius_mm, "t", in.depth_mm, "must not be above r");
    require(in.feed_mm_rev <= 2 * in.radius_mm, "s", in.feed_mm_rev, "must not be above 2 r");
    // arccos(1 - t/r) without cancellation at small depths.
    const double lead = 2 * std::asin(std::sqrt(in.depth_mm / (2 * in.radius_mm)));
    return EdgeLength{in.radius_mm * (lead + std::asin(in.feed_mm_rev / (2 * in.radius_mm)))};
  });
}

Pressure flank_contact_pressure(const FlankLoad& in) {
  return guarded<&flank_contact_pressure>(
      in, [&] { return Pressure{in.force_growth_n / (in.flank_wear_mm * in.edge_length_mm)}; });
}

Power cutting_power(const PowerInputs& in) {
  return guarded<&cutting_power>(in, [&] { return Power{in.p_z_n * in.speed_m_min / 60000}; });
}

ChatterRisk ceramic_chatter_risk(const CeramicRegime& in) {
  return guarded<&ceramic_chatter_risk>(
      in, [&] { return ChatterRisk{in.depth_mm >= 0.1 && in.speed_m_min >= 60 && in.speed_m_min <= 100}; });
}

Deflection part_deflection(const BarLoad& in) {
  return guarded<&part_deflection>(in, [&] {
    const double inertia_mm4 = std::numbers::pi * std::pow(in.diameter_mm, 4) / 64;
    return Deflection{1000 * in.p_y_n * std::pow(in.length_mm, 3) /
                      (48 * in.elastic_modulus_mpa * inertia_mm4)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K106",
       .title = "The influence of machining regimes on cutting forces when turning hardened steel parts with "
                "a tool having a cylindrical rake face",
       .authors = "Melnichuk Yu. A., Klimenko S. A., Manokhin A. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Finish turning of hardened bearing steel (60-64 HRC) at increased feed with a PCBN tool of "
                 "cylindrical rake, against a flat rake and ceramic: force components by regime, wear and "
                 "time, power, chatter of ceramic, deflection of the part.",
       .role = "cutting",
       .errata = {"A figure 6 is cited where the paper has four; figure 4 is meant.",
                  "The hardness is 62-64 HRC in the method and 60-62 HRC in the conclusions; unresolved."}});

  source
      .function<&hard_turning_forces>("hard_turning_forces", "Force components of hard turning.", "eq. (C1)",
                                      Provenance::completion)
      .input(&HardTurning::speed_m_min, "v", "v", "m/min", positive(),
             "cutting speed, published 30-150; no effect on the forces", 60.0)
      .input(&HardTurning::feed_mm_rev, "s", "s", "mm/rev", positive(), "feed, published 0.1-0.7", 0.29)
      .input(&HardTurning::depth_mm, "t", "t", "mm", positive(), "depth of cut, published 0.05-0.25", 0.1)
      .input(&HardTurning::flank_wear_mm, "h", "h", "mm", non_negative(), "flank wear, data 0-0.2", 0.0)
      .input(&HardTurning::rake, "rake", "-", "-", no_range(), "rake face", "cylindrical")
      .input(&HardTurning::tool_material, "tool_material", "-", "-", no_range(), "insert material", "cbn")
      .output(&HardTurningForces::p_x_n, "p_x", "P_x", "N", non_negative(), "feed force")
      .output(&HardTurningForces::p_y_n, "p_y", "P_y", "N", non_negative(), "radial force")
      .output(&HardTurningForces::p_z_n, "p_z", "P_z", "N", non_negative(), "main force")
      .output(&HardTurningForces::in_published_envelope, "in_published_envelope", "-", "-", no_range(),
              "speed, feed, depth and all forces are within the published ranges")
      .note("Calibrated on statements of the text; treat results outside the envelope as extrapolation.")
      .note(
          "Wear and insert material are left out of P_x, speed out of all: no figures. The ceramic factor "
          "is stated for the cylindrical rake and used for both.");
  source
      .function<&force_growth_with_time>("force_growth_with_time",
                                         "Growth of the forces over those just after cutting in.", "eq. (C2)",
                                         Provenance::completion)
      .input(&CuttingTime::cutting_time_min, "tau", "tau", "min", closed(0, 60), "cutting time", 10.0)
      .output(&ForceGrowth::factor_y, "factor_y", "f_y", "1", at_least(1),
              "radial force over the initial one")
      .output(&ForceGrowth::factor_z, "factor_z", "f_z", "1", at_least(1), "main force over the initial one")
      .note("The points at 10 and 40 min come from different regimes: indicative.");
  source
      .function<&active_edge_length>("active_edge_length", "Active edge of a flat-rake round insert.",
                                     "eq. (C3)", Provenance::completion)
      .input(&RoundInsert::radius_mm, "r", "r", "mm", positive(), "insert radius", 3.5)
      .input(&RoundInsert::depth_mm, "t", "t", "mm", positive(), "depth of cut, at most r", 0.1)
      .input(&RoundInsert::feed_mm_rev, "s", "s", "mm/rev", non_negative(), "feed, at most 2 r", 0.14)
      .output(&EdgeLength::length_mm, "b", "b", "mm", non_negative(), "active edge length");
  source
      .function<&flank_contact_pressure>("flank_contact_pressure", "Contact pressure on the worn flank.",
                                         "eq. (C4)", Provenance::completion)
      .input(&FlankLoad::force_growth_n, "delta_p_y", "dP_y", "N", non_negative(),
             "growth of the radial force with wear", 150.0)
      .input(&FlankLoad::flank_wear_mm, "h", "h", "mm", positive(), "flank wear", 0.1)
      .input(&FlankLoad::edge_length_mm, "edge_length", "b", "mm", positive(), "active edge length", 0.909)
      .output(&Pressure::pressure_mpa, "pressure", "p", "MPa", non_negative(), "contact pressure");
  source.function<&cutting_power>("cutting_power", "Cutting power.", "eq. (C5)", Provenance::completion)
      .input(&PowerInputs::p_z_n, "p_z", "P_z", "N", non_negative(), "main force", 400.0)
      .input(&PowerInputs::speed_m_min, "v", "v", "m/min", non_negative(), "cutting speed", 150.0)
      .output(&Power::power_kw, "power", "N", "kW", non_negative(), "cutting power");
  source
      .function<&ceramic_chatter_risk>("ceramic_chatter_risk", "Whether a ceramic insert chatters.",
                                       "text; deeper cuts completed", Provenance::completion)
      .input(&CeramicRegime::speed_m_min, "v", "v", "m/min", non_negative(), "cutting speed", 80.0)
      .input(&CeramicRegime::depth_mm, "t", "t", "mm", non_negative(), "depth of cut", 0.1)
      .output(&ChatterRisk::risk, "risk", "-", "-", no_range(), "chatter, faster wear and a poor surface")
      .note("Printed for a depth of 0.1 mm; that deeper cuts are no better is a completion.");
  source
      .function<&part_deflection>("part_deflection", "Deflection of a bar between centres.", "eq. (C6)",
                                  Provenance::completion)
      .input(&BarLoad::p_y_n, "p_y", "P_y", "N", non_negative(), "radial force at mid-span", 500.0)
      .input(&BarLoad::length_mm, "length", "L", "mm", positive(), "length between centres", 600.0)
      .input(&BarLoad::diameter_mm, "diameter", "d", "mm", positive(), "diameter", 150.0)
      .input(&BarLoad::elastic_modulus_mpa, "e_modulus", "E", "MPa", positive(), "elastic modulus", 210000.0)
      .output(&Deflection::deflection_um, "deflection", "delta", "um", non_negative(), "deflection");
}

}  // namespace verstat::models::k106
