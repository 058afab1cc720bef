#include "analysis/psychometric/bootstrap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/analysis/psychometric/support.hpp"

using namespace palpate::analysis;

namespace {

struct Prepared {
  Fitter fitter{make_design(psignifit_blocks(), {})};
  std::vector<double> psi =
      fitted_psi(fitter.design(), fitter.fit(correct_in(fitter.design(), psignifit_blocks())));
};

bool same_bits(const Replicate& a, const Replicate& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return same(a.alpha, b.alpha) && same(a.beta, b.beta) && same(a.lapse, b.lapse) && a.deviance == b.deviance;
}

}  // namespace

TEST(Bootstrap, SharesAreTheWhole) {
  EXPECT_TRUE(rc::check([] {
    const long replicates = *rc::gen::inRange(1L, 100'000L), n = *rc::gen::inRange(1L, 40L);
    long next = 0;
    for (long k = 1; k <= n; ++k) {
      const Share share = share_of(replicates, k, n);
      RC_ASSERT(share.first == next);
      RC_ASSERT(std::abs(share.end - share.first - replicates / n) <= 1);
      next = share.end;
    }
    RC_ASSERT(next == replicates);
  }));
}

TEST(Bootstrap, AShareHasTheBitsOfTheWhole) {
  const Prepared one;
  const auto whole = bootstrap_replicates(one.fitter, one.psi, 7, {0, 200});
  const auto part = bootstrap_replicates(one.fitter, one.psi, 7, {120, 200});
  for (std::size_t i = 0; i < part.size(); ++i) EXPECT_TRUE(same_bits(part[i], whole[120 + i])) << i;
  const auto other = bootstrap_replicates(one.fitter, one.psi, 8, {0, 200});
  int equal = 0;
  for (std::size_t i = 0; i < other.size(); ++i) equal += same_bits(other[i], whole[i]);
  EXPECT_LT(equal, 20);  // another seed, other answers
}

TEST(Bootstrap, DrawsBinomialNumbers) {
  // One level's answers seen through two levels and a fixed lapse rate: the fit is then saturated, and psi at
  // a level is its proportion. Mean and variance of 4000 of them; five standard errors.
  const auto blocks = blocks_from({0, 1}, {12, 28}, 40);
  const Fitter fitter(make_design(blocks, {.guess = 0, .lapse_upper = 0}));
  double sum = 0, squares = 0;
  constexpr int kDraws = 4000;
  for (const Replicate& one : bootstrap_replicates(fitter, std::vector{0.3, 0.7}, 1, {0, kDraws})) {
    const double p = shape_at(Shape::Logistic, one.beta * (1 - one.alpha)).below;
    sum += p;
    squares += (p - 0.7) * (p - 0.7);
  }
  const double variance = 0.21 / 40;
  EXPECT_NEAR(sum / kDraws, 0.7, 5 * std::sqrt(variance / kDraws));
  EXPECT_NEAR(squares / kDraws / variance, 1, 5 * std::sqrt(2.0 / kDraws));
}

TEST(Bootstrap, IntervalIsNearTheProfileInterval) {
  // psignifit 3's documentation prints 2.79484448 to 4.73796576 for its own bootstrap (bias-corrected, 2000
  // replicates) of this threshold; its lapse rate may reach 0.1. A tenth is allowed for the difference.
  const Prepared one;
  const auto replicates = bootstrap_replicates(one.fitter, one.psi, 1, {0, 4000});
  const Interval interval = percentile_interval(
      replicates, [](const Replicate& replicate) { return replicate.alpha; }, 0.95);
  EXPECT_NEAR(interval.lower, 2.79484448, 0.1);
  EXPECT_NEAR(interval.upper, 4.73796576, 0.1);
}

TEST(Bootstrap, PercentilesAreR_quantileOfType6) {
  // R 4.2: quantile(c(3, 1, 4, 1.5, 9, 2.6, 5.3, 5.8, 9.7), c(.1, .9), type = 6): 1.0, 9.7
  std::vector<Replicate> replicates;
  for (const double value : {3.0, 1.0, 4.0, 1.5, 9.0, 2.6, 5.3, 5.8, 9.7})
    replicates.push_back({.alpha = value});
  const auto alpha = [](const Replicate& one) { return one.alpha; };
  const Interval wide = percentile_interval(replicates, alpha, 0.8);
  EXPECT_NEAR(wide.lower, 1.0, 1e-12);
  EXPECT_NEAR(wide.upper, 9.7, 1e-12);
  const Interval half =
      percentile_interval(replicates, alpha, 0.5);  // places 2.5 and 7.5 of the sorted values
  EXPECT_NEAR(half.lower, 0.5 * (1.5 + 2.6), 1e-12);
  EXPECT_NEAR(half.upper, 0.5 * (5.8 + 9.0), 1e-12);
  EXPECT_TRUE(std::isinf(percentile_interval(replicates, alpha, 0.95).upper));  // nine cannot tell
}

TEST(Bootstrap, CountsAReplicateWithoutThresholdAgainstBothEnds) {
  std::vector<Replicate> replicates(39, {.alpha = 2});
  replicates[5].alpha = NAN;
  const auto alpha = [](const Replicate& one) { return one.alpha; };
  EXPECT_TRUE(std::isinf(percentile_interval(replicates, alpha, 0.95).lower));
  EXPECT_TRUE(std::isinf(percentile_interval(replicates, alpha, 0.95).upper));
  EXPECT_EQ(percentile_interval(replicates, alpha, 0.8).lower, 2);
}

TEST(Bootstrap, DeviancePIsNeverZero) {
  std::vector<Replicate> replicates{{.deviance = 1}, {.deviance = 2}, {.deviance = 3}, {.deviance = 4}};
  EXPECT_EQ(deviance_p(replicates, 100), 0.2);
  EXPECT_EQ(deviance_p(replicates, 3), 0.6);
  EXPECT_EQ(deviance_p(replicates, 0), 1);
}
