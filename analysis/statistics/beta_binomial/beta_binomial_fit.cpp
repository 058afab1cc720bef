#include "analysis/statistics/beta_binomial/beta_binomial_fit.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace palpate::analysis {
namespace {

constexpr double kMinusInfinity = -std::numeric_limits<double>::infinity();

// The chance that the next of a series of draws is a success, after `successes` of `draws`: Polya's urn,
// whose product over a series is the moment of the beta distribution that the likelihood is made of.
double next_draw(double mean, double gamma, double successes, double draws) {
  if (draws == 0) return mean;  // also for gamma = 1
  return (mean * (1 - gamma) + successes * gamma) / (1 - gamma + draws * gamma);
}

struct Best {
  double at = 0.0;
  double value = kMinusInfinity;
};

// The maximum of f over [0, 1]: Brent's method in the best of a few parts, and the ends themselves.
template <typename Function>
Best maximum(const Function& f, int parts) {
  Best best;
  const auto look = [&](double at) {
    const double value = f(at);
    if (value > best.value) best = {.at = at, .value = value};
  };
  for (int k = 0; k <= parts; ++k) look(static_cast<double>(k) / parts);
  const double width = 1.0 / parts;
  const double from = std::max(0.0, best.at - width), to = std::min(1.0, best.at + width);
  constexpr int kBits = 30;  // of the place; the value is then good to all its digits
  look(boost::math::tools::brent_find_minima([&](double at) { return -f(at); }, from, to, kBits).first);
  for (const double end : {0.0, 1.0}) {  // where Brent stops a hair inside
    const double value = f(end);
    if (std::abs(best.at - end) < 1e-6 && value > best.value - 1e-9) best = {.at = end, .value = value};
  }
  return best;
}

// Where the profile has fallen by half the chi-squared quantile, on the way from the estimate to an end of
// [0, 1]; that end where it does not fall so far.
template <typename Profile>
double profile_end(const Profile& profile, double estimate, double end, double best, double level) {
  const double fall = quantile(boost::math::chi_squared(1), level) / 2;
  const auto above = [&](double at) {
    return std::max(profile(at) - best + fall, -1e6);
  };  // -inf is no number
  if (estimate == end || above(end) >= 0) return end;
  if (above(estimate) <= 0) return estimate;  // a level so low that the fall is within round-off
  std::uintmax_t steps = 100;
  const auto [low, high] =
      boost::math::tools::toms748_solve(above, std::min(estimate, end), std::max(estimate, end),
                                        boost::math::tools::eps_tolerance<double>(40), steps);
  return (low + high) / 2;
}

template <typename Profile>
Interval profile_interval(const Profile& profile, double estimate, double best, double level) {
  return {.lower = profile_end(profile, estimate, 0.0, best, level),
          .upper = profile_end(profile, estimate, 1.0, best, level),
          .level = level,
          .method = "profile likelihood"};
}

bool at_an_end(double value) {
  return value == 0 || value == 1;
}

double step_for(double value) {
  return std::min(1e-4, std::min(value, 1 - value) / 2);
}

// -d2f/dx2 by a central difference.
template <typename Function>
double curvature(const Function& f, double at) {
  const double h = step_for(at);
  return (2 * f(at) - f(at + h) - f(at - h)) / (h * h);
}

}  // namespace

double beta_binomial_log(long correct, long trials, double chance, double mean, double gamma) {
  const long wrong = trials - correct;
  double log = 0.0;
  for (long k = 0; k < wrong; ++k) {
    log += std::log(next_draw(1 - mean, gamma, static_cast<double>(k), static_cast<double>(k)));
  }
  const auto felt = [&](long k) {  // that one more is felt, after k felt and all the wrong ones
    return next_draw(mean, gamma, static_cast<double>(k), static_cast<double>(wrong + k));
  };
  if (chance == 0) {
    for (long k = 0; k < correct; ++k) log += std::log(felt(k));
    return log;
  }
  // Of the correct answers k are felt and the others are lucky guesses: a sum over k, all terms positive.
  log += static_cast<double>(correct) * std::log(chance) + static_cast<double>(wrong) * std::log1p(-chance);
  double term = 1.0, sum = 1.0;
  for (long k = 0; k < correct; ++k) {
    term *= static_cast<double>(correct - k) / static_cast<double>(k + 1) * (1 - chance) / chance * felt(k);
    sum += term;
    if (sum > 1e200) term /= sum, log += std::log(sum), sum = 1.0;
  }
  return log + std::log(sum);
}

BetaBinomialFit::BetaBinomialFit(std::span<const ExamineeCount> counts, double chance) : chance_(chance) {
  std::map<std::pair<long, long>, double> times;
  for (const ExamineeCount& count : counts) ++times[{count.correct, count.trials}];
  for (const auto& [count, often] : times) {
    const double x = static_cast<double>(count.first), n = static_cast<double>(count.second);
    using boost::math::lgamma;
    log_ways_ += often * (lgamma(n + 1) - lgamma(x + 1) - lgamma(n - x + 1));
    counts_.push_back({.count = {.correct = count.first, .trials = count.second}, .times = often});
  }
  constexpr int kParts = 20;  // the profile of gamma may have more than one peak
  gamma_ = maximum([this](double gamma) { return profile_of_gamma(gamma); }, kParts).at;
  const Best best = maximum([this](double mean) { return log_likelihood(mean, gamma_); }, 1);
  mean_ = best.at, best_ = best.value;
  if (chance_ > 0 && mean_ == 0) gamma_ = std::numeric_limits<double>::quiet_NaN();  // nobody: no spread
}

double BetaBinomialFit::log_likelihood(double mean, double gamma) const {
  double sum = log_ways_;
  for (const Repeated& one : counts_) {
    sum += one.times * beta_binomial_log(one.count.correct, one.count.trials, chance_, mean, gamma);
  }
  return sum;
}

double BetaBinomialFit::profile_of_mean(double mean) const {
  constexpr int kParts = 20;
  return maximum([&](double gamma) { return log_likelihood(mean, gamma); }, kParts).value;
}

double BetaBinomialFit::profile_of_gamma(double gamma) const {
  return maximum([&](double mean) { return log_likelihood(mean, gamma); }, 1).value;
}

BoundedEstimate BetaBinomialFit::mean_estimate(double level) const {
  BoundedEstimate result{.estimate = mean_};
  result.interval =
      profile_interval([this](double mean) { return profile_of_mean(mean); }, mean_, best_, level);
  if (at_an_end(mean_)) return result;
  // The curvature of the profile is the inverse of the corner of the inverse information.
  const double alone = curvature([this](double mean) { return log_likelihood(mean, gamma_); }, mean_);
  if (at_an_end(gamma_)) {
    result.standard_error = 1 / std::sqrt(alone);
  } else {
    const double h = step_for(mean_), k = step_for(gamma_);
    const double other = curvature([this](double gamma) { return log_likelihood(mean_, gamma); }, gamma_);
    const double mixed = (log_likelihood(mean_ + h, gamma_ - k) + log_likelihood(mean_ - h, gamma_ + k) -
                          log_likelihood(mean_ + h, gamma_ + k) - log_likelihood(mean_ - h, gamma_ - k)) /
                         (4 * h * k);
    result.standard_error = std::sqrt(other / (alone * other - mixed * mixed));
  }
  return result;
}

BoundedEstimate BetaBinomialFit::gamma_estimate(double level) const {
  BoundedEstimate result{.estimate = gamma_};
  if (std::isnan(gamma_)) {
    result.interval = {.lower = gamma_, .upper = gamma_, .level = level, .method = "profile likelihood"};
    return result;
  }
  result.interval =
      profile_interval([this](double gamma) { return profile_of_gamma(gamma); }, gamma_, best_, level);
  if (!at_an_end(gamma_) && !at_an_end(mean_)) {
    const double profiled = curvature([this](double gamma) { return profile_of_gamma(gamma); }, gamma_);
    result.standard_error = 1 / std::sqrt(profiled);
  }
  return result;
}

}  // namespace palpate::analysis
