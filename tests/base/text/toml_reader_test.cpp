#include "base/text/toml_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace palpate::base {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

enum class Order { Coin, Fixed };
constexpr EnumWords<Order, 2> kOrders{{{Order::Coin, "coin", "a fair coin"}, {Order::Fixed, "fixed"}}};
constexpr std::array<std::string_view, 1> kLater{"latin"};

constexpr std::array kKeys{
    Key{.name = "name", .takes = kText, .example = "\"a\""},
    Key{.name = "depth", .takes = takes_quantity(Dimension::Length, kPositive), .example = "\"5 mm\""},
    Key{.name = "time", .takes = takes_quantity(Dimension::Time, {.least = 0.5}), .fallback = "\"1 s\""},
    Key{.name = "share", .takes = takes_number({.least = 0.0, .most = 1.0, .open = true}), .fallback = "0.5"},
    Key{.name = "trials", .takes = takes_whole(1, 9), .fallback = "3"},
    Key{.name = "order", .takes = takes_word(words_of<kOrders, kLater>), .fallback = "\"coin\""},
    Key{.name = "note", .takes = kText, .absent = "none"},
    Key{.name = "at", .takes = takes_three(Dimension::Length), .fallback = "[\"0 mm\", \"0 mm\", \"1 mm\"]"},
};

/// Reads what a file of this text says; gives what is refused.
template <class Ask>
std::string refusal_of(std::string_view text, Ask ask) {
  const toml::table root = parse_toml(text, "f.toml");
  TomlReader reader(root, "f.toml", kKeys);
  try {
    ask(reader);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TomlReader, WhatIsLeftOutHasTheValueOfItsDescription) {
  const toml::table root = parse_toml("name = \"x\"", "f.toml");
  TomlReader reader(root, "f.toml", kKeys);
  EXPECT_EQ(reader.text("name"), "x");
  EXPECT_DOUBLE_EQ(reader.quantity("time"), 1.0);
  EXPECT_DOUBLE_EQ(reader.number("share"), 0.5);
  EXPECT_EQ(reader.whole("trials"), 3);
  EXPECT_EQ(reader.word("order", kOrders), Order::Coin);
  EXPECT_EQ(reader.three_quantities("at"), (Triple{0.0, 0.0, 1e-3}));
  EXPECT_FALSE(reader.has("note"));
  EXPECT_NO_THROW(reader.refuse_unknown());
}

TEST(TomlReader, MessagesSayWhatTheDescriptionAccepts) {
  EXPECT_EQ(refusal_of("", [](TomlReader& r) { r.text("name"); }),
            "f.toml:1: name: is missing; accepted: a string such as \"a\"");
  EXPECT_EQ(refusal_of("\ndepth = \"-1 mm\"", [](TomlReader& r) { r.quantity("depth"); }),
            "f.toml:2: depth: found \"-1 mm\", accepted: a quantity > 0 such as \"5 mm\"");
  EXPECT_EQ(refusal_of("depth = 3", [](TomlReader& r) { r.quantity("depth"); }),
            "f.toml:1: depth: found the number 3, accepted: a quantity with its unit, as a string");
  EXPECT_EQ(refusal_of("time = \"0.1 s\"", [](TomlReader& r) { r.quantity("time"); }),
            "f.toml:1: time: found \"0.1 s\", accepted: a quantity >= 0.5 s");
  EXPECT_EQ(refusal_of("share = 1", [](TomlReader& r) { r.number("share"); }),
            "f.toml:1: share: found 1, accepted: a number greater than 0 and less than 1");
  for (const char* no_number : {"share = nan", "share = inf", "share = -inf"})
    EXPECT_THAT(refusal_of(no_number, [](TomlReader& r) { r.number("share"); }),
                HasSubstr("accepted: a number"));
  EXPECT_EQ(refusal_of("trials = 10", [](TomlReader& r) { r.whole("trials"); }),
            "f.toml:1: trials: found 10, accepted: a whole number from 1 to 9");
  EXPECT_EQ(refusal_of("trials = 2.5", [](TomlReader& r) { r.whole("trials"); }),
            "f.toml:1: trials: found the number 2.5, accepted: a whole number from 1 to 9");
  EXPECT_EQ(refusal_of("order = \"random\"", [](TomlReader& r) { r.word("order"); }),
            "f.toml:1: order: found \"random\", accepted: coin, fixed");
  EXPECT_EQ(refusal_of("order = \"latin\"", [](TomlReader& r) { r.word("order"); }),
            "f.toml:1: order: found \"latin\", which is not in this version, accepted: coin, fixed");
  EXPECT_EQ(refusal_of("order = 1", [](TomlReader& r) { r.word("order"); }),
            "f.toml:1: order: found the number 1, accepted: coin, fixed");
}

TEST(TomlReader, AKeyThatNobodyAskedForIsRefusedWithThoseThatMayStandThere) {
  const auto ask = [](TomlReader& r) {
    r.has("note");
    r.whole("trials");
    r.refuse_unknown();
  };
  EXPECT_THAT(refusal_of("trails = 3", ask),
              AllOf(StartsWith("f.toml:1: trails: unknown key, perhaps trials is meant"),
                    HasSubstr("accepted here: note, trials"), Not(HasSubstr("depth"))));
}

// A mistake of the program, and no fault of the file's.
TEST(TomlReader, AKeyIsReadAsItIsDescribedOrNotAtAll) {
  const toml::table root = parse_toml("name = \"x\"\nfoo = 3", "f.toml");
  TomlReader reader(root, "f.toml", kKeys);
  EXPECT_THROW(reader.text("foo"), std::logic_error);     // no description
  EXPECT_THROW(reader.number("name"), std::logic_error);  // another kind of value
  EXPECT_THROW(reader.has("name"), std::logic_error);     // it is required
  constexpr std::array kFurther{Key{.name = "foo", .takes = takes_whole(1, 9), .absent = "none"}};
  reader.also(kFurther);
  EXPECT_EQ(reader.whole("foo"), 3);
}

}  // namespace
}  // namespace palpate::base
