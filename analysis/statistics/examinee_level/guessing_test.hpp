#pragma once

#include <span>

#include "analysis/numerics/examinee_count.hpp"
#include "analysis/resampling/sign_flip.hpp"

namespace palpate::analysis {

/// Whether the mean of examinees' proportions correct departs from any chance. The statistic is
/// T = (mean - chance)/sqrt(max(s^2, v)/N): s^2 the variance between the N proportions, v what it is on the
/// average when everybody guesses, the mean of chance (1 - chance)/n_i. So people who differ more than
/// guessing alone would make them count by how they differ, and proportions that happen to agree feign no
/// certainty. Its distribution is that of guessing, each number correct binomial with its own trials: exact
/// where that takes no more than 1e7 steps, else a seeded Monte Carlo with the add-one rule. Where people's
/// probabilities differ about chance p is right for many examinees, as a t-test's is. Two-sided: twice the
/// smaller side. The interval for the mean less chance is Student's, with s. Throws std::invalid_argument
/// unless 0 < chance < 1, for fewer than 999 resamples or more than 1e7 trials in all; counts were checked.
SignFlipTest guessing_test(std::span<const ExamineeCount> counts, double chance,
                           const SignFlipOptions& options);

}  // namespace palpate::analysis
