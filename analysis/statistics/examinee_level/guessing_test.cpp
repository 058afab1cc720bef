#include "analysis/statistics/examinee_level/guessing_test.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/numerics/rounding.hpp"

namespace palpate::analysis {
namespace {

constexpr double kMostSteps = 1e7;  // of the exact distribution: half a second
constexpr double kAlike = 1e-9;     // statistics that differ by less, relative, are equal

struct Studentised {
  double examinees = 1.0;
  double chance = 0.5;
  double guessing_variance = 0.0;  // v

  // Of the sum of the proportions and the sum of their squares.
  double operator()(double sum, double squares) const {
    const double mean = sum / examinees;
    const double s2 = examinees > 1 ? (squares - sum * mean) / (examinees - 1) : 0.0;
    return (mean - chance) / std::sqrt(std::max(s2, guessing_variance) / examinees);
  }
};

Studentised studentised(std::span<const ExamineeCount> counts, double chance) {
  Studentised statistic{.examinees = static_cast<double>(counts.size()), .chance = chance};
  for (const ExamineeCount& count : counts)
    statistic.guessing_variance +=
        chance * (1 - chance) / static_cast<double>(count.trials) / statistic.examinees;
  return statistic;
}

// Probabilities of statistics at least, and at most, as large as the one seen.
struct Sides {
  double seen = 0.0;
  double greater = 0.0, less = 0.0;

  void add(double statistic, double probability) {
    const double slack = kAlike * (1 + std::abs(seen));
    if (statistic >= seen - slack) greater += probability;
    if (statistic <= seen + slack) less += probability;
  }
  PValues p() const {
    PValues p{.greater = std::min(1.0, greater), .less = std::min(1.0, less)};
    p.two_sided = std::min(1.0, 2 * std::min(p.greater, p.less));
    return p;
  }
};

// Sums of proportions and of their squares in whole steps of a common denominator, as one number.
using SumStates = std::vector<std::pair<std::uint64_t, double>>;

struct CommonSteps {
  std::uint64_t denominator = 1;
  std::uint64_t base = 1;  // more than any sum of squares
};

std::optional<CommonSteps> common_steps(std::span<const ExamineeCount> counts) {
  CommonSteps steps;
  for (const ExamineeCount& count : counts) {
    steps.denominator = std::lcm(steps.denominator, static_cast<std::uint64_t>(count.trials));
    if (steps.denominator > 100'000) return std::nullopt;
  }
  const double n = static_cast<double>(counts.size()), d = static_cast<double>(steps.denominator);
  if (n * d * (n * d * d + 1) > 9e18) return std::nullopt;
  steps.base = counts.size() * steps.denominator * steps.denominator + 1;
  return steps;
}

SumStates with_examinee(const SumStates& states, std::uint64_t trials, double chance,
                        const CommonSteps& steps) {
  const boost::math::binomial_distribution<> guessed(static_cast<double>(trials), chance);
  std::unordered_map<std::uint64_t, double> reached;
  for (std::uint64_t k = 0; k <= trials; ++k) {
    const std::uint64_t step = k * (steps.denominator / trials), move = step * steps.base + step * step;
    const double probability = pdf(guessed, static_cast<double>(k));
    for (const auto& [sums, before] : states) reached[sums + move] += before * probability;
  }
  SumStates sorted(reached.begin(), reached.end());
  std::ranges::sort(sorted);  // so that probabilities are added in one order everywhere
  return sorted;
}

std::optional<PValues> exact_guessing_p(std::span<const ExamineeCount> counts, double chance,
                                        const Studentised& statistic) {
  const auto steps = common_steps(counts);
  if (!steps) return std::nullopt;
  SumStates states = {{0, 1.0}};
  double done = 0.0;
  std::uint64_t seen = 0;
  for (const ExamineeCount& count : counts) {
    const auto trials = static_cast<std::uint64_t>(count.trials);
    done += static_cast<double>(states.size()) * static_cast<double>(trials + 1);
    if (done > kMostSteps) return std::nullopt;
    states = with_examinee(states, trials, chance, *steps);
    const std::uint64_t step = static_cast<std::uint64_t>(count.correct) * (steps->denominator / trials);
    seen += step * steps->base + step * step;
  }
  const double d = static_cast<double>(steps->denominator);
  const auto of = [&](std::uint64_t sums) {
    const std::uint64_t sum = sums / steps->base, squares = sums % steps->base;
    return statistic(static_cast<double>(sum) / d, static_cast<double>(squares) / (d * d));
  };
  Sides sides{.seen = of(seen)};
  for (const auto& [sums, probability] : states) sides.add(of(sums), probability);
  return sides.p();
}

// P(X <= 0), P(X <= 1), ... of guessing, for each number of trials that there is.
std::map<long, std::vector<double>> guessed_below(std::span<const ExamineeCount> counts, double chance) {
  std::map<long, std::vector<double>> below;
  for (const ExamineeCount& count : counts) {
    const auto [table, is_new] = below.try_emplace(count.trials);
    if (!is_new) continue;
    const boost::math::binomial_distribution<> guessed(static_cast<double>(count.trials), chance);
    for (long k = 0; k < count.trials; ++k) table->second.push_back(cdf(guessed, static_cast<double>(k)));
  }
  return below;
}

PValues sampled_guessing_p(std::span<const ExamineeCount> counts, double chance, const Studentised& statistic,
                           const SignFlipOptions& options) {
  double sum = 0.0, squares = 0.0;
  const auto add = [&](double correct, long trials) {
    const double proportion = correct / static_cast<double>(trials);
    sum += proportion;
    squares += proportion * proportion;
  };
  for (const ExamineeCount& count : counts) add(static_cast<double>(count.correct), count.trials);
  Sides sides{.seen = statistic(sum, squares), .greater = 1, .less = 1};  // the answers themselves
  const auto tables = guessed_below(counts, chance);
  std::vector<const std::vector<double>*> below;
  for (const ExamineeCount& count : counts) below.push_back(&tables.at(count.trials));
  std::mt19937_64 random(options.seed);
  for (long sample = 0; sample < options.resamples; ++sample) {
    sum = squares = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double uniform = static_cast<double>(random() >> 11) * 0x1.0p-53;  // [0, 1)
      const auto drawn = std::ranges::upper_bound(*below[i], uniform) - below[i]->begin();
      add(static_cast<double>(drawn), counts[i].trials);
    }
    sides.add(statistic(sum, squares), 1);
  }
  const double all = static_cast<double>(options.resamples + 1);
  sides.greater /= all, sides.less /= all;
  return sides.p();
}

Interval student_interval(std::span<const double> above, double mean, double level) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Interval interval{.lower = kNone, .upper = kNone, .level = level, .method = "none: one examinee"};
  if (above.size() < 2) return interval;
  interval.method = "none: all proportions are equal";
  const std::vector<double> settled = settled_differences(above);
  if (std::ranges::all_of(settled, [&](double value) { return value == settled.front(); })) return interval;
  const double n = static_cast<double>(above.size());
  double squares = 0.0;
  for (const double value : above) squares += (value - mean) * (value - mean);
  const double half = quantile(complement(boost::math::students_t(n - 1), (1 - level) / 2)) *
                      std::sqrt(squares / (n - 1) / n);
  return {.lower = mean - half, .upper = mean + half, .level = level, .method = "Student's t"};
}

// The chance of each number correct is tabulated.
void require_few_answers(std::span<const ExamineeCount> counts) {
  constexpr long kMostAnswers = 10'000'000;
  long all = 0;
  for (const ExamineeCount& count : counts) all += count.trials;
  if (all <= kMostAnswers) return;
  throw std::invalid_argument(
      fmt::format("{} trials in all; accepted for a chance other than 1/2: up to {}", all, kMostAnswers));
}

}  // namespace

SignFlipTest guessing_test(std::span<const ExamineeCount> counts, double chance,
                           const SignFlipOptions& options) {
  require_level(chance, "chance");
  require_level(options.level, "confidence level");
  if (options.resamples < 999)
    throw std::invalid_argument(fmt::format("{} resamples; at least 999 are needed", options.resamples));
  require_few_answers(counts);
  SignFlipTest test{.n = counts.size()};
  std::vector<double> above;
  for (const ExamineeCount& count : counts)
    above.push_back(static_cast<double>(count.correct) / static_cast<double>(count.trials) - chance);
  test.mean = std::reduce(above.begin(), above.end()) / static_cast<double>(test.n);
  const Studentised statistic = studentised(counts, chance);
  const auto exact = exact_guessing_p(counts, chance, statistic);
  test.exact = exact.has_value();
  test.p = exact ? *exact : sampled_guessing_p(counts, chance, statistic, options);
  if (!exact) test.seed = options.seed, test.resamples = options.resamples;
  test.interval = student_interval(above, test.mean, options.level);
  test.method = {.name = fmt::format("studentised mean against guessing, {}",
                                     exact ? "exact"
                                           : fmt::format("Monte Carlo with {} resamples, seed {}, add-one "
                                                         "rule",
                                                         options.resamples, options.seed)),
                 .source = exact ? "Student 1908; binomial distribution of each examinee"
                                 : "Student 1908; Phipson & Smyth 2010"};
  return test;
}

}  // namespace palpate::analysis
