#include "analysis/statistics/similarity/similarity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/binomial/binomial_power.hpp"
#include "analysis/binomial/binomial_test.hpp"
#include "analysis/numerics/proportion_interval.hpp"

namespace palpate::analysis {

double discriminators_at(double proportion, double chance) {
  return (proportion - chance) / (1 - chance);
}

double proportion_at(double discriminators, double chance) {
  return chance + discriminators * (1 - chance);
}

SimilarityTest similarity_test(long correct, long trials, double chance, double bound, double alpha) {
  require_counts(correct, trials);
  require_level(chance, "chance");
  require_level(alpha, "alpha");
  if (!(chance < bound && bound < 1)) {
    throw std::invalid_argument(
        fmt::format("the bound is {} correct; it must lie between chance, {}, and 1", bound, chance));
  }
  SimilarityTest test{.correct = correct,
                      .trials = trials,
                      .chance = chance,
                      .bound = bound,
                      .bound_discriminators = discriminators_at(bound, chance),
                      .alpha = alpha};
  test.proportion = static_cast<double>(correct) / static_cast<double>(trials);
  test.discriminators = std::max(0.0, discriminators_at(test.proportion, chance));
  const double upper = clopper_pearson_bound(correct, trials, Side::Less, 1 - alpha).upper;
  test.discriminators_up_to = std::max(0.0, discriminators_at(upper, chance));
  test.p = binomial_p(correct, trials, bound).less;
  test.critical = critical_number(trials, bound, alpha, Side::Less);
  test.similar = rejects(test.critical, correct);
  test.power_at_chance = rejection_probability(test.critical, chance);
  test.method = {.name = "similarity test, exact binomial at the bound", .source = "ISO 4120:2021"};
  return test;
}

}  // namespace palpate::analysis
