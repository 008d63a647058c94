// verstat optimize: find the best plan of a study and confirm it by simulation.
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/progress.h"
#include "app/results.h"
#include "optimize/study.h"
#include "store/database.h"
#include "store/result_json.h"

namespace verstat::app {

namespace {

using nlohmann::ordered_json;

ordered_json point(const optimize::StudySpec& study, const std::vector<double>& x) {
  ordered_json values = ordered_json::array();
  for (std::size_t k = 0; k < x.size(); ++k)
    values.push_back({{"name", study.variables[k].name},
                      {"pointer", study.variables[k].pointer},
                      {"unit", study.variables[k].unit},
                      {"value", x[k]}});
  return values;
}

ordered_json number_or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

// What the study found, in numbers and in words.
ordered_json result_of(const optimize::StudySpec& study, const std::string& currency,
                       const optimize::AnalyticOutcome& analytic,
                       const optimize::Confirmation& confirmation) {
  const auto kpi = *confirmation.baseline.index_of(study.objective.kpi);
  const auto estimate = [&](const shop::RunResult& run) {
    return ordered_json{{"mean", number_or_null(run.estimates[kpi].mean)},
                        {"half_width_95", number_or_null(run.estimates[kpi].half_width)}};
  };
  const auto base = confirmation.baseline.estimates[kpi].mean;
  const auto saving = confirmation.saving.mean;
  const auto half = confirmation.saving.half_width;
  std::string words = "The best plan and today's could not be compared.";
  if (base && saving && half && *base > 0) {
    const double percent = 100 * *saving / *base;
    const double percent_half = 100 * *half / *base;
    if (confirmation.verdict == "not distinguishable") {
      words = fmt::format(
          "The best plan and today's cannot be told apart: {:.2f} +- {:.2f} % of the cost per part.", percent,
          percent_half);
    } else {
      words =
          fmt::format("The best plan costs {:.2f} +- {:.2f} % {} per part: {:.2f} +- {:.2f} {} of {:.2f} {}.",
                      std::abs(percent), percent_half, percent > 0 ? "less" : "more", std::abs(*saving),
                      *half, currency, *base, currency);
    }
  }
  return {{"objective", study.objective.kpi},
          {"unit", currency},
          {"baseline",
           {{"values", point(study, analytic.baseline)},
            {"analytic", analytic.baseline_value},
            {"simulated", estimate(confirmation.baseline)}}},
          {"best",
           {{"values", point(study, analytic.search.best.x)},
            {"analytic", analytic.search.best.value},
            {"simulated", estimate(confirmation.best)}}},
          {"evaluations", analytic.search.evaluations.size()},
          {"saving",
           {{"mean", number_or_null(saving)},
            {"half_width", number_or_null(half)},
            {"confidence", study.confirmation.confidence}}},
          {"verdict", confirmation.verdict},
          {"words", words}};
}

struct LoadedStudy {
  std::string text;
  optimize::StudySpec spec;
  std::string scenario_file;
};

LoadedStudy load_study_file(const std::string& file) {
  LoadedStudy study;
  try {
    study.text = scenarios::read_text_file(file);
    study.spec = optimize::load_study(scenarios::parse_json(study.text));
  } catch (const scenarios::InputError& e) {
    throw UsageError(fmt::format("study {}: {}", file, e.what()));
  }
  study.scenario_file = (std::filesystem::path(file).parent_path() / study.spec.scenario).string();
  return study;
}

void print_result(const ordered_json& result) {
  fmt::print("{:<28} {:>14} {:>14}\n", "", "today", "best");
  const auto& today = result["baseline"];
  const auto& best = result["best"];
  for (std::size_t k = 0; k < best["values"].size(); ++k) {
    const std::string unit = best["values"][k]["unit"].get<std::string>();
    fmt::print("{:<28} {:>14.6g} {:>14.6g}  {}\n", best["values"][k]["name"].get<std::string>(),
               today["values"][k]["value"].get<double>(), best["values"][k]["value"].get<double>(),
               unit == "1" ? "" : unit);
  }
  const std::string unit = result["unit"].get<std::string>();
  fmt::print("{:<28} {:>14.6g} {:>14.6g}  {}\n", "cost per part, long run", today["analytic"].get<double>(),
             best["analytic"].get<double>(), unit);
  const auto simulated = [](const ordered_json& side) {
    const auto& s = side["simulated"];
    const auto value = [](const ordered_json& j) {
      return j.is_null() ? std::nullopt : std::optional(j.get<double>());
    };
    return shown(value(s["mean"]), value(s["half_width_95"]));
  };
  fmt::print("{:<28} {:>14} {:>14}  {}\n\n{}\n", "cost per part, simulated", simulated(today),
             simulated(best), unit, result["words"].get<std::string>());
}

}  // namespace

void add_optimize(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto file = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("optimize", "Find the best plan of a study, confirm it by simulation");
  command->add_option("STUDY", *file, "study file (JSON)")->required();
  add_json(*command, *options);
  add_db(*command, *options);
  add_run_options(*command, *options);
  command->footer(
      "Example:\n  verstat optimize scenarios/gallery/heavy-lathe.study.json\n"
      "Stage one minimises the long-run cost per part with NLopt; stage two simulates today's plan and the "
      "best one\n"
      "with the same random numbers, so that the saving comes with an interval. --replications is that of "
      "stage two.");
  command->callback([options, file] {
    LoadedStudy study = load_study_file(*file);
    const auto changes = changes_of(*options);
    const LoadedScenario loaded = load_scenario(study.scenario_file, changes);
    if (!options->replications.empty())
      study.spec.confirmation.replications = loaded.scenario.simulation.replications;
    if (study.spec.confirmation.replications < 2)
      throw UsageError("--replications 1: a comparison needs at least 2 pairs of replications");
    const int threads = thread_count(*options);

    optimize::AnalyticOutcome analytic;
    try {
      analytic = optimize::optimize_analytic(study.spec, loaded.json);
    } catch (const scenarios::InputError& e) {
      throw UsageError(fmt::format("study {}: {}", *file, e.what()));
    }

    // Everything asked for is valid: only now is the database touched.
    store::Writer writer(options->db);
    store::Study record;
    record.header = {.name = study.spec.name,
                     .scenario_name = loaded.scenario.name,
                     .objective = study.spec.objective.kpi,
                     .seed = loaded.scenario.simulation.seed.value,
                     .provenance = provenance()};
    record.study_text = study.text;
    record.scenario_text = loaded.text;
    record.changes = changes_text(changes);
    for (const auto& v : study.spec.variables)
      record.variables.push_back({v.name, v.pointer, v.unit, v.low, v.high});
    const std::int64_t id = writer.begin_study(record);
    std::vector<store::Trial> trials;
    for (const auto& e : analytic.search.evaluations) {
      const bool finite = std::isfinite(e.value);
      trials.push_back({.number = static_cast<std::int64_t>(trials.size()) + 1,
                        .stage = "analytic",
                        .values = e.x,
                        .objective = finite ? std::optional(e.value) : std::nullopt,
                        .feasible = finite});
    }
    writer.add_trials(id, trials);

    const auto start = std::chrono::steady_clock::now();
    optimize::Confirmation confirmation;
    {
      ProgressBar bar("confirmation");
      confirmation = optimize::confirm(study.spec, loaded.json, analytic.search.best.x, threads,
                                       [&](std::int64_t done, std::int64_t of) { bar.update(done, of); });
    }
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto keep = [&](const shop::RunResult& run, std::vector<scenarios::Change> made, const char* what) {
      made.insert(made.begin(), changes.begin(), changes.end());
      made.push_back({"/simulation/replications", study.spec.confirmation.replications});
      return writer.add_run(
          record_of(run, loaded, made, fmt::format("study {}: {}", id, what), elapsed_s / 2));
    };
    const std::int64_t baseline = keep(confirmation.baseline, {}, "today");
    const std::int64_t best =
        keep(confirmation.best, optimize::changes_at(study.spec, analytic.search.best.x), "best");
    const ordered_json result = result_of(study.spec, loaded.scenario.currency, analytic, confirmation);
    writer.finish_study(id, baseline, best, result.dump(), "finished");

    if (options->json) {
      ordered_json answer = {
          {"study", id}, {"name", study.spec.name}, {"baseline_run", baseline}, {"best_run", best}};
      answer.update(result);
      fmt::print("{}\n", answer.dump(2));
    } else {
      fmt::print("{}\n\n", study.spec.name);
      print_result(result);
      fmt::print("\nstudy {} in {}: {} trials, runs {} (today) and {} (best)\n", id, options->db,
                 trials.size(), baseline, best);
    }
  });
}

}  // namespace verstat::app
