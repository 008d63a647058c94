#pragma once
// RapidCheck's properties as Catch2 assertions: a bare rc::check only prints when a property is falsified.

#include <string>
#include <utility>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace verstat::test {

template <class Property>
void property(Property&& holds) {
  CHECK(rc::check(std::forward<Property>(holds)));
}
template <class Property>
void property(const std::string& what, Property&& holds) {
  CHECK(rc::check(what, std::forward<Property>(holds)));
}

}  // namespace verstat::test
