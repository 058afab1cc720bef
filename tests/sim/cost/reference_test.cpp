#include "sim/cost/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace palpate::sim {
namespace {

constexpr double kSizes[] = {8e-3, 5e-3, 3.5e-3, 2e-3};

/// Curves whose error is amount h^p of a limit that is known.
std::vector<std::vector<double>> curves(double order, double amount) {
  std::vector<std::vector<double>> all;
  for (const double h : kSizes) {
    std::vector<double>& curve = all.emplace_back();
    for (int i = 1; i <= 20; ++i)
      curve.push_back(0.4 * i * i * (1 + amount * std::pow(h / kSizes[0], order)));
  }
  return all;
}

TEST(Extrapolate, FindsTheLimitOfAKnownOrder) {
  for (const double order : {0.6, 1.0, 1.5, 2.0}) {
    const ExtrapolatedCurve found = extrapolate(curves(order, 0.3), kSizes);
    ASSERT_TRUE(found.converges);
    EXPECT_NEAR(found.order, order, 1e-6);
    for (int i = 1; i <= 20; ++i)
      EXPECT_NEAR(found.forces[static_cast<std::size_t>(i) - 1], 0.4 * i * i, 1e-6 * 0.4 * i * i);
  }
}

// 1.25 times what was added to the finest curve: here its error, 0.3 (1/4)^p.
TEST(Extrapolate, TellsItsUncertainty) {
  EXPECT_NEAR(extrapolate(curves(1.0, 0.3), kSizes).uncertainty, 1.25 * 0.3 / 4, 1e-6);
  // An order that linear elements cannot have is not believed: 2 is taken, and three times what is added.
  const ExtrapolatedCurve fast = extrapolate(curves(4.0, 0.3), kSizes);
  EXPECT_EQ(fast.order, 2.0);
  const double last = 0.3 * (std::pow(3.5 / 8, 4) - std::pow(2.0 / 8, 4));
  const double beyond = 4.0 / (3.5 * 3.5 - 4.0);
  EXPECT_NEAR(fast.uncertainty, 3 * beyond * last, 0.05 * fast.uncertainty);
}

TEST(Extrapolate, SaysWhereNothingConverges) {
  std::vector<std::vector<double>> all = curves(1.0, 0.3);
  all.back() = all[1];  // back to where it was
  for (double& force : all.back()) force *= 1.2;
  const ExtrapolatedCurve found = extrapolate(all, kSizes);
  EXPECT_FALSE(found.converges);
  EXPECT_EQ(found.forces, all.back());
  EXPECT_NE(found.how.find("do not converge"), std::string::npos);
  EXPECT_THROW(extrapolate(std::vector(all.begin(), all.begin() + 2), std::vector(kSizes, kSizes + 2)),
               std::invalid_argument);
}

}  // namespace
}  // namespace palpate::sim
