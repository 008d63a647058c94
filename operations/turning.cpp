#include "operations/turning.h"

#include "models/reliability/k117_rational_reliability.h"

namespace verstat::operations {

CutPlan plan(const Turning& turning, const EdgeLife& edge) {
  models::k117::TurningPass pass;
  pass.diameter_mm = turning.diameter_mm;
  pass.length_mm = turning.length_mm;
  pass.passes = static_cast<double>(turning.passes);
  pass.speed_m_min = turning.cutting_speed_m_min;
  pass.feed_mm_rev = turning.feed_mm_rev;

  models::k117::Regime regime;
  regime.speed_m_min = turning.cutting_speed_m_min;
  regime.feed_mm_rev = turning.feed_mm_rev;
  regime.depth_mm = turning.depth_of_cut_mm;
  regime.mean_ref_min = edge.mean_ref_min;
  regime.speed_ref_m_min = edge.cutting_speed_ref_m_min;
  regime.feed_ref_mm_rev = edge.feed_ref_mm_rev;
  regime.depth_ref_mm = edge.depth_of_cut_ref_mm;
  regime.mu = edge.speed_exponent;
  regime.feed_exponent = edge.feed_exponent;
  regime.depth_exponent = edge.depth_exponent;

  return {.main_time_min = models::k117::machining_time_turning(pass).time_min,
          .mean_life_min = models::k117::mean_life_for_regime(regime).mean_min};
}

}  // namespace verstat::operations
