// What a report may say before the planned sample is complete, and what looks cost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/report.hpp"
#include "tests/analysis/report/fixture.hpp"

namespace palpate::analysis {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Everybody is right under kuroda and wrong under sibille: every test would reject.
StudyTable clear_cut(std::size_t examinees, bool looks) {
  StudyTable table = test::study_table(std::vector<std::vector<int>>(examinees, {4, 0}));
  if (looks) table.design.looks = {5, 10, 15}, table.design.spending = "obrien-fleming";
  return table;
}

}  // namespace

// Python 3, for 20, 40 and 60 answers and what 2 - 2 Phi(z(0.975)/sqrt(t)) lets be spent:
//   d = [1.0]; used = 0
//   for n, k in ((20, 18), (40, 28), (60, 37)):
//     for _ in range(n - len(d) + 1): d = [(a + b) / 2 for a, b in zip(d + [0], [0] + d)]
//     used += sum(d[k:]); d[k:] = [0] * (len(d) - k)
//   print(used, 1 - (1 - used)**2)  # 0.04788314501344733 0.09347349445051589
TEST(Looks, CountTowardsTheProbabilityThatAnythingRejects) {
  const StudyReport end = analyse(clear_cut(15, true));
  const PrimaryTest& primary = *end.cells[0].primary;
  EXPECT_GT(primary.size, primary.critical.size);
  EXPECT_EQ(primary.critical.at_least, 37);
  EXPECT_NEAR(primary.size, 0.04788314501344733, 1e-12);
  EXPECT_THAT(end.limits,
              Contains(HasSubstr("at least one would reject with probability 0.09347, at this look "
                                 "or at one before.")));
  const StudyReport without = analyse(clear_cut(15, false));
  EXPECT_EQ(without.cells[0].primary->size, without.cells[0].primary->critical.size);
}

}  // namespace palpate::analysis
