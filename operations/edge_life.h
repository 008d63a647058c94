#pragma once
// Extended Taylor life of one cutting edge: what a tool brings to an operation.

#include "models/math/life_law.h"

namespace verstat::operations {

/// Law and scatter of the life of one edge, its mean at a reference regime, and how speed, feed and depth
/// change it: mean = mean_ref (V_ref/V)^mu (S_ref/S)^(mu y) (t_ref/t)^(mu x). K117.
struct EdgeLife {
  models::LifeLawKind law = models::LifeLawKind::weibull;
  double cv = 0.7;
  double mean_ref_min = 60;
  double cutting_speed_ref_m_min = 60;
  double feed_ref_mm_rev = 1.0;
  double depth_of_cut_ref_mm = 10;
  double speed_exponent = 5;     ///< mu
  double feed_exponent = 0.45;   ///< y
  double depth_exponent = 0.15;  ///< x
};

}  // namespace verstat::operations
