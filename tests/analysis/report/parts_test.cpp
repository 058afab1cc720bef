#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/report.hpp"
#include "analysis/report/write_report.hpp"
#include "tests/analysis/report/fixture.hpp"

namespace palpate::analysis {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Each part of a joined file has its own plan and sessions: what one froze late says nothing about another.
TEST(Analyse, TellsThePlanOfEveryPart) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.parts = {"the study file a.db", "the study file b.db", "the study file c.db"};
  for (ReportedSession& session : table.sessions) session.part = 1;
  table.sessions[0].part = 0;
  table.frozen_plans = {{.part = 0, .sha256 = "abc", .frozen_utc = "2003-12-01T08:00:00Z"},
                        {.part = 1, .sha256 = "def", .frozen_utc = "2003-12-04T08:00:00Z"}};
  const StudyReport report = analyse(table);
  EXPECT_THAT(report.plan, Contains("The analysis plan was frozen in the study file a.db on "
                                    "2003-12-01 08:00:00 UTC (SHA-256 abc)."));
  EXPECT_THAT(
      report.plan,
      Contains("The analysis plan was frozen in the study file b.db on 2003-12-04 08:00:00 UTC (SHA-256 "
               "def), after the first of these sessions had begun."));
  EXPECT_THAT(report.plan, Contains("No analysis plan was frozen in the study file c.db."));
  EXPECT_THAT(report.deviations, Contains("The parts froze analysis plans that are not the same."));
}

TEST(Analyse, NamesEveryVersionOfASessionThatWasTakenUpAgain) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.sessions[2].later_versions = {"0.3.0"};
  const StudyReport report = analyse(table);
  EXPECT_THAT(report.deviations, Contains(HasSubstr("version changed on the way: 0.1.0 and 0.3.0")));
  EXPECT_THAT(text_report(report), HasSubstr("0.1.0, then 0.3.0"));
}

}  // namespace
}  // namespace palpate::analysis
