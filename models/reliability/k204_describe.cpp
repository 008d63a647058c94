#include "models/reliability/k204_safety_clutch.h"

namespace verstat::models::k204 {
namespace {

Value numbers(std::initializer_list<double> values) {
  Value::List list;
  for (const double v : values) list.emplace_back(v);
  return list;
}

const auto clutch = [](auto& f) {
  f.input(&ClutchType::clutch, "clutch", "-", "-", no_range(), "type of the clutch", "cone");
};
// The optimum and the spike probabilities need a band of positive width.
const Range wide_accuracy = open_low(1, 1.5);

void describe_coefficients(Source& source) {
  source
      .function<&clutch_coefficients>("clutch_coefficients", "Published ranges of the coefficients.",
                                      "text after Fig. 6, conclusions", Provenance::paper)
      .with(clutch)
      .output(&ClutchCoefficients::accuracy_min, "k_accuracy_min", "K_T", "1", at_least(1), "accuracy, from")
      .output(&ClutchCoefficients::accuracy_max, "k_accuracy_max", "K_T", "1", at_least(1), "accuracy, to")
      .output(&ClutchCoefficients::sensitivity_min, "k_sensitivity_min", "K_ch", "1", open_low(0, 1),
              "sensitivity, from")
      .output(&ClutchCoefficients::sensitivity_max, "k_sensitivity_max", "K_ch", "1", open_low(0, 1),
              "sensitivity, to")
      .output(&ClutchCoefficients::stability_min, "k_stability_min", "K_s", "1", open_low(0, 1),
              "stability, from")
      .output(&ClutchCoefficients::stability_max, "k_stability_max", "K_s", "1", open_low(0, 1),
              "stability, to")
      .output(&ClutchCoefficients::frequency_min, "k_frequency_min", "K_chs", "1", positive(),
              "turns per re-engagement attempt, from")
      .output(&ClutchCoefficients::frequency_max, "k_frequency_max", "K_chs", "1", positive(),
              "turns per re-engagement attempt, to")
      .output(&ClutchCoefficients::auto_reengage_limit_rpm, "auto_reengage_limit_rpm", "-", "rpm",
              non_negative(), "highest speed of automatic re-engagement, 0 = no limit")
      .note("The tripping frequency of the cone clutch is not published; returned as 1.");
  source
      .function<&clutch_dynamic_factor>("clutch_dynamic_factor",
                                        "Peak torque at a trip over the static trip torque.",
                                        "text after Fig. 6", Provenance::completion)
      .with(clutch)
      .input(&ClutchSpeed::speed_rpm, "speed_rpm", "n", "rpm", closed(0, 600), "speed", 230.0)
      .output(&DynamicFactor::k_d, "k_d", "K_d", "1", at_least(1), "dynamic factor")
      .note(
          "Published points; interpolation, the point (0, 1) and extrapolation to 600 rpm are completions.");
  source
      .function<&clutch_dynamic_factor_inertial>("clutch_dynamic_factor_inertial",
                                                 "Dynamic factor from inertia and stiffness of the drive.",
                                                 "completion", Provenance::completion)
      .input(&InertialDrive::speed_rpm, "speed_rpm", "n", "rpm", non_negative(), "speed", 400.0)
      .input(&InertialDrive::trip_torque_nm, "trip_torque_nm", "T", "N*m", positive(), "static trip torque",
             42.0)
      .input(&InertialDrive::inertia_kg_m2, "inertia_kg_m2", "J", "kg*m2", positive(), "blocked inertia",
             0.02)
      .input(&InertialDrive::torsional_stiffness_nm_rad, "torsional_stiffness_nm_rad", "c", "N*m/rad",
             positive(), "torsional stiffness", 4.228)
      .output(&DynamicFactor::k_d, "k_d", "K_d", "1", at_least(1), "dynamic factor");
  const auto setting = [](auto& f, auto torque) {
    f.input(torque, "set_torque_nm", "T", "N*m", positive(), "set torque", 42.0);
  };
  source
      .function<&clutch_trip_band>("clutch_trip_band", "Band of the trip torque.", "definition of K_T",
                                   Provenance::completion)
      .with([&](auto& f) { setting(f, &Setting::set_torque_nm); })
      .input(&Setting::accuracy, "k_accuracy", "K_T", "1", at_least(1), "accuracy", 1.15)
      .output(&TripBand::t_min_nm, "t_min_nm", "T_min", "N*m", positive(), "least trip torque")
      .output(&TripBand::t_max_nm, "t_max_nm", "T_max", "N*m", positive(), "greatest trip torque")
      .output(&TripBand::t_mean_nm, "t_mean_nm", "T", "N*m", positive(), "mean trip torque")
      .output(&TripBand::sigma_nm, "sigma_nm", "sigma", "N*m", non_negative(), "standard deviation");
  source
      .function<&clutch_set_torque_drift>("clutch_set_torque_drift", "Setting after a number of trips.",
                                          "definition of K_s", Provenance::completion)
      .with([&](auto& f) { setting(f, &DriftInputs::set_torque_nm); })
      .input(&DriftInputs::stability, "k_stability", "K_s", "1", open_low(0, 1), "stability", 0.96)
      .input(&DriftInputs::trips, "trips", "N", "1", non_negative(), "trips so far", 50)
      .optional(&DriftInputs::reference_trips, "reference_trips", "N_ref", "1", positive(),
                "trips of the stability test; not stated in the paper")
      .output(&SetTorque::set_torque_nm, "set_torque_nm", "T", "N*m", non_negative(), "set torque");
  source
      .function<&clutch_reengage_torque>("clutch_reengage_torque",
                                         "Torque below which the clutch re-engages.", "definition of K_ch",
                                         Provenance::completion)
      .with([&](auto& f) { setting(f, &SensitivityInputs::set_torque_nm); })
      .input(&SensitivityInputs::sensitivity, "k_sensitivity", "K_ch", "1", open_low(0, 1), "sensitivity",
             0.98)
      .output(&ReengageTorque::reengage_torque_nm, "reengage_torque_nm", "-", "N*m", positive(),
              "re-engagement torque");
}

void describe_setting(Source& source) {
  const auto torques = [](auto& f, auto work, auto allowed) {
    f.input(work, "work_peak_torque_nm", "T_work", "N*m", positive(), "peak working torque", 28.0)
        .input(allowed, "allowable_torque_nm", "T_allow", "N*m", positive(), "torque that the drive bears",
               55.0);
  };
  const auto drift = [](auto& f, auto pointer) {
    f.input(pointer, "drift_factor", "D", "1", open_low(0, 1),
            "share of the setting left at the end of the re-adjustment interval", 0.96);
  };
  source
      .function<&clutch_setting_window>("clutch_setting_window",
                                        "Settings without false trips and with the drive protected.",
                                        "equation (e)", Provenance::completion)
      .with([&](auto& f) {
        torques(f, &WindowInputs::work_peak_torque_nm, &WindowInputs::allowable_torque_nm);
      })
      .input(&WindowInputs::accuracy, "k_accuracy", "K_T", "1", at_least(1), "accuracy", 1.17)
      .input(&WindowInputs::dynamic_factor, "k_d", "K_d", "1", at_least(1), "dynamic factor", 1.27)
      .with([&](auto& f) { drift(f, &WindowInputs::drift_factor); })
      .output(&SettingWindow::set_min_nm, "set_min_nm", "-", "N*m", positive(), "least setting")
      .output(&SettingWindow::set_max_nm, "set_max_nm", "-", "N*m", positive(), "greatest setting")
      .output(&SettingWindow::feasible, "feasible", "-", "-", closed(0, 1), "the window is not empty")
      .output(&SettingWindow::required_overload_ratio, "required_overload_ratio", "-", "1", at_least(1),
              "least ratio of allowable to working torque");
  source
      .function<&clutch_max_speed>("clutch_max_speed", "Highest speed with a setting that protects.",
                                   "equation (e)", Provenance::completion)
      .with(clutch)
      .with([&](auto& f) {
        torques(f, &MaxSpeedInputs::work_peak_torque_nm, &MaxSpeedInputs::allowable_torque_nm);
      })
      .input(&MaxSpeedInputs::accuracy, "k_accuracy", "K_T", "1", at_least(1), "accuracy", 1.17)
      .with([&](auto& f) { drift(f, &MaxSpeedInputs::drift_factor); })
      .output(&MaxSpeed::speed_rpm, "speed_rpm", "n", "rpm", closed(0, 600), "highest speed, 0 if none")
      .note("Says nothing about automatic re-engagement.");
  const auto cut = [](auto& f, auto torque, auto ratio) {
    f.input(torque, "cutting_torque_nm", "T_c", "N*m", positive(), "working torque", 25.0)
        .input(ratio, "spike_mean_ratio", "s", "1", closed(0.05, 2),
               "mean height of a spike over the working torque", 0.4);
  };
  source
      .function<&overload_spike_outcome>("overload_spike_outcome",
                                         "Probabilities that a torque spike trips the clutch or breaks.",
                                         "equation (f)", Provenance::completion)
      .with([&](auto& f) { cut(f, &SpikeInputs::cutting_torque_nm, &SpikeInputs::spike_mean_ratio); })
      .input(&SpikeInputs::set_torque_nm, "set_torque_nm", "T", "N*m", positive(), "set torque", 42.0)
      .input(&SpikeInputs::accuracy, "k_accuracy", "K_T", "1", wide_accuracy, "accuracy", 1.15)
      .input(&SpikeInputs::dynamic_factor, "k_d", "K_d", "1", at_least(1), "dynamic factor", 1.27)
      .input(&SpikeInputs::break_torque_nm, "break_torque_nm", "T_b", "N*m", positive(),
             "torque that breaks the weakest of tool, gearbox and spindle", 50.0)
      .output(&SpikeOutcome::p_trip, "p_trip", "P_trip", "1", probability(), "the clutch trips")
      .output(&SpikeOutcome::p_trip_safe, "p_trip_safe", "-", "1", probability(),
              "the clutch trips and nothing breaks")
      .output(&SpikeOutcome::p_break, "p_break", "P_break", "1", probability(), "something breaks")
      .output(&SpikeOutcome::p_break_no_clutch, "p_break_no_clutch", "P_break,0", "1", probability(),
              "something would break without a clutch")
      .note(
          "Spikes are exponential, the threshold normal; a threshold truncated to its band changes the "
          "probabilities by at most 0.003.");
  source
      .function<&optimal_clutch_setting>("optimal_clutch_setting",
                                         "Setting with the least expected cost per spike.", "equation (h)",
                                         Provenance::completion)
      .with([&](auto& f) { cut(f, &OptimumInputs::cutting_torque_nm, &OptimumInputs::spike_mean_ratio); })
      .input(&OptimumInputs::accuracy, "k_accuracy", "K_T", "1", wide_accuracy, "accuracy", 1.15)
      .input(&OptimumInputs::dynamic_factor, "k_d", "K_d", "1", at_least(1), "dynamic factor", 1.27)
      .input(&OptimumInputs::break_torque_nm, "break_torque_nm", "T_b", "N*m", positive(),
             "torque that breaks, above T_c (1 + K_T) / 2", 60.0)
      .input(&OptimumInputs::trip_cost, "trip_cost", "-", "cu", non_negative(), "cost of a trip", 4.0)
      .input(&OptimumInputs::break_cost, "break_cost", "-", "cu", non_negative(), "cost of a break", 90.0)
      .output(&OptimalSetting::set_torque_nm, "set_torque_nm", "T", "N*m", positive(), "set torque")
      .output(&OptimalSetting::cost_per_spike, "cost_per_spike", "-", "cu", non_negative(),
              "expected cost per spike")
      .note("An optimum at the break torque means that the clutch does not pay.");
}

void describe_events(Source& source) {
  source
      .function<&clutch_cost_rate>("clutch_cost_rate", "Trips, breaks, cost and availability.",
                                   "equation (g)", Provenance::completion)
      .input(&CostRateInputs::spike_rate_per_min, "spike_rate_per_min", "lambda", "1/min", non_negative(),
             "spikes per minute of cutting", 0.02)
      .input(&CostRateInputs::p_trip_safe, "p_trip_safe", "-", "1", probability(),
             "probability of a trip without a break", 0.18)
      .input(&CostRateInputs::p_break, "p_break", "P_break", "1", probability(), "probability of a break",
             0.01)
      .input(&CostRateInputs::trip_cost, "trip_cost", "-", "cu", non_negative(), "cost of a trip", 4.0)
      .input(&CostRateInputs::break_cost, "break_cost", "-", "cu", non_negative(), "cost of a break", 90.0)
      .input(&CostRateInputs::trip_downtime_min, "trip_downtime_min", "-", "min", non_negative(),
             "downtime of a trip", 3.0)
      .input(&CostRateInputs::break_downtime_min, "break_downtime_min", "-", "min", non_negative(),
             "downtime of a break", 45.0)
      .output(&CostRate::trips_per_min, "trips_per_min", "-", "1/min", non_negative(),
              "trips per minute of cutting")
      .output(&CostRate::breaks_per_min, "breaks_per_min", "-", "1/min", non_negative(),
              "breaks per minute of cutting")
      .output(&CostRate::cost_per_cut_min, "cost_per_cut_min", "-", "cu/min", non_negative(),
              "cost per minute of cutting")
      .output(&CostRate::availability, "availability", "-", "1", probability(), "availability");
  source
      .function<&torque_growth_trip_time>("torque_growth_trip_time",
                                          "Cutting time until growing torque trips the clutch.",
                                          "equation (i)", Provenance::completion)
      .input(&GrowthInputs::initial_torque_nm, "initial_torque_nm", "T_0", "N*m", positive(),
             "torque of the sharp tool", 30.0)
      .input(&GrowthInputs::torque_growth_per_min, "torque_growth_per_min", "g", "1/min", positive(),
             "relative growth per minute of cutting", 0.01)
      .input(&GrowthInputs::set_torque_nm, "set_torque_nm", "T", "N*m", positive(), "set torque", 42.0)
      .input(&GrowthInputs::accuracy, "k_accuracy", "K_T", "1", at_least(1), "accuracy", 1.15)
      .output(&GrowthTripTime::t_first_min, "t_first_min", "-", "min", non_negative(), "earliest trip")
      .output(&GrowthTripTime::t_mean_min, "t_mean_min", "-", "min", non_negative(), "mean trip")
      .output(&GrowthTripTime::t_last_min, "t_last_min", "-", "min", non_negative(), "latest trip");
  source
      .function<&clutch_stop_event>("clutch_stop_event", "Downtime and impacts of an overload stop.",
                                    "equation (j)", Provenance::completion)
      .with(clutch)
      .input(&StopInputs::speed_rpm, "speed_rpm", "n", "rpm", positive(), "speed", 230.0)
      .input(&StopInputs::overload_clear_min, "overload_clear_min", "-", "min", non_negative(),
             "until the torque has fallen below the re-engagement torque", 0.05)
      .input(&StopInputs::detect_min, "detect_min", "-", "min", non_negative(),
             "until somebody sees the open clutch", 0.5)
      .input(&StopInputs::manual_reset_min, "manual_reset_min", "-", "min", non_negative(), "manual reset",
             4.0)
      .input(&StopInputs::restart_min, "restart_min", "-", "min", non_negative(),
             "run-up and return to the cut", 0.3)
      .input(&StopInputs::frequency, "k_frequency", "K_chs", "1", positive(),
             "turns per re-engagement attempt", 1.0)
      .output(&StopEvent::auto_reengage, "auto_reengage", "-", "-", closed(0, 1),
              "the clutch re-engages by itself")
      .output(&StopEvent::downtime_min, "downtime_min", "-", "min", non_negative(), "downtime")
      .output(&StopEvent::impacts, "impacts", "-", "1", at_least(0), "impacts while slipping")
      .note("The limit of 170 rpm for polygon slots is published.");
  const auto series = [](auto& f, auto pointer, const char* name, Range range, const char* meaning,
                         Value example) {
    f.input(pointer, name, "-", range.low_open ? "N*m" : "1", range, meaning, std::move(example))
        .length(1, 100'000);
  };
  source
      .function<&clutch_test_metrics>("clutch_test_metrics", "Coefficients of an own test series.",
                                      "equation (l)", Provenance::completion)
      .with([&](auto& f) {
        series(f, &TestSeries::static_trip_nm, "static_trip_nm", positive(), "static trip torques",
               numbers({40, 42, 44}));
        series(f, &TestSeries::dynamic_peak_nm, "dynamic_peak_nm", positive(), "peak torques when rotating",
               numbers({52, 53.3, 54.7}));
        series(f, &TestSeries::reengage_nm, "reengage_nm", positive(), "re-engagement torques",
               numbers({41, 41.4, 41.2}));
        series(f, &TestSeries::static_trip_after_nm, "static_trip_after_nm", positive(),
               "static trip torques after the series", numbers({40.3, 40.5, 40.2}));
        series(f, &TestSeries::idle_revolutions, "idle_revolutions", non_negative(),
               "turns between re-engagement attempts", numbers({1, 1, 1}));
      })
      .output(&TestMetrics::k_d, "k_d", "K_d", "1", positive(), "dynamic factor")
      .output(&TestMetrics::k_accuracy, "k_accuracy", "K_T", "1", at_least(1), "accuracy")
      .output(&TestMetrics::k_sensitivity, "k_sensitivity", "K_ch", "1", positive(), "sensitivity")
      .output(&TestMetrics::k_stability, "k_stability", "K_s", "1", positive(), "stability")
      .output(&TestMetrics::k_frequency, "k_frequency", "K_chs", "1", non_negative(),
              "turns per re-engagement attempt");
  source.function<&motor_torque>("motor_torque", "Torque of a motor.", "equation (k)", Provenance::completion)
      .input(&Motor::power_kw, "power_kw", "P", "kW", positive(), "power", 1.0)
      .input(&Motor::speed_rpm, "speed_rpm", "n", "rpm", positive(), "speed", 230.0)
      .output(&Torque::torque_nm, "torque_nm", "T", "N*m", positive(), "torque");
  source
      .function<&clutch_static_trip_torque>("clutch_static_trip_torque",
                                            "Static trip torque from spring and pocket.", "equation (k)",
                                            Provenance::completion)
      .input(&Pocket::spring_force_n, "spring_force_n", "F", "N", positive(), "spring force", 500.0)
      .input(&Pocket::element_radius_mm, "element_radius_mm", "R", "mm", positive(),
             "radius of the engaging elements", 50.0)
      .input(&Pocket::pocket_angle_deg, "pocket_angle_deg", "alpha", "deg", open(0, 90),
             "wall angle of the pocket from the plane of rotation", 50.0)
      .input(&Pocket::friction_coefficient, "friction_coefficient", "mu_f", "1", closed(0, 1),
             "friction coefficient", 0.1)
      .output(&StaticTrip::torque_nm, "torque_nm", "T", "N*m", positive(),
              "trip torque; null when self-locking")
      .output(&StaticTrip::self_locking, "self_locking", "-", "-", closed(0, 1), "the clutch never trips")
      .note("The paper does not say from which plane its 50-60 deg are measured.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K204",
       .title = "Research of drives of mechanical systems",
       .authors = "Hevko I. B.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Cone-pin and ball safety clutches in a drive: measured coefficients of dynamics, accuracy, "
                 "sensitivity, stability and tripping frequency, completed into the event of a drive stopped "
                 "by an overload: its rate, downtime, self-clearing and the chance that something breaks.",
       .role = "reliability",
       .errata = {
           "The dynamic factor of the round-slot clutch at 400 rpm is printed as 1.25 and as 1.15; 1.25 is "
           "used."}});
  describe_coefficients(source);
  describe_setting(source);
  describe_events(source);
}

}  // namespace verstat::models::k204
