#include "analysis/statistics/similarity/description.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/similarity/similarity.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const SimilarityTest& test) {
  return {{"procedure", "similarity"},
          {"correct", test.correct},
          {"trials", test.trials},
          {"chance", test.chance},
          {"bound", test.bound},
          {"bound_discriminators", test.bound_discriminators},
          {"alpha", test.alpha},
          {"similar", test.similar},
          {"p", test.p},
          {"proportion", test.proportion},
          {"discriminators", test.discriminators},
          {"discriminators_up_to", test.discriminators_up_to},
          {"at_most", test.critical.at_most ? ordered_json(*test.critical.at_most) : ordered_json(nullptr)},
          {"size", test.critical.size},
          {"power_at_chance", test.power_at_chance},
          {"method", to_json(test.method)}};
}

std::string critical_line(const SimilarityTest& test) {
  if (!test.critical.at_most) {
    return fmt::format("No number of correct answers in {} shows similarity: there are too few trials.\n",
                       counted(test.trials, "trial", "trials"));
  }
  return fmt::format(
      "Similar up to {} of {} correct; guessing alone stays there with probability {}, the bound with {}.\n",
      *test.critical.at_most, test.trials, number(test.power_at_chance), number(test.critical.size));
}

std::string in_words(const SimilarityTest& test) {
  return fmt::format("{} of {} correct: {}; discriminators {}, with {} confidence at most {}\n", test.correct,
                     test.trials, percent(test.proportion), percent(test.discriminators),
                     short_percent(1 - test.alpha), percent(test.discriminators_up_to)) +
         fmt::format("Bound: {} correct, which is {} discriminators: {}\n", percent(test.bound),
                     percent(test.bound_discriminators), p_in_words(test.p)) +
         (test.similar ? fmt::format("Below the bound at alpha {}.\n", number(test.alpha))
                       : fmt::format("Not shown to lie below the bound at alpha {}; that does not show a "
                                     "difference either.\n",
                                     number(test.alpha))) +
         critical_line(test) + method_line(test.method);
}

double bound_of(const Arguments& asked) {
  if (asked.given("discriminators") == asked.given("proportion")) {
    throw std::invalid_argument(
        "similarity needs its bound once: either discriminators (such as 0.2) or proportion (correct, such "
        "as 0.6)");
  }
  if (asked.given("proportion")) return asked.number("proportion");
  return proportion_at(asked.number("discriminators"), asked.number("chance"));
}

Outcome similarity_outcome(const Arguments& asked) {
  const SimilarityTest test = similarity_test(asked.count("correct"), asked.count("trials"),
                                              asked.number("chance"), bound_of(asked), asked.number("alpha"));
  return {.json = as_json(test), .text = in_words(test)};
}

}  // namespace

Statistic similarity_statistic() {
  return {
      .name = "similarity",
      .question = "Is what can be felt less than matters?",
      .title = "similarity (equivalence) test of forced choices",
      .teaches =
          "A test that does not reject chance shows nothing. To show that two things cannot be told apart "
          "in any way that matters, say beforehand what would matter: a bound for the proportion of "
          "discriminators, who do not have to guess, or for the proportion correct. The test rejects, at "
          "alpha, that the truth lies at the bound or above. ISO 4120 calls this risk beta. It needs many "
          "more trials than the test for a difference: see the probability that guessing alone passes.",
      .inputs = {correct_input(),
                 trials_input(),
                 chance_input(),
                 {.name = "discriminators",
                  .kind = Input::Kind::Fraction,
                  .meaning = "Bound: proportion of discriminators that would matter",
                  .optional = true},
                 {.name = "proportion",
                  .kind = Input::Kind::Fraction,
                  .meaning = "Bound: proportion correct that would matter, instead",
                  .optional = true},
                 {.name = "alpha",
                  .kind = Input::Kind::Fraction,
                  .meaning = "Largest probability of a false claim of similarity",
                  .usual = "0.05"}},
      .outputs = {{"correct", "Correct answers"},
                  {"trials", "All answers"},
                  {"chance", "Probability of a correct guess"},
                  {"bound", "Proportion correct that would matter"},
                  {"bound_discriminators", "The same as a proportion of discriminators"},
                  {"alpha", "Largest probability of a false claim of similarity"},
                  {"similar", "Whether the test shows the proportion to lie below the bound"},
                  {"p", "Probability of so few correct answers or fewer at the bound"},
                  {"proportion", "correct/trials"},
                  {"discriminators", "Estimate, (proportion - chance)/(1 - chance), not below 0"},
                  {"discriminators_up_to", "Upper bound with confidence 1 - alpha, exact"},
                  {"at_most", "Critical number: similar up to this many correct; null: no number is"},
                  {"size", "Probability of a claim of similarity at the bound"},
                  {"power_at_chance", "Probability of a claim of similarity when everybody guesses"}},
      .example = {{"correct", 22}, {"trials", 66}, {"chance", "1/3"}, {"discriminators", 0.3}},
      .run = similarity_outcome};
}

}  // namespace palpate::analysis
