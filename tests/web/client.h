#pragma once
// A client written with plain sockets, so that it can misbehave.

#include <cerrno>
#include <cstdint>
#include <map>
#include <regex>
#include <string>
#include <string_view>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace verstat::web_test {

using nlohmann::json;

class Socket {
 public:
  /// To a port of this machine.
  explicit Socket(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    // A test that waits for ever tells nothing.
    const timeval patience{10, 0};
    ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    connected_ = ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() { ::close(descriptor_); }

  [[nodiscard]] bool connected() const { return connected_; }
  /// False when the peer has hung up.
  bool send(std::string_view data) const {
    while (!data.empty()) {
      const auto sent = ::send(descriptor_, data.data(), data.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      data.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }
  /// Up to the end of the connection.
  [[nodiscard]] std::string read_all() const {
    std::string all;
    while (read_some(all)) continue;
    return all;
  }
  /// What comes next, at least a byte unless the peer has hung up.
  [[nodiscard]] std::string read_piece() const {
    std::string piece;
    read_some(piece);
    return piece;
  }
  /// One answer of a connection that stays open.
  [[nodiscard]] std::string read_answer() const {
    std::string all;
    static const std::regex length("Content-Length: (\\d+)");
    for (;;) {
      const auto end = all.find("\r\n\r\n");
      std::smatch match;
      if (end != std::string::npos && std::regex_search(all, match, length) &&
          all.size() >= end + 4 + std::stoul(match[1]))
        return all;
      if (!read_some(all)) return all;
    }
  }

 private:
  bool read_some(std::string& all) const {
    char piece[8192];
    // A child that ends may interrupt the call.
    ssize_t size = 0;
    do size = ::recv(descriptor_, piece, sizeof piece, 0);
    while (size < 0 && errno == EINTR);
    if (size > 0) all.append(piece, static_cast<std::size_t>(size));
    return size > 0;
  }
  int descriptor_;
  bool connected_ = false;
};

struct Answer {
  int status = 0;
  std::map<std::string, std::string> headers;
  std::string body;
  [[nodiscard]] json parsed() const { return json::parse(body); }
  [[nodiscard]] std::string message() const { return parsed().at("error").at("message"); }
};

inline Answer parse_answer(const std::string& text) {
  Answer answer;
  const auto end = text.find("\r\n\r\n");
  if (text.size() < 12 || end == std::string::npos) return answer;
  answer.status = std::stoi(text.substr(9, 3));
  std::size_t at = text.find("\r\n") + 2;
  while (at < end) {
    const auto stop = text.find("\r\n", at);
    const auto colon = text.find(": ", at);
    answer.headers[text.substr(at, colon - at)] = text.substr(colon + 2, stop - colon - 2);
    at = stop + 2;
  }
  answer.body = text.substr(end + 4);
  return answer;
}

}  // namespace verstat::web_test
