#pragma once
// What grinding kinds share: the time between two dressings of the wheel as the life of a replaceable
// element.

#include <vector>

#include "models/catalogue/field.h"
#include "operations/cut_plan.h"

namespace verstat::operations {

/// How the time between dressings scatters about its mean. COMPLETION: no source states it; the scatter of a
/// cutting edge is assumed.
struct DressingLaw {
  models::LifeLawKind dressing_law = models::LifeLawKind::weibull;
  double dressing_cv = 0.7;
};

/// Grains stand `grain_protrusion_um` out of the bond after dressing and lose `protrusion_loss_um_min` per
/// minute of grinding; the wheel is dressed when the protrusion has fallen to the depth the wheel sinks in.
struct GrainProtrusion : DressingLaw {
  double grain_protrusion_um = 0;
  double protrusion_loss_um_min = 0;
};

/// The element "wheel dressing" with the mean time between dressings, min of grinding, > 0.
/// Throws models::DomainError naming "dressing_cv" where the normal law does not take it.
[[nodiscard]] ElementLife dressing_life(const DressingLaw& law, double mean_min, const char* origin);

/// Time in which the protrusion falls to `sunk_um`, at least the main time of one part: a wheel that starts
/// below it is dressed for every part, and the limit on the protrusion says that even this is not enough.
[[nodiscard]] ElementLife dressing_life(const GrainProtrusion& grains, double sunk_um, double main_time_min);

/// Whole steps of `step` in `total`, both > 0: the last one may be smaller. Rounding never adds one.
[[nodiscard]] double steps_in(double total, double step);

template <class S>
void append_dressing_law(std::vector<models::Field>& fields) {
  fields.push_back(models::member<S>(&DressingLaw::dressing_law, "dressing_law", "", "-", models::no_range(),
                                     "law of the time between dressings", false));
  fields.push_back(
      models::member<S>(&DressingLaw::dressing_cv, "dressing_cv", "", "1", models::closed(0.05, 2),
                        "coefficient of variation of that time (normal law: up to 0.45)", false));
}
template <class S>
void append_grain_protrusion(std::vector<models::Field>& fields) {
  fields.push_back(models::member<S>(&GrainProtrusion::grain_protrusion_um, "grain_protrusion_um", "", "um",
                                     models::open_low(0, 1000), "grains above the bond after dressing",
                                     true));
  fields.push_back(models::member<S>(&GrainProtrusion::protrusion_loss_um_min, "protrusion_loss_um_min", "",
                                     "um/min", models::closed(1e-6, 1000),
                                     "protrusion lost per minute of grinding", true));
  append_dressing_law<S>(fields);
}

}  // namespace verstat::operations
