#include "operations/kinds/ball_screw_grinding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::BallScrewGrinding> {
  static std::vector<Field> fields() {
    using S = operations::BallScrewGrinding;
    std::vector<Field> all{
        may<S>(&S::part, "part", "-", no_range(), "screw or nut"),
        need<S>(&S::center_radius_mm, "center_radius_mm", "mm", closed(0.1, 1000),
                "distance of the groove arc's centre from the part axis"),
        need<S>(&S::profile_radius_mm, "profile_radius_mm", "mm", closed(0.01, 100),
                "radius of the finished groove arc in the axial section"),
        need<S>(&S::lead_mm, "lead_mm", "mm", closed(0.1, 500), "lead, right hand"),
        need<S>(&S::thread_length_mm, "thread_length_mm", "mm", closed(0.1, 1e5), "length of the thread"),
        may<S>(&S::phi_max_deg, "phi_max_deg", "deg", closed(1, 60), "half angle of the groove arc"),
        need<S>(&S::stock_mm, "stock_mm", "mm", open_low(0, 10), "stock along the normal of the groove"),
        may<S>(&S::method, "method", "-", no_range(),
               "narrow wheel tilted more at every pass, or copying wheel as wide as the groove"),
        need<S>(&S::infeed_mm, "infeed_mm", "mm", closed(1e-4, 10), "infeed per pass"),
        may<S>(&S::sparkout_passes, "sparkout_passes", "1", closed(0, 1000), "passes without infeed"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "travel beyond the thread"),
        need<S>(&S::part_speed_rpm, "part_speed_rpm", "rpm", closed(0.01, 1e4), "speed of the part"),
        may<S>(&S::return_speed_ratio, "return_speed_ratio", "1", closed(0.1, 100),
               "return speed over working speed"),
        may<S>(&S::setting_time_min, "setting_time_min", "min", closed(0, 1000),
               "setting of infeed and tilt, per pass"),
        may<S>(&S::specific_energy_j_mm3, "specific_energy_j_mm3", "J/mm3", closed(0.1, 1000),
               "energy per removed volume; needed for the power"),
        need<S>(&S::wheel_outer_radius_mm, "wheel_outer_radius_mm", "mm", closed(0.1, 2000),
                "outer radius of the wheel"),
        need<S>(&S::wheel_profile_radius_mm, "wheel_profile_radius_mm", "mm", closed(0.01, 100),
                "radius of the wheel profile; copying: that of the groove"),
        need<S>(&S::wheel_width_mm, "wheel_width_mm", "mm", closed(0.01, 200),
                "width of the working profile"),
        may<S>(&S::wheel_speed_m_s, "wheel_speed_m_s", "m/s", closed(1, 500), "wheel speed"),
        may<S>(&S::wheel_arc, "wheel_arc", "-", no_range(),
               "dressed to a plain arc, or to the exact profile of the final settings"),
        may<S>(&S::grain_ratio, "grain_ratio", "1", closed(0.01, 1000),
               "grain trace widths over the reference width; 5 and more: dense wheel"),
        need<S>(&S::grinding_ratio, "grinding_ratio", "1", open_low(0, 1e6),
                "removed volume per worn wheel volume"),
        need<S>(&S::wear_limit_mm, "wear_limit_mm", "mm", closed(1e-5, 1),
                "wear at which the wheel is dressed"),
        may<S>(&S::dressing_time_min, "dressing_time_min", "min", closed(0, 1000),
               "time of one dressing, for the time with dressing"),
        may<S>(&S::form_error_max_um, "form_error_max_um", "um", closed(0, 1000),
               "largest form error of the finished groove"),
        may<S>(&S::tilt_max_deg, "tilt_max_deg", "deg", closed(0, 90), "largest tilt of the wheel head"),
        may<S>(&S::section_points, "section_points", "1", closed(5, 1001),
               "points of the section from which the form error is taken")};
    operations::append_dressing_law<S>(all);
    return all;
  }
};

namespace verstat::operations {

namespace {

namespace k203 = models::k203;
constexpr double deg_per_rad = 180 / std::numbers::pi;

bool is_nut(const BallScrewGrinding& s) {
  return s.part == ThreadPart::nut;
}

double groove_width_mm(const BallScrewGrinding& s) {
  return 2 * s.profile_radius_mm * std::sin(s.phi_max_deg / deg_per_rad);
}

void check(const BallScrewGrinding& s) {
  models::require(s.stock_mm < s.profile_radius_mm, "stock_mm", s.stock_mm,
                  "must be below profile_radius_mm");
  models::require(s.wheel_width_mm <= 2 * s.wheel_profile_radius_mm, "wheel_width_mm", s.wheel_width_mm,
                  "must not be above twice wheel_profile_radius_mm");
  models::require(s.wheel_profile_radius_mm < s.wheel_outer_radius_mm, "wheel_profile_radius_mm",
                  s.wheel_profile_radius_mm, "must be below wheel_outer_radius_mm");
  models::require(s.wear_limit_mm < s.wheel_profile_radius_mm, "wear_limit_mm", s.wear_limit_mm,
                  "must be below wheel_profile_radius_mm");
  if (s.method == k203::Method::copying) {
    models::require(s.wheel_profile_radius_mm == s.profile_radius_mm, "wheel_profile_radius_mm",
                    s.wheel_profile_radius_mm, "must be profile_radius_mm with the copying method");
    models::require(s.wheel_width_mm >= groove_width_mm(s) * (1 - 1e-9), "wheel_width_mm", s.wheel_width_mm,
                    "must cover the groove, 2 profile_radius_mm sin(phi_max_deg), with the copying method");
  } else {
    models::require(s.wheel_width_mm < groove_width_mm(s), "wheel_width_mm", s.wheel_width_mm,
                    "must be below the width of the groove with the narrow method");
  }
}

/// Radial way of the wheel that takes the stock off everywhere: a copying wheel reaches the normal depth on
/// the flanks only after stock / cos(phi_max), a narrow one follows equidistant arcs.
double infeed_path_mm(const BallScrewGrinding& s) {
  return s.method == k203::Method::narrow ? s.stock_mm
                                          : k203::plunge_length({s.stock_mm, s.phi_max_deg}).length_mm;
}

/// Settings of every working pass. A copying wheel keeps the tilt of the helix and only comes nearer.
k203::PassSchedule settings(const BallScrewGrinding& s) {
  k203::PassPlan in;
  in.groove_center_radius_mm = s.center_radius_mm;
  in.final_profile_radius_mm = s.profile_radius_mm;
  in.stock_mm = s.stock_mm;
  in.infeed_mm = s.infeed_mm;
  in.lead_mm = s.lead_mm;
  in.wheel_outer_radius_mm = s.wheel_outer_radius_mm;
  in.wheel_profile_radius_mm = s.wheel_profile_radius_mm;
  in.internal = is_nut(s) ? 1 : 0;
  if (s.method == k203::Method::narrow) return k203::pass_schedule(in);

  const double bottom_mm =
      is_nut(s) ? s.center_radius_mm + s.profile_radius_mm : s.center_radius_mm - s.profile_radius_mm;
  models::require(bottom_mm > 0, "profile_radius_mm", s.profile_radius_mm,
                  "must be below center_radius_mm on a screw");
  models::require(!is_nut(s) || s.wheel_outer_radius_mm < bottom_mm, "wheel_outer_radius_mm",
                  s.wheel_outer_radius_mm, "must be below the groove bottom radius of a nut");
  const double aligned_deg = -std::atan(s.lead_mm / (2 * std::numbers::pi) / bottom_mm) * deg_per_rad;
  const double path_mm = infeed_path_mm(s);
  const auto passes = static_cast<std::size_t>(steps_in(path_mm, s.infeed_mm));
  k203::PassSchedule schedule;
  for (std::size_t k = 1; k <= passes; ++k) {
    const double left_mm = std::max(0.0, path_mm - static_cast<double>(k) * s.infeed_mm);
    const double final_mm =
        is_nut(s) ? bottom_mm - s.wheel_outer_radius_mm : bottom_mm + s.wheel_outer_radius_mm;
    schedule.profile_radius_mm.push_back(s.profile_radius_mm);
    schedule.center_distance_mm.push_back(is_nut(s) ? final_mm - left_mm : final_mm + left_mm);
    schedule.tilt_deg.push_back(aligned_deg);
  }
  return schedule;
}

/// Form error of the groove that pass `k` leaves, mm.
double form_error_mm(const BallScrewGrinding& s, const k203::PassSchedule& schedule, std::size_t k,
                     double wheel_phi_deg) {
  if (s.wheel_arc == WheelArc::toroidal) {
    k203::SectionSampling in;
    in.wheel_center_radius_mm = s.wheel_outer_radius_mm - s.wheel_profile_radius_mm;
    in.wheel_profile_radius_mm = s.wheel_profile_radius_mm;
    in.lead_mm = s.lead_mm;
    in.center_distance_mm = schedule.center_distance_mm[k];
    in.tilt_deg = schedule.tilt_deg[k];
    in.internal = is_nut(s) ? 1 : 0;
    in.phi_max_deg = wheel_phi_deg;
    in.points = s.section_points;
    return k203::groove_profile_fit(in).form_error_mm;
  }
  k203::IntermediatePass in;
  in.center_radius_mm = s.center_radius_mm;
  in.profile_radius_mm = is_nut(s) ? s.profile_radius_mm : -s.profile_radius_mm;
  in.lead_mm = s.lead_mm;
  in.final_center_distance_mm = schedule.center_distance_mm.back();
  in.final_tilt_deg = schedule.tilt_deg.back();
  in.pass_center_distance_mm = schedule.center_distance_mm[k];
  in.pass_tilt_deg = schedule.tilt_deg[k];
  in.phi_max_deg = s.phi_max_deg;
  in.points = s.section_points;
  return k203::pass_form_error(in).form_error_mm;
}

}  // namespace

CutPlan plan(const BallScrewGrinding& s, const PlanContext& context) {
  check(s);
  // Half angle of the wheel's own arc: what it can touch of the groove at most.
  const double wheel_phi_deg =
      std::min(s.phi_max_deg,
               std::asin(std::min(1.0, s.wheel_width_mm / 2 / s.wheel_profile_radius_mm)) * deg_per_rad);
  const double profile_mm = is_nut(s) ? s.profile_radius_mm : -s.profile_radius_mm;
  const double path_mm = infeed_path_mm(s);
  const k203::PassSchedule schedule = settings(s);
  const std::size_t last = schedule.tilt_deg.size() - 1;

  k203::StockOnGroove stock;
  stock.center_radius_mm = s.center_radius_mm;
  stock.profile_radius_mm = profile_mm;
  stock.lead_mm = s.lead_mm;
  stock.thread_length_mm = s.thread_length_mm;
  stock.stock_mm = path_mm;
  stock.phi_max_deg = s.phi_max_deg;
  stock.scheme = s.method == k203::Method::narrow ? k203::Stock::concentric : k203::Stock::shifted;
  const auto removed = k203::removed_volume(stock);

  // The load per mm of wheel profile is the same for both methods in K203; a narrow wheel carries the groove
  // arc on its own, shorter one.
  const auto wear = k203::wheel_wear_per_part({s.stock_mm, removed.groove_length_mm, s.wheel_outer_radius_mm,
                                               s.grinding_ratio, s.wear_limit_mm, s.phi_max_deg, s.method});
  const double load_ratio = s.method == k203::Method::narrow ? s.phi_max_deg * s.profile_radius_mm /
                                                                   (wheel_phi_deg * s.wheel_profile_radius_mm)
                                                             : 1;
  const double dressings_per_part = wear.dressings_per_part * load_ratio;

  k203::GrindingPlan timing;
  timing.thread_length_mm = s.thread_length_mm;
  timing.lead_mm = s.lead_mm;
  timing.overrun_mm = s.overrun_mm;
  timing.stock_mm = path_mm;
  timing.infeed_mm = s.infeed_mm;
  timing.sparkout_passes = s.sparkout_passes;
  timing.part_speed_rpm = s.part_speed_rpm;
  timing.return_speed_ratio = s.return_speed_ratio;
  timing.setting_time_min = s.setting_time_min;
  timing.dressing_time_min = 0;  // the shop dresses the wheel when its element is worn
  timing.dressings_per_part = dressings_per_part;
  const auto time = k203::groove_grinding_time(timing);

  CutPlan p;
  p.quantities.reserve(20);
  p.set_main_time(time.time_min, "K203.groove_grinding_time");
  const double form_um = 1000 * form_error_mm(s, schedule, last, wheel_phi_deg);
  const double dressing_mm =
      k203::dressing_depth({s.wheel_profile_radius_mm, s.wear_limit_mm, 90 - wheel_phi_deg}).depth_mm;
  const auto abrasive = k203::dressing_volume({s.wheel_outer_radius_mm - s.wheel_profile_radius_mm,
                                               s.wheel_profile_radius_mm, s.wheel_width_mm, dressing_mm});
  const double traverse_m_min =
      removed.groove_length_mm / s.thread_length_mm * s.lead_mm * s.part_speed_rpm / 1000;
  k203::RemovalRegime regime;
  regime.wheel_center_radius_mm = s.wheel_outer_radius_mm - s.wheel_profile_radius_mm;
  regime.wheel_profile_radius_mm = s.wheel_profile_radius_mm;
  regime.wear_mm = 0;
  regime.phi_max_deg = wheel_phi_deg;
  regime.traverse_speed_m_min = traverse_m_min;
  regime.infeed_mm = std::min(s.infeed_mm, path_mm);
  regime.retreat_speed_mm_s = 0;
  regime.grain_ratio = s.grain_ratio;
  regime.scheme = stock.scheme;
  const auto rate = k203::grinding_removal_rate(regime);
  const double wheel_rpm = 30'000 * s.wheel_speed_m_s / (std::numbers::pi * s.wheel_outer_radius_mm);

  auto& q = p.quantities;
  q.push_back({"passes", static_cast<double>(time.passes), "1", "K203.groove_grinding_time",
               "passes with spark-out"});
  q.push_back({"infeed_path_mm", path_mm, "mm",
               s.method == k203::Method::narrow ? "given: stock" : "K203.plunge_length",
               "radial way of the wheel that takes the stock off"});
  q.push_back({"pass_time_min", time.pass_time_min, "min", "K203.groove_grinding_time",
               "working stroke without return"});
  q.push_back({"time_with_dressing_min", time.time_min + s.dressing_time_min * dressings_per_part, "min",
               "K203.groove_grinding_time", "time of a part with its share of dressing"});
  q.push_back({"first_tilt_deg", schedule.tilt_deg.front(), "deg",
               s.method == k203::Method::narrow ? "K203.pass_schedule" : "definition: along the helix",
               "tilt of the wheel axis in the first pass"});
  q.push_back({"tilt_deg", schedule.tilt_deg[last], "deg",
               s.method == k203::Method::narrow ? "K203.pass_schedule" : "definition: along the helix",
               "tilt of the wheel axis in the last pass"});
  q.push_back({"center_distance_mm", schedule.center_distance_mm[last], "mm", "K203.pass_schedule",
               "distance of the axes in the last pass"});
  const char* form_origin =
      s.wheel_arc == WheelArc::toroidal ? "K203.groove_profile_fit" : "K203.pass_form_error";
  q.push_back({"form_error_um", form_um, "um", form_origin, "form error of the finished groove"});
  if (last > 0)
    q.push_back({"form_error_before_last_um", 1000 * form_error_mm(s, schedule, last - 1, wheel_phi_deg),
                 "um", form_origin, "form error that the last but one pass leaves"});
  q.push_back({"groove_length_mm", removed.groove_length_mm, "mm", "K203.removed_volume",
               "length of the groove along the helix"});
  q.push_back({"removed_volume_mm3", removed.volume_mm3, "mm3", "K203.removed_volume", "metal removed"});
  q.push_back({"removal_rate_mm3_min", rate.q_mm3_min, "mm3/min", "K203.grinding_removal_rate",
               "removal rate of a freshly dressed wheel at full infeed"});
  q.push_back({"dressing_depth_mm", dressing_mm, "mm", "K203.dressing_depth",
               "depth that restores the worn profile"});
  q.push_back({"dressings_per_part", dressings_per_part, "1", "K203.wheel_wear_per_part",
               "dressings per part, on the arc that the wheel has"});
  q.push_back({"wheel_speed_rpm", wheel_rpm, "rpm", "definition", "speed of the wheel"});
  std::optional<double> power_kw;
  if (s.specific_energy_j_mm3) {
    power_kw = *s.specific_energy_j_mm3 * rate.q_mm3_min / 60'000;
    q.push_back(
        {"power_kw", *power_kw, "kW", "COMPLETION: specific energy times removal rate", "grinding power"});
  }

  p.limits.reserve(6);
  if (s.form_error_max_um)
    p.limits.push_back({"form_error_um", form_um, *s.form_error_max_um, true, "um", form_origin});
  if (s.tilt_max_deg) {
    double most_deg = 0;
    for (const double tilt_deg : schedule.tilt_deg) most_deg = std::max(most_deg, std::abs(tilt_deg));
    p.limits.push_back({"tilt_deg", most_deg, *s.tilt_max_deg, true, "deg", "K203.pass_schedule"});
  }
  add_machine_limits(p, context,
                     WheelLoad{.wheel_rpm = wheel_rpm,
                               .diameter_mm = 2 * s.wheel_outer_radius_mm,
                               .work_speed_m_min = traverse_m_min,
                               .infeed_mm = regime.infeed_mm,
                               .feed_rate_mm_min = s.lead_mm * s.part_speed_rpm,
                               .power_kw = power_kw});

  p.more_elements.push_back(dressing_life(s, time.time_min / dressings_per_part, "K203.wheel_wear_per_part"));
  p.consumables.push_back({"wheel_volume_mm3", dressings_per_part * abrasive.volume_mm3, "mm3",
                           "K203.dressing_volume", "abrasive lost by wear and dressing per part"});
  return p;
}

namespace ball_screw_grinding {
void add_to(Kinds& kinds) {
  kinds.add<BallScrewGrinding>("The groove of a ball screw or nut ground with crossed axes.", {"K203"});
}
}  // namespace ball_screw_grinding

}  // namespace verstat::operations
