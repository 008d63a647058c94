#pragma once
// Pages of runs, studies and trials: searched, sorted and cut in SQL, so that a page of a large database
// costs no more than it shows.

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "store/records.h"

namespace SQLite {
class Database;
}

namespace verstat::store {

struct ListQuery {
  std::vector<std::string> words;  ///< all must stand in scenario, label, changes, note or tags
  std::string tag;                 ///< empty: any
  std::string sort = "id";         ///< one of run_sorts or study_sorts; of runs also the name of a KPI
  bool descending = true;
  std::int64_t limit = 50;
  std::int64_t offset = 0;
};

template <class Row>
struct ListPage {
  std::int64_t total = 0;  ///< that match
  std::vector<Row> rows;
};

/// A trial as a page shows it.
struct TrialRow {
  std::int64_t number = 0;
  std::string stage;
  std::vector<double> values;
  std::optional<double> objective;
  bool feasible = true;
  std::optional<double> half_width;  ///< of a simulated objective, in databases that keep it
  std::int64_t replications = 0;     ///< of a simulated trial, likewise
};

struct TrialQuery {
  bool by_objective = false;  ///< best first, without those that have none; else by number
  bool highest = false;       ///< best is the highest objective, not the lowest
  std::int64_t after = 0;     ///< only numbers above this
  std::int64_t limit = 200;
  std::int64_t offset = 0;
};

class Listing {
 public:
  static const std::vector<std::string>& run_sorts();
  static const std::vector<std::string>& study_sorts();

  /// Opens the database and its notes read-only. Throws StoreError.
  explicit Listing(const std::filesystem::path& database);
  Listing(const Listing&) = delete;
  Listing& operator=(const Listing&) = delete;
  ~Listing();

  [[nodiscard]] ListPage<RunHeader> runs(const ListQuery& query) const;
  [[nodiscard]] ListPage<StudyHeader> studies(const ListQuery& query) const;
  /// The KPIs with these names of these runs.
  [[nodiscard]] std::map<std::int64_t, std::vector<KpiSummary>> kpis(
      const std::vector<std::int64_t>& runs, const std::vector<std::string>& names) const;
  /// Currency of each of these runs.
  [[nodiscard]] std::map<std::int64_t, std::string> currencies(const std::vector<std::int64_t>& runs) const;
  /// True when some run has a KPI of this name.
  [[nodiscard]] bool has_kpi(const std::string& name) const;
  [[nodiscard]] bool has_study(std::int64_t id) const;
  [[nodiscard]] ListPage<TrialRow> trials(std::int64_t study, const TrialQuery& query) const;
  /// At most `most` trials, by number: the best half of that number and an even choice of all.
  [[nodiscard]] ListPage<TrialRow> sample(std::int64_t study, std::int64_t most, bool highest = false) const;

 private:
  [[nodiscard]] std::int64_t trial_count(std::int64_t study) const;
  std::filesystem::path file_;
  std::unique_ptr<SQLite::Database> db_;
  std::string notes_ = "notes";  // schema name of the notes within the connection
};

}  // namespace verstat::store
