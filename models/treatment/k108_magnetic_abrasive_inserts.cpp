#include "models/treatment/k108_magnetic_abrasive_inserts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k108 {
namespace {

double settled_ra_um(Mixture mixture) {
  return mixture == Mixture::fine ? 0.065 : 0.105;  // middles of the printed 0.06-0.07 and 0.10-0.11 um
}

bool recommended_angle(double deg) {
  return deg >= 20 && deg <= 30;  // conclusions
}

}  // namespace

TreatmentTime treatment_time(const Stages& in) {
  return guarded<&treatment_time>(
      in, [&] { return TreatmentTime{static_cast<double>(in.stages) * in.stage_time_s / 60}; });
}

Roughness final_roughness(const MixtureChoice& in) {
  return guarded<&final_roughness>(in, [&] { return Roughness{settled_ra_um(in.mixture)}; });
}

SettingVerdict recommended_setting(const Setting& in) {
  return guarded<&recommended_setting>(in, [&] {
    return SettingVerdict{recommended_angle(in.tilt_deg) && recommended_angle(in.turn_deg),
                          in.mixture == Mixture::fine};
  });
}

RingRadius ring_radius(const CarrierMotion& in) {
  return guarded<&ring_radius>(
      in, [&] { return RingRadius{60 * 1000 * in.speed_m_s / (2 * std::numbers::pi * in.speed_rpm)}; });
}

Roughness roughness_after(const TreatedFace& in) {
  return guarded<&roughness_after>(in, [&] {
    constexpr double settling_s = 200;  // text, stage 2
    const double settled_um = settled_ra_um(in.mixture);
    return Roughness{settled_um + (in.ra_initial_um - settled_um) * std::exp(-3 * in.time_s / settling_s)};
  });
}

HardnessFactor hardness_factor(const HardeningTime& in) {
  return guarded<&hardness_factor>(in, [&] {
    constexpr double gain = 0.135;  // middle of the printed 13-14 %
    constexpr double peak_s = 120;  // middle of the printed 100-140 s of the first peak
    return HardnessFactor{1 - gain * std::expm1(-3 * in.time_s / peak_s)};
  });
}

EdgeRadius edge_radius_after(const EdgeTreatment& in) {
  return guarded<&edge_radius_after>(in, [&] {
    return EdgeRadius{in.initial_um + in.rate_um_s * std::min(in.time_s, in.break_s) +
                      in.slow_factor * in.rate_um_s * std::max(0.0, in.time_s - in.break_s)};
  });
}

EdgeTime time_for_edge_radius(const EdgeTarget& in) {
  return guarded<&time_for_edge_radius>(in, [&] {
    if (in.target_um <= in.initial_um) return EdgeTime{0};
    const double at_break_um = in.initial_um + in.rate_um_s * in.break_s;
    if (in.target_um <= at_break_um)
      return EdgeTime{std::min(in.break_s, (in.target_um - in.initial_um) / in.rate_um_s)};
    require(in.slow_factor > 0, "rho_target", in.target_um,
            "must not be above the radius at t_break when slow_factor = 0");
    return EdgeTime{in.break_s + (in.target_um - at_break_um) / (in.slow_factor * in.rate_um_s)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K108",
       .title =
           "Influence of the conditions of magnetic-abrasive treatment in large ring-type working gaps on "
           "the quality of indexable carbide inserts",
       .authors = "Maiboroda V. S., Dzhulii D. Yu.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Inserts on inclined mandrels travel through a magnetic ring bath of ferromagnetic powder and "
           "diamond paste: edge radius, surface hardness and roughness against time, mandrel angles and "
           "powder. Experimental, no equations; the curves are lost with the figures.",
       .role = "treatment",
       .errata = {
           "The angles p and q are also printed as rho and phi; q is a turn about the vertical, though "
           "the figure caption says about the mandrel's own axis.",
           "The text ties roughness to hardness in phase and in antiphase; the sign is not recoverable "
           "and the waves are left out.",
           "Stage 2 was run at p = 40, q = 10 deg, outside the recommended window, yet supports the "
           "recommended mixture."}});

  const auto mixture = [](auto& f, auto pointer) {
    f.input(pointer, "mixture", "-", "-", no_range(),
            "fine: shot 200/100 um + paste 3/2+2/1 um; coarse: shot 400/315 + paste 14/10", "fine");
  };
  const auto growth = [](auto& f, auto initial, auto rate, auto break_s, auto slow) {
    f.input(initial, "rho_initial", "rho_0", "um", non_negative(), "edge radius before", 10.0)
        .input(rate, "rate", "k", "um/s", positive(), "rate of growth at first", 0.055)
        .input(break_s, "t_break", "t_b", "s", non_negative(), "time from which the growth slows", 330.0)
        .input(slow, "slow_factor", "lambda", "1", closed(0, 1), "share of the rate left after t_break", 0.3);
  };

  source
      .function<&treatment_time>("treatment_time", "Time of a treatment in equal stages.", "text",
                                 Provenance::paper)
      .input(&Stages::stages, "stages", "-", "1", at_least(0), "number of stages", 8)
      .input(&Stages::stage_time_s, "stage_time", "-", "s", non_negative(), "time of one stage", 26.0)
      .output(&TreatmentTime::total_min, "t_total", "-", "min", non_negative(), "time of the treatment");
  source
      .function<&final_roughness>("final_roughness", "Roughness at which the treated faces settle.", "text",
                                  Provenance::paper)
      .with([&](auto& f) { mixture(f, &MixtureChoice::mixture); })
      .output(&Roughness::ra_um, "ra", "Ra", "um", positive(), "roughness")
      .note("The middle of the printed range, 0.06-0.07 or 0.10-0.11 um.");
  source
      .function<&recommended_setting>("recommended_setting", "Whether a setting is the recommended one.",
                                      "conclusions", Provenance::paper)
      .input(&Setting::tilt_deg, "p", "p", "deg", any(),
             "tilt of the mandrel in the plane tangent to the ring", 24.0)
      .input(&Setting::turn_deg, "q", "q", "deg", any(), "turn of the mandrel about the vertical", 25.0)
      .with([&](auto& f) { mixture(f, &Setting::mixture); })
      .output(&SettingVerdict::angles_ok, "angles_ok", "-", "-", no_range(), "both angles are 20..30 deg")
      .output(&SettingVerdict::mixture_ok, "mixture_ok", "-", "-", no_range(), "the mixture is the fine one");
  source.function<&ring_radius>("ring_radius", "Radius of the ring bath.", "(C1)", Provenance::completion)
      .input(&CarrierMotion::speed_m_s, "v", "v", "m/s", positive(), "linear speed", 2.0)
      .input(&CarrierMotion::speed_rpm, "n", "n", "rpm", positive(), "speed of the mandrel carrier", 200.0)
      .output(&RingRadius::radius_mm, "radius", "R", "mm", positive(), "radius of the ring");
  source
      .function<&roughness_after>("roughness_after", "Roughness after a treatment time.", "(C2)",
                                  Provenance::completion)
      .input(&TreatedFace::time_s, "t", "t", "s", non_negative(), "treatment time", 60.0)
      .input(&TreatedFace::ra_initial_um, "ra_initial", "Ra_0", "um", positive(), "roughness before", 0.4)
      .with([&](auto& f) { mixture(f, &TreatedFace::mixture); })
      .output(&Roughness::ra_um, "ra", "Ra", "um", positive(), "roughness")
      .note(
          "Only the settling time and level are printed; the exponential between is assumed. Vibro-abraded "
          "faces were not improved.");
  source
      .function<&hardness_factor>("hardness_factor", "Gain in surface hardness after a treatment time.",
                                  "(C3)", Provenance::completion)
      .input(&HardeningTime::time_s, "t", "t", "s", closed(0, 480), "treatment time", 480.0)
      .output(&HardnessFactor::factor, "factor", "HV/HV_0", "1", closed(1, 1.135),
              "hardness over initial hardness")
      .note("The printed wave of hardness is not modelled: its amplitudes are lost.");
  source
      .function<&edge_radius_after>("edge_radius_after", "Edge radius after a treatment time.", "(C4)",
                                    Provenance::completion)
      .input(&EdgeTreatment::time_s, "t", "t", "s", non_negative(), "treatment time", 480.0)
      .with([&](auto& f) {
        growth(f, &EdgeTreatment::initial_um, &EdgeTreatment::rate_um_s, &EdgeTreatment::break_s,
               &EdgeTreatment::slow_factor);
      })
      .output(&EdgeRadius::radius_um, "rho", "rho", "um", non_negative(), "edge radius")
      .note(
          "Only \"up to 30 um\" is printed, and that the fine mixture acts uniformly while the coarse one "
          "slows after 300-360 s: the rates are the user's.");
  source
      .function<&time_for_edge_radius>("time_for_edge_radius", "Treatment time to reach an edge radius.",
                                       "(C4), inverse", Provenance::completion)
      .input(&EdgeTarget::target_um, "rho_target", "rho", "um", non_negative(), "edge radius wanted", 30.0)
      .with([&](auto& f) {
        growth(f, &EdgeTarget::initial_um, &EdgeTarget::rate_um_s, &EdgeTarget::break_s,
               &EdgeTarget::slow_factor);
      })
      .output(&EdgeTime::time_s, "t", "t", "s", non_negative(), "treatment time");
}

}  // namespace verstat::models::k108
