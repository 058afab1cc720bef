#include "sim/cycle/simulation.hpp"

#include <algorithm>
#include <cassert>

#include "sim/cycle/free_deformation.hpp"
#include "sim/cycle/region_force.hpp"
#include "sim/probe/probes.hpp"

namespace palpate::sim {
Simulation::Simulation(const Model& model)
    : model_(&model), law_(model.law->prepare(model)), memory_(law_ ? model.law->memory_size(model) : 0) {
  free_.probes = probe_rows(model);
  response_.probe_forces.resize(model.probes.size(), Vec3(Vec3::Zero()));
  response_.probe_torques.resize(model.probes.size(), Vec3(Vec3::Zero()));
  response_.loads.held.resize(model.probes.size(), RegionMotion(RegionMotion::Zero()));
  free_.motion.reserve(model.bodies.size());
  free_solves_.reserve(model.bodies.size());
  for (int i = 0; i < std::ssize(model.bodies); ++i) {
    const Eigen::Index size = 3 * model.bodies[i].rest.cols();
    free_.motion.push_back({.displacement = Eigen::VectorXd::Zero(size)});
    free_solves_.emplace_back(model, i, 0);
    response_.loads.on_body.emplace_back(Eigen::VectorXd::Zero(size));
  }
}

void Simulation::reset() {
  std::ranges::fill(memory_, 0.0);
  if (law_) law_->reset();
  clear_response();
}

Eigen::VectorXd Simulation::displacement(int body) const {
  return sim::displacement(*model_, body, response_.loads);
}

FreeMotion Simulation::motion() const {
  FreeMotion motion;
  for (int body = 0; body < std::ssize(model_->bodies); ++body)
    motion.push_back({.displacement = displacement(body), .moved = true});
  return motion;
}

void Simulation::clear_response() {
  for (Eigen::VectorXd& forces : response_.loads.on_body) forces.setZero();
  std::ranges::fill(response_.probe_forces, Vec3(Vec3::Zero()));
  std::ranges::fill(response_.probe_torques, Vec3(Vec3::Zero()));
  std::ranges::fill(response_.loads.held, RegionMotion(RegionMotion::Zero()));
  if (law_) std::ranges::fill(law_->summaries, PairSummary{});
}

/// A region takes what holds the body still under its loads, and what it takes to move the regions.
void Simulation::add_region_forces() {
  for (int probe = 0; probe < std::ssize(model_->probes); ++probe)
    if (model_->probes[probe].region) add_region_force(*model_, probe, response_);
}

SolveReport Simulation::solve(ProbeDisplacements probes) {
  if (!std::ranges::all_of(probes, [](const ProbeDisplacement& probe) {
        return probe.from_rest.allFinite() && probe.rotation.allFinite();
      }))
    return {.stop = Stop::NotFinite};
  prescribe(*model_, probes, free_.probes);
  for (std::size_t i = 0; i < free_.probes.size(); ++i) response_.loads.held[i] = free_.probes[i].region;
  SolveReport report = free_deformation(*model_, free_solves_, free_, response_);
  if (!law_) report.force_error_bound = 0.0;  // nothing is iterated
  if (report.stop == Stop::Converged && law_)
    report = model_->law->solve(*model_, free_, memory_, *law_, response_);
  add_region_forces();
  const auto finite = [](const Vec3& force) { return force.allFinite(); };
  if (solved(report.stop) && !std::ranges::all_of(response_.probe_forces, finite))
    report.stop = Stop::NotFinite;
  return report;
}

CycleResult Simulation::step(ProbeDisplacements probes, double dt) {
  assert(probes.size() == model_->probes.size());
  clear_response();
  const SolveReport report = solve(probes);
  if (!solved(report.stop))
    clear_response();  // half a result would be felt as another contact model
  else if (!memory_.empty())
    model_->law->advance(*model_, *law_, dt, memory_);
  for (Vec3& force : response_.probe_forces) force = -force;  // the body's reaction on the finger
  for (Vec3& torque : response_.probe_torques) torque = -torque;
  CycleResult result{
      .probe_forces = response_.probe_forces, .probe_torques = response_.probe_torques, .solve = report};
  if (law_) result.pairs = law_->summaries;
  return result;
}

}  // namespace palpate::sim
