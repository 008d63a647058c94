#pragma once
// A server over a real socket for tests.

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/store/example_results.h"
#include "tests/web/client.h"
#include "web-ui/server/http.h"
#include "web-ui/server/site.h"

namespace verstat::web_test {

using nlohmann::json;
using test::example_run;

inline constexpr int run_count = 7;

inline constexpr web::Asset test_pages[] = {
    {"/index.html", "text/html; charset=utf-8", "aaaa", false, "<p>plain</p>", "gzipped"},
    {"/assets/x-1.js", "text/javascript; charset=utf-8", "bbbb", true, "1;", ""}};

/// A database of runs and one study, and a server on a free port, ended with the test.
class Serving {
 public:
  /// With a `script` (of the shell) jobs are started by it in place of the program.
  explicit Serving(web::HttpOptions options = {}, const std::string& token = "",
                   const std::string& script = "")
      : folder_(std::filesystem::temp_directory_path() / fmt::format("verstat-web-{}", ::getpid())) {
    std::filesystem::create_directories(folder_);
    std::filesystem::remove(file());
    {
      store::Writer writer(file());
      for (int k = 1; k <= run_count; ++k) writer.add_run(example_run(k));
      test::add_example_study(writer, "finished");
    }
    options.port = 0;
    std::filesystem::remove(file().string() + ".notes");
    std::shared_ptr<web::Jobs> jobs;
    if (!script.empty()) {
      const auto program = folder_ / "program.sh";
      std::ofstream(program) << "#!/bin/sh\n" << script;
      std::filesystem::permissions(program, std::filesystem::perms::owner_all);
      jobs = std::make_shared<web::Jobs>(program);
    }
    site_.emplace(web::Api(file(), "9.9", jobs), test_pages);
    server_.emplace(options, [this](const web::Request& request) { return site_->answer(guard_, request); });
    guard_ = web::guard_for("127.0.0.1", true, server_->port(), token);
    thread_ = std::jthread([this] { server_->run(false); });
  }
  Serving(const Serving&) = delete;
  Serving& operator=(const Serving&) = delete;
  ~Serving() {
    server_->stop();
    thread_.join();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "results.db"; }
  [[nodiscard]] std::uint16_t port() const { return server_->port(); }
  [[nodiscard]] std::string host() const { return fmt::format("127.0.0.1:{}", port()); }

  [[nodiscard]] Answer raw(const std::string& text) const {
    const Socket socket(port());
    socket.send(text);
    return parse_answer(socket.read_all());
  }
  [[nodiscard]] Answer get(const std::string& target, const std::string& more = "",
                           const std::string& method = "GET") const {
    return raw(fmt::format("{} {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{}\r\n", method, target,
                           host(), more));
  }
  [[nodiscard]] Answer post(const std::string& target, const std::string& body,
                            const std::string& more = "X-Verstat: 1\r\nContent-Type: application/json\r\n",
                            const std::string& method = "POST") const {
    return raw(
        fmt::format("{} {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{}Content-Length: {}\r\n\r\n{}",
                    method, target, host(), more, body.size(), body));
  }

 private:
  std::filesystem::path folder_;
  web::Guard guard_;
  std::optional<web::Site> site_;
  std::optional<web::HttpServer> server_;
  std::jthread thread_;
};

}  // namespace verstat::web_test
