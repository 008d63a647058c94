#include "sim/shop/edge.h"

namespace verstat::shop {

FittedInsert::FittedInsert(const scenarios::Insert& insert, std::uint64_t seed, const std::string& entity,
                           std::uint64_t replication)
    : insert_(&insert),
      unit_life_(insert.edge_life.law, 1.0, insert.edge_life.cv),
      life_stream_(seed, entity, "edge life", replication),
      reserve_stream_(seed, entity, "reserve edge", replication),
      single_edge_stream_(seed, entity, "single edge", replication) {
  fit_new();
}

void FittedInsert::draw_life() {
  wear_ = 0;
  life_ = unit_life_.quantile(life_stream_.uniform());
}

bool FittedInsert::turn_to_next_edge(bool after_failure) {
  // The draw comes first, used or not: variants of a shop stay in step.
  const bool reserve_ok = reserve_stream_.uniform() < insert_->reserve_ok_probability;
  if (edges_left_ == 0 || (after_failure && !reserve_ok)) return false;
  --edges_left_;
  draw_life();
  return true;
}

void FittedInsert::fit_new() {
  const bool single = single_edge_stream_.uniform() < insert_->single_edge_probability;
  edges_left_ = single ? 0 : insert_->edges - 1;
  draw_life();
}

}  // namespace verstat::shop
