// verstat serve: the pages and the REST interface over a results database.
#include <charconv>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "app/cli.h"
#include "app/version.h"
#include "models/catalogue/shortened.h"
#include "store/database.h"
#include "web-ui/server/http.h"
#include "web-ui/server/jobs.h"
#include "web-ui/server/site.h"

namespace verstat::app {

namespace {

constexpr std::size_t shortest_token = 16;
constexpr std::uint64_t largest_body_bytes = 4U << 20U;  // a scenario of a large plant

std::uint16_t port_of(const std::string& text) {
  std::uint16_t port = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || stop != text.data() + text.size())
    throw UsageError(fmt::format("--port {}: must be a whole number from 0 (any free port) to 65535",
                                 models::shortened(text, 100)));
  return port;
}

void check_token(const std::string& token) {
  if (token.empty()) return;
  const bool plain =
      token.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~") ==
      std::string::npos;
  if (token.size() < shortest_token || !plain)
    throw UsageError(
        fmt::format("--token: must be at least {} letters, digits or -._~ (openssl rand -hex 16 makes one)",
                    shortest_token));
}

void serve(const std::string& db, const std::string& host_text, const std::string& port_text,
           const std::string& token, bool read_only) {
  const std::string host = host_text == "localhost" ? "127.0.0.1" : host_text;
  const std::uint16_t port = port_of(port_text);
  bool loopback = false;
  try {
    loopback = web::is_loopback(host);
  } catch (const std::invalid_argument& e) {
    throw UsageError(fmt::format("--host: {}", e.what()));
  }
  check_token(token);
  if (!loopback && token.empty())
    throw UsageError(
        fmt::format("--host {}: other machines can reach this address, so a --token is needed", host));
  // The first page tells whoever begins how to; it needs a database to say so.
  if (!read_only && !std::filesystem::exists(db)) static_cast<void>(store::Writer(db));
  static_cast<void>(
      store::Reader(db).run_count());  // an unreadable database is said now, not on the first page

  // Jobs run this very program; the link leads to it also when the file has been replaced since.
  auto jobs = read_only ? nullptr : std::make_shared<web::Jobs>("/proc/self/exe");
  // Studies say how far they are in a form for programs.
  const web::Site site(web::Api(db, VERSTAT_VERSION, jobs, {"--progress", "json"}), web::pages());
  web::Guard guard;  // filled in once the port is known, before the first request
  web::HttpServer server({.address = host, .port = port, .body_bytes = largest_body_bytes},
                         [&](const web::Request& request) { return site.answer(guard, request); });
  guard = web::guard_for(host, loopback, server.port(), token);

  const bool v6 = host.find(':') != std::string::npos;
  fmt::print("http://{}{}{}:{}/{}\n", v6 ? "[" : "", host, v6 ? "]" : "", server.port(),
             token.empty() ? "" : "?token=" + token);
  std::fflush(stdout);
  fmt::print(stderr, "serving {}{}{}; Ctrl-C ends it\n", db, read_only ? " read-only" : "",
             web::pages().empty() ? " without pages (built with VERSTAT_WEB=OFF), the API alone" : "");
  server.run(true);
}

}  // namespace

void add_serve(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto host = std::make_shared<std::string>("127.0.0.1");
  auto port = std::make_shared<std::string>("8080");
  auto token = std::make_shared<std::string>();
  auto read_only = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("serve", "Show runs, studies and models in the browser");
  add_db(*command, *options);
  command->add_option("--host", *host, "address to listen on; others than this machine's own need --token")
      ->capture_default_str();
  command->add_option("--port", *port, "port to listen on, 0 for any free one")->capture_default_str();
  command
      ->add_option("--token", *token,
                   "secret that every request must bring (or VERSTAT_TOKEN, which process lists do not show)")
      ->envname("VERSTAT_TOKEN");
  command->add_flag("--read-only", *read_only, "start and store nothing: no jobs, no notes");
  command->footer("Example:\n  verstat serve --db verstat.db --port 8080");
  command->callback([=] { serve(options->db, *host, *port, *token, *read_only); });
}

}  // namespace verstat::app
