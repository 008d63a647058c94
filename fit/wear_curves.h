#pragma once
// Wear readings into lives: one curve per edge, its life where the wear meets the criterion of ISO 3685.

#include <string>
#include <vector>

#include "fit/columns.h"
#include "fit/observation.h"

namespace verstat::fit {

struct WearOptions {
  TableOptions table;
  std::vector<ColumnChoice> columns;
  double criterion_mm =
      0.3;               ///< VB_B = 0.3 mm of ISO 3685 for even wear (0.6 mm for the maximum of uneven wear)
  std::string material;  ///< only this workpiece material; empty: all
  std::string tool;      ///< only this tool; empty: all
};

/// One edge at one regime.
struct WearRun {
  std::string laboratory;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_of_cut_mm = 0;
  std::size_t readings = 0;
  double last_time_min = 0;
  double last_wear_mm = 0;
  std::size_t falling_readings = 0;  ///< lower than the one before: wear does not heal, measuring scatters
  Observation life;                  ///< min; exact: interpolated between two readings
};

struct WearGroup {
  std::string material;
  std::string tool;
  std::vector<WearRun> runs;
};

struct WearData {
  Table table;
  std::vector<WearGroup> groups;
  std::size_t rows_used = 0;
  double criterion_mm = 0.3;
};

struct WearReading {
  double time_min = 0;
  double wear_mm = 0;
};
/// Life of one curve (times rising): the linear interpolation between the last reading below the criterion
/// and the first one at or above it; before the first reading an interval from 0; never reached: still good
/// at the last reading.
[[nodiscard]] Observation life_at(const std::vector<WearReading>& curve, double criterion_mm);

/// Rows of equal material, tool, laboratory, regime and run are one curve; a time that does not rise starts
/// another edge. Throws InputError.
[[nodiscard]] WearData read_wear(const std::string& path, const WearOptions& options);

}  // namespace verstat::fit
