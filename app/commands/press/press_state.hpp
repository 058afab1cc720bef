#pragma once

#include <string>

#include "sim/model/loads.hpp"
#include "sim/model/model.hpp"

namespace palpate::app {

/// Writes STATE.BODY.vtu for each body, all or none: point data `displacement` [m] and `force` [N], of every node
/// by the uncondensed problem under these loads, and cell data `von_mises` [Pa]. A probe's push is among the
/// forces. Throws std::system_error where the disk refuses.
void save_state(const sim::Model& model, const sim::Loads& loads, const std::string& state);

}  // namespace palpate::app
