#include "trials/procedures/constant/constant.hpp"

#include <gtest/gtest.h>

#include "tests/trials/support/protocols.hpp"
#include "trials/plan/plan.hpp"

namespace palpate::trials {
namespace {

TEST(Constant, AsksWhatWasDrawnAheadWhateverIsAnswered) {
  const Protocol protocol = test::small_protocol(3);
  ASSERT_EQ(protocol.procedure, &kConstant);
  Generator generator = make_generator(1, "test");
  const std::vector<ChosenLevel> ahead = kConstant.draw_ahead(protocol, generator);
  ASSERT_EQ(ahead.size(), 6U);
  for (const bool correct : {false, true}) {
    ProcedureState state = replay(kConstant, protocol, ahead, {});
    for (const ChosenLevel level : ahead) {
      EXPECT_EQ(kConstant.next(state, generator), level);
      state = after(kConstant, state, {.level = level, .answer = 1, .correct = correct});
    }
    EXPECT_EQ(kConstant.next(state, generator), std::nullopt);
  }
}

TEST(Constant, TakesUpAfterTheAnswersThatAreStored) {
  const Protocol protocol = test::small_protocol(3);
  Generator generator = make_generator(1, "test");
  const std::vector<ChosenLevel> ahead = levels_of(draw_plan(protocol, generator));
  const std::vector<Told> answers{{.level = ahead[0], .answer = 1}, {.level = ahead[1], .answer = 2}};
  EXPECT_EQ(kConstant.next(replay(kConstant, protocol, ahead, answers), generator), ahead[2]);
}

}  // namespace
}  // namespace palpate::trials
