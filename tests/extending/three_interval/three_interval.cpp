#include "tests/extending/three_interval/three_interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/detection/dprime.hpp"
#include "trials/observer/observer.hpp"
#include "trials/plan/plan.hpp"
#include "trials/protocol/reading.hpp"

namespace palpate::tasks {
namespace {

using trials::Generator;
using trials::Protocol;
using trials::Trial;

// The design.

constexpr std::array kKeys{
    base::Key{.name = "other",
              .takes = base::kText,
              .example = "\"soft\"",
              .meaning = "The condition that two of the intervals present."},
    base::Key{.name = "correct",
              .takes = base::kText,
              .example = "\"hard\"",
              .meaning = "The condition that one interval presents: that interval is the correct answer."},
};

base::Words coin() {
  return {.now = {{"coin", "each interval is as likely as any other to hold the correct condition"}},
          .later = {}};
}
constexpr std::array kOrderKeys{
    base::Key{.name = "interval",
              .takes = base::takes_word(coin),
              .example = "\"coin\"",
              .meaning = "How it is drawn which interval holds what."},
};

void read(base::TomlReader& task, Protocol& protocol) {
  const std::string other = task.text("other"), correct = task.text("correct");
  if (other == correct) task.refuse("other", "accepted: another condition than the correct one");
  protocol.presented = {trials::condition_index(task, "other", protocol, other),
                        trials::condition_index(task, "correct", protocol, correct)};
  protocol.correct = protocol.presented[1];
}

void read_order(base::TomlReader& order, Protocol&) {
  order.word("interval");
}

void check_primary(const base::TomlReader& analysis, const Protocol& protocol) {
  if (protocol.analysis.primary != trials::PrimaryAnalysis::PairedComparison)
    analysis.refuse("primary", "accepted: \"paired-comparison\"");
}

// Drawing.

int correct_answer(const Protocol& protocol, const Trial& trial) {
  const auto held = std::ranges::find(trial.interval_condition, protocol.correct);
  if (held == trial.interval_condition.end()) return 0;
  return 1 + static_cast<int>(held - trial.interval_condition.begin());
}

void redraw(const Protocol& protocol, Trial& trial, Generator& generator) {
  trial.interval_condition.assign(3, protocol.presented[0]);
  trial.interval_condition[generator.below(3)] = protocol.correct;
  trial.correct_answer = correct_answer(protocol, trial);
}

void draw(const Protocol& protocol, std::span<Trial> trials, Generator& generator) {
  for (Trial& trial : trials) redraw(protocol, trial, generator);
}

// What a simulated person answers: the interval that felt stiffest, or softest where that is asked for.

int decide(const Protocol& protocol, std::span<const std::optional<double>> percepts,
           const trials::Observer& observer, Generator& generator) {
  const auto guess = static_cast<std::ptrdiff_t>(generator.below(3));
  const bool felt_all =
      std::ranges::all_of(percepts, [](const auto& percept) { return percept.has_value(); });
  if (!felt_all || generator.uniform() < observer.parameters->lapse_rate) return 1 + static_cast<int>(guess);
  const auto [softest, stiffest] = std::ranges::minmax_element(percepts);
  const auto chosen = protocol.answer == trials::Answer::Softest ? softest : stiffest;
  return 1 + static_cast<int>(chosen - percepts.begin());
}

double d_prime(long correct, long trials) {
  return analysis::dprime(analysis::choice_task("m-AFC", 3, {}), correct, trials,
                          analysis::DPrimeCorrection::None)
      .d_prime;
}

// Words.

std::string question_in_words(const Protocol& protocol) {
  return fmt::format("\"{}\" once and \"{}\" twice", protocol.conditions[protocol.correct].name,
                     protocol.conditions[protocol.presented[0]].name);
}
std::string order_in_words(const Protocol& protocol) {
  return fmt::format("Each of the three intervals is as likely as any other to hold \"{}\".",
                     protocol.conditions[protocol.correct].name);
}
std::string course_in_words(const Protocol& protocol) {
  return fmt::format("3IFC: three intervals present {}, in random order.", question_in_words(protocol));
}
std::string task_means(const Protocol& protocol) {
  return fmt::format("three intervals, then: {}", protocol.question);
}
std::string correct_answer_means(const Protocol& protocol) {
  return fmt::format("Number of the interval that held the condition {}",
                     protocol.conditions[protocol.correct].name);
}

constexpr std::array<std::string_view, 1> kOne{"1"}, kTwo{"2"}, kThree{"3"};
constexpr std::array<trials::Choice, 3> kChoices{
    {{"First turn", kOne}, {"Second turn", kTwo}, {"Third turn", kThree}}};

}  // namespace

constexpr trials::Task kThreeInterval{.name = "3IFC",
                                      .intervals = 3,
                                      .chance = 1.0 / 3,
                                      .choices = kChoices,
                                      .answer_is = "the number of an interval",
                                      .hint = "Press 1, 2 or 3, or click.",
                                      .spoken_hint = "Press 1, 2 or 3.",
                                      .meaning = "three intervals, one of which holds the condition",
                                      .keys = kKeys,
                                      .order_keys = kOrderKeys,
                                      .read = read,
                                      .read_order = read_order,
                                      .check_primary = check_primary,
                                      .draw = draw,
                                      .redraw = redraw,
                                      .correct_answer = correct_answer,
                                      .decide = decide,
                                      .d_prime = d_prime,
                                      .question_in_words = question_in_words,
                                      .order_in_words = order_in_words,
                                      .course_in_words = course_in_words,
                                      .task_means = task_means,
                                      .correct_answer_means = correct_answer_means,
                                      .response_means = "Number of the interval that was chosen"};

}  // namespace palpate::tasks
