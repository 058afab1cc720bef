#include "analysis/mixed/glmm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/analysis/mixed/support/data_sets.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

double error_of(const GlmmFit& fit, int k) {
  return std::sqrt(fit.covariance(k, k));
}

void expect_fit(const GlmmFit& fit, double intercept, double slope, double error_intercept,
                double error_slope, double tolerance) {
  EXPECT_TRUE(fit.convergence.converged) << fit.convergence.reason;
  EXPECT_NEAR(fit.fixed[0], intercept, tolerance);
  EXPECT_NEAR(fit.fixed[1], slope, tolerance);
  EXPECT_NEAR(error_of(fit, 0), error_intercept, tolerance);
  EXPECT_NEAR(error_of(fit, 1), error_slope, tolerance);
}

std::string refusal_of(const std::vector<LevelAnswers>& answers) {
  try {
    observations(answers);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "it was not refused";
  return "";
}

}  // namespace

// R 4.2, lme4 1.1-31: cb <- cbpp; cb$level <- as.integer(cb$period); long <- one row for each animal with y 0
// or 1; m <- glmer(y ~ level + (1|herd), long, binomial(LINK), nAGQ = N, control = glmerControl(tolPwrss =
// 1e-12)); fixef(m); sqrt(diag(vcov(m))); VarCorr(m); logLik(m). lme4 stops within some 3e-5 of the maximum,
// and its standard errors are finite differences, hence tolerances of 5e-5.
TEST(Glmm, AgreesWithLme4OnPleuropneumonia) {
  const Observations data = observations(pleuropneumonia());
  const GlmmFit laplace = fit_glmm(data, {.link = Link::Logit, .nodes = 1});
  expect_fit(laplace, -0.9323444, -0.5594040, 0.3041916, 0.1233779, 5e-5);
  EXPECT_NEAR(laplace.spread.intercept, 0.6637212, 5e-5);
  EXPECT_NEAR(laplace.log_likelihood, -93.28466296, 1e-7);  // of the counts; likewise
  const GlmmFit logit = fit_glmm(data, {.link = Link::Logit, .nodes = 25});
  expect_fit(logit, -0.9333608, -0.5590008, 0.3050785, 0.1234162, 5e-5);
  EXPECT_NEAR(logit.log_likelihood - data.log_ways, -278.7131588, 1e-7);
  const GlmmFit probit = fit_glmm(data, {.link = Link::Probit, .nodes = 25});
  expect_fit(probit, -0.6151012, -0.2802381, 0.1612989, 0.0613152, 5e-5);
  EXPECT_NEAR(probit.spread.intercept, 0.3550765, 5e-5);
  EXPECT_NEAR(probit.log_likelihood - data.log_ways, -279.4873407, 1e-6);
}

TEST(Glmm, TakesTheObservedCurvatureInLaplacesApproximation) {
  // R 4.2, for each herd h, with p the three parameters: g <- function(u) sum(dbinom(h$incidence, h$size,
  // pnorm(p[1] + p[2]*h$level + p[3]*u), log = TRUE)) - u^2/2; m <- optimize(g, c(-6, 6), maximum = TRUE);
  // g(m) - log(-g''(m))/2, g'' by differences; summed, and maximised by optim(method = "BFGS").
  const GlmmFit fit = fit_glmm(observations(pleuropneumonia()), {.link = Link::Probit, .nodes = 1});
  EXPECT_NEAR(fit.fixed[0], -0.614822039, 1e-5);
  EXPECT_NEAR(fit.fixed[1], -0.280384721, 1e-5);
  EXPECT_NEAR(fit.spread.intercept, 0.354029210, 1e-5);
  EXPECT_NEAR(fit.log_likelihood, -94.0297265028, 1e-7);
}

TEST(Glmm, AgreesWithLme4WithARandomSlope) {
  // glmer(cbind(ones, 10 - ones) ~ level + (1 + level|examinee), d, binomial("logit"))
  const GlmmFit fit = fit_glmm(observations(eight_examinees()),
                               {.link = Link::Logit, .random = RandomEffects::Slope, .nodes = 1});
  expect_fit(fit, -0.02034990, 0.95270051, 0.3749184, 0.1359221, 5e-5);
  EXPECT_NEAR(fit.covariance(0, 1), 0.0250492, 5e-5);
  EXPECT_NEAR(fit.spread.intercept, 0.99481029, 5e-5);
  EXPECT_NEAR(*fit.spread.slope, 0.29867328, 5e-5);
  EXPECT_NEAR(*fit.spread.correlation, 0.64727247, 1e-4);
  EXPECT_NEAR(fit.log_likelihood, -93.95058963, 1e-7);
}

TEST(Glmm, AgreesWithAFineRuleForTwoEffects) {
  // R 4.2: the integral over both effects by a product of statmod::gauss.quad.prob(200, "normal") about 0,
  // optim(method = "BFGS", control = list(reltol = 1e-14)), standard errors by optimHess(ndeps = 1e-3).
  const Observations data = observations(eight_examinees());
  const GlmmFit logit = fit_glmm(data, {.link = Link::Logit, .random = RandomEffects::Slope, .nodes = 15});
  expect_fit(logit, -0.02021582, 0.95325542, 0.37533005, 0.13721702, 3e-5);
  EXPECT_NEAR(logit.spread.intercept, 0.99599325, 1e-4);
  EXPECT_NEAR(*logit.spread.slope, 0.30293177, 1e-4);
  EXPECT_NEAR(*logit.spread.correlation, 0.6419415, 1e-4);
  EXPECT_NEAR(logit.log_likelihood, -93.90884819, 1e-6);
  const GlmmFit probit = fit_glmm(data, {.link = Link::Probit, .random = RandomEffects::Slope, .nodes = 15});
  expect_fit(probit, -0.00891165, 0.54491386, 0.21349715, 0.07438655, 3e-5);
  EXPECT_NEAR(*probit.spread.correlation, 0.68619695, 1e-4);
  EXPECT_NEAR(probit.log_likelihood, -94.45392688, 1e-6);
}

TEST(Glmm, WithoutVarianceIsAGeneralisedLinearModel) {
  // R 4.2: m <- glm(cbind(correct, 10 - correct) ~ level, binomial("logit"), control = list(epsilon =
  // 1e-14)); coef(m); sqrt(diag(vcov(m))); logLik(m)
  const Observations data = observations(four_alike());
  for (const RandomEffects random : {RandomEffects::Intercept, RandomEffects::Slope}) {
    const GlmmFit fit = fit_glmm(data, {.link = Link::Logit, .random = random, .nodes = 3});
    EXPECT_TRUE(fit.singular);
    EXPECT_EQ(fit.spread.intercept, 0);
    EXPECT_FALSE(fit.spread.correlation);
    expect_fit(fit, -3.215624156714, 1.286249662686, 0.541083442, 0.202240172, 2e-7);
    EXPECT_NEAR(fit.log_likelihood, -19.976578852661, 1e-9);
  }
  const GlmmFit probit = fit_glmm(data, {.link = Link::Probit});
  EXPECT_NEAR(probit.fixed[0], -1.9186285733279, 1e-7);
  EXPECT_NEAR(probit.fixed[1], 0.7674514293312, 1e-7);
  EXPECT_NEAR(probit.log_likelihood, -19.9701833630394, 1e-9);
}

TEST(Glmm, CountsAndSingleAnswersAreOneModel) {
  std::vector<LevelAnswers> single;
  for (const LevelAnswers& row : pleuropneumonia()) {
    for (long k = 0; k < row.trials; ++k) single.push_back({row.examinee, row.level, k < row.ones, 1});
  }
  const Observations counts = observations(pleuropneumonia()), answers = observations(single);
  const GlmmFit one = fit_glmm(counts, {}), other = fit_glmm(answers, {});
  EXPECT_EQ(one.fixed, other.fixed);
  EXPECT_EQ(answers.log_ways, 0);
  EXPECT_NEAR(one.log_likelihood - counts.log_ways, other.log_likelihood, 1e-10);
}

TEST(Glmm, FollowsTheUnitOfTheLevelAndTheNamingOfTheAnswers) {
  // Tolerances: both fits stop within 1e-8 of their log-likelihood's maximum before a last Newton step.
  const GlmmOptions options{.link = Link::Probit, .random = RandomEffects::Slope, .nodes = 3};
  const GlmmFit metres = fit_glmm(observations(eight_examinees()), options);
  std::vector<LevelAnswers> changed = eight_examinees();
  for (LevelAnswers& row : changed) row.level = 1000 * row.level + 5000;
  const GlmmFit millimetres = fit_glmm(observations(changed), options);
  EXPECT_NEAR(millimetres.fixed[1] * 1000, metres.fixed[1], 1e-6);
  EXPECT_NEAR(millimetres.fixed[0] + 5000 * millimetres.fixed[1], metres.fixed[0], 1e-6);
  EXPECT_NEAR(*millimetres.spread.slope * 1000, *metres.spread.slope, 1e-6);
  changed = eight_examinees();
  for (LevelAnswers& row : changed) row.ones = row.trials - row.ones;
  const GlmmFit turned = fit_glmm(observations(changed), options);
  EXPECT_NEAR(turned.fixed[0], -metres.fixed[0], 1e-6);
  EXPECT_NEAR(turned.fixed[1], -metres.fixed[1], 1e-6);
  EXPECT_NEAR(*turned.spread.correlation, *metres.spread.correlation, 1e-5);
}

TEST(Glmm, ClimbsOnWhereLaplacesMaximumIsFarFromItsOwn) {
  // The likelihood is not concave at Laplace's maximum. lme4's Laplace fit of the same: fixef 0.3227,
  // -0.0970; sd 0 and 0.265; log-likelihood -42.41, a little lower.
  const long ones[6][4] = {{3, 4, 4, 7}, {5, 6, 4, 7}, {4, 4, 2, 4},
                           {7, 3, 5, 5}, {7, 5, 6, 3}, {5, 5, 4, 2}};
  std::vector<LevelAnswers> answers;
  for (int examinee = 0; examinee < 6; ++examinee) {
    for (int k = 0; k < 4; ++k) answers.push_back({std::to_string(examinee), k - 1.5, ones[examinee][k], 8});
  }
  const GlmmFit fit =
      fit_glmm(observations(answers), {.link = Link::Logit, .random = RandomEffects::Slope, .nodes = 5});
  EXPECT_TRUE(fit.convergence.converged) << fit.convergence.reason;
  EXPECT_NEAR(fit.fixed[1], -0.0970, 0.002);
  EXPECT_GT(fit.log_likelihood, -42.41);
}

TEST(Glmm, SaysWhenItDidNotConverge) {
  // Two people of opposite minds with three answers each: the random slope's variance grows without end.
  const GlmmFit fit = fit_glmm(
      observations(
          {{"a", -1, 0, 1}, {"a", 0, 0, 1}, {"a", 1, 1, 1}, {"b", -1, 1, 1}, {"b", 0, 1, 1}, {"b", 1, 0, 1}}),
      {.random = RandomEffects::Slope, .nodes = 5});
  EXPECT_FALSE(fit.convergence.converged);
  EXPECT_THAT(fit.convergence.reason, HasSubstr("no maximum here"));
  EXPECT_TRUE(std::isnan(fit.covariance(0, 0)));
}

TEST(Glmm, RefusesWhatHasNoFiniteSlope) {
  EXPECT_THAT(refusal_of({{"a", 1, 0, 5}, {"a", 2, 5, 5}, {"b", 1, 0, 5}, {"b", 2, 3, 5}, {"b", 3, 5, 5}}),
              HasSubstr("separates the answers completely (0 from 1 to 2, 1 from 2 to 3)"));
  EXPECT_THAT(refusal_of({{"a", 1, 5, 5}, {"a", 2, 0, 5}, {"b", 1, 5, 5}, {"b", 2, 5, 5}, {"b", 3, 0, 5}}),
              HasSubstr("separates the answers completely"));
  // Each changes at once, at a place of its own.
  EXPECT_THAT(refusal_of({{"a", 1, 0, 5},
                          {"a", 2, 5, 5},
                          {"a", 3, 5, 5},
                          {"b", 1, 0, 5},
                          {"b", 2, 0, 5},
                          {"b", 3, 0, 5},
                          {"b", 4, 5, 5}}),
              HasSubstr("answers of every examinee completely"));
}

TEST(Glmm, RefusesWhatIsTooLittle) {
  EXPECT_THAT(refusal_of({{"a", 1, 1, 5}, {"a", 2, 3, 5}}), HasSubstr("1 examinee; a mixed model needs"));
  EXPECT_THAT(refusal_of({{"a", 1, 1, 5}, {"b", 1, 3, 5}}), HasSubstr("every answer is at level 1"));
  EXPECT_THAT(refusal_of({{"a", 1, 5, 5}, {"b", 2, 5, 5}}), HasSubstr("all 10 answers are 1"));
  EXPECT_THAT(refusal_of({{"a", 1, 6, 5}, {"b", 2, 5, 5}}), HasSubstr("6"));
  EXPECT_THROW(fit_glmm(observations(four_alike()), {.nodes = 0}), std::invalid_argument);
  EXPECT_THROW(fit_glmm(observations(four_alike()), {.random = RandomEffects::Slope, .nodes = 26}),
               std::invalid_argument);
}
