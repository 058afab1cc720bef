#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/cycle/press.hpp"
#include "sim/cycle/stroke.hpp"

namespace palpate::app {

/// A press as `palpate press --format json` prints it: scene, model, units, bodies, curve.
nlohmann::ordered_json press_json(const sim::Model& model, const sim::Press& press);

/// The same as a table for a terminal.
std::string press_text(const sim::Model& model, const sim::Press& press);

/// A stroke likewise: each entry of the curve begins with its time [s], and each probe has its displacement.
nlohmann::ordered_json stroke_json(const sim::Model& model, const sim::Stroke& stroke);

/// The same as a table for a terminal: where each probe is, and the force on it as a vector.
std::string stroke_text(const sim::Model& model, const sim::Stroke& stroke);

}  // namespace palpate::app
