#include "sim/shop/edge.h"

namespace verstat::shop {

FittedInsert::FittedInsert(const scenarios::Insert& insert, LotSource* lots, std::uint64_t seed,
                           const std::string& entity, std::uint64_t replication)
    : insert_(&insert),
      lots_(lots),
      unit_life_(insert.edge_life.law, 1.0, insert.edge_life.cv),
      life_stream_(seed, entity, "edge life", replication),
      reserve_stream_(seed, entity, "reserve edge", replication),
      single_edge_stream_(seed, entity, "single edge", replication) {
  fit_new();
}

void FittedInsert::draw_life() {
  wear_ = 0;
  life_ = unit_life_.quantile(life_stream_.uniform()) * lot_factor_ * regrind_factor_;
}

FittedInsert::Outlook FittedInsert::after_this_edge(bool after_failure) {
  // The draw comes first, used or not: variants of a shop stay in step.
  const bool reserve_ok = reserve_stream_.uniform() < insert_->reserve_ok_probability;
  const bool broken = after_failure && !reserve_ok;
  return {edges_left_ == 0 || broken ? Next::used_up : Next::edge, broken};
}

void FittedInsert::turn_to_next_edge() {
  --edges_left_;
  draw_life();
}

std::int64_t FittedInsert::fit_new() {
  const bool single = single_edge_stream_.uniform() < insert_->single_edge_probability;
  edges_left_ = single ? 0 : insert_->edges - 1;
  lot_factor_ = lots_ == nullptr ? 1 : lots_->next_life_factor();
  regrind_factor_ = 1;
  draw_life();
  return edges_held();
}

void FittedInsert::regrind(double life_factor) {
  edges_left_ = insert_->edges - 1;
  regrind_factor_ = life_factor;
  draw_life();
}

}  // namespace verstat::shop
