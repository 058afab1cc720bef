#include "analysis/report/primary_power.hpp"

#include <fmt/core.h>

#include <boost/random/beta_distribution.hpp>
#include <boost/random/binomial_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/binomial/counts_distribution.hpp"
#include "analysis/report/primary_test.hpp"
#include "analysis/report/verdict.hpp"

namespace palpate::analysis {
namespace {

constexpr long kStudies = 10'000;

/// The beta distribution of the examinees' probabilities.
struct BetaShape {
  double a = 0.0, b = 0.0;
};

BetaShape beta_of(const Power& asked) {
  const double sum = 1 / asked.overdispersion - 1;
  return {.a = asked.probability * sum, .b = (1 - asked.probability) * sum};
}

std::vector<CriticalNumber> regions(const StudyDesign& design) {
  const long each = design.trials_per_examinee_per_cell;
  const Side side = side_from_name(design.side);
  if (design.looks.empty())
    return {critical_number(each * design.planned_examinees, design.chance, strictest_alpha(design), side)};
  std::vector<long> trials;
  for (const int look : design.looks) trials.push_back(each * look);
  std::vector<CriticalNumber> all;
  for (const PlannedLook& look :
       planned_looks(trials, design.chance, design.alpha, side, spending_from_name(design.spending)))
    all.push_back(look.critical);
  return all;
}

/// Probability that the number correct enters a region of rejection at some look.
double exact_power(const StudyDesign& design, const Power& asked) {
  const long each = design.trials_per_examinee_per_cell;
  const std::vector<double> one = beta_binomial_counts(each, asked.probability, asked.overdispersion);
  std::vector<double> going_on = {1.0};
  double rejected = 0.0;
  for (const CriticalNumber& region : regions(design)) {
    while (static_cast<long>(going_on.size()) <= region.trials) going_on = convolve(going_on, one);
    for (std::size_t k = 0; k < going_on.size(); ++k) {
      if (!rejects(region, static_cast<long>(k))) continue;
      rejected += going_on[k];
      going_on[k] = 0.0;
    }
  }
  return rejected;
}

/// One sitting with half of the trials in either order.
OrderStratum balanced_sitting(long trials, double probability, boost::random::mt19937_64& random) {
  const long first = trials / 2;
  boost::random::binomial_distribution<long> right_first(first, probability),
      right_second(trials - first, probability);
  const long a = right_first(random), b = right_second(random);
  return {
      .trials = trials, .correct_first = first, .answers_first = a + (trials - first - b), .correct = a + b};
}

double simulated_power(const StudyDesign& design, const Power& asked, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  const auto [a, b] = asked.overdispersion > 0 ? beta_of(asked) : BetaShape{1, 1};
  boost::random::beta_distribution<> people(a, b);
  long found = 0;
  std::vector<OrderStratum> sittings(design.planned_examinees);
  for (long study = 0; study < kStudies; ++study) {
    for (OrderStratum& sitting : sittings) {
      const double p = asked.overdispersion > 0 ? people(random) : asked.probability;
      sitting = balanced_sitting(design.trials_per_examinee_per_cell, p, random);
    }
    const auto test =
        order_randomisation_test(sittings, strictest_alpha(design), side_from_name(design.side));
    found += rejects(test.critical, test.correct) ? 1 : 0;
  }
  return static_cast<double>(found) / static_cast<double>(kStudies);
}

}  // namespace

Power primary_power(const StudyDesign& design, double probability, double overdispersion,
                    std::uint64_t seed) {
  require_level(probability, "probability");
  if (!(overdispersion >= 0 && overdispersion < 1)) {
    throw std::invalid_argument(
        fmt::format("overdispersion is {}; accepted: from 0 (all alike) to below 1", overdispersion));
  }
  if (design.trials_per_examinee_per_cell < 1 || design.planned_examinees < 1) {
    throw std::invalid_argument(
        "the protocol does not fix how many trials an examinee answers: no power can be told");
  }
  Power power{.probability = probability, .overdispersion = overdispersion};
  if (design.interval_order == "coin") {
    power.power = exact_power(design, power);
    return power;
  }
  power.studies = kStudies;
  power.power = simulated_power(design, power, seed);
  power.standard_error = std::sqrt(power.power * (1 - power.power) / static_cast<double>(kStudies));
  return power;
}

}  // namespace palpate::analysis
