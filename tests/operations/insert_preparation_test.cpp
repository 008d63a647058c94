#include "operations/kinds/insert_preparation.h"

#include "models/inspection/k119_cutter_certification.h"
#include "models/inspection/k121_thermo_emf.h"
#include "models/reliability/k117_rational_reliability.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using operations::InsertPreparation;
using operations::InsertScreening;
using operations::InsertTreatment;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("insert preparation: sorting and rounding change the life law and the cost") {
  GalleryExample<InsertPreparation> e;
  const auto both = e.plan();
  CHECK(both.scrap_probability == Approx(0.2));
  CHECK(value_of(both, "mean_life_after_min") > 2.67 * value_of(both, "mean_life_before_min"));
  CHECK(value_of(both, "breakage_fraction_after") < 0.31);
  CHECK(value_of(both, "cost_rate_after_per_min") < value_of(both, "cost_rate_before_per_min"));
  // Treatment alone: the printed lot, 18.7 to 49.8 min, 0.86 to 0.31 broken.
  e.spec.screening = InsertScreening::none;
  const auto rounded = e.plan();
  CHECK(rounded.scrap_probability == 0);
  CHECK(value_of(rounded, "mean_life_after_min") == Approx(49.8).epsilon(0.005));
  CHECK(value_of(rounded, "breakage_fraction_after") == Approx(0.31).epsilon(0.001));
  // TiN alone makes this grade worse.
  e.spec.treatment = InsertTreatment::tin_coating;
  CHECK(value_of(e.plan(), "saving_fraction") < value_of(rounded, "saving_fraction"));
  CHECK(value_of(e.plan(), "mean_life_after_min") < 18.7);
}

TEST_CASE("insert preparation: sorting alone is the published decision") {
  GalleryExample<InsertPreparation> e;
  e.spec.treatment = InsertTreatment::none;
  const auto law = models::k119::weibull_from_mean_cv({.mean_life_min = 18.7, .life_cv = 0.5});
  models::k119::InspectionIn in;
  in.insert_cost = 80;
  in.edges_per_insert = 4;
  in.edges_used_by_test = 1;
  in.test_cost = 4;
  in.salvage_value = 10;
  in.change_cost = 8;
  in.breakage_cost = 60;
  in.shape = law.shape;
  in.scale_min = law.scale_min;
  in.breakage_fraction = 0.86;
  in.rho_life = 0.67;
  in.rho_break = 0.79;
  test::property([&] {
    in.reject_fraction = e.spec.reject_fraction = *rc::gen::inRange(1, 90) / 100.0;
    const auto expected = models::k119::inspection_decision(in);
    const auto p = e.plan();
    const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    RC_ASSERT(near(value_of(p, "cost_rate_before_per_min"), expected.cost_rate_without));
    RC_ASSERT(near(value_of(p, "cost_rate_after_per_min"), expected.cost_rate_with));
    RC_ASSERT(near(value_of(p, "breakage_fraction_after"), expected.breakage_fraction_accepted));
  });
  e.spec.edges_used_by_test = 4;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("edges_used_by_test"));
}

TEST_CASE("insert preparation: magnetic pulses turn Weibull lives into normal ones") {
  GalleryExample<InsertPreparation> e("insert_preparation_pulse");
  const auto life = operations::prepared_life(e.spec);
  CHECK(life.law == models::LifeLawKind::normal);
  CHECK(life.cv == 0.4);
  CHECK(life.mean_min == 60);
  const auto p = e.plan();
  const auto effect = models::k117::pulse_treatment_effect({.gamma = 0.8});
  CHECK(value_of(p, "gamma_life_before_min") == Approx(effect.gamma_life_before_min));
  CHECK(value_of(p, "gamma_life_after_min") == Approx(effect.gamma_life_after_min));
  CHECK(value_of(p, "gamma_life_after_min") / value_of(p, "gamma_life_before_min") ==
        Approx(1.691).margin(0.0006));
}

TEST_CASE("insert preparation: thermo-EMF") {
  GalleryExample<InsertPreparation> e("insert_preparation_emf");
  const auto p = e.plan();
  CHECK(p.scrap_probability == Approx(1 - 0.8413447).epsilon(1e-5));  // one standard deviation
  CHECK(value_of(p, "mean_life_after_min") > 30);
  CHECK(value_of(p, "life_cv_after") < 0.6);
  e.spec.emf_limit_mv = 5;
  CHECK(value_of(e.plan(), "mean_life_after_min") > value_of(p, "mean_life_after_min"));
  CHECK(e.plan().scrap_probability == Approx(0.5));
  e.spec.emf_limit_mv = 11.9;  // rejects nothing
  CHECK(value_of(e.plan(), "mean_life_after_min") == 30);
  e.spec.emf_sd_mv = 1;  // ln life would scatter by 0.93, more than a cv of 0.6 holds
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("emf_sd_mv"));
}

TEST_CASE("insert preparation: magnetic-abrasive baths") {
  GalleryExample<InsertPreparation> e("insert_preparation_pulse");
  e.spec.treatment = InsertTreatment::magnetic_abrasive_drills;
  e.spec.treatment_s = 180;
  const auto drills = e.plan();
  CHECK(value_of(drills, "mean_life_after_min") == Approx(1.8 * 60));
  CHECK(value_of(drills, "life_cv_after") == 0.7);
  CHECK(value_of(drills, "edge_radius_um") == Approx(17.5));
  CHECK(value_of(drills, "ra_um") == Approx(0.12));
  CHECK(drills.main_time_min == Approx((180 + 60) / 60.0 / 20));
  e.spec.treatment = InsertTreatment::magnetic_abrasive;
  e.spec.treatment_s = 480;
  e.spec.edge_radius_max_um = 30;
  const auto inserts = e.plan();
  CHECK(value_of(inserts, "edge_radius_um") == Approx(5 + 0.05 * 480));
  CHECK(limit_of(inserts, "edge_radius_um").margin() > 0);
  CHECK(value_of(inserts, "ra_um") == Approx(0.065).margin(0.003));
  CHECK(value_of(inserts, "hardness_factor") == Approx(1.135).margin(1e-4));
  e.spec.edge_radius_max_um = 20;
  CHECK(limit_of(e.plan(), "edge_radius_um").margin() < 0);
  e.spec.treatment_s = 600;  // beyond the published time
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("480"));
}
