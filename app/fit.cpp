// verstat fit: from the shop's records to inputs of a scenario.
#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/files.h"
#include "app/fit_answer.h"
#include "fit/event_report.h"
#include "fit/library.h"
#include "fit/life_report.h"
#include "fit/taylor_report.h"
#include "fit/value_report.h"
#include "models/catalogue/shortened.h"

namespace verstat::app {
namespace {

std::optional<double> maybe(const char* flag, const std::string& text, double low, double high) {
  if (text.empty()) return std::nullopt;
  return real_flag(flag, text, low, high);
}

/// One flag with one value; its default is what `to` holds.
void add_value_flag(CLI::App& command, const std::string& flag, std::string& to, const std::string& what) {
  auto* option = command.add_option(flag, to, what);
  if (!to.empty()) option->capture_default_str();
}
/// A flag that may be repeated.
void add_repeated_flag(CLI::App& command, const std::string& flag, std::vector<std::string>& to,
                       const std::string& what) {
  command.add_option(flag, to, what)->allow_extra_args(false);
}

// What all tables have in common.
struct TableFlags {
  std::string file;
  fit::TableOptions table;
  std::vector<std::string> columns;
  std::string duplicates = "identity";
  std::string confidence = "0.95";
  std::string seed = "1";
  std::string out;
  std::string library;
  bool json = false;

  CLI::App* add_to(CLI::App& parent, const char* name, const char* what, const char* file_what) {
    CLI::App* command = parent.add_subcommand(name, what);
    command->add_option("FILE", file, file_what)->required();
    add_repeated_flag(*command, "--column", columns,
                      "ROLE=HEADER: which column plays a role; may be repeated");
    add_value_flag(*command, "--encoding", table.encoding, "utf-8 or cp1251 (else found, with a note)");
    add_value_flag(*command, "--separator", table.separator,
                   "comma, semicolon or tab (else found, with a note)");
    add_value_flag(*command, "--decimal", table.decimal,
                   "point or comma (else found, refused when in doubt)");
    add_value_flag(*command, "--sheet", table.sheet, "sheet of an xlsx workbook (else the first one)");
    add_value_flag(*command, "--duplicates", duplicates,
                   "rows written twice: drop, keep, or identity (drop when a column tells items apart)");
    add_value_flag(*command, "--confidence", confidence, "of the intervals, 0.5 to 0.999");
    add_value_flag(*command, "--seed", seed, "of simulated samples");
    command->add_flag("--json", json, "print the answer as JSON on standard output");
    return command;
  }
  void add_results_to(CLI::App& command) {
    add_value_flag(command, "--out", out,
                   "write the changes with their provenance to this file, for --changes");
    add_value_flag(command, "--library", library,
                   "write the fitted entries with their provenance to this folder, for --use");
  }
  [[nodiscard]] fit::TableOptions table_options() const {
    fit::TableOptions options = table;
    if (duplicates == "drop")
      options.duplicates = fit::Duplicates::drop;
    else if (duplicates == "keep")
      options.duplicates = fit::Duplicates::keep;
    else if (duplicates != "identity")
      throw UsageError(fmt::format("--duplicates {}: must be identity, drop or keep", duplicates));
    return options;
  }
  /// Table options and columns of any log.
  template <class LogOptions>
  [[nodiscard]] LogOptions of_table(LogOptions options) const {
    options.table = table_options();
    for (const std::string& text : columns) options.columns.push_back(fit::parse_column_choice(text));
    return options;
  }
  [[nodiscard]] double confidence_level() const { return real_flag("--confidence", confidence, 0.5, 0.999); }
  [[nodiscard]] std::uint64_t seed_value() const {
    return static_cast<std::uint64_t>(whole_flag("--seed", seed, 0, 9'000'000'000'000'000));
  }
  void answer_with(const std::function<fit::Report(const fit::Origin&)>& report) const {
    answer(report(origin_now(file)), json, out, library);
  }
};

// Removal logs, for lives and for their value.
struct RemovalFlags : TableFlags {
  fit::RemovalOptions removals;
  CLI::App* add_to(CLI::App& parent, const char* name, const char* what, const char* file_what) {
    CLI::App* command = TableFlags::add_to(parent, name, what, file_what);
    add_value_flag(*command, "--regime", removals.regime, "only rows of this regime");
    add_repeated_flag(*command, "--planned-cause", removals.planned_causes,
                      "a further word for: taken out although it still cut");
    add_repeated_flag(*command, "--failure-cause", removals.failure_causes, "a further word for a failure");
    return command;
  }
  [[nodiscard]] fit::RemovalLog log() const { return fit::read_removals(file, of_table(removals)); }
};

// Logs of events in time.
struct EventFlags : TableFlags {
  std::string bootstrap = "199";
  std::string hours, weekdays;
  bool observations = false;
  CLI::App* add_to(CLI::App& parent, const char* name, const char* what, const char* file_what) {
    CLI::App* command = TableFlags::add_to(parent, name, what, file_what);
    add_results_to(*command);
    add_value_flag(*command, "--bootstrap", bootstrap, "simulated samples of each test of fit");
    command->add_flag("--empirical", observations,
                      "write the observations themselves, not only where no law fits");
    return command;
  }
  void add_calendar(CLI::App& command) {
    add_value_flag(command, "--hours", hours, "when the shop works, such as 07:00-15:00 (else all day)");
    add_value_flag(command, "--weekdays", weekdays, "on which days, such as mon-fri (else all)");
  }
  [[nodiscard]] fit::EventReportOptions options() const {
    return {.confidence = confidence_level(),
            .goodness_samples = static_cast<int>(whole_flag("--bootstrap", bootstrap, 19, 10'000)),
            .seed = seed_value(),
            .written = observations ? fit::Written::observations : fit::Written::best};
  }
};

void add_life(CLI::App& fit_command) {
  struct Flags : RemovalFlags {
    std::string gamma = "0.9";
    std::string bootstrap = "199";
    fit::LifeTarget target;
    std::string speed, feed, depth, min_per_part;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command = f->add_to(
      fit_command, "life", "Life laws of edges from a removal log",
      "removal log (CSV, xlsx): life or parts, cause; tool, regime, batch, edge, last inspection if known");
  f->add_results_to(*command);
  add_value_flag(*command, "--tool", f->removals.tool, "only rows of this tool");
  add_value_flag(*command, "--gamma", f->gamma, "share of edges that outlive the gamma-percent life");
  add_value_flag(*command, "--bootstrap", f->bootstrap, "simulated samples of each test of fit");
  add_value_flag(*command, "--to", f->target.pointer, "insert that the changes are for, such as /inserts/0");
  add_value_flag(*command, "--speed", f->speed,
                 "cutting speed of the log, m/min: reference regime of changes and library entry");
  add_value_flag(*command, "--feed", f->feed, "feed of the log, mm/rev");
  add_value_flag(*command, "--depth", f->depth, "depth of cut of the log, mm");
  add_value_flag(*command, "--min-per-part", f->min_per_part,
                 "cutting minutes of one part, when lives are in parts");
  command->footer(
      "Example:\n  verstat fit life docs/examples/fit/removals.csv --tool T5K10 --to /inserts/0\n"
      "Laws by censored maximum likelihood, ranked by AICc; bounds by profile likelihood.");
  command->callback([f] {
    fit::LifeAnalysisOptions options;
    options.gamma = real_flag("--gamma", f->gamma, 0.001, 0.999);
    options.confidence = f->confidence_level();
    options.goodness_samples = static_cast<int>(whole_flag("--bootstrap", f->bootstrap, 19, 10'000));
    options.seed = f->seed_value();
    fit::LifeTarget target = f->target;
    target.cutting_speed_m_min = maybe("--speed", f->speed, 1e-6, 1e5);
    target.feed_mm_rev = maybe("--feed", f->feed, 1e-6, 100);
    target.depth_of_cut_mm = maybe("--depth", f->depth, 1e-6, 1000);
    target.min_per_part = maybe("--min-per-part", f->min_per_part, 1e-6, 1e5);
    if (!f->library.empty() && !(target.cutting_speed_m_min && target.feed_mm_rev && target.depth_of_cut_mm))
      throw UsageError(fmt::format(
          "--library {}: the entry of an insert needs the regime of the log: --speed, --feed and --depth",
          f->library));
    const fit::RemovalLog log = f->log();
    f->answer_with(
        [&](const fit::Origin& origin) { return fit::report_lives(log, options, target, origin); });
  });
}

// "120,0.2,1.5": v, f, a_p.
std::array<double, 3> regime_of(const std::string& text) {
  std::array<double, 3> regime{};
  std::size_t from = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto comma = text.find(',', from);
    const bool last = k == 2;
    if ((comma == std::string::npos) != last)
      throw UsageError(fmt::format(
          "--at {}: must be SPEED,FEED,DEPTH in m/min, mm/rev and mm, such as 120,0.2,1.5", text));
    regime[k] = real_flag("--at", text.substr(from, comma - from), 1e-6, 1e5);
    from = comma + 1;
  }
  return regime;
}

void add_taylor(CLI::App& fit_command) {
  struct Flags : TableFlags {
    fit::WearOptions wear;
    std::string criterion = "0.3";
    std::vector<std::string> at;
    bool pool = false;
    std::string to;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command = f->add_to(
      fit_command, "taylor", "Extended Taylor equation from wear curves",
      "wear readings (CSV, xlsx): time, flank wear, cutting speed; feed, depth, material, tool, laboratory "
      "if known");
  f->add_results_to(*command);
  add_value_flag(*command, "--criterion", f->criterion,
                 "flank wear that ends the life, mm (ISO 3685: 0.3 even, 0.6 uneven)");
  add_value_flag(*command, "--material", f->wear.material, "only rows of this workpiece material");
  add_value_flag(*command, "--tool", f->wear.tool, "only rows of this tool");
  add_repeated_flag(*command, "--at", f->at, "SPEED,FEED,DEPTH to predict; may be repeated");
  command->add_flag("--pool-laboratories", f->pool, "one level for all laboratories instead of one each");
  add_value_flag(*command, "--to", f->to, "insert that the changes are for, such as /inserts/0");
  command->footer(
      "Example:\n  verstat fit taylor docs/examples/fit/wear.csv --at 150,0.2,1\n"
      "Runs that never reach the criterion count as censored; exponents the runs do not show are named, not "
      "guessed.");
  command->callback([f] {
    fit::WearOptions wear = f->of_table(f->wear);
    wear.criterion_mm = real_flag("--criterion", f->criterion, 1e-4, 10);
    fit::TaylorTarget target{.pointer = f->to, .regimes = {}};
    for (const std::string& text : f->at) target.regimes.push_back(regime_of(text));
    const fit::TaylorOptions options{.pool_laboratories = f->pool, .confidence = f->confidence_level()};
    const fit::WearData data = fit::read_wear(f->file, wear);
    f->answer_with(
        [&](const fit::Origin& origin) { return fit::report_taylor(data, options, target, origin); });
  });
}

void add_downtime(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::DowntimeOptions downtime;
    fit::DowntimeTarget target;
    std::string clock = "operating";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command = f->add_to(
      fit_command, "downtime", "Times between failures and of repairs from a downtime log",
      "downtime log (CSV, xlsx): start, end or duration; machine, mode, operating and cutting counters if "
      "known");
  f->add_calendar(*command);
  add_value_flag(*command, "--from", f->downtime.from, "start of watching, such as 2026-03-01");
  add_value_flag(*command, "--to-time", f->downtime.to, "end of watching");
  command->add_flag("--new-at-start", f->downtime.new_at_start, "machines were as new when watching began");
  add_value_flag(*command, "--clock", f->clock,
                 "calendar, operating or cutting: the clock of changes and library entries");
  add_value_flag(*command, "--mode", f->target.mode, "mode of failure that the changes are for");
  add_value_flag(*command, "--to-failure", f->target.to_failure,
                 "pointer of the duration that is the time to failure");
  add_value_flag(*command, "--to-repair", f->target.to_repair, "pointer of the duration that is the repair");
  command->add_flag("--accept-trend", f->target.accept_trend,
                    "write a renewal law although the rate of failures changes");
  command->footer(
      "Example:\n  verstat fit downtime docs/examples/fit/downtime.csv\n"
      "Laplace's trend test comes before any renewal law.");
  command->callback([f] {
    fit::DowntimeOptions downtime = f->of_table(f->downtime);
    downtime.calendar = fit::WorkCalendar(f->hours, f->weekdays);
    fit::DowntimeTarget target = f->target;
    if (f->clock == "calendar")
      target.clock = fit::Clock::calendar;
    else if (f->clock == "cutting")
      target.clock = fit::Clock::cutting;
    else if (f->clock != "operating")
      throw UsageError(fmt::format("--clock {}: must be calendar, operating or cutting", f->clock));
    const fit::EventReportOptions options = f->options();
    const fit::DowntimeLog log = fit::read_downtime(f->file, downtime);
    f->answer_with(
        [&](const fit::Origin& origin) { return fit::report_downtime(log, options, target, origin); });
  });
}

fit::SupplyForm supply_form(const std::string& text) {
  if (text == "law") return fit::SupplyForm::law;
  if (text == "profile") return fit::SupplyForm::profile;
  if (text == "orders") return fit::SupplyForm::orders;
  throw UsageError(fmt::format("--as {}: must be law, profile or orders", text));
}

void add_arrivals(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::ArrivalOptions arrivals;
    std::string to;
    std::string as = "law";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      f->add_to(fit_command, "arrivals", "Arrival or order log: times between, profiles of day and week",
                "arrival or order log (CSV, xlsx): arrival; quantity, part, order if known");
  f->add_calendar(*command);
  add_value_flag(*command, "--part", f->arrivals.part, "only rows of this part");
  add_value_flag(*command, "--as", f->as,
                 "what the supply becomes: law (times between), profile (rates over the week) or orders (as "
                 "they came)");
  add_value_flag(*command, "--to", f->to, "supply that the changes are for, such as /parts/0/supply");
  command->footer(
      "Example:\n  verstat fit arrivals docs/examples/fit/orders.csv --hours 07:00-15:00 --weekdays mon-fri "
      "--to "
      "/parts/0/supply");
  command->callback([f] {
    fit::ArrivalOptions arrivals = f->of_table(f->arrivals);
    arrivals.calendar = fit::WorkCalendar(f->hours, f->weekdays);
    const fit::EventReportOptions options = f->options();
    const fit::SupplyForm form = supply_form(f->as);
    const fit::ArrivalLog log = fit::read_arrivals(f->file, arrivals, options.confidence);
    const std::string name =
        f->arrivals.part.empty() ? std::filesystem::path(f->file).stem().string() : f->arrivals.part;
    f->answer_with([&](const fit::Origin& origin) {
      return fit::report_arrivals(log, options, form, f->to, name, origin);
    });
  });
}

void add_cycle(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::CycleOptions cycles;
    std::string to;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      f->add_to(fit_command, "cycle", "Laws of cycle times; the observations themselves where none fits",
                "cycle times (CSV, xlsx): cycle; operation if known");
  add_value_flag(*command, "--operation", f->cycles.operation, "only rows of this operation");
  add_value_flag(*command, "--to", f->to,
                 "duration that the changes are for, such as /operations/0/process/time");
  command->footer("Example:\n  verstat fit cycle docs/examples/fit/cycles.csv");
  command->callback([f] {
    const fit::EventReportOptions options = f->options();
    const fit::CycleLog log = fit::read_cycles(f->file, f->of_table(f->cycles));
    f->answer_with(
        [&](const fit::Origin& origin) { return fit::report_cycles(log, options, f->to, origin); });
  });
}

void add_value(CLI::App& fit_command) {
  struct Flags : RemovalFlags {
    std::string plans;
    std::string truths = "2000";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      f->add_to(fit_command, "value", "How many more edges to measure before choosing between plans",
                "removal log (CSV, xlsx), as for fit life");
  command->add_option("--plans", f->plans, "plans to choose between (JSON)")->required();
  add_value_flag(*command, "--truths", f->truths, "simulated truths");
  command->footer(
      "Example:\n  verstat fit value docs/examples/fit/removals.csv --plans docs/examples/fit/plans.json\n"
      "Expected value of sample information by simulation.");
  command->callback([f] {
    const int truths = static_cast<int>(whole_flag("--truths", f->truths, 100, 100'000));
    const fit::ValueSpec spec = fit::read_value_spec(f->plans);
    const fit::RemovalLog log = f->log();
    f->answer_with([&](const fit::Origin& origin) {
      return fit::report_value(log, spec, truths, f->seed_value(), origin);
    });
  });
}

}  // namespace

double real_flag(const std::string& flag, const std::string& text, double low, double high) {
  double value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value >= low) || !(value <= high))
    throw UsageError(
        fmt::format("{} {}: must be a number from {} to {}", flag, models::shortened(text, 100), low, high));
  return value;
}

std::int64_t whole_flag(const std::string& flag, const std::string& text, std::int64_t low,
                        std::int64_t high) {
  std::int64_t value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high)
    throw UsageError(fmt::format("{} {}: must be a whole number from {} to {}", flag,
                                 models::shortened(text, 100), low, high));
  return value;
}

fit::Origin origin_now(const std::string& file) {
  const store::Provenance now = provenance();
  return {
      .file = std::filesystem::path(file).filename().string(), .date = now.created, .version = now.version};
}

void answer(const fit::Report& report, bool json, const std::string& out, const std::string& library) {
  if (!out.empty()) {
    if (report.changes.empty())
      throw UsageError(
          fmt::format("--out {}: there are no changes to write; --to names what they are for", out));
    write_file("--out", out, report.json["patch"].dump(2) + "\n");
  }
  std::vector<std::string> entries;
  if (!library.empty()) entries = fit::write_library(library, report.library);
  if (json) {
    fmt::print("{}\n", report.json.dump(2));
    return;
  }
  for (const std::string& line : report.lines) fmt::print("{}\n", line);
  for (const std::string& warning : report.warnings) fmt::print("warning: {}\n", warning);
  if (!entries.empty()) fmt::print("\n");
  for (const std::string& entry : entries) fmt::print("library entry in {}\n", entry);
  if (report.changes.empty()) return;
  fmt::print("\nchanges{}:\n", out.empty()
                                   ? " (--out FILE keeps them with their provenance for --changes FILE)"
                                   : " in " + out);
  constexpr std::size_t readable = 400;
  for (const scenarios::Change& change : report.changes) {
    const std::string value =
        change.value.is_string() ? change.value.get<std::string>() : change.value.dump();
    if (value.size() <= readable)
      fmt::print("  --set '{}={}'\n", change.pointer, value);
    else
      fmt::print("  {}: {}... ({} characters)\n", change.pointer, models::shortened(value, 60), value.size());
  }
}

void add_fit(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "fit", "Turn the shop's records (CSV, xlsx) into inputs of a scenario, with their uncertainty");
  command->require_subcommand(1);
  add_life(*command);
  add_taylor(*command);
  add_downtime(*command);
  add_arrivals(*command);
  add_cycle(*command);
  add_value(*command);
  command->footer(
      "Example:\n  verstat fit life docs/examples/fit/removals.csv --tool T5K10\n"
      "Every row that is left out is named with its line and the reason.");
}

}  // namespace verstat::app
