#include "base/text/utf8.hpp"

#include <gtest/gtest.h>

namespace palpate::base {
namespace {

// RFC 3629, section 4: the table of well-formed sequences, its first and last rows and what lies just beyond.
TEST(Utf8, TakesEveryLengthAtItsLimits) {
  for (const char* text :
       {"", "a", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
        "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "Größe 3 µm"})
    EXPECT_TRUE(is_utf8(text)) << text;
}

TEST(Utf8, RefusesOverlongSurrogateCutAndBeyond) {
  for (const char* text : {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                           "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xC2", "\xE2\x82", "a\xFFz"})
    EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(Utf8, TellsTheLengthOfTheFirstCharacter) {
  EXPECT_EQ(utf8_length("az"), 1U);
  EXPECT_EQ(utf8_length("µm"), 2U);
  EXPECT_EQ(utf8_length("€2"), 3U);
  EXPECT_EQ(utf8_length("\xF0\x9F\x98\x80!"), 4U);
  EXPECT_EQ(utf8_length("\xFF"), 0U);
}

}  // namespace
}  // namespace palpate::base
