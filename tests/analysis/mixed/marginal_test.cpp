#include "analysis/mixed/marginal.hpp"

#include <gtest/gtest.h>

#include "tests/analysis/mixed/support/data_sets.hpp"

using namespace palpate::analysis;

namespace {

template <int Q>
typename MarginalLikelihood<Q>::Parameters some_parameters() {
  typename MarginalLikelihood<Q>::Parameters at;
  if constexpr (Q == 1) at << -0.5, -0.3, 0.4;
  if constexpr (Q == 2) at << -0.5, -0.3, 0.4, 0.2, 0.3;
  return at;
}

template <int Q>
void expect_gradient(Link link, int nodes) {
  const Observations data = observations(pleuropneumonia());
  MarginalLikelihood<Q> marginal(data, link, nodes);
  using Parameters = typename MarginalLikelihood<Q>::Parameters;
  Parameters at = some_parameters<Q>(), gradient, unused;
  marginal(at, gradient);
  for (int k = 0; k < MarginalLikelihood<Q>::kParameters; ++k) {
    constexpr double kStep = 1e-4;  // error: its square times a third derivative of some hundreds
    Parameters up = at, down = at;
    up[k] += kStep, down[k] -= kStep;
    EXPECT_NEAR((marginal(up, unused) - marginal(down, unused)) / (2 * kStep), gradient[k], 1e-5)
        << name_of(link) << ", " << nodes << " nodes, parameter " << k;
  }
}

}  // namespace

TEST(MarginalLikelihood, HasTheGradientOfItsRule) {
  for (const Link link : {Link::Logit, Link::Probit}) {
    for (const int nodes : {1, 2, 5}) {
      expect_gradient<1>(link, nodes);
      expect_gradient<2>(link, nodes);
    }
  }
}

TEST(MarginalLikelihood, DoesNotDependOnWhereItWasBefore) {
  const Observations data = observations(eight_examinees());
  MarginalLikelihood<2> fresh(data, Link::Probit, 3), used(data, Link::Probit, 3);
  MarginalLikelihood<2>::Parameters at = some_parameters<2>(), gradient, other;
  other << 3, 2, -1, 2, 0.1;
  used(other, gradient);
  used(-other, gradient);
  EXPECT_NEAR(used(at, gradient), fresh(at, gradient), 1e-10);  // round-off of sums of some hundreds
}

TEST(MarginalLikelihood, NodesCloseInOnTheIntegral) {
  const Observations data = observations(pleuropneumonia());
  MarginalLikelihood<1>::Parameters at = some_parameters<1>(), gradient;
  const double truth = MarginalLikelihood<1>(data, Link::Logit, 50)(at, gradient);
  double before = INFINITY;
  for (const int nodes : {1, 3, 7}) {  // beyond that, round-off
    const double error = std::abs(MarginalLikelihood<1>(data, Link::Logit, nodes)(at, gradient) - truth);
    EXPECT_LT(error, before / 2) << nodes;
    before = error;
  }
  EXPECT_LT(before, 1e-8);
}
