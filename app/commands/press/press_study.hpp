#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/compliance/cache.hpp"
#include "sim/cycle/press.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {

/// One thing that a study lets feel, pressed: a condition in a cell.
struct PressedStimulus {
  std::string cell;
  std::string condition;
  sim::Model model;
  sim::Press press;
};

/// Presses stimuli of the protocol, those too that no trial presents: of all, what Fig. 8 of Kuroda et al.
/// 2003 shows of its study. @param depth [m]; without it, the first probe's in the scene
std::vector<PressedStimulus> press_study(const trials::Protocol& protocol,
                                         const std::vector<trials::Stimulus>& stimuli,
                                         std::optional<double> depth, int steps, sim::ComplianceCache& cache);

nlohmann::ordered_json study_press_json(const trials::Protocol& protocol,
                                        const std::vector<PressedStimulus>& pressed);

/// A table of the forces: a row for each depth, a column for each condition, cell after cell.
std::string study_press_text(const trials::Protocol& protocol, const std::vector<PressedStimulus>& pressed);

}  // namespace palpate::app
