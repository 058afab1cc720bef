#include "analysis/statistics/power/power_curve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/binomial/counts_distribution.hpp"
#include "analysis/words/words.hpp"

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
  if (largest < 1 || largest > kMostTrials)
    throw std::invalid_argument(fmt::format("largest is {}; accepted: from 1 to {}", largest, kMostTrials));
  if (asked.each < 1 || asked.each > largest) {
    throw std::invalid_argument(
        fmt::format("each is {}; accepted: from 1 to largest ({})", asked.each, largest));
  }
}

double power_at(const CriticalNumber& critical, const std::vector<double>& counts) {
  double power = 0.0;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (rejects(critical, static_cast<long>(k))) power += counts[k];
  return power;
}

bool looked_for(const PowerAsked& asked) {
  if (asked.side == Side::Greater) return asked.probability > asked.chance;
  if (asked.side == Side::Less) return asked.probability < asked.chance;
  return asked.probability != asked.chance;
}

// What the power of ever more answers goes to, where the truth is not what the test looks for and examinees
// differ: by the normal distribution, whose variance is 1 + (each - 1) gamma times what the test takes it for.
double power_in_the_end(const PowerAsked& asked) {
  if (asked.probability != asked.chance) return 0.0;
  const double tails = asked.side == Side::TwoSided ? 2.0 : 1.0;
  const boost::math::normal normal;
  const double critical = quantile(complement(normal, asked.alpha / tails));
  const double inflation = 1 + static_cast<double>(asked.each - 1) * asked.overdispersion;
  return tails * cdf(complement(normal, critical / std::sqrt(inflation)));
}

std::optional<std::string> why_never(const PowerAsked& asked, const SampleSize& size) {
  if (looked_for(asked) || size.first) return std::nullopt;
  const bool binomial = asked.overdispersion == 0.0 || asked.each == 1;
  const double most = binomial ? asked.alpha : power_in_the_end(asked);
  if (asked.target <= most) return std::nullopt;
  const std::string place =
      asked.probability == asked.chance
          ? "is chance itself"
          : fmt::format("is {} chance, where the test with side '{}' does not look",
                        asked.probability < asked.chance ? "below" : "above", name_of(asked.side));
  return fmt::format("the true proportion {} {}, so that {} {}", percent(asked.probability), place,
                     binomial ? "no number of answers has more power than alpha,"
                              : "with more and more answers the power goes to",
                     number(most));
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
  curve.never = why_never(asked, size);
  return curve;
}

}  // namespace palpate::analysis
