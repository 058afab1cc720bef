#include "sim/elasticity/supports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "sim/elasticity/static_solve.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::sim {
namespace {

using test::box_mesh;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Material kUnitStiff{.young_modulus = 1.0, .poisson_ratio = 0.4};

/// 4 x 3 x 3 nodes; node i + 4 (j + 3 k) has the tag one above.
TetMesh bar() {
  return box_mesh(3, 2, 2, Vec3(0.03, 0.02, 0.02));
}

/// Two bars that share nothing: nodes 0 .. 35 and 36 .. 71.
TetMesh two_bars() {
  TetMesh both = bar();
  for (std::size_t i = 0; i < 36; ++i) both.nodes.push_back(both.nodes[i] + Vec3(0, 0, 0.1));
  for (Tetrahedron t : bar().tetrahedra) {
    for (int& node : t) node += 36;
    both.tetrahedra.push_back(t);
  }
  both.region.assign(both.tetrahedra.size(), -1);
  both.node_tags.resize(72);
  std::iota(both.node_tags.begin(), both.node_tags.end(), 1);
  return both;
}

/// Solves under a unit force on every node, and says what was refused.
void solve(const TetMesh& mesh, const std::vector<int>& fixed) {
  const Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Ones(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  static_solve(stiffness(mesh, {&kUnitStiff, 1}), fixed, forces);
}

struct MissingRank {
  std::vector<int> fixed;
  const char* by_mesh;       // named by the file's numbers
  const char* by_stiffness;  // which knows neither numbers nor places
};

class Supports : public testing::TestWithParam<MissingRank> {};

TEST_P(Supports, SayWhichRankIsMissing) {
  const TetMesh mesh = bar();
  EXPECT_THAT([&] { require_supports(mesh, GetParam().fixed); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(GetParam().by_mesh)));
  EXPECT_THAT([&] { solve(mesh, GetParam().fixed); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(GetParam().by_stiffness)));
}

// Hard cases 14 and 15.
INSTANTIATE_TEST_SUITE_P(
    HardCases, Supports,
    testing::Values(
        MissingRank{{},
                    "supports leave 6 of 6 rigid motions free: no node is fixed",
                    "supports leave 6 of 6 rigid motions free: no node is fixed"},
        MissingRank{{5},
                    "supports leave 3 of 6 rigid motions free: 1 fixed node (node 6) holds translations only",
                    "1 fixed node (node 5) holds translations only"},
        MissingRank{
            {5, 9},
            "supports leave 1 of 6 rigid motions free: 2 fixed nodes (nodes 6 and 10) leave the rotation",
            "2 fixed nodes (nodes 5 and 9) leave the rotation"},
        MissingRank{{0, 1, 3},
                    "supports leave 1 of 6 rigid motions free: its 3 fixed nodes lie on one line",
                    "they lie on one line, or"},
        MissingRank{{0, 1, 2, 3}, "its 4 fixed nodes lie on one line", "they lie on one line, or"}));

TEST(Supports, OfThreeNodesOffALineHoldTheBody) {
  const TetMesh mesh = bar();
  const std::vector<int> fixed{0, 3, 4};
  EXPECT_NO_THROW(require_supports(mesh, fixed));
  EXPECT_NO_THROW(solve(mesh, fixed));
}

/// A slanting line far from the origin: places are rounded, and still the nodes are one hinge.
TEST(Supports, FindALineThatRoundingHasBent) {
  TetMesh mesh = bar();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(3, 1, 2).normalized()).toRotationMatrix();
  for (Vec3& node : mesh.nodes) node = turn * node + Vec3(1e3, 2e3, -5e2);
  const std::vector<int> fixed{0, 1, 2, 3};
  EXPECT_THAT([&] { require_supports(mesh, fixed); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("its 4 fixed nodes lie on one line")));
}

// Hard case 8.
TEST(Supports, NameThePieceThatNothingHolds) {
  const TetMesh mesh = two_bars();
  std::vector<int> fixed{0, 3, 4};
  EXPECT_THAT([&] { require_supports(mesh, fixed); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(
                  "supports leave 6 of 6 rigid motions of one of the body's 2 pieces (the one of 36 "
                  "nodes with node 37) free: no node is fixed")));
  fixed.insert(fixed.end(), {36, 40});
  EXPECT_THAT([&] { solve(mesh, fixed); }, ThrowsMessage<std::invalid_argument>(
                                               HasSubstr("supports leave 1 of 6 rigid motions of one of")));
  fixed.push_back(41);
  EXPECT_NO_THROW(solve(mesh, fixed));
}

/// A piece of which every node is fixed moves nowhere, however few they are.
TEST(Supports, AskNothingOfAPieceThatIsFixedWhole) {
  TetMesh mesh = two_bars();
  std::vector<int> fixed(36);
  std::iota(fixed.begin(), fixed.end(), 0);
  fixed.insert(fixed.end(), {36, 39, 40});
  EXPECT_NO_THROW(solve(mesh, fixed));
}

/// Two halves that hang together by the edge between nodes 36 and 37: a door.
TEST(Supports, OfADoorAreRefusedByTheFactorisation) {
  TetMesh mesh = bar();
  for (std::size_t i = 0; i < 36; ++i)  // the second half: turned about the edge between nodes 0 and 1
    if (i > 1) mesh.nodes.push_back(Vec3(mesh.nodes[i].x(), -mesh.nodes[i].y(), -mesh.nodes[i].z()));
  for (Tetrahedron t : bar().tetrahedra) {
    for (int& node : t) node = node <= 1 ? node : node + 34;
    mesh.tetrahedra.push_back(t);
  }
  mesh.region.assign(mesh.tetrahedra.size(), -1);
  // Five nodes, not on one line, hold the first half; the second one swings.
  EXPECT_THAT(
      [&] {
        solve(mesh, {28, 32, 33, 34, 35});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("a part of the body hangs on a single node")));
}

/// What is slender or uneven is not singular: it must not be taken for it.
TEST(Supports, HoldASlenderBarAndASoftRoot) {
  TetMesh mesh = box_mesh(150, 1, 1, Vec3(150, 1, 1));
  EXPECT_NO_THROW(solve(mesh, mesh.node_groups.at("x_min")));
  mesh = box_mesh(40, 1, 1, Vec3(40, 1, 1));
  mesh.region_names = {"root"};
  for (std::size_t e = 0; e < 6; ++e) mesh.region[e] = 0;
  const std::array<Material, 2> materials{Material{1e6, 0.4}, Material{1.0, 0.4}};
  const Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Ones(3, static_cast<Eigen::Index>(mesh.nodes.size()));
  EXPECT_NO_THROW(static_solve(stiffness(mesh, materials), mesh.node_groups.at("x_min"), forces));
}

}  // namespace
}  // namespace palpate::sim
