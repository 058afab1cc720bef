#include "analysis/statistics/friedman/friedman.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace palpate::analysis;
using testing::ElementsAre;

namespace {

// Times to round first base by three methods, 22 players: Hollander & Wolfe 1973, p. 140, in R's
// ?friedman.test.
const std::vector<std::vector<double>> kRounding = {
    {5.40, 5.85, 5.20, 5.55, 5.90, 5.45, 5.40, 5.45, 5.25, 5.85, 5.25,
     5.65, 5.60, 5.05, 5.50, 5.45, 5.55, 5.45, 5.50, 5.65, 5.70, 6.30},
    {5.50, 5.70, 5.60, 5.50, 5.85, 5.55, 5.40, 5.50, 5.15, 5.80, 5.20,
     5.55, 5.35, 5.00, 5.50, 5.55, 5.55, 5.50, 5.45, 5.60, 5.65, 6.30},
    {5.55, 5.75, 5.50, 5.40, 5.70, 5.60, 5.35, 5.35, 5.00, 5.70, 5.10,
     5.45, 5.45, 4.95, 5.40, 5.50, 5.35, 5.55, 5.25, 5.40, 5.55, 6.25}};

const std::vector<std::vector<double>> kEight = {{2.1, 1.8, 2.5, 1.9, 2.2, 2.0, 2.4, 1.7},
                                                 {2.6, 2.0, 2.4, 2.3, 2.2, 2.5, 2.9, 2.1},
                                                 {3.0, 2.4, 2.9, 2.2, 2.8, 2.6, 2.7, 2.5}};

}  // namespace

TEST(Friedman, AgreesWithHollanderAndWolfeAndR) {
  const FriedmanTest test = friedman_test(kRounding);
  EXPECT_NEAR(test.chi_squared, 11.1428571428571, 1e-12);  // R 4.2: friedman.test(RoundingTimes), p. 142
  EXPECT_NEAR(test.p_asymptotic, 0.00380504077551136, 1e-15);
  EXPECT_EQ(test.degrees_of_freedom, 2);
  EXPECT_TRUE(test.ties);
  EXPECT_NEAR(test.kendall_w, 0.253246753246753, 1e-14);  // R 4.2: 11.142857/(22*2)
  // R 4.2: the distribution of the rank sums, row by row, each row's ranks in all distinct orders; the sum of
  // the probabilities of those whose sum of squares is at least the one seen
  EXPECT_NEAR(test.p_exact.value(), 0.00314982728160881, 1e-14);
}

TEST(Friedman, BootstrapsKendallsWLikeR) {
  const FriedmanTest test = friedman_test(kEight);
  EXPECT_NEAR(test.chi_squared, 10.129032258064516,
              1e-12);  // R 4.2: friedman.test(cbind(none, sibille, kuroda))
  EXPECT_NEAR(test.p_exact.value(), 0.00332218792866941, 1e-15);  // as above
  EXPECT_THAT(test.mean_ranks, ElementsAre(9.5 / 8, 16.5 / 8, 22.0 / 8));
  // R 4.2: quantile(replicate(20000, W(R[sample(8, 8, TRUE), ])), c(.025, .975), type = 6), set.seed(1); W
  // takes a few values only, so other random numbers give the same ends
  EXPECT_NEAR(test.w_interval.lower, 0.4375, 0.01);
  EXPECT_NEAR(test.w_interval.upper, 0.890625, 0.01);
}

TEST(Friedman, LooksAtNothingButRanks) {
  auto stretched = kEight;
  for (auto& column : stretched) {
    for (double& value : column) value = std::exp(value);
  }
  const FriedmanTest one = friedman_test(kEight), other = friedman_test(stretched);
  EXPECT_EQ(one.chi_squared, other.chi_squared);
  EXPECT_EQ(one.p_exact, other.p_exact);
  EXPECT_EQ(one.w_interval.upper, other.w_interval.upper);
}

TEST(Friedman, HasNothingToSayWhereAllIsTied) {
  const FriedmanTest test = friedman_test({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(test.chi_squared, 0);
  EXPECT_EQ(test.p_asymptotic, 1);
  EXPECT_EQ(test.p_exact, 1.0);
  EXPECT_TRUE(std::isnan(test.kendall_w));
}

TEST(Friedman, RefusesWhatItCannotRank) {
  EXPECT_THROW(friedman_test({{1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(friedman_test({{1}, {2}}), std::invalid_argument);
  EXPECT_THROW(friedman_test({{1, 2}, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(friedman_test({{1, NAN}, {1, 2}}), std::invalid_argument);
}
