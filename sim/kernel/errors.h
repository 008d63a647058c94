#pragma once
// What can go wrong in a simulation, as types a caller can tell apart.

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace verstat::sim {

/// The simulation was used in a way that cannot be right (negative delay, a process that interrupts itself).
/// The message names the object, the value and what is allowed.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The model asks for more than it was granted: events, or memory. No fault of the program.
class BudgetError : public SimulationError {
 public:
  using SimulationError::SimulationError;
};

/// An exception that escaped from a process, as it leaves Simulation::run().
/// The original exception is nested: std::rethrow_if_nested gives it back.
class ProcessError : public std::runtime_error, public std::nested_exception {
 public:
  ProcessError(const std::string& message, std::string process, double time)
      : std::runtime_error(message), process_(std::move(process)), time_(time) {}

  /// Name of the process that failed.
  [[nodiscard]] const std::string& process() const noexcept { return process_; }
  /// Simulated time of the failure, in the time unit of the model.
  [[nodiscard]] double time() const noexcept { return time_; }

 private:
  std::string process_;
  double time_;
};

/// Why a process was interrupted: a number for programs, a text for people.
class Reason {
 public:
  Reason() = default;
  Reason(const char* text) : text_(text) {}             // NOLINT: reads as interrupt("breakdown")
  Reason(std::string text) : text_(std::move(text)) {}  // NOLINT
  Reason(int code, std::string text) : code_(code), text_(std::move(text)) {}

  [[nodiscard]] int code() const noexcept { return code_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

  /// Code of the reason a pre-empted holder of a resource gets.
  static constexpr int preempted = -1;

 private:
  int code_ = 0;
  std::string text_;
};

/// Thrown out of the wait of a process that another one interrupted.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(Reason reason) : reason_(std::move(reason)), what_("interrupted: " + reason_.text()) {}
  [[nodiscard]] const Reason& reason() const noexcept { return reason_; }
  [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

 private:
  Reason reason_;
  std::string what_;
};

}  // namespace verstat::sim
