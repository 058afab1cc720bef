#include "analysis/statistics/randomisation/order_randomisation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "analysis/binomial/binomial_test.hpp"

namespace palpate::analysis {
namespace {

/// Every admissible order of a few trials, counted by hand: the independent way.
std::vector<double> counted_by_hand(const std::vector<int>& answers, int correct_first) {
  std::vector<int> order(answers.size(), 2);
  std::fill_n(order.begin(), correct_first, 1);
  std::ranges::sort(order);
  std::vector<double> count(answers.size() + 1, 0.0);
  double all = 0.0;
  do {
    std::size_t correct = 0;
    for (std::size_t i = 0; i < order.size(); ++i) correct += order[i] == answers[i] ? 1U : 0U;
    count[correct] += 1.0;
    all += 1.0;
  } while (std::next_permutation(order.begin(), order.end()));
  for (double& share : count) share /= all;
  return count;
}

}  // namespace

// Four trials, two of each order, answered 1, 1, 2, 2: of the 6 orders one fits everywhere, four half, one
// nowhere.
TEST(OrderRandomisation, CountsTheSixOrdersOfFourTrials) {
  const std::vector<OrderStratum> one{{.trials = 4, .correct_first = 2, .answers_first = 2, .correct = 4}};
  const OrderRandomisationTest test = order_randomisation_test(one, 0.05, Side::Greater);
  EXPECT_NEAR(test.p.greater, 1.0 / 6, 1e-15);
  EXPECT_NEAR(test.p.two_sided, 2.0 / 6, 1e-15);
  EXPECT_NEAR(test.expected, 2.0, 1e-15);
  EXPECT_FALSE(test.critical.at_least);  // not even all correct is rare enough
}

// Whoever always answers "1" is right in exactly half of a balanced stratum, in whatever order.
TEST(OrderRandomisation, SaysNothingOfWhoAlwaysAnswersTheSame) {
  const std::vector<OrderStratum> strata(15,
                                         {.trials = 4, .correct_first = 2, .answers_first = 4, .correct = 2});
  const OrderRandomisationTest test = order_randomisation_test(strata, 0.05, Side::Greater);
  EXPECT_EQ(test.p.greater, 1.0);
  EXPECT_EQ(test.standard_deviation, 0.0);
  EXPECT_FALSE(test.critical.at_least);
}

// The sum of 15 such strata by convolving (1/6, 0, 4/6, 0, 1/6) fifteen times. Python:
//   import numpy as np; d = np.array([1.0])
//   for _ in range(15): d = np.convolve(d, [1/6, 0, 4/6, 0, 1/6])
//   print(d[40:].sum(), d[38:].sum())
TEST(OrderRandomisation, ConvolvesExaminees) {
  std::vector<OrderStratum> strata(15, {.trials = 4, .correct_first = 2, .answers_first = 2, .correct = 2});
  for (int i = 0; i < 5; ++i) strata[i].correct = 4;
  const OrderRandomisationTest test = order_randomisation_test(strata, 0.05, Side::Greater);
  EXPECT_EQ(test.correct, 40);
  EXPECT_NEAR(test.p.greater, 0.021248040519646034, 1e-12);
  EXPECT_EQ(test.critical.at_least, 40);  // 39 cannot be, and P(X >= 38) is 0.0573
  EXPECT_NEAR(test.critical.size, 0.021248040519646034, 1e-12);
}

RC_GTEST_PROP(OrderRandomisation, AgreesWithEveryOrderCounted, ()) {
  const auto answers =
      *rc::gen::container<std::vector<int>>(*rc::gen::inRange<std::size_t>(1, 9), rc::gen::element(1, 2));
  const auto n = static_cast<int>(answers.size());
  const int correct_first = *rc::gen::inRange(0, n + 1);
  const auto expected = counted_by_hand(answers, correct_first);
  const auto seen =
      static_cast<long>(std::ranges::find_if(expected, [](double p) { return p > 0; }) - expected.begin());
  const std::vector<OrderStratum> one{{.trials = n,
                                       .correct_first = correct_first,
                                       .answers_first = std::ranges::count(answers, 1),
                                       .correct = seen}};
  const OrderRandomisationTest test = order_randomisation_test(one, 0.05, Side::TwoSided);
  for (std::size_t k = 0; k < expected.size(); ++k)
    RC_ASSERT(std::abs(test.under_guessing[k] - expected[k]) < 1e-12);
}

// p of each number by itself, as the test defines it; the program takes each sum once.
TEST(OrderRandomisation, RejectsTheNumbersWhosePIsAtMostAlpha) {
  std::vector<OrderStratum> strata(12, {.trials = 6, .correct_first = 3, .answers_first = 2, .correct = 3});
  strata.push_back({.trials = 5, .correct_first = 1, .answers_first = 4, .correct = 2});
  for (const Side side : {Side::Greater, Side::Less, Side::TwoSided}) {
    const OrderRandomisationTest test = order_randomisation_test(strata, 0.05, side);
    const std::vector<double>& chance = test.under_guessing;
    for (std::size_t seen = 0; seen < chance.size(); ++seen) {
      if (chance[seen] == 0) continue;
      double p = 0.0;
      for (std::size_t k = 0; k < chance.size(); ++k) {
        if (side == Side::Greater ? k >= seen
            : side == Side::Less  ? k <= seen
                                  : chance[k] <= chance[seen] * (1 + 1e-7))
          p += chance[k];
      }
      EXPECT_EQ(rejects(test.critical, static_cast<long>(seen)), p <= 0.05) << seen;
    }
  }
}

TEST(OrderRandomisation, RefusesCountsThatContradictThemselves) {
  const auto refuses = [](const OrderStratum& stratum) {
    EXPECT_THROW(order_randomisation_test(std::vector{stratum}, 0.05, Side::Greater), std::invalid_argument);
  };
  refuses({.trials = 0});
  refuses({.trials = 4, .correct_first = 5, .answers_first = 2, .correct = 2});
  refuses({.trials = 4, .correct_first = 2, .answers_first = 2, .correct = 3});  // parity
  refuses({.trials = 4, .correct_first = 2, .answers_first = 4, .correct = 4});  // always "1" is right twice
  EXPECT_THROW(order_randomisation_test({}, 0.05, Side::Greater), std::invalid_argument);
}

}  // namespace palpate::analysis
