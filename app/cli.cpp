#include "app/cli.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <thread>

#include <boost/version.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sqlite3.h>
#include <unistd.h>

#include "app/version.h"
#include "fit/library.h"
#include "fit/order_file.h"
#include "models/catalogue/closest.h"
#include "models/catalogue/error.h"
#include "models/catalogue/shortened.h"
#include "optimize/ledger.h"
#include "sim/kernel/errors.h"
#include "store/database.h"
#include "store/text_search.h"

namespace verstat::app {

using scenarios::Change;
using scenarios::InputError;

void add_json(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "print the answer as JSON on standard output");
}
void add_db(CLI::App& command, CommonOptions& options) {
  command.add_option("--db", options.db, "results database (SQLite)")->capture_default_str();
}
void add_changes(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--set", options.set,
                  "change one value: POINTER=VALUE, for instance /machines/0/count=3; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--changes", options.changes,
                  "make the changes of this file, as verstat fit --out writes it; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option(
          "--use", options.use,
          "POINTER=FILE: put a library entry there, as verstat fit --library writes it; may be repeated")
      ->allow_extra_args(false);
}
void add_run_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "seed of all random streams, 0 to 18446744073709551615");
  command.add_option("--replications", options.replications, "independent repetitions, 1 to 100000");
  command.add_option("--threads", options.threads, "threads to use (results do not depend on it)");
  add_changes(command, options);
}

namespace {

// CLI11 takes "010" for 8, "-1" for 2^64 - 1 and swallows what follows: numbers are read here.
template <class Number>
Number whole(const std::string& flag, const std::string& text, Number low, Number high) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high)
    throw UsageError(fmt::format("{} {}: must be a whole number from {} to {}", flag,
                                 models::shortened(text, 100), low, high));
  return value;
}

// [{"pointer", "value"}, ...], or an object that holds such a list under "changes".
std::vector<Change> changes_in(const std::string& file) {
  const auto refuse = [&](const std::string& text) {
    throw UsageError(fmt::format("--changes {}: {}", file, text));
  };
  nlohmann::json j;
  try {
    j = scenarios::parse_json(scenarios::read_text_file(file));
  } catch (const InputError& e) {
    refuse(e.what());
  }
  const nlohmann::json& list = j.is_object() && j.contains("changes") ? j["changes"] : j;
  if (!list.is_array()) refuse("must hold a list of {\"pointer\": ..., \"value\": ...}");
  std::vector<Change> changes;
  for (const nlohmann::json& one : list) {
    if (!one.is_object() || one.size() != 2 || !one.contains("value") || !one.contains("pointer") ||
        !one["pointer"].is_string())
      refuse(fmt::format("change {} must be {{\"pointer\": ..., \"value\": ...}}", changes.size()));
    changes.push_back({one["pointer"].get<std::string>(), one["value"]});
  }
  return changes;
}

}  // namespace

int thread_count(const CommonOptions& options) {
  if (options.threads.empty()) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return whole<int>("--threads", options.threads, 1, 1024);
}

std::vector<Change> changes_of(const CommonOptions& options) {
  std::vector<Change> changes;
  for (const std::string& text : options.use)
    for (Change& change : fit::changes_of_use(text)) changes.push_back(std::move(change));
  for (const std::string& file : options.changes)
    for (Change& change : changes_in(file)) changes.push_back(std::move(change));
  for (const std::string& text : options.set) changes.push_back(scenarios::parse_change(text));
  const auto setting = [&](const char* member, nlohmann::json value) {
    changes.push_back({fmt::format("/simulation/{}", member), std::move(value)});
  };
  if (!options.seed.empty())
    setting("seed", std::to_string(whole<std::uint64_t>("--seed", options.seed, 0, UINT64_MAX)));
  if (!options.replications.empty())
    setting("replications", whole<std::int64_t>("--replications", options.replications, 1, 100'000));
  return changes;
}

std::string changes_text(const std::vector<Change>& changes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Change& change : changes) list.push_back({{"pointer", change.pointer}, {"value", change.value}});
  return list.dump();
}

std::string read_scenario_text(const std::string& file) {
  try {
    return fit::with_order_files(scenarios::read_text_file(file), std::filesystem::path(file).parent_path());
  } catch (const InputError& e) {
    throw UsageError(fmt::format("scenario {}: {}", file, e.what()));
  }
}

LoadedScenario load_scenario(const std::string& file, const std::vector<Change>& changes) {
  return load_scenario_text(read_scenario_text(file), "scenario " + file, changes);
}

LoadedScenario load_scenario_text(const std::string& text, const std::string& where,
                                  const std::vector<Change>& changes) {
  LoadedScenario loaded;
  try {
    loaded.text = text;
    loaded.json = scenarios::parse_json(text);
    // --seed works on a scenario without settings, too.
    if (loaded.json.is_object() && !loaded.json.contains("simulation"))
      loaded.json["simulation"] = nlohmann::json::object();
    loaded.json = scenarios::apply(std::move(loaded.json), changes);
    loaded.scenario = scenarios::load(loaded.json);
  } catch (const InputError& e) {
    throw UsageError(fmt::format("{}: {}", where, e.what()));
  }
  return loaded;
}

namespace {

/// What the same bits take besides the version: the C library picks fused instructions where the processor
/// has them.
std::string platform() {
  const bool fma = __builtin_cpu_supports("fma") != 0;
  return fmt::format("x86-64{}, glibc {}", fma ? " with FMA" : "", gnu_get_libc_version());
}

/// The first line is for scripts, the second for a report: what it was built from and what it runs on.
std::string version_text() {
  return fmt::format("verstat {}\nbuilt by g++ {} with Boost {}, {{fmt}} {}.{}.{}; runs on {}, SQLite {}",
                     VERSTAT_VERSION, __VERSION__, BOOST_LIB_VERSION, FMT_VERSION / 10000,
                     FMT_VERSION / 100 % 100, FMT_VERSION % 100, platform(), sqlite3_libversion());
}

}  // namespace

store::Provenance provenance() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {.version = VERSTAT_VERSION,
          .platform = platform(),
          .created = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))};
}

void exit_with(int code) {
  if (code != success) throw CLI::RuntimeError(code);
}

namespace {

// Errors repeat names from files of strangers: on a terminal, control characters would do as they please.
std::string harmless(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

}  // namespace

void print_warnings(const std::vector<scenarios::Warning>& warnings) {
  for (const scenarios::Warning& warning : warnings)
    fmt::print(stderr, "warning: {}: {}\n", warning.pointer, harmless(warning.text));
}

namespace {

int report(const std::string& text, ExitCode code) {
  const bool colour = isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  fmt::print(stderr, "{}error:{} {}\n", colour ? "\033[31m" : "", colour ? "\033[0m" : "", harmless(text));
  return code;
}

// Answers as JSON and the database hold texts, and what is typed stands in them.
void check_text(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    std::string word = argv[k];
    if (store::is_utf8(word)) continue;
    for (char& c : word)
      if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    throw UsageError(
        fmt::format("argument {}, \"{}\", is not UTF-8 text; rename the file or type it anew in a "
                    "terminal that writes UTF-8",
                    k, models::shortened(word, 200)));
  }
}

struct Command {
  std::string_view name;
  void (*add)(CLI::App& program);
};
constexpr std::array commands = {Command{"validate", add_validate},   Command{"run", add_run},
                                 Command{"compare", add_compare},     Command{"sweep", add_sweep},
                                 Command{"losses", add_losses},       Command{"optimize", add_optimize},
                                 Command{"plan", add_plan},           Command{"models", add_models},
                                 Command{"runs", add_runs},           Command{"fit", add_fit},
                                 Command{"calibrate", add_calibrate}, Command{"serve", add_serve},
                                 Command{"schema", add_schema},       Command{"trace", add_trace},
                                 Command{"graph", add_graph}};

// Describes the command that is asked for; all of them for the help of the whole program.
void add_commands(CLI::App& program, const std::string& asked) {
  for (const Command& command : commands)
    if (asked == command.name) return command.add(program);
  // CLI11 would only say that a sub-command is required.
  if (!asked.empty() && asked.front() != '-') {
    std::vector<std::string> names;
    for (const Command& command : commands) names.emplace_back(command.name);
    throw UsageError(
        fmt::format("there is no command \"{}\"; closest: \"{}\" (verstat --help shows what there is)", asked,
                    models::closest(asked, names)));
  }
  for (const Command& command : commands) command.add(program);
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program(
      "Verstat simulates machining shops and finds the regimes, change ages and crews that pay.\n"
      "Cutting times, tool lives and failures come from published process models.");
  program.name("verstat");
  program.set_version_flag("--version", version_text());
  program.require_subcommand(1);
  program.footer(
      "Example:\n  verstat run scenarios/gallery/heavy-lathe.json --set /tools/0/strategy/gamma=0.47");
  try {
    check_text(argc, argv);
    add_commands(program, argc < 2 ? "" : argv[1]);
    program.parse(argc, argv);
    return success;
  } catch (const CLI::Success& e) {  // --help, --version
    return program.exit(e);
  } catch (const CLI::RuntimeError& e) {  // exit_with
    return e.get_exit_code();
  } catch (const CLI::ParseError& e) {
    std::string text = e.what();
    for (char& c : text)
      if (c == '\n') c = ' ';
    return report(text + " (verstat --help shows what there is)", bad_input);
  } catch (const UsageError& e) {
    return report(e.what(), bad_input);
  } catch (const InputError& e) {
    return report(e.what(), bad_input);
  } catch (const models::ModelError& e) {
    return report(e.what(), bad_input);
  } catch (const sim::BudgetError& e) {
    return report(e.what(), bad_input);
  } catch (const optimize::Interrupted& e) {
    return report(fmt::format("ended early: {}", e.what()), ExitCode::interrupted);
  } catch (const store::StoreError& e) {
    return report(e.what(), failure);
  } catch (const std::bad_alloc&) {
    return report("out of memory: fewer machines, replications or threads need less", failure);
  } catch (const std::exception& e) {
    return report(e.what(), failure);
  }
}

}  // namespace verstat::app
