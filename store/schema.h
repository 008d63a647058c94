#pragma once
#include <filesystem>

namespace SQLite {
class Database;
}
namespace verstat::store {

/// Throws StoreError for a database that another program has made: nothing of it may be changed.
void refuse_foreign(SQLite::Database& db);

/// Brings a database to schema_version, one transaction per step; what an older program wrote is copied to
/// `<file>.schema<N>.bak` before. Foreign keys must be off (as SQLite opens): steps rebuild tables. Throws
/// StoreError when it is newer.
void migrate(SQLite::Database& db, const std::filesystem::path& file);

}  // namespace verstat::store
