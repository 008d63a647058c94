#pragma once
// Properties that can fail a test: rc::check alone prints its counterexample and returns false, and Catch2
// goes on.

#include <utility>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace verstat::tests {

/// Checks a RapidCheck property, and fails the running test case with it.
template <class Testable>
void check_property(Testable&& testable) {
  CHECK(rc::check(std::forward<Testable>(testable)));
}

}  // namespace verstat::tests
