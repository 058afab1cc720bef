#include "app/web/server/server.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <chrono>
#include <deque>
#include <stdexcept>

#include "app/web/server/access.hpp"
#include "app/web/server/connection.hpp"

namespace palpate::app {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr std::size_t kMostVisitors = 24;  // a browser opens 6
constexpr auto kRest = std::chrono::milliseconds(100);

}  // namespace

struct Server::State : std::enable_shared_from_this<Server::State> {
  State(asio::io_context& io, const Page& served, std::string of_link, PageEvents handlers)
      : acceptor(io), rest(io), page(served), events(std::move(handlers)), token(std::move(of_link)) {}

  void listen(std::uint16_t wanted);
  void accept();
  void accept_later();
  void make_room();
  void serve(tcp::socket socket);
  void take(const std::shared_ptr<PageSocket>& opened);

  tcp::acceptor acceptor;
  asio::steady_timer rest;                      // after a connection that could not be accepted
  std::deque<std::weak_ptr<Visitor>> visitors;  // the oldest first
  const Page& page;
  PageEvents events;
  std::string token;
  std::uint16_t port = 0;
  std::shared_ptr<PageSocket> open;  // the one that counts
};

void Server::State::listen(std::uint16_t wanted) {
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), wanted);
  try {
    acceptor.open(endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(endpoint);
    acceptor.listen(16);
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(fmt::format(
        "port {} of 127.0.0.1 cannot be had ({}); leave out --port and one will be chosen that is free",
        wanted, error.code().message()));
  }
  port = acceptor.local_endpoint().port();
}

void Server::State::accept() {
  acceptor.async_accept([self = shared_from_this()](boost::system::error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (error) return self->accept_later();
    self->serve(std::move(socket));
    self->accept();
  });
}

/// Without a descriptor to be had, accepting fails at once, again and again: the haptic loop needs the core.
void Server::State::accept_later() {
  rest.expires_after(kRest);
  rest.async_wait([self = shared_from_this()](boost::system::error_code error) {
    if (!error && self->acceptor.is_open()) self->accept();
  });
}

/// Makes room for one more connection: whoever has been there longest goes.
void Server::State::make_room() {
  std::erase_if(visitors, [](const std::weak_ptr<Visitor>& visitor) { return visitor.expired(); });
  if (visitors.size() < kMostVisitors) return;
  if (const auto oldest = visitors.front().lock()) oldest->send_away();
  visitors.pop_front();
}

void Server::State::serve(tcp::socket socket) {
  boost::system::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  make_room();
  const auto weak = weak_from_this();
  visitors.push_back(serve_connection(std::move(socket), {.page = page, .token = token, .port = port},
                                      [weak](const std::shared_ptr<PageSocket>& opened) {
                                        if (const auto self = weak.lock()) self->take(opened);
                                      }));
}

/// A page's WebSocket has opened: the one before it, if any, is sent away.
void Server::State::take(const std::shared_ptr<PageSocket>& opened) {
  if (open) {
    const auto before = std::exchange(open, nullptr);
    before->close(kTakenOver);
    events.closed();
  }
  open = opened;
  const auto weak = weak_from_this();
  const std::weak_ptr<PageSocket> mine = opened;
  const auto current = [weak, mine]() -> std::shared_ptr<State> {
    const auto self = weak.lock();
    return self && self->open && self->open == mine.lock() ? self : nullptr;
  };
  opened->listen(
      [current](std::string_view message, bool text) {
        if (const auto self = current()) (text ? self->events.text : self->events.binary)(message);
      },
      [current] {
        const auto self = current();
        if (!self) return;
        self->open = nullptr;
        self->events.closed();
      });
  events.opened();
}

Server::Server(asio::io_context& context, const Page& page, std::uint16_t port, std::string token,
               PageEvents events)
    : state_(std::make_shared<State>(context, page, std::move(token), std::move(events))) {
  state_->listen(port);
  state_->accept();
}

Server::~Server() {
  boost::system::error_code ignored;
  state_->acceptor.close(ignored);
  state_->rest.cancel(ignored);
}

std::string Server::link() const {
  return fmt::format("http://127.0.0.1:{}/{}/", state_->port, state_->token);
}

std::uint16_t Server::port() const {
  return state_->port;
}

const std::string& Server::token() const {
  return state_->token;
}

bool Server::connected() const {
  return state_->open != nullptr;
}

void Server::send_text(std::string message) {
  if (state_->open) state_->open->send(std::move(message), true);
}

void Server::send_binary(std::string message) {
  if (state_->open) state_->open->send(std::move(message), false);
}

void Server::finish() {
  if (state_->open) state_->open->close(kEnded);
}

}  // namespace palpate::app
