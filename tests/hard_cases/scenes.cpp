#include "tests/hard_cases/scenes.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <fstream>
#include <optional>

#include "sim/compile/compile.hpp"
#include "sim/contact/exact/exact.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::hard_cases {
namespace {

std::filesystem::path folder_of_its_own() {
  static const palpate::test::TemporaryFolder all;
  static int count = 0;
  std::filesystem::path folder = all.path() / std::to_string(++count);
  std::filesystem::create_directory(folder);
  return folder;
}

/// Compliances of the last few scenes: a body is condensed once for all laws.
sim::ComplianceCache& recent_bodies() {
  constexpr int kScenes = 20;
  static std::optional<sim::ComplianceCache> cache;
  static int used = 0;
  if (used++ % kScenes == 0) cache.emplace("");
  return *cache;
}

std::string lengths(const Vec3& place) {
  return fmt::format(R"(["{:.17g} m", "{:.17g} m", "{:.17g} m"])", place[0], place[1], place[2]);
}

std::string table_of(const BodyOf& body) {
  return fmt::format(
      "[bodies.{0}]\nmesh = \"{0}.msh\"\nlength_unit = \"{1}\"\nyoung_modulus = \"{2:.17g} Pa\"\n"
      "poisson_ratio = 0.40\n{3}{4}offset = {5}\n",
      body.name, body.unit, body.modulus, body.fixed.empty() ? "" : "fixed = " + body.fixed + "\n",
      body.touchable.empty() ? "" : "touchable = " + body.touchable + "\n", lengths(body.offset));
}

std::string table_of(const ProbeOf& probe) {
  return fmt::format(
      "[probes.{}]\nbody = \"{}\"\n{}\n{}direction = [{:.17g}, {:.17g}, {:.17g}]\ndepth = \"2 mm\"\n",
      probe.name, probe.body, probe.kind,
      probe.kind.find("region") == std::string::npos ? "at = " + lengths(probe.at) + "\n" : "",
      probe.direction[0], probe.direction[1], probe.direction[2]);
}

}  // namespace

std::filesystem::path write_scene(const SceneOf& scene) {
  const std::filesystem::path folder = folder_of_its_own();
  std::string text = "name = \"hard case\"\n";
  for (const BodyOf& body : scene.bodies) {
    sim::write_msh(folder / (body.name + ".msh"), body.mesh);
    text += table_of(body);
  }
  if (scene.bodies.size() > 1)
    text += fmt::format("[contact]\ntouch = {}\nmodel = \"exact\"\n{}", scene.touch, scene.contact);
  for (const ProbeOf& probe : scene.probes) text += table_of(probe);
  std::ofstream(folder / "scene.toml") << text;
  return folder / "scene.toml";
}

sim::Model compiled(const std::filesystem::path& file, std::string_view model,
                    std::span<const sim::Override> more) {
  std::vector<sim::Override> overrides(more.begin(), more.end());
  overrides.push_back({"contact.model", std::string(model)});
  return sim::compile(sim::load_scene(file, overrides), recent_bodies());
}

sim::Model compiled(const SceneOf& scene, std::string_view model, std::span<const sim::Override> more) {
  return compiled(write_scene(scene), model, more);
}

std::string refusal_of(const std::filesystem::path& file, std::span<const sim::Override> overrides) {
  return refused([&] {
    sim::ComplianceCache cache({});
    sim::compile(sim::load_scene(file, overrides), cache);
  });
}

TetMesh box_with_sides(int cells, int layers, const Vec3& size) {
  TetMesh mesh = sim::test::box_mesh(cells, cells, layers, size);
  mesh.node_groups["sides"] = sim::test::nodes_of(mesh, {"x_min", "x_max", "y_min", "y_max"});
  return mesh;
}

SceneOf two_boxes(Jitter& jitter, const Boxes& boxes) {
  const double side = 30e-3, height = 20e-3, thickness = 5e-3;  // [m]
  const double uneven = boxes.gap > 0.0 ? boxes.gap : 0.0;      // what positions are jittered by a part of
  SceneOf scene;
  scene.bodies = {
      {.name = "upper",
       .mesh = jitter.of(box_with_sides(boxes.upper_cells, 2, Vec3(side, side, thickness)), 10 * uneven),
       .fixed = "\"sides\"",
       .touchable = "\"z_min\"",
       .modulus = jitter.of(1e6),
       .offset = Vec3(boxes.shift, boxes.shift, height + boxes.gap)},
      {.name = "lower",
       .mesh =
           jitter.of(sim::test::box_mesh(boxes.lower_cells, boxes.lower_cells, 4, Vec3(side, side, height)),
                     10 * uneven),
       .modulus = jitter.of(1e6)}};
  scene.probes = {
      {.at = Vec3(side / 2 + boxes.shift, side / 2 + boxes.shift, height + boxes.gap + thickness)}};
  return scene;
}

sim::CycleResult step_to(sim::Simulation& simulation, const Vec3& there) {
  std::vector<sim::ProbeDisplacement> probes(simulation.free_state().probes.size());
  probes.front().from_rest = there;
  return simulation.step(probes, sim::kCyclePeriod);
}

Vec3 force_at(const sim::Model& model, const Vec3& there) {
  sim::Simulation simulation(model);
  return step_to(simulation, there).probe_forces.front();
}

double steepest(const sim::Model& exact) {
  const sim::ExactScratch scratch(exact);
  const Eigen::MatrixXd& K = scratch.system.compliance;
  const Eigen::MatrixXd all = K + Eigen::MatrixXd(sim::kDelta * K.diagonal().asDiagonal());
  const Eigen::Index axes = scratch.system.first_of_probe[1];
  const Eigen::MatrixXd stiffest =
      Eigen::MatrixXd(all.ldlt().solve(Eigen::MatrixXd::Identity(K.rows(), axes))).topRows(axes);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffest, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

double stored_energy(const sim::Model& model, const sim::Simulation& simulation) {
  double stored = 0.0;
  for (int body = 0; body < std::ssize(model.bodies); ++body)
    stored +=
        0.5 * simulation.displacement(body).dot(simulation.loads().on_body[static_cast<std::size_t>(body)]);
  return stored;
}

double apart(const Vec3& a, const Vec3& b) {
  return (a - b).norm() / b.norm();
}

}  // namespace palpate::hard_cases
