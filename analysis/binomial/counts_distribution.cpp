#include "analysis/binomial/counts_distribution.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/numerics/log_gamma.hpp"

namespace palpate::analysis {

std::vector<double> convolve(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sum(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0.0) continue;
    for (std::size_t j = 0; j < b.size(); ++j) sum[i + j] += a[i] * b[j];
  }
  return sum;
}

std::vector<double> binomial_counts(long trials, double probability) {
  const boost::math::binomial_distribution<> distribution(static_cast<double>(trials), probability);
  std::vector<double> counts;
  for (long k = 0; k <= trials; ++k) counts.push_back(boost::math::pdf(distribution, static_cast<double>(k)));
  return counts;
}

std::vector<double> beta_binomial_counts(long trials, double probability, double overdispersion) {
  if (overdispersion == 0.0) return binomial_counts(trials, probability);
  const double sum = 1 / overdispersion - 1, a = probability * sum, b = (1 - probability) * sum;
  const auto log_beta = [](double x, double y) { return log_gamma(x) + log_gamma(y) - log_gamma(x + y); };
  const double n = static_cast<double>(trials);
  std::vector<double> counts;
  for (long count = 0; count <= trials; ++count) {
    const double k = static_cast<double>(count);
    const double log_ways = -std::log(n + 1) - log_beta(n - k + 1, k + 1);
    counts.push_back(std::exp(log_ways + log_beta(k + a, n - k + b) - log_beta(a, b)));
  }
  return counts;
}

}  // namespace palpate::analysis
