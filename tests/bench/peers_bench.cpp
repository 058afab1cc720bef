// What other programs need for the same work: a sphere (R 20 mm) pressed 5 mm into a box (50 x 50 x 30 mm), both
// elastic, E 1 MPa, nu 0.40, frictionless. The whole cycle with `exact` over a press of half a second, what preparing
// it takes, and after how many cycles that is regained. docs/method.md, "Speed", tells of the other programs.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "base/machine/machine.hpp"
#include "sim/compile/compile.hpp"
#include "sim/contact/laws.hpp"
#include "sim/cost/cycle_cost.hpp"
#include "sim/cycle/press.hpp"
#include "sim/mesh/read_mesh.hpp"
#include "sim/mesh/write_msh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::sim {
namespace {

constexpr double kRadius = 20e-3, kHeight = 30e-3, kDepth = 5e-3;  // [m]
constexpr double kHeld = 12e-3;  // the sphere's cap is held from here above its middle [m]
constexpr double kTouchable =
    15e-3;  // distance from the press within which surfaces can touch: at 5 mm the contact
            // is some 10 mm wide, sqrt(R d) [m]

constexpr const char* kGeometry = R"geo(SetFactory("OpenCASCADE");
{shape}
Mesh.MeshSizeMin = {h};
Mesh.MeshSizeMax = {h};
Physical Volume("body") = {{1}};
Mesh.MshFileVersion = 4.1;
)geo";

constexpr const char* kScene = R"(name = "sphere on box"
[bodies.box]
mesh = "box.msh"
length_unit = "m"
young_modulus = "1 MPa"
poisson_ratio = 0.40
fixed = "bottom"
touchable = "near"
[bodies.sphere]
mesh = "sphere.msh"
length_unit = "m"
young_modulus = "1 MPa"
poisson_ratio = 0.40
touchable = "near"
[contact]
touch = [["sphere", "box"]]
model = "exact"
pairing = "both"
[probes.finger]
body = "sphere"
kind = "region"
group = "cap"
direction = [0, 0, -1]
depth = "5 mm"
)";

/// The measured step of another program on such a scene.
struct Peer {
  const char* name;
  double nodes = 0;
  double step = 0.0;  // [s]
};

struct Size {
  double edge = 0.0;  // of the tetrahedra [m]
  Peer peer;          // the fastest whose force is right
};

constexpr Size kSizes[] = {
    {7.0e-3, {"SOFA v26.06, PrecomputedLinearSolver", 605, 4.6e-3}},
    {2.9e-3, {"SOFA v26.06, PrecomputedLinearSolver", 4967, 0.231}},
    {1.53e-3, {"SOFA v26.06, sparse LDL (METIS)", 19947, 19.0}},
};

TetMesh meshed(const std::filesystem::path& folder, const char* shape, double edge) {
  const auto geometry = folder / "body.geo", mesh = folder / "body.msh";
  std::ofstream(geometry) << fmt::format(kGeometry, fmt::arg("shape", shape), fmt::arg("h", edge));
  const std::string made = fmt::format("gmsh {} -3 -nt 1 -v 1 -o {}", geometry.string(), mesh.string());
  if (std::system(made.c_str()) != 0) throw std::runtime_error("no mesh by: " + made);
  return read_mesh(mesh, 1.0).mesh;
}

/// Adds the nodes that `belongs` names as a group.
template <class Belongs>
void add_group(TetMesh& mesh, const char* name, Belongs belongs) {
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (belongs(mesh.nodes[i])) mesh.node_groups[name].push_back(static_cast<int>(i));
}

void write_scene(const std::filesystem::path& folder, double edge) {
  const auto near_the_press = [](const Vec3& node) { return std::hypot(node.x(), node.y()) < kTouchable; };
  TetMesh box = meshed(folder, "Box(1) = {-25e-3, -25e-3, -30e-3, 50e-3, 50e-3, 30e-3};", edge);
  add_group(box, "bottom", [](const Vec3& node) { return node.z() < -kHeight + 1e-9; });
  add_group(box, "near", [&](const Vec3& node) { return node.z() > -1e-9 && near_the_press(node); });
  TetMesh sphere = meshed(folder, "Sphere(1) = {0, 0, 20e-3, 20e-3};", edge);
  const auto on_surface = [](const Vec3& node) {
    return std::abs((node - Vec3(0, 0, kRadius)).norm() - kRadius) < 1e-6;
  };
  add_group(sphere, "cap", [&](const Vec3& node) { return node.z() > kRadius + kHeld && on_surface(node); });
  add_group(sphere, "near",
            [&](const Vec3& node) { return node.z() < kRadius && near_the_press(node) && on_surface(node); });
  write_msh(folder / "box.msh", box);
  write_msh(folder / "sphere.msh", sphere);
  std::ofstream(folder / "scene.toml") << kScene;
}

/// At the full depth [N].
double pressed_force(const Model& model) {
  Simulation simulation(model);
  return simulation.step(displaced_by(model, kDepth), kCyclePeriod).probe_forces.front().norm();
}

void measure(const Size& size) {
  const palpate::test::TemporaryFolder folder;
  write_scene(folder.path(), size.edge);
  ComplianceCache cache("");
  const auto begun = std::chrono::steady_clock::now();
  const Model model = compile(load_scene(folder / "scene.toml"), cache);
  { const Simulation prepared(model); }
  const double preparation = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  // A press of half a second at 1 kHz.
  const CycleCost cost =
      measure_cycle(model, contact_law("exact"),
                    {.depth = kDepth, .poses = 500, .most_cycles = 10'000, .most_seconds = 20.0});
  const double cycle = 1e-6 * cost.total.median;
  std::size_t nodes = 0;
  for (const Body& body : model.bodies) nodes += body.mesh->nodes.size();
  fmt::print(
      "{:>6} {:>9} {:>8} {:>9.3f} {:>11.2f} {:>10.1f} {:>10.1f} {:>12.4g} {:>9.3g} {:>11.3g}  {}, {} nodes\n",
      nodes, fmt::format("{}+{}", model.bodies[0].rest.cols(), model.bodies[1].rest.cols()), cost.active,
      pressed_force(model), preparation, cost.total.median, cost.total.p999, 1e3 * size.peer.step,
      size.peer.step / cycle, preparation / (size.peer.step - cycle), size.peer.name, size.peer.nodes);
}

}  // namespace
}  // namespace palpate::sim

int main() {
  fmt::print("{}\n{:>6} {:>9} {:>8} {:>9} {:>11} {:>10} {:>10} {:>12} {:>9} {:>11}  {}\n",
             palpate::base::describe_machine(), "nodes", "touchable", "contacts", "force [N]", "prepare [s]",
             "cycle [us]", "p99.9 [us]", "peer [ms]", "ratio", "regained", "peer");
  for (const auto& size : palpate::sim::kSizes) palpate::sim::measure(size);
}
