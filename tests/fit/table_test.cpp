// Tables as shops write them: what is decided is said, what is left out is named, what is doubtful is
// refused.
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <unistd.h>

#include "fit/arrival_log.h"
#include "fit/columns.h"
#include "fit/cycle_log.h"
#include "fit/downtime_log.h"
#include "fit/removal_log.h"
#include "fit/wear_curves.h"
#include "fit/workbook.h"
#include "scenarios/json_text.h"
#include "tests/property.h"

using namespace verstat::fit;
using Catch::Contains;
using verstat::scenarios::InputError;

namespace {

// A file that lives as long as the test case.
class File {
 public:
  explicit File(const std::string& text) {
    static int number = 0;
    path_ = (std::filesystem::temp_directory_path() /
             ("verstat-fit-" + std::to_string(::getpid()) + "-" + std::to_string(++number) + ".csv"))
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

std::string why(const std::string& text, const RemovalOptions& options = {}) {
  const File file(text);
  try {
    static_cast<void>(read_removals(file.path(), options));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a Ukrainian removal log with every usual flaw", "[fit]") {
  const File file(
      "\xEF\xBB\xBF\r\n"
      "№;Інструмент;Партія;Стійкість, хв;Причина\r\n"
      "1;Т5К10;А;31,5;Знос\r\n"
      "2;Т5К10;А;45,0;за планом\r\n"
      "3;Т5К10;Б;немає даних;знос\r\n"
      "4;Т5К10;Б;12,25;Викришування\r\n"
      "2;Т5К10;А;45,0;за планом\r\n"
      ";;;;\r\n"
      "5;Т5К10;Б;сорок;знос\r\n"
      "6;Т5К10;Б;20,0;загубили\r\n"
      "7;Т5К10;Б;20,0\r\n"
      "8;Т5К10;Б;-3,0;знос\r\n"
      "9;Т5К10;;3,0;знос\r\n"
      "№;Інструмент;Партія;Стійкість, хв;Причина\r\n");
  const RemovalLog log = read_removals(file.path(), {});
  CHECK(log.rows_used == 3);
  CHECK(log.table.rows_in_file == 11);
  REQUIRE(log.groups.size() == 1);
  const auto& lives = log.groups[0].lives;
  REQUIRE(lives.size() == 3);
  CHECK(lives[0].exact());
  CHECK(lives[0].low == 31.5);
  CHECK(lives[0].line == 3);
  CHECK_FALSE(lives[1].failed());
  CHECK(lives[2].low == 12.25);
  CHECK(log.causes == std::vector<std::string>{"worn", "chipped"});
  CHECK(log.batches == std::vector<std::string>{"А", "Б"});
  // Used and dropped rows are all rows.
  CHECK(log.rows_used + log.table.dropped.size() == log.table.rows_in_file);
  const auto reason = [&](std::size_t line) -> std::string {
    for (const DroppedRow& row : log.table.dropped)
      if (row.line == line) return row.reason;
    return "";
  };
  CHECK_THAT(reason(5), Contains("немає даних"));
  CHECK(reason(7) == "repeats line 4");
  CHECK_THAT(reason(9), Contains("\"сорок\", not a number"));
  CHECK_THAT(reason(10), Contains("cause \"загубили\" is not known"));
  CHECK_THAT(reason(11), Contains("has 4 cells, the header has 5"));
  CHECK_THAT(reason(12), Contains("-3 is not above 0"));
  CHECK_THAT(reason(13), Contains("\"Партія\" is empty"));
  CHECK(reason(14) == "repeats the header");
  std::string notes;
  for (const std::string& note : log.table.notes) notes += note + "\n";
  CHECK_THAT(notes, Contains("byte-order mark") && Contains("semicolon") && Contains("decimal comma in"));
}

TEST_CASE("Windows-1251 is read and said, and refused when UTF-8 was promised", "[fit]") {
  // "Час, хв;Причина" and "знос" in Windows-1251.
  const std::string text =
      "\xD7\xE0\xF1, \xF5\xE2;\xCF\xF0\xE8\xF7\xE8\xED\xE0\n31,5;\xE7\xED\xEE\xF1\n7,5;\xC7\xCD\xCE\xD1\n";
  const File file(text);
  const RemovalLog log = read_removals(file.path(), {});
  CHECK(log.rows_used == 2);
  CHECK_THAT(log.table.notes.front(), Contains("Windows-1251"));
  RemovalOptions strict;
  strict.table.encoding = "utf-8";
  CHECK_THAT(why(text, strict), Contains("byte 1 is not UTF-8"));
}

TEST_CASE("doubtful input is refused with the flag that settles it", "[fit]") {
  CHECK_THAT(why("Minutes;Cause\n12,5;worn\n13.5;worn\n"), Contains("--decimal"));
  CHECK_THAT(why("Minutes;Cause\n1,234;worn\n"), Contains("decimal or a thousands sign"));
  CHECK(why("Minutes;Cause\n1,234;worn\n3,5;worn\n").empty());  // the other cell settles it
  CHECK_THAT(why("Minutes;Life;Cause\n12;13;worn\n"), Contains("--column life=HEADER"));
  CHECK_THAT(why("Span;Cause\n12;worn\n"), Contains("no column for the life"));
  CHECK_THAT(why("Minutes\n12\n"), Contains("no column for the cause"));
  CHECK_THAT(why("Life (furlongs);Cause\n12;worn\n"), Contains("the unit \"furlongs\""));
  CHECK_THAT(why("Minutes;Cause\n12;\"worn\n"), Contains("line 2") && Contains("never closed"));
  CHECK_THAT(why(""), Contains("is empty"));
  CHECK_THAT(why("\"\",\n1,2\n"), Contains("no column for"));
  CHECK_THAT(why(",,\n"), Contains("has no header"));
  CHECK_THAT(why("PK\x03\x04 and so on"), Contains("xlsx2csv"));
  CHECK_THAT(why(std::string("\xFF\xFEM\0", 4)), Contains("UTF-16"));
  CHECK_THAT(why("Minutes;Cause\nno data;worn\n"), Contains("no row of 1 can be used") && Contains("line 2"));
  RemovalOptions unknown;
  unknown.columns = {{"lief", "Minutes"}};
  CHECK_THAT(why("Minutes;Cause\n12;worn\n", unknown), Contains("there is no role \"lief\""));
  RemovalOptions decided;
  decided.table.decimal = "comma";
  const File file("Minutes;Cause\n12,5;worn\n13.5;worn\n");
  const RemovalLog log = read_removals(file.path(), decided);
  CHECK(log.rows_used == 1);
  CHECK(log.table.dropped.front().line == 3);
}

TEST_CASE("rows written twice: dropped where rows can be told apart, kept with a note where not", "[fit]") {
  const File with("Edge,Minutes,Cause\n1,20,worn\n1,20,worn\n2,20,worn\n");
  CHECK(read_removals(with.path(), {}).rows_used == 2);
  const File without("Minutes,Cause\n45,planned\n45,planned\n31,worn\n");
  const RemovalLog kept = read_removals(without.path(), {});
  CHECK(kept.rows_used == 3);
  CHECK_THAT(kept.table.notes.back(), Contains("equal an earlier one"));
  RemovalOptions drop;
  drop.table.duplicates = Duplicates::drop;
  CHECK(read_removals(without.path(), drop).rows_used == 2);
}

TEST_CASE("units, parts and inspections", "[fit]") {
  const File hours("Life (h),Cause\n0.5,worn\n");
  CHECK(read_removals(hours.path(), {}).groups[0].lives[0].low == 30);
  const File seconds("life_s,cause\n90,worn\n");
  CHECK(read_removals(seconds.path(), {}).groups[0].lives[0].low == 1.5);
  const File parts("Parts,Cause\n31,worn\n40,planned\n2.5,worn\n");
  const RemovalLog log = read_removals(parts.path(), {});
  CHECK(log.unit == "parts");
  CHECK(log.groups[0].lives[0].low == 30);
  CHECK(log.groups[0].lives[0].high == 31);
  CHECK(log.groups[0].lives[1].low == 40);
  CHECK_FALSE(log.groups[0].lives[1].failed());
  CHECK(log.table.dropped.size() == 1);
  const File inspected("Minutes,Last good,Cause\n30,20,worn\n25,,worn\n25,28,worn\n");
  const RemovalLog inspections = read_removals(inspected.path(), {});
  CHECK(inspections.groups[0].lives[0].low == 20);
  CHECK(inspections.groups[0].lives[0].high == 30);
  CHECK(inspections.groups[0].lives[1].exact());
  CHECK_THAT(inspections.table.dropped.front().reason, Contains("wrong way round"));
}

TEST_CASE("numbers and moments", "[fit]") {
  CHECK(parse_number("1 234,5", ',') == 1234.5);
  CHECK(parse_number("1\xC2\xA0"
                     "234.5",
                     '.') == 1234.5);
  CHECK(parse_number("+7", '.') == 7);
  CHECK(parse_number("1e3", '.') == 1000);
  for (const char* bad : {"", "nan", "inf", "1.2.3", "12 min", "0x10", "1e999", "--3"})
    CHECK_FALSE(parse_number(bad, '.'));
  CHECK(parse_moment("1970-01-02") == 1440);
  CHECK(*parse_moment("2026-03-01 14:05") - *parse_moment("28.02.2026 14:05:30") ==
        Approx(1439.5).epsilon(1e-12));
  CHECK(parse_moment("2024-02-29T07:00Z") == parse_moment("29.02.2024 7:00"));
  for (const char* bad :
       {"2026-02-29", "01/02/2026", "2026-13-01", "2026-03-01 25:00", "2026-03-01 7", "soon", "2026-03-01x"})
    CHECK_FALSE(parse_moment(bad));
}

TEST_CASE("any bytes are read or refused, never worse", "[fit]") {
  verstat::test::property([] {
    const auto bytes =
        *rc::gen::container<std::string>(rc::gen::elementOf(std::string("a,;\t\"\n\r1.5-\xD0\xB7\xFF\xE2 ")));
    try {
      const Table table = parse_table("any", bytes, {});
      RC_ASSERT(table.rows.size() + table.dropped.size() == table.rows_in_file);
      for (const Row& row : table.rows) RC_ASSERT(row.cells.size() == table.columns.size());
    } catch (const InputError&) {
      RC_TAG("refused");
    }
  });
}

TEST_CASE("Ukrainian and Russian headers of every table are known without --column", "[fit]") {
  for (const std::string text :
       {"№ кромки;Інструмент;Режим;Партія;Час різання, хв;Остання перевірка, хв;Причина заміни\n"
        "1;Т15К6;чорновий;А;31,5;20,0;знос\n2;Т15К6;чорновий;Б;45,0;;за графіком\n",
        "Режущая кромка;Инструмент;Режим;Партия;Время резания, мин;Последний осмотр, мин;Причина снятия\n"
        "1;Т15К6;черновой;А;31,5;20,0;износ\n2;Т15К6;черновой;Б;45,0;;по графику\n"}) {
    INFO(text);
    const File file(text);
    const RemovalLog log = read_removals(file.path(), {});
    REQUIRE(log.groups.size() == 1);
    CHECK(log.rows_used == 2);
    CHECK(log.groups[0].tool == "Т15К6");
    CHECK_FALSE(log.groups[0].regime.empty());
    const auto& lives = log.groups[0].lives;
    REQUIRE(lives.size() == 2);
    CHECK(lives[0].low == 20);
    CHECK(lives[0].high == 31.5);
    CHECK_FALSE(lives[1].failed());
    CHECK(log.batches.size() == 2);
    REQUIRE(log.causes.size() == 1);
    CHECK(log.causes[0] == "worn");
  }
  for (const std::string text : {"Дослід;Матеріал;Інструмент;Швидкість різання, м/хв;Подача, мм/об;Глибина "
                                 "різання, мм;Час, хв;Знос VB, мм\n"
                                 "1;40Х;Т15К6;150;0,2;1;5;0,12\n1;40Х;Т15К6;150;0,2;1;20;0,35\n",
                                 "Опыт;Материал;Инструмент;Скорость резания, м/мин;Подача, мм/об;Глубина "
                                 "резания, мм;Время, мин;Износ VB, "
                                 "мм\n1;40Х;Т15К6;150;0,2;1;5;0,12\n1;40Х;Т15К6;150;0,2;1;20;0,35\n"}) {
    INFO(text);
    const File file(text);
    const WearData wear = read_wear(file.path(), {});
    REQUIRE(wear.groups.size() == 1);
    CHECK(wear.groups[0].material == "40Х");
    REQUIRE(wear.groups[0].runs.size() == 1);
    CHECK(wear.groups[0].runs[0].cutting_speed_m_min == 150);
    CHECK(wear.groups[0].runs[0].depth_of_cut_mm == 1);
  }
  for (const std::string text :
       {"№;Верстат;Причина;Початок простою;Кінець простою;Напрацювання, год;Час різання, год\n"
        "1;1К62;патрон;02.03.2026 7:15;02.03.2026 8:05;10;4\n2;1К62;патрон;04.03.2026 7:15;04.03.2026 "
        "8:05;30;9\n",
        "№;Станок;Вид отказа;Начало простоя;Конец простоя;Наработка, ч;Время резания, ч\n"
        "1;1К62;патрон;02.03.2026 7:15;02.03.2026 8:05;10;4\n2;1К62;патрон;04.03.2026 7:15;04.03.2026 "
        "8:05;30;9\n"}) {
    INFO(text);
    const File file(text);
    const DowntimeLog log = read_downtime(file.path(), {});
    CHECK(log.machines.size() == 1);
    REQUIRE(log.repairs.size() == 1);
    CHECK(log.repairs[0].mode == "патрон");
    CHECK(log.repairs[0].repairs[0].low == 50);
    CHECK(log.times.size() == 3);  // calendar, operating, cutting
  }
  for (const std::string text : {"Замовлення;Дата замовлення;Деталь;Кількість\n1;02.03.2026 7:15;вал;3\n"
                                 "2;02.03.2026 9:15;вал;1\n3;03.03.2026 7:15;вал;2\n",
                                 "Заказ;Дата заказа;Деталь;Количество\n1;02.03.2026 7:15;вал;3\n"
                                 "2;02.03.2026 9:15;вал;1\n3;03.03.2026 7:15;вал;2\n"}) {
    INFO(text);
    const File file(text);
    ArrivalOptions options;
    options.part = "вал";
    const ArrivalLog log = read_arrivals(file.path(), options, 0.95);
    CHECK(log.rows_used == 3);
    CHECK(log.quantities[0] == 3);
  }
  for (const std::string text : {"Операція;Час циклу, хв\nточіння;2,5\nточіння;2,6\n",
                                 "Операция;Время цикла, мин\nточение;2,5\nточение;2,6\n"}) {
    INFO(text);
    const File file(text);
    const CycleLog log = read_cycles(file.path(), {});
    REQUIRE(log.groups.size() == 1);
    CHECK(log.groups[0].times[1].low == 2.6);
  }
}

TEST_CASE("a workbook that only calls itself so, and a sheet of a table, are refused", "[fit]") {
  CHECK(is_workbook_name("a.xlsx"));
  CHECK(is_workbook_name("DIR/Зняття.XLSX"));
  CHECK_FALSE(is_workbook_name("xlsx"));
  CHECK_FALSE(is_workbook_name("a.xlsx.csv"));
  RemovalOptions options;
  options.table.sheet = "Зняття";
  CHECK_THAT(why("Minutes,Cause\n3,worn\n", options), Contains("--sheet Зняття"));
}
