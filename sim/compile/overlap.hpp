#pragma once

#include "sim/model/model.hpp"

namespace palpate::sim {

/// Throws std::invalid_argument where two bodies overlap at rest.
void refuse_overlap(const Body& a, const Body& b);

}  // namespace palpate::sim
