#include "trials/study/clock_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

}  // namespace

TEST(ClockSteps, AreToldOfAFileThatIsWholeAllTheSame) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "study.db";
  const Protocol protocol = test::small_protocol(2);
  {
    StudyFile study = open_study(path, protocol, "0.1.0");
    Session session = start_session(study, protocol, test::facts_of("P01"));
    test::answer_all(session);
  }
  EXPECT_THAT(verify_study(path).clock_steps, IsEmpty());
  const std::int64_t entries = verify_study(path).receipt.entries;
  {
    StudyFile study = open_study(path, protocol, "0.1.0");
    study.add_event({.kind = "remark", .text = "late", .utc = "2101-01-02T00:00:00.000Z"});
    study.add_event({.kind = "remark", .text = "later", .utc = "2101-01-01T23:59:59.500Z"});
    study.add_event({.kind = "remark", .text = "later still", .utc = "2101-01-02T12:00:00.000Z"});
  }
  const VerifyReport report = verify_study(path);
  EXPECT_THAT(report.problems, IsEmpty());
  ASSERT_EQ(report.clock_steps.size(), 1U);
  EXPECT_EQ(report.clock_steps[0].entry, entries + 2);
  EXPECT_THAT(in_words(report.clock_steps[0]),
              HasSubstr("from 2101-01-02T00:00:00.000Z to 2101-01-01T23:59:59.500Z"));
}

}  // namespace palpate::trials
