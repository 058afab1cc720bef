#include "analysis/report/learning.hpp"

#include <gtest/gtest.h>

#include "analysis/report/report.hpp"
#include "tests/analysis/report/fixture.hpp"

using namespace palpate::analysis;

// The fixture's first answers are the right ones: of 1, 2 and 3 of 4 right the first half has 1, 2 and 2, the
// last 0, 0 and 1; all differences are negative, which three signs do with probability 1/4, two-sided.
TEST(Learning, ComparesEachExamineesFirstHalfWithTheLast) {
  StudyTable table = test::study_table({{1, 4}, {2, 4}, {3, 4}});
  table.design.planned_examinees = 3;
  const StudyReport report = analyse(table);
  const Learning& learning = *report.cells[0].learning;
  EXPECT_EQ(learning.correct_first, 5);
  EXPECT_EQ(learning.trials_first, 6);
  EXPECT_EQ(learning.correct_last, 1);
  EXPECT_EQ(learning.trials_last, 6);
  EXPECT_NEAR(learning.mean_difference, -2.0 / 3, 1e-15);
  EXPECT_EQ(learning.sign_flip.p.two_sided, 0.25);
  EXPECT_EQ(report.cells[1].learning->mean_difference, 0.0);
}

TEST(Learning, LeavesTheMiddleAnswerOut) {
  StudyTable table = test::study_table({{3, 5}, {3, 5}}, 5);
  table.design.planned_examinees = 2;
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].learning->trials_first, 4);  // right, right | right | wrong, wrong
  EXPECT_EQ(report.cells[0].learning->correct_first, 4);
  EXPECT_EQ(report.cells[0].learning->correct_last, 0);
}

TEST(Learning, NeedsTwoAnswers) {
  StudyTable table = test::study_table({{1, 0}, {1, 1}}, 1);
  table.design.planned_examinees = 2;
  EXPECT_FALSE(analyse(table).cells[0].learning);
}
