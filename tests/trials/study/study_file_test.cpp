#include "trials/study/study_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <system_error>

#include "base/clock/utc.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

using testing::HasSubstr;

class StudyFileTest : public testing::Test {
 protected:
  StudyFile open() { return open_study(path_, protocol_, "0.1.0"); }
  std::string refusal(const Protocol& protocol) {
    return test::message_of<std::invalid_argument>([&] { open_study(path_, protocol, "0.1.0"); });
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::small_protocol(1);
};

TEST_F(StudyFileTest, IsMadeWithTheStudyInIt) {
  const StudyFile made = open();
  const StudyRow study = read_study(path_).study();
  EXPECT_EQ(study.uuid, made.study().uuid);
  EXPECT_EQ(study.protocol_text, protocol_.text);
  EXPECT_EQ(study.protocol_sha256, protocol_.sha256);
  EXPECT_EQ(study.software_version, "0.1.0");
  EXPECT_EQ(read_study(path_).protocol().conditions.size(), protocol_.conditions.size());
}

TEST_F(StudyFileTest, IsOpenedAgainAndStaysTheSameStudy) {
  const std::string uuid = open().study().uuid;
  EXPECT_EQ(open().study().uuid, uuid);
}

TEST_F(StudyFileTest, TheFileAndItsHeadAreLeftWhenItIsClosed) {
  open();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    names.push_back(entry.path().filename());
  EXPECT_THAT(names, testing::UnorderedElementsAre("study.db", "study.db.head"));
}

TEST_F(StudyFileTest, UsesStrictTablesAndAWriteAheadLog) {
  open();
  EXPECT_EQ(test::sql_value(path_, "PRAGMA journal_mode"), "wal");
  EXPECT_EQ(test::sql_value(path_,
                            "SELECT count(*) FROM pragma_table_list WHERE schema = 'main' AND type = 'table' "
                            "AND strict = 0 AND name NOT LIKE 'sqlite_%'"),
            "0");
}

TEST_F(StudyFileTest, RefusesFilesThatAreNoStudyAndLeavesThemAsTheyAre) {
  test::sql(folder_ / "foreign.db", "CREATE TABLE t (x)");
  const std::string foreign = test::read(folder_ / "foreign.db");
  open();
  const std::string whole = test::read(path_);
  std::string newer = whole;
  newer[63] = 99;  // user_version
  for (const auto& [bytes, said] :
       std::vector<std::pair<std::string, std::string>>{{"", "holds 0 bytes"},
                                                        {std::string(5000, 'x'), "is no SQLite database"},
                                                        {foreign, "is a database of another program"},
                                                        {whole.substr(0, whole.size() / 2), "is cut short"},
                                                        {newer, "has format 99"}}) {
    test::write(path_, bytes);
    EXPECT_THAT(refusal(protocol_), HasSubstr(said));
    EXPECT_THAT(test::message_of<std::invalid_argument>([&] { read_study(path_); }), HasSubstr(said));
    EXPECT_EQ(test::read(path_), bytes);
  }
}

TEST_F(StudyFileTest, RefusesAnotherProtocolsStudy) {
  open();
  const std::string before = test::read(path_);
  const Protocol other = test::small_protocol(2);
  EXPECT_THAT(refusal(other), HasSubstr("not of small.toml as it is now"));
  Protocol other_mesh = protocol_;
  other_mesh.files.push_back({"rectum", "rectum.msh", std::string(64, 'a')});
  EXPECT_THAT(refusal(other_mesh),
              HasSubstr("rectum.msh (rectum) is not the one that this study began with"));
  EXPECT_EQ(test::read(path_), before);
}

TEST_F(StudyFileTest, RefusesAFolderThatIsMissing) {
  path_ = folder_ / "none" / "study.db";
  EXPECT_THAT(refusal(protocol_), HasSubstr("does not exist"));
}

// As root nothing is read-only; so for this test the process is nobody (65534).
TEST_F(StudyFileTest, RefusesAFolderThatCannotBeWritten) {
  std::filesystem::permissions(folder_.path(), static_cast<std::filesystem::perms>(0555));
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const std::string said = test::message_of<std::system_error>([&] { open(); });
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::owner_all);
  EXPECT_THAT(said, HasSubstr(folder_.path().string() + ": cannot be written: Permission denied"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(StudyFileTest, RefusesToChangeOrDeleteRows) {
  StudyFile study = open();
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  test::answer_all(session);
  for (const char* change :
       {"UPDATE answer SET response = 2", "DELETE FROM answer", "DELETE FROM ledger",
        "UPDATE event SET text = ''", "UPDATE trial SET correct_interval = 1",
        "UPDATE session SET run_mode = 'pilot'", "DELETE FROM trace", "UPDATE study SET protocol_text = ''"})
    EXPECT_THAT(test::sql(path_, change), HasSubstr("append-only")) << change;
  EXPECT_TRUE(verify_study(path_).problems.empty());
}

TEST_F(StudyFileTest, HoldsAllOfALoopsTimingOrNone) {
  StudyFile study = open();
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  session.begin_interval();
  const std::string end =
      "INSERT INTO presentation_end VALUES (1, '', 'enough', 1, 1.0, 1.0, 1.0, 0.0, NULL, 2.5, NULL)";
  EXPECT_THAT(test::sql(path_, end), HasSubstr("CHECK constraint failed"));
}

TEST_F(StudyFileTest, HoldsHowExactlyForcesWereComputed) {
  StudyFile study = open();
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  session.begin_interval();
  session.end_interval(test::felt_in_a_loop());
  const std::vector<PresentationRow> felt = study.presentations(1);
  ASSERT_TRUE(felt.at(0).solve.has_value());
  EXPECT_EQ(felt[0].solve->force_error_bound, 0.0125);
  EXPECT_EQ(felt[0].solve->cycles_within_tolerance, 70);
  EXPECT_EQ(felt[0].solve->cycles_at_cap, 3);
  test::answer_all(session);
  EXPECT_THAT(verify_study(path_).problems, testing::IsEmpty());
}

/// A study of which version 1 kept one presentation.
void make_version_1(const std::filesystem::path& path) {
  ASSERT_EQ(test::sql(path, "DROP TABLE presentation_solve; PRAGMA user_version = 1"), "");
}

TEST_F(StudyFileTest, AFileOfVersion1IsReadAndVerifiedAsItIs) {
  {
    StudyFile study = open();
    Session session = start_session(study, protocol_, test::facts_of("P01"));
    test::answer_all(session);
  }
  make_version_1(path_);
  const std::string before = test::read(path_);
  EXPECT_THAT(verify_study(path_).problems, testing::IsEmpty());
  const std::vector<PresentationRow> felt = read_study(path_).presentations(1);
  EXPECT_EQ(felt.size(), 4U);
  for (const PresentationRow& presentation : felt) EXPECT_FALSE(presentation.solve.has_value());
  EXPECT_EQ(test::read(path_), before);
}

TEST_F(StudyFileTest, AFileOfVersion1GoesOnWithWhatLaterOnesKeep) {
  {
    StudyFile study = open();
    Session session = start_session(study, protocol_, test::facts_of("P01"));
    test::feel_both(session);
    session.answer(1, 0.8, "2003-12-03T09:30:05.000Z");
  }
  make_version_1(path_);
  StudyFile study = open();
  EXPECT_EQ(test::sql_value(path_, "PRAGMA user_version"), "2");
  Session session = start_session(study, protocol_, test::facts_of("P02"));
  session.begin_interval();
  session.end_interval(test::felt_in_a_loop());
  test::answer_all(session);
  EXPECT_FALSE(study.presentations(1).at(0).solve.has_value());
  EXPECT_TRUE(study.presentations(2).at(0).solve.has_value());
  EXPECT_THAT(verify_study(path_).problems, testing::IsEmpty());
  EXPECT_THAT(test::sql(path_, "DELETE FROM presentation_solve"), HasSubstr("append-only"));
}

TEST_F(StudyFileTest, AMissingTableIsDamage) {
  open();
  ASSERT_EQ(test::sql(path_, "DROP TABLE answer"), "");
  const std::string said = test::message_of<std::invalid_argument>([&] { read_study(path_).answers(1); });
  EXPECT_THAT(said, HasSubstr("the study file is damaged (no such table: answer)"));
}

TEST_F(StudyFileTest, ARowThatAnotherProgramWroteIsToldInWords) {
  StudyFile study = open();
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  ASSERT_EQ(test::sql(path_,
                      "INSERT INTO presentation SELECT 9, session, number, draw, 1, 1, 'soft', '' FROM "
                      "trial WHERE number = 1"),
            "");
  const std::string said = test::message_of<std::runtime_error>([&] { session.begin_interval(); });
  EXPECT_THAT(said, HasSubstr("the study file refused a row that does not fit those it holds"));
}

TEST_F(StudyFileTest, KeepsEventsInTheChain) {
  StudyFile study = open();
  const Receipt before = study.receipt();
  EventRow event{.kind = "voided"};
  event.text = "the alarm rang";
  event.utc = base::utc_now();
  study.add_event(event);
  ASSERT_EQ(study.events().size(), 1U);
  EXPECT_EQ(study.events()[0].text, "the alarm rang");
  EXPECT_EQ(study.receipt().entries, before.entries + 1);
  EXPECT_NE(study.receipt().head, before.head);
}

// A file size limit stands for a full disk: the kernel refuses the write in the middle of a sitting.
TEST_F(StudyFileTest, LosesNothingWhenTheDiskIsFull) {
  StudyFile study = open();
  Session session = start_session(study, protocol_, test::facts_of("P01"));
  test::feel_both(session);
  session.answer(1, 0.8, base::utc_now());

  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  rlimit tight = before;
  tight.rlim_cur = std::filesystem::file_size(path_.string() + "-wal");
  ::setrlimit(RLIMIT_FSIZE, &tight);
  const std::string said = test::message_of<std::runtime_error>([&] { session.begin_interval(); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(said, HasSubstr("every answer given before is kept"));
  EXPECT_EQ(session.phase(), Phase::Ready);

  test::answer_all(session);  // there is room again: the sitting goes on
  EXPECT_TRUE(verify_study(path_).problems.empty());
  EXPECT_EQ(verify_study(path_).answers, 2);
}

TEST(Receipt, IsReadAsItIsPrinted) {
  const Receipt receipt{.entries = 120, .head = std::string(64, 'b')};
  EXPECT_EQ(parse_receipt(to_string(receipt)), receipt);
  for (const char* text : {"", "120", "120-", "x-9f", "-1-aa", "120-zz", " ", "120-0123456789abcde"})
    EXPECT_THROW(parse_receipt(text), std::invalid_argument) << text;
}

TEST(Receipt, IsReadAsItIsWrittenByHand) {
  EXPECT_EQ(parse_receipt(" 120-0123456789ABCDEF\n"), (Receipt{120, "0123456789abcdef"}));
}

}  // namespace
}  // namespace palpate::trials
