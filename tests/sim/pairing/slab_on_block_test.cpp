// A slab that lies exactly on a block: neither rounding nor depth may take their contact away.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sim/cycle/press.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/sim/support/body_table.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/two_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

/// A slab of 30 x 30 x 3 mm, held at two sides and free to touch with all else, on a block of 20 mm; the block is so
/// placed that no node faces a node.
std::filesystem::path slab_on_block() {
  static const palpate::test::TemporaryFolder folder;
  TetMesh slab = test::box_mesh(6, 6, 1, Vec3(30e-3, 30e-3, 3e-3));
  slab.node_groups["ends"] = test::nodes_of(slab, {"x_min", "x_max"});
  slab.node_groups["free"] = test::nodes_of(slab, {"y_min", "y_max", "z_min", "z_max"});
  write_msh(folder.path() / "upper.msh", slab);
  write_msh(folder.path() / "lower.msh", test::box_mesh(7, 7, 4, Vec3(30e-3, 30e-3, 20e-3)));
  std::ofstream(folder.path() / "scene.toml")
      << test::two_body_tables(
             test::body_table("upper", "ends", "free") + "offset = [\"0 mm\", \"0 mm\", \"30 mm\"]\n",
             test::body_table("lower", "z_min", "z_max") + "offset = [\"0.21 mm\", \"0.13 mm\", \"10 mm\"]\n",
             "kuroda")
      << "[probes.finger]\nbody = \"upper\"\nkind = \"point\"\nat = [\"15 mm\", \"15 mm\", \"33 mm\"]\n"
         "direction = [0, 0, -1]\ndepth = \"2 mm\"\n";
  return folder.path() / "scene.toml";
}

std::vector<PressStep> press_slab(double depth, int steps, std::vector<Override> changes = {}) {
  return press(test::compile_scene(slab_on_block(), changes), depth, steps).curve;
}

double pushed_back(const PressStep& step) {
  return step.probe_forces[0].z();
}

const Override kApart{"bodies.lower.offset", R"(["0.21 mm", "0.13 mm", "9.999999999 mm"])"};  // by 1e-12 m
const Override kNone{"contact.model", "none"};

TEST(SlabOnBlock, RoundingTakesNoContactAway) {
  const std::vector<PressStep> touching = press_slab(1e-3, 10), apart = press_slab(1e-3, 10, {kApart});
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(touching[i].pairs[0].active, 58)
        << i;  // 30 nodes of the slab on the block, 28 of the block under it
    EXPECT_EQ(apart[i].pairs[0].active, 58) << i;
    EXPECT_NEAR(pushed_back(touching[i]) / pushed_back(apart[i]), 1.0, 1e-7);  // 1e-12 m in 1e-4 m
  }
  // Nothing comes or goes, so each step adds as much as the one before, but for what the surfaces turn: to 2 % of it.
  // One node of the 58 that goes takes as much of the whole force, which is that of up to 10 steps.
  for (std::size_t i = 2; i < 10; ++i) {
    const double step = pushed_back(touching[i]) - pushed_back(touching[i - 1]);
    EXPECT_NEAR(step / (pushed_back(touching[i - 1]) - pushed_back(touching[i - 2])), 1.0, 0.02) << i;
  }
}

// Through half of its thickness, through all of it, and twice that.
TEST(SlabOnBlock, DepthTakesNoContactAway) {
  const std::vector<PressStep> curve = press_slab(6e-3, 60);
  const std::vector<PressStep> alone = press_slab(6e-3, 60, {kNone});
  double before = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_GE(curve[i].pairs[0].active, 58) << curve[i].depth;
    EXPECT_GT(pushed_back(curve[i]), pushed_back(alone[i]))
        << curve[i].depth;  // contact pushes, and never pulls
    EXPECT_GT(pushed_back(curve[i]), before) << curve[i].depth;
    before = pushed_back(curve[i]);
  }
}

// A block that reaches 0.1 mm into the slab, as the scene declares: it is as if they touched.
const std::vector<Override> kOverlapping{{"bodies.lower.offset", R"(["0.21 mm", "0.13 mm", "10.1 mm"])"},
                                         {"contact.overlap", "0.11 mm"}};

TEST(SlabOnBlock, WhatTheyOverlapAtRestIsNotFelt) {
  for (const char* law : {"kuroda", "sibille"}) {
    std::vector<Override> changes{{"contact.model", law}};
    const std::vector<PressStep> touching = press_slab(1e-3, 10, changes);
    changes.insert(changes.end(), kOverlapping.begin(), kOverlapping.end());
    const std::vector<PressStep> deeper = press_slab(1e-3, 10, changes);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_EQ(deeper[i].pairs[0].active, touching[i].pairs[0].active) << law << i;
      // the block stands 0.1 mm higher; nodes of surfaces that bend meet it where they are
      EXPECT_NEAR(pushed_back(deeper[i]) / pushed_back(touching[i]), 1.0, 0.01) << law << i;
    }
  }
}

// At depth 0 there is nothing to feel, and from there on no step.
TEST(SlabOnBlock, AnOverlapAtRestGivesNoForceToBeginWith) {
  EXPECT_EQ(press_slab(1e-9, 1, kOverlapping)[0].pairs[0].active, 58);
  const double slope = pushed_back(press_slab(1e-4, 1, kOverlapping)[0]) / 1e-4;
  EXPECT_NEAR(pushed_back(press_slab(1e-9, 1, kOverlapping)[0]) / 1e-9 / slope, 1.0, 0.02);
}

}  // namespace
}  // namespace palpate::sim
