#pragma once
// A duration as a user gives it: a constant or a probability law.

#include <variant>
#include <vector>

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
/// How an empirical law fills the gaps between the observed values.
enum class BetweenValues {
  linear,  ///< evenly between neighbouring values
  step     ///< not at all: only observed values occur
};
/// The observed values themselves.
struct EmpiricalDuration {
  static constexpr const char* kind = "empirical";
  std::vector<double> values_min;
  std::vector<double> weights;  ///< of the values, in their order; empty: the same for all
  BetweenValues between = BetweenValues::linear;
};
using Duration = std::variant<ConstantDuration, ExponentialDuration, UniformDuration, TriangularDuration,
                              LognormalDuration, GammaDuration, WeibullDuration, EmpiricalDuration>;

/// Mean of a duration, min.
[[nodiscard]] double mean_min(const Duration& duration);

}  // namespace verstat::operations
