// Tables as spreadsheets write them, to cells; with the options that the converter of workbooks asks for,
// too.
#include "fit/csv_table.h"
#include "scenarios/json_text.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  for (const char* const separator : {"", "semicolon"}) {
    try {
      fit::TableOptions options;
      options.separator = separator;
      const fit::Table table = fit::parse_table("table.csv", bytes, options);
      for (const fit::Row& row : table.rows)
        if (row.cells.size() != table.columns.size()) finding("a row with too many or too few cells");
    } catch (const scenarios::InputError& e) {
      check_words(e.what());
    }
  }
}

std::vector<std::string> seeds() {
  return {scenarios::read_text_file("tests/data/turning_wear.csv").substr(0, 300),
          "tool,time min,failed\n1,30.5,yes\n2,41,no\n",
          "\xef\xbb\xbfінструмент;хв;відмова\n1;30,5;так\n2;41;ні\n\"a;\"\"b\";;-\n", "a\tb\tc\n1\t2\t3\n",
          "a;b\n1;2;\n\"x\ny\";3\n"};
}

}  // namespace

Target table_target() {
  return {"table", Form::bytes, eat, seeds};
}

}  // namespace verstat::fuzz
