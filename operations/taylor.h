#pragma once
#include "operations/cut_plan.h"
#include "operations/edge_life.h"

namespace verstat::operations {

/// Life of the tool's edge at a regime by the extended Taylor law, K117.mean_life_for_regime.
/// Speed m/min, feed mm/rev (or mm/tooth for teeth), depth mm, all > 0. Throws models::ModelError.
[[nodiscard]] ElementLife taylor_life(const EdgeLife& edge, double cutting_speed_m_min, double feed_mm,
                                      double depth_of_cut_mm);

}  // namespace verstat::operations
