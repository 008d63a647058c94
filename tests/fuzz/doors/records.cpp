// The shop's records, from the file to the lives, stops and arrivals a fit works with: the whole way of a CSV
// table, and that of a workbook behind its converter. The first letter says which log it is; small letters
// ask for what the converter asks for.
#include "fit/arrival_log.h"
#include "fit/cycle_log.h"
#include "fit/downtime_log.h"
#include "fit/order_file.h"
#include "fit/removal_log.h"
#include "fit/wear_curves.h"
#include "scenarios/json_text.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

const char* const shop_of_orders =
    R"({"parts":[{"name":"shaft","supply":{"kind":"orders","file":"records.csv"}}]})";

void read(char log, const std::string& path) {
  fit::TableOptions table;
  if (log >= 'a') table.separator = "semicolon";
  switch (log) {
    case 'L':
    case 'l':
      (void)fit::read_removals(path, {.table = table});
      break;
    case 'T':
    case 't':
      (void)fit::read_wear(path, {.table = table});
      break;
    case 'D':
    case 'd': {
      fit::DowntimeOptions options{.table = table};
      if (log == 'd') options.calendar = fit::WorkCalendar("07:00-15:00", "mon-fri");
      (void)fit::read_downtime(path, options);
      break;
    }
    case 'A':
    case 'a': {
      fit::ArrivalOptions options{.table = table};
      if (log == 'a') options.calendar = fit::WorkCalendar("07:00-15:00", "mon-fri");
      (void)fit::read_arrivals(path, options, 0.95);
      break;
    }
    case 'O':
      (void)fit::with_order_files(shop_of_orders, own_folder());
      break;
    default:
      (void)fit::read_cycles(path, {.table = table});
  }
}

void eat(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::string path = write_own("records.csv", bytes.substr(1));
  try {
    read(bytes.front(), path);
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  }
}

// The first lines of a table.
std::string head(const std::string& file, std::size_t bytes) {
  const std::string text = scenarios::read_text_file(file);
  return text.substr(0, text.find('\n', bytes) + 1);
}

std::vector<std::string> seeds() {
  const std::string examples = "docs/examples/fit/";
  return {
      "L" + head(examples + "removals.csv", 200),
      "l" + head(examples + "removals.csv", 200),
      "T" + head(examples + "wear.csv", 400),
      "D" + head(examples + "downtime.csv", 300),
      "d" + head(examples + "downtime.csv", 300),
      "A" + head(examples + "orders.csv", 200),
      "O" + head(examples + "orders.csv", 200),
      "C" + head(examples + "cycles.csv", 100),
      "Lparts,last good,cause,tool,regime,batch,edge\n31,29,worn,T1,A,1,1\n30,,planned,T1,A,2,2\n",
      "L\xd1\x81\xd1\x82\xd1\x96\xd0\xb9\xd0\xba\xd1\x96\xd1\x81\xd1\x82\xd1\x8c; "
      "\xd1\x85\xd0\xb2;\xd0\xbf\xd1\x80\xd0\xb8\xd1\x87\xd0\xb8\xd0\xbd\xd0\xb0\n45,5;\xd0\xbf\xd0\xbb\xd0"
      "\xb0\xd0\xbd\xd0\xbe\xd0\xb2\xd0\xb0\n1 "
      "200,0;\xd0\xbf\xd0\xbe\xd0\xbb\xd0\xbe\xd0\xbc\xd0\xba\xd0\xb0\n",
      "Dmachine,start,duration (h),operating hours,cutting hours\nA,2026-03-01 10:00,1.5,100,50\n"
      "A,2026-03-02T11:30,2,130,60\n",
      "Aarrival (min),quantity,part\n0,1,shaft\n12.5,2,shaft\n40,1,bush\n",
      "Oarrival (min),quantity,due (min),part\n0,1,100,shaft\n12.5,2,200,shaft\n",
      "cCycle, s;operation\n12.5;turning\n13;milling\n-;turning\n"};
}

}  // namespace

Target records_target() {
  return {"records", Form::bytes, eat, seeds};
}

}  // namespace verstat::fuzz
