// 23, 24, 25, 27, 35: contact surfaces with needles, contacts that say the same, fixed nodes, nodes on corners, other
// orders.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "sim/contact/exact/exact.hpp"
#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/pairing/find_pairs.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"
#include "tests/sim/support/box_mesh.hpp"

namespace palpate::hard_cases {
namespace {

const Vec3 kPressedDown(0.1e-3, -0.2e-3, -2e-3);

/// The top node (i, j) of a box of 6 x 6 x 4 cells moved towards its neighbour along x, to `left` of the way.
TetMesh with_needle(TetMesh mesh, double left) {
  const int node = 3 + 7 * (3 + 7 * 4), beside = node + 1;
  mesh.nodes[node] = mesh.nodes[beside] + left * (mesh.nodes[node] - mesh.nodes[beside]);
  return mesh;
}

const sim::ExactScratch& scratch_of(const sim::Simulation& simulation) {
  return static_cast<const sim::ExactScratch&>(*simulation.law_scratch());
}

}  // namespace

Outcome needle_triangle(Jitter& jitter) {
  const Boxes boxes{.upper_cells = 6, .lower_cells = 6};
  SceneOf scene = two_boxes(jitter, boxes);
  Outcome outcome{.limit = 1e-2};
  TetMesh flat = scene.bodies[1].mesh;
  flat = with_needle(flat, 0.0);
  const std::string refusal = refused([&] { sim::validate(sim::mend(flat, "body", 1.0).mesh); });
  outcome.expect(says(refusal, "nodes"), "a triangle of no area is taken: " + refusal);
  // What the needle does to the elastic body is in both: a node that is moved by a thousandth or a millionth.
  const auto force = [&](double left) {
    SceneOf with = scene;
    with.bodies[1].mesh = with_needle(scene.bodies[1].mesh, left);
    const sim::Model model = compiled(with, "exact");
    sim::Simulation simulation(model);
    const sim::CycleResult result = step_to(simulation, kPressedDown);
    outcome.expect(result.solve.residual <= 1e-9, "contact is not solved");
    return Vec3(result.probe_forces[0]);
  };
  outcome.figure = apart(force(jitter.of(1e-6)), force(jitter.of(1e-3)));
  return outcome;
}

Outcome redundant_contacts(Jitter& jitter) {
  // Each node faces a node: its contact is there twice, from either side. (Jitter would take them off each other: of
  // the bodies it changes the moduli alone.)
  SceneOf scene = two_boxes(jitter, {.upper_cells = 6, .lower_cells = 6, .gap = 0.0, .shift = 0.0});
  const sim::Model model = compiled(scene, "exact");
  sim::Simulation fresh(model), used(model);
  const auto net = [&](sim::Simulation& simulation) {
    const sim::CycleResult result = step_to(simulation, kPressedDown);
    return Vec3(result.pairs[0].force_on[0]);
  };
  Outcome outcome{.limit = 1e-9};
  for (int way = 0; way < 5; ++way) {
    step_to(used, jitter.of(Vec3(0.3e-3 * way, 0.1e-3, -1e-3 * way)));
    outcome.figure = std::max(outcome.figure, apart(net(used), net(fresh)));
    fresh.reset();
  }
  const Eigen::VectorXd& forces = scratch_of(used).solve.forces();
  const Eigen::Index first = scratch_of(used).system.bilateral;
  outcome.expect(forces.tail(forces.size() - first).maxCoeff() <= net(fresh).norm(),
                 "a contact pushes more than all");
  outcome.expect(forces.tail(forces.size() - first).minCoeff() >= 0.0, "a contact pulls");
  return outcome;
}

Outcome fixed_contact(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter, {.upper_cells = 6, .lower_cells = 6, .shift = 0.0});
  TetMesh& lower = scene.bodies[1].mesh;  // its sides are fixed up to the top, as those of the upper one are
  lower.node_groups["held"] = sim::test::nodes_of(lower, {"x_min", "x_max", "y_min", "y_max", "z_min"});
  scene.bodies[1].fixed = "\"held\"";
  const sim::Model model = compiled(scene, "exact");
  sim::Simulation simulation(model);
  Outcome outcome{.limit = 1e-6, .bound = Bound::AtLeast};
  outcome.expect(step_to(simulation, kPressedDown).probe_forces[0].allFinite(), "a force is not finite");
  const auto diagonal = scratch_of(simulation).system.compliance.diagonal();
  const Eigen::VectorXd W = diagonal.tail(diagonal.size() - scratch_of(simulation).system.bilateral);
  outcome.expect(W.size() > 0, "there is no contact");
  outcome.figure = W.minCoeff() / W.maxCoeff();
  scene.bodies[1].touchable = "\"x_min\"";  // fixed altogether
  outcome.expect(says(refusal_of(write_scene(scene), {}), "bodies.lower.touchable"),
                 "what is fixed may touch");
  return outcome;
}

Outcome node_on_corner(Jitter& jitter) {
  // Nodes over nodes, where six polygons meet; then all of them 1e-12 m beside.
  const auto scene = [&](double beside) {
    return write_scene(two_boxes(jitter, {.upper_cells = 6, .lower_cells = 6, .shift = beside}));
  };
  const auto there = scene(0.0);
  const std::vector<sim::Override> beside{
      {"bodies.upper.offset", R"(["0.000001 um", "-0.000001 um", "20.2 mm"])"}};
  return of_each_law(1e-6, [&](std::string_view law, Outcome& outcome) {
    const sim::Model on = compiled(there, law), off = compiled(there, law, beside);
    sim::Simulation simulation(on);
    step_to(simulation, kPressedDown);
    sim::Placement placement = sim::rest_placement(on);
    sim::place(on, simulation.free_state().motion, placement);
    sim::Pairs pairs;
    sim::find_pairs(on, simulation.free_state().motion, placement, pairs);
    std::set<std::pair<int, int>> nodes;
    for (const sim::CollidingPair& pair : pairs) nodes.insert({pair.node_body, pair.node});
    outcome.expect(!pairs.empty() && nodes.size() == pairs.size(), "a node has passed two polygons");
    return apart(force_at(off, kPressedDown), force_at(on, kPressedDown));
  });
}

Outcome reordered_contacts(Jitter& jitter) {
  SceneOf scene = two_boxes(jitter);
  SceneOf turned = scene;
  std::ranges::reverse(turned.bodies);
  turned.touch = "[[\"lower\", \"upper\"]]";
  Outcome outcome = of_each_law(1e-9, [&](std::string_view law, Outcome&) {
    return apart(force_at(compiled(turned, law), kPressedDown), force_at(compiled(scene, law), kPressedDown));
  });
  // And the rows of one system, shuffled.
  const sim::Model model = compiled(scene, "exact");
  sim::ExactScratch scratch(model);
  const Eigen::Index first = scratch.system.bilateral;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(scratch.system.compliance.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(jitter.seed() + 1);
  std::shuffle(order.begin() + first, order.end(), random);
  sim::ContactSystem shuffled = scratch.system;
  shuffled.compliance = Eigen::MatrixXd(scratch.system.compliance(order, order));
  std::vector<double> gaps;
  for (const Eigen::Index row : std::span(order).subspan(static_cast<std::size_t>(first)))
    gaps.push_back(scratch.rest_gaps[static_cast<std::size_t>(row - first)]);
  const std::vector<char> holds(static_cast<std::size_t>(first), 1);
  const std::vector<double> values{kPressedDown[0], kPressedDown[1], kPressedDown[2]};
  scratch.solve.solve(holds, values, scratch.rest_gaps);
  sim::ComplementaritySolve solve(shuffled);
  solve.solve(holds, values, gaps);
  const Eigen::VectorXd forces = scratch.solve.forces(), expected = forces(order);
  outcome.expect((solve.forces() - expected).norm() <= 1e-9 * expected.norm(), "contacts carry other forces");
  return outcome;
}

}  // namespace palpate::hard_cases
