#include "models/grinding/k303_cutting_surface_height.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace verstat::models::k303 {
namespace {

constexpr double um_mm = 1000;
constexpr int most_intervals = 10'000;  // the sum of grooves takes their square in time
constexpr double tie_um = 1e-9;         // Rmax is a step function, so it may equal the protrusion

double equivalent_diameter_mm(const WheelAndWork& in) {
  const double wheel = in.wheel_radius_mm;
  const double work = in.work_radius_mm;
  if (in.kind == GrindingKind::surface) return 2 * wheel;
  require(work > 0, "work_radius_mm", work, "must be positive for internal and external grinding");
  if (in.kind == GrindingKind::external) return 2 * wheel * work / (work + wheel);
  require(work > wheel, "work_radius_mm", work, "must be larger than wheel_radius_mm in internal grinding");
  return 2 * wheel * work / (work - wheel);
}

double groove_width_um(double depth_um, double tip_radius_um, double half_angle_rad) {
  const double cone_from_um = tip_radius_um * (1 - std::sin(half_angle_rad));
  const double round_um = std::min(depth_um, cone_from_um);
  return 2 * (std::sqrt(round_um * (2 * tip_radius_um - round_um)) +
              (depth_um - round_um) * std::tan(half_angle_rad));
}

double half_angle(double angle_deg) {
  return angle_deg * std::numbers::pi / 360;
}

// exp(-a) - exp(-b) for neighbouring layers, without the loss of digits.
double layer_share(double layer, double interval_um, double m, double x0) {
  const double above = std::pow((layer - 1) * interval_um, m) / x0;
  const double below = std::pow(layer * interval_um, m) / x0;
  return std::exp(-above) * -std::expm1(above - below);
}

// The section of the work on its way along the arc. Sums of grooves per interval are extended as they are
// needed and serve every speed and depth of the same wheel.
class Section {
 public:
  explicit Section(const WheelSet& wheel)
      : wheel_(&wheel),
        half_angle_rad_(half_angle(wheel.tip_angle_deg)),
        unit_arc_mm_(std::sqrt(equivalent_diameter_mm(wheel) * wheel.interval_um / um_mm)) {}

  // K, whole intervals in the depth.
  [[nodiscard]] int intervals(double depth_mm) const {
    const double count = std::floor(depth_mm * um_mm / wheel_->interval_um + 1e-9);
    require(count <= most_intervals, "interval_um", wheel_->interval_um,
            "must cut the depth into at most 10000 intervals");
    return static_cast<int>(count);
  }

  struct Level {
    std::optional<int> full;  // interval in which the coverage is reached
    double covered;           // share after the last interval
  };
  // Fills a fresh top that lies `k` intervals above the bottom of the cut.
  [[nodiscard]] Level fill(int k, double work_speed_m_min) {
    const double grooves = 60 * wheel_->wheel_speed_m_s * unit_arc_mm_ /
                           (work_speed_m_min * wheel_->grain_spacing_mm * wheel_->grain_spacing_mm);
    while (static_cast<int>(roots_.size()) <= k)
      roots_.push_back(std::sqrt(static_cast<double>(roots_.size())));
    // Share of the width that is covered; of one mm, whose grooves are summed in um.
    const double grooves_per_um = grooves / um_mm;
    const double enough = wheel_->coverage;
    double covered = 0;
    double root_from = roots_[static_cast<std::size_t>(k)];
    for (int n = 1; n <= k; ++n) {
      const double root_to = roots_[static_cast<std::size_t>(k - n)];
      covered += (1 - covered) * (grooves_per_um * groove_sum(n) * (root_from - root_to));
      root_from = root_to;
      if (covered >= enough) return {n, covered};
    }
    return {std::nullopt, covered};
  }

  // Path of the section from first contact to point p of K.
  [[nodiscard]] double position_mm(int k, int p) const {
    return unit_arc_mm_ * (std::sqrt(static_cast<double>(k)) - std::sqrt(static_cast<double>(k - p)));
  }

  [[nodiscard]] double rmax_um(double depth_mm, double work_speed_m_min) {
    const Level top = fill(intervals(depth_mm), work_speed_m_min);
    return top.full ? *top.full * wheel_->interval_um : depth_mm * um_mm;
  }

 private:
  // s_N = sum over i = 1..N of F(i) b((N - i + 1) dR), from eqs. (6), (8), (9); um.
  double groove_sum(int n) {
    if (static_cast<int>(sums_um_.size()) < n) extend_sums(n);
    return sums_um_[static_cast<std::size_t>(n) - 1];
  }
  void extend_sums(int n) {
    while (static_cast<int>(sums_um_.size()) < n) {
      const double next = static_cast<double>(sums_um_.size() + 1);
      shares_.push_back(layer_share(next, wheel_->interval_um, wheel_->weibull_m, wheel_->weibull_x0_um_m));
      widths_um_.push_back(
          groove_width_um(next * wheel_->interval_um, wheel_->tip_radius_um, half_angle_rad_));
      double sum = 0;
      for (std::size_t i = 0; i < shares_.size(); ++i) sum += shares_[i] * widths_um_[shares_.size() - 1 - i];
      sums_um_.push_back(sum);
    }
  }

  const WheelSet* wheel_;
  double half_angle_rad_;
  double unit_arc_mm_;
  std::vector<double> shares_;
  std::vector<double> widths_um_;
  std::vector<double> sums_um_;
  std::vector<double> roots_;  // sqrt(0), sqrt(1), ...
};

SurfaceAlongArc along_arc(Section& section, const CuttingRegime& in) {
  const int k = section.intervals(in.depth_mm);
  if (k == 0) return {{0}, {in.depth_mm * um_mm}};
  std::vector<std::optional<double>> rmax_um(static_cast<std::size_t>(k) + 1);
  const auto at = [&](int p) -> std::optional<double>& { return rmax_um[static_cast<std::size_t>(p)]; };
  const auto top = section.fill(k, in.work_speed_m_min);
  for (int p = 1; p <= top.full.value_or(k); ++p) at(p) = p * in.interval_um;
  if (!top.full) at(k) = in.depth_mm * um_mm;
  for (int j = 1; top.full && j < k; ++j) {
    const auto level = section.fill(k - j, in.work_speed_m_min);
    if (!level.full) {
      at(k) = (k - j) * in.interval_um;
      break;
    }
    at(*level.full + j) = *level.full * in.interval_um;
  }
  SurfaceAlongArc out;
  for (int p = 1; p <= k; ++p)
    if (at(p)) {
      out.position_mm.push_back(section.position_mm(k, p));
      out.rmax_um.push_back(*at(p));
    }
  return out;
}

}  // namespace

CuttingSurface cutting_surface_roughness(const CuttingRegime& in) {
  return guarded<&cutting_surface_roughness>(in, [&] {
    Section section(in);
    const int k = section.intervals(in.depth_mm);
    const auto top = section.fill(k, in.work_speed_m_min);
    const int number = top.full.value_or(k);
    return CuttingSurface{.rmax_um = top.full ? number * in.interval_um : in.depth_mm * um_mm,
                          .interval_number = number,
                          .saturated = top.full ? 0 : 1,
                          .position_mm = section.position_mm(k, number),
                          .coverage_reached = std::min(1.0, top.covered)};
  });
}

SurfaceAlongArc cutting_surface_profile(const CuttingRegime& in) {
  return guarded<&cutting_surface_profile>(in, [&] {
    Section section(in);
    return along_arc(section, in);
  });
}

ResidualHeight residual_height(const CuttingRegime& in) {
  return guarded<&residual_height>(in, [&] {
    Section section(in);
    const int k = section.intervals(in.depth_mm);
    return ResidualHeight{section.rmax_um(in.depth_mm, in.work_speed_m_min),
                          along_arc(section, in).rmax_um.back(), section.position_mm(k, k)};
  });
}

ContactArc contact_arc(const ArcOfCut& in) {
  return guarded<&contact_arc>(in, [&] {
    const double diameter_mm = equivalent_diameter_mm(in);
    return ContactArc{diameter_mm, std::sqrt(diameter_mm * in.depth_mm)};
  });
}

ScratchWidth scratch_width(const GrainTip& in) {
  return guarded<&scratch_width>(in, [&] {
    return ScratchWidth{groove_width_um(in.depth_um, in.tip_radius_um, half_angle(in.tip_angle_deg))};
  });
}

LayerProbability tip_layer_probability(const TipLayer& in) {
  return guarded<&tip_layer_probability>(in, [&] {
    return LayerProbability{
        layer_share(static_cast<double>(in.layer), in.interval_um, in.weibull_m, in.weibull_x0_um_m)};
  });
}

MinimumInterval minimum_interval(const IntervalSearch& in) {
  return guarded<&minimum_interval>(in, [&] {
    const double diameter_mm = equivalent_diameter_mm(in);
    const double passing = 60 * in.wheel_width_mm * in.wheel_speed_m_s /
                           (in.work_speed_m_min * in.grain_spacing_mm * in.grain_spacing_mm);
    // Grows with the interval, so the first multiple with one grain is found by doubling and halving.
    const auto grains = [&](double multiple) {
      const double interval_um = multiple * in.step_um;
      return passing * 2 * std::sqrt(diameter_mm * interval_um / um_mm) *
             layer_share(1, interval_um, in.weibull_m, in.weibull_x0_um_m);
    };
    double enough = 1;
    while (!(grains(enough) >= 1)) {
      enough *= 2;
      require(enough < 1e15, "step_um", in.step_um, "is too fine for one grain to pass within 1e15 steps");
    }
    double few = std::floor(enough / 2);
    while (enough - few > 1) {
      const double middle = std::floor((few + enough) / 2);
      (grains(middle) >= 1 ? enough : few) = middle;
    }
    return MinimumInterval{enough * in.step_um, grains(enough)};
  });
}

MaxWorkSpeed max_work_speed_for_protrusion(const SpeedSearch& in) {
  return guarded<&max_work_speed_for_protrusion>(in, [&] {
    require(in.speed_low_m_min < in.speed_high_m_min, "speed_low_m_min", in.speed_low_m_min,
            "must be below speed_high_m_min");
    Section section(in);
    const auto feasible = [&](double speed_m_min) {
      return section.rmax_um(in.depth_mm, speed_m_min) < in.protrusion_um - tie_um;
    };
    double low = in.speed_low_m_min;
    double high = in.speed_high_m_min;
    if (!feasible(low)) return MaxWorkSpeed{0};
    if (feasible(high)) return MaxWorkSpeed{high};
    while (high - low > 1e-6 * high) {
      const double middle = (low + high) / 2;
      (feasible(middle) ? low : high) = middle;
    }
    return MaxWorkSpeed{low};
  });
}

MaxDepth max_depth_for_protrusion(const DepthSearch& in) {
  return guarded<&max_depth_for_protrusion>(in, [&] {
    Section section(in);
    const auto depth_mm = [&](int k) { return k * in.interval_um / um_mm; };
    int feasible = 0;
    int infeasible = section.intervals(0.1) + 1;
    while (infeasible - feasible > 1) {
      const int middle = (feasible + infeasible) / 2;
      const bool safe = section.rmax_um(depth_mm(middle), in.work_speed_m_min) < in.protrusion_um - tie_um;
      (safe ? feasible : infeasible) = middle;
    }
    return MaxDepth{depth_mm(feasible)};
  });
}

RemovalRate specific_removal_rate(const SpeedAndDepth& in) {
  return guarded<&specific_removal_rate>(
      in, [&] { return RemovalRate{1000 * in.work_speed_m_min * in.depth_mm}; });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K303",
       .title = "Investigation of the height of roughness profile of the cut surface with internal grinding",
       .authors = "Matyukha P. G., Gabitov V. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Height of irregularities of the cutting surface inside the contact arc of wheel and bore: "
                 "grooves "
                 "of grains of different height fill a section of the work step by step; the depth at which "
                 "its top "
                 "is 90 % covered is Rmax. It equals the depth to which the wheel face sinks into the work "
                 "and must "
                 "stay below the grain protrusion.",
       .role = "grinding",
       .errata = {"Eq. (2) prints (1 - sum b)/B; units and the later E_N = 1 - b/1000 require (1000 B - sum "
                  "b)/(1000 "
                  "B).",
                  "The path L_N prints 10^3 under the root; mm and um require 10^-3, as eq. (10) has it.",
                  "Eq. (5) prints b(2 dR) in its second term; by eq. (6) it is F(2 dR) b(dR).",
                  "Eq. (9) prints 2 rho a_z^2 - a_z^2 under the root: wrong dimension, 2 rho a_z - a_z^2.",
                  "Table 1 prints the depth 0,05 for 0.005 mm: Rmax cannot exceed the depth."}});

  const auto speed = [](auto& f) {
    f.input(&WheelSet::wheel_speed_m_s, "wheel_speed_m_s", "V_k", "m/s", positive(), "wheel speed", 25.0);
  };
  const auto work = [](auto& f) {
    f.input(&WheelAndWork::wheel_radius_mm, "wheel_radius_mm", "R_k", "mm", positive(), "wheel radius", 20.0)
        .input(&WheelAndWork::work_radius_mm, "work_radius_mm", "R_d", "mm", any(),
               "radius of the bore or shaft; ignored for surface grinding", 25.0)
        .input(&WheelAndWork::kind, "kind", "-", "-", no_range(),
               "internal (the paper), external or surface grinding", "internal");
  };
  const auto relief = [](auto& f) {
    f.input(&WheelSet::grain_spacing_mm, "grain_spacing_mm", "S", "mm", positive(),
            "spacing of grains on the wheel face", 0.32)
        .input(&WheelSet::tip_radius_um, "tip_radius_um", "rho", "um", positive(), "radius of the grain tip",
               6.69)
        .input(&WheelSet::tip_angle_deg, "tip_angle_deg", "epsilon", "deg", open(0, 180),
               "apex angle of the grain tip", 91.0)
        .input(&WheelSet::weibull_x0_um_m, "weibull_x0", "X_0", "um^m", positive(),
               "scale of the depth of tips under the face", 81.2)
        .input(&WheelSet::weibull_m, "weibull_m", "m", "1", positive(), "shape of the depth of tips", 1.45)
        .optional(&WheelSet::interval_um, "interval_um", "Delta R", "um", positive(),
                  "thickness of a layer of grains of equal height")
        .optional(&WheelSet::coverage, "coverage", "-", "1", open(0, 1), "covered share that counts as full");
  };
  const auto wheel_set = [&](auto& f) { f.with(speed).with(work).with(relief); };
  const auto regime = [&](auto& f) {
    f.input(&CuttingRegime::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed",
            6.0)
        .input(&CuttingRegime::depth_mm, "depth_mm", "t_f", "mm", positive(), "depth of cut per revolution",
               0.01)
        .with(wheel_set);
  };
  const auto protrusion = [](auto& f) {
    f.note("Only whole intervals are told apart; a tie with the protrusion counts as unsafe.");
  };

  source
      .function<&cutting_surface_roughness>("cutting_surface_roughness",
                                            "Largest height of irregularities of the cutting surface.",
                                            "eqs. (1)-(9)", Provenance::repaired)
      .with(regime)
      .output(&CuttingSurface::rmax_um, "rmax_um", "R_max", "um", non_negative(), "largest height")
      .output(&CuttingSurface::interval_number, "interval_number", "N'", "1", non_negative(),
              "intervals until the top is covered; K when saturated")
      .output(&CuttingSurface::saturated, "saturated", "-", "1", closed(0, 1),
              "1: the coverage is never reached, Rmax is the depth")
      .output(&CuttingSurface::position_mm, "position_mm", "L", "mm", non_negative(),
              "path of the section along the arc from first contact")
      .output(&CuttingSurface::coverage_reached, "coverage_reached", "b/1000", "1", probability(),
              "covered share after the last interval")
      .note("For the instant after plunging into a smooth surface; within 2 % of the paper's table.");
  source
      .function<&cutting_surface_profile>("cutting_surface_profile",
                                          "Height of irregularities along the whole contact arc.",
                                          "eqs. (1)-(9) with renumbering", Provenance::reconstructed)
      .with(regime)
      .output(&SurfaceAlongArc::position_mm, "position_mm", "L", "mm", non_negative(),
              "path along the arc from first contact")
      .output(&SurfaceAlongArc::rmax_um, "rmax_um", "R_max", "um", non_negative(), "height at that point")
      .note("Renumbering after a full layer is read as a fresh count on the new top.");
  source
      .function<&residual_height>("residual_height", "Largest height and the one at the end of the arc.",
                                  "eqs. (1)-(9) with renumbering", Provenance::reconstructed)
      .with(regime)
      .output(&ResidualHeight::rmax_um, "rmax_um", "R_max", "um", non_negative(), "largest height")
      .output(&ResidualHeight::final_height_um, "final_height_um", "-", "um", non_negative(),
              "height left after one passage of the arc")
      .output(&ResidualHeight::arc_length_mm, "arc_length_mm", "L", "mm", non_negative(),
              "arc of the whole intervals")
      .note("The roughness of the finished part is not predicted.");
  source
      .function<&contact_arc>("contact_arc", "Equivalent diameter and length of the contact arc.", "geometry",
                              Provenance::completion)
      .with(work)
      .input(&ArcOfCut::depth_mm, "depth_mm", "t_f", "mm", positive(), "depth of cut", 0.01)
      .output(&ContactArc::equivalent_diameter_mm, "equivalent_diameter_mm", "D_e", "mm", positive(),
              "equivalent diameter")
      .output(&ContactArc::arc_length_mm, "arc_length_mm", "L", "mm", positive(), "length of the arc");
  source
      .function<&scratch_width>("scratch_width", "Width of the groove of one grain.", "eq. (9)",
                                Provenance::repaired)
      .input(&GrainTip::depth_um, "depth_um", "t", "um", non_negative(), "depth of the groove", 1.0)
      .input(&GrainTip::tip_radius_um, "tip_radius_um", "rho", "um", positive(), "radius of the grain tip",
             6.69)
      .input(&GrainTip::tip_angle_deg, "tip_angle_deg", "epsilon", "deg", open(0, 180),
             "apex angle of the grain tip", 91.0)
      .output(&ScratchWidth::width_um, "width_um", "b", "um", non_negative(), "width of the groove");
  source
      .function<&tip_layer_probability>("tip_layer_probability", "Share of grains with tips in one layer.",
                                        "eq. (8)", Provenance::repaired)
      .input(&TipLayer::layer, "layer", "i", "1", at_least(1), "number of the layer from the face", 1)
      .input(&TipLayer::interval_um, "interval_um", "Delta R", "um", positive(), "thickness of a layer", 0.12)
      .input(&TipLayer::weibull_m, "weibull_m", "m", "1", positive(), "shape of the depth of tips", 1.45)
      .input(&TipLayer::weibull_x0_um_m, "weibull_x0", "X_0", "um^m", positive(),
             "scale of the depth of tips", 81.2)
      .output(&LayerProbability::probability, "probability", "F", "1", probability(), "share of the grains");
  source
      .function<&minimum_interval>("minimum_interval", "Finest interval through which a grain still passes.",
                                   "eq. (10)", Provenance::paper)
      .input(&IntervalSearch::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed",
             3.0)
      .input(&IntervalSearch::wheel_width_mm, "wheel_width_mm", "B", "mm", positive(), "wheel width", 10.0)
      .input(&IntervalSearch::step_um, "step_um", "-", "um", positive(), "step of the search", 0.01)
      .input(&IntervalSearch::wheel_speed_m_s, "wheel_speed_m_s", "V_k", "m/s", positive(), "wheel speed",
             25.0)
      .with(work)
      .input(&IntervalSearch::grain_spacing_mm, "grain_spacing_mm", "S", "mm", positive(),
             "spacing of grains on the wheel face", 0.32)
      .input(&IntervalSearch::weibull_x0_um_m, "weibull_x0", "X_0", "um^m", positive(),
             "scale of the depth of tips", 81.2)
      .input(&IntervalSearch::weibull_m, "weibull_m", "m", "1", positive(), "shape of the depth of tips",
             1.45)
      .output(&MinimumInterval::interval_um, "interval_um", "Delta R", "um", positive(),
              "smallest sufficient multiple of the step")
      .output(&MinimumInterval::grain_count, "grain_count", "-", "1", at_least(1),
              "grains of the first layer that pass");
  source
      .function<&max_work_speed_for_protrusion>("max_work_speed_for_protrusion",
                                                "Largest work speed without rubbing of the bond.",
                                                "completion, Rmax < H", Provenance::completion)
      .input(&SpeedSearch::protrusion_um, "protrusion_um", "H", "um", positive(), "grain protrusion", 8.0)
      .input(&SpeedSearch::depth_mm, "depth_mm", "t_f", "mm", positive(), "depth of cut", 0.01)
      .input(&SpeedSearch::speed_low_m_min, "speed_low_m_min", "-", "m/min", positive(), "slowest work speed",
             0.5)
      .input(&SpeedSearch::speed_high_m_min, "speed_high_m_min", "-", "m/min", positive(),
             "fastest work speed", 60.0)
      .with(wheel_set)
      .output(&MaxWorkSpeed::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", non_negative(),
              "largest safe speed; 0: none, the high end: all are")
      .with(protrusion);
  source
      .function<&max_depth_for_protrusion>("max_depth_for_protrusion",
                                           "Largest depth of cut without rubbing of the bond.",
                                           "completion, Rmax < H", Provenance::completion)
      .input(&DepthSearch::protrusion_um, "protrusion_um", "H", "um", positive(), "grain protrusion", 8.0)
      .input(&DepthSearch::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed",
             6.0)
      .with(wheel_set)
      .output(&MaxDepth::depth_mm, "depth_mm", "t_f", "mm", closed(0, 0.1), "largest safe depth; 0: none")
      .with(protrusion);
  source
      .function<&specific_removal_rate>("specific_removal_rate", "Removal rate per mm of wheel width.",
                                        "definition", Provenance::completion)
      .input(&SpeedAndDepth::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed",
             6.0)
      .input(&SpeedAndDepth::depth_mm, "depth_mm", "t_f", "mm", positive(), "depth of cut", 0.01)
      .output(&RemovalRate::q_mm3_mm_min, "q_mm3_mm_min", "q", "mm3/(mm*min)", positive(), "removal rate");
}

}  // namespace verstat::models::k303
