#include "tests/extending/spring/spring.hpp"

#include "sim/contact/prescribed/prescribed_solve.hpp"
#include "sim/pairing/find_pairs.hpp"

namespace palpate::sim {
namespace {

constexpr double kStiffness = 10e3;  // [N/m]

/// Everything that a cycle writes to, taken once: a law allocates nothing in a cycle.
struct SpringScratch : LawScratch {
  Placement placement{};
  Pairs pairs{};
  std::vector<Eigen::VectorXd> forces{};        // of contact, on the touchable nodes of each body [N]
  std::vector<Eigen::VectorXd> displacement{};  // that they bring [m]
  std::vector<PrescribedSolve> holds{};         // of each body: what its probes do against those forces
  ProbeRows back{};                             // what each probe takes back of the motion that they bring
};

std::unique_ptr<LawScratch> prepare(const Model& model) {
  if (model.pairs.empty()) return nullptr;
  auto scratch = std::make_unique<SpringScratch>();
  scratch->summaries.resize(model.pairs.size());
  scratch->placement = rest_placement(model);
  scratch->pairs.reserve(most_pairs(model));
  scratch->back.resize(model.probes.size());
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    scratch->forces.emplace_back(Eigen::VectorXd::Zero(3 * model.bodies[i].rest.cols()));
    scratch->displacement.push_back(scratch->forces.back());
    scratch->holds.emplace_back(model, i, 0);
  }
  return scratch;
}

void push(const Model& model, const CollidingPair& pair, SpringScratch& scratch) {
  const Vec3 force = kStiffness * pair.depth * pair.normal;
  scratch.forces[pair.node_body].segment<3>(3 * pair.node) += force;
  for (const int corner : model.bodies[pair.polygon_body].polygons.triangles[pair.polygon])
    scratch.forces[pair.polygon_body].segment<3>(3 * corner) -= force / 3.0;
  PairSummary& summary = scratch.summaries[pair.touch_pair];
  const int side = model.pairs[pair.touch_pair].bodies[0] == pair.node_body ? 0 : 1;
  ++summary.active;
  summary.force_on[side] += force;
  summary.force_on[1 - side] -= force;
}

/// Adds what the contact forces do to one body, whose pressing probes stay where they are.
bool respond(const Model& model, const FreeState& free, int i, SpringScratch& scratch, Response& response) {
  const Body& body = model.bodies[i];
  Eigen::VectorXd& displacement = scratch.displacement[i];
  response.loads.on_body[i] += scratch.forces[i];
  displacement.noalias() = 1.0 / body.young_modulus * body.compliance->touch_touch * scratch.forces[i];
  for (const int k : body.probes) {
    const Probe& probe = model.probes[k];
    Vec3 mean = Vec3::Zero();
    for (std::size_t j = 0; j < probe.nodes.size(); ++j)
      mean += probe.weights[j] * displacement.segment<3>(3 * probe.nodes[j]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis)
      scratch.back[k].value[axis] = -probe.axes.col(axis).dot(mean);
  }
  PrescribedSolve& hold = scratch.holds[i];
  if (!hold.factor(free.probes, {})) return false;
  hold.solve(&scratch.back, {});
  hold.add_forces(response.loads.on_body[i]);
  for (const int k : body.probes) response.probe_forces[k] += hold.probe_force(k);
  return true;
}

SolveReport solve(const Model& model, const FreeState& free, std::span<const double>, LawScratch& scratch,
                  Response& response) {
  auto& own = static_cast<SpringScratch&>(scratch);
  place(model, free.motion, own.placement);
  find_pairs(model, free.motion, own.placement, own.pairs);
  if (own.pairs.empty()) return {};
  for (Eigen::VectorXd& forces : own.forces) forces.setZero();
  for (const CollidingPair& pair : own.pairs) push(model, pair, own);
  for (int i = 0; i < std::ssize(model.bodies); ++i)
    if (!respond(model, free, i, own, response)) return {.stop = Stop::SingularMatrix};
  return {.iterations = 1};
}

}  // namespace

constinit const ContactLaw kSpring{.name = "spring",
                                   .meaning = "they push each other apart like springs",
                                   .prepare = prepare,
                                   .solve = solve};

}  // namespace palpate::sim
