#include "analysis/statistics/examinee_level/examinee_level.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace palpate::analysis {

ExamineeLevelTest examinee_level_test(std::span<const ExamineeCount> counts, double chance,
                                      const SignFlipOptions& options) {
  if (counts.empty()) throw std::invalid_argument("no examinees; the examinee-level test needs at least 1");
  if (chance != 0.5) {
    throw std::invalid_argument(
        fmt::format("chance is {}; the examinee-level sign-flip test needs chance 1/2, where guessing is "
                    "symmetric",
                    chance));
  }
  std::vector<double> above(counts.size());
  std::ranges::transform(counts, above.begin(), [chance](const ExamineeCount& count) {
    require_counts(count.correct, count.trials);
    return static_cast<double>(count.correct) / static_cast<double>(count.trials) - chance;
  });
  ExamineeLevelTest result{.examinees = counts.size(), .chance = chance};
  result.test = sign_flip_test(above, options);
  result.p = result.test.p;
  result.mean_proportion = chance + result.test.mean;
  result.interval = result.test.interval;
  result.interval.lower = std::max(chance + result.test.interval.lower, 0.0);  // a NaN in front stays NaN
  result.interval.upper = std::min(chance + result.test.interval.upper, 1.0);
  double squares = 0.0;
  for (const double value : above) squares += (value - result.test.mean) * (value - result.test.mean);
  if (above.size() > 1) result.deviation = std::sqrt(squares / static_cast<double>(above.size() - 1));
  if (result.deviation > 0) result.standardised = result.test.mean / result.deviation;
  result.method = {.name = "examinee-level test: " + result.test.method.name,
                   .source = result.test.method.source};
  return result;
}

}  // namespace palpate::analysis
