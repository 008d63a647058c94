#include "web-ui/server/jobs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <fstream>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace verstat::web {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds grace{5};
constexpr int poll_ms = 50;
// What a child prints is an answer of the command line; a larger one is not kept.
constexpr std::size_t most_output = 256U << 20U;  // a year of sixty machines takes 90 MB
constexpr std::size_t longest_line = 64U << 10U;
// Below the server: pages must answer while a study has all cores.
constexpr int child_niceness = 5;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder of its own, gone with the job.
class Folder {
 public:
  Folder() {
    std::string path = (std::filesystem::temp_directory_path() / "verstat-job-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr)
      throw std::runtime_error(fmt::format("cannot make a folder {}: {}", path, std::strerror(errno)));
    path_ = path;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream out(path_ / name, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw std::runtime_error(fmt::format("cannot write {} of the job (disk full?)", name));
  }

 private:
  std::filesystem::path path_;
};

class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { reset(); }
  void reset(int value = -1) {
    if (value_ >= 0) ::close(value_);
    value_ = value;
  }
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    read.reset(ends[0]);
    write.reset(ends[1]);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  Descriptor read;
  Descriptor write;
};

/// The program, started in a folder and a process group of its own.
class Child {
 public:
  Child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
        const std::filesystem::path& folder) {
    std::vector<std::string> words = {program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out_.write.get(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err_.write.get(), STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    // The server's sockets are not the child's business: it would hold the port beyond the server's end.
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    // The server's threads may block signals; a child that cannot be interrupted would have to be killed.
    sigset_t none;
    sigemptyset(&none);
    sigset_t defaults;
    sigemptyset(&defaults);
    for (const int s : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&defaults, s);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int error = ::posix_spawn(&process_, program.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0)
      throw std::runtime_error(fmt::format("cannot start {}: {}", program.string(), std::strerror(error)));
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(process_), child_niceness);
    out_.write.reset();
    err_.write.reset();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ > 0) {
      signal(SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
  }
  void signal(int number) const { ::kill(-process_, number); }
  /// Reads what has come within `poll_ms`. False when the child has closed both ends.
  bool read(std::string& out, std::string& err) {
    std::array<pollfd, 2> ends{pollfd{out_.read.get(), POLLIN, 0}, pollfd{err_.read.get(), POLLIN, 0}};
    ::poll(ends.data(), ends.size(), poll_ms);
    const bool more_out = drain(out_.read, out);
    const bool more_err = drain(err_.read, err);
    return more_out || more_err;
  }
  /// Exit code, or 128 and the number of the signal that ended it.
  int wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  static bool drain(Descriptor& from, std::string& to) {
    if (from.get() < 0) return false;
    std::array<char, 16384> piece{};
    for (;;) {
      const auto size = ::read(from.get(), piece.data(), piece.size());
      if (size > 0) {
        to.append(piece.data(), static_cast<std::size_t>(size));
        continue;
      }
      if (size < 0 && (errno == EAGAIN || errno == EINTR)) return true;
      from.reset();
      return false;
    }
  }
  Pipe out_;
  Pipe err_;
  pid_t process_ = -1;
};

}  // namespace

std::string_view to_string(JobState state) {
  switch (state) {
    case JobState::queued:
      return "queued";
    case JobState::running:
      return "running";
    case JobState::finished:
      return "finished";
    case JobState::failed:
      return "failed";
    case JobState::cancelled:
      return "cancelled";
  }
  return "failed";
}

bool read_progress(const std::string& line, JobStatus& status) {
  if (line.starts_with("{")) {
    const nlohmann::json j = nlohmann::json::parse(line, nullptr, false);
    if (!j.is_object()) return false;
    const auto number = [&](std::initializer_list<const char*> names) -> std::optional<double> {
      for (const char* name : names)
        if (j.contains(name) && j[name].is_number()) return j[name].get<double>();
      return std::nullopt;
    };
    const auto done = number({"done", "trials"});
    if (!done) return false;
    status.done = static_cast<std::int64_t>(*done);
    const auto of = number({"of", "budget"});
    status.of = of ? std::optional(static_cast<std::int64_t>(*of)) : std::nullopt;
    status.left_s = number({"left_s", "time_left_s"});
    status.best = number({"best"});
    for (const char* name : {"stage", "what"})
      if (j.contains(name) && j[name].is_string()) status.stage = j[name].get<std::string>();
    return true;
  }
  const auto colon = line.rfind(": ");
  if (colon == std::string::npos) return false;
  long long done = 0;
  long long of = 0;
  double left_s = 0;
  double best = 0;
  const char* rest = line.c_str() + colon;
  const bool with_best =
      std::sscanf(rest, ": %lld of %lld, best %lf %lf s left", &done, &of, &best, &left_s) == 4;
  if (!with_best && std::sscanf(rest, ": %lld of %lld, %lf s left", &done, &of, &left_s) != 3) return false;
  status.best = with_best ? std::optional(best) : std::nullopt;
  status.stage = line.substr(0, colon);
  status.done = done;
  status.of = of;
  status.left_s = left_s;
  return true;
}

// Shared with the event streams, which may outlive the server's front by a moment.
class Jobs::Queue {
 public:
  explicit Queue(std::filesystem::path program) : program_(std::move(program)) {}

  void start() {
    for (std::size_t lane = 0; lane < threads_.size(); ++lane)
      threads_[lane] = std::thread([this, lane] { work(lane); });
  }
  void end() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  std::optional<std::int64_t> submit(JobSpec spec) {
    const std::lock_guard lock(mutex_);
    std::deque<std::int64_t>& waiting = waiting_[spec.lengthy ? 1 : 0];
    if (waiting.size() >= most_waiting) return std::nullopt;
    const std::int64_t id = next_++;
    Job& job = jobs_[id];
    job.status = {.id = id, .kind = spec.kind, .title = spec.title, .version = 1};
    job.spec = std::move(spec);
    waiting.push_back(id);
    // The oldest that are over make room.
    for (auto old = jobs_.begin(); jobs_.size() > most_kept && old != jobs_.end();)
      old = old->second.status.over() ? jobs_.erase(old) : std::next(old);
    wake_.notify_all();
    return id;
  }

  std::vector<JobStatus> list() const {
    const std::lock_guard lock(mutex_);
    std::vector<JobStatus> all;
    for (auto job = jobs_.rbegin(); job != jobs_.rend(); ++job) all.push_back(seen(job->second));
    return all;
  }

  std::optional<JobStatus> find(std::int64_t id) const {
    const std::lock_guard lock(mutex_);
    const auto job = jobs_.find(id);
    if (job == jobs_.end()) return std::nullopt;
    return seen(job->second);
  }

  bool cancel(std::int64_t id) {
    const std::lock_guard lock(mutex_);
    const auto job = jobs_.find(id);
    if (job == jobs_.end() || job->second.status.over()) return false;
    job->second.cancelled = true;
    if (job->second.status.state == JobState::queued) {
      for (auto& lane : waiting_) std::erase(lane, id);
      job->second.status.state = JobState::cancelled;
      ++job->second.status.version;
    }
    return true;
  }

 private:
  struct Job {
    JobStatus status;
    JobSpec spec;
    bool cancelled = false;
    Clock::time_point start{};
  };

  static JobStatus seen(const Job& job) {
    JobStatus status = job.status;
    if (status.state == JobState::running) status.elapsed_s = seconds_since(job.start);
    return status;
  }

  void work(std::size_t lane) {
    std::unique_lock lock(mutex_);
    while (true) {
      wake_.wait(lock, [&] { return ending_ || !waiting_[lane].empty(); });
      if (ending_) return;
      const std::int64_t id = waiting_[lane].front();
      waiting_[lane].pop_front();
      Job& job = jobs_.at(id);  // stays: only jobs that are over are forgotten
      job.start = Clock::now();
      job.status.state = JobState::running;
      ++job.status.version;
      const JobSpec spec = std::move(job.spec);
      lock.unlock();
      JobState state = JobState::failed;
      std::string message;
      std::string result;
      std::string output;
      try {
        state = execute(id, spec, message, result, output);
      } catch (const std::exception& e) {
        message = e.what();
      }
      lock.lock();
      job.status.state = state;
      job.status.message = message;
      job.status.result = result;
      if (state == JobState::finished && spec.keep_output) {
        job.status.output = std::make_shared<const std::string>(std::move(output));
        std::size_t kept = 0;
        std::size_t bytes = 0;
        for (auto one = jobs_.rbegin(); one != jobs_.rend(); ++one) {
          auto& kept_output = one->second.status.output;
          if (!kept_output) continue;
          bytes += kept_output->size();
          if (++kept > most_outputs || (kept > 1 && bytes > most_output)) kept_output = nullptr;
        }
      }
      job.status.elapsed_s = seconds_since(job.start);
      ++job.status.version;
    }
  }

  JobState execute(std::int64_t id, const JobSpec& spec, std::string& message, std::string& result,
                   std::string& out) {
    const Folder folder;
    for (const auto& [name, text] : spec.files) folder.write(name, text);
    Child child(program_, spec.arguments, folder.path());
    std::string err;
    std::string last_words;
    std::optional<Clock::time_point> asked;
    bool killed = false;
    for (bool open = true; open;) {
      open = child.read(out, err);
      if (out.size() > most_output) out.resize(most_output + 1);
      listen(id, err, last_words);
      const bool stop = stopping(id);
      if (stop && !asked) {
        asked = Clock::now();
        child.signal(SIGINT);
      }
      if (asked && !killed && Clock::now() - *asked > grace) {
        killed = true;
        child.signal(SIGKILL);
      }
    }
    err += '\n';
    listen(id, err, last_words);
    const int code = child.wait();
    if (code != 0) {
      message = last_words.empty() ? fmt::format("the program ended with code {}", code) : last_words;
      // Nobody but the system or its administrator kills a job without being asked.
      if (code == 128 + SIGKILL && !asked)
        message =
            "the program was killed from outside, most likely because the memory of the machine ran out: "
            "fewer machines, replications or threads need less";
      return asked ? JobState::cancelled : JobState::failed;
    }
    if (out.size() > most_output)
      throw std::runtime_error(
          fmt::format("the answer is longer than the {} MiB that are kept; shorten /simulation/horizon_min",
                      most_output >> 20U));
    result = spec.finish ? spec.finish(out) : std::string();
    return JobState::finished;
  }

  /// Takes the whole lines out of what the child has said.
  void listen(std::int64_t id, std::string& err, std::string& last_words) {
    for (auto end = err.find('\n'); end != std::string::npos; end = err.find('\n')) {
      std::string line = err.substr(0, end);
      err.erase(0, end + 1);
      if (line.empty()) continue;
      const std::lock_guard lock(mutex_);
      JobStatus& status = jobs_.at(id).status;
      if (read_progress(line, status)) {
        ++status.version;
      } else {
        last_words = line.starts_with("error: ") ? line.substr(7) : line;
      }
    }
    if (err.size() > longest_line) err.clear();
  }

  bool stopping(std::int64_t id) const {
    const std::lock_guard lock(mutex_);
    return ending_ || jobs_.at(id).cancelled;
  }

  std::filesystem::path program_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<std::int64_t, Job> jobs_;
  std::array<std::deque<std::int64_t>, 2> waiting_;  // simulations, studies
  std::int64_t next_ = 1;
  bool ending_ = false;
  std::array<std::thread, 2> threads_;
};

Jobs::Jobs(std::filesystem::path program) : queue_(std::make_shared<Queue>(std::move(program))) {
  queue_->start();
}
Jobs::~Jobs() {
  queue_->end();
}
std::optional<std::int64_t> Jobs::submit(JobSpec spec) {
  return queue_->submit(std::move(spec));
}
std::vector<JobStatus> Jobs::list() const {
  return queue_->list();
}
std::optional<JobStatus> Jobs::find(std::int64_t id) const {
  return queue_->find(id);
}
bool Jobs::cancel(std::int64_t id) {
  return queue_->cancel(id);
}

std::shared_ptr<EventStream> Jobs::events(std::int64_t id,
                                          std::function<std::string(const JobStatus&)> write) const {
  class News final : public EventStream {
   public:
    News(std::shared_ptr<Queue> queue, std::int64_t id, std::function<std::string(const JobStatus&)> write)
        : queue_(std::move(queue)), id_(id), write_(std::move(write)) {}
    std::optional<std::string> next() override {
      if (over_) return std::nullopt;
      const auto status = queue_->find(id_);
      if (!status) return std::nullopt;
      if (status->version == version_) return std::string();
      version_ = status->version;
      over_ = status->over();
      return fmt::format("id: {}\nevent: job\ndata: {}\n\n", version_, write_(*status));
    }

   private:
    std::shared_ptr<Queue> queue_;
    std::int64_t id_;
    std::function<std::string(const JobStatus&)> write_;
    std::int64_t version_ = 0;
    bool over_ = false;
  };
  if (!queue_->find(id)) return nullptr;
  return std::make_shared<News>(queue_, id, std::move(write));
}

}  // namespace verstat::web
