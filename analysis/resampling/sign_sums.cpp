#include "analysis/resampling/sign_sums.hpp"

#include <cassert>
#include <numeric>

namespace palpate::analysis {

std::vector<double> sign_sum_distribution(std::span<const long> weights) {
  const long total = std::reduce(weights.begin(), weights.end());
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1.0;
  std::size_t reached = 0;  // the largest sum so far
  for (const long weight : weights) {
    assert(weight >= 0);
    const std::size_t step = weight;
    reached += step;
    // Downward, so that entry s - step still holds the distribution without this weight.
    for (std::size_t s = reached + 1; s-- > step;) {
      probability[s] = 0.5 * (probability[s] + probability[s - step]);
    }
    for (std::size_t s = 0; s < step; ++s) probability[s] *= 0.5;
  }
  return probability;
}

}  // namespace palpate::analysis
