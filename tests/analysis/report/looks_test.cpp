// What a report may say before the planned sample is complete, and what looks cost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/report.hpp"
#include "analysis/report/tables.hpp"
#include "tests/analysis/report/fixture.hpp"

namespace palpate::analysis {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Everybody is right under kuroda and wrong under sibille: every test would reject.
StudyTable clear_cut(std::size_t examinees, bool looks) {
  StudyTable table = test::study_table(std::vector<std::vector<int>>(examinees, {4, 0}));
  if (looks) table.design.looks = {5, 10, 15}, table.design.spending = "obrien-fleming";
  return table;
}

const char* const kNone = "no claim before the planned sample";

}  // namespace

TEST(Looks, ClaimNothingBesideThePrimaryTestBeforeTheEnd) {
  const StudyReport look = analyse(clear_cut(10, true));
  EXPECT_THAT(look.summary[1], HasSubstr("Guessing is rejected"));  // what alpha is spent on
  for (const std::size_t paragraph : {1u, 3u}) {
    EXPECT_THAT(look.summary[paragraph], AllOf(HasSubstr("p = 0.00"), HasSubstr(kNone)));
    EXPECT_THAT(look.summary[paragraph], Not(HasSubstr("people like these")));
    EXPECT_THAT(look.summary[paragraph], Not(HasSubstr("larger than chance")));
  }
  EXPECT_THAT(look.summary[2], Not(HasSubstr("hardly guesses")));  // the other side, at the full alpha
  EXPECT_THAT(look.people_claim, HasSubstr(kNone));
  const StudyReport end = analyse(clear_cut(15, true));
  EXPECT_THAT(end.summary[1], HasSubstr("people like these answer better than by chance"));
  EXPECT_THAT(end.summary[3], HasSubstr("larger than chance explains"));
  for (const std::string& paragraph : end.summary) EXPECT_THAT(paragraph, Not(HasSubstr(kNone)));
}

TEST(Looks, ThatNobodyPlannedClaimNothingAtAll) {
  const StudyReport look = analyse(clear_cut(12, false), {.interim = true});
  EXPECT_THAT(look.summary[1],
              HasSubstr("Exact binomial test: p < 0.0001 (one-sided: greater), 95 % interval"));
  for (std::size_t i = 1; i < look.summary.size(); ++i) {
    EXPECT_THAT(look.summary[i], HasSubstr(kNone));
    EXPECT_THAT(look.summary[i], Not(HasSubstr("Guessing is")));
  }
}

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

// What simulated observers answer says nothing of the study.
TEST(Looks, AreHeldAgainstTheRunModeThatWasLookedAt) {
  StudyTable table = clear_cut(15, false);
  table.looks = {
      {.run_mode = "simulated", .utc = "2003-12-01T08:00:00Z", .text = "run mode simulated, 7 of 15"}};
  EXPECT_TRUE(analyse(table).deviations.empty());
  EXPECT_THAT(analyse(table).limits, Not(Contains(HasSubstr("looked at"))));
  table.looks.push_back(
      {.run_mode = "study", .utc = "2003-12-02T08:00:00Z", .text = "run mode study, 9 of 15"});
  EXPECT_THAT(analyse(table).deviations, Contains(HasSubstr("looked at once before")));
  EXPECT_THAT(analyse(table).limits,
              Contains("The results were looked at before the planned sample was "
                       "complete, on 2003-12-02 08:00:00 UTC: run mode study, 9 of 15."));
}

TEST(Looks, ThatWerePlannedSayWhenTheyWereFirstTaken) {
  StudyTable table = clear_cut(10, true);
  table.looks = {
      {.run_mode = "study", .planned = 1, .utc = "2003-12-04T08:00:00Z"},
      {.run_mode = "study", .planned = 2, .utc = "2003-12-08T08:00:00Z"},
      {.run_mode = "study", .planned = 2, .utc = "2003-12-07T08:00:00Z"},  // of another site's file
      {.run_mode = "pilot", .planned = 2, .utc = "2003-12-01T08:00:00Z"}};
  const StudyReport again = analyse(table, {.written_utc = "2003-12-09T08:00:00Z"});
  EXPECT_TRUE(again.deviations.empty());
  EXPECT_THAT(again.banners, Contains(HasSubstr("It was first taken on 2003-12-07 08:00:00 UTC.")));
  EXPECT_THAT(again.plan, Contains("Planned look 1 of 3 was first taken on 2003-12-04 08:00:00 UTC."));
  EXPECT_THAT(again.plan, Contains("Planned look 2 of 3 was first taken on 2003-12-07 08:00:00 UTC."));
  table.looks.clear();
  const StudyReport now = analyse(table, {.written_utc = "2003-12-09T08:00:00Z"});
  EXPECT_THAT(now.banners, Contains(HasSubstr("It was first taken on 2003-12-09 08:00:00 UTC.")));
}

TEST(Looks, OneSidedPSaysSo) {
  StudyTable table = test::study_table(test::like_the_paper());
  EXPECT_THAT(analyse(table).summary[1], HasSubstr("; one-sided p"));
  EXPECT_EQ(people_table(analyse(table)).header[4], "one-sided p");
  table.design.side = "two-sided";
  EXPECT_THAT(analyse(table).summary[1], HasSubstr("; two-sided p"));
  EXPECT_EQ(people_table(analyse(table)).header[4], "two-sided p");
}

}  // namespace palpate::analysis
