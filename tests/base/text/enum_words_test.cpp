#include "base/text/enum_words.hpp"

#include <gtest/gtest.h>

namespace palpate::base {
namespace {

enum class Side { Left, Right };
constexpr EnumWords<Side, 2> kSides = {{{Side::Left, "left"}, {Side::Right, "right"}}};

TEST(EnumWords, OneTableWritesReadsAndLists) {
  EXPECT_EQ(word_of(kSides, Side::Right), "right");
  EXPECT_EQ(value_of(kSides, "left"), Side::Left);
  EXPECT_EQ(value_of(kSides, "Left"), std::nullopt);
  EXPECT_EQ(accepted_words(kSides), "left, right");
}

}  // namespace
}  // namespace palpate::base
