#include "analysis/statistics/similarity/similarity.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "analysis/binomial/binomial_power.hpp"

using namespace palpate::analysis;

TEST(Similarity, AgreesWithR) {
  // R 4.2: b <- 1/3 + .3*2/3; pbinom(22, 66, b)
  const SimilarityTest test = similarity_test(22, 66, 1.0 / 3, proportion_at(0.3, 1.0 / 3), 0.05);
  EXPECT_NEAR(test.bound, 0.533333333333333, 1e-14);
  EXPECT_NEAR(test.p, 0.000831309429639476, 1e-14);
  EXPECT_TRUE(test.similar);
  EXPECT_EQ(test.critical.at_most, 28);                         // max(which(pbinom(0:66, 66, b) <= .05)) - 1
  EXPECT_NEAR(test.critical.size, 0.0492723401589197, 1e-12);   // pbinom(28, 66, b)
  EXPECT_NEAR(test.power_at_chance, 0.953080109977348, 1e-12);  // pbinom(28, 66, 1/3)
  // u <- binom.test(22, 66, alternative = "less")$conf.int[2]; (u - 1/3)/(2/3)
  EXPECT_NEAR(test.discriminators_up_to, 0.161038482486145, 1e-9);
  EXPECT_NEAR(test.discriminators, 0, 1e-15);
}

RC_GTEST_PROP(Similarity, IsClaimedWhereTheUpperBoundOfDiscriminatorsIsBelowTheirBound, ()) {
  const long n = *rc::gen::inRange(1L, 120L), k = *rc::gen::inRange(0L, n + 1);
  const double chance = *rc::gen::element(0.5, 1.0 / 3), discriminators = *rc::gen::element(0.11, 0.23, 0.51);
  const SimilarityTest test = similarity_test(k, n, chance, proportion_at(discriminators, chance), 0.05);
  RC_ASSERT(test.similar == (test.discriminators_up_to < discriminators));
  RC_ASSERT(test.similar == (test.p <= 0.05));
  RC_ASSERT(rejection_probability(test.critical, test.bound) <= 0.05);
}

TEST(Similarity, CannotBeShownByAFewAnswers) {
  const SimilarityTest test = similarity_test(0, 3, 0.5, 0.55, 0.05);
  EXPECT_FALSE(test.similar);
  EXPECT_FALSE(test.critical.at_most.has_value());
  EXPECT_EQ(test.power_at_chance, 0);
}

TEST(Similarity, RefusesBoundsThatMeanNothing) {
  EXPECT_THROW(similarity_test(5, 10, 0.5, 0.5, 0.05), std::invalid_argument);
  EXPECT_THROW(similarity_test(5, 10, 0.5, 0.4, 0.05), std::invalid_argument);
  EXPECT_THROW(similarity_test(5, 10, 0.5, 1.0, 0.05), std::invalid_argument);
}
