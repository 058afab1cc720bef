#include "analysis/statistics/mcnemar/mcnemar.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace palpate::analysis;

TEST(McNemar, AgreesWithAgrestiAndR) {
  // Agresti, Categorical Data Analysis (2nd ed., section 10.1): approval of the Prime Minister, z^2 = 17.36,
  // difference 0.04 with interval (0.02, 0.06). The rest by R 4.2, m <- matrix(c(794, 86, 150, 570), 2):
  const McNemarTest test = mcnemar_test({794, 86, 150, 570});
  EXPECT_NEAR(test.chi_squared, 17.3559322033898, 1e-10);  // mcnemar.test(m, correct = FALSE)
  EXPECT_NEAR(test.p_asymptotic, 3.09929344104522e-05, 1e-14);
  EXPECT_NEAR(test.chi_squared_corrected, 16.81779661017, 1e-10);  // mcnemar.test(m)
  EXPECT_NEAR(test.p_asymptotic_corrected, 4.11456228135e-05, 1e-13);
  EXPECT_NEAR(test.exact.two_sided, 3.71593613957143e-05, 1e-14);  // binom.test(86, 236)$p.value
  // less dbinom(86, 236, .5), Fagerland et al. 2013
  EXPECT_NEAR(test.mid_p.two_sided, 2.89338951761547e-05, 1e-14);
  EXPECT_NEAR(test.difference, -0.04, 1e-15);
  EXPECT_NEAR(test.difference_interval.lower, -0.06, 0.005);
  EXPECT_NEAR(test.difference_interval.upper, -0.02, 0.005);
  // b <- binom.test(86, 236)$conf.int; b/(1 - b)
  EXPECT_NEAR(test.odds_ratio_interval.lower, 0.434597606083669, 1e-9);
  EXPECT_NEAR(test.odds_ratio_interval.upper, 0.752316239171127, 1e-9);
}

TEST(McNemar, SaysNothingWithoutDiscordantPairs) {
  const McNemarTest test = mcnemar_test({10, 0, 0, 5});
  EXPECT_EQ(test.exact.two_sided, 1.0);
  EXPECT_EQ(test.p_asymptotic, 1.0);
  EXPECT_EQ(test.chi_squared, 0.0);
  EXPECT_TRUE(std::isnan(test.odds_ratio));
  EXPECT_TRUE(std::isinf(test.odds_ratio_interval.upper));
}

TEST(McNemar, ExchangingTheAnswersExchangesTheSides) {
  const McNemarTest one = mcnemar_test({3, 7, 2, 5}), other = mcnemar_test({3, 2, 7, 5});
  EXPECT_NEAR(one.exact.greater, other.exact.less, 1e-15);
  EXPECT_NEAR(one.mid_p.two_sided, other.mid_p.two_sided, 1e-15);
  EXPECT_EQ(one.difference, -other.difference);
}

TEST(McNemar, RefusesWhatIsNoTable) {
  EXPECT_THROW(mcnemar_test({0, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(mcnemar_test({1, -2, 3, 4}), std::invalid_argument);
}

TEST(McNemar, AgreesWithFagerlandsMidP) {
  // Fagerland, Lydersen & Laake 2013, table 1 (Bentur et al.): 1, 1, 7, 12; exact 0.0703, mid-p 0.0391.
  // statsmodels 0.13: mcnemar([[1, 1], [7, 12]], exact=True).pvalue is 0.0703125; less dbinom(1, 8, .5).
  const McNemarTest bentur = mcnemar_test({1, 1, 7, 12});
  EXPECT_NEAR(bentur.exact.two_sided, 0.0703125, 1e-15);
  EXPECT_NEAR(bentur.mid_p.two_sided, 0.0390625, 1e-15);
  // Their supplement: with as many pairs on both sides 1 - dbinom(5, 10, .5)/2.
  EXPECT_NEAR(mcnemar_test({3, 5, 5, 2}).mid_p.two_sided, 0.876953125, 1e-15);
}
