#include "analysis/mixed/observations.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <map>
#include <stdexcept>

#include "analysis/numerics/infinity.hpp"
#include "analysis/numerics/result.hpp"

namespace palpate::analysis {
namespace {

struct Counts {
  long ones = 0;
  long trials = 0;
};

// By examinee in the order of their names, then by level: the result does not depend on the order of rows.
using Grouped = std::map<std::string, std::map<double, Counts>>;

Grouped group(const std::vector<LevelAnswers>& answers) {
  Grouped grouped;
  for (const LevelAnswers& row : answers) {
    require_counts(row.ones, row.trials);
    require_finite(row.level, "level");
    Counts& counts = grouped[row.examinee][row.level];
    counts.ones += row.ones;
    counts.trials += row.trials;
  }
  return grouped;
}

double log_ways(long ones, long trials) {
  using boost::math::lgamma;
  const double k = static_cast<double>(ones), n = static_cast<double>(trials);
  return lgamma(n + 1) - lgamma(k + 1) - lgamma(n - k + 1);
}

// The levels over which each kind of answer was given.
struct Reach {
  double least_zero = kInfinity, most_zero = -least_zero;
  double least_one = least_zero, most_one = -least_zero;

  void add(double level, const Counts& counts) {
    if (counts.ones > 0) least_one = std::min(least_one, level), most_one = std::max(most_one, level);
    if (counts.ones < counts.trials)
      least_zero = std::min(least_zero, level), most_zero = std::max(most_zero, level);
  }
};

void refuse_separation(const Grouped& grouped) {
  Reach all;
  bool rising = true, falling = true;  // whether each examinee's answers change at once, and which way
  for (const auto& [name, levels] : grouped) {
    Reach own;
    for (const auto& [level, counts] : levels) own.add(level, counts), all.add(level, counts);
    rising = rising && own.most_zero < own.least_one;
    falling = falling && own.most_one < own.least_zero;
  }
  if (all.most_zero <= all.least_one || all.most_one <= all.least_zero) {
    throw std::invalid_argument(fmt::format(
        "the level separates the answers completely (0 from {} to {}, 1 from {} to {}): the slope "
        "has no finite estimate; levels nearer to the change are needed",
        all.least_zero, all.most_zero, all.least_one, all.most_one));
  }
  if (rising || falling) {
    throw std::invalid_argument(
        "the level separates the answers of every examinee completely: the slope has no finite estimate; "
        "levels nearer to each one's change are needed");
  }
}

void standardise(Observations& data) {
  const double n = static_cast<double>(data.total_trials);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < data.x.size(); ++i) sum += data.trials[i] * data.x[i];
  data.centre = sum / n;
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    squares += data.trials[i] * (data.x[i] - data.centre) * (data.x[i] - data.centre);
  }
  data.scale = std::sqrt(squares / n);
  for (double& x : data.x) x = (x - data.centre) / data.scale;
}

}  // namespace

Observations observations(const std::vector<LevelAnswers>& answers) {
  const Grouped grouped = group(answers);
  Observations data{.rows = answers.size()};
  for (const auto& [name, levels] : grouped) {
    data.first.push_back(data.x.size());
    for (const auto& [level, counts] : levels) {
      data.x.push_back(level);
      data.ones.push_back(static_cast<double>(counts.ones));
      data.trials.push_back(static_cast<double>(counts.trials));
      data.total_ones += counts.ones;
      data.total_trials += counts.trials;
    }
  }
  data.first.push_back(data.x.size());
  for (const LevelAnswers& row : answers) data.log_ways += log_ways(row.ones, row.trials);
  if (grouped.size() < 2) {
    throw std::invalid_argument(fmt::format(
        "{} examinee; a mixed model needs at least 2, for one alone says nothing of how people differ",
        grouped.size()));
  }
  if (data.total_ones == 0 || data.total_ones == data.total_trials) {
    throw std::invalid_argument(fmt::format("all {} answers are {}; the model needs answers of both kinds",
                                            data.total_trials, data.total_ones == 0 ? 0 : 1));
  }
  const auto [least, most] = std::minmax_element(data.x.begin(), data.x.end());
  if (*least == *most) {
    throw std::invalid_argument(fmt::format("every answer is at level {}; a slope needs two levels", *least));
  }
  refuse_separation(grouped);
  standardise(data);
  return data;
}

}  // namespace palpate::analysis
