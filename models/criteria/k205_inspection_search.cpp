// Search over sets of inspection operations (K205, criterion 4), and the comparison of criteria.
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "models/criteria/k205_hierarchical_efficiency.h"

namespace verstat::models::k205 {
namespace {

constexpr std::size_t enumerated_operations = 20;
constexpr double tie = 1e-12;

struct SetValue {
  double cost_cu;
  double escape_probability;
  [[nodiscard]] double efficiency() const { return cost_cu / (1 - escape_probability); }
};

class Search {
 public:
  explicit Search(const InspectionChoice& choice) : in_(choice) {}

  [[nodiscard]] SetValue value(const std::vector<char>& chosen) const {
    std::vector<double> missed(in_.defect_share.size(), 1.0);
    double cost = in_.base_cost_cu;
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k]) {
        cost += in_.operation_cost_cu[k];
        for (std::size_t i = 0; i < missed.size(); ++i) missed[i] *= 1 - in_.detection[k][i];
      }
    return {cost, escape(missed)};
  }

  // Criterion 4 of every subset; bit k of the index is operation k.
  [[nodiscard]] std::vector<double> all_values() {
    values_.assign(std::size_t{1} << in_.operation_cost_cu.size(), 0.0);
    missed_.assign(in_.operation_cost_cu.size() + 1, std::vector<double>(in_.defect_share.size(), 1.0));
    descend(0, 0, in_.base_cost_cu, 0);
    return std::move(values_);
  }

 private:
  [[nodiscard]] double escape(const std::vector<double>& missed) const {
    double undetected = 0;
    for (std::size_t i = 0; i < missed.size(); ++i) undetected += missed[i] * in_.defect_share[i];
    return in_.defective_share * undetected;
  }
  // Adds operations from `next` on to the set; missed_[depth] belongs to the set as it is.
  void descend(std::size_t set, std::size_t next, double cost_cu, std::size_t depth) {
    values_[set] = SetValue{cost_cu, escape(missed_[depth])}.efficiency();
    for (std::size_t k = next; k < in_.operation_cost_cu.size(); ++k) {
      for (std::size_t i = 0; i < in_.defect_share.size(); ++i)
        missed_[depth + 1][i] = missed_[depth][i] * (1 - in_.detection[k][i]);
      descend(set | (std::size_t{1} << k), k + 1, cost_cu + in_.operation_cost_cu[k], depth + 1);
    }
  }

  const InspectionChoice& in_;
  std::vector<double> values_;
  std::vector<std::vector<double>> missed_;
};

// Fewer operations first, then the set whose ascending list comes first in lexicographic order.
bool preferred(const std::vector<char>& a, const std::vector<char>& b) {
  const auto size = [](const std::vector<char>& set) {
    std::size_t n = 0;
    for (const char c : set) n += static_cast<std::size_t>(c);
    return n;
  };
  const std::size_t size_a = size(a);
  const std::size_t size_b = size(b);
  if (size_a != size_b) return size_a < size_b;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k]) return a[k] != 0;
  return false;
}

std::vector<char> enumerate(const InspectionChoice& choice) {
  const std::vector<double> values = Search(choice).all_values();
  double least = values[0];
  for (const double v : values) least = std::min(least, v);
  std::size_t best = 0;
  bool found = false;
  for (std::size_t set = 0; set < values.size(); ++set) {
    if (values[set] > least + tie) continue;
    const int more = std::popcount(set) - std::popcount(best);
    const std::size_t differing = set ^ best;
    // Equal sizes: the lowest operation that only one has decides.
    if (!found || more < 0 || (more == 0 && ((differing & (~differing + 1)) & set) != 0)) best = set;
    found = true;
  }
  std::vector<char> chosen(choice.operation_cost_cu.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) chosen[k] = static_cast<char>((best >> k) & 1U);
  return chosen;
}

std::vector<char> climb(const InspectionChoice& choice) {
  const Search search(choice);
  std::vector<char> chosen(choice.operation_cost_cu.size(), 0);
  double here = search.value(chosen).efficiency();
  for (;;) {
    std::vector<double> values(chosen.size());
    double least = here;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      chosen[k] ^= 1;
      values[k] = search.value(chosen).efficiency();
      chosen[k] ^= 1;
      least = std::min(least, values[k]);
    }
    if (!(least < here - tie)) return chosen;
    std::optional<std::vector<char>> best;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (values[k] > least + tie) continue;
      std::vector<char> neighbour = chosen;
      neighbour[k] ^= 1;
      if (!best || preferred(neighbour, *best)) best = std::move(neighbour);
    }
    chosen = std::move(*best);
    here = search.value(chosen).efficiency();
  }
}

double sign(double x) {
  return (x > 0) - (x < 0);
}

double kendall_tau_b(const std::vector<std::vector<double>>& matrix, std::size_t a, std::size_t b) {
  double score = 0;
  double pairs_a = 0;
  double pairs_b = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = i + 1; j < matrix.size(); ++j) {
      const double order_a = sign(matrix[j][a] - matrix[i][a]);
      const double order_b = sign(matrix[j][b] - matrix[i][b]);
      score += order_a * order_b;
      pairs_a += order_a * order_a;
      pairs_b += order_b * order_b;
    }
  return pairs_a > 0 && pairs_b > 0 ? score / std::sqrt(pairs_a * pairs_b) : 0;
}

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] < b[k]) return false;
    better = better || a[k] > b[k];
  }
  return better;
}

}  // namespace

InspectionOptimum optimal_inspection_set(const InspectionChoice& in) {
  return guarded<&optimal_inspection_set>(in, [&] {
    const std::size_t operations = in.operation_cost_cu.size();
    if (in.detection.size() != operations)
      throw DomainError("detection",
                        fmt::format("detection has {} entries, must have one list per operation, that is {}",
                                    in.detection.size(), operations));
    for (std::size_t k = 0; k < operations; ++k)
      if (in.detection[k].size() != in.defect_share.size())
        throw DomainError(
            "detection", fmt::format("detection/{} has {} entries, must have one per defect type, that is {}",
                                     k, in.detection[k].size(), in.defect_share.size()));
    double shares = 0;
    for (const double share : in.defect_share) shares += share;
    if (shares > 1 + 1e-9)
      throw DomainError("defect_share", fmt::format("defect_share sums to {}, must not exceed 1", shares));
    if (!(in.defective_share * shares < 1))
      reject("every part may escape with a defect: the criterion is not defined");

    const std::vector<char> chosen = operations <= enumerated_operations ? enumerate(in) : climb(in);
    const SetValue value = Search(in).value(chosen);
    InspectionOptimum out{{}, value.efficiency(), value.escape_probability, value.cost_cu};
    for (std::size_t k = 0; k < operations; ++k)
      if (chosen[k]) out.operations.push_back(static_cast<std::int64_t>(k));
    return out;
  });
}

Conflict criteria_conflict(const CriteriaMatrix& in) {
  return guarded<&criteria_conflict>(in, [&] {
    const std::size_t criteria = in.matrix.front().size();
    for (std::size_t i = 0; i < in.matrix.size(); ++i)
      if (in.matrix[i].size() != criteria || criteria == 0)
        throw DomainError("matrix", fmt::format("matrix/{} has {} entries, must have as many as the first "
                                                "row and at least one",
                                                i, in.matrix[i].size()));
    Conflict out;
    out.tau.assign(criteria, std::vector<double>(criteria, 1.0));
    for (std::size_t a = 0; a < criteria; ++a) {
      for (std::size_t b = a + 1; b < criteria; ++b)
        out.tau[a][b] = out.tau[b][a] = kendall_tau_b(in.matrix, a, b);
      std::size_t winner = 0;
      for (std::size_t i = 1; i < in.matrix.size(); ++i)
        if (in.matrix[i][a] > in.matrix[winner][a]) winner = i;
      out.winners.push_back(static_cast<std::int64_t>(winner));
    }
    for (std::size_t i = 0; i < in.matrix.size(); ++i) {
      bool dominated = false;
      for (std::size_t j = 0; j < in.matrix.size() && !dominated; ++j)
        dominated = dominates(in.matrix[j], in.matrix[i]);
      if (!dominated) out.pareto.push_back(static_cast<std::int64_t>(i));
    }
    return out;
  });
}

}  // namespace verstat::models::k205
