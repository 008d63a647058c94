#include "models/inspection/k307_location_gauges.h"

#include <algorithm>
#include <cmath>

#include "models/math/gauss_legendre.h"
#include "models/math/normal.h"
#include "models/math/normal_interval.h"

namespace verstat::models::k307 {
namespace {

constexpr double fit_slack_mm = 1e-9;
constexpr double widest_sigma = 8;

void check_elements(const GaugeDesign& in) {
  require(in.deviation_1_mm >= in.wear_value_1_mm, "F1", in.deviation_1_mm, "must not be below W1");
  require(in.deviation_2_mm >= in.wear_value_2_mm, "F2", in.deviation_2_mm, "must not be below W2");
}

struct Elements {
  double deviation_mm;  // (F1 + F2)/2
  double wear_mm;       // (W1 + W2)/2
};

Elements mean_elements(const GaugeDesign& in) {
  return {(in.deviation_1_mm + in.deviation_2_mm) / 2, (in.wear_value_1_mm + in.wear_value_2_mm) / 2};
}

// Expectation of g(Z) for a standard normal Z over low..8, in panels of at most four sigmas: 24 points hold a
// bell of that width to rounding.
template <class G>
double expectation(G&& g, double low, double high) {
  double sum = 0;
  const int panels = std::max(1, static_cast<int>(std::ceil((high - low) / 4)));
  const double width = (high - low) / panels;
  for (int k = 0; k < panels; ++k)
    sum += integrate_gauss([&](double z) { return normal_density(z) * g(z); }, low + k * width,
                           low + (k + 1) * width, gauss_legendre_24());
  return sum;
}

double pass_probability(const GaugedProcess& in) {
  const double mean_radius = (in.d1_mean_mm + in.d2_mean_mm) / 2;
  const double radius_sigma = std::hypot(in.d1_sigma_mm, in.d2_sigma_mm) / 2;
  const double c_mean = in.distance_mean_mm;
  const double c_sigma = in.distance_sigma_mm;
  // P(B - s <= C <= B' + s) at a given mean radius s of the holes.
  const auto given_radius = [&](double s) {
    const double low = (in.b_outer_mm - s - c_mean) / c_sigma;
    const double high = (in.b_inner_mm + s - c_mean) / c_sigma;
    return low < high ? normal_between(low, high) : 0.0;
  };
  if (radius_sigma == 0) return given_radius(mean_radius);
  // The one of the two that scatters less is integrated over, so that the integrand is smooth on the scale of
  // the panels whatever the ratio of the scatters.
  if (radius_sigma <= c_sigma) {
    // No distance passes where s < (B - B')/2.
    const double kink = ((in.b_outer_mm - in.b_inner_mm) / 2 - mean_radius) / radius_sigma;
    if (kink >= widest_sigma) return 0;
    return expectation([&](double z) { return given_radius(mean_radius + z * radius_sigma); },
                       std::max(-widest_sigma, kink), widest_sigma);
  }
  // P(s >= max(B - c, c - B')) at a given distance c; the maximum changes sides at c = (B + B')/2.
  const auto given_distance = [&](double z) {
    const double c = c_mean + z * c_sigma;
    return normal_cdf((mean_radius - std::max(in.b_outer_mm - c, c - in.b_inner_mm)) / radius_sigma);
  };
  const double kink =
      std::clamp(((in.b_outer_mm + in.b_inner_mm) / 2 - c_mean) / c_sigma, -widest_sigma, widest_sigma);
  return expectation(given_distance, -widest_sigma, kink) + expectation(given_distance, kink, widest_sigma);
}

}  // namespace

GaugeSizes gauge_outer_span(const GaugeDesign& in) {
  return guarded<&gauge_outer_span>(in, [&] {
    check_elements(in);
    const Elements mean = mean_elements(in);
    const double worn = in.distance_mm + (in.d1_min_mm + in.d2_min_mm) / 2 - in.tolerance_mm;
    return GaugeSizes{worn + mean.deviation_mm, worn + mean.wear_mm, worn, mean.deviation_mm - mean.wear_mm,
                      mean.wear_mm};
  });
}

GaugeSizes gauge_inner_span(const GaugeDesign& in) {
  return guarded<&gauge_inner_span>(in, [&] {
    check_elements(in);
    const Elements mean = mean_elements(in);
    const double worn = in.distance_mm - (in.d1_min_mm + in.d2_min_mm) / 2 + in.tolerance_mm;
    return GaugeSizes{worn - mean.wear_mm, worn - mean.deviation_mm, worn, mean.deviation_mm - mean.wear_mm,
                      mean.wear_mm};
  });
}

GaugeVerdict gauge_accepts(const GaugedPart& in) {
  return guarded<&gauge_accepts>(in, [&] {
    const double radius = (in.d1_mm + in.d2_mm) / 2;
    return GaugeVerdict{in.distance_mm + radius >= in.b_outer_mm - fit_slack_mm &&
                        in.distance_mm - radius <= in.b_inner_mm + fit_slack_mm};
  });
}

CenterDeviation allowed_center_deviation(const HolePair& in) {
  return guarded<&allowed_center_deviation>(in, [&] {
    return CenterDeviation{in.tolerance_mm + ((in.d1_mm - in.d1_min_mm) + (in.d2_mm - in.d2_min_mm)) / 2};
  });
}

PassProbability gauge_pass_probability(const GaugedProcess& in) {
  return guarded<&gauge_pass_probability>(
      in, [&] { return PassProbability{std::clamp(pass_probability(in), 0.0, 1.0)}; });
}

GaugeLife gauge_life_checks(const GaugeWear& in) {
  return guarded<&gauge_life_checks>(in, [&] {
    // 1e-6 keeps a whole number of checks from being rounded down.
    const double checks =
        std::floor(1000 * std::abs(in.size_mm - in.wear_limit_mm) / in.wear_per_check_um + 1e-6);
    require(checks < 1e15, "wear_per_check", in.wear_per_check_um, "leaves more than 1e15 checks");
    return GaugeLife{static_cast<std::int64_t>(checks)};
  });
}

Temperature heating_temperature(const ShrinkFit& in) {
  return guarded<&heating_temperature>(in, [&] {
    return Temperature{in.room_c +
                       (in.interference_mm + in.clearance_mm) / (in.expansion_1_k * in.diameter_mm)};
  });
}

AxialGap axial_gap(const SeizedHub& in) {
  return guarded<&axial_gap>(
      in, [&] { return AxialGap{in.expansion_1_k * in.length_mm * (in.seizing_c - in.room_c)}; });
}

ReducedDeviation reduced_deviation(const MeasuredSize& in) {
  return guarded<&reduced_deviation>(in, [&] {
    require(in.lower_mm < in.upper_mm, "lower", in.lower_mm, "must be below upper");
    return ReducedDeviation{((in.size_mm - in.lower_mm) + (in.size_mm - in.upper_mm)) /
                            (in.upper_mm - in.lower_mm)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K307",
       .title = "The geometrical interchangeability of units on the basis of the processing method in "
                "accordance with ISO 9001:2009",
       .authors = "Martynov A. P.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A joint as the product of a chain of processes whose errors add up at assembly. The computable "
           "part: limit sizes of a pair of snap gauges for the distance between two hole axes with a "
           "dependent position tolerance, what they accept and how long they last; thermal assembly of "
           "shrink fits; reduced deviations for the control of small batches.",
       .role = "inspection",
       .errata = {"The legend lists the largest hole diameters, which the formulas do not use.",
                  "The paper speaks of two gauges and prints the sizes of one."}});

  const auto design = [](auto& f) {
    f.input(&GaugeDesign::distance_mm, "L", "L", "mm", positive(), "nominal distance of the axes", 100.0)
        .input(&GaugeDesign::d1_min_mm, "D1_min", "D_1min", "mm", positive(), "least diameter of hole 1",
               20.0)
        .input(&GaugeDesign::d2_min_mm, "D2_min", "D_2min", "mm", positive(), "least diameter of hole 2",
               20.0)
        .input(&GaugeDesign::tolerance_mm, "T_p", "T_p", "mm", positive(), "position tolerance, diametral",
               0.2)
        .input(&GaugeDesign::deviation_1_mm, "F1", "F_1", "mm", non_negative(),
               "basic deviation of new element 1, at least W1", 0.02)
        .input(&GaugeDesign::deviation_2_mm, "F2", "F_2", "mm", non_negative(),
               "basic deviation of new element 2, at least W2", 0.02)
        .input(&GaugeDesign::wear_value_1_mm, "W1", "W_1", "mm", non_negative(), "wear value of element 1",
               0.008)
        .input(&GaugeDesign::wear_value_2_mm, "W2", "W_2", "mm", non_negative(), "wear value of element 2",
               0.008)
        .output(&GaugeSizes::b_max_mm, "B_max", "B_max", "mm", any(), "largest size of a new gauge")
        .output(&GaugeSizes::b_min_mm, "B_min", "B_min", "mm", any(), "least size of a new gauge")
        .output(&GaugeSizes::b_wear_mm, "B_wear", "B_W", "mm", any(), "size at the end of wear")
        .output(&GaugeSizes::tolerance_mm, "tolerance", "-", "mm", non_negative(), "B_max - B_min")
        .output(&GaugeSizes::wear_allowance_mm, "wear_allowance", "-", "mm", non_negative(),
                "from the nearest new size to the wear limit")
        .note("F and W come from the gauge standard for dependent position tolerances.");
  };
  source
      .function<&gauge_outer_span>("gauge_outer_span", "Sizes of the gauge over the far walls of two holes.",
                                   "text", Provenance::paper)
      .with(design);
  source
      .function<&gauge_inner_span>("gauge_inner_span", "Sizes of the gauge over the near walls of two holes.",
                                   "completion by symmetry", Provenance::completion)
      .with(design);
  source
      .function<&gauge_accepts>("gauge_accepts", "Whether a part passes both gauges.", "text",
                                Provenance::completion)
      .input(&GaugedPart::distance_mm, "C", "C", "mm", positive(), "actual distance of the axes", 100.0)
      .input(&GaugedPart::d1_mm, "D1", "D_1", "mm", positive(), "actual diameter of hole 1", 20.02)
      .input(&GaugedPart::d2_mm, "D2", "D_2", "mm", positive(), "actual diameter of hole 2", 20.02)
      .input(&GaugedPart::b_outer_mm, "B_outer", "B", "mm", any(), "actual size over the far walls", 119.82)
      .input(&GaugedPart::b_inner_mm, "B_inner", "B'", "mm", any(), "actual size over the near walls", 80.18)
      .output(&GaugeVerdict::accept, "accept", "-", "-", no_range(), "both gauges enter")
      .note("The diameters are taken as already accepted. A fit to within 1e-9 mm is accepted.");
  source
      .function<&allowed_center_deviation>("allowed_center_deviation",
                                           "Permitted deviation of the axis distance, worn gauges.",
                                           "consequence of the text", Provenance::completion)
      .input(&HolePair::d1_mm, "D1", "D_1", "mm", positive(), "actual diameter of hole 1", 20.05)
      .input(&HolePair::d2_mm, "D2", "D_2", "mm", positive(), "actual diameter of hole 2", 20.03)
      .input(&HolePair::d1_min_mm, "D1_min", "D_1min", "mm", positive(), "least diameter of hole 1", 20.0)
      .input(&HolePair::d2_min_mm, "D2_min", "D_2min", "mm", positive(), "least diameter of hole 2", 20.0)
      .input(&HolePair::tolerance_mm, "T_p", "T_p", "mm", positive(), "position tolerance, diametral", 0.2)
      .output(&CenterDeviation::deviation_mm, "dev", "-", "mm", any(), "permitted +- deviation");
  source
      .function<&gauge_pass_probability>("gauge_pass_probability",
                                         "Probability that a part passes both gauges.", "completion",
                                         Provenance::completion)
      .input(&GaugedProcess::distance_mean_mm, "C_mean", "C", "mm", positive(), "mean distance of the axes",
             100.0)
      .input(&GaugedProcess::distance_sigma_mm, "C_sigma", "sigma_C", "mm", positive(), "its scatter", 0.08)
      .input(&GaugedProcess::d1_mean_mm, "D1_mean", "D_1", "mm", positive(), "mean diameter of hole 1",
             20.026)
      .input(&GaugedProcess::d1_sigma_mm, "D1_sigma", "sigma_1", "mm", non_negative(), "its scatter", 0.008)
      .input(&GaugedProcess::d2_mean_mm, "D2_mean", "D_2", "mm", positive(), "mean diameter of hole 2",
             20.026)
      .input(&GaugedProcess::d2_sigma_mm, "D2_sigma", "sigma_2", "mm", non_negative(), "its scatter", 0.008)
      .input(&GaugedProcess::b_outer_mm, "B_outer", "B", "mm", any(), "actual size over the far walls",
             119.82)
      .input(&GaugedProcess::b_inner_mm, "B_inner", "B'", "mm", any(), "actual size over the near walls",
             80.18)
      .output(&PassProbability::p, "p", "p", "1", probability(), "pass probability")
      .note(
          "Diameters are not cut off at their limits although holes are accepted first; the operator's "
          "measuring scatter is not modelled.");
  source
      .function<&gauge_life_checks>("gauge_life_checks", "Checks that a gauge has left.", "completion",
                                    Provenance::completion)
      .input(&GaugeWear::size_mm, "B", "B", "mm", positive(), "actual size, on the new side of the limit",
             119.82)
      .input(&GaugeWear::wear_limit_mm, "B_wear", "B_W", "mm", positive(), "size at the end of wear", 119.8)
      .input(&GaugeWear::wear_per_check_um, "wear_per_check", "-", "um", positive(), "loss of span per check",
             0.002)
      .output(&GaugeLife::checks, "checks", "-", "1", non_negative(), "checks left")
      .note("Does not know the kind of gauge: a gauge past its limit has no checks left.");
  source
      .function<&heating_temperature>("heating_temperature", "Temperature for a thermal assembly.",
                                      "completion", Provenance::completion)
      .input(&ShrinkFit::diameter_mm, "d", "d", "mm", positive(), "diameter of the joint", 100.0)
      .input(&ShrinkFit::interference_mm, "delta", "delta", "mm", non_negative(), "largest interference",
             0.12)
      .input(&ShrinkFit::clearance_mm, "clearance", "Delta", "mm", non_negative(), "clearance for assembly",
             0.05)
      .input(&ShrinkFit::expansion_1_k, "alpha", "alpha", "1/K", positive(), "expansion coefficient", 11.5e-6)
      .input(&ShrinkFit::room_c, "t_room", "t_room", "degC", at_least(-273.15), "room temperature", 20.0)
      .output(&Temperature::temperature_c, "t", "t", "degC", at_least(-273.15), "heating temperature");
  source
      .function<&axial_gap>("axial_gap", "Gap at the shoulder after thermal assembly.", "completion",
                            Provenance::completion)
      .input(&SeizedHub::length_mm, "l", "l", "mm", positive(), "length of the hub", 80.0)
      .input(&SeizedHub::expansion_1_k, "alpha", "alpha", "1/K", positive(), "expansion coefficient", 11.5e-6)
      .input(&SeizedHub::seizing_c, "t_seize", "t_seize", "degC", at_least(-273.15),
             "temperature at which the hub seizes", 150.0)
      .input(&SeizedHub::room_c, "t_room", "t_room", "degC", at_least(-273.15), "room temperature", 20.0)
      .output(&AxialGap::gap_mm, "gap", "g", "mm", any(), "gap")
      .note("Upper bound: the hub seizes at the end away from the shoulder.");
  source
      .function<&reduced_deviation>("reduced_deviation", "Deviation in halves of the tolerance.",
                                    "completion", Provenance::completion)
      .input(&MeasuredSize::size_mm, "x", "x", "mm", any(), "measured size", 20.03)
      .input(&MeasuredSize::lower_mm, "lower", "x_l", "mm", any(), "lower limit", 20.0)
      .input(&MeasuredSize::upper_mm, "upper", "x_u", "mm", any(), "upper limit", 20.05)
      .output(&ReducedDeviation::deviation, "e", "e", "1", any(), "-1 and +1 at the limits");
}

}  // namespace verstat::models::k307
