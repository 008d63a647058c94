#include "operations/kinds/blade_finishing.h"

#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::operations::BladeFinishing> {
  static std::vector<Field> fields() {
    using S = operations::BladeFinishing;
    return {need<S>(&S::variant, "variant", "-", no_range(), "route after milling"),
            need<S>(&S::polishing_min, "polishing_min", "min", closed(0, 1e4), "polishing of a blade"),
            may<S>(&S::vibropolishing_min, "vibropolishing_min", "min", closed(0, 1e5),
                   "vibropolishing of a batch"),
            may<S>(&S::handling_min, "handling_min", "min", closed(0, 1e4), "handling of a batch"),
            may<S>(&S::batch_size, "batch_size", "1", closed(1, 10'000), "blades treated together"),
            may<S>(&S::ra_max_um, "ra_max_um", "um", open_low(0, 100), "roughest surface allowed"),
            may<S>(&S::working_stress_mpa, "working_stress_mpa", "MPa", closed(0, 5000),
                   "mean stress amplitude in service"),
            may<S>(&S::working_stress_sd_mpa, "working_stress_sd_mpa", "MPa", closed(0, 5000), "its scatter"),
            may<S>(&S::reliability, "reliability", "1", closed(0.5, 0.99999),
                   "share of blades above the guaranteed endurance limit"),
            may<S>(&S::failure_probability_max, "failure_probability_max", "1", probability(),
                   "largest probability that a blade fails in service"),
            may<S>(&S::endurance_limit_min_mpa, "endurance_limit_min_mpa", "MPa", closed(0, 5000),
                   "least guaranteed endurance limit")};
  }
};

namespace verstat::operations {

namespace {

namespace k312 = models::k312;
using k312::Finish;

std::optional<k312::HardenedFinish> hardening(Finish variant) {
  switch (variant) {
    case Finish::soft:
      return k312::HardenedFinish::soft;
    case Finish::medium:
      return k312::HardenedFinish::medium;
    case Finish::hard:
      return k312::HardenedFinish::hard;
    case Finish::polishing:
    case Finish::vibropolishing:
      return std::nullopt;
  }
  return std::nullopt;
}

void endurance(const BladeFinishing& spec, const k312::FinishState& state, CutPlan& p) {
  models::require(state.sigma_1_mpa || (!spec.failure_probability_max && !spec.endurance_limit_min_mpa),
                  "variant", "VP", "has no measured endurance limit to hold a limit against");
  if (!state.sigma_1_mpa) return;
  const double mean_mpa = *state.sigma_1_mpa;
  const double sd_mpa = *state.sigma_1_sd_mpa;
  auto& q = p.quantities;
  q.push_back({"endurance_limit_mpa", mean_mpa, "MPa", "K312.finish_state", "mean endurance limit"});
  q.push_back({"endurance_limit_sd_mpa", sd_mpa, "MPa", "K312.finish_state", "its scatter"});
  p.leave("endurance_limit_mpa", sd_mpa);
  const auto polished = k312::finish_state({Finish::polishing});
  q.push_back({"endurance_factor", mean_mpa / *polished.sigma_1_mpa, "1", "K312.finish_state",
               "endurance limit over that of polishing alone"});
  q.push_back({"scatter_factor", sd_mpa / *polished.sigma_1_sd_mpa, "1", "K312.finish_state",
               "scatter over that of polishing alone"});
  const double guaranteed_mpa = k312::guaranteed_endurance({mean_mpa, sd_mpa, spec.reliability}).sigma_mpa;
  q.push_back({"guaranteed_endurance_mpa", guaranteed_mpa, "MPa", "K312.guaranteed_endurance",
               "endurance limit that the wanted share of blades exceeds"});
  if (spec.endurance_limit_min_mpa)
    p.limits.push_back({"guaranteed_endurance_mpa", guaranteed_mpa, *spec.endurance_limit_min_mpa, false,
                        "MPa", "K312.guaranteed_endurance"});
  models::require(spec.working_stress_mpa || !spec.failure_probability_max, "failure_probability_max",
                  spec.failure_probability_max.value_or(0), "needs working_stress_mpa");
  if (!spec.working_stress_mpa) return;
  constexpr const char* origin = "K312.fatigue_failure_probability";
  const double failing = k312::fatigue_failure_probability(
                             {*spec.working_stress_mpa, spec.working_stress_sd_mpa, mean_mpa, sd_mpa})
                             .p;
  q.push_back({"failure_probability", failing, "1", origin, "that a blade fails in service"});
  p.leave("failure_probability");
  if (spec.failure_probability_max)
    p.limits.push_back({"failure_probability", failing, *spec.failure_probability_max, true, "1", origin});
}

}  // namespace

CutPlan plan(const BladeFinishing& spec, const PlanContext&) {
  const auto state = k312::finish_state({spec.variant});
  double batch_min = 0;
  const char* origin = "given";
  if (const auto variant = hardening(spec.variant)) {
    batch_min = k312::hardening_regime({*variant}).time_min;
    origin = "K312.hardening_regime, with the given polishing";
  } else if (spec.variant == Finish::vibropolishing) {
    batch_min = spec.vibropolishing_min;
  }
  CutPlan p;
  p.quantities.reserve(12);
  // Vibropolishing stands instead of polishing, hardening comes after it; only treated batches are handled.
  const double blades = static_cast<double>(spec.batch_size);
  const double polishing_min = spec.variant == Finish::vibropolishing ? 0 : spec.polishing_min;
  const double treated_min = spec.variant == Finish::polishing ? 0 : (batch_min + spec.handling_min) / blades;
  p.set_main_time(polishing_min + treated_min, origin);
  auto& q = p.quantities;
  q.push_back({"ra_um", state.ra_um, "um", "K312.finish_state", "roughness Ra"});
  q.push_back({"microhardness_mpa", state.microhardness_mpa, "MPa", "K312.finish_state", "of the surface"});
  p.leave("ra_um");
  p.leave("microhardness_mpa", state.microhardness_sd_mpa);
  q.push_back({"hardening_percent", state.hardening_pct, "%", "K312.finish_state", "degree of hardening"});
  p.limits.push_back({"ra_um", state.ra_um, spec.ra_max_um, true, "um", "K312.roughness_ok"});
  endurance(spec, state, p);
  return p;
}

namespace blade_finishing {
void add_to(Kinds& kinds) {
  kinds.add<BladeFinishing>("Milled blades polished, hardened with balls, or vibropolished.", {"K312"});
}
}  // namespace blade_finishing

}  // namespace verstat::operations
