#include "analysis/mixed/link.hpp"

#include <gtest/gtest.h>

using namespace palpate::analysis;

namespace {

class LinkAt : public testing::TestWithParam<std::tuple<Link, double>> {};

}  // namespace

TEST_P(LinkAt, HasTheDerivativesOfItsLogarithm) {
  const auto [link, eta] = GetParam();
  const double h = 1e-4 * std::max(1.0, std::abs(eta));
  const auto at = [link = link](double x) { return likelihood(link, x, 2, 5); };
  const BinaryLikelihood here = at(eta), up = at(eta + h), down = at(eta - h);
  // The error of a central difference is h^2/6 times a third derivative of order 1 (or less).
  EXPECT_NEAR((up.log - down.log) / (2 * h), here.score, 1e-7 * std::max(1.0, std::abs(here.score)));
  EXPECT_NEAR((down.score - up.score) / (2 * h), here.curvature, 1e-7);
  EXPECT_NEAR((up.curvature - down.curvature) / (2 * h), here.curvature_slope, 1e-7);
  EXPECT_GE(here.curvature, 0);
}

INSTANTIATE_TEST_SUITE_P(Predictors, LinkAt,
                         testing::Combine(testing::Values(Link::Logit, Link::Probit),
                                          testing::Values(-36.0, -8.0, -1.5, -0.1, 0.3, 2.0, 9.0, 36.0)));

TEST(Link, AgreesWithRFarOut) {
  // R 4.2: options(digits = 16); pnorm(c(-50, -36, -10, 3), log.p = TRUE)
  EXPECT_NEAR(normal_tail(-50).log / -1254.83136113942, 1, 1e-13);
  EXPECT_NEAR(normal_tail(-36).log / -652.503227593798, 1, 1e-13);
  EXPECT_NEAR(normal_tail(-10).log / -53.2312851505125, 1, 1e-13);
  EXPECT_NEAR(normal_tail(3).log / -0.00135080996474819, 1, 1e-12);
  // dlogis and plogis: plogis(c(-50, 3), log.p = TRUE)
  EXPECT_NEAR(logit_likelihood(-50, 1, 1).log, -50, 1e-13);
  EXPECT_NEAR(logit_likelihood(3, 1, 1).log / -0.0485873515737421, 1, 1e-13);
}

TEST(Link, HasItsQuantiles) {
  EXPECT_NEAR(quantile_of(Link::Probit, 0.75), 0.674489750196082, 1e-14);  // R: qnorm(.75)
  EXPECT_NEAR(quantile_of(Link::Logit, 0.75), std::log(3), 1e-14);
}
