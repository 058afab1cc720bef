#include "analysis/statistics/bayes/bayes_factor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using Beta = boost::math::beta_distribution<>;

// Beyond these the quantiles of a beta distribution are not found any more.
constexpr double kLeastOfPrior = 1e-6, kMostOfPrior = 1e9;

double log_beta(double a, double b) {
  using boost::math::lgamma;
  return lgamma(a) + lgamma(b) - lgamma(a + b);
}

// The part of a beta distribution that lies on the side of the alternative.
double part(const Beta& beta, double chance, Side side) {
  if (side == Side::TwoSided) return 1.0;
  return side == Side::Greater ? cdf(complement(beta, chance)) : cdf(beta, chance);
}

double quantile_of_part(const Beta& beta, double chance, Side side, double probability) {
  const double whole = part(beta, chance, side);
  if (whole <= 0) return std::numeric_limits<double>::quiet_NaN();
  if (side == Side::Greater) return quantile(complement(beta, (1 - probability) * whole));
  return quantile(beta, probability * whole);
}

std::string prior_in_words(const BayesFactor& result) {
  std::string name = fmt::format("Beta({}, {})", number(result.prior.a), number(result.prior.b));
  if (result.side == Side::TwoSided) return name;
  return fmt::format("{} {} {}", name, result.side == Side::Greater ? "above" : "below",
                     chance_in_words(result.chance));
}

}  // namespace

BayesFactor bayes_factor(long correct, long trials, double chance, Side side, const BetaPrior& prior,
                         double level) {
  require_counts(correct, trials);
  require_level(chance, "chance");
  require_level(level, "credible level");
  if (!(std::min(prior.a, prior.b) >= kLeastOfPrior && std::max(prior.a, prior.b) <= kMostOfPrior)) {
    throw std::invalid_argument(fmt::format("prior is Beta({}, {}); both numbers must be above 0: {} to {}",
                                            prior.a, prior.b, kLeastOfPrior, kMostOfPrior));
  }
  BayesFactor result{.correct = correct, .trials = trials, .chance = chance, .side = side, .prior = prior};
  const double k = static_cast<double>(correct), wrong = static_cast<double>(trials - correct);
  const Beta before(prior.a, prior.b), after(prior.a + k, prior.b + wrong);
  result.log_bayes_factor = log_beta(prior.a + k, prior.b + wrong) - log_beta(prior.a, prior.b) +
                            std::log(part(after, chance, side)) - std::log(part(before, chance, side)) -
                            k * std::log(chance) - wrong * std::log1p(-chance);
  result.bayes_factor = std::exp(result.log_bayes_factor);
  result.posterior_median = quantile_of_part(after, chance, side, 0.5);
  result.interval = {.lower = quantile_of_part(after, chance, side, (1 - level) / 2),
                     .upper = quantile_of_part(after, chance, side, (1 + level) / 2),
                     .level = level,
                     .method = "credible, equal tails of the posterior"};
  result.method = {.name = "Bayes factor against chance, prior " + prior_in_words(result),
                   .source = "Jeffreys 1961, section 5.1; Kass & Raftery 1995"};
  return result;
}

std::string evidence_in_words(double log_bayes_factor) {
  const double factor = std::exp(std::abs(log_bayes_factor));
  const std::string strength = factor < 3     ? "evidence not worth more than a bare mention"
                               : factor < 20  ? "positive evidence"
                               : factor < 150 ? "strong evidence"
                                              : "very strong evidence";
  return strength + (log_bayes_factor < 0 ? " for chance" : " against chance");
}

}  // namespace palpate::analysis
