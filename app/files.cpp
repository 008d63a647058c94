#include "app/files.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "app/cli.h"

namespace verstat::app {

void write_file(const std::string& flag, const std::string& file, const std::string& text) {
  const std::string beside = fmt::format("{}.{}.part", file, ::getpid());
  std::error_code error;
  {
    std::ofstream out(beside, std::ios::binary);
    out << text;
    out.close();
    if (!out) {
      std::filesystem::remove(beside, error);
      throw UsageError(fmt::format("{} {}: cannot be written; name a file in an existing directory with room",
                                   flag, file));
    }
  }
  std::filesystem::rename(beside, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw UsageError(fmt::format("{} {}: cannot be written ({})", flag, file, error.message()));
}

}  // namespace verstat::app
