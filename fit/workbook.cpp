#include "fit/workbook.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scenarios/json_text.h"

extern char** environ;  // NOLINT: POSIX says to declare it

namespace verstat::fit {
namespace {

constexpr std::size_t largest_table = 256U << 20U;

// A descriptor that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close_now(); }
  void close_now() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw scenarios::InputError("", fmt::format("table {}: {}", path, why));
}

}  // namespace

bool is_workbook_name(const std::string& path) {
  if (path.size() < 5) return false;
  std::string end = path.substr(path.size() - 5);
  for (char& c : end)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return end == ".xlsx";
}

std::string workbook_as_table(const std::string& path, const std::string& sheet) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) refuse(path, "no pipe to the converter can be made");
  const Descriptor from(pipe_ends[0]);
  Descriptor into(pipe_ends[1]);

  // A file named -d is no flag.
  const std::string file = path.starts_with('-') ? "./" + path : path;
  // --ignore-formats takes every word up to the next flag.
  std::vector<std::string> words = {"xlsx2csv",          "--ignore-formats", "float", "--dateformat",
                                    "%Y-%m-%d %H:%M:%S", "--delimiter",      ";"};
  if (!sheet.empty()) words.push_back("--sheetname=" + sheet);
  words.push_back(file);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, into.get(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "xlsx2csv", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  into.close_now();
  if (error == ENOENT)
    refuse(path,
           "is a workbook, and the program that converts it is not installed: install the Debian package "
           "xlsx2csv, or save the sheet as \"CSV UTF-8\"");
  if (error != 0) refuse(path, fmt::format("xlsx2csv cannot be started: {}", std::strerror(error)));

  std::string table;
  bool too_large = false;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t n = read(from.get(), buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    table.append(buffer.data(), static_cast<std::size_t>(n));
    if (table.size() > largest_table) {
      too_large = true;
      kill(child, SIGKILL);
      break;
    }
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (too_large) refuse(path, "the sheet is larger than 256 MiB as a table");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    refuse(path,
           sheet.empty()
               ? "xlsx2csv cannot read this workbook; save the sheet as \"CSV UTF-8\""
               : fmt::format("xlsx2csv finds no sheet \"{}\" in this workbook, or cannot read it", sheet));
  return table;
}

}  // namespace verstat::fit
