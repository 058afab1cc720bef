#include "trials/plan/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace palpate::trials {
namespace {

// The vector that the Rust crate rand_xoshiro checks its Xoshiro256StarStar with (made by the authors' C
// code).
TEST(Random, GivesThePublishedNumbers) {
  Generator generator({1, 2, 3, 4});
  const std::vector<std::uint64_t> expected{11520ULL,
                                            0ULL,
                                            1509978240ULL,
                                            1215971899390074240ULL,
                                            1216172134540287360ULL,
                                            607988272756665600ULL,
                                            16172922978634559625ULL,
                                            8476171486693032832ULL,
                                            10595114339597558777ULL,
                                            2904607092377533576ULL};
  for (const std::uint64_t number : expected) EXPECT_EQ(generator.next(), number);
}

TEST(Random, SeedAndPurposeDecide) {
  const auto first = [](Seed seed, std::string_view purpose) { return make_generator(seed, purpose).next(); };
  EXPECT_EQ(first(7, "order of P01"), first(7, "order of P01"));
  EXPECT_NE(first(7, "order of P01"), first(8, "order of P01"));
  EXPECT_NE(first(7, "order of P01"), first(7, "order of P02"));
  EXPECT_NE(first({}, "order of P01"), first({}, "order of P01"));
}

RC_GTEST_PROP(Random, BelowStaysBelow, (std::uint64_t seed)) {
  const std::uint64_t bound = *rc::gen::positive<std::uint64_t>();
  Generator generator = make_generator(seed, "test");
  for (int i = 0; i < 20; ++i) RC_ASSERT(generator.below(bound) < bound);
}

// A bound just over half of 2^64: without rejection the lower half of the values would come twice as often.
TEST(Random, BelowIsUnbiased) {
  const std::uint64_t bound = 3ULL << 62;
  Generator generator = make_generator(1, "bias");
  constexpr int kDraws = 30000;
  int lowest_third = 0;
  for (int i = 0; i < kDraws; ++i) lowest_third += generator.below(bound) < bound / 3 ? 1 : 0;
  // Fair: 10 000 with standard deviation 82; biased: 15 000.
  EXPECT_NEAR(lowest_third, kDraws / 3, 5 * std::sqrt(kDraws * (1.0 / 3) * (2.0 / 3)));
}

TEST(Random, NormalHasMomentsAndTailsOfTheNormalDistribution) {
  Generator generator = make_generator(1, "normal");
  constexpr int kDraws = 100000;
  double sum = 0, squares = 0;
  int below_one = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = generator.normal();
    sum += x;
    squares += x * x;
    below_one += x < 1.0 ? 1 : 0;
  }
  // Five standard errors each: of the mean 1/sqrt(n), of the variance sqrt(2/n), of a share sqrt(p q / n).
  EXPECT_NEAR(sum / kDraws, 0.0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(below_one / static_cast<double>(kDraws), 0.841344746, 5 * std::sqrt(0.8413 * 0.1587 / kDraws));
}

}  // namespace
}  // namespace palpate::trials
