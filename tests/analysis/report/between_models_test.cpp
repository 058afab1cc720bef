#include <gtest/gtest.h>

#include "analysis/report/report.hpp"
#include "tests/analysis/report/fixture.hpp"

using namespace palpate::analysis;

// Differences of counts of ten, of which 0.3 - 0.2 and 0.9 - 0.8 are one as fractions and two as doubles.
TEST(Analyse, LosesNoTieBetweenModels) {
  const std::vector<std::vector<int>> correct{{3, 2}, {9, 8}, {1, 2}, {7, 4}, {6, 3}, {2, 5},
                                              {4, 4}, {8, 6}, {3, 1}, {1, 6}, {9, 4}, {7, 7}};
  StudyTable table = test::study_table(correct, 10);
  table.design.planned_examinees = 12;
  table.design.between_models = "wilcoxon";
  const StudyReport report = analyse(table);
  // R 4.2: d <- c(1,1,-1,3,3,-3,0,2,2,-5,5,0); r <- rank(abs(d)); V <- sum(r[d > 0])
  //   S <- as.matrix(expand.grid(rep(list(0:1), 10))) %*% r[d != 0]; 2 * mean(S >= V)
  EXPECT_EQ(report.comparisons[0].signed_rank->v, 50.5);
  EXPECT_NEAR(report.comparisons[0].signed_rank->p.two_sided, 0.345703125, 1e-12);
}
