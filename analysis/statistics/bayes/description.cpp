#include "analysis/statistics/bayes/description.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/statistics/bayes/bayes_factor.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const BayesFactor& result) {
  return {{"procedure", "bayes"},
          {"correct", result.correct},
          {"trials", result.trials},
          {"chance", result.chance},
          {"side", name_of(result.side)},
          {"prior", {result.prior.a, result.prior.b}},
          {"bayes_factor", to_json(result.bayes_factor)},
          {"log_bayes_factor", to_json(result.log_bayes_factor)},
          {"evidence", evidence_in_words(result.log_bayes_factor)},
          {"posterior_median", to_json(result.posterior_median)},
          {"interval", to_json(result.interval)},
          {"method", to_json(result.method)}};
}

std::string in_words(const BayesFactor& result) {
  const double share = static_cast<double>(result.correct) / static_cast<double>(result.trials);
  const bool against = result.log_bayes_factor >= 0;
  return fmt::format("{} of {} correct: {}\n", result.correct, result.trials, percent(share)) +
         fmt::format("The answers are {} times as likely {} as {}: {}.\n",
                     number(std::exp(std::abs(result.log_bayes_factor))),
                     against ? "under the prior" : "under chance",
                     against ? "under chance" : "under the prior",
                     evidence_in_words(result.log_bayes_factor)) +
         fmt::format("Bayes factor {} (against chance); its reciprocal {}\n", number(result.bayes_factor),
                     number(std::exp(-result.log_bayes_factor))) +
         fmt::format("If it is not chance: median {}, {} credible interval {}\n",
                     percent(result.posterior_median), short_percent(result.interval.level),
                     percent_range(result.interval)) +
         method_line(result.method);
}

Outcome bayes_outcome(const Arguments& asked) {
  const std::vector<double> prior = asked.numbers("prior");
  if (prior.size() != 2) {
    throw std::invalid_argument(fmt::format("prior has {}; accepted: two, a and b of a beta distribution",
                                            counted(static_cast<long>(prior.size()), "number", "numbers")));
  }
  const BayesFactor result =
      bayes_factor(asked.count("correct"), asked.count("trials"), asked.number("chance"), asked.side(),
                   {.a = prior[0], .b = prior[1]}, asked.level());
  return {.json = as_json(result), .text = in_words(result)};
}

}  // namespace

Statistic bayes_statistic() {
  return {
      .name = "bayes",
      .question = "How much do the answers speak for or against chance?",
      .title = "Bayes factor against chance",
      .teaches =
          "How many times likelier the answers are if the proportion correct lies above chance (side "
          "greater), below or off it, than if it is chance. Unlike a p value it can speak for chance. The "
          "answer depends on the prior: what is believed beforehand about the proportion if it is not "
          "chance, a beta distribution, by default with every proportion above chance equally likely. The "
          "prior is decided before the data are seen, and reported. Answers are taken for independent.",
      .inputs = {correct_input(),
                 trials_input(),
                 chance_input(),
                 side_input("greater"),
                 {.name = "prior",
                  .kind = Input::Kind::Numbers,
                  .meaning = "a and b of the beta prior, cut off at chance where the side is greater or less",
                  .usual = "1,1"},
                 level_input()},
      .outputs = {{"correct", "Correct answers"},
                  {"trials", "All answers"},
                  {"chance", "Probability of a correct guess"},
                  {"side", "Alternative that was asked for"},
                  {"prior", "a and b of the beta prior"},
                  {"bayes_factor", "P(answers if not chance)/P(answers if chance)"},
                  {"log_bayes_factor",
                   "its natural logarithm; null where the factor is too small for a number"},
                  {"evidence", "Kass & Raftery's words for it"},
                  {"posterior_median", "of the proportion, if it is not chance"},
                  {"interval", "credible, for the same"}},
      .example = {{"correct", 41}, {"trials", 60}},
      .run = bayes_outcome};
}

}  // namespace palpate::analysis
