// The checks of card K103; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k103_magneto_abrasive_drills.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k103;

TEST_CASE("K103: hardness and test speed of the text", "[K103]") {
  const auto hardness = [](double before) {
    return mat_treatment_effect({Powder::polimam_t_plus_10_pr_r6m5, before}).hardness_after_min_gpa;
  };
  CHECK(hardness(9.1) == Approx(10.2).margin(0.05));
  CHECK(hardness(9.3) == Approx(10.4).margin(0.05));
  CHECK(constant_thrust_test({100, 100}).cutting_speed_m_min == Approx(18.8).margin(0.05));
  CHECK(constant_thrust_test({100, 100}).relative_performance == 1);
}

TEST_CASE("K103: the kinetics meet both printed states", "[K103]") {
  CHECK(mat_surface_kinetics({180}).ra_um == Approx(0.12).epsilon(1e-14));
  CHECK(mat_surface_kinetics({180}).edge_radius_um == 17.5);
  CHECK(mat_surface_kinetics({0}).ra_um == 0.435);
  CHECK(mat_surface_kinetics({0}).edge_radius_um == 8.5);
  CHECK(mat_surface_kinetics({300}).ra_um == mat_surface_kinetics({180}).ra_um);
  CHECK(mat_surface_kinetics({230}).edge_radius_um == Approx(20));
  CHECK(mat_time_for_edge_radius({15}).time_s == Approx(130));
  CHECK(mat_time_for_edge_radius({mat_surface_kinetics({300}).edge_radius_um}).time_s == Approx(300));
  CHECK(mat_time_for_edge_radius({8, 8.5, 7}).time_s ==
        0);  // already reached, though the edge would not grow
}

TEST_CASE("K103: edge radius rises and roughness falls with time, and the time is the inverse", "[K103]") {
  verstat::test::property([] {
    const double before = *rc::gen::inRange(10, 200) * 0.1;
    const double after = before + *rc::gen::inRange(1, 200) * 0.1;
    const double t = *rc::gen::inRange(1, 300);
    const auto course = [&](double time_s) {
      return mat_surface_kinetics({time_s, 0.435, 0.12, before, after});
    };
    RC_ASSERT(course(t).edge_radius_um > course(t - 1).edge_radius_um);
    const double fall_um = course(t - 1).ra_um - course(t).ra_um;
    RC_ASSERT(fall_um >= 0);
    RC_ASSERT((fall_um > 0) == (t <= 180));
    RC_ASSERT(mat_time_for_edge_radius({course(t).edge_radius_um, before, after}).time_s ==
              Approx(t).epsilon(1e-10));
  });
}

TEST_CASE("K103: a life factor of 1 changes nothing and is worth nothing", "[K103]") {
  const auto same = mat_weibull_life({30, 2, 1});
  CHECK(same.scale_min == 30);
  CHECK(same.shape == 2);
  CHECK(same.mean_min == Approx(30 * std::sqrt(std::acos(-1.0)) / 2));  // Gamma(1.5)
  CHECK(mat_break_even_cost({10, 1}).max_treatment_cost == 0);
  // At the break-even cost the cost per unit of life is the same.
  const double c = mat_break_even_cost({12, 1.7}).max_treatment_cost;
  CHECK((12 + c) / (1.7 * 30) == Approx(12.0 / 30));
  CHECK(mat_weibull_life({20, 1, 1.8}).mean_min == Approx(36));
}

TEST_CASE("K103: a batch shares its cycle", "[K103]") {
  CHECK(mat_batch_time({1}).time_min == Approx(4));
  CHECK(mat_batch_time({12, 360, 60}).time_min == Approx(7.0 / 12));
}

TEST_CASE("K103: the qualitative table of the charges", "[K103]") {
  const auto rounds = [](Powder p) { return mat_powder_class({p}).rounds_edge; };
  CHECK(rounds(Powder::polimam_m) == RoundsEdge::no);
  CHECK(rounds(Powder::pr_r6m5) == RoundsEdge::no);
  CHECK(rounds(Powder::tsaramam) == RoundsEdge::unknown);
  CHECK(rounds(Powder::polimam_t) == RoundsEdge::yes);
  CHECK(mat_powder_class({Powder::polimam_t}).shape == GrainShape::splintered);
  CHECK_FALSE(mat_powder_class({Powder::polimam_t}).top_drilling_speed);
  CHECK_FALSE(mat_powder_class({Powder::pr_r6m5}).top_drilling_speed);
  CHECK(mat_powder_class({Powder::pr_r6m5}).shape == GrainShape::rounded);
}

TEST_CASE("K103: bad input names itself", "[K103]") {
  CHECK_THROWS_WITH(mat_treatment_effect({Powder::polimam_t, 9}),
                    "K103.mat_treatment_effect: powder = \"polimam_t\", no data: numbers are published only "
                    "for \"polimam_t_plus_10_pr_r6m5\"");
  CHECK_THROWS_WITH(mat_time_for_edge_radius({15, 8.5, 8.5}),
                    "K103.mat_time_for_edge_radius: edge_radius_180_um = 8.5, must be above "
                    "edge_radius_before_um for the edge to become rounder");
  CHECK_THROWS_WITH(mat_time_for_edge_radius({23.6}),
                    "K103.mat_time_for_edge_radius: target_radius_um = 23.6, must not be above the radius "
                    "reached at 300 s");
  CHECK_THROWS_WITH(mat_surface_kinetics({301}),
                    "K103.mat_surface_kinetics: time_s = 301, allowed 0 <= time_s <= 300 (treatment time)");
}
