#include "analysis/resampling/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace palpate::analysis;

namespace {

double mean_of(std::span<const std::size_t> chosen) {
  double sum = 0.0;
  for (const std::size_t index : chosen) sum += static_cast<double>(index);
  return sum / static_cast<double>(chosen.size());
}

}  // namespace

TEST(Bootstrap, OfAMeanIsNearlyNormal) {
  // Of 0..399: standard error sqrt((400^2 - 1)/12/400) = 5.7735; the Monte Carlo error of an end is about
  // 0.15.
  const Interval interval = bootstrap_interval(400, mean_of, {.level = 0.95, .resamples = 9999, .seed = 4});
  EXPECT_NEAR(interval.lower, 199.5 - 1.95996 * 5.7735, 0.6);
  EXPECT_NEAR(interval.upper, 199.5 + 1.95996 * 5.7735, 0.6);
}

TEST(Bootstrap, DependsOnItsSeedAlone) {
  const auto lower = [](std::uint64_t seed) {
    return bootstrap_interval(50, mean_of, {.level = 0.9, .resamples = 999, .seed = seed}).lower;
  };
  EXPECT_EQ(lower(7), lower(7));
  EXPECT_NE(lower(7), lower(8));
}

TEST(Bootstrap, RefusesTooFewResamples) {
  EXPECT_THROW(bootstrap_interval(5, mean_of, {.resamples = 998}), std::invalid_argument);
  EXPECT_THROW(bootstrap_interval(5, mean_of, {.level = 1.0}), std::invalid_argument);
}
