#pragma once
// A name for a database that is free, removed with its companions at the end.

#include <filesystem>
#include <string>

#include <unistd.h>

namespace verstat::test {

struct TemporaryFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("verstat-store-test-" + std::to_string(::getpid()) + ".db");
  TemporaryFile() { clear(); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { clear(); }
  void clear() const {
    for (const char* suffix : {"", "-wal", "-shm", ".lock", ".notes", ".notes-journal"})
      std::filesystem::remove(path.string() + suffix);
  }
};

}  // namespace verstat::test
