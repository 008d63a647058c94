#pragma once
#include <filesystem>

namespace SQLite {
class Database;
}
namespace verstat::store {

/// Brings a database to schema_version, one transaction per step; what an older program wrote is copied to
/// `<file>.schema<N>.bak` before. Foreign keys must be off (as SQLite opens): steps rebuild tables. Throws
/// StoreError when it is newer.
void migrate(SQLite::Database& db, const std::filesystem::path& file);

}  // namespace verstat::store
