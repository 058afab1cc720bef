#include "analysis/psychometric/goodness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/measures.hpp"
#include "tests/analysis/psychometric/support.hpp"

using namespace palpate::analysis;

TEST(BlockInfluence, ResidualsAddUpToTheDeviance) {
  const auto blocks = psignifit_blocks();
  const PsychometricFit fit = fit_of(blocks, {});
  const Design design = make_design(blocks, {});
  double sum = 0;
  for (const BlockInfluence& one : block_influence(blocks, {}, fit)) sum += one.residual * one.residual;
  EXPECT_NEAR(sum, deviance_of(design, correct_in(design, blocks), fit.log_likelihood), 1e-10);
}

TEST(BlockInfluence, ResidualsAreR_residualsOfGlm) {
  // R 4.2: x <- 0:4; k <- c(5, 14, 24, 40, 45); residuals(glm(cbind(k, 50 - k) ~ x, binomial), "deviance")
  const auto blocks = blocks_from({0, 1, 2, 3, 4}, {5, 14, 24, 40, 45}, 50);
  const PsychometricModel model{.guess = 0, .lapse_upper = 0};
  const double expected[] = {-0.0766767802273, 0.310300502353, -0.549478809231, 0.555004352953,
                             -0.239951035177};
  const auto influence = block_influence(blocks, model, fit_of(blocks, model));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(influence[i].residual, expected[i], 1e-8);
}

TEST(BlockInfluence, IsTheFitOfTheOthersLessTheFitOfAll) {
  auto blocks = psignifit_blocks();
  blocks[1].correct = 45;  // a block unlike the others
  const PsychometricFit all = fit_of(blocks, {});
  const auto influence = block_influence(blocks, {}, all);
  auto others = blocks;
  others.erase(others.begin() + 1);
  const PsychometricFit without = fit_of(others, {});
  EXPECT_NEAR(influence[1].threshold_change, without.alpha - all.alpha, 1e-12);
  EXPECT_NEAR(influence[1].slope_change, (without.beta - all.beta) / 4, 1e-12);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i != 1) EXPECT_GT(std::abs(influence[1].threshold_change), std::abs(influence[i].threshold_change));
  }
}

TEST(BlockInfluence, HasNoChangeWhereTooFewLevelsAreLeft) {
  const auto blocks = blocks_from({1, 2, 3}, {6, 7, 9}, 10);
  for (const BlockInfluence& one : block_influence(blocks, {}, fit_of(blocks, {})))
    EXPECT_TRUE(std::isnan(one.threshold_change));
}
