#include "analysis/statistics/wilcoxon/signed_rank.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/sign/sign_test.hpp"

using namespace palpate::analysis;

namespace {

// Hollander & Wolfe 1973, p. 29 (depression before and after tranquiliser), from the help of R's wilcox.test.
std::vector<double> depression() {
  const double x[] = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const double y[] = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> d;
  for (int i = 0; i < 9; ++i) d.push_back(x[i] - y[i]);
  return d;
}

const std::vector<double> kTied{2, 1, 0, -1, 3, 2, 0, 1, -2, 4, 1, 1, 0, 2, -1};

}  // namespace

TEST(SignedRank, AgreesWithROnHollanderAndWolfe) {
  // R 4.2: wilcox.test(x, y, paired = TRUE, alternative = ..., exact = TRUE, conf.int = TRUE)
  const SignedRankTest test = signed_rank_test(depression(), Zeros::Drop);
  EXPECT_TRUE(test.exact);
  EXPECT_FALSE(test.ties);
  EXPECT_EQ(test.v, 40.0);
  EXPECT_NEAR(test.p.greater, 0.01953125, 1e-15);
  EXPECT_NEAR(test.p.less, 0.986328125, 1e-15);
  EXPECT_NEAR(test.p.two_sided, 0.0390625, 1e-15);
  EXPECT_NEAR(test.pseudo_median, 0.46, 1e-12);
  EXPECT_NEAR(test.interval.lower, 0.01, 1e-12);
  EXPECT_NEAR(test.interval.upper, 0.786, 1e-12);
}

TEST(SignedRank, IsExactWithTiesAndZeros) {
  // R 4.2, all 2^12 signs: r <- rank(abs(d)); r <- r[d != 0] (Pratt) or d <- d[d != 0]; r <- rank(abs(d))
  // (dropped);
  //   D <- as.matrix(expand.grid(rep(list(0:1), 12))) %*% r; mean(D >= V); mean(D <= V)
  const SignedRankTest dropped = signed_rank_test(kTied, Zeros::Drop),
                       pratt = signed_rank_test(kTied, Zeros::Pratt);
  EXPECT_EQ(dropped.v, 62.5);
  EXPECT_EQ(dropped.zeros, 3u);
  EXPECT_TRUE(dropped.ties);
  EXPECT_NEAR(dropped.p.greater, 0.038818359375, 1e-14);
  EXPECT_NEAR(dropped.p.less, 0.977294921875, 1e-14);
  EXPECT_NEAR(dropped.p.two_sided, 0.07763671875, 1e-14);
  EXPECT_EQ(pratt.v, 89.5);
  EXPECT_NEAR(pratt.p.greater, 0.03662109375, 1e-14);
  EXPECT_NEAR(pratt.p.two_sided, 0.0732421875, 1e-14);
}

TEST(SignedRank, ApproximatesBeyondWhatIsExactAndSaysSo) {
  // R 4.2: d <- (1:600) * ifelse((1:600) %% 5 < 3, 1, -1);
  //   wilcox.test(d, exact = FALSE, correct = TRUE, alternative = "greater")$p.value
  std::vector<double> d;
  for (int i = 1; i <= 600; ++i) d.push_back(i % 5 < 3 ? i : -i);
  const SignedRankTest test = signed_rank_test(d, Zeros::Drop);
  EXPECT_FALSE(test.exact);
  EXPECT_NE(test.method.name.find("normal approximation"), std::string::npos);
  EXPECT_NEAR(test.p.greater / 1.2431486782632e-05, 1.0, 1e-8);
}

TEST(SignedRank, IsSymmetric) {
  EXPECT_TRUE(rc::check([] {
    const auto whole =
        *rc::gen::container<std::vector<int>>(*rc::gen::inRange(1, 30), rc::gen::inRange(-6, 7));
    const Zeros zeros = *rc::gen::element(Zeros::Drop, Zeros::Pratt);
    std::vector<double> d(whole.begin(), whole.end()), mirrored = d;
    for (double& value : mirrored) value = -value;
    const SignedRankTest test = signed_rank_test(d, zeros), mirror = signed_rank_test(mirrored, zeros);
    RC_ASSERT(std::abs(test.p.greater - mirror.p.less) < 1e-12);
    RC_ASSERT(std::abs(test.p.two_sided - mirror.p.two_sided) < 1e-12);
    RC_ASSERT(std::abs(test.pseudo_median + mirror.pseudo_median) < 1e-12);
    RC_ASSERT(test.p.greater > 0 && test.p.greater <= 1);
    RC_ASSERT(test.interval.lower <= test.pseudo_median && test.pseudo_median <= test.interval.upper);
  }));
}

TEST(SignedRank, HasNothingToSayOfZeros) {
  const SignedRankTest test = signed_rank_test(std::vector<double>{0, 0, 0}, Zeros::Pratt);
  EXPECT_EQ(test.p.two_sided, 1.0);
  EXPECT_EQ(test.rank_biserial, 0.0);
  EXPECT_THROW(signed_rank_test({}, Zeros::Pratt), std::invalid_argument);
}

TEST(SignTest, AgreesWithTheBinomial) {
  const SignTest test = sign_test(kTied);  // 9 positive, 3 negative, 3 zeros
  EXPECT_EQ(test.positive, 9);
  EXPECT_EQ(test.zeros, 3);
  EXPECT_NEAR(test.p.greater, 0.072998046875, 1e-15);  // R 4.2: binom.test(9, 12, alternative = "greater")
  EXPECT_EQ(test.median, 1.0);
  // R 4.2: sort(d)[c(qbinom(.025, 15, .5), 15 - qbinom(.025, 15, .5) + 1)]
  EXPECT_EQ(test.interval.lower, 0.0);
  EXPECT_EQ(test.interval.upper, 2.0);
  EXPECT_NEAR(sign_test_of_counts(12, 3).p.greater, 0.017578125,
              1e-15);  // binom.test(12, 15, alternative = "greater")
  EXPECT_EQ(sign_test_of_counts(0, 0).p.two_sided, 1.0);
}

TEST(SignedRank, BootstrapsItsEffectSizeLikeR) {
  // R 4.2: rb <- function(d) {d0 <- d[d != 0]; r <- rank(abs(d))[d != 0]; (sum(r[d0 > 0]) - sum(r[d0 <
  // 0]))/sum(r)}; quantile(replicate(40000, rb(sample(d, 10, TRUE))), c(.025, .975), type = 6): few values,
  // so the ends agree
  const std::vector<double> d = {3, 1, 2, -1, 4, 2, 0, 3, 1, 2};
  EXPECT_NEAR(signed_rank_test(d, Zeros::Pratt).rank_biserial, 0.888888888888889, 1e-14);
  const Interval interval = rank_biserial_interval(d, Zeros::Pratt, {});
  EXPECT_NEAR(interval.lower, 0.538461538461538, 0.01);
  EXPECT_EQ(interval.upper, 1);
}

TEST(SignTest, GivesTheShareOfPositiveDifferences) {
  const SignTest test = sign_test(std::vector<double>{3, 1, 2, -1, 4, 2, 0, 3, 1, 2});
  EXPECT_NEAR(test.share_positive, 8.0 / 9, 1e-15);
  EXPECT_NEAR(test.share_interval.lower, 0.517503485082663, 1e-9);  // R 4.2: binom.test(8, 9)$conf.int
  EXPECT_NEAR(test.share_interval.upper, 0.997190863253401, 1e-9);
  EXPECT_TRUE(std::isnan(sign_test(std::vector<double>{0, 0}).share_positive));
}
