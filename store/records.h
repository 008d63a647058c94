#pragma once
// What the database keeps: results and everything needed to compute them again. The store knows results, not
// how they were made.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace verstat::store {

struct KpiInfo {
  std::string name;  ///< "cost_per_part", "machine/lathe 1/state/cutting"
  std::string unit;
  std::string meaning;
};

/// Mean over replications with the half-width of its 95 % confidence interval.
struct KpiSummary {
  KpiInfo kpi;
  std::optional<double> mean;        ///< none when no replication has a value
  std::optional<double> half_width;  ///< none with fewer than two values
  std::int64_t samples = 0;          ///< replications that have a value
};

/// Where and with what a result was computed: the same version on the same kind of machine gives the same
/// bits.
struct Provenance {
  std::string version;   ///< of the program
  std::string platform;  ///< processor features and C library
  std::string created;   ///< UTC, ISO 8601
};

struct RunHeader {
  std::int64_t id = 0;
  std::string label;  ///< "what-if", "study 3: baseline"
  std::string scenario_name;
  std::string changes;  ///< JSON list of {"pointer", "value"}
  std::uint64_t seed = 0;
  std::int64_t replications = 0;
  double horizon_min = 0;
  double warmup_min = 0;
  double elapsed_s = 0;
  Provenance provenance;
  /// Hash of all results and of the course of events, as its maker computes it; empty in runs of schema 2 and
  /// before.
  std::string fingerprint = {};
};

struct Run {
  RunHeader header;
  std::string scenario_text;  ///< as the user wrote it, before the changes
  std::string currency;
  std::vector<KpiSummary> kpis;
  /// values[r][k]: KPI k in replication r; none where the KPI has no value ("cost per part" of no part).
  std::vector<std::vector<std::optional<double>>> values;
};

struct Variable {
  std::string name;
  std::string pointer;
  std::string unit;
  double low = 0;
  double high = 0;
  std::string type = "continuous";  ///< "continuous", "integer", "categorical"
  std::string options = "[]";       ///< JSON list of the options of a categorical variable
};

struct Trial {
  std::int64_t number = 0;     ///< from 1, in the order of evaluation
  std::string stage;           ///< "analytic", "simulation", "choice", "design", ...
  std::vector<double> values;  ///< of the variables, bit for bit; a category is the index of its option
  std::optional<double> objective;
  bool feasible = true;
  std::optional<double> half_width = {};  ///< of a simulated objective
  std::int64_t first_replication = 0;     ///< of a simulated trial
  std::int64_t replications = 0;          ///< 0: computed without simulation
  /// Everything that the study reads from the trial, bit for bit, so that it is never computed twice. Empty
  /// in trials of schema 1.
  std::vector<double> outcome = {};
};

struct StudyHeader {
  std::int64_t id = 0;
  std::string name;
  std::string scenario_name;
  std::string status;  ///< "running", "finished", "interrupted", "failed"
  std::string objective;
  std::int64_t trials = 0;
  std::uint64_t seed = 0;
  Provenance provenance;
  std::string kind = "optimize";  ///< "optimize", "sweep", "compare", "losses"
};

struct Study {
  StudyHeader header;
  std::string study_text;
  std::string scenario_text;
  std::string changes;
  std::vector<Variable> variables;
  std::vector<Trial> trials;
  std::optional<std::int64_t> baseline_run;
  std::optional<std::int64_t> best_run;
  std::string result;  ///< JSON: best point, saving with interval, words; empty object while running
};

}  // namespace verstat::store
