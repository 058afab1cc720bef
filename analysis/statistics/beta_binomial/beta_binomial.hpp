#pragma once

#include <optional>
#include <span>
#include <string>

#include "analysis/numerics/examinee_count.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

struct BetaBinomialOptions {
  double chance = 0.5;
  bool corrected = true;
  double level = 0.95;
};

/// A parameter between 0 and 1. NaN where the data say nothing of it.
struct BoundedEstimate {
  double estimate = 0.0;
  std::optional<double> standard_error{};  // of the observed information; none at 0 and 1
  Interval interval{};                     // profile likelihood
};

/// G2 = 2 (log L - log L under the hypothesis).
struct LikelihoodRatioTest {
  double g_squared = 0.0;
  double p = 1.0;
  std::string reference{};  // distribution that p is taken from
};

struct TaroneTest {
  double z = 0.0;
  double p = 1.0;  // against more variance than the binomial has
};

struct BetaBinomial {
  std::size_t examinees = 0;
  long correct = 0, trials = 0;
  BetaBinomialOptions options{};
  BoundedEstimate mean{};   // corrected: of the proportion above chance, pd; else of the proportion correct
  BoundedEstimate gamma{};  // overdispersion: 0 (everybody alike) to 1 (each one all or nothing)
  BoundedEstimate proportion{};  // mean proportion correct: chance + (1 - chance) pd, or the mean itself
  double log_likelihood = 0.0;   // binomial coefficients included
  double binomial_log_likelihood = 0.0;  // with gamma = 0
  LikelihoodRatioTest overdispersion{};  // of gamma = 0
  TaroneTest tarone{};                   // of equal proportions
  LikelihoodRatioTest against_chance{};  // of a mean at chance, against one above
  Method method{};
};

/// log P(correct of trials) where an examinee's own probability of a correct answer is chance + (1 - chance)
/// b, and b follows a beta distribution of this mean and gamma = 1/(alpha + beta + 1). chance 0: the plain
/// beta-binomial. gamma 0 and 1 are the limits, the binomial and all-or-nothing. Without the binomial
/// coefficient. Source: [BrockhoffChristensen2010].
double beta_binomial_log(long correct, long trials, double chance, double mean, double gamma);

/// Maximum-likelihood fit of the beta-binomial or the chance-corrected beta-binomial model [Brockhoff2003].
/// Overdispersion: likelihood ratio, whose null distribution is half a point mass at 0 and half a chi-squared
/// with 1 degree of freedom, since gamma lies at its boundary [SelfLiang1987]; and Tarone's Z [Tarone1979].
/// Against chance: without correction, the signed root of the likelihood ratio with gamma free; with it,
/// gamma vanishes under the hypothesis, and chi-squared with 2 degrees of freedom is a reference that errs on
/// the safe side. Throws std::invalid_argument for counts that cannot be, fewer than two examinees, one trial
/// each, or a chance outside (0, 1); and where all answers are alike.
BetaBinomial beta_binomial(std::span<const ExamineeCount> counts, const BetaBinomialOptions& options);

}  // namespace palpate::analysis
