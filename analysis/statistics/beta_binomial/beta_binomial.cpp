#include "analysis/statistics/beta_binomial/beta_binomial.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/statistics/beta_binomial/beta_binomial_fit.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

void check(std::span<const ExamineeCount> counts, const BetaBinomialOptions& options) {
  require_level(options.level, "confidence level");
  require_level(options.chance, "chance");
  if (counts.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{}; overdispersion is a difference between examinees, at least 2 are needed",
                    base::counted(std::ssize(counts), "examinee", "examinees")));
  }
  long correct = 0, trials = 0, most = 0;
  for (const ExamineeCount& count : counts) {
    require_counts(count.correct, count.trials);
    correct += count.correct, trials += count.trials, most = std::max(most, count.trials);
  }
  if (most < 2) {
    throw std::invalid_argument("one trial for each examinee; overdispersion shows in repeated trials only");
  }
  if (correct == 0 || correct == trials) {
    throw std::invalid_argument(fmt::format("all {} answers are {}; overdispersion cannot be told from them",
                                            trials, correct == 0 ? "wrong" : "correct"));
  }
}

double chi_squared_tail(double value, double degrees) {
  return cdf(complement(boost::math::chi_squared(degrees), value));
}

LikelihoodRatioTest overdispersion(double full, double without) {
  const double g = std::max(0.0, 2 * (full - without));
  return {.g_squared = g,
          .p = g > 0 ? chi_squared_tail(g, 1) / 2 : 1.0,
          .reference = "half 0, half chi-squared with 1 degree of freedom"};
}

// Sum of squared deviations from the pooled proportion, in its binomial standard errors [Tarone1979].
TaroneTest tarone(std::span<const ExamineeCount> counts, double correct, double trials) {
  const double p = correct / trials;
  double squares = 0.0, pairs = 0.0;
  for (const ExamineeCount& count : counts) {
    const double n = static_cast<double>(count.trials), off = static_cast<double>(count.correct) - n * p;
    squares += off * off / (p * (1 - p));
    pairs += n * (n - 1);
  }
  TaroneTest test{.z = (squares - trials) / std::sqrt(2 * pairs)};
  test.p = cdf(complement(boost::math::normal(), test.z));
  return test;
}

LikelihoodRatioTest against_chance(const BetaBinomialFit& fit, const BetaBinomialOptions& options) {
  const double hypothesis = options.corrected ? 0.0 : options.chance;
  const double g = std::max(0.0, 2 * (fit.log_likelihood() - fit.profile_of_mean(hypothesis)));
  if (options.corrected) {
    return {.g_squared = g,
            .p = chi_squared_tail(g, 2),
            .reference = "chi-squared with 2 degrees of freedom, an upper bound"};
  }
  const double root = fit.mean() > hypothesis ? std::sqrt(g) : -std::sqrt(g);
  return {.g_squared = g,
          .p = cdf(complement(boost::math::normal(), root)),
          .reference = "normal, of the signed root"};
}

BoundedEstimate of_proportion(BoundedEstimate mean, const BetaBinomialOptions& options) {
  if (!options.corrected) return mean;
  const auto correct = [c = options.chance](double pd) { return c + (1 - c) * pd; };
  mean.estimate = correct(mean.estimate);
  if (mean.standard_error) *mean.standard_error *= 1 - options.chance;
  mean.interval.lower = correct(mean.interval.lower);
  mean.interval.upper = correct(mean.interval.upper);
  return mean;
}

}  // namespace

BetaBinomial beta_binomial(std::span<const ExamineeCount> counts, const BetaBinomialOptions& options) {
  check(counts, options);
  BetaBinomial result{.examinees = counts.size(), .options = options};
  for (const ExamineeCount& count : counts) result.correct += count.correct, result.trials += count.trials;
  const BetaBinomialFit fit(counts, options.corrected ? options.chance : 0.0);
  result.mean = fit.mean_estimate(options.level);
  result.gamma = fit.gamma_estimate(options.level);
  result.proportion = of_proportion(result.mean, options);
  result.log_likelihood = fit.log_likelihood();
  result.binomial_log_likelihood = fit.profile_of_gamma(0.0);
  result.overdispersion = overdispersion(result.log_likelihood, result.binomial_log_likelihood);
  result.tarone = tarone(counts, static_cast<double>(result.correct), static_cast<double>(result.trials));
  result.against_chance = against_chance(fit, options);
  result.method = {.name = options.corrected ? "chance-corrected beta-binomial model, maximum likelihood"
                                             : "beta-binomial model, maximum likelihood",
                   .source = "Brockhoff 2003; Brockhoff & Christensen 2010; Tarone 1979"};
  return result;
}

}  // namespace palpate::analysis
