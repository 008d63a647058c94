// Inserts as they are fitted: sorted, coated and treated lots.
#include "models/catalogue/error.h"
#include "operations/cut_plan.h"
#include "scenarios/tooling.h"

namespace verstat::scenarios {

Insert prepared(const Insert& insert) {
  if (!insert.preparation) return insert;
  const operations::CutPlan plan = insert.preparation->plan({.edge = &insert.edge_life});
  if (!plan.lot)
    throw models::DomainError("kind", "kind = \"" + insert.preparation->kind()->name +
                                          "\", must be one that prepares a lot of inserts, such as "
                                          "\"insert_preparation\", \"coating\" or \"drill_finishing\"");
  Insert fitted = insert;
  fitted.edge_life = plan.lot->edge_life(insert.edge_life);
  fitted.price = plan.lot->price(insert.price);
  fitted.edges -= plan.lot->edges_used_by_test;
  return fitted;
}

}  // namespace verstat::scenarios
