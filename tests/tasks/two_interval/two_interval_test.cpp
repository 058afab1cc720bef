#include "tasks/two_interval/two_interval.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/support/places.hpp"
#include "tests/trials/support/protocols.hpp"

namespace palpate::tasks {
namespace {

using testing::HasSubstr;
using trials::Generator;
using trials::IntervalOrder;
using trials::Protocol;
using trials::Trial;
using trials::test::with;

Protocol example() {
  return trials::load_protocol(std::filesystem::path(palpate::test::source_folder()) /
                               "tasks/two_interval/example.toml");
}

/// What the shipped protocol is refused with, `from` replaced.
std::string refusal_of(std::string_view from, std::string_view to) {
  const std::string text = with(trials::test::shipped_text(), from, to);
  return trials::test::message_of<std::invalid_argument>([&] { trials::parse_protocol(text, "p.toml"); });
}

TEST(TwoInterval, IsInTheListOfTasks) {
  const auto all = trials::tasks();
  EXPECT_NE(std::ranges::find(all, &kTwoInterval), all.end());
}

TEST(TwoInterval, ItsExampleIsAProtocol) {
  const Protocol protocol = example();
  EXPECT_EQ(protocol.task, &kTwoInterval);
  EXPECT_EQ(protocol.presented, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(protocol.correct, 1U);
}

TEST(TwoInterval, RefusesWhatIsNoPairOrNotInIt) {
  EXPECT_THAT(refusal_of("[\"soft\", \"hard\"]", "[\"soft\"]"), HasSubstr("two different conditions"));
  EXPECT_THAT(refusal_of("correct = \"hard\"", "correct = \"absent\""), HasSubstr("is not in the pair"));
}

TEST(TwoInterval, RefusesToHalveAnOddNumberOfTrials) {
  const std::string odd = with(trials::test::shipped_text(), "per_cell = 4", "per_cell = 3");
  EXPECT_THAT(trials::test::message_of<std::invalid_argument>(
                  [&] { trials::parse_protocol(with(odd, "\"coin\"", "\"balanced\""), "p.toml"); }),
              HasSubstr("order.interval: balances the two orders, and 3 trials of a cell cannot be halved"));
}

TEST(TwoInterval, RefusesAPrimaryAnalysisThatDoesNotHold) {
  EXPECT_THAT(refusal_of("\"coin\"", "\"balanced\""), HasSubstr("which holds for coin flips only"));
  EXPECT_THAT(refusal_of("\"paired-comparison\"", "\"order-randomisation\""),
              HasSubstr("which is for balanced orders"));
}

TEST(TwoInterval, HasOneChoiceAndItsOwnKeysForEachInterval) {
  ASSERT_EQ(static_cast<int>(kTwoInterval.choices.size()), kTwoInterval.intervals);
  std::set<std::string_view> keys;
  for (const trials::Choice& choice : kTwoInterval.choices)
    keys.insert(choice.keys.begin(), choice.keys.end());
  EXPECT_EQ(keys, (std::set<std::string_view>{"1", "2", "ArrowLeft", "ArrowRight"}));
  EXPECT_DOUBLE_EQ(kTwoInterval.chance, 1.0 / kTwoInterval.intervals);
}

TEST(TwoInterval, TheIntervalWithTheCorrectConditionIsTheCorrectAnswer) {
  const Protocol protocol = example();
  Generator generator = trials::make_generator(1, "test");
  std::set<int> correct;
  std::vector<Trial> drawn(32);
  kTwoInterval.draw(protocol, drawn, generator);
  for (const Trial& trial : drawn)
    for (const int answer : {1, 2}) {
      const bool held = trial.interval_condition[answer - 1] == protocol.correct;
      EXPECT_EQ(kTwoInterval.correct_answer(protocol, trial) == answer, held);
      EXPECT_EQ(trial.correct_answer == answer, held);
      if (held) correct.insert(answer);
    }
  EXPECT_EQ(correct.size(), 2U);
}

TEST(TwoInterval, BalancesWithinEachCellOfWhatIsDrawnTogether) {
  Protocol protocol = example();
  protocol.interval_order = IntervalOrder::Balanced;
  Generator generator = trials::make_generator(1, "test");
  std::vector<Trial> drawn(10);
  kTwoInterval.draw(protocol, drawn, generator);
  EXPECT_EQ(std::ranges::count(drawn, 1, &Trial::correct_answer), 5);
  const Trial before = drawn[3];
  kTwoInterval.redraw(protocol, drawn[3], generator);
  EXPECT_EQ(drawn[3], before);
}

// d' = sqrt(2) z(p) in 2IFC: 1.414214 * 0.674490 for 75 %.
TEST(TwoInterval, KnowsItsSensitivity) {
  EXPECT_NEAR(kTwoInterval.d_prime(75, 100), 0.953873, 1e-6);
}

TEST(TwoInterval, SaysWhatIsAsked) {
  const Protocol protocol = example();
  EXPECT_EQ(kTwoInterval.question_in_words(protocol), "soft against hard; \"hard\" is correct");
  EXPECT_EQ(kTwoInterval.task_means(protocol), "2 intervals, then: In which interval did it feel harder?");
  EXPECT_EQ(kTwoInterval.correct_answer_means(protocol),
            "Number of the interval that held the condition hard");
}

}  // namespace
}  // namespace palpate::tasks
