#include "operations/kinds/duration.h"

#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::operations::PlainOperation> {
  static std::vector<Field> fields() {
    using S = operations::PlainOperation;
    return {need<S>(&S::time, "time", "min", no_range(), "time of the operation")};
  }
};

namespace verstat::operations {

CutPlan plan(const PlainOperation& spec, const PlanContext&) {
  CutPlan p;
  p.set_main_time(mean_min(spec.time), "given");
  p.time_law = spec.time;
  return p;
}

namespace duration {
void add_to(Kinds& kinds) {
  kinds.add<PlainOperation>("A plain time, constant or random.", {});
}
}  // namespace duration

}  // namespace verstat::operations
