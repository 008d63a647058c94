#pragma once
// Operation kind "insert_preparation": inserts (or drills) are sorted by a test and treated before they reach
// the machines.
//
// Sorting by a correlated test (K119) or by thermo-EMF (K121) rejects a share of the lot; rounding, coating
// (K119), magnetic pulses (K117 section F) and magnetic-abrasive baths (K108, K103) change what is left. The
// plan says what both do to the life law, to the breakages and to the cost of a minute of cutting;
// prepared_life() hands the law on.

#include <cstdint>

#include "models/treatment/k108_magnetic_abrasive_inserts.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class InsertScreening {
  none,
  strength_test,  ///< shot or stepped-feed test with a known correlation, K119
  thermo_emf      ///< EMF limit, K121
};
enum class InsertTreatment {
  none,
  edge_rounding,            ///< vibro-abrasive, K119
  tin_coating,              ///< K119
  edge_rounding_tin,        ///< K119
  magnetic_pulse,           ///< K117 section F: Weibull becomes normal
  magnetic_abrasive,        ///< carbide inserts in a ring bath, K108
  magnetic_abrasive_drills  ///< high-speed-steel drills in a ring bath, K103
};

struct InsertPreparation {
  static constexpr const char* kind = "insert_preparation";
  /// The lot as delivered: Weibull lives of one edge.
  double mean_life_min = 0;
  double life_cv = 0.7;
  double breakage_fraction = 0;  ///< of the lives that end by breakage

  InsertScreening screening = InsertScreening::none;
  double reject_fraction = 0.2;        ///< of the strength test
  double life_correlation = 0.67;      ///< of the test with life
  double breakage_correlation = 0.79;  ///< of the test with breakage, magnitude
  double emf_mean_mv = 5;
  double emf_sd_mv = 0.4;
  double emf_limit_mv = 5.4;
  double cutting_speed_m_min = 100;  ///< of the regime the inserts are sorted for
  double depth_of_cut_mm = 1;
  double feed_mm_rev = 0.3;
  double test_min = 0;  ///< per insert

  InsertTreatment treatment = InsertTreatment::none;
  double treatment_s = 180;
  double handling_s = 60;  ///< per batch
  std::int64_t batch_size = 1;
  double life_factor = 1;  ///< magnetic pulse and magnetic-abrasive inserts: no published value
  double pulse_life_cv = 0.4;
  models::k108::Mixture mixture = models::k108::Mixture::fine;
  double ra_initial_um = 3;
  double edge_radius_initial_um = 5;
  double edge_radius_rate_um_s = 0.05;
  std::optional<double> edge_radius_max_um;

  double insert_cost = 0;
  std::int64_t edges_per_insert = 4;
  std::int64_t edges_used_by_test = 0;
  double test_cost = 0;       ///< per insert
  double salvage_value = 0;   ///< per rejected insert
  double treatment_cost = 0;  ///< per insert
  double change_cost = 0;     ///< per edge change
  double breakage_cost = 0;   ///< extra, per breakage
  double gamma = 0.8;         ///< of the gamma-percent life shown
};

/// What a prepared edge brings to the machine.
struct PreparedLife {
  models::LifeLawKind law = models::LifeLawKind::weibull;
  double mean_min = 0;
  double cv = 0.7;
  double breakage_fraction = 0;
  double reject_fraction = 0;  ///< of the lot
};
/// Life of the inserts that pass, after their treatment. Throws models::ModelError or models::DomainError.
[[nodiscard]] PreparedLife prepared_life(const InsertPreparation& spec);

/// One insert of the delivered lot: its time, its probability of being rejected (scrap), and what the lot is
/// worth before and after. Throws models::ModelError or models::DomainError.
[[nodiscard]] CutPlan plan(const InsertPreparation& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::InsertScreening> {
  using E = operations::InsertScreening;
  static constexpr std::array names{std::pair{E::none, "none"}, std::pair{E::strength_test, "strength_test"},
                                    std::pair{E::thermo_emf, "thermo_emf"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::InsertTreatment> {
  using E = operations::InsertTreatment;
  static constexpr std::array names{std::pair{E::none, "none"},
                                    std::pair{E::edge_rounding, "edge_rounding"},
                                    std::pair{E::tin_coating, "tin_coating"},
                                    std::pair{E::edge_rounding_tin, "edge_rounding_tin"},
                                    std::pair{E::magnetic_pulse, "magnetic_pulse"},
                                    std::pair{E::magnetic_abrasive, "magnetic_abrasive"},
                                    std::pair{E::magnetic_abrasive_drills, "magnetic_abrasive_drills"}};
};
