// The peak of the load over one pitch against a dense sampling of it.
#include "models/milling/helical_tooth_load.h"

#include <algorithm>
#include <numbers>

#include "tests/property.h"

using verstat::models::SinePowerIntegral;
using verstat::models::ToothLoad;

TEST_CASE("tooth load: no sampled angle is above the peak, and some come close") {
  const SinePowerIntegral integral(0.75);
  verstat::test::property([&] {
    const double start = *rc::gen::inRange(0, 250) / 100.0;
    const double exit = start + (std::numbers::pi - start) * *rc::gen::inRange(5, 101) / 100.0;
    const double lag = *rc::gen::elementOf(std::vector<double>{0.0, 0.02, 0.3, 1.0, 2.5, 6.0});
    const std::int64_t teeth = *rc::gen::inRange(1, 12);
    const ToothLoad load{integral, start, exit, lag, teeth};
    const double peak = load.peak();
    double sampled = 0;
    constexpr int samples = 4000;
    for (int k = 0; k <= samples; ++k)
      sampled = std::max(sampled, load.at(2 * std::numbers::pi / static_cast<double>(teeth) * k / samples));
    RC_ASSERT(sampled <= peak * (1 + 1e-9));
    // Between two samples the load moves little; at a step of straight teeth the peak is one-sided.
    RC_ASSERT(sampled >= peak * (1 - 5e-3));
  });
}
