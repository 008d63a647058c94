#include "app/mpi/ranks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <list>
#include <string>
#include <thread>

#include <mpi.h>

#include "scenarios/load.h"
#include "scenarios/model_json.h"
#include "sim/shop/kpis.h"

namespace verstat::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int task_tag = 1;
constexpr int result_tag = 2;
constexpr int stop_tag = 3;

// Waiting in MPI burns a core: both sides look and sleep.
constexpr std::chrono::microseconds nap(500);
// A rank silent for so long, and for so many times the longest replication so far, is taken for dead.
constexpr double patience_s = 10;
constexpr double patience_factor = 10;

struct TaskHead {
  std::uint64_t number = 0;  // of the task, never used twice
  std::uint64_t replication = 0;
};
struct ResultHead {
  std::uint64_t number = 0;
  std::uint64_t events = 0;
  std::uint64_t course = 0;
  std::uint64_t failed = 0;  // then a text follows, else the values
};

template <class Head>
std::string message(const Head& head, const void* data, std::size_t bytes) {
  std::string m(reinterpret_cast<const char*>(&head), sizeof head);
  m.append(static_cast<const char*>(data), bytes);
  return m;
}
template <class Head>
Head head_of(const std::string& m) {
  Head head;
  std::memcpy(&head, m.data(), sizeof head);
  return head;
}

// The message that waits, if any.
bool receive(int from, int tag, std::string& m, int& source, int& its_tag) {
  int there = 0;
  MPI_Status status;
  if (MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status) != MPI_SUCCESS || there == 0) return false;
  int bytes = 0;
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  m.resize(static_cast<std::size_t>(bytes));
  source = status.MPI_SOURCE;
  its_tag = status.MPI_TAG;
  return MPI_Recv(m.data(), bytes, MPI_BYTE, source, its_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE) ==
         MPI_SUCCESS;
}

}  // namespace

struct Ranks::State {
  struct Rank {
    bool busy = false;
    bool silent = false;  // passed over until it answers
    std::size_t index = 0;
    std::uint64_t number = 0;
    Clock::time_point since;
  };
  // Messages under way; kept until MPI has them, those to silent ranks for ever.
  struct Sending {
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::vector<Rank> ranks;
  std::list<Sending> sending;
  std::uint64_t next_number = 1;
  double longest_s = 0;

  void send(std::size_t rank, int tag, std::string text) {
    Sending& s = sending.emplace_back();
    s.text = std::move(text);
    MPI_Isend(s.text.data(), static_cast<int>(s.text.size()), MPI_BYTE, static_cast<int>(rank), tag,
              MPI_COMM_WORLD, &s.request);
  }
  void forget_sent() {
    for (auto s = sending.begin(); s != sending.end();) {
      int done = 0;
      MPI_Test(&s->request, &done, MPI_STATUS_IGNORE);
      s = done != 0 ? sending.erase(s) : std::next(s);
    }
  }
};

Ranks::Ranks(int size) : state_(new State) {
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  state_->ranks.resize(static_cast<std::size_t>(size));
}
Ranks::~Ranks() {
  // Messages to silent ranks may still be read by MPI: their memory stays.
  if (state_->sending.empty()) delete state_;
}

shop::RunResult Ranks::run(const scenarios::Scenario& scenario, std::uint64_t first, std::int64_t count,
                           const shop::Progress& progress) {
  State& s = *state_;
  const std::string text =
      scenarios::to_json(models::write_fields(&scenario, scenarios::scenario_fields())).dump();
  const auto n = static_cast<std::size_t>(count);
  shop::RunResult result;
  result.kpis = shop::kpi_infos(scenario);
  result.values.resize(n);
  result.courses.resize(n);
  std::vector<bool> done(n, false);
  std::vector<std::uint64_t> events(n, 0);
  std::size_t finished = 0;
  std::deque<std::size_t> open;
  for (std::size_t k = 0; k < n; ++k) open.push_back(k);
  const std::uint64_t oldest = s.next_number;  // answers of earlier runs are only signs of life

  while (finished < n) {
    s.forget_sent();
    std::string m;
    int source = 0;
    int tag = 0;
    bool moved = false;
    while (receive(MPI_ANY_SOURCE, result_tag, m, source, tag)) {
      moved = true;
      State::Rank& rank = s.ranks[static_cast<std::size_t>(source)];
      const auto head = head_of<ResultHead>(m);
      rank.silent = false;
      if (rank.number != head.number) continue;
      rank.busy = false;
      if (head.number < oldest) continue;
      s.longest_s = std::max(s.longest_s, std::chrono::duration<double>(Clock::now() - rank.since).count());
      if (done[rank.index]) continue;  // somebody else was asked meanwhile
      if (head.failed != 0) throw std::runtime_error(m.substr(sizeof head));
      auto& values = result.values[rank.index];
      values.resize(result.kpis.size());
      for (std::size_t k = 0; k < values.size() && sizeof head + (k + 1) * sizeof(double) <= m.size(); ++k) {
        double value = 0;
        std::memcpy(&value, m.data() + sizeof head + k * sizeof value, sizeof value);
        if (!std::isnan(value)) values[k] = value;
      }
      events[rank.index] = head.events;
      result.courses[rank.index] = head.course;
      done[rank.index] = true;
      ++finished;
      if (progress) progress(static_cast<std::int64_t>(finished), count);
    }
    const double patience = std::max(patience_s, patience_factor * s.longest_s);
    bool anybody = false;
    for (std::size_t r = 1; r < s.ranks.size(); ++r) {
      State::Rank& rank = s.ranks[r];
      if (rank.busy && !rank.silent &&
          std::chrono::duration<double>(Clock::now() - rank.since).count() > patience) {
        rank.silent = true;
        if (rank.number >= oldest && !done[rank.index]) open.push_front(rank.index);
      }
      anybody = anybody || !rank.silent;
      if (rank.busy || rank.silent) continue;
      while (!open.empty() && done[open.front()]) open.pop_front();
      if (open.empty()) continue;
      rank.busy = true;
      rank.index = open.front();
      rank.number = s.next_number++;
      rank.since = Clock::now();
      open.pop_front();
      s.send(r, task_tag, message(TaskHead{rank.number, first + rank.index}, text.data(), text.size()));
      moved = true;
    }
    if (!anybody && !open.empty()) {
      // All alone: the work is done here.
      const std::size_t index = open.front();
      open.pop_front();
      if (done[index]) continue;
      const shop::RunResult one = shop::run_replications(scenario, first + index, 1, 1);
      result.values[index] = one.values.front();
      events[index] = one.events;
      result.courses[index] = one.courses.front();
      done[index] = true;
      ++finished;
      if (progress) progress(static_cast<std::int64_t>(finished), count);
      continue;
    }
    if (!moved) {
      // Ctrl-C is noticed while the ranks work.
      if (progress) progress(static_cast<std::int64_t>(finished), count);
      std::this_thread::sleep_for(nap);
    }
  }
  std::vector<std::optional<double>> column(n);
  for (std::size_t k = 0; k < result.kpis.size(); ++k) {
    for (std::size_t r = 0; r < n; ++r) column[r] = result.values[r][k];
    result.estimates.push_back(shop::estimate(column));
  }
  for (const std::uint64_t e : events) result.events += e;
  return result;
}

bool Ranks::stop() {
  State& s = *state_;
  bool all = true;
  for (std::size_t r = 1; r < s.ranks.size(); ++r) {
    all = all && !s.ranks[r].silent;
    if (!s.ranks[r].silent) s.send(r, stop_tag, {});
  }
  for (int k = 0; k < 10'000 && !s.sending.empty(); ++k) {
    s.forget_sent();
    std::this_thread::sleep_for(nap);
  }
  return all && s.sending.empty();
}

void serve_rank_0() {
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  std::string known;
  scenarios::Scenario scenario;
  for (;;) {
    std::string m;
    int source = 0;
    int tag = 0;
    if (!receive(0, MPI_ANY_TAG, m, source, tag)) {
      std::this_thread::sleep_for(nap);
      continue;
    }
    if (tag == stop_tag) return;
    const auto head = head_of<TaskHead>(m);
    std::string answer;
    try {
      if (m.compare(sizeof head, std::string::npos, known) != 0) {
        known = m.substr(sizeof head);
        scenario = scenarios::load(scenarios::parse_json(known));
      }
      const shop::RunResult run = shop::run_replications(scenario, head.replication, 1, 1);
      std::vector<double> values;
      for (const auto& value : run.values.front())
        values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
      answer = message(ResultHead{head.number, run.events, run.courses.front(), 0}, values.data(),
                       values.size() * sizeof(double));
    } catch (const std::exception& e) {
      known.clear();
      answer = message(ResultHead{head.number, 0, 0, 1}, e.what(), std::strlen(e.what()));
    }
    MPI_Send(answer.data(), static_cast<int>(answer.size()), MPI_BYTE, 0, result_tag, MPI_COMM_WORLD);
  }
}

}  // namespace verstat::app
