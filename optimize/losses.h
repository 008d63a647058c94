#pragma once
// The price list of losses: the shop as it is against the shop with one loss removed.

#include <string>
#include <vector>

#include "scenarios/load.h"

namespace verstat::optimize {

/// A loss and the changes of the scenario that remove it, everything else left as it is.
struct Loss {
  std::string name;  ///< "failures of roughing tool"
  std::string kind;  ///< "failure", "change", "wait", "scrap"
  std::vector<scenarios::Change> removed_by;
};

/// The losses that a scenario states and that a change of its numbers can remove:
///   failure  an edge that fails costs no more time, damage or parts than a planned change; a machine does
///   not
///            fail in one of its modes
///   change   indexing, replacing, swapping and positioning take no time; nor does the change of an element,
///   a
///            maintenance or a set-up
///   scrap    failures of a tool's edges spoil no part; an operation spoils none
///   wait     a crew with as many members as there are machines, and without walking; spare parts and inserts
///            that are always there
/// A loss that is zero already is not listed.
[[nodiscard]] std::vector<Loss> losses_of(const scenarios::Scenario& scenario);

}  // namespace verstat::optimize
