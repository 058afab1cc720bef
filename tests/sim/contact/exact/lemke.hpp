#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/contact/exact/system.hpp"

namespace palpate::sim::test {

/// What a cycle of the exact contact model solves.
struct ContactProblem {
  ContactSystem system{};
  std::vector<char> holds{};
  std::vector<double> values{}, gaps{};
};

/// Complementary pivoting after Lemke on the bilateral rows' Schur complement, an algorithm that shares nothing with
/// the one under test. Source: [CottlePangStone1992] section 4.4.
Eigen::VectorXd lemke(const ContactProblem& problem);

}  // namespace palpate::sim::test
