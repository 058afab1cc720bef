#include "tests/extending/patch/patch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/cycle/simulation.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

TEST(Patch, HoldsTheMeanOfItsNodes) {
  const Model model = test::compile_scene(test::write_two_boxes({.probe = "kind = \"patch\""}));
  const Probe& patch = model.probes[0];
  EXPECT_GT(patch.nodes.size(), 4U);
  Simulation simulation(model);
  const ProbeDisplacement pressed{1e-3 * patch.direction};
  simulation.step({&pressed, 1}, 1e-3);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < patch.nodes.size(); ++i)
    mean += patch.weights[i] * simulation.motion()[0].displacement.segment<3>(3 * patch.nodes[i]);
  EXPECT_LT((mean - pressed.from_rest).norm(), 1e-15);
}

TEST(Patch, IsOneOfTheKindsThatASceneMayName) {
  const std::string scene = test::write_two_boxes({.probe = "kind = \"thimble\""});
  EXPECT_THAT(palpate::test::run({"press", scene}).err,
              testing::HasSubstr("point, pad, fingertip, region, patch"));
}

}  // namespace
}  // namespace palpate::sim
