#pragma once
// Data that cannot be fitted, said in one line: an outcome of a fit, not a fault of the program.

#include <stdexcept>

namespace verstat::fit {

class FitError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace verstat::fit
