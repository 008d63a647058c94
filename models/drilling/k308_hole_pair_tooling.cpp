#include "models/drilling/k308_hole_pair_tooling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/normal_interval.h"

namespace verstat::models::k308 {
namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180;

// Sliding per mm of stroke when the share `slip` of the circumferential motion remains.
double sliding(double radius_mm, double feed_mm_rev, double slip) {
  return std::hypot(2 * pi * radius_mm * slip / feed_mm_rev, 1.0);
}

WearRatio wear_ratio(double ratio) {
  return {ratio, 1 / ratio};
}

}  // namespace

WearRatio bushing_wear_ratio(const RotatingBushing& in) {
  return guarded<&bushing_wear_ratio>(in, [&] {
    const double fixed = sliding(in.radius_mm, in.feed_mm_rev, 1) +
                         in.return_factor * sliding(in.radius_mm, in.return_feed_mm_rev, 1);
    return wear_ratio(in.slip_factor * (1 + in.return_factor) / fixed);
  });
}

SlidingPath sliding_path(const BushingStroke& in) {
  return guarded<&sliding_path>(
      in, [&] { return SlidingPath{in.depth_mm * sliding(in.radius_mm, in.feed_mm_rev, in.slip)}; });
}

WearRatio bushing_wear_ratio_slip(const SlippingBushing& in) {
  return guarded<&bushing_wear_ratio_slip>(in, [&] {
    const auto both_strokes = [&](double slip) {
      return sliding(in.radius_mm, in.feed_mm_rev, slip) +
             in.return_factor * sliding(in.radius_mm, in.return_feed_mm_rev, slip);
    };
    return wear_ratio(both_strokes(in.slip) / both_strokes(1));
  });
}

BushingLife bushing_life(const FixedBushingLife& in) {
  return guarded<&bushing_life>(in, [&] { return BushingLife{in.holes_fixed / in.wear_ratio}; });
}

SetupError setup_error(const SetupErrors& in) {
  return guarded<&setup_error>(
      in, [&] { return SetupError{std::hypot(in.locating_mm, in.clamping_mm, in.fixture_mm)}; });
}

GaugeError gauge_error(const GaugeErrors& in) {
  return guarded<&gauge_error>(in, [&] {
    const double lever = std::hypot(in.lever_manufacture_mm, in.lever_clearance_mm, in.disproportion_mm);
    return GaugeError{std::hypot(lever, in.contact_shift_mm, in.direct_transmission_mm)};
  });
}

CentreDistance head_center_distance(const SpindleArms& in) {
  return guarded<&head_center_distance>(in, [&] {
    return CentreDistance{(in.pinion_diameter_mm + in.gear_diameter_mm) *
                          std::sin(in.angle_deg / 2 * radians_per_degree)};
  });
}

HeadAngle head_angle(const SpindleDistance& in) {
  return guarded<&head_angle>(in, [&] {
    const double reach_mm = in.pinion_diameter_mm + in.gear_diameter_mm;
    const bool within = in.distance_mm <= reach_mm;
    return HeadAngle{within ? 2 * std::asin(in.distance_mm / reach_mm) / radians_per_degree : 180.0,
                     within && in.distance_mm >= in.gear_diameter_mm};
  });
}

MultiSpindleTime multi_spindle_drilling(const MultiSpindleJob& in) {
  return guarded<&multi_spindle_drilling>(in, [&] {
    const double rpm =
        in.machine_rpm * static_cast<double>(in.pinion_teeth) / static_cast<double>(in.gear_teeth);
    const std::int64_t strokes = in.holes / in.drills + (in.holes % in.drills == 0 ? 0 : 1);
    const double stroke_min = (in.depth_mm + in.approach_mm + in.overrun_mm) / (in.feed_mm_rev * rpm);
    return MultiSpindleTime{
        rpm, strokes,
        static_cast<double>(strokes) * stroke_min + static_cast<double>(strokes - 1) * in.index_min};
  });
}

Acceptance inspection_accept_probability(const Inspection& in) {
  return guarded<&inspection_accept_probability>(in, [&] {
    require(in.lower_mm < in.upper_mm, "lower", in.lower_mm, "must be below upper");
    const double sigma_mm = in.error_mm / in.deviations;
    if (sigma_mm == 0)
      return Acceptance{in.lower_mm <= in.value_mm && in.value_mm <= in.upper_mm ? 1.0 : 0.0};
    return Acceptance{
        normal_between((in.lower_mm - in.value_mm) / sigma_mm, (in.upper_mm - in.value_mm) / sigma_mm)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K308",
       .title = "Technological equipment for handling the holes with different centring distances",
       .authors = "Dynia V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Three devices for the paired holes of chain plates: a drill bushing that turns with the "
                 "drill and its wear against a fixed one; a two-spindle head whose centre distance is set by "
                 "an angle; a motorized checking fixture with its error sums and a go / no-go decision.",
       .role = "drilling",
       .errata = {"The legend of eq. (1) is damaged (\"k2 = S1 - feed\", S1 twice): k2 is the factor for the "
                  "smaller normal force on the return stroke, S1 and S2 the feeds of cutting and return.",
                  "Eq. (3) is printed as the root of 2/p1 + 2/p2 + ...: the exponents were set as "
                  "numerators; the root of the sum of squares is meant.",
                  "Both first figures carry the number 2."}});

  const auto bushing = [](auto& f, auto return_factor, auto radius, auto feed, auto return_feed) {
    f.optional(return_factor, "k2", "k2", "1", closed(0, 1),
               "factor for the smaller normal force on the return stroke")
        .input(radius, "r", "r", "mm", positive(), "drill radius", 5.0)
        .input(feed, "S1", "S1", "mm/rev", positive(), "feed while drilling", 0.2)
        .input(return_feed, "S2", "S2", "mm/rev", positive(), "feed of the return stroke", 0.8)
        .output(&WearRatio::ratio, "k3", "k3", "1", positive(),
                "wear of the rotating bushing over that of a fixed one")
        .output(&WearRatio::life_gain, "life_gain", "1/k3", "1", positive(), "gain in life");
  };
  source
      .function<&bushing_wear_ratio>("bushing_wear_ratio",
                                     "Wear of a bushing that turns with the drill, against a fixed one.",
                                     "eq. (1)", Provenance::repaired)
      .optional(&RotatingBushing::slip_factor, "k1", "k1", "1", positive(),
                "factor for the lag of the bushing, printed 1.2-1.4")
      .with([&](auto& f) {
        bushing(f, &RotatingBushing::return_factor, &RotatingBushing::radius_mm,
                &RotatingBushing::feed_mm_rev, &RotatingBushing::return_feed_mm_rev);
      })
      .note(
          "Optimistic: it supposes almost complete entrainment (1.2-1.4 is about 0.5-0.7 % slip at r = 5 mm) "
          "and leaves out the bearing. Plan with bushing_wear_ratio_slip at 1-5 %.")
      .note("The value of k2 is lost in print; 0.3 is assumed.");
  source
      .function<&sliding_path>("sliding_path", "Sliding of the drill margin along the bushing in one stroke.",
                               "derivation of eq. (1)", Provenance::completion)
      .input(&BushingStroke::radius_mm, "r", "r", "mm", positive(), "drill radius", 5.0)
      .input(&BushingStroke::feed_mm_rev, "S", "S", "mm/rev", positive(), "feed", 0.2)
      .input(&BushingStroke::depth_mm, "depth", "-", "mm", non_negative(), "depth of the stroke", 20.0)
      .input(&BushingStroke::slip, "slip", "s", "1", closed(0, 1),
             "share of circumferential sliding, 1 for a fixed bushing", 1.0)
      .output(&SlidingPath::path_mm, "path", "-", "mm", non_negative(), "sliding path");
  source
      .function<&bushing_wear_ratio_slip>("bushing_wear_ratio_slip",
                                          "Wear of a turning bushing that slips, against a fixed one.",
                                          "completion (partial slip)", Provenance::completion)
      .input(&SlippingBushing::slip, "slip", "s", "1", closed(0, 1), "share of circumferential sliding", 0.02)
      .with([&](auto& f) {
        bushing(f, &SlippingBushing::return_factor, &SlippingBushing::radius_mm,
                &SlippingBushing::feed_mm_rev, &SlippingBushing::return_feed_mm_rev);
      });
  source
      .function<&bushing_life>("bushing_life", "Holes until a bushing is worn out.",
                               "completion (wear proportional to path)", Provenance::completion)
      .input(&FixedBushingLife::holes_fixed, "holes_fixed", "-", "1", non_negative(),
             "holes until a fixed bushing is worn out", 10000.0)
      .input(&FixedBushingLife::wear_ratio, "k3", "k3", "1", positive(), "wear ratio", 0.02)
      .output(&BushingLife::holes, "holes", "-", "1", non_negative(), "holes until this bushing is worn out")
      .note("The bearing of the bushing wears by itself and needs a life of its own.");
  source.function<&setup_error>("setup_error", "Error of setting up a part.", "eq. (2)", Provenance::paper)
      .input(&SetupErrors::locating_mm, "eps_b", "eps_b", "mm", non_negative(), "locating error", 0.03)
      .input(&SetupErrors::clamping_mm, "eps_z", "eps_z", "mm", non_negative(), "clamping error", 0.04)
      .input(&SetupErrors::fixture_mm, "eps_pr", "eps_pr", "mm", non_negative(), "error of the fixture", 0.0)
      .output(&SetupError::error_mm, "eps", "eps", "mm", non_negative(), "error of setting up")
      .note("For the total error of an inspection put sqrt(fixture^2 + delta^2) of gauge_error in eps_pr.");
  source
      .function<&gauge_error>("gauge_error", "Error of the measuring device.", "eq. (3)",
                              Provenance::repaired)
      .input(&GaugeErrors::lever_manufacture_mm, "d1", "d_p1", "mm", non_negative(),
             "manufacture of the lever", 0.002)
      .input(&GaugeErrors::lever_clearance_mm, "d2", "d_p2", "mm", non_negative(), "clearance of the lever",
             0.003)
      .input(&GaugeErrors::disproportion_mm, "d3", "d_p3", "mm", non_negative(),
             "disproportion of linear and angular motion", 0.001)
      .input(&GaugeErrors::contact_shift_mm, "d4", "d_p4", "mm", non_negative(),
             "shift of the spherical contact point", 0.001)
      .input(&GaugeErrors::direct_transmission_mm, "d5", "d_p5", "mm", non_negative(),
             "direct transmission (screw and encoder)", 0.001)
      .output(&GaugeError::error_mm, "delta", "Delta_p", "mm", non_negative(), "error of the device")
      .note("Components of a lever gauge; the fixture described has no lever: d1 to d4 are 0 for it.");
  source
      .function<&head_center_distance>("head_center_distance",
                                       "Centre distance of the two spindles at an angle of the arms.",
                                       "completion (geometry)", Provenance::completion)
      .input(&SpindleArms::pinion_diameter_mm, "d_pinion", "-", "mm", positive(),
             "pitch diameter of the pinion", 40.0)
      .input(&SpindleArms::gear_diameter_mm, "d_gear", "-", "mm", positive(),
             "pitch diameter of the spindle gears", 24.0)
      .input(&SpindleArms::angle_deg, "phi_deg", "phi", "deg", closed(0, 180), "angle between the arms", 60.0)
      .output(&CentreDistance::distance_mm, "A", "A", "mm", non_negative(), "centre distance");
  source
      .function<&head_angle>("head_angle", "Angle between the spindle arms for a centre distance.",
                             "completion (geometry)", Provenance::completion)
      .input(&SpindleDistance::pinion_diameter_mm, "d_pinion", "-", "mm", positive(),
             "pitch diameter of the pinion", 40.0)
      .input(&SpindleDistance::gear_diameter_mm, "d_gear", "-", "mm", positive(),
             "pitch diameter of the spindle gears", 24.0)
      .input(&SpindleDistance::distance_mm, "A", "A", "mm", positive(), "centre distance", 40.0)
      .output(&HeadAngle::angle_deg, "phi", "phi", "deg", closed(0, 180), "angle between the arms")
      .output(&HeadAngle::ok, "ok", "-", "-", no_range(), "the gears clear each other and reach the distance")
      .note("Judged on the pitch circles: the spindle gears must not mesh, so add two modules to d_gear.");
  source
      .function<&multi_spindle_drilling>("multi_spindle_drilling",
                                         "Speed, strokes and main time with a multi-spindle head.",
                                         "completion", Provenance::completion)
      .input(&MultiSpindleJob::depth_mm, "depth", "l", "mm", non_negative(), "depth of the holes", 12.0)
      .input(&MultiSpindleJob::approach_mm, "approach", "l_1", "mm", non_negative(), "approach", 3.0)
      .input(&MultiSpindleJob::overrun_mm, "overrun", "l_2", "mm", non_negative(), "overrun", 2.0)
      .input(&MultiSpindleJob::feed_mm_rev, "f", "f", "mm/rev", positive(), "feed of the drill", 0.15)
      .input(&MultiSpindleJob::machine_rpm, "n_machine", "-", "rpm", positive(),
             "speed of the machine spindle", 600.0)
      .input(&MultiSpindleJob::pinion_teeth, "z_pinion", "-", "1", at_least(1), "teeth of the pinion", 40)
      .input(&MultiSpindleJob::gear_teeth, "z_gear", "-", "1", at_least(1), "teeth of the spindle gears", 24)
      .input(&MultiSpindleJob::holes, "n_holes", "-", "1", at_least(1), "holes per part", 5)
      .input(&MultiSpindleJob::drills, "n_spindles", "-", "1", at_least(1), "drills in the head", 2)
      .input(&MultiSpindleJob::index_min, "t_index", "-", "min", non_negative(), "indexing between strokes",
             0.1)
      .output(&MultiSpindleTime::spindle_rpm, "n_spindle", "-", "rpm", positive(), "speed of the drills")
      .output(&MultiSpindleTime::strokes, "strokes", "-", "1", at_least(1), "strokes per part")
      .output(&MultiSpindleTime::time_min, "t", "t", "min", non_negative(), "main time per part");
  source
      .function<&inspection_accept_probability>("inspection_accept_probability",
                                                "Probability that a part passes the inspection.",
                                                "completion (normal measuring error)", Provenance::completion)
      .input(&Inspection::value_mm, "x", "x", "mm", any(), "true value", 40.04)
      .input(&Inspection::lower_mm, "lower", "x_l", "mm", any(), "lower limit", 39.95)
      .input(&Inspection::upper_mm, "upper", "x_u", "mm", any(), "upper limit", 40.05)
      .input(&Inspection::error_mm, "eps", "eps", "mm", non_negative(), "total measuring error", 0.03)
      .optional(&Inspection::deviations, "k", "k", "1", positive(),
                "standard deviations that the error stands for")
      .output(&Acceptance::probability, "p", "p", "1", probability(), "probability of acceptance");
}

}  // namespace verstat::models::k308
