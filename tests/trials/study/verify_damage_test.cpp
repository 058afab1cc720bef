#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/raw_sql.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A finished study, on which something falls that is no statement.
class DamagedFile : public testing::Test {
 protected:
  DamagedFile() {
    const Protocol protocol = test::small_protocol(2);
    StudyFile study = open_study(path_, protocol, "0.1.0");
    Session session = start_session(study, protocol, test::facts_of("P01"));
    test::answer_all(session);
  }
  std::vector<std::string> problems() { return verify_study(path_).problems; }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "study.db";
};

TEST_F(DamagedFile, ASchemaThatCannotBeReadIsAProblemInPlainWords) {
  ASSERT_EQ(test::sql(path_,
                      "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = "
                      "'CREATE' || char(27) WHERE name = 'trace'"),
            "");
  EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("database: damaged, and the rest was not looked at"),
                                            HasSubstr("\\x1b"), Not(HasSubstr("palpate verify")))));
}

// Bits that fall over anywhere in the file: found, or refused; never a crash and never a whole file.
TEST_F(DamagedFile, DamagedPagesAreFoundOrRefused) {
  const std::string whole = test::read(path_);
  for (std::size_t at = 4096; at < whole.size(); at += 4096) {
    std::string damaged = whole;
    for (std::size_t i = 0; i < 64; ++i) damaged[at + i] = static_cast<char>(~damaged[at + i]);
    test::write(path_, damaged);
    try {
      EXPECT_THAT(problems(), Not(IsEmpty())) << "page " << at / 4096;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), Not(HasSubstr("palpate verify")));
    } catch (const std::runtime_error&) {
    }
  }
}

TEST_F(DamagedFile, NoStudyFileIsRefused) {
  EXPECT_THROW(verify_study(folder_ / "none.db"), std::invalid_argument);
  test::write(folder_ / "text.db", std::string(1000, 'x'));
  EXPECT_THROW(verify_study(folder_ / "text.db"), std::invalid_argument);
}

}  // namespace
}  // namespace palpate::trials
