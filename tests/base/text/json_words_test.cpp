#include "base/text/json_words.hpp"

#include <gtest/gtest.h>

#include "base/text/utf8.hpp"

using namespace palpate::base;

TEST(JsonWords, LeaveTheLibrarysNameOut) {
  EXPECT_EQ(json_words("[json.exception.type_error.302] type must be number, but is string"),
            "type must be number, but is string");
  EXPECT_EQ(json_words("anything else"), "anything else");
}

TEST(JsonWords, NameTheWordThatIsNone) {
  const std::string_view said =
      "[json.exception.parse_error.101] parse error at line 1, column 7: syntax error";
  EXPECT_EQ(json_words(said, R"({"a": NaN})", 7).substr(0, 33), "no JSON at character 7: 'NaN'; ac");
  EXPECT_EQ(json_words(said, R"({"a": -inf})", 8).substr(0, 31), "no JSON at character 8: '-inf';");
  EXPECT_EQ(json_words(said, "{'a': 1}", 2), "no JSON at character 2: syntax error");
  EXPECT_EQ(json_words(said, "", 0), "no JSON at character 0: syntax error");
}

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable("caf\xC3\xA9 \x1b[2J\xff\n"), "caf\xC3\xA9 \\x1b[2J\\xff\\x0a");
  EXPECT_EQ(printable(std::string(300, 'a')), std::string(200, 'a') + "...");
}
