#pragma once
// The program as a process of its own that can be killed, and a look at what it left behind.

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>
#include <unistd.h>

namespace verstat::test {

/// Starts the program with `arguments` as typed in a shell; `before` stands in front of it.
inline pid_t start(const std::string& arguments, const std::string& before = "") {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    const std::string line =
        before + "exec " + std::string(VERSTAT_PROGRAM) + " " + arguments + " >/dev/null 2>&1 </dev/null";
    ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  return child;
}
/// Waits; exit code, or 128 + signal.
inline int ended(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// "ok", or what is wrong with the file: pages, foreign keys, and from `first_run` on runs that are not
/// whole.
inline std::string state_of(const std::string& file, int first_run = 1) {
  SQLite::Database db(file, SQLite::OPEN_READWRITE, 60'000);
  const std::string pages = db.execAndGet("PRAGMA integrity_check").getString();
  if (pages != "ok") return pages;
  if (SQLite::Statement(db, "PRAGMA foreign_key_check").executeStep()) return "a foreign key leads nowhere";
  if (db.execAndGet("SELECT count(*) FROM sqlite_master WHERE name = 'run'").getInt() == 0) return "ok";
  // Every replication of a run has left as many values as its KPIs have samples.
  SQLite::Statement whole(
      db,
      "SELECT count(*) FROM run WHERE id >= ? AND (SELECT sum(samples) FROM run_kpi WHERE "
      "run_id = run.id) IS NOT (SELECT count(*) FROM replication_kpi WHERE "
      "run_id = run.id AND value IS NOT NULL)");
  whole.bind(1, first_run);
  whole.executeStep();
  const int torn = whole.getColumn(0).getInt();
  return torn == 0 ? "ok" : std::to_string(torn) + " runs are not whole";
}

/// A number that grows evenly through [0, 1): whole sequences are repeated by their seed.
class Moments {
 public:
  explicit Moments(std::uint64_t seed) : state_(seed) {}
  double next() {  // splitmix64
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace verstat::test
