#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "app/web/server/page.hpp"

namespace palpate::app {

// Why the program closes a page's WebSocket (codes that RFC 6455 leaves to applications).
constexpr std::uint16_t kEnded = 4000;
constexpr std::uint16_t kTakenOver = 4001;

/// An open WebSocket to a page.
class PageSocket {
 public:
  virtual ~PageSocket() = default;
  /// Starts reading. `gone` is called once, whoever closes.
  virtual void listen(std::function<void(std::string_view message, bool text)> message,
                      std::function<void()> gone) = 0;
  /// Text always arrives while the page is there; other messages are dropped when too many wait.
  virtual void send(std::string message, bool text) = 0;
  /// Sends what waits, then closes.
  virtual void close(std::uint16_t code) = 0;
};

struct Door {
  const Page& page;
  std::string token;
  std::uint16_t port = 0;
};

/// A connection that asks for files, or for nothing at all; gone once it is a WebSocket or closed.
class Visitor {
 public:
  virtual ~Visitor() = default;
  virtual void send_away() = 0;  // closes it
};

/// Answers one browser connection: files of the page to who may have them, and hands over an opened
/// WebSocket. Everybody else gets a refusal that says nothing about the session.
std::weak_ptr<Visitor> serve_connection(boost::asio::ip::tcp::socket socket, Door door,
                                        std::function<void(std::shared_ptr<PageSocket>)> opened);

}  // namespace palpate::app
