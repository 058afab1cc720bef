#include "analysis/statistics/critical/description.hpp"

#include <fmt/core.h>

#include "analysis/binomial/critical_number.hpp"
#include "analysis/binomial/to_json.hpp"
#include "analysis/description/phrases.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string in_words(const CriticalNumber& critical) {
  std::string text;
  if (critical.at_least) text += fmt::format("{} or more of {} correct", *critical.at_least, critical.trials);
  if (critical.at_most) {
    text += fmt::format("{}{} or fewer of {} correct", text.empty() ? "" : ", or ", *critical.at_most,
                        critical.trials);
  }
  if (text.empty()) {
    return fmt::format(
        "No number of correct answers in {} rejects chance {} at alpha {} (side {}): there are too "
        "few trials.\n",
        counted(critical.trials, "trial", "trials"), chance_in_words(critical.chance), critical.alpha,
        name_of(critical.side));
  }
  return fmt::format("{} rejects chance {} at alpha {} (side {}).\n", text, chance_in_words(critical.chance),
                     critical.alpha, name_of(critical.side)) +
         fmt::format("Actual size: guessing is rejected with probability {}.\n", number(critical.size)) +
         method_line(critical.method);
}

Outcome critical_outcome(const Arguments& asked) {
  const CriticalNumber critical =
      critical_number(asked.count("trials"), asked.number("chance"), asked.number("alpha"), asked.side());
  return {.json = to_json(critical), .text = in_words(critical)};
}

}  // namespace

Statistic critical_statistic() {
  return {.name = "critical",
          .question = "How many correct answers are needed?",
          .title = "critical number of the exact binomial test",
          .teaches =
              "The smallest number of correct answers that guessing reaches with a probability of at "
              "most alpha, and how large that probability really is. Kuroda et al. 2003, 60 answers per "
              "model: 37.",
          .inputs = {trials_input(), chance_input(), alpha_input(), side_input("greater")},
          .outputs = {{"trials", "All answers"},
                      {"chance", "Probability of a correct guess"},
                      {"alpha", "Largest probability of a false rejection"},
                      {"side", "Alternative that was asked for"},
                      {"at_least", "So many correct answers or more reject; null: no number does"},
                      {"at_most", "So many or fewer reject; null: no number does"},
                      {"size", "Probability of a rejection when everybody guesses"}},
          .example = {{"trials", 60}, {"chance", "1/2"}, {"alpha", 0.05}, {"side", "greater"}},
          .run = critical_outcome};
}

}  // namespace palpate::analysis
