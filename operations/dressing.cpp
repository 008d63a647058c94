#include "operations/dressing.h"

#include <algorithm>
#include <cmath>

#include "models/catalogue/error.h"

namespace verstat::operations {

ElementLife dressing_life(const DressingLaw& law, double mean_min, const char* origin) {
  models::require(law.dressing_law != models::LifeLawKind::normal || law.dressing_cv <= 0.45, "dressing_cv",
                  law.dressing_cv, "must not be above 0.45 with the normal law");
  return {.element = "wheel dressing",
          .law = law.dressing_law,
          .mean_min = mean_min,
          .cv = law.dressing_cv,
          .origin = origin};
}

ElementLife dressing_life(const GrainProtrusion& grains, double sunk_um, double main_time_min) {
  const double worn_min = (grains.grain_protrusion_um - sunk_um) / grains.protrusion_loss_um_min;
  return dressing_life(grains, std::max(worn_min, main_time_min),
                       "COMPLETION: constant loss of protrusion until the wheel sinks in as deep");
}

double steps_in(double total, double step) {
  return std::ceil(total / step - 1e-9);
}

}  // namespace verstat::operations
