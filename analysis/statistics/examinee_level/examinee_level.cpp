#include "analysis/statistics/examinee_level/examinee_level.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/rounding.hpp"
#include "analysis/statistics/examinee_level/guessing_test.hpp"

namespace palpate::analysis {

namespace {

// 0 also where proportions are equal but for rounding: no effect size is made of round-off.
double deviation_of(const std::vector<double>& above, double mean) {
  const std::vector<double> settled = settled_differences(above);
  if (std::ranges::all_of(settled, [&](double value) { return value == settled.front(); })) return 0.0;
  double squares = 0.0;
  for (const double value : above) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(above.size() - 1));
}

}  // namespace

ExamineeLevelTest examinee_level_test(std::span<const ExamineeCount> counts, double chance,
                                      const SignFlipOptions& options) {
  if (counts.empty()) throw std::invalid_argument("no examinees; the examinee-level test needs at least 1");
  std::vector<double> above(counts.size());
  std::ranges::transform(counts, above.begin(), [chance](const ExamineeCount& count) {
    require_counts(count.correct, count.trials);
    return static_cast<double>(count.correct) / static_cast<double>(count.trials) - chance;
  });
  ExamineeLevelTest result{.examinees = counts.size(), .chance = chance};
  result.test = chance == 0.5 ? sign_flip_test(above, options) : guessing_test(counts, chance, options);
  result.p = result.test.p;
  result.mean_proportion = chance + result.test.mean;
  result.interval = result.test.interval;
  result.interval.lower = std::max(chance + result.test.interval.lower, 0.0);  // a NaN in front stays NaN
  result.interval.upper = std::min(chance + result.test.interval.upper, 1.0);
  result.deviation = deviation_of(above, result.test.mean);
  if (result.deviation > 0) result.standardised = result.test.mean / result.deviation;
  result.method = {.name = "examinee-level test: " + result.test.method.name,
                   .source = result.test.method.source};
  return result;
}

}  // namespace palpate::analysis
