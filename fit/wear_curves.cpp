#include "fit/wear_curves.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"time",
       Quantity::time_min,
       {"time", "cutting time", "minutes", "час", "час різання", "время", "время резания"}},
      {"wear",
       Quantity::length_mm,
       {"flank wear", "vb", "wear", "flank wear vb", "знос", "знос vb", "зношення", "фаска зносу", "износ",
        "износ vb"}},
      {"speed",
       Quantity::speed_m_min,
       {"cutting speed", "speed", "vc", "v c", "v", "швидкість", "швидкість різання", "скорость",
        "скорость резания"}},
      {"feed", Quantity::feed_mm_rev, {"feed", "f", "s", "подача"}},
      {"depth",
       Quantity::length_mm,
       {"depth of cut", "depth", "ap", "a p", "глибина", "глибина різання", "глубина", "глубина резания"}},
      {"material",
       Quantity::text,
       {"workpiece material", "material", "workpiece", "матеріал", "матеріал заготовки", "материал",
        "материал заготовки"}},
      {"tool",
       Quantity::text,
       {"tool material", "tool", "insert", "grade", "інструмент", "матеріал інструмента", "пластина",
        "инструмент", "материал инструмента"}},
      {"laboratory",
       Quantity::text,
       {"organization", "laboratory", "lab", "machine", "лабораторія", "верстат", "лаборатория", "станок"}},
      {"run", Quantity::text, {"run", "edge", "test", "trial", "дослід", "кромка", "опыт"}},
      {"record", Quantity::text, {"record", "id", "no", "№", "номер"}, true}};
  return all;
}

}  // namespace

Observation life_at(const std::vector<WearReading>& curve, double criterion_mm) {
  const auto reached =
      std::find_if(curve.begin(), curve.end(), [&](const auto& r) { return r.wear_mm >= criterion_mm; });
  if (reached == curve.end()) return survived(curve.back().time_min);
  if (reached == curve.begin()) return between(0, reached->time_min);
  const WearReading& before = *(reached - 1);
  const double share = (criterion_mm - before.wear_mm) / (reached->wear_mm - before.wear_mm);
  return exact_life(before.time_min + share * (reached->time_min - before.time_min));
}

WearData read_wear(const std::string& path, const WearOptions& options) {
  WearData data;
  data.criterion_mm = options.criterion_mm;
  data.table = read_table(path, options.table);
  Table& table = data.table;
  const Columns columns(table, roles(), options.columns, options.table);
  columns.require("time", "minutes of cutting at the reading");
  columns.require("wear", "width of the flank wear land, mm");
  columns.require("speed", "cutting speed, m/min");
  for (const char* optional : {"feed", "depth"})
    if (!columns.has(optional))
      table.notes.push_back(fmt::format("no column for the {}: taken as the same everywhere", optional));

  struct Curve {
    WearRun run;
    std::vector<WearReading> readings;
  };
  std::vector<std::vector<Curve>> curves;  // by group
  std::map<std::pair<std::string, std::string>, std::size_t> group_of;
  using Key = std::tuple<std::size_t, std::string, std::string, double, double, double>;
  std::map<Key, std::size_t> open;  // the curve that takes the next reading
  std::size_t elsewhere = 0;
  for (const Row& row : table.rows) {
    const std::string material = columns.text(row, "material");
    const std::string tool = columns.text(row, "tool");
    if ((!options.material.empty() && material != options.material) ||
        (!options.tool.empty() && tool != options.tool)) {
      ++elsewhere;
      continue;
    }
    std::string reason;
    const auto value = [&](const char* key, bool positive, double missing) -> std::optional<double> {
      if (!columns.has(key)) return missing;
      auto v = columns.value(row, key, reason);
      if (v && !(positive ? *v > 0 : *v >= 0)) {
        reason =
            fmt::format("\"{}\" = {} is not {} 0", columns.header(key), *v, positive ? "above" : "at least");
        v.reset();
      }
      return v;
    };
    const auto time = value("time", false, 0);
    const auto wear = time ? value("wear", false, 0) : std::nullopt;
    const auto speed = wear ? value("speed", true, 0) : std::nullopt;
    const auto feed = speed ? value("feed", true, 1) : std::nullopt;
    const auto depth = feed ? value("depth", true, 1) : std::nullopt;
    if (!depth) {
      table.dropped.push_back({row.line, reason});
      continue;
    }
    const auto [place, fresh] = group_of.emplace(std::pair{material, tool}, data.groups.size());
    if (fresh) {
      data.groups.push_back({material, tool, {}});
      curves.emplace_back();
    }
    const std::size_t g = place->second;
    const std::string laboratory = columns.text(row, "laboratory");
    const Key key{g, laboratory, columns.text(row, "run"), *speed, *feed, *depth};
    auto at = open.find(key);
    if (at == open.end() || curves[g][at->second].readings.back().time_min >= *time) {
      if (*time == 0 && *wear > options.criterion_mm) {
        table.dropped.push_back({row.line, "worn beyond the criterion before it cut"});
        continue;
      }
      Curve curve;
      curve.run = {.laboratory = laboratory,
                   .cutting_speed_m_min = *speed,
                   .feed_mm_rev = *feed,
                   .depth_of_cut_mm = *depth};
      curve.run.life.line = row.line;
      curves[g].push_back(std::move(curve));
      open[key] = curves[g].size() - 1;
      at = open.find(key);
    }
    Curve& curve = curves[g][at->second];
    if (!curve.readings.empty() && *wear < curve.readings.back().wear_mm) ++curve.run.falling_readings;
    curve.readings.push_back({*time, *wear});
    ++data.rows_used;
  }
  if (elsewhere > 0) table.notes.push_back(fmt::format("{} rows are of another material or tool", elsewhere));
  for (std::size_t g = 0; g < data.groups.size(); ++g)
    for (Curve& curve : curves[g]) {
      WearRun& run = curve.run;
      if (curve.readings.back().time_min <= 0) {
        table.dropped.push_back({run.life.line, "a curve with the reading at 0 min only"});
        continue;
      }
      const std::size_t line = run.life.line;
      run.life = life_at(curve.readings, options.criterion_mm);
      run.life.line = line;
      run.readings = curve.readings.size();
      run.last_time_min = curve.readings.back().time_min;
      run.last_wear_mm = curve.readings.back().wear_mm;
      data.groups[g].runs.push_back(run);
    }
  if (data.rows_used == 0) {
    std::string first;
    if (!table.dropped.empty())
      first = fmt::format("; line {}: {}", table.dropped.front().line, table.dropped.front().reason);
    throw scenarios::InputError(
        "", fmt::format("table {}: no row of {} can be used{}", path, table.rows_in_file, first));
  }
  return data;
}

}  // namespace verstat::fit
