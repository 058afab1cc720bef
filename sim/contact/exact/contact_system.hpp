#pragma once

#include <span>

#include "sim/contact/exact/complementarity.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/facing_pairs.hpp"

namespace palpate::sim {

/// The rows of every probe's axes (in the model's order), then one of each pair along its normal, on the compliance
/// of all bodies: K = sum over bodies of J C J^T / E.
ContactSystem contact_system(const Model& model, std::span<const FacingPair> pairs);

}  // namespace palpate::sim
