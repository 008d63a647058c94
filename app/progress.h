#pragma once
// Progress on standard error: a bar on a terminal, plain lines otherwise, nothing with --json to a file.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace verstat::app {

class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();
  /// Not thread safe: the caller serialises. `best`: the best value so far, shown when there is one.
  void update(std::int64_t done, std::int64_t of, const std::optional<double>& best = {});

 private:
  std::string what_;
  bool terminal_;
  bool open_ = false;  // a bar is on the line
  int tenth_ = 0;      // plain lines: one per tenth
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace verstat::app
