#include "analysis/statistics/looks/planned_looks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"
#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

constexpr double kRounding = 1 + 1e-12;  // as in critical_number(): alpha means what it says

void validate(std::span<const long> trials, double chance, double alpha, Side side) {
  require_level(chance, "chance");
  require_level(alpha, "alpha");
  if (side == Side::TwoSided) {
    throw std::invalid_argument("planned looks are one-sided in this version; accepted sides: greater, less");
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i] > (i == 0 ? 0 : trials[i - 1])) continue;
    throw std::invalid_argument(fmt::format("look {} comes after {}; accepted: more than at the look before",
                                            i + 1, base::counted(trials[i], "answer", "answers")));
  }
  if (trials.empty()) throw std::invalid_argument("no look; accepted: one or more");
}

}  // namespace

Spending spending_from_name(std::string_view name) {
  if (name == "obrien-fleming") return Spending::OBrienFleming;
  if (name == "pocock") return Spending::Pocock;
  throw std::invalid_argument(fmt::format("spending is '{}'; accepted: obrien-fleming, pocock", name));
}

std::string_view name_of(Spending spending) {
  return spending == Spending::OBrienFleming ? "obrien-fleming" : "pocock";
}

double spent(Spending spending, double alpha, double t) {
  if (spending == Spending::Pocock) return alpha * std::log(1 + (std::numbers::e - 1) * t);
  const boost::math::normal_distribution<> normal;
  const double z = boost::math::quantile(boost::math::complement(normal, alpha / 2));
  return 2 * boost::math::cdf(boost::math::complement(normal, z / std::sqrt(t)));
}

std::vector<PlannedLook> planned_looks(std::span<const long> trials, double chance, double alpha, Side side,
                                       Spending spending) {
  validate(trials, chance, alpha, side);
  // "Less" is "greater" seen from the wrong answers.
  const double success = side == Side::Less ? 1 - chance : chance;
  std::vector<double> going_on = {1.0};  // probability of each number of successes, not rejected yet
  std::vector<PlannedLook> looks;
  double used = 0.0;
  long before = 0;
  for (const long n : trials) {
    going_on = convolve(going_on, binomial_counts(n - before, success));
    before = n;
    const double may_be_spent =
        spent(spending, alpha, static_cast<double>(n) / static_cast<double>(trials.back()));
    long k = n + 1;
    while (k > 0 && used + going_on[k - 1] <= may_be_spent * kRounding) used += going_on[--k];
    PlannedLook look{.critical = {.trials = n, .chance = chance, .alpha = may_be_spent, .side = side},
                     .size = used};
    look.critical.size = used - (looks.empty() ? 0.0 : looks.back().size);
    if (k <= n)
      (side == Side::Less ? look.critical.at_most : look.critical.at_least) = side == Side::Less ? n - k : k;
    look.critical.method = {
        .name = fmt::format("exact binomial test at planned looks, {} spending", name_of(spending)),
        .source = "Lan & DeMets 1983"};
    std::fill(going_on.begin() + k, going_on.end(), 0.0);
    looks.push_back(look);
  }
  return looks;
}

}  // namespace palpate::analysis
