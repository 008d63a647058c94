#include "models/inspection/k121_thermo_emf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/math/gauss_legendre.h"
#include "models/math/normal.h"
#include "models/math/solve.h"

namespace verstat::models::k121 {
namespace {

// Eq. (2); the exponents 0.2, 0.15, 0.35 are printed there.
double coefficient(double emf_mv) {
  return (501 - 41 * emf_mv) / std::pow(emf_mv, 0.24);
}
double cut_factor(const Cut& in) {
  return std::pow(in.depth_mm, 0.15) * std::pow(in.feed_mm_rev, 0.35) / in.k_v;
}
double speed(double emf_mv, const Cut& cut, double tool_life_min) {
  return coefficient(emf_mv) / (std::pow(tool_life_min, 0.2) * cut_factor(cut));
}
double life(double emf_mv, const Cut& cut, double speed_m_min) {
  // max: rounding at the very end of the range must not turn the life negative.
  return std::pow(std::max(0.0, coefficient(emf_mv)) / (speed_m_min * cut_factor(cut)), 5);
}
double speed_slope(double emf_mv) {
  return -41 / (501 - 41 * emf_mv) - 0.24 / emf_mv;
}

// P(a < Z < b), from the tail that keeps its digits.
double normal_between(double a, double b) {
  return a > 0 ? normal_cdf(-a) - normal_cdf(-b) : normal_cdf(b) - normal_cdf(a);
}

Groups sort_groups(const Sorting& in) {
  const auto n = static_cast<std::size_t>(in.groups);
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<double> z{-inf};
  for (std::size_t i = 1; i < n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(n);
    z.push_back(in.mode == GroupMode::quantile ? normal_quantile(part) : -2 + 4 * part);
  }
  z.push_back(inf);
  Groups out{};
  for (std::size_t i = 0; i < n; ++i) {
    const double share = normal_between(z[i], z[i + 1]);
    // z phi(z) is 0 at the open ends.
    const auto moment = [](double x) { return std::isinf(x) ? 0 : x * normal_density(x); };
    const double offset = (normal_density(z[i]) - normal_density(z[i + 1])) / share;
    const double variance = 1 + (moment(z[i]) - moment(z[i + 1])) / share - offset * offset;
    if (i > 0) out.inner_bounds_mv.push_back(in.emf_mean_mv + in.emf_sd_mv * z[i]);
    out.share.push_back(share);
    out.mean_emf_mv.push_back(in.emf_mean_mv + in.emf_sd_mv * offset);
    out.within_variance_share += share * variance;
  }
  out.within_variance_share = std::clamp(out.within_variance_share, 0.0, 1.0);
  return out;
}

// Panels of at most three standard deviations: 24 points hold a bell times a smooth life to rounding.
template <class F>
double by_panels(F&& f, double low, double high, double sd) {
  if (!(high > low)) return 0;
  const int panels = static_cast<int>(std::ceil((high - low) / (3 * sd)));
  const double width = (high - low) / panels;
  double sum = 0;
  for (int k = 0; k < panels; ++k)
    sum += integrate_gauss(f, low + k * width, low + (k + 1) * width, gauss_legendre_24());
  return sum;
}

}  // namespace

SpeedCoefficient emf_speed_coefficient(const Emf& in) {
  return guarded<&emf_speed_coefficient>(in, [&] { return SpeedCoefficient{coefficient(in.emf_mv)}; });
}

Speed emf_cutting_speed(const SpeedForLife& in) {
  return guarded<&emf_cutting_speed>(in, [&] { return Speed{speed(in.emf_mv, in, in.tool_life_min)}; });
}

ToolLife emf_tool_life(const LifeAtSpeed& in) {
  return guarded<&emf_tool_life>(in, [&] { return ToolLife{life(in.emf_mv, in, in.speed_m_min)}; });
}

Speed handbook_cutting_speed(const Handbook& in) {
  return guarded<&handbook_cutting_speed>(in, [&] {
    return Speed{
        in.c_v * in.k_v /
        (std::pow(in.tool_life_min, in.m) * std::pow(in.depth_mm, in.x) * std::pow(in.feed_mm_rev, in.y))};
  });
}

Sensitivity emf_sensitivity(const Emf& in) {
  return guarded<&emf_sensitivity>(in, [&] {
    const double slope = speed_slope(in.emf_mv);
    return Sensitivity{slope, 5 * slope};
  });
}

ReferenceEmf emf_room_correction(const RoomEmf& in) {
  return guarded<&emf_room_correction>(
      in, [&] { return ReferenceEmf{in.emf_mv * (100 - in.reference_c) / (100 - in.room_c)}; });
}

EmfLimit emf_limit_for_regime(const RegimeForLimit& in) {
  return guarded<&emf_limit_for_regime>(in, [&] {
    constexpr double least_mv = 0.05;
    const double needed = in.speed_m_min * std::pow(in.tool_life_min, 0.2) * cut_factor(in);
    const auto spare = [&](double emf_mv) { return coefficient(emf_mv) - needed; };
    if (!(spare(least_mv) >= 0)) return EmfLimit{0, false};
    // The coefficient falls all the way to (nearly) 0 at the end of the range.
    if (spare(emf_end_mv) >= 0) return EmfLimit{emf_end_mv, true};
    return EmfLimit{find_root(spare, least_mv, emf_end_mv), true};
  });
}

Groups emf_sort_groups(const Sorting& in) {
  return guarded<&emf_sort_groups>(in, [&] { return sort_groups(in); });
}

GroupPlan emf_group_plan(const GroupPlanIn& in) {
  return guarded<&emf_group_plan>(in, [&] {
    GroupPlan out{};
    for (const double emf_mv : sort_groups(in).mean_emf_mv) {
      require(emf_mv > 0 && emf_mv < emf_end_mv, "emf_sd_mv", in.emf_sd_mv,
              "is too large: the mean EMF of every group must lie between 0 and 501/41 mV");
      out.speed_at_target_life_m_min.push_back(speed(emf_mv, in, in.tool_life_min));
      out.life_at_common_speed_min.push_back(life(emf_mv, in, in.common_speed_m_min));
    }
    return out;
  });
}

LifeScatter emf_life_scatter(const ScatterIn& in) {
  return guarded<&emf_life_scatter>(in, [&] {
    const double by_emf = std::abs(5 * speed_slope(in.emf_mean_mv)) * in.emf_sd_mv;
    LifeScatter out{};
    out.ln_sd_total = std::sqrt(std::log1p(in.life_cv_total * in.life_cv_total));
    out.rho = std::min(1.0, by_emf / out.ln_sd_total);
    out.ln_sd_between = out.rho * out.ln_sd_total * std::sqrt(1 - sort_groups(in).within_variance_share);
    out.ln_sd_within = std::sqrt(
        std::max(0.0, (out.ln_sd_total - out.ln_sd_between) * (out.ln_sd_total + out.ln_sd_between)));
    out.life_cv_within = std::sqrt(std::expm1(out.ln_sd_within * out.ln_sd_within));
    return out;
  });
}

ScreenedLife emf_screened_life(const ScreenIn& in) {
  return guarded<&emf_screened_life>(in, [&] {
    const double low_mv = std::max(0.1, in.emf_mean_mv - 6 * in.emf_sd_mv);
    const double high_mv = std::min(emf_end_mv, in.emf_mean_mv + 6 * in.emf_sd_mv);
    require(low_mv < high_mv, "emf_mean_mv", in.emf_mean_mv,
            "must leave an EMF above 0.1 mV within six standard deviations");
    const double limit_mv = std::min(in.emf_limit_mv, high_mv);
    require(limit_mv > low_mv, "emf_limit_mv", in.emf_limit_mv,
            "accepts nothing: must be above the lowest EMF of the delivery, the larger of 0.1 mV and mean - "
            "6 sd");
    const auto score = [&](double emf_mv) { return (emf_mv - in.emf_mean_mv) / in.emf_sd_mv; };
    const double per_speed = 1 / (in.speed_m_min * cut_factor(in));
    const auto weighted_life = [&](double emf_mv) {
      const double ratio = std::max(0.0, coefficient(emf_mv)) * per_speed;
      const double square = ratio * ratio;
      return square * square * ratio * normal_density(score(emf_mv)) / in.emf_sd_mv;
    };
    const double accepted = normal_between(score(low_mv), score(limit_mv));
    const double rejected = normal_between(score(limit_mv), score(high_mv));
    const double below = by_panels(weighted_life, low_mv, limit_mv, in.emf_sd_mv);
    const double above = by_panels(weighted_life, limit_mv, high_mv, in.emf_sd_mv);
    return ScreenedLife{rejected / (accepted + rejected), (below + above) / (accepted + rejected),
                        below / accepted};
  });
}

SetLife multi_insert_set_life(const InsertSet& in) {
  return guarded<&multi_insert_set_life>(in, [&] {
    // u = Phi^-1(2^(-1/n)) from the upper tail; exactly 0 for one insert.
    const double tail = -std::expm1(-std::numbers::ln2 / static_cast<double>(in.inserts));
    const double u = in.inserts == 1 ? 0 : -normal_quantile(tail);
    const double together = std::hypot(in.ln_sd_between, in.ln_sd_within);
    return SetLife{in.median_life_min * std::exp(-u * together),
                   in.median_life_min * std::exp(-u * in.ln_sd_within),
                   std::exp(u * (together - in.ln_sd_within))};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K121",
       .title = "Preliminary diagnostics of carbide inserts based on the thermo-EMF method",
       .authors = "Babenko S. A., Krasovsky S. S., Khoroshailo V. V., Polupanov V. P.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Inserts of one grade and delivery differ in phase composition, hence in cutting properties. The "
           "EMF "
           "between an insert and an electrode at 100 degC depends on the composition and is measured in "
           "seconds without damage; it sorts a delivery, and scales speed and life.",
       .role = "inspection",
       .errata = {"The text states C_v = A K E; eq. (2) shows C_v = A - K E, the minus is lost in print."}});

  const Range valid_emf = open(0, emf_end_mv);
  const auto emf = [&](auto& f) {
    f.input(&Emf::emf_mv, "emf_mv", "E", "mV", valid_emf, "EMF of the insert at a room of 20 degC", 5.0);
  };
  const auto cut = [](auto& f) {
    f.input(&Cut::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut, 0.5..2 tested", 1.0)
        .input(&Cut::feed_mm_rev, "feed_mm_rev", "S", "mm/rev", positive(), "feed, 0.14..0.46 tested", 0.3)
        .optional(&Cut::k_v, "k_v", "K_v", "1", positive(), "product of correction factors");
  };
  const auto delivery = [&](auto& f) {
    f.input(&Delivery::emf_mean_mv, "emf_mean_mv", "mu", "mV", valid_emf, "mean EMF of the delivery", 5.0)
        .input(&Delivery::emf_sd_mv, "emf_sd_mv", "sigma", "mV", positive(), "standard deviation of the EMF",
               0.4);
  };
  const auto sorting = [&](auto& f) {
    f.with(delivery)
        .optional(&Sorting::groups, "n_groups", "n", "1", closed(1, 100'000), "number of groups")
        .optional(&Sorting::mode, "mode", "-", "-", no_range(),
                  "quantile (equal counts) or width (equal bins, outer bins open)");
  };
  const auto fit_note =
      "Fitted for T14K8 on ShKh15, 60..150 m/min; K_v must not repeat the factor of the tool grade. Not "
      "beyond "
      "about 10 mV: the speed is 0 at 501/41.";

  source
      .function<&emf_speed_coefficient>("emf_speed_coefficient", "Speed coefficient of an insert by its EMF.",
                                        "eq. (2)", Provenance::repaired)
      .with(emf)
      .output(&SpeedCoefficient::c_v, "c_v", "C_v", "-", non_negative(),
              "speed coefficient, all of the EMF in one factor")
      .note(fit_note);
  source
      .function<&emf_cutting_speed>("emf_cutting_speed", "Cutting speed of an insert for a tool life.",
                                    "eq. (2)", Provenance::paper)
      .with(emf)
      .input(&SpeedForLife::tool_life_min, "tool_life_min", "T", "min", positive(), "tool life", 60.0)
      .with(cut)
      .output(&Speed::speed_m_min, "speed_m_min", "v", "m/min", non_negative(), "cutting speed")
      .note(fit_note);
  source
      .function<&emf_tool_life>("emf_tool_life", "Tool life of an insert at a cutting speed.",
                                "eq. (2) solved for T", Provenance::paper)
      .with(emf)
      .input(&LifeAtSpeed::speed_m_min, "speed_m_min", "v", "m/min", positive(), "cutting speed", 130.0)
      .with(cut)
      .output(&ToolLife::tool_life_min, "tool_life_min", "T", "min", non_negative(), "tool life")
      .note(fit_note);
  source
      .function<&handbook_cutting_speed>("handbook_cutting_speed", "Cutting speed of the handbook form.",
                                         "eq. (1)", Provenance::paper)
      .input(&Handbook::c_v, "c_v", "C_v", "-", positive(), "speed coefficient", 280.0)
      .input(&Handbook::tool_life_min, "tool_life_min", "T", "min", positive(), "tool life", 60.0)
      .with(cut)
      .input(&Handbook::m, "m", "m", "1", positive(), "exponent of life", 0.2)
      .input(&Handbook::x, "x", "x", "1", positive(), "exponent of depth", 0.15)
      .input(&Handbook::y, "y", "y", "1", positive(), "exponent of feed", 0.35)
      .output(&Speed::speed_m_min, "speed_m_min", "v", "m/min", positive(), "cutting speed");
  source
      .function<&emf_sensitivity>("emf_sensitivity", "Relative change of speed and life per mV of EMF.",
                                  "derivative of eq. (2)", Provenance::completion)
      .with(emf)
      .output(&Sensitivity::dln_speed_per_mv, "dln_speed_per_mv", "d ln v/dE", "1/mV", at_most(0),
              "of the speed at equal life")
      .output(&Sensitivity::dln_life_per_mv, "dln_life_per_mv", "d ln T/dE", "1/mV", at_most(0),
              "of the life at equal speed");
  source
      .function<&emf_room_correction>("emf_room_correction",
                                      "EMF at the reference temperature of the cold side.", "Seebeck effect",
                                      Provenance::completion)
      .with(emf)
      .input(&RoomEmf::room_c, "room_degc", "T_room", "degC", open_high(0, 100),
             "temperature of the shop at the measurement", 25.0)
      .optional(&RoomEmf::reference_c, "reference_degc", "T_ref", "degC", open_high(0, 100),
                "reference temperature")
      .output(&ReferenceEmf::emf_ref_mv, "emf_ref_mv", "E_ref", "mV", positive(),
              "EMF at the reference temperature");
  source
      .function<&emf_limit_for_regime>("emf_limit_for_regime",
                                       "Largest EMF that still gives the life at the speed.",
                                       "eq. (2) solved for E", Provenance::completion)
      .input(&RegimeForLimit::speed_m_min, "speed_m_min", "v", "m/min", positive(), "cutting speed", 100.0)
      .input(&RegimeForLimit::tool_life_min, "tool_life_min", "T", "min", positive(), "tool life", 60.0)
      .with(cut)
      .output(&EmfLimit::emf_limit_mv, "emf_limit_mv", "E", "mV", closed(0, emf_end_mv),
              "limit for acceptance, 0 when not feasible")
      .output(&EmfLimit::feasible, "feasible", "-", "-", no_range(), "an EMF of 0.05 mV is fast enough")
      .note(fit_note);
  source
      .function<&emf_sort_groups>("emf_sort_groups", "Sorting a delivery into groups by EMF.", "normal law",
                                  Provenance::completion)
      .with(sorting)
      .output(&Groups::inner_bounds_mv, "inner_bounds_mv", "E", "mV", any(), "bounds between the groups")
      .output(&Groups::share, "share", "p", "1", probability(), "share of each group, lowest EMF first")
      .output(&Groups::mean_emf_mv, "mean_emf_mv", "E", "mV", any(), "mean EMF of each group")
      .output(&Groups::within_variance_share, "within_variance_share", "-", "1", probability(),
              "part of the variance of EMF left within the groups");
  source
      .function<&emf_group_plan>("emf_group_plan", "Speed or life of each group of a sorted delivery.",
                                 "eq. (2), normal law", Provenance::completion)
      .with(sorting)
      .input(&GroupPlanIn::tool_life_min, "tool_life_min", "T", "min", positive(), "life wanted", 60.0)
      .input(&GroupPlanIn::common_speed_m_min, "common_speed_m_min", "v", "m/min", positive(),
             "speed common to all groups", 130.0)
      .with(cut)
      .output(&GroupPlan::speed_at_target_life_m_min, "speed_at_target_life_m_min", "v", "m/min",
              non_negative(), "speed of each group at equal life")
      .output(&GroupPlan::life_at_common_speed_min, "life_at_common_speed_min", "T", "min", non_negative(),
              "life of each group at equal speed")
      .note(fit_note);
  source
      .function<&emf_life_scatter>("emf_life_scatter", "Part of the life scatter that sorting removes.",
                                   "law of total variance", Provenance::completion)
      .with(sorting)
      .input(&ScatterIn::life_cv_total, "life_cv_total", "cv", "1", positive(),
             "coefficient of variation of life in the delivery", 0.5)
      .output(&LifeScatter::rho, "rho", "rho", "1", probability(),
              "correlation of EMF with ln life, magnitude, at most 1")
      .output(&LifeScatter::ln_sd_total, "ln_sd_total", "s_T", "1", positive(),
              "standard deviation of ln life")
      .output(&LifeScatter::ln_sd_between, "ln_sd_between", "s_b", "1", non_negative(),
              "between groups, removed by sorting")
      .output(&LifeScatter::ln_sd_within, "ln_sd_within", "s_w", "1", non_negative(), "within groups")
      .output(&LifeScatter::life_cv_within, "life_cv_within", "cv", "1", non_negative(),
              "coefficient of variation of life within a group")
      .note("rho = 1 means that the EMF scatters too much for the life scatter: one of them is wrong.");
  source
      .function<&emf_screened_life>("emf_screened_life", "Mean life when inserts above an EMF are rejected.",
                                    "eq. (2), normal law", Provenance::completion)
      .with(delivery)
      .input(&ScreenIn::emf_limit_mv, "emf_limit_mv", "E", "mV", positive(), "largest EMF accepted", 5.4)
      .input(&ScreenIn::speed_m_min, "speed_m_min", "v", "m/min", positive(), "cutting speed", 130.0)
      .with(cut)
      .output(&ScreenedLife::reject_fraction, "reject_fraction", "p", "1", probability(), "share rejected")
      .output(&ScreenedLife::mean_life_all_min, "mean_life_all_min", "T", "min", non_negative(),
              "mean life of all")
      .output(&ScreenedLife::mean_life_accepted_min, "mean_life_accepted_min", "T", "min", non_negative(),
              "mean life of the accepted")
      .note(fit_note);
  source
      .function<&multi_insert_set_life>("multi_insert_set_life",
                                        "Life of a set of inserts drawn at random and from one group.",
                                        "median of the minimum", Provenance::completion)
      .input(&InsertSet::median_life_min, "median_life_min", "T", "min", positive(),
             "median life of an insert", 60.0)
      .input(&InsertSet::ln_sd_between, "ln_sd_between", "s_b", "1", non_negative(),
             "standard deviation of ln life between groups", 0.3)
      .input(&InsertSet::ln_sd_within, "ln_sd_within", "s_w", "1", non_negative(),
             "standard deviation of ln life within a group", 0.35)
      .input(&InsertSet::inserts, "n_inserts", "n", "1", at_least(1), "inserts of the tool", 8)
      .output(&SetLife::median_random_min, "median_random_min", "T", "min", positive(),
              "median life of a random set")
      .output(&SetLife::median_sorted_min, "median_sorted_min", "T", "min", positive(),
              "median life of a set from the central group")
      .output(&SetLife::gain, "gain", "-", "1", at_least(1), "sorted/random");
}

}  // namespace verstat::models::k121
