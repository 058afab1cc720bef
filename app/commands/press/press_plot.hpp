#pragma once

#include "app/command_line/plot.hpp"
#include "app/commands/press/press_study.hpp"
#include "sim/cycle/stroke.hpp"
#include "trials/observer/observer.hpp"

namespace palpate::app {

/// Force over depth of one scene: mm, N.
Plot press_plot(const sim::Model& model, const sim::Press& press);

/// The force on each probe over time, a panel each: its components and what resists the press: s, N.
Plot stroke_plot(const sim::Model& model, const sim::Stroke& stroke);

/// A panel for each cell, a line for each condition; and the force beyond which the device of `people` gives no
/// more, as a line where a press comes near it, else in words.
Plot study_press_plot(const trials::Protocol& protocol, const std::vector<PressedStimulus>& pressed,
                      const trials::ObserverParameters& people);

}  // namespace palpate::app
