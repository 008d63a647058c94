#pragma once
// What happened in one replication, event by event: for the Gantt chart, for other programs, for doubters.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/shop/costs.h"
#include "sim/shop/state_clock.h"

namespace verstat::shop {

class Trace {
 public:
  struct StateChange {
    std::size_t machine;
    double at_min;
    MachineState state;  ///< from then on
  };
  struct PartStep {
    std::size_t part;  ///< part type
    std::size_t step;  ///< of its route
    std::size_t machine;
    double at_min;
  };
  struct QueueLength {
    std::size_t group;
    double at_min;
    std::size_t waiting;  ///< from then on
  };
  struct Finished {
    std::size_t part;
    double arrived_min;
    double finished_min;
  };

  /// Some hands of a crew at one job. A job under way at the end of the warm-up comes in two pieces.
  struct CrewWork {
    std::size_t crew;
    std::int64_t hands;
    Cost heading;  ///< what their wage is booked under
    std::optional<std::size_t> machine;
    double from_min;
    double to_min;
  };

  void machine_state(std::size_t machine, double at_min, MachineState state) {
    states_.push_back({machine, at_min, state});
  }
  void part_step(std::size_t part, std::size_t step, std::size_t machine, double at_min) {
    part_steps_.push_back({part, step, machine, at_min});
  }
  void queue_length(std::size_t group, double at_min, std::size_t waiting) {
    queues_.push_back({group, at_min, waiting});
  }
  void part_finished(std::size_t part, double arrived_min, double finished_min) {
    finished_.push_back({part, arrived_min, finished_min});
  }
  /// A tool of the scenario on a machine: an edge was taken out after `life_min` of cutting.
  void edge_removed(std::size_t tool, std::size_t machine, double at_min, double life_min, bool failed) {
    edges_.push_back({tool, machine, at_min, life_min, failed});
  }

  void crew_work(const CrewWork& work) { crew_work_.push_back(work); }

  struct EdgeRemoved {
    std::size_t tool;
    std::size_t machine;
    double at_min;
    double life_min;
    bool failed;
  };
  [[nodiscard]] const std::vector<StateChange>& states() const { return states_; }
  [[nodiscard]] const std::vector<PartStep>& part_steps() const { return part_steps_; }
  [[nodiscard]] const std::vector<QueueLength>& queues() const { return queues_; }
  [[nodiscard]] const std::vector<Finished>& finished() const { return finished_; }
  [[nodiscard]] const std::vector<EdgeRemoved>& edges() const { return edges_; }
  /// In the order in which the pieces ended.
  [[nodiscard]] const std::vector<CrewWork>& crew_work() const { return crew_work_; }

 private:
  std::vector<StateChange> states_;
  std::vector<PartStep> part_steps_;
  std::vector<QueueLength> queues_;
  std::vector<Finished> finished_;
  std::vector<EdgeRemoved> edges_;
  std::vector<CrewWork> crew_work_;
};

}  // namespace verstat::shop
