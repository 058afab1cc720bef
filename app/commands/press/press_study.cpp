#include "app/commands/press/press_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "app/commands/press/press_output.hpp"

namespace palpate::app {
namespace {

double felt(const PressedStimulus& stimulus, std::size_t step) {
  return sim::normal_force(stimulus.model.probes.front(), stimulus.press.curve[step].probe_forces.front());
}

}  // namespace

std::vector<PressedStimulus> press_study(const trials::Protocol& protocol,
                                         const std::vector<trials::Stimulus>& stimuli,
                                         std::optional<double> depth, int steps,
                                         sim::ComplianceCache& cache) {
  std::vector<PressedStimulus> pressed;
  pressed.reserve(stimuli.size());
  for (const trials::Stimulus& stimulus : stimuli) {
    sim::Model model = trials::compile_stimulus(protocol, stimulus, cache);
    sim::Press press = sim::press(model, depth.value_or(model.probes.front().depth), steps);
    sim::require_solved(press);
    pressed.push_back({.cell = protocol.cells[stimulus.cell].name,
                       .condition = protocol.conditions[stimulus.condition].name,
                       .model = std::move(model),
                       .press = std::move(press)});
  }
  return pressed;
}

nlohmann::ordered_json study_press_json(const trials::Protocol& protocol,
                                        const std::vector<PressedStimulus>& pressed) {
  nlohmann::ordered_json stimuli = nlohmann::ordered_json::array();
  for (const PressedStimulus& stimulus : pressed) {
    nlohmann::ordered_json entry = {{"cell", stimulus.cell}, {"condition", stimulus.condition}};
    entry.update(press_json(stimulus.model, stimulus.press));
    stimuli.push_back(std::move(entry));
  }
  return {{"protocol", protocol.name}, {"stimuli", stimuli}};
}

std::string study_press_text(const trials::Protocol& protocol, const std::vector<PressedStimulus>& pressed) {
  std::string text = fmt::format("{}: force [N] that the finger feels\n{:>10}", protocol.name, "");
  std::string conditions = fmt::format("{:>10}", "depth [mm]");
  std::vector<std::size_t> width;
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    const bool first_of_cell = i == 0 || pressed[i].cell != pressed[i - 1].cell;
    const std::string& cell = first_of_cell ? pressed[i].cell : "";
    width.push_back(std::max({cell.size(), pressed[i].condition.size(), std::size_t{9}}) +
                    (first_of_cell ? 3 : 1));
    text += fmt::format("{:>{}}", cell, width[i]);
    conditions += fmt::format("{:>{}}", pressed[i].condition, width[i]);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  text += fmt::format("\n{}\n", conditions);
  for (std::size_t step = 0; step < pressed.front().press.curve.size(); ++step) {
    text += fmt::format("{:>10.3f}", 1e3 * pressed.front().press.curve[step].depth);
    for (std::size_t i = 0; i < pressed.size(); ++i)
      text += fmt::format("{:>{}.4f}", felt(pressed[i], step), width[i]);
    text += "\n";
  }
  return text;
}

}  // namespace palpate::app
