// verstat optimize: find the best plan of a study and confirm it by simulation; go on where one stopped.
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/elsewhere.h"
#include "app/files.h"
#include "app/interrupt.h"
#include "app/study_report.h"
#include "app/study_session.h"
#include "models/catalogue/error.h"
#include "models/catalogue/shortened.h"

namespace verstat::app {

namespace {

using nlohmann::ordered_json;
using optimize::Problem;
using scenarios::Change;

struct OptimizeOptions {
  CommonOptions common;
  std::string file;
  std::string resume;
  std::string progress = "bar";
  std::string plan_file;
  std::string time_s;
};

// Everything that a study is made of, from files or from the database.
struct Prepared {
  std::string where;  // for messages
  std::string text;
  optimize::StudySpec spec;
  std::vector<Change> changes;  // of the command line
  LoadedScenario loaded;        // with all changes, the study's fixed ones first
};

Prepared prepare(const std::string& where, const std::string& study_text, const std::string& scenario_where,
                 const std::string& scenario_text, std::vector<Change> changes) {
  Prepared p{.where = where, .text = study_text, .changes = std::move(changes)};
  try {
    p.spec = optimize::load_study(scenarios::parse_json(study_text));
  } catch (const scenarios::InputError& e) {
    throw UsageError(fmt::format("{}: {}", where, e.what()));
  }
  std::vector<Change> all = optimize::fixed_changes(p.spec);
  all.insert(all.end(), p.changes.begin(), p.changes.end());
  p.loaded = load_scenario_text(scenario_text, scenario_where, all);
  return p;
}

Prepared prepare_files(const OptimizeOptions& options) {
  const std::string where = "study " + options.file;
  std::string text;
  std::string scenario_file;
  try {
    text = scenarios::read_text_file(options.file);
    const auto spec = optimize::load_study(scenarios::parse_json(text));
    scenario_file = (std::filesystem::path(options.file).parent_path() / spec.scenario).string();
  } catch (const scenarios::InputError& e) {
    throw UsageError(fmt::format("{}: {}", where, e.what()));
  }
  const std::string scenario_text = read_scenario_text(scenario_file);
  return prepare(where, text, "scenario " + scenario_file, scenario_text, changes_of(options.common));
}

double seconds(const std::string& text) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value > 0) || value > 1e9)
    throw UsageError(fmt::format("--time {}: must be seconds above 0", models::shortened(text, 100)));
  return value;
}

store::Study record_of(const Prepared& p) {
  store::Study record;
  record.header = {.name = p.spec.name,
                   .scenario_name = p.loaded.scenario.name,
                   .objective = p.spec.objective.label(),
                   .seed = p.loaded.scenario.simulation.seed.value,
                   .provenance = provenance()};
  record.study_text = p.text;
  record.scenario_text = p.loaded.text;
  record.changes = changes_text(p.changes);
  for (const auto& v : p.spec.variables) {
    store::Variable one{v.name, v.pointer, v.unit, v.low, v.high};
    if (v.type == optimize::VariableType::integer) one.type = "integer";
    if (v.type == optimize::VariableType::categorical) {
      one.type = "categorical";
      ordered_json texts = ordered_json::array();
      for (std::size_t o = 0; o < v.options.size(); ++o)
        texts.push_back(ordered_json(optimize::value_at(v, static_cast<double>(o))));
      one.options = texts.dump();
    }
    record.variables.push_back(std::move(one));
  }
  return record;
}

// What is in the way when nothing is feasible: of the plan the search came to, the constraint missed most.
std::string nearest_miss(Problem& problem, const optimize::StudyAnswer& answer) {
  if (!answer.analytic) return {};
  try {
    const auto look = problem.look(answer.analytic->x);
    std::size_t worst = 0;
    for (std::size_t k = 1; k < look.conditions.size(); ++k)
      if (look.conditions[k].margin < look.conditions[worst].margin) worst = k;
    if (look.conditions.empty()) return {};
    const auto& c = problem.conditions()[worst];
    return fmt::format("the nearest one has {} {:.6g} {}, {} {:.6g} is needed", c.name,
                       look.conditions[worst].value, c.unit == "1" ? "" : c.unit,
                       c.at_most ? "at most" : "at least", look.conditions[worst].allowed);
  } catch (const std::exception& e) {
    return e.what();
  }
}

// The time between Ctrl-C and the answer is kept short: nothing new is asked.
void analyse(Problem& problem, StudyFindings& findings) {
  const auto& best = *findings.answer.best;
  const auto seed = problem.typed_scenario_at(best.x).simulation.seed.value;
  const auto search = optimize::search_options(problem.study(), seed);
  if (problem.study().objective.function.empty())
    findings.one_cut =
        optimize::one_cut_optima(scenarios::load(problem.scenario_at(best.x)),
                                 findings.confirmation ? &findings.confirmation->best : nullptr);
  if (!problem.not_covered().empty() || problem.study().objectives.size() > 1) return;
  // Of the best plan in the long run: what simulation moved it by is no constraint.
  const std::vector<double>& x = findings.answer.analytic ? findings.answer.analytic->x : best.x;
  if (!findings.answer.analytic || !findings.answer.analytic->feasible) return;
  findings.binding = optimize::binding_constraints(problem, x, search);
  findings.sensitivity = optimize::sensitivities(problem, x, search);
}

// From the first trial to the answer.
int run_session(const OptimizeOptions& options, const Prepared& p, Problem& problem, StudySession& session,
                int threads) {
  const optimize::StudySpec& study = p.spec;
  session.set_budget(options.time_s.empty() ? study.budget.time_s : seconds(options.time_s),
                     study.budget.trials);

  const optimize::StudyTools tools{
      .simulate = session.simulate(threads),
      .progress = [&](const optimize::StudyProgress& now) { session.progress(now); }};
  StudyFindings findings{.study = study,
                         .answer = optimize::run_study(problem, session.ledger(), tools),
                         .currency = p.loaded.scenario.currency,
                         .id = session.id()};
  findings.trials = session.trials();
  optimize::StudyAnswer& answer = findings.answer;
  if (!answer.best && answer.interrupted.empty()) findings.nearest_miss = nearest_miss(problem, answer);
  if (answer.best) {
    try {
      const auto look = problem.look(answer.best->x);
      if (!look.objectives.empty()) findings.best_long_run = look.objectives[0];
    } catch (const std::exception&) {
      // Simulated only.
    }
  }
  const bool simulated = study.objective.function.empty();
  if (answer.best && answer.interrupted.empty() && !simulated) analyse(problem, findings);
  if (answer.best && answer.interrupted.empty() && simulated) try {
      std::vector<Change> made = optimize::fixed_changes(study);
      made.insert(made.end(), p.changes.begin(), p.changes.end());
      const auto confirm_with =
          optimize::confirmation_changes(study, p.loaded.scenario.simulation.seed.value);
      made.insert(made.end(), confirm_with.begin(), confirm_with.end());
      const std::int64_t all = 2 * study.confirmation.replications;
      const auto run = [&](bool baseline, const std::vector<Change>& changes) {
        const LoadedScenario loaded = load_scenario_text(p.loaded.text, p.where, changes);
        return session.run_once(baseline, loaded, changes, baseline ? "today" : "best", [&] {
          const std::int64_t before = baseline ? 0 : study.confirmation.replications;
          return simulate_anywhere(loaded.scenario, 0, loaded.scenario.simulation.replications, threads,
                                   [&](std::int64_t done, std::int64_t) {
                                     session.ledger().check();
                                     session.progress("confirmation", before + done, all);
                                   });
        });
      };
      shop::RunResult today = run(true, made);
      const auto best = optimize::changes_at(study.variables, answer.best->x);
      made.insert(made.end(), best.begin(), best.end());
      findings.confirmation = optimize::confirm(study, std::move(today), run(false, made));
      // What today's plan owes by simulation, too.
      for (const auto& c : problem.conditions()) {
        if (c.kind != optimize::Condition::Kind::kpi) continue;
        const auto k = findings.confirmation->baseline.index_of(c.item);
        if (!k || !findings.confirmation->baseline.estimates[*k].mean) continue;
        const double mean = *findings.confirmation->baseline.estimates[*k].mean;
        if (c.at_most ? mean > c.allowed : mean < c.allowed) answer.baseline_feasible = false;
      }
      analyse(problem, findings);
    } catch (const optimize::Interrupted& why) {
      answer.interrupted = why.what();
    }
  const ordered_json result = to_json(findings);
  const bool ended_early = !answer.interrupted.empty();
  session.finish(result.dump(), ended_early ? "interrupted" : "finished");

  if (!options.plan_file.empty() && answer.best) {
    std::vector<Change> plan = optimize::fixed_changes(study);
    plan.insert(plan.end(), p.changes.begin(), p.changes.end());
    const auto best = optimize::changes_at(study.variables, answer.best->x);
    plan.insert(plan.end(), best.begin(), best.end());
    write_file("--write-plan", options.plan_file, changed_text(p.loaded.text, plan));
  }
  if (options.common.json) {
    const auto number = [](const std::optional<std::int64_t>& run) {
      return run ? ordered_json(*run) : ordered_json(nullptr);
    };
    ordered_json out = {{"name", study.name},
                        {"baseline_run", number(session.baseline_run())},
                        {"best_run", number(session.best_run())}};
    out.update(result);
    print_json(session.id(), out);
  } else {
    fmt::print("{}\n\n", study.name);
    print_findings(result);
    fmt::print("\nstudy {} in {}: {} trials", session.id(), options.common.db, session.trials());
    if (session.baseline_run() && session.best_run())
      fmt::print(", runs {} (today) and {} (best)", *session.baseline_run(), *session.best_run());
    fmt::print("\n");
    if (!options.plan_file.empty() && answer.best) fmt::print("the best plan is {}\n", options.plan_file);
  }
  return end_asked() ? static_cast<int>(ExitCode::interrupted) : static_cast<int>(success);
}

int optimize_study(OptimizeOptions& options) {
  check_progress(options.progress);
  const bool resumed = !options.resume.empty();
  if (options.file.empty() && !resumed) throw UsageError("optimize: which STUDY? (or --resume NUMBER)");
  if (resumed &&
      (!options.common.set.empty() || !options.common.seed.empty() || !options.common.replications.empty()))
    throw UsageError(
        "--resume: the study goes on as it was begun; --set, --seed and --replications cannot be given");
  const int threads = thread_count(options.common);

  std::optional<Prepared> p;
  std::unique_ptr<StudySession> session;
  if (resumed) {
    const std::int64_t id = study_number(options.resume);
    session = std::make_unique<StudySession>(options.common.db, id, "optimize", options.progress);
    const store::Study& record = session->record();
    if (!options.file.empty() && scenarios::read_text_file(options.file) != record.study_text)
      throw UsageError(
          fmt::format("--resume {}: {} is not the study that was begun; leave the file out, or begin anew",
                      id, options.file));
    const std::string where = fmt::format("study {} of {}", id, options.common.db);
    p = prepare(where, record.study_text, "scenario of " + where, record.scenario_text,
                changes_from_text(record.changes));
  } else {
    p = prepare_files(options);
  }
  // --replications is that of the confirmation; a resumed study has it among its changes.
  for (const Change& change : p->changes)
    if (change.pointer == "/simulation/replications")
      p->spec.confirmation.replications = p->loaded.scenario.simulation.replications;
  if (p->spec.confirmation.replications < 2)
    throw UsageError("--replications 1: a comparison needs at least 2 pairs of replications");

  const optimize::StudySpec& study = p->spec;
  std::unique_ptr<Problem> problem;
  try {
    problem = std::make_unique<Problem>(study, p->loaded.json);
    // Ends nothing and computes nothing: what the stages would refuse is said before the database is touched.
    optimize::check_study(*problem);
  } catch (const scenarios::InputError& e) {
    throw UsageError(fmt::format("{}: {}", p->where, e.what()));
  }
  if (session == nullptr)
    session = std::make_unique<StudySession>(options.common.db, record_of(*p), options.progress);
  try {
    return run_session(options, *p, *problem, *session, threads);
  } catch (const store::StoreError& error) {
    throw with_way_on(error, "optimize", *session);
  }
}

}  // namespace

void add_optimize(CLI::App& program) {
  auto options = std::make_shared<OptimizeOptions>();
  CLI::App* command =
      program.add_subcommand("optimize", "Find the best plan of a study, confirm it by simulation");
  command->add_option("STUDY", options->file, "study file (JSON)");
  command->add_option("--resume", options->resume, "go on with this study of the database");
  command->add_option("--write-plan", options->plan_file, "write the best plan as a scenario file");
  command->add_option("--time", options->time_s,
                      "end after so many seconds, with the best so far (can be resumed)");
  add_progress(*command, options->progress);
  add_json(*command, options->common);
  add_db(*command, options->common);
  add_run_options(*command, options->common);
  command->footer(
      "Example:\n  verstat optimize scenarios/gallery/heavy-lathe.study.json\n"
      "Stage one minimises the long-run model with NLopt, stage two refines by simulation and stage three "
      "chooses\n"
      "among the finalists with fresh random numbers, when the study asks for them; then today's plan and "
      "the best\n"
      "one are simulated with the same random numbers, so that the saving comes with an interval. "
      "--replications is\n"
      "that of this last comparison. Every finished trial is kept: --resume goes on after Ctrl-C or a "
      "crash.");
  command->callback([options] { exit_with(optimize_study(*options)); });
}

}  // namespace verstat::app
