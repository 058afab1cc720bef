#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "analysis/report/report.hpp"
#include "tests/analysis/report/fixture.hpp"

using namespace palpate::analysis;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string message(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

StudyTable mixed_modes() {
  StudyTable table = test::study_table(test::like_the_paper());
  table.sessions.back().run_mode = "pilot";
  table.sessions.front().run_mode = "practice";
  return table;
}

}  // namespace

TEST(Analyse, CountsWhatThePaperCounts) {
  const StudyReport report = analyse(test::study_table(test::like_the_paper()));
  ASSERT_EQ(report.cells.size(), 2u);
  EXPECT_EQ(report.cells[0].correct, 52);
  EXPECT_EQ(report.cells[1].correct, 31);
  EXPECT_EQ(report.cells[0].trials, 60);
  EXPECT_EQ(report.cells[0].primary->critical.at_least, 37);  // Kuroda et al. 2003, section 5.2
  EXPECT_TRUE(rejects(report.cells[0].primary->critical, 52));
  EXPECT_FALSE(rejects(report.cells[1].primary->critical, 31));
  // R 4.2: binom.test(52, 60, alternative = "greater")$p.value, (31, 60)
  EXPECT_NEAR(report.cells[0].primary->p.greater / 2.60284573668641e-09, 1, 1e-10);
  EXPECT_NEAR(report.cells[1].primary->p.greater, 0.448710913495715, 1e-12);
  EXPECT_TRUE(report.complete);
  EXPECT_TRUE(report.banners.empty());
}

TEST(Analyse, ComparesModelsWithinExaminees) {
  const StudyReport report = analyse(test::study_table(test::like_the_paper()));
  ASSERT_EQ(report.comparisons.size(), 1u);
  const CellComparison& comparison = report.comparisons[0];
  EXPECT_EQ(comparison.planned, "sign-flip");
  EXPECT_NEAR(comparison.mean_difference, 21.0 / 60, 1e-12);
  // R 4.2: d <- c(2,1,1,3,2,0,2,1,2,1,1,2,-1,3,1)
  //   S <- as.matrix(expand.grid(rep(list(c(-1, 1)), 15))) %*% d; mean(abs(S) >= sum(d))
  EXPECT_NEAR(comparison.sign_flip->p.two_sided, 0.0009765625, 1e-12);
  // the same with r <- rank(abs(d))[d != 0] * sign(d[d != 0])
  EXPECT_NEAR(comparison.signed_rank->p.two_sided, 0.0009765625, 1e-12);
}

TEST(Analyse, GivesResultsByIntervalOrder) {
  const StudyReport report = analyse(test::study_table(test::like_the_paper()));
  // An examinee with k of 4 is right in the first k trials; the harder interval comes first in trials 1
  // and 3.
  const OrderCounts& kuroda = report.cells[0].bias->counts;
  EXPECT_EQ(kuroda.trials_first, 30);
  EXPECT_EQ(kuroda.correct_first, 28);   // 2 each, but 1 for the two examinees with 2
  EXPECT_EQ(kuroda.correct_second, 24);  // 9 x 2 + 6 x 1
  EXPECT_EQ(report.cells[0].bias->answers_first, 34);
}

TEST(Analyse, WithholdsTestsUntilThePlannedSampleIsComplete) {
  auto correct = test::like_the_paper();
  correct.resize(14);
  const StudyReport report = analyse(test::study_table(correct));
  EXPECT_TRUE(report.withheld);
  EXPECT_FALSE(report.cells[0].primary || report.cells[0].by_people || report.cells[0].d_prime ||
               report.cells[0].bias);
  EXPECT_TRUE(report.comparisons.empty() && report.stimuli.empty() && report.curves.empty());
  EXPECT_EQ(report.cells[0].trials, 56);
  for (const CellResult& cell : report.cells) {
    EXPECT_EQ(cell.correct, 0);
    for (const ExamineeCount& examinee : cell.by_examinee) EXPECT_EQ(examinee.correct, 0);
  }
  for (const std::string& sentence : report.summary) EXPECT_THAT(sentence, Not(HasSubstr("p =")));
  EXPECT_THAT(report.banners, Contains(HasSubstr("14 of 15 planned examinees")));
  const StudyReport look = analyse(test::study_table(correct), {.interim = true});
  EXPECT_FALSE(look.withheld);
  EXPECT_TRUE(look.cells[0].primary.has_value());
  EXPECT_THAT(look.banners, Contains(HasSubstr("INTERIM LOOK")));
}

TEST(Analyse, NeverPoolsRunModes) {
  EXPECT_EQ(message([] { analyse(mixed_modes()); }),
            "the study holds sessions of several run modes, which are never pooled: pilot, practice and "
            "study; name one with --run-mode");
  const StudyReport report = analyse(mixed_modes(), {.run_mode = "study"});
  EXPECT_EQ(report.cells[0].trials, 52);
  EXPECT_EQ(report.examinees.size(), 13u);
  EXPECT_EQ(message([] { analyse(mixed_modes(), {.run_mode = "simulated"}); }),
            "the study holds no session of run mode 'simulated'; found: pilot, practice and study");
  EXPECT_THAT(message([] { analyse(mixed_modes(), {.run_mode = "practice"}); }), HasSubstr("never reported"));
}

TEST(Analyse, LeavesPracticeAsideWhereOnlyOneOtherModeIs) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.sessions.front().run_mode = "practice";
  EXPECT_EQ(analyse(table).cells[0].trials, 56);
}

TEST(Analyse, NeverPoolsWhatWasPresentedDifferently) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.sessions[3].pseudo_haptic = true;
  EXPECT_THAT(message([&] { analyse(table); }), HasSubstr("never pooled"));
  table = test::study_table(test::like_the_paper());
  table.sessions[3].protocol_sha256 = "b";
  EXPECT_THAT(message([&] { analyse(table); }), HasSubstr("different protocols are not pooled"));
}

TEST(Analyse, RefusesDesignsThatTheBinomialDoesNotHoldFor) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.design.interval_order = "balanced";
  EXPECT_THAT(message([&] { analyse(table); }), HasSubstr("neither test holds for the other order"));
  table = test::study_table(test::like_the_paper());
  table.design.primary = "glmm";
  EXPECT_THAT(message([&] { analyse(table); }), HasSubstr("this version knows paired-comparison"));
  table = test::study_table(test::like_the_paper());
  table.trials[0].correct = !*table.trials[0].correct;
  EXPECT_THAT(message([&] { analyse(table); }), HasSubstr("session 1, trial 1"));
  EXPECT_THAT(message([] {
                analyse(StudyTable{.design = test::study_table({{1, 1}}).design});
              }),
              HasSubstr("no session yet"));
}

TEST(Analyse, ListsVoidedTrialsAndDoesNotCountThem) {
  StudyTable table = test::study_table(test::like_the_paper());
  table.trials[0].voided = true;
  table.trials[0].void_reason = "the phone rang";
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].trials, 59);
  EXPECT_EQ(report.cells[0].correct, 51);
  EXPECT_TRUE(report.complete);  // it was asked
  ASSERT_EQ(report.voided.size(), 1u);
  EXPECT_EQ(report.voided[0].reason, "the phone rang");
}

// The sentences of a result must stay true wherever it falls.

TEST(Sentences, NeverSayThatSomethingCannotBeFelt) {
  const StudyReport report = analyse(test::study_table(test::like_the_paper()));
  EXPECT_THAT(report.summary[2], HasSubstr("Guessing is not rejected (p = 0.449)"));
  EXPECT_THAT(report.summary[2],
              HasSubstr("does not show that the difference cannot be felt: 38.4 % to 64.8 %"));
}

TEST(Sentences, SayWhenAnswersFallOnTheOtherSideOfChance) {
  const StudyReport report = analyse(test::study_table(std::vector<std::vector<int>>(15, {0, 1})));
  EXPECT_THAT(report.summary[1],
              HasSubstr("0 of 60 answers were correct (0.0 %). Guessing is not rejected (p = 1)"));
  EXPECT_THAT(report.summary[1], HasSubstr("on the other side of chance"));
  EXPECT_THAT(report.summary[1], Not(HasSubstr("told soft and hard apart")));
  EXPECT_THAT(report.summary[1],
              HasSubstr("it is not shown that people like these answer better than by chance"));
  StudyTable table = test::study_table(std::vector<std::vector<int>>(15, {0, 1}));
  table.design.side = "two-sided";
  EXPECT_THAT(analyse(table).summary[1], HasSubstr("named them the wrong way round"));
}

TEST(Sentences, HoldAtAHundredPercent) {
  const StudyReport report = analyse(test::study_table(std::vector<std::vector<int>>(15, {4, 0})));
  EXPECT_THAT(report.summary[1], HasSubstr("60 of 60 answers were correct (100.0 %)"));
  EXPECT_THAT(report.summary[1], HasSubstr("all alike, so that no interval can be given"));
  EXPECT_TRUE(report.cells[0].d_prime->corrected);
}

TEST(Sentences, HoldForOneExamineeAndForNoAnswers) {
  StudyTable one = test::study_table({{4, 2}});
  one.design.planned_examinees = 1;
  const StudyReport report = analyse(one);
  EXPECT_THAT(report.summary[1], HasSubstr("With 4 answers no number of correct ones can reject guessing"));
  EXPECT_THAT(report.summary[1], HasSubstr("With one examinee nothing can be said about people in general"));
  StudyTable none = test::study_table({{4, 2}});
  none.trials.clear();
  const StudyReport empty = analyse(none, {.interim = true});
  EXPECT_EQ(empty.summary[1], "kuroda: no answers were counted.");
  EXPECT_EQ(empty.summary[3], "kuroda against sibille: no complete examinee has answers counted under both.");
}

TEST(Sentences, CallSimulatedAndPseudoHapticByTheirNames) {
  const StudyReport simulated = analyse(test::study_table(test::like_the_paper(), 4, "simulated"));
  EXPECT_THAT(simulated.banners, Contains(HasSubstr("SIMULATED: no person took part")));
  for (const std::string& sentence : simulated.summary) {
    EXPECT_THAT(sentence, Not(HasSubstr("somebody")));
    EXPECT_THAT(sentence, Not(HasSubstr("people like")));
  }
  StudyTable table = test::study_table(test::like_the_paper());
  for (ReportedSession& session : table.sessions) {
    session.pseudo_haptic = true;
    session.channel = "the pointer's lag";
  }
  const StudyReport pseudo = analyse(table);
  EXPECT_THAT(
      pseudo.banners,
      Contains(HasSubstr("no force reached the hand. The stimulus was carried by the pointer's lag")));
  for (const std::string& sentence : pseudo.summary) EXPECT_THAT(sentence, Not(HasSubstr("be felt")));
}

// Where the orders are balanced, whoever always answers "1" is right in half of the trials, whatever is felt;
// and the p value is that of the randomisation test, not of the binomial.
TEST(Analyse, TestsBalancedOrdersByRandomisation) {
  StudyTable table = test::study_table(test::like_the_paper());  // two of four trials with the hard one first
  table.design.interval_order = "balanced";
  table.design.primary = "order-randomisation";
  const StudyReport report = analyse(table);
  EXPECT_EQ(report.cells[0].primary->name, "order-randomisation");
  EXPECT_THAT(report.cells[0].primary->method.name,
              HasSubstr("randomisation test over the admissible orders"));
  EXPECT_LT(report.cells[0].primary->p.greater, 1e-6);
  for (TrialRow& trial : table.trials) {
    trial.response = "1";
    trial.correct = trial.correct_answer == "1";
  }
  const StudyReport always_first = analyse(table);
  EXPECT_EQ(always_first.cells[0].correct, 30);
  EXPECT_EQ(always_first.cells[0].primary->p.greater, 1.0);
  EXPECT_EQ(always_first.cells[0].primary->p.two_sided, 1.0);
}

static StudyTable with_looks(std::size_t examinees) {
  auto correct = test::like_the_paper();
  correct.resize(examinees);
  StudyTable table = test::study_table(correct);
  table.design.looks = {5, 10, 15};
  table.design.spending = "obrien-fleming";
  return table;
}

// At a planned look the tests are shown without --interim, with the number that the alpha spent so far
// allows.
TEST(Analyse, OpensAtAPlannedLookAndOnlyThen) {
  const StudyReport first = analyse(with_looks(5));
  EXPECT_FALSE(first.withheld);
  ASSERT_TRUE(first.look);
  EXPECT_EQ(first.look->number, 1);
  // P(X >= 18 of 20) = 0.000201, P(X >= 17) = 0.00129; 2 - 2 Phi(z(0.975)/sqrt(1/3)) = 0.000687 may be spent.
  EXPECT_EQ(first.cells[0].primary->critical.at_least, 18);
  EXPECT_THAT(first.banners, testing::Contains(HasSubstr("PLANNED LOOK 1 of 3: 5 of 15")));
  EXPECT_TRUE(first.deviations.empty());  // to look was planned
  const StudyReport between = analyse(with_looks(7));
  EXPECT_TRUE(between.withheld);
  EXPECT_FALSE(between.look);
  EXPECT_THAT(between.summary, testing::Contains(HasSubstr("looks when exactly 5, 10 and 15 examinees")));
  const StudyReport last = analyse(with_looks(15));
  EXPECT_EQ(last.look->number, 3);
  EXPECT_GE(last.cells[0].primary->critical.at_least, 37);  // no less than without looks
}

// The report says what was fixed beforehand, and where the study departed from it.
TEST(Analyse, TellsThePlanAndWhatDeviatesFromIt) {
  StudyTable table = test::study_table(test::like_the_paper());
  const StudyReport without = analyse(table);
  EXPECT_THAT(without.plan, Contains(HasSubstr("No analysis plan was frozen")));
  EXPECT_TRUE(without.deviations.empty());
  table.frozen_plans = {{.sha256 = "abc", .frozen_utc = "2003-12-01T08:00:00Z", .software_version = "0.1.0"}};
  EXPECT_THAT(analyse(table).plan,
              Contains(HasSubstr("frozen in the study file on 2003-12-01 08:00:00 UTC (SHA-256 abc).")));
  table.frozen_plans[0].frozen_utc = "2003-12-04T08:00:00Z";
  EXPECT_THAT(analyse(table).plan, Contains(HasSubstr("after the first of these sessions had begun")));

  table.looks.resize(2);
  table.design.planned_examinees = 12;
  table.sessions[3].finished = false;
  table.sessions[4].software_version = "0.2.0";
  table.trials[5].voided = true;
  const std::vector<std::string> found = analyse(table).deviations;
  EXPECT_THAT(found, Contains(HasSubstr("15 examinees are complete, 12 were planned")));
  EXPECT_THAT(found, Contains(HasSubstr("looked at 2 times before")));
  EXPECT_THAT(found, Contains(HasSubstr("1 session was not finished")));
  EXPECT_THAT(found, Contains(HasSubstr("version changed on the way: 0.1.0 and 0.2.0")));
  EXPECT_THAT(found, Contains(HasSubstr("1 trial was voided")));
}

// R: quantile(c(1, 2, 3, 4, 10)), with each time recorded 12 times
TEST(Analyse, SummarisesResponseTimes) {
  StudyTable table = test::study_table(test::like_the_paper());
  for (std::size_t i = 0; i < table.trials.size(); ++i)
    table.trials[i].response_time_s = std::vector{1.0, 2.0, 3.0, 4.0, 10.0}[i % 5];
  const ResponseTimes times = *analyse(table).cells[0].response_times;
  EXPECT_EQ(times.n, 60U);
  EXPECT_EQ(times.least, 1.0);
  EXPECT_EQ(times.lower_quartile, 2.0);
  EXPECT_EQ(times.median, 3.0);
  EXPECT_EQ(times.upper_quartile, 4.0);
  EXPECT_EQ(times.most, 10.0);
}
