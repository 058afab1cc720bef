#include "base/text/toml_depth.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/text/toml_reader.hpp"

namespace palpate::base {
namespace {

using testing::HasSubstr;

std::string repeated(std::string_view part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

std::string refusal(const std::string& text) {
  try {
    parse_toml(text, "deep.toml");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TomlDepth, AKeyOfTooManyPartsIsRefusedWithItsLine) {
  for (const std::size_t parts : {kDeepestKey + 1, std::size_t{40000}, std::size_t{1000000}}) {
    const std::string key = repeated("a.", parts - 1) + "a", quoted = repeated("'a' . ", parts - 1) + "a";
    for (const std::string& text :
         {key + " = 1", "[" + key + "]", "[[" + key + "]]", quoted + " = 1", "x = { " + key + " = 1 }"})
      EXPECT_EQ(refusal("\n" + text + "\n"), "deep.toml:2: a key of more parts than 64; accepted: up to 64");
  }
}

TEST(TomlDepth, BracketsTooDeepAreRefused) {
  const std::string arrays = "x = " + repeated("[", 100000), tables = "x = " + repeated("{ a = ", 100000);
  for (const std::string& text : {arrays, tables, "x = " + repeated("[", 65) + repeated("]", 65)})
    EXPECT_EQ(refusal(text), "deep.toml:1: brackets deeper than 64; accepted: up to 64");
}

TEST(TomlDepth, WhatIsAtTheBoundIsRead) {
  EXPECT_EQ(refusal(repeated("a.", kDeepestKey - 1) + "a = 1"), "");
  EXPECT_EQ(refusal("x = " + repeated("[", kDeepestBrackets) + repeated("]", kDeepestBrackets)), "");
}

// Dots and brackets that are none: of texts, comments, numbers, and of one line after the other.
TEST(TomlDepth, TextsCommentsAndNumbersAreNoKeys) {
  const std::string dots(100, '.'), brackets(100, '[');
  for (const std::string& text :
       {"x = \"" + dots + brackets + "\"", "x = '" + dots + brackets + "'", "# " + dots + brackets,
        "x = \"\"\"\n\"" + dots + brackets + "\n\"\"\"", "x = '''\n'" + brackets + "\n'''",
        "x = \"\\\"" + dots + "\"", "x = [" + repeated("1.5, ", 200) + "]", repeated("[[a.b]]\n", 200)})
    EXPECT_EQ(refusal(text), "") << text;
}

TEST(TomlDepth, AKeyOfTheCommandLineIsBoundToo) {
  EXPECT_NO_THROW(refuse_deep_key(repeated("a.", kDeepestKey - 1) + "a"));
  EXPECT_THROW(refuse_deep_key(repeated("a.", 40000)), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::base
