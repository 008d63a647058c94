// The same operation on two machines: what spindles and safety clutches add to plans.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/dynamics/k201_bearing_resonance.h"
#include "models/dynamics/k206_spindle_base_frequencies.h"
#include "models/grinding/k209_grinding_wheel_radial_oscillations.h"
#include "models/reliability/k204_safety_clutch.h"
#include "operations/kinds/elastic_grinding.h"
#include "operations/kinds/face_milling.h"
#include "operations/kinds/hard_turning.h"
#include "operations/spindle.h"
#include "tests/operations/gallery.h"

using namespace verstat;
using namespace verstat::operations;
using Catch::Matchers::Contains;
using namespace verstat::test;

namespace {

/// The plan on this machine instead of the example's own.
template <class Spec>
CutPlan on(const GalleryExample<Spec>& example, const Spindle& spindle) {
  auto context = example.context();
  context.spindle = &spindle;
  return operations::detail::plan_of(example.spec, context);
}

bool in_a_band(const CutPlan& plan) {
  for (const ForbiddenBand& band : plan.bands)
    if (std::string(band.name) == "spindle_speed_rpm" && band.inside()) return true;
  return false;
}

}  // namespace

TEST_CASE("milling: teeth must not shake the base, and the base bounds the stable width", "[K206]") {
  GalleryExample<FaceMilling> stiff("face_milling_machine");
  stiff.file.machine_limits.safety_clutch.reset();  // known up to 600 rpm
  const auto p = stiff.plan();
  CHECK(p.feasible());
  const auto dynamics = stiff.file.spindle->dynamics();
  REQUIRE(dynamics.natural_hz.size() == 3);
  // Ten teeth at this speed meet the first natural frequency.
  stiff.spec.cutting_speed_m_min = 3.14159265358979 * 0.125 * dynamics.natural_hz[0] * 60 / 10;
  CHECK(in_a_band(stiff.plan()));
  CHECK_FALSE(stiff.plan().feasible());
  stiff.spec.teeth = 6;  // fewer teeth pass: out of the band at the same speed
  CHECK_FALSE(in_a_band(stiff.plan()));

  GalleryExample<FaceMilling> same("face_milling_machine");
  Spindle soft = *same.file.spindle;
  for (double& k : soft.elastic_base->support_k_n_um) k /= 20;
  for (double& k : soft.elastic_base->bearing_k_n_um) k /= 4;
  const auto on_soft = on(same, soft);
  CHECK(value_of(on_soft, "stable_width_mm") < 0.7 * value_of(p, "stable_width_mm"));
  CHECK_FALSE(limit_of(on_soft, "width_of_cut_mm").met());
  CHECK(soft.dynamics().natural_hz[0] < dynamics.natural_hz[0]);
  CHECK(on_soft.main_time_min == p.main_time_min);
}

TEST_CASE("least real part of the compliance: nothing lower on a fine grid of frequencies", "[K206]") {
  const GalleryExample<FaceMilling> example("face_milling_machine");
  const ElasticBase& base = *example.file.spindle->elastic_base;
  const auto dynamics = example.file.spindle->dynamics();
  models::k206::NoseInputs nose;
  nose.spindle_length_mm = base.spindle_length_mm;
  nose.spindle_outer_mm = base.spindle_outer_mm;
  nose.spindle_inner_mm = base.spindle_inner_mm;
  nose.sleeve_length_mm = base.sleeve_length_mm;
  nose.sleeve_outer_mm = base.sleeve_outer_mm;
  nose.sleeve_inner_mm = base.sleeve_inner_mm;
  nose.bearing_section = base.bearing_section;
  nose.bearing_k_n_um = base.bearing_k_n_um;
  nose.support_section = base.support_section;
  nose.support_k_n_um = base.support_k_n_um;
  nose.loss_factor = base.loss_factor;
  double least = 0;
  for (double hz = 5; hz < 1.2 * dynamics.natural_hz.back(); hz *= 1.002) {
    nose.freq_hz = hz;
    least = std::min(least, models::k206::nose_compliance(nose).re_um_n);
  }
  CHECK(dynamics.least_real_um_n <= least);
  CHECK(dynamics.least_real_um_n == Approx(least).epsilon(1e-3));
}

TEST_CASE("turning: a bearing that resonates parametrically forbids bands of speed", "[K201]") {
  GalleryExample<HardTurning> example("hard_turning_machine");
  const auto p = example.plan();
  REQUIRE_FALSE(example.file.spindle->dynamics().parametric.empty());
  CHECK_FALSE(in_a_band(p));
  const auto band = example.file.spindle->dynamics().parametric.front();
  const double middle_rpm = (band.low_rpm + band.high_rpm) / 2;
  example.spec.cutting_speed_m_min = 3.14159265358979 * example.spec.diameter_mm * middle_rpm / 1000;
  CHECK(in_a_band(example.plan()));
  // At the middle of the band the vibration grows by itself.
  const BearingResonance& b = *example.file.spindle->bearings;
  const double cage =
      models::k201::cage_speed_ratio({b.ball_diameter_mm, b.pitch_diameter_mm, b.contact_angle_deg}).ratio;
  const double share = (middle_rpm - 100) / 5900;
  models::k201::GrowthInputs growth;
  growth.natural_frequency_rad_s = 2 * 3.14159265358979 * (130 - 2 * share);
  growth.omega_exc_rad_s = static_cast<double>(b.harmonic) * cage * 2 * 3.14159265358979 * middle_rpm / 60;
  growth.stiffness_ratio = 0.25 + 0.05 * share;
  growth.damping_ratio = b.damping_ratio;
  CHECK(models::k201::parametric_growth_rate(growth).unstable == 1);
  // The bands are those of the search with the step that is asked for.
  const auto searched = [&](double step_rpm) {
    models::k201::BandInputs in;
    in.speed_nodes_rpm = b.speed_nodes_rpm;
    for (const double hz : b.natural_frequency_hz) in.p_nodes_rad_s.push_back(2 * std::numbers::pi * hz);
    in.ratio_nodes = b.stiffness_ratio;
    in.cage_ratio = cage;
    in.harmonic = b.harmonic;
    in.damping_ratio = b.damping_ratio;
    in.n_min_rpm = 300;  // slower ones are beyond the tenth zone
    in.n_max_rpm = example.file.spindle->speed_max_rpm;
    in.step_rpm = step_rpm;
    return models::k201::parametric_speed_bands(in).bands;
  };
  std::size_t fewest = 1000, most = 0;
  for (const double step_rpm : {5.0, 50.0, 4000.0}) {
    Spindle coarse = *example.file.spindle;
    coarse.speed_min_rpm = 300;
    coarse.bearings->speed_step_rpm = step_rpm;
    const auto found = coarse.dynamics().parametric;
    const auto expected = searched(step_rpm);
    INFO("step " << step_rpm);
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k].low_rpm == Approx(expected[k].n_low_rpm).epsilon(1e-9));
      CHECK(found[k].high_rpm == Approx(expected[k].n_high_rpm).epsilon(1e-9));
    }
    fewest = std::min(fewest, found.size());
    most = std::max(most, found.size());
  }
  CHECK(fewest < most);  // a band narrower than the step is missed
  // Enough damping and there is no band.
  Spindle damped = *example.file.spindle;
  damped.bearings->damping_ratio = 0.2;
  CHECK(damped.dynamics().parametric.empty());
  CHECK_FALSE(in_a_band(on(example, damped)));
  // The radial force bends the spindle; the radial force is known, so a hydrostatic spindle adds its error.
  Spindle hydrostatic = damped;
  hydrostatic.hydrostatic.emplace();
  hydrostatic.machine_error_max_um = 1e-3;
  const auto bent = on(example, hydrostatic);
  CHECK(value_of(bent, "spindle_displacement_um") > 0);
  CHECK_FALSE(limit_of(bent, "spindle_form_error_um").met());
}

TEST_CASE("grinding: the seat of the wheel is seen in the waviness", "[K209][K210]") {
  GalleryExample<ElasticGrinding> example("elastic_grinding_machine");
  const auto flanges = example.plan();
  CHECK(flanges.feasible());
  Spindle device = *example.file.spindle;
  device.wheel->mounting = models::k209::Mounting::centring_device;
  const auto centred = on(example, device);
  CHECK(value_of(centred, "waviness_um") < value_of(flanges, "waviness_um"));
  CHECK(value_of(centred, "depth_modulation") < value_of(flanges, "depth_modulation"));
  CHECK(value_of(centred, "spindle_displacement_um") == value_of(flanges, "spindle_displacement_um"));
  // Twice the clearance: a softer bearing.
  Spindle loose = *example.file.spindle;
  loose.hydrostatic->radial_clearance_um *= 2;
  CHECK(value_of(on(example, loose), "spindle_displacement_um") >
        1.5 * value_of(flanges, "spindle_displacement_um"));
}

TEST_CASE("dynamics are computed again when a number has moved, and copies keep their own", "[spindle]") {
  const GalleryExample<FaceMilling> example("face_milling_machine");
  Spindle spindle = *example.file.spindle;
  const double before_hz = spindle.dynamics().natural_hz[0];
  const Spindle copy = spindle;
  const std::vector<std::string> path{"elastic_base", "support_k_n_um", "0"};
  double* stiffness = models::locate_in_fields(&spindle, models::detail::Binding<Spindle>::fields(), path);
  REQUIRE(stiffness != nullptr);  // through an optional member
  *stiffness *= 4;
  CHECK(spindle.dynamics().natural_hz[0] > before_hz);
  CHECK(copy.dynamics().natural_hz[0] == before_hz);
  Spindle empty = copy;
  empty.elastic_base.reset();
  CHECK(models::locate_in_fields(&empty, models::detail::Binding<Spindle>::fields(), path) == nullptr);
  CHECK(empty.dynamics().natural_hz.empty());
}

TEST_CASE("safety clutch: stops and breaks per part follow the spikes", "[K204]") {
  GalleryExample<FaceMilling> example("face_milling_machine");
  auto& clutch = *example.file.machine_limits.safety_clutch;
  clutch.set_torque_nm = 420;
  clutch.spike_rate_per_min = 0.5;
  clutch.break_torque_nm = 700;
  const auto p = example.plan();
  REQUIRE(p.overload);
  const auto spike = models::k204::overload_spike_outcome(
      {.cutting_torque_nm = value_of(p, "cutting_torque_nm"),
       .spike_mean_ratio = clutch.spike_mean_ratio,
       .set_torque_nm = 420,
       .accuracy = clutch.accuracy,
       .dynamic_factor =
           models::k204::clutch_dynamic_factor({{clutch.clutch}, value_of(p, "spindle_speed_rpm")}).k_d,
       .break_torque_nm = 700});
  CHECK(p.overload->trips_per_part == Approx(0.5 * p.main_time_min * spike.p_trip_safe));
  CHECK(p.overload->trip_probability == Approx(1 - std::exp(-p.overload->trips_per_part)));
  CHECK(p.overload->breaks_per_part == Approx(0.5 * p.main_time_min * spike.p_break));
  CHECK(value_of(p, "overload_break_probability_no_clutch") > p.overload->break_probability);
  for (const Quantity& q : p.quantities)
    if (std::string_view(q.name).starts_with("overload_") && std::string_view(q.unit) == "1")
      CHECK_THAT(q.origin, Contains("K204.overload_spike_outcome"));
  CHECK_THAT(p.overload->origin, Contains("K204.overload_spike_outcome"));

  // The setting with the least expected cost: none of many others is cheaper.
  const double best_nm = optimal_setting_nm(clutch, p, 4, 300);
  const auto cost = [&](double set_nm) {
    clutch.set_torque_nm = set_nm;
    const auto planned = example.plan();
    return 4 * planned.overload->trips_per_part + 300 * planned.overload->breaks_per_part;
  };
  const double least = cost(best_nm);
  for (double set_nm = 260; set_nm < 700; set_nm += 5) CHECK(cost(set_nm) >= least * (1 - 1e-9));

  // Drift lowers the setting: more stops of the same work.
  clutch.set_torque_nm = 420;
  clutch.stability = 0.9;
  clutch.trips = 100;
  CHECK(example.plan().overload->trips_per_part > p.overload->trips_per_part);
  // A clutch of polygon slots does not close by itself above 170 rpm.
  clutch.clutch = models::k204::Clutch::ball_triangle;
  CHECK_FALSE(example.plan().overload->self_reset);
  CHECK(example.plan().overload->reset_min > p.overload->reset_min);
  clutch.shaft_speed_rpm = 100;
  CHECK(example.plan().overload->self_reset);

  // No torque known, no overload; a spindle beyond the tested speeds must name the clutch's shaft.
  auto silent = example.spec;
  silent.kc11_mpa.reset();
  CHECK_FALSE(example.Gallery::plan(silent).overload);
  clutch.shaft_speed_rpm.reset();
  auto fast = example.spec;
  fast.cutting_speed_m_min = 400;
  CHECK_THAT(refusal(fast, example.context()), Contains("shaft_speed_rpm"));
}
