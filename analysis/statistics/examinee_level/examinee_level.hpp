#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/numerics/examinee_count.hpp"
#include "analysis/resampling/sign_flip.hpp"

namespace palpate::analysis {

struct ExamineeLevelTest {
  std::size_t examinees = 0;
  double chance = 0.5;
  double mean_proportion = 0.0;  // each examinee counts the same, however many trials
  double deviation = 0.0;        // standard deviation of the proportions; 0 with one examinee
  /// (mean - chance)/deviation, Cohen's d of one sample; none where that is 0.
  std::optional<double> standardised{};
  PValues p{};
  Interval interval{};  // for the mean proportion, by inverting the test, cut to 0..1; NaN when all are alike
  SignFlipTest test{};  // on (proportion - chance); for another chance than 1/2, what guessing_test() gives
  Method method{};
};

/// Whether examinees as a group depart from chance. The unit is the examinee, so the claim is about people
/// like those examined, where the pooled binomial says only that somebody answered better than by chance. At
/// chance 1/2, where deviations are symmetric when nobody feels anything, a sign-flip permutation test on
/// each one's proportion correct less 1/2; at any other chance guessing_test(). Throws std::invalid_argument
/// for no examinees, counts that cannot be, or a chance outside 0 to 1.
ExamineeLevelTest examinee_level_test(std::span<const ExamineeCount> counts, double chance,
                                      const SignFlipOptions& options = {});

}  // namespace palpate::analysis
