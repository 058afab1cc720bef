#include "analysis/binomial/binomial_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using namespace palpate::analysis;

namespace {

// R's figures carry 15 digits; both programs promise about 12.
constexpr double kRelative = 1e-10;

void expect_close(double found, double expected) {
  EXPECT_NEAR(found, expected, kRelative * expected);
}

// The definition, term by term: n is small enough for a plain product.
double probability(long k, long n, double chance) {
  double p = 1.0;
  for (long i = 1; i <= k; ++i) p *= static_cast<double>(n - k + i) / static_cast<double>(i);
  return p * std::pow(chance, static_cast<double>(k)) * std::pow(1 - chance, static_cast<double>(n - k));
}

}  // namespace

TEST(BinomialTest, AgreesWithR) {
  // R 4.2: for (x, n, p, side) binom.test(x, n, p, alternative = side)$p.value, printed with 15 digits
  expect_close(binomial_p(41, 60, 0.5).greater, 0.00310880132966335);
  expect_close(binomial_p(37, 60, 0.5).greater, 0.0462304905364621);
  expect_close(binomial_p(36, 60, 0.5).greater, 0.0775009520016304);
  expect_close(binomial_p(6, 60, 0.5).less, 4.86148083594928e-11);
  expect_close(binomial_p(6, 60, 0.5).two_sided, 9.72296167189856e-11);
  expect_close(binomial_p(12, 20, 1.0 / 3).greater, 0.0129732968253003);
  expect_close(binomial_p(0, 10, 0.5).two_sided, 0.001953125);
  expect_close(binomial_p(10, 10, 0.5).two_sided, 0.001953125);
  EXPECT_EQ(binomial_p(0, 10, 0.5).greater, 1.0);
  EXPECT_EQ(binomial_p(10, 20, 0.5).two_sided, 1.0);
}

TEST(BinomialTest, TwoSidedCountsOutcomesNoLikelierThanTheOneSeen) {
  // R 4.2: binom.test(3, 20, 1/3)$p.value; binom.test(682, 925, 0.75)$p.value (Conover 1971, p. 97, from its
  // help)
  expect_close(binomial_p(3, 20, 1.0 / 3).two_sided, 0.0980830317188288);
  expect_close(binomial_p(682, 925, 0.75).two_sided, 0.382491559574852);
}

TEST(BinomialTest, HoldsForManyTrials) {
  // R 4.2: binom.test(52000, 100000)$p.value
  EXPECT_NEAR(binomial_p(52000, 100000, 0.5).two_sided / 1.15309386667231e-36, 1.0, 1e-8);
}

TEST(BinomialTest, GivesTheBoundThatBelongsToItsSide) {
  // R 4.2: binom.test(41, 60, alternative = "greater")$conf.int, "two.sided", and binom.test(6, 60,
  // alternative = "less")
  const BinomialTest greater = binomial_test(41, 60, 0.5, Side::Greater);
  expect_close(greater.bound.lower, 0.57082959140154);
  EXPECT_EQ(greater.bound.upper, 1.0);
  expect_close(greater.interval.lower, 0.550440312235947);
  expect_close(greater.interval.upper, 0.797424492881028);
  EXPECT_EQ(greater.p.of(greater.side), greater.p.greater);
  const BinomialTest less = binomial_test(6, 60, 0.5, Side::Less);
  EXPECT_EQ(less.bound.lower, 0.0);
  expect_close(less.bound.upper, 0.187857381988982);
}

TEST(BinomialTest, RefusesWhatCannotBe) {
  const auto message = [](auto call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message([] { binomial_test(61, 60, 0.5, Side::Greater); }),
            "61 correct answers of 60 trials; accepted: 0 to 60");
  EXPECT_EQ(message([] { binomial_test(0, 0, 0.5, Side::Greater); }), "0 trials; at least 1 is needed");
  EXPECT_EQ(message([] { binomial_test(1, 2, 1.0, Side::Greater); }),
            "chance is 1; it must lie between 0 and 1, both excluded");
  EXPECT_EQ(message([] { binomial_test(1, 2, NAN, Side::Greater); }),
            "chance is nan; it must lie between 0 and 1, both excluded");
  EXPECT_EQ(message([] { side_from_name("more"); }), "side is 'more'; accepted: greater, less, two-sided");
}

TEST(BinomialTest, IsTheSumOfItsTerms) {
  EXPECT_TRUE(rc::check([] {
    const long n = *rc::gen::inRange(1L, 40L), k = *rc::gen::inRange(0L, n + 1);
    const double chance = *rc::gen::element(0.5, 1.0 / 3, 0.25, 0.1, 0.9);
    double greater = 0, less = 0, two_sided = 0;
    for (long j = 0; j <= n; ++j) {
      const double p = probability(j, n, chance);
      if (j >= k) greater += p;
      if (j <= k) less += p;
      if (p <= probability(k, n, chance) * (1 + 1e-7)) two_sided += p;
    }
    const PValues p = binomial_p(k, n, chance);
    RC_ASSERT(std::abs(p.greater - greater) < 1e-12);
    RC_ASSERT(std::abs(p.less - less) < 1e-12);
    RC_ASSERT(std::abs(p.two_sided - std::min(1.0, two_sided)) < 1e-12);
    RC_ASSERT(p.greater >= 0 && p.greater <= 1 && p.less >= 0 && p.less <= 1 && p.two_sided <= 1);
  }));
}

TEST(BinomialTest, ExchangingRightAndWrongExchangesTheSides) {
  EXPECT_TRUE(rc::check([] {
    const long n = *rc::gen::inRange(1L, 300L), k = *rc::gen::inRange(0L, n + 1);
    const PValues right = binomial_p(k, n, 0.5), wrong = binomial_p(n - k, n, 0.5);
    RC_ASSERT(std::abs(right.greater - wrong.less) <= 1e-12);
    RC_ASSERT(std::abs(right.two_sided - wrong.two_sided) <= 1e-12);
  }));
}

TEST(BinomialMidP, AgreesWithR) {
  // R 4.2: d <- dbinom(0:n, n, p); f <- dbinom(k, n, p); greater pbinom(k, n, p, lower = FALSE) + f/2, less
  // pbinom(k - 1, n, p) + f/2, two-sided sum(d[d < f*(1 - 1e-7)]) + sum(d[abs(d - f) <= f*1e-7])/2
  const PValues paper = binomial_mid_p(41, 60, 0.5);
  EXPECT_NEAR(paper.greater, 0.00222200973553344, 1e-14);
  EXPECT_NEAR(paper.less, 0.99777799026446645, 1e-13);
  EXPECT_NEAR(paper.two_sided, 0.00444401947106687, 1e-14);
  const PValues quarter = binomial_mid_p(7, 30, 0.25);
  EXPECT_NEAR(quarter.greater, 0.568827873946056, 1e-13);
  EXPECT_NEAR(quarter.two_sided, 0.916882162970252, 1e-13);
  EXPECT_NEAR(binomial_mid_p(9, 12, 1.0 / 3).two_sided, 0.00219967973867278, 1e-14);
  EXPECT_NEAR(binomial_mid_p(0, 5, 0.25).two_sided, 0.22216796875, 1e-14);
  EXPECT_NEAR(binomial_mid_p(10, 10, 1.0 / 3).greater, 8.46754390421513e-06, 1e-16);
}

TEST(BinomialP, OfManyChancesAgreesWithR) {
  // R 4.2: binom.test(k, n, p)$p.value
  EXPECT_NEAR(binomial_p(9, 12, 1.0 / 3).two_sided, 0.00385555499105263, 1e-14);
  EXPECT_NEAR(binomial_p(0, 5, 0.25).two_sided, 0.3408203125, 1e-14);
  EXPECT_NEAR(binomial_p(3, 17, 0.15).two_sided, 0.73269608955017, 1e-13);
  EXPECT_EQ(binomial_p(2, 10, 0.2).two_sided, 1.0);
  EXPECT_EQ(binomial_p(7, 30, 0.25).two_sided, 1.0);
}

RC_GTEST_PROP(BinomialMidP, IsTheExactOneLessHalfOfWhatIsAsLikely, ()) {
  const long n = *rc::gen::inRange(1L, 80L), k = *rc::gen::inRange(0L, n + 1);
  const double chance = *rc::gen::element(0.5, 1.0 / 3, 0.25, 0.1);
  const PValues exact = binomial_p(k, n, chance), mid = binomial_mid_p(k, n, chance);
  RC_ASSERT(std::abs(mid.greater + mid.less - 1) < 1e-12);
  RC_ASSERT(mid.greater <= exact.greater && mid.less <= exact.less && mid.two_sided <= exact.two_sided);
}
