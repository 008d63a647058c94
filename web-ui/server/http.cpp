#include "web-ui/server/http.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <csignal>
#include <list>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fmt/format.h>

namespace verstat::web {

namespace beast = boost::beast;
namespace http = beast::http;
namespace net = boost::asio;
using tcp = net::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t buffer_bytes = 64U << 10U;
// Unread input at a close makes the system send a reset, which can destroy the answer under way: after an
// early refusal this much is read and thrown away.
constexpr std::size_t drained_bytes = 4U << 20U;
constexpr std::chrono::seconds drain_timeout{2};
// Connections on their way out that do not count for a moment.
constexpr std::size_t most_leaving = 16;

Request request_of(const http::request<http::string_body>& message) {
  Request request;
  request.method = std::string(message.method_string());
  request.target = std::string(message.target());
  for (const auto& field : message) {
    std::string name(field.name_string());
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::string& value = request.headers[name];
    if (!value.empty()) value += ", ";
    value += std::string(field.value());
  }
  request.body = message.body();
  return request;
}

class Session;

/// Connections that wait for their clients, who have sent nothing yet or half a request: the longest first.
/// When all places are taken the first of them makes room, so that whoever hoards connections shuts nobody
/// out.
class WaitingRoom {
 public:
  using Place = std::list<std::weak_ptr<Session>>::iterator;

  Place enter(std::weak_ptr<Session> session) {
    const std::lock_guard lock(mutex_);
    return waiting_.insert(waiting_.end(), std::move(session));
  }
  void leave(Place place) {
    const std::lock_guard lock(mutex_);
    waiting_.erase(place);
  }
  /// The one that has waited longest and was not asked before; null when nobody waits.
  std::shared_ptr<Session> longest() {
    const std::lock_guard lock(mutex_);
    for (std::weak_ptr<Session>& one : waiting_)
      if (auto session = one.lock()) {
        one.reset();
        return session;
      }
    return nullptr;
  }

 private:
  std::mutex mutex_;
  std::list<std::weak_ptr<Session>> waiting_;
};

/// One connection: reads a request, answers it, reads the next. All its steps run on its strand.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, const HttpOptions& options, const HttpServer::Handler& handler,
          std::atomic<std::size_t>& open, std::atomic<std::size_t>& streams, WaitingRoom& room)
      : stream_(std::move(socket)),
        pause_(stream_.get_executor()),
        buffer_(buffer_bytes),
        options_(options),
        handler_(handler),
        open_(open),
        streams_(streams),
        room_(room) {
    open_.fetch_add(1);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() {
    come_back();
    open_.fetch_sub(1);
    if (events_) streams_.fetch_sub(1);
  }

  void start() {
    error_code ignored;
    // Small answers must not wait for the peer's delayed acknowledgement.
    stream_.socket().set_option(tcp::no_delay(true), ignored);
    net::dispatch(stream_.get_executor(), [self = shared_from_this()] { self->wait_for_request(); });
  }

  /// Its place is needed: hangs up if it still waits for the client. May be called from any thread.
  void make_room() {
    net::post(stream_.get_executor(), [self = shared_from_this()] {
      if (self->place_) self->close();
    });
  }

 private:
  void wait_for_client() {
    if (!place_) place_ = room_.enter(weak_from_this());
  }
  void come_back() {
    if (place_) room_.leave(*place_);
    place_.reset();
  }

  void wait_for_request() {
    wait_for_client();
    if (buffer_.size() > 0) return read_request();  // the next one has come with the last
    stream_.expires_after(options_.idle_timeout);
    stream_.async_read_some(buffer_.prepare(4096),
                            [self = shared_from_this()](error_code error, std::size_t size) {
                              if (error) return self->close();
                              self->buffer_.commit(size);
                              self->read_request();
                            });
  }

  void read_request() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(options_.header_bytes));
    parser_->body_limit(options_.body_bytes);
    stream_.expires_after(options_.read_timeout);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) { self->on_request(error); });
  }

  void on_request(error_code error) {
    come_back();
    if (!error) {
      const auto& message = parser_->get();
      const Request request = request_of(message);
      Response response = handled(request);
      const bool head = message.method() == http::verb::head;
      if (response.stream && !head) return send_stream(std::move(response), message.version());
      return send(std::move(response), message.keep_alive(), message.version(), head, false);
    }
    if (error == http::error::end_of_stream || error == http::error::partial_message) return close();
    if (error == http::error::body_limit)
      return refuse(413, fmt::format("the body is larger than the {} bytes allowed", options_.body_bytes));
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
      return refuse(431,
                    fmt::format("the header is larger than the {} bytes allowed", options_.header_bytes));
    if (error.category() == http::make_error_code(http::error::bad_method).category())
      return refuse(400, fmt::format("this is no HTTP request: {}", error.message()));
    close();  // timeout, reset: nobody is listening
  }

  // The handler promises not to throw; out of memory it may all the same, and one request must not end the
  // server.
  Response handled(const Request& request) {
    try {
      return handler_(request);
    } catch (const std::exception& e) {
      return error_response(500, e.what());
    }
  }

  void refuse(int status, const std::string& message) {
    send(error_response(status, message), false, 11, false, true);
  }

  void send(Response response, bool keep_alive, unsigned version, bool head, bool drain) {
    answer_.emplace(static_cast<http::status>(response.status), version);
    answer_->set(http::field::content_type, response.content_type);
    for (const auto& [name, value] : response.headers) answer_->set(name, value);
    answer_->keep_alive(keep_alive);
    const auto length = response.body.size();
    if (!head) answer_->body() = std::move(response.body);
    if (response.status != 304) answer_->content_length(length);
    stream_.expires_after(options_.write_timeout);
    http::async_write(stream_, *answer_,
                      [self = shared_from_this(), keep_alive, drain](error_code error, std::size_t) {
                        self->answer_.reset();
                        if (error || !keep_alive) {
                          if (!error && drain) return self->drain();
                          return self->close();
                        }
                        self->wait_for_request();
                      });
  }

  // An event stream: the header, then chunks as news comes, until the stream or the client ends.
  void send_stream(Response response, unsigned version) {
    if (version < 11) return refuse(400, "an event stream needs HTTP/1.1");
    if (streams_.fetch_add(1) >= options_.most_streams) {
      streams_.fetch_sub(1);
      return refuse(503, "too many event streams are open; close a page or ask for the state now and then");
    }
    events_ = std::move(response.stream);
    header_.emplace(static_cast<http::status>(response.status), 11U);
    header_->set(http::field::content_type, response.content_type);
    for (const auto& [name, value] : response.headers) header_->set(name, value);
    header_->keep_alive(false);
    header_->chunked(true);
    serializer_.emplace(*header_);
    stream_.expires_after(options_.write_timeout);
    http::async_write_header(stream_, *serializer_,
                             [self = shared_from_this()](error_code error, std::size_t) {
                               if (error) return self->close();
                               self->last_piece_ = std::chrono::steady_clock::now();
                               self->send_news();
                             });
  }

  void send_news() {
    std::optional<std::string> news = events_->next();
    const auto now = std::chrono::steady_clock::now();
    if (!news) {
      stream_.expires_after(options_.write_timeout);
      return net::async_write(stream_, http::make_chunk_last(),
                              [self = shared_from_this()](error_code, std::size_t) { self->close(); });
    }
    if (news->empty() && now - last_piece_ >= options_.stream_heartbeat) *news = ":\n\n";
    if (news->empty()) {
      stream_.expires_never();
      pause_.expires_after(options_.stream_pause);
      return pause_.async_wait([self = shared_from_this()](error_code error) {
        if (error) return self->close();
        self->send_news();
      });
    }
    last_piece_ = now;
    piece_ = std::move(*news);
    stream_.expires_after(options_.write_timeout);
    net::async_write(stream_, http::make_chunk(net::buffer(piece_)),
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (error) return self->close();
                       self->send_news();
                     });
  }

  void drain() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(drain_timeout);
    buffer_.clear();
    drain_some();
  }

  void drain_some() {
    stream_.async_read_some(buffer_.prepare(4096),
                            [self = shared_from_this()](error_code error, std::size_t size) {
                              self->drained_ += size;
                              if (error || self->drained_ > drained_bytes) return self->close();
                              self->drain_some();
                            });
  }

  void close() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_both, ignored);
    stream_.close();
  }

  beast::tcp_stream stream_;
  net::steady_timer pause_;
  beast::flat_buffer buffer_;
  const HttpOptions& options_;
  const HttpServer::Handler& handler_;
  std::atomic<std::size_t>& open_;
  std::atomic<std::size_t>& streams_;
  WaitingRoom& room_;
  std::optional<WaitingRoom::Place> place_;  // while the client is waited for
  std::shared_ptr<EventStream> events_;
  std::optional<http::response<http::empty_body>> header_;
  std::optional<http::response_serializer<http::empty_body>> serializer_;
  std::string piece_;
  std::chrono::steady_clock::time_point last_piece_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<http::response<http::string_body>> answer_;
  std::size_t drained_ = 0;
};

}  // namespace

bool is_loopback(const std::string& address) {
  error_code error;
  const auto parsed = net::ip::make_address(address, error);
  if (error)
    throw std::invalid_argument(fmt::format("{} is no numeric address such as 127.0.0.1 or ::1", address));
  return parsed.is_loopback();
}

class HttpServer::Impl {
 public:
  Impl(const HttpOptions& options, Handler handler)
      : options_(options),
        handler_(std::move(handler)),
        context_(std::max(1, options.threads)),
        acceptor_(context_),
        retry_(context_),
        signals_(context_) {
    error_code error;
    const auto address = net::ip::make_address(options_.address, error);
    const tcp::endpoint endpoint(address, options_.port);
    if (!error) acceptor_.open(endpoint.protocol(), error);
    // Lets a restarted server have its port back at once; two at a time stay impossible.
    if (!error) acceptor_.set_option(net::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(net::socket_base::max_listen_connections, error);
    if (error)
      throw std::runtime_error(fmt::format("cannot listen on {} port {}: {}; choose another with --port",
                                           options_.address, options_.port, error.message()));
  }

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

  void run(bool until_signal) {
    if (until_signal) {
      signals_.add(SIGINT);
      signals_.add(SIGTERM);
      signals_.async_wait([this](error_code error, int) {
        if (!error) stop();
      });
    }
    accept();
    std::vector<std::jthread> others;
    for (int k = 1; k < options_.threads; ++k) others.emplace_back([this] { context_.run(); });
    context_.run();
  }

  void stop() { context_.stop(); }

 private:
  void accept() {
    acceptor_.async_accept(net::make_strand(context_), [this](error_code error, tcp::socket socket) {
      if (error) {
        // Out of descriptors, most likely: wait for connections to end rather than spin.
        retry_.expires_after(std::chrono::milliseconds(100));
        retry_.async_wait([this](error_code stopped) {
          if (!stopped) accept();
        });
        return;
      }
      // Over the limit the socket is closed unanswered, an answer would need a connection's memory; unless
      // somebody can go for it.
      const std::size_t open = open_.load();
      bool room = open < options_.most_connections;
      if (!room && open < options_.most_connections + most_leaving)
        if (const auto longest = room_.longest()) {
          longest->make_room();
          room = true;
        }
      if (room)
        std::make_shared<Session>(std::move(socket), options_, handler_, open_, streams_, room_)->start();
      accept();
    });
  }

  // In this order: sessions waiting in the context refer to what stands above it.
  HttpOptions options_;
  Handler handler_;
  std::atomic<std::size_t> open_{0};
  std::atomic<std::size_t> streams_{0};
  WaitingRoom room_;
  net::io_context context_;
  tcp::acceptor acceptor_;
  net::steady_timer retry_;
  net::signal_set signals_;
};

HttpServer::HttpServer(const HttpOptions& options, Handler handler)
    : impl_(std::make_unique<Impl>(options, std::move(handler))) {}
HttpServer::~HttpServer() = default;
std::uint16_t HttpServer::port() const {
  return impl_->port();
}
void HttpServer::run(bool until_signal) {
  impl_->run(until_signal);
}
void HttpServer::stop() {
  impl_->stop();
}

}  // namespace verstat::web
