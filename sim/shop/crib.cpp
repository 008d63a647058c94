#include "sim/shop/crib.h"

#include <limits>

#include "sim/shop/durations.h"

namespace verstat::shop {

InsertCrib::InsertCrib(sim::Simulation& sim, const scenarios::InsertStock& spec, const std::string& insert,
                       std::uint64_t seed, std::uint64_t replication)
    : sim_(&sim),
      spec_(&spec),
      shelf_(sim, std::numeric_limits<double>::infinity(), static_cast<double>(spec.stock), insert),
      lead_time_(law_of(spec.lead_time)),
      lead_stream_(seed, insert, "lead time", replication),
      position_(spec.stock),
      mean_stock_(0.0, static_cast<double>(spec.stock)) {
  reset_counts();
}

void InsertCrib::reset_counts() {
  counts_ = Counts{.stock_at_start = stock()};
  mean_stock_.reset(sim_->now());
}

bool InsertCrib::would_wait(std::int64_t inserts) const {
  return shelf_.waiting_to_get() > 0 || stock() < inserts;
}

sim::Task<void> InsertCrib::issue(std::int64_t inserts) {
  ++counts_.requests;
  if (would_wait(inserts)) ++counts_.stock_outs;
  position_ -= inserts;
  if (position_ <= spec_->reorder_point) {
    const std::int64_t quantity = spec_->order_quantity;
    const std::int64_t ordered = ((spec_->reorder_point - position_) / quantity + 1) * quantity;
    position_ += ordered;
    const double lead_min = lead_time_.sample(lead_stream_);
    sim_->spawn("delivery", deliver(ordered, lead_min));
  }
  co_await shelf_.get(static_cast<double>(inserts));
  counts_.issued += inserts;
  mean_stock_.set(sim_->now(), shelf_.level());
}

sim::Task<void> InsertCrib::deliver(std::int64_t inserts, double lead_min) {
  co_await sim_->delay(lead_min);
  co_await shelf_.put(static_cast<double>(inserts));
  counts_.delivered += inserts;
  mean_stock_.set(sim_->now(), shelf_.level());
}

}  // namespace verstat::shop
