#include "analysis/words/words.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace palpate::analysis;

TEST(Words, PIsOneOnlyWhereItIsOne) {
  EXPECT_EQ(p_in_words(1.0), "p = 1");
  EXPECT_EQ(p_in_words(std::nextafter(1.0, 0.0)), "p > 0.999");
  EXPECT_EQ(p_in_words(0.9996), "p > 0.999");
  EXPECT_EQ(p_in_words(0.9994), "p = 0.999");
  EXPECT_EQ(p_in_words(0.00009), "p < 0.0001");
  EXPECT_EQ(bare_p(1.0), "1");
  EXPECT_EQ(bare_p(0.9996), "> 0.999");
  EXPECT_EQ(bare_p(0.046), "0.046");
  EXPECT_EQ(bare_p(1e-9), "< 0.0001");
}

TEST(Words, TimesHaveNoMilliseconds) {
  EXPECT_EQ(to_the_second("2026-11-28T10:11:12.345Z"), "2026-11-28 10:11:12");
  EXPECT_EQ(to_the_second("2026-11-28T10:11:12Z"), "2026-11-28 10:11:12");
  EXPECT_EQ(to_the_second("n/a"), "n/a");
  EXPECT_EQ(to_the_second(""), "");
}
