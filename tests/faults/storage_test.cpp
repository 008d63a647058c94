// Storage that fails: full, read-only, locked, taken away. The message says what happened, what was committed
// stays, and the next command goes on.
#include <chrono>
#include <fstream>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include "tests/e2e/command.h"
#include "tests/faults/program.h"

using namespace verstat::test;
namespace fs = std::filesystem;

namespace {

std::string lathe(int replications, const std::string& db) {
  return "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=12000 --replications " +
         std::to_string(replications) + " --db " + db;
}

/// A file system of its own, as large as it is told. Mounting takes rights that not everybody has.
class SmallDisk {
 public:
  SmallDisk(std::string path, const std::string& size) : path_(std::move(path)) {
    fs::create_directories(path_);
    mounted_ = ::mount("tmpfs", path_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
  }
  [[nodiscard]] bool mounted() const { return mounted_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
  bool mounted_ = false;
};

}  // namespace

TEST_CASE("disk full: what was committed stays, the message says so, room brings it back", "[disk]") {
  const Workspace w;
  const SmallDisk disk(w.file("disk"), "1536k");
  if (!disk.mounted()) {
    WARN("not tested here: mounting a small disk needs root");
    return;
  }
  const std::string db = disk.file("a.db");
  REQUIRE(call(lathe(4, db)).exit_code == 0);
  const std::string before = call("runs --json --run 1 --all-replications --db " + db).out;
  int stored = 1;
  int refused = 0;
  for (int k = 0; k < 6 && refused == 0; ++k) {
    const Answer a = call(lathe(300, db));
    if (a.exit_code == 0) {
      ++stored;
      continue;
    }
    ++refused;
    CHECK(a.exit_code == 1);
    CHECK_THAT(a.err, Catch::Contains(db));
    CHECK_THAT(a.err, Catch::Contains("full"));
  }
  REQUIRE(refused == 1);
  // Not one byte is left for anybody.
  { std::ofstream(disk.file("filler")) << std::string(2'000'000, 'x'); }
  const Answer none = call(lathe(4, db));
  CHECK(none.exit_code == 1);
  CHECK_THAT(none.err, Catch::Contains(db));
  const Answer study = call("optimize scenarios/gallery/heavy-lathe.study.json --db " + db);
  CHECK(study.exit_code == 1);
  CHECK_THAT(study.err, Catch::Contains(db));
  CHECK(call("runs --json --run 1 --all-replications --db " + db).out == before);
  fs::remove(disk.file("filler"));
  REQUIRE(::mount("tmpfs", w.file("disk").c_str(), "tmpfs", MS_REMOUNT, "size=8m") == 0);
  CHECK(state_of(db) == "ok");
  REQUIRE(call(lathe(4, db)).exit_code == 0);
  CHECK(state_of(db) == "ok");
  CHECK(SQLite::Database(db).execAndGet("SELECT count(*) FROM run").getInt() == stored + 1);
}

TEST_CASE("a read-only disk: results can be read, writing is refused in words", "[disk]") {
  const Workspace w;
  const SmallDisk disk(w.file("disk"), "4m");
  if (!disk.mounted()) {
    WARN("not tested here: mounting a small disk needs root");
    return;
  }
  const std::string db = disk.file("a.db");
  REQUIRE(call(lathe(4, db)).exit_code == 0);
  REQUIRE(::mount("tmpfs", w.file("disk").c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0);
  const Answer written = call(lathe(4, db));
  CHECK(written.exit_code == 1);
  CHECK_THAT(written.err, Catch::Contains("database " + db) && Catch::Contains("Read-only"));
  const Answer read = call("runs --json --run 1 --db " + db);
  INFO(read.err);
  CHECK(read.exit_code == 0);
}

TEST_CASE("a database deleted or replaced underneath a study ends it in words") {
  for (const bool replaced : {false, true}) {
    const Workspace w;
    const std::string db = w.file("a.db");
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string line =
          "exec " + std::string(VERSTAT_PROGRAM) +
          " sweep scenarios/gallery/heavy-lathe.json --factor /tools/0/strategy/gamma=0.4..0.8"
          " --design lhs --points 200 --set /simulation/horizon_min=60000 --replications 4 --db " +
          db + " >/dev/null 2>" + w.file("said") + " </dev/null";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
    for (int k = 0; k < 1000 && call("runs --study 1 --db " + db).exit_code != 0; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    fs::rename(db, w.file("elsewhere.db"));
    if (replaced) fs::copy_file(w.file("elsewhere.db"), db);
    CHECK(ended(child) == 1);
    CHECK_THAT(read_file(w.file("said")), Catch::Contains("was deleted, moved or replaced"));
  }
}

TEST_CASE("a new database leaves nothing beside it") {
  const Workspace w;
  REQUIRE(call(lathe(4, w.file("a.db"))).exit_code == 0);
  for (const auto& entry : fs::directory_iterator(fs::path(w.file("a.db")).parent_path()))
    CHECK((entry.path().filename() == "a.db" || entry.path().filename() == "a.db.lock"));
}

TEST_CASE("a database that another program holds is waited for, then said") {
  const Workspace w;
  const std::string db = w.file("a.db");
  REQUIRE(call(lathe(4, db)).exit_code == 0);
  const int lock = ::open((db + ".lock").c_str(), O_RDWR);
  REQUIRE(::flock(lock, LOCK_EX) == 0);
  CHECK(call("runs --json --db " + db).exit_code == 0);  // readers do not care
  const pid_t writer = start(lathe(4, db));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  CHECK(::waitpid(writer, nullptr, WNOHANG) == 0);  // it waits
  ::flock(lock, LOCK_UN);
  ::close(lock);
  CHECK(ended(writer) == 0);
  CHECK(SQLite::Database(db).execAndGet("SELECT count(*) FROM run").getInt() == 2);
}

TEST_CASE("a torn or foreign file is refused by name, and left as it is") {
  const Workspace w;
  const std::string db = w.file("a.db");
  REQUIRE(call(lathe(4, db)).exit_code == 0);
  const std::string whole = read_file(db);
  REQUIRE(whole.size() > 8192);
  Moments moments(11);
  for (int k = 0; k < 12; ++k) {
    std::string torn = whole;
    if (k % 2 == 0) {
      torn.resize(static_cast<std::size_t>(moments.next() * static_cast<double>(whole.size())));
    } else {
      for (int b = 0; b < 2000; ++b)
        torn[static_cast<std::size_t>(moments.next() * static_cast<double>(whole.size()))] =
            static_cast<char>(moments.next() * 256);
    }
    fs::remove(db + "-wal");
    fs::remove(db + "-shm");
    std::ofstream(db, std::ios::binary) << torn;
    for (const std::string& command :
         {std::string("runs --json --db "), std::string("runs --json --run 1 --db ")}) {
      const Answer a = call(command + db, "timeout 20");
      INFO("file " << k << " " << a.err);
      CHECK((a.exit_code == 0 || a.exit_code == 1));
      if (a.exit_code == 1) CHECK_THAT(a.err, Catch::Contains(db));
    }
  }
}

TEST_CASE("a worker without memory ends in words") {
  const Workspace w;
  const std::string db = w.file("a.db");
  const Answer a = call(
      "run scenarios/gallery/mixed-plant.json --replications 40 --threads 2 --set "
      "/machines/0/count=10000 --db " +
          db,
      "ulimit -v 200000; timeout 20");
  INFO(a.err);
  CHECK(a.exit_code == 1);
  CHECK_THAT(a.err, Catch::Contains("out of memory"));
  CHECK_FALSE(fs::exists(db));
}

TEST_CASE("a stored run is computed again bit for bit; one changed bit, and a changed course, are found") {
  const Workspace w;
  const std::string db = w.file("a.db");
  REQUIRE(call(lathe(3, db) + " --threads 2").exit_code == 0);
  // The runs of studies, replications of which were computed in several goes.
  REQUIRE(
      call("compare scenarios/gallery/heavy-lathe.json --variant \"two: /crews/0/members=2\" --replications 5"
           " --set /simulation/horizon_min=20000 --progress none --db " +
           db)
          .exit_code == 0);
  REQUIRE(call("optimize scenarios/gallery/heavy-lathe.study.json --set /simulation/horizon_min=20000 "
               "--replications 3"
               " --progress none --db " +
               db)
              .exit_code == 0);
  SQLite::Database file(db, SQLite::OPEN_READWRITE, 10'000);
  CHECK(file.execAndGet("SELECT count(*) FROM run").getInt() == 5);
  CHECK(file.execAndGet("SELECT count(*) FROM run WHERE length(fingerprint) = 16").getInt() == 5);
  CHECK(file.execAndGet("SELECT count(DISTINCT fingerprint) FROM run").getInt() == 5);
  for (int run = 1; run <= 5; ++run) {
    const Answer a = call("runs --verify " + std::to_string(run) + " --threads 1 --db " + db);
    INFO(a.err);
    CHECK(a.exit_code == 0);
    CHECK_THAT(a.out, Catch::Contains("come out the same, bit for bit"));
  }
  // The last bit of one value.
  file.exec(
      "UPDATE replication_kpi SET value = value * (1 + 3e-16) WHERE run_id = 2 AND replication = 1 AND "
      "position = 0");
  const Answer bit = call("runs --verify 2 --db " + db);
  CHECK(bit.exit_code == 1);
  CHECK_THAT(bit.err, Catch::Contains("1 of ") && Catch::Contains("of replication 1"));
  CHECK(call("runs --verify 2 --json --db " + db).exit_code == 1);
  file.exec("UPDATE run SET fingerprint = '0000000000000000' WHERE id = 3");
  const Answer course = call("runs --verify 3 --db " + db);
  CHECK(course.exit_code == 1);
  CHECK_THAT(course.err, Catch::Contains("the course of events does not"));
  CHECK(call("runs --verify 9 --db " + db).exit_code == 2);
}

TEST_CASE("runs of schema 2 are read and verified once a command has written") {
  const Workspace w;
  const std::string db = w.file("old.db");
  SQLite::Database(db, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec(read_file("tests/store/schema2.sql"));
  const Answer early = call("runs --verify 1 --db " + db);
  CHECK(early.exit_code == 1);
  CHECK_THAT(early.err, Catch::Contains("any writing command brings it up to date"));
  const Answer run = call(lathe(2, db) + " --json");
  REQUIRE(run.exit_code == 0);
  CHECK(fs::exists(db + ".schema2.bak"));
  SQLite::Database file(db);
  const std::string then = file.execAndGet("SELECT platform FROM run WHERE id = 1").getString();
  const std::string now = file.execAndGet("SELECT platform FROM run WHERE id = 2").getString();
  const Answer old = call("runs --verify 1 --db " + db);
  if (then != now) {
    WARN("kept for " << then << ", not compared on " << now);
    return;
  }
  INFO(old.err);
  CHECK(old.exit_code == 0);
  CHECK_THAT(old.out, Catch::Contains("none was stored"));
}
