#include "tests/extending/spring/spring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "sim/cycle/simulation.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

constexpr double kDepth = 1.5e-3;  // [m]

TEST(Spring, PushesBothBodiesAlikeAndLeavesTheProbeWhereItIs) {
  const std::array<Override, 1> with_spring{{{"contact.model", "spring"}}};
  const Model model = test::compile_scene(test::write_two_boxes(), with_spring);
  Simulation simulation(model);
  const std::array<ProbeDisplacement, 1> pressed{{{kDepth * model.probes[0].direction}}};
  const CycleResult result = simulation.step(pressed, 1e-3);
  ASSERT_EQ(result.solve.stop, Stop::Converged);
  const PairSummary& pair = result.pairs[0];
  EXPECT_GT(pair.active, 0);
  EXPECT_LT(pair.force_on[1].z(), 0.0);  // the lower box is pressed down
  EXPECT_LT((pair.force_on[0] + pair.force_on[1]).norm(), 1e-12 * pair.force_on[0].norm());
  const Vec3 held = simulation.motion()[0].displacement.segment<3>(3 * model.probes[0].nodes[0]);
  EXPECT_LT((held - pressed[0].from_rest).norm(), 1e-12 * kDepth);
}

TEST(Spring, IsPressedAsAnyContactModelIs) {
  const std::string scene = test::write_two_boxes();
  const auto pressed = palpate::test::run({"press", scene, "--model", "spring", "--steps", "2"});
  EXPECT_EQ(pressed.exit_code, 0) << pressed.err;
  const auto unknown = palpate::test::run({"press", scene, "--model", "glue"});
  EXPECT_THAT(unknown.err, testing::HasSubstr("spring"));
}

}  // namespace
}  // namespace palpate::sim
