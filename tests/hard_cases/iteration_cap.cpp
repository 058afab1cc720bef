// 34: a search for contacts that takes more pivots than it may.
#include <cmath>

#include "app/loop/interval_engine.hpp"
#include "devices/mouse/mouse.hpp"
#include "sim/contact/exact/complementarity.hpp"
#include "sim/model/contact_law.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

constexpr int kContacts = 60;

/// Contacts that a search by single pivots goes through nearly all sets of, 2^n for n contacts: what they do to each
/// other while a probe holds is L L^T, L of 1 on the diagonal and 2 below, and every gap is -1 [Fathi1979]. In one order
/// of the contacts it does so here, in the reverse one it is soon done.
sim::ContactSystem many_pivots(const Eigen::MatrixXd& L, bool reversed) {
  Eigen::MatrixXd root = Eigen::MatrixXd::Zero(kContacts + 1, kContacts + 1);
  root(0, 0) = 1.0;  // the probe's row, which each contact pushes by a tenth
  root.col(0).tail(kContacts).setConstant(0.1);
  root.bottomRightCorner(kContacts, kContacts) = reversed ? Eigen::MatrixXd(L.colwise().reverse()) : L;
  return {.compliance = root * root.transpose(), .bilateral = 1, .first_of_probe = {0, 1}};
}

Eigen::MatrixXd twos_below_ones(Jitter& jitter) {
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(kContacts, kContacts);
  for (int i = 0; i < kContacts; ++i)
    for (int j = 0; j <= i; ++j) L(i, j) = jitter.of(i == j ? 1.0 : 2.0);
  return L;
}

/// Whether the step says so, and whether the trial counts it: by a law whose every cycle stops at its cap.
void count_capped_cycles(Jitter& jitter, Outcome& outcome) {
  constexpr sim::ContactLaw kCapped{
      .name = "capped",
      .prepare = [](const sim::Model&) { return std::make_unique<sim::LawScratch>(); },
      .solve =
          [](const sim::Model&, const sim::FreeState&, std::span<const double>, sim::LawScratch&,
             sim::Response&) { return sim::SolveReport{.stop = sim::Stop::CapReached, .iterations = 1000}; }};
  sim::Model model = compiled(two_boxes(jitter), "exact");
  model.law = &kCapped;
  sim::Simulation simulation(model);
  outcome.expect(step_to(simulation, Vec3(0, 0, -1e-3)).solve.stop == sim::Stop::CapReached,
                 "no flag in the step");
  app::IntervalEngine engine(model, {.least_presses = 1, .most_presses = 3, .max_time = 3.0},
                             devices::mouse());
  for (int cycle = 0; cycle < 50; ++cycle)
    engine.tick({.position = (cycle < 10 ? -1e-3 : 1e-3) * engine.press(), .known = true});
  outcome.expect(engine.solve_record().cycles_at_cap == 50, "the trial does not count them");
}

}  // namespace

Outcome iteration_cap(Jitter& jitter) {
  using End = sim::ComplementarityReport::End;
  Outcome outcome{.limit = 1.0};
  const Eigen::MatrixXd L = twos_below_ones(jitter);
  const sim::ContactSystem hard = many_pivots(L, false), easy = many_pivots(L, true);
  const std::vector<double> gaps(kContacts, -1.0), values{0.0};
  const std::vector<char> holds{1};
  sim::ComplementaritySolve capped(hard), solved(easy);
  const auto report = capped.solve(holds, values, gaps);
  outcome.expect(report.end == End::CapReached, "the cap is not reached");
  outcome.expect(report.iterations == sim::ComplementaritySolve::kMostIterations,
                 "iterations are miscounted");
  outcome.expect(capped.forces().allFinite() && capped.forces().tail(kContacts).minCoeff() >= 0.0,
                 "a contact pulls");
  outcome.expect(std::abs((hard.compliance * capped.forces())[0]) <= 1e-9 * capped.forces().norm(),
                 "the probe does not hold");
  outcome.expect(solved.solve(holds, values, gaps).end == End::Converged, "the other order is not solved");
  outcome.figure = std::abs(capped.forces()[0] - solved.forces()[0]) / report.force_error_bound;
  count_capped_cycles(jitter, outcome);
  return outcome;
}

}  // namespace palpate::hard_cases
