#include "tests/message_times/leak.hpp"

#include <gtest/gtest.h>

#include <random>

namespace palpate::app::message_times {
namespace {

std::vector<double> noisy(std::mt19937& random, double middle, double spread) {
  std::normal_distribution<double> normal(middle, spread);
  std::vector<double> sample(50);
  for (double& value : sample) value = normal(random);
  return sample;
}

TEST(Leak, IsWhatARankTestAndABrowsersClockBothSee) {
  std::mt19937 random(1);
  int false_alarms = 0;
  for (int run = 0; run < 1000; ++run)
    false_alarms += leaks(difference(noisy(random, 16, 2), noisy(random, 16, 2)));
  EXPECT_EQ(false_alarms, 0);
  EXPECT_TRUE(leaks(difference(noisy(random, 16, 2), noisy(random, 20, 2))));
  EXPECT_TRUE(leaks(difference(noisy(random, 20, 2), noisy(random, 16, 2))));
  EXPECT_FALSE(leaks(difference(noisy(random, 16, 0.01), noisy(random, 16.1, 0.01))));  // no clock tells it
}

TEST(Leak, OneMachineHiccupIsNone) {
  std::vector<double> calm(50, 16.0), hiccup = calm;
  hiccup[7] = 900.0;
  EXPECT_FALSE(leaks(difference(calm, hiccup)));
}

// 1 is longer than 0 and 1 than 1 by half: (1 + 0.5 + 1 + 0.5) / 4.
TEST(Leak, SharesAreOfAllPairs) {
  EXPECT_DOUBLE_EQ(difference({0, 1}, {1, 1}).share_longer, 0.75);
  EXPECT_NEAR(difference({0, 1}, {1, 1}).chance, std::sqrt(5.0 / 48.0), 1e-12);
}

}  // namespace
}  // namespace palpate::app::message_times
