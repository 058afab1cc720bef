#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/command_line/plot.hpp"
#include "app/commands/cost/sweep.hpp"

namespace palpate::app {

/// "reference", "band", "variants" and "advice".
nlohmann::ordered_json sweep_json(const Sweep& sweep);

/// Two tables, of accuracy and of time, the reference and the advice.
std::string sweep_text(const Sweep& sweep);

/// A variant a row, every figure a column with its unit, machine and versions in a column each.
std::string sweep_csv(const Sweep& sweep, const std::string& machine, const std::string& versions);

/// Time of a cycle over the error of the force, both logarithmic: a curve over the meshes for each kind of variant, the
/// Pareto front, what a finger tells apart, 250 Hz and 1 kHz.
Plot work_precision(const Sweep& sweep, const std::string& note);

/// Time of a cycle over the nodes of the meshes, a curve for each contact model, as Fig. 5 of [Kuroda2003] has it.
Plot over_family(const Sweep& sweep, const std::string& note);

}  // namespace palpate::app
