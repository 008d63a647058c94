#pragma once
// What the sub-commands share: options, output, exit codes. One file per sub-command beside this one.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/load.h"
#include "scenarios/warnings.h"
#include "store/records.h"

namespace verstat::app {

/// Exit codes of the program.
enum ExitCode : int {
  success = 0,
  failure = 1,    ///< something went wrong that no better input would mend
  bad_input = 2,  ///< a file, flag, pointer or value is wrong; nothing was done
  interrupted = 130
};

/// Bad input, said in one line.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Options that most sub-commands know.
struct CommonOptions {
  bool json = false;
  std::string db = "verstat.db";
  std::string seed;
  std::string replications;
  std::string threads;
  std::vector<std::string> set;
  std::vector<std::string> changes;  ///< files
  std::vector<std::string> use;      ///< library entries, POINTER=FILE
};
void add_json(CLI::App& command, CommonOptions& options);
void add_db(CLI::App& command, CommonOptions& options);
/// --set, --changes, --use
void add_changes(CLI::App& command, CommonOptions& options);
/// --seed, --replications, --threads, --set, --changes, --use
void add_run_options(CLI::App& command, CommonOptions& options);

/// Threads to use: --threads, else as many as the machine has. Throws UsageError.
[[nodiscard]] int thread_count(const CommonOptions& options);
/// The changes of --use entries, of --changes files, of --set, then --seed and --replications as changes of
/// the simulation settings. Throws InputError.
[[nodiscard]] std::vector<scenarios::Change> changes_of(const CommonOptions& options);
[[nodiscard]] std::string changes_text(const std::vector<scenarios::Change>& changes);

/// A scenario file with the changes made and checked. Errors name the file.
struct LoadedScenario {
  std::string text;     ///< of the file
  nlohmann::json json;  ///< with the changes
  scenarios::Scenario scenario;
};
[[nodiscard]] LoadedScenario load_scenario(const std::string& file,
                                           const std::vector<scenarios::Change>& changes);
/// The same of a text; `where` names it in errors.
[[nodiscard]] LoadedScenario load_scenario_text(const std::string& text, const std::string& where,
                                                const std::vector<scenarios::Change>& changes);
/// The text of a scenario file, with the CSV tables of orders that it names read in. Throws UsageError.
[[nodiscard]] std::string read_scenario_text(const std::string& file);

/// A line on stderr for each: what a shop can be run with and should not be.
void print_warnings(const std::vector<scenarios::Warning>& warnings);

/// Program version, and processor and C library (results agree bit for bit where both are the same).
[[nodiscard]] store::Provenance provenance();

/// Ends a sub-command with an exit code, from within its callback.
void exit_with(int code);

/// Registers each sub-command; the returned callbacks run when it is chosen.
void add_validate(CLI::App& program);
void add_run(CLI::App& program);
void add_optimize(CLI::App& program);
void add_compare(CLI::App& program);
void add_sweep(CLI::App& program);
void add_losses(CLI::App& program);
void add_models(CLI::App& program);
void add_runs(CLI::App& program);
void add_schema(CLI::App& program);
void add_plan(CLI::App& program);
void add_serve(CLI::App& program);
void add_fit(CLI::App& program);
void add_calibrate(CLI::App& program);
void add_trace(CLI::App& program);
void add_graph(CLI::App& program);

/// Runs the whole program; returns its exit code.
[[nodiscard]] int run_program(int argc, char** argv);

}  // namespace verstat::app
