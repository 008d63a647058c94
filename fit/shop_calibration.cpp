#include "fit/shop_calibration.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit/columns.h"
#include "fit/fit_error.h"
#include "scenarios/json_text.h"
#include "sim/kernel/replications.h"
#include "sim/shop/run.h"

namespace verstat::fit {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using scenarios::InputError;

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
  throw InputError("", fmt::format("totals {}: {}", file, text));
}

double finite(const std::string& file, const json& object, const std::string& where, const char* member) {
  if (!object.contains(member) || !object[member].is_number())
    refuse(file, fmt::format("{}/{} must be a number", where, member));
  return object[member].get<double>();
}

void only(const std::string& file, const json& object, const std::string& where,
          std::initializer_list<const char*> known) {
  if (!object.is_object())
    refuse(file, fmt::format("{} must be an object", where.empty() ? "the file" : where));
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      std::string all;
      for (const char* k : known) all += (all.empty() ? "" : ", ") + std::string(k);
      refuse(file, fmt::format("{}/{}: there is no such member; there are {}", where, key, all));
    }
}

void check(const std::string& where, const UncertainInput& in) {
  if (!(in.low < in.high))
    throw InputError("", fmt::format("{}: low {} must be below high {}", where, in.low, in.high));
  if (in.logarithmic && !(in.low > 0))
    throw InputError("", fmt::format("{}: a logarithmic scale needs low above 0, not {}", where, in.low));
  if (in.mean.has_value() != in.sd.has_value())
    throw InputError("", fmt::format("{}: mean and sd come together", where));
  if (in.sd && !(*in.sd > 0)) throw InputError("", fmt::format("{}: sd = {} must be above 0", where, *in.sd));
  if (in.mean && (*in.mean < in.low || *in.mean > in.high))
    throw InputError("", fmt::format("{}: mean = {} must lie between low and high", where, *in.mean));
}

}  // namespace

CalibrationSpec read_calibration(const std::string& file, const std::vector<std::string>& uncertain) {
  CalibrationSpec spec{.file = file};
  json j;
  try {
    j = scenarios::parse_json(scenarios::read_text_file(file));
  } catch (const InputError& e) {
    refuse(file, e.what());
  }
  only(file, j, "", {"description", "counted_hours", "counted_min", "totals", "uncertain"});
  if (j.contains("counted_hours") == j.contains("counted_min"))
    refuse(file, "must have counted_hours or counted_min: the time in which the totals were counted");
  spec.counted_min = j.contains("counted_min") ? finite(file, j, "", "counted_min")
                                               : 60 * finite(file, j, "", "counted_hours");
  if (!(spec.counted_min > 0 && spec.counted_min <= 1e7))
    refuse(file,
           fmt::format("the counted time is {} min, must be above 0 and at most 1e7", spec.counted_min));
  if (!j.contains("totals") || !j["totals"].is_array() || j["totals"].empty() || j["totals"].size() > 50)
    refuse(file,
           "/totals must be a list of 1 to 50 totals such as {\"kpi\": \"parts_good\", \"value\": 812}");
  for (std::size_t k = 0; k < j["totals"].size(); ++k) {
    const json& one = j["totals"][k];
    const std::string where = fmt::format("/totals/{}", k);
    only(file, one, where, {"kpi", "value", "hours", "sd"});
    if (!one.contains("kpi") || !one["kpi"].is_string())
      refuse(file, where + "/kpi must be the name of a KPI");
    if (one.contains("value") == one.contains("hours"))
      refuse(file, where + " must have either value, or hours for a share of time");
    ObservedTotal total{.name = one["kpi"].get<std::string>()};
    // Shares of time are written by shops in hours.
    const double unit = one.contains("hours") ? 60 / spec.counted_min : 1;
    total.value = unit * finite(file, one, where, one.contains("hours") ? "hours" : "value");
    if (one.contains("sd")) total.measurement_sd = unit * finite(file, one, where, "sd");
    if (!(total.measurement_sd >= 0)) refuse(file, where + "/sd must not be negative");
    for (const ObservedTotal& other : spec.totals)
      if (other.name == total.name)
        refuse(file, fmt::format("{}/kpi \"{}\" stands twice", where, total.name));
    spec.totals.push_back(total);
  }
  if (j.contains("uncertain")) {
    if (!j["uncertain"].is_array()) refuse(file, "/uncertain must be a list");
    for (std::size_t k = 0; k < j["uncertain"].size(); ++k) {
      const json& one = j["uncertain"][k];
      const std::string where = fmt::format("/uncertain/{}", k);
      only(file, one, where, {"pointer", "low", "high", "scale", "mean", "sd"});
      if (!one.contains("pointer") || !one["pointer"].is_string())
        refuse(file, where + "/pointer must be a JSON pointer");
      UncertainInput in{.name = one["pointer"].get<std::string>(),
                        .low = finite(file, one, where, "low"),
                        .high = finite(file, one, where, "high")};
      if (one.contains("scale")) {
        if (one["scale"] != "log" && one["scale"] != "linear")
          refuse(file, where + "/scale must be \"linear\" or \"log\"");
        in.logarithmic = one["scale"] == "log";
      }
      if (one.contains("mean")) in.mean = finite(file, one, where, "mean");
      if (one.contains("sd")) in.sd = finite(file, one, where, "sd");
      check(fmt::format("totals {}: {}", file, where), in);
      spec.inputs.push_back(in);
    }
  }
  for (const std::string& text : uncertain) {
    const auto equals = text.find('=');
    const auto dots = equals == std::string::npos ? equals : text.find("..", equals);
    std::optional<double> low;
    std::optional<double> high;
    if (dots != std::string::npos) {
      low = parse_number(std::string_view(text).substr(equals + 1, dots - equals - 1), '.');
      high = parse_number(std::string_view(text).substr(dots + 2), '.');
    }
    if (!low || !high || text[0] != '/')
      throw InputError("", fmt::format("--uncertain {}: must be POINTER=LOW..HIGH, such as "
                                       "/inserts/0/edge_life/mean_ref_min=40..90",
                                       text));
    UncertainInput in{.name = text.substr(0, equals), .low = *low, .high = *high};
    check("--uncertain " + text, in);
    spec.inputs.push_back(in);
  }
  if (spec.inputs.empty())
    refuse(file, "names no uncertain input: \"uncertain\" in the file, or --uncertain POINTER=LOW..HIGH");
  if (spec.inputs.size() > 8)
    refuse(file, fmt::format("{} uncertain inputs; at most 8 can be told apart", spec.inputs.size()));
  for (std::size_t i = 0; i < spec.inputs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (spec.inputs[i].name == spec.inputs[k].name)
        refuse(file, fmt::format("{} is uncertain twice", spec.inputs[i].name));
  return spec;
}

Report calibrate_shop(const json& scenario, const CalibrationSpec& spec, const CalibrationOptions& options,
                      int threads, Origin origin) {
  // The month: the warm-up of the scenario, then the counted time, once.
  const scenarios::Scenario base = scenarios::load(scenario);
  json month = scenario;
  month["simulation"]["horizon_min"] = base.simulation.warmup_min + spec.counted_min;
  month["simulation"]["replications"] = 1;
  std::vector<double> start;
  for (const UncertainInput& in : spec.inputs) {
    try {
      const json& now = scenario.at(json::json_pointer(in.name));
      if (!now.is_number()) throw InputError("", fmt::format("{} is not a number", in.name));
      start.push_back(now.get<double>());
    } catch (const json::exception&) {
      throw InputError("", fmt::format("{}: the scenario has no such member", in.name));
    }
  }
  const auto scenario_at = [&](const std::vector<double>& point) {
    std::vector<scenarios::Change> changes;
    for (std::size_t i = 0; i < point.size(); ++i) changes.push_back({spec.inputs[i].name, point[i]});
    return scenarios::load(scenarios::apply(month, changes));
  };
  // Both ends of every input are tried first: a limit that the scenario refuses is an error before the work.
  for (std::size_t i = 0; i < spec.inputs.size(); ++i)
    for (const double end : {spec.inputs[i].low, spec.inputs[i].high}) {
      std::vector<double> point = start;
      point[i] = end;
      try {
        static_cast<void>(scenario_at(point));
      } catch (const InputError& e) {
        throw InputError(e.pointer(), fmt::format("uncertain input {}: {}", spec.inputs[i].name, e.what()));
      }
    }
  const std::vector<shop::KpiInfo> kpis = shop::kpi_infos(base);
  std::vector<std::size_t> index;
  for (const ObservedTotal& total : spec.totals) {
    const auto at =
        std::find_if(kpis.begin(), kpis.end(), [&](const auto& k) { return k.name == total.name; });
    if (at == kpis.end())
      throw InputError("",
                       fmt::format("totals {}: there is no KPI \"{}\" in this shop (verstat run lists them)",
                                   spec.file, total.name));
    index.push_back(static_cast<std::size_t>(at - kpis.begin()));
  }
  const SimulateMonths simulate = [&](const std::vector<std::vector<double>>& points, std::uint64_t first) {
    return sim::run_replications(points.size(), static_cast<unsigned>(threads), [&](std::size_t k) {
      scenarios::Scenario one = scenario_at(points[k]);
      one.simulation.seed.value = options.seed + first + k;
      const shop::RunResult run = shop::run_scenario(one, 1);
      std::vector<double> values;
      for (std::size_t t = 0; t < index.size(); ++t) {
        const auto value = run.values[0][index[t]];
        if (!value)
          throw InputError(
              "",
              fmt::format("\"{}\" has no value in a simulated month of {} min: count longer or leave it out",
                          spec.totals[t].name, spec.counted_min));
        values.push_back(*value);
      }
      return values;
    });
  };

  Calibration c;
  try {
    c = calibrate(spec.inputs, spec.totals, start, simulate, options);
  } catch (const FitError& e) {
    throw InputError("", fmt::format("totals {}: {}", spec.file, e.what()));
  }

  Report report;
  origin.file = spec.file;
  origin.rows_used = origin.rows_in_file = spec.totals.size();
  origin.method = fmt::format("approximate Bayesian calibration, {} simulated months of {:g} h", c.months,
                              spec.counted_min / 60);
  report.json["counted_min"] = spec.counted_min;
  report.json["confidence"] = options.confidence;
  report.json["months_simulated"] = c.months;
  report.json["inputs"] = ordered_json::array();
  report.lines.push_back(fmt::format("{} months of {:g} h simulated; {:g} % intervals", c.months,
                                     spec.counted_min / 60, 100 * options.confidence));
  report.lines.emplace_back("");
  std::vector<std::string> silent;
  for (std::size_t i = 0; i < c.inputs.size(); ++i) {
    const CalibratedInput& in = c.inputs[i];
    const char* verdict = in.sd_ratio < 0.3   ? "well determined"
                          : in.sd_ratio < 0.8 ? "narrowed"
                                              : "the totals say next to nothing about it";
    if (in.sd_ratio >= 0.8) silent.push_back(spec.inputs[i].name);
    report.json["inputs"].push_back({{"pointer", spec.inputs[i].name},
                                     {"start", start[i]},
                                     {"mean", in.mean},
                                     {"sd", in.sd},
                                     {"median", in.median},
                                     {"bounds", interval_json(in.bounds)},
                                     {"prior_sd", in.prior_sd},
                                     {"sd_ratio", in.sd_ratio},
                                     {"verdict", verdict}});
    report.lines.push_back(fmt::format("{}: was {}, now {}: {} (uncertainty {:.0f} % of what it was)",
                                       spec.inputs[i].name, plain(start[i]), with_bounds(in.mean, in.bounds),
                                       verdict, 100 * in.sd_ratio));
  }
  report.json["correlation"] = c.correlation;
  for (std::size_t i = 0; i < c.inputs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::abs(c.correlation[i][k]) > 0.7)
        report.lines.push_back(fmt::format("{} and {} are known only together (correlation {:+.2f})",
                                           spec.inputs[k].name, spec.inputs[i].name, c.correlation[i][k]));
  report.json["directions"] = ordered_json::array();
  for (const Direction& direction : c.directions)
    report.json["directions"].push_back({{"weights", direction.weights}, {"sd_ratio", direction.sd_ratio}});
  report.lines.emplace_back("");
  report.lines.push_back(
      fmt::format("{:<44}{:>12}{:>30}{:>30}", "the model against last month", "month", "before", "after"));
  report.json["totals"] = ordered_json::array();
  bool all_inside = true;
  for (std::size_t j = 0; j < c.totals.size(); ++j) {
    const CheckedTotal& t = c.totals[j];
    all_inside = all_inside && t.inside;
    report.json["totals"].push_back(
        {{"kpi", spec.totals[j].name},
         {"observed", t.observed},
         {"before", {{"mean", t.start_mean}, {"interval", interval_json(t.start_interval)}}},
         {"after", {{"mean", t.mean}, {"interval", interval_json(t.interval)}}},
         {"inside", t.inside}});
    report.lines.push_back(fmt::format("{:<44}{:>12}{:>30}{:>30}{}", spec.totals[j].name, plain(t.observed),
                                       with_bounds(t.start_mean, t.start_interval),
                                       with_bounds(t.mean, t.interval), t.inside ? "" : "  outside"));
  }
  report.json["misfit_p_value"] = c.misfit_p_value;
  report.json["largest_r_hat"] = c.largest_r_hat;
  report.json["posterior_draws"] = c.draws;
  if (!all_inside || c.misfit_p_value < 0.01)
    report.warnings.push_back(
        fmt::format("the model cannot make this month within these limits (p = {:.2g}): something else "
                    "than the named inputs is wrong",
                    c.misfit_p_value));
  if (!silent.empty()) {
    std::string all;
    for (const std::string& one : silent) all += (all.empty() ? "" : ", ") + one;
    report.warnings.push_back("not told by these totals, left as they are: " + all);
  }
  if (c.largest_r_hat > 1.05)
    report.warnings.push_back(fmt::format(
        "the chains do not agree (R-hat {:.3f}): more --points or fewer inputs", c.largest_r_hat));
  for (std::size_t i = 0; i < c.inputs.size(); ++i)
    if (c.inputs[i].sd_ratio < 0.8) report.changes.push_back({spec.inputs[i].name, c.inputs[i].mean});
  report.json["warnings"] = report.warnings;
  report.json["provenance"] = origin_json(origin);
  if (!report.changes.empty()) report.json["patch"] = patch_json(report.changes, origin);
  return report;
}

}  // namespace verstat::fit
