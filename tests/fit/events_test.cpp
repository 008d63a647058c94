// Downtime, arrivals, cycles: trend before renewal, the right clock, laws or the observations themselves.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "fit/arrival_log.h"
#include "fit/cycle_log.h"
#include "fit/downtime_log.h"
#include "fit/duration_fit.h"
#include "fit/event_report.h"
#include "fit/fit_error.h"
#include "models/math/normal.h"
#include "scenarios/json_text.h"
#include "sim/kernel/random_stream.h"

using namespace verstat::fit;
using Catch::Contains;
using verstat::scenarios::InputError;
using verstat::sim::RandomStream;

namespace {

class File {
 public:
  explicit File(const std::string& text) {
    static int number = 0;
    path_ = (std::filesystem::temp_directory_path() /
             ("verstat-events-" + std::to_string(::getpid()) + "-" + std::to_string(++number) + ".csv"))
                .string();
    std::ofstream(path_, std::ios::binary) << text;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

const ModeTimes& times_of(const DowntimeLog& log, const std::string& mode, Clock clock) {
  for (const ModeTimes& t : log.times)
    if (t.mode == mode && t.clock == clock) return t;
  throw std::runtime_error("no such mode and clock");
}

}  // namespace

TEST_CASE("Laplace's test: by hand, its level, and a wearing machine", "[fit]") {
  // Events at 2, 6, 7 in 0..10: (15 - 15) / sqrt(3 * 100 / 12) = 0; at 8, 9 also watched to 10.
  CHECK(laplace_test({{{2, 6, 7}, 10}}).statistic == Approx(0).margin(1e-12));
  CHECK(laplace_test({{{6, 7, 8}, 10}}).statistic == Approx(6 / std::sqrt(25.0)));
  // Watched to the last event: it is the end, not an event.
  CHECK(laplace_test({{{2, 8, 10}, 10}}).events == 2);
  CHECK(laplace_test({{{2, 8, 10}, 10}}).statistic == Approx(0).margin(1e-12));
  // Two machines together.
  CHECK(laplace_test({{{6, 7}, 10}, {{30}, 40}}).statistic ==
        Approx((13 + 30 - 10 - 20) / std::sqrt(2 * 100 / 12.0 + 1600 / 12.0)));
  int refused = 0;
  int growth_covered = 0;
  int seen = 0;
  for (int k = 0; k < 1000; ++k) {
    RandomStream stream(21, "machine", "steady", static_cast<std::uint64_t>(k));
    EventSeries steady{{}, 1000};
    for (double t = stream.exponential(40); t < 1000; t += stream.exponential(40)) steady.times.push_back(t);
    refused += laplace_test({steady}).p_value < 0.05 ? 1 : 0;
    // Power law with growth 2: unit-rate arrivals s = lambda t^2.
    EventSeries wearing{{}, 1000};
    for (double s = stream.exponential(1); s < 25; s += stream.exponential(1))
      wearing.times.push_back(1000 * std::sqrt(s / 25));
    seen += laplace_test({wearing}).p_value < 0.05 && laplace_test({wearing}).statistic > 0 ? 1 : 0;
    if (wearing.times.size() < 2) continue;
    const PowerLaw law = fit_power_law({wearing}, 0.95);
    growth_covered += law.growth_bounds.low <= 2 && 2 <= law.growth_bounds.high ? 1 : 0;
  }
  CHECK(refused > 29);  // 50 of 1000, standard error 7
  CHECK(refused < 71);
  CHECK(seen > 700);
  CHECK(growth_covered > 929);
  CHECK(growth_covered < 971);
}

TEST_CASE("times between failures on each clock, by hand", "[fit]") {
  // One machine, watched 0..1000 on a minute counter; two modes.
  const File file(
      "machine,mode,start (min),end (min),cutting (min)\n"
      "m1,belt,100,110,50\n"
      "m1,motor,200,250,90\n"
      "m1,belt,400,420,200\n"
      "m1,belt,390,395,195\n"
      "m1,belt,700,705,330\n"
      "m1,motor,650,640,300\n");
  DowntimeOptions options;
  const DowntimeLog log = read_downtime(file.path(), options);
  CHECK(log.rows_used == 5);
  REQUIRE(log.table.dropped.size() == 1);
  CHECK(log.table.dropped[0].line == 7);
  CHECK(log.from_min == 100);
  CHECK(log.to_min == 705);
  // Calendar: from the end of one belt stop to the start of the next: 390 - 110, 400 - 395, 700 - 420.
  const auto& calendar = times_of(log, "belt", Clock::calendar).between;
  REQUIRE(calendar.size() == 3);
  CHECK(calendar[0].low == 280);
  CHECK(calendar[1].low == 5);
  CHECK(calendar[2].low == 280);
  // Operating: without the 50 min of the motor.
  const auto& operating = times_of(log, "belt", Clock::operating).between;
  REQUIRE(operating.size() == 3);
  CHECK(operating[0].low == 230);
  CHECK(operating[1].low == 5);
  CHECK(operating[2].low == 280);
  const auto& cutting = times_of(log, "belt", Clock::cutting).between;
  REQUIRE(cutting.size() == 3);
  CHECK(cutting[0].low == 145);
  // The motor stopped once: one unfinished time on the calendar, from 250 to the end of watching.
  const auto& motor = times_of(log, "motor", Clock::calendar).between;
  REQUIRE(motor.size() == 1);
  CHECK_FALSE(motor[0].failed());
  CHECK(motor[0].low == 455);
  // Repairs.
  for (const ModeRepairs& r : log.repairs)
    if (r.mode == "belt") CHECK(r.repairs.size() == 4);
  // As new at the start: the first time counts.
  options.new_at_start = true;
  options.from = "1970-01-01";
  options.to = "1970-01-02";
  const DowntimeLog fresh = read_downtime(file.path(), options);
  const auto& first = times_of(fresh, "belt", Clock::calendar).between;
  CHECK(first.front().low == 100);
  CHECK_FALSE(first.back().failed());
  CHECK(first.back().low == 1440 - 705);
}

TEST_CASE("a renewal process seen through a downtime log gives its law back", "[fit]") {
  RandomStream stream(23, "machine", "weibull");
  std::string text = "start (min),duration (min)\n";
  double t = 0;
  for (int k = 0; k < 3000; ++k) {
    t += 500 * std::pow(-std::log1p(-stream.uniform()), 1 / 1.5);
    const double repair = std::exp(3 + 0.6 * verstat::models::normal_quantile(stream.uniform()));
    text += std::to_string(t) + "," + std::to_string(repair) + "\n";
    t += repair;
  }
  const File file(text);
  const DowntimeLog log = read_downtime(file.path(), {});
  const DurationFit fit = fit_durations(times_of(log, "", Clock::operating).between, 49, 1);
  REQUIRE(fit.laws.front().law.family == LifeFamily::weibull);
  CHECK(fit.laws.front().law.first == Approx(500).epsilon(0.04));
  CHECK(fit.laws.front().law.second == Approx(1.5).epsilon(0.05));
  const DurationFit repair = fit_durations(log.repairs.front().repairs, 49, 1);
  REQUIRE(repair.laws.front().law.family == LifeFamily::lognormal);
  CHECK(repair.laws.front().law.first == Approx(3).epsilon(0.02));
  CHECK(repair.laws.front().law.second == Approx(0.6).epsilon(0.05));
  CHECK_FALSE(repair.empirical);
}

TEST_CASE("cycle times of two kinds of part: no law, the quantiles stand", "[fit]") {
  std::vector<Observation> times;
  RandomStream stream(29, "operation", "cycle");
  for (int k = 0; k < 200; ++k)
    times.push_back(
        exact_life((k % 3 == 0 ? 5 : 2) + 0.1 * verstat::models::normal_quantile(stream.uniform())));
  const DurationFit fit = fit_durations(times, 99, 1);
  CHECK(fit.empirical);
  CHECK(fit.quantiles.size() == 101);
  CHECK(fit.quantiles[0] == fit.least);
  CHECK(fit.quantiles[100] == fit.most);
  CHECK(fit.quantiles[50] == Approx(2).margin(0.2));
  CHECK(fit.quantiles[90] == Approx(5).margin(0.2));
  CHECK(fit.largest_gap > 0.1);
  // A scenario then gets the observations themselves.
  const ScenarioDuration written = duration_of(fit);
  CHECK(written.law == "empirical");
  REQUIRE(written.value["values_min"].size() == 200);
  CHECK_FALSE(written.value.contains("weights"));
  CHECK(written.value["values_min"][0] == fit.least);
  // Always the same.
  const DurationFit same = fit_durations({exact_life(3), exact_life(3)}, 99, 1);
  CHECK(same.constant);
  CHECK(same.laws.empty());
  CHECK_THROWS_AS(fit_durations({exact_life(3)}, 99, 1), FitError);
}

TEST_CASE("observations as a duration: counts, unfinished times, and quantiles of very many", "[fit]") {
  // Three of five seen once, one twice.
  const DurationFit counted =
      fit_durations({exact_life(4), exact_life(2), exact_life(4), exact_life(9), exact_life(5)}, 39, 1);
  const auto written = duration_of(counted, Written::observations);
  CHECK(written.value["values_min"] == nlohmann::json({2, 4, 5, 9}));
  CHECK(written.value["weights"] == nlohmann::json({1, 2, 1, 1}));
  // Kaplan-Meier by hand: 2 of 4 (1/4), then 1 of 2 at risk at 6 (3/8); the unfinished one at 8 leaves 3/8
  // to 6.
  const DurationFit unfinished =
      fit_durations({exact_life(2), survived(3), exact_life(6), survived(8)}, 39, 1);
  CHECK(unfinished.distinct == std::vector<double>({2, 6}));
  CHECK(unfinished.weights[0] == Approx(0.25));
  CHECK(unfinished.weights[1] == Approx(0.75));
  CHECK(unfinished.weight_beyond == Approx(0.375));
  // More different values than a scenario wants to carry: the same distribution by its quantiles.
  std::vector<Observation> many;
  RandomStream stream(31, "operation", "many");
  for (int k = 0; k < 5000; ++k) many.push_back(exact_life(stream.uniform(1, 3)));
  const DurationFit fit = fit_durations(many, 39, 1);
  const auto quantiles = duration_of(fit, Written::observations);
  REQUIRE(quantiles.value["values_min"].size() == 1001);
  CHECK(quantiles.value["values_min"][0] == fit.least);
  CHECK(quantiles.value["values_min"][1000] == Approx(fit.most).epsilon(1e-12));
  for (const int q : {100, 500, 900})
    CHECK(quantiles.value["values_min"][static_cast<std::size_t>(q)] ==
          Approx(1 + 2 * q / 1000.0).margin(0.05));
  CHECK(duration_of(fit_durations({exact_life(3), exact_life(3)}, 39, 1)).law == "constant");
}

TEST_CASE("arrivals: Poisson in the day shift is seen as such", "[fit]") {
  RandomStream stream(31, "orders", "poisson");
  std::string text = "Date;Quantity\n";
  int arrivals = 0;
  const auto two = [](int x) { return (x < 10 ? "0" : "") + std::to_string(x); };
  for (int day = 1; day <= 28; ++day)
    for (double t = 7 * 60 + stream.exponential(60); t < 15 * 60; t += stream.exponential(60)) {
      const int minute = static_cast<int>(t);
      text += two(day) + ".02.2027 " + two(minute / 60) + ":" + two(minute % 60) + ";2\n";
      ++arrivals;
    }
  text += "soon;2\n";
  const File file(text);
  const ArrivalLog log = read_arrivals(file.path(), {}, 0.95);
  CHECK(static_cast<int>(log.rows_used) == arrivals);
  CHECK(log.table.dropped.size() == 1);
  CHECK(log.calendar);
  CHECK_FALSE(log.dates_only);
  CHECK(log.hour_p_value < 1e-6);     // nothing comes at night
  CHECK(log.weekday_p_value > 0.01);  // all days alike
  CHECK(log.dispersion_p_value > 0.01);
  CHECK(log.trend.p_value > 0.01);
  REQUIRE(log.hours.size() == 24);
  CHECK(log.hours[3].arrivals == 0);
  CHECK(log.hours[10].rate_per_h == Approx(1).margin(0.6));
  CHECK(log.hours[10].bounds.low < 1);
  CHECK(log.hours[10].bounds.high > 1);
  REQUIRE(log.weekdays.size() == 7);
  CHECK(log.weekdays[0].name == "Monday");
  // 1 February 2027 is a Monday, and every weekday comes four times.
  for (const RateSlot& d : log.weekdays) CHECK(d.exposure_h == Approx(96));
  const DurationFit fit = fit_durations(log.between, 49, 1);
  CHECK(fit.values == log.between.size());
  const File mixed("Date;Quantity\n2027-02-01;1\n17;1\n18;1\n19;2\n");
  CHECK_THROWS_WITH(read_arrivals(mixed.path(), {}, 0.95), Contains("cannot be one time axis"));
}

TEST_CASE("exposure and scatter of days are those of a count day by day, over any years", "[fit]") {
  // Three weeks and a day from a Wednesday on: 16 working days; arrivals at weekends are not of them.
  const File file(
      "Date;Quantity\n2027-02-03 08:10;1\n2027-02-03 09:10;1\n2027-02-05 14:30;1\n2027-02-06 09:00;1\n"
      "2027-02-10 07:00;1\n2027-02-24 10:00;1\n");
  const ArrivalLog log =
      read_arrivals(file.path(), {.calendar = WorkCalendar("07:00-15:00", "mon-fri")}, 0.95);
  std::vector<double> per_day;
  double hours = 0;
  for (int d = 0; d <= 21; ++d) {  // 3 February 2027 is a Wednesday
    if ((d + 2) % 7 >= 5) continue;
    hours += 8;
    per_day.push_back(d == 0 ? 2 : d == 2 || d == 7 || d == 21 ? 1 : 0);
  }
  double exposed = 0;
  for (const RateSlot& slot : log.weekdays) exposed += slot.exposure_h;
  CHECK(exposed == Approx(hours));
  CHECK(log.weekdays[2].exposure_h == Approx(32));  // four Wednesdays
  CHECK(log.weekdays[0].exposure_h == Approx(24));  // the 8th, 15th and 22nd
  CHECK(log.weekdays[3].exposure_h == Approx(24));
  CHECK(log.weekdays[5].exposure_h == 0);
  CHECK(log.weekdays[5].arrivals == 1);
  CHECK(log.hours[7].exposure_h == Approx(16));
  CHECK(log.hours[15].exposure_h == 0);
  double mean = 0;
  for (const double n : per_day) mean += n / static_cast<double>(per_day.size());
  double squares = 0;
  for (const double n : per_day) squares += (n - mean) * (n - mean);
  CHECK(log.dispersion_of_days == Approx(squares / static_cast<double>(per_day.size() - 1) / mean));
  // A year that is a typing error must not cost minutes.
  const File far("Date;Quantity\n1900-01-01 08:00;1\n2027-02-03 09:10;1\n9999-12-31 08:00;1\n");
  const ArrivalLog long_log =
      read_arrivals(far.path(), {.calendar = WorkCalendar("07:00-15:00", "mon-fri")}, 0.95);
  double days = 0;
  for (const RateSlot& slot : long_log.weekdays) days += slot.exposure_h / 8;
  CHECK(days == Approx(2'958'464.0 * 5 / 7).epsilon(1e-5));
}

TEST_CASE("a known profile of the week comes back as a weekly profile", "[fit]") {
  // 2 an hour in the morning, 4 after noon, Fridays half of it, nothing at night and at weekends; 28 weeks.
  const auto rate = [](int weekday, int hour) {
    if (weekday > 4 || hour < 8 || hour >= 16) return 0.0;
    return (hour < 12 ? 2.0 : 4.0) * (weekday == 4 ? 0.5 : 1.0);
  };
  RandomStream stream(37, "orders", "profile");
  std::string text = "Date\n";
  const auto two = [](int x) { return (x < 10 ? "0" : "") + std::to_string(x); };
  for (int day = 0; day < 7 * 28; ++day)
    for (int hour = 8; hour < 16; ++hour) {
      if (!(rate(day % 7, hour) > 0)) continue;
      for (double t = stream.exponential(60 / rate(day % 7, hour)); t < 60;
           t += stream.exponential(60 / rate(day % 7, hour))) {
        // 1 February 2027 is a Monday.
        const std::chrono::sys_days date =
            std::chrono::sys_days(std::chrono::year(2027) / 2 / 1) + std::chrono::days(day);
        const std::chrono::year_month_day ymd(date);
        text += std::to_string(static_cast<int>(ymd.year())) + "-" +
                two(static_cast<int>(static_cast<unsigned>(ymd.month()))) + "-" +
                two(static_cast<int>(static_cast<unsigned>(ymd.day()))) + " " + two(hour) + ":" +
                two(static_cast<int>(t)) + "\n";
      }
    }
  const File file(text);
  const ArrivalLog log = read_arrivals(file.path(), {}, 0.95);
  EventReportOptions options;
  options.goodness_samples = 19;
  const Report report =
      report_arrivals(log, options, SupplyForm::profile, "/parts/0/supply", "orders", {.file = "orders.csv"});
  REQUIRE(report.changes.size() == 1);
  const auto& supply = report.changes[0].value;
  CHECK(supply["kind"] == "weekly_profile");
  std::vector<double> per_h(168, 0.0);
  for (const auto& period : supply["rates"])
    for (int hour = period["from_h"]; hour < period["to_h"]; ++hour)
      per_h[static_cast<std::size_t>(hour)] = period["per_h"];
  // Arrivals within one minute are one arrival: 60 (1 - exp(-rate / 60)) are seen.
  for (int hour = 0; hour < 168; ++hour) {
    INFO(hour);
    const double truth = 60 * -std::expm1(-rate(hour / 24, hour % 24) / 60);
    CHECK(per_h[static_cast<std::size_t>(hour)] == Approx(truth).epsilon(0.2));
  }
  REQUIRE(report.library.size() == 1);
  CHECK(report.library[0].kind == "supply");
}

TEST_CASE("working time: a shift from Monday to Friday", "[fit]") {
  const WorkCalendar shift("07:00-15:00", "mon-fri");
  const auto at = [](const char* text) { return *verstat::fit::parse_moment(text); };
  const auto between = [&](const char* from, const char* to) {
    return shift.worked_min(at(to)) - shift.worked_min(at(from));
  };
  // 2027-02-05 is a Friday.
  CHECK(between("2027-02-05 14:00", "2027-02-08 08:30") == Approx(60 + 90));
  CHECK(between("2027-02-05 16:00", "2027-02-08 06:00") == 0);
  CHECK(between("2027-02-01", "2027-03-01") == Approx(20 * 480));
  CHECK(shift.working(at("2027-02-05 07:00")));
  CHECK_FALSE(shift.working(at("2027-02-05 15:00")));
  CHECK_FALSE(shift.working(at("2027-02-06 09:00")));
  CHECK(WorkCalendar("", "sat-mon").working(at("2027-02-07 03:00")));
  CHECK(WorkCalendar().worked_min(123.5) == 123.5);
  // Minute by minute over two weeks.
  double sum = 0;
  for (double t = at("2027-02-03 11:00"); t < at("2027-02-17 12:00"); t += 1) sum += shift.working(t) ? 1 : 0;
  CHECK(between("2027-02-03 11:00", "2027-02-17 12:00") == Approx(sum));
  for (const char* bad : {"7-15", "15:00-07:00", "07:00", "07:00-25:00", "07:60-08:00"})
    CHECK_THROWS_WITH(WorkCalendar(bad, ""), Contains("--hours"));
  for (const char* bad : {"monday", "mon-", ",", "mon;tue"})
    CHECK_THROWS_WITH(WorkCalendar("", bad), Contains("--weekdays"));
}

TEST_CASE("Poisson orders of the day shift are exponential on the clock of the shift", "[fit]") {
  RandomStream stream(37, "orders", "shift");
  std::string text = "Date\n";
  const auto two = [](int x) { return (x < 10 ? "0" : "") + std::to_string(x); };
  // Whole minutes would make ties and steps: seconds do not show at a mean of 90 min.
  double carried = stream.exponential(90);
  for (int day = 1; day <= 60; ++day) {
    double t = carried;
    for (; t < 480; t += stream.exponential(90)) {
      const int second = static_cast<int>((t + 420) * 60);
      text += day <= 31 ? "2027-03-" + two(day) : "2027-04-" + two(day - 31);
      text += " " + two(second / 3600) + ":" + two(second / 60 % 60) + ":" + two(second % 60) + "\n";
    }
    carried = t - 480;
  }
  const File file(text);
  ArrivalOptions options;
  options.calendar = WorkCalendar("07:00-15:00", "");
  const ArrivalLog log = read_arrivals(file.path(), options, 0.95);
  CHECK(log.hour_p_value > 0.01);  // the same rate in every hour of the shift
  CHECK(log.hours[3].exposure_h == 0);
  CHECK(log.hours[7].exposure_h == Approx(60).margin(1));
  CHECK(log.dispersion_p_value > 0.01);
  const DurationFit shift = fit_durations(log.between, 99, 1);
  CHECK(shift.laws.front().law.mean() == Approx(90).epsilon(0.2));
  CHECK_FALSE(shift.empirical);
  for (const LawReport& law : shift.laws)
    if (law.law.family == LifeFamily::exponential) CHECK(law.goodness.p_value > 0.05);
  // On the calendar the nights are gaps that no exponential law has.
  const DurationFit calendar = fit_durations(read_arrivals(file.path(), {}, 0.95).between, 99, 1);
  for (const LawReport& law : calendar.laws)
    if (law.law.family == LifeFamily::exponential) CHECK(law.goodness.p_value < 0.05);
}

TEST_CASE("Garwood's interval", "[fit]") {
  CHECK(poisson_interval(0, 0.95).low == 0);
  CHECK(poisson_interval(0, 0.95).high ==
        Approx(3.689).margin(5e-4));  // Pearson, Hartley, Biometrika Tables, table 40
  CHECK(poisson_interval(10, 0.95).low == Approx(4.795).margin(5e-4));
  CHECK(poisson_interval(10, 0.95).high == Approx(18.390).margin(1e-3));
}
