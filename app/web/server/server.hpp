#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "app/web/server/page.hpp"

namespace boost::asio {
class io_context;
}

namespace palpate::app {

/// What the server tells about its page; called on the io_context's thread.
struct PageEvents {
  std::function<void()> opened;
  std::function<void(std::string_view)> text;
  std::function<void(std::string_view)> binary;
  std::function<void()> closed;
};

/// Serves one page and one WebSocket on 127.0.0.1. Where the page is opened a second time, that takes over from
/// the first, which is told so. Single-threaded: everything runs on the io_context.
class Server {
 public:
  /// @param page  must outlive the server
  /// @param port   0: the operating system chooses
  /// @param token  of the link, see draw_token()
  /// Throws std::runtime_error that names the port when it cannot be had.
  Server(boost::asio::io_context& context, const Page& page, std::uint16_t port, std::string token,
         PageEvents events);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::string link() const;  // http://127.0.0.1:PORT/TOKEN/
  std::uint16_t port() const;
  const std::string& token() const;
  bool connected() const;

  void send_text(std::string message);
  /// What only the newest of matters (pointer, pictures): dropped when the page is slow to read.
  void send_binary(std::string message);
  /// Lets the page know that the session is over, then closes.
  void finish();

  struct State;

 private:
  std::shared_ptr<State> state_;
};

}  // namespace palpate::app
