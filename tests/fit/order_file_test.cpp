// Order lists beside a scenario.
#include "fit/order_file.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/input_error.h"

using namespace verstat;
using nlohmann::json;

namespace {
struct Folder {
  std::filesystem::path path;
  Folder() : path(std::filesystem::temp_directory_path() / ("verstat-orders-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }
};
const std::string scenario =
    R"({"parts": [{"name": "shaft", "supply": {"kind": "orders", "file": "orders.csv"}}, {"name": "x", "supply": {"kind": "always_available"}}]})";
}  // namespace

TEST_CASE("orders are read from a table beside the scenario", "[fit][orders]") {
  const Folder folder;
  SECTION("dates count from the Monday before the first; other parts' rows are theirs") {
    // 2026-03-03 is a Tuesday.
    folder.write(
        "orders.csv",
        "\xEF\xBB\xBF"
        "part;order date;quantity;due date\nshaft;03.03.2026 06:00;4;05.03.2026\nother;01.03.2026;9;\n"
        "shaft;04.03.2026 12:30;2;\n");
    const json orders =
        json::parse(fit::with_order_files(scenario, folder.path))["parts"][0]["supply"]["orders"];
    REQUIRE(orders.size() == 2);
    CHECK(orders[0] == json({{"arrives_min", 1440 + 360.0}, {"quantity", 4}, {"due_min", 3 * 1440.0}}));
    CHECK(orders[1] == json({{"arrives_min", 2 * 1440 + 750.0}, {"quantity", 2}}));
  }
  SECTION("minutes stay minutes, in order") {
    folder.write("orders.csv", "arrives (min),qty\n50,1\n10,3\n");
    const json orders =
        json::parse(fit::with_order_files(scenario, folder.path))["parts"][0]["supply"]["orders"];
    CHECK(orders[0]["arrives_min"] == 10);
    CHECK(orders[1]["arrives_min"] == 50);
  }
  SECTION("a row that cannot be read is an error with its line") {
    folder.write("orders.csv", "arrives (min),qty\n50,1\n10,0\n");
    CHECK_THROWS_WITH(fit::with_order_files(scenario, folder.path), Catch::Contains("/parts/0/supply/file") &&
                                                                        Catch::Contains("line 3") &&
                                                                        Catch::Contains("quantity 0"));
  }
  SECTION("a file that is not there") {
    CHECK_THROWS_AS(fit::with_order_files(scenario, folder.path), scenarios::InputError);
  }
}
