#pragma once
// Whatever goes wrong with a file leaves as one StoreError that names it.

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "store/database.h"

namespace verstat::store {

/// What `body` gives. Errors of SQLite, values that no Verstat has written there (a text that should be a
/// number, a row for a replication the run does not have) and StoreErrors without the file become a
/// StoreError that begins with "<what> <file>"; memory that runs out is nobody's file.
template <class Body>
auto naming(const char* what, const std::filesystem::path& file, Body&& body) {
  try {
    return body();
  } catch (const SQLite::Exception& e) {
    throw StoreError(
        fmt::format("{} {}: {}", what, file.string(), e.getErrorStr()[0] != 0 ? e.what() : "unknown error"));
  } catch (const StoreError& e) {
    if (std::string_view(e.what()).starts_with(what)) throw;
    throw StoreError(fmt::format("{} {} {}", what, file.string(), e.what()));
  } catch (const std::logic_error& e) {  // of at() and stoull()
    throw StoreError(fmt::format("{} {}: holds what no Verstat has written ({}): restore it from a copy",
                                 what, file.string(), e.what()));
  }
}

}  // namespace verstat::store
