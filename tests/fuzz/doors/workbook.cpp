// Workbooks through the converter, a process each: what it makes of broken ones must become an error in
// words. (What it prints goes the way that the door "records" tests.)
#include <fmt/format.h>

#include "fit/csv_table.h"
#include "scenarios/json_text.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  const std::string path = write_own("records.xlsx", bytes);
  try {
    (void)fit::read_table(path, {});
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  }
}

std::vector<std::string> seeds() {
  return {scenarios::read_text_file("tests/data/removals.xlsx")};
}

}  // namespace

Target workbook_target() {
  return {.name = "workbook", .form = Form::bytes, .eat = eat, .seeds = seeds, .short_run = 20};
}

}  // namespace verstat::fuzz
