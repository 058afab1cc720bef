#include "analysis/report/primary_test.hpp"

#include <algorithm>

#include "analysis/binomial/counts_distribution.hpp"

namespace palpate::analysis {
namespace {

PlannedLook planned_look_at(const StudyDesign& design, const LookTaken& look, long trials, Side side) {
  std::vector<long> counts;
  for (int i = 0; i + 1 < look.number; ++i) {
    const long planned = long{design.looks[i]} * design.trials_per_examinee_per_cell;
    if (planned < trials) counts.push_back(planned);
  }
  counts.push_back(trials);
  const std::size_t now = counts.size() - 1;
  const long whole = long{design.planned_examinees} * design.trials_per_examinee_per_cell;
  if (look.number < look.of) counts.push_back(std::max(whole, trials + 1));
  return planned_looks(counts, design.chance, design.alpha, side, spending_from_name(design.spending))[now];
}

}  // namespace

std::optional<LookTaken> look_due(const StudyDesign& design, long complete) {
  const auto looks = static_cast<int>(design.looks.size());
  for (int i = 0; i < looks; ++i) {
    const long at = design.looks[i];
    const bool last = i + 1 == looks;
    if (complete != at && !(last && complete > at)) continue;
    const double share = static_cast<double>(at) / static_cast<double>(design.planned_examinees);
    return LookTaken{.number = i + 1,
                     .of = looks,
                     .spent = spent(spending_from_name(design.spending), design.alpha, share)};
  }
  return std::nullopt;
}

PrimaryTest primary_test(const StudyDesign& design, std::span<const OrderStratum> sittings, double level,
                         const std::optional<LookTaken>& look) {
  PrimaryTest test{
      .name = design.primary, .chance = design.chance, .side = side_from_name(design.side), .look = look};
  for (const OrderStratum& sitting : sittings) {
    test.correct += sitting.correct;
    test.trials += sitting.trials;
  }
  const BinomialTest binomial = binomial_test(test.correct, test.trials, design.chance, test.side, level);
  test.proportion = binomial.proportion;
  test.interval = binomial.interval;
  test.bound = binomial.bound;
  test.wilson = binomial.wilson;
  if (design.primary == "order-randomisation") {
    const OrderRandomisationTest random = order_randomisation_test(sittings, design.alpha, test.side);
    test.p = random.p;
    test.critical = random.critical;
    test.size = random.critical.size;
    test.under_guessing = random.under_guessing;
    test.method = random.method;
    return test;
  }
  test.p = binomial.p;
  test.under_guessing = binomial_counts(test.trials, design.chance);
  test.method = binomial.method;
  if (look) {
    const PlannedLook at = planned_look_at(design, *look, test.trials, test.side);
    test.critical = at.critical;
    test.size = at.size;
    return test;
  }
  test.critical = critical_number(test.trials, design.chance, design.alpha, test.side);
  test.size = test.critical.size;
  return test;
}

}  // namespace palpate::analysis
