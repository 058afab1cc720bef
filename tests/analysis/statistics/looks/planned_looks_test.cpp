#include "analysis/statistics/looks/planned_looks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace palpate::analysis {
namespace {

/// Share of guessers who are rejected at some look.
double simulated_size(const std::vector<PlannedLook>& looks, double chance, int studies) {
  std::mt19937_64 random(5);
  std::bernoulli_distribution guess(chance);
  int rejected = 0;
  for (int study = 0; study < studies; ++study) {
    long correct = 0, trials = 0;
    for (const PlannedLook& look : looks) {
      for (; trials < look.critical.trials; ++trials) correct += guess(random) ? 1 : 0;
      if (!rejects(look.critical, correct)) continue;
      ++rejected;
      break;
    }
  }
  return static_cast<double>(rejected) / studies;
}

}  // namespace

// One look is the plain exact test.
TEST(PlannedLooks, OneLookIsTheCriticalNumber) {
  for (const Side side : {Side::Greater, Side::Less}) {
    const auto looks = planned_looks(std::vector{60L}, 0.5, 0.05, side, Spending::OBrienFleming);
    const CriticalNumber plain = critical_number(60, 0.5, 0.05, side);
    EXPECT_EQ(looks[0].critical.at_least, plain.at_least);
    EXPECT_EQ(looks[0].critical.at_most, plain.at_most);
    EXPECT_NEAR(looks[0].size, plain.size, 1e-14);
  }
}

// Five equal looks at one-sided alpha 0.025, in the limit of many answers: the boundaries of Brownian motion,
// by the recursion of Armitage, McPherson & Rowe 1969 on a grid (Python):
//   x = np.linspace(-9, 9, 18001); h = x[1] - x[0]; dens = None; used = 0
//   for k in range(1, 6):
//     step = lambda y: norm.pdf(y, 0, np.sqrt(.2))
//     f = step(x) if dens is None else np.convolve(dens, step(np.arange(-9000, 9001)*h), "same")*h
//     tail = np.cumsum(f[::-1])[::-1]*h; spent = 2 - 2*norm.cdf(norm.isf(.0125)/np.sqrt(k/5))
//     c = brentq(lambda b: np.interp(b, x, tail) - (spent - used), 0, 8.9); print(c/np.sqrt(k/5))
//     used = spent; dens = np.where(x < c, f, 0)
// prints 4.878, 3.358, 2.681, 2.290, 2.032; with .025*np.log(1 + (np.e -
// 1)*k/5) 2.439, 2.428, 2.411, 2.398, 2.387. Here one more correct answer changes z by less than 0.015, and
// the tail is granular: 0.02.
TEST(PlannedLooks, TendToTheBoundariesOfBrownianMotion) {
  const std::vector<long> trials{20000, 40000, 60000, 80000, 100000};
  const auto z = [&](Spending spending) {
    std::vector<double> boundaries;
    for (const PlannedLook& look : planned_looks(trials, 0.5, 0.025, Side::Greater, spending)) {
      const auto n = static_cast<double>(look.critical.trials);
      boundaries.push_back((static_cast<double>(*look.critical.at_least) - 0.5 - n / 2) / std::sqrt(n / 4));
    }
    return boundaries;
  };
  using testing::DoubleNear;
  EXPECT_THAT(z(Spending::OBrienFleming),
              testing::ElementsAre(DoubleNear(4.878, 0.02), DoubleNear(3.358, 0.02), DoubleNear(2.681, 0.02),
                                   DoubleNear(2.290, 0.02), DoubleNear(2.032, 0.02)));
  EXPECT_THAT(z(Spending::Pocock),
              testing::ElementsAre(DoubleNear(2.439, 0.02), DoubleNear(2.428, 0.02), DoubleNear(2.411, 0.02),
                                   DoubleNear(2.398, 0.02), DoubleNear(2.387, 0.02)));
}

// 100 000 simulated studies: the standard error of a share near 0.05 is 0.0007, and four of them are allowed.
TEST(PlannedLooks, GuessersAreRejectedAsOftenAsTheSizeSays) {
  for (const Spending spending : {Spending::OBrienFleming, Spending::Pocock}) {
    const auto looks = planned_looks(std::vector{20L, 40L, 60L}, 0.5, 0.05, Side::Greater, spending);
    EXPECT_LE(looks.back().size, 0.05);
    EXPECT_NEAR(simulated_size(looks, 0.5, 100'000), looks.back().size, 0.0028);
  }
}

RC_GTEST_PROP(PlannedLooks, NeverSpendMoreThanTheyMay, ()) {
  std::vector<long> trials;
  long n = 0;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) trials.push_back(n += *rc::gen::inRange(1, 60));
  const double alpha = *rc::gen::element(0.01, 0.05, 0.2), chance = *rc::gen::element(0.5, 1.0 / 3, 0.25);
  const auto spending = *rc::gen::element(Spending::OBrienFleming, Spending::Pocock);
  const auto looks =
      planned_looks(trials, chance, alpha, *rc::gen::element(Side::Greater, Side::Less), spending);
  for (const PlannedLook& look : looks) RC_ASSERT(look.size <= look.critical.alpha * (1 + 1e-9));
  RC_ASSERT(looks.back().size <= alpha * (1 + 1e-9));
}

TEST(PlannedLooks, RefuseWhatIsNoPlan) {
  const auto refuses = [](std::vector<long> trials, Side side) {
    EXPECT_THROW(planned_looks(trials, 0.5, 0.05, side, Spending::Pocock), std::invalid_argument);
  };
  refuses({}, Side::Greater);
  refuses({20, 20}, Side::Greater);
  refuses({20, 40}, Side::TwoSided);
  EXPECT_THROW(spending_from_name("haybittle"), std::invalid_argument);
}

}  // namespace palpate::analysis
