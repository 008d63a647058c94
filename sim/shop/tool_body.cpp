#include "sim/shop/tool_body.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verstat::shop {

using scenarios::LoadSharing;
using scenarios::ReplaceTeeth;

ToolBody::ToolBody(const scenarios::Tool& tool, const scenarios::Insert& insert, LotSource* lots,
                   std::uint64_t seed, const std::string& entity, std::uint64_t replication) {
  if (const auto* mill = std::get_if<scenarios::ReplaceAtFailedTeeth>(&tool.strategy)) mill_ = *mill;
  teeth_.reserve(static_cast<std::size_t>(tool.teeth));
  for (std::int64_t k = 0; k < tool.teeth; ++k)
    teeth_.push_back(
        {.insert = FittedInsert(insert, lots, seed,
                                k == 0 ? entity : fmt::format("{}/tooth {}", entity, k + 1), replication)});
}

ToolBody::Failure ToolBody::next_failure() const {
  Failure first;
  for (std::size_t k = 0; k < teeth_.size(); ++k) {
    const Tooth& tooth = teeth_[k];
    if (tooth.failed) continue;
    const double left = (tooth.insert.life() - tooth.insert.wear()) / tooth.load;
    if (left < first.wear_left) first = {left, k};
  }
  return first;
}

void ToolBody::spend(double mean_lives) {
  for (Tooth& tooth : teeth_)
    if (!tooth.failed) tooth.insert.spend(mean_lives * tooth.load);
  age_ += mean_lives;
  wear_since_plan_ += mean_lives;
}

void ToolBody::fail(std::size_t tooth) {
  teeth_[tooth].failed = true;
  ++failed_;
  share_load();
}

void ToolBody::break_off() {
  for (Tooth& tooth : teeth_) tooth.failed = true;
  failed_ = static_cast<std::int64_t>(teeth_.size());
  share_load();
}

void ToolBody::share_load() {
  const auto z = static_cast<std::int64_t>(teeth_.size());
  feed_factor_ = 1;
  for (Tooth& tooth : teeth_) tooth.load = 1;
  if (!mill_ || failed_ == 0 || failed_ == z) return;
  const double working = static_cast<double>(z - failed_);
  if (mill_->reduce_feed) {
    feed_factor_ = working / static_cast<double>(z);
    return;
  }
  if (mill_->load_sharing == LoadSharing::none) return;
  const double even = std::pow(static_cast<double>(z) / working, mill_->load_exponent);
  for (std::int64_t k = 0; k < z; ++k) {
    Tooth& tooth = teeth_[static_cast<std::size_t>(k)];
    if (mill_->load_sharing == LoadSharing::global) {
      tooth.load = even;
      continue;
    }
    std::int64_t pitches = 1;
    while (teeth_[static_cast<std::size_t>((k - pitches + z) % z)].failed) {
      if (pitches == z) break;
      ++pitches;
    }
    tooth.load = std::pow(static_cast<double>(pitches), mill_->load_exponent);
  }
}

double ToolBody::worst_share_of_life() const {
  double worst = 0;
  for (const Tooth& tooth : teeth_)
    if (!tooth.failed && tooth.insert.life() > 0)
      worst = std::max(worst, tooth.insert.wear() / tooth.insert.life());
  return worst;
}

double ToolBody::largest_wear() const {
  double largest = 0;
  for (const Tooth& tooth : teeth_)
    if (!tooth.failed) largest = std::max(largest, tooth.insert.wear());
  return largest;
}

std::int64_t ToolBody::edges_held() const {
  std::int64_t edges = 0;
  for (const Tooth& tooth : teeth_) edges += tooth.insert.edges_held();
  return edges;
}

std::int64_t ToolBody::decide_change(bool after_failure) {
  const ReplaceTeeth replace = mill_ ? mill_->replace : ReplaceTeeth::all;
  std::int64_t used_up = 0;
  for (Tooth& tooth : teeth_) {
    tooth.changed =
        !after_failure || tooth.failed || replace == ReplaceTeeth::all ||
        (replace == ReplaceTeeth::failed_and_older_than && tooth.insert.wear() >= mill_->older_than);
    if (!tooth.changed) continue;
    tooth.outlook = tooth.insert.after_this_edge(tooth.failed);
    if (tooth.outlook.next == FittedInsert::Next::used_up) ++used_up;
  }
  return used_up;
}

void ToolBody::change_made(bool after_failure) {
  const bool all = std::all_of(teeth_.begin(), teeth_.end(), [](const Tooth& t) { return t.changed; });
  for (Tooth& tooth : teeth_) {
    if (tooth.changed) tooth.failed = false;
    tooth.changed = false;
  }
  failed_ = std::count_if(teeth_.begin(), teeth_.end(), [](const Tooth& t) { return t.failed; });
  share_load();
  if (all) age_ = 0;
  if (!after_failure) wear_since_plan_ = 0;
  cut_since_inspection_min = 0;
  parts_since_inspection = 0;
}

}  // namespace verstat::shop
