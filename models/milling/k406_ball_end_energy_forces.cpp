#include "models/milling/k406_ball_end_energy_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/milling/ball_end_energy.h"

namespace verstat::models::k406 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

energy::Flow flow_of(const FlowScale& scale, double speed_m_min, double feed_mm) {
  return energy::flow(scale.vf_scale * speed_m_min * feed_mm, scale.stress_scale);
}

// arccos(1 - share), share = z/R0, without losing the digits of a small share.
double polar_angle(double share) {
  return 2 * std::asin(std::sqrt(std::min(1.0, share / 2)));
}

double mean_speed_m_min(double diameter, double rpm, double depth) {
  const double radius = diameter / 2;
  const double kappa = polar_angle(depth / radius);
  return 2 * pi * rpm * depth / kappa / 1000;  // R0 (1 - cos kappa) = depth
}

// The engaged edge cut into slices, with everything that does not turn with the tool.
class EngagedEdge {
 public:
  explicit EngagedEdge(const BallEndMill& in) : mill_(in) {
    require(in.depth_mm <= in.diameter_mm / 2, "a_p", in.depth_mm, "must not be above d/2");
    const double ball = in.diameter_mm / 2;
    const double kappa_end = polar_angle(in.depth_mm / ball);
    speed_ = mean_speed_m_min(in.diameter_mm, in.spindle_rpm, in.depth_mm);
    const energy::Flow state = flow_of(in, speed_, in.feed_mm_tooth);
    const double tan_helix = std::tan(in.helix_deg * degree);
    const auto count = static_cast<std::size_t>(in.slices);
    const double step = kappa_end / static_cast<double>(in.slices);
    edge_mm_ = ball * step;
    slices_.reserve(count);
    for (std::size_t j = 0; j < count; ++j) {
      const double kappa = (static_cast<double>(j) + 0.5) * step;
      Slice s{};
      s.sin_kappa = std::sin(kappa);
      s.cos_kappa = std::cos(kappa);
      s.radius_mm = ball * s.sin_kappa;
      s.lag = (1 - s.cos_kappa) * tan_helix;
      const auto k =
          energy::Edge(in.normal_rake_deg * degree, std::atan(s.sin_kappa * s.sin_kappa * tan_helix))
              .least_power(state);
      s.k_m = k.k_m;
      s.k_t = k.k_t;
      s.k_v = k.k_v;
      const double width =
          in.step_over_mm >= 2 * s.radius_mm ? pi : std::acos(1 - in.step_over_mm / s.radius_mm);
      s.from = in.mode == CutMode::down ? pi - width : 0;
      s.to = in.mode == CutMode::up ? width : pi;
      slices_.push_back(s);
    }
  }

  [[nodiscard]] double speed_m_min() const { return speed_; }

  // (C5), summed over teeth and slices, at a tool angle in radians.
  [[nodiscard]] BallEndForces at(double angle) const {
    BallEndForces sum{};
    const double teeth = static_cast<double>(mill_.teeth);
    for (std::int64_t q = 0; q < mill_.teeth; ++q) {
      const double tooth = angle + 2 * pi * static_cast<double>(q) / teeth;
      for (const Slice& s : slices_) {
        double psi = std::fmod(tooth - s.lag, 2 * pi);
        if (psi < 0) psi += 2 * pi;
        if (!(psi > s.from && psi < s.to)) continue;
        const double sine = std::sin(psi);
        const double cosine = std::cos(psi);
        const double thickness = mill_.feed_mm_tooth * sine * s.sin_kappa;
        const double along = (s.k_m * thickness + mill_.edge_force_m_n_mm) * edge_mm_;
        const double third = s.k_t * thickness * edge_mm_;
        const double away = (s.k_v * thickness + mill_.edge_force_v_n_mm) * edge_mm_;
        const double outward = third * s.cos_kappa - away * s.sin_kappa;
        sum.x_n += -along * cosine + outward * sine;
        sum.y_n += along * sine + outward * cosine;
        sum.z_n += third * s.sin_kappa + away * s.cos_kappa;
        sum.torque_nm += along * s.radius_mm / 1000;
      }
    }
    return sum;
  }

 private:
  struct Slice {
    double sin_kappa, cos_kappa, radius_mm, lag;
    double k_m, k_t, k_v;
    double from, to;  // engaged strictly between
  };
  BallEndMill mill_;
  double speed_ = 0;
  double edge_mm_ = 0;
  std::vector<Slice> slices_;
};

}  // namespace

CuttingState cutting_state(const StateInputs& in) {
  return guarded<&cutting_state>(in, [&] {
    const energy::Flow state = flow_of(in, in.cutting_speed_m_min, in.feed_mm);
    const double shear = state.shear_constant_deg + 0.375 * in.effective_rake_deg;
    return CuttingState{state.x, shear, state.shear_stress_mpa,
                        state.angle_sum_deg - shear + in.effective_rake_deg};
  });
}

EffectiveRake effective_rake(const ChipFlow& in) {
  return guarded<&effective_rake>(in, [&] {
    const double eta = in.flow_deg * degree;
    const energy::Edge edge(in.normal_rake_deg * degree, in.inclination_deg * degree);
    return EffectiveRake{std::asin(edge.sin_effective_rake(std::sin(eta), std::cos(eta))) / degree};
  });
}

AreaFactor shear_area_factor(const ShearFlow& in) {
  return guarded<&shear_area_factor>(in, [&] {
    const double eta = in.flow_deg * degree;
    const energy::Edge edge(in.normal_rake_deg * degree, in.inclination_deg * degree);
    const double rake = std::asin(edge.sin_effective_rake(std::sin(eta), std::cos(eta)));
    return AreaFactor{edge.area_factor(eta, rake, in.shear_angle_deg * degree)};
  });
}

SpecificEnergy specific_energy(const EnergyInputs& in) {
  return guarded<&specific_energy>(in, [&] {
    const energy::Flow state = flow_of(in, in.cutting_speed_m_min, in.feed_mm);
    const auto p = energy::Edge(in.normal_rake_deg * degree, in.inclination_deg * degree)
                       .power(state, in.flow_deg * degree);
    return SpecificEnergy{p.total(),
                          p.shear,
                          p.friction,
                          p.angles.effective_rake / degree,
                          p.angles.shear / degree,
                          p.angles.friction / degree,
                          state.shear_stress_mpa,
                          p.area_factor,
                          p.friction_area_factor};
  });
}

ObliqueForces oblique_specific_forces(const ObliqueInputs& in) {
  return guarded<&oblique_specific_forces>(in, [&] {
    const auto k = energy::Edge(in.normal_rake_deg * degree, in.inclination_deg * degree)
                       .least_power(flow_of(in, in.cutting_speed_m_min, in.feed_mm));
    return ObliqueForces{k.eta / degree,
                         k.angles.effective_rake / degree,
                         k.angles.shear / degree,
                         k.angles.friction / degree,
                         k.k_m,
                         k.k_t,
                         k.k_v,
                         k.k_f,
                         k.k_n,
                         k.valid};
  });
}

BallGeometry ball_geometry(const BallPoint& in) {
  return guarded<&ball_geometry>(in, [&] {
    const double ball = in.diameter_mm / 2;
    require(in.height_mm <= ball, "z", in.height_mm, "must not be above d/2");
    const double tan_helix = std::tan(in.helix_deg * degree);
    const double share = in.height_mm / ball;
    const double square = share * (2 - share);  // sin^2 kappa
    return BallGeometry{ball * std::sqrt(square), polar_angle(share) / degree,
                        std::atan(square * tan_helix) / degree, share * tan_helix / degree};
  });
}

MeanSpeed mean_edge_speed(const BallSpeed& in) {
  return guarded<&mean_edge_speed>(in, [&] {
    require(in.depth_mm <= in.diameter_mm / 2, "a_p", in.depth_mm, "must not be above d/2");
    return MeanSpeed{mean_speed_m_min(in.diameter_mm, in.spindle_rpm, in.depth_mm)};
  });
}

BallEndForces ball_end_forces_at(const BallEndMillAt& in) {
  return guarded<&ball_end_forces_at>(in, [&] { return EngagedEdge(in).at(in.angle_deg * degree); });
}

ForceSummary ball_end_force_summary(const BallEndMillTurn& in) {
  return guarded<&ball_end_force_summary>(in, [&] {
    const EngagedEdge edge(in);
    const double steps = static_cast<double>(in.steps);
    const double pitch = 2 * pi / static_cast<double>(in.teeth);
    ForceSummary sum{};
    for (std::int64_t k = 0; k < in.steps; ++k) {
      const BallEndForces f = edge.at((static_cast<double>(k) + 0.5) * pitch / steps);
      sum.x_peak_n = std::max(sum.x_peak_n, std::abs(f.x_n));
      sum.y_peak_n = std::max(sum.y_peak_n, std::abs(f.y_n));
      sum.z_peak_n = std::max(sum.z_peak_n, std::abs(f.z_n));
      sum.resultant_peak_n = std::max(sum.resultant_peak_n, std::hypot(f.x_n, f.y_n, f.z_n));
      sum.torque_peak_nm = std::max(sum.torque_peak_nm, std::abs(f.torque_nm));
      sum.x_mean_n += f.x_n / steps;
      sum.y_mean_n += f.y_n / steps;
      sum.z_mean_n += f.z_n / steps;
      sum.torque_mean_nm += f.torque_nm / steps;
    }
    sum.power_mean_kw = 2 * pi * in.spindle_rpm / 60 * sum.torque_mean_nm / 1000;
    sum.speed_m_min = edge.speed_m_min();
    return sum;
  });
}

InclinedSpeed inclined_ball_speed(const InclinedBall& in) {
  return guarded<&inclined_ball_speed>(in, [&] {
    require(in.depth_mm <= in.diameter_mm / 2, "a_p", in.depth_mm, "must not be above d/2");
    const double reach = polar_angle(2 * in.depth_mm / in.diameter_mm);
    const double diameter = in.diameter_mm * std::sin(std::min(in.surface_deg * degree + reach, pi / 2));
    return InclinedSpeed{diameter, pi * diameter * in.spindle_rpm / 1000};
  });
}

MachineForces rotate_forces(const ToolForces& in) {
  return guarded<&rotate_forces>(in, [&] {
    const double tilt = in.tilt_deg * degree;
    const double lead = in.lead_deg * degree;
    const double y = in.y_n * std::cos(tilt) - in.z_n * std::sin(tilt);
    const double z = in.y_n * std::sin(tilt) + in.z_n * std::cos(tilt);
    return MachineForces{in.x_n * std::cos(lead) + z * std::sin(lead), y,
                         -in.x_n * std::sin(lead) + z * std::cos(lead)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K406",
       .title = "Prediction of cutting forces in high-speed machining of a complex surface by ball-end mills "
                "through geometrical analysis",
       .authors = "Dobrotvorskiy S. S., Basova E. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Forces of a ball-end mill from the least cutting power: shear power on the shear area plus "
           "friction power on an effective friction area of an oblique edge, the chip-flow angle being the "
           "one with the least total; shear angle, shear stress and friction angle are fits for steel "
           "38KhM2YuA and high-speed steel tools.",
       .role = "milling",
       .errata = {
           "Equations (1)-(8) are lost in print and restored from the text.",
           "Eq. (17): cos i instead of sin i in the first term; the printed form gives 0 instead of the "
           "normal rake for a straight edge.",
           "The unit of x = V f in (14)-(16) is not as printed: m/min times m is the reading in which all "
           "three fits stay physical; vf_scale is an input.",
           "The transformations of eq. (25) are named but not given: geometry of the helical edge on the "
           "ball, immersion and rotation are completions."}});

  const auto scale = [](auto& f) {
    f.optional(&FlowScale::vf_scale, "vf_scale", "-", "1", positive(),
               "x = vf_scale v f (1/60000 is the alternative)")
        .optional(&FlowScale::stress_scale, "stress_scale", "-", "1", positive(),
                  "multiplies the shear stress");
  };
  const auto speed_and_feed = [](auto& f, auto v, auto feed) {
    f.input(v, "v", "V", "m/min", positive(), "cutting speed", 30.0)
        .input(feed, "f", "f", "mm", positive(), "feed per tooth", 0.1);
  };
  const auto rake = [](auto& f, auto member) {
    f.input(member, "alpha_n", "alpha_n", "deg", closed(-45, 45), "normal rake", 10.0);
  };
  const auto inclination = [](auto& f, auto member) {
    f.input(member, "inclination", "i", "deg", open(-80, 80), "inclination of the edge", 30.0);
  };
  const auto flow = [](auto& f, auto member) {
    f.input(member, "eta", "eta", "deg", open(-90, 90), "chip-flow angle", 15.0);
  };
  const auto mill = [&](auto& f) {
    f.optional(&BallEndMill::diameter_mm, "d", "d", "mm", positive(), "ball diameter")
        .optional(&BallEndMill::helix_deg, "helix", "i_0", "deg", open(-80, 80), "helix angle at the equator")
        .optional(&BallEndMill::teeth, "teeth", "z", "1", closed(1, 100), "number of teeth")
        .optional(&BallEndMill::normal_rake_deg, "alpha_n", "alpha_n", "deg", closed(-45, 45), "normal rake")
        .optional(&BallEndMill::spindle_rpm, "n", "n", "rpm", positive(), "spindle speed")
        .optional(&BallEndMill::feed_mm_tooth, "f_z", "f_z", "mm/tooth", positive(), "feed per tooth")
        .optional(&BallEndMill::depth_mm, "a_p", "a_p", "mm", positive(), "depth of cut, at most d/2")
        .optional(&BallEndMill::step_over_mm, "a_e", "a_e", "mm", positive(), "step-over")
        .optional(&BallEndMill::mode, "mode", "-", "-", no_range(), "climb (down), conventional (up) or slot")
        .with(scale)
        .optional(&BallEndMill::edge_force_m_n_mm, "k_em", "k_em", "N/mm", any(),
                  "edge force along the velocity")
        .optional(&BallEndMill::edge_force_v_n_mm, "k_ev", "k_ev", "N/mm", any(),
                  "edge force normal to the cut")
        .optional(&BallEndMill::slices, "slices", "-", "1", closed(1, 1000), "slices of the engaged edge");
  };
  const char* const level =
      "Without a calibrating measurement start with stress_scale 1.2-1.5 for alloy steel; fits are for HSS "
      "speeds.";

  source
      .function<&cutting_state>("cutting_state", "Shear angle, shear stress and friction angle.",
                                "eq. (14)-(16)", Provenance::repaired)
      .with([&](auto& f) { speed_and_feed(f, &StateInputs::cutting_speed_m_min, &StateInputs::feed_mm); })
      .input(&StateInputs::effective_rake_deg, "alpha_e", "alpha_e", "deg", open(-90, 90), "effective rake",
             10.0)
      .with(scale)
      .output(&CuttingState::x, "x", "x", "1", positive(), "scaled product of speed and feed")
      .output(&CuttingState::shear_angle_deg, "phi_e", "phi_e", "deg", any(), "effective shear angle")
      .output(&CuttingState::shear_stress_mpa, "tau", "tau", "N/mm2", positive(), "shear stress")
      .output(&CuttingState::friction_angle_deg, "beta", "beta", "deg", any(), "friction angle")
      .note("Physical up to about x = 0.06 (angles) and 0.02 (chip flow).");
  source
      .function<&effective_rake>("effective_rake", "Effective rake of an oblique edge.", "eq. (17)",
                                 Provenance::repaired)
      .with([&](auto& f) {
        rake(f, &ChipFlow::normal_rake_deg);
        inclination(f, &ChipFlow::inclination_deg);
        flow(f, &ChipFlow::flow_deg);
      })
      .output(&EffectiveRake::effective_rake_deg, "alpha_e", "alpha_e", "deg", closed(-90, 90),
              "effective rake");
  source
      .function<&shear_area_factor>("shear_area_factor", "Shear area per uncut thickness and edge length.",
                                    "completion (C1)", Provenance::completion)
      .with([&](auto& f) {
        rake(f, &ShearFlow::normal_rake_deg);
        inclination(f, &ShearFlow::inclination_deg);
        flow(f, &ShearFlow::flow_deg);
      })
      .input(&ShearFlow::shear_angle_deg, "phi_e", "phi_e", "deg", open(0, 180), "effective shear angle",
             22.0)
      .output(&AreaFactor::factor, "factor", "A_s/tL", "1", non_negative(), "shear area factor");
  source
      .function<&specific_energy>("specific_energy", "Specific cutting energy at a chip-flow angle.",
                                  "eq. (9)-(19)", Provenance::reconstructed)
      .with([&](auto& f) {
        speed_and_feed(f, &EnergyInputs::cutting_speed_m_min, &EnergyInputs::feed_mm);
        rake(f, &EnergyInputs::normal_rake_deg);
        inclination(f, &EnergyInputs::inclination_deg);
        flow(f, &EnergyInputs::flow_deg);
      })
      .with(scale)
      .output(&SpecificEnergy::total_n_mm2, "u", "U/(V t L)", "N/mm2", any(), "specific energy")
      .output(&SpecificEnergy::shear_n_mm2, "u_shear", "U_s/(V t L)", "N/mm2", any(), "share of shear")
      .output(&SpecificEnergy::friction_n_mm2, "u_friction", "U_m/(V t L)", "N/mm2", any(),
              "share of friction")
      .output(&SpecificEnergy::effective_rake_deg, "alpha_e", "alpha_e", "deg", any(), "effective rake")
      .output(&SpecificEnergy::shear_angle_deg, "phi_e", "phi_e", "deg", any(), "effective shear angle")
      .output(&SpecificEnergy::friction_angle_deg, "beta", "beta", "deg", any(), "friction angle")
      .output(&SpecificEnergy::shear_stress_mpa, "tau", "tau", "N/mm2", positive(), "shear stress")
      .output(&SpecificEnergy::area_factor, "area_factor", "A_s/tL", "1", any(), "shear area factor")
      .output(&SpecificEnergy::friction_area_factor, "friction_area_factor", "Q_m/tL", "1", any(),
              "friction area factor");
  source
      .function<&oblique_specific_forces>("oblique_specific_forces",
                                          "Specific forces at the least cutting power.", "eq. (20)-(24)",
                                          Provenance::reconstructed)
      .with([&](auto& f) {
        speed_and_feed(f, &ObliqueInputs::cutting_speed_m_min, &ObliqueInputs::feed_mm);
        rake(f, &ObliqueInputs::normal_rake_deg);
        inclination(f, &ObliqueInputs::inclination_deg);
      })
      .with(scale)
      .output(&ObliqueForces::flow_deg, "eta", "eta", "deg", closed(-60, 60), "chip-flow angle")
      .output(&ObliqueForces::effective_rake_deg, "alpha_e", "alpha_e", "deg", any(), "effective rake")
      .output(&ObliqueForces::shear_angle_deg, "phi_e", "phi_e", "deg", any(), "effective shear angle")
      .output(&ObliqueForces::friction_angle_deg, "beta", "beta", "deg", any(), "friction angle")
      .output(&ObliqueForces::k_m, "k_m", "k_M", "N/mm2", any(), "along the cutting velocity")
      .output(&ObliqueForces::k_t, "k_t", "k_T", "N/mm2", any(), "along the third axis")
      .output(&ObliqueForces::k_v, "k_v", "k_V", "N/mm2", any(), "normal to the cut surface")
      .output(&ObliqueForces::k_f, "k_f", "k_F", "N/mm2", any(), "friction on the rake")
      .output(&ObliqueForces::k_n, "k_n", "k_N", "N/mm2", any(), "normal to the rake")
      .output(&ObliqueForces::valid, "valid", "-", "-", no_range(), "the state is physical")
      .note(level);
  source
      .function<&ball_geometry>("ball_geometry", "Radius, inclination and lag of the edge on the ball.",
                                "completion (C2)", Provenance::completion)
      .input(&BallPoint::diameter_mm, "d", "d", "mm", positive(), "ball diameter", 10.0)
      .input(&BallPoint::helix_deg, "helix", "i_0", "deg", open(-80, 80), "helix angle at the equator", 30.0)
      .input(&BallPoint::height_mm, "z", "z", "mm", non_negative(), "height above the tip, at most d/2", 0.5)
      .output(&BallGeometry::radius_mm, "radius", "R", "mm", non_negative(), "radius of the section")
      .output(&BallGeometry::kappa_deg, "kappa", "kappa", "deg", closed(0, 90), "polar angle from the tip")
      .output(&BallGeometry::inclination_deg, "inclination", "i", "deg", open(-80, 80),
              "inclination of the edge")
      .output(&BallGeometry::lag_deg, "lag", "psi_0", "deg", any(), "lag behind the tip");
  source
      .function<&mean_edge_speed>("mean_edge_speed", "Mean speed of the engaged edge.", "completion (C3)",
                                  Provenance::completion)
      .input(&BallSpeed::diameter_mm, "d", "d", "mm", positive(), "ball diameter", 10.0)
      .input(&BallSpeed::spindle_rpm, "n", "n", "rpm", positive(), "spindle speed", 2000.0)
      .input(&BallSpeed::depth_mm, "a_p", "a_p", "mm", positive(), "depth of cut, at most d/2", 0.5)
      .output(&MeanSpeed::speed_m_min, "v_mean", "V", "m/min", positive(), "mean speed");
  source
      .function<&ball_end_forces_at>("ball_end_forces_at", "Forces and torque at a tool angle.",
                                     "completion (C2)-(C5)", Provenance::completion)
      .input(&BallEndMillAt::angle_deg, "angle", "W", "deg", any(), "angle of the tool", 150.0)
      .with(mill)
      .output(&BallEndForces::x_n, "f_x", "F_x", "N", any(), "force on the tool along the feed")
      .output(&BallEndForces::y_n, "f_y", "F_y", "N", any(), "force on the tool across the feed")
      .output(&BallEndForces::z_n, "f_z_force", "F_z", "N", any(), "force along the axis, away from the work")
      .output(&BallEndForces::torque_nm, "torque", "M", "N*m", any(), "torque")
      .note(level)
      .note("Runout, vibration and wear are not modelled; a surface normal to the tool axis is assumed.");
  source
      .function<&ball_end_force_summary>("ball_end_force_summary",
                                         "Peaks and means of forces, torque and power.",
                                         "completion (C2)-(C5)", Provenance::completion)
      .with(mill)
      .optional(&BallEndMillTurn::steps, "steps", "-", "1", closed(1, 10'000), "steps per tooth pitch")
      .output(&ForceSummary::x_peak_n, "f_x_peak", "F_x", "N", non_negative(), "largest magnitude")
      .output(&ForceSummary::y_peak_n, "f_y_peak", "F_y", "N", non_negative(), "largest magnitude")
      .output(&ForceSummary::z_peak_n, "f_z_peak", "F_z", "N", non_negative(), "largest magnitude")
      .output(&ForceSummary::resultant_peak_n, "resultant_peak", "F", "N", non_negative(),
              "largest resultant")
      .output(&ForceSummary::torque_peak_nm, "torque_peak", "M", "N*m", non_negative(), "largest torque")
      .output(&ForceSummary::x_mean_n, "f_x_mean", "F_x", "N", any(), "mean along the feed")
      .output(&ForceSummary::y_mean_n, "f_y_mean", "F_y", "N", any(), "mean across the feed")
      .output(&ForceSummary::z_mean_n, "f_z_mean", "F_z", "N", any(), "mean along the axis")
      .output(&ForceSummary::torque_mean_nm, "torque_mean", "M", "N*m", any(), "mean torque")
      .output(&ForceSummary::power_mean_kw, "power_mean", "N", "kW", any(), "mean power")
      .output(&ForceSummary::speed_m_min, "v_mean", "V", "m/min", positive(),
              "mean speed of the engaged edge")
      .note(level);
  source
      .function<&inclined_ball_speed>("inclined_ball_speed",
                                      "Effective diameter and speed on an inclined surface.",
                                      "completion (C6)", Provenance::completion)
      .input(&InclinedBall::diameter_mm, "d", "d", "mm", positive(), "ball diameter", 10.0)
      .input(&InclinedBall::spindle_rpm, "n", "n", "rpm", positive(), "spindle speed", 8000.0)
      .input(&InclinedBall::depth_mm, "a_p", "a_p", "mm", positive(), "depth of cut, at most d/2", 0.2)
      .input(&InclinedBall::surface_deg, "theta", "theta", "deg", closed(0, 90), "inclination of the surface",
             30.0)
      .output(&InclinedSpeed::diameter_mm, "d_eff", "d_eff", "mm", positive(), "effective diameter")
      .output(&InclinedSpeed::speed_m_min, "v_eff", "v_eff", "m/min", positive(), "effective speed");
  source
      .function<&rotate_forces>("rotate_forces", "Forces in the machine frame.", "completion (C7)",
                                Provenance::completion)
      .input(&ToolForces::x_n, "f_x", "F_x", "N", any(), "force along the tool's x", 50.0)
      .input(&ToolForces::y_n, "f_y", "F_y", "N", any(), "force along the tool's y", 80.0)
      .input(&ToolForces::z_n, "f_z", "F_z", "N", any(), "force along the tool's axis", 30.0)
      .input(&ToolForces::lead_deg, "lead", "-", "deg", any(), "rotation about y, after the tilt", 10.0)
      .input(&ToolForces::tilt_deg, "tilt", "-", "deg", any(), "rotation about x", 20.0)
      .output(&MachineForces::x_n, "f_x", "F_x", "N", any(), "force along the machine's x")
      .output(&MachineForces::y_n, "f_y", "F_y", "N", any(), "force along the machine's y")
      .output(&MachineForces::z_n, "f_z_force", "F_z", "N", any(), "force along the machine's z");
}

}  // namespace verstat::models::k406
