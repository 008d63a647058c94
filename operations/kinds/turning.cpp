#include "operations/kinds/turning.h"

#include <numbers>

#include "models/reliability/k117_rational_reliability.h"
#include "operations/fields.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::Turning> {
  static std::vector<Field> fields() {
    using S = operations::Turning;
    return {need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 1e5), "diameter of the cut"),
            need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e6), "length of the cut"),
            may<S>(&S::passes, "passes", "1", closed(1, 10'000), "number of passes"),
            need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e5),
                    "cutting speed v_c"),
            need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-4, 100), "feed f"),
            need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(1e-4, 1000), "depth of cut a_p")};
  }
};

namespace verstat::operations {

CutPlan plan(const Turning& spec, const PlanContext& context) {
  models::k117::TurningPass pass;
  pass.diameter_mm = spec.diameter_mm;
  pass.length_mm = spec.length_mm;
  pass.passes = static_cast<double>(spec.passes);
  pass.speed_m_min = spec.cutting_speed_m_min;
  pass.feed_mm_rev = spec.feed_mm_rev;

  CutPlan p;
  p.set_main_time(models::k117::machining_time_turning(pass).time_min, "K117.machining_time_turning");
  const double spindle_speed_rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  p.quantities.push_back({"spindle_speed_rpm", spindle_speed_rpm, "rpm", "definition", "spindle speed"});
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.depth_of_cut_mm);
  return p;
}

namespace turning {
void add_to(Kinds& kinds) {
  kinds.add<Turning>("A cylinder turned lengthwise in passes.", {"K117"});
}
}  // namespace turning

}  // namespace verstat::operations
