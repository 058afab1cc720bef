#pragma once

#include <nlohmann/json.hpp>

#include "sim/cycle/press.hpp"

namespace palpate::app {

/// A press as `palpate press --format json` prints it: scene, model, units, bodies, curve.
nlohmann::ordered_json press_json(const sim::Model& model, const sim::Press& press);

/// The same as a table for a terminal.
std::string press_text(const sim::Model& model, const sim::Press& press);

}  // namespace palpate::app
