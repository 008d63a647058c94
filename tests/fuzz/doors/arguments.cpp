// The command line: the whole program with the arguments of a stranger, one per line. Commands that compute
// for long or write databases run in a folder that is gone, where they get as far as their first file; the
// others find honest and broken files. `serve` and `models doc` are left out: one waits, the other writes
// hundreds of pages.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/cli.h"
#include "scenarios/json_text.h"
#include "store/database.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

namespace fs = std::filesystem;

// Folders by their descriptors: the one this process began in, one with files, one that is gone.
struct Folders {
  Folders() {
    files = own_folder() + "/files";
    fs::create_directory(files);
    const auto copy = [&](const std::string& from, const std::string& name, std::size_t bytes) {
      std::string text = scenarios::read_text_file(from);
      if (bytes < text.size()) text.resize(text.find('\n', bytes) + 1);
      write_own("files/" + name, text);
    };
    write_own("files/s.json", json_in("scenarios/gallery", "heavy-lathe.json", 4000).at(0));
    write_own("files/p.json", json_in("scenarios/gallery/operations", "turning.json", 4000).at(0));
    write_own("files/bad.json", R"({"name": 3})");
    write_own("files/batch.json",
              R"([{"id":1,"function":"K117.weibull_from_moments","inputs":{"mean_min":60}}])");
    write_own("files/changes.json", R"({"changes":[{"pointer":"/machines/0/count","value":3}]})");
    write_own("files/entry.json",
              R"({"kind":"insert","name":"T","entry":{"edges":4},"provenance":{"file":"x","rows_used":3}})");
    copy("docs/examples/fit/removals.csv", "l.csv", 300);
    copy("docs/examples/fit/wear.csv", "t.csv", 500);
    copy("docs/examples/fit/downtime.csv", "d.csv", 300);
    copy("docs/examples/fit/orders.csv", "a.csv", 300);
    copy("docs/examples/fit/cycles.csv", "c.csv", 200);
    copy("docs/examples/fit/plans.json", "v.json", SIZE_MAX);
    static_cast<void>(store::Writer(files + "/verstat.db"));
    honest = {"s.json", "p.json", "bad.json", "batch.json", "changes.json", "entry.json", "l.csv",
              "t.csv",  "d.csv",  "a.csv",    "c.csv",      "v.json",       "verstat.db"};
    const std::string lost = own_folder() + "/lost";
    fs::create_directory(lost);
    begun_in = ::open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    with_files = ::open(files.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    gone = ::open(lost.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    fs::remove(lost);
  }
  // What commands have written.
  void clean() const {
    for (const auto& entry : fs::directory_iterator(files))
      if (!honest.contains(entry.path().filename().string())) fs::remove_all(entry.path());
  }
  std::string files;
  std::set<std::string> honest;
  int begun_in = -1, with_files = -1, gone = -1;
};

// What commands print goes nowhere while one of these lives; sanitizers write past it.
class Silence {
 public:
  Silence() : out_(stdout), err_(stderr), cout_(std::cout.rdbuf(nullptr)), cerr_(std::cerr.rdbuf(nullptr)) {
    static std::FILE* const nowhere = std::fopen("/dev/null", "we");
    stdout = nowhere;
    stderr = nowhere;
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() {
    stdout = out_;
    stderr = err_;
    std::cout.rdbuf(cout_);
    std::cerr.rdbuf(cerr_);
  }

 private:
  std::FILE* out_;
  std::FILE* err_;
  std::streambuf* cout_;
  std::streambuf* cerr_;
};

bool plain_name(std::string_view name) {
  return !name.empty() && name.front() != '.' &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_") ==
             std::string_view::npos;
}

// Nothing outside the folder may be written, and nothing may be waited for.
bool harmless(const std::vector<std::string>& words) {
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string_view word = words[k];
    if (word == "serve" || word == "doc" || word == "-") return false;
    for (const std::string_view flag : {"--out", "--library", "--db", "--write-plan"}) {
      if (word == flag && k + 1 < words.size() && !plain_name(words[k + 1])) return false;
      if (word.starts_with(flag) && word.size() > flag.size() && word[flag.size()] == '=' &&
          !plain_name(word.substr(flag.size() + 1)))
        return false;
    }
  }
  return true;
}

bool takes_long(std::string_view command) {
  for (const std::string_view one : {"run", "compare", "sweep", "losses", "optimize", "calibrate", "trace"})
    if (command == one) return true;
  return false;
}

void eat(std::string_view bytes) {
  static const Folders folders;
  std::vector<std::string> words = {"verstat"};
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view word = bytes.substr(0, end);
    words.emplace_back(word.substr(0, word.find('\0')));  // as the system hands them over
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  if (!harmless(words)) return;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const bool lost = words.size() > 1 && takes_long(words[1]);
  if (::fchdir(lost ? folders.gone : folders.with_files) != 0) finding("cannot change the folder");
  int code = 0;
  {
    const Silence silence;
    code = app::run_program(static_cast<int>(words.size()), arguments.data());
  }
  if (::fchdir(folders.begun_in) != 0) finding("cannot change the folder back");
  // 1 means: no better input would mend it. A database is the only thing that can be wrong by itself here.
  const bool database = words.size() > 1 && (lost || words[1] == "runs");
  if (code != app::success && code != app::bad_input && !(code == app::failure && database)) {
    std::string all;
    for (const std::string& word : words) all += " [" + word + "]";
    finding(fmt::format("exit code {} of{}", code, all));
  }
  static std::uint64_t eaten = 0;
  if (++eaten % 1024 == 0) folders.clean();
}

std::vector<std::string> seeds() {
  return {
      "--help",
      "--version",
      "validate\ns.json\n--json\n--seed\n7\n--replications=3\n--threads\n2",
      "validate\ns.json\n--set\n/machines/0/count=3\n--changes\nchanges.json\n--use\n/inserts/0=entry.json",
      "validate\nbad.json",
      "graph\ns.json\n--set=/crews/0/members=2",
      "schema",
      "plan\np.json\n--explain\n--json\n--set\n/feed_mm_rev=0.5",
      "models\nlist\n--source\nK109",
      "models\nsearch\nmill\nwear\n--json",
      "models\nshow\nK117.weibull_from_moments",
      "models\neval\nK117.weibull_from_moments\n--inputs\n{\"mean_min\": 60, \"cv\": 0.7}",
      "models\neval\n--batch\nbatch.json\n--source\nK117",
      "models\ncount\n--points\n.",
      "runs\n--db\nverstat.db\n--json",
      "runs\n--run\n1\n--all-replications",
      "runs\n--study=2",
      "run\ns.json\n--label\nx\n--check\n--json\n--db\nx.db\n--seed\n1\n--replications\n2\n--threads\n1",
      "run\ns.json\n--set\n/machines/0/count=3\n--set\n/tools/0/strategy/gamma=0.4",
      "compare\ns.json\n--variant\nmore: /machines/0/count=3; /crews/0/members=2\n--kpi\ncost_per_part\n"
      "--confidence\n0.9\n--indifference\n0.01\n--max-replications\n40\n--progress\nnone",
      "sweep\ns.json\n--factor\n/machines/0/count=1..3:3\n--factor\n/crews/0/members=1,2\n--design\nfull\n"
      "--points\n8\n--kpi\noee\n--progress\njson",
      "sweep\n--resume\n3\n--db\nx.db",
      "losses\ns.json\n--replications\n4\n--progress\nbar",
      "optimize\nstudy.json\n--write-plan\nplan.json\n--time\n2.5\n--progress\nnone",
      "optimize\n--resume\n1",
      "calibrate\ns.json\n--totals\nm.json\n--uncertain\n/crews/0/"
      "rate_per_min=0.1..2\n--points\n20\n--rounds\n2",
      "trace\ns.json\n--format\nchrome\n--replication\n3\n--out\nt.json",
      "fit\ncycle\nc.csv\n--operation\nturning\n--to\n/operations/0/process/"
      "time\n--bootstrap\n19\n--empirical",
      "fit\narrivals\na.csv\n--as\norders\n--part\nshaft\n--hours\n07:00-15:00\n--weekdays\nmon-fri\n--to\n"
      "/parts/0/supply\n--bootstrap\n19",
      "fit\ndowntime\nd.csv\n--from\n2026-01-01\n--to-time\n2026-02-01\n--clock\ncalendar\n--mode\nchuck\n"
      "--bootstrap\n19\n--new-at-start\n--accept-trend",
      "fit\ntaylor\nt.csv\n--criterion\n0.2\n--at\n120,0.2,1.5\n--material\n40Cr\n--pool-laboratories",
      "fit\nlife\nl.csv\n--tool\nT5K10\n--gamma\n0.8\n--bootstrap\n39\n--confidence\n0.9\n--seed\n3\n--to\n"
      "/inserts/0\n--column\ncause=Cause\n--decimal\ncomma\n--encoding\nutf-8\n--separator\nsemicolon\n"
      "--duplicates\nkeep\n--json",
      "fit\nlife\nl.csv\n--speed\n60\n--feed\n1\n--depth\n10\n--min-per-part\n5\n--library\nlib\n--"
      "bootstrap\n39",
      "fit\nvalue\nl.csv\n--plans\nv.json\n--truths\n100",
      "fit\ncycle\nmissing.csv\n--sheet\n1"};
}

}  // namespace

Target arguments_target() {
  return {.name = "arguments", .form = Form::bytes, .eat = eat, .seeds = seeds, .short_run = 500};
}

}  // namespace verstat::fuzz
