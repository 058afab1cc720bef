#include "analysis/statistics/power/power_curve.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"

namespace palpate::analysis {
namespace {

constexpr long kMostTrials = 20'000;

void validate(const PowerAsked& asked, long largest) {
  require_level(asked.chance, "chance");
  require_level(asked.probability, "probability");
  require_level(asked.alpha, "alpha");
  require_level(asked.target, "target");
  if (!(asked.overdispersion >= 0 && asked.overdispersion < 1)) {
    throw std::invalid_argument(
        fmt::format("overdispersion is {}; accepted: from 0 (all alike) to below 1", asked.overdispersion));
  }
  if (asked.each < 1 || largest < asked.each || largest > kMostTrials) {
    throw std::invalid_argument(
        fmt::format("{} answers of each examinee, at most {} in all; accepted: 1 <= each <= all <= {}",
                    asked.each, largest, kMostTrials));
  }
}

double power_at(const CriticalNumber& critical, const std::vector<double>& counts) {
  double power = 0.0;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (rejects(critical, static_cast<long>(k))) power += counts[k];
  return power;
}

}  // namespace

PowerCurve power_curve(const PowerAsked& asked, long largest) {
  validate(asked, largest);
  PowerCurve curve;
  const bool alike = asked.overdispersion == 0.0;
  const std::vector<double> one = beta_binomial_counts(asked.each, asked.probability, asked.overdispersion);
  std::vector<double> counts = {1.0};
  for (long n = asked.each; n <= largest; n += asked.each) {
    const CriticalNumber critical = critical_number(n, asked.chance, asked.alpha, asked.side);
    if (!alike) counts = convolve(counts, one);
    curve.trials.push_back(n);
    curve.power.push_back(alike ? rejection_probability(critical, asked.probability)
                                : power_at(critical, counts));
  }
  SampleSize& size = curve.size;
  size = {.chance = asked.chance,
          .probability = asked.probability,
          .alpha = asked.alpha,
          .target = asked.target,
          .side = asked.side,
          .step = asked.each};
  size.searched = curve.trials.back();
  for (std::size_t i = curve.trials.size(); i-- > 0;) {
    if (curve.power[i] < asked.target) continue;
    size.first = curve.trials[i];
    size.power_at_first = curve.power[i];
    if (i + 1 != curve.trials.size() && curve.power[i + 1] < asked.target) continue;
    const bool lasts = i + 1 == curve.trials.size() || size.lasting == curve.trials[i + 1];
    if (lasts) size.lasting = curve.trials[i], size.power_at_lasting = curve.power[i];
  }
  size.method = {.name = "exact power of the binomial test",
                 .source = alike ? "Chernick & Liu 2002" : "Brockhoff 2003 (beta-binomial)"};
  return curve;
}

}  // namespace palpate::analysis
