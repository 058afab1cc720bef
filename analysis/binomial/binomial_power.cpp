#include "analysis/binomial/binomial_power.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/binomial.hpp>
#include <stdexcept>

namespace palpate::analysis {

double rejection_probability(const CriticalNumber& critical, double probability) {
  if (!(probability >= 0 && probability <= 1)) {
    throw std::invalid_argument(fmt::format("probability is {}; accepted: 0 to 1", probability));
  }
  const boost::math::binomial_distribution<> binomial(static_cast<double>(critical.trials), probability);
  double total = 0.0;
  if (critical.at_least && *critical.at_least == 0) return 1.0;
  if (critical.at_least) total += cdf(complement(binomial, static_cast<double>(*critical.at_least - 1)));
  if (critical.at_most) total += cdf(binomial, static_cast<double>(*critical.at_most));
  return total;
}

double binomial_power(long trials, double chance, double probability, double alpha, Side side) {
  return rejection_probability(critical_number(trials, chance, alpha, side), probability);
}

SampleSize binomial_sample_size(double chance, double probability, double alpha, Side side, double target,
                                long step, long largest) {
  require_level(chance, "chance");
  require_level(alpha, "alpha");
  require_level(target, "power");
  const bool on_side = side == Side::Greater ? probability > chance
                       : side == Side::Less  ? probability < chance
                                             : probability != chance;
  if (!on_side || !(probability >= 0 && probability <= 1)) {
    throw std::invalid_argument(
        fmt::format("true proportion is {}, chance {}: the test with side '{}' cannot be expected to find it",
                    probability, chance, name_of(side)));
  }
  if (step < 1) throw std::invalid_argument(fmt::format("step is {}; at least 1 is needed", step));

  SampleSize size{.chance = chance,
                  .probability = probability,
                  .alpha = alpha,
                  .target = target,
                  .side = side,
                  .step = step};
  for (long n = step; n <= largest; n += step) {
    const double power = binomial_power(n, chance, probability, alpha, side);
    size.searched = n;
    if (power < target) {
      size.lasting.reset();
    } else {
      if (!size.first) size.first = n, size.power_at_first = power;
      if (!size.lasting) size.lasting = n, size.power_at_lasting = power;
    }
    // The teeth shrink as n grows: twice the first size and a hundred steps more is well past the last one.
    if (size.first && n >= 2 * *size.first + 100 * step) break;
  }
  size.method = {.name = "exact power of the binomial test",
                 .source = "binomial distribution, no approximation"};
  return size;
}

}  // namespace palpate::analysis
