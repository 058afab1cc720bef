#include "app/commands/check/check_stimulus.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/report/primary_power.hpp"
#include "analysis/words/words.hpp"
#include "app/study/simulation.hpp"
#include "app/study/study_table.hpp"
#include "sim/cycle/press.hpp"
#include "trials/observer/observer.hpp"

namespace palpate::app {

using nlohmann::ordered_json;

namespace {

constexpr int kSteps = 20;                // over the scene's depth
constexpr double kForceThreshold = 0.07;  // of force, that fingers just tell apart [Pang1991]
constexpr double kEnoughPower = 0.8;

/// Force against the press at each of kSteps depths [N].
std::vector<double> forces_of(const sim::Model& model) {
  const sim::Probe& finger = model.probes.front();
  std::vector<double> forces;
  for (const sim::PressStep& step : sim::press(model, finger.depth, kSteps).curve)
    forces.push_back(sim::normal_force(finger, step.probe_forces.front()));
  return forces;
}

/// Share of 2IFC answers that are correct where two stiffnesses differ by so much, of people without bias.
/// @param misled  the other one of the two is what they are asked for
double share_correct(double difference, bool misled, const trials::ObserverParameters& people) {
  const double deviation = trials::deviation_of_difference({.weber_fraction = people.weber_fraction.mean});
  const double felt = cdf(boost::math::normal(), (misled ? -1.0 : 1.0) * std::log1p(difference) / deviation);
  return people.lapse_rate * 0.5 + (1.0 - people.lapse_rate) * felt;
}

/// Whether the correct one of two conditions pushes back more where the softest is asked for, or less where the
/// stiffest is. Of conditions that differ in more than a stiffness, only forces tell.
bool misleads(const trials::Protocol& protocol, const std::vector<double>& forces) {
  const bool first = protocol.presented.front() == protocol.correct;
  const double correct = first ? forces[0] : forces[1], other = first ? forces[1] : forces[0];
  return *protocol.answer == trials::Answer::Stiffest ? correct < other : correct > other;
}

void add_expectation(const trials::Protocol& protocol, const trials::ObserverParameters& people,
                     StimulusCheck& check) {
  if (!protocol.answer || protocol.presented.size() != 2 || protocol.task->intervals != 2) return;
  check.answer_misleads = misleads(protocol, check.forces);
  check.expected_correct = share_correct(check.difference, check.answer_misleads, people);
  check.power = analysis::primary_power(design_of(protocol), *check.expected_correct).power;
}

StimulusCheck check_cell(const trials::Protocol& protocol, const trials::Stimuli& stimuli, std::size_t cell) {
  StimulusCheck check{.cell = protocol.cells[cell].name};
  std::vector<std::vector<double>> curves;
  double deepest = std::numeric_limits<double>::infinity();
  for (const std::size_t condition : protocol.presented) {
    const sim::Model& model = *stimuli.at(trials::stimulus_index(protocol, cell, condition));
    check.conditions.push_back(protocol.conditions[condition].name);
    curves.push_back(forces_of(model));
    deepest = std::min(deepest, model.probes.front().depth);
  }
  for (int step = 0; step < kSteps; ++step) {
    const double depth = deepest * (step + 1) / kSteps;
    if (depth < protocol.exploration.min_depth * (1.0 - 1e-9) && step + 1 < kSteps) continue;
    std::vector<double> forces;
    forces.reserve(curves.size());
    for (const std::vector<double>& curve : curves) forces.push_back(curve[step]);
    const auto [least, most] = std::ranges::minmax(forces);
    const double difference = least > 0.0 ? most / least - 1.0 : std::numeric_limits<double>::infinity();
    if (!check.forces.empty() && difference <= check.difference) continue;
    check.depth = depth;
    check.forces = forces;
    check.difference = difference;
  }
  return check;
}

bool says_any(std::string text, std::initializer_list<std::string_view> words) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::any_of(words,
                             [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// The words of a question that speak of something else than what makes its answer correct.
std::string question_warning(const trials::Protocol& protocol) {
  const bool stiff =
      says_any(protocol.question, {"harder", "hardest", "stiffer", "stiffest", "firmer", "firmest"});
  const bool soft = says_any(protocol.question, {"softer", "softest", "more compliant", "less stiff"});
  if (!protocol.answer || stiff == soft) return {};
  const bool asked_for_stiffest = *protocol.answer == trials::Answer::Stiffest;
  if (asked_for_stiffest == stiff) return {};
  return fmt::format(
      "the question, \"{}\", seems to ask for the {} interval, and correct is \"{}\", the {} one of the pair",
      protocol.question, stiff ? "stiffest" : "softest", protocol.conditions[protocol.correct].name,
      base::word_of(trials::kAnswerWords, *protocol.answer));
}

}  // namespace

std::vector<StimulusCheck> check_stimuli(const trials::Protocol& protocol, const trials::Stimuli& stimuli) {
  const trials::ObserverParameters people = trials::load_observer(default_observer());
  std::vector<StimulusCheck> cells;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell) {
    cells.push_back(check_cell(protocol, stimuli, cell));
    add_expectation(protocol, people, cells.back());
  }
  return cells;
}

std::vector<std::string> stimulus_warnings(const trials::Protocol& protocol,
                                           const std::vector<StimulusCheck>& cells) {
  std::vector<std::string> warnings;
  for (const StimulusCheck& cell : cells) {
    if (cell.difference < kForceThreshold)
      warnings.push_back(fmt::format(
          "in cell {} nobody can tell {} apart: {:.1f} % of force between them, and fingers tell {:.0f} %",
          cell.cell, fmt::join(cell.conditions, " and "), 100 * cell.difference, 100 * kForceThreshold));
    else if (cell.answer_misleads)
      warnings.push_back(fmt::format(
          "in cell {} the correct condition is not what is asked for, the {}: \"{}\" pushes back {} than \"{}\"; "
          "whoever goes by that is right in {:.0f} % of the trials",
          cell.cell, base::word_of(trials::kAnswerWords, *protocol.answer),
          protocol.conditions[protocol.correct].name,
          *protocol.answer == trials::Answer::Stiffest ? "less" : "more",
          cell.conditions[protocol.presented.front() == protocol.correct ? 1 : 0],
          100 * *cell.expected_correct));
    else if (cell.power && *cell.power < kEnoughPower)
      warnings.push_back(fmt::format(
          "in cell {} people as protocols/observers/default.toml has them are right in {:.0f} % of the trials, "
          "and the primary test finds that in {:.0f} % of such studies",
          cell.cell, 100 * *cell.expected_correct, 100 * *cell.power));
  }
  if (const std::string words = question_warning(protocol); !words.empty()) warnings.push_back(words);
  return warnings;
}

void print_text(const trials::Protocol& protocol, const std::vector<StimulusCheck>& cells) {
  fmt::print("\nwhat there is to feel, pressed {:g} mm deep and more\n",
             1e3 * protocol.exploration.min_depth);
  std::size_t width = 15;
  for (const StimulusCheck& cell : cells) width = std::max(width, analysis::columns(cell.cell) + 2);
  for (const StimulusCheck& cell : cells) {
    std::string forces;
    for (std::size_t i = 0; i < cell.forces.size(); ++i)
      forces += fmt::format("{}{} {:.2f} N", i > 0 ? ", " : "", cell.conditions[i], cell.forces[i]);
    fmt::print("  {}{} {} at {:g} mm: {:.1f} % apart", cell.cell,
               std::string(width - analysis::columns(cell.cell), ' '), forces, 1e3 * cell.depth,
               100 * cell.difference);
    if (cell.expected_correct)
      fmt::print("; simulated people are right in {:.0f} %, power {:.2f}", 100 * *cell.expected_correct,
                 *cell.power);
    fmt::print("\n");
  }
  fmt::print(
      "  A finger tells {:.0f} % of force apart (Pang, Tan and Durlach 1991), and 22 to 23 % of stiffness\n"
      "  (Jones and Hunter 1990; Tan et al. 1995).\n",
      100 * kForceThreshold);
}

ordered_json to_json(const std::vector<StimulusCheck>& cells) {
  ordered_json list = ordered_json::array();
  for (const StimulusCheck& cell : cells) {
    ordered_json one = {{"cell", cell.cell},
                        {"conditions", cell.conditions},
                        {"depth", cell.depth},
                        {"forces", cell.forces},
                        {"difference", cell.difference}};
    one["expected_correct"] = cell.expected_correct ? ordered_json(*cell.expected_correct) : ordered_json();
    one["power"] = cell.power ? ordered_json(*cell.power) : ordered_json();
    list.push_back(one);
  }
  return list;
}

}  // namespace palpate::app
