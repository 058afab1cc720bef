#include "analysis/statistics/adjust/adjust.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace palpate::analysis;

namespace {

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
}

}  // namespace

TEST(Adjust, AgreesWithR) {
  // R 4.2: p.adjust(p, "holm"), "hochberg", "BH"
  const std::vector<double> p = {.010, .002, .041, .3, .03, .03};
  expect_near(holm(p), {0.05, 0.012, 0.12, 0.3, 0.12, 0.12});
  expect_near(hochberg(p), {0.05, 0.012, 0.082, 0.3, 0.082, 0.082});
  expect_near(benjamini_hochberg(p), {0.03, 0.012, 0.0492, 0.3, 0.045, 0.045});
}

TEST(Adjust, AgreesWithBenjaminiAndHochbergsExample) {
  // Benjamini & Hochberg 1995, section 3.2: of 15 p values their procedure rejects 4 at 0.05, Bonferroni-type
  // procedures 3.
  const std::vector<double> p = {0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                 0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.000};
  const auto rejected = [](const std::vector<double>& adjusted) {
    return std::ranges::count_if(adjusted, [](double value) { return value <= 0.05; });
  };
  EXPECT_EQ(rejected(benjamini_hochberg(p)), 4);
  EXPECT_EQ(rejected(hochberg(p)), 3);
  EXPECT_EQ(rejected(holm(p)), 3);
}

RC_GTEST_PROP(Adjust, OrdersTheThreeByTheirStrength, ()) {
  const auto percents = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 101)));
  std::vector<double> p;
  for (const int percent : percents) p.push_back(percent / 100.0);
  const auto by_holm = holm(p), by_hochberg = hochberg(p), by_bh = benjamini_hochberg(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    RC_ASSERT(by_bh[i] <= by_hochberg[i] + 1e-15);
    RC_ASSERT(by_hochberg[i] <= by_holm[i] + 1e-15);
    RC_ASSERT(p[i] <= by_bh[i] + 1e-15 && by_holm[i] <= 1);
  }
}

TEST(Adjust, RefusesWhatIsNoPValue) {
  EXPECT_THROW(holm({}), std::invalid_argument);
  EXPECT_THROW(hochberg(std::vector<double>{0.5, 1.5}), std::invalid_argument);
  EXPECT_THROW(benjamini_hochberg(std::vector<double>{NAN}), std::invalid_argument);
}
