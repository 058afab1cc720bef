#include "analysis/statistics/ttest/description.hpp"

#include <fmt/core.h>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/ttest/paired_t.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

nlohmann::ordered_json as_json(const PairedTTest& test) {
  return {{"procedure", "ttest"},
          {"n", test.n},
          {"mean", test.mean},
          {"standard_deviation", test.standard_deviation},
          {"t", test.t},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p_values", to_json(test.p)},
          {"interval", to_json(test.interval)},
          {"cohen_dz", test.cohen_dz},
          {"cohen_dz_interval", to_json(test.dz_interval)},
          {"method", to_json(test.method)}};
}

std::string in_words(const PairedTTest& test, Side side) {
  return fmt::format("{}: mean {}, standard deviation {}\n",
                     counted(static_cast<long>(test.n), "difference", "differences"), number(test.mean),
                     number(test.standard_deviation)) +
         fmt::format("t = {}, {}: ", number(test.t),
                     counted(test.degrees_of_freedom, "degree of freedom", "degrees of freedom")) +
         p_line(test.p, side) +
         fmt::format("{} interval for the mean: {} ({})\n", short_percent(test.interval.level),
                     range(test.interval), test.interval.method) +
         fmt::format("Effect size: Cohen's d_z = {}, {} interval {} ({})\n", number(test.cohen_dz),
                     short_percent(test.dz_interval.level), range(test.dz_interval),
                     test.dz_interval.method) +
         method_line(test.method);
}

Outcome ttest_outcome(const Arguments& asked) {
  const PairedTTest test = paired_t_test(number_column(asked.table, "difference"), asked.level());
  Outcome outcome{.json = as_json(test), .text = in_words(test, asked.side())};
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic ttest_statistic() {
  return {.name = "ttest",
          .question = "Is the mean difference zero, for differences that are normal?",
          .title = "paired t-test",
          .teaches =
              "Student's test on the differences of pairs, with Cohen's d_z, the mean in standard deviations "
              "of the differences. It asks for independent differences from a normal distribution, or for "
              "many of them; permutation asks for less. Which one is used is decided beforehand.",
          .inputs = {side_input("two-sided"), level_input()},
          .data = difference_data("One thing less the other, for each examinee"),
          .outputs = {{"n", "Differences given"},
                      {"mean", "of the differences"},
                      {"standard_deviation", "of the differences"},
                      {"t", "mean/standard error"},
                      {"degrees_of_freedom", "n - 1"},
                      {"side", "Alternative that was asked for"},
                      {"p", "p value of that side"},
                      {"p_values", "of all three sides"},
                      {"interval", "for the mean"},
                      {"cohen_dz", "Effect size, mean/standard deviation"},
                      {"cohen_dz_interval", "for it, by the noncentral t distribution"}},
          .example = {{"data", {{"difference", {3, 1, 2, -1, 4, 2, 0, 3, 1, 2}}}}},
          .run = ttest_outcome};
}

}  // namespace palpate::analysis
