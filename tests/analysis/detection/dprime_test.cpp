#include "analysis/detection/dprime.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/interval_bias/interval_bias.hpp"

using namespace palpate::analysis;

TEST(DPrime2IFC, AgreesWithPublishedTable) {
  // Hacker & Ratcliff 1979, table for two alternatives; Macmillan & Creelman 2005, table A5.7, two decimals.
  // R 4.2: sqrt(2) * qnorm(c(.55, .60, .65, .70, .75, .80, .85, .90, .95, .99))
  const double table[][2] = {{55, 0.18}, {60, 0.36}, {65, 0.54}, {70, 0.74}, {75, 0.95},
                             {80, 1.19}, {85, 1.47}, {90, 1.81}, {95, 2.33}, {99, 3.29}};
  for (const auto& [percent, expected] : table) {
    const DPrime d = dprime_2ifc(std::lround(percent), 100, DPrimeCorrection::HalfTrial);
    EXPECT_NEAR(d.d_prime, expected, 0.005 + 1e-6) << percent << " %";
    EXPECT_FALSE(d.corrected);
  }
}

TEST(DPrime2IFC, AgreesWithR) {
  const DPrime d = dprime_2ifc(41, 60, DPrimeCorrection::HalfTrial);
  EXPECT_NEAR(d.d_prime, 0.674637043770044, 1e-12);         // sqrt(2) * qnorm(41/60)
  EXPECT_NEAR(d.standard_error, 0.238540681301073, 1e-12);  // p <- 41/60; sqrt(2*p*(1-p)/60)/dnorm(qnorm(p))
  EXPECT_NEAR(d.interval.lower, 0.179285329943904, 1e-9);   // sqrt(2) * qnorm(binom.test(41, 60)$conf.int)
  EXPECT_NEAR(d.interval.upper, 1.177272043735068, 1e-9);
}

TEST(DPrime2IFC, CorrectsNothingAndEverythingByNamedRules) {
  EXPECT_TRUE(std::isinf(dprime_2ifc(20, 20, DPrimeCorrection::None).d_prime));
  const DPrime half = dprime_2ifc(20, 20, DPrimeCorrection::HalfTrial);
  EXPECT_NEAR(half.d_prime, 2.77180764869936, 1e-12);  // R 4.2: sqrt(2) * qnorm(1 - 1/40)
  EXPECT_TRUE(half.corrected);
  EXPECT_NE(half.method.source.find("Macmillan & Kaplan 1985"), std::string::npos);
  EXPECT_TRUE(std::isinf(half.interval.upper));
  const DPrime log_linear = dprime_2ifc(20, 20, DPrimeCorrection::LogLinear);
  EXPECT_NEAR(log_linear.d_prime, 2.80120690304159, 1e-12);  // R 4.2: sqrt(2) * qnorm(20.5/21)
  EXPECT_NE(log_linear.method.source.find("Hautus 1995"), std::string::npos);
  EXPECT_NEAR(dprime_2ifc(0, 20, DPrimeCorrection::HalfTrial).d_prime, -half.d_prime, 1e-12);
}

TEST(IntervalBias, FindsAPreferenceThatTheProportionCorrectHides) {
  // 30 of 30 right when the first interval is the harder, 10 of 30 when the second is: 50 answers "1" of 60
  const IntervalBias bias = interval_bias({30, 30, 10, 30}, DPrimeCorrection::HalfTrial);
  EXPECT_EQ(bias.answers_first, 50);
  EXPECT_NEAR(bias.hit_rate_second, 1.0 / 3, 1e-15);
  EXPECT_NEAR(bias.p.two_sided, 1.61638145661571e-07, 1e-15);  // R 4.2: binom.test(50, 60)$p.value
  ASSERT_TRUE(bias.d_prime.has_value());
  // R 4.2: H <- qnorm(1 - 1/60); F <- qnorm(1/3); (H + F)/sqrt(2); (F - H)/2
  EXPECT_NEAR(bias.d_prime->d_prime, 1.20018502158993, 1e-12);
  EXPECT_NEAR(bias.d_prime->criterion, -1.27938626674022, 1e-12);
}

TEST(IntervalBias, IsSilentAboutAnOrderThatNeverCame) {
  const IntervalBias bias = interval_bias({3, 4, 0, 0}, DPrimeCorrection::HalfTrial);
  EXPECT_TRUE(std::isnan(bias.hit_rate_second));
  EXPECT_FALSE(bias.d_prime.has_value());
  EXPECT_THROW(interval_bias({0, 0, 0, 0}, DPrimeCorrection::HalfTrial), std::invalid_argument);
}

TEST(IntervalBias, GivesDPrimeOfBothOrdersItsInterval) {
  // R 4.2: g <- glm(cbind(c(26, 15), c(4, 15)) ~ c(.5, -.5), family = binomial("probit")), the second row the
  // answers "first" where the second was correct; its slope, standard error and confint(), each over sqrt(2)
  const DPrimeByOrder d = dprime_2ifc_by_order(26, 30, 15, 30, DPrimeCorrection::None);
  EXPECT_NEAR(d.d_prime, 0.785434142473, 1e-9);
  EXPECT_NEAR(d.standard_error, 0.260265727408, 1e-6);
  EXPECT_NEAR(d.interval.lower, 0.287329406741, 5e-5);  // confint interpolates the profile
  EXPECT_NEAR(d.interval.upper, 1.31164935799, 5e-5);
}
