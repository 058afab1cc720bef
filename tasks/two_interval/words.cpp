#include <fmt/format.h>

#include "tasks/two_interval/two_interval.hpp"

namespace palpate::tasks::two_interval {

using trials::Protocol;

namespace {

const std::string& correct_condition(const Protocol& protocol) {
  return protocol.conditions[protocol.correct].name;
}

/// "soft against hard", where `link` is " against ".
std::string pair_in_words(const Protocol& protocol, std::string_view link) {
  return fmt::format("{}{}{}", protocol.conditions[protocol.presented[0]].name, link,
                     protocol.conditions[protocol.presented[1]].name);
}

}  // namespace

std::string question_in_words(const Protocol& protocol) {
  return fmt::format("{}; \"{}\" is correct", pair_in_words(protocol, " against "),
                     correct_condition(protocol));
}

std::string order_in_words(const Protocol& protocol) {
  const double guess = 100 * kTwoInterval.chance;
  if (protocol.interval_order == trials::IntervalOrder::Balanced)
    return fmt::format(
        "In each cell \"{}\" comes first in exactly half of the {} trials, in random sequence. Nobody is "
        "told whether an answer was right, so that counting the orders helps no more than guessing: {:.0f} % "
        "right.",
        correct_condition(protocol), protocol.trials_per_examinee_per_cell, guess);
  return fmt::format(
      "Before each trial a fair coin decides which interval holds \"{}\"; flips are independent, so that "
      "whoever feels nothing is right in {:.0f} % of the trials whatever rule is followed{}, and may be right "
      "or wrong many times in a row.",
      correct_condition(protocol), guess,
      protocol.feedback ? " and whatever is told of earlier answers" : "");
}

std::string course_in_words(const Protocol& protocol) {
  return fmt::format(
      "{}: the examinee presses on a simulated body in {} intervals, one with each of the conditions {}, in "
      "random order, {} to {} times, at least {:g} mm deep and for at most {:g} s, and then answers the "
      "question. Correct is the interval with the condition {}.",
      kTwoInterval.name, kTwoInterval.intervals, pair_in_words(protocol, " and "),
      protocol.exploration.least_presses, protocol.exploration.most_presses,
      1e3 * protocol.exploration.min_depth, protocol.exploration.max_time, correct_condition(protocol));
}

std::string task_means(const Protocol& protocol) {
  return fmt::format("{} intervals, then: {}", kTwoInterval.intervals, protocol.question);
}

std::string correct_answer_means(const Protocol& protocol) {
  return fmt::format("Number of the interval that held the condition {}", correct_condition(protocol));
}

}  // namespace palpate::tasks::two_interval
