#include "models/life/k120_deep_hole_guide_pads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k120 {
namespace {

constexpr double lead_in_lost_from_mm = 0.04;  // text: 0.04-0.05 mm, the cautious end
constexpr int points_on_pad = 10;
constexpr int replace_when_worn = 8;  // text: wear traces at points 8-10

struct PowerLaw {
  double a, b, c;

  [[nodiscard]] double wear(double length_m, double shift_m) const {
    if (length_m <= shift_m) return 0;
    return std::max(0.0, a * std::pow(length_m - shift_m, b) + c);
  }
  [[nodiscard]] double length(double wear_mm, double shift_m) const {
    if (wear_mm <= c) return shift_m;
    return shift_m + std::pow((wear_mm - c) / a, 1 / b);
  }
};

// Shift of a point counted from 1.
double shift_of(int point, double shift_per_point_m) {
  return (point - 1) * shift_per_point_m;
}

// The linear part of the fit: for a given b, the best a and c and the sum of squared errors they leave.
// Lengths are relative to the longest, so that no power overflows.
class Projection {
 public:
  explicit Projection(const PadMeasurements& in) : wear_(in.wear_mm), longest_m_(in.length_m.back()) {
    log_length_.reserve(in.length_m.size());
    for (const double length_m : in.length_m) log_length_.push_back(std::log(length_m / longest_m_));
    for (const double h : wear_) mean_wear_ += h / static_cast<double>(wear_.size());
    power_.resize(wear_.size());
  }

  struct Best {
    double a, c, sse;
  };
  Best at(double b) {
    const std::size_t n = wear_.size();
    double mean = 0;
    for (std::size_t k = 0; k < n; ++k) {
      power_[k] = std::exp(b * log_length_[k]);
      mean += power_[k] / static_cast<double>(n);
    }
    double uu = 0;
    double uh = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double u = power_[k] - mean;
      uu += u * u;
      uh += u * (wear_[k] - mean_wear_);
    }
    const double a = uu > 0 ? uh / uu : 0;
    double sse = 0;  // from the residuals: a difference of sums would leave only rounding for a good fit
    for (std::size_t k = 0; k < n; ++k) {
      const double residual = (wear_[k] - mean_wear_) - a * (power_[k] - mean);
      sse += residual * residual;
    }
    return {a * std::pow(longest_m_, -b), mean_wear_ - a * mean, sse};
  }

 private:
  const std::vector<double>& wear_;
  double longest_m_;
  double mean_wear_ = 0;
  std::vector<double> log_length_, power_;
};

double grid_b(int k) {
  return (10 + k) / 100.0;
}

// Golden section for the b of least squared error between low and high, to the last bits of b.
double refine_b(Projection& fit, double low, double high) {
  constexpr double golden = 1 / std::numbers::phi;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double sse_left = fit.at(left).sse;
  double sse_right = fit.at(right).sse;
  while (high - low > 1e-13) {
    if (sse_left <= sse_right) {
      high = right;
      right = left;
      sse_right = sse_left;
      left = high - golden * (high - low);
      sse_left = fit.at(left).sse;
    } else {
      low = left;
      left = right;
      sse_left = sse_right;
      right = low + golden * (high - low);
      sse_right = fit.at(right).sse;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

SlidingPath pad_sliding_path(const DrilledLength& in) {
  return guarded<&pad_sliding_path>(in, [&] {
    return SlidingPath{std::numbers::pi * in.hole_diameter_mm * in.drilled_length_m / in.feed_mm_rev};
  });
}

PadLength pad_length_from_path(const PadPath& in) {
  return guarded<&pad_length_from_path>(
      in, [&] { return PadLength{in.path_m * in.feed_mm_rev / (std::numbers::pi * in.hole_diameter_mm)}; });
}

DrillingTime deep_drilling_time(const DrillingRegime& in) {
  return guarded<&deep_drilling_time>(in, [&] {
    const double rpm = 1000 * in.cutting_speed_m_min / (std::numbers::pi * in.hole_diameter_mm);
    const double feed_mm_min = rpm * in.feed_mm_rev;
    return DrillingTime{rpm, feed_mm_min, 1000 * in.drilled_length_m / feed_mm_min};
  });
}

PadWear pad_radial_wear(const PadWearAtLength& in) {
  return guarded<&pad_radial_wear>(in, [&] {
    return PadWear{PowerLaw{in.a_mm_m_b, in.b, in.c_mm}.wear(in.drilled_length_m, in.shift_m)};
  });
}

PadLength pad_length_to_wear(const PadWearLimit& in) {
  return guarded<&pad_length_to_wear>(in, [&] {
    return PadLength{PowerLaw{in.a_mm_m_b, in.b, in.c_mm}.length(in.wear_mm, in.shift_m)};
  });
}

WearEffect pad_wear_effect(const RadialWear& in) {
  return guarded<&pad_wear_effect>(in, [&] {
    return WearEffect{2 * in.wear_mm, in.wear_mm, in.wear_mm >= lead_in_lost_from_mm};
  });
}

PadWearFit fit_pad_wear(const PadMeasurements& in) {
  return guarded<&fit_pad_wear>(in, [&] {
    const auto& lengths = in.length_m;
    require(in.wear_mm.size() == lengths.size(), "wear_mm", static_cast<std::int64_t>(in.wear_mm.size()),
            "must have as many entries as length_m");
    for (std::size_t k = 1; k < lengths.size(); ++k)
      require(lengths[k] > lengths[k - 1], "length_m", lengths[k], "must increase from entry to entry");
    const auto [least, most] = std::ranges::minmax(in.wear_mm);
    require(least < most, "wear_mm", most, "must not be the same at every length");

    Projection fit(in);
    constexpr int last = 390;  // b = 4.00
    int best = 0;
    double best_sse = fit.at(grid_b(0)).sse;
    for (int k = 1; k <= last; ++k)
      if (const double sse = fit.at(grid_b(k)).sse; sse < best_sse) {
        best = k;
        best_sse = sse;
      }
    const double b = refine_b(fit, grid_b(std::max(best - 1, 0)), grid_b(std::min(best + 1, last)));
    const auto [a, c, sse] = fit.at(b);
    return PadWearFit{.a_mm_m_b = a,
                      .b = b,
                      .c_mm = c,
                      .rmse_mm = std::sqrt(sse / static_cast<double>(lengths.size())),
                      .b_at_limit = best == 0 || best == last};
  });
}

PadState pad_state(const PadUnderWay& in) {
  return guarded<&pad_state>(in, [&] {
    const PowerLaw law{in.a_mm_m_b, in.b, in.c_mm};
    const auto wear = [&](int point) {
      return law.wear(in.drilled_length_m, shift_of(point, in.shift_per_point_m));
    };
    int past_critical = 0;
    for (int point = 1; point <= points_on_pad; ++point)
      if (wear(point) >= in.critical_wear_mm) ++past_critical;
    const double tail_wear_mm = wear(replace_when_worn);
    return PadState{.wear_at_point_1_mm = wear(1),
                    .wear_at_point_8_mm = tail_wear_mm,
                    .points_past_critical = past_critical,
                    .lead_in_first_point = std::min(points_on_pad, past_critical + 1),
                    .replace = tail_wear_mm >= in.trace_wear_mm};
  });
}

PadLife pad_life(const PadSet& in) {
  return guarded<&pad_life>(in, [&] {
    const PowerLaw law{in.a_mm_m_b, in.b, in.c_mm};
    const double replace_at_m =
        law.length(in.trace_wear_mm, shift_of(replace_when_worn, in.shift_per_point_m));
    const double holes = std::floor(replace_at_m / in.hole_length_m + 1e-9);
    require(holes < 1e15, "hole_length_m", in.hole_length_m, "asks for more than 1e15 holes per pad set");
    return PadLife{.lead_in_shift_starts_m = law.length(in.critical_wear_mm, 0),
                   .replace_at_m = replace_at_m,
                   .holes_per_pad_set = static_cast<std::int64_t>(holes)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K120",
       .title = "Analysis of the dimensional wear of guide pads of tools for deep-hole machining",
       .authors = "Patsiora A. P.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "The guide pads of a deep-hole head base the tool on the hole just drilled. Only the lead-in of a "
           "pad rubs; when its radial wear reaches a critical value the contact jumps back along the pad, "
           "and "
           "the wear spot grows in stages until the tail is marked and the pad must be replaced. Power laws "
           "of radial wear against drilled length, measured on a 70 mm head in ten points along the pad.",
       .role = "life",
       .errata = {
           "The critical radial wear is printed 0.04-0.05 um once; it is mm (diameter loss 0.08-0.1 mm in "
           "the "
           "same sentence).",
           "\"Diametral size falls by more than 0.04-0.05 mm\" contradicts the diameter loss of 0.08-0.1 mm "
           "by "
           "a factor 2; the radial reading is used.",
           "35168 m of path holds for pi = 3.14; 60 m/min of cutting speed and 70 m/min of sliding speed of "
           "the same run cannot both be true."}});

  const auto law = [](auto& f, auto a, auto b, auto c) {
    f.input(a, "a", "a", "mm/m^b", positive(), "factor of the power law of wear", 2.5e-4)
        .input(b, "b", "b", "1", positive(), "exponent of the power law of wear", 1.6)
        .input(c, "c", "c", "mm", any(), "constant of the power law of wear", 0.0);
  };
  const auto shift = [](auto& f, auto pointer) {
    f.input(pointer, "shift_m", "delta_L", "m", non_negative(),
            "drilled length before this point of the pad starts to wear", 8.0);
  };
  const auto limits = [](auto& f, auto per_point, auto critical, auto trace) {
    f.input(per_point, "shift_per_point_m", "delta_L", "m", non_negative(),
            "drilled length by which each point starts to wear after its predecessor", 8.0)
        .optional(critical, "critical_wear_mm", "h_cr", "mm", positive(),
                  "radial wear at which the contact leaves a point")
        .optional(trace, "trace_wear_mm", "-", "mm", positive(), "radial wear that shows as a trace");
  };

  source
      .function<&pad_sliding_path>("pad_sliding_path", "Path of a pad point along the hole wall.",
                                   "recovered from 35168 m and 23445 m", Provenance::reconstructed)
      .input(&DrilledLength::hole_diameter_mm, "hole_diameter_mm", "D", "mm", positive(), "hole diameter",
             70.0)
      .input(&DrilledLength::drilled_length_m, "drilled_length_m", "L", "m", positive(), "drilled length",
             24.0)
      .input(&DrilledLength::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(), "feed", 0.15)
      .output(&SlidingPath::path_m, "path_m", "l", "m", positive(), "sliding path");
  source
      .function<&pad_length_from_path>("pad_length_from_path", "Drilled length of a given sliding path.",
                                       "inverse of pad_sliding_path", Provenance::reconstructed)
      .input(&PadPath::hole_diameter_mm, "hole_diameter_mm", "D", "mm", positive(), "hole diameter", 70.0)
      .input(&PadPath::path_m, "path_m", "l", "m", positive(), "sliding path", 35168.0)
      .input(&PadPath::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(), "feed", 0.15)
      .output(&PadLength::drilled_length_m, "drilled_length_m", "L", "m", positive(), "drilled length");
  source
      .function<&deep_drilling_time>("deep_drilling_time",
                                     "Spindle speed, feed rate and time for a drilled length.",
                                     "completion (kinematics)", Provenance::completion)
      .input(&DrillingRegime::hole_diameter_mm, "hole_diameter_mm", "D", "mm", positive(), "hole diameter",
             70.0)
      .input(&DrillingRegime::drilled_length_m, "drilled_length_m", "L", "m", positive(), "drilled length",
             24.0)
      .input(&DrillingRegime::cutting_speed_m_min, "cutting_speed_m_min", "v", "m/min", positive(),
             "cutting speed", 60.0)
      .input(&DrillingRegime::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(), "feed", 0.15)
      .output(&DrillingTime::spindle_rpm, "spindle_rpm", "n", "rpm", positive(), "spindle speed")
      .output(&DrillingTime::feed_rate_mm_min, "feed_rate_mm_min", "s n", "mm/min", positive(), "feed rate")
      .output(&DrillingTime::time_min, "time_min", "t", "min", positive(), "drilling time");
  source
      .function<&pad_radial_wear>("pad_radial_wear", "Radial wear of one pad point after a drilled length.",
                                  "eq. (1)", Provenance::paper)
      .input(&PadWearAtLength::drilled_length_m, "drilled_length_m", "L", "m", non_negative(),
             "drilled length", 24.0)
      .with([&](auto& f) { law(f, &PadWearAtLength::a_mm_m_b, &PadWearAtLength::b, &PadWearAtLength::c_mm); })
      .with([&](auto& f) { shift(f, &PadWearAtLength::shift_m); })
      .output(&PadWear::wear_mm, "wear_mm", "h", "mm", non_negative(), "radial wear")
      .note("The law is printed without a shift; the shift and the zero up to it are completions.")
      .note("The coefficients stand only in a lost figure: measure them and use fit_pad_wear.");
  source
      .function<&pad_length_to_wear>("pad_length_to_wear",
                                     "Drilled length at which a pad point reaches a wear.",
                                     "eq. (1), inverse", Provenance::paper)
      .input(&PadWearLimit::wear_mm, "wear_mm", "h", "mm", positive(), "radial wear", 0.045)
      .with([&](auto& f) { law(f, &PadWearLimit::a_mm_m_b, &PadWearLimit::b, &PadWearLimit::c_mm); })
      .with([&](auto& f) { shift(f, &PadWearLimit::shift_m); })
      .output(&PadLength::drilled_length_m, "drilled_length_m", "L", "m", non_negative(), "drilled length")
      .note("A wear not above c is there as soon as the point starts to wear: the answer is the shift.");
  source
      .function<&pad_wear_effect>("pad_wear_effect", "What a radial pad wear does to the tool.", "text",
                                  Provenance::repaired)
      .input(&RadialWear::wear_mm, "wear_mm", "h", "mm", non_negative(), "radial wear", 0.04)
      .output(&WearEffect::diameter_loss_mm, "diameter_loss_mm", "2 h", "mm", non_negative(),
              "loss of diameter over the pads")
      .output(&WearEffect::insert_overhang_increase_mm, "insert_overhang_increase_mm", "h", "mm",
              non_negative(), "more overhang of the peripheral insert")
      .output(&WearEffect::lead_in_lost, "lead_in_lost", "-", "-", no_range(), "wear of 0.04 mm or more")
      .note(
          "0.04 mm is the cautious end of the printed 0.04-0.05; the effect on the hole is only described.");
  source
      .function<&fit_pad_wear>("fit_pad_wear", "Power law of wear through own measurements of a pad point.",
                               "completion (variable projection)", Provenance::completion)
      .input(&PadMeasurements::length_m, "length_m", "L", "m", positive(),
             "drilled lengths, increasing, counted from where this point starts to wear",
             Value::List{4.0, 8.0, 12.0, 16.0, 20.0, 24.0})
      .length(4, 100'000)
      .input(&PadMeasurements::wear_mm, "wear_mm", "h", "mm", any(), "radial wear measured at each length",
             Value::List{0.0044, 0.0088, 0.0145, 0.0212, 0.0288, 0.0373})
      .length(4, 100'000)
      .output(&PadWearFit::a_mm_m_b, "a", "a", "mm/m^b", any(), "factor")
      .output(&PadWearFit::b, "b", "b", "1", closed(0.1, 4), "exponent")
      .output(&PadWearFit::c_mm, "c", "c", "mm", any(), "constant")
      .output(&PadWearFit::rmse_mm, "rmse_mm", "-", "mm", non_negative(), "root of the mean squared error")
      .output(&PadWearFit::b_at_limit, "b_at_limit", "-", "-", no_range(),
              "warning: b lies at an end of the searched 0.10..4.00, the law does not fit")
      .note("A factor a <= 0 means that the wear does not grow: the other functions refuse it.");
  source
      .function<&pad_state>("pad_state", "State of a guide pad after a drilled length.", "completion",
                            Provenance::completion)
      .input(&PadUnderWay::drilled_length_m, "drilled_length_m", "L", "m", non_negative(), "drilled length",
             60.0)
      .with([&](auto& f) { law(f, &PadUnderWay::a_mm_m_b, &PadUnderWay::b, &PadUnderWay::c_mm); })
      .with([&](auto& f) {
        limits(f, &PadUnderWay::shift_per_point_m, &PadUnderWay::critical_wear_mm,
               &PadUnderWay::trace_wear_mm);
      })
      .output(&PadState::wear_at_point_1_mm, "wear_at_point_1_mm", "h_1", "mm", non_negative(),
              "radial wear of the first point")
      .output(&PadState::wear_at_point_8_mm, "wear_at_point_8_mm", "h_8", "mm", non_negative(),
              "radial wear of point 8")
      .output(&PadState::points_past_critical, "points_past_critical", "-", "1", closed(0, 10),
              "points at or above the critical wear")
      .output(&PadState::lead_in_first_point, "lead_in_first_point", "-", "1", closed(1, 10),
              "first point still in the lead-in; 10 also when all are past it")
      .output(&PadState::replace, "replace", "-", "-", no_range(), "point 8 shows wear")
      .note("Equal shifts and one common law for the ten points; the paper has point 10 nearly linear in L.");
  source
      .function<&pad_life>("pad_life", "Drilled length and holes until the pads are due.", "completion",
                           Provenance::completion)
      .with([&](auto& f) { law(f, &PadSet::a_mm_m_b, &PadSet::b, &PadSet::c_mm); })
      .with([&](auto& f) {
        limits(f, &PadSet::shift_per_point_m, &PadSet::critical_wear_mm, &PadSet::trace_wear_mm);
      })
      .input(&PadSet::hole_length_m, "hole_length_m", "-", "m", positive(), "length of one hole", 12.0)
      .output(&PadLife::lead_in_shift_starts_m, "lead_in_shift_starts_m", "-", "m", non_negative(),
              "drilled length at which the lead-in begins to move back")
      .output(&PadLife::replace_at_m, "replace_at_m", "-", "m", non_negative(),
              "drilled length at which point 8 shows wear")
      .output(&PadLife::holes_per_pad_set, "holes_per_pad_set", "-", "1", at_least(0),
              "whole holes per set of pads")
      .note("Scatter is not given: use a Weibull life in drilled metres with this mean and a measured cv.");
}

}  // namespace verstat::models::k120
