// 4, 5, 6: what reading a mesh mends, and counts.
#include <cmath>
#include <set>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/volume.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {
namespace {

constexpr double kSide = 30e-3;  // [m]

TetMesh sound_box(Jitter& jitter) {
  return jitter.of(sim::test::box_mesh(3, 3, 3, Vec3::Constant(kSide)), kSide);
}

/// The mesh's last tetrahedron on four nodes of its own, `distance` beside those of the others.
TetMesh with_duplicates(TetMesh mesh, double distance) {
  for (int& node : mesh.tetrahedra.back()) {
    mesh.nodes.push_back(mesh.nodes[node] + Vec3(distance, 0, 0));
    mesh.node_tags.push_back(static_cast<std::int64_t>(mesh.nodes.size()));
    node = static_cast<int>(mesh.nodes.size()) - 1;
  }
  return mesh;
}

}  // namespace

Outcome inverted_tetrahedra(Jitter& jitter) {
  Outcome outcome;
  TetMesh mesh = sound_box(jitter);
  std::mt19937_64 random(jitter.seed());
  std::set<std::size_t> turned;
  while (turned.size() < 7) turned.insert(random() % mesh.tetrahedra.size());
  for (const std::size_t t : turned) std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][1]);
  const sim::MeshFile mended = sim::mend(mesh, "box", 1.0);
  outcome.expect(mended.repairs.reordered_tetrahedra == 7, "reordered tetrahedra are miscounted");
  for (const sim::Tetrahedron& t : mended.mesh.tetrahedra)
    outcome.expect(sim::signed_volume(mended.mesh, t) > 0.0, "a tetrahedron stays inverted");
  TetMesh pulled = sound_box(jitter);  // an inner node pulled out of the box: no order of nodes mends that
  pulled.nodes[sim::test::inner_nodes(pulled).front()].x() = jitter.of(2 * kSide);
  const std::string refusal = refused([&] { sim::validate(sim::mend(pulled, "box", 1.0).mesh); });
  outcome.expect(says(refusal, "tetrahedra overlap") && says(refusal, "tetrahedron "), "overlap: " + refusal);
  return outcome;
}

Outcome duplicate_nodes(Jitter& jitter) {
  Outcome outcome;
  const TetMesh whole = sound_box(jitter);
  const double tolerance = sim::mend(whole, "box", 1.0).repairs.weld_tolerance;
  outcome.expect(std::abs(tolerance / (1e-9 * std::sqrt(3.0) * kSide) - 1.0) < 5e-3, "another tolerance");
  for (const double within : {0.0, 1e-3, 0.9}) {
    const sim::MeshFile welded = sim::mend(with_duplicates(whole, jitter.of(within * tolerance)), "box", 1.0);
    outcome.expect(welded.repairs.welded_nodes == 4, "welded nodes are miscounted");
    outcome.expect(welded.mesh.tetrahedra == whole.tetrahedra, "welding changes the mesh");
  }
  const sim::MeshFile apart = sim::mend(with_duplicates(whole, jitter.of(1.1 * tolerance)), "box", 1.0);
  outcome.expect(apart.repairs.welded_nodes == 0, "nodes beyond the tolerance are welded");
  return outcome;
}

Outcome unreferenced_nodes(Jitter& jitter) {
  Outcome outcome;
  const TetMesh whole = sound_box(jitter);
  TetMesh strewn = whole;
  for (int stray = 0; stray < 5; ++stray) {  // before the others, so that every index moves
    strewn.nodes.insert(strewn.nodes.begin(), jitter.of(Vec3(5, 7, 9)));
    strewn.node_tags.insert(strewn.node_tags.begin(), 1000 + stray);
  }
  for (sim::Tetrahedron& t : strewn.tetrahedra)
    for (int& node : t) node += 5;
  for (auto& [name, nodes] : strewn.node_groups)
    for (int& node : nodes) node += 5;
  const sim::MeshFile mended = sim::mend(strewn, "box", 1.0);
  outcome.expect(mended.repairs.unreferenced_nodes == 5, "unreferenced nodes are miscounted");
  outcome.expect(mended.mesh.nodes == whole.nodes && mended.mesh.tetrahedra == whole.tetrahedra &&
                     mended.mesh.node_groups == whole.node_groups,
                 "leaving them out changes the mesh");
  return outcome;
}

}  // namespace palpate::hard_cases
