// verstat sweep: designs of experiments over any numbers of a scenario.
#include <bit>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/results.h"
#include "app/study_session.h"
#include "app/table.h"
#include "models/catalogue/closest.h"
#include "models/catalogue/shortened.h"
#include "optimize/designs.h"
#include "store/result_json.h"

namespace verstat::app {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using optimize::Design;
using optimize::Effect;
using optimize::Trial;

struct SweepCommand {
  CommonOptions common;
  std::string file;
  std::vector<std::string> factors;
  std::string design = "full";
  std::string points;
  std::vector<std::string> kpis;
  std::string progress = "bar";
  std::string resume;
};

// POINTER=low..high, POINTER=low..high:levels or POINTER=value,value,...
struct Factor {
  std::string pointer;
  double low = 0;
  double high = 1;
  int levels = 2;
  bool whole = false;
  std::vector<json> values;  // a list instead of a range

  [[nodiscard]] json at(double coded) const {
    if (!values.empty()) {
      const double step = 0.5 * (coded + 1) * static_cast<double>(values.size() - 1);
      return values[static_cast<std::size_t>(std::llround(step))];
    }
    const double value = 0.5 * ((1 - coded) * low + (1 + coded) * high);
    if (whole) return static_cast<std::int64_t>(std::llround(value));
    return coded == -1 ? low : (coded == 1 ? high : value);
  }
};

bool number_of(std::string_view text, double& value) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size() && std::isfinite(value);
}

Factor parse_factor(const std::string& text) {
  const auto fail = [&] {
    throw UsageError(fmt::format(
        "--factor {}: must be POINTER=LOW..HIGH, POINTER=LOW..HIGH:LEVELS or POINTER=VALUE,VALUE,...",
        models::shortened(text, 200)));
  };
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || text[0] != '/') fail();
  Factor f{.pointer = text.substr(0, equals)};
  std::string rest = text.substr(equals + 1);
  const auto dots = rest.find("..");
  if (dots != std::string::npos && rest.find('"') == std::string::npos) {
    std::string high = rest.substr(dots + 2);
    if (const auto colon = high.find(':'); colon != std::string::npos) {
      double levels = 0;
      if (!number_of(std::string_view(high).substr(colon + 1), levels) || levels != std::floor(levels) ||
          levels < 2 || levels > 1000)
        fail();
      f.levels = static_cast<int>(levels);
      high.resize(colon);
    }
    if (!number_of(std::string_view(rest).substr(0, dots), f.low) || !number_of(high, f.high) ||
        !(f.low < f.high))
      fail();
    f.whole = rest.find_first_of(".eE") == dots && high.find_first_of(".eE") == std::string::npos;
    return f;
  }
  const json list = json::parse("[" + rest + "]", nullptr, false);
  if (!list.is_discarded()) {
    f.values.assign(list.begin(), list.end());
  } else {
    for (std::size_t at = 0; at <= rest.size();) {
      const auto comma = std::min(rest.find(',', at), rest.size());
      f.values.emplace_back(rest.substr(at, comma - at));
      at = comma + 1;
    }
  }
  if (f.values.size() < 2) fail();
  f.levels = static_cast<int>(f.values.size());
  return f;
}

int points_of(const SweepCommand& c, int otherwise) {
  if (c.points.empty()) return otherwise;
  int points = 0;
  const auto [stop, error] = std::from_chars(c.points.data(), c.points.data() + c.points.size(), points);
  if (error != std::errc() || stop != c.points.data() + c.points.size() || points < 2 || points > 100'000)
    throw UsageError(fmt::format("--points {}: must be a whole number from 2 to 100000",
                                 models::shortened(c.points, 100)));
  return points;
}

Design design_of(const SweepCommand& c, const std::vector<Factor>& factors, std::uint64_t seed) {
  const auto k = static_cast<int>(factors.size());
  try {
    if (c.design == "full") {
      std::vector<int> levels;
      for (const Factor& f : factors) levels.push_back(f.levels);
      return optimize::full_factorial(levels);
    }
    if (c.design == "fractional") {
      auto q = static_cast<int>(std::bit_width(static_cast<unsigned>(k)));  // 2^q > k
      if (!c.points.empty()) {
        const auto points = static_cast<unsigned>(points_of(c, 0));
        if (!std::has_single_bit(points))
          throw UsageError(fmt::format("--points {}: a fraction has 2, 4, 8, 16, ... points", points));
        q = static_cast<int>(std::bit_width(points)) - 1;
      }
      return optimize::fractional_factorial(k, std::max(q, 2));
    }
    if (c.design == "lhs") return optimize::latin_hypercube(k, points_of(c, 10 * k), seed);
    if (c.design == "sobol") return optimize::sobol(k, points_of(c, 16 * k));
    if (c.design == "tornado") return optimize::one_at_a_time(k);
  } catch (const std::invalid_argument& e) {
    throw UsageError(fmt::format("--design {}: {}", c.design, e.what()));
  }
  throw UsageError(fmt::format("--design {}: must be full, fractional, lhs, sobol or tornado",
                               models::shortened(c.design, 100)));
}

std::string name_of(const std::vector<Factor>& factors, const std::vector<std::size_t>& which) {
  std::string name;
  for (const std::size_t f : which) name += (name.empty() ? "" : " x ") + factors[f].pointer;
  return name;
}

void sweep(SweepCommand& c) {
  check_progress(c.progress);
  std::unique_ptr<StudySession> session;
  LoadedScenario loaded;
  std::vector<scenarios::Change> changes;
  if (!c.resume.empty()) {
    const std::int64_t id = study_number(c.resume);
    if (!c.file.empty() || !c.factors.empty() || !c.common.set.empty() || !c.common.seed.empty() ||
        !c.common.replications.empty())
      throw UsageError("--resume: the sweep goes on as it was begun; nothing of it can be given again");
    session = std::make_unique<StudySession>(c.common.db, id, "sweep", c.progress);
    const json asked = json::parse(session->record().study_text);
    c.factors = asked.at("factors").get<std::vector<std::string>>();
    c.design = asked.at("design").get<std::string>();
    c.points = asked.at("points").get<std::string>();
    c.kpis = asked.at("kpis").get<std::vector<std::string>>();
    changes = changes_from_text(session->record().changes);
    loaded =
        load_scenario_text(session->record().scenario_text, fmt::format("scenario of study {}", id), changes);
  } else {
    if (c.file.empty()) throw UsageError("sweep: which SCENARIO? (or --resume NUMBER)");
    if (c.factors.empty()) throw UsageError("sweep: needs at least one --factor");
    changes = changes_of(c.common);
    loaded = load_scenario(c.file, changes);
    if (c.kpis.empty()) c.kpis = {"cost_per_part", "throughput_per_h"};
  }
  std::vector<Factor> factors;
  for (const std::string& text : c.factors) factors.push_back(parse_factor(text));
  const Design design = design_of(c, factors, loaded.scenario.simulation.seed.value);
  std::vector<std::string> names;
  for (const auto& info : shop::kpi_infos(loaded.scenario)) names.push_back(info.name);
  for (const std::string& kpi : c.kpis)
    if (std::find(names.begin(), names.end(), kpi) == names.end())
      throw UsageError(fmt::format("--kpi {}: there is no such KPI; closest: {}", models::shortened(kpi, 100),
                                   models::closest(kpi, names)));
  // Every point is checked before the first is simulated.
  std::vector<std::vector<scenarios::Change>> at;
  for (const auto& point : design.points) {
    auto& made = at.emplace_back();
    for (std::size_t f = 0; f < factors.size(); ++f)
      made.push_back({factors[f].pointer, factors[f].at(point[f])});
    try {
      (void)scenarios::load(scenarios::apply(loaded.json, made));
    } catch (const scenarios::InputError& e) {
      throw UsageError(fmt::format("sweep: a point of the design is no valid scenario: {}", e.what()));
    }
  }
  const int threads = thread_count(c.common);
  if (session == nullptr) {
    store::Study record;
    record.header = {
        .name = std::string(models::shortened(fmt::format("Sweep of {}", loaded.scenario.name), 200)),
        .scenario_name = loaded.scenario.name,
        .objective = c.kpis.front(),
        .seed = loaded.scenario.simulation.seed.value,
        .provenance = provenance(),
        .kind = "sweep"};
    record.study_text = ordered_json{
        {"factors", c.factors},
        {"design", c.design},
        {"points", c.points},
        {"kpis", c.kpis}}.dump();
    record.scenario_text = loaded.text;
    record.changes = changes_text(changes);
    for (const Factor& f : factors)
      record.variables.push_back({f.pointer, f.pointer, "1", f.values.empty() ? f.low : 0,
                                  f.values.empty() ? f.high : static_cast<double>(f.values.size() - 1)});
    session = std::make_unique<StudySession>(c.common.db, std::move(record), c.progress);
  }

  const optimize::Simulate simulate = session->simulate(threads);
  const std::int64_t n = loaded.scenario.simulation.replications;
  const std::size_t points = design.points.size();
  // responses[kpi][point][replication]
  std::vector<std::vector<std::vector<double>>> responses(c.kpis.size(),
                                                          std::vector<std::vector<double>>(points));
  try {
    for (std::size_t p = 0; p < points; ++p) {
      const auto& outcome = session->ledger().ask(
          {.stage = "design", .x = design.points[p], .replications = n}, [&](Trial& trial) {
            const shop::RunResult run = simulate(scenarios::load(scenarios::apply(loaded.json, at[p])), 0, n);
            for (const std::string& kpi : c.kpis) {
              const auto k = *run.index_of(kpi);
              for (const auto& row : run.values) trial.outcome.push_back(row[k].value_or(std::nan("")));
            }
            const auto k = *run.index_of(c.kpis.front());
            trial.objective = run.estimates[k].mean;
            trial.half_width = run.estimates[k].half_width;
          });
      for (std::size_t k = 0; k < c.kpis.size(); ++k)
        responses[k][p].assign(outcome.begin() + static_cast<std::ptrdiff_t>(k) * n,
                               outcome.begin() + static_cast<std::ptrdiff_t>(k + 1) * n);
      session->progress("design", static_cast<std::int64_t>(p) + 1, static_cast<std::int64_t>(points));
    }
  } catch (const store::StoreError& error) {
    throw with_way_on(error, "sweep", *session);
  } catch (const optimize::Interrupted&) {
    session->finish("{}", "interrupted");
    fmt::print(stderr, "sweep {} goes on with: verstat sweep --resume {} --db {}\n", session->id(),
               session->id(), c.common.db);
    throw;
  }

  ordered_json result = {{"design", c.design},
                         {"replications", n},
                         {"factors", ordered_json::array()},
                         {"points", ordered_json::array()},
                         {"kpis", ordered_json::array()}};
  if (design.resolution > 0) result["resolution"] = design.resolution;
  for (const Factor& f : factors)
    result["factors"].push_back({{"pointer", f.pointer}, {"low", f.at(-1)}, {"high", f.at(1)}});
  for (std::size_t p = 0; p < points; ++p) {
    ordered_json row = {{"values", ordered_json::array()}};
    for (const auto& change : at[p]) row["values"].push_back(ordered_json(change.value));
    for (std::size_t k = 0; k < c.kpis.size(); ++k) {
      std::vector<std::optional<double>> values;
      for (const double v : responses[k][p])
        values.push_back(std::isfinite(v) ? std::optional(v) : std::nullopt);
      const shop::Estimate e = shop::estimate(values);
      row[c.kpis[k]] = estimate_json(e, "half_width_95");
    }
    result["points"].push_back(std::move(row));
  }
  for (std::size_t k = 0; k < c.kpis.size(); ++k) {
    ordered_json one = {{"kpi", c.kpis[k]}};
    if (c.design == "tornado") {
      ordered_json bars = ordered_json::array();
      for (std::size_t f = 0; f < factors.size(); ++f) {
        const auto paired = [&](std::size_t p) {
          std::vector<std::optional<double>> d;
          for (std::size_t r = 0; r < static_cast<std::size_t>(n); ++r) {
            const double x = responses[k][p][r] - responses[k][0][r];
            d.push_back(std::isfinite(x) ? std::optional(x) : std::nullopt);
          }
          return shop::estimate(d);
        };
        const shop::Estimate low = paired(1 + 2 * f);
        const shop::Estimate high = paired(2 + 2 * f);
        bars.push_back({{"factor", factors[f].pointer},
                        {"low", estimate_json(low)},
                        {"high", estimate_json(high)},
                        {"swing", low.mean && high.mean ? std::abs(*high.mean - *low.mean) : 0.0}});
      }
      std::stable_sort(bars.begin(), bars.end(), [](const ordered_json& a, const ordered_json& b) {
        return a["swing"].get<double>() > b["swing"].get<double>();
      });
      one["tornado"] = bars;
    } else {
      try {
        ordered_json list = ordered_json::array();
        double largest = 0;
        for (const auto& row : responses[k])
          for (const double v : row) largest = std::max(largest, std::abs(v));
        for (Effect e : optimize::effects(design, responses[k], 0.95)) {
          // What least squares leaves of a response that does not move is rounding.
          if (std::abs(e.effect) + e.half_width.value_or(0) < 1e-12 * largest)
            e = {.factors = e.factors,
                 .effect = 0,
                 .half_width = e.half_width ? std::optional(0.0) : std::nullopt,
                 .aliases = e.aliases};
          list.push_back({{"effect", name_of(factors, e.factors)},
                          {"value", e.effect},
                          {"half_width", store::number_or_null(e.half_width)}});
          if (e.aliases.empty()) continue;
          list.back()["aliases"] = ordered_json::array();
          for (const auto& alias : e.aliases) list.back()["aliases"].push_back(name_of(factors, alias));
        }
        one["effects"] = list;
      } catch (const std::invalid_argument& e) {
        one["no_effects"] = e.what();
      }
    }
    result["kpis"].push_back(std::move(one));
  }
  session->finish(result.dump(), "finished");

  if (c.common.json) {
    print_json(session->id(), result);
    return;
  }
  fmt::print("{}: {} points ({}{}), {} replications each under the same random numbers; +- at 95 %\n",
             loaded.scenario.name, points, c.design,
             design.resolution > 0 ? fmt::format(", resolution {}", design.resolution) : "", n);
  for (std::size_t f = 0; f < factors.size(); ++f) fmt::print("{:>2} {}\n", f + 1, factors[f].pointer);
  fmt::print("\n");
  Table table(std::string(factors.size() + c.kpis.size(), 'r'), "", 10);
  std::vector<std::string> head;
  for (std::size_t f = 0; f < factors.size(); ++f) head.push_back(std::to_string(f + 1));
  head.insert(head.end(), c.kpis.begin(), c.kpis.end());
  table.add(std::move(head));
  constexpr std::size_t most_lines = 64;
  for (std::size_t p = 0; p < std::min(points, most_lines); ++p) {
    std::vector<std::string> row;
    for (const auto& value : result["points"][p]["values"])
      row.push_back(value.is_number() ? fmt::format("{:.6g}", value.get<double>())
                                      : (value.is_string() ? value.get<std::string>() : value.dump()));
    for (const std::string& kpi : c.kpis) row.push_back(shown(result["points"][p][kpi], "half_width_95"));
    table.add(std::move(row));
  }
  table.print();
  if (points > most_lines) fmt::print("... {} more; --json has them all\n", points - most_lines);
  for (const auto& one : result["kpis"]) {
    fmt::print("\n{}\n", one["kpi"].get<std::string>());
    Table effects(one.contains("tornado") ? "lrrrr" : "lrl", "  ");
    if (one.contains("tornado"))
      for (const auto& bar : one["tornado"])
        effects.add({bar["factor"].get<std::string>(), "low", shown(bar["low"]), "high", shown(bar["high"])});
    if (one.contains("effects"))
      for (const auto& e : one["effects"])
        effects.add({e["effect"].get<std::string>(),
                     shown({{"mean", e["value"]}, {"half_width", e["half_width"]}}),
                     e.contains("aliases") ? "or " + e["aliases"][0].get<std::string>() : ""});
    effects.print();
    if (one.contains("no_effects")) fmt::print("  no effects: {}\n", one["no_effects"].get<std::string>());
  }
  fmt::print("\nstudy {} in {}\n", session->id(), c.common.db);
}

}  // namespace

void add_sweep(CLI::App& program) {
  auto c = std::make_shared<SweepCommand>();
  CLI::App* command =
      program.add_subcommand("sweep", "Simulate a design of experiments over any numbers of a scenario");
  command->add_option("SCENARIO", c->file, "scenario file (JSON)");
  command
      ->add_option("--factor", c->factors,
                   "POINTER=LOW..HIGH[:LEVELS] or POINTER=VALUE,VALUE,...; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--design", c->design, "full, fractional, lhs, sobol or tornado")
      ->capture_default_str();
  command->add_option("--points", c->points, "of a fraction, Latin hypercube or Sobol design");
  command->add_option("--kpi", c->kpis, "KPI to look at; may be repeated")->allow_extra_args(false);
  command->add_option("--resume", c->resume, "go on with this sweep of the database");
  add_progress(*command, c->progress);
  add_json(*command, c->common);
  add_db(*command, c->common);
  add_run_options(*command, c->common);
  command->footer(
      "Example:\n  verstat sweep scenarios/gallery/heavy-lathe.json --factor "
      "/tools/0/strategy/gamma=0.3..0.8 --factor "
      "/operations/0/process/cutting_speed_m_min=45..60 --replications 5\n"
      "An effect is the change of the KPI when a factor goes from low to high.");
  command->callback([c] { sweep(*c); });
}

}  // namespace verstat::app
