#include "tests/message_times/leak.hpp"

#include <algorithm>
#include <cmath>

namespace palpate::app::message_times {
namespace {

// 4.5 standard deviations of chance: 1 in 150000, and a run of the test makes some thirty comparisons.
constexpr double kBeyondChance = 4.5;
// Browsers tell a page the time in steps of 0.1 ms, unless it is isolated, which ours is not: what moves the
// middle of a sample by less than two steps is no news to a page, however sure a rank test is of it.
constexpr double kTold = 0.2;  // [ms]

double median_of(std::vector<double>& sample) {
  std::ranges::nth_element(sample, sample.begin() + std::ssize(sample) / 2);
  return sample[sample.size() / 2];
}

}  // namespace

TimeDifference difference(std::vector<double> first, std::vector<double> second) {
  double longer = 0.0;
  for (const double a : first)
    for (const double b : second) longer += b > a ? 1.0 : b == a ? 0.5 : 0.0;
  const auto n = static_cast<double>(first.size()), m = static_cast<double>(second.size());
  return {.share_longer = longer / (n * m),
          .median = median_of(second) - median_of(first),
          .chance = std::sqrt((n + m + 1) / (12 * n * m))};  // of the Mann-Whitney statistic over n m
}

bool leaks(const TimeDifference& difference) {
  return std::abs(difference.share_longer - 0.5) > kBeyondChance * difference.chance &&
         std::abs(difference.median) > kTold;
}

}  // namespace palpate::app::message_times
