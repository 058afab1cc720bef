#include "trials/study/merge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/clock/utc.hpp"
#include "base/files/sha256.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/verify.hpp"
#include "trials/tables/delimited.hpp"

namespace palpate::trials {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Table> tables_of(const StudyFile& study) {
  const auto answered = answered_trials(study);
  return {trial_table(study.protocol(), answered), interval_table(study.protocol(), answered),
          exposure_table(study.protocol(), exposures(study))};
}

/// Two sites' files: each with a voided trial, one with a sitting that was cut off, one that never ended.
class MergeTest : public testing::Test {
 protected:
  MergeTest() {
    osaka_ = make("osaka.db", {"P01", "P02"});
    kyoto_ = make("kyoto.db", {"Q01"});
  }

  Receipt make(const std::string& name, const std::vector<std::string>& examinees) {
    StudyFile study = open_study(folder_ / name, protocol_, "0.1.0");
    for (const std::string& examinee : examinees) {
      Session session = start_session(study, protocol_, test::facts_of(examinee));
      session.begin_interval();
      session.interrupt(test::press_to(1e-3), "test");
      test::answer_all(session);
      EventRow event{.session = session.row().id, .trial = 2, .kind = "voided", .text = "alarm"};
      study.add_event(event);
    }
    Session unfinished = start_session(study, protocol_, test::facts_of(examinees[0] + "0"));
    test::feel_both(unfinished);
    unfinished.answer(1, 0.5, base::utc_now());
    unfinished.begin_interval();
    return study.receipt();
  }
  std::string refusal(const std::vector<MergeSource>& sources) {
    const std::string message =
        test::message_of<std::invalid_argument>([&] { merge_studies(folder_ / "all.db", sources, "0.1.0"); });
    EXPECT_FALSE(std::filesystem::exists(folder_ / "all.db"));
    return message;
  }
  std::filesystem::path merged() {
    merge_studies(folder_ / "all.db", {{folder_ / "osaka.db"}, {folder_ / "kyoto.db"}}, "0.1.0");
    return folder_ / "all.db";
  }
  void tamper(const std::string& table, const std::string& change) {
    const std::string trigger = table + "_refuses_UPDATE";
    const std::string guard =
        test::sql_value(folder_ / "all.db", "SELECT sql FROM sqlite_schema WHERE name = '" + trigger + "'");
    ASSERT_EQ(test::sql(folder_ / "all.db", "DROP TRIGGER " + trigger + ";" + change + ";" + guard), "");
  }

  test::TemporaryFolder folder_;
  Protocol protocol_ = test::small_protocol(2);
  Receipt osaka_{}, kyoto_{};
};

TEST_F(MergeTest, HoldsEveryRowOfItsParts) {
  const StudyFile all = read_study(merged());
  const StudyFile osaka = read_study(folder_ / "osaka.db"), kyoto = read_study(folder_ / "kyoto.db");
  const std::vector<Table> first = tables_of(osaka), second = tables_of(kyoto), joined = tables_of(all);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    Table both = first[i];
    both.rows.insert(both.rows.end(), second[i].rows.begin(), second[i].rows.end());
    EXPECT_FALSE(second[i].rows.empty());
    EXPECT_EQ(to_csv(joined[i]), to_csv(both));
  }
  EXPECT_EQ(all.events().size(), osaka.events().size() + kyoto.events().size() + 1);
}

TEST_F(MergeTest, IsWholeAndEveryReceiptHolds) {
  const auto all = merged();
  const VerifyReport report = verify_study(all);
  EXPECT_THAT(report.problems, IsEmpty());
  ASSERT_EQ(report.parts.size(), 2U);
  EXPECT_EQ(report.parts[0].receipt, osaka_);
  EXPECT_EQ(report.parts[1].receipt, kyoto_);
  EXPECT_EQ(report.parts[1].file, "kyoto.db");
  EXPECT_EQ(report.receipt.entries, osaka_.entries + kyoto_.entries + 1);
  for (const Receipt& receipt : {osaka_, kyoto_, report.receipt})
    EXPECT_THAT(verify_study(all, receipt).problems, IsEmpty()) << to_string(receipt);
  Receipt wrong = kyoto_;
  ++wrong.entries;
  EXPECT_THAT(verify_study(all, wrong).problems, Contains(HasSubstr("the receipt does not fit")));
}

TEST_F(MergeTest, ASiteStandsBeforeItsCodesAndTheChainStillHolds) {
  make("third.db", {"P01"});
  merge_studies(folder_ / "all.db", {{folder_ / "osaka.db", "Osaka"}, {folder_ / "third.db", "Third"}},
                "0.1.0");
  EXPECT_THAT(verify_study(folder_ / "all.db", osaka_).problems, IsEmpty());
  std::vector<std::string> codes;
  for (const SessionRow& session : read_study(folder_ / "all.db").sessions())
    codes.push_back(session.facts.examinee);
  EXPECT_THAT(codes, testing::ElementsAre("Osaka-P01", "Osaka-P02", "Osaka-P010", "Third-P01", "Third-P010"));
}

// A code without its site would hash as the site hashed it: it must be missed, not mended.
TEST_F(MergeTest, ACodeThatLostItsSiteIsFound) {
  merge_studies(folder_ / "all.db", {{folder_ / "osaka.db", "Osaka"}, {folder_ / "kyoto.db"}}, "0.1.0");
  tamper("session", "UPDATE session SET examinee = 'P01' WHERE examinee = 'Osaka-P01'");
  EXPECT_THAT(verify_study(folder_ / "all.db").problems,
              testing::ElementsAre("examinee P01, sitting 1: its code does not begin with its site, Osaka"));
}

TEST_F(MergeTest, AnOrderNotYetAnsweredCannotBeAlteredInAPart) {
  merge_studies(folder_ / "all.db", {{folder_ / "osaka.db", "Osaka"}, {folder_ / "kyoto.db"}}, "0.1.0");
  tamper("trial",
         "UPDATE trial SET correct_interval = 3 - correct_interval WHERE session = 3 AND number = 4");
  EXPECT_THAT(verify_study(folder_ / "all.db").problems,
              testing::ElementsAre(HasSubstr("examinee Osaka-P010, sitting 1: its facts or orders are not")));
}

TEST_F(MergeTest, GoesOnAsAnyStudyDoes) {
  const auto all = merged();
  StudyFile study = open_study(all, protocol_, "0.1.0");
  Session resumed = start_session(study, protocol_, test::facts_of("Q010"));  // cut off at its site
  EXPECT_TRUE(resumed.view().resumed);
  test::answer_all(resumed);
  Session added = start_session(study, protocol_, test::facts_of("N1"));
  test::answer_all(added);
  EXPECT_THAT(verify_study(all, added.receipt()).problems, IsEmpty());
  EXPECT_THAT(verify_study(all, kyoto_).problems, IsEmpty());
}

TEST_F(MergeTest, NeverTouchesItsSources) {
  const std::string before = test::read(folder_ / "osaka.db");
  merged();
  EXPECT_EQ(test::read(folder_ / "osaka.db"), before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "osaka.db-wal"));
}

TEST_F(MergeTest, TamperingIsFoundInEveryPart) {
  const auto all = merged();
  const std::string last_of_kyoto = std::to_string(osaka_.entries + 5);
  tamper("answer", "UPDATE answer SET response = 3 - response, correct = 1 - correct WHERE entry IN (4, " +
                       last_of_kyoto + ")");
  EXPECT_THAT(verify_study(all).problems, Contains(HasSubstr("entry 4 was altered")));
  EXPECT_THAT(verify_study(all).problems, Contains(HasSubstr("entry " + last_of_kyoto + " was altered")));
}

TEST_F(MergeTest, AnotherListOfPartsIsFound) {
  const auto all = merged();
  tamper("event", "UPDATE event SET text = replace(text, 'kyoto.db', 'nara.db') WHERE kind = 'merged'");
  EXPECT_THAT(verify_study(all).problems, Contains(HasSubstr("was altered")));
  tamper("event", "UPDATE event SET text = 'nonsense' WHERE kind = 'merged'");
  EXPECT_THAT(verify_study(all).problems, Contains(HasSubstr("cannot be read")));
}

TEST_F(MergeTest, RefusesWhatDoesNotBelongTogether) {
  const MergeSource osaka{folder_ / "osaka.db"}, kyoto{folder_ / "kyoto.db"};
  EXPECT_THAT(refusal({osaka}), HasSubstr("1 study file to join; accepted: two or more"));
  std::filesystem::copy(osaka.file, folder_ / "copy.db");
  EXPECT_THAT(refusal({osaka, {folder_ / "copy.db", "Copy"}}), HasSubstr("are the same study"));
  make("clash.db", {"p1"});
  EXPECT_THAT(refusal({osaka, {folder_ / "clash.db"}}), HasSubstr("examinee p1 of "));
  EXPECT_THAT(refusal({osaka, {folder_ / "kyoto.db", "a site"}}), HasSubstr("accepted: letters and digits"));
  EXPECT_THAT(refusal({osaka, {folder_ / "kyoto.db", std::string(30, 'x')}}), HasSubstr("a code of 1 to 32"));
  EXPECT_THAT(refusal({osaka, {folder_ / "none.db"}}), HasSubstr("none.db: no such file"));
  merge_studies(folder_ / "joined.db", {osaka, kyoto}, "0.1.0");
  EXPECT_THAT(refusal({{folder_ / "joined.db"}, {folder_ / "clash.db"}}), HasSubstr("was itself joined"));
}

TEST_F(MergeTest, RefusesAnotherProtocolWithBothHashes) {
  const Protocol other = test::small_protocol(3);
  { StudyFile study = open_study(folder_ / "other.db", other, "0.1.0"); }
  const std::string message = refusal({{folder_ / "osaka.db"}, {folder_ / "other.db"}});
  EXPECT_THAT(message, HasSubstr(protocol_.sha256));
  EXPECT_THAT(message, HasSubstr(other.sha256));
}

TEST_F(MergeTest, RefusesAnotherScene) {
  Protocol other = protocol_;
  other.scene_text += "# changed\n";
  other.files[0].sha256 = base::sha256_hex(other.scene_text);
  { StudyFile study = open_study(folder_ / "other.db", other, "0.1.0"); }
  EXPECT_THAT(refusal({{folder_ / "osaka.db"}, {folder_ / "other.db"}}), HasSubstr(other.files[0].sha256));
}

TEST_F(MergeTest, RefusesASourceThatIsNotWhole) {
  ASSERT_EQ(test::sql(folder_ / "kyoto.db", "DROP TRIGGER answer_refuses_UPDATE"), "");
  EXPECT_THAT(refusal({{folder_ / "osaka.db"}, {folder_ / "kyoto.db"}}), HasSubstr("kyoto.db: is not whole"));
}

TEST_F(MergeTest, ReplacesNothing) {
  test::write(folder_ / "all.db", "mine");
  EXPECT_THROW(merged(), std::invalid_argument);
  EXPECT_EQ(test::read(folder_ / "all.db"), "mine");
}

}  // namespace
}  // namespace palpate::trials
