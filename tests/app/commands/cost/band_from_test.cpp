#include "app/commands/cost/band_from.hpp"

#include <gtest/gtest.h>

namespace palpate::app {
namespace {

// One cell: the interval of the difference is that of the share correct, turned over. The 95 % likelihood-ratio interval
// of 30 of 40 is 0.60297 to 0.86597 (R 4.2: uniroot over dbinom, half of qchisq(0.95, 1) below the maximum).
TEST(BandOf, IsTheIntervalOfTheShareTurnedOver) {
  const double z = 0.6744897501960817;                     // qnorm(0.75)
  const double z_low = 0.261035206, z_high = 1.107549163;  // qnorm of the ends
  const sim::Band band = band_of({0.2}, {30}, {40});
  EXPECT_NEAR(band.lower, 0.2 * z / z_high, 2e-4);
  EXPECT_NEAR(band.upper, 0.2 * z / z_low, 2e-3);
}

TEST(BandOf, TakesAllCellsTogether) {
  const sim::Band one = band_of({0.2}, {30}, {40}), two = band_of({0.2, 0.2}, {15, 15}, {20, 20});
  EXPECT_NEAR(one.lower, two.lower, 1e-6);
  EXPECT_NEAR(one.upper, two.upper, 1e-6);
  const sim::Band more = band_of({0.2, 0.4}, {30, 37}, {40, 40});
  EXPECT_GT(more.lower, one.lower - 0.05);
  EXPECT_LT(more.upper - more.lower, one.upper - one.lower);
}

TEST(BandOf, HasNoUpperEndWhereNothingWasToldApart) {
  const sim::Band band = band_of({0.1}, {20}, {40});
  EXPECT_EQ(band.upper, 1.0);
  EXPECT_GT(band.lower, 0.1);  // a difference that is told apart is larger than this one
}

TEST(BandOf, HasALowerEndWhereAllWasToldApart) {
  const sim::Band band = band_of({0.3}, {40}, {40});
  EXPECT_GT(band.lower, 0.0);
  EXPECT_LT(band.lower, 0.01);
  EXPECT_LT(band.upper, 0.3);
}

}  // namespace
}  // namespace palpate::app
