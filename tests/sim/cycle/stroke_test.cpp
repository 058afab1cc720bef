#include "sim/cycle/stroke.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "tests/sim/support/two_boxes.hpp"

namespace palpate::sim {
namespace {

using test::compile_scene;
using test::write_two_boxes;
using testing::ElementsAre;
using testing::HasSubstr;

/// Every probe of the model pressed to each depth in turn, 10 ms apart.
std::vector<StrokePose> pressed_to(const Model& model, std::span<const double> depths) {
  std::vector<StrokePose> poses;
  for (const double depth : depths)
    poses.push_back({0.01 * static_cast<double>(poses.size()), displaced_by(model, depth)});
  return poses;
}

TEST(Stroke, StraightInIsAPress) {
  const Model model = compile_scene(write_two_boxes({.shift = 1.7e-3}));
  const Press press = sim::press(model, 2e-3, 4);
  const std::vector<double> depths{0.5e-3, 1e-3, 1.5e-3, 2e-3};
  const Stroke stroke = sim::stroke(model, pressed_to(model, depths));
  ASSERT_EQ(stroke.steps.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(stroke.steps[i].depth, depths[i]);
    EXPECT_EQ(stroke.steps[i].probe_forces, press.curve[i].probe_forces);
    EXPECT_EQ(stroke.steps[i].penetration, press.curve[i].penetration);
  }
  EXPECT_EQ(stroke.loads.on_body, press.loads.on_body);
}

// A held probe feels the surface's resistance across its press as well as along it; off the skin, nothing.
TEST(Stroke, SidewaysIsFeltSidewaysAndOffTheSkinNothing) {
  const Model model = compile_scene(write_two_boxes(), std::vector<Override>{{"contact.model", "none"}});
  const std::vector<StrokePose> poses{
      {0.0, {{Vec3(0, 0, -1e-3)}}}, {0.1, {{Vec3(1e-3, 0, -1e-3)}}}, {0.2, {{Vec3(1e-3, 0, 1e-3)}}}};
  const Stroke stroke = sim::stroke(model, poses);
  const auto force = [&](std::size_t step) { return stroke.steps[step].probe_forces[0]; };
  EXPECT_LT(std::abs(force(0).x()), 0.2 * force(0).z());  // the cut of the mesh is not quite symmetric
  EXPECT_LT(force(1).x(), force(0).x() - 0.2 * force(0).z());
  EXPECT_EQ(force(2), Vec3::Zero());
  EXPECT_EQ(stroke.times, (std::vector<double>{0.0, 0.1, 0.2}));
}

// Without contact each probe presses a body of its own.
TEST(Stroke, MovesEachProbeByItself) {
  const Model model = compile_scene(write_two_boxes({.second_probe = true}),
                                    std::vector<Override>{{"contact.model", "none"}});
  ASSERT_EQ(model.probes.size(), 2U);
  const Vec3 in = 1e-3 * model.probes[0].direction;
  const std::vector<StrokePose> poses{{0, {{in}, {}}}, {1, {{}, {in}}}, {2, {{in}, {in}}}};
  const Stroke stroke = sim::stroke(model, poses);
  EXPECT_EQ(stroke.steps[0].probe_forces[1], Vec3::Zero());
  EXPECT_EQ(stroke.steps[1].probe_forces[0], Vec3::Zero());
  EXPECT_THAT(stroke.steps[2].probe_forces,
              ElementsAre(stroke.steps[0].probe_forces[0], stroke.steps[1].probe_forces[1]));
  EXPECT_GT(stroke.steps[2].probe_forces[0].norm(), 0.0);
}

std::vector<double> told_dts;

/// A law with a memory, which notes how much time each cycle is told to have taken.
constexpr ContactLaw kNoting{
    .name = "noting",
    .prepare = [](const Model&) { return std::make_unique<LawScratch>(); },
    .memory_size = [](const Model&) { return std::size_t{1}; },
    .solve = [](const Model&, const FreeState&, std::span<const double>, LawScratch&,
                Response&) { return SolveReport{}; },
    .advance = [](const Model&, const LawScratch&, double dt, std::span<double>) { told_dts.push_back(dt); }};

TEST(Stroke, TellsEachCycleTheTimeSinceTheOneBefore) {
  Model model = compile_scene(write_two_boxes());
  model.law = &kNoting;
  told_dts.clear();
  std::vector<StrokePose> poses;
  for (const double time : {3.0, 3.5, 3.75, 5.0}) poses.push_back({time, displaced_by(model, 1e-3)});
  stroke(model, poses);
  EXPECT_THAT(told_dts, ElementsAre(kCyclePeriod, 0.5, 0.25, 1.25));
}

TEST(Stroke, ThatCannotBeSolvedSaysWhen) {
  const Model model = compile_scene(write_two_boxes());
  std::vector<StrokePose> poses = pressed_to(model, std::vector<double>{1e-3, 1e-3});
  EXPECT_NO_THROW(require_solved(stroke(model, poses)));
  poses[1].probes[0].rotation[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { require_solved(stroke(model, poses)); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("at a time of 0.01 s (not finite)")));
}

}  // namespace
}  // namespace palpate::sim
