#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/result.hpp"
#include "analysis/psychometric/fit.hpp"

namespace palpate::analysis {

/// What the hypothesis says is the same in all conditions.
enum class Same {
  Function,   // threshold and slope
  Threshold,  // the level at F = threshold_at; each condition has its slope
  Slope       // beta; each condition has its threshold
};

/// "function", "threshold" or "slope"; anything else is a std::invalid_argument.
Same same_from_name(std::string_view name);
std::string_view name_of(Same same);

struct PsychometricCondition {
  std::string name{};
  std::vector<Block> blocks{};
};

/// A function of each condition, and the lapse rate that they share.
struct JointFit {
  std::vector<double> alpha{};  // [u], in the order of the conditions
  std::vector<double> beta{};   // [1/u]
  double lapse = 0.0;
  double log_likelihood = 0.0;  // without the binomial coefficients
};

struct PsychometricComparison {
  std::optional<std::string> why_not{};  // no comparison, and the reason
  JointFit separate{};                   // a function for each condition
  JointFit same{};                       // under the hypothesis
  double chi_squared = 0.0;              // twice the difference of the log likelihoods
  double degrees_of_freedom = 0.0;
  double p = 1.0;
  Method method{};
};

/// Likelihood ratio test that what `same` names is the same in all conditions, against a function for each.
/// The lapse rate is the examinee's: one for all conditions under both, so that no parameter of the test lies
/// at a bound. p by the chi-squared distribution, which holds for many trials. Throws std::invalid_argument
/// for fewer than two conditions; a condition without a function (levels too few, separable answers, answers
/// that do not rise) is told by `why_not`. Source: [Wilks1938]; [PrinsKingdom2018].
PsychometricComparison compare_psychometric(std::span<const PsychometricCondition> conditions,
                                            const PsychometricModel& model, Same same);

}  // namespace palpate::analysis
