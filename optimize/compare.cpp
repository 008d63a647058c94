#include "optimize/compare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace verstat::optimize {

void append(shop::RunResult& to, const shop::RunResult& more) {
  if (to.values.empty()) {
    to = more;
    return;
  }
  if (to.kpis.size() != more.kpis.size())
    throw std::invalid_argument("two runs of one scenario differ in KPIs");
  to.events += more.events;
  to.courses.insert(to.courses.end(), more.courses.begin(), more.courses.end());
  to.values.insert(to.values.end(), more.values.begin(), more.values.end());
  std::vector<std::optional<double>> column(to.values.size());
  for (std::size_t k = 0; k < to.kpis.size(); ++k) {
    for (std::size_t r = 0; r < column.size(); ++r) column[r] = to.values[r][k];
    to.estimates[k] = shop::estimate(column);
  }
}

namespace {

Verdict judge(const Difference& d, double indifference) {
  if (!d.difference.mean || !d.difference.half_width || !d.first.mean) return Verdict::unclear;
  const double mean = *d.difference.mean;
  const double half = *d.difference.half_width;
  if (std::abs(mean) + half <= indifference * std::abs(*d.first.mean)) return Verdict::unchanged;
  if (mean + half < 0) return Verdict::less;
  if (mean - half > 0) return Verdict::more;
  return Verdict::unclear;
}

}  // namespace

Comparison compare(std::size_t variants, const RunVariant& run, const CompareOptions& options) {
  if (variants < 2) throw std::invalid_argument("a comparison needs two variants");
  if (options.kpis.empty()) throw std::invalid_argument("a comparison needs a KPI");
  Comparison result;
  result.runs.resize(variants);
  std::int64_t looks = 1;
  for (std::int64_t n = options.first_replications; 2 * n <= options.max_replications; n *= 2) ++looks;
  const double share =
      (1 - options.confidence) / static_cast<double>(looks) / static_cast<double>(variants - 1);

  for (std::int64_t n = options.first_replications;; n *= 2) {
    for (std::size_t v = 0; v < variants; ++v)
      append(result.runs[v],
             run(v, static_cast<std::uint64_t>(result.replications), n - result.replications));
    result.replications = n;
    result.differences.clear();
    result.clear = true;
    for (std::size_t v = 1; v < variants; ++v) {
      auto& all = result.differences.emplace_back();
      for (const std::string& kpi : options.kpis) {
        const auto at = result.runs[0].index_of(kpi);
        const auto other = result.runs[v].index_of(kpi);
        if (!at || !other)
          throw std::invalid_argument(fmt::format("there is no KPI \"{}\" in every variant", kpi));
        Difference d{.kpi = kpi,
                     .unit = result.runs[0].kpis[*at].unit,
                     .first = result.runs[0].estimates[*at],
                     .other = result.runs[v].estimates[*other],
                     .difference = shop::paired_difference(result.runs[0], result.runs[v], kpi, 1 - share)};
        d.verdict = judge(d, options.indifference);
        if (all.empty() && d.verdict == Verdict::unclear) result.clear = false;
        all.push_back(std::move(d));
      }
    }
    if (result.clear || 2 * n > options.max_replications) return result;
  }
}

std::string kpi_in_words(const std::string& kpi) {
  if (kpi.find('/') == std::string::npos && kpi.find(' ') != std::string::npos) return kpi;  // words already
  std::string what = kpi.substr(kpi.rfind('/') + 1);
  for (const std::string_view unit : {"_per_h", "_min", "_kwh"})
    if (what.ends_with(unit) && what.size() > unit.size()) {
      what.resize(what.size() - unit.size());
      break;
    }
  const auto plain = [](std::string text) {
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
  };
  const auto first = kpi.find('/');
  if (first == std::string::npos) return plain(what);
  const auto second = kpi.find('/', first + 1);
  // "cost/idle", "load/lathe"; "tool/roughing tool/failure_share", "machine/lathe/state/idle".
  if (second == std::string::npos) return fmt::format("{} ({})", plain(kpi.substr(0, first)), plain(what));
  return fmt::format("{} of {}", plain(what), kpi.substr(first + 1, second - first - 1));
}

std::string in_words(const Difference& d) {
  const bool cost = d.kpi == "cost_per_part" || d.kpi == "cost_per_good_part";
  const std::string subject = kpi_in_words(d.kpi);
  const std::string per = d.kpi == "cost_per_good_part" ? "per good part" : "per part";
  if (!d.difference.mean || !d.difference.half_width || !d.first.mean)
    return fmt::format("{}: there are too few values to compare", subject);
  const bool relative = *d.first.mean != 0;
  const double scale = relative ? 100 / std::abs(*d.first.mean) : 1;
  const double mean = *d.difference.mean * scale;
  const double half = *d.difference.half_width * scale;
  const int digits = half > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, 6) : 2;
  const std::string amount =
      fmt::format("{:.{}f} +- {:.{}f} {}", std::abs(mean), digits, half, digits, relative ? "%" : d.unit);
  switch (d.verdict) {
    case Verdict::less:
      return cost ? fmt::format("costs {} less {}", amount, per)
                  : fmt::format("{} is {} lower", subject, amount);
    case Verdict::more:
      return cost ? fmt::format("costs {} more {}", amount, per)
                  : fmt::format("{} is {} higher", subject, amount);
    case Verdict::unchanged:
      return cost ? fmt::format("costs the same {}", per) : fmt::format("{} is unchanged", subject);
    case Verdict::unclear:
      break;
  }
  return fmt::format("{}: no difference can be told ({:+.{}f} +- {:.{}f} {})", subject, mean, digits, half,
                     digits, relative ? "%" : d.unit);
}

std::string in_words(const std::string& variant, const std::vector<Difference>& differences) {
  std::string words;
  for (const Difference& d : differences) {
    const std::string one = in_words(d);
    // "indexing at gamma 0.85 costs ..."; anything else is a sentence of its own.
    if (words.empty())
      words = variant + (one.starts_with("costs ") ? " " : ": ") + one;
    else
      words += "; " + one;
  }
  return words + ".";
}

}  // namespace verstat::optimize
