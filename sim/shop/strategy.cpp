#include "sim/shop/strategy.h"

#include <cmath>
#include <limits>

namespace verstat::shop {
namespace {

class RunToFailure final : public Strategy {
 public:
  [[nodiscard]] double cutting_to_change_min(const ToolView&) const override {
    return std::numeric_limits<double>::infinity();
  }
};

// Change at the gamma-percent life of the edge (K117 section E).
class AgeReplacement final : public Strategy {
 public:
  explicit AgeReplacement(double limit) : limit_(limit) {}
  [[nodiscard]] double cutting_to_change_min(const ToolView& tool) const override {
    return (limit_ - tool.edge_wear) * tool.mean_life_min;
  }

 private:
  double limit_;  // in mean lives
};

// Change after as many whole parts as fit into the gamma-percent life; inside the part when not even one
// fits. The count is kept as cutting minutes of the edge, so that an edge fitted in the middle of a part
// after a failure is changed after the same cutting (K117 section E).
class PartCountReplacement final : public Strategy {
 public:
  explicit PartCountReplacement(double limit) : limit_(limit) {}
  [[nodiscard]] double cutting_to_change_min(const ToolView& tool) const override {
    const double limit_min = limit_ * tool.mean_life_min;
    const double parts = std::floor(limit_min / tool.main_time_min + 1e-12);
    const double age_min = parts >= 1 ? parts * tool.main_time_min : limit_min;
    return age_min - tool.edge_wear * tool.mean_life_min;
  }

 private:
  double limit_;
};

// Change every gamma-percent life of cutting, whatever the age of the edge in place.
class BlockReplacement final : public Strategy {
 public:
  explicit BlockReplacement(double limit) : limit_(limit) {}
  [[nodiscard]] double cutting_to_change_min(const ToolView& tool) const override {
    return (limit_ - tool.wear_since_plan) * tool.mean_life_min;
  }

 private:
  double limit_;
};

}  // namespace

std::unique_ptr<Strategy> make_strategy(const scenarios::Strategy& spec, const models::LifeLaw& unit_life) {
  struct Make {
    const models::LifeLaw& life;
    std::unique_ptr<Strategy> operator()(const scenarios::RunToFailure&) const {
      return std::make_unique<RunToFailure>();
    }
    std::unique_ptr<Strategy> operator()(const scenarios::AgeReplacement& s) const {
      return std::make_unique<AgeReplacement>(life.gamma_percent_life(s.gamma));
    }
    std::unique_ptr<Strategy> operator()(const scenarios::PartCountReplacement& s) const {
      return std::make_unique<PartCountReplacement>(life.gamma_percent_life(s.gamma));
    }
    std::unique_ptr<Strategy> operator()(const scenarios::BlockReplacement& s) const {
      return std::make_unique<BlockReplacement>(life.gamma_percent_life(s.gamma));
    }
  };
  return std::visit(Make{unit_life}, spec);
}

}  // namespace verstat::shop
