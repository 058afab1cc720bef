// 7, 8, 14, 15: surfaces that are none, and supports that do not hold.
#include <fmt/format.h>

#include <utility>

#include "sim/elasticity/supports.hpp"
#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {
namespace {

constexpr double kEdge = 10e-3;  // [m]

/// Tetrahedra on given points, in units of 10 mm; tags count from 1.
TetMesh tetrahedra_on(Jitter& jitter, const std::vector<Vec3>& nodes,
                      const std::vector<sim::Tetrahedron>& tetrahedra) {
  TetMesh mesh{.tetrahedra = tetrahedra};
  mesh.region.assign(tetrahedra.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mesh.nodes.push_back(kEdge * nodes[i]);
    mesh.node_tags.push_back(static_cast<std::int64_t>(i) + 1);
  }
  return sim::mend(jitter.of(mesh, kEdge), "made", 1.0).mesh;
}

/// A box on its bottom and another piece of one cell beside it.
TetMesh two_pieces() {
  TetMesh mesh = sim::test::box_mesh(2, 2, 2, Vec3::Constant(2 * kEdge));
  const TetMesh piece = sim::test::box_mesh(1, 1, 1, Vec3::Constant(kEdge));
  const auto first = static_cast<int>(mesh.nodes.size());
  for (const Vec3& node : piece.nodes) {
    mesh.nodes.emplace_back(node + Vec3(5 * kEdge, 0, 0));
    mesh.node_tags.push_back(static_cast<std::int64_t>(mesh.nodes.size()));
  }
  for (sim::Tetrahedron t : piece.tetrahedra) {
    for (int& node : t) node += first;
    mesh.tetrahedra.push_back(t);
    mesh.region.push_back(-1);
  }
  return mesh;
}

/// How a scene of one box with these fixed nodes (tags) is refused.
std::string with_fixed(Jitter& jitter, const TetMesh& mesh, const std::string& fixed) {
  SceneOf scene;
  scene.bodies = {{.name = "upper", .mesh = jitter.of(mesh, kEdge), .fixed = fixed, .touchable = ""}};
  scene.probes = {{.kind = "kind = \"point\"", .at = Vec3(kEdge, kEdge, 2 * kEdge)}};
  return refusal_of(write_scene(scene), {});
}

}  // namespace

Outcome non_manifold_surface(Jitter& jitter) {
  Outcome outcome;
  const auto refusal = [&](const std::vector<Vec3>& nodes, const std::vector<sim::Tetrahedron>& tetrahedra) {
    return refused([&] { sim::validate(tetrahedra_on(jitter, nodes, tetrahedra)); });
  };
  const std::string edge = refusal({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                                   {{0, 1, 2, 3}, {0, 1, 4, 5}});
  outcome.expect(says(edge, "edge 1-2 (4 triangles)"), "edge: " + edge);
  const std::string node =
      refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
              {{0, 1, 2, 3}, {0, 4, 5, 6}});
  outcome.expect(says(node, "node 1;"), "node: " + node);
  const std::string face = refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}},
                                   {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
  outcome.expect(says(face, "face 1-2-3 (3 tetrahedra)"), "face: " + face);
  return outcome;
}

Outcome loose_piece(Jitter& jitter) {
  Outcome outcome;
  const std::string refusal = with_fixed(jitter, two_pieces(), "\"z_min\"");
  outcome.expect(
      says(refusal, "bodies.upper") && says(refusal, "one of the body's 2 pieces (the one of 8 nodes"),
      "refusal: " + refusal);
  return outcome;
}

Outcome no_fixed_node(Jitter& jitter) {
  Outcome outcome;
  const TetMesh box = sim::test::box_mesh(2, 2, 2, Vec3::Constant(2 * kEdge));
  const std::string scene = with_fixed(jitter, box, "");
  outcome.expect(says(scene, "bodies.upper") && says(scene, "nothing holds it"), "scene: " + scene);
  const std::string mesh = refused([&] { sim::require_supports(jitter.of(box, kEdge), {}); });
  outcome.expect(says(mesh, "leave 6 of 6 rigid motions"), "mesh: " + mesh);
  return outcome;
}

Outcome few_fixed_nodes(Jitter& jitter) {
  Outcome outcome;
  const TetMesh box = sim::test::box_mesh(2, 2, 2, Vec3::Constant(2 * kEdge));
  const auto expect = [&](const TetMesh& mesh, const std::string& fixed, std::string_view words) {
    const std::string refusal = with_fixed(jitter, mesh, fixed);
    outcome.expect(words.empty() ? refusal.empty() : says(refusal, "bodies.upper") && says(refusal, words),
                   fmt::format("fixed = {}: {}", fixed, refusal));
  };
  expect(box, "[1]", "leave 3 of 6 rigid motions");
  expect(box, "[1, 3]", "leave 1 of 6 rigid motions");
  expect(box, "[1, 3, 7]", "");                                     // three corners of the bottom
  if (jitter.exact()) expect(box, "[1, 2, 3]", "lie on one line");  // jitter takes them off it
  return outcome;
}

}  // namespace palpate::hard_cases
