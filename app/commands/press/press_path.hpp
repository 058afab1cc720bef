#pragma once

#include <set>
#include <string>
#include <vector>

#include "sim/cycle/stroke.hpp"

namespace palpate::app {

/// Probes of a kind that slides get the reach that a path needs, where the scene gives them none.
void let_reach(sim::Scene& scene, const std::string& file);

/// The poses of a path file (devices/scripted/path.hpp), a row each; a probe that has no columns stays where it
/// rests. Throws std::invalid_argument, "FILE:LINE: column: what was found; what is accepted", for what is no path,
/// a probe that the scene does not have, and a rotation of one that does not turn.
std::vector<sim::StrokePose> read_stroke(const sim::Model& model, const std::string& file);

/// What a stroke shows more than the scene is made for: a sentence for each probe, of where it is deepest.
std::set<std::string> stroke_warnings(const sim::Model& model, const sim::Stroke& stroke);

}  // namespace palpate::app
