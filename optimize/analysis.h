#pragma once
// What an engineer asks about an optimum: what holds it back and what more room would bring, what it hangs
// on, and how it differs from the textbook's optimum of one cut. All in the long run, without simulation.

#include <string>
#include <vector>

#include "optimize/problem.h"
#include "sim/shop/run.h"

namespace verstat::optimize {

/// A constraint or bound that holds the optimum back.
struct Binding {
  std::string name;  ///< "power_kw of rough turning", "upper bound of cutting speed"
  std::string unit;
  double value = 0;  ///< at the optimum
  double allowed = 0;
  double shadow_price = 0;  ///< objective gained per unit of more room, >= 0, in the objective's unit
};
/// Every condition with less than 0.1 % of room and every bound that the optimum touches, each relaxed by 1 %
/// of its allowed value (or of the bounds) and the continuous variables searched again from the optimum.
[[nodiscard]] std::vector<Binding> binding_constraints(Problem& problem, const std::vector<double>& best,
                                                       const SearchOptions& options);

/// What the optimum does when an input is other than believed.
struct Sensitivity {
  std::string name;
  std::string pointer;
  double relative = 0;       ///< the input is off by this share
  double objective_low = 0;  ///< best objective with the input lower, higher
  double objective_high = 0;
  double regret_low =
      0;  ///< what keeping this optimum would lose then, >= 0; infinite when it breaks a constraint
  double regret_high = 0;
  std::vector<double> x_low;  ///< the optimum then
  std::vector<double> x_high;
};
/// For the uncertain inputs of the study, or else for price, scatter and Taylor exponent of every insert and
/// the rate of every machine, +- 10 %. Inputs that move nothing are left out. Largest effect first.
[[nodiscard]] std::vector<Sensitivity> sensitivities(const Problem& problem, const std::vector<double>& best,
                                                     const SearchOptions& options);
/// The uncertain inputs that `sensitivities` takes when the study names none.
[[nodiscard]] std::vector<UncertainSpec> usual_uncertain_inputs(const scenarios::Scenario& scenario);

/// One operation by the textbook and as the shop wants it.
struct OneCut {
  std::string operation;
  double speed_min_cost_m_min = 0;  ///< textbook: smallest cost of this cut alone
  double speed_max_rate_m_min = 0;  ///< textbook: most parts per hour from this machine alone
  double life_min_cost_min = 0;     ///< mean tool life there
  double life_max_rate_min = 0;
  double speed_shop_m_min = 0;  ///< in the plan
  double life_shop_min = 0;
  double load = 0;             ///< of its machines
  double waits_for_crew = 0;   ///< share of the tool's time, simulated; 0 without a simulation
  double waits_for_stock = 0;  ///< likewise: for tools and inserts, or for room behind the machine
  std::string why;             ///< the plan differs from the textbook because ...
};
/// Minimum-cost and maximum-rate speed of one cut with a deterministic Taylor life T ~ v^-mu:
///   T_cost = (mu - 1) (t_c + C_t / C_m),  T_rate = (mu - 1) t_c
/// with t_c the time and C_t the money (crew and edge) of a planned change, C_m the machine's rate (Taylor
/// 1907; Gilbert 1950). For operations with a wearing edge whose main time goes as 1 / v. mu is the local
/// exponent of the plan's life. The reason of the difference is looked for in the loads of the machines
/// (bottleneck, demand), in the waits for crew and stock of the `simulated` plan, and in the failures. Empty
/// when neither the long run nor a simulation knows the shop.
[[nodiscard]] std::vector<OneCut> one_cut_optima(const scenarios::Scenario& plan,
                                                 const shop::RunResult* simulated = nullptr);

/// The closed form alone: mean life at the optimum, `machine_rate` > 0 money per minute, exponent mu > 1,
/// change `change_min` >= 0, `change_cost` >= 0 money besides machine time.
[[nodiscard]] double taylor_life_min_cost(double mu, double change_min, double change_cost,
                                          double machine_rate);

}  // namespace verstat::optimize
