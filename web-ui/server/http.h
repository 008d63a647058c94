#pragma once
// The socket side: HTTP/1.1 on Boost.Beast, which only http.cpp includes.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "web-ui/server/message.h"

namespace verstat::web {

struct HttpOptions {
  std::string address = "127.0.0.1";  ///< numeric
  std::uint16_t port = 8080;          ///< 0: any free one
  int threads = 2;
  /// Beyond them a new connection takes the place of the one that has waited longest for its client; when
  /// none waits it is hung up on.
  std::size_t most_connections = 256;
  std::size_t most_streams = 48;  ///< of them event streams, which stay open
  std::size_t header_bytes = 16U << 10U;
  std::uint64_t body_bytes = 1U << 20U;
  std::chrono::milliseconds idle_timeout{30'000};     ///< until the first byte of a request
  std::chrono::milliseconds read_timeout{10'000};     ///< from its first to its last byte
  std::chrono::milliseconds write_timeout{30'000};    ///< for a whole answer, or one piece of a stream
  std::chrono::milliseconds stream_pause{150};        ///< between two looks for news
  std::chrono::milliseconds stream_heartbeat{5'000};  ///< silence after which a comment shows a gone client
};

/// True for 127.0.0.0/8 and ::1. Throws std::invalid_argument when `address` is no numeric address.
[[nodiscard]] bool is_loopback(const std::string& address);

class HttpServer {
 public:
  using Handler = std::function<Response(const Request&)>;

  /// Binds and listens. `handler` answers complete, size-checked requests; it must not throw and may be
  /// called from `threads` threads at once. Throws std::runtime_error naming address and port when they
  /// cannot be had.
  HttpServer(const HttpOptions& options, Handler handler);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  /// The port, also when 0 was asked for.
  [[nodiscard]] std::uint16_t port() const;
  /// Serves until `stop`; with `until_signal` also until SIGINT or SIGTERM. Handlers under way are
  /// finished, then every connection is dropped.
  void run(bool until_signal);
  /// Ends `run`. May be called from any thread.
  void stop();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace verstat::web
