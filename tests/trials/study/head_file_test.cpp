#include "trials/study/head_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/clock/utc.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/connection.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A sitting in its middle. What a kill leaves is what stands on the disk at that moment.
class HeadFileTest : public testing::Test {
 protected:
  HeadFileTest() {
    study_.emplace(open_study(path_, protocol_, "0.1.0"));
    session_.emplace(start_session(*study_, protocol_, test::facts_of("P01")));
    answer();
  }

  void answer() {
    test::feel_both(*session_);
    session_->answer(1, 0.8, base::utc_now());
  }

  /// The files as a kill would leave them now, in a folder of their own; returns the study file there.
  fs::path killed() {
    const fs::path folder = folder_ / fmt::format("killed-{}", ++kills_);
    fs::create_directory(folder);
    for (const char* end : {"", "-wal", ".head"})
      if (fs::exists(path_.string() + end))
        fs::copy_file(path_.string() + end, folder / ("study.db" + std::string(end)));
    return folder / "study.db";
  }
  static void flip(const fs::path& file, std::size_t at) {
    std::string bytes = test::read(file);
    bytes.at(at) = static_cast<char>(bytes.at(at) ^ 0x10);
    test::write(file, bytes);
  }
  static std::vector<std::string> problems(const fs::path& study) { return verify_study(study).problems; }

  test::TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.db";
  Protocol protocol_ = test::small_protocol(2);
  int kills_ = 0;
  std::optional<StudyFile> study_;
  std::optional<Session> session_;
};

// The interval that runs is in the log; the answers are in the file itself.
TEST_F(HeadFileTest, NoAnswerHangsOnTheLogAlone) {
  session_->begin_interval();
  const std::string log = test::read(path_.string() + "-wal");
  ASSERT_GT(log.size(), 4096U);
  for (std::size_t at = 0; at < log.size(); at += 509) {
    const fs::path flipped = killed(), cut = killed();
    flip(flipped.string() + "-wal", at);
    fs::resize_file(cut.string() + "-wal", at);
    for (const fs::path& left : {flipped, cut}) {
      const VerifyReport report = verify_study(left);
      EXPECT_THAT(report.problems, IsEmpty()) << at;
      EXPECT_EQ(report.answers, 1) << at;
    }
  }
}

TEST_F(HeadFileTest, ACopyWithoutTheLogHoldsEveryAnswer) {
  const fs::path left = killed();
  fs::remove(left.string() + "-wal");
  fs::remove(left.string() + ".head");
  EXPECT_THAT(problems(left), IsEmpty());
  EXPECT_EQ(verify_study(left).answers, 1);
}

/// Somebody reads meanwhile, so that the log cannot be folded in: its loss is told.
class ReadMeanwhileTest : public HeadFileTest {
 protected:
  ReadMeanwhileTest() {
    reader_.exec("BEGIN");
    EXPECT_EQ(reader_.execAndGet("SELECT count(*) FROM answer").getInt(), 1);
    answer();
  }
  SQLite::Database reader_ = open_for_reading(path_);
};

TEST_F(ReadMeanwhileTest, IsWholeWithItsLogAndSaysThatItBelongsToIt) {
  const VerifyReport report = verify_study(killed());
  EXPECT_THAT(report.problems, IsEmpty());
  EXPECT_EQ(report.answers, 2);
  EXPECT_THAT(report.notes, ElementsAre(HasSubstr("study.db-wal (")));
}

TEST_F(ReadMeanwhileTest, ALogThatIsCutFlippedOrLeftBehindIsToldAndNotGoneOnWith) {
  const fs::path flipped = killed(), cut = killed(), alone = killed();
  const auto bytes = fs::file_size(path_.string() + "-wal");
  flip(flipped.string() + "-wal", bytes - 4000);  // the last commit's
  fs::resize_file(cut.string() + "-wal", bytes - 100);
  fs::remove(alone.string() + "-wal");
  for (const fs::path& left : {flipped, cut, alone}) {
    EXPECT_THAT(problems(left), ElementsAre(HasSubstr("3 entries of the chain were saved, as ")));
    EXPECT_THAT(problems(left), ElementsAre(HasSubstr(".head tells, and 2 are there: the others were lost")));
    for (const auto& go_on : std::vector<std::function<void()>>{
             [&] { check_start(left, protocol_, test::facts_of("P01"), false); },
             [&] { open_study(left, protocol_, "0.1.0"); }})
      EXPECT_THAT(test::message_of<std::invalid_argument>(go_on), HasSubstr("3 entries of the chain"));
    fs::remove(left.string() + ".head");  // as the message says: the study goes on with what is left
    StudyFile study = open_study(left, protocol_, "0.1.0");
    EXPECT_EQ(start_session(study, protocol_, test::facts_of("P01"), false).answered(), 1);
  }
}

TEST_F(HeadFileTest, IsForItsOwnerAndFollowsTheChain) {
  EXPECT_EQ(fs::status(head_path(path_)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  for (int i = 0; i < 2; ++i, answer()) {
    const HeadFile head = read_head(path_);
    EXPECT_EQ(head.state, HeadFile::State::Good);
    EXPECT_EQ(head.newest, (ChainHead{study_->study().uuid, session_->receipt()}));
  }
}

// A line that is damaged leaves the other, which is no further than the study is.
TEST_F(HeadFileTest, ALineThatIsDamagedLeavesTheOther) {
  const std::size_t bytes = fs::file_size(head_path(path_));
  for (std::size_t at = 0; at < bytes; ++at) {
    const fs::path left = killed();
    flip(head_path(left), at);
    EXPECT_EQ(read_head(left).state, HeadFile::State::Good) << at;
    EXPECT_THAT(problems(left), IsEmpty()) << at;
  }
}

TEST_F(HeadFileTest, OneThatIsDamagedWhollyIsTold) {
  const fs::path left = killed();
  const std::size_t line = fs::file_size(head_path(left)) / 2;
  flip(head_path(left), 30);
  flip(head_path(left), line + 30);
  EXPECT_THAT(problems(left), ElementsAre(HasSubstr("which tells how far it was saved, is damaged")));
}

TEST_F(HeadFileTest, AStudyThatWasRewrittenIsTold) {
  const fs::path left = killed();
  ChainHead head = *read_head(left).newest;
  head.receipt.head.assign(64, 'a');
  fs::remove(head_path(left));
  write_head(left, head);
  EXPECT_THAT(problems(left), ElementsAre(HasSubstr("is not the one that was saved")));
}

// A new study under the name of one that was put away.
TEST_F(HeadFileTest, AnotherStudysHeadIsReplaced) {
  const fs::path left = killed();
  fs::remove(left);
  fs::remove(left.string() + "-wal");
  const StudyFile made = open_study(left, protocol_, "0.1.0");
  EXPECT_EQ(read_head(left).newest, (ChainHead{made.study().uuid, made.receipt()}));
}

}  // namespace
}  // namespace palpate::trials
