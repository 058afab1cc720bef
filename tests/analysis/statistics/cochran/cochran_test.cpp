#include "analysis/statistics/cochran/cochran.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis/statistics/mcnemar/mcnemar.hpp"

using namespace palpate::analysis;

TEST(Cochran, AgreesWithConoversExample) {
  // Conover 1999, section 4.6: three sportsmen predict twelve games, T = 2.8, p between 0.1 and 0.25.
  // statsmodels 0.13: cochrans_q(x) of the same: 2.8, 0.24659696394160646
  const CochranTest test = cochran_test({{1, 1, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1},
                                         {1, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1},
                                         {1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1}});
  EXPECT_NEAR(test.q, 2.8, 1e-12);
  EXPECT_NEAR(test.p_asymptotic, 0.24659696394160646, 1e-12);
  EXPECT_EQ(test.informative, 5U);
}

TEST(Cochran, AgreesWithStatsmodels) {
  const CochranTest test = cochran_test({{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0},
                                         {1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 0},
                                         {1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 0, 1}});
  // statsmodels 0.13: cochrans_q(np.array([..]).T)
  EXPECT_NEAR(test.q, 10.571428571428571, 1e-12);
  EXPECT_NEAR(test.p_asymptotic, 0.005063414171757494, 1e-14);
  EXPECT_EQ(test.degrees_of_freedom, 2);
  // python: a dictionary of column sums, each row added in all orders of set(itertools.permutations(row))
  EXPECT_NEAR(test.p_exact.value(), 0.0027434842249657062, 1e-15);
  EXPECT_NEAR(test.eta_squared, 10.571428571428571 / 24, 1e-14);
  // numpy: sorted Q/24 of 20000 resamples of the rows; the effect takes a few values only
  EXPECT_NEAR(test.eta_squared_interval.lower, 0.25, 0.01);
  EXPECT_NEAR(test.eta_squared_interval.upper, 0.6759, 0.02);
}

TEST(Cochran, OfTwoColumnsIsMcNemars) {
  const CochranTest two = cochran_test({{1, 1, 1, 1, 1, 1, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1, 1, 1, 1, 0}});
  const McNemarTest mcnemar = mcnemar_test({2, 5, 2, 1});
  EXPECT_NEAR(two.q, mcnemar.chi_squared, 1e-14);
  EXPECT_NEAR(two.p_asymptotic, mcnemar.p_asymptotic, 1e-14);
  EXPECT_NEAR(two.p_exact.value(), mcnemar.exact.two_sided, 1e-14);
}

TEST(Cochran, HasNothingToSayWithoutDifferentAnswers) {
  const CochranTest test = cochran_test({{1, 0, 1}, {1, 0, 1}});
  EXPECT_EQ(test.q, 0);
  EXPECT_EQ(test.p_asymptotic, 1);
  EXPECT_EQ(test.informative, 0U);
}

TEST(Cochran, RefusesWhatIsNoAnswer) {
  EXPECT_THROW(cochran_test({{0, 1, 2}, {0, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(cochran_test({{0, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(cochran_test({{0, 1, 1}, {0, 1}}), std::invalid_argument);
}
