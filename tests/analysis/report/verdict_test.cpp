#include "analysis/report/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/primary_power.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/report/tables.hpp"
#include "analysis/report/write_report.hpp"
#include "tests/analysis/report/fixture.hpp"

using namespace palpate::analysis;
using testing::HasSubstr;

namespace {

/// So many of 60 correct under either cell, of 15 examinees with four trials each.
StudyTable with_correct(int kuroda, int sibille) {
  std::vector<std::vector<int>> correct(15, {0, 0});
  for (std::vector<int>& row : correct) {
    row = {std::min(4, kuroda), std::min(4, sibille)};
    kuroda -= row[0], sibille -= row[1];
  }
  return test::study_table(correct);
}

StudyReport adjusted_by(const std::string& method) {
  StudyTable table = with_correct(37, 38);
  table.design.adjust = method;
  return analyse(table);
}

}  // namespace

// R 4.2: p <- 1 - pbinom(c(36, 37), 60, 0.5); p.adjust(p, "holm"), "hochberg", "BH"
TEST(Verdict, CountsThePThatThePlanAdjusts) {
  const StudyReport none = adjusted_by("none");
  EXPECT_FALSE(none.cells[0].p_adjusted);
  EXPECT_EQ(verdict(none, none.cells[0]), Verdict::ToldApart);
  EXPECT_EQ(verdict(none, none.cells[1]), Verdict::ToldApart);
  const StudyReport holm = adjusted_by("holm");
  EXPECT_NEAR(*holm.cells[0].p_adjusted, 0.0518938959289215, 1e-12);
  EXPECT_NEAR(*holm.cells[1].p_adjusted, 0.0518938959289215, 1e-12);
  EXPECT_EQ(verdict(holm, holm.cells[0]), Verdict::NotShown);
  EXPECT_EQ(verdict(holm, holm.cells[1]), Verdict::NotShown);
  for (const char* method : {"hochberg", "benjamini-hochberg"}) {
    const StudyReport report = adjusted_by(method);
    EXPECT_NEAR(*report.cells[1].p_adjusted, 0.0462304905364621, 1e-12) << method;
    EXPECT_EQ(verdict(report, report.cells[1]), Verdict::ToldApart) << method;
  }
  EXPECT_THROW(adjusted_by("tukey"), std::invalid_argument);
}

TEST(Verdict, IsALineForEachCellAndTellsOfTheAdjustmentBesideIt) {
  const StudyReport holm = adjusted_by("holm");
  const TextTable table = verdict_table(holm);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"sibille", "not shown", "38 of 60", "63.3 %",
                                                     "49.9 % to 75.4 %", "0.026", "0.052"}));
  EXPECT_EQ(table.header.back(), "p, Holm");
  EXPECT_THAT(cell_summary(holm, holm.cells[1]), HasSubstr("p = 0.026, after Holm over 2 cells p = 0.052"));
  EXPECT_THAT(verdict_table(adjusted_by("none")).note, HasSubstr("nothing is adjusted"));
}

TEST(Verdict, SaysWhenTheAnswersAreTheWrongWayRoundOrTooFew) {
  StudyTable table = with_correct(10, 60);
  table.design.side = "two-sided";
  const StudyReport report = analyse(table);
  EXPECT_EQ(verdict(report, report.cells[0]), Verdict::WrongWayRound);
  table.design.planned_examinees = 20;
  const StudyReport interim = analyse(table, {.interim = true});
  EXPECT_EQ(verdict(interim, interim.cells[1]), Verdict::NoClaim);
}

// A one-sided test finds nothing in answers that are all wrong; that is no evidence for guessing, and even a
// screenful must tell it.
TEST(Verdict, TellsOfAnswersWhereTheTestDoesNotLook) {
  const StudyReport report = analyse(with_correct(2, 60));
  EXPECT_EQ(verdict(report, report.cells[0]), Verdict::OtherWay);
  EXPECT_FALSE(report.cells[0].evidence);
  EXPECT_EQ(verdict_table(report).rows[0][1], "not shown, but off chance the other way");
  EXPECT_THAT(brief_report(report), HasSubstr("off chance the other way"));
  EXPECT_THAT(cell_summary(report, report.cells[0]), HasSubstr("the wrong way round"));
  EXPECT_TRUE(evidence_table(report).rows.empty());
}

// R 4.2: pbinom(31, 60, 0.65); 2 * qbeta(0.95, 32, 29) - 1
//   dbinom(31, 60, 0.5) / integrate(function(t) 2 * dbinom(31, 60, t), 0.5, 1, rel.tol = 1e-12)$value
TEST(Verdict, StandsBesideWhatSpeaksForChance) {
  const StudyReport report = analyse(test::study_table(test::like_the_paper()));
  EXPECT_FALSE(report.cells[0].evidence);
  ASSERT_TRUE(report.cells[1].evidence);
  const EvidenceForChance& evidence = *report.cells[1].evidence;
  EXPECT_NEAR(evidence.similarity->p, 0.0228342782590414, 1e-12);
  EXPECT_NEAR(evidence.similarity->discriminators_up_to, 0.257120039231054, 1e-12);
  EXPECT_NEAR(std::exp(-evidence.bayes.log_bayes_factor), 5.038427772449602, 1e-10);
  EXPECT_THAT(
      cell_summary(report, report.cells[1]),
      HasSubstr("so the conditions count as similar where 30 % may be (p = 0.023). The Bayes factor for "
                "chance is 5: positive evidence for chance."));
}

TEST(Verdict, LeavesThePowerOfACellThatIsAlone) {
  StudyDesign design = test::study_table({}).design;
  const double alone = primary_power(design, 0.7).power;
  design.adjust = "holm";
  EXPECT_EQ(strictest_alpha(design), 0.025);
  const double adjusted = primary_power(design, 0.7).power;
  EXPECT_LT(adjusted, alone);
  design.adjust = "none";
  design.alpha = 0.025;
  EXPECT_EQ(primary_power(design, 0.7).power, adjusted);
}
