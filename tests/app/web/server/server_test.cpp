#include "app/web/server/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <ctime>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "app/web/server/access.hpp"

namespace palpate::app {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using testing::HasSubstr;

constexpr std::array<PageFile, 2> kFiles{
    {{.name = "index.html", .bytes = "<p>hello</p>"}, {.name = "page.js", .bytes = "1;"}}};
constexpr Page kPage{.name = "fake", .files = kFiles};

/// A server of a page of two files, and a browser that asks it.
class ServerTest : public testing::Test {
 protected:
  ServerTest() : thread_([this] { io_.run(); }) {}
  ~ServerTest() override {
    io_.stop();
    thread_.join();
  }

  /// The answer to GET of `path`: after the link's token, or of its own where it begins with a slash.
  http::response<http::string_body> get(const std::string& path) {
    const std::string link = server_.link();
    std::smatch part;
    std::regex_match(link, part, std::regex("http://127\\.0\\.0\\.1:([0-9]+)(/.+/)"));
    const auto port = static_cast<std::uint16_t>(std::stoi(part[1]));
    asio::io_context io;
    asio::ip::tcp::socket socket(io);
    socket.connect({asio::ip::address_v4::loopback(), port});
    const std::string target = path.starts_with("/") ? path : part[2].str() + path;
    http::request<http::empty_body> request(http::verb::get, target, 11);
    request.set(http::field::host, "127.0.0.1:" + part[1].str());
    http::write(socket, request);
    boost::beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(socket, buffer, response);
    return response;
  }

  std::uint16_t port() const {
    const std::string link = server_.link();
    return static_cast<std::uint16_t>(std::stoi(link.substr(std::string_view("http://127.0.0.1:").size())));
  }
  /// What the server's thread has used of a processor [s].
  double processor_time() {
    clockid_t clock{};
    timespec used{};
    pthread_getcpuclockid(thread_.native_handle(), &clock);
    clock_gettime(clock, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }

  asio::io_context io_;
  Server server_{io_, kPage, 0, draw_token(), {}};
  std::thread thread_;
};

TEST_F(ServerTest, ServesTheFilesOfItsPage) {
  const auto index = get("");
  EXPECT_EQ(index.result(), http::status::ok);
  EXPECT_EQ(index.body(), "<p>hello</p>");
  EXPECT_EQ(index[http::field::content_type], "text/html; charset=utf-8");
  EXPECT_EQ(get("page.js").body(), "1;");
  EXPECT_EQ(get("page.css").result(), http::status::not_found);
}

TEST_F(ServerTest, ServesNobodyWithoutTheLinksToken) {
  for (const std::string path : {"/", "/page.js", "/index.html"}) {
    const auto refused = get(path);
    EXPECT_EQ(refused.result(), http::status::forbidden);
    EXPECT_THAT(refused.body(), HasSubstr("the link that the program printed"));
  }
}

// Connections that ask for nothing, more than the server keeps: the oldest are closed, the page still comes.
TEST_F(ServerTest, IdleConnectionsHaveABound) {
  asio::io_context io;
  std::vector<asio::ip::tcp::socket> idle;
  for (int i = 0; i < 90; ++i) idle.emplace_back(io).connect({asio::ip::address_v4::loopback(), port()});
  EXPECT_EQ(get("page.js").body(), "1;");
  const auto closed = std::ranges::count_if(idle, [](asio::ip::tcp::socket& socket) {
    socket.non_blocking(true);
    char byte = 0;
    boost::system::error_code error;
    socket.read_some(asio::buffer(&byte, 1), error);
    return error == asio::error::eof || error == asio::error::connection_reset;
  });
  EXPECT_EQ(closed, 90 - 24 + 1);
}

// The process may open nothing more: the server waits, and takes the connection once it may again.
TEST_F(ServerTest, WaitsWithoutDescriptorsInsteadOfSpinning) {
  asio::io_context io;
  asio::ip::tcp::socket socket(io, asio::ip::tcp::v4());
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const int next = ::dup(0);  // the lowest that is free
  ::close(next);
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(next);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &tight), 0);
  socket.connect({asio::ip::address_v4::loopback(), port()});
  // Long enough for several tries; a loop that spins takes all of the time for itself.
  constexpr std::chrono::milliseconds kWhile(600);
  const double used = processor_time();
  std::this_thread::sleep_for(kWhile);
  EXPECT_LT(processor_time() - used, 0.25 * std::chrono::duration<double>(kWhile).count());
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  http::request<http::empty_body> request(http::verb::get, "/", 11);
  http::write(socket, request);
  boost::beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(socket, buffer, response);
  EXPECT_EQ(response.result(), http::status::forbidden);
}

}  // namespace
}  // namespace palpate::app
