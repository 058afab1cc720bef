#include "trials/study/verify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/clock/utc.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"

namespace palpate::trials {
namespace {
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A finished study whose guards somebody takes away and puts back, as who tampers with a file would.
class VerifyTest : public testing::Test {
 protected:
  VerifyTest() {
    StudyFile study = open_study(path_, protocol_, "0.1.0");
    Session session = start_session(study, protocol_, test::facts_of("P01"));
    test::answer_all(session);
    receipt_ = session.receipt();
  }

  void tamper(const std::string& change) {
    const std::string table =
        change.substr(change.find(change.rfind("UPDATE", 0) == 0 ? "UPDATE " : "FROM ") + 7);
    std::string name = table.substr(0, table.find(' '));
    if (change.rfind("DELETE", 0) == 0) name = change.substr(12, change.find(' ', 12) - 12);
    const char* action = change.rfind("DELETE", 0) == 0 ? "DELETE" : "UPDATE";
    const std::string trigger = name + "_refuses_" + action;
    const std::string guard =
        test::sql_value(path_, "SELECT sql FROM sqlite_schema WHERE name = '" + trigger + "'");
    ASSERT_EQ(test::sql(path_, "DROP TRIGGER " + trigger + ";" + change + ";" + guard), "") << change;
  }
  std::vector<std::string> problems() { return verify_study(path_).problems; }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::small_protocol(2);
  Receipt receipt_{};
};

TEST_F(VerifyTest, AWholeFileHasNoProblems) {
  const VerifyReport report = verify_study(path_, receipt_);
  EXPECT_THAT(report.problems, IsEmpty());
  EXPECT_EQ(report.sessions, 1);
  EXPECT_EQ(report.answers, 4);
  EXPECT_EQ(report.presentations, 8);
  EXPECT_EQ(report.receipt, receipt_);
}

TEST_F(VerifyTest, LooksWithoutTouching) {
  const std::string before = test::read(path_);
  verify_study(path_);
  EXPECT_EQ(test::read(path_), before);
}

TEST_F(VerifyTest, AnAlteredAnswerIsFound) {
  tamper("UPDATE answer SET response = 3 - response WHERE trial = 2");
  EXPECT_THAT(problems(), Contains(HasSubstr("whether the answer is correct does not follow")));
  EXPECT_THAT(problems(), Contains(HasSubstr("chain: entry 3 was altered")));
}

TEST_F(VerifyTest, AnAnswerAlteredWithItsCorrectnessIsFoundByTheChain) {
  tamper("UPDATE answer SET response = 3 - response, correct = 1 - correct WHERE trial = 2");
  EXPECT_THAT(problems(), testing::ElementsAre(HasSubstr("chain: entry 3 was altered")));
}

TEST_F(VerifyTest, APilotSoldAsAStudyIsFound) {
  tamper("UPDATE session SET run_mode = 'pilot'");
  EXPECT_THAT(problems(), Contains(HasSubstr("chain: entry 2 was altered")));
  EXPECT_THAT(problems(), Contains(HasSubstr("the chain says run mode=study, the file run mode=pilot")));
}

TEST_F(VerifyTest, AnOrderAlteredAfterwardsIsFound) {
  tamper("UPDATE trial SET correct_interval = 3 - correct_interval WHERE number = 1");
  EXPECT_THAT(problems(), Contains(HasSubstr("the correct answer is not the one")));
}

TEST_F(VerifyTest, AnAlteredTraceIsFound) {
  tamper("UPDATE trace SET columns = zeroblob(100) WHERE presentation = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("its trace does not have the hash")));
}

TEST_F(VerifyTest, AnAlteredMeasureIsFound) {
  tamper("UPDATE presentation_end SET peak_force_n = 9 WHERE presentation = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("are not those of its trace")));
}

TEST_F(VerifyTest, AnAlteredBoundOfTheForceIsFound) {
  StudyFile study = open_study(path_, protocol_, "0.1.0");
  Session session = start_session(study, protocol_, test::facts_of("P02"));
  session.begin_interval();
  session.end_interval(test::felt_in_a_loop());
  test::answer_all(session);
  ASSERT_THAT(problems(), IsEmpty());
  tamper("UPDATE presentation_solve SET cycles_at_cap = 0");
  EXPECT_THAT(problems(), testing::ElementsAre(testing::ContainsRegex("chain: entry .* was altered")));
  tamper("DELETE FROM presentation_solve");
  EXPECT_THAT(problems(), testing::ElementsAre(testing::ContainsRegex("chain: entry .* was altered")));
}

TEST_F(VerifyTest, ADeletedEventIsFound) {
  tamper("DELETE FROM event WHERE kind = 'session ended'");
  EXPECT_THAT(problems(), Contains(HasSubstr("has lost its answer or event")));
}

TEST_F(VerifyTest, AnotherProtocolsTextIsFound) {
  tamper("UPDATE study SET protocol_text = replace(protocol_text, '0.05', '0.10')");
  EXPECT_THAT(problems(), Contains(HasSubstr("the protocol's text does not have the hash")));
}

TEST_F(VerifyTest, AMissingGuardIsFound) {
  ASSERT_EQ(test::sql(path_, "DROP TRIGGER answer_refuses_UPDATE"), "");
  EXPECT_THAT(problems(), Contains(HasSubstr("trigger answer_refuses_UPDATE is missing")));
}

TEST_F(VerifyTest, AMissingTableIsAProblemAndNoException) {
  ASSERT_EQ(test::sql(path_, "DROP TABLE trace"), "");
  EXPECT_THAT(problems(), Contains(HasSubstr("schema: table trace is missing")));
  ASSERT_EQ(test::sql(path_, "PRAGMA foreign_keys = OFF; DROP TABLE study"), "");
  EXPECT_THAT(problems(), Contains(HasSubstr("schema: table study is missing")));
}

TEST_F(VerifyTest, AProtocolThatCannotBeReadIsAProblemAndNoException) {
  tamper("UPDATE study SET protocol_text = 'no [ TOML'");
  EXPECT_THAT(problems(), Contains(HasSubstr("the protocol's text does not have the hash")));
  EXPECT_THAT(problems(), Contains(HasSubstr("the rest was not looked at")));
}

TEST_F(VerifyTest, ASeedThatIsNoNumberIsAProblemAndNoException) {
  tamper("UPDATE session SET seed = 'x'");
  EXPECT_THAT(problems(), Contains(HasSubstr("a sitting has the seed \"x\"")));
}

TEST_F(VerifyTest, AnAnswerWithoutATrialIsAProblemAndNoException) {
  tamper("UPDATE answer SET draw = 7 WHERE trial = 2");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 2: is answered but was never drawn")));
  EXPECT_THAT(problems(), Contains(HasSubstr("chain: entry 3 has lost its answer or event")));
}

TEST_F(VerifyTest, AVerdictOrConditionThatIsNoneIsAProblemAndNoException) {
  tamper("UPDATE presentation_end SET verdict = 'x' WHERE presentation = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("a presentation's verdict: found \"x\", accepted: enough")));
  tamper("UPDATE presentation SET condition = 'x' WHERE id = 1");
  EXPECT_THAT(problems(),
              Contains(HasSubstr("a presentation names \"x\", which its protocol does not have")));
}

// The chain holds it: who makes an interval count that did not changes the text that was hashed.
TEST_F(VerifyTest, AnAlteredVerdictIsFound) {
  tamper("UPDATE presentation_end SET verdict = 'too few presses' WHERE presentation = 3");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 2: interval 1 was never shown as drawn and explored")));
  EXPECT_THAT(problems(), Contains(HasSubstr("chain: entry 3 was altered")));
}

TEST_F(VerifyTest, AnswersAreLookedAtWithoutTraces) {
  tamper("UPDATE trace SET columns = zeroblob(100) WHERE presentation = 3");
  EXPECT_THAT(verify_study(path_, {}, VerifyScope::Answers).problems, IsEmpty());
  EXPECT_NO_THROW(require_whole(path_));
}

TEST_F(VerifyTest, AFileThatIsNotWholeIsNotGoneOnWith) {
  EXPECT_NO_THROW(check_start(path_, protocol_, test::facts_of("P02"), false));
  tamper("UPDATE answer SET response = 3 - response, correct = 1 - correct WHERE trial = 2");
  const std::string said = test::message_of<std::invalid_argument>([&] { require_whole(path_); });
  EXPECT_THAT(said,
              HasSubstr(path_.string() + ": the study file is not whole (1 problem; the first: chain: "));
  EXPECT_THAT(said, HasSubstr("; `palpate verify " + path_.string() + "` lists them"));
  EXPECT_EQ(test::message_of<std::invalid_argument>(
                [&] { check_start(path_, protocol_, test::facts_of("P02"), false); }),
            said);
}

// Who cuts back the whole end of the chain, and the head beside the file, is told by the receipt alone.
TEST_F(VerifyTest, ACutBackFileIsFoundByTheReceipt) {
  tamper("DELETE FROM event WHERE kind = 'session ended'");
  tamper("DELETE FROM answer WHERE trial = 4");
  tamper("DELETE FROM ledger WHERE entry > 4");
  EXPECT_THAT(problems(), Contains(HasSubstr("6 entries of the chain were saved")));
  std::filesystem::remove(path_.string() + ".head");
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(verify_study(path_, receipt_).problems,
              Contains(HasSubstr("it was printed for 6 entries, the file holds 4")));
}

TEST_F(VerifyTest, AReceiptHoldsAfterMoreSittings) {
  StudyFile study = open_study(path_, protocol_, "0.1.0");
  Session session = start_session(study, protocol_, test::facts_of("P02"));
  test::answer_all(session);
  EXPECT_THAT(verify_study(path_, receipt_).problems, IsEmpty());
}

TEST_F(VerifyTest, AnotherStudysReceiptIsFound) {
  const std::filesystem::path other = folder_ / "other.db";
  StudyFile study = open_study(other, protocol_, "0.1.0");
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  test::answer_all(session);
  EXPECT_THAT(verify_study(path_, session.receipt()).problems,
              Contains(HasSubstr("not the one that it was printed for")));
}

// What is copied from the laboratory's book: some digits of the head, in capitals, with spaces around.
TEST_F(VerifyTest, AReceiptMayBeCutShort) {
  Receipt by_hand = receipt_;
  by_hand.head.resize(16);
  EXPECT_THAT(verify_study(path_, by_hand).problems, IsEmpty());
  by_hand.head.back() = by_hand.head.back() == '0' ? '1' : '0';
  EXPECT_THAT(verify_study(path_, by_hand).problems,
              Contains(HasSubstr("the receipt does not fit (a slip of the pen?): entry 6")));
}

TEST_F(VerifyTest, AnotherProtocolsNameIsFound) {
  tamper("UPDATE study SET protocol_name = 'another'");
  EXPECT_THAT(problems(), Contains(HasSubstr("the protocol's name is \"another\"")));
}

/// A sitting that was cut off twice: in the second trial while an interval was felt, and again once it had
/// been felt wholly. Two trials have never been asked.
class CutOffTest : public VerifyTest {
 protected:
  CutOffTest() {
    path_ = folder_ / "cut_off.db";
    StudyFile study = open_study(path_, protocol_, "0.1.0");
    Session session = start_session(study, protocol_, test::facts_of("P01"));
    test::feel_both(session);
    session.answer(1, 0.8, base::utc_now());
    session.begin_interval();
    session.interrupt(test::press_to(1e-3), "the page was closed");
    test::feel_both(session);
    session.interrupt({}, "the page was closed");
  }
};

TEST_F(CutOffTest, IsWhole) {
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(CutOffTest, AnOrderNotYetAnsweredCannotBeAltered) {
  tamper(
      "UPDATE trial SET interval_order = CASE interval_order WHEN 'hard,soft' THEN 'soft,hard' ELSE "
      "'hard,soft' END, correct_interval = 3 - correct_interval WHERE number = 4");
  EXPECT_THAT(problems(),
              testing::ElementsAre(HasSubstr("its facts or orders are not those that it was begun "
                                             "with: the chain says plan=")));
}

TEST_F(CutOffTest, AnOrderDrawnAgainCannotBeAltered) {
  tamper(
      "UPDATE trial SET interval_order = CASE interval_order WHEN 'hard,soft' THEN 'soft,hard' ELSE "
      "'hard,soft' END, correct_interval = 3 - correct_interval WHERE number = 2 AND draw = 1");
  EXPECT_THAT(problems(), testing::ElementsAre(HasSubstr("trial 2, draw 1: the order, or what was felt")));
}

TEST_F(CutOffTest, ExposureThatLedToNoAnswerCannotBeAlteredOrDeleted) {
  tamper("UPDATE presentation SET condition = 'hard' WHERE trial = 2 AND draw = 0");
  tamper("UPDATE presentation SET condition = 'soft' WHERE trial = 2 AND draw = 1");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 2, draw 2: the order, or what was felt before it")));
  tamper("DELETE FROM trace WHERE presentation = 3");
  tamper("DELETE FROM presentation_end WHERE presentation = 3");
  tamper("DELETE FROM presentation WHERE id = 3");
  EXPECT_THAT(problems(), Contains(AllOf(HasSubstr("trial 2, draw 1: the order, or what was felt before it"),
                                         HasSubstr("the file presentations before=0"))));
}

TEST_F(CutOffTest, MissingTrialsAndDrawsAreFound) {
  tamper("DELETE FROM trial WHERE number = 4");
  tamper("DELETE FROM trial WHERE number = 2 AND draw = 2");
  EXPECT_THAT(problems(), Contains(HasSubstr("trial 4: is missing")));
  EXPECT_THAT(problems(), Contains(HasSubstr("1 trial of cell")));
  EXPECT_THAT(problems(), Contains(HasSubstr("the chain tells of orders drawn again that are missing")));
}

TEST_F(CutOffTest, ASittingWithoutItsBeginningIsFound) {
  tamper("DELETE FROM event WHERE kind = 'session begun'");
  EXPECT_THAT(problems(), Contains(HasSubstr("sitting 1: 0 events of its beginning in the chain")));
  EXPECT_THAT(problems(), Contains(HasSubstr("entry 1 has lost its answer or event")));
}

TEST_F(CutOffTest, ASittingWithoutAnswersIsInTheChain) {
  const Receipt before = read_study(path_).receipt();
  StudyFile study = open_study(path_, protocol_, "0.1.0");
  EXPECT_NE(start_session(study, protocol_, test::facts_of("P02")).receipt(), before);
}

}  // namespace
}  // namespace palpate::trials
