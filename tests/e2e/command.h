#pragma once
// Runs the program as a user would and keeps what it said.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace verstat::test {

struct Answer {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A folder of its own, removed at the end.
class Workspace {
 public:
  Workspace() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("verstat-e2e-" + std::to_string(::getpid()) + "-" + std::to_string(++number));
    std::filesystem::create_directories(path_);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  ~Workspace() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

inline std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// `arguments` as typed in a shell, from the root of the tree.
/// `before`: what stands in front of the program, as "timeout 20".
inline Answer call(const std::string& arguments, const std::string& before = "") {
  static const Workspace workspace;
  const std::string err_file = workspace.file("stderr");
  // Mutation testing puts another program in its place.
  const char* other = std::getenv("VERSTAT_PROGRAM");
  const std::string line = before + " " + std::string(other != nullptr ? other : VERSTAT_PROGRAM) + " " +
                           arguments + " 2>" + err_file + " </dev/null";
  Answer answer;
  std::FILE* pipe = ::popen(line.c_str(), "r");
  std::array<char, 65536> block{};
  std::size_t got = 0;
  while ((got = std::fread(block.data(), 1, block.size(), pipe)) > 0) answer.out.append(block.data(), got);
  const int status = ::pclose(pipe);
  answer.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  answer.err = read_file(err_file);
  return answer;
}

}  // namespace verstat::test
