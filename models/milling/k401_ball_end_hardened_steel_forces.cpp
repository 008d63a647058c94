#include "models/milling/k401_ball_end_hardened_steel_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace verstat::models::k401 {
namespace {

// Explored box, table of the plan.
constexpr double rpm_low = 8936, rpm_high = 31100;
constexpr double feed_low = 0.04, feed_high = 0.12;
constexpr double depth_low = 0.06, depth_high = 0.36;
constexpr double step_low = 0.3, step_high = 0.6;
constexpr double relief_low = 6, relief_high = 18;
constexpr double hrc_low = 40, hrc_high = 55;

// The parts of (1)-(3) that do not hold the feed, so that searches in the feed stay cheap.
class LogForces {
 public:
  LogForces(double n, double a_p, double a_e, double alpha, double hrc)
      : a_e_(a_e), ln_ae_(std::log(a_e)), ln_alpha_(std::log(alpha)), ln_h_(std::log(hrc)), h_(hrc) {
    g_ = hrc * ln_h_;
    x_constant_ = -0.85 - 1.9e-6 * n * alpha + 0.02 * g_;
    y_constant_ = 3.33 + 4.26e-5 * h_ * g_ + 1.34 * a_e * a_e;
    y_log_ = (2.7e-6 * n + 0.048) * ln_alpha_;
    z_constant_ = 4.93 - 0.0024 * g_ * ln_alpha_ - 0.49 * a_e * ln_h_;
    z_log_ = -28.24 * a_p * a_e;
  }
  // ln P_x, ln P_y, ln P_z at a feed, eq. (1)-(3).
  [[nodiscard]] std::array<double, 3> at(double f) const {
    const double ln_f = std::log(f);
    const double f3 = f * f * f;
    return {x_constant_ + 1.32e-8 * g_ * g_ * g_ * f3 * f - 2.77e-3 * a_e_ * a_e_ * g_ * ln_f -
                169.21 * f3 * ln_ae_,
            y_constant_ + y_log_ * ln_f - 5.67 * f3 * f * f * h_ * g_ * a_e_ * a_e_ * ln_ae_,
            z_constant_ + z_log_ * f * ln_f};
  }

 private:
  double a_e_, ln_ae_, ln_alpha_, ln_h_, h_;
  double g_ = 0, x_constant_ = 0, y_constant_ = 0, y_log_ = 0, z_constant_ = 0, z_log_ = 0;
};

// Largest excess of the logarithm of a force over that of its limit, and which force it is.
struct Excess {
  double value;
  BindingForce force;
};
class LimitedForces {
 public:
  LimitedForces(const LogForces& forces, double px_max, double py_max, double pz_max)
      : forces_(forces), limits_{std::log(px_max), std::log(py_max), std::log(pz_max)} {}
  [[nodiscard]] Excess at(double f) const {
    const auto ln_p = forces_.at(f);
    Excess worst{ln_p[0] - limits_[0], BindingForce::px};
    if (ln_p[1] - limits_[1] > worst.value) worst = {ln_p[1] - limits_[1], BindingForce::py};
    if (ln_p[2] - limits_[2] > worst.value) worst = {ln_p[2] - limits_[2], BindingForce::pz};
    return worst;
  }

 private:
  LogForces forces_;
  std::array<double, 3> limits_;
};

constexpr double golden = 0.6180339887498949;

// Golden section for the largest value of `f` in [low, high], unimodal there (-infinity allowed).
template <class F>
double golden_maximum(F&& f, double low, double high, double width) {
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double at_a = f(a);
  double at_b = f(b);
  while (high - low > width) {
    if (at_a >= at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = f(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = f(b);
    }
  }
  return (low + high) / 2;
}

// The worst excess is quasi-convex in the feed, so the feasible feeds are one interval: its upper end.
LargestFeed largest_feed(const LimitedForces& limited) {
  if (limited.at(feed_high).value <= 0) return {true, feed_high, BindingForce::range};
  double low = golden_maximum([&](double f) { return -limited.at(f).value; }, feed_low, feed_high, 1e-12);
  if (limited.at(feed_low).value <= limited.at(low).value) low = feed_low;
  if (const Excess least = limited.at(low); least.value > 0) return {false, 0, least.force};
  double high = feed_high;
  for (int k = 0; k < 100 && high - low > 1e-16; ++k) {
    const double middle = (low + high) / 2;
    (limited.at(middle).value <= 0 ? low : high) = middle;
  }
  return {true, low, limited.at(high).force};
}

struct Candidate {
  double removal;  // a_p a_e f_z, -infinity when infeasible
  double f_z, a_p;
};
// Best feed and depth for a step-over at the highest speed. The removal rises with the feed: a_p f is
// constant/(-ln f) where P_z limits the depth and 0.36 f where it does not. So the best feed is the largest
// that keeps all forces at the smallest depth.
Candidate best_for_step(const RegimeProblem& in, double a_e) {
  const LimitedForces shallow(LogForces(rpm_high, depth_low, a_e, in.relief_deg, in.hardness_hrc),
                              in.px_max_n, in.py_max_n, in.pz_max_n);
  const LargestFeed feed = largest_feed(shallow);
  if (!feed.feasible) return {-std::numeric_limits<double>::infinity(), 0, 0};
  const double f = feed.feed_mm_tooth;
  const double ln_h = std::log(in.hardness_hrc);
  const double left = std::log(in.pz_max_n) - 4.93 +
                      0.0024 * in.hardness_hrc * ln_h * std::log(in.relief_deg) + 0.49 * a_e * ln_h;
  const double depth = std::clamp(left / (-28.24 * a_e * f * std::log(f)), depth_low, depth_high);
  return {depth * a_e * f, f, depth};
}

double effective_diameter(double diameter, double depth) {
  return 2 * std::sqrt(depth * (diameter - depth));
}

}  // namespace

BallEndForces ball_end_forces(const BallEndCut& in) {
  return guarded<&ball_end_forces>(in, [&] {
    const auto ln_p = LogForces(in.spindle_rpm, in.depth_mm, in.step_over_mm, in.relief_deg, in.hardness_hrc)
                          .at(in.feed_mm_tooth);
    const double x = std::exp(ln_p[0]);
    const double y = std::exp(ln_p[1]);
    const double z = std::exp(ln_p[2]);
    const auto inside = [](double value, double low, double high) { return value >= low && value <= high; };
    return BallEndForces{
        x,
        y,
        z,
        std::hypot(x, z),
        std::hypot(x, y, z),
        inside(in.spindle_rpm, rpm_low, rpm_high) && inside(in.feed_mm_tooth, feed_low, feed_high) &&
            inside(in.depth_mm, depth_low, depth_high) && inside(in.step_over_mm, step_low, step_high) &&
            inside(in.relief_deg, relief_low, relief_high) && inside(in.hardness_hrc, hrc_low, hrc_high)};
  });
}

ForceGradient ball_end_force_gradient(const BallEndCut& in) {
  return guarded<&ball_end_force_gradient>(in, [&] {
    const double n = in.spindle_rpm, f = in.feed_mm_tooth, a_p = in.depth_mm, a_e = in.step_over_mm;
    const double alpha = in.relief_deg, h = in.hardness_hrc;
    const double ln_h = std::log(h), g = h * ln_h;
    const double ln_f = std::log(f), ln_ae = std::log(a_e), ln_alpha = std::log(alpha);
    const double f2 = f * f, f3 = f2 * f, f4 = f2 * f2, f5 = f4 * f;
    ForceGradient d{};
    d.x_n = -1.9e-6 * alpha;
    d.x_fz = 5.28e-8 * g * g * g * f3 - 2.77e-3 * a_e * a_e * g / f - 507.63 * f2 * ln_ae;
    d.x_ap = 0;
    d.x_ae = -5.54e-3 * a_e * g * ln_f - 169.21 * f3 / a_e;
    d.x_alpha = -1.9e-6 * n;
    d.x_hrc = (0.02 + 3.96e-8 * g * g * f4 - 2.77e-3 * a_e * a_e * ln_f) * (ln_h + 1);
    d.y_n = 2.7e-6 * ln_alpha * ln_f;
    d.y_fz = (2.7e-6 * n + 0.048) * ln_alpha / f - 28.35 * f4 * h * g * a_e * a_e * ln_ae;
    d.y_ap = 0;
    d.y_ae = 2.68 * a_e - 5.67 * f5 * h * g * a_e * (2 * ln_ae + 1);
    d.y_alpha = (2.7e-6 * n + 0.048) * ln_f / alpha;
    d.y_hrc = (4.26e-5 - 5.67 * f5 * a_e * a_e * ln_ae) * h * (2 * ln_h + 1);
    d.z_n = 0;
    d.z_fz = -28.24 * a_p * a_e * (ln_f + 1);
    d.z_ap = -28.24 * a_e * f * ln_f;
    d.z_ae = -28.24 * a_p * f * ln_f - 0.49 * ln_h;
    d.z_alpha = -0.0024 * g / alpha;
    d.z_hrc = -0.0024 * (ln_h + 1) * ln_alpha - 0.49 * a_e / h;
    return d;
  });
}

LargestFeed max_feed_for_force_limits(const LimitedCut& in) {
  return guarded<&max_feed_for_force_limits>(in, [&] {
    return largest_feed(
        LimitedForces(LogForces(in.spindle_rpm, in.depth_mm, in.step_over_mm, in.relief_deg, in.hardness_hrc),
                      in.px_max_n, in.py_max_n, in.pz_max_n));
  });
}

BestRegime best_regime(const RegimeProblem& in) {
  return guarded<&best_regime>(in, [&] {
    // No force rises with the speed. One variable is left, the step-over; its best removal has kinks and may
    // end where no feed is feasible, hence a grid and golden section around every local maximum of it.
    constexpr int cells = 120;
    const auto removal = [&](double a_e) { return best_for_step(in, a_e).removal; };
    const auto node = [&](int k) {
      return k == cells ? step_high : step_low + (step_high - step_low) * k / cells;
    };
    std::array<double, cells + 1> values{};
    for (int k = 0; k <= cells; ++k) values[static_cast<std::size_t>(k)] = removal(node(k));
    double best_step = 0;
    double best = -std::numeric_limits<double>::infinity();
    const auto offer = [&](double a_e, double value) {
      if (value > best) {
        best = value;
        best_step = a_e;
      }
    };
    for (int k = 0; k <= cells; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (!std::isfinite(values[i])) continue;
      offer(node(k), values[i]);
      if ((k > 0 && values[i] < values[i - 1]) || (k < cells && values[i] < values[i + 1])) continue;
      const double step =
          golden_maximum(removal, node(std::max(k - 1, 0)), node(std::min(k + 1, cells)), 1e-9);
      offer(step, removal(step));
    }
    if (!std::isfinite(best)) return BestRegime{false, 0, 0, 0, 0, 0};
    const Candidate chosen = best_for_step(in, best_step);
    return BestRegime{true,       rpm_high,
                      chosen.f_z, chosen.a_p,
                      best_step,  chosen.removal * rpm_high * static_cast<double>(in.teeth) / 1000};
  });
}

FinishingRates ball_finishing_rates(const BallFinishing& in) {
  return guarded<&ball_finishing_rates>(in, [&] {
    require(in.depth_mm <= in.diameter_mm / 2, "a_p", in.depth_mm, "must not be above d/2");
    require(in.step_over_mm <= in.diameter_mm, "a_e", in.step_over_mm, "must not be above d");
    const double feed = in.spindle_rpm * static_cast<double>(in.teeth) * in.feed_mm_tooth;
    const double diameter = effective_diameter(in.diameter_mm, in.depth_mm);
    const double radius = in.diameter_mm / 2;
    const double half_step = in.step_over_mm / 2;
    // R - sqrt(R^2 - x^2) without cancellation.
    const double scallop = half_step * half_step /
                           (radius + std::sqrt(std::max(0.0, (radius - half_step) * (radius + half_step))));
    return FinishingRates{
        feed,     in.depth_mm * in.step_over_mm * feed / 1000,         in.step_over_mm * feed / 100,
        diameter, std::numbers::pi * diameter * in.spindle_rpm / 1000, 1000 * scallop};
  });
}

Power power_bound(const PowerLoad& in) {
  return guarded<&power_bound>(in, [&] { return Power{in.in_plane_n * in.speed_m_min / 60000}; });
}

Deflection tool_deflection(const Overhang& in) {
  return guarded<&tool_deflection>(in, [&] {
    const double shank = 0.8 * in.diameter_mm;
    const double inertia = std::numbers::pi * shank * shank * shank * shank / 64;
    const double length = in.overhang_mm;
    return Deflection{1000 * in.force_n * length * length * length / (3 * in.modulus_mpa * inertia)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K401",
       .title = "Modelling of cutting forces in high-speed machining of hardened steels with ball-end mills",
       .authors = "Ravskaya N. S., Lipskiy E. R., Skrynnik P. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "High-speed finish milling of hardened forming dies (steel 5KhNM, HRC 40-55) with a two-flute "
           "solid-carbide ball-end mill: the three maximum force components as functions of spindle speed, "
           "feed, depth, step-over, relief angle and hardness, identified from 55 runs.",
       .role = "milling",
       .errata = {
           "The unit of force is not printed: newton, from the specific force and an independent model.",
           "The term 1.32e-8 g^3 f_z^4 of eq. (1) is never above 3e-5 and so probably misprinted; kept as "
           "printed.",
           "The upper and lower hardness are swapped in the printed table of the plan."}});

  const auto n = [](auto& f) {
    f.input(&BallEndCut::spindle_rpm, "n", "n", "rpm", positive(), "spindle speed (fitted on 8936-31100)",
            20018.0);
  };
  const auto f_z = [](auto& f) {
    f.input(&BallEndCut::feed_mm_tooth, "f_z", "S_z", "mm/tooth", positive(), "feed per tooth (0.04-0.12)",
            0.08);
  };
  const auto widths = [](auto& f) {
    f.input(&CutWidth::depth_mm, "a_p", "t", "mm", positive(), "depth of cut (0.06-0.36)", 0.21)
        .input(&CutWidth::step_over_mm, "a_e", "B", "mm", positive(), "step-over (0.3-0.6)", 0.45)
        .input(&CutWidth::relief_deg, "alpha", "alpha", "deg", positive(), "relief angle (6-18)", 12.0)
        .input(&CutWidth::hardness_hrc, "hrc", "H", "HRC", above(1), "hardness of the work, HRC_E (40-55)",
               47.5);
  };
  const auto cut = [&](auto& f) {
    n(f);
    f_z(f);
    widths(f);
  };
  const auto limits = [](auto& f, auto px, auto py, auto pz) {
    f.input(px, "px_max", "P_x,max", "N", positive(), "limit of the feed force", 20.0)
        .input(py, "py_max", "P_y,max", "N", positive(), "limit of the push-off force", 30.0)
        .input(pz, "pz_max", "P_z,max", "N", positive(), "limit of the normal force", 40.0);
  };
  const char* const never_alone =
      "P_z falls with hardness while P_x rises: use the resultant or all three limits together.";

  source
      .function<&ball_end_forces>("ball_end_forces", "Largest force components over a revolution.",
                                  "eq. (1)-(3)", Provenance::paper)
      .with(cut)
      .output(&BallEndForces::feed_n, "p_x", "P_x", "N", non_negative(), "feed force")
      .output(&BallEndForces::push_off_n, "p_y", "P_y", "N", non_negative(),
              "push-off force along the tool axis")
      .output(&BallEndForces::normal_n, "p_z", "P_z", "N", non_negative(), "force normal to the feed force")
      .output(&BallEndForces::in_plane_n, "p_xz", "P_xz", "N", non_negative(), "in-plane force, upper bound")
      .output(&BallEndForces::resultant_n, "resultant", "R", "N", non_negative(), "resultant, upper bound")
      .output(&BallEndForces::in_range, "in_range", "-", "-", no_range(), "inputs inside the explored box")
      .note(never_alone)
      .note(
          "No behaviour outside the box is implied; ball diameter, overhang and model error are not "
          "printed.");
  source
      .function<&ball_end_force_gradient>("ball_end_force_gradient",
                                          "Derivatives of the logarithms of the three forces.", "eq. (4)-(6)",
                                          Provenance::completion)
      .with(cut)
      .output(&ForceGradient::x_n, "dlnpx_dn", "-", "1/rpm", any(), "ln P_x by n")
      .output(&ForceGradient::x_fz, "dlnpx_df_z", "-", "1/mm", any(), "ln P_x by f_z")
      .output(&ForceGradient::x_ap, "dlnpx_da_p", "-", "1/mm", any(), "ln P_x by a_p")
      .output(&ForceGradient::x_ae, "dlnpx_da_e", "-", "1/mm", any(), "ln P_x by a_e")
      .output(&ForceGradient::x_alpha, "dlnpx_dalpha", "-", "1/deg", any(), "ln P_x by alpha")
      .output(&ForceGradient::x_hrc, "dlnpx_dhrc", "-", "1/HRC", any(), "ln P_x by hrc")
      .output(&ForceGradient::y_n, "dlnpy_dn", "-", "1/rpm", any(), "ln P_y by n")
      .output(&ForceGradient::y_fz, "dlnpy_df_z", "-", "1/mm", any(), "ln P_y by f_z")
      .output(&ForceGradient::y_ap, "dlnpy_da_p", "-", "1/mm", any(), "ln P_y by a_p")
      .output(&ForceGradient::y_ae, "dlnpy_da_e", "-", "1/mm", any(), "ln P_y by a_e")
      .output(&ForceGradient::y_alpha, "dlnpy_dalpha", "-", "1/deg", any(), "ln P_y by alpha")
      .output(&ForceGradient::y_hrc, "dlnpy_dhrc", "-", "1/HRC", any(), "ln P_y by hrc")
      .output(&ForceGradient::z_n, "dlnpz_dn", "-", "1/rpm", any(), "ln P_z by n")
      .output(&ForceGradient::z_fz, "dlnpz_df_z", "-", "1/mm", any(), "ln P_z by f_z")
      .output(&ForceGradient::z_ap, "dlnpz_da_p", "-", "1/mm", any(), "ln P_z by a_p")
      .output(&ForceGradient::z_ae, "dlnpz_da_e", "-", "1/mm", any(), "ln P_z by a_e")
      .output(&ForceGradient::z_alpha, "dlnpz_dalpha", "-", "1/deg", any(), "ln P_z by alpha")
      .output(&ForceGradient::z_hrc, "dlnpz_dhrc", "-", "1/HRC", any(), "ln P_z by hrc");
  source
      .function<&max_feed_for_force_limits>("max_feed_for_force_limits",
                                            "Largest feed under three force limits.", "eq. (1)-(3), inverse",
                                            Provenance::completion)
      .with(n)
      .with(widths)
      .with([&](auto& f) { limits(f, &LimitedCut::px_max_n, &LimitedCut::py_max_n, &LimitedCut::pz_max_n); })
      .output(&LargestFeed::feasible, "feasible", "-", "-", no_range(),
              "a feed in 0.04..0.12 keeps the limits")
      .output(&LargestFeed::feed_mm_tooth, "f_z_max", "S_z", "mm/tooth", closed(0, 0.12),
              "largest feed, 0 when infeasible")
      .output(&LargestFeed::binding, "binding", "-", "-", no_range(), "what limits the feed")
      .note(never_alone);
  source
      .function<&best_regime>("best_regime", "Largest removal rate in the explored box under force limits.",
                              "eq. (1)-(3), optimum", Provenance::completion)
      .input(&RegimeProblem::hardness_hrc, "hrc", "H", "HRC", above(1), "hardness of the work (40-55)", 47.5)
      .input(&RegimeProblem::relief_deg, "alpha", "alpha", "deg", above(1), "relief angle (6-18)", 12.0)
      .input(&RegimeProblem::teeth, "z", "z", "1", at_least(1), "number of teeth", 2)
      .with([&](auto& f) {
        limits(f, &RegimeProblem::px_max_n, &RegimeProblem::py_max_n, &RegimeProblem::pz_max_n);
      })
      .output(&BestRegime::feasible, "feasible", "-", "-", no_range(),
              "some regime in the box keeps the limits")
      .output(&BestRegime::spindle_rpm, "n", "n", "rpm", non_negative(), "spindle speed")
      .output(&BestRegime::feed_mm_tooth, "f_z", "S_z", "mm/tooth", non_negative(), "feed per tooth")
      .output(&BestRegime::depth_mm, "a_p", "t", "mm", non_negative(), "depth of cut")
      .output(&BestRegime::step_over_mm, "a_e", "B", "mm", non_negative(), "step-over")
      .output(&BestRegime::removal_cm3_min, "removal_rate", "Q", "cm3/min", non_negative(), "removal rate")
      .note("No force rises with the speed, so it goes to its bound: tool life or machine must limit it.");
  source
      .function<&ball_finishing_rates>("ball_finishing_rates",
                                       "Rates, effective speed and scallop of raster finishing.",
                                       "completion (C1)-(C4)", Provenance::completion)
      .input(&BallFinishing::spindle_rpm, "n", "n", "rpm", positive(), "spindle speed", 20000.0)
      .input(&BallFinishing::feed_mm_tooth, "f_z", "S_z", "mm/tooth", positive(), "feed per tooth", 0.08)
      .input(&BallFinishing::teeth, "z", "z", "1", at_least(1), "number of teeth", 2)
      .input(&BallFinishing::depth_mm, "a_p", "t", "mm", positive(), "depth of cut, at most d/2", 0.2)
      .input(&BallFinishing::step_over_mm, "a_e", "B", "mm", positive(), "step-over, at most d", 0.45)
      .input(&BallFinishing::diameter_mm, "d", "D", "mm", positive(), "ball diameter", 10.0)
      .output(&FinishingRates::feed_mm_min, "v_f", "v_f", "mm/min", positive(), "feed rate")
      .output(&FinishingRates::removal_cm3_min, "removal_rate", "Q", "cm3/min", positive(), "removal rate")
      .output(&FinishingRates::area_cm2_min, "area_rate", "-", "cm2/min", positive(), "area finished")
      .output(&FinishingRates::effective_diameter_mm, "d_eff", "D_eff", "mm", positive(),
              "diameter at the depth of cut")
      .output(&FinishingRates::effective_speed_m_min, "v_eff", "v_eff", "m/min", positive(),
              "cutting speed at the depth of cut")
      .output(&FinishingRates::scallop_um, "scallop", "h", "um", non_negative(), "height of the scallops");
  source
      .function<&power_bound>("power_bound", "Upper bound of the cutting power.", "completion (C5)",
                              Provenance::completion)
      .input(&PowerLoad::in_plane_n, "p_xz", "P_xz", "N", non_negative(), "in-plane force", 36.99)
      .input(&PowerLoad::speed_m_min, "v_eff", "v_eff", "m/min", non_negative(), "cutting speed", 177.0)
      .output(&Power::power_kw, "power", "N", "kW", non_negative(), "power, not more than");
  source
      .function<&tool_deflection>("tool_deflection", "Deflection of the tool tip.", "completion (C6)",
                                  Provenance::completion)
      .input(&Overhang::force_n, "force", "F", "N", non_negative(), "force in the plane of rotation", 30.0)
      .input(&Overhang::diameter_mm, "d", "D", "mm", positive(), "ball diameter", 10.0)
      .input(&Overhang::overhang_mm, "overhang", "L", "mm", positive(), "overhang", 40.0)
      .input(&Overhang::modulus_mpa, "e_modulus", "E", "MPa", positive(), "modulus (carbide 580000-620000)",
             600000.0)
      .output(&Deflection::deflection_um, "deflection", "-", "um", non_negative(), "deflection");
}

}  // namespace verstat::models::k401
