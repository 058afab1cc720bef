#pragma once

#include <vector>

#include "sim/cycle/simulation.hpp"

namespace palpate::hard_cases {

/// Displacements of the uncondensed bodies under the loads of a cycle, by node of the mesh: from K, not from C.
std::vector<Eigen::Matrix3Xd> solved_with_stiffness(const sim::Model& model, const sim::Loads& loads);

/// Scaled natural residual of the contacts of an `exact` cycle, with gaps from K: the largest of
/// |λ − max(0, λ − w / D)| over the largest λ.
double residual_from_stiffness(const sim::Model& model, const sim::Simulation& simulation);

}  // namespace palpate::hard_cases
