#include "sim/cycle/cycle.hpp"

#include <algorithm>

#include "sim/contact/laws.hpp"
#include "sim/cycle/buffers.hpp"

namespace palpate::sim {
namespace {

/// Empties what a cycle writes.
void start(Scratch::Buffers& buffers) {
  buffers.pairs.clear();
  buffers.shares.clear();
  for (auto& forces : buffers.loads.on_body) forces.setZero();
  for (auto& displacement : buffers.displacement) displacement.setZero();
  std::ranges::fill(buffers.probe_forces, Vec3(Vec3::Zero()));
  std::ranges::fill(buffers.summaries, PairSummary{});
  for (BodyBuffers& body : buffers.bodies) {
    body.temporary_claims.clear();
    body.actual_claims.clear();
  }
}

void hold_probed_nodes(const Model& model, Scratch::Buffers& buffers) {
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    if (!buffers.rows[i].pressing) continue;
    BodyBuffers& body = buffers.bodies[model.probes[i].body];
    body.temporary_claims.hold(model.probes[i].nodes);
    body.actual_claims.hold(model.probes[i].nodes);
  }
}

SolveReport touch(const Model& model, Scratch::Buffers& buffers) {
  place(model, buffers.free_motion);
  find_pairs(model, buffers.free_motion, buffers.pairs);
  for (const CollidingPair& pair : buffers.pairs) ++buffers.summaries[pair.touch_pair].active;
  if (buffers.pairs.empty()) return {};
  hold_probed_nodes(model, buffers);
  const SolveReport law =
      model.law == ContactModel::Kuroda ? kuroda(model, buffers) : sibille(model, buffers);
  return law.stop == Stop::Converged ? apply_claims(model, buffers) : law;
}

/// A cycle that failed delivers nothing: half a result would be felt as another contact model.
CycleResult result(Scratch::Buffers& buffers, SolveReport report) {
  const bool finite = std::ranges::all_of(buffers.probe_forces, [](const Vec3& f) { return f.allFinite(); });
  if (report.stop == Stop::Converged && !finite) report.stop = Stop::NotFinite;
  if (report.stop != Stop::Converged) start(buffers);
  for (Vec3& force : buffers.probe_forces) force = -force;  // the body's reaction on the finger
  return {buffers.probe_forces, buffers.summaries, report};
}

/// A body that no probe presses is where it rests, whatever the cycle before has left.
void rest(const Body& body, BodyMotion& motion) {
  motion.displacement.setZero();
  motion.positions = body.rest;
}

}  // namespace

std::string_view to_string(Stop stop) {
  switch (stop) {
    case Stop::Converged:
      return "converged";
    case Stop::IterationLimit:
      return "iteration limit";
    case Stop::SingularMatrix:
      return "singular matrix";
    case Stop::NotFinite:
      return "not finite";
  }
  return "";
}

Scratch::Buffers::Buffers(const Model& model)
    : rows(model.probes.size()),
      free_motion(rest_motion(model)),
      probe_forces(model.probes.size(), Vec3(Vec3::Zero())),
      summaries(model.pairs.size()) {
  pairs.reserve(most_pairs(model));
  shares.reserve(most_pairs(model));
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
    const auto nodes = static_cast<int>(model.bodies[i].rest.cols());
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3 * nodes);
    bodies.push_back({PrescribedSolve(model, i), PrescribedSolve(model, i), PrescribedSolve(model, i),
                      Claims(nodes), Claims(nodes), zero});
    displacement.push_back(zero);
    loads.on_body.push_back(zero);
  }
}

Scratch::Scratch(const Model& model) : buffers_(std::make_unique<Buffers>(model)) {}
Scratch::~Scratch() = default;
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;
const Loads& Scratch::loads() const {
  return buffers_->loads;
}
const Eigen::VectorXd& Scratch::displacement(int body) const {
  return buffers_->displacement[body];
}

SolveReport free_deformation(const Model& model, Scratch::Buffers& buffers) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    BodyMotion& motion = buffers.free_motion[i];
    PrescribedSolve& solve = buffers.bodies[i].free;
    const bool was_moved = motion.moved;
    motion.moved =
        std::ranges::any_of(model.bodies[i].probes, [&](int probe) { return buffers.rows[probe].pressing; });
    if (!motion.moved) {
      if (was_moved) rest(model.bodies[i], motion);
      continue;
    }
    motion.displacement.setZero();
    if (!solve.factor(buffers.rows, {})) return {.stop = Stop::SingularMatrix};
    solve.solve(&buffers.rows, {});
    solve.add_displacement(motion.displacement);
    solve.add_forces(buffers.loads.on_body[i]);
    for (const int probe : model.bodies[i].probes) buffers.probe_forces[probe] = solve.probe_force(probe);
    buffers.displacement[i] = motion.displacement;
  }
  return {};
}

CycleResult cycle(const Model& model, const Memory&, Pose pose, Scratch& scratch) {
  Scratch::Buffers& buffers = scratch.buffers();
  start(buffers);
  if (!std::ranges::all_of(pose, [](const ProbePose& probe) { return probe.displacement.allFinite(); }))
    return result(buffers, {.stop = Stop::NotFinite});
  footprint(model, pose, buffers.rows);
  SolveReport report = free_deformation(model, buffers);
  if (report.stop == Stop::Converged && model.law != ContactModel::None && !model.pairs.empty())
    report = touch(model, buffers);
  return result(buffers, report);
}

Eigen::VectorXf deform(const Model& model, int body, const Loads& loads) {
  const auto at = static_cast<std::size_t>(body);
  const Eigen::VectorXd unit_loads = loads.on_body[at] / model.bodies[at].young_modulus;
  return model.bodies[at].compliance->drawn_touch * unit_loads.cast<float>();
}

}  // namespace palpate::sim
