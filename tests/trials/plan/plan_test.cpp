#include "trials/plan/plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>

#include "tests/trials/support/protocols.hpp"

namespace palpate::trials {
namespace {

std::vector<Trial> plan_for(const Protocol& protocol, std::uint64_t seed) {
  Generator generator = make_generator(seed, "order of P01, sitting 1");
  return draw_plan(protocol, generator);
}

RC_GTEST_PROP(Plan, HoldsEveryCellAsOftenAsAskedFor, (std::uint64_t seed)) {
  const Protocol protocol = test::small_protocol(*rc::gen::inRange(1, 30));
  std::map<std::size_t, int> count;
  for (const Trial& trial : plan_for(protocol, seed)) ++count[trial.cell];
  RC_ASSERT(count.size() == protocol.cells.size());
  for (const auto& [cell, times] : count) RC_ASSERT(times == protocol.trials_per_examinee_per_cell);
}

RC_GTEST_PROP(Plan, NumbersTrialsAndKnowsTheCorrectInterval, (std::uint64_t seed)) {
  const Protocol protocol = test::small_protocol(*rc::gen::inRange(1, 30));
  const std::vector<Trial> plan = plan_for(protocol, seed);
  std::map<int, int> length;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    RC_ASSERT(plan[i].number == static_cast<int>(i) + 1);
    const int before = i == 0 ? 1 : plan[i - 1].block;
    RC_ASSERT(plan[i].block >= before);
    RC_ASSERT(plan[i].block <= before + 1);
    const auto& order = plan[i].interval_condition;
    RC_ASSERT(order.size() == 2U);
    RC_ASSERT(order[0] != order[1]);
    RC_ASSERT(order[plan[i].correct_answer - 1] == protocol.correct);
    ++length[plan[i].block];
  }
  RC_ASSERT(static_cast<int>(length.size()) == block_count(static_cast<int>(plan.size())));
  for (const auto& [block, trials] : length) RC_ASSERT(std::abs(trials - length.begin()->second) <= 1);
}

RC_GTEST_PROP(Plan, IsTheSameForTheSameSeed, (std::uint64_t seed)) {
  const Protocol protocol = test::small_protocol(4);
  RC_ASSERT(plan_for(protocol, seed) == plan_for(protocol, seed));
}

// Drawn by a program of its own (Python: hashlib for the state, xoshiro256** and Fisher-Yates after their
// descriptions) for seed 2003 and the purpose "order of P01, sitting 1".
TEST(Plan, IsTheOneThatSeed2003Draws) {
  const std::vector<std::pair<std::size_t, int>> expected{{1, 1}, {1, 2}, {0, 1}, {0, 2},
                                                          {0, 1}, {0, 2}, {1, 1}, {1, 2}};
  std::vector<std::pair<std::size_t, int>> drawn;
  for (const Trial& trial : plan_for(test::small_protocol(4), 2003))
    drawn.emplace_back(trial.cell, trial.correct_answer);
  EXPECT_EQ(drawn, expected);
}

constexpr int kSeeds = 3000;

TEST(Plan, FlipsFairAndIndependentCoins) {
  const Protocol protocol = test::small_protocol(2);
  int first = 0, same_as_before = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto plan = plan_for(protocol, static_cast<std::uint64_t>(seed));
    first += plan[0].correct_answer == 1 ? 1 : 0;
    same_as_before += plan[1].correct_answer == plan[0].correct_answer ? 1 : 0;
  }
  const double bound = 5 * std::sqrt(kSeeds * 0.25);  // five standard deviations of a fair coin's count
  EXPECT_NEAR(first, kSeeds / 2, bound);
  EXPECT_NEAR(same_as_before, kSeeds / 2, bound);
}

TEST(Plan, DrawsEveryOrderOfCellsEquallyOften) {
  const Protocol protocol = test::small_protocol(2);  // two cells twice: 6 orders
  std::map<std::vector<std::size_t>, int> count;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::vector<std::size_t> cells;
    for (const Trial& trial : plan_for(protocol, static_cast<std::uint64_t>(seed)))
      cells.push_back(trial.cell);
    ++count[cells];
  }
  ASSERT_EQ(count.size(), 6U);
  for (const auto& [order, times] : count) EXPECT_NEAR(times, kSeeds / 6, 5 * std::sqrt(kSeeds * 5.0 / 36));
}

TEST(Plan, RedrawsTheIntervalsAndKeepsTheRest) {
  const Protocol protocol = test::small_protocol(4);
  const Trial before = plan_for(protocol, 1)[3];
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Generator generator = make_generator(seed, "again");
    Trial after = before;
    protocol.task->redraw(protocol, after, generator);
    EXPECT_EQ(after.cell, before.cell);
    EXPECT_EQ(after.number, before.number);
    changed += after.correct_answer != before.correct_answer ? 1 : 0;
  }
  EXPECT_NEAR(changed, 100, 5 * std::sqrt(50.0));
}

Protocol balanced_protocol(int trials) {
  Protocol protocol = test::small_protocol(trials);
  protocol.interval_order = IntervalOrder::Balanced;
  return protocol;
}

RC_GTEST_PROP(Plan, BalancesTheOrdersWithinEachCell, (std::uint64_t seed)) {
  const Protocol protocol = balanced_protocol(2 * *rc::gen::inRange(1, 15));
  std::map<std::size_t, int> first;
  for (const Trial& trial : plan_for(protocol, seed)) first[trial.cell] += trial.correct_answer == 1 ? 1 : 0;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell)
    RC_ASSERT(2 * first[cell] == protocol.trials_per_examinee_per_cell);
}

TEST(Plan, DrawsEveryBalancedOrderEquallyOften) {
  const Protocol protocol = balanced_protocol(4);
  std::map<std::vector<int>, int> count;  // of the first cell: 6 orders
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::vector<int> order;
    for (const Trial& trial : plan_for(protocol, static_cast<std::uint64_t>(seed)))
      if (trial.cell == 0) order.push_back(trial.correct_answer);
    ++count[order];
  }
  ASSERT_EQ(count.size(), 6U);
  for (const auto& [order, times] : count) EXPECT_NEAR(times, kSeeds / 6, 5 * std::sqrt(kSeeds * 5.0 / 36));
}

TEST(Plan, KeepsABalancedOrderWhenATrialIsInterrupted) {
  const Protocol protocol = balanced_protocol(4);
  const Trial before = plan_for(protocol, 1)[3];
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Generator generator = make_generator(seed, "again");
    Trial after = before;
    protocol.task->redraw(protocol, after, generator);
    EXPECT_EQ(after, before);
  }
}

}  // namespace
}  // namespace palpate::trials
