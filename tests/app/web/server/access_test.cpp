#include "app/web/server/access.hpp"

#include <gtest/gtest.h>

#include <set>

namespace palpate::app {
namespace {

const std::string kToken(48, 'a');

Access page(Claim claim) {
  return check_access(claim, kToken, 8080);
}

TEST(Token, Has192BitsAndIsNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(draw_token());
  EXPECT_EQ(tokens.size(), 100U);
  for (const std::string& token : tokens) {
    EXPECT_EQ(token.size(), 48U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  }
}

TEST(Access, IsGrantedByTheLink) {
  const std::string target = "/" + kToken + "/page.js";
  EXPECT_EQ(page({.host = "127.0.0.1:8080", .target = target}), Access::Granted);
  EXPECT_EQ(
      page({.host = "127.0.0.1:8080", .origin = "http://127.0.0.1:8080", .target = target, .upgrade = true}),
      Access::Granted);
}

TEST(Access, IsRefusedUnderAnotherName) {
  const std::string target = "/" + kToken + "/";
  for (const std::string_view host :
       {"", "evil.example", "evil.example:8080", "localhost:8080", "127.0.0.1", "127.0.0.1:8081"})
    EXPECT_EQ(page({.host = host, .target = target}), Access::WrongHost) << host;
}

TEST(Access, IsRefusedToOtherSites) {
  const std::string target = "/" + kToken + "/live";
  for (const std::string_view origin :
       {"http://evil.example", "null", "https://127.0.0.1:8080", "http://127.0.0.1"})
    EXPECT_EQ(page({.host = "127.0.0.1:8080", .origin = origin, .target = target}), Access::WrongOrigin)
        << origin;
  EXPECT_EQ(page({.host = "127.0.0.1:8080", .target = target, .upgrade = true}), Access::WrongOrigin);
}

TEST(Access, IsRefusedWithoutTheToken) {
  const std::string almost = "/" + kToken.substr(1) + "b/", longer = "/" + kToken + "a/", bare = "/" + kToken;
  for (const std::string_view target :
       {std::string_view("/"), std::string_view(""), std::string_view("/x/live"), std::string_view(almost),
        std::string_view(longer), std::string_view(bare)})
    EXPECT_EQ(page({.host = "127.0.0.1:8080", .target = target}), Access::WrongToken) << target;
}

TEST(Access, TheFolderMeansItsPage) {
  EXPECT_EQ(file_of("/t/"), "index.html");
  EXPECT_EQ(file_of("/t/page.js"), "page.js");
}

}  // namespace
}  // namespace palpate::app
