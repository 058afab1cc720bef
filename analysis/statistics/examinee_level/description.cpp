#include "analysis/statistics/examinee_level/description.hpp"

#include <fmt/core.h>

#include "analysis/description/examinee_counts.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/examinee_level/examinee_level.hpp"
#include "analysis/statistics/examinee_level/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const ExamineeLevelTest& test, Side side) {
  return fmt::format("{}: mean proportion correct {}{}; chance {}\n",
                     counted(static_cast<long>(test.examinees), "examinee", "examinees"),
                     percent(test.mean_proportion),
                     test.examinees > 1 ? ", standard deviation " + percent(test.deviation) : "",
                     chance_in_words(test.chance)) +
         p_line(test.p, side) +
         fmt::format("{} interval for the mean: {} ({})\n", short_percent(test.interval.level),
                     percent_range(test.interval), test.interval.method) +
         (test.standardised
              ? fmt::format("Effect size: {} standard deviations above chance\n", number(*test.standardised))
              : "") +
         method_line(test.method);
}

Outcome examinee_level_outcome(const Arguments& asked) {
  const ExamineeLevelTest test =
      examinee_level_test(read_examinee_counts(asked.table), asked.number("chance"),
                          {.level = asked.level(),
                           .resamples = asked.count("resamples"),
                           .seed = static_cast<std::uint64_t>(asked.count("seed"))});
  Outcome outcome{.json = to_json(test), .text = in_words(test, asked.side())};
  put_side(outcome.json, asked.side());
  return outcome;
}

}  // namespace

Statistic examinee_level_statistic() {
  return {
      .name = "examinee-level",
      .question = "Do people like these examinees answer above chance?",
      .title = "examinee-level test",
      .teaches =
          "The unit is the examinee, not the answer: each one's proportion correct less chance is one "
          "difference, and the test asks whether their mean is 0. So the claim is about people like those "
          "examined, where the pooled binomial says only that somebody answers above chance. At chance 1/2, "
          "where guessing is symmetric, it is the sign-flip permutation test. At another chance the mean is "
          "divided by its standard error between examinees (by that of guessing where it is larger) and "
          "compared with what guessing gives; where people's own probabilities differ about chance, p is "
          "right for many examinees.",
      .inputs = {chance_input(),
                 side_input("greater"),
                 {.name = "resamples",
                  .kind = Input::Kind::Count,
                  .meaning = "Size of the random sample, where not all patterns can be counted",
                  .usual = std::to_string(SignFlipOptions{}.resamples)},
                 {.name = "seed",
                  .kind = Input::Kind::Seed,
                  .meaning = "Of that sample",
                  .usual = std::to_string(SignFlipOptions{}.seed)},
                 level_input()},
      .data = examinee_counts_data(),
      .outputs = {{"examinees", "Rows of data"},
                  {"chance", "Probability of a correct guess"},
                  {"mean_proportion", "Mean of the proportions correct, each examinee counting once"},
                  {"standard_deviation", "of the proportions; null for one examinee"},
                  {"standardised_mean",
                   "Effect size: (mean - chance)/standard deviation; null where that is 0"},
                  {"side", "Alternative that was asked for"},
                  {"p", "p value of that side"},
                  {"p_values", "of all three sides"},
                  {"interval",
                   "for the mean proportion: by inverting the test, or Student's where chance is not 1/2"},
                  {"test", "The test on proportions less chance"}},
      .example = {{"data", {{"correct", {8, 7, 9, 5, 6, 8}}, {"trials", {10, 10, 10, 10, 10, 10}}}}},
      .run = examinee_level_outcome};
}

}  // namespace palpate::analysis
