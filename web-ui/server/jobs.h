#pragma once
// Work that takes longer than a request: simulations and studies, each in a child process of the same
// program, one after the other (the database has one writer). A crash or a cancel of a child never hurts the
// server.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "web-ui/server/message.h"

namespace verstat::web {

enum class JobState { queued, running, finished, failed, cancelled };
[[nodiscard]] std::string_view to_string(JobState state);

/// What to start.
struct JobSpec {
  std::string kind;                          ///< "run", "study", "again", "trace", "losses", "resume", "fit"
  std::string title;                         ///< for people
  bool lengthy = false;                      ///< queued among studies, which take hours
  std::vector<std::string> arguments;        ///< of the program; file names are those of `files`
  std::map<std::string, std::string> files;  ///< name and text, written into the job's own folder
  bool keep_output = false;                  ///< what the child prints can be had afterwards
  /// Turns the child's standard output into the job's result (JSON text). Runs on the queue's thread once the
  /// child has ended well; an exception fails the job with its text.
  std::function<std::string(const std::string& output)> finish;
};

/// How a job stands.
struct JobStatus {
  std::int64_t id = 0;
  std::string kind;
  std::string title;
  JobState state = JobState::queued;
  std::string stage;                 ///< what the child says it is doing, "replications"
  std::optional<std::int64_t> done;  ///< of that
  std::optional<std::int64_t> of;
  std::optional<double> left_s;  ///< as the child estimates
  std::optional<double> best;    ///< of a study so far
  std::string message;           ///< why it failed
  std::string result;            ///< JSON text when finished
  double elapsed_s = 0;          ///< since the child was started
  std::int64_t version = 0;      ///< grows with every change
  /// What the child has printed, of the `most_outputs` newest jobs that keep it; else null.
  std::shared_ptr<const std::string> output;

  [[nodiscard]] bool over() const {
    return state == JobState::finished || state == JobState::failed || state == JobState::cancelled;
  }
};

/// Takes what a child wrote to standard error, a line: {"done": 3, "of": 20, ...} or
/// "replications: 3 of 20, 5 s left". False when the line is neither.
bool read_progress(const std::string& line, JobStatus& status);

class Jobs {
 public:
  static constexpr std::size_t most_waiting = 20;
  static constexpr std::size_t most_kept = 200;
  static constexpr std::size_t most_outputs = 3;

  /// `program` is started for every job with the job's arguments.
  explicit Jobs(std::filesystem::path program);
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  /// Ends the child under way.
  ~Jobs();

  /// The id of the job; none when `most_waiting` are waiting already.
  std::optional<std::int64_t> submit(JobSpec spec);
  /// Newest first.
  [[nodiscard]] std::vector<JobStatus> list() const;
  [[nodiscard]] std::optional<JobStatus> find(std::int64_t id) const;
  /// Asks the job to end: a child gets an interrupt, and five seconds later no choice. False when there is no
  /// such job or it is over.
  bool cancel(std::int64_t id);
  /// `write` turns a status into the data of an event. The stream ends after the status that is the last.
  /// Null when there is no such job.
  [[nodiscard]] std::shared_ptr<EventStream> events(std::int64_t id,
                                                    std::function<std::string(const JobStatus&)> write) const;

 private:
  class Queue;
  std::shared_ptr<Queue> queue_;
};

}  // namespace verstat::web
