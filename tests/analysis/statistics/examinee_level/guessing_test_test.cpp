#include "analysis/statistics/examinee_level/guessing_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <random>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/statistics/examinee_level/examinee_level.hpp"
#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

// R 4.2: g <- expand.grid(0:4, 0:5, 0:6); n <- c(4, 5, 6); k <- c(3, 2, 4)
//   p <- dbinom(g[,1], 4, 1/3) * dbinom(g[,2], 5, 1/3) * dbinom(g[,3], 6, 1/3)
//   st <- function(x) { m <- mean(x); (m - 1/3)/sqrt(max(var(x), mean(2/9/n))/3) }
//   T <- apply(sweep(as.matrix(g), 2, n, "/"), 1, st); t <- st(k/n)
//   sum(p[T >= t - 1e-9]); sum(p[T <= t + 1e-9]); t.test(k/n, mu = 1/3)$conf.int
TEST(GuessingTest, IsREnumerationOfGuessing) {
  const std::vector<ExamineeCount> counts{{3, 4}, {2, 5}, {4, 6}};
  const ExamineeLevelTest test = examinee_level_test(counts, 1.0 / 3);
  EXPECT_TRUE(test.test.exact);
  EXPECT_NEAR(test.p.greater, 0.0129500456027766, 1e-12);
  EXPECT_NEAR(test.p.less, 0.9897261164212717, 1e-12);
  EXPECT_NEAR(test.p.two_sided, 2 * 0.0129500456027766, 1e-12);
  EXPECT_NEAR(test.interval.lower, 0.151386656304223, 1e-12);
  EXPECT_EQ(test.interval.upper, 1.0);  // R: 1.0597
}

// One examinee's is the exact binomial test.
TEST(GuessingTest, OfOneExamineeIsTheBinomialTest) {
  for (long correct = 0; correct <= 15; ++correct) {
    const ExamineeLevelTest test = examinee_level_test(std::vector<ExamineeCount>{{correct, 15}}, 0.25);
    EXPECT_NEAR(test.p.greater, binomial_p(correct, 15, 0.25).greater, 1e-12);
    EXPECT_NEAR(test.p.less, binomial_p(correct, 15, 0.25).less, 1e-12);
    EXPECT_TRUE(std::isnan(test.interval.lower));
  }
}

// Where the exact distribution takes too many steps: 4 standard errors of R's million and our 99999.
// R 4.2: set.seed(1); n <- rep(30, 20); st as above with /20; k as below
//   x <- matrix(rbinom(2e7, 30, 1/3)/30, 20); mean(st(x) >= st(k/n) - 1e-9)
TEST(GuessingTest, SamplesWhatCannotBeCounted) {
  std::vector<ExamineeCount> counts;
  for (const long correct : {12, 9, 15, 10, 8, 14, 11, 13, 9, 12, 16, 7, 10, 12, 14, 11, 9, 13, 10, 12})
    counts.push_back({.correct = correct, .trials = 30});
  const SignFlipTest test = guessing_test(counts, 1.0 / 3, {});
  EXPECT_FALSE(test.exact);
  EXPECT_EQ(test.resamples, 99'999);
  constexpr double kR = 0.00805700;
  EXPECT_NEAR(test.p.greater, kR, 4 * std::sqrt(kR * (1 - kR) * 1.1e-5));
}

// People differ about chance: probabilities of a beta distribution with mean 1/3, gamma 0.18. 20 examinees are
// enough for the level to be near 5 %: within 3 standard errors of 400 studies and a point for the skewness.
TEST(GuessingTest, KeepsItsLevelWherePeopleDiffer) {
  std::mt19937_64 random(8);
  std::gamma_distribution<double> a(1.5), b(3.0);
  constexpr int kStudies = 400;
  int above = 0, pooled_above = 0;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<ExamineeCount> counts;
    long correct = 0;
    for (int i = 0; i < 20; ++i) {
      const double x = a(random), p = x / (x + b(random));
      counts.push_back({.correct = std::binomial_distribution<long>(10, p)(random), .trials = 10});
      correct += counts.back().correct;
    }
    above += guessing_test(counts, 1.0 / 3, {.resamples = 999}).p.greater <= 0.05;
    pooled_above += binomial_p(correct, 200, 1.0 / 3).greater <= 0.05;
  }
  EXPECT_NEAR(above / double(kStudies), 0.05, 3 * std::sqrt(0.05 * 0.95 / kStudies) + 0.01);
  EXPECT_GT(pooled_above / double(kStudies), 0.10);  // the pooled test takes them for one person
}

TEST(ExamineeLevelStatistic, TakesAnyChance) {
  const nlohmann::ordered_json data = {{"correct", {3, 2, 4}}, {"trials", {4, 5, 6}}};
  const Outcome outcome = run_statistic("examinee-level", {{"data", data}, {"chance", "1/3"}});
  EXPECT_NEAR(outcome.json["p"], 0.0129500456027766, 1e-12);
  EXPECT_THAT(outcome.text, HasSubstr("studentised mean against guessing, exact"));
  EXPECT_THAT(refusal_of("examinee-level", {{"data", data}, {"chance", 1}}), HasSubstr("chance"));
}
