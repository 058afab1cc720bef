#include "sim/contact/exact/exact.hpp"

#include <algorithm>
#include <numeric>

#include "sim/contact/exact/contact_system.hpp"
#include "sim/probe/probes.hpp"

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

/// The push of every contact on both bodies, or of a fingertip on one.
void add_contacts(const Model& model, ExactScratch& scratch, Response& response) {
  Loads& loads = response.loads;
  for (const int row : scratch.solve.active().subspan(scratch.solve.holding())) {
    const FacingPair& pair = scratch.pairs[static_cast<std::size_t>(row - scratch.system.bilateral)];
    const Vec3 push = scratch.solve.forces()[row] * pair.normal;
    loads.on_body[pair.node_body].segment<3>(3 * pair.node) += push;
    if (pair.polygon_body == kRigid) {
      response.probe_forces[pair.touch_pair] += push;
      continue;
    }
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

/// Gaps and system of contacts between bodies where probes and regions are now.
void bring_rows_of_bodies(const Model& model, const ProbeRows& probes, ExactScratch& scratch) {
  if (scratch.carried) {
    Carried& carried = *scratch.carried;
    if (any_slides(model)) {  // a row that stays as it is has others' places in it
      fill_probes(model, probes, scratch.system);
      std::ranges::fill(carried.known, 0);
    }
    meet(model, probes, carried, std::span(scratch.pairs).first(scratch.first_tip), scratch.gaps);
    if (carried.renewed.empty()) return;
    fill_contacts(model, probes, carried.turns, scratch.pairs, carried.renewed, carried.near,
                  carried.response, scratch.system);
    scratch.solve.changed();
    return;
  }
  move_gaps(scratch.regions, probes, scratch.rest_gaps, std::span(scratch.gaps).first(scratch.stay.size()));
  if (scratch.sliding.empty()) return;
  move_rows(model, scratch.sliding, probes, scratch.system);
  scratch.solve.changed();
}

void bring_rows(const Model& model, const ProbeRows& probes, ExactScratch& scratch) {
  bring_rows_of_bodies(model, probes, scratch);
  if (!scratch.tips) return;
  if (scratch.carried)
    bring_tips(model, probes, scratch.first_tip, scratch.carried->near, scratch.carried->turns, scratch.pairs,
               scratch.gaps, *scratch.tips, scratch.system);
  else
    bring_tips(model, probes, scratch.first_tip, scratch.stay, {}, scratch.pairs, scratch.gaps, *scratch.tips,
               scratch.system);
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

}  // namespace

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
  add_contacts(model, own, response);
  add_to_probes(model, free.probes, own, response);
  return {.stop = stop_of(found.end),
          .iterations = found.iterations,
          .residual = found.residual,
          .force_error_bound = found.force_error_bound};
}

namespace {

/// The nearest at rest come first: what is far is left out of a cycle from the end.
std::vector<FacingPair> pairs_of_bodies(const Model& model, bool bodies_touch) {
  if (!bodies_touch) return {};
  if (carries_bodies(model)) return carried_pairs(model);
  std::vector<FacingPair> pairs = facing_pairs(model);
  std::ranges::stable_sort(pairs, {}, &FacingPair::gap);
  return pairs;
}

std::vector<int> first_contacts(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// The rows of contacts that stay as they are; room for the others.
ContactSystem system_at_rest(const Model& model, std::span<const FacingPair> pairs,
                             std::span<const int> stay) {
  ContactSystem system = empty_system(model, pairs.size());
  const std::vector<Eigen::Matrix3d> turns(model.bodies.size(), Eigen::Matrix3d::Identity());
  PushResponse response(model);
  fill_contacts(model, probe_rows(model), turns, pairs, stay, stay, response, system);
  return system;
}

/// What the solve may take as constant where all rows stay as they are.
void finish_constant(const Model& model, ContactSystem& system) {
  const Eigen::MatrixXd& compliance = system.compliance;
  for (Eigen::Index row = system.bilateral; row < compliance.rows(); ++row)
    system.reach.push_back(compliance.col(row).lpNorm<Eigen::Infinity>());
  if (model.contact_precision == Precision::Single) system.single = compliance.cast<float>();
}

std::unique_ptr<LawScratch> prepare_exact(const Model& model) {
  if (model.pairs.empty() && !has_tips(model)) return nullptr;
  return std::make_unique<ExactScratch>(model);
}

}  // namespace

bool rows_stay(const Model& model) {
  return !carries_bodies(model) && !any_slides(model) && !has_tips(model);
}

ExactScratch::ExactScratch(const Model& model, bool bodies_touch)
    : pairs(pairs_of_bodies(model, bodies_touch)),
      first_tip(add_tips(model, pairs)),
      carried(bodies_touch && carries_bodies(model)
                  ? std::optional<Carried>(std::in_place, model, std::span(pairs).first(first_tip))
                  : std::nullopt),
      stay(first_contacts(carried ? 0 : first_tip)),
      gaps(pairs.size()),
      regions(region_rows(model, std::span(pairs).first(stay.size()))),
      sliding(sliding_rows(model, std::span(pairs).first(stay.size()))),
      system(system_at_rest(model, pairs, stay)),
      solve(system) {
  summaries.resize(model.pairs.size());
  rest_gaps.reserve(stay.size());
  for (const FacingPair& pair : std::span(pairs).first(stay.size())) rest_gaps.push_back(pair.gap);
  std::ranges::copy(rest_gaps, gaps.begin());
  if (first_tip < pairs.size()) tips.emplace(model, pairs.size());
  if (rows_stay(model)) finish_constant(model, system);
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
    .prepare = prepare_exact,
    .solve = solve_exact,
    .follows_regions = true};

}  // namespace palpate::sim
