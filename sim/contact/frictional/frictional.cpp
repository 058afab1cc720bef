#include "sim/contact/frictional/frictional.hpp"

#include <algorithm>
#include <numeric>

#include "sim/contact/exact/coupling.hpp"
#include "sim/probe/probes.hpp"

namespace palpate::sim {
namespace {

std::vector<FacingPair> pairs_of(const Model& model) {
  return carries_bodies(model) ? carried_pairs(model) : facing_pairs(model);
}

std::vector<int> numbers(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Eigen::Matrix3d frame_of_polygon(const FrictionalScratch& scratch, const FacingPair& pair) {
  return scratch.carried ? scratch.carried->turns[pair.polygon_body] : Eigen::Matrix3d::Identity();
}

/// What the regions have done to a contact of bodies that stand where the scene puts them.
Vec3 went_by_regions(const Model& model, const ProbeRows& probes, const FacingPair& pair) {
  Vec3 went = Vec3::Zero();
  for (std::size_t p = 0; p < model.probes.size(); ++p)
    if (const auto& region = model.probes[p].region)
      for (Eigen::Index mode = 0; mode < 12; ++mode)
        if (const double by = probes[p].region[mode]; by != 0.0)
          went += by * relative_motion(pair, model.probes[p].body, region->touch_motion.col(mode));
  return went;
}

/// Contacts, gaps and system where probes and regions are now.
void bring_rows(const Model& model, const ProbeRows& probes, FrictionalScratch& scratch) {
  if (scratch.carried) {
    Carried& carried = *scratch.carried;
    meet(model, probes, carried, scratch.pairs, scratch.normal_gaps);
    fill_frictional(model, probes, carried.turns, scratch.pairs, carried.renewed, carried.near,
                    carried.response, scratch.system);
    scratch.near.assign(carried.near.begin(), carried.near.end());
  }
  if (any_slides(model)) fill_probe_rows(model, probes, scratch.pairs, scratch.near, scratch.system);
}

/// How far each contact's sides stand from each other along its normal and from its anchor across, without loads.
void find_gaps(const Model& model, const ProbeRows& probes, std::span<const double> memory,
               FrictionalScratch& scratch) {
  for (std::size_t i = 0; i < scratch.pairs.size(); ++i) {
    const FacingPair& pair = scratch.pairs[i];
    scratch.went[i] =
        scratch.carried ? gone(model, probes, *scratch.carried, pair) : went_by_regions(model, probes, pair);
    const Vec3 from_anchor = scratch.went[i] - Vec3(memory[3 * i], memory[3 * i + 1], memory[3 * i + 2]);
    scratch.gaps[i] = scratch.system.frames[i].transpose() * (frame_of_polygon(scratch, pair) * from_anchor);
    scratch.gaps[i][0] =
        scratch.carried ? scratch.normal_gaps[i] : pair.gap + pair.normal.dot(scratch.went[i]);
  }
}

void take_probes(const Model& model, const ProbeRows& probes, FrictionalScratch& scratch) {
  std::size_t row = 0;
  for (std::size_t p = 0; p < probes.size(); ++p)
    for (Eigen::Index axis = 0; axis < model.probes[p].axes.cols(); ++axis, ++row) {
      scratch.holds[row] = probes[p].pressing ? 1 : 0;
      scratch.values[row] = probes[p].value[axis];
    }
}

Eigen::Index row_of(const FrictionalScratch& scratch, int contact) {
  return scratch.system.bilateral + 3 * contact;
}

/// The push of every contact on both bodies.
void add_contacts(const Model& model, FrictionalScratch& scratch, Loads& loads) {
  for (const int contact : scratch.near) {
    const Vec3 in_frame = scratch.solve.forces().segment<3>(row_of(scratch, contact));
    if (!(in_frame[0] > 0.0)) continue;
    const FacingPair& pair = scratch.pairs[contact];
    const Vec3 push = scratch.system.frames[contact] * in_frame;
    loads.on_body[pair.node_body].segment<3>(3 * pair.node) += push;
    for (std::size_t k = 0; k < 3; ++k)
      loads.on_body[pair.polygon_body].segment<3>(3 * pair.corners[k]) -=
          pair.weights[static_cast<Eigen::Index>(k)] * push;
    PairSummary& summary = scratch.summaries[pair.touch_pair];
    ++summary.active;
    const bool first = pair.node_body == model.pairs[pair.touch_pair].bodies[0];
    summary.force_on[first ? 0 : 1] += push;
    summary.force_on[first ? 1 : 0] -= push;
  }
}

/// What the probes push more or less than without contact.
void add_to_probes(const Model& model, const ProbeRows& probes, FrictionalScratch& scratch,
                   Response& response) {
  std::ranges::fill(scratch.given, 0.0);
  for (std::size_t i = 0; i < scratch.given.size(); ++i)
    for (const int contact : scratch.near)
      scratch.given[i] -=
          scratch.system.compliance.block<1, 3>(static_cast<Eigen::Index>(i), row_of(scratch, contact))
              .dot(scratch.solve.forces().segment<3>(row_of(scratch, contact)));
  scratch.solve.solve_bilateral(scratch.holds, scratch.given);
  auto given = scratch.given.begin();
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    const std::span<const double> weights = weights_of(probe, probes[p]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis) {
      const Vec3 force = *given++ * probe.axes.col(axis);
      response.probe_forces[p] += force;
      for (std::size_t k = 0; k < probe.nodes.size(); ++k)
        response.loads.on_body[probe.body].segment<3>(3 * probe.nodes[k]) += weights[k] * force;
    }
  }
}

/// Anchors after the cycle: of what sticks where they were, of what slips or is apart where the node is.
void move_anchors(std::span<const double> memory, FrictionalScratch& scratch) {
  std::ranges::copy(scratch.went, scratch.anchors.begin());
  for (const int contact : scratch.near) {
    const Eigen::Index row = row_of(scratch, contact);
    Vec3& anchor = scratch.anchors[contact];
    if (scratch.solve.touch(contact) == Touch::Sticks && scratch.solve.forces()[row] > 0.0) {
      anchor = {memory[3 * contact], memory[3 * contact + 1], memory[3 * contact + 2]};
      continue;
    }
    const Vec3 by_loads = scratch.solve.slack().segment<3>(row) - scratch.gaps[contact];
    anchor += frame_of_polygon(scratch, scratch.pairs[contact]).transpose() *
              (scratch.system.frames[contact] * by_loads);
  }
}

/// Whether no contact that was left out can have closed.
bool all_seen(const Model& model, const ProbeRows& probes, FrictionalScratch& scratch) {
  begin_giving_way(*scratch.carried);
  const Eigen::VectorXd& forces = scratch.solve.forces();
  for (const int contact : scratch.near)
    give_way(model, scratch.pairs[contact], forces.segment<3>(row_of(scratch, contact)).norm(),
             *scratch.carried);
  give_way(model, probes, {forces.data(), static_cast<std::size_t>(scratch.system.bilateral)},
           *scratch.carried);
  return looked_far_enough(*scratch.carried);
}

SolveReport solve_frictional(const Model& model, const FreeState& free, std::span<const double> memory,
                             LawScratch& scratch, Response& response) {
  auto& own = static_cast<FrictionalScratch&>(scratch);
  take_probes(model, free.probes, own);
  if (own.carried) carry(model, free.probes, *own.carried);
  CoulombReport found;
  do {
    bring_rows(model, free.probes, own);
    find_gaps(model, free.probes, memory, own);
    found = own.solve.solve(model.friction, own.holds, own.values, own.gaps, own.near);
  } while (own.carried && !all_seen(model, free.probes, own));
  move_anchors(memory, own);
  add_contacts(model, own, response.loads);
  add_to_probes(model, free.probes, own, response);
  return {.stop = found.converged ? Stop::Converged : Stop::CapReached,
          .iterations = found.iterations,
          .residual = found.residual};
}

void advance_anchors(const Model&, const LawScratch& scratch, double, std::span<double> memory) {
  const auto& own = static_cast<const FrictionalScratch&>(scratch);
  for (std::size_t i = 0; i < own.anchors.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) memory[3 * i + k] = own.anchors[i][static_cast<Eigen::Index>(k)];
}

std::size_t anchors_of(const Model& model) {
  return 3 * pairs_of(model).size();
}

}  // namespace

FrictionalScratch::FrictionalScratch(const Model& model)
    : pairs(pairs_of(model)),
      carried(carries_bodies(model) ? std::optional<Carried>(std::in_place, model, pairs) : std::nullopt),
      near(numbers(pairs.size())),
      normal_gaps(pairs.size()),
      gaps(pairs.size(), Vec3(Vec3::Zero())),
      went(gaps),
      anchors(gaps),
      system(empty_friction_system(model, pairs.size())),
      solve(system) {
  summaries.resize(model.pairs.size());
  const auto rows = static_cast<std::size_t>(system.bilateral);
  holds.resize(rows);
  values.resize(rows);
  given.resize(rows);
  if (carried) return;
  const std::vector<Eigen::Matrix3d> turns(model.bodies.size(), Eigen::Matrix3d::Identity());
  PushResponse response(model);
  fill_frictional(model, probe_rows(model), turns, pairs, near, near, response, system);
}

void FrictionalScratch::reset() {
  solve.reset();
  if (carried) forget(*carried);
}

constinit const ContactLaw kFrictional{.name = "exact",
                                       .meaning = "contact pushes, sticks and slips (Coulomb)",
                                       .prepare = prepare_where_bodies_touch<FrictionalScratch>,
                                       .memory_size = anchors_of,
                                       .solve = solve_frictional,
                                       .advance = advance_anchors,
                                       .follows_regions = true};

}  // namespace palpate::sim
