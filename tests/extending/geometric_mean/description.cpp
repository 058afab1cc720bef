#include "tests/extending/geometric_mean/description.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/ttest/paired_t.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

/// The mean of logarithms and Student's interval for it, taken back: for what is multiplied rather than
/// added, such as magnitude estimates.
Outcome outcome_of(const Arguments& asked) {
  std::vector<double> logarithms = number_column(asked.table, "estimate");
  for (double& value : logarithms) {
    if (!(value > 0.0))
      throw std::invalid_argument(fmt::format("estimate: found {}, accepted: greater than 0", value));
    value = std::log(value);
  }
  const PairedTTest test = paired_t_test(logarithms, asked.level());
  const double mean = std::exp(test.mean);
  Interval interval = test.interval;
  interval.lower = std::exp(interval.lower);
  interval.upper = std::exp(interval.upper);
  return {.json = {{"procedure", "geometric-mean"},
                   {"n", test.n},
                   {"geometric_mean", mean},
                   {"interval", to_json(interval)}},
          .text = fmt::format("{}: geometric mean {}, {} interval {}\n",
                              counted(static_cast<long>(test.n), "estimate", "estimates"), number(mean),
                              short_percent(interval.level), range(interval))};
}

}  // namespace

Statistic geometric_mean_statistic() {
  return {.name = "geometric-mean",
          .question = "What do estimates come to whose logarithms are normal?",
          .title = "geometric mean",
          .teaches = "The mean for magnitude estimates, which people give as ratios.",
          .inputs = {level_input()},
          .data = {.shape = Data::Shape::Columns,
                   .meaning = "one estimate a row, an examinee each",
                   .columns = {{.name = "estimate", .meaning = "A number greater than 0"}}},
          .outputs = {{"n", "Estimates given"},
                      {"geometric_mean", "of them"},
                      {"interval", "for it, Student's of the logarithms"}},
          .example = {{"data", {{"estimate", {1, 10, 100}}}}},
          .run = outcome_of};
}

}  // namespace palpate::analysis
