#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/surface.hpp"
#include "sim/mesh/volume.hpp"
#include "tests/sim/mesh/fixtures.hpp"

namespace palpate::sim::test {
namespace {

std::vector<int> permutation(std::size_t n, std::uint64_t seed) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(seed);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// The same body with nodes and tetrahedra in another order; tags go with their nodes.
TetMesh permuted(const TetMesh& mesh, std::uint64_t seed) {
  const std::vector<int> node_at = permutation(mesh.nodes.size(), seed);
  const std::vector<int> tetrahedron_at = permutation(mesh.tetrahedra.size(), seed + 1);
  TetMesh out = mesh;
  std::vector<int> place(mesh.nodes.size());
  for (std::size_t i = 0; i < node_at.size(); ++i) {
    const std::size_t from = node_at[i];
    out.nodes[i] = mesh.nodes[from];
    out.node_tags[i] = mesh.node_tags[from];
    place[from] = static_cast<int>(i);
  }
  for (std::size_t t = 0; t < tetrahedron_at.size(); ++t) {
    out.tetrahedra[t] = mesh.tetrahedra[tetrahedron_at[t]];
    for (int& node : out.tetrahedra[t]) node = place[node];
  }
  return out;
}

/// Surface triangles by their tags, each turned so that its least tag comes first: equal for equal surfaces.
std::set<std::array<std::int64_t, 3>> tagged_surface(const TetMesh& mesh) {
  std::set<std::array<std::int64_t, 3>> triangles;
  for (const Triangle& triangle : extract_surface(mesh).triangles) {
    std::array<std::int64_t, 3> tags{};
    for (std::size_t i = 0; i < 3; ++i) tags[i] = mesh.node_tags[triangle[i]];
    std::rotate(tags.begin(), std::ranges::min_element(tags), tags.end());
    triangles.insert(tags);
  }
  return triangles;
}

RC_GTEST_PROP(MeshProperties, OrderOfNodesAndElementsDoesNotMatter, (std::uint64_t seed)) {
  const TetMesh cube = cube_mesh(*rc::gen::inRange(1, 4), 0.1);
  const MeshFile read = parse_mesh(to_msh2(permuted(cube, seed)), "body.msh", 1.0);
  RC_ASSERT(read.repairs.reordered_tetrahedra == 0);
  RC_ASSERT(tagged_surface(read.mesh) == tagged_surface(cube));
  // Each of the sums of up to 162 volumes is exact to a few units in the last place.
  RC_ASSERT(std::abs(measure_quality(read.mesh).volume - 1e-3) < 1e-15);
  RC_ASSERT(std::abs(enclosed_volume(read.mesh) - 1e-3) < 1e-15);
}

RC_GTEST_PROP(MeshProperties, NodesOfTheirOwnForEveryTetrahedronAreWeldedAgain, (std::uint64_t seed)) {
  const TetMesh cube = cube_mesh(*rc::gen::inRange(1, 4), 0.1);
  TetMesh apart = cube;
  apart.nodes.clear();
  apart.node_tags.clear();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(-1e-11, 1e-11);  // the tolerance is 1.7e-10 m
  for (Tetrahedron& t : apart.tetrahedra)
    for (int& node : t) {
      apart.nodes.push_back(cube.nodes[node] + Vec3(jitter(random), jitter(random), jitter(random)));
      node = static_cast<int>(apart.nodes.size()) - 1;
      apart.node_tags.push_back(node + 1);
    }
  const MeshFile mended = mend(apart, "body", 1.0);
  RC_ASSERT(mended.mesh.nodes.size() == cube.nodes.size());
  RC_ASSERT(mended.repairs.welded_nodes == static_cast<int>(apart.nodes.size() - cube.nodes.size()));
  validate(mended.mesh);
  RC_ASSERT(std::abs(enclosed_volume(mended.mesh) - 1e-3) < 1e-11);  // surface of 0.06 m^2 times the jitter
}

RC_GTEST_PROP(MeshProperties, RigidMotionKeepsShape, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
  const TetMesh cube = cube_mesh(2, 0.1);
  TetMesh moved = cube;
  for (Vec3& x : moved.nodes) x = rotation * x + Vec3(1, 2, 3);
  const MeshQuality before = measure_quality(cube), after = measure_quality(moved);
  RC_ASSERT(std::abs(before.volume - after.volume) < 1e-14);
  RC_ASSERT(std::abs(before.min_dihedral - after.min_dihedral) < 1e-9);
  RC_ASSERT(std::abs(before.min_radius_ratio - after.min_radius_ratio) < 1e-10);
  RC_ASSERT(extract_surface(moved).triangles == extract_surface(cube).triangles);
}

RC_GTEST_PROP(MeshProperties, MirroredBodiesAreReorderedOutright, (std::uint64_t seed)) {
  TetMesh mirrored = permuted(cube_mesh(2, 0.1), seed);
  for (Vec3& x : mirrored.nodes) x.x() = -x.x();
  const MeshFile mended = mend(mirrored, "body", 1.0);
  RC_ASSERT(mended.repairs.reordered_tetrahedra == 48);
  validate(mended.mesh);
  RC_ASSERT(std::abs(enclosed_volume(mended.mesh) - 1e-3) < 1e-15);
}

}  // namespace
}  // namespace palpate::sim::test
