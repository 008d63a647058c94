#pragma once
// What people write beside results: a note and tags on a run or a study. Kept in a file of its own beside the
// database, "verstat.db.notes", so that a note can be written while a study holds the database.

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace verstat::store {

enum class Subject { run, study };

struct Annotation {
  std::string note;
  std::vector<std::string> tags;  ///< sorted
};

/// File of the notes that belong to a database.
[[nodiscard]] std::filesystem::path notes_file(const std::filesystem::path& database);

/// Throws StoreError that names the file when it cannot be used.
class Notes {
 public:
  static constexpr std::size_t longest_note = 10'000;  ///< bytes
  static constexpr std::size_t longest_tag = 100;      ///< bytes
  static constexpr std::size_t most_tags = 30;         ///< of one subject

  /// `database` is the results database. Its notes file is made at the first `set`.
  explicit Notes(const std::filesystem::path& database);

  /// Replaces note and tags of a run or a study. Tags are trimmed, sorted and made unique; empty ones are
  /// dropped. Throws std::invalid_argument when something is too long or too many, or no UTF-8 text.
  void set(Subject subject, std::int64_t id, const Annotation& annotation) const;
  [[nodiscard]] Annotation get(Subject subject, std::int64_t id) const;
  /// Of all these subjects; those without an annotation are left out.
  [[nodiscard]] std::map<std::int64_t, Annotation> of(Subject subject,
                                                      const std::vector<std::int64_t>& ids) const;
  /// Every tag in use with how often, by name.
  [[nodiscard]] std::map<std::string, std::int64_t> tags() const;

 private:
  [[nodiscard]] std::unique_ptr<SQLite::Database> open_to_read() const;
  std::filesystem::path file_;
};

}  // namespace verstat::store
