#pragma once
// The one Boost.Math policy of the project. Without it doubles are promoted to long double: ten times slower,
// and other last bits. Errors are thrown as std exceptions, which `guarded` turns into a ModelError.

#include <boost/math/policies/policy.hpp>

namespace verstat::models {

using MathPolicy = boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                                 boost::math::policies::promote_float<false>>;

}  // namespace verstat::models
