#include "models/math/normal_interval.h"

#include "models/math/normal.h"

namespace verstat::models {

double normal_between(double low, double high) {
  // In the upper tail the mirror image is the accurate one.
  return low > 0 ? normal_cdf(-low) - normal_cdf(-high) : normal_cdf(high) - normal_cdf(low);
}

}  // namespace verstat::models
