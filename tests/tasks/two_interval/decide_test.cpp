#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tasks/two_interval/two_interval.hpp"
#include "tests/trials/support/observers.hpp"

namespace palpate::tasks {
namespace {

using trials::draw_observer;
using trials::Generator;
using trials::make_generator;
using trials::Observer;
using trials::ObserverParameters;
using trials::perceive;
using trials::Trace;
using trials::test::plain_observer;

constexpr int kTrials = 4000;

double five_deviations(double share) {
  return 5 * std::sqrt(share * (1 - share) / kTrials);
}

/// A press to 4 mm on a spring of this stiffness [N/m].
Trace spring(double stiffness) {
  Trace trace;
  for (int i = 0; i <= 200; ++i) {
    const double depth = 4e-3 * i / 200;
    trace.push_back({.time = static_cast<float>(i * 1e-3),
                     .proposed_depth = static_cast<float>(depth),
                     .depth = static_cast<float>(depth),
                     .displacement = {0, 0, static_cast<float>(depth)},
                     .force = {0, 0, static_cast<float>(-stiffness * depth)}});
  }
  return trace;
}

/// Share of trials in which the second of two springs is said to be what is asked for.
double share_second(const ObserverParameters& p, const Trace& first, const Trace& second,
                    trials::Answer answer = trials::Answer::Stiffest) {
  trials::Protocol protocol;
  protocol.answer = answer;
  Generator generator = make_generator(1, "test");
  const Observer observer = draw_observer(p, generator);
  int chosen = 0;
  for (int i = 0; i < kTrials; ++i) {
    const auto a = perceive(first, observer, generator), b = perceive(second, observer, generator);
    chosen += kTwoInterval.decide(protocol, std::array{a, b}, observer, generator) == 2 ? 1 : 0;
  }
  return static_cast<double>(chosen) / kTrials;
}

TEST(TwoIntervalDecision, AnswersWhatIsAsked) {
  ObserverParameters p = plain_observer();
  p.weber_fraction.mean = 0.01;
  EXPECT_EQ(share_second(p, spring(100.0), spring(200.0), trials::Answer::Stiffest), 1.0);
  EXPECT_EQ(share_second(p, spring(100.0), spring(200.0), trials::Answer::Softest), 0.0);
}

TEST(TwoIntervalDecision, TellsTheWeberFractionApartIn75PercentOfTheTrials) {
  for (const double w : {0.05, 0.2, 0.5}) {
    ObserverParameters p = plain_observer();
    p.weber_fraction.mean = w;
    for (const double stiffness : {50.0, 2000.0})
      EXPECT_NEAR(share_second(p, spring(stiffness), spring(stiffness * (1 + w))), 0.75,
                  five_deviations(0.75))
          << w;
  }
}

// Twice the logarithmic difference is twice the d': Phi(2 * 0.6745) = 0.9113.
TEST(TwoIntervalDecision, GetsBetterAsTheNormalDistributionSays) {
  EXPECT_NEAR(share_second(plain_observer(), spring(500), spring(500 * 1.2 * 1.2)), 0.9113,
              five_deviations(0.9113));
}

TEST(TwoIntervalDecision, GuessesWhereNothingDiffers) {
  EXPECT_NEAR(share_second(plain_observer(), spring(500), spring(500)), 0.5, five_deviations(0.5));
}

TEST(TwoIntervalDecision, GuessesWhereNothingIsFelt) {
  EXPECT_NEAR(share_second(plain_observer(), spring(0), spring(0)), 0.5, five_deviations(0.5));
  EXPECT_NEAR(share_second(plain_observer(), {}, spring(500)), 0.5, five_deviations(0.5));
}

TEST(TwoIntervalDecision, LapsesAreCoins) {
  ObserverParameters p = plain_observer();
  p.lapse_rate = 0.2;  // of an otherwise certain answer: 1 - 0.2 / 2
  EXPECT_NEAR(share_second(p, spring(500), spring(50000)), 0.9, five_deviations(0.9));
}

TEST(TwoIntervalDecision, BiasIsInDeviationsOfTheDifference) {
  ObserverParameters p = plain_observer();
  p.interval_bias.mean = 0.5;  // Phi(0.5) = 0.6915
  EXPECT_NEAR(share_second(p, spring(500), spring(500)), 0.6915, five_deviations(0.6915));
}

TEST(TwoIntervalDecision, NoiseOfTheSensesMakesItWorse) {
  ObserverParameters p = plain_observer();
  p.force_noise = 5.0;  // of forces up to 2.4 N
  EXPECT_LT(share_second(p, spring(500), spring(600)), 0.72);
}

}  // namespace
}  // namespace palpate::tasks
