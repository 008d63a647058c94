#include "models/treatment/k103_magneto_abrasive_drills.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <boost/math/special_functions/gamma.hpp>

#include "models/math/policy.h"

namespace verstat::models::k103 {
namespace {

constexpr double treatment_s = 180;  // time of the published treatment
constexpr double longest_s = 300;

std::string name(Powder powder) {
  for (const auto& [value, text] : EnumNames<Powder>::names)
    if (value == powder) return text;
  return {};
}

double edge_radius_um(double before_um, double after_180_um, double time_s) {
  return before_um + (after_180_um - before_um) * (time_s / treatment_s);
}

}  // namespace

PowderClass mat_powder_class(const PowderChoice& in) {
  return guarded<&mat_powder_class>(in, [&]() -> PowderClass {
    switch (in.powder) {
      case Powder::polimam_m:
        return {GrainShape::rounded, RoundsEdge::no, true};
      case Powder::pr_r6m5:
        return {GrainShape::rounded, RoundsEdge::no, false};
      case Powder::tsaramam:
        return {GrainShape::non_equiaxed, RoundsEdge::unknown, true};
      case Powder::polimam_t:
        return {GrainShape::splintered, RoundsEdge::yes, false};
      case Powder::polimam_m_plus_5_polimam_t:
      case Powder::polimam_t_plus_10_pr_r6m5:
        break;
    }
    return {GrainShape::mixture, RoundsEdge::yes, true};
  });
}

TreatmentEffect mat_treatment_effect(const TreatedDrill& in) {
  return guarded<&mat_treatment_effect>(in, [&] {
    require(in.powder == Powder::polimam_t_plus_10_pr_r6m5, "powder", name(in.powder),
            "no data: numbers are published only for \"polimam_t_plus_10_pr_r6m5\"");
    return TreatmentEffect{.ra_after_max_um = 0.12,
                           .hardness_after_min_gpa = 1.12 * in.hardness_before_gpa,
                           .edge_radius_min_um = 15,
                           .edge_radius_max_um = 20,
                           .life_factor_min = 1.8,
                           .life_factor_typical = 2.0};
  });
}

TreatedSurface mat_surface_kinetics(const TreatmentCourse& in) {
  return guarded<&mat_surface_kinetics>(in, [&] {
    const double radius_um = edge_radius_um(in.edge_radius_before_um, in.edge_radius_180_um, in.time_s);
    require(radius_um > 0, "edge_radius_180_um", in.edge_radius_180_um,
            "is so far below edge_radius_before_um that no radius is left at time_s");
    const double share = std::min(in.time_s / treatment_s, 1.0);
    return TreatedSurface{in.ra_before_um * std::pow(in.ra_180_um / in.ra_before_um, share), radius_um};
  });
}

TreatmentTime mat_time_for_edge_radius(const EdgeTarget& in) {
  return guarded<&mat_time_for_edge_radius>(in, [&] {
    const double before_um = in.edge_radius_before_um;
    if (in.target_um <= before_um) return TreatmentTime{0};
    require(in.edge_radius_180_um > before_um, "edge_radius_180_um", in.edge_radius_180_um,
            "must be above edge_radius_before_um for the edge to become rounder");
    require(in.target_um <= edge_radius_um(before_um, in.edge_radius_180_um, longest_s), "target_radius_um",
            in.target_um, "must not be above the radius reached at 300 s");
    return TreatmentTime{
        std::min(longest_s, treatment_s * (in.target_um - before_um) / (in.edge_radius_180_um - before_um))};
  });
}

TreatedLife mat_weibull_life(const UntreatedLife& in) {
  return guarded<&mat_weibull_life>(in, [&] {
    const double scale_min = in.life_factor * in.scale_min;
    return TreatedLife{scale_min, in.shape, scale_min * boost::math::tgamma(1 + 1 / in.shape, MathPolicy())};
  });
}

TimePerTool mat_batch_time(const Batch& in) {
  return guarded<&mat_batch_time>(
      in, [&] { return TimePerTool{(in.cycle_s + in.handling_s) / (60 * static_cast<double>(in.size))}; });
}

BreakEven mat_break_even_cost(const ToolCost& in) {
  return guarded<&mat_break_even_cost>(in, [&] { return BreakEven{(in.life_factor - 1) * in.tool_cost}; });
}

ThrustTestResult constant_thrust_test(const ThrustTest& in) {
  return guarded<&constant_thrust_test>(in, [&] {
    return ThrustTestResult{in.rate_mm_min / in.speed_rpm, in.rate_mm_min / in.reference_rate_mm_min,
                            std::numbers::pi * in.drill_diameter_mm * in.speed_rpm / 1000};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K103",
       .title = "Magneto-abrasive treatment of high-speed-steel tools with various magneto-abrasive powder "
                "materials",
       .authors = "Maiboroda V. S., Anisimova A. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Twist drills are carried through a ring-shaped magnetic bath of abrasive powder, which "
                 "polishes the working surfaces, work-hardens them and rounds the edges. Six powder charges "
                 "compared by roughness, edge radius, hardness and drilling at constant thrust.",
       .role = "treatment",
       .errata = {
           "Hardness gain is \"> 12 %\" in the conclusions and \"> 10 %\" in the abstracts, roughness "
           "Ra < 0.12 um in the text and < 0.2 um in the English abstract: the conclusions are used.",
           "The charge with the best polish and rounding is not among the fastest, while one that leaves "
           "the edges nearly as they were is: life must not be derived from Ra or radius."}});

  const auto powder = [](auto& f, auto pointer) {
    f.input(pointer, "powder", "-", "-", no_range(), "powder charge", "polimam_t_plus_10_pr_r6m5");
  };
  const auto radii = [](auto& f, auto before, auto after) {
    f.optional(before, "edge_radius_before_um", "R_0", "um", positive(), "edge radius before the treatment")
        .optional(after, "edge_radius_180_um", "R_180", "um", positive(), "edge radius after 180 s");
  };
  source
      .function<&mat_powder_class>("mat_powder_class", "What is known of a powder charge.",
                                   "discussion of figs 1-5", Provenance::paper)
      .with([&](auto& f) { powder(f, &PowderChoice::powder); })
      .output(&PowderClass::shape, "shape", "-", "-", no_range(), "shape of the grains")
      .output(&PowderClass::rounds_edge, "rounds_edge", "-", "-", no_range(), "whether it rounds the edges")
      .output(&PowderClass::top_drilling_speed, "top_drilling_speed", "-", "-", no_range(),
              "among the fastest at constant thrust");
  source
      .function<&mat_treatment_effect>("mat_treatment_effect", "State and life of a drill treated for 180 s.",
                                       "conclusions and introduction", Provenance::paper)
      .with([&](auto& f) { powder(f, &TreatedDrill::powder); })
      .input(&TreatedDrill::hardness_before_gpa, "hardness_before_gpa", "HV200", "GPa", positive(),
             "hardness before", 9.1)
      .output(&TreatmentEffect::ra_after_max_um, "ra_after_max_um", "Ra", "um", positive(),
              "roughness stays below")
      .output(&TreatmentEffect::hardness_after_min_gpa, "hardness_after_min_gpa", "HV200", "GPa", positive(),
              "hardness is at least")
      .output(&TreatmentEffect::edge_radius_min_um, "edge_radius_min_um", "R", "um", positive(),
              "smallest edge radius")
      .output(&TreatmentEffect::edge_radius_max_um, "edge_radius_max_um", "R", "um", positive(),
              "largest edge radius")
      .output(&TreatmentEffect::life_factor_min, "life_factor_min", "k", "1", positive(),
              "life over that of an untreated drill, at least")
      .output(&TreatmentEffect::life_factor_typical, "life_factor_typical", "k", "1", positive(),
              "life over that of an untreated drill, typical")
      .note(
          "Numbers exist for the recommended charge only. The life factors come from earlier work of the "
          "authors on the ring bath and were not measured here.");
  source
      .function<&mat_surface_kinetics>("mat_surface_kinetics", "Roughness and edge radius over time.", "(C1)",
                                       Provenance::completion)
      .input(&TreatmentCourse::time_s, "time_s", "tau", "s", closed(0, longest_s), "treatment time", 90.0)
      .optional(&TreatmentCourse::ra_before_um, "ra_before_um", "Ra_0", "um", positive(), "roughness before")
      .optional(&TreatmentCourse::ra_180_um, "ra_180_um", "Ra_180", "um", positive(), "roughness after 180 s")
      .with([&](auto& f) {
        radii(f, &TreatmentCourse::edge_radius_before_um, &TreatmentCourse::edge_radius_180_um);
      })
      .output(&TreatedSurface::ra_um, "ra_um", "Ra", "um", positive(), "roughness")
      .output(&TreatedSurface::edge_radius_um, "edge_radius_um", "R", "um", positive(), "edge radius")
      .note(
          "Only the states at 0 and 180 s are printed; the law between and the growth after are assumed. "
          "Beyond 20 um the radius exceeds everything printed.");
  source
      .function<&mat_time_for_edge_radius>("mat_time_for_edge_radius", "Treatment time to an edge radius.",
                                           "(C1), inverse", Provenance::completion)
      .input(&EdgeTarget::target_um, "target_radius_um", "R", "um", positive(), "edge radius wanted", 15.0)
      .with([&](auto& f) { radii(f, &EdgeTarget::edge_radius_before_um, &EdgeTarget::edge_radius_180_um); })
      .output(&TreatmentTime::time_s, "time_s", "tau", "s", closed(0, longest_s), "treatment time");
  source
      .function<&mat_weibull_life>("mat_weibull_life", "Weibull life of a treated drill.", "(C2)",
                                   Provenance::completion)
      .input(&UntreatedLife::scale_min, "scale_min", "eta", "min", positive(), "scale of the untreated life",
             30.0)
      .input(&UntreatedLife::shape, "shape", "beta", "1", positive(), "Weibull shape", 2.0)
      .optional(&UntreatedLife::life_factor, "life_factor", "k", "1", positive(),
                "life over that of an untreated drill")
      .output(&TreatedLife::scale_min, "scale_min", "eta'", "min", positive(), "scale of the treated life")
      .output(&TreatedLife::shape, "shape", "beta'", "1", positive(), "Weibull shape, unchanged")
      .output(&TreatedLife::mean_min, "mean_life_min", "T", "min", positive(), "mean of the treated life")
      .note("The effect on the scatter is not given.");
  source
      .function<&mat_batch_time>("mat_batch_time", "Treatment time per tool.", "(C3)", Provenance::completion)
      .input(&Batch::size, "batch_size", "-", "1", at_least(1), "tools in the bath", 12)
      .optional(&Batch::cycle_s, "cycle_s", "-", "s", non_negative(), "time of the cycle")
      .optional(&Batch::handling_s, "handling_s", "-", "s", non_negative(), "handling per batch")
      .output(&TimePerTool::time_min, "time_per_tool_min", "-", "min", non_negative(), "time per tool")
      .note("180 s are taken as the whole cycle; give 360 s if they are meant per direction of flow.");
  source
      .function<&mat_break_even_cost>("mat_break_even_cost", "Treatment cost at which it still pays.", "(C4)",
                                      Provenance::completion)
      .input(&ToolCost::tool_cost, "tool_cost", "C", "currency", non_negative(), "tool cost per life", 10.0)
      .optional(&ToolCost::life_factor, "life_factor", "k", "1", positive(),
                "life over that of an untreated drill")
      .output(&BreakEven::max_treatment_cost, "max_treatment_cost", "c", "currency", any(),
              "largest treatment cost per life; negative: it never pays")
      .note("Saved tool changes are not counted: the true limit is higher.");
  source
      .function<&constant_thrust_test>("constant_thrust_test", "Drilling test at constant thrust.", "(E1)",
                                       Provenance::reconstructed)
      .input(&ThrustTest::rate_mm_min, "penetration_rate_mm_min", "v_p", "mm/min", positive(),
             "penetration rate", 110.0)
      .input(&ThrustTest::reference_rate_mm_min, "reference_rate_mm_min", "v_p,ref", "mm/min", positive(),
             "penetration rate of the reference drill at the same thrust", 88.0)
      .optional(&ThrustTest::speed_rpm, "speed_rpm", "n", "rpm", positive(), "spindle speed")
      .optional(&ThrustTest::drill_diameter_mm, "drill_diameter_mm", "d", "mm", positive(), "drill diameter")
      .output(&ThrustTestResult::feed_mm_rev, "feed_mm_rev", "f", "mm/rev", positive(), "feed")
      .output(&ThrustTestResult::relative_performance, "relative_performance", "-", "1", positive(),
              "penetration rate over that of the reference")
      .output(&ThrustTestResult::cutting_speed_m_min, "cutting_speed_m_min", "v_c", "m/min", positive(),
              "cutting speed");
}

}  // namespace verstat::models::k103
