// verstat compare: two or more variants under common random numbers, until the difference is clear.
#include "optimize/compare.h"

#include <cmath>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/interrupt.h"
#include "app/results.h"
#include "app/study_session.h"
#include "app/table.h"
#include "models/catalogue/shortened.h"

namespace verstat::app {

namespace {

using nlohmann::ordered_json;

struct CompareCommand {
  CommonOptions common;
  std::vector<std::string> files;
  std::vector<std::string> variants;
  std::vector<std::string> kpis;
  std::string confidence = "0.95";
  std::string indifference = "0.005";
  std::string max_replications = "320";
  std::string progress = "bar";
};

struct Variant {
  std::string name;
  std::string file;
  std::vector<scenarios::Change> changes;
  LoadedScenario loaded;
};

double number(const std::string& flag, const std::string& text, double low, double high) {
  double value = 0;
  try {
    std::size_t used = 0;
    value = std::stod(text, &used);
    if (used != text.size()) value = std::nan("");
  } catch (const std::exception&) {
    value = std::nan("");  // said below
  }
  if (!(value > low && value < high))
    throw UsageError(fmt::format("{} {}: must be a number above {:g} and below {:g}", flag,
                                 models::shortened(text, 100), low, high));
  return value;
}

// "NAME: POINTER=VALUE; POINTER=VALUE"
std::pair<std::string, std::vector<scenarios::Change>> parse_variant(const std::string& text) {
  const auto colon = text.find(':');
  const auto slash = text.find('/');
  if (colon == std::string::npos || slash == std::string::npos || colon > slash || colon == 0)
    throw UsageError(fmt::format("--variant {}: must be NAME: POINTER=VALUE; POINTER=VALUE; ...",
                                 models::shortened(text, 200)));
  std::vector<scenarios::Change> changes;
  std::string rest = text.substr(colon + 1);
  while (!rest.empty()) {
    // A semicolon that begins the next pointer: values may contain others.
    std::size_t end = rest.size();
    std::size_t next = rest.size();
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (rest[k] != ';') continue;
      const auto after = rest.find_first_not_of(' ', k + 1);
      if (after != std::string::npos && rest[after] == '/') {
        end = k;
        next = after;
        break;
      }
    }
    const auto begin = rest.find_first_not_of(' ');
    changes.push_back(scenarios::parse_change(rest.substr(begin, end - begin)));
    rest = rest.substr(next);
  }
  return {text.substr(0, colon), std::move(changes)};
}

std::vector<Variant> variants_of(const CompareCommand& c) {
  const auto common = changes_of(c.common);
  std::vector<Variant> all;
  for (const std::string& file : c.files) all.push_back({file, file, common, {}});
  for (const std::string& text : c.variants) {
    auto [name, changes] = parse_variant(text);
    changes.insert(changes.begin(), common.begin(), common.end());
    all.push_back({name, c.files.front(), std::move(changes), {}});
  }
  if (all.size() < 2)
    throw UsageError("compare: needs two scenario files, or one and a --variant \"NAME: POINTER=VALUE\"");
  for (Variant& v : all) v.loaded = load_scenario(v.file, v.changes);
  // The same random numbers and the same time for all: those of the first.
  const auto& first = all.front().loaded.scenario.simulation;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const auto& own = all[k].loaded.scenario.simulation;
    if (own.horizon_min != first.horizon_min || own.warmup_min != first.warmup_min)
      throw UsageError(fmt::format(
          "compare: {} simulates {:g} min after {:g}, {} {:g} after {:g}; make them equal with --set "
          "/simulation/horizon_min=... and /simulation/warmup_min=...",
          all[k].name, own.horizon_min, own.warmup_min, all.front().name, first.horizon_min,
          first.warmup_min));
    if (own.seed.value != first.seed.value) {
      all[k].changes.push_back({"/simulation/seed", std::to_string(first.seed.value)});
      all[k].loaded = load_scenario(all[k].file, all[k].changes);
    }
  }
  return all;
}

constexpr const char* verdict_text(optimize::Verdict v) {
  switch (v) {
    case optimize::Verdict::less:
      return "less";
    case optimize::Verdict::more:
      return "more";
    case optimize::Verdict::unchanged:
      return "unchanged";
    case optimize::Verdict::unclear:
      break;
  }
  return "unclear";
}

void compare_variants(const CompareCommand& c) {
  check_progress(c.progress);
  std::vector<Variant> variants = variants_of(c);
  optimize::CompareOptions options;
  if (!c.kpis.empty()) options.kpis = c.kpis;
  options.confidence = number("--confidence", c.confidence, 0.5, 1);
  options.indifference = number("--indifference", c.indifference, 0, 1);
  options.max_replications =
      static_cast<std::int64_t>(number("--max-replications", c.max_replications, 3, 1e5));
  // A fixed number when it is asked for.
  if (!c.common.replications.empty()) {
    options.first_replications = variants.front().loaded.scenario.simulation.replications;
    options.max_replications = options.first_replications;
    if (options.first_replications < 2)
      throw UsageError("--replications 1: a comparison needs at least 2 pairs");
  }
  options.first_replications = std::min(options.first_replications, options.max_replications);
  for (const Variant& v : variants)
    for (const std::string& kpi : options.kpis) {
      const auto infos = shop::kpi_infos(v.loaded.scenario);
      if (std::none_of(infos.begin(), infos.end(), [&](const auto& i) { return i.name == kpi; }))
        throw UsageError(
            fmt::format("--kpi {}: there is no such KPI in {}", models::shortened(kpi, 100), v.name));
    }
  const int threads = thread_count(c.common);

  store::Study record;
  std::string title;
  for (const Variant& v : variants) title += (title.empty() ? "" : " / ") + v.name;
  record.header = {.name = std::string(models::shortened(title, 200)),
                   .scenario_name = variants.front().loaded.scenario.name,
                   .objective = options.kpis.front(),
                   .seed = variants.front().loaded.scenario.simulation.seed.value,
                   .provenance = provenance(),
                   .kind = "compare"};
  record.scenario_text = variants.front().loaded.text;
  record.changes = changes_text(variants.front().changes);
  ordered_json asked = {{"variants", ordered_json::array()},
                        {"kpis", options.kpis},
                        {"confidence", options.confidence},
                        {"indifference", options.indifference},
                        {"max_replications", options.max_replications}};
  for (const Variant& v : variants)
    asked["variants"].push_back(
        {{"name", v.name}, {"file", v.file}, {"changes", ordered_json::parse(changes_text(v.changes))}});
  record.study_text = asked.dump();

  StudySession session(c.common.db, std::move(record), c.progress);
  const auto start = std::chrono::steady_clock::now();
  const optimize::Simulate simulate = session.simulate(threads);
  std::int64_t done = 0;
  optimize::Comparison comparison;
  try {
    comparison = optimize::compare(
        variants.size(),
        [&](std::size_t v, std::uint64_t first, std::int64_t count) {
          shop::RunResult run = simulate(variants[v].loaded.scenario, first, count);
          done += count;
          session.progress("replications", done,
                           static_cast<std::int64_t>(variants.size()) * options.max_replications);
          return run;
        },
        options);
  } catch (const optimize::Interrupted&) {
    session.finish("{}", "interrupted");
    throw;
  }
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  ordered_json result = {{"replications", comparison.replications},
                         {"confidence", options.confidence},
                         {"clear", comparison.clear},
                         {"variants", ordered_json::array()}};
  std::vector<std::int64_t> runs;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    std::vector<scenarios::Change> made = variants[v].changes;
    made.push_back({"/simulation/replications", comparison.replications});
    runs.push_back(session.writer().add_run(record_of(
        comparison.runs[v], variants[v].loaded, made,
        std::string(models::shortened(fmt::format("study {}: {}", session.id(), variants[v].name), 200)),
        elapsed_s / static_cast<double>(variants.size()))));
    if (v < 2) session.writer().set_study_run(session.id(), v == 0, runs.back());
    ordered_json one = {{"name", variants[v].name}, {"run", runs.back()}};
    if (v > 0) {
      one["differences"] = ordered_json::array();
      for (const optimize::Difference& d : comparison.differences[v - 1]) {
        one["differences"].push_back({{"kpi", d.kpi},
                                      {"unit", d.unit},
                                      {"first", estimate_json(d.first)},
                                      {"this", estimate_json(d.other)},
                                      {"difference", estimate_json(d.difference)},
                                      {"verdict", verdict_text(d.verdict)}});
      }
      one["words"] = optimize::in_words(variants[v].name, comparison.differences[v - 1]);
    }
    result["variants"].push_back(std::move(one));
  }
  result["words"] = result["variants"][1]["words"];
  session.writer().finish_study(session.id(), runs[0], runs[1], result.dump(), "finished");

  if (c.common.json) {
    print_json(session.id(), result);
    return;
  }
  fmt::print("{} replications of each variant under the same random numbers, against {}{}\n\n",
             comparison.replications, variants[0].name,
             comparison.clear ? "" : " (the budget ended before the first KPI was clear)");
  for (std::size_t v = 1; v < variants.size(); ++v) {
    fmt::print("{}\n", result["variants"][v]["words"].get<std::string>());
    Table table("lrrrl", "  ");
    table.add({"", variants[0].name, variants[v].name, "difference"});
    for (const optimize::Difference& d : comparison.differences[v - 1])
      table.add({d.kpi, shown(d.first.mean, d.first.half_width), shown(d.other.mean, d.other.half_width),
                 shown(d.difference.mean, d.difference.half_width), d.unit == "1" ? "" : d.unit});
    table.print();
    fmt::print("\n");
  }
  fmt::print("study {} in {}, runs", session.id(), c.common.db);
  for (const std::int64_t run : runs) fmt::print(" {}", run);
  fmt::print("\n");
}

}  // namespace

void add_compare(CLI::App& program) {
  auto c = std::make_shared<CompareCommand>();
  CLI::App* command =
      program.add_subcommand("compare", "Compare variants of a shop under common random numbers");
  command->add_option("SCENARIO", c->files, "scenario files; the first is what the others are compared with")
      ->required();
  command
      ->add_option("--variant", c->variants,
                   "another variant of the first file: \"NAME: POINTER=VALUE; ...\"")
      ->allow_extra_args(false);
  command->add_option("--kpi", c->kpis, "KPI to compare; may be repeated, the first decides when to stop")
      ->allow_extra_args(false);
  command->add_option("--confidence", c->confidence, "of the intervals")->capture_default_str();
  command
      ->add_option("--indifference", c->indifference, "share of the value below which a difference is none")
      ->capture_default_str();
  command->add_option("--max-replications", c->max_replications, "where to stop in any case")
      ->capture_default_str();
  add_progress(*command, c->progress);
  add_json(*command, c->common);
  add_db(*command, c->common);
  add_run_options(*command, c->common);
  command->footer(
      "Example:\n  verstat compare scenarios/gallery/heavy-lathe.json --variant \"gamma 0.47: "
      "/tools/0/strategy/gamma=0.47\"\n"
      "Replications are doubled until the first KPI is less, more or the same, or --max-replications is "
      "reached;\n"
      "--replications takes exactly so many. --set changes all variants.");
  command->callback([c] { compare_variants(*c); });
}

}  // namespace verstat::app
