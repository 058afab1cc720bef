// Which answers the tests count: never more than were planned, and the same ones whoever comes after.
#include "analysis/report/sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/report/tables.hpp"
#include "analysis/report/write_report.hpp"
#include "tests/analysis/report/fixture.hpp"

namespace palpate::analysis {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The paper's 15 examinees, and `more` who answer everything right under kuroda and nothing under sibille.
StudyTable with_more(std::size_t more) {
  auto correct = test::like_the_paper();
  correct.resize(15 + more, {4, 0});
  return test::study_table(correct);
}

/// Takes an examinee's last answers away.
void cut_short(StudyTable& table, std::size_t session, int answered) {
  std::erase_if(table.trials,
                [&](const TrialRow& trial) { return trial.session == session && trial.trial > answered; });
  table.sessions[session].finished = false;
}

StudyTable sequential(std::size_t examinees) {
  auto correct = test::like_the_paper();
  correct.resize(examinees);
  StudyTable table = test::study_table(correct);
  table.design.looks = {5, 10, 15};
  table.design.spending = "obrien-fleming";
  return table;
}

}  // namespace

TEST(Sample, TestsCountThePlannedExamineesHoweverManyCome) {
  const StudyReport planned = analyse(with_more(0)), more = analyse(with_more(2));
  ASSERT_EQ(more.cells.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(more.cells[c].correct, planned.cells[c].correct);
    EXPECT_EQ(more.cells[c].trials, 60);
    EXPECT_EQ(more.cells[c].primary->p.greater, planned.cells[c].primary->p.greater);
    EXPECT_EQ(more.cells[c].primary->critical.at_least, 37);
    EXPECT_EQ(more.cells[c].by_people->examinees, 15u);
    EXPECT_FALSE(planned.cells[c].all);
  }
  EXPECT_EQ(more.comparisons[0].examinees, 15u);
  EXPECT_EQ(more.comparisons[0].sign_flip->p.two_sided, planned.comparisons[0].sign_flip->p.two_sided);
  ASSERT_TRUE(more.cells[0].all);
  EXPECT_EQ(more.cells[0].all->correct, 52 + 8);
  EXPECT_EQ(more.cells[0].all->trials, 68);
  EXPECT_EQ(more.complete_examinees, 17);
  EXPECT_EQ(more.sample, 15);
}

TEST(Sample, SaysThatMoreSatAndWhatAllOfThemGive) {
  const StudyReport report = analyse(with_more(2));
  EXPECT_EQ(
      report.summary[0].substr(0, report.summary[0].find(" The question")),
      "17 of 15 planned examinees completed the study; 120 answers are counted, those of the first 15 to "
      "complete it; 16 other answers are not.");
  EXPECT_THAT(report.summary[1],
              HasSubstr("With everybody's answers, which is not planned, 60 of 68 are correct (88.2 %)."));
  EXPECT_THAT(report.deviations, Contains("17 examinees are complete, 15 were planned; the tests count those "
                                          "who completed first."));
  EXPECT_THAT(report.limits, Contains(HasSubstr("The tests count the first 15 to complete.")));
  EXPECT_EQ(examinee_table(report).rows[16][1], "4 of 4, not counted");
  const nlohmann::ordered_json json = json_report(report);
  EXPECT_EQ(json["counted_examinees"], 15);
  EXPECT_EQ(json["cells"][0]["all_answers"]["correct"], 60);
  EXPECT_EQ(json["cells"][0]["by_examinee"][14]["counted"], true);
  EXPECT_EQ(json["cells"][0]["by_examinee"][16]["counted"], false);
  EXPECT_EQ(json["cells"][0]["by_examinee"][16]["trials"], 4);
}

// Who began first is not who completed first.
TEST(Sample, GoesByTheTimeOfCompletion) {
  StudyTable table = with_more(1);
  for (TrialRow& trial : table.trials)
    trial.answered_utc = trial.session == 7 ? "2003-12-09T00:00:00.000Z" : "2003-12-03T00:00:00.000Z";
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].by_examinee[7].trials, 0);   // 2 of 4 under kuroda
  EXPECT_EQ(report.cells[0].by_examinee[15].trials, 4);  // 4 of 4
  EXPECT_EQ(report.cells[0].correct, 52 - 2 + 4);
}

// Inside a file the chain tells the order: session 15 sits last, with the clock set back by a day.
TEST(Sample, GoesByTheChainWhateverTheClockSays) {
  StudyTable table = with_more(1);
  std::int64_t entry = 0;
  for (TrialRow& trial : table.trials) {
    trial.written.entry = ++entry;
    trial.answered_utc = trial.session == 15 ? "2003-12-02T00:00:00.000Z" : "2003-12-03T00:00:00.000Z";
  }
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].by_examinee[15].trials, 0);
  EXPECT_EQ(report.cells[0].correct, 52);
}

// Two files joined, the second with the clock set back in the middle: its answers keep their order among each
// other, and stand between those of the first by the latest time that their own clock had shown.
TEST(Sample, JoinsChainsByTheClockWithoutBreakingTheirOrder) {
  StudyTable table = with_more(1);
  std::int64_t entry = 0;
  for (TrialRow& trial : table.trials) {
    trial.written = {.chain = trial.session < 8 ? std::size_t{0} : std::size_t{1}, .entry = ++entry};
    trial.answered_utc = trial.session < 8     ? "2003-12-05T00:00:00.000Z"
                         : trial.session == 8  ? "2003-12-04T00:00:00.000Z"
                         : trial.session == 15 ? "2003-12-06T00:00:00.000Z"
                                               : "2003-12-03T00:00:00.000Z";
  }
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].by_examinee[15].trials, 0);
  EXPECT_EQ(report.cells[0].correct, 52);
  table.design.planned_examinees = 1;
  EXPECT_EQ(analyse(table).cells[0].by_examinee[8].trials, 4);  // the first of the second file
}

TEST(Sample, LeavesOutTheUnfinishedAndWhatCameAfterCompletion) {
  StudyTable table = with_more(1);
  cut_short(table, 3, 2);  // so the 16th is the 15th to complete
  table.sessions.push_back(table.sessions[0]);
  table.trials.push_back(table.trials[0]);  // the first examinee sits again
  table.trials.back().session = table.sessions.size() - 1;
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.complete_examinees, 15);
  EXPECT_EQ(report.cells[0].trials, 60);
  EXPECT_EQ(report.cells[0].by_examinee[0].trials, 4);
  EXPECT_EQ(report.cells[0].by_examinee[3].trials, 0);
  EXPECT_EQ(report.cells[0].all->trials, 63);
  EXPECT_EQ(report.comparisons[0].examinees, 15u);
  EXPECT_THAT(report.limits, Contains(HasSubstr("no answer is counted of an examinee who is not complete")));
}

// The look that is taken again while others sit is the same look.
TEST(Sample, APlannedLookIsOneLook) {
  const StudyReport before = analyse(sequential(10));
  StudyTable later = sequential(12);
  cut_short(later, 10, 1);
  cut_short(later, 11, 6);
  const StudyReport after = analyse(later);
  ASSERT_TRUE(before.look && after.look);
  EXPECT_EQ(after.look->number, 2);
  EXPECT_EQ(after.cells[0].trials, 40);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(after.cells[c].correct, before.cells[c].correct);
    EXPECT_EQ(after.cells[c].primary->critical.at_least, before.cells[c].primary->critical.at_least);
    EXPECT_EQ(after.cells[c].by_people->p.greater, before.cells[c].by_people->p.greater);
  }
  EXPECT_EQ(after.comparisons[0].examinees, 10u);
}

// An examinee who answered one question would weigh as much as one who answered all.
TEST(Sample, AtAnInterimLookOnlyCompleteExamineesAreTakenOneByOne) {
  StudyTable table = sequential(7);
  cut_short(table, 6, 5);
  const StudyReport report = analyse(table, {.interim = true});
  EXPECT_EQ(report.cells[0].trials, 28);  // all that is there
  EXPECT_EQ(report.cells[0].by_people->examinees, 6u);
  EXPECT_EQ(report.comparisons[0].examinees, 6u);
  StudyTable none = sequential(1);
  cut_short(none, 0, 5);
  const StudyReport nobody = analyse(none, {.interim = true});
  EXPECT_FALSE(nobody.cells[0].by_people);
  EXPECT_THAT(nobody.summary[3], HasSubstr("no complete examinee has answers counted under both"));
}

}  // namespace palpate::analysis
