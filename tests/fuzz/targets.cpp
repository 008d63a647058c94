#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {scenario_target(), simulated_target(), study_target(),
                                          table_target(),    records_target(),   workbook_target(),
                                          model_target(),    changes_target(),   route_target(),
                                          http_target(),     arguments_target()};
  return all;
}

}  // namespace verstat::fuzz
