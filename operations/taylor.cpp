#include "operations/taylor.h"

#include "models/reliability/k117_rational_reliability.h"

namespace verstat::operations {

ElementLife taylor_life(const EdgeLife& edge, double cutting_speed_m_min, double feed_mm,
                        double depth_of_cut_mm) {
  models::k117::Regime regime;
  regime.speed_m_min = cutting_speed_m_min;
  regime.feed_mm_rev = feed_mm;
  regime.depth_mm = depth_of_cut_mm;
  regime.mean_ref_min = edge.mean_ref_min;
  regime.speed_ref_m_min = edge.cutting_speed_ref_m_min;
  regime.feed_ref_mm_rev = edge.feed_ref_mm_rev;
  regime.depth_ref_mm = edge.depth_of_cut_ref_mm;
  regime.mu = edge.speed_exponent;
  regime.feed_exponent = edge.feed_exponent;
  regime.depth_exponent = edge.depth_exponent;
  return {.element = "edge",
          .law = edge.law,
          .mean_min = models::k117::mean_life_for_regime(regime).mean_min,
          .cv = edge.cv,
          .origin = "K117.mean_life_for_regime"};
}

}  // namespace verstat::operations
