// K117 section A: availability of an insert as a semi-Markov process.
#include <cmath>
#include <numeric>

#include "models/reliability/detail/k117_parts.h"

namespace verstat::models::k117 {
namespace {

// Mean visits per insert (n5 = 1), cutting time and failures: everything but the restoration times.
struct Visits {
  double n1, n2, n3, n4;
  double up_min;
  double failures;
};

Visits visits(const TwoEdgeInsert& in) {
  const LifeLaw edge1 = LifeLaw::weibull(in.scale1_min, in.shape1);
  const LifeLaw edge2 = LifeLaw::weibull(in.scale2_min, in.shape2);
  const double r1 = detail::survival(edge1, in.change_age1_min);
  const double r2 = detail::survival(edge2, in.change_age2_min);
  const double to_index = r1 + (1 - r1) * in.p_reserve_ok;
  Visits v{};
  v.n1 = 1 - in.p_single_edge;
  v.n2 = in.p_single_edge;
  v.n3 = v.n4 = v.n1 * to_index;
  v.up_min = (v.n1 + v.n2) * detail::worked(edge1, in.change_age1_min) +
             v.n3 * detail::worked(edge2, in.change_age2_min);
  v.failures = (v.n1 + v.n2) * (1 - r1) + v.n3 * (1 - r2);
  return v;
}

using Matrix = std::vector<std::vector<double>>;

std::vector<bool> reachable_from(const Matrix& p, std::size_t start) {
  std::vector<bool> seen(p.size(), false);
  std::vector<std::size_t> open{start};
  seen[start] = true;
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    for (std::size_t to = 0; to < p.size(); ++to)
      if (p[from][to] > 0 && !seen[to]) {
        seen[to] = true;
        open.push_back(to);
      }
  }
  return seen;
}

// The states of the only recurrent class.
std::vector<std::size_t> recurrent_states(const Matrix& p) {
  // A walk that always moves on to a state which does not lead back ends in a recurrent class.
  std::size_t at = 0;
  std::vector<bool> ahead = reachable_from(p, at);
  for (std::size_t k = 0; k < p.size(); ++k)
    if (ahead[k] && !reachable_from(p, k)[at]) {
      at = k;
      ahead = reachable_from(p, at);
      k = static_cast<std::size_t>(-1);  // look again from the first state
    }
  std::vector<std::size_t> members;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (ahead[k]) members.push_back(k);
    require(reachable_from(p, k)[at], "P", static_cast<std::int64_t>(k),
            "is a state from which the recurrent class is not reached: allowed is one recurrent class");
  }
  return members;
}

// Stationary distribution of an irreducible chain by state reduction: no subtractions, so no cancellation
// (Grassmann, Taksar, Heyman 1985). Periodic chains are allowed.
std::vector<double> stationary(Matrix p) {
  const std::size_t n = p.size();
  for (std::size_t k = n; k-- > 1;) {
    const double out = std::accumulate(p[k].begin(), p[k].begin() + static_cast<std::ptrdiff_t>(k), 0.0);
    for (std::size_t i = 0; i < k; ++i) {
      p[i][k] /= out;
      for (std::size_t j = 0; j < k; ++j) p[i][j] += p[i][k] * p[k][j];
    }
  }
  std::vector<double> pi(n, 0.0);
  pi[0] = 1;
  double sum = 1;
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) pi[k] += pi[i] * p[i][k];
    sum += pi[k];
  }
  for (double& x : pi) x /= sum;
  return pi;
}

}  // namespace

InsertAvailability insert_cycle_availability(const InsertCycle& in) {
  return guarded<&insert_cycle_availability>(in, [&] {
    const Visits v = visits(in);
    const double down_min =
        v.n4 / in.rate_index_per_min + 1 / in.rate_replace_per_min + in.failure_extra_min * v.failures;
    const double all = v.n1 + v.n2 + v.n3 + v.n4 + 1;
    InsertAvailability out{};
    out.availability = v.up_min / (v.up_min + down_min);
    out.mean_up_min = v.up_min;
    out.mean_down_min = down_min;
    out.cycle_min = v.up_min + down_min;
    out.pi1 = v.n1 / all;
    out.pi2 = v.n2 / all;
    out.pi3 = v.n3 / all;
    out.pi4 = v.n4 / all;
    out.pi5 = 1 / all;
    out.failures_per_insert = v.failures;
    out.changes_per_cutting_hour = 60 * (v.n4 + 1) / v.up_min;
    return out;
  });
}

InsertAvailabilityEdges insert_cycle_availability_edges(const InsertCycleEdges& in) {
  return guarded<&insert_cycle_availability_edges>(in, [&] {
    InsertAvailabilityEdges out{};
    double reach = 1;
    double scale_min = in.scale_min;
    out.mean_down_min = 1 / in.rate_replace_per_min;
    for (std::int64_t k = 0; k < in.edges; ++k) {
      const LifeLaw edge = LifeLaw::weibull(scale_min, in.shape);
      const double survives = detail::survival(edge, in.change_age_min);
      out.mean_up_min += reach * detail::worked(edge, in.change_age_min);
      out.edges_used_per_insert += reach;
      out.failures_per_insert += reach * (1 - survives);
      if (k > 0) out.mean_down_min += reach / in.rate_index_per_min;
      reach *= survives + (1 - survives) * in.p_reserve_ok;
      scale_min *= in.edge_factor;
    }
    out.mean_down_min += in.failure_extra_min * out.failures_per_insert;
    out.availability = out.mean_up_min / (out.mean_up_min + out.mean_down_min);
    out.inserts_per_cutting_hour = 60 / out.mean_up_min;
    return out;
  });
}

SemiMarkovSteadyState semi_markov_steady_state(const SemiMarkov& in) {
  return guarded<&semi_markov_steady_state>(in, [&] {
    const std::size_t n = in.transitions.size();
    require(in.mean_sojourn_min.size() == n, "m_min", static_cast<std::int64_t>(in.mean_sojourn_min.size()),
            "is the number of sojourns: must be the number of states, one for each row of P");
    for (std::size_t i = 0; i < n; ++i) {
      require(in.transitions[i].size() == n, "P", static_cast<std::int64_t>(in.transitions[i].size()),
              "is the length of a row: P must be square");
      const double sum = std::accumulate(in.transitions[i].begin(), in.transitions[i].end(), 0.0);
      require(std::abs(sum - 1) <= 1e-9, "P", sum, "is the sum of a row: must be 1 within 1e-9");
    }
    const std::vector<std::size_t> members = recurrent_states(in.transitions);
    Matrix inside(members.size(), std::vector<double>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = 0; j < members.size(); ++j) inside[i][j] = in.transitions[members[i]][members[j]];
    const std::vector<double> pi = stationary(std::move(inside));
    SemiMarkovSteadyState out{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    double mean_min = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      out.embedded[members[i]] = pi[i];
      mean_min += pi[i] * in.mean_sojourn_min[members[i]];
    }
    if (!(mean_min > 0)) reject("m_min is 0 in every recurrent state: at least one must be above 0");
    for (std::size_t i = 0; i < n; ++i)
      out.time_fraction[i] = out.embedded[i] * in.mean_sojourn_min[i] / mean_min;
    return out;
  });
}

RestorationRate required_restoration_rate(const AvailabilityTarget& in) {
  return guarded<&required_restoration_rate>(in, [&] {
    const Visits v = visits(in);
    return RestorationRate{(v.n4 + 1) * in.availability / (v.up_min * (1 - in.availability))};
  });
}

SeriesReliability series_reliability(const SeriesParts& in) {
  return guarded<&series_reliability>(in, [&] {
    double product = 1;
    for (const double part : in.parts) product *= part;
    return SeriesReliability{product};
  });
}

}  // namespace verstat::models::k117
