// Inserts as they are fitted: sorted and treated lots.
#include "models/catalogue/error.h"
#include "operations/kinds/insert_preparation.h"
#include "scenarios/tooling.h"

namespace verstat::scenarios {

Insert prepared(const Insert& insert) {
  if (!insert.preparation) return insert;
  const auto* spec = insert.preparation->as<operations::InsertPreparation>();
  if (spec == nullptr)
    throw models::DomainError("kind", "kind = \"" + insert.preparation->kind()->name +
                                          "\", must be one that prepares a lot of inserts: "
                                          "\"insert_preparation\"");
  const operations::PreparedLife life = operations::prepared_life(*spec);
  const double accepted = 1 - life.reject_fraction;
  const bool tests = spec->screening != operations::InsertScreening::none;
  const bool treats = spec->treatment != operations::InsertTreatment::none;

  Insert fitted = insert;
  // The treatment acts on the law, not on how speed, feed and depth change the mean.
  fitted.edge_life.law = life.law;
  fitted.edge_life.cv = life.cv;
  fitted.edge_life.mean_ref_min *= life.mean_min / spec->mean_life_min;
  // Price of an accepted and treated insert, as in K119.inspection_decision.
  const double tested = tests ? spec->test_cost - life.reject_fraction * spec->salvage_value : 0;
  fitted.price = (insert.price + tested) / accepted + (treats ? spec->treatment_cost : 0);
  if (tests) fitted.edges -= spec->edges_used_by_test;
  return fitted;
}

}  // namespace verstat::scenarios
