#pragma once
// A duration as a user gives it: a constant or a probability law.

#include <variant>

namespace verstat::operations {

struct ConstantDuration {
  static constexpr const char* kind = "constant";
  double value_min = 0;
};
struct ExponentialDuration {
  static constexpr const char* kind = "exponential";
  double rate_per_min = 0;  ///< mean is 1 / rate
};
struct UniformDuration {
  static constexpr const char* kind = "uniform";
  double low_min = 0;
  double high_min = 0;
};
struct TriangularDuration {
  static constexpr const char* kind = "triangular";
  double low_min = 0;
  double mode_min = 0;
  double high_min = 0;
};
struct LognormalDuration {
  static constexpr const char* kind = "lognormal";
  double mean_min = 0;
  double cv = 0.5;
};
struct GammaDuration {
  static constexpr const char* kind = "gamma";
  double mean_min = 0;
  double cv = 0.5;
};
struct WeibullDuration {
  static constexpr const char* kind = "weibull";
  double mean_min = 0;
  double cv = 0.5;
};
using Duration = std::variant<ConstantDuration, ExponentialDuration, UniformDuration, TriangularDuration,
                              LognormalDuration, GammaDuration, WeibullDuration>;

/// Mean of a duration, min.
[[nodiscard]] double mean_min(const Duration& duration);

}  // namespace verstat::operations
