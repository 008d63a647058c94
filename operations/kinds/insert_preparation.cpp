#include "operations/kinds/insert_preparation.h"

#include <algorithm>

#include "models/inspection/k119_cutter_certification.h"
#include "models/inspection/k121_thermo_emf.h"
#include "models/reliability/k117_rational_reliability.h"
#include "models/treatment/k103_magneto_abrasive_drills.h"
#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::operations::InsertPreparation> {
  static std::vector<Field> fields() {
    using S = operations::InsertPreparation;
    return {
        need<S>(&S::mean_life_min, "mean_life_min", "min", open_low(0, 1e6),
                "mean life of an untreated edge"),
        may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2),
               "coefficient of variation of its life (Weibull)"),
        may<S>(&S::breakage_fraction, "breakage_fraction", "1", closed(0, 1),
               "share of the lives that end by breakage"),
        may<S>(&S::screening, "screening", "-", no_range(), "test that sorts the lot"),
        may<S>(&S::reject_fraction, "reject_fraction", "1", closed(0.001, 0.999),
               "share that the strength test rejects"),
        may<S>(&S::life_correlation, "life_correlation", "1", closed(0, 0.995),
               "correlation of the strength test with life"),
        may<S>(&S::breakage_correlation, "breakage_correlation", "1", closed(0, 0.995),
               "correlation of the test with breakage, magnitude"),
        may<S>(&S::emf_mean_mv, "emf_mean_mv", "mV", open_low(0, 12), "mean EMF of the delivery"),
        may<S>(&S::emf_sd_mv, "emf_sd_mv", "mV", open_low(0, 6), "standard deviation of the EMF"),
        may<S>(&S::emf_limit_mv, "emf_limit_mv", "mV", open_low(0, 12), "largest EMF that is accepted"),
        may<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1000),
               "cutting speed of the regime the EMF is judged for"),
        may<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(0.01, 50), "its depth of cut"),
        may<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(0.001, 10), "its feed"),
        may<S>(&S::test_min, "test_min", "min", closed(0, 1e4), "time of the test per insert"),
        may<S>(&S::treatment, "treatment", "-", no_range(), "treatment of the accepted inserts"),
        may<S>(&S::treatment_s, "treatment_s", "s", closed(0, 1e6), "time of the treatment per batch"),
        may<S>(&S::handling_s, "handling_s", "s", closed(0, 1e6), "handling per batch"),
        may<S>(&S::batch_size, "batch_size", "1", closed(1, 1'000'000), "inserts of a batch"),
        may<S>(&S::life_factor, "life_factor", "1", closed(1, 10),
               "mean life over that before magnetic_pulse or magnetic_abrasive treatment"),
        may<S>(&S::pulse_life_cv, "pulse_life_cv", "1", closed(0.05, 0.45),
               "coefficient of variation of the normal life after magnetic pulses"),
        may<S>(&S::mixture, "mixture", "-", no_range(), "powder of the bath for inserts"),
        may<S>(&S::ra_initial_um, "ra_initial_um", "um", open_low(0, 100), "roughness Ra before the bath"),
        may<S>(&S::edge_radius_initial_um, "edge_radius_initial_um", "um", closed(0, 500),
               "edge radius before the bath"),
        may<S>(&S::edge_radius_rate_um_s, "edge_radius_rate_um_s", "um/s", open_low(0, 10),
               "growth of the edge radius of inserts in the bath"),
        may<S>(&S::edge_radius_max_um, "edge_radius_max_um", "um", open_low(0, 500), "largest edge radius"),
        may<S>(&S::insert_cost, "insert_cost", "money", closed(0, 1e9), "price of an insert"),
        may<S>(&S::edges_per_insert, "edges_per_insert", "1", closed(1, 16), "edges of an insert"),
        may<S>(&S::edges_used_by_test, "edges_used_by_test", "1", closed(0, 15),
               "edges that the test destroys"),
        may<S>(&S::test_cost, "test_cost", "money", closed(0, 1e9), "cost of the test per insert"),
        may<S>(&S::salvage_value, "salvage_value", "money", closed(0, 1e9), "value of a rejected insert"),
        may<S>(&S::treatment_cost, "treatment_cost", "money", closed(0, 1e9),
               "cost of the treatment per insert"),
        may<S>(&S::change_cost, "change_cost", "money", closed(0, 1e9), "cost of an edge change"),
        may<S>(&S::breakage_cost, "breakage_cost", "money", closed(0, 1e9), "extra cost of a breakage"),
        may<S>(&S::gamma, "gamma", "1", closed(0.01, 0.99), "probability of the gamma-percent life shown")};
  }
};

namespace verstat::operations {

namespace {

namespace k103 = models::k103;
namespace k108 = models::k108;
namespace k119 = models::k119;
namespace k121 = models::k121;
using Life = PreparedLife;

double reject_fraction(const InsertPreparation& spec) {
  if (spec.screening == InsertScreening::none) return 0;
  if (spec.screening == InsertScreening::strength_test) return spec.reject_fraction;
  k121::ScreenIn in;
  in.emf_mean_mv = spec.emf_mean_mv;
  in.emf_sd_mv = spec.emf_sd_mv;
  in.depth_mm = spec.depth_of_cut_mm;
  in.feed_mm_rev = spec.feed_mm_rev;
  in.emf_limit_mv = spec.emf_limit_mv;
  in.speed_m_min = spec.cutting_speed_m_min;
  return k121::emf_screened_life(in).reject_fraction;
}

/// Correlation of the EMF with the logarithm of life: what part of the scatter the test can see.
double emf_correlation(const InsertPreparation& spec) {
  k121::ScatterIn in;
  in.emf_mean_mv = spec.emf_mean_mv;
  in.emf_sd_mv = spec.emf_sd_mv;
  in.groups = 1;
  in.life_cv_total = spec.life_cv;
  const double rho = k121::emf_life_scatter(in).rho;
  models::require(rho <= 0.995, "emf_sd_mv", spec.emf_sd_mv,
                  "explains more than the scatter of life: must be lower, or life_cv higher");
  return rho;
}

Life screened(const InsertPreparation& spec) {
  Life life{models::LifeLawKind::weibull, spec.mean_life_min, spec.life_cv, spec.breakage_fraction,
            reject_fraction(spec)};
  if (life.reject_fraction < 0.001) return life;  // as good as no test; the model ends there
  models::require(life.reject_fraction <= 0.999, "emf_limit_mv", spec.emf_limit_mv,
                  "rejects more than 99.9 % of the lot");
  const bool emf = spec.screening == InsertScreening::thermo_emf;
  const auto law = k119::weibull_from_mean_cv({.mean_life_min = spec.mean_life_min, .life_cv = spec.life_cv});
  const auto accepted = k119::screened_life({.shape = law.shape,
                                             .scale_min = law.scale_min,
                                             .rho = emf ? emf_correlation(spec) : spec.life_correlation,
                                             .reject_fraction = life.reject_fraction});
  life.mean_min = accepted.mean_accepted_min;
  life.cv = accepted.cv_accepted;
  // The EMF is fitted to life; nothing is known of breakage.
  if (!emf && spec.breakage_fraction >= 0.001 && spec.breakage_fraction <= 0.999)
    life.breakage_fraction = k119::screen_by_correlated_test({.rho = spec.breakage_correlation,
                                                              .bad_fraction = spec.breakage_fraction,
                                                              .reject_fraction = life.reject_fraction})
                                 .bad_fraction_accepted;
  return life;
}

Life treated(const InsertPreparation& spec, Life life) {
  const auto by_table = [&](k119::Treatment variant) {
    const auto row = k119::treatment_variant({.variant = variant});
    life.mean_min *= row.life_ratio;
    life.breakage_fraction = std::min(1.0, life.breakage_fraction * row.breakage_ratio);
  };
  switch (spec.treatment) {
    case InsertTreatment::none:
      break;
    case InsertTreatment::edge_rounding:
      by_table(k119::Treatment::bo);
      break;
    case InsertTreatment::tin_coating:
      by_table(k119::Treatment::tin);
      break;
    case InsertTreatment::edge_rounding_tin:
      by_table(k119::Treatment::bo_tin);
      break;
    case InsertTreatment::magnetic_pulse:
      life.law = models::LifeLawKind::normal;
      life.mean_min *= spec.life_factor;
      life.cv = spec.pulse_life_cv;
      break;
    case InsertTreatment::magnetic_abrasive:
      life.mean_min *= spec.life_factor;
      break;
    case InsertTreatment::magnetic_abrasive_drills: {
      const auto law = k119::weibull_from_mean_cv({.mean_life_min = life.mean_min, .life_cv = life.cv});
      const auto effect = k103::mat_treatment_effect({.hardness_before_gpa = 8});
      life.mean_min =
          k103::mat_weibull_life(
              {.scale_min = law.scale_min, .shape = law.shape, .life_factor = effect.life_factor_min})
              .mean_min;
      break;
    }
  }
  return life;
}

const char* treatment_origin(InsertTreatment treatment) {
  switch (treatment) {
    case InsertTreatment::none:
      return "specification";
    case InsertTreatment::edge_rounding:
    case InsertTreatment::tin_coating:
    case InsertTreatment::edge_rounding_tin:
      return "K119.treatment_variant";
    case InsertTreatment::magnetic_pulse:
      return "K117.pulse_treatment_effect";
    case InsertTreatment::magnetic_abrasive:
      return "COMPLETION: life factor of the specification, K108 gives none";
    case InsertTreatment::magnetic_abrasive_drills:
      return "K103.mat_weibull_life";
  }
  return "specification";
}

/// What the bath leaves on the edge.
void surface(const InsertPreparation& spec, CutPlan& p) {
  std::optional<double> radius_um;
  const char* origin = "K108.edge_radius_after";
  if (spec.treatment == InsertTreatment::magnetic_abrasive) {
    radius_um = k108::edge_radius_after({.time_s = spec.treatment_s,
                                         .initial_um = spec.edge_radius_initial_um,
                                         .rate_um_s = spec.edge_radius_rate_um_s,
                                         .break_s = 0,
                                         .slow_factor = 1})
                    .radius_um;
    p.quantities.push_back(
        {"ra_um",
         k108::roughness_after(
             {.time_s = spec.treatment_s, .ra_initial_um = spec.ra_initial_um, .mixture = spec.mixture})
             .ra_um,
         "um", "K108.roughness_after", "roughness Ra after the bath"});
    p.quantities.push_back({"hardness_factor", k108::hardness_factor({.time_s = spec.treatment_s}).factor,
                            "1", "K108.hardness_factor", "hardness over initial hardness"});
  } else if (spec.treatment == InsertTreatment::magnetic_abrasive_drills) {
    const auto state = k103::mat_surface_kinetics({.time_s = spec.treatment_s});
    origin = "K103.mat_surface_kinetics";
    radius_um = state.edge_radius_um;
    p.quantities.push_back({"ra_um", state.ra_um, "um", origin, "roughness Ra after the bath"});
  }
  if (!radius_um) return;
  p.quantities.push_back({"edge_radius_um", *radius_um, "um", origin, "edge radius after the bath"});
  if (spec.edge_radius_max_um)
    p.limits.push_back({"edge_radius_um", *radius_um, *spec.edge_radius_max_um, true, "um", origin});
}

/// Cost of a minute of cutting: the edge, its change and its breakages over its life.
double cost_rate(const InsertPreparation& spec, double edge_cost, const Life& life) {
  return (edge_cost + spec.change_cost + life.breakage_fraction * spec.breakage_cost) / life.mean_min;
}

}  // namespace

PreparedLife prepared_life(const InsertPreparation& spec) {
  return treated(spec, screened(spec));
}

CutPlan plan(const InsertPreparation& spec, const PlanContext&) {
  const bool tests = spec.screening != InsertScreening::none;
  const bool treats = spec.treatment != InsertTreatment::none;
  const Life before{models::LifeLawKind::weibull, spec.mean_life_min, spec.life_cv, spec.breakage_fraction,
                    0};
  const Life after = prepared_life(spec);
  const double accepted = 1 - after.reject_fraction;

  CutPlan p;
  // Rejected inserts are tested but not treated.
  const double treatment_min =
      treats ? k103::mat_batch_time(
                   {.size = spec.batch_size, .cycle_s = spec.treatment_s, .handling_s = spec.handling_s})
                   .time_min
             : 0;
  p.set_main_time((tests ? spec.test_min : 0) + accepted * treatment_min,
                  "K103.mat_batch_time and the time of the test");
  p.scrap_probability = after.reject_fraction;

  const char* screening = spec.screening == InsertScreening::thermo_emf ? "K121.emf_screened_life"
                                                                        : "K119.screen_by_correlated_test";
  const char* origin = treats  ? treatment_origin(spec.treatment)
                       : tests ? "K119.screened_life"
                               : "specification";
  p.quantities.push_back(
      {"reject_fraction", after.reject_fraction, "1", screening, "share of the lot that is rejected"});
  if (spec.screening == InsertScreening::thermo_emf)
    p.quantities.push_back({"emf_life_correlation", emf_correlation(spec), "1", "K121.emf_life_scatter",
                            "correlation of the EMF with the logarithm of life"});
  p.quantities.push_back(
      {"mean_life_before_min", before.mean_min, "min", "specification", "mean life of the lot"});
  p.quantities.push_back(
      {"mean_life_after_min", after.mean_min, "min", origin, "mean life of a prepared edge"});
  p.quantities.push_back({"life_cv_before", before.cv, "1", "specification", "scatter of the lot"});
  p.quantities.push_back({"life_cv_after", after.cv, "1", origin, "scatter of the prepared edges"});
  p.quantities.push_back({"normal_law_after", after.law == models::LifeLawKind::normal ? 1.0 : 0.0, "1",
                          origin, "1: normal life law, 0: Weibull"});
  const auto gamma_life = [&](const Life& life) {
    return models::LifeLaw(life.law, life.mean_min, life.cv).gamma_percent_life(spec.gamma);
  };
  constexpr const char* gamma_origin = "K117.gamma_percent_life";
  const double gamma_before_min = gamma_life(before);
  const double gamma_after_min = gamma_life(after);
  p.quantities.push_back({"gamma_life_before_min", gamma_before_min, "min", gamma_origin,
                          "age survived with probability gamma, as delivered"});
  p.quantities.push_back(
      {"gamma_life_after_min", gamma_after_min, "min", gamma_origin, "the same of a prepared edge"});
  p.quantities.push_back({"breakage_fraction_before", before.breakage_fraction, "1", "specification",
                          "share of lives that end by breakage, as delivered"});
  p.quantities.push_back({"breakage_fraction_after", after.breakage_fraction, "1",
                          treats ? origin : "K119.screen_by_correlated_test", "the same of a prepared edge"});

  models::require(!tests || spec.edges_used_by_test < spec.edges_per_insert, "edges_used_by_test",
                  spec.edges_used_by_test, "must be below edges_per_insert");
  constexpr const char* cost_origin = "K119.inspection_decision; COMPLETION: with the cost of the treatment";
  const double edges = static_cast<double>(spec.edges_per_insert);
  const double edges_left = edges - static_cast<double>(tests ? spec.edges_used_by_test : 0);
  const double tested = tests ? spec.test_cost - after.reject_fraction * spec.salvage_value : 0;
  const double prepared_cost = (spec.insert_cost + tested) / accepted + (treats ? spec.treatment_cost : 0);
  const double rate_before = cost_rate(spec, spec.insert_cost / edges, before);
  const double rate_after = cost_rate(spec, prepared_cost / edges_left, after);
  p.quantities.push_back({"prepared_insert_cost", prepared_cost, "money", cost_origin,
                          "cost of an insert that is accepted and treated"});
  p.quantities.push_back({"cost_rate_before_per_min", rate_before, "money/min", cost_origin,
                          "cost of the tool per minute of cutting, as delivered"});
  p.quantities.push_back({"cost_rate_after_per_min", rate_after, "money/min", cost_origin,
                          "cost of the tool per minute of cutting, prepared"});
  if (rate_before > 0)
    p.quantities.push_back({"saving_fraction", 1 - rate_after / rate_before, "1", cost_origin,
                            "share of that cost which the preparation saves"});
  p.consumables.push_back({"inserts_per_prepared_insert", 1 / accepted, "1", screening,
                           "delivered inserts for one that is used"});
  p.lot = PreparedLot{.law = after.law,
                      .life_factor = after.mean_min / before.mean_min,
                      .cv = after.cv,
                      .breakage_fraction = after.breakage_fraction,
                      .delivered_per_prepared = 1 / accepted,
                      .added_cost_per_insert = tested / accepted + (treats ? spec.treatment_cost : 0),
                      .edges_used_by_test = tests ? spec.edges_used_by_test : 0,
                      .origin = origin};
  surface(spec, p);
  return p;
}

namespace insert_preparation {
void add_to(Kinds& kinds) {
  kinds.add<InsertPreparation>("Inserts sorted by a test and treated: another life law at another cost.",
                               {"K119", "K121", "K108", "K103", "K117"});
}
}  // namespace insert_preparation

}  // namespace verstat::operations
