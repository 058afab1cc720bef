#include "app/web/server/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <regex>
#include <string>
#include <thread>

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

}  // namespace
}  // namespace palpate::app
