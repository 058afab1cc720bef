// 9: what a mesh's numbers mean.
#include "sim/mesh/quality.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {
namespace {

TetMesh scaled(TetMesh mesh, double factor) {
  for (Vec3& node : mesh.nodes) node *= factor;
  return mesh;
}

bool warned(const TetMesh& mesh) {
  for (const std::string& warning : sim::measure_quality(mesh).warnings)
    if (says(warning, "unit")) return true;
  return false;
}

}  // namespace

Outcome units(Jitter& jitter) {
  const SceneOf in_metres = two_boxes(jitter);
  SceneOf in_millimetres = in_metres;
  for (BodyOf& body : in_millimetres.bodies) {
    body.mesh = scaled(body.mesh, 1000.0);
    body.unit = "mm";
  }
  const Vec3 there(0.3e-3, 0.1e-3, -2e-3);
  Outcome outcome{.limit = 1e-10};  // numbers rounded to 1e-16, in a body whose condition is some 1e4
  outcome.figure = apart(force_at(compiled(in_millimetres, "exact"), there),
                         force_at(compiled(in_metres, "exact"), there));
  SceneOf without_unit = in_metres;
  without_unit.bodies[0].unit = "";
  outcome.expect(says(refusal_of(write_scene(without_unit), {}), "length_unit"),
                 "a scene without units is read");
  const TetMesh box = jitter.of(sim::test::box_mesh(2, 2, 2, Vec3::Constant(30e-3)), 1e-3);
  outcome.expect(!warned(box), "a body of 30 mm draws a warning");
  outcome.expect(warned(scaled(box, 1000.0)), "a body of 30 m draws no warning");
  outcome.expect(warned(scaled(box, 1e-3)), "a body of 30 um draws no warning");
  return outcome;
}

}  // namespace palpate::hard_cases
