#include "web-ui/server/csv.h"

#include <algorithm>

#include <fmt/format.h>

namespace verstat::web {

CsvWriter::CsvWriter(CsvFormat format) : format_(format) {
  if (format_.byte_order_mark) out_ = "\xEF\xBB\xBF";
}

void CsvWriter::cell(std::string_view value) {
  if (!first_) out_ += format_.separator;
  first_ = false;
  const bool quoted = value.find_first_of("\"\r\n") != std::string_view::npos ||
                      value.find(format_.separator) != std::string_view::npos;
  if (!quoted) {
    out_ += value;
    return;
  }
  out_ += '"';
  for (const char c : value) {
    if (c == '"') out_ += '"';
    out_ += c;
  }
  out_ += '"';
}

CsvWriter& CsvWriter::text(std::string_view value) {
  const bool formula =
      !value.empty() && std::string_view("=+-@\t\r").find(value.front()) != std::string_view::npos;
  cell(formula ? "'" + std::string(value) : std::string(value));
  return *this;
}

CsvWriter& CsvWriter::number(std::optional<double> value) {
  std::string digits = value ? fmt::format("{}", *value) : std::string();
  std::replace(digits.begin(), digits.end(), '.', format_.decimal);
  cell(digits);
  return *this;
}

CsvWriter& CsvWriter::integer(std::int64_t value) {
  cell(std::to_string(value));
  return *this;
}

CsvWriter& CsvWriter::end_row() {
  out_ += "\r\n";
  first_ = true;
  return *this;
}

std::string kpi_table(const store::Run& run, CsvFormat format) {
  CsvWriter csv(format);
  csv.text("name").text("mean").text("half_width_95").text("unit").text("samples").text("meaning").end_row();
  for (const store::KpiSummary& k : run.kpis)
    csv.text(k.kpi.name)
        .number(k.mean)
        .number(k.half_width)
        .text(k.kpi.unit)
        .integer(k.samples)
        .text(k.kpi.meaning)
        .end_row();
  return csv.take();
}

std::string trial_table(const store::Study& study, CsvFormat format) {
  CsvWriter csv(format);
  csv.text("number").text("stage");
  for (const store::Variable& v : study.variables)
    csv.text(v.unit == "1" ? v.name : fmt::format("{} [{}]", v.name, v.unit));
  csv.text("objective " + study.header.objective).text("feasible").end_row();
  for (const store::Trial& trial : study.trials) {
    csv.integer(trial.number).text(trial.stage);
    for (const double value : trial.values) csv.number(value);
    csv.number(trial.objective).integer(trial.feasible ? 1 : 0).end_row();
  }
  return csv.take();
}

}  // namespace verstat::web
