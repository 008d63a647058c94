// verstat fit: from the shop's records to inputs of a scenario.
#include <charconv>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/files.h"
#include "app/fit_answer.h"
#include "fit/event_report.h"
#include "fit/life_report.h"
#include "fit/taylor_report.h"
#include "fit/value_report.h"

namespace verstat::app {
namespace {

// What all tables have in common.
struct TableFlags {
  std::string file;
  fit::TableOptions table;
  std::vector<std::string> columns;
  std::string duplicates = "identity";
  std::string confidence = "0.95";
  std::string seed = "1";
  std::string out;
  bool json = false;

  void add_to(CLI::App& command, const char* what) {
    command.add_option("FILE", file, what)->required();
    command.add_option("--column", columns, "ROLE=HEADER: which column plays a role; may be repeated")
        ->allow_extra_args(false);
    command.add_option("--encoding", table.encoding, "utf-8 or cp1251 (else found, with a note)");
    command.add_option("--separator", table.separator, "comma, semicolon or tab (else found, with a note)");
    command.add_option("--decimal", table.decimal, "point or comma (else found, refused when in doubt)");
    command
        .add_option("--duplicates", duplicates,
                    "rows written twice: drop, keep, or identity (drop when a column tells items apart)")
        ->capture_default_str();
    command.add_option("--confidence", confidence, "of the intervals, 0.5 to 0.999")->capture_default_str();
    command.add_option("--seed", seed, "of simulated samples")->capture_default_str();
    command.add_option("--out", out, "write the changes with their provenance to this file, for --changes");
    command.add_flag("--json", json, "print the answer as JSON on standard output");
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
  [[nodiscard]] std::vector<fit::ColumnChoice> choices() const {
    std::vector<fit::ColumnChoice> all;
    for (const std::string& text : columns) all.push_back(fit::parse_column_choice(text));
    return all;
  }
  [[nodiscard]] double confidence_level() const { return real_flag("--confidence", confidence, 0.5, 0.999); }
  [[nodiscard]] std::uint64_t seed_value() const {
    return static_cast<std::uint64_t>(whole_flag("--seed", seed, 0, 9'000'000'000'000'000));
  }
  [[nodiscard]] fit::Origin origin() const { return origin_now(file); }
};

std::optional<double> maybe(const char* flag, const std::string& text, double low, double high) {
  if (text.empty()) return std::nullopt;
  return real_flag(flag, text, low, high);
}

void add_life(CLI::App& fit_command) {
  struct Flags : TableFlags {
    fit::RemovalOptions removals;
    std::string gamma = "0.9";
    std::string bootstrap = "199";
    fit::LifeTarget target;
    std::string speed, feed, depth, min_per_part;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command = fit_command.add_subcommand("life", "Life laws of edges from a removal log");
  f->add_to(*command,
            "removal log (CSV): life or parts, cause; tool, regime, batch, edge, last inspection if known");
  command->add_option("--tool", f->removals.tool, "only rows of this tool");
  command->add_option("--regime", f->removals.regime, "only rows of this regime");
  command
      ->add_option("--planned-cause", f->removals.planned_causes,
                   "a further word for: taken out although it still cut")
      ->allow_extra_args(false);
  command->add_option("--failure-cause", f->removals.failure_causes, "a further word for a failure")
      ->allow_extra_args(false);
  command->add_option("--gamma", f->gamma, "share of edges that outlive the gamma-percent life")
      ->capture_default_str();
  command->add_option("--bootstrap", f->bootstrap, "simulated samples of each test of fit")
      ->capture_default_str();
  command->add_option("--to", f->target.pointer, "insert that the changes are for, such as /inserts/0");
  command->add_option("--speed", f->speed,
                      "cutting speed of the log, m/min: reference regime of the changes");
  command->add_option("--feed", f->feed, "feed of the log, mm/rev");
  command->add_option("--depth", f->depth, "depth of cut of the log, mm");
  command->add_option("--min-per-part", f->min_per_part,
                      "cutting minutes of one part, when lives are in parts");
  command->footer(
      "Example:\n  verstat fit life docs/examples/fit/removals.csv --tool T5K10 --to /inserts/0\n"
      "Laws by censored maximum likelihood, ranked by AICc; bounds by profile likelihood.");
  command->callback([f] {
    fit::RemovalOptions removals = f->removals;
    removals.table = f->table_options();
    removals.columns = f->choices();
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
    const fit::RemovalLog log = fit::read_removals(f->file, removals);
    answer(fit::report_lives(log, options, target, f->origin()), f->json, f->out);
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
  CLI::App* command = fit_command.add_subcommand("taylor", "Extended Taylor equation from wear curves");
  f->add_to(*command,
            "wear readings (CSV): time, flank wear, cutting speed; feed, depth, material, tool, laboratory "
            "if known");
  command
      ->add_option("--criterion", f->criterion,
                   "flank wear that ends the life, mm (ISO 3685: 0.3 even, 0.6 uneven)")
      ->capture_default_str();
  command->add_option("--material", f->wear.material, "only rows of this workpiece material");
  command->add_option("--tool", f->wear.tool, "only rows of this tool");
  command->add_option("--at", f->at, "SPEED,FEED,DEPTH to predict; may be repeated")->allow_extra_args(false);
  command->add_flag("--pool-laboratories", f->pool, "one level for all laboratories instead of one each");
  command->add_option("--to", f->to, "insert that the changes are for, such as /inserts/0");
  command->footer(
      "Example:\n  verstat fit taylor docs/examples/fit/wear.csv --at 150,0.2,1\n"
      "Runs that never reach the criterion count as censored; exponents the runs do not show are named, not "
      "guessed.");
  command->callback([f] {
    fit::WearOptions wear = f->wear;
    wear.table = f->table_options();
    wear.columns = f->choices();
    wear.criterion_mm = real_flag("--criterion", f->criterion, 1e-4, 10);
    fit::TaylorTarget target{.pointer = f->to, .regimes = {}};
    for (const std::string& text : f->at) target.regimes.push_back(regime_of(text));
    const fit::TaylorOptions options{.pool_laboratories = f->pool, .confidence = f->confidence_level()};
    const fit::WearData data = fit::read_wear(f->file, wear);
    answer(fit::report_taylor(data, options, target, f->origin()), f->json, f->out);
  });
}

struct EventFlags : TableFlags {
  std::string bootstrap = "199";
  std::string hours, weekdays;
  void add_calendar(CLI::App& command) {
    command.add_option("--hours", hours, "when the shop works, such as 07:00-15:00 (else all day)");
    command.add_option("--weekdays", weekdays, "on which days, such as mon-fri (else all)");
  }
  void add_to(CLI::App& command, const char* what) {
    TableFlags::add_to(command, what);
    command.add_option("--bootstrap", bootstrap, "simulated samples of each test of fit")
        ->capture_default_str();
  }
  [[nodiscard]] fit::EventReportOptions options() const {
    return {.confidence = confidence_level(),
            .goodness_samples = static_cast<int>(whole_flag("--bootstrap", bootstrap, 19, 10'000)),
            .seed = seed_value()};
  }
};

void add_downtime(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::DowntimeOptions downtime;
    fit::DowntimeTarget target;
    std::string clock = "operating";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      fit_command.add_subcommand("downtime", "Times between failures and of repairs from a downtime log");
  f->add_to(
      *command,
      "downtime log (CSV): start, end or duration; machine, mode, operating and cutting counters if known");
  f->add_calendar(*command);
  command->add_option("--from", f->downtime.from, "start of watching, such as 2026-03-01");
  command->add_option("--to-time", f->downtime.to, "end of watching");
  command->add_flag("--new-at-start", f->downtime.new_at_start, "machines were as new when watching began");
  command->add_option("--clock", f->clock, "calendar, operating or cutting: the clock of the changes")
      ->capture_default_str();
  command->add_option("--mode", f->target.mode, "mode of failure that the changes are for");
  command->add_option("--to-failure", f->target.to_failure,
                      "pointer of the duration that is the time to failure");
  command->add_option("--to-repair", f->target.to_repair, "pointer of the duration that is the repair");
  command->add_flag("--accept-trend", f->target.accept_trend,
                    "write a renewal law although the rate of failures changes");
  command->footer(
      "Example:\n  verstat fit downtime docs/examples/fit/downtime.csv\n"
      "Laplace's trend test comes before any renewal law.");
  command->callback([f] {
    fit::DowntimeOptions downtime = f->downtime;
    downtime.table = f->table_options();
    downtime.columns = f->choices();
    downtime.calendar = fit::WorkCalendar(f->hours, f->weekdays);
    fit::DowntimeTarget target = f->target;
    if (f->clock == "calendar")
      target.clock = fit::Clock::calendar;
    else if (f->clock == "cutting")
      target.clock = fit::Clock::cutting;
    else if (f->clock != "operating")
      throw UsageError(fmt::format("--clock {}: must be calendar, operating or cutting", f->clock));
    const fit::DowntimeLog log = fit::read_downtime(f->file, downtime);
    answer(fit::report_downtime(log, f->options(), target, f->origin()), f->json, f->out);
  });
}

void add_arrivals(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::ArrivalOptions arrivals;
    std::string to;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      fit_command.add_subcommand("arrivals", "Arrival or order log: times between, profiles of day and week");
  f->add_to(*command, "arrival or order log (CSV): arrival; quantity, part, order if known");
  f->add_calendar(*command);
  command->add_option("--part", f->arrivals.part, "only rows of this part");
  command->add_option("--to", f->to, "supply that the changes are for, such as /parts/0/supply");
  command->footer(
      "Example:\n  verstat fit arrivals docs/examples/fit/orders.csv --hours 07:00-15:00 --weekdays mon-fri "
      "--to "
      "/parts/0/supply");
  command->callback([f] {
    fit::ArrivalOptions arrivals = f->arrivals;
    arrivals.table = f->table_options();
    arrivals.columns = f->choices();
    arrivals.calendar = fit::WorkCalendar(f->hours, f->weekdays);
    const fit::ArrivalLog log = fit::read_arrivals(f->file, arrivals, f->confidence_level());
    answer(fit::report_arrivals(log, f->options(), f->to, f->origin()), f->json, f->out);
  });
}

void add_cycle(CLI::App& fit_command) {
  struct Flags : EventFlags {
    fit::CycleOptions cycles;
    std::string to;
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      fit_command.add_subcommand("cycle", "Laws of cycle times, with their quantiles to fall back on");
  f->add_to(*command, "cycle times (CSV): cycle; operation if known");
  command->add_option("--operation", f->cycles.operation, "only rows of this operation");
  command->add_option("--to", f->to, "duration that the changes are for, such as /operations/0/process/time");
  command->footer("Example:\n  verstat fit cycle docs/examples/fit/cycles.csv");
  command->callback([f] {
    fit::CycleOptions cycles = f->cycles;
    cycles.table = f->table_options();
    cycles.columns = f->choices();
    const fit::CycleLog log = fit::read_cycles(f->file, cycles);
    answer(fit::report_cycles(log, f->options(), f->to, f->origin()), f->json, f->out);
  });
}

void add_value(CLI::App& fit_command) {
  struct Flags : TableFlags {
    fit::RemovalOptions removals;
    std::string plans;
    std::string truths = "2000";
  };
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      fit_command.add_subcommand("value", "How many more edges to measure before choosing between plans");
  f->add_to(*command, "removal log (CSV), as for fit life");
  command->add_option("--plans", f->plans, "plans to choose between (JSON)")->required();
  command->add_option("--regime", f->removals.regime, "only rows of this regime");
  command
      ->add_option("--planned-cause", f->removals.planned_causes,
                   "a further word for: taken out although it still cut")
      ->allow_extra_args(false);
  command->add_option("--failure-cause", f->removals.failure_causes, "a further word for a failure")
      ->allow_extra_args(false);
  command->add_option("--truths", f->truths, "simulated truths")->capture_default_str();
  command->footer(
      "Example:\n  verstat fit value docs/examples/fit/removals.csv --plans docs/examples/fit/plans.json\n"
      "Expected value of sample information by simulation.");
  command->callback([f] {
    fit::RemovalOptions removals = f->removals;
    removals.table = f->table_options();
    removals.columns = f->choices();
    const int truths = static_cast<int>(whole_flag("--truths", f->truths, 100, 100'000));
    const fit::ValueSpec spec = fit::read_value_spec(f->plans);
    const fit::RemovalLog log = fit::read_removals(f->file, removals);
    answer(fit::report_value(log, spec, truths, f->seed_value(), f->origin()), f->json, f->out);
  });
}

}  // namespace

double real_flag(const std::string& flag, const std::string& text, double low, double high) {
  double value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value >= low) || !(value <= high))
    throw UsageError(
        fmt::format("{} {}: must be a number from {} to {}", flag, text.substr(0, 100), low, high));
  return value;
}

std::int64_t whole_flag(const std::string& flag, const std::string& text, std::int64_t low,
                        std::int64_t high) {
  std::int64_t value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high)
    throw UsageError(
        fmt::format("{} {}: must be a whole number from {} to {}", flag, text.substr(0, 100), low, high));
  return value;
}

fit::Origin origin_now(const std::string& file) {
  const store::Provenance now = provenance();
  return {
      .file = std::filesystem::path(file).filename().string(), .date = now.created, .version = now.version};
}

void answer(const fit::Report& report, bool json, const std::string& out) {
  if (!out.empty()) {
    if (report.changes.empty())
      throw UsageError(
          fmt::format("--out {}: there are no changes to write; --to names what they are for", out));
    write_file("--out", out, report.json["patch"].dump(2) + "\n");
  }
  if (json) {
    fmt::print("{}\n", report.json.dump(2));
    return;
  }
  for (const std::string& line : report.lines) fmt::print("{}\n", line);
  for (const std::string& warning : report.warnings) fmt::print("warning: {}\n", warning);
  if (report.changes.empty()) return;
  fmt::print("\nchanges{}:\n", out.empty()
                                   ? " (--out FILE keeps them with their provenance for --changes FILE)"
                                   : " in " + out);
  for (const scenarios::Change& change : report.changes)
    fmt::print("  --set '{}={}'\n", change.pointer,
               change.value.is_string() ? change.value.get<std::string>() : change.value.dump());
}

void add_fit(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "fit", "Turn the shop's records (CSV) into inputs of a scenario, with their uncertainty");
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
