#pragma once
// Magnetic-abrasive treatment of indexable carbide inserts in a ring-type bath (K108): edge radius, hardness
// and roughness after a treatment time, and the settings that the authors recommend.
//
// Maiboroda, Dzhulii 2011. Experimental, the curves are lost: the time courses are completions around the
// printed end values.

#include <array>
#include <cstdint>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k108 {

/// fine: chopped cast-iron shot 200/100 um + diamond paste 3/2 + 2/1 um; coarse: shot 400/315 + paste 14/10.
enum class Mixture { fine, coarse };

struct Stages {
  std::int64_t stages = 0;
  double stage_time_s = 0;
};
struct TreatmentTime {
  double total_min;
};
/// Time of a treatment in equal stages. K108, description of the experiments.
[[nodiscard]] TreatmentTime treatment_time(const Stages& in);

struct MixtureChoice {
  Mixture mixture = Mixture::fine;
};
struct Roughness {
  double ra_um;
};
/// Roughness Ra at which the faces settle: the middle of the printed 0.06-0.07 (fine) or 0.10-0.11 um
/// (coarse).
[[nodiscard]] Roughness final_roughness(const MixtureChoice& in);

struct Setting {
  double tilt_deg = 0;
  double turn_deg = 0;
  Mixture mixture = Mixture::fine;
};
struct SettingVerdict {
  bool angles_ok;
  bool mixture_ok;
};
/// Whether a setting is the recommended one: mandrel angles p and q both 20..30 deg, ends included, and the
/// fine mixture. K108, conclusions.
[[nodiscard]] SettingVerdict recommended_setting(const Setting& in);

struct CarrierMotion {
  double speed_m_s = 0;
  double speed_rpm = 0;
};
struct RingRadius {
  double radius_mm;
};
/// Radius of the ring bath from the linear speed > 0 and the speed of the carrier > 0. K108 (C1), COMPLETION.
[[nodiscard]] RingRadius ring_radius(const CarrierMotion& in);

struct TreatedFace {
  double time_s = 0;
  double ra_initial_um = 0;
  Mixture mixture = Mixture::fine;
};
/// Roughness after a time, exponential towards the final one with 95 % of the change at the printed settling
/// time of 200 s. K108 (C2), COMPLETION. A face smoother than the final level becomes rougher.
[[nodiscard]] Roughness roughness_after(const TreatedFace& in);

struct HardeningTime {
  double time_s = 0;
};
struct HardnessFactor {
  double factor;
};
/// Hardness over initial hardness after 0..480 s, 1 + 0.135 (1 - exp(-3 t / 120)). K108 (C3), COMPLETION: the
/// printed final +13-14 %; the printed wave before it is not modelled.
[[nodiscard]] HardnessFactor hardness_factor(const HardeningTime& in);

struct EdgeTreatment {
  double time_s = 0;
  double initial_um = 0;
  double rate_um_s = 0;
  double break_s = 0;
  double slow_factor = 1;
};
struct EdgeRadius {
  double radius_um;
};
/// Edge radius growing at a rate > 0, from t_break on at slow_factor (0..1) of it. K108 (C4), COMPLETION. The
/// rates are the user's: fine uniform (1), coarse slower after 300-360 s.
[[nodiscard]] EdgeRadius edge_radius_after(const EdgeTreatment& in);

struct EdgeTarget {
  double target_um = 0;
  double initial_um = 0;
  double rate_um_s = 0;
  double break_s = 0;
  double slow_factor = 1;
};
struct EdgeTime {
  double time_s;
};
/// Time to reach an edge radius, 0 when already reached. Inverse of (C4). Error when slow_factor is 0 and the
/// target lies above the radius at t_break.
[[nodiscard]] EdgeTime time_for_edge_radius(const EdgeTarget& in);

}  // namespace verstat::models::k108

template <>
struct verstat::models::EnumNames<verstat::models::k108::Mixture> {
  static constexpr std::array names{std::pair{k108::Mixture::fine, "fine"},
                                    std::pair{k108::Mixture::coarse, "coarse"}};
};
