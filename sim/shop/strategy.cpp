#include "sim/shop/strategy.h"

#include <cmath>
#include <limits>

#include "models/cutting/k106_cylindrical_rake_hard_turning.h"

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

// Nothing is planned; inspections find worn edges.
class ConditionBased final : public Strategy {
 public:
  explicit ConditionBased(double every_min) : every_min_(every_min) {}
  [[nodiscard]] double cutting_to_change_min(const ToolView&) const override {
    return std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double cutting_to_inspection_min(const ToolView& tool) const override {
    return every_min_ - tool.cut_since_inspection_min;
  }

 private:
  double every_min_;
};

// Age replacement; in the last share of the period any stop of the machine will do.
class Opportunistic final : public Strategy {
 public:
  Opportunistic(double limit, double window) : limit_(limit), joins_from_((1 - window) * limit) {}
  [[nodiscard]] double cutting_to_change_min(const ToolView& tool) const override {
    return (limit_ - tool.edge_wear) * tool.mean_life_min;
  }
  [[nodiscard]] bool joins_stop(const ToolView& tool) const override {
    return tool.edge_wear > 0 && tool.edge_wear >= joins_from_;
  }

 private:
  double limit_;
  double joins_from_;
};

}  // namespace

double share_of_life_shown(const scenarios::WearSign& sign) {
  if (const auto* share = std::get_if<scenarios::ShareOfLife>(&sign)) return share->share;
  const auto& growth = std::get<scenarios::ForceGrowth>(sign);
  using models::k106::HardTurning;
  using models::k106::Rake;
  // Ratios of forces do not depend on the regime.
  HardTurning cut{.speed_m_min = 60, .feed_mm_rev = 0.14, .depth_mm = 0.1};
  cut.rake = growth.cylindrical_rake ? Rake::cylindrical : Rake::flat;
  const double sharp_n = models::k106::hard_turning_forces(cut).p_y_n;
  cut.flank_wear_mm = growth.wear_limit_mm;
  const double factor_at_limit = models::k106::hard_turning_forces(cut).p_y_n / sharp_n;
  return (growth.factor - 1) / (factor_at_limit - 1);
}

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
    std::unique_ptr<Strategy> operator()(const scenarios::ReplaceAtFailedTeeth& s) const {
      if (!s.gamma) return std::make_unique<RunToFailure>();
      return std::make_unique<AgeReplacement>(life.gamma_percent_life(*s.gamma));
    }
    std::unique_ptr<Strategy> operator()(const scenarios::ConditionBased& s) const {
      return std::make_unique<ConditionBased>(s.every_min.value_or(std::numeric_limits<double>::infinity()));
    }
    std::unique_ptr<Strategy> operator()(const scenarios::Opportunistic& s) const {
      return std::make_unique<Opportunistic>(life.gamma_percent_life(s.gamma), s.window);
    }
  };
  return std::visit(Make{unit_life}, spec);
}

}  // namespace verstat::shop
