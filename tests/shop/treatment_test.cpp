// Treatments change what follows: lives and their scatter of treated lots of tools, and the state in which
// parts reach the next operation, the inspection and the store. Cards K103, K108, K115, K116, K208, K309,
// K310, K312, K402.
#include "models/grinding/k302_combined_grinding_roughness.h"
#include "models/math/normal.h"
#include "models/surface/k116_tool_steel_surface.h"
#include "models/treatment/k309_grain_trajectory.h"
#include "models/treatment/k312_blade_finishing.h"
#include "tests/shop/small_shop.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;

namespace {

json shown(const std::string& operation) {
  return scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + operation + ".json")
      .at("process");
}

operations::CutPlan plan_of(const scenarios::Scenario& s, const std::string& operation) {
  return scenarios::plan(s, *scenarios::find_named(s.operations, operation));
}

/// The cell with its inserts prepared by this process.
json cell_with(json preparation) {
  json cell = tool_cell();
  cell["inserts"][0]["preparation"] = std::move(preparation);
  return cell;
}

/// One machine treats, a second one inspects everything and errs nowhere; what falls short is scrap.
json treated_and_inspected(const json& process, const json& requirement) {
  json shop = small_shop(always(), constant(1));
  shop["operations"][0]["process"] = process;
  shop["machines"].push_back({{"name", "desk"}});
  shop["operations"].push_back({{"name", "look"},
                                {"machine", "desk"},
                                {"process", duration_process(constant(0.5))},
                                {"inspection", json::object()}});
  shop["parts"][0]["route"] = {"o", "look"};
  shop["parts"][0]["requirements"] = {requirement};
  shop["simulation"]["horizon_min"] = 60'000;
  return shop;
}

}  // namespace

TEST_CASE("a treated lot of tools: mean life and scatter in the shop are those of the card",
          "[treatment][long]") {
  struct Lot {
    const char* card;
    json process;
    double life_factor;
    double cv;
  };
  json inserts = shown("insert_preparation");
  inserts["screening"] = "none";
  inserts["treatment_s"] = 180;
  json bath = inserts;
  bath["treatment"] = "magnetic_abrasive";
  bath["life_factor"] = 1.6;
  bath["life_cv"] = 0.5;
  json drills = inserts;
  drills["treatment"] = "magnetic_abrasive_drills";
  drills["life_cv"] = 0.5;
  json steel = shown("tool_steel_finishing");
  steel["life_cv"] = 0.3;
  const double turned =
      models::k116::fatigue_life_cycles({models::k116::FatigueFinish::turning_geksanit_r_100, 800}).cycles;
  const double ground =
      models::k116::fatigue_life_cycles({models::k116::FatigueFinish::grinding_abrasive, 800}).cycles;
  json current = shown("pulse_current");
  current["life_factor"] = 1.8;
  current["life_cv"] = 0.4;
  const std::vector<Lot> lots{{"K402 islands", shown("coating"), 2.75, 0.5},
                              {"K208 drills in the ring bath", shown("drill_finishing"), 2, 0.5},
                              {"K103 drills, least factor", drills, 2, 0.5},
                              {"K108 inserts", bath, 1.6, 0.5},
                              {"K116 tools of tool steel", steel, turned / ground, 0.3},
                              {"K310 coated by current pulses", current, 1.8, 0.4}};
  for (const Lot& lot : lots) {
    INFO(lot.card);
    const json cell = cell_with(lot.process);
    const auto s = scenarios::load(cell);
    const auto life = scenarios::prepared(s.inserts[0]).edge_life;
    const bool drill = std::string(lot.card).find("drills") != std::string::npos;
    const double factor = drill ? life.mean_ref_min / cell_life_min : lot.life_factor;
    // K103 and K208: drills live 1.5 to 2.5 times as long, the least of it is what K103 promises.
    if (drill) CHECK((factor >= 1.5 && factor <= 2.6));
    CHECK(life.mean_ref_min == Approx(factor * cell_life_min));
    CHECK(life.cv == Approx(lot.cv));
    // Run to failure an edge is used for its life; changed at the 80 percent age, for the restricted mean,
    // which depends on the scatter. The factor of the tool steel is in the tens: shorter lives as delivered
    // keep the number of changes.
    const double scale = std::max(1.0, factor / 3);
    std::vector<std::string> longer;
    if (scale > 1) {
      longer.push_back("/inserts/0/edge_life/mean_ref_min=" + std::to_string(cell_life_min / scale));
    }
    const auto failing = run_with(cell, longer);
    check_meets(failing, "tool/tool/edge_use_min", factor * cell_life_min / scale, 0.02);
    auto by_age = longer;
    by_age.emplace_back(R"(/tools/0/strategy={"kind":"age","gamma":0.8})");
    const models::LifeLaw law(life.law, factor * cell_life_min / scale, life.cv);
    check_meets(run_with(cell, by_age), "tool/tool/edge_use_min",
                law.restricted_mean(law.gamma_percent_life(0.8)), 0.02);
  }
}

TEST_CASE("K115: the hyperboloid roller leaves a quarter of the profile error, and fewer rejects",
          "[treatment][K115][long]") {
  json rolling = shown("gear_rolling");
  rolling["conventional_profile_error_um"] = 12;
  rolling.erase("profile_error_max_um");
  rolling.erase("accuracy_grade_max");
  const json drawing = {{"quantity", "profile_error_um"}, {"at_most", 10}, {"sd", 4}};
  json conventional = rolling;
  conventional["roller"] = "conventional";
  const auto good = run(treated_and_inspected(rolling, drawing));
  const auto worse = run(treated_and_inspected(conventional, drawing));
  CHECK(mean(worse, "part/p/profile_error_um/mean") == Approx(12));
  CHECK(mean(good, "part/p/profile_error_um/mean") == Approx(3));
  check_truth(worse, "quality_ratio", models::normal_cdf((10.0 - 12) / 4), 0.05);
  check_truth(good, "quality_ratio", models::normal_cdf((10.0 - 3) / 4), 0.01);
  CHECK(mean(good, "part/p/profile_error_um/short_share") == Approx(models::normal_cdf(-7.0 / 4)));
}

TEST_CASE("K116: a ground surface hands its tempered zone on, a turned one hardly any",
          "[treatment][K116][long]") {
  json shop = small_shop(always(), constant(1));
  json steel = shown("tool_steel_finishing");
  steel.erase("fatigue_limit_min_mpa");
  shop["operations"][0]["process"] = steel;
  shop["machines"].push_back({{"name", "grinder"}});
  json grinding = shown("cylindrical_grinding");
  grinding.erase("defect_depth_max_um");
  shop["operations"].push_back(
      {{"name", "grind"},
       {"machine", "grinder"},
       {"process", grinding},
       {"incoming", {{{"from", "o"}, {"quantity", "tempered_depth_um"}, {"input", "initial_defect_um"}}}}});
  shop["parts"][0]["route"] = {"o", "grind"};
  shop["parts"][0]["requirements"] = {{{"quantity", "fatigue_limit_mpa"}, {"at_least", 600}},
                                      {{"quantity", "defect_depth_um"}, {"at_most", 20}}};
  const auto turned = scenarios::load(shop);
  shop["operations"][0]["process"]["finish"] = "grinding_abrasive";
  const auto ground = scenarios::load(shop);
  // The allowance takes 250 um off what the paper found: 12 um under boron nitride, 650 under an abrasive
  // wheel.
  const double own_um = *plan_of(turned, "grind").value_of("finish_defect_um");
  CHECK(*plan_of(turned, "grind").value_of("defect_depth_um") == Approx(own_um));
  const auto after_rough = models::k302::defect_depth_after_pass(
      {650, 210, *plan_of(ground, "grind").value_of("rough_defect_um")});
  CHECK(*plan_of(ground, "grind").value_of("defect_depth_um") ==
        Approx(models::k302::defect_depth_after_pass({after_rough.depth_um, 40, own_um}).depth_um));
  CHECK(*plan_of(ground, "grind").value_of("defect_depth_um") >= 650 - 250);

  // 770 MPa by turning at 100 m/min, 560 by grinding: only one meets the drawing.
  const auto r = run(shop);
  CHECK(mean(r, "part/p/fatigue_limit_mpa/mean") == Approx(560).margin(2));
  CHECK(mean(r, "part/p/fatigue_limit_mpa/short_share") == 1);
  CHECK(mean(r, "part/p/defect_depth_um/short_share") == 1);
  CHECK(mean(r, "part/p/escape_ratio") == 1);
  shop["operations"][0]["process"]["finish"] = "turning_boron_nitride";
  const auto t = run(shop);
  CHECK(mean(t, "part/p/fatigue_limit_mpa/mean") == Approx(770));
  CHECK(mean(t, "part/p/escape_ratio") == 0);
}

TEST_CASE("K309: magnetic-abrasive finishing starts from the roughness that grinding leaves",
          "[treatment][K309][long]") {
  json shop = small_shop(always(), constant(1));
  shop["operations"][0]["process"] = shown("cylindrical_grinding");
  shop["machines"].push_back({{"name", "bath"}});
  json finishing = shown("magnetic_abrasive");
  finishing.erase("ra_max_um");
  shop["operations"].push_back(
      {{"name", "finish"},
       {"machine", "bath"},
       {"process", finishing},
       {"incoming", {{{"from", "o"}, {"quantity", "roughness_ra_um"}, {"input", "ra_before_um"}}}}});
  shop["parts"][0]["route"] = {"o", "finish"};
  shop["parts"][0]["requirements"] = {{{"quantity", "ra_um"}, {"at_most", 0.1}}};
  for (const int sparkout : {0, 3, 10}) {
    INFO(sparkout);
    shop["operations"][0]["process"]["sparkout_passes"] = sparkout;
    const auto s = scenarios::load(shop);
    const double before_um = *plan_of(s, "o").value_of("roughness_ra_um");
    const auto p = plan_of(s, "finish");
    CHECK(*p.value_of("ra_before_um") == before_um);
    CHECK(*p.value_of("ra_um") ==
          Approx(models::k309::roughness_after_mao({p.main_time_min, before_um, 0.065, 0.8}).ra_um));
  }
  // Without it the paper's ground bearings are taken.
  json alone = shop;
  alone["operations"][1].erase("incoming");
  CHECK(*plan_of(scenarios::load(alone), "finish").value_of("ra_before_um") == 0.25);
  CHECK(mean(run(shop), "part/p/ra_um/mean") ==
        Approx(*plan_of(scenarios::load(shop), "finish").value_of("ra_um")));
}

TEST_CASE("K305: what thermo-friction machining leaves is the allowance of the grinding after it",
          "[treatment][K305][long]") {
  json shop = small_shop(always(), constant(1));
  json flat = shown("thermo_friction");
  flat.erase("next_allowance_mm");
  flat["hardened_layer"] = "kept";
  shop["operations"][0]["process"] = flat;
  shop["machines"].push_back({{"name", "grinder"}});
  shop["operations"].push_back({{"name", "grind"},
                                {"machine", "grinder"},
                                {"process", shown("elastic_grinding")},
                                {"incoming",
                                 {{{"from", "o"},
                                   {"quantity", "following_allowance_mm"},
                                   {"input", "allowance_um"},
                                   {"factor", 1000}}}}});
  shop["parts"][0]["route"] = {"o", "grind"};
  const auto s = scenarios::load(shop);
  const double allowance_um = 1000 * *plan_of(s, "o").value_of("following_allowance_mm");
  json by_hand = shop;
  by_hand["operations"][1].erase("incoming");
  by_hand["operations"][1]["process"]["allowance_um"] = allowance_um;
  CHECK(plan_of(s, "grind").main_time_min == plan_of(scenarios::load(by_hand), "grind").main_time_min);
  shop["operations"][0]["process"]["roughness_rz_um"] = 20;  // a smoother surface leaves less to grind
  CHECK(plan_of(scenarios::load(shop), "grind").main_time_min < plan_of(s, "grind").main_time_min);
}

TEST_CASE("K312: finishing decides how many blades fall short of the endurance limit",
          "[treatment][K312][long]") {
  const json drawing = {{"quantity", "endurance_limit_mpa"}, {"at_least", 520}};
  for (const char* variant : {"P", "P+UH1", "P+UH2", "P+UH3"}) {
    INFO(variant);
    json finishing = shown("blade_finishing");
    finishing["variant"] = variant;
    finishing["polishing_min"] = 1;
    finishing["handling_min"] = 0;
    finishing["batch_size"] = 100;
    finishing.erase("failure_probability_max");
    const auto state = [&] {
      using models::k312::Finish;
      const std::string v = variant;
      return models::k312::finish_state({v == "P"       ? Finish::polishing
                                         : v == "P+UH1" ? Finish::soft
                                         : v == "P+UH2" ? Finish::medium
                                                        : Finish::hard});
    }();
    const double falls_short =
        models::k312::fatigue_failure_probability({520, 0, *state.sigma_1_mpa, *state.sigma_1_sd_mpa}).p;
    const auto r = run(treated_and_inspected(finishing, drawing));
    CHECK(mean(r, "part/p/endurance_limit_mpa/mean") == Approx(*state.sigma_1_mpa));
    CHECK(mean(r, "part/p/endurance_limit_mpa/short_share") == Approx(falls_short));
    check_truth(r, "quality_ratio", 1 - falls_short, 0.2);
    CHECK(mean(r, "part/p/escape_ratio") == 0);  // the inspection finds them all
  }
}

TEST_CASE("a drawing that is not met is found where it is decided, and rework makes the part anew",
          "[treatment][long]") {
  // Two operations leave the roughness; only the last one counts.
  json shop = small_shop(always(), constant(1));
  json first = shown("magnetic_abrasive");
  first.erase("ra_max_um");
  first["passes"] = 1;
  json second = first;
  second["passes"] = 20;
  shop["operations"][0]["process"] = first;
  shop["machines"].push_back({{"name", "m2"}});
  shop["operations"].push_back({{"name", "second"}, {"machine", "m2"}, {"process", second}});
  shop["machines"].push_back({{"name", "desk"}});
  shop["operations"].push_back({{"name", "look"},
                                {"machine", "desk"},
                                {"process", duration_process(constant(0.01))},
                                {"inspection", json::object()}});
  shop["parts"][0]["route"] = {"o", "second", "look"};
  const double ra_um = *plan_of(scenarios::load(shop), "second").value_of("ra_um");
  shop["parts"][0]["requirements"] = {
      {{"quantity", "ra_um"}, {"at_most", ra_um}, {"sd", 0.01}}};  // half of the parts
  const auto r = run(shop);
  CHECK(mean(r, "part/p/ra_um/mean") == Approx(ra_um));
  check_truth(r, "quality_ratio", 0.5, 0.1);
  check_audit(shop);
  shop["parts"][0].erase("route");
  shop["parts"][0]["steps"] = {{{"name", "a"}, {"operation", "o"}},
                               {{"name", "b"}, {"operation", "second"}},
                               {{"name", "c"}, {"operation", "look"}, {"rework", "b"}, {"rework_limit", 1}}};
  shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 4}};
  check_truth(run(shop), "quality_ratio", 0.75, 0.1);
}
