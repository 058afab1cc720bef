#include "analysis/statistics/dprime/description.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/description/phrases.hpp"
#include "analysis/detection/detection_words.hpp"
#include "analysis/detection/dprime.hpp"
#include "analysis/detection/to_json.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

std::string below_chance(const DPrime& d_prime) {
  if (knows_direction(d_prime.task) || d_prime.proportion > chance_of(d_prime.task)) return "";
  return fmt::format("No more than the {} that guessing gives: d' is 0.\n", percent(chance_of(d_prime.task)));
}

std::string in_words(const DPrime& d_prime) {
  const double observed = static_cast<double>(d_prime.correct) / static_cast<double>(d_prime.trials);
  return fmt::format("{} of {} correct: {}\n", d_prime.correct, d_prime.trials, percent(observed)) +
         (d_prime.corrected ? fmt::format("Corrected to {} ({}).\n", percent(d_prime.proportion),
                                          name_of(d_prime.correction))
                            : "") +
         fmt::format("d' = {} (standard error {})\n{} interval: {} ({})\n", number(d_prime.d_prime),
                     std::isfinite(d_prime.standard_error) ? number(d_prime.standard_error) : "none",
                     short_percent(d_prime.interval.level), range(d_prime.interval),
                     d_prime.interval.method) +
         below_chance(d_prime) + method_line(d_prime.method);
}

Outcome dprime_outcome(const Arguments& asked) {
  std::optional<long> alternatives;
  std::optional<Strategy> strategy;
  if (asked.given("alternatives")) alternatives = asked.count("alternatives");
  if (asked.given("strategy")) strategy = strategy_from_name(asked.text("strategy"));
  const DPrime d_prime =
      dprime(choice_task(asked.text("task"), alternatives, strategy), asked.count("correct"),
             asked.count("trials"), correction_from_name(asked.text("correction")), asked.level());
  return {.json = to_json(d_prime), .text = in_words(d_prime)};
}

}  // namespace

Statistic dprime_statistic() {
  return {
      .name = "dprime",
      .question = "How well are two stimuli told apart?",
      .title = "d' of a choice task",
      .teaches =
          "d' is the distance between two stimuli in standard deviations of what one presentation feels "
          "like, for an observer who prefers no answer; it makes results of different tasks comparable. "
          "2IFC and 2AFC: sqrt(2) z(proportion correct). m-AFC: the strongest of m. Triangle: the sample "
          "that differs most. Oddity and ABX depend on how an answer comes about, so the strategy has to be "
          "said: differencing compares the presentations of a trial with each other, as where stimuli "
          "vary from trial to trial; independent-observations judges each against two stimuli that are "
          "well known. For answers yes/no or same/different see yes-no and same-different. At 100 % d' would "
          "be infinite: half-trial puts 1 - 1/(2n) there (Macmillan & Kaplan 1985), log-linear always takes "
          "(k + 1/2)/(n + 1) (Hautus 1995), none leaves it.",
      .inputs = {correct_input(),
                 trials_input(),
                 {.name = "task",
                  .kind = Input::Kind::Choice,
                  .meaning = "What was asked",
                  .usual = "2IFC",
                  .choices = {"2IFC", "2AFC", "m-AFC", "triangle", "oddity", "ABX"}},
                 {.name = "alternatives",
                  .kind = Input::Kind::Count,
                  .meaning = "Of m-AFC: how many there are to choose from",
                  .optional = true},
                 {.name = "strategy",
                  .kind = Input::Kind::Choice,
                  .meaning = "Of oddity and ABX: how an answer is taken to come about",
                  .optional = true,
                  .choices = {"differencing", "independent-observations"}},
                 correction_input("half-trial"),
                 level_input()},
      .outputs = {{"task", "What was asked"},
                  {"alternatives", "of an answer"},
                  {"strategy", "of oddity and ABX; null for the others"},
                  {"chance", "Probability of a correct guess"},
                  {"correct", "Correct answers"},
                  {"trials", "All answers"},
                  {"proportion", "that entered the model, after the correction"},
                  {"correction", "at 0 and 100 %"},
                  {"corrected", "Whether it changed the proportion"},
                  {"d_prime", "d'; null where it is infinite"},
                  {"standard_error", "by the delta method; null where there is none"},
                  {"interval", "from the exact interval for the proportion"}},
      .example = {{"correct", 41}, {"trials", 60}},
      .run = dprime_outcome};
}

}  // namespace palpate::analysis
