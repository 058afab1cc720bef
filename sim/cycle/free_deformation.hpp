#pragma once

#include <span>

#include "sim/contact/prescribed/prescribed_solve.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"
#include "sim/model/solve_report.hpp"

namespace palpate::sim {

/// Probe-only positions: every body deformed by the probes that press it and nothing else. From free.probes
/// it sets free.motion and, in a response that comes zeroed, what the probes alone do.
/// @param solves  one a body, with room for its probes
SolveReport free_deformation(const Model& model, std::span<PrescribedSolve> solves, FreeState& free,
                             Response& response);

}  // namespace palpate::sim
