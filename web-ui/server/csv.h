#pragma once
// Tables as comma- or semicolon-separated values for spreadsheets.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "store/records.h"

namespace verstat::web {

struct CsvFormat {
  char separator = ',';          ///< ',' or ';'
  char decimal = '.';            ///< '.' or ','; ',' only with ';'
  bool byte_order_mark = false;  ///< Excel takes a file for UTF-8 only when it begins with one
};

/// RFC 4180: quoted where needed, lines end with CR LF. Texts that a spreadsheet would take for a formula
/// (beginning with = + - @ or a tab) get an apostrophe in front: names come from scenario files of anybody.
class CsvWriter {
 public:
  explicit CsvWriter(CsvFormat format);
  CsvWriter& text(std::string_view value);
  /// Shortest digits that read back as the same double; an empty cell for none.
  CsvWriter& number(std::optional<double> value);
  CsvWriter& integer(std::int64_t value);
  CsvWriter& end_row();
  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  void cell(std::string_view value);
  CsvFormat format_;
  bool first_ = true;
  std::string out_;
};

/// name, mean, half_width_95, unit, samples, meaning; one row per KPI.
[[nodiscard]] std::string kpi_table(const store::Run& run, CsvFormat format);
/// number, stage, one column per variable, objective, feasible; one row per trial.
[[nodiscard]] std::string trial_table(const store::Study& study, CsvFormat format);

}  // namespace verstat::web
