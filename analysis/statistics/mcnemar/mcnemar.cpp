#include "analysis/statistics/mcnemar/mcnemar.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/proportion_interval.hpp"
#include "analysis/numerics/standard_normal.hpp"

namespace palpate::analysis {
namespace {

double odds(double proportion) {
  return proportion < 1 ? proportion / (1 - proportion) : kInfinity;
}

void fill_p(McNemarTest& test, long b) {
  const long n = test.discordant;
  if (n == 0) return;  // nothing speaks against equality: every p is 1, every statistic 0
  test.exact = binomial_p(b, n, 0.5);
  test.mid_p = binomial_mid_p(b, n, 0.5);

  const double difference = std::abs(static_cast<double>(2 * b - n)), count = static_cast<double>(n);
  const double corrected = std::max(0.0, difference - 1);
  test.chi_squared = difference * difference / count;
  test.chi_squared_corrected = corrected * corrected / count;
  const boost::math::chi_squared distribution(1);
  test.p_asymptotic = cdf(complement(distribution, test.chi_squared));
  test.p_asymptotic_corrected = cdf(complement(distribution, test.chi_squared_corrected));
}

void fill_estimates(McNemarTest& test, double level) {
  const double b = static_cast<double>(test.table.first_only),
               c = static_cast<double>(test.table.second_only);
  const double n = static_cast<double>(test.pairs);
  const double z = critical_z(level);
  const double half = z * std::sqrt(std::max(0.0, b + c - (b - c) * (b - c) / n)) / n;
  test.difference = (b - c) / n;
  test.difference_interval = {.lower = std::max(-1.0, test.difference - half),
                              .upper = std::min(1.0, test.difference + half),
                              .level = level,
                              .method = "Wald (large samples)"};
  test.odds_ratio = b / c;
  test.odds_ratio_interval = {.lower = 0.0,
                              .upper = kInfinity,
                              .level = level,
                              .method = "exact, from Clopper-Pearson on the discordant pairs"};
  if (test.discordant == 0) return;
  const Interval share = clopper_pearson(test.table.first_only, test.discordant, level);
  test.odds_ratio_interval.lower = odds(share.lower);
  test.odds_ratio_interval.upper = odds(share.upper);
}

}  // namespace

McNemarTest mcnemar_test(const PairedTable& table, double level) {
  require_level(level, "confidence level");
  const auto [a, b, c, d] = table;
  if (a < 0 || b < 0 || c < 0 || d < 0 || a + b + c + d == 0) {
    throw std::invalid_argument(fmt::format(
        "table is {},{},{},{}; McNemar's test takes four counts >= 0, not all of them 0", a, b, c, d));
  }
  McNemarTest test{.table = table, .pairs = a + b + c + d, .discordant = b + c};
  fill_p(test, b);
  fill_estimates(test, level);
  test.method = {.name = "McNemar's test: exact, mid-p and asymptotic",
                 .source = "McNemar 1947; Fagerland, Lydersen & Laake 2013"};
  return test;
}

}  // namespace palpate::analysis
