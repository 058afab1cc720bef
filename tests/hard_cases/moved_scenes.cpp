// 10, 11, 12: the same scene elsewhere, turned, mirrored, and with its nodes and elements in another order.
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

const Vec3 kPressed(0.3e-3, 0.1e-3, -2e-3);

/// Every place of a scene taken by Q x + t, the offsets of its bodies into their meshes.
SceneOf moved(SceneOf scene, const Eigen::Matrix3d& Q, const Vec3& t) {
  for (BodyOf& body : scene.bodies) {
    for (Vec3& node : body.mesh.nodes) node = Q * (node + body.offset) + t;
    body.offset.setZero();
    if (Q.determinant() < 0.0)
      for (sim::Tetrahedron& tetrahedron : body.mesh.tetrahedra) std::swap(tetrahedron[0], tetrahedron[1]);
  }
  for (ProbeOf& probe : scene.probes) {
    probe.at = Q * probe.at + t;
    probe.direction = Q * probe.direction;
  }
  return scene;
}

TetMesh shuffled(const TetMesh& mesh, std::mt19937_64& random) {
  std::vector<int> number(mesh.nodes.size());
  std::iota(number.begin(), number.end(), 0);
  std::ranges::shuffle(number, random);
  TetMesh mixed = mesh;
  for (std::size_t i = 0; i < number.size(); ++i) {
    mixed.nodes[static_cast<std::size_t>(number[i])] = mesh.nodes[i];
    mixed.node_tags[static_cast<std::size_t>(number[i])] = mesh.node_tags[i];
  }
  for (sim::Tetrahedron& tetrahedron : mixed.tetrahedra)
    for (int& node : tetrahedron) node = number[static_cast<std::size_t>(node)];
  std::ranges::shuffle(mixed.tetrahedra, random);
  for (auto& [name, nodes] : mixed.node_groups) {
    for (int& node : nodes) node = number[static_cast<std::size_t>(node)];
    std::ranges::sort(nodes);
  }
  return mixed;
}

}  // namespace

Outcome far_from_origin(Jitter& jitter) {
  const SceneOf here = two_boxes(jitter);
  const SceneOf far = moved(here, Eigen::Matrix3d::Identity(), jitter.of(Vec3(1e4, -1e4, 1e4)));
  // Numbers of 1e4 m are rounded to 1e-12 m. Of an edge of 5 mm that is 2e-10, of the depth past the gap 1e-9; the
  // many edges and what stands on the way from them to a force take some hundred times that.
  return of_each_law(1e-6, [&](std::string_view law, Outcome&) {
    return apart(force_at(compiled(far, law), kPressed), force_at(compiled(here, law), kPressed));
  });
}

Outcome permuted(Jitter& jitter) {
  const SceneOf as_it_was = two_boxes(jitter);
  std::mt19937_64 random(jitter.seed() + 1);
  SceneOf mixed = as_it_was;
  for (BodyOf& body : mixed.bodies) body.mesh = shuffled(body.mesh, random);
  return of_each_law(1e-10, [&](std::string_view law, Outcome&) {
    return apart(force_at(compiled(mixed, law), kPressed), force_at(compiled(as_it_was, law), kPressed));
  });
}

Outcome moved_scene(Jitter& jitter) {
  const SceneOf as_it_was = two_boxes(jitter);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(jitter.of(2.0), Vec3(0.3, 1, -1).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirrored = Vec3(1, -1, 1).asDiagonal().toDenseMatrix() * turned;
  return of_all_laws(1e-10, [&](std::string_view law, Outcome&) {
    const Vec3 here = force_at(compiled(as_it_was, law), kPressed);
    double farthest = 0.0;
    for (const Eigen::Matrix3d& Q : {turned, mirrored}) {
      const SceneOf there = moved(as_it_was, Q, jitter.of(Vec3(0.1, -0.2, 0.3)));
      farthest = std::max(farthest, apart(force_at(compiled(there, law), Q * kPressed), Q * here));
    }
    return farthest;
  });
}

}  // namespace palpate::hard_cases
