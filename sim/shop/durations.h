#pragma once
#include "scenarios/scenario.h"
#include "sim/kernel/distribution.h"

namespace verstat::shop {

/// The probability law of a duration, min. One uniform number per draw, so that variants stay paired.
[[nodiscard]] sim::Distribution law_of(const scenarios::Duration& duration);

}  // namespace verstat::shop
