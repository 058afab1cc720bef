#include "app/web/server/connection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <optional>

#include "app/web/server/access.hpp"

namespace palpate::app {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

constexpr std::size_t kLargestMessage = 16 * 1024;  // a page's; the longest is the strategy text [byte]
constexpr std::size_t kLargestHeader = 8 * 1024;    // [byte]
constexpr std::size_t kMostWaiting = 4;             // binary messages; more would only be late
constexpr auto kPatience = std::chrono::seconds(10);

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

std::string_view content_type(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  return "image/svg+xml";
}

/// The page may load its own files and talk to this server, and nothing else.
void add_headers(Response& response, std::uint16_t port) {
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy",
               fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
                           "connect-src 'self' ws://127.0.0.1:{}; base-uri 'none'; form-action 'none'; "
                           "frame-ancestors 'none'",
                           port));
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
}

Response refuse(http::status status, std::string_view why) {
  Response response(status, 11);
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.body() = fmt::format("{}\n", why);
  return response;
}

Response answer(const Page& page, const Request& request, Access access) {
  if (access != Access::Granted)
    return refuse(http::status::forbidden, "Open this page by the link that the program printed.");
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(http::status::method_not_allowed, "Only GET and HEAD.");
  const std::string_view wanted = file_of(view(request.target()));
  const auto file = std::ranges::find(page.files, wanted, &PageFile::name);
  if (file == page.files.end()) return refuse(http::status::not_found, "There is no such file.");
  Response response(http::status::ok, 11);
  response.set(http::field::content_type,
               beast::string_view(content_type(wanted).data(), content_type(wanted).size()));
  response.body() = file->bytes;
  return response;
}

class Socket final : public PageSocket, public std::enable_shared_from_this<Socket> {
 public:
  explicit Socket(beast::tcp_stream stream) : socket_(std::move(stream)) {}

  template <typename Opened>
  void accept(const Request& request, Opened opened) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.read_message_max(kLargestMessage);
    socket_.async_accept(request, [self = shared_from_this(), opened](beast::error_code error) {
      if (!error) opened(self);
    });
  }

  void listen(std::function<void(std::string_view, bool)> message, std::function<void()> gone) override {
    message_ = std::move(message);
    gone_ = std::move(gone);
    read();
  }

  void send(std::string message, bool text) override {
    if (closing_) return;
    if (!text && waiting_.size() >= kMostWaiting) return;
    waiting_.push_back({std::move(message), text});
    if (waiting_.size() == 1) write();
  }

  void close(std::uint16_t code) override {
    if (closing_) return;
    closing_ = code;
    if (waiting_.empty()) close_now();
  }

 private:
  struct Waiting {
    std::string bytes;
    bool text = false;
  };

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->lost();
      const auto bytes = self->buffer_.cdata();
      if (!self->closing_)
        self->message_({static_cast<const char*>(bytes.data()), bytes.size()}, self->socket_.got_text());
      self->buffer_.consume(self->buffer_.size());
      self->read();
    });
  }

  void write() {
    socket_.text(waiting_.front().text);
    socket_.async_write(asio::buffer(waiting_.front().bytes),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (error) return;  // the pending read learns of it, and tells
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) return self->write();
                          if (self->closing_) self->close_now();
                        });
  }

  void close_now() {
    socket_.async_close(websocket::close_reason(*closing_),
                        [self = shared_from_this()](beast::error_code) {});
  }

  void lost() {
    if (const auto gone = std::exchange(gone_, nullptr)) gone();
  }

  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer buffer_;
  std::deque<Waiting> waiting_;
  std::function<void(std::string_view, bool)> message_;
  std::function<void()> gone_;
  std::optional<std::uint16_t> closing_;
};

/// Requests on one connection, until it closes or becomes a WebSocket.
class Visit final : public Visitor, public std::enable_shared_from_this<Visit> {
 public:
  Visit(tcp::socket socket, Door door, std::function<void(std::shared_ptr<PageSocket>)> opened)
      : stream_(std::move(socket)), door_(std::move(door)), opened_(std::move(opened)) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(kLargestHeader);
    parser_->body_limit(0);
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->respond();
                     });
  }

  void send_away() override {
    beast::error_code ignored;
    stream_.socket().close(ignored);
  }

 private:
  void respond() {
    const Request request = parser_->release();
    const bool upgrade = websocket::is_upgrade(request);
    const Claim claim{.host = view(request[http::field::host]),
                      .origin = view(request[http::field::origin]),
                      .target = view(request.target()),
                      .upgrade = upgrade};
    const Access access = check_access(claim, door_.token, door_.port);
    if (upgrade && access == Access::Granted && file_of(claim.target) == "live") {
      stream_.expires_never();
      return std::make_shared<Socket>(std::move(stream_))->accept(request, opened_);
    }
    response_ = answer(door_.page, request, access);
    add_headers(response_, door_.port);
    response_.keep_alive(request.keep_alive() && !upgrade);
    response_.prepare_payload();
    if (request.method() == http::verb::head) response_.body().clear();
    write();
  }

  void write() {
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return;
      if (self->response_.keep_alive()) return self->read();
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  Door door_;
  std::function<void(std::shared_ptr<PageSocket>)> opened_;
  beast::flat_buffer buffer_{kLargestHeader * 2};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Response response_;
};

}  // namespace

std::weak_ptr<Visitor> serve_connection(tcp::socket socket, Door door,
                                        std::function<void(std::shared_ptr<PageSocket>)> opened) {
  const auto visit = std::make_shared<Visit>(std::move(socket), std::move(door), std::move(opened));
  visit->read();
  return visit;
}

}  // namespace palpate::app
