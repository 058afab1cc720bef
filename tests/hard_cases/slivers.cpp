// 3: tetrahedra that are nearly flat.
#include <algorithm>
#include <cmath>

#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/volume.hpp"
#include "sim/model/loads.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/sim/support/on_mesh.hpp"

namespace palpate::hard_cases {
namespace {

double least_volume(const TetMesh& mesh) {
  double least = INFINITY;
  for (const sim::Tetrahedron& tetrahedron : mesh.tetrahedra)
    least = std::min(least, sim::signed_volume(mesh, tetrahedron));
  return least;
}

/// An inner node moved towards a face of the tetrahedra around it, to a part `left` of the way to where the first of
/// them loses its volume.
TetMesh with_slivers(TetMesh mesh, double left) {
  const int node = sim::test::inner_nodes(mesh).front();
  const Vec3 from = mesh.nodes[node];
  const auto around = std::ranges::find_if(
      mesh.tetrahedra, [&](const sim::Tetrahedron& t) { return std::ranges::find(t, node) != t.end(); });
  Vec3 face = Vec3::Zero();
  for (const int corner : *around)
    if (corner != node) face += mesh.nodes[corner] / 3;
  double sound = 0.0, flat = 2.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (sound + flat);
    mesh.nodes[node] = from + middle * (face - from);
    (least_volume(mesh) > 0.0 ? sound : flat) = middle;
  }
  mesh.nodes[node] = from + (1.0 - left) * sound * (face - from);
  return mesh;
}

}  // namespace

Outcome slivers(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  TetMesh& mesh = scene.bodies[1].mesh;
  mesh = with_slivers(mesh, jitter.of(0.005));
  Outcome outcome{.limit = 1e-9};
  const sim::MeshQuality quality = sim::measure_quality(mesh);
  outcome.expect(quality.min_dihedral < 1.0, "there is no sliver");
  outcome.expect(!quality.warnings.empty(), "slivers are not told");
  const sim::Model model = compiled(scene, "exact");
  sim::Simulation simulation(model);
  step_to(simulation, Vec3(0, 0, -2e-3));
  const sim::Body& body = model.bodies[1];
  const Eigen::Matrix3Xd f = sim::test::on_mesh(body, simulation.loads().on_body[1]);
  const Eigen::Matrix3Xd u = sim::whole_bodies(model, simulation.loads())[1].displacement;
  Eigen::Matrix3Xd residual =
      (sim::stiffness(*body.mesh, body.materials) * u.reshaped()).reshaped(3, u.cols()) - f;
  residual(Eigen::all, body.fixed).setZero();
  outcome.figure = residual.norm() / f.norm();
  const Eigen::VectorXd whole = u(Eigen::all, body.compliance->touch).reshaped();
  outcome.expect((simulation.displacement(1) - whole).norm() <= 1e-9 * whole.norm(),
                 "the condensed body moves otherwise than the whole one");
  return outcome;
}

}  // namespace palpate::hard_cases
