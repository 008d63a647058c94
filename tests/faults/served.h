#pragma once
// `verstat serve` as a process of its own, and what the system says about a process.

#include <chrono>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include <dirent.h>
#include <unistd.h>

#include "tests/e2e/command.h"
#include "tests/faults/program.h"
#include "tests/web/client.h"

namespace verstat::test {

/// Seconds of processor that a living process has had, its own threads together.
inline double processor_s(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(in, text);
  const auto name_end = text.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream rest(text.substr(name_end + 1));
  std::string skipped;
  for (int k = 0; k < 11; ++k) rest >> skipped;
  double user = 0;
  double system = 0;
  rest >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Seconds that the first thread of a process has stood ready while others had the processors.
inline double queued_s(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/schedstat");
  double ran_ns = 0;
  double waited_ns = 0;
  in >> ran_ns >> waited_ns;
  return 1e-9 * waited_ns;
}

/// A line of /proc/PID/status in its unit: "VmRSS" in kB, "Threads".
inline long status_of(pid_t process, const std::string& name) {
  std::ifstream in("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ":")) return std::stol(line.substr(name.size() + 1));
  return -1;
}

inline std::size_t descriptors_of(pid_t process) {
  DIR* const folder = ::opendir(("/proc/" + std::to_string(process) + "/fd").c_str());
  if (folder == nullptr) return 0;
  std::size_t count = 0;
  while (const dirent* entry = ::readdir(folder)) count += entry->d_name[0] == '.' ? 0 : 1;
  ::closedir(folder);
  return count;
}

/// A server on a free port; killed at the end unless it has ended before.
class Served {
 public:
  /// `before` stands in front of the program, as "LD_PRELOAD=...".
  Served(const std::string& db, const std::string& flags, const std::string& said,
         const std::string& before = "") {
    std::filesystem::remove(said);  // of the one before
    process_ = ::fork();
    if (process_ == 0) {
      ::setpgid(0, 0);
      const std::string line = before + " exec " + std::string(VERSTAT_PROGRAM) + " serve --port 0 --db " +
                               db + " " + flags + " >" + said + " 2>&1 </dev/null";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
    for (int k = 0; k < 2000 && port_ == 0; ++k) {
      const std::string text = read_file(said);
      const std::string mark = "http://127.0.0.1:";
      const auto at = text.find(mark);
      if (at != std::string::npos && text.find('\n', at) != std::string::npos)
        port_ = static_cast<std::uint16_t>(std::stoi(text.substr(at + mark.size())));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;
  ~Served() { end(SIGKILL); }

  /// 0 when it did not come up.
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] pid_t process() const { return process_; }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port_); }
  /// Exit code, or 128 + signal; -1 when it has ended before.
  int end(int signal) {
    if (process_ <= 0) return -1;
    ::kill(process_, signal);
    const int code = ended(process_);
    process_ = -1;
    return code;
  }

  [[nodiscard]] std::string request(const std::string& method, const std::string& target,
                                    const std::string& body = "", const std::string& more = "") const {
    std::string text = method + " " + target + " HTTP/1.1\r\nHost: " + host() + "\r\n" + more;
    if (method != "GET" && method != "HEAD")
      text +=
          "X-Verstat: 1\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
          "\r\n";
    return text + "\r\n" + body;
  }
  [[nodiscard]] web_test::Answer ask(const std::string& method, const std::string& target,
                                     const std::string& body = "",
                                     const std::string& more = "Connection: close\r\n") const {
    const web_test::Socket socket(port_);
    socket.send(request(method, target, body, more));
    return web_test::parse_answer(socket.read_all());
  }
  [[nodiscard]] web_test::Answer get(const std::string& target) const { return ask("GET", target); }

 private:
  pid_t process_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace verstat::test
