// verstat losses: what removing each loss would bring, by paired runs.
#include "optimize/losses.h"

#include <cmath>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/results.h"
#include "app/study_session.h"
#include "app/table.h"
#include "models/catalogue/shortened.h"
#include "store/result_json.h"

namespace verstat::app {

namespace {

using nlohmann::ordered_json;
using optimize::Loss;
using optimize::Trial;

constexpr const char* money_kpi = "cost_per_good_part";
constexpr const char* parts_kpi = "parts_good";

struct LossesCommand {
  CommonOptions common;
  std::string file;
  std::vector<std::string> own;
  std::string progress = "bar";
};

// Cost per good part and good parts, replication by replication.
struct Sample {
  std::vector<std::optional<double>> money;
  std::vector<std::optional<double>> parts;
};

Sample sample_of(StudySession& session, const optimize::Simulate& simulate,
                 const scenarios::Scenario& scenario, const std::string& stage) {
  const std::int64_t n = scenario.simulation.replications;
  const auto& outcome = session.ledger().ask({.stage = stage, .replications = n}, [&](Trial& trial) {
    const shop::RunResult run = simulate(scenario, 0, n);
    for (const char* kpi : {money_kpi, parts_kpi}) {
      const auto k = *run.index_of(kpi);
      for (const auto& row : run.values) trial.outcome.push_back(row[k].value_or(std::nan("")));
    }
    const auto k = *run.index_of(money_kpi);
    trial.objective = run.estimates[k].mean;
    trial.half_width = run.estimates[k].half_width;
  });
  Sample s;
  for (std::size_t r = 0; r < outcome.size(); ++r) {
    const auto value = std::isfinite(outcome[r]) ? std::optional(outcome[r]) : std::nullopt;
    (r < static_cast<std::size_t>(n) ? s.money : s.parts).push_back(value);
  }
  return s;
}

shop::Estimate difference(const std::vector<std::optional<double>>& from,
                          const std::vector<std::optional<double>>& to) {
  std::vector<std::optional<double>> d(from.size());
  for (std::size_t r = 0; r < d.size(); ++r)
    if (from[r] && to[r]) d[r] = *to[r] - *from[r];
  return shop::estimate(d);
}

void price_losses(const LossesCommand& c) {
  check_progress(c.progress);
  const auto changes = changes_of(c.common);
  const LoadedScenario loaded = load_scenario(c.file, changes);
  if (loaded.scenario.simulation.replications < 2)
    throw UsageError("losses: at least 2 replications are needed");
  std::vector<Loss> losses = optimize::losses_of(loaded.scenario);
  for (const std::string& text : c.own) {
    const auto colon = text.find(':');
    if (colon == std::string::npos || colon == 0 || text.find('/') < colon)
      throw UsageError(fmt::format("--loss {}: must be NAME: POINTER=VALUE", models::shortened(text, 200)));
    const auto begin = text.find_first_not_of(' ', colon + 1);
    losses.push_back(
        {text.substr(0, colon),
         "own",
         {scenarios::parse_change(text.substr(begin == std::string::npos ? colon + 1 : begin))}});
  }
  if (losses.empty())
    throw UsageError(fmt::format("scenario {}: states no loss that could be removed", c.file));
  std::vector<LoadedScenario> without;
  for (const Loss& loss : losses) {
    std::vector<scenarios::Change> all = changes;
    all.insert(all.end(), loss.removed_by.begin(), loss.removed_by.end());
    without.push_back(load_scenario(c.file, all));
  }
  const int threads = thread_count(c.common);

  store::Study record;
  record.header = {.name = "Price list of losses: " + loaded.scenario.name,
                   .scenario_name = loaded.scenario.name,
                   .objective = money_kpi,
                   .seed = loaded.scenario.simulation.seed.value,
                   .provenance = provenance(),
                   .kind = "losses"};
  ordered_json asked = ordered_json::array();
  for (const Loss& loss : losses)
    asked.push_back({{"name", loss.name},
                     {"kind", loss.kind},
                     {"removed_by", ordered_json::parse(changes_text(loss.removed_by))}});
  record.study_text = asked.dump();
  record.scenario_text = loaded.text;
  record.changes = changes_text(changes);
  StudySession session(c.common.db, std::move(record), c.progress);
  const optimize::Simulate simulate = session.simulate(threads);
  const auto steps = static_cast<std::int64_t>(losses.size()) + 1;
  ordered_json result;
  try {
    const Sample today = sample_of(session, simulate, loaded.scenario, "today");
    session.progress("losses", 1, steps);
    const shop::Estimate cost = shop::estimate(today.money);
    const shop::Estimate parts = shop::estimate(today.parts);
    ordered_json list = ordered_json::array();
    for (std::size_t k = 0; k < losses.size(); ++k) {
      const Sample s = sample_of(session, simulate, without[k].scenario, "without " + losses[k].name);
      session.progress("losses", static_cast<std::int64_t>(k) + 2, steps);
      const shop::Estimate more = difference(today.parts, s.parts);
      const shop::Estimate saved = difference(s.money, today.money);
      list.push_back({{"name", losses[k].name},
                      {"kind", losses[k].kind},
                      {"removed_by", asked[k]["removed_by"]},
                      {"parts", estimate_json(more)},
                      {"saving_per_good_part", estimate_json(saved)}});
    }
    std::stable_sort(list.begin(), list.end(), [](const ordered_json& a, const ordered_json& b) {
      const auto value = [](const ordered_json& j) {
        const auto& mean = j["saving_per_good_part"]["mean"];
        return mean.is_null() ? -1e300 : mean.get<double>();
      };
      return value(a) > value(b);
    });
    result = {{"currency", loaded.scenario.currency},
              {"replications", loaded.scenario.simulation.replications},
              {"minutes", loaded.scenario.simulation.horizon_min - loaded.scenario.simulation.warmup_min},
              {"today",
               {{"cost_per_good_part", store::number_or_null(cost.mean)},
                {"parts_good", store::number_or_null(parts.mean)}}},
              {"losses", list}};
    if (!list.empty() && cost.mean && !list[0]["saving_per_good_part"]["mean"].is_null())
      result["words"] = fmt::format(
          "The dearest loss: without {} a good part would cost {:.3g} {} less ({:.2g} %).",
          list[0]["name"].get<std::string>(), list[0]["saving_per_good_part"]["mean"].get<double>(),
          loaded.scenario.currency, 100 * list[0]["saving_per_good_part"]["mean"].get<double>() / *cost.mean);
  } catch (const optimize::Interrupted&) {
    session.finish("{}", "interrupted");
    throw;
  }
  session.finish(result.dump(), "finished");

  if (c.common.json) {
    print_json(session.id(), result);
    return;
  }
  fmt::print("{}: without each loss, in {:g} min; paired runs of {} replications, +- at 95 %\n\n",
             loaded.scenario.name, result["minutes"].get<double>(), loaded.scenario.simulation.replications);
  Table table("lrr");
  table.add({"loss removed", "more good parts", loaded.scenario.currency + " less per good part"});
  for (const auto& loss : result["losses"])
    table.add({loss["name"].get<std::string>(), shown(loss["parts"]), shown(loss["saving_per_good_part"])});
  table.print();
  if (result.contains("words")) fmt::print("\n{}\n", result["words"].get<std::string>());
  fmt::print("\nstudy {} in {}\n", session.id(), c.common.db);
}

}  // namespace

void add_losses(CLI::App& program) {
  auto c = std::make_shared<LossesCommand>();
  CLI::App* command = program.add_subcommand("losses", "What removing each loss of a shop would bring");
  command->add_option("SCENARIO", c->file, "scenario file (JSON)")->required();
  command->add_option("--loss", c->own, "a loss of your own, and what removes it: \"NAME: POINTER=VALUE\"")
      ->allow_extra_args(false);
  add_progress(*command, c->progress);
  add_json(*command, c->common);
  add_db(*command, c->common);
  add_run_options(*command, c->common);
  command->footer(
      "Example:\n  verstat losses scenarios/gallery/heavy-lathe.json\n"
      "Failures, edge changes, scrap and waiting for crews are removed one at a time; the differences are "
      "paired\n"
      "replication by replication. Losses overlap: their sum is not what removing all of them would bring.");
  command->callback([c] { price_losses(*c); });
}

}  // namespace verstat::app
