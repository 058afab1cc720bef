#include "analysis/report/over_examinees.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "analysis/resampling/bootstrap.hpp"

namespace palpate::analysis {

std::optional<Interval> interval_over_examinees(std::span<const ExamineeCount> examinees, double level) {
  constexpr long kMostDraws = 20'000'000;
  std::vector<ExamineeCount> answered;
  std::ranges::copy_if(examinees, std::back_inserter(answered),
                       [](const ExamineeCount& count) { return count.trials > 0; });
  const auto alike = [&](const ExamineeCount& count) {
    return count.correct * answered.front().trials == answered.front().correct * count.trials;
  };
  if (answered.size() < 2 || std::ranges::all_of(answered, alike)) return std::nullopt;
  const auto proportion = [&](std::span<const std::size_t> drawn) {
    long correct = 0, trials = 0;
    for (const std::size_t examinee : drawn) {
      correct += answered[examinee].correct;
      trials += answered[examinee].trials;
    }
    return static_cast<double>(correct) / static_cast<double>(trials);
  };
  const long resamples = std::clamp(kMostDraws / static_cast<long>(answered.size()), 999L, 9999L);
  return bootstrap_interval(answered.size(), proportion, {.level = level, .resamples = resamples});
}

}  // namespace palpate::analysis
