#pragma once

#include <nlohmann/json.hpp>

#include "app/command_line/plot.hpp"
#include "sim/cycle/press.hpp"

namespace palpate::app {

/// A press as `palpate press --format json` prints it: scene, model, units, bodies, curve.
nlohmann::ordered_json press_json(const sim::Model& model, const sim::Press& press);

/// The same as a table for a terminal.
std::string press_text(const sim::Model& model, const sim::Press& press);

/// What the finger feels over its depth, from the surface on: mm, N.
PlotSeries press_curve(const std::string& name, const sim::Model& model, const sim::Press& press);

}  // namespace palpate::app
