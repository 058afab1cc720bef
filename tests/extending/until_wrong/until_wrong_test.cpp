#include "tests/extending/until_wrong/until_wrong.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/trials/support/protocols.hpp"

namespace palpate::trials {
namespace {

/// Cells that are asked when answers are right (true) or wrong, of two cells with at most three trials each.
std::vector<std::size_t> cells_asked(const std::vector<bool>& answers) {
  const Protocol protocol = test::small_protocol(3);
  Generator generator = make_generator(1, "test");
  ProcedureState state = replay(kUntilWrong, protocol, {}, {});
  std::vector<std::size_t> cells;
  while (const auto level = kUntilWrong.next(state, generator)) {
    const bool correct = answers.at(cells.size());
    cells.push_back(level->cell);
    state = after(kUntilWrong, state, {.level = *level, .answer = 1, .correct = correct});
  }
  return cells;
}

TEST(UntilWrong, GoesOnAfterAWrongAnswerOrTheMostTrials) {
  EXPECT_THAT(cells_asked({true, false, false}), testing::ElementsAre(0, 0, 1));
  EXPECT_THAT(cells_asked({true, true, true, true, true, true}), testing::ElementsAre(0, 0, 0, 1, 1, 1));
}

TEST(UntilWrong, IsPlayedStoredAndVerified) {
  const palpate::test::TemporaryFolder folder;
  const std::string protocol = palpate::test::source_folder() + "/tests/extending/until_wrong/example.toml";
  const std::string study = folder / "study.db";
  const auto played =
      palpate::test::run({"simulate", protocol, "--study", study, "--examinees", "3", "--seed", "1"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto verified = palpate::test::run({"verify", study});
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  EXPECT_THAT(verified.out, testing::HasSubstr("3 sittings"));
}

}  // namespace
}  // namespace palpate::trials
