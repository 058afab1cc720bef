#pragma once

#include <vector>

#include "analysis/mixed/observations.hpp"

namespace palpate::analysis {

/// Contagious bovine pleuropneumonia: R's lme4::cbpp (Lesnoff et al. 2004), new cases of so many animals in
/// 15 herds over four periods; the herd is the examinee, the period's number the level.
std::vector<LevelAnswers> pleuropneumonia();

/// Eight simulated examinees, ten answers at each of the levels -3 to 3. R 4.2: set.seed(20); b0 <- rnorm(8,
/// .2, .6); b1 <- rnorm(8, 1, .35); d <- expand.grid(level=-3:3, examinee=1:8); rbinom(56, 10,
/// plogis(b0[d$examinee] + b1[d$examinee] * d$level))
std::vector<LevelAnswers> eight_examinees();

/// Four examinees who differ less than chance alone would make them: the variance between them is estimated
/// as 0.
std::vector<LevelAnswers> four_alike();

}  // namespace palpate::analysis
