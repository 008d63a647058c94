// Shops that run and should not: every source of machine dynamics is seen when a regime lies inside its band
// or beyond its bound (K201, K206, K209, K210, K408), and so is a drawing that is not met.
#include "scenarios/warnings.h"

#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "operations/spindle.h"
#include "scenarios/json_text.h"
#include "scenarios/load.h"

using namespace verstat;
using Catch::Contains;
using nlohmann::json;

namespace {

/// A shop of one machine that does the operation of this gallery file, with its limits and its spindle.
json shop_of(const std::string& operation) {
  const json shown =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + operation + ".json");
  json machine = {{"name", "m"}};
  if (shown.contains("machine_limits")) machine["limits"] = shown["machine_limits"];
  if (shown.contains("spindle")) machine["spindle"] = shown["spindle"];
  return {{"name", "shop"},
          {"machines", {machine}},
          {"operations", {{{"name", "o"}, {"machine", "m"}, {"process", shown.at("process")}}}},
          {"stores", {{{"name", "s"}}}},
          {"parts", {{{"name", "p"}, {"route", {"o"}}, {"store", "s"}}}}};
}

std::vector<scenarios::Warning> warned(const json& shop) {
  return scenarios::warnings(scenarios::load(shop));
}

const scenarios::Warning& only(const std::vector<scenarios::Warning>& all, const std::string& limit) {
  for (const auto& w : all)
    if (w.limit == limit) return w;
  std::string there;
  for (const auto& w : all) there += w.text + "; ";
  FAIL("no warning about " << limit << ": " << there);
  throw std::logic_error("not reached");
}

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST_CASE("K201: a turning speed inside a parametric band is warned of, with the band") {
  json shop = shop_of("hard_turning_machine");
  shop["operations"][0]["process"]["feed_mm_rev"] = 0.2;  // outside the band of K107
  CHECK(warned(shop).empty());
  const auto s = scenarios::load(shop);
  const auto band = s.machines[0].spindle->dynamics().parametric.front();
  const double rpm = (band.low_rpm + band.high_rpm) / 2;
  shop["operations"][0]["process"]["cutting_speed_m_min"] = pi * 40 * rpm / 1000;
  const auto all = warned(shop);
  const auto& w = only(all, "spindle_speed_rpm");
  CHECK(w.pointer == "/operations/0/process");
  CHECK(w.operation == "o");
  CHECK(w.machine == "m");
  CHECK((w.low < w.value && w.value < w.high));
  CHECK_THAT(w.text, Contains("operation \"o\" on \"m\"") && Contains("forbidden band") && Contains("K201"));
}

TEST_CASE("K206: teeth that meet the base, and a width that chatters") {
  json shop = shop_of("face_milling_machine");
  shop["machines"][0]["limits"].erase("safety_clutch");
  CHECK(warned(shop).empty());
  const auto s = scenarios::load(shop);
  const double hz = s.machines[0].spindle->dynamics().natural_hz[0];
  json resonant = shop;
  resonant["operations"][0]["process"]["cutting_speed_m_min"] = pi * 0.125 * hz * 60 / 10;
  CHECK_THAT(only(warned(resonant), "spindle_speed_rpm").text, Contains("K206"));
  json deep = shop;
  deep["operations"][0]["process"]["depth_of_cut_mm"] = 9;
  const auto all = warned(deep);
  const auto& w = only(all, "width_of_cut_mm");
  CHECK(w.value == 9);
  CHECK_THAT(w.text, Contains("must be at most") && Contains("K206"));
}

TEST_CASE("K209, K210: waviness of the wheel, film and form error of a hydrostatic spindle") {
  json shop = shop_of("elastic_grinding_machine");
  CHECK(warned(shop).empty());
  json wavy = shop;
  wavy["machines"][0]["spindle"]["wheel"]["waviness_max_um"] = 1e-4;
  CHECK_THAT(only(warned(wavy), "waviness_um").text, Contains("K209"));
  json heavy = shop;
  heavy["machines"][0]["spindle"]["machine_error_max_um"] = 1e-4;
  const auto all = warned(heavy);
  CHECK_THAT(only(all, "spindle_form_error_um").text, Contains("must be at most"));
  json thin = shop;
  thin["machines"][0]["spindle"]["hydrostatic"]["film_min_um"] = 1000;
  bool film = false;
  for (const auto& w : warned(thin))
    film = film || (w.limit.find("film") != std::string::npos && w.text.find("K210") != std::string::npos);
  CHECK(film);
}

TEST_CASE("K408: a reamer whose teeth meet the natural frequency of the tool in its holder") {
  json shop = shop_of("reaming");
  CHECK(warned(shop).empty());
  // Raise the speed until its limit is passed; the warning names it.
  json& speed = shop["operations"][0]["process"]["cutting_speed_m_min"];
  std::vector<scenarios::Warning> all;
  for (double v = 5; v < 120 && all.empty(); v *= 1.1) {
    speed = v;
    all = warned(shop);
  }
  REQUIRE_FALSE(all.empty());
  CHECK_THAT(all.front().text, Contains("K408"));
  // A rigid holder makes the tool stiffer: the same speed is allowed.
  shop["machines"][0]["spindle"]["holder"] = "rigid";
  CHECK(warned(shop).empty());
}

TEST_CASE("every machine group is planned for itself, and a drawing that is not met is warned of") {
  json shop = shop_of("turning");
  shop["machines"][0]["limits"]["power_kw"] = 100;
  json weak = shop["machines"][0];
  weak["name"] = "weak";
  weak["limits"]["power_kw"] = 0.1;
  shop["machines"].push_back(weak);
  shop["operations"][0].erase("machine");
  shop["operations"][0]["machines"] = {"m", "weak"};
  shop["parts"][0]["requirements"] = {{{"quantity", "roughness_ra_um"}, {"at_most", 0.01}}};
  const auto all = warned(shop);
  const auto& power = only(all, "power_kw");
  CHECK(power.machine == "weak");
  CHECK(power.low == 0.1);
  const auto& drawing = only(all, "roughness_ra_um");
  CHECK(drawing.pointer == "/parts/0/requirements/0");
  CHECK_THAT(drawing.text, Contains("the drawing asks for at most 0.01"));
  const json list = json::parse(scenarios::to_json(all).dump());
  CHECK(list.size() == all.size());
  CHECK(list[0].at("limit") == all[0].limit);
}

TEST_CASE("shops of the gallery keep their limits, but for two that show what it is to break one") {
  std::vector<std::string> breaking;
  for (const auto& file : std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery")) {
    const std::string name = file.path().filename().string();
    if (!name.ends_with(".json") || name.ends_with(".study.json")) continue;
    for (const auto& w : warned(scenarios::read_json_file(file.path().string())))
      breaking.push_back(name + " " + w.limit);
  }
  std::sort(breaking.begin(), breaking.end());
  CHECK(breaking == std::vector<std::string>{"bearing-rings.json feed_mm_rev",
                                             "drilling-line.json breakage_probability"});
}
