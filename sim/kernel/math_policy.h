#pragma once
// The policy of all Boost.Math calls of the kernel.

#include <boost/math/policies/policy.hpp>

namespace verstat::sim::detail {

/// Double stays double: promotion to long double costs a factor of ten and changes last bits by platform.
using MathPolicy = boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                                 boost::math::policies::promote_float<false>>;

}  // namespace verstat::sim::detail
