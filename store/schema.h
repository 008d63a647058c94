#pragma once
namespace SQLite {
class Database;
}
namespace verstat::store {

/// Brings a database to schema_version, one transaction per step. Throws StoreError when it is newer.
void migrate(SQLite::Database& db);

}  // namespace verstat::store
