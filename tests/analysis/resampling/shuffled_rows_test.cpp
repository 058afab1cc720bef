#include "analysis/resampling/shuffled_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/binomial/binomial_test.hpp"

using namespace palpate::analysis;

namespace {

// All orders of all rows, one by one.
double by_enumeration(std::vector<std::vector<long>> rows) {
  const auto squares = [&] {
    long total = 0;
    for (std::size_t j = 0; j < rows[0].size(); ++j) {
      long sum = 0;
      for (const auto& row : rows) sum += row[j];
      total += sum * sum;
    }
    return total;
  };
  const long seen = squares();
  for (auto& row : rows) std::ranges::sort(row);
  double as_large = 0, all = 0;
  for (bool more = true; more;) {
    all += 1;
    as_large += squares() >= seen;
    more = false;
    for (auto& row : rows) {
      if ((more = std::next_permutation(row.begin(), row.end())))
        break;  // else it is back at its first order
    }
  }
  return as_large / all;
}

}  // namespace

TEST(ShuffledRows, OfFullAgreementIsOneOrderInEach) {
  // Three judges who order three things alike: 6 of the 6^3 outcomes, 1/36 = 0.028, as in the tables of
  // Friedman 1937 (chi-squared 6) and Hollander & Wolfe (A.22).
  EXPECT_NEAR(*shuffled_rows_p({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), 1.0 / 36, 1e-15);
  EXPECT_NEAR(*shuffled_rows_p({{0, 1, 5, 6}, {0, 1, 5, 6}}), 1.0 / 24, 1e-15);
}

RC_GTEST_PROP(ShuffledRows, AgreesWithGoingThroughAllOrders, ()) {
  const auto columns = *rc::gen::inRange<std::size_t>(2, 5), count = *rc::gen::inRange<std::size_t>(1, 5);
  std::vector<std::vector<long>> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back(*rc::gen::container<std::vector<long>>(columns, rc::gen::inRange(0L, 4L)));
  }
  RC_ASSERT(std::abs(*shuffled_rows_p(rows) - by_enumeration(rows)) < 1e-12);
}

RC_GTEST_PROP(ShuffledRows, OfTwoColumnsIsTheSignTest, ()) {
  const long first = *rc::gen::inRange(0L, 30L), second = *rc::gen::inRange(0L, 30L);
  RC_PRE(first + second > 0);
  std::vector<std::vector<long>> rows(first, {1, 0});
  rows.resize(first + second, {0, 1});
  RC_ASSERT(std::abs(*shuffled_rows_p(rows) - binomial_p(first, first + second, 0.5).two_sided) < 1e-12);
}

TEST(ShuffledRows, GivesUpOnWhatIsTooLarge) {
  const std::vector<std::vector<long>> long_rows(40, {0, 1, 2, 3, 4, 5, 6, 7});
  EXPECT_FALSE(shuffled_rows_p(long_rows).has_value());  // does not fit into 64 bits
  const std::vector<std::vector<long>> many(60, {0, 1, 2, 3, 4});
  EXPECT_FALSE(shuffled_rows_p(many).has_value());  // too many steps
  EXPECT_FALSE(shuffled_rows_p({{1, 2, 3}, {1, 2, 3}}, 3).has_value());
  EXPECT_EQ(shuffled_rows_p({{1, 1, 1}, {2, 2, 2}}), 1.0);
}
