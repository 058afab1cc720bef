#include "sim/contact/exact/exact.hpp"

#include <algorithm>

#include "sim/contact/exact/contact_system.hpp"

namespace palpate::sim {
namespace {

/// What the probes prescribe, as rows of the system.
void take_probes(const Model& model, const ProbeRows& probes, ExactScratch& scratch) {
  std::size_t row = 0;
  for (std::size_t p = 0; p < probes.size(); ++p)
    for (Eigen::Index axis = 0; axis < model.probes[p].axes.cols(); ++axis, ++row) {
      scratch.holds[row] = probes[p].pressing ? 1 : 0;
      scratch.values[row] = probes[p].value[axis];
    }
}

/// The push of every contact on both bodies.
void add_contacts(const Model& model, ExactScratch& scratch, Loads& loads) {
  for (const int row : scratch.solve.active().subspan(scratch.solve.holding())) {
    const FacingPair& pair = scratch.pairs[static_cast<std::size_t>(row - scratch.system.bilateral)];
    const Vec3 push = scratch.solve.forces()[row] * pair.normal;
    loads.on_body[pair.node_body].segment<3>(3 * pair.node) += push;
    for (std::size_t k = 0; k < 3; ++k)
      loads.on_body[pair.polygon_body].segment<3>(3 * pair.corners[k]) -=
          pair.weights[static_cast<Eigen::Index>(k)] * push;
    PairSummary& summary = scratch.summaries[pair.touch_pair];
    summary.active += scratch.solve.forces()[row] > 0.0 ? 1 : 0;
    const bool first = pair.node_body == model.pairs[pair.touch_pair].bodies[0];
    summary.force_on[first ? 0 : 1] += push;
    summary.force_on[first ? 1 : 0] -= push;
  }
}

/// What the probes push more or less than without contact.
void add_to_probes(const Model& model, const ProbeRows& probes, ExactScratch& scratch, Response& response) {
  const std::span<const int> rows = scratch.solve.active();
  const std::size_t holding = scratch.solve.holding();
  scratch.given.assign(holding, 0.0);
  for (std::size_t i = 0; i < holding; ++i)
    for (const int row : rows.subspan(holding))
      scratch.given[i] -= scratch.system.compliance(row, rows[i]) * scratch.solve.forces()[row];
  scratch.solve.solve_bilateral(scratch.given);
  std::size_t i = 0;
  int row = 0;
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    const std::span<const double> weights = weights_of(probe, probes[p]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis, ++row) {
      if (i == holding || rows[i] != row) continue;
      const Vec3 force = scratch.given[i++] * probe.axes.col(axis);
      response.probe_forces[p] += force;
      for (std::size_t k = 0; k < probe.nodes.size(); ++k)
        response.loads.on_body[probe.body].segment<3>(3 * probe.nodes[k]) += weights[k] * force;
    }
  }
}

Stop stop_of(ComplementarityReport::End end) {
  using End = ComplementarityReport::End;
  if (end == End::Converged) return Stop::Converged;
  return end == End::WithinTolerance ? Stop::WithinTolerance : Stop::CapReached;
}

/// Gaps and system where probes and regions are now.
void bring_rows(const Model& model, const ProbeRows& probes, ExactScratch& scratch) {
  if (scratch.carried) {
    Carried& carried = *scratch.carried;
    meet(model, probes, carried, scratch.pairs, scratch.gaps);
    if (carried.renewed.empty()) return;
    fill_contacts(model, probes, carried.turns, scratch.pairs, carried.renewed, carried.near,
                  carried.response, scratch.system);
    scratch.solve.changed();
    return;
  }
  move_gaps(scratch.regions, probes, scratch.rest_gaps, scratch.gaps);
  if (scratch.sliding.empty()) return;
  move_rows(model, scratch.sliding, probes, scratch.system);
  scratch.solve.changed();
}

/// Whether no contact that was left out can have closed.
bool all_seen(const Model& model, const ProbeRows& probes, ExactScratch& scratch) {
  begin_giving_way(*scratch.carried);
  const Eigen::VectorXd& forces = scratch.solve.forces();
  for (const int row : scratch.solve.active().subspan(scratch.solve.holding()))
    give_way(model, scratch.pairs[static_cast<std::size_t>(row - scratch.system.bilateral)], forces[row],
             *scratch.carried);
  give_way(model, probes, {forces.data(), static_cast<std::size_t>(scratch.system.bilateral)},
           *scratch.carried);
  return looked_far_enough(*scratch.carried);
}

SolveReport solve_exact(const Model& model, const FreeState& free, std::span<const double>,
                        LawScratch& scratch, Response& response) {
  auto& own = static_cast<ExactScratch&>(scratch);
  take_probes(model, free.probes, own);
  if (own.carried) carry(model, free.probes, *own.carried);
  ComplementarityReport found;
  do {
    bring_rows(model, free.probes, own);
    found = own.solve.solve(own.holds, own.values, own.gaps, model.contact_tolerance);
  } while (own.carried && !all_seen(model, free.probes, own));
  add_contacts(model, own, response.loads);
  add_to_probes(model, free.probes, own, response);
  return {.stop = stop_of(found.end),
          .iterations = found.iterations,
          .residual = found.residual,
          .force_error_bound = found.force_error_bound};
}

}  // namespace

ExactScratch::ExactScratch(const Model& model)
    : pairs(carries_bodies(model) ? carried_pairs(model) : facing_pairs(model)),
      carried(carries_bodies(model) ? std::optional<Carried>(std::in_place, model, pairs) : std::nullopt),
      regions(carried ? std::vector<RegionRows>() : region_rows(model, pairs)),
      sliding(carried ? std::vector<SlidingRows>() : sliding_rows(model, pairs)),
      system(carried ? empty_system(model, pairs.size()) : contact_system(model, pairs)),
      solve(system) {
  summaries.resize(model.pairs.size());
  for (const FacingPair& pair : pairs) rest_gaps.push_back(pair.gap);
  gaps = rest_gaps;
  const auto rows = static_cast<std::size_t>(system.bilateral);
  holds.resize(rows);
  values.resize(rows);
  given.reserve(rows);
}

void ExactScratch::reset() {
  solve.reset();
  if (carried) forget(*carried);
}

constinit const ContactLaw kExact{
    .name = "exact",
    .meaning = "contact only pushes, and only where bodies touch; both carry the same force",
    .prepare = prepare_where_bodies_touch<ExactScratch>,
    .solve = solve_exact};

}  // namespace palpate::sim
