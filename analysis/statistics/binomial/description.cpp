#include "analysis/statistics/binomial/description.hpp"

#include <fmt/core.h>

#include "analysis/binomial/binomial_test.hpp"
#include "analysis/binomial/to_json.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string bound_line(const BinomialTest& test) {
  if (test.side == Side::TwoSided) return "";
  const bool greater = test.side == Side::Greater;
  return fmt::format("One-sided {} bound that belongs to the test: {} {}\n", short_percent(test.bound.level),
                     greater ? "at least" : "at most",
                     percent(greater ? test.bound.lower : test.bound.upper));
}

std::string in_words(const BinomialTest& test) {
  return fmt::format("{} of {} correct: {}\n", test.correct, test.trials, percent(test.proportion)) +
         fmt::format("Against chance {}: ", chance_in_words(test.chance)) + p_line(test.p, test.side) +
         "With mid-p: " + p_line(test.mid_p, test.side) +
         fmt::format("{} interval: {} (Clopper-Pearson, exact), {} (Wilson), {} (Jeffreys)\n",
                     short_percent(test.interval.level), percent_range(test.interval),
                     percent_range(test.wilson), percent_range(test.jeffreys)) +
         bound_line(test) + method_line(test.method);
}

Outcome binomial_outcome(const Arguments& asked) {
  const BinomialTest test = binomial_test(asked.count("correct"), asked.count("trials"),
                                          asked.number("chance"), asked.side(), asked.level());
  return {.json = to_json(test), .text = in_words(test)};
}

}  // namespace

Statistic binomial_statistic() {
  return {
      .name = "binomial",
      .question = "Are more answers correct than guessing gives?",
      .title = "exact binomial test",
      .teaches =
          "Tests that every answer is correct with the probability of a guess. It asks for answers that are "
          "independent when nobody feels anything: orders drawn by fair coins make them so. Two-sided p "
          "values add up all outcomes that are no likelier than the one seen, as R's binom.test does. The "
          "exact test keeps to alpha always; mid-p counts half of what is as likely as the outcome seen and "
          "keeps to it on the average only: say beforehand which of them decides.",
      .inputs = {correct_input(), trials_input(), chance_input(), side_input("greater"), level_input()},
      .outputs = {{"correct", "Correct answers"},
                  {"trials", "All answers"},
                  {"chance", "Probability of a correct guess"},
                  {"side", "Alternative that was asked for"},
                  {"proportion", "correct/trials"},
                  {"p", "p value of that side"},
                  {"p_values", "of all three sides"},
                  {"mid_p", "mid-p value of that side"},
                  {"mid_p_values", "of all three sides"},
                  {"interval", "for the proportion, Clopper-Pearson"},
                  {"bound", "one-sided bound that belongs to the test"},
                  {"wilson", "interval for the proportion, Wilson"},
                  {"jeffreys", "interval for the proportion, Jeffreys"}},
      .example = {{"correct", 41}, {"trials", 60}, {"chance", "1/2"}, {"side", "greater"}},
      .run = binomial_outcome};
}

}  // namespace palpate::analysis
