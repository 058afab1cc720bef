#include "analysis/binomial/critical_number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "analysis/binomial/binomial_power.hpp"
#include "analysis/binomial/binomial_test.hpp"

using namespace palpate::analysis;

TEST(CriticalNumber, IsThatOfThePaper) {
  // Kuroda et al. 2003, section 5.2: 60 answers, alpha 0.05, "critical value, 37"
  const CriticalNumber critical = critical_number(60, 0.5, 0.05, Side::Greater);
  EXPECT_EQ(critical.at_least, 37);
  EXPECT_FALSE(critical.at_most.has_value());
  EXPECT_NEAR(critical.size, 0.0462304905364621, 1e-12);  // R 4.2: pbinom(36, 60, .5, lower.tail = FALSE)
  EXPECT_TRUE(rejects(critical, 37));
  EXPECT_FALSE(rejects(critical, 36));
}

TEST(CriticalNumber, AgreesWithPublishedTables) {
  // ISO 5495 (paired comparison, one-sided), also Roessler et al. 1978: at alpha 0.05, 0.01, 0.001.
  // R 4.2: qbinom(alpha, n, .5, lower.tail = FALSE) + 1
  struct Row {
    long n, at_5, at_1, at_01;
  };
  for (const Row& row : {Row{10, 9, 10, 10}, Row{20, 15, 16, 18}, Row{30, 20, 22, 24}, Row{40, 26, 28, 31},
                         Row{50, 32, 34, 37}, Row{60, 37, 40, 43}, Row{100, 59, 63, 66}}) {
    EXPECT_EQ(critical_number(row.n, 0.5, 0.05, Side::Greater).at_least, row.at_5) << row.n;
    EXPECT_EQ(critical_number(row.n, 0.5, 0.01, Side::Greater).at_least, row.at_1) << row.n;
    EXPECT_EQ(critical_number(row.n, 0.5, 0.001, Side::Greater).at_least, row.at_01) << row.n;
  }
  // ISO 4120 (triangle test, chance 1/3): 15 of 30 at alpha 0.05
  EXPECT_EQ(critical_number(30, 1.0 / 3, 0.05, Side::Greater).at_least, 15);
}

TEST(CriticalNumber, SaysWhenNoNumberIsEnough) {
  EXPECT_FALSE(critical_number(4, 0.5, 0.05, Side::Greater).at_least.has_value());  // 1/16 > 0.05
  EXPECT_EQ(critical_number(4, 0.5, 0.05, Side::Greater).size, 0.0);
  EXPECT_EQ(critical_number(5, 0.5, 0.05, Side::Greater).at_least, 5);
}

TEST(CriticalNumber, TakesAlphaAtItsWord) {
  EXPECT_EQ(critical_number(5, 0.5, 1.0 / 32, Side::Greater).at_least, 5);  // P(X = 5) is alpha exactly
  EXPECT_EQ(critical_number(6, 0.5, 2.0 / 64, Side::TwoSided).at_least, 6);
  EXPECT_EQ(critical_number(6, 0.5, 2.0 / 64, Side::TwoSided).at_most, 0);
}

TEST(CriticalNumber, IsTheEdgeOfWhatTheTestRejects) {
  EXPECT_TRUE(rc::check([] {
    const long n = *rc::gen::inRange(1L, 120L);
    const double chance = *rc::gen::element(0.5, 1.0 / 3, 0.25, 0.02),
                 alpha = *rc::gen::element(0.05, 0.01, 0.2);
    const Side side = *rc::gen::element(Side::Greater, Side::Less, Side::TwoSided);
    const CriticalNumber critical = critical_number(n, chance, alpha, side);
    for (long k = 0; k <= n; ++k) {
      RC_ASSERT(rejects(critical, k) == (binomial_p(k, n, chance).of(side) <= alpha * (1 + 1e-12)));
    }
    RC_ASSERT(critical.size <= alpha * (1 + 1e-9));
  }));
}

TEST(BinomialPower, AgreesWithR) {
  // R 4.2: pbinom(36, 60, c(.6, .65, .7, .75), lower.tail = FALSE)
  EXPECT_NEAR(binomial_power(60, 0.5, 0.60, 0.05, Side::Greater), 0.451106389384398, 1e-10);
  EXPECT_NEAR(binomial_power(60, 0.5, 0.65, 0.05, Side::Greater), 0.752883821815426, 1e-10);
  EXPECT_NEAR(binomial_power(60, 0.5, 0.70, 0.05, Side::Greater), 0.936761870034802, 1e-10);
  EXPECT_NEAR(binomial_power(60, 0.5, 0.75, 0.05, Side::Greater), 0.992505591005678, 1e-10);
  // R 4.2: pbinom(qbinom(.05, 30, 1/3, lower.tail = FALSE), 30, .5, lower.tail = FALSE)
  EXPECT_NEAR(binomial_power(30, 1.0 / 3, 0.5, 0.05, Side::Greater), 0.572232224047184, 1e-10);
  EXPECT_EQ(binomial_power(60, 0.5, 1.0, 0.05, Side::Greater), 1.0);
  EXPECT_EQ(binomial_power(60, 0.5, 0.0, 0.05, Side::Greater), 0.0);
}

TEST(BinomialSampleSize, ShowsBothEndsOfTheSawtooth) {
  // R 4.2: pw <- sapply(1:400, function(n) pbinom(qbinom(.05, n, .5, lower.tail = FALSE), n, .7, lower.tail =
  // FALSE))
  //        which(pw >= .8)[1]; max(which(pw < .8)) + 1
  const SampleSize size = binomial_sample_size(0.5, 0.7, 0.05, Side::Greater, 0.8);
  EXPECT_EQ(size.first, 37);
  EXPECT_EQ(size.lasting, 42);
  EXPECT_GE(size.power_at_lasting, 0.8);
  // the same for n = 4, 8, ... with .65 and .9: the 25th for both
  const SampleSize by_examinee = binomial_sample_size(0.5, 0.65, 0.05, Side::Greater, 0.9, 4);
  EXPECT_EQ(by_examinee.first, 100);
  EXPECT_EQ(by_examinee.lasting, 100);
}

TEST(BinomialSampleSize, RefusesATruthThatTheTestCannotSee) {
  EXPECT_THROW(binomial_sample_size(0.5, 0.4, 0.05, Side::Greater, 0.8), std::invalid_argument);
  EXPECT_THROW(binomial_sample_size(0.5, 0.5, 0.05, Side::TwoSided, 0.8), std::invalid_argument);
  EXPECT_FALSE(binomial_sample_size(0.5, 0.51, 0.05, Side::Greater, 0.99, 1, 200).first.has_value());
}
